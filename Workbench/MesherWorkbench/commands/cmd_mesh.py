"""Mesh solid, Mesh faces, Mesh sketch or planar face: each makes a mesh object and opens its panel."""
import FreeCAD
import FreeCADGui

from ..messages import show_refusal


def _translated(text):
    return FreeCAD.Qt.translate("Mesher", text)


def _selected():
    """The selected object and the names of its selected faces; without a selection the active body."""
    selection = FreeCADGui.Selection.getSelectionEx()
    if selection:
        return selection[0].Object, [n for n in selection[0].SubElementNames if n.startswith("Face")], len(selection)
    view = FreeCADGui.ActiveDocument.ActiveView if FreeCADGui.ActiveDocument else None
    body = view.getActiveObject("pdbody") if hasattr(view, "getActiveObject") else None
    return body, [], 1 if body else 0


class _MeshCommand:
    def __init__(self, menu, tip, icon, accelerator, choose):
        self._resources = {"MenuText": menu, "ToolTip": tip, "Pixmap": icon, "Accel": accelerator}
        self._choose = choose

    def GetResources(self):
        return self._resources

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None

    def Activated(self):
        document = FreeCAD.ActiveDocument
        obj, faces, count = _selected()
        refusal = self._refusal(obj, count)
        if refusal is None:
            source, dimension, refusal = self._choose(obj, faces)
        if refusal is not None:
            show_refusal(refusal)
            return
        from ..factory import make_mesh_object
        from ..taskpanels.task_mesh import TaskMesh

        document.openTransaction(self._resources["MenuText"])
        FreeCADGui.Control.showDialog(TaskMesh(make_mesh_object(source, dimension=dimension), isNew=True))

    @staticmethod
    def _refusal(obj, count):
        if obj is None:
            return _translated("Nothing is selected. Select a solid, faces or a sketch first.")
        if count > 1:
            return _translated("Several objects are selected. Select one, or join them first.")
        if FreeCADGui.Control.activeDialog():
            return _translated("Another task is open. Finish it first.")
        if obj.isDerivedFrom("Fem::FemMeshObject") or obj.isDerivedFrom("Mesh::Feature"):
            return _translated("A mesh is selected. Select the shape it was made of.")
        if not hasattr(obj, "Shape") or obj.Shape.isNull():
            return _translated("The selected object has no shape. Recompute the document or select another one.")
        return None


def _choose_solid(obj, faces):
    if not obj.Shape.Solids:
        return None, None, _translated("The selection has no solid. Its faces can be meshed by Mesh faces.")
    return obj, 3, None


def _choose_faces(obj, faces):
    if not obj.Shape.Faces:
        return None, None, _translated("The selection has no face.")
    return ((obj, faces) if faces else obj), 2, None


def _choose_plane(obj, faces):
    if faces:
        return (obj, faces), 2, None
    if not obj.Shape.Wires:
        return None, None, _translated("The selection has no closed wire. Close the sketch.")
    return obj, 2, None


COMMANDS = (
    ("Mesher_MeshSolid",
     _MeshCommand("Mesh solid", "Mesh the selected solid or the active body with tetrahedra", "MesherMeshSolid",
                  "M, S", _choose_solid)),
    ("Mesher_MeshFaces",
     _MeshCommand("Mesh faces", "Mesh the selected faces, or all of the selected object, with triangles",
                  "MesherMeshFaces", "M, F", _choose_faces)),
    ("Mesher_MeshPlane",
     _MeshCommand("Mesh sketch or planar face", "Mesh the regions of a sketch or the selected plane faces",
                  "MesherMeshPlane", "M, P", _choose_plane)),
)

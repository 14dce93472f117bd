"""Mesh solid, Mesh faces, Mesh sketch or planar face: each makes a mesh object and opens its panel."""
import sys

import FreeCAD
import FreeCADGui

import mesher

from ..messages import in_words_of_panel, show_refusal, translated
from ..tools.meshed_shape import first_size, plane_faces
from ..tools.undo_steps import UndoSteps

_FIRST_CURVATURE = 12  # elements in a full turn


def _selected():
    """The selected object and the names of its selected faces; without a selection the active body."""
    selection = FreeCADGui.Selection.getSelectionEx()
    if selection:
        return selection[0].Object, [n for n in selection[0].SubElementNames if n.startswith("Face")], len(selection)
    view = FreeCADGui.ActiveDocument.ActiveView if FreeCADGui.ActiveDocument else None
    body = view.getActiveObject("pdbody") if hasattr(view, "getActiveObject") else None
    return body, [], 1 if body else 0


def _add_to_active_analysis(mesh):
    """As FEM's own meshes do."""
    gui = sys.modules.get("FemGui")
    analysis = gui.getActiveAnalysis() if gui else None
    if analysis is not None and analysis.Document == mesh.Document:
        analysis.addObject(mesh)


class _MeshCommand:
    def __init__(self, menu, tip, icon, accelerator, choose):
        self._resources = {"MenuText": menu, "ToolTip": tip, "Pixmap": icon, "Accel": accelerator}
        self._choose = choose

    def GetResources(self):
        return self._resources

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None

    def Activated(self):
        obj, faces, count = _selected()
        refusal = self._refusal(obj, count)
        if refusal is None:
            source, dimension, refusal = self._choose(obj, faces)
        if refusal is not None:
            show_refusal(refusal)
            return
        from ..factory import make_mesh_object
        from ..taskpanels.task_mesh import TaskMesh

        def make():
            mesh = make_mesh_object(source, dimension=dimension, size=first_size(obj.Shape), curvature=_FIRST_CURVATURE)
            _add_to_active_analysis(mesh)
            return mesh

        steps = UndoSteps(obj.Document)
        try:
            panel = TaskMesh(steps.record(self._resources["MenuText"], make), steps, is_new=True)
        except Exception as error:
            steps.take_back()
            steps.end()
            show_refusal(in_words_of_panel(error))
            return
        FreeCADGui.Control.showDialog(panel)

    @staticmethod
    def _refusal(obj, count):
        if FreeCADGui.Control.activeDialog():
            return translated("Another task is open. Finish it first.")
        if obj is None:
            return translated("Nothing is selected. Select a solid, faces or a sketch first.")
        if count > 1:
            return translated("Several objects are selected. Select one, or join them first.")
        if obj.isDerivedFrom("Fem::FemMeshObject") or obj.isDerivedFrom("Mesh::Feature"):
            return translated("A mesh is selected. Select the shape it was made of.")
        if not hasattr(obj, "Shape") or obj.Shape.isNull():
            return translated("The selected object has no shape. Recompute the document or select another one.")
        return None


def _choose_solid(obj, faces):
    if not obj.Shape.Solids:
        return None, None, translated("The selection has no solid. Its faces can be meshed by Mesh faces.")
    return obj, 3, None


def _choose_faces(obj, faces):
    if not obj.Shape.Faces:
        return None, None, translated("The selection has no face.")
    return ((obj, faces) if faces else obj), 2, None


def _choose_plane(obj, faces):
    if faces:
        curved = [name for name in faces if obj.Shape.getElement(name).findPlane() is None]
        if curved:
            return None, None, translated("{face} is curved. Use Mesh faces.").format(face=curved[0])
        return (obj, faces), 2, None
    if obj.Shape.Solids:
        return None, None, translated("A solid is selected. Select one of its plane faces, or use Mesh faces.")
    if not obj.Shape.Faces:
        try:
            plane_faces(obj)
        except mesher.ModelError as error:
            return None, None, in_words_of_panel(error)
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

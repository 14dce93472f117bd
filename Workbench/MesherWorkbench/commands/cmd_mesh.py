"""Mesh solid, Mesh faces, Mesh sketch or planar face: each makes a mesh object and opens its panel."""
import sys

import FreeCAD
import FreeCADGui
import Part

import mesher

from ..messages import in_words_of_panel, show_refusal, translated
from ..tools import macro_lines
from ..tools.meshed_shape import first_size, plane_faces
from ..tools.places import Place, object_at, pieces_at, place_of
from ..tools.undo_steps import UndoSteps

_FIRST_CURVATURE = 12  # elements in a full turn


def _selected():
    """The places that are selected, and the names of selected faces there; without a selection the active body."""
    picked = {}
    for selected in FreeCADGui.Selection.getSelectionEx("", 0):
        for sub in selected.SubElementNames or ("",):
            place, element = place_of(selected.Object, sub)
            picked.setdefault(place, []).extend([element] if element.startswith("Face") else [])
    if picked:
        return picked
    view = FreeCADGui.ActiveDocument.ActiveView if FreeCADGui.ActiveDocument else None
    body = view.getActiveObject("pdbody") if hasattr(view, "getActiveObject") else None
    return {Place(body, ""): []} if body else {}


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
        picked = _selected()
        refusal = self._refusal(picked)
        if refusal is None:
            faces = [name for names in picked.values() for name in names]
            pieces = [piece for place in picked for piece in pieces_at(place)]
            dimension, refusal = self._choose(pieces, faces)
        if refusal is not None:
            show_refusal(refusal)
            return
        from ..taskpanels.task_mesh import TaskMesh

        first = next(iter(picked))
        # What a link shows of another document stays there, the mesh does not.
        part = object_at(first) if object_at(first).Document == first.top.Document else first.top

        def make():
            size = first_size(Part.makeCompound([piece.shape for piece in pieces]))
            source = f"({macro_lines.expression_of(part)}, {faces if dimension == 2 else []!r})"
            before = set(part.Document.Objects)
            macro_lines.do("make_mesh_object", source, dimension=dimension, size=size, curvature=_FIRST_CURVATURE)
            mesh = next(obj for obj in part.Document.Objects if obj not in before)
            macro_lines.places(mesh, list(picked))
            _add_to_active_analysis(mesh)
            return mesh

        steps = UndoSteps(part.Document)
        try:
            panel = TaskMesh(steps.record(self._resources["MenuText"], make), steps, is_new=True)
        except Exception as error:
            steps.take_back()
            steps.end()
            show_refusal(in_words_of_panel(error))
            return
        FreeCADGui.Control.showDialog(panel)

    @staticmethod
    def _refusal(picked):
        if FreeCADGui.Control.activeDialog():
            return translated("Another task is open. Finish it first.")
        if not picked:
            return translated("Nothing is selected. Select a solid, faces or a sketch first.")
        objects = [object_at(place) for place in picked]
        if any(obj.isDerivedFrom("Fem::FemMeshObject") or obj.isDerivedFrom("Mesh::Feature") for obj in objects):
            return translated("A mesh is selected. Select the shape it was made of.")
        if len(picked) > 1 and any(picked.values()):
            return translated("Faces of several objects are selected. Select faces of one, or whole objects.")
        if not all(pieces_at(place) for place in picked):
            return translated("The selected object has no shape. Recompute the document or select another one.")
        return None


def _choose_solid(pieces, faces):
    if not any(piece.shape.Solids for piece in pieces):
        return None, translated("The selection has no solid. Its faces can be meshed by Mesh faces.")
    return 3, None


def _choose_faces(pieces, faces):
    if not any(piece.shape.Faces for piece in pieces):
        return None, translated("The selection has no face.")
    return 2, None


def _choose_plane(pieces, faces):
    if len(pieces) > 1:
        return None, translated("Several objects are selected. Select one sketch, or plane faces of one.")
    shape = pieces[0].shape
    if faces:
        curved = [name for name in faces if shape.getElement(name).findPlane() is None]
        if curved:
            return None, translated("{face} is curved. Use Mesh faces.").format(face=curved[0])
        return 2, None
    if shape.Solids:
        return None, translated("A solid is selected. Select one of its plane faces, or use Mesh faces.")
    if not shape.Faces:
        try:
            plane_faces(pieces[0].obj, shape)
        except mesher.ModelError as error:
            return None, in_words_of_panel(error)
    return 2, None


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

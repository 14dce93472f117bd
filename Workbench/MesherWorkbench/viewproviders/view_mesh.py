"""How a mesh object looks and what a double click does."""
import FreeCADGui

from .. import resources
from ..messages import show_refusal, translated

_FACE_COLOUR = (0.62, 0.78, 0.92)
_LINE_WIDTH = 1.0  # pixels


class ViewMesherMesh:
    def __init__(self, view):
        view.Proxy = self
        view.DisplayMode = "Faces & Wireframe"
        view.ShapeColor = _FACE_COLOUR
        view.LineWidth = _LINE_WIDTH

    def getIcon(self):
        return resources.icon("MesherMeshSolid")

    def attach(self, view):
        self.ViewObject = view

    def claimChildren(self):
        return self.ViewObject.Object.MeshRegionList

    def setEdit(self, view, mode):
        from ..taskpanels.task_mesh import TaskMesh

        if FreeCADGui.Control.activeDialog():
            show_refusal(translated("Another task is open. Finish it first."))
            return False
        view.Object.Document.openTransaction(translated("Edit mesh"))
        FreeCADGui.Control.showDialog(TaskMesh(view.Object))
        return True

    def unsetEdit(self, view, mode):
        FreeCADGui.Control.closeDialog()

    def doubleClicked(self, view):
        FreeCADGui.getDocument(view.Object.Document.Name).setEdit(view.Object.Name)
        return True

    def __getstate__(self):
        return None

    def __setstate__(self, state):
        return None

    dumps = __getstate__
    loads = __setstate__


def show_mesh_instead_of_part(obj):
    """Both in one place would hide each other in turn."""
    obj.ViewObject.Visibility = True
    if obj.Part is not None:
        obj.Part.ViewObject.Visibility = False


def show_part_instead_of_mesh(obj):
    obj.ViewObject.Visibility = False
    if obj.Part is not None:
        obj.Part.ViewObject.Visibility = True

"""How a mesh object looks and what a double click does."""
import FreeCADGui

from .. import resources


class ViewMesherMesh:
    def __init__(self, view):
        view.Proxy = self
        view.DisplayMode = "Faces & Wireframe"

    def getIcon(self):
        return resources.icon("MesherMeshSolid")

    def attach(self, view):
        self.ViewObject = view

    def setEdit(self, view, mode):
        from ..taskpanels.task_mesh import TaskMesh

        FreeCADGui.Control.showDialog(TaskMesh(view.Object))
        return True

    def unsetEdit(self, view, mode):
        FreeCADGui.Control.closeDialog()

    def doubleClicked(self, view):
        FreeCADGui.ActiveDocument.setEdit(view.Object.Name)
        return True

    def __getstate__(self):
        return None

    def __setstate__(self, state):
        return None

    dumps = __getstate__
    loads = __setstate__

"""How a mesh object looks and what a double click does."""
import FreeCADGui
from pivy import coin

from .. import resources
from ..messages import in_words_of_panel, show_refusal, translated
from ..tools.places import Place, object_at, shown_by
from ..tools.undo_steps import UndoSteps

_FACE_COLOUR = (0.62, 0.78, 0.92)
_LINE_WIDTH = 2.0  # pixels


class ViewMesherMesh:
    _starts = False  # whether the panel that opens begins a run
    _panel = None

    def __init__(self, view):
        view.Proxy = self
        view.DisplayMode = "Faces & Wireframe"
        view.ShapeColor = _FACE_COLOUR
        view.LineWidth = _LINE_WIDTH

    def getIcon(self):
        return resources.icon("MesherStaleMesh" if self.ViewObject.Object.IsStale else "MesherMeshSolid")

    def updateData(self, obj, name):
        if name == "IsStale":
            obj.ViewObject.signalChangeIcon()

    def attach(self, view):
        self.ViewObject = view
        # Lines lie in the faces: these are drawn a little behind them, which would show through here and there.
        view.RootNode.insertChild(coin.SoPolygonOffset(), 0)

    def claimChildren(self):
        return self.ViewObject.Object.MeshRegionList

    def setEdit(self, view, mode):
        return self._open_panel(view) is not None

    def update(self):
        """Meshes anew, in the panel."""
        document = FreeCADGui.getDocument(self.ViewObject.Object.Document.Name)
        self._starts = True
        try:
            document.setEdit(self.ViewObject.Object.Name)
        finally:
            self._starts = False

    def setupContextMenu(self, view, menu):
        menu.addAction(translated("Update mesh")).triggered.connect(self.update)

    def _open_panel(self, view):
        from ..taskpanels.task_mesh import TaskMesh

        if FreeCADGui.Control.activeDialog():
            show_refusal(translated("Another task is open. Finish it first."))
            return None
        steps = UndoSteps(view.Object.Document)
        try:
            self._panel = panel = TaskMesh(view.Object, steps)
        except Exception as error:  # values that make no sense can be typed into the properties
            steps.end()
            show_refusal(in_words_of_panel(error))
            return None
        FreeCADGui.Control.showDialog(panel)
        if self._starts:
            panel.start()
        return panel

    def unsetEdit(self, view, mode):
        # Nobody else tells it, as when another object is edited.
        if self._panel is not None:
            self._panel.leave()
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
    _show_parts(obj, False)


def show_part_instead_of_mesh(obj):
    obj.ViewObject.Visibility = False
    _show_parts(obj, True)


def _show_parts(obj, is_shown):
    places = [Place(top, path) for top, path in zip(obj.Containers, obj.ContainerPaths)]
    for part in {shown_by(place) for place in places if object_at(place) is not None} or {obj.Part} - {None}:
        part.ViewObject.Visibility = is_shown

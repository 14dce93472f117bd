"""The panel that looks into a mesh: a cut by whole elements, and the worst elements with a zoom on each. What it shows is
in the scene, and changes nothing in the document."""
import FreeCADGui
from PySide import QtCore, QtGui

import mesher_gui

from .. import resources
from ..messages import translated
from ..tools.inspection import MeshArrays, boundary_of, used_of
from .document_watch import DocumentWatch
from .qt import standard_buttons, widget_at
from .scene_mesh import SceneMesh, SceneVisibility

_WORST_COUNT = 20
_CUT_COLOUR = (0.62, 0.78, 0.92)
_WORST_COLOUR = (0.85, 0.15, 0.1)


class TaskInspection:
    def __init__(self, obj):
        self._obj = obj
        self._document_name = obj.Document.Name
        self._arrays = MeshArrays(obj.FemMesh)
        self._watch = DocumentWatch(obj, self.leave, self._let_go)
        self._is_open = True
        self._worst = self._arrays.worst(_WORST_COUNT)
        self._visibility = SceneVisibility(obj.ViewObject)
        self._mark = SceneMesh(obj.ViewObject, "MesherWorst", _WORST_COLOUR, in_front=True)
        self._cut = SceneMesh(obj.ViewObject, "MesherCut", _CUT_COLOUR)
        self._is_shown = True
        self.form = widget_at(mesher_gui.create_inspection_panel())
        self.form.setWindowTitle(translated("Inspect {label}").format(label=obj.Label))
        self.form.setWindowIcon(QtGui.QIcon(resources.icon("MesherInspectMesh")))
        self.form.setProperty("worst", [self._row_of(*row) for row in self._worst])
        for signal, slot in (("cutChanged()", self._show_cut), ("worstChosen()", self._show_chosen)):
            QtCore.QObject.connect(self.form, QtCore.SIGNAL(signal), slot)

    # what FreeCAD asks of a task panel
    def getStandardButtons(self):
        return standard_buttons("Close")

    def reject(self):
        self._let_go()
        self._is_open = False
        self._watch.end()
        FreeCADGui.Control.closeDialog()
        return True

    def leave(self):
        """The document is gone, or the mesh."""
        if self._is_open:
            self.reject()

    def _let_go(self):
        """Takes what it shows out of the scene, once."""
        if self._is_shown:
            self._is_shown = False
            self._visibility.hide(False)
            self._cut.leave()
            self._mark.leave()

    def _row_of(self, element, smallest, largest):
        x, y, z = self._middle_of(element)
        return [f"{smallest:.2f}°", f"{largest:.2f}°", f"{x:.4g}, {y:.4g}, {z:.4g}"]

    def _middle_of(self, element):
        return self._arrays.nodes[self._arrays.elements[element]].mean(axis=0).tolist()

    def _show_cut(self):
        axis = self.form.property("axis")
        is_cut = axis >= 0
        self._show(self._cut, self._arrays.beyond(axis, self.form.property("share"), self.form.property("flipped")) if is_cut else None)
        self._visibility.hide(is_cut)

    def _show_chosen(self):
        row = self.form.property("chosen")
        if row < 0:
            return
        element = self._worst[row][0]
        self._show(self._mark, self._arrays.elements[element:element + 1])
        self._mark.zoom(FreeCADGui.getDocument(self._document_name).activeView())

    def _show(self, scene, elements):
        if not self._is_shown:
            return
        if elements is None or not len(elements):
            scene.show(None, None)
            return
        scene.show(*used_of(self._arrays.nodes, boundary_of(elements)))

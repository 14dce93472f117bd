"""The panel that looks into a mesh: a cut by whole elements, and the worst elements with a zoom on each. What it shows are
objects of the document that leave with it."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

import mesher_gui

from .. import resources
from ..messages import translated
from ..tools.inspection import MeshArrays, boundary_of, mesh_feature_of
from .document_watch import DocumentWatch
from .qt import standard_buttons, widget_at

_WORST_COUNT = 20
_CUT_COLOUR = (0.62, 0.78, 0.92)
_WORST_COLOUR = (0.85, 0.15, 0.1)


class TaskInspection:
    def __init__(self, obj):
        self._obj = obj
        self._document_name = obj.Document.Name
        self._watch = DocumentWatch(obj, self.leave)
        self._is_open = True
        self._looks = {name: getattr(obj.ViewObject, name) for name in ("Visibility", "Transparency")}
        self._arrays = MeshArrays(obj.FemMesh)
        self._worst = self._arrays.worst(_WORST_COUNT)
        self._cut = None
        self._marks = None
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
        document = FreeCAD.listDocuments().get(self._document_name)
        if document is not None:
            for name in (self._cut, self._marks):
                if name is not None and document.getObject(name) is not None:
                    document.removeObject(name)
            document.abortTransaction()
            self._set_looks(**self._looks)
        self._is_open = False
        self._watch.end()
        FreeCADGui.Control.closeDialog()
        return True

    def leave(self):
        """The document is gone."""
        if self._is_open:
            self.reject()

    def _row_of(self, element, smallest, largest):
        x, y, z = self._middle_of(element)
        return [f"{smallest:.2f}°", f"{largest:.2f}°", f"{x:.4g}, {y:.4g}, {z:.4g}"]

    def _middle_of(self, element):
        return self._arrays.nodes[self._arrays.elements[element]].mean(axis=0).tolist()

    def _set_looks(self, **looks):
        try:
            for name, value in looks.items():
                setattr(self._obj.ViewObject, name, value)
        except ReferenceError:
            pass  # it was deleted meanwhile

    def _show_cut(self):
        axis = self.form.property("axis")
        self._cut = self._replace(self._cut, "MeshCut", _CUT_COLOUR, None if axis < 0 else self._arrays.beyond(
            axis, self.form.property("share"), self.form.property("flipped")))
        self._set_looks(Visibility=axis < 0)

    def _show_chosen(self):
        row = self.form.property("chosen")
        if row < 0:
            return
        element = self._worst[row][0]
        self._marks = self._replace(self._marks, "WorstElement", _WORST_COLOUR, self._arrays.elements[element:element + 1])
        # One element in a crowd is seen through the others.
        self._set_looks(Transparency=80)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self._document_name, self._marks)
        FreeCADGui.SendMsgToActiveView("ViewSelection")
        FreeCADGui.Selection.clearSelection()

    def _replace(self, name, new_name, colour, elements):
        """The object that shows some elements, in place of the one before; None without elements."""
        document = FreeCAD.getDocument(self._document_name)
        feature = document.getObject(name) if name else None
        if elements is None or not len(elements):
            if feature is not None:
                document.removeObject(name)
            return None
        if feature is None:
            feature = document.addObject("Mesh::Feature", new_name)
            feature.ViewObject.ShapeColor = colour
            feature.ViewObject.DisplayMode = "Flat Lines"
        feature.Mesh = mesh_feature_of(self._arrays.nodes, boundary_of(elements))
        return feature.Name

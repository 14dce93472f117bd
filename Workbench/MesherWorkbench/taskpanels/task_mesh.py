"""The panel of a mesh object: sizes, an estimate, Mesh and Stop, progress, result. The widgets are those of the module
mesher_gui; meshing and estimating are in threads, whose state a timer reads, so that neither waits for the other."""
import json
import time

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

import mesher
import mesher_gui

from .. import resources
from ..factory import keep_for_update
from ..messages import in_words_of_panel, show_refusal, translated
from ..tools import macro_lines
from ..tools.background_task import BackgroundTask
from ..tools.mesh_tool import HANDING_OVER, MeshTool
from ..tools.meshed_shape import first_size, meshed_shape
from ..tools.places import Place, object_at, place_of
from ..viewproviders.view_mesh import show_mesh_instead_of_part, show_part_instead_of_mesh
from . import texts
from .document_watch import DocumentWatch
from .qt import new_quantity_field, standard_buttons, widget_at
from .scene_mesh import zoom_to

_POLL_MILLISECONDS = 50
_PAUSE_BEFORE_ESTIMATE = 300  # milliseconds, in which more may be typed
_PATIENCE_AFTER_STOP = 0.5  # seconds
_LENGTHS = (("size", "CharacteristicLengthMax"), ("minSize", "CharacteristicLengthMin"), ("sag", "SurfaceDeviation"))
_NUMBERS = (("curvature", "MeshSizeFromCurvature"), ("improve", "OptimizeStd"), ("overlap", "Overlap"))
_SHOWN_KINDS = ("Face", "Edge", "Vertex")  # what the view can have selected
_LOCAL_KINDS = ("Solid", *_SHOWN_KINDS)


class TaskMesh:
    def __init__(self, obj, steps, is_new=False):
        self._obj = obj
        self._steps = steps
        self._expressions = dict(obj.ExpressionEngine)
        self._was_touched = "Touched" in obj.State
        self._document_name = obj.Document.Name
        self._watch = DocumentWatch(obj, self.leave, self._let_lengths_go)
        self._is_open = True
        self._is_new = is_new
        self._tool = None
        self._known = None  # has read the shape
        self._task = None
        self._estimate = None
        self._stopped_at = None
        self._poller = QtCore.QTimer()
        self._poller.setInterval(_POLL_MILLISECONDS)
        self._poller.timeout.connect(self._poll)
        self._estimator = QtCore.QTimer()
        self._estimator.setSingleShot(True)
        self._estimator.timeout.connect(self._start_estimate)
        self.form = widget_at(mesher_gui.create_mesh_panel(self._new_field))
        self.form.setWindowTitle(obj.Label)
        self.form.setWindowIcon(QtGui.QIcon(resources.icon("MesherMeshSolid")))
        self._show_options()
        self._show_result()
        for signal, slot in (("meshRequested()", self.start), ("cancelRequested()", self._cancel),
                             ("optionsChanged()", self._on_options_changed), ("selectionWanted()", self._add_selected),
                             ("placeWanted(int)", self._show_place)):
            QtCore.QObject.connect(self.form, QtCore.SIGNAL(signal), slot)
        QtGui.QApplication.instance().aboutToQuit.connect(self._cancel)
        self._start_estimate()

    # what FreeCAD asks of a task panel
    def getStandardButtons(self):
        return standard_buttons("Ok", "Cancel")

    def accept(self):
        if self._task is not None:
            return False
        if self._is_alive() and (self._changes() or self._changed_expressions()):
            self._record(translated("Edit mesh"))
        self._close()
        return True

    def reject(self):
        self._cancel()
        self._task = None
        self._close(self._take_back)
        return True

    def leave(self):
        """Without a document there is nothing to take over or take back."""
        if self._is_open:
            self._cancel()
            self._task = None
            self._close()

    def _take_back(self):
        """What is in the document as it was before the panel opened."""
        if not self._is_alive():
            return
        self._put_back_expressions()
        if self._steps.take_back():
            if self._is_alive() and not self._was_touched:
                self._obj.purgeTouched()
        elif self._is_new:
            # Others have changed the document meanwhile, which stays.
            self._steps.record(translated("Cancel"), self._remove)
        else:
            FreeCAD.Console.PrintWarning(translated("{label}: other changes of the document came after; use Undo to take this mesh back.\n")
                                         .format(label=self._obj.Label))

    def _remove(self):
        show_part_instead_of_mesh(self._obj)
        self._obj.Document.removeObject(self._obj.Name)

    def _close(self, then=lambda: None):
        self._is_open = False
        if self._estimate is not None:
            self._estimate.cancel()
        self._watch.end()
        self._poller.stop()
        self._estimator.stop()
        QtGui.QApplication.instance().aboutToQuit.disconnect(self._cancel)
        if self._document() is not None:
            FreeCADGui.getDocument(self._document_name).resetEdit()
        FreeCADGui.Control.closeDialog()
        if self._document() is not None:
            then()
        self._steps.end()

    # between form and object
    def _document(self):
        """The document, or None once it is closed."""
        return FreeCAD.listDocuments().get(self._document_name)

    def _is_alive(self):
        """Whether the object still is in its document."""
        try:
            return self._document() is not None and self._document().getObject(self._obj.Name) is not None
        except ReferenceError:
            return False

    def _new_field(self, name):
        property_name = dict(_LENGTHS).get(name)
        return new_quantity_field(self._obj, property_name) if property_name else new_quantity_field()

    def _put(self, name, value):
        # FreeCAD takes the form away from a panel that it has closed.
        if self.form is not None:
            self.form.setProperty(name, value)

    def _let_lengths_go(self):
        self._put("bound", False)

    def _show_options(self):
        for name, property_name in _LENGTHS:
            self._put(name, getattr(self._obj, property_name).Value)
        for name, property_name in _NUMBERS:
            self._put(name, getattr(self._obj, property_name))
        self._put("localSizes", {name: FreeCAD.Units.Quantity(length).Value
                                             for name, length in self._obj.LocalSizes.items()})

    def _values(self):
        """Of the form, by properties of the object."""
        values = {property_name: FreeCAD.Units.Quantity(self.form.property(name), FreeCAD.Units.Length) for name, property_name in _LENGTHS}
        values.update((property_name, self.form.property(name)) for name, property_name in _NUMBERS)
        values["LocalSizes"] = {name: f"{size!r} mm" for name, size in self.form.property("localSizes").items()}
        return values

    def _changes(self):
        """The values of the form that are not those of the object."""
        return {name: value for name, value in self._values().items() if getattr(self._obj, name) != value}

    def _changed_expressions(self):
        """Those that were typed into fields, or deleted there; None for these. FreeCAD has them in the object at once."""
        now = dict(self._obj.ExpressionEngine)
        return {path: now.get(path) for path in {*now, *self._expressions} if now.get(path) != self._expressions.get(path)}

    def _put_back_expressions(self):
        changed = self._changed_expressions()
        for path in changed:
            self._obj.setExpression(path, self._expressions.get(path))
        return changed

    def _record(self, name, then=lambda: None):
        """The form into the object, and what `then` does, as one step of undo."""
        expressions = self._put_back_expressions()

        def change():
            for path, expression in expressions.items():
                macro_lines.bind(self._obj, path, expression)
            for property_name, value in self._changes().items():
                macro_lines.assign(self._obj, property_name, value)
            then()
            self._obj.purgeTouched()

        self._steps.record(name, change)
        self._expressions = dict(self._obj.ExpressionEngine)

    def _show_result(self):
        self._put("summary", texts.summary_of(self._obj))
        self._put("histogram", texts.histogram_of(self._obj))

    def _show_place(self, number):
        """Where elements were left bad: zooms there, and selects what is to blame."""
        place = json.loads(self._obj.Report)["left"]["places"][number]
        zoom_to(FreeCADGui.getDocument(self._document_name).activeView(), place["point"], self._size_there())
        FreeCADGui.Selection.clearSelection()
        shape = meshed_shape(self._obj)
        for name in place["entities"]:
            where, element = shape.place_of(name)
            if element.startswith(_SHOWN_KINDS):
                FreeCADGui.Selection.addSelection(self._document_name, where.top.Name, where.path + element)

    def _size_there(self):
        size = self.form.property("size") or first_size(meshed_shape(self._obj).whole)
        return 3.0 * size

    def _add_selected(self):
        names = self._selected_names() if self._is_alive() else []
        if not names:
            show_refusal(translated("No face, edge or vertex of the meshed part is selected. "
                                          "Select some in the view first."))
            return
        first = 0.5 * (self.form.property("size") or first_size(meshed_shape(self._obj).whole))
        sizes = self.form.property("localSizes")
        self._put("localSizes", {**dict.fromkeys(names, first), **sizes})
        self._on_options_changed()

    def _selected_names(self):
        """Of elements of what is meshed."""
        try:
            shape = meshed_shape(self._obj)
        except mesher.ModelError:
            return []
        names = []
        for selected in FreeCADGui.Selection.getSelectionEx("", 0):
            for place, element in (place_of(selected.Object, sub) for sub in selected.SubElementNames):
                # By itself or through what contains it: it is the same element if there is just one such object.
                name = shape.name_at(place, element) or shape.name_at(Place(object_at(place), ""), element)
                if name and element.startswith(_LOCAL_KINDS):
                    names.append(name)
        return names

    # the estimate
    def _on_options_changed(self):
        if self._estimate is not None:
            self._estimate.cancel()
        # That of other sizes would be taken for that of these.
        self._put("estimate", translated("estimating"))
        self._estimator.start(_PAUSE_BEFORE_ESTIMATE)

    def _start_estimate(self):
        if self._estimate is not None and self._estimate.is_running:
            self._estimator.start(_PAUSE_BEFORE_ESTIMATE)
            return
        if self._task is not None:
            return
        try:
            tool = self._known = MeshTool(self._obj, self._values(), self._known)
        except Exception as error:
            self._put("estimate", in_words_of_panel(error))
            return
        self._is_volume = tool.is_volume
        self._estimate = BackgroundTask(tool.estimate)
        self._poller.start(_POLL_MILLISECONDS)

    def _finish_estimate(self):
        task, self._estimate = self._estimate, None
        if task.error is None:
            self._put("estimate", texts.estimate_text(task.result, self._is_volume))
        else:
            # A mesh may be possible all the same: curved faces, for one, have no estimate.
            is_told = isinstance(task.error, (mesher.OptionError, mesher.ModelError))
            self._put("estimate", in_words_of_panel(task.error) if is_told else "")

    # the run
    def start(self):
        if self._task is not None:
            return
        try:
            if not self._is_alive():
                raise ValueError(translated("The mesh object was deleted. Close this panel."))
            self._tool = self._known = MeshTool(self._obj, self._values(), self._known)
        except Exception as error:
            self._finish(in_words_of_panel(error))
            show_refusal(in_words_of_panel(error))
            return
        self._stopped_at = None
        self._started_at = time.monotonic()
        self._put("summary", "")
        self._put("running", True)
        self._task = BackgroundTask(self._tool.run, self._wake)
        self._poller.start(_POLL_MILLISECONDS)

    def _cancel(self):
        if self._estimate is not None:
            self._estimate.cancel()
        if self._task is None:
            return
        self._task.cancel()
        self._poller.start(_POLL_MILLISECONDS)
        self._stopped_at = time.monotonic()
        self._put("stage", translated("stopping"))

    def _wake(self):
        """In any thread."""
        QtCore.QMetaObject.invokeMethod(self._poller, "start", QtCore.Qt.QueuedConnection)

    def _poll(self):
        if self._estimate is not None and not self._estimate.is_running:
            self._finish_estimate()
        if self._task is not None:
            self._poll_run()
        if self._estimate is None and self._task is None:
            self._poller.stop()

    def _poll_run(self):
        task = self._task
        if task.is_cancelled:
            # Between two words of progress of a large mesh may be seconds; nobody has to watch them.
            if not task.is_running or time.monotonic() - self._stopped_at > _PATIENCE_AFTER_STOP:
                self._task = None
                self._finish(translated("cancelled"))
            return
        if task.is_running:
            stage, fraction = task.progress
            if stage == HANDING_OVER:
                # Whoever asks in Python would wait until FreeCAD has read the mesh, and the window with him.
                self._poller.stop()
            self._put("stage", texts.stage_text(stage, time.monotonic() - self._started_at))
            self._put("fraction", fraction)
            return
        self._task = None
        try:
            if task.error is None:
                self._take_in(task.result)
            else:
                self._tell(task.error)
        except Exception as error:  # of FreeCAD: an expression may have lost what it is about meanwhile
            self._finish(in_words_of_panel(error))
            show_refusal(in_words_of_panel(error))

    def _take_in(self, mesh, is_whole=True):
        if not self._is_alive():
            self._finish(translated("The mesh object was deleted."))
            return
        self._record(translated("Mesh"), lambda: self._fill_in(mesh, is_whole))
        self._finish(texts.done_text(time.monotonic() - self._started_at), fraction=1.0)
        self._show_result()

    def _fill_in(self, mesh, is_whole):
        """FreeCAD takes seconds for a million elements, in which its window rests. No line of a macro makes a part of a mesh."""
        self._put("stage", translated(HANDING_OVER))
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            QtGui.QApplication.processEvents(QtCore.QEventLoop.ExcludeUserInputEvents)
            if is_whole:
                keep_for_update(self._obj, self._tool, mesh)
                macro_lines.do("update", macro_lines.expression_of(self._obj))
            else:
                self._tool.fill_in(mesh)
                show_mesh_instead_of_part(self._obj)
        finally:
            QtGui.QApplication.restoreOverrideCursor()

    def _tell(self, error):
        """What went wrong, with the entities it is about selected, and what there is of the mesh."""
        partial = getattr(error, "mesh", None)
        if partial is not None and len(partial.nodes):
            self._take_in(partial, is_whole=False)
        self._finish(in_words_of_panel(error))
        FreeCADGui.Selection.clearSelection()
        for failure in getattr(error, "failures", ()):
            place, element = self._tool.place_of(failure["entity"])
            if element.startswith(_SHOWN_KINDS) and self._is_alive():
                FreeCADGui.Selection.addSelection(self._document_name, place.top.Name, place.path + element)
        show_refusal(in_words_of_panel(error))

    def _finish(self, text, fraction=0.0):
        self._put("running", False)
        self._put("fraction", fraction)
        self._put("stage", text)
        self._on_options_changed()

"""The panel of a mesh object: sizes, Mesh, Cancel, progress. The widgets are those of the module mesher_gui; meshing is in a
thread, which talks to the panel through plain values that a timer reads, so that neither waits for the other."""
import threading

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

import mesher
import mesher_gui

from ..messages import show_refusal
from ..tools.mesh_tool import MeshTool

try:
    from shiboken2 import wrapInstance
except ImportError:
    from shiboken6 import wrapInstance

_POLL_MILLISECONDS = 50
_LENGTHS = (("size", "CharacteristicLengthMax"), ("minSize", "CharacteristicLengthMin"))


class TaskMesh:
    def __init__(self, obj, isNew=False):
        self._obj = obj
        self._is_new = isNew
        self._thread = None
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._poll)
        self.form = wrapInstance(mesher_gui.create_mesh_panel(), QtGui.QWidget)
        self.form.setWindowTitle(obj.Label)
        for name, property_name in _LENGTHS:
            self.form.setProperty(name, getattr(obj, property_name).Value)
        self.form.setProperty("curvature", obj.MeshSizeFromCurvature)
        QtCore.QObject.connect(self.form, QtCore.SIGNAL("meshRequested()"), self._start)
        QtCore.QObject.connect(self.form, QtCore.SIGNAL("cancelRequested()"), self._cancel)

    # what FreeCAD asks of a task panel
    def getStandardButtons(self):
        return int(QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel)

    def accept(self):
        if self._thread is not None:
            return False
        self._take_over()
        self._close()
        FreeCAD.ActiveDocument.commitTransaction()
        return True

    def reject(self):
        if self._thread is not None:
            self._cancel()
            self._thread.join()
            self._thread = None
            self._timer.stop()
        self._close()
        if self._is_new:
            FreeCAD.ActiveDocument.abortTransaction()
        return True

    def _close(self):
        FreeCADGui.ActiveDocument.resetEdit()
        FreeCADGui.Control.closeDialog()

    def _take_over(self):
        """The form's values into the object."""
        for name, property_name in _LENGTHS:
            setattr(self._obj, property_name, self.form.property(name))
        self._obj.MeshSizeFromCurvature = self.form.property("curvature")

    # the run
    def _start(self):
        if self._thread is not None:
            return
        self._take_over()
        try:
            self._tool = MeshTool(self._obj)
        except Exception as error:
            self._finish(str(error))
            show_refusal(str(error))
            return
        self._is_cancelled = False
        self._progress = ("", 0.0)
        self._mesh = None
        self._error = None
        self.form.setProperty("running", True)
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()
        self._timer.start(_POLL_MILLISECONDS)

    def _run(self):
        try:
            self._mesh = self._tool.run(self._on_progress)
        except Exception as error:  # told by the main thread
            self._error = error

    def _on_progress(self, stage, fraction):
        self._progress = (stage, fraction)
        return not self._is_cancelled

    def _cancel(self):
        self._is_cancelled = True

    def _poll(self):
        if self._thread.is_alive():
            stage, fraction = self._progress
            self.form.setProperty("stage", stage)
            self.form.setProperty("fraction", fraction)
            return
        self._thread.join()
        self._thread = None
        self._timer.stop()
        if self._error is None:
            self._tool.fill_in(self._mesh)
            self._finish(f"{self._obj.ElementCount} elements, {self._obj.NodeCount} nodes, angles "
                         f"{self._obj.SmallestAngle:.1f} to {self._obj.LargestAngle:.1f} degrees")
        elif isinstance(self._error, mesher.Cancelled):
            self._finish("cancelled")
        else:
            self._finish(str(self._error))
            show_refusal(str(self._error))

    def _finish(self, text):
        self.form.setProperty("running", False)
        self.form.setProperty("stage", text)

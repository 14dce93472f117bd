"""Hands and eyes for tests that use FreeCAD's window as people do."""
import os
import sys
import time

import FreeCADGui
from PySide import QtCore, QtGui


class Ear:
    """Hears what Python says of exceptions that nobody caught, in slots of Qt for one."""

    def __init__(self, stream):
        self._stream = stream
        self.text = ""

    def write(self, text):
        self.text += text
        self._stream.write(text)

    def flush(self):
        self._stream.flush()


def finish(status):
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)


def pump(seconds, until=lambda: False):
    """Lets the window live for so long, or until something holds; the longest time in which it did not."""
    longest = 0.0
    end = time.monotonic() + seconds
    while time.monotonic() < end and not until():
        begin = time.monotonic()
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
        longest = max(longest, time.monotonic() - begin)
        time.sleep(0.005)
    return longest


def find(kind, name, seconds=10.0):
    """The one visible widget of that name, as soon as it is there: a slow machine shows it later."""
    found = []

    def look():
        found[:] = [w for w in FreeCADGui.getMainWindow().findChildren(kind) if w.objectName() == name and w.isVisible()]
        return found

    pump(0.0 if look() else seconds, look)
    assert len(found) == 1, f"{len(found)} visible {name}"
    return found[0]


def trigger(name):
    """The entry of the menu."""
    actions = [a for a in FreeCADGui.getMainWindow().findChildren(QtGui.QAction) if a.objectName() == name]
    assert actions, f"no action {name}"
    actions[0].trigger()
    pump(0.2)


def press_key(widget, key, text=""):
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtGui.QApplication.sendEvent(widget, QtGui.QKeyEvent(kind, key, QtCore.Qt.NoModifier, text))


def type_keys(widget, text):
    for letter in text:
        press_key(widget, QtCore.Qt.Key_unknown, letter)


def select(obj, *names):
    FreeCADGui.Selection.clearSelection()
    for name in names or ("",):
        FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name, name)
    pump(0.05)


def take_picture(path):
    """Of the whole screen, so that what OpenGL draws is on it."""
    pump(0.3)
    QtGui.QApplication.primaryScreen().grabWindow(0).save(path)


def visible_buttons(word):
    """The buttons of task panels that say this word. Qt is asked what each object is, and not Python: PySide gives an object the type
    of another one that lay at the same address before, if it was not told of the end of that one."""
    def is_meant(thing):
        return (thing.inherits("QPushButton") and thing.property("visible") and thing.property("text").replace("&", "") == word
                and thing.parent().inherits("QDialogButtonBox"))

    return [thing for thing in FreeCADGui.getMainWindow().findChildren(QtCore.QObject) if is_meant(thing)]


def press(word, seconds=10.0):
    """The button of the task panel that says this word, as soon as it is there."""
    pump(seconds, lambda: visible_buttons(word))
    buttons = visible_buttons(word)
    assert len(buttons) == 1, f"{len(buttons)} visible buttons {word}"
    QtCore.QMetaObject.invokeMethod(buttons[0], "click")
    pump(0.3)


class Messages:
    """Closes every window that tells something, since nobody is there to do it, and keeps what it says."""

    def __init__(self):
        self.texts = []
        self.picture = None
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._look)
        self._timer.start(50)

    def _look(self):
        for box in FreeCADGui.getMainWindow().findChildren(QtGui.QMessageBox):
            if box.isVisible():
                if self.picture:
                    # Only what was drawn is on the screen.
                    self._timer.stop()
                    path, self.picture = self.picture, None
                    take_picture(path)
                    self._timer.start(50)
                self.texts.append(box.text())
                box.accept()

    def next(self):
        """The text of the window that is open or opens now."""
        pump(5, lambda: self.texts)
        assert self.texts, "no message"
        return self.texts.pop(0)


class Panel:
    """The panel of a mesh object, while it is open."""

    def set_length(self, name, value):
        find(QtGui.QAbstractSpinBox, name).setProperty("rawValue", value)

    def length(self, name):
        return find(QtGui.QAbstractSpinBox, name).property("rawValue")

    def type_length(self, name, text):
        """As at the keyboard, leaving the field by Tab."""
        box = find(QtGui.QAbstractSpinBox, name)
        box.setFocus()
        box.selectAll()
        type_keys(box, text)
        press_key(box, QtCore.Qt.Key_Tab, "\t")
        pump(0.05)
        return self.length(name)

    def text_of(self, name):
        return find(QtGui.QLabel, name).text()

    def start(self):
        find(QtGui.QPushButton, "meshButton").click()

    def is_idle(self):
        return find(QtGui.QPushButton, "meshButton").isEnabled()

    def run(self, seconds=150.0):
        """Meshes; the fractions and stages that the panel showed, and the longest time that the window was dead."""
        bar = find(QtGui.QProgressBar, "progress")
        fractions, stages, longest = [], [], 0.0
        self.start()
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            longest = max(longest, pump(0.02))
            if self.is_idle():
                return fractions, stages, longest
            fractions.append(bar.value())
            stage = self.text_of("stage").split(",")[0]
            if not stages or stages[-1] != stage:
                stages.append(stage)
        raise AssertionError("the run did not end")

    def stop(self, seconds=10.0):
        """Presses Stop; the seconds until the panel was ready for the next run."""
        asked = time.monotonic()
        find(QtGui.QPushButton, "cancelButton").click()
        pump(seconds, self.is_idle)
        assert self.is_idle(), "the run does not stop"
        return time.monotonic() - asked

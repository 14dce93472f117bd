"""Hands and eyes for tests that use FreeCAD's window as people do."""
import os
import sys
import time

import FreeCADGui
from PySide import QtCore, QtGui

import window_hands


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


def wait_for(name, seconds=10.0):
    """Until there is a visible widget of that name: a slow machine shows it later."""
    pump(0.0 if window_hands.count(name) else seconds, lambda: window_hands.count(name))


def get(name, what):
    """A property of the one visible widget of that name."""
    wait_for(name)
    return window_hands.get(name, what)


def put(name, what, value):
    wait_for(name)
    window_hands.set(name, what, value)


def click(name):
    wait_for(name)
    window_hands.click(name)


def trigger(name):
    """The entry of the menu."""
    window_hands.trigger(name)
    pump(0.2)


def type_keys(name, text):
    """Over what is in the field."""
    wait_for(name)
    window_hands.type_keys(name, text)


def select(obj, *names):
    FreeCADGui.Selection.clearSelection()
    for name in names or ("",):
        FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name, name)
    pump(0.05)


def take_picture(path):
    pump(0.3)
    window_hands.take_picture(path)


def press(word, seconds=10.0):
    """The button of the task panel that says this word, as soon as it is there."""
    pump(seconds, lambda: window_hands.count_buttons(word))
    window_hands.press(word)
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
        if not window_hands.count_messages():
            return
        if self.picture:
            # Only what was drawn is on the screen.
            self._timer.stop()
            path, self.picture = self.picture, None
            take_picture(path)
            self._timer.start(50)
        self.texts.append(window_hands.close_message())

    def next(self):
        """The text of the window that is open or opens now."""
        pump(5, lambda: self.texts)
        assert self.texts, "no message"
        return self.texts.pop(0)


class Panel:
    """The panel of a mesh object, while it is open."""

    def set_length(self, name, value):
        put(name, "rawValue", float(value))

    def length(self, name):
        return get(name, "rawValue")

    def type_length(self, name, text):
        """As at the keyboard, leaving the field by Tab."""
        type_keys(name, text + "\t")
        pump(0.05)
        return self.length(name)

    def text_of(self, name):
        return get(name, "text")

    def start(self):
        click("meshButton")

    def is_idle(self):
        return get("meshButton", "enabled")

    def run(self, seconds=150.0):
        """Meshes; the fractions and stages that the panel showed, and the longest time that the window was dead."""
        fractions, stages, longest = [], [], 0.0
        self.start()
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            longest = max(longest, pump(0.02))
            if self.is_idle():
                return fractions, stages, longest
            fractions.append(get("progress", "value"))
            stage = self.text_of("stage").split(",")[0]
            if not stages or stages[-1] != stage:
                stages.append(stage)
        raise AssertionError("the run did not end")

    def stop(self, seconds=10.0):
        """Presses Stop; the seconds until the panel was ready for the next run."""
        asked = time.monotonic()
        click("cancelButton")
        pump(seconds, self.is_idle)
        assert self.is_idle(), "the run does not stop"
        return time.monotonic() - asked

"""Tells a panel that its document is being closed."""
import FreeCAD
from PySide import QtCore


class DocumentWatch:
    def __init__(self, name, leave):
        self._name = name
        self._leave = leave
        FreeCAD.addDocumentObserver(self)

    def slotDeletedDocument(self, document):
        if document.Name == self._name:
            # Behind the closing, which is in the middle of its work.
            QtCore.QTimer.singleShot(0, self._leave)

    def end(self):
        FreeCAD.removeDocumentObserver(self)

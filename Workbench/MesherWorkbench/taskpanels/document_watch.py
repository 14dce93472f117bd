"""Tells a panel that its document is being closed, or its object deleted, by an undo for one."""
import FreeCAD
from PySide import QtCore


class DocumentWatch:
    """Calls `let_go` before the object, or the document with it, is deleted, and `leave` afterwards."""

    def __init__(self, obj, leave, let_go=lambda: None):
        self._obj = obj
        self._document_name = obj.Document.Name
        self._leave = leave
        self._let_go = let_go
        FreeCAD.addDocumentObserver(self)

    def slotDeletedDocument(self, document):
        if document.Name == self._document_name:
            self._on_end()

    def slotDeletedObject(self, obj):
        if obj == self._obj:
            self._on_end()

    def _on_end(self):
        self._let_go()
        # Behind what deletes, which is in the middle of its work.
        QtCore.QTimer.singleShot(0, self._leave)

    def end(self):
        FreeCAD.removeDocumentObserver(self)

"""What a panel changes in its document: steps of undo, each whole, that can be taken back while nobody has changed anything since. No
transaction stays open in between, since it would swallow what others do, and take it back with it."""
import FreeCAD


class UndoSteps:
    def __init__(self, document):
        self._name = document.Name
        self._names = []
        self._stack = list(document.UndoNames)
        self._is_own = False
        self._are_last = True
        FreeCAD.addDocumentObserver(self)

    def record(self, name, change):
        """Calls `change()` as one step; what it raises leaves the document as it was. Returns its result."""
        document = FreeCAD.getDocument(self._name)
        self._is_own = True
        # The active document would have a step as well, in which nothing is done.
        active = FreeCAD.activeDocument()
        FreeCAD.setActiveDocument(self._name)
        document.openTransaction(name)
        try:
            result = change()
        except BaseException:
            document.abortTransaction()
            raise
        else:
            document.commitTransaction()
            self._names.append(name)
            self._stack = list(document.UndoNames)
            return result
        finally:
            if active is not None:
                FreeCAD.setActiveDocument(active.Name)
            self._is_own = False

    def take_back(self):
        """Whether the document is as it was before the first step: not so where other steps came after, which stay as they are."""
        document = FreeCAD.getDocument(self._name)
        count = len(self._names)
        if not self._are_last or list(document.UndoNames[:count]) != self._names[::-1]:
            return False
        self._is_own = True
        try:
            for _ in range(count):
                document.undo()
            if count:
                _forget_redo(document)
        finally:
            self._is_own = False
        self._names = []
        self._stack = list(document.UndoNames)
        return True

    def end(self):
        FreeCAD.removeDocumentObserver(self)

    # what FreeCAD tells of documents
    def slotCommitTransaction(self, document):
        # FreeCAD tells of transactions in which nothing was done as well.
        if document.Name == self._name and list(document.UndoNames) != self._stack:
            self._on_step(document)

    def slotUndoDocument(self, document):
        self._on_step(document)

    def slotRedoDocument(self, document):
        self._on_step(document)

    def _on_step(self, document):
        if document.Name == self._name and not self._is_own:
            self._are_last = False


def _forget_redo(document):
    """Steps that were cancelled are not to come back by Redo. FreeCAD forgets them at the next change, which is taken back here."""
    active = FreeCAD.activeDocument()
    FreeCAD.setActiveDocument(document.Name)
    document.openTransaction("Forget")
    document.addObject("App::FeaturePython", "Forgotten")
    document.abortTransaction()
    FreeCAD.setActiveDocument(active.Name)

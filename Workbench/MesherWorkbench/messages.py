"""How people are told what cannot be done."""
import re

import FreeCAD

# What Python calls them, and what the panel does.
_NAMES = {
    "dimension=2": "the command Mesh faces",
    "larger size": "larger Largest size",
    "local_sizes": "Local size",
    "max_elements": "the limit on elements",
    "order=1": "1st as the object's ElementOrder",
    "order=2": "ElementOrder 2nd",
    "min_size": "Smallest size",
    "larger than size": "larger than Largest size",
    "curvature": "Elements / turn",
    "sag": "Chord deviation",
}


def translated(text):
    return FreeCAD.Qt.translate("Mesher", text)


def in_words_of_panel(error):
    """An error of the package, which speaks of its arguments, for people who see labels."""
    pattern = r"\b(" + "|".join(re.escape(name) for name in sorted(_NAMES, key=len, reverse=True)) + r")\b"
    return re.sub(pattern, lambda name: translated(_NAMES[name[0]]), str(error))


def show_refusal(text):
    """In the report view, and in a window where there is one."""
    FreeCAD.Console.PrintError(f"Mesher: {text}\n")
    if FreeCAD.GuiUp:
        import FreeCADGui
        from PySide import QtGui

        QtGui.QMessageBox.warning(FreeCADGui.getMainWindow(), "Mesher", text)

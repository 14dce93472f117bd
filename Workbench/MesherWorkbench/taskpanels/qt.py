"""What differs between the versions of Qt that FreeCAD has."""
from PySide import QtCore, QtGui

# Both may be installed, but only one knows FreeCAD's widgets.
if QtCore.qVersion().startswith("5."):
    from shiboken2 import wrapInstance
else:
    from shiboken6 import wrapInstance


def widget_at(address):
    """The QWidget of a module in C++."""
    return wrapInstance(address, QtGui.QWidget)


def standard_buttons(*names):
    """What a task panel answers to getStandardButtons: a number in every version."""
    buttons = QtGui.QDialogButtonBox.NoButton
    for name in names:
        buttons |= getattr(QtGui.QDialogButtonBox, name)
    return int(getattr(buttons, "value", buttons))

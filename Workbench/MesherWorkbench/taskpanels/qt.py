"""What differs between the versions of Qt that FreeCAD has."""
import FreeCADGui
from PySide import QtCore, QtGui

# Both may be installed, but only one knows FreeCAD's widgets.
if QtCore.qVersion().startswith("5."):
    import shiboken2 as shiboken
else:
    import shiboken6 as shiboken


def widget_at(address):
    """The QWidget of a module in C++."""
    return shiboken.wrapInstance(address, QtGui.QWidget)


def new_quantity_field(obj=None, property_name=None):
    """The address of a new field of FreeCAD's for quantities, and the widget in which it is until C++ takes it out. Expressions that
    are typed become those of the object's property."""
    owner = QtGui.QWidget()
    field = None
    # PySide finds widgets by their addresses, and may take a new one for one that is gone. The next has another address.
    while not (isinstance(field, QtGui.QAbstractSpinBox) and shiboken.isValid(field)):
        field = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox", owner)
    if obj is not None:
        FreeCADGui.ExpressionBinding(field).bind(obj, property_name)
    return shiboken.getCppPointer(field)[0], owner


def standard_buttons(*names):
    """What a task panel answers to getStandardButtons: a number in every version."""
    buttons = QtGui.QDialogButtonBox.NoButton
    for name in names:
        buttons |= getattr(QtGui.QDialogButtonBox, name)
    return int(getattr(buttons, "value", buttons))

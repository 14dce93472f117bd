"""How people are told what cannot be done."""
import FreeCAD


def show_refusal(text):
    """In the report view, and in a window where there is one."""
    FreeCAD.Console.PrintError(f"Mesher: {text}\n")
    if FreeCAD.GuiUp:
        import FreeCADGui
        from PySide import QtGui

        QtGui.QMessageBox.warning(FreeCADGui.getMainWindow(), "Mesher", text)

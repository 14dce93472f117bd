"""The commands of menu and toolbar."""
import FreeCADGui

from . import cmd_mesh


def register():
    """Adds all commands to FreeCAD; their names in the order of the menu."""
    for name, command in cmd_mesh.COMMANDS:
        FreeCADGui.addCommand(name, command)
    return [name for name, _ in cmd_mesh.COMMANDS]

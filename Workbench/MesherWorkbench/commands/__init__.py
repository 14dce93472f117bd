"""The commands of menu and toolbar."""
import FreeCADGui

from . import cmd_inspect, cmd_mesh, cmd_update


def register():
    """Adds all commands to FreeCAD; their names in the order of the menu."""
    commands = cmd_mesh.COMMANDS + cmd_update.COMMANDS + cmd_inspect.COMMANDS
    for name, command in commands:
        FreeCADGui.addCommand(name, command)
    return [name for name, _ in commands]

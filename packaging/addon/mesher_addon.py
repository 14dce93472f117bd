"""The checkout as an add-on of FreeCAD: leads to the workbench that run.sh has built in it."""
import os
import sys

import FreeCAD

_CHECKOUT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
_WORKBENCH = os.path.join(_CHECKOUT, "build", "release", "Mod", "Mesher")


def code_of(name):
    """Init.py or InitGui.py of the workbench that is built, compiled; without one nothing, and a word about it."""
    path = os.path.join(_WORKBENCH, name)
    if not os.path.isfile(path):
        if name == "Init.py":
            FreeCAD.Console.PrintError(f"Mesher: the workbench is not built yet. Run {os.path.join(_CHECKOUT, 'run.sh')} "
                                       "in a terminal, then start FreeCAD again.\n")
        return "pass"
    if _WORKBENCH not in sys.path:
        sys.path.insert(0, _WORKBENCH)
    with open(path, encoding="utf-8") as file:
        return compile(file.read(), path, "exec")

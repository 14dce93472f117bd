"""Where the workbench's own files are. (InitGui.py does not know its own path, modules do.)"""
import os


def icon_directory():
    return os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "Resources", "icons")


def icon(name):
    return os.path.join(icon_directory(), name + ".svg")

"""The workbench of FreeCAD around the package mesher: documents, commands and panels; all meshing is in the core."""
from .factory import make_mesh, make_mesh_object, update

__all__ = ["make_mesh", "make_mesh_object", "update"]

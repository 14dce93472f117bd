"""What stands for a model: a path, a shape of FreeCAD, or a document object that has one."""
import os
import tempfile

from . import _core
from .errors import ModelError


def memory_directory():
    """A directory in memory, where there is one."""
    return "/dev/shm" if os.path.isdir("/dev/shm") else None


def model_of(source, heal=False):
    """The model that `source` stands for; a shape is copied exactly, by FreeCAD's binary format."""
    if isinstance(source, _core.Model):
        return source
    if isinstance(source, (str, os.PathLike)):
        return _core.Model.read(os.fspath(source), heal)
    shape = getattr(source, "Shape", source)
    if not hasattr(shape, "exportBinary"):
        raise TypeError(f"a path or a shape is wanted, not {type(source).__name__}")
    if shape.isNull():
        label = getattr(source, "Label", "shape")
        raise ModelError(f"{label}: the shape is empty; recompute the document or choose another object.",
                         [{"entity": label, "point": None, "reason": "the shape is empty",
                           "remedy": "recompute the document or choose another object"}])
    with tempfile.TemporaryDirectory(dir=memory_directory()) as directory:
        path = os.path.join(directory, "shape.bin")
        shape.exportBinary(path)
        # What the kernel holds and has just written does not crash its reader.
        return _core.Model.read(path, heal, tried=False)

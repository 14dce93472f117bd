"""The shape that a mesh object is made of, and how its parts are called there and in the document."""
import Part

import mesher

from .shape_hash import hash_of

_KINDS = {"Face": "Faces", "Edge": "Edges", "Vertex": "Vertexes", "Solid": "Solids"}


class MeshedShape:
    def __init__(self, part, shape, names=None):
        self.shape = shape
        self.names = names or {}  # of the shape's faces in the part, where they differ
        self._part = part

    def name_of(self, name):
        """What the shape calls a face, edge or vertex that the part calls `name`."""
        if self.shape is self._part:
            return name
        kind = name.rstrip("0123456789")
        if kind in _KINDS:
            try:
                wanted = self._part.getElement(name)
            except Exception:  # FreeCAD has no exception of its own for names that do not exist
                return name
            for number, element in enumerate(getattr(self.shape, _KINDS[kind]), 1):
                if element.isSame(wanted):
                    return f"{kind}{number}"
        return name


def meshed_shape(obj):
    """Of a mesh object; raises ModelError with what to do about it."""
    if obj.Part is None:
        raise refusal(obj, "the mesh has no part", "choose the object to mesh as its Part")
    part = obj.Part.Shape
    if part.isNull():
        raise refusal(obj.Part, "the shape is empty", "recompute the document or choose another object")
    names = [name for _, subs in obj.References for name in subs if name]
    if names:
        return _faces_of(obj, part, names)
    if not part.Faces and part.Wires:
        return MeshedShape(part, plane_faces(obj.Part))
    return MeshedShape(part, part)


def differs_from_mesh(obj):
    """Whether the shape of a mesh object is another one than that of its mesh."""
    if not obj.ShapeHash:
        return False
    if obj.Part is None or obj.Part.Shape.isNull():
        return True
    return hash_of(obj.Part.Shape) != obj.ShapeHash


def plane_faces(part):
    """The regions that the wires of a sketch bound."""
    open_wires = [wire for wire in part.Shape.Wires if not wire.isClosed()]
    if open_wires:
        end = open_wires[0].OrderedVertexes[0].Point
        raise refusal(part, f"a wire is open at ({end.x:.6g}, {end.y:.6g}, {end.z:.6g})", "close it in the sketch")
    try:
        faces = Part.makeFace(part.Shape.Wires, "Part::FaceMakerBullseye")
    except Exception as error:  # the kernel's errors have no common type in Python
        raise refusal(part, f"its wires bound no plane face ({error})", "close the wires and take away crossings") from error
    return faces


def first_size(shape):
    """A twentieth of the diagonal, to two digits: a mesh that is there at once and shows the shape."""
    return float(f"{shape.BoundBox.DiagonalLength / 20.0:.2g}")


def refusal(obj, reason, remedy):
    failure = {"entity": obj.Label, "point": None, "reason": reason, "remedy": remedy}
    return mesher.ModelError(f"{obj.Label}: {reason}; {remedy}.", [failure])


def _faces_of(obj, part, names):
    faces = []
    for name in names:
        if not name.startswith("Face"):
            raise refusal(obj, f"{name} is no face", "select faces only")
        try:
            faces.append(part.getElement(name))
        except Exception as error:
            raise refusal(obj, f"{obj.Part.Label} has no {name} any more", "select the faces again") from error
    return MeshedShape(part, Part.makeCompound(faces), {f"Face{i}": name for i, name in enumerate(names, 1)})

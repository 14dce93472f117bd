"""The shape that a mesh object is made of, and how its parts are called there and in the document."""
import Part

import mesher

from .places import Place, name_at, object_at, piece_of, pieces_at
from .shape_hash import hash_of, is_same

_KINDS = {"Face": "Faces", "Edge": "Edges", "Vertex": "Vertexes", "Solid": "Solids"}


class MeshedShape:
    """`whole` is all that the mesh object means, `shape` the part of it that is meshed."""

    def __init__(self, pieces, whole, shape, names=None):
        self.shape = shape
        self.whole = whole
        self.names = names or {}  # of the shape's elements in the document, where they differ
        self._pieces = pieces

    def name_of(self, name):
        """What the shape calls a face, edge or vertex that the document calls `name`."""
        if self.shape is self.whole and len(self._pieces) == 1:
            return name
        place, element = self.place_of(name)
        kind = element.rstrip("0123456789")
        if kind in _KINDS:
            try:
                wanted = next(piece for piece in self._pieces if piece.place == place).shape.getElement(element)
            except Exception:  # FreeCAD has no exception of its own for names that do not exist
                return name
            for number, known in enumerate(getattr(self.shape, _KINDS[kind]), 1):
                if known.isSame(wanted):
                    return f"{kind}{number}"
        return name

    def place_of(self, name):
        """The place of an element that the document calls `name`, and what it is called there."""
        for piece in self._pieces:
            start = name_at(piece.place, "")
            if name.startswith(start):
                return piece.place, name[len(start):]
        return self._pieces[0].place, name

    def name_at(self, place, element):
        """What the document calls an element at a place; None where nothing of that is meshed."""
        if all(piece.place != place for piece in self._pieces):
            return None
        return element if len(self._pieces) == 1 else name_at(place, element)


def meshed_shape(obj, pieces=None):
    """Of a mesh object, and of its pieces as far as they are known; raises ModelError with what to do about it."""
    pieces = pieces_of(obj) if pieces is None else pieces
    if not pieces or any(piece.shape.isNull() for piece in pieces):
        raise refusal(obj.Part, "the shape is empty", "recompute the document or choose another object")
    if len(pieces) > 1:
        whole = Part.makeCompound([piece.shape for piece in pieces])
        return MeshedShape(pieces, whole, whole, _names_of(pieces))
    whole = pieces[0].shape
    names = [name for _, subs in obj.References for name in subs if name]
    if names:
        return _faces_of(obj, pieces, names)
    if not whole.Faces and whole.Wires:
        return MeshedShape(pieces, whole, plane_faces(obj.Part, whole))
    return MeshedShape(pieces, whole, whole)


def pieces_of(obj):
    """What a mesh object means, one by one."""
    if obj.Part is None:
        raise refusal(obj, "the mesh has no part", "choose the object to mesh as its Part")
    if not obj.Containers:
        return [piece_of(obj.Part)]
    places = [Place(top, path) for top, path in zip(obj.Containers, obj.ContainerPaths)]
    if any(object_at(place) is None for place in places):
        raise refusal(obj, "one of its parts is gone", "make the mesh again of those that there are")
    return [piece for place in places for piece in pieces_at(place)]


def differs_from_mesh(obj):
    """Whether the shape of a mesh object is another one than that of its mesh."""
    if not obj.ShapeHash:
        return False
    try:
        return not is_same(hash_of(meshed_shape(obj).whole), obj.ShapeHash)
    except mesher.ModelError:
        return True


def plane_faces(part, shape):
    """The regions that the wires of a sketch, and of its shape where it is seen, bound."""
    open_wires = [wire for wire in shape.Wires if not wire.isClosed()]
    if open_wires:
        end = open_wires[0].OrderedVertexes[0].Point
        raise refusal(part, f"a wire is open at ({end.x:.6g}, {end.y:.6g}, {end.z:.6g})", "close it in the sketch")
    try:
        faces = Part.makeFace(shape.Wires, "Part::FaceMakerBullseye")
    except Exception as error:  # the kernel's errors have no common type in Python
        raise refusal(part, f"its wires bound no plane face ({error})", "close the wires and take away crossings") from error
    return faces


def first_size(shape):
    """A twentieth of the diagonal, to two digits: a mesh that is there at once and shows the shape."""
    return float(f"{shape.BoundBox.DiagonalLength / 20.0:.2g}")


def refusal(obj, reason, remedy):
    failure = {"entity": obj.Label, "point": None, "reason": reason, "remedy": remedy}
    return mesher.ModelError(f"{obj.Label}: {reason}; {remedy}.", [failure])


def _faces_of(obj, pieces, names):
    whole = pieces[0].shape
    faces = []
    for name in names:
        if not name.startswith("Face"):
            raise refusal(obj, f"{name} is no face", "select faces only")
        try:
            faces.append(whole.getElement(name))
        except Exception as error:
            raise refusal(obj, f"{obj.Part.Label} has no {name} any more", "select the faces again") from error
    return MeshedShape(pieces, whole, Part.makeCompound(faces), {f"Face{i}": name for i, name in enumerate(names, 1)})


def _names_of(pieces):
    """Of the elements of a compound: solids by the labels of their objects, the others by their places."""
    names, counts = {}, dict.fromkeys(_KINDS, 0)
    for piece in pieces:
        solids = len(piece.shape.Solids)
        for kind, elements in _KINDS.items():
            for number in range(1, len(getattr(piece.shape, elements)) + 1):
                counts[kind] += 1
                label = piece.obj.Label if solids == 1 else f"{piece.obj.Label}.{number}"
                names[f"{kind}{counts[kind]}"] = label if kind == "Solid" else name_at(piece.place, f"{kind}{number}")
    return _apart(names)


def _apart(names):
    """Two objects may have one label."""
    taken = {}
    for entity, name in names.items():
        taken[name] = taken.get(name, 0) + 1
        if taken[name] > 1:
            names[entity] = f"{name} ({taken[name]})"
    return names

"""Whether a mesh is that of its shape still."""
import numpy

_GOLDEN = 0.6180339887498949
_TOLERANCE = 1e-8  # of the sums of distances below


def hash_of(shape):
    """Of what it is, and where; not of how it is displayed: how many elements it has of each kind, and sums over points of them, each
    with a weight of its own. Documents keep a shape but for the last digits, so these are compared by `is_same`."""
    points = [vertex.Point for vertex in shape.Vertexes]
    # An edge may be a point, or have no curve in space: it has the points of its faces and ends.
    points += [edge.valueAt(0.5 * (edge.FirstParameter + edge.LastParameter)) for edge in shape.Edges if _has_curve(edge)]
    points += [_middle_of(face) for face in shape.Faces]
    places = numpy.array([tuple(point) for point in points]).reshape(-1, 3)
    weights = 0.5 + numpy.modf(_GOLDEN * numpy.arange(1, len(places) + 1))[0]
    counts = [len(elements) for elements in (shape.Vertexes, shape.Edges, shape.Faces, shape.Solids)]
    return " ".join([*map(str, counts), *(f"{value:.17g}" for value in (*(weights @ places), shape.BoundBox.DiagonalLength))])


def is_same(one, other):
    one, other = ([float(word) for word in words.split()] for words in (one, other))
    if len(one) != len(other) or one[:4] != other[:4]:
        return False
    return all(abs(a - b) <= _TOLERANCE * max(one[-1], 1e-300) for a, b in zip(one[4:-1], other[4:-1]))


def _has_curve(edge):
    try:
        return not edge.Degenerated and edge.Curve is not None
    except Exception:  # FreeCAD has a type of its own for each release
        return False


def _middle_of(face):
    low_u, high_u, low_v, high_v = face.ParameterRange
    return face.valueAt(0.5 * (low_u + high_u), 0.5 * (low_v + high_v))

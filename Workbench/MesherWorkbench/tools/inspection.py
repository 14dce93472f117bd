"""What is inside of a mesh: cuts by whole elements, and the elements with the worst angles. Works on arrays."""
import numpy

_FACES_OF_TET = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))


class MeshArrays:
    """Nodes and elements of highest dimension of a Fem.FemMesh: tetrahedra with positive volume, or triangles, by their corners.
    Raises ValueError for others."""

    def __init__(self, fem_mesh):
        _refuse_others(fem_mesh)
        places = fem_mesh.Nodes
        numbers = numpy.array(sorted(places), dtype=numpy.int64)
        self.nodes = numpy.array([tuple(places[number]) for number in numbers.tolist()]).reshape(-1, 3)
        elements = fem_mesh.Volumes or fem_mesh.Faces
        corners = 4 if fem_mesh.Volumes else 3
        named = numpy.array([fem_mesh.getElementNodes(element)[:corners] for element in elements], dtype=numpy.int64)
        self.elements = numpy.searchsorted(numbers, named.reshape(-1, corners))
        if corners == 4:
            self.elements = _turned_positive(self.nodes, self.elements)

    @property
    def is_volume(self):
        return self.elements.shape[1] == 4

    def beyond(self, axis, share, is_flipped=False):
        """The elements whose middle is beyond a plane that cuts away this share of the extent."""
        coordinates = self.nodes[:, axis]
        middles = coordinates[self.elements].mean(axis=1)
        low, high = coordinates.min(), coordinates.max()
        if is_flipped:
            return self.elements[middles <= high - share * (high - low)]
        return self.elements[middles >= low + share * (high - low)]

    def angles(self):
        """(smallest, largest) of each element in degrees: dihedral of tetrahedra, plane of triangles."""
        return _dihedral_angles(self.nodes[self.elements]) if self.is_volume else _plane_angles(self.nodes[self.elements])

    def worst(self, count):
        """(element, smallest, largest) of those whose angles are nearest to 0 or 180 degrees, worst first."""
        smallest, largest = self.angles()
        # Ties by number, so that the table is the same each time.
        order = numpy.argsort(numpy.minimum(smallest, 180.0 - largest), kind="stable")[:count]
        return [(int(i), float(smallest[i]), float(largest[i])) for i in order]


def boundary_of(elements):
    """The triangles that bound these elements, outward; triangles bound themselves."""
    if elements.shape[1] == 3:
        return elements
    faces = numpy.concatenate([elements[:, face] for face in _FACES_OF_TET])
    keys = numpy.sort(faces, axis=1)
    order = numpy.lexsort(keys.T)
    keys = keys[order]
    is_same = numpy.append(False, (keys[1:] == keys[:-1]).all(axis=1))
    is_shared = is_same | numpy.append(is_same[1:], False)
    return faces[order[~is_shared]]


def used_of(nodes, triangles):
    """The nodes that the triangles have, and the triangles by numbers of these."""
    used, renumbered = numpy.unique(triangles, return_inverse=True)
    return nodes[used], renumbered.reshape(-1, 3)


def _refuse_others(fem_mesh):
    counts = {"hexahedra": fem_mesh.HexaCount, "prisms": fem_mesh.PrismCount, "pyramids": fem_mesh.PyramidCount,
              "polyhedra": fem_mesh.PolyhedronCount}
    if not fem_mesh.VolumeCount:
        counts = {"quadrilaterals": fem_mesh.QuadrangleCount, "polygons": fem_mesh.PolygonCount}
    found = [f"{count} {kind}" for kind, count in counts.items() if count]
    if found:
        raise ValueError(" and ".join(found))


def _turned_positive(nodes, tets):
    """Tetrahedra whose faces all look outward, whichever way round they stood."""
    a, b, c, d = (nodes[tets[:, i]] for i in range(4))
    is_negative = (numpy.cross(b - a, c - a) * (d - a)).sum(axis=1) < 0.0
    return numpy.where(is_negative[:, None], tets[:, [1, 0, 2, 3]], tets)


def _dihedral_angles(corners):
    normals = [numpy.cross(corners[:, b] - corners[:, a], corners[:, c] - corners[:, a]) for a, b, c in _FACES_OF_TET]
    normals = [normal / numpy.linalg.norm(normal, axis=1, keepdims=True) for normal in normals]
    cosines = numpy.stack([-(normals[i] * normals[j]).sum(axis=1) for i in range(4) for j in range(i)])
    return _range_of(cosines)


def _plane_angles(corners):
    cosines = []
    for i in range(3):
        one, other = corners[:, (i + 1) % 3] - corners[:, i], corners[:, (i + 2) % 3] - corners[:, i]
        cosines.append((one * other).sum(axis=1) / (numpy.linalg.norm(one, axis=1) * numpy.linalg.norm(other, axis=1)))
    return _range_of(numpy.stack(cosines))


def _range_of(cosines):
    angles = numpy.degrees(numpy.arccos(numpy.clip(cosines, -1.0, 1.0)))
    return angles.min(axis=0), angles.max(axis=0)

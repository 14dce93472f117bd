"""Meshes as FreeCAD's FEM workbench holds them."""
import functools
import os
import tempfile

import numpy

from ._core import Mesh
from .model_argument import memory_directory

_VTK_TRIANGLE, _VTK_TET = 5, 10
# Corners of an element in the order in which FreeCAD keeps them, and takes them from for its view and for solvers. Tetrahedra stand the
# other way round there than in our meshes, VTK and CalculiX.
_KEPT = {_VTK_TRIANGLE: (0, 1, 2), _VTK_TET: (1, 0, 2, 3)}


def to_fem_mesh(mesh, lines=False, names=None):
    """A Fem.FemMesh of the mesh with the groups Face1, Solid1 and so on (and Edge1 if `lines` are wanted, which some solvers'
    writers take for beams). Nodes count from 1 in the mesh's order, and so do triangles, tetrahedra and lines in turn.
    `names` calls groups by other names: {"Face1": "Face6"}."""
    fem_mesh = _read(mesh.nodes, [(kind, corners[:, list(_order_in_file(kind))]) for kind, corners in
                                  ((_VTK_TRIANGLE, mesh.triangles), (_VTK_TET, mesh.tets))])
    _add_groups(fem_mesh, mesh.triangle_face, "Face", "Face", 1, names)
    _add_groups(fem_mesh, mesh.tet_solid, "Solid", "Volume", 1 + len(mesh.triangles), names)
    if lines:
        first = 1 + len(mesh.triangles) + len(mesh.tets)
        # FreeCAD's reader knows no lines.
        for number, nodes in enumerate((mesh.lines + 1).tolist(), first):
            fem_mesh.addEdge(nodes, number)
        _add_groups(fem_mesh, mesh.line_edge, "Edge", "Edge", first, names)
    return fem_mesh


def of_fem_mesh(fem_mesh):
    """The mesh of a Fem.FemMesh of triangles and tetrahedra, and what the groups of its faces and solids are called, by our names of
    them: {"Face1": "Face6"}. What is in no group of faces or volumes is in one of its own. Raises ValueError for other elements."""
    places = fem_mesh.Nodes
    numbers = numpy.array(sorted(places), dtype=numpy.int64)
    nodes = numpy.array([tuple(places[number]) for number in numbers.tolist()]).reshape(-1, 3)
    arrays, names = [], {}
    for kind, prefix, group_type, elements in ((_VTK_TRIANGLE, "Face", "Face", fem_mesh.Faces), (_VTK_TET, "Solid", "Volume", fem_mesh.Volumes)):
        kept = _KEPT[kind]
        rows = [fem_mesh.getElementNodes(element) for element in elements]
        if any(len(row) != len(kept) for row in rows):
            raise ValueError("it has elements of other kinds than triangles and tetrahedra of the first order")
        corners = numpy.searchsorted(numbers, numpy.array(rows, dtype=numpy.int64).reshape(-1, len(kept)))
        owners, called = _owners_of(fem_mesh, numpy.array(elements, dtype=numpy.int64), group_type)
        names.update((f"{prefix}{number}", name) for number, name in enumerate(called, 1))
        # Back from the order of FreeCAD.
        arrays += [corners[:, numpy.argsort(kept)], owners]
    return Mesh.of_arrays(nodes, *arrays), names


def _owners_of(fem_mesh, elements, group_type):
    """The number of each element's group, and the names of these groups."""
    owners = numpy.full(len(elements), -1, dtype=numpy.int64)
    order = numpy.argsort(elements)
    names = []
    for group in fem_mesh.Groups:
        if fem_mesh.getGroupElementType(group) != group_type:
            continue
        members = order[numpy.searchsorted(elements, sorted(fem_mesh.getGroupElements(group)), sorter=order)]
        free = members[owners[members] < 0]
        if len(free):
            owners[free] = len(names)
            names.append(fem_mesh.getGroupName(group))
    if (owners < 0).any():
        owners[owners < 0] = len(names)
        names.append("rest")
    return owners, names


@functools.cache
def _order_in_file(kind):
    """Which corners to write one after the other, so that FreeCAD keeps what it should. Its reader takes corners as they stand or in
    an order of its own, by version: it is asked with one element."""
    count = len(_KEPT[kind])
    corners = numpy.arange(count)
    read = _read(numpy.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)])[:count], [(kind, corners[None])])
    kept = [number - 1 for number in read.getElementNodes(1)]
    if sorted(kept) != corners.tolist():
        raise RuntimeError(f"FreeCAD makes an element of the nodes {kept} of one of the nodes {corners.tolist()}")
    order = [0] * count
    for place, wanted in zip(kept, _KEPT[kind]):
        order[place] = wanted
    return tuple(order)


def _read(nodes, blocks):
    """FreeCAD's mesh of these nodes and elements: (kind, corners) one after the other."""
    import Fem

    fem_mesh = Fem.FemMesh()
    with tempfile.TemporaryDirectory(dir=memory_directory()) as directory:
        path = os.path.join(directory, "mesh.vtk")
        _write_legacy_vtk(nodes, blocks, path)
        fem_mesh.read(path)
    return fem_mesh


def _write_legacy_vtk(nodes, blocks, path):
    cells = [numpy.insert(corners.astype("i4"), 0, corners.shape[1], axis=1).ravel() for _, corners in blocks]
    kinds = [numpy.full(len(corners), kind, "i4") for kind, corners in blocks]
    # Joining arrays gives them the machine's byte order; the file's is the other one.
    cells, kinds = numpy.concatenate(cells).astype(">i4"), numpy.concatenate(kinds).astype(">i4")
    with open(path, "wb") as file:
        file.write(b"# vtk DataFile Version 3.0\nmesh\nBINARY\nDATASET UNSTRUCTURED_GRID\n")
        file.write(b"POINTS %d double\n" % len(nodes))
        file.write(nodes.astype(">f8").tobytes())
        file.write(b"\nCELLS %d %d\n" % (len(kinds), len(cells)))
        file.write(cells.tobytes())
        file.write(b"\nCELL_TYPES %d\n" % len(kinds))
        file.write(kinds.tobytes())
        file.write(b"\n")


def _add_groups(fem_mesh, owners, prefix, kind, first, names):
    for owner in numpy.unique(owners).tolist():
        name = f"{prefix}{owner + 1}"
        group = fem_mesh.addGroup((names or {}).get(name, name), kind)
        fem_mesh.addGroupElements(group, (numpy.flatnonzero(owners == owner) + first).tolist())

"""Tests without a window: freecadcmd -t TestMesherApp."""
import inspect
import json
import os
import tempfile
import unittest

import Fem
import FreeCAD
import Mesh
import Part

import mesher
from mesher.fem_mesh import of_fem_mesh

from MesherWorkbench import exporter, make_mesh, update
from MesherWorkbench.factory import _OPTIONS
from MesherWorkbench.tools.inspection import MeshArrays, boundary_of, used_of
from MesherWorkbench.tools.mesh_tool import MeshTool


def _groups_of(fem_mesh):
    return {fem_mesh.getGroupName(group): len(fem_mesh.getGroupElements(group)) for group in fem_mesh.Groups}


def _volume_of(fem_mesh):
    """FreeCAD's own sums up quadratic elements only."""
    nodes = fem_mesh.Nodes
    total = 0.0
    for element in fem_mesh.Volumes:
        a, b, c, d = (nodes[n] for n in fem_mesh.getElementNodes(element))
        total -= (b - a).cross(c - a).dot(d - a) / 6.0
    return total


def _read_inp(path):
    """Nodes by number, and the nodes of each tetrahedron, of a file for CalculiX."""
    nodes, tets, taken = {}, [], ""
    with open(path) as file:
        for line in file:
            if line.startswith("*"):
                taken = line.upper()
            elif not line.strip():
                continue
            elif taken.startswith("*NODE"):
                number, *place = line.split(",")
                nodes[int(number)] = FreeCAD.Vector(*map(float, place))
            elif "TYPE=C3D4" in taken:
                tets.append([int(number) for number in line.split(",")[1:5]])
    return nodes, tets


class _DocumentTest(unittest.TestCase):
    def setUp(self):
        self.document = FreeCAD.newDocument("TestMesher")
        self.document.UndoMode = 1

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def _feature(self, shape, name="Shape"):
        feature = self.document.addObject("Part::Feature", name)
        feature.Shape = shape
        self.document.recompute()
        return feature


class PlaneFaces(_DocumentTest):
    def test_plate_with_a_hole(self):
        hole = Part.Face(Part.Wire(Part.makeCircle(1, FreeCAD.Vector(3, 2, 0))))
        plate = self._feature(Part.makePlane(10, 5).cut(hole))
        mesh = make_mesh(plate, size=0.5, dimension=2)
        self.assertEqual(mesh.TypeId, "Fem::FemMeshObjectPython")
        self.assertGreater(mesh.FemMesh.TriangleCount, 400)
        self.assertEqual(mesh.FemMesh.NodeCount, mesh.NodeCount)
        self.assertEqual(_groups_of(mesh.FemMesh), {"Face1": mesh.FemMesh.TriangleCount})
        self.assertGreaterEqual(mesh.SmallestAngle, 30.0)
        # FEM finds the nodes on the exact face only if they lie on it to its tolerance.
        self.assertEqual(len(mesh.FemMesh.getNodesByFace(plate.Shape.Faces[0])), mesh.NodeCount)

    def test_face_of_a_solid_keeps_its_name(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        mesh = make_mesh((box, ["Face6"]), size=2.0)
        self.assertEqual(list(_groups_of(mesh.FemMesh)), ["Face6"])
        self.assertEqual(len(mesh.FemMesh.getNodesByFace(box.Shape.Faces[5])), mesh.NodeCount)

    def test_sketch(self):
        sketch = self.document.addObject("Sketcher::SketchObject", "Sketch")
        corners = [FreeCAD.Vector(*xy, 0) for xy in ((0, 0), (8, 0), (8, 4), (0, 4))]
        for i in range(4):
            sketch.addGeometry(Part.LineSegment(corners[i], corners[(i + 1) % 4]))
        sketch.addGeometry(Part.Circle(FreeCAD.Vector(4, 2, 0), FreeCAD.Vector(0, 0, 1), 1))
        self.document.recompute()
        mesh = make_mesh(sketch, size=0.5, dimension=2)
        self.assertGreater(mesh.FemMesh.TriangleCount, 200)

    def test_open_sketch_is_refused_and_leaves_nothing(self):
        sketch = self.document.addObject("Sketcher::SketchObject", "Sketch")
        sketch.addGeometry(Part.LineSegment(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(8, 0, 0)))
        self.document.recompute()
        before = len(self.document.Objects)
        with self.assertRaises(mesher.ModelError) as refused:
            make_mesh(sketch, dimension=2)
        self.assertIn("Sketch", str(refused.exception))
        self.assertEqual(len(self.document.Objects), before)


class MeshObject(_DocumentTest):
    def _plate(self):
        return self._feature(Part.makePlane(10, 5), "Plate")

    def test_sizes_follow_properties_and_regions(self):
        plate = self._plate()
        coarse = make_mesh(plate, size=2.0, dimension=2).ElementCount
        self.assertGreater(make_mesh(plate, size=0.5, dimension=2).ElementCount, 4 * coarse)

    def test_local_sizes_of_edges_and_faces(self):
        plate = self._plate()
        coarse = make_mesh(plate, size=2.0, dimension=2).ElementCount
        for name in ("Edge1", "Vertex1", "Face1"):
            with self.subTest(name):
                mesh = make_mesh(plate, size=2.0, dimension=2, local_sizes={name: 0.2})
                self.assertGreater(mesh.ElementCount, coarse + 10)

    def test_local_sizes_are_named_as_in_the_part(self):
        # What is meshed is Face6 alone, whose edges have other numbers there.
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        edges = [f"Edge{i}" for i, edge in enumerate(box.Shape.Edges, 1) if any(edge.isSame(e) for e in box.Shape.Faces[5].Edges)]
        coarse = make_mesh((box, ["Face6"]), size=3.0)
        fine = make_mesh((box, ["Face6"]), size=3.0, local_sizes={edges[-1]: 0.2})
        self.assertGreater(fine.ElementCount, coarse.ElementCount + 10)
        middle = box.Shape.getElement(edges[-1]).CenterOfMass
        nearest = min(p.distanceToPoint(middle) for p in fine.FemMesh.Nodes.values())
        self.assertLess(nearest, 0.2)

    def test_mesh_regions_of_fem(self):
        import ObjectsFem

        plate = self._plate()
        mesh = make_mesh(plate, size=2.0, dimension=2)
        region = ObjectsFem.makeMeshRegion(self.document, mesh, 0.2)
        region.References = [(plate, ("Edge1",))]
        count = mesh.ElementCount
        tool = MeshTool(mesh)
        tool.fill_in(tool.run())
        self.assertGreater(mesh.ElementCount, count + 10)

    def test_estimate(self):
        mesh = make_mesh(self._feature(Part.makeBox(10, 10, 10)), size=1.0)
        expected = MeshTool(mesh).estimate()["elements"]
        self.assertGreater(expected, 0.3 * mesh.ElementCount)
        self.assertLess(expected, 3.0 * mesh.ElementCount)

    def test_save_and_reload(self):
        mesh = make_mesh(self._plate(), size=1.0, dimension=2)
        name, count, groups = mesh.Name, mesh.FemMesh.TriangleCount, _groups_of(mesh.FemMesh)
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "saved.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
            mesh = self.document.getObject(name)
            self.assertEqual(mesh.FemMesh.TriangleCount, count)
            self.assertEqual(_groups_of(mesh.FemMesh), groups)
            self.assertEqual(type(mesh.Proxy).__name__, "MesherMesh")
            self.assertAlmostEqual(mesh.CharacteristicLengthMax.Value, 1.0)

    def test_undo(self):
        plate = self._plate()
        self.document.openTransaction("mesh")
        make_mesh(plate, size=1.0, dimension=2)
        self.document.commitTransaction()
        self.assertEqual(len(self.document.findObjects("Fem::FemMeshObject")), 1)
        self.document.undo()
        self.assertEqual(len(self.document.findObjects("Fem::FemMeshObject")), 0)

    def test_cancel(self):
        plate = self._plate()
        with self.assertRaises(mesher.Cancelled):
            make_mesh(plate, size=0.05, dimension=2, progress=lambda stage, fraction: False)
        self.assertEqual(len(self.document.findObjects("Fem::FemMeshObject")), 0)

    def test_same_mesh_as_from_a_file(self):
        plate = self._plate()
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "plate.brep")
            plate.Shape.exportBrep(path)
            self.assertEqual(mesher.mesh(path, size=0.5, dimension=2).hash,
                             mesher.mesh(plate, size=0.5, dimension=2).hash)


class PartAndShape(_DocumentTest):
    """FEM calls the meshed object Part up to FreeCAD 0.21, and Shape from 1.0 on."""

    def setUp(self):
        super().setUp()
        self.box, self.other = (self.document.addObject("Part::Box", name) for name in ("Box", "Other"))
        self.document.recompute()
        self.mesh = make_mesh(self.box, size=5.0)

    def test_both_are_there(self):
        self.assertEqual((self.mesh.Part, self.mesh.Shape), (self.box, self.box))
        self.assertNotIn("Touched", self.mesh.State)

    def test_either_sets_the_other(self):
        self.mesh.Shape = self.other
        self.assertEqual(self.mesh.Part, self.other)
        self.mesh.Part = self.box
        self.assertEqual(self.mesh.Shape, self.box)

    def test_undo_and_redo(self):
        self.document.openTransaction("other part")
        self.mesh.Shape = self.other
        self.document.commitTransaction()
        self.document.undo()
        self.assertEqual((self.mesh.Part, self.mesh.Shape), (self.box, self.box))
        self.document.redo()
        self.assertEqual((self.mesh.Part, self.mesh.Shape), (self.other, self.other))

    def test_deleted_part(self):
        self.document.removeObject("Box")
        self.assertEqual((self.mesh.Part, self.mesh.Shape), (None, None))

    def test_documents_of_versions_with_a_part_only(self):
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "old.FCStd")
            name = self.mesh.Name
            self.mesh.removeProperty("Shape")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
            mesh = self.document.getObject(name)
            self.assertEqual(mesh.Shape, self.document.getObject("Box"))
            self.assertNotIn("Touched", mesh.State)
            mesh.Part = self.document.getObject("Other")
            self.assertEqual(mesh.Shape, mesh.Part)

    def test_a_mesh_is_no_shape(self):
        with self.assertRaises(TypeError):
            make_mesh(self.mesh)


class SeveralObjects(_DocumentTest):
    def test_each_solid_has_the_label_of_its_object(self):
        parts = [self._feature(Part.makeBox(1, 1, 1, FreeCAD.Vector(2 * i, 0, 0))) for i in range(3)]
        for part, label in zip(parts, ("shaft", "wheel", "wheel")):
            part.Label = label
        mesh = make_mesh(parts, size=0.5)
        solids = [part.Label for part in parts]
        groups = {mesh.FemMesh.getGroupName(group) for group in mesh.FemMesh.Groups}
        self.assertLessEqual({*solids, f"{parts[0].Name}.Face1", f"{parts[2].Name}.Face6"}, groups)
        self.assertEqual(len([name for name in groups if "Face" not in name]), 3)

    def test_a_part_in_a_container_is_meshed_where_it_is(self):
        group = self.document.addObject("App::Part", "Group")
        part = self._feature(Part.makeBox(1, 1, 1))
        group.addObject(part)
        group.Placement.Base = FreeCAD.Vector(5, 0, 0)
        self.document.recompute()
        mesh = make_mesh(part, size=0.5)
        self.assertAlmostEqual(min(node.x for node in mesh.FemMesh.Nodes.values()), 5.0)
        mesh = make_mesh(group, size=0.5)
        self.assertAlmostEqual(min(node.x for node in mesh.FemMesh.Nodes.values()), 5.0)


    def test_a_container_has_all_its_parts_whatever_is_shown(self):
        group = self.document.addObject("App::Part", "Group")
        parts = [self._feature(Part.makeBox(1, 1, 1, FreeCAD.Vector(2 * i, 0, 0))) for i in range(2)]
        for part in parts:
            group.addObject(part)
        parts[0].Visibility = False
        self.document.recompute()
        mesh = make_mesh(group, size=0.5, local_sizes={f"{group.Name}.{parts[0].Name}.Face1": 0.25})
        groups = {mesh.FemMesh.getGroupName(number) for number in mesh.FemMesh.Groups}
        self.assertLessEqual({part.Label for part in parts}, groups)
        parts[1].Visibility = False
        mesh.touch()
        self.document.recompute()
        self.assertFalse(mesh.IsStale)

    def test_a_mesh_of_its_own_place_comes_back_to_its_shape(self):
        part = self._feature(Part.makeBox(1, 1, 1))
        mesh = make_mesh(part, size=0.5)
        mesh.Placement.Base.x = 100
        update(mesh)
        self.assertAlmostEqual(min(node.x for node in mesh.FemMesh.Nodes.values()), 0.0)
        self.assertEqual(mesh.Placement, FreeCAD.Placement())


class Stale(_DocumentTest):
    def test_not_after_saving_and_reopening(self):
        turned = Part.makeCylinder(3, 7)
        turned.Placement = FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 40))
        box = Part.makeBox(4, 4, 4)
        shapes = [Part.makeCylinder(5, 20), Part.makeSphere(5), Part.makeCone(5, 2, 8), Part.makeTorus(5, 1), turned,
                  Part.makeBox(4, 4, 4).fuse(turned), Part.makeBox(9, 9, 9).cut(Part.makeSphere(5)),
                  box.makeFillet(1, box.Edges[:3])]
        names = [make_mesh(self._feature(shape), size=4.0).Name for shape in shapes]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "shapes.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
        for name in names:
            self.document.getObject(name).touch()
        self.document.recompute()
        self.assertEqual([name for name in names if self.document.getObject(name).IsStale], [])

    def test_after_a_small_change_and_no_longer_when_it_is_taken_back(self):
        part = self._feature(Part.makeCylinder(5, 20))
        mesh = make_mesh(part, size=4.0)
        for radius, is_stale in ((5.001, True), (5.0, False)):
            part.Shape = Part.makeCylinder(radius, 20)
            self.document.recompute()
            self.assertEqual(mesh.IsStale, is_stale)

    def test_when_a_container_moves(self):
        group = self.document.addObject("App::Part", "Group")
        part = self._feature(Part.makeBox(1, 1, 1))
        group.addObject(part)
        self.document.recompute()
        mesh = make_mesh(part, size=0.5)
        group.Placement.Base.x = 50
        self.document.recompute()
        self.assertTrue(mesh.IsStale)
        update(mesh)
        self.assertFalse(mesh.IsStale)
        self.assertAlmostEqual(min(node.x for node in mesh.FemMesh.Nodes.values()), 50.0)


class Refusals(_DocumentTest):
    def test_object_without_a_shape(self):
        with self.assertRaises(TypeError):
            make_mesh(self.document.addObject("App::FeaturePython", "Nothing"))

    def test_empty_shape(self):
        with self.assertRaises(mesher.ModelError):
            make_mesh(self.document.addObject("Part::Feature", "Empty"))

    def test_faces_of_several_objects(self):
        one, other = (self._feature(Part.makeBox(1, 1, 1)) for _ in range(2))
        for source in ([], [one, (other, ["Face1"])]):
            with self.assertRaises(ValueError):
                make_mesh(source)

    def test_senseless_size(self):
        with self.assertRaises((ValueError, mesher.MesherError)):
            mesher.mesh(Part.makePlane(1, 1), size=-1.0, dimension=2)

    def test_senseless_options_leave_nothing(self):
        plate = self._feature(Part.makePlane(1, 1))
        before = len(self.document.Objects)
        for options, error in (({"size": -1.0}, ValueError), ({"size": "big"}, TypeError), ({"dimension": 4}, ValueError),
                               ({"local_sizes": {"Face1": 0.0}}, ValueError), ({"order": 3}, ValueError),
                               ({"curvature": 12.5, "dimension": 2}, TypeError)):
            with self.subTest(options=options), self.assertRaises(error):
                make_mesh(plate, **options)
        self.assertEqual(len(self.document.Objects), before)

    def test_face_that_is_gone(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        with self.assertRaises(mesher.ModelError) as refused:
            make_mesh((box, ["Face9"]), size=1.0)
        self.assertIn("Face9", str(refused.exception))

    def test_part_that_is_deleted(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        mesh = make_mesh(box, size=5.0)
        self.document.removeObject("Box")
        with self.assertRaises(mesher.ModelError) as refused:
            MeshTool(mesh)
        self.assertIn("no part", str(refused.exception))

    def test_elements_of_second_order_are_refused_with_a_remedy(self):
        from MesherWorkbench.messages import in_words_of_panel

        box = self._feature(Part.makeBox(1, 1, 1))
        with self.assertRaises(mesher.OptionError) as refused:
            make_mesh(box, order=2)
        self.assertEqual(refused.exception.failures[0]["entity"], "order=2")
        self.assertEqual(refused.exception.failures[0]["remedy"], "choose order=1")
        self.assertRegex(in_words_of_panel(refused.exception),
                         "^ElementOrder 2nd: elements of second order are not there yet .*; choose 1st as the object's ElementOrder.$")

    def test_unknown_option(self):
        with self.assertRaises(TypeError):
            make_mesh(self._feature(Part.makePlane(1, 1)), sizes=3.0)


class Options(_DocumentTest):
    """Every option of mesher.mesh is a property of the object, and reaches the mesher from there."""

    def test_each_reaches_the_report(self):
        box = self._feature(Part.makeBox(4, 4, 4))
        wishes = {"size": 2.0, "min_size": 0.25, "curvature": 12, "sag": 0.5, "refinement": 1.5, "grading": 2.0, "improve": False,
                  "threads": 2, "min_angle": 25.0, "max_turn": 60.0, "measure": "q3", "threshold": 0.25, "max_dihedral": 150.0, "lambda_": 6.0, "overlap": "refuse",
                  "max_elements": 90_000, "max_wall_elements": 5000, "timeout": 100.0, "check": True, "heal": True,
                  "size_formula": "3 + x", "local_sizes": {"Face6": 1.5, "Solid1": 1.75},
                  "size_distance": {"Edge1": (1.0, 0.5), "Face1": (1.25, 0.5, 0.125)},
                  "size_box": [((0, 0, 0), (1, 2, 3), 1.5), ((0, 0, 0), (1, 1, 1), 1.5, 0.5)],
                  "size_ball": [((1, 2, 3), 0.5, 1.5), ((1, 2, 3), 0.5, 1.5, 0.25)]}
        mesh = make_mesh(box, dimension=3, order=1, **wishes)
        shape = Part.makeBox(4, 4, 4)
        direct = mesher.mesh(shape, dimension=3, order=1, **wishes)
        by_object = json.loads(mesh.Report)
        self.assertEqual(by_object["options"], direct.report["options"])
        for option, value in wishes.items():
            if isinstance(value, (int, float)) and option in by_object["options"]:
                self.assertEqual(by_object["options"][option], value, option)

    def test_none_is_missing(self):
        arguments = set(inspect.signature(mesher.mesh).parameters) - {"source", "progress", "faces"}
        self.assertEqual(arguments, _OPTIONS)

    def test_sizes_in_files(self):
        box = self._feature(Part.makeBox(4, 4, 4))
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "points.txt")
            with open(path, "w") as file:
                file.write("2 2 2 0.25\n")
            fine = make_mesh(box, size=2.0, size_points=path)
            self.assertGreater(fine.ElementCount, 2 * make_mesh(box, size=2.0).ElementCount)
        with self.assertRaisesRegex(TypeError, "size_points"):
            make_mesh(box, size_points=[[2, 2, 2, 0.25]])

    def test_words_that_cannot_be_read_are_told(self):
        mesh = make_mesh(self._feature(Part.makeBox(4, 4, 4)), size=2.0)
        for name, words, option in (("SizeBalls", "1,2,3=0.5", "size_ball"), ("SizeBoxes", "0,0,0,1,1=2", "size_box"),
                                    ("SizeDistances", "Face1", "size_distance"), ("SizeDistances", "Face1=1", "size_distance")):
            setattr(mesh, name, [words])
            with self.assertRaises(mesher.OptionError) as refused:
                MeshTool(mesh)
            self.assertEqual(refused.exception.failures[0]["entity"], option)
            setattr(mesh, name, [])

    def test_solids_that_overlap(self):
        boxes = self._feature(Part.makeCompound([Part.makeBox(2, 2, 2), Part.makeBox(2, 2, 2, FreeCAD.Vector(1, 1, 1))]))
        with self.assertRaises(mesher.MeshingError):
            make_mesh(boxes, size=1.0, overlap="refuse")
        mesh = make_mesh(boxes, size=1.0)
        self.assertEqual(mesh.Overlap, "separate")
        self.assertRegex(json.loads(mesh.Report)["warnings"][0], "^Solid1 and Solid2 .* about 1 mm.3 in common")
        self.assertEqual({name for name in _groups_of(mesh.FemMesh) if name.startswith("Solid")}, {"Solid1", "Solid2"})


class Solids(_DocumentTest):
    def _plate_with_hole(self):
        plate = Part.makeBox(100, 50, 5).cut(Part.makeCylinder(10, 5, FreeCAD.Vector(50, 25, 0)))
        return self._feature(plate, "Plate")

    def test_groups_and_volume(self):
        plate = self._plate_with_hole()
        mesh = make_mesh(plate, size=5.0, curvature=12)
        groups = _groups_of(mesh.FemMesh)
        self.assertEqual(groups["Solid1"], mesh.FemMesh.TetraCount)
        self.assertEqual(sorted(name for name in groups if name.startswith("Face")),
                         sorted(f"Face{i}" for i in range(1, len(plate.Shape.Faces) + 1)))
        self.assertAlmostEqual(_volume_of(mesh.FemMesh), plate.Shape.Volume, delta=0.005 * plate.Shape.Volume)
        self.assertGreater(mesh.SmallestAngle, 18.0)
        self.assertLess(mesh.LargestAngle, 155.0)

    def test_fem_finds_the_nodes_of_every_face(self):
        plate = self._plate_with_hole()
        mesh = make_mesh(plate, size=8.0, curvature=12).FemMesh
        for number, face in enumerate(plate.Shape.Faces, 1):
            group = [g for g in mesh.Groups if mesh.getGroupName(g) == f"Face{number}"][0]
            nodes = {n for element in mesh.getGroupElements(group) for n in mesh.getElementNodes(element)}
            self.assertEqual(set(mesh.getNodesByFace(face)), nodes, f"Face{number}")

    def test_every_element_is_the_right_way_round(self):
        # CalculiX and VTK count a tetrahedron positive that SMESH, as FreeCAD keeps it, counts negative.
        mesh = make_mesh(self._feature(Part.makeBox(1, 1, 1)), size=0.5).FemMesh
        for element in mesh.Volumes:
            a, b, c, d = (mesh.getNodeById(n) for n in mesh.getElementNodes(element))
            self.assertLess((b - a).cross(c - a).dot(d - a), 0.0)

    def test_solvers_get_positive_elements(self):
        fem_mesh = make_mesh(self._feature(Part.makeBox(1, 1, 1)), size=0.5).FemMesh
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "mesh.inp")
            fem_mesh.write(path)
            nodes, tets = _read_inp(path)
        self.assertEqual(len(tets), fem_mesh.TetraCount)
        for a, b, c, d in ((nodes[n] for n in tet) for tet in tets):
            self.assertGreater((b - a).cross(c - a).dot(d - a), 0.0)

    def test_triangles_look_outward(self):
        fem_mesh = make_mesh(self._feature(Part.makeBox(2, 2, 2)), size=1.0).FemMesh
        for element in fem_mesh.Faces:
            a, b, c = (fem_mesh.getNodeById(n) for n in fem_mesh.getElementNodes(element))
            self.assertGreater((b - a).cross(c - a).dot(a - FreeCAD.Vector(1, 1, 1)), 0.0)

    def test_same_mesh_as_from_a_file(self):
        # A file has fifteen digits, a shape seventeen: the shape is the one that the file gives.
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "plate.brep")
            self._plate_with_hole().Shape.exportBrep(path)
            shape = Part.Shape()
            shape.read(path)
            self.assertEqual(mesher.mesh(path, size=8.0).hash, mesher.mesh(shape, size=8.0).hash)

    def test_faces_of_a_solid_as_a_surface(self):
        cylinder = self.document.addObject("Part::Cylinder", "Cylinder")
        self.document.recompute()
        mesh = make_mesh(cylinder, size=1.0, curvature=24, dimension=2)
        self.assertAlmostEqual(mesh.FemMesh.TriangleCount, mesh.ElementCount)
        self.assertGreater(mesh.ElementCount, 100)

    def test_shell_is_refused_with_a_remedy(self):
        shell = self._feature(Part.Shell(Part.makeBox(1, 1, 1).Faces[:5]), "Shell")
        with self.assertRaises(mesher.MeshingError) as refused:
            make_mesh(shell, size=0.5, dimension=3)
        self.assertIn("dimension=2", str(refused.exception))


class Export(_DocumentTest):
    def test_a_mesh_comes_back_from_its_document(self):
        part = self._feature(Part.makeCylinder(5, 20))
        obj = make_mesh(part, size=2.0, curvature=12)
        direct = mesher.mesh(part.Shape, size=2.0, curvature=12)
        mesh, names = of_fem_mesh(obj.FemMesh)
        self.assertEqual(mesh.check(), [])
        self.assertEqual(names, {"Face1": "Face1", "Face2": "Face2", "Face3": "Face3", "Solid1": "Solid1"})
        for name in ("nodes", "triangles", "triangle_face", "tets", "tet_solid"):
            self.assertTrue((getattr(mesh, name) == getattr(direct, name)).all(), name)

    def test_files_in_all_formats(self):
        obj = make_mesh(self._feature(Part.makeBox(1, 2, 3)), size=1.0)
        for kind in exporter.FILE_TYPES:
            extension = kind[kind.index("*") + 1:-1]
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "mesh" + extension)
                exporter.export([obj, self.document.addObject("App::FeaturePython", "Other")], path)
                self.assertGreater(os.path.getsize(path), 500, kind)

    def test_other_elements_are_refused_and_leave_no_file(self):
        cube = Fem.FemMesh()
        for place in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)):
            cube.addNode(*place)
        cube.addVolume([1, 2, 3, 4, 5, 6, 7, 8])
        obj = self.document.addObject("Fem::FemMeshObject", "Cube")
        obj.FemMesh = cube
        with tempfile.TemporaryDirectory() as folder:
            exporter.export([obj], os.path.join(folder, "cube.msh"))
            self.assertEqual(os.listdir(folder), [])

    def test_arrays_that_are_no_mesh(self):
        nodes = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
        for triangles, faces, error in (([[0, 1, 3]], [0], IndexError), ([[0, 1, 2]], [-1], ValueError), ([[0, 1, 2]], [], ValueError),
                                        ([[0, 1]], [0], ValueError)):
            with self.assertRaises(error):
                mesher.Mesh.of_arrays(nodes, triangles, faces)
        with self.assertRaises(ValueError):
            mesher.Mesh.of_arrays([[0, 0, float("nan")], *nodes[1:]], [[0, 1, 2]], [0])
        with self.assertRaisesRegex(ValueError, "no report"):
            mesher.Mesh.of_arrays(nodes, [[0, 1, 2]], [0]).quality()


class Inspection(_DocumentTest):
    def _solid(self):
        return make_mesh(self._feature(Part.makeCylinder(5, 20)), size=2.0, curvature=12)

    def test_boundary_of_all_elements_is_the_surface(self):
        mesh = self._solid()
        arrays = MeshArrays(mesh.FemMesh)
        self.assertEqual(len(boundary_of(arrays.elements)), mesh.FemMesh.TriangleCount)

    def test_both_sides_of_a_cut_are_closed_and_all_there_is(self):
        arrays = MeshArrays(self._solid().FemMesh)
        near, far = arrays.beyond(2, 0.4), arrays.beyond(2, 0.6, is_flipped=True)
        self.assertEqual(len(near) + len(far), len(arrays.elements))
        for side in (near, far):
            points, triangles = used_of(arrays.nodes, boundary_of(side))
            self.assertEqual(len(points), triangles.max() + 1)
            part = Mesh.Mesh(points[triangles].tolist())
            self.assertTrue(part.isSolid())
            self.assertGreater(part.Volume, 0.0)

    def test_quadratic_elements_are_read_by_their_corners(self):
        mesh = Fem.FemMesh()
        for place in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (.5, 0, 0), (.5, .5, 0), (0, .5, 0), (0, 0, .5), (.5, 0, .5), (0, .5, .5)):
            mesh.addNode(*place)
        mesh.addVolume(list(range(1, 11)))
        arrays = MeshArrays(mesh)
        self.assertEqual(sorted(arrays.elements[0].tolist()), [0, 1, 2, 3])
        self.assertAlmostEqual(arrays.worst(1)[0][1], 54.7356, places=3)

    def test_other_elements_are_refused(self):
        cube = Fem.FemMesh()
        for place in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)):
            cube.addNode(*place)
        square = cube.copy() if hasattr(cube, "copy") else Fem.FemMesh(cube)
        cube.addVolume([1, 2, 3, 4, 5, 6, 7, 8])
        square.addFace([1, 2, 3, 4])
        for mesh, words in ((cube, "1 hexahedra"), (square, "1 quadrilaterals")):
            with self.assertRaisesRegex(ValueError, words):
                MeshArrays(mesh)

    def test_worst_elements_have_the_angles_of_the_report(self):
        mesh = self._solid()
        worst = MeshArrays(mesh.FemMesh).worst(10**9)
        self.assertEqual(len(worst), mesh.ElementCount)
        self.assertAlmostEqual(min(smallest for _, smallest, _ in worst), mesh.SmallestAngle, places=6)
        self.assertAlmostEqual(max(largest for _, _, largest in worst), mesh.LargestAngle, places=6)
        badness = [min(smallest, 180.0 - largest) for _, smallest, largest in worst]
        self.assertEqual(badness, sorted(badness))

    def test_faces(self):
        mesh = make_mesh(self._feature(Part.makePlane(10, 5)), size=1.0, dimension=2)
        arrays = MeshArrays(mesh.FemMesh)
        self.assertFalse(arrays.is_volume)
        self.assertAlmostEqual(min(arrays.angles()[0]), mesh.SmallestAngle, places=6)
        self.assertLess(0, len(arrays.beyond(0, 0.5)))
        self.assertLess(len(arrays.beyond(0, 0.5)), mesh.ElementCount)

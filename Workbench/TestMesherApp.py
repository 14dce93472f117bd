"""Tests without a window: freecadcmd -t TestMesherApp."""
import os
import tempfile
import unittest

import FreeCAD
import Part

import mesher
from MesherWorkbench import make_mesh


def _groups_of(fem_mesh):
    return {fem_mesh.getGroupName(group): len(fem_mesh.getGroupElements(group)) for group in fem_mesh.Groups}


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


class Refusals(_DocumentTest):
    def test_object_without_a_shape(self):
        with self.assertRaises(TypeError):
            make_mesh(self.document.addObject("App::FeaturePython", "Nothing"))

    def test_empty_shape(self):
        with self.assertRaises(mesher.ModelError):
            make_mesh(self.document.addObject("Part::Feature", "Empty"))

    def test_senseless_size(self):
        with self.assertRaises((ValueError, mesher.MesherError)):
            mesher.mesh(Part.makePlane(1, 1), size=-1.0, dimension=2)

    def test_unknown_option(self):
        with self.assertRaises(TypeError):
            make_mesh(self._feature(Part.makePlane(1, 1)), sizes=3.0)

"""The package mesher without FreeCAD: test_mesher_module.py MODULE_DIRECTORY DATA_DIRECTORY."""
import gc
import os
import sys
import tempfile
import threading
import unittest

import numpy

MODULE_DIRECTORY, DATA_DIRECTORY = sys.argv[1:3]
sys.path.insert(0, MODULE_DIRECTORY)
import mesher  # noqa: E402

PLATE = os.path.join(DATA_DIRECTORY, "plate.brep")


def mesh_plate(**options):
    return mesher.mesh(PLATE, dimension=2, **{"size": 1.0, **options})


class Arrays(unittest.TestCase):
    def test_shapes_and_kinds(self):
        mesh = mesh_plate()
        self.assertEqual(mesh.nodes.shape[1], 3)
        self.assertEqual(mesh.nodes.dtype, numpy.float64)
        self.assertEqual(mesh.triangles.shape[1], 3)
        self.assertEqual(mesh.tets.shape, (0, 4))
        self.assertEqual(len(mesh.triangle_face), len(mesh.triangles))
        self.assertLess(mesh.triangles.max(), len(mesh.nodes))
        self.assertEqual(set(numpy.unique(mesh.node_dimension)), {0, 1, 2})

    def test_area_from_the_arrays_is_that_of_the_report(self):
        mesh = mesh_plate()
        a, b, c = (mesh.nodes[mesh.triangles[:, i]] for i in range(3))
        area = 0.5 * numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1).sum()
        self.assertAlmostEqual(area, mesh.report["mesh"]["area"], delta=1e-9 * area)

    def test_views_outlive_the_mesh(self):
        nodes = mesh_plate().nodes
        copy = nodes.copy()
        gc.collect()
        mesh_plate(size=0.7)
        self.assertTrue((nodes == copy).all())

    def test_views_are_read_only(self):
        with self.assertRaises(ValueError):
            mesh_plate().nodes[0, 0] = 1.0

    def test_nothing_is_wrong_with_the_mesh(self):
        self.assertEqual(mesh_plate().check(), [])


class Runs(unittest.TestCase):
    def test_same_mesh_every_time(self):
        self.assertEqual(mesh_plate().hash, mesh_plate().hash)
        self.assertNotEqual(mesh_plate().hash, mesh_plate(size=0.5).hash)

    def test_the_report_has_the_hash_of_the_mesh(self):
        mesh = mesh_plate()
        self.assertEqual(int(mesh.report["mesh_hash"], 16), mesh.hash)

    def test_progress_can_cancel(self):
        with self.assertRaises(mesher.Cancelled) as cancelled:
            mesh_plate(size=0.02, progress=lambda stage, fraction: fraction < 0.3)
        self.assertEqual(cancelled.exception.report["status"], "cancelled")

    def test_progress_that_raises_ends_the_run_with_its_own_error(self):
        def fail(stage, fraction):
            raise ZeroDivisionError(stage)

        with self.assertRaises(ZeroDivisionError):
            mesh_plate(size=0.02, progress=fail)

    def test_other_threads_run_meanwhile(self):
        ticks = []
        done = threading.Event()

        def tick():
            while not done.wait(0.001):
                ticks.append(None)

        thread = threading.Thread(target=tick)
        thread.start()
        mesh_plate(size=0.03)
        done.set()
        thread.join()
        self.assertGreater(len(ticks), 5)

    def test_a_model_is_read_once_and_meshed_twice(self):
        model = mesher.Model.read(PLATE)
        self.assertEqual(mesher.mesh(model, dimension=2, size=1.0).hash, mesh_plate().hash)

    def test_info(self):
        facts = mesher.info(PLATE)
        self.assertEqual(facts["faces"], mesher.Model.read(PLATE).face_count)


class Refusals(unittest.TestCase):
    def test_missing_file(self):
        with self.assertRaises(mesher.ModelError) as refused:
            mesher.mesh("/nowhere/part.step")
        self.assertEqual(refused.exception.failures[0]["entity"], "/nowhere/part.step")
        self.assertTrue(refused.exception.failures[0]["remedy"])

    def test_truncated_file(self):
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "half.brep")
            with open(PLATE, "rb") as whole, open(path, "wb") as half:
                half.write(whole.read()[:700])
            with self.assertRaises(mesher.ModelError):
                mesher.mesh(path, dimension=2)

    def test_no_shape(self):
        with self.assertRaises(TypeError):
            mesher.mesh(3)

    def test_options(self):
        for options, error in (({"sizes": 1.0}, TypeError), ({"size": "small"}, TypeError), ({"size": True}, TypeError),
                               ({"size": -1.0}, ValueError), ({"size": float("nan")}, ValueError),
                               ({"measure": "q9"}, ValueError), ({"size": 1e-9}, mesher.MeshingError)):
            with self.subTest(options=options), self.assertRaises(error):
                mesh_plate(**options)

    def test_unwritable_target(self):
        with self.assertRaises(mesher.WriteError):
            mesh_plate().write("/nowhere/plate.msh")

    def test_unknown_format(self):
        with self.assertRaises(mesher.WriteError):
            mesh_plate().write("plate.xyz")


class Files(unittest.TestCase):
    def test_written_file_is_there_whole(self):
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "plate.msh")
            mesh_plate().write(path)
            with open(path) as file:
                self.assertIn("$EndElements", file.read())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)

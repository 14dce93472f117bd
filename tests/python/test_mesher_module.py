"""The package mesher without FreeCAD: test_mesher_module.py MODULE_DIRECTORY DATA_DIRECTORY."""
import gc
import os
import sys
import tempfile
import threading
import time
import unittest

import numpy

MODULE_DIRECTORY, DATA_DIRECTORY = sys.argv[1:3]
sys.path.insert(0, MODULE_DIRECTORY)
import mesher  # noqa: E402

PLATE = os.path.join(DATA_DIRECTORY, "plate.brep")


def mesh_plate(**options):
    return mesher.mesh(PLATE, **{"dimension": 2, "size": 1.0, **options})


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
        model = mesher.Model.read(PLATE)
        worker = threading.Thread(target=lambda: mesher.mesh(model, dimension=2, size=0.008))
        worker.start()
        ticks = 0
        while worker.is_alive():
            time.sleep(0.001)
            ticks += 1
        # A worker that kept the interpreter to itself would let this thread run before and behind it only.
        self.assertGreater(ticks, 5)

    def test_a_model_is_read_once_and_meshed_twice(self):
        model = mesher.Model.read(PLATE)
        self.assertEqual(mesher.mesh(model, dimension=2, size=1.0).hash, mesh_plate().hash)

    def test_info(self):
        facts = mesher.info(PLATE)
        self.assertEqual(facts["faces"], mesher.Model.read(PLATE).face_count)


class Sizes(unittest.TestCase):
    """Of the plate, which is coarse without them."""

    def setUp(self):
        self.coarse = mesh_plate(size=2.0)
        lower, upper = self.coarse.nodes.min(axis=0), self.coarse.nodes.max(axis=0)
        self.middle = 0.5 * (lower + upper)

    def test_each_way_to_ask_makes_smaller_elements(self):
        x, y, z = self.middle.tolist()
        for options in ({"local_sizes": {"Edge1": 0.1}}, {"size_distance": {"Edge1": (0.1, 0.2)}},
                        {"size_distance": {"Edge1": (0.1, 0.2, 0.5)}}, {"size_box": [((x, y, z), (x + 1, y + 1, z), 0.1)]},
                        {"size_box": [((x, y, z), (x + 1, y + 1, z), 0.1, 0.5)]}, {"size_ball": [(self.middle, 1.0, 0.1)]},
                        {"size_ball": [((x, y, z), 1.0, 0.1, 0.5)]}, {"size_formula": "0.3"}, {"curvature": 100},
                        {"sag": 0.001}, {"size_points": [(x, y, z, 0.1)]}, {"size_points": numpy.array([[x, y, z, 0.1]], "f4")},
                        {"refinement": 5}):
            with self.subTest(options=options):
                self.assertGreater(len(mesh_plate(size=2.0, **options).triangles), len(self.coarse.triangles) + 10)

    def test_faces_choose_what_is_meshed(self):
        self.assertEqual(mesh_plate(size=2.0, faces=["Face1"]).hash, self.coarse.hash)
        with self.assertRaises(mesher.MesherError):
            mesh_plate(size=2.0, faces=["Face9"])

    def test_faces_of_different_planes_are_meshed_in_space(self):
        box = os.path.join(DATA_DIRECTORY, "box.brep")
        sides = mesher.mesh(box, dimension=2, size=0.4, faces=["Face5", "Face1"])
        self.assertEqual(numpy.unique(sides.triangle_face).tolist(), numpy.unique([0, 4]).tolist())
        self.assertEqual(sides.check(), [])

    def test_a_background_mesh_gives_its_sizes(self):
        distance = numpy.linalg.norm(self.coarse.nodes - self.middle, axis=1)
        sizes = 0.1 + 0.5 * distance
        finer = mesh_plate(size=2.0, background=(self.coarse.nodes, self.coarse.triangles, sizes))
        corners = finer.nodes[finer.triangles]
        lengths = numpy.linalg.norm(corners[:, 1] - corners[:, 0], axis=1)
        away = numpy.linalg.norm(corners.mean(axis=1) - self.middle, axis=1)
        self.assertLess(lengths[away < 0.5].mean(), 0.5 * lengths[away > 1.5].mean())

    def test_points_of_an_array_are_those_of_a_file(self):
        rows = [[*self.middle.tolist(), 0.125]]
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "points.txt")
            with open(path, "w") as file:
                file.write(" ".join(map(repr, rows[0])))
            self.assertEqual(mesh_plate(size=2.0, size_points=path).hash, mesh_plate(size=2.0, size_points=rows).hash)

    def test_estimate_is_near(self):
        for size in (1.0, 0.2):
            expected = mesher.estimate(PLATE, dimension=2, size=size)["elements"]
            made = len(mesh_plate(size=size).triangles)
            self.assertLess(expected / made, 2.5)
            self.assertGreater(expected / made, 0.4)


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
        nodes, triangles = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]
        for options, error in (
                ({"sizes": 1.0}, TypeError), ({"size": "small"}, TypeError), ({"size": True}, TypeError),
                ({"size": [1.0]}, TypeError), ({"size": -1.0}, ValueError), ({"size": 0}, ValueError),
                ({"size": float("nan")}, ValueError), ({"size": float("inf")}, ValueError), ({"min_size": 2.0}, ValueError),
                ({"curvature": 2}, ValueError), ({"curvature": "12"}, TypeError), ({"threads": 0}, ValueError),
                ({"threads": -1}, TypeError), ({"threads": 1.5}, TypeError), ({"dimension": 4}, ValueError),
                ({"dimension": "3"}, TypeError), ({"order": 3}, ValueError), ({"improve": "yes"}, TypeError),
                ({"measure": "q9"}, ValueError), ({"measure": 2}, TypeError), ({"timeout": 0}, ValueError),
                ({"max_elements": 0}, ValueError), ({"faces": "Face1"}, TypeError), ({"faces": [1]}, TypeError),
                ({"local_sizes": {"Edge1": -1}}, ValueError), ({"local_sizes": {"Edge1": "fine"}}, TypeError),
                ({"local_sizes": {1: 1.0}}, TypeError), ({"local_sizes": ["Edge1"]}, TypeError),
                ({"local_sizes": {"Edge99": 1.0}}, mesher.MesherError), ({"local_sizes": {"Hole": 1.0}}, mesher.MesherError),
                ({"size_distance": {"Edge1": 1.0}}, TypeError), ({"size_distance": {"Edge1": (1,)}}, TypeError),
                ({"size_box": [((0, 0), (1, 1), 1.0)]}, TypeError), ({"size_ball": [((0, 0, 0), -1.0, 1.0)]}, ValueError),
                ({"size_ball": ((0, 0, 0), 1.0, 1.0)}, TypeError), ({"size_formula": "1 +"}, ValueError),
                ({"size_formula": 1.0}, TypeError), ({"size_points": [[0, 0, 0]]}, ValueError),
                ({"size_points": [[0, 0, 0, -1]]}, ValueError), ({"size_points": [[0, 0, float("nan"), 1]]}, ValueError),
                ({"size_points": numpy.zeros((0, 4))}, ValueError), ({"size_points": [["a", "b", "c", "d"]]}, TypeError),
                ({"size_points": 3}, ValueError), ({"size_points": "/nowhere/points.txt"}, mesher.MeshingError),
                ({"background": "/nowhere/mesh.msh"}, mesher.MeshingError), ({"background": (nodes, triangles)}, TypeError),
                ({"background": (nodes, triangles, [1, 1])}, ValueError), ({"background": (nodes, triangles, [1, 1, 0])}, ValueError),
                ({"background": (nodes, [[0, 1, 3]], [1, 1, 1])}, ValueError),
                ({"background": (nodes, [[0, 1, -1]], [1, 1, 1])}, ValueError),
                ({"background": (nodes, [[0.5, 1, 2]], [1, 1, 1])}, TypeError),
                ({"background": (nodes, [[0, 1]], [1, 1, 1])}, ValueError), ({"size": 1e-9}, mesher.MeshingError)):
            with self.subTest(options=options), self.assertRaises(error):
                mesh_plate(**options)

    def test_errors_of_options_speak_python_and_carry_what_to_do(self):
        with self.assertRaises(mesher.OptionError) as refused:
            mesh_plate(size=1.0, min_size=2.0)
        self.assertNotIn("--", str(refused.exception))
        self.assertEqual(refused.exception.failures[0]["entity"], "min_size")
        self.assertTrue(refused.exception.failures[0]["remedy"])

    def test_a_limit_leaves_what_there_is(self):
        whole = len(mesh_plate(size=0.1).triangles)
        with self.assertRaises(mesher.MeshingError) as ended:
            mesh_plate(size=0.1, max_elements=whole * 3 // 4)
        self.assertEqual(ended.exception.report["stop_reason"], "element_limit")
        partial = ended.exception.mesh
        self.assertGreater(len(partial.triangles), 100)
        self.assertGreater(partial.quality()["max_angle"], 60.0)

    def test_estimate_refuses_what_mesh_refuses(self):
        with self.assertRaises(mesher.OptionError):
            mesher.estimate(PLATE, dimension=2, size=-1.0)
        with self.assertRaises(TypeError):
            mesher.estimate(PLATE, sizes=1.0)
        with self.assertRaises(mesher.MesherError):
            mesher.estimate(PLATE, size=1.0)

    def test_estimate_is_ended_by_its_progress(self):
        heard = []
        def no(stage, fraction):
            heard.append(stage)
            return False
        with self.assertRaises(mesher.Cancelled):
            mesher.estimate(PLATE, dimension=2, size=1e-3, progress=no)
        self.assertEqual(len(heard), 1)

    def test_estimate_keeps_to_its_time(self):
        with self.assertRaises(mesher.MeshingError) as ended:
            mesher.estimate(PLATE, dimension=2, size=1e-3, timeout=1e-9)
        self.assertIn("time limit", str(ended.exception))

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

#!/usr/bin/python3
"""Tests the program mesher as its users call it: exit statuses, messages, files.

    test_mesher.py PROGRAM DATA-FOLDER [unittest options]
"""
import json
import math
import os
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve() if len(sys.argv) > 2 else None
DATA = Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else None

try:
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    vtkXMLUnstructuredGridReader = None


# A unit square, as small as AP203 allows.
STEP_SQUARE = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','',(''),(''),'','','');
FILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('');
#2=MECHANICAL_CONTEXT('',#1,'mechanical');
#3=PRODUCT('p','p','',(#2));
#4=PRODUCT_DEFINITION_FORMATION('','',#3);
#5=DESIGN_CONTEXT('',#1,'design');
#6=PRODUCT_DEFINITION('','',#4,#5);
#7=PRODUCT_DEFINITION_SHAPE('','',#6);
#8=SHAPE_DEFINITION_REPRESENTATION(#7,#9);
#9=MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#10,#17),#11);
#10=SHELL_BASED_SURFACE_MODEL('',(#18));
#11=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#12))GLOBAL_UNIT_ASSIGNED_CONTEXT((#13,#14,#15))REPRESENTATION_CONTEXT('',''));
#12=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-7),#13,'','');
#13=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#14=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#15=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#16=CARTESIAN_POINT('',(0.,0.,0.));
#17=AXIS2_PLACEMENT_3D('',#16,#26,#27);
#18=OPEN_SHELL('',(#19));
#19=ADVANCED_FACE('',(#20),#25,.T.);
#20=FACE_BOUND('',#21,.T.);
#21=EDGE_LOOP('',(#51,#52,#53,#54));
#25=PLANE('',#17);
#26=DIRECTION('',(0.,0.,1.));
#27=DIRECTION('',(1.,0.,0.));
#28=DIRECTION('',(0.,1.,0.));
#29=DIRECTION('',(-1.,0.,0.));
#30=CARTESIAN_POINT('',(1.,0.,0.));
#31=CARTESIAN_POINT('',(1.,1.,0.));
#32=CARTESIAN_POINT('',(0.,1.,0.));
#33=DIRECTION('',(0.,-1.,0.));
#34=VERTEX_POINT('',#16);
#35=VERTEX_POINT('',#30);
#36=VERTEX_POINT('',#31);
#37=VERTEX_POINT('',#32);
#38=VECTOR('',#27,1.);
#39=VECTOR('',#28,1.);
#40=VECTOR('',#29,1.);
#41=VECTOR('',#33,1.);
#42=LINE('',#16,#38);
#43=LINE('',#30,#39);
#44=LINE('',#31,#40);
#45=LINE('',#32,#41);
#46=EDGE_CURVE('',#34,#35,#42,.T.);
#47=EDGE_CURVE('',#35,#36,#43,.T.);
#48=EDGE_CURVE('',#36,#37,#44,.T.);
#49=EDGE_CURVE('',#37,#34,#45,.T.);
#51=ORIENTED_EDGE('',*,*,#46,.T.);
#52=ORIENTED_EDGE('',*,*,#47,.T.);
#53=ORIENTED_EDGE('',*,*,#48,.T.);
#54=ORIENTED_EDGE('',*,*,#49,.T.);
ENDSEC;
END-ISO-10303-21;
"""


def read_msh(path):
    """Places of the nodes by tag, and the corners of the triangles, of a Gmsh 4.1 file."""
    words = iter(path.read_text().split("$Nodes\n")[1].replace("$EndNodes\n$Elements\n", "").split())
    number = lambda: int(next(words))
    nodes, triangles = {}, []
    blocks, _, _, _ = (number() for _ in range(4))
    for _ in range(blocks):
        _, _, _, count = (number() for _ in range(4))
        tags = [number() for _ in range(count)]
        nodes.update((tag, tuple(float(next(words)) for _ in range(3))) for tag in tags)
    blocks, _, _, _ = (number() for _ in range(4))
    corners = {15: 1, 1: 2, 2: 3}
    for _ in range(blocks):
        _, _, kind, count = (number() for _ in range(4))
        for _ in range(count):
            number()
            element = [number() for _ in range(corners[kind])]
            if kind == 2:
                triangles.append(element)
    return nodes, triangles


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_mesher(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=120,
                              cwd=self.folder, check=False)

    def expect(self, status, *arguments):
        run = self.run_mesher(*arguments)
        self.assertEqual(run.returncode, status, run.stdout + run.stderr)
        return run

    def expect_refusal(self, status, pattern, *arguments):
        """One sentence on stderr that fits the pattern, and nothing written."""
        before = sorted(os.listdir(self.folder))
        run = self.expect(status, *arguments)
        self.assertRegex(run.stderr, pattern)
        self.assertEqual(len(run.stderr.strip().split("\n")), 1, run.stderr)
        self.assertTrue(run.stderr.startswith("mesher: ") and run.stderr.endswith(".\n"), run.stderr)
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def mesh_plate(self, *arguments):
        return self.expect(0, "mesh", DATA / "plate.brep", "--dimension", 2, "--size", 0.2, *arguments)


class TestMesh(Case):
    def test_writes_every_format(self):
        names = ["m.msh", "m.vtu", "m.vtk", "m.su2", "m.stl", "m.ply", "m.inp", "m.unv", "m.png"]
        self.mesh_plate(*[part for name in names for part in ("-o", name)])
        self.assertEqual(sorted(os.listdir(self.folder)), sorted(names))
        for name in names:
            self.assertGreater((self.folder / name).stat().st_size, 1000, name)

    def test_report_says_what_was_done(self):
        self.mesh_plate("-o", "m.msh", "--report", "r.json", "--check")
        report = json.loads((self.folder / "r.json").read_text())
        self.assertEqual(report["status"], "done")
        self.assertEqual(report["stop_reason"], "done")
        self.assertEqual(report["failures"], [])
        self.assertGreaterEqual(report["quality"]["min_angle"], 30)
        self.assertAlmostEqual(report["model"]["area"], 8 - 3.141592653589793 / 4, places=10)
        self.assertAlmostEqual(report["mesh"]["area"], report["model"]["area"], delta=0.05)
        self.assertEqual(report["options"]["size"], 0.2)
        self.assertRegex(report["mesh_hash"], "^[0-9a-f]{16}$")

    def test_two_runs_give_the_same_bytes(self):
        self.mesh_plate("-o", "a.msh")
        self.mesh_plate("-o", "b.msh")
        self.assertEqual((self.folder / "a.msh").read_bytes(), (self.folder / "b.msh").read_bytes())

    def test_format_overrules_the_extension(self):
        self.mesh_plate("-o", "m.dat", "-o", "n.msh", "--format", "msh2")
        self.assertIn("2.2 0 8", (self.folder / "m.dat").read_text())
        self.assertIn("4.1 0 8", (self.folder / "n.msh").read_text())

    def test_names_regions_after_faces(self):
        self.expect(0, "mesh", DATA / "inclusion.brep", "--dimension", 2, "--size", 0.2, "-o", "m.msh")
        text = (self.folder / "m.msh").read_text()
        for name in ('2 1 "Face1"', '2 2 "Face2"', '1 5 "Edge5"', '0 5 "Vertex5"'):
            self.assertIn(name, text)

    def test_curved_boundary_lies_on_the_circle(self):
        self.mesh_plate("-o", "m.msh", "--curved-boundary", "b.json", "--boundary-order", 3)
        boundary = json.loads((self.folder / "b.json").read_text())
        self.assertEqual(boundary["order"], 3)
        hole = [edge for edge in boundary["edges"] if edge["curve"] == "Edge5"]
        self.assertGreater(len(hole), 8)
        for point in (point for edge in hole for point in edge["gauss"]):
            x, y = point["point"][0] - 1, point["point"][1] - 1
            self.assertAlmostEqual(x * x + y * y, 0.25, places=14)
            self.assertAlmostEqual(abs(point["curvature"]), 2, places=10)

    def test_limit_on_elements_leaves_nothing_unless_asked_to(self):
        arguments = ["mesh", DATA / "plate.brep", "--dimension", 2, "--size", 0.2, "--max-elements", 400, "-o", "m.msh"]
        self.expect_refusal(1, "limit of 400 elements", *arguments)
        run = self.expect(1, *arguments, "--keep-partial", "--report", "r.json")
        self.assertIn("limit", run.stderr)
        self.assertTrue((self.folder / "m.msh").exists())
        report = json.loads((self.folder / "r.json").read_text())
        self.assertEqual((report["status"], report["stop_reason"]), ("failed", "element_limit"))

    def test_timeout(self):
        self.expect_refusal(1, "time limit", "mesh", DATA / "plate.brep", "--dimension", 2, "--size", 0.002, "--timeout", 0.05,
                            "-o", "m.msh")

    def test_sigint_cancels_and_leaves_nothing(self):
        command = [PROGRAM, "mesh", DATA / "plate.brep", "--dimension", "2", "--size", "0.001", "-o", "m.msh", "--report", "r.json"]
        with subprocess.Popen(command, cwd=self.folder, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL) as process:
            time.sleep(0.5)
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertIn(os.listdir(self.folder), ([], ["r.json"]))


def turned(axis, angle):
    """The matrix of a rotation, by Rodrigues' formula."""
    length = math.hypot(*axis)
    x, y, z = (c / length for c in axis)
    c, s = math.cos(angle), math.sin(angle)
    return [[c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
            [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
            [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)]]


class TestSolids(Case):
    """Solids and faces in space."""

    def test_box(self):
        self.expect(0, "mesh", DATA / "box.brep", "--size", 0.3, "--check", "-o", "m.msh", "--report", "r.json")
        self.expect(0, "check", "m.msh", "--model", DATA / "box.brep")
        report = json.loads((self.folder / "r.json").read_text())
        self.assertAlmostEqual(report["mesh"]["volume"], 6.0, delta=1e-9)
        self.assertGreater(report["quality"]["min_dihedral"], 18.0)
        self.assertLess(report["quality"]["max_dihedral"], 155.0)
        self.assertEqual(len(report["quality"]["dihedral_histogram"]), 18)
        for stage in ("reading", "estimate", "surfaces", "contacts", "tetrahedralization", "refinement", "measures", "writing"):
            self.assertIn(stage, report["seconds"])
            self.assertGreaterEqual(report["cpu_seconds"][stage], 0.0)

    def test_two_runs_give_the_same_bytes(self):
        for name in ("a.msh", "b.msh"):
            self.expect(0, "mesh", DATA / "box.brep", "--size", 0.4, "-o", name)
        self.assertEqual((self.folder / "a.msh").read_bytes(), (self.folder / "b.msh").read_bytes())

    def test_the_number_of_threads_changes_nothing(self):
        for threads in (1, 2):
            self.expect(0, "mesh", DATA / "box.brep", "--size", 0.4, "--threads", threads, "-o", f"{threads}.msh")
        self.assertEqual((self.folder / "1.msh").read_bytes(), (self.folder / "2.msh").read_bytes())

    def test_writes_every_format(self):
        names = ["m.msh", "m.vtu", "m.vtk", "m.inp", "m.unv", "m.stl"]
        outputs = [word for name in names for word in ("-o", name)]
        self.expect(0, "mesh", DATA / "box.brep", "--size", 0.5, *outputs)
        for name in names:
            self.assertGreater((self.folder / name).stat().st_size, 1000, name)

    def test_sizes_on_an_edge(self):
        counts = []
        for options in ([], ["--local-size", "Edge1=0.05"]):
            self.expect(0, "mesh", DATA / "box.brep", "--size", 0.5, *options, "-o", "m.msh", "--report", "r.json")
            counts.append(json.loads((self.folder / "r.json").read_text())["counts"]["tets"])
        self.assertGreater(counts[1], 3 * counts[0])

    def test_what_solids_do_not_take_is_told(self):
        self.expect_refusal(1, "--min-angle: cannot be above 34", "mesh", DATA / "box.brep", "--size", 0.5, "--min-angle", 40, "-o", "m.msh")
        run = self.expect(0, "mesh", DATA / "box.brep", "--size", 0.5, "--refinement", 2, "-o", "m.msh")
        self.assertIn("--refinement has no effect", run.stderr)

    def test_faces_in_space(self):
        self.expect(0, "mesh", DATA / "cylinder_wall.brep", "--dimension", 2, "--size", 0.3, "--check", "-o", "m.msh")
        self.expect(0, "mesh", DATA / "box.brep", "--dimension", 2, "--size", 0.3, "--check", "-o", "b.msh", "--report", "r.json")
        self.assertAlmostEqual(json.loads((self.folder / "r.json").read_text())["mesh"]["area"], 22.0, delta=1e-9)

    def test_limits(self):
        self.expect_refusal(1, "limit of 2000 elements", "mesh", DATA / "box.brep", "--size", 0.3, "--max-elements", 2000, "-o", "m.msh")
        self.expect_refusal(1, "time limit", "mesh", DATA / "box.brep", "--size", 0.01, "--timeout", 0.2, "-o", "m.msh")
        self.assertFalse((self.folder / "m.msh").exists())

    def test_sigint_cancels_within_a_second(self):
        process = subprocess.Popen([PROGRAM, "mesh", DATA / "box.brep", "--size", "0.01", "-o", "m.msh"], cwd=self.folder,
                                   stderr=subprocess.PIPE)
        time.sleep(1.0)
        process.send_signal(signal.SIGINT)
        self.assertIn("cancelled", process.communicate(timeout=30)[1].decode())
        self.assertEqual(process.returncode, 130)
        self.assertFalse((self.folder / "m.msh").exists())


class TestPlacement(Case):
    """Faces in any plane of space."""

    def mesh_placed(self, model, rotation, translation=(0, 0, 0)):
        """Meshes a copy of the model that its location turns and moves; returns nodes, triangles and the report."""
        rows = "\n".join(" ".join(repr(float(value)) for value in (*row, t)) for row, t in zip(rotation, translation))
        text = (DATA / model).read_text().replace("Locations 0", "Locations 1\n1\n" + rows).rstrip()
        self.assertTrue(text.endswith("+1 0"))
        (self.folder / "placed.brep").write_text(text[:-1] + "1\n")
        self.expect(0, "mesh", "placed.brep", "--dimension", 2, "--size", 0.2, "--check", "-o", "m.msh", "--report", "r.json")
        self.expect(0, "check", "m.msh", "--model", "placed.brep")
        return *read_msh(self.folder / "m.msh"), json.loads((self.folder / "r.json").read_text())

    def test_placements_without_rounding_give_the_same_mesh(self):
        identity = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
        for model in ("plate.brep", "inclusion.brep"):
            nodes, triangles, report = self.mesh_placed(model, identity)
            for rotation in ([[0, 0, 1], [1, 0, 0], [0, 1, 0]], [[1, 0, 0], [0, 0, -1], [0, 1, 0]],
                             [[-1, 0, 0], [0, 1, 0], [0, 0, -1]], [[0, -1, 0], [0, 0, -1], [1, 0, 0]]):
                with self.subTest(model=model, rotation=rotation):
                    placed_nodes, placed_triangles, placed_report = self.mesh_placed(model, rotation)
                    expected = {tag: tuple(sum(r * c for r, c in zip(row, p)) for row in rotation) for tag, p in nodes.items()}
                    self.assertEqual(placed_nodes, expected)
                    self.assertEqual(placed_triangles, triangles)
                    self.assertEqual(placed_report["counts"], report["counts"])

    def test_nodes_of_a_tilted_face_lie_in_its_plane(self):
        size = math.hypot(4, 2)
        for model, area in [("plate.brep", 8 - math.pi / 4), ("inclusion.brep", 8)]:
            for axis, angle, translation in [((1, 2, 3), 1, (0, 0, 0)), ((-3, 1, 0.2), 2.5, (5, -7, 11)),
                                             ((0, 1, 1e-3), 1.2, (-20, 3, 0.1)), ((1, 1, 1), 3, (1, 1, 1))]:
                with self.subTest(model=model, axis=axis):
                    rotation = turned(axis, angle)
                    nodes, _, report = self.mesh_placed(model, rotation, translation)
                    normal = [row[2] for row in rotation]
                    for p in nodes.values():
                        offset = [a - b for a, b in zip(p, translation)]
                        self.assertLess(abs(sum(a * b for a, b in zip(offset, normal))), 1e-12 * size)
                    self.assertAlmostEqual(report["model"]["area"] / area, 1, delta=1e-12)
                    self.assertAlmostEqual(report["mesh"]["area"] / area, 1, delta=0.005)
                    centre = [sum(row[i] for i in range(2)) + t for row, t in zip(rotation, translation)]
                    on_circle = [p for p in nodes.values() if abs(math.dist(p, centre) - 0.5) < 1e-3]
                    self.assertGreater(len(on_circle), 12)
                    self.assertLess(max(abs(math.dist(p, centre) - 0.5) for p in on_circle), 1e-12 * size)

    def test_oblique_disc(self):
        self.expect(0, "mesh", DATA / "disc_oblique.brep", "--dimension", 2, "--size", 0.3, "--check", "-o", "m.msh", "--report", "r.json")
        report = json.loads((self.folder / "r.json").read_text())
        self.assertAlmostEqual(report["model"]["area"], 4 * math.pi, delta=1e-11)
        nodes, _ = read_msh(self.folder / "m.msh")
        for p in nodes.values():
            self.assertLess(abs(sum(p) - 6) / math.sqrt(3), 4e-12)


class TestSizes(Case):
    """Sizes from the command line arrive in the mesh; what they do there is tested with the library."""

    def mesh(self, *arguments, model="plate.brep"):
        """Corners of the triangles and the report."""
        self.expect(0, "mesh", DATA / model, "--dimension", 2, "--check", "-o", "m.msh", "--report", "r.json", *arguments)
        report = json.loads((self.folder / "r.json").read_text())
        nodes, triangles = read_msh(self.folder / "m.msh")
        return [[nodes[n] for n in corners] for corners in triangles], report

    def sizes_near(self, triangles, point, radius):
        """Edge lengths of triangles whose middle is near the point."""
        edges = []
        for corners in triangles:
            middle = [sum(c[i] for c in corners) / 3 for i in range(3)]
            if math.dist(middle, point) < radius:
                edges += [math.dist(corners[i], corners[(i + 1) % 3]) for i in range(3)]
        return edges

    def expect_sizes(self, small_at, arguments, size=0.05):
        """Edges of about the size there, and of the general size of 0.4 at the other end."""
        triangles, report = self.mesh("--size", 0.4, *arguments)
        near = self.sizes_near(triangles, small_at, 0.1)
        self.assertTrue(near, arguments)
        self.assertLess(max(near), 2.2 * size)
        self.assertGreater(max(self.sizes_near(triangles, (4 - small_at[0], 2 - small_at[1], 0), 0.8)), 0.2)
        return report

    def test_every_kind_of_size(self):
        (self.folder / "points.txt").write_text("# x y z size\n\n3.5 1.5 0 0.05 # the only one\n")
        for small_at, arguments in [
                ((3.5, 1.5, 0), ["--size-box", "3,1,0,4,2,0=0.05"]),
                ((3.5, 1.5, 0), ["--size-ball", "3.5,1.5,0,0.4=0.05,0.3"]),
                ((3.5, 1.5, 0), ["--size-formula", "0.05 + 0.3*sqrt((x-3.5)^2 + (y-1.5)^2)"]),
                ((3.5, 1.5, 0), ["--size-points", "points.txt", "--grading", 3]),
                ((3.95, 1.95, 0), ["--local-size", "Vertex3=0.05"]),
                ((3.95, 1, 0), ["--size-distance", "Edge2=0.05,0.3,0.2"])]:
            with self.subTest(arguments=arguments):
                self.expect_sizes(small_at, arguments)

    def test_report_holds_the_sizes(self):
        report = self.expect_sizes((3.5, 1.5, 0), [
            "--size-box", "3,1,0,4,2,0=0.05", "--size-box", "0,0,0,1,1,0=0.3,0.5", "--size-ball", "1,1,0,0.5=0.3",
            "--size-distance", "Edge5=0.2,0.1", "--size-formula", "0.3"])
        options = report["options"]
        self.assertEqual(options["size_box"], [{"first": [3, 1, 0], "last": [4, 2, 0], "size": 0.05, "growth": 1},
                                               {"first": [0, 0, 0], "last": [1, 1, 0], "size": 0.3, "growth": 0.5}])
        self.assertEqual(options["size_ball"], [{"centre": [1, 1, 0], "radius": 0.5, "size": 0.3, "growth": 1}])
        self.assertEqual(options["size_distance"], [{"entity": "Edge5", "size": 0.2, "growth": 0.1, "plateau": 0}])
        self.assertEqual(options["size_formula"], "0.3")
        self.assertLess(abs(report["counts"]["expected_triangles"] / report["counts"]["triangles"] - 1), 0.5)

    def test_size_of_one_face_of_several(self):
        self.expect(0, "mesh", DATA / "inclusion.brep", "--dimension", 2, "--size", 0.4, "--local-size", "Face2=0.05", "-o", "m.msh",
                    "--grading", 2, "--check")
        nodes, triangles = read_msh(self.folder / "m.msh")
        disc = self.sizes_near([[nodes[n] for n in corners] for corners in triangles], (1, 1, 0), 0.45)
        self.assertGreater(len(disc), 3 * 300)
        self.assertLess(max(disc), 0.1)
        self.assertGreater(max(self.sizes_near([[nodes[n] for n in c] for c in triangles], (3.5, 1, 0), 0.5)), 0.2)

    def test_only_the_faces_that_are_named(self):
        self.expect(0, "mesh", DATA / "inclusion.brep", "--dimension", 2, "--size", 0.1, "--faces", "Face2", "-o", "m.msh")
        nodes, triangles = read_msh(self.folder / "m.msh")
        used = {n for corners in triangles for n in corners}
        self.assertLess(max(math.dist(nodes[n], (1, 1, 0)) for n in used), 0.5 + 1e-12)
        self.expect(0, "mesh", DATA / "box.brep", "--dimension", 2, "--size", 0.3, "--faces", "Face3", "-o", "b.msh")
        self.expect(0, "check", "b.msh", "--model", DATA / "box.brep")
        for faces in ("Face3", "Face1,Face2"):
            self.expect(0, "estimate", DATA / "inclusion.brep", "--dimension", 2, "--faces", "Face2,Face1")
        self.expect_refusal(1, "Face7: the model has no such face", "mesh", DATA / "box.brep", "--dimension", 2, "--faces", "Face7",
                            "-o", "a.msh")
        self.expect_refusal(1, "Face1: the face is named twice", "mesh", DATA / "box.brep", "--dimension", 2,
                            "--faces", "Face1,Face1", "-o", "a.msh")

    def test_size_of_a_background_mesh(self):
        corners = [(0, 0), (4, 0), (4, 2), (0, 2)]
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", "4"]
        lines += [f"{i} {x} {y} 0" for i, (x, y) in enumerate(corners, 1)]
        lines += ["$EndNodes", "$Elements", "2", "1 2 2 1 1 1 2 3", "2 2 2 1 1 1 3 4", "$EndElements"]
        lines += ["$NodeData", "1", '"size"', "1", "0", "3", "0", "1", "4", "1 0.4", "2 0.04", "3 0.04", "4 0.4", "$EndNodeData", ""]
        (self.folder / "sizes.msh").write_text("\n".join(lines))
        triangles, _ = self.mesh("--background", "sizes.msh")
        self.assertLess(max(self.sizes_near(triangles, (3.9, 1, 0), 0.2)), 0.12)
        self.assertGreater(max(self.sizes_near(triangles, (0.2, 1.8, 0), 0.4)), 0.2)
        (self.folder / "plain.msh").write_text("\n".join(lines[:lines.index("$NodeData")]) + "\n")
        self.expect_refusal(1, "plain.msh: has no number at its nodes", "mesh", DATA / "plate.brep", "--dimension", 2,
                            "--background", "plain.msh", "-o", "a.msh")
        (self.folder / "zero.msh").write_text("\n".join(lines).replace("2 0.04", "2 0"))
        self.expect_refusal(1, "zero.msh: background node 1", "mesh", DATA / "plate.brep", "--dimension", 2,
                            "--background", "zero.msh", "-o", "a.msh")

    def test_absurd_sizes_are_told_before_memory_is_taken(self):
        plate = DATA / "plate.brep"
        for arguments in (["--size", "1e-300"], ["--size-box", "1,0.2,0,1.001,0.2001,0=1e-9"], ["--local-size", "Vertex1=1e-12"],
                          ["--size-formula", "1e-7"], ["--size-ball", "3,1,0,1e-3=1e-8"]):
            expensive = arguments[0] in ("--size", "--size-formula", "--size-box", "--size-ball")
            with self.subTest(arguments=arguments):
                if expensive:
                    self.expect_refusal(1, "elements and .* would be needed, more than --max-elements", "mesh", plate,
                                        "--dimension", 2, "-o", "a.msh", *arguments)
                    self.assertEqual(self.run_mesher("estimate", plate, "--dimension", 2, *arguments).returncode, 1)
                else:  # a single place can be as small as it likes
                    self.expect(0, "mesh", plate, "--dimension", 2, "-o", "m.msh", *arguments)

    def test_size_files_that_cannot_be_read(self):
        (self.folder / "empty.txt").touch()
        (self.folder / "comment.txt").write_text("# nothing\n")
        (self.folder / "short.txt").write_text("0 0 0 1\n1 2 3\n4\n")
        (self.folder / "words.txt").write_text("0 0 0 fine\n")
        (self.folder / "negative.txt").write_text("0 0 0 1\n0 0 0 -1\n")
        (self.folder / "nan.txt").write_text("0 0 nan 1\n")
        (self.folder / "folder.txt").mkdir()
        for name, pattern in [("missing.txt", "no such file"), ("empty.txt", "empty"), ("comment.txt", "without a point"),
                              ("short.txt", "line 2: four numbers"), ("words.txt", "line 1: four numbers"),
                              ("negative.txt", "line 2: the size is no length"), ("nan.txt", "line 1: the place is not finite"),
                              ("folder.txt", "is a folder")]:
            for command in (["mesh", "-o", "a.msh"], ["estimate"]):
                with self.subTest(name=name, command=command[0]):
                    self.expect_refusal(1, f"{name}: .*{pattern}", *command, DATA / "plate.brep", "--dimension", 2,
                                        "--size-points", name)
        self.expect_refusal(1, "missing.msh: there is no such file", "mesh", DATA / "plate.brep", "--dimension", 2,
                            "--background", "missing.msh", "-o", "a.msh")


class TestRefusals(Case):
    def test_wrong_usage(self):
        plate = DATA / "plate.brep"
        for pattern, arguments in [
                ("command is missing", []),
                ("unknown command 'mush'", ["mush"]),
                ("model is missing", ["mesh", "-o", "a.msh"]),
                ("output is missing", ["mesh", plate]),
                ("too much", ["mesh", plate, plate, "-o", "a.msh"]),
                ("unrecognised option '--sise", ["mesh", plate, "-o", "a.msh", "--sise", 1]),
                ("unknown format 'nonsense'", ["mesh", plate, "-o", "a.msh", "--format", "nonsense"]),
                ("extension '.xyz'", ["mesh", plate, "-o", "a.xyz"]),
                ("no extension", ["mesh", plate, "-o", "a"]),
                ("more --format", ["mesh", plate, "-o", "a.msh", "--format", "msh", "--format", "vtu"]),
                ("named twice", ["mesh", plate, "-o", "a.msh", "-o", "./a.msh"]),
                ("named twice", ["mesh", plate, "-o", plate, "--format", "msh"]),
                ("wants a number, not '1,5'", ["mesh", plate, "-o", "a.msh", "--size", "1,5"]),
                ("--size: the size 0 makes no sense", ["mesh", plate, "-o", "a.msh", "--size", 0]),
                ("--size: the size -1 makes no sense", ["mesh", plate, "-o", "a.msh", "--size=-1"]),
                ("--size: the size nan makes no sense", ["mesh", plate, "-o", "a.msh", "--size", "nan"]),
                ("--size: the size inf makes no sense", ["mesh", plate, "-o", "a.msh", "--size", "inf"]),
                ("Face6=0.5", ["mesh", plate, "-o", "a.msh", "--local-size", "Fase6=1"]),
                ("Face6=0.5", ["mesh", plate, "-o", "a.msh", "--local-size", "Face1=1,2"]),
                ("Edge3=0.1,0.2", ["mesh", plate, "-o", "a.msh", "--size-distance", "Edge3=0.1"]),
                ("Edge3=0.1,0.2", ["mesh", plate, "-o", "a.msh", "--size-distance", "Kante3=0.1,0.2"]),
                ("0,0,0,1,1,1=0.1", ["mesh", plate, "-o", "a.msh", "--size-box", "0,0,1,1=0.1"]),
                ("0,0,0,1,1,1=0.1", ["mesh", plate, "-o", "a.msh", "--size-box", "0,0,0,1,1,1"]),
                ("0,0,0,1,1,1=0.1", ["mesh", plate, "-o", "a.msh", "--size-box", "0,0,0,1,1,b=0.1"]),
                ("0,0,0,1=0.1", ["mesh", plate, "-o", "a.msh", "--size-ball", "0,0,0,1=0.1,0.2,0.3"]),
                ("0,0,0,1=0.1", ["mesh", plate, "-o", "a.msh", "--size-ball", "=0.1"]),
                ("--size-box: the size 0 makes no sense", ["mesh", plate, "-o", "a.msh", "--size-box", "0,0,0,1,1,1=0"]),
                ("--size-ball: the radius -1 makes no sense", ["mesh", plate, "-o", "a.msh", "--size-ball", "0,0,0,-1=1"]),
                ("--size-formula: formula, character 4", ["mesh", plate, "-o", "a.msh", "--size-formula", "x+1)"]),
                ("--local-size: the size 0 of Edge1 makes no sense", ["estimate", plate, "--local-size", "Edge1=0"]),
                ("--faces: 'Edge1' is no name of a face", ["mesh", plate, "-o", "a.msh", "--faces", "Edge1"]),
                ("q1 to q8", ["mesh", plate, "-o", "a.msh", "--measure", "q9"]),
                ("--dimension", ["mesh", plate, "-o", "a.msh", "--dimension", 4]),
                ("mesh is missing", ["check"]),
                ("output is missing", ["draw", "a.msh"])]:
            with self.subTest(arguments=arguments):
                self.expect_refusal(2, re.escape(pattern), *arguments)

    def expect_model_refusal(self, name, pattern, *arguments):
        """By every command that reads models, with the name of the file; `arguments` of mesh and estimate."""
        for command in (["mesh", "-o", "a.msh", "--report", "/dev/null"], ["estimate"]):
            with self.subTest(name=name, command=command[0]):
                self.expect_refusal(1, f"{re.escape(str(name))}.*{pattern}.*; .+\\.$", *command, name, "--dimension", 2, *arguments)

    def test_models_that_cannot_be_read(self):
        plate = (DATA / "plate.brep").read_text()
        (self.folder / "empty.step").touch()
        (self.folder / "garbage.step").write_text("no model at all")
        (self.folder / "cut.brep").write_text(plate[:400])
        (self.folder / "cut_late.brep").write_text(plate[:-30])
        (self.folder / "mesh.brep").write_text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")
        (self.folder / "damaged.brep").write_text(plate.replace("Curves 5", "Curbes 5"))
        (self.folder / "miscounted.brep").write_text(plate.replace("Curves 5", "Curves 4"))
        (self.folder / "numbers.brep").write_text(plate.replace("1 4 2 0 -1 0 0", "1 4 2 0 0 0 0"))
        (self.folder / "nan.brep").write_text(plate.replace("1 4 2 0 -1 0 0", "1 nan 2 0 -1 0 0"))
        (self.folder / "cut.step").write_text(STEP_SQUARE[:len(STEP_SQUARE) // 2])
        (self.folder / "damaged.step").write_text(STEP_SQUARE.replace("#30=CARTESIAN_POINT", "#30=CARTESIAN_PAINT"))
        (self.folder / "dangling.step").write_text(STEP_SQUARE.replace("#30=CARTESIAN_POINT", "#130=CARTESIAN_POINT"))
        (self.folder / "folder.step").mkdir()
        (self.folder / "locked.step").write_text(STEP_SQUARE)
        (self.folder / "locked.step").chmod(0)
        for name, pattern in [("missing.step", "no such file"), ("empty.step", "empty"), ("garbage.step", "neither STEP nor"),
                              ("cut.brep", "truncated"), ("cut_late.brep", "truncated"), ("mesh.brep", "neither STEP nor"),
                              ("damaged.brep", "damaged"), ("miscounted.brep", "damaged"), ("numbers.brep", "Edge3: the edge has no curve"),
                              ("nan.brep", "Edge3: the edge's curve has places that are not finite"),
                              ("cut.step", "truncated"), ("damaged.step", "damaged at #"), ("dangling.step", "damaged at #"),
                              ("folder.step", "folder")]:
            self.expect_model_refusal(name, pattern)
            with self.subTest(name=name, command="info"):
                self.expect_refusal(1, re.escape(name), "info", name)
        if os.geteuid() != 0:
            self.expect_model_refusal("locked.step", "cannot be opened")

    def test_a_damaged_model_writes_nothing_to_stdout(self):
        (self.folder / "damaged.brep").write_text((DATA / "plate.brep").read_text().replace("Curves 5", "Curbes 5"))
        self.assertEqual(self.expect(1, "info", "damaged.brep", "--json").stdout, "")

    def test_step_model(self):
        (self.folder / "square.step").write_text(STEP_SQUARE)
        self.expect(0, "mesh", "square.step", "--dimension", 2, "--size", 0.2, "-o", "m.msh", "--check")
        self.expect(0, "check", "m.msh", "--model", "square.step")

    def test_models_that_cannot_be_meshed(self):
        self.expect_refusal(1, "plate.brep: has no solid; .*--dimension 2", "mesh", DATA / "plate.brep", "-o", "a.msh")
        for name, pattern in [
                ("open_wire.brep", r"Face1 at \(0, 1, 0\): its wire is open between Edge3 and Edge1"),
                ("crossing_wire.brep", r"Edge1 and Edge3 at \(1\.333.*, 0\.666.*, 0\): the edges meet away from"),
                ("no_area.brep", "Face1: the face has no area"),
                ("no_wire.brep", "Face1: the face has no area or no end"),
                ("wire_only.brep", "has no face"),
                ("nothing.brep", "has no face")]:
            self.expect_model_refusal(DATA / name, pattern)
        for name, faces, pattern in [
                ("box.brep", "Face1,Face2", r"Face[1-6] at \(.*\): the face lies in another plane than Face1"),
                ("angled_squares.brep", "Face1,Face2",
                 r"Face2 at \(0, 0, 1\): the face lies in another plane than Face1: .* up to 1 off"),
                ("cylinder_wall.brep", "Face1", "Face1: the face is not plane: it departs from its best plane by 1")]:
            self.expect_model_refusal(DATA / name, pattern, "--faces", faces)

    def test_absurd_sizes_of_a_model(self):
        self.expect_model_refusal(DATA / "plate.brep", "--max-elements 50000000", "--size", 1e-7)
        self.expect_model_refusal(DATA / "plate.brep", "--max-elements 10000", "--refinement", 1000, "--max-elements", 10000)
        self.expect_model_refusal(DATA / "plate.brep", "Edge6: cannot have a size of its own", "--local-size", "Edge6=1")
        self.expect_model_refusal(DATA / "plate.brep", "Solid1: cannot have a size of its own", "--size-distance", "Solid1=1,1")
        self.expect(0, "mesh", DATA / "plate.brep", "--dimension", 2, "--size", 1e300, "-o", "m.msh")

    def test_targets_that_cannot_be_written_are_told_before_meshing(self):
        (self.folder / "folder.msh").mkdir()
        for pattern, target in [("does not exist", "missing/a.msh"), ("folder", "folder.msh")]:
            for option in ("-o", "--report", "--curved-boundary"):
                outputs = ["-o", target] if option == "-o" else ["-o", "a.msh", option, target]
                with self.subTest(option=option, target=target):
                    self.expect_refusal(1, pattern, "mesh", DATA / "missing.brep", "--dimension", 2, *outputs)

    def test_full_disk(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("there is no /dev/full")
        mesh = ["mesh", DATA / "plate.brep", "--dimension", 2]
        for name in ("msh", "msh2", "vtu", "vtk", "su2", "stl", "ply", "inp", "unv", "png"):
            with self.subTest(format=name):
                self.expect_refusal(1, "/dev/full: .*space.*; .+", *mesh, "-o", "/dev/full", "--format", name)
        self.expect(1, *mesh, "-o", "m.msh", "--report", "/dev/full")
        self.expect(1, *mesh, "-o", "n.msh", "--curved-boundary", "/dev/full")
        self.expect_refusal(1, "/dev/full: .*space.*; .+", "draw", "m.msh", "-o", "/dev/full")

    def test_write_protected_target(self):
        if os.geteuid() == 0:
            self.skipTest("nothing is write-protected for this user")
        self.folder.chmod(0o555)
        self.expect_refusal(1, "a.msh: .*; .+", "mesh", DATA / "plate.brep", "--dimension", 2, "-o", "a.msh")
        self.folder.chmod(0o755)

    def test_a_failed_run_leaves_what_was_there(self):
        (self.folder / "m.msh").write_text("precious")
        self.expect_refusal(1, "no area", "mesh", DATA / "no_area.brep", "--dimension", 2, "-o", "m.msh")
        self.assertEqual((self.folder / "m.msh").read_text(), "precious")

    def test_failed_run_is_told_in_the_report(self):
        self.expect(1, "mesh", DATA / "box.brep", "--dimension", 2, "--faces", "Face1,Face2", "-o", "a.msh", "--report", "r.json")
        report = json.loads((self.folder / "r.json").read_text())
        self.assertEqual(report["status"], "failed")
        failure = report["failures"][0]
        self.assertRegex(failure["entity"], "^Face[1-6]$")
        self.assertTrue(failure["reason"] and failure["remedy"] and len(failure["point"]) == 3)


class TestDemonstration(Case):
    def test_gasket(self):
        gasket = DATA.parents[1] / "Resources" / "demos" / "gasket.brep"
        self.expect(0, "mesh", gasket, "--dimension", 2, "--size", 4, "--curvature", 48, "--local-size", "Face2=1.2", "--check",
                    "-o", "m.msh", "--report", "r.json")
        run = self.expect(0, "check", "m.msh", "--model", gasket)
        areas = [float(re.search(f"area of Face{i}: (.*)", run.stdout).group(1)) for i in (1, 2, 3)]
        report = json.loads((self.folder / "r.json").read_text())
        self.assertAlmostEqual(sum(areas), report["mesh"]["area"], places=8)
        self.assertAlmostEqual(report["mesh"]["area"] / report["model"]["area"], 1, delta=1e-3)
        self.assertGreaterEqual(report["quality"]["min_angle"], 30)
        self.assertLessEqual(report["quality"]["max_angle"], 120)

    def test_table_of_a_report(self):
        self.mesh_plate("-o", "m.msh", "--report", "r.json")
        script = DATA.parents[1] / "tools" / "show_report.py"
        run = subprocess.run([sys.executable, script, self.folder / "r.json"], capture_output=True, text=True, check=True)
        self.assertRegex(run.stdout, r"(?m)^triangles +505$")
        self.assertRegex(run.stdout, r"(?m)^angles +3\d\.\d\d to 1\d\d\.\d\d degrees$")
        (self.folder / "no.json").write_text("{}")
        for name in ("no.json", "missing.json", "m.msh"):
            run = subprocess.run([sys.executable, script, self.folder / name], capture_output=True, text=True, check=False)
            self.assertEqual((run.returncode, run.stdout), (2, ""))
            self.assertIn(name, run.stderr)


@unittest.skipUnless(shutil.which("gmsh"), "gmsh is not installed")
class TestGmsh(Case):
    """Gmsh, as a program of its own, opens what is written for it."""

    def run_gmsh(self, *arguments):
        run = subprocess.run(["gmsh", *map(str, arguments)], capture_output=True, text=True, timeout=120, cwd=self.folder, check=False)
        output = run.stdout + run.stderr
        self.assertEqual(run.returncode, 0, output)
        self.assertNotRegex(output, "(?m)^(Error|Warning)", output)
        return output

    def test_opens_both_versions(self):
        self.expect(0, "mesh", DATA / "inclusion.brep", "--dimension", 2, "--size", 0.2, "-o", "new.msh", "-o", "old.msh",
                    "--format", "msh", "--format", "msh2", "--report", "r.json")
        counts = json.loads((self.folder / "r.json").read_text())["counts"]
        for name, version in (("new.msh", "4.1"), ("old.msh", "2.2")):
            with self.subTest(version=version):
                self.assertIn(f"$MeshFormat\n{version} 0 8", (self.folder / name).read_text())
                output = self.run_gmsh("-check", name)
                nodes, elements = re.search(r"(\d+) nodes\s.*?(\d+) elements", output, re.DOTALL).groups()
                self.assertEqual(int(nodes), counts["vertices"])
                self.assertEqual(int(elements), counts["triangles"] + counts["lines"] + 5)

    def test_keeps_groups_and_places(self):
        """What Gmsh writes of our file is the same mesh, by our own reader."""
        self.expect(0, "mesh", DATA / "inclusion.brep", "--dimension", 2, "--size", 0.2, "-o", "new.msh", "-o", "old.msh",
                    "--format", "msh", "--format", "msh2")
        before = self.expect(0, "check", "new.msh", "--model", DATA / "inclusion.brep").stdout
        for name, target in (("new.msh", "msh22"), ("old.msh", "msh41")):
            with self.subTest(name=name):
                self.run_gmsh(name, "-save", "-format", target, "-o", "again.msh")
                after = self.expect(0, "check", "again.msh", "--model", DATA / "inclusion.brep").stdout
                self.assertEqual(after.split("\n")[:3], before.split("\n")[:3])


class TestOtherCommands(Case):
    def test_check_accepts_what_was_written(self):
        for name in ("m.msh", "m.vtu"):
            self.mesh_plate("-o", name)
            run = self.expect(0, "check", name, "--model", DATA / "plate.brep")
            self.assertIn("valid", run.stdout)
        self.mesh_plate("-o", "m.dat", "--format", "msh2")
        (self.folder / "m.dat").rename(self.folder / "n.msh")
        self.expect(0, "check", "n.msh")

    def test_check_refuses_a_doctored_mesh(self):
        self.mesh_plate("-o", "m.msh")
        text = (self.folder / "m.msh").read_text()
        (self.folder / "moved.msh").write_text(text.replace("\n4 2 0\n", "\n4 2.5 0\n"))
        self.expect(0, "check", "moved.msh")
        self.expect_refusal(1, "off their entity", "check", "moved.msh", "--model", DATA / "plate.brep")
        (self.folder / "cut.msh").write_text(text[:len(text) // 2])
        self.expect_refusal(1, "cut.msh: line", "check", "cut.msh")
        lines = text.split("\n")
        lines[-4] = " ".join(lines[-4].split()[:1] + lines[-4].split()[:0:-1])
        (self.folder / "turned.msh").write_text("\n".join(lines))
        self.expect_refusal(1, "not valid", "check", "turned.msh")

    def test_info_and_estimate(self):
        run = self.expect(0, "info", DATA / "box.brep")
        for line in ("1 solids", "6 faces", "12 edges", "8 vertices", "6 plane"):
            self.assertIn(line, run.stdout)
        run = self.expect(0, "estimate", DATA / "plate.brep", "--dimension", 2, "--size", 0.05)
        elements = float(re.search("elements: about (.*)", run.stdout).group(1))
        self.expect(0, "mesh", DATA / "plate.brep", "--dimension", 2, "--size", 0.05, "-o", "m.msh", "--report", "r.json")
        triangles = json.loads((self.folder / "r.json").read_text())["counts"]["triangles"]
        self.assertTrue(triangles / 2 < elements < 2 * triangles, (elements, triangles))

    def test_estimates_solids_and_refuses_too_many_elements(self):
        box = DATA / "box.brep"
        run = self.expect(0, "estimate", box, "--size", 0.1)
        elements = float(re.search("elements: about (.*)", run.stdout).group(1))
        self.expect(0, "mesh", box, "--size", 0.1, "-o", "m.msh", "--report", "r.json")
        report = json.loads((self.folder / "r.json").read_text())
        tets = report["counts"]["tets"]
        self.assertTrue(tets / 2 < elements < 2 * tets, (elements, tets))
        self.assertAlmostEqual(report["model"]["volume"], 6, delta=1e-6)
        self.assertAlmostEqual(report["model"]["area"], 22, delta=1e-6)
        few = ["--size", 0.1, "--max-elements", int(elements / 4)]
        self.expect_refusal(1, ".*box.brep.*elements.*--max-elements.*", "estimate", box, *few)
        self.expect_refusal(1, ".*elements.*--max-elements.*", "mesh", box, *few, "-o", "n.msh")
        self.assertFalse((self.folder / "n.msh").exists())

    def test_draw(self):
        self.mesh_plate("-o", "m.vtu")
        self.expect(0, "draw", "m.vtu", "-o", "m.png", "--width", 300)
        header = (self.folder / "m.png").read_bytes()[:24]
        self.assertEqual(header[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">I", header[16:20])[0], 300)

    def test_draws_solids_and_their_cuts(self):
        self.expect(0, "mesh", DATA / "box.brep", "--size", 0.5, "-o", "m.vtu")
        pictures = {}
        for name, cut in (("both", []), ("surface", ["--cut", "no"]), ("x", ["--cut", "x"]), ("near", ["--cut", "x=0.9"])):
            self.expect(0, "draw", "m.vtu", "-o", "m.png", "--width", 300, *cut)
            pictures[name] = (self.folder / "m.png").read_bytes()
            self.assertEqual(struct.unpack(">I", pictures[name][16:20])[0], 300)
        self.assertEqual(len(set(pictures.values())), 4)
        for cut in ("w", "x=", "x=a", "xy", "x:1", "no2"):
            self.expect_refusal(2, ".*--cut.*", "draw", "m.vtu", "-o", "m.png", "--cut", cut)

    def test_help_version_and_formats(self):
        self.assertIn("--keep-partial", self.expect(0, "--help").stdout)
        self.assertRegex(self.expect(0, "--version").stdout, r"^mesher \d+\.\d+\.\d+\n$")
        self.assertIn("msh2", self.expect(0, "formats").stdout)

    @unittest.skipUnless(vtkXMLUnstructuredGridReader, "python3-vtk9 is not installed")
    def test_vtk_reads_the_vtu(self):
        self.mesh_plate("-o", "m.vtu", "--report", "r.json")
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(self.folder / "m.vtu"))
        reader.Update()
        grid = reader.GetOutput()
        counts = json.loads((self.folder / "r.json").read_text())["counts"]
        self.assertEqual(grid.GetNumberOfPoints(), counts["vertices"])
        types = [grid.GetCellType(i) for i in range(grid.GetNumberOfCells())]
        self.assertEqual(types.count(5), counts["triangles"])
        self.assertEqual(types.count(3), counts["lines"])
        self.assertEqual(grid.GetBounds(), (0.0, 4.0, 0.0, 2.0, 0.0, 0.0))
        entity = grid.GetCellData().GetArray("entity")
        self.assertEqual({entity.GetValue(i) for i, t in enumerate(types) if t == 5}, {1})
        self.assertEqual({entity.GetValue(i) for i, t in enumerate(types) if t == 3}, {1, 2, 3, 4, 5})


if __name__ == "__main__":
    if PROGRAM is None:
        sys.exit(__doc__)
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

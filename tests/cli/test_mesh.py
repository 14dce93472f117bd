#!/usr/bin/python3
"""Tests `mesher mesh` as its users call it: files, reports, limits.

    test_mesh.py PROGRAM DATA-FOLDER [unittest options]
"""
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest

from program_case import DATA, PROGRAM, Case, run_tests


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

    def test_tells_an_angle_that_is_out_of_reach(self):
        run = self.mesh_plate("-o", "m.msh", "--report", "r.json", "--min-angle", 40)
        self.assertRegex(run.stderr, "40 degrees .* --min-angle is out of reach .* 30 degrees were kept")
        report = json.loads((self.folder / "r.json").read_text())
        self.assertGreaterEqual(report["quality"]["min_angle"], 30)
        self.assertLess(report["counts"]["triangles"], 20000)

    def test_format_overrules_the_extension(self):
        self.mesh_plate("-o", "m.dat", "-o", "n.msh", "--format", "msh2")
        self.assertIn("2.2 0 8", (self.folder / "m.dat").read_text())
        self.assertIn("4.1 0 8", (self.folder / "n.msh").read_text())

    def test_names_regions_after_faces(self):
        self.expect(0, "mesh", DATA / "inclusion.brep", "--dimension", 2, "--size", 0.2, "-o", "m.msh")
        text = (self.folder / "m.msh").read_text()
        for name in ('2 1 "Face1"', '2 2 "Face2"', '1 3 "Edge1"', '1 7 "Edge5"'):
            self.assertIn(name, text)
        self.assertNotIn("Vertex", text)

    def test_groups_of_everything_on_a_wish(self):
        self.expect(0, "mesh", DATA / "inclusion.brep", "--dimension", 2, "--size", 0.2, "--groups", "all", "-o", "m.msh")
        self.assertIn('0 12 "Vertex5"', (self.folder / "m.msh").read_text())
        self.expect(0, "mesh", DATA / "box.brep", "--size", 0.5, "--groups", "all", "-o", "m.msh", "-o", "n.msh", "-o", "m.unv",
                    "--format", "msh", "--format", "msh2")
        for name in ("m.msh", "n.msh"):
            text = (self.folder / name).read_text()
            names = re.findall(r'(?m)^[0-3] (\d+) "(\w+)"$', text)
            self.assertEqual([int(number) for number, _ in names], list(range(1, 1 + 1 + 6 + 12 + 8)))
            self.expect(0, "check", name, "--model", DATA / "box.brep")
        self.assertIn("\nEdge12\n", (self.folder / "m.unv").read_text())
        self.expect_refusal(2, "--groups is bounding or all, not 'some'", "mesh", DATA / "box.brep", "--groups", "some", "-o", "m.msh")

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

    def test_refinement_by_the_features_of_a_solid(self):
        counts = []
        for refinement in (1, 3):
            self.expect(0, "mesh", DATA / "box.brep", "--refinement", refinement, "--check", "-o", "m.msh", "--report", "r.json")
            counts.append(json.loads((self.folder / "r.json").read_text())["counts"]["tets"])
        self.assertGreater(counts[1], 5 * counts[0])

    def test_what_solids_do_not_take_is_told(self):
        self.expect_refusal(1, "--min-angle: cannot be above 34", "mesh", DATA / "box.brep", "--size", 0.5, "--min-angle", 40, "-o", "m.msh")
        self.expect_refusal(1, "--order 2: elements of second order are not there yet .*; choose --order 1", "mesh", DATA / "box.brep",
                            "--order", 2, "-o", "m.msh")

    def test_faces_in_space(self):
        self.expect(0, "mesh", DATA / "cylinder_wall.brep", "--dimension", 2, "--size", 0.3, "--check", "-o", "m.msh")
        self.expect(0, "mesh", DATA / "box.brep", "--dimension", 2, "--size", 0.3, "--check", "-o", "b.msh", "--report", "r.json")
        self.assertAlmostEqual(json.loads((self.folder / "r.json").read_text())["mesh"]["area"], 22.0, delta=1e-9)

    def test_limits(self):
        self.expect_refusal(1, "limit of 1000 elements", "mesh", DATA / "box.brep", "--size", 0.3, "--max-elements", 1000, "-o", "m.msh")
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
                self.assertEqual(int(elements), counts["triangles"] + counts["lines"])

    def test_keeps_groups_and_places(self):
        """What Gmsh writes of our file is the same mesh, by our own reader."""
        self.expect(0, "mesh", DATA / "inclusion.brep", "--dimension", 2, "--size", 0.2, "-o", "new.msh", "-o", "old.msh",
                    "--format", "msh", "--format", "msh2", "--groups", "all")
        before = self.expect(0, "check", "new.msh", "--model", DATA / "inclusion.brep").stdout
        for name, target in (("new.msh", "msh22"), ("old.msh", "msh41")):
            with self.subTest(name=name):
                self.run_gmsh(name, "-save", "-format", target, "-o", "again.msh")
                after = self.expect(0, "check", "again.msh", "--model", DATA / "inclusion.brep").stdout
                self.assertEqual(after.split("\n")[:3], before.split("\n")[:3])


if __name__ == "__main__":
    run_tests()

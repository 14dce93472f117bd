#!/usr/bin/python3
"""Tests the program mesher as its users call it: exit statuses, messages, files.

    test_mesher.py PROGRAM DATA-FOLDER [unittest options]
"""
import json
import os
import re
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
                ("q1 to q8", ["mesh", plate, "-o", "a.msh", "--measure", "q9"]),
                ("--dimension", ["mesh", plate, "-o", "a.msh", "--dimension", 4]),
                ("mesh is missing", ["check"]),
                ("output is missing", ["draw", "a.msh"])]:
            with self.subTest(arguments=arguments):
                self.expect_refusal(2, re.escape(pattern), *arguments)

    def test_models_that_cannot_be_read(self):
        (self.folder / "empty.step").touch()
        (self.folder / "garbage.step").write_text("no model at all")
        (self.folder / "cut.brep").write_text((DATA / "plate.brep").read_text()[:400])
        (self.folder / "folder.step").mkdir()
        for name in ("missing.step", "empty.step", "garbage.step", "cut.brep", "folder.step"):
            for command in (["mesh", name, "--dimension", 2, "-o", "a.msh"], ["info", name],
                            ["estimate", name, "--dimension", 2]):
                with self.subTest(name=name, command=command[0]):
                    self.expect_refusal(1, re.escape(name), *command)

    def test_models_that_cannot_be_meshed(self):
        self.expect_refusal(1, "not yet", "mesh", DATA / "box.brep", "-o", "a.msh")
        self.expect_refusal(1, "Face[1-6].*another plane", "mesh", DATA / "box.brep", "-o", "a.msh", "--dimension", 2)
        self.expect_refusal(1, "--max-elements", "mesh", DATA / "plate.brep", "-o", "a.msh", "--dimension", 2, "--size", 1e-7)

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
        self.expect_refusal(1, "space", "mesh", DATA / "plate.brep", "--dimension", 2, "-o", "/dev/full", "--format", "msh")

    def test_failed_run_is_told_in_the_report(self):
        self.expect(1, "mesh", DATA / "box.brep", "--dimension", 2, "-o", "a.msh", "--report", "r.json")
        report = json.loads((self.folder / "r.json").read_text())
        self.assertEqual(report["status"], "failed")
        failure = report["failures"][0]
        self.assertRegex(failure["entity"], "^Face[1-6]$")
        self.assertTrue(failure["reason"] and failure["remedy"] and len(failure["point"]) == 3)


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

    def test_draw(self):
        self.mesh_plate("-o", "m.vtu")
        self.expect(0, "draw", "m.vtu", "-o", "m.png", "--width", 300)
        header = (self.folder / "m.png").read_bytes()[:24]
        self.assertEqual(header[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">I", header[16:20])[0], 300)

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

#!/usr/bin/python3
"""Tests `mesher check`, `info`, `estimate` and `draw` as their users call them.

    test_other_commands.py PROGRAM DATA-FOLDER [unittest options]
"""
import json
import re
import struct
import unittest

from program_case import DATA, Case, run_tests

try:
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    vtkXMLUnstructuredGridReader = None


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
        self.expect(0, "mesh", DATA / "box.brep", "--size", 0.3, "-o", "m.vtu")
        pictures = {}
        for name, cut in (("both", []), ("surface", ["--cut", "no"]), ("x", ["--cut", "x"]), ("near", ["--cut", "x=0.9"])):
            self.expect(0, "draw", "m.vtu", "-o", "m.png", "--width", 300, *cut)
            pictures[name] = (self.folder / "m.png").read_bytes()
            self.assertEqual(struct.unpack(">I", pictures[name][16:20])[0], 300)
        self.assertEqual(len(set(pictures.values())), 4)
        for cut in ("w", "x=", "x=a", "xy", "x:1", "no2"):
            self.expect_refusal(2, ".*--cut.*", "draw", "m.vtu", "-o", "m.png", "--cut", cut)

    def test_help_version_and_formats(self):
        for words in (["--help"], ["-h"], ["help"], ["mesh", "--help"], ["mesh", "part.step", "-h"], ["check", "--help"]):
            self.assertIn("--keep-partial", self.expect(0, *words).stdout)
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
    run_tests()

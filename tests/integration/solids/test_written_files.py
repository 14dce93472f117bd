#!/usr/bin/python3
"""Every format that solids are written in, read again by programs that share nothing with the mesher: VTK, meshio, Gmsh,
CalculiX, FreeCAD, and a few lines of Python.

    test_written_files.py PROGRAM MODULE-FOLDER MODELS-FOLDER DEMOS-FOLDER [unittest options]
"""
import contextlib
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, MODULES, MODELS = (Path(word).resolve() for word in sys.argv[1:4])
HERE = Path(__file__).resolve().parent
NAMES = ("m.msh", "m.vtu", "m.vtk", "m.inp", "m.unv", "m.stl", "m.ply")
# Two boxes of volumes 1 and 2 that share a face, and a box with a hole.
MODEL = "glued_boxes"
GROUPS = {"Solid": 2, "Face": 11, "Edge": 20, "Vertex": 12}

try:
    from vtkmodules.vtkIOGeometry import vtkSTLReader
    from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    HAS_VTK = True
except ImportError:
    HAS_VTK = False
try:
    import meshio
    HAS_MESHIO = True
except ImportError:
    HAS_MESHIO = False


def volume_of(a, b, c, d):
    u, v, w = ([q - p for p, q in zip(a, corner)] for corner in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6


class WrittenFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        outputs = [word for name in NAMES for word in ("-o", name)]
        for more in (outputs + ["--report", "r.json"], ["-o", "old.msh", "--format", "msh2"],
                     ["-o", "all.msh", "-o", "all_old.msh", "--format", "msh", "--format", "msh2", "--groups", "all"]):
            run = subprocess.run([PROGRAM, "mesh", MODELS / f"{MODEL}.brep", "--size", "0.4", *more], cwd=cls.folder,
                                 capture_output=True, text=True, timeout=120, check=False)
            if run.returncode != 0:
                raise AssertionError(run.stderr)
        cls.counts = json.loads((cls.folder / "r.json").read_text())["counts"]

    def check(self, name):
        """What `mesher check` says of a file."""
        run = subprocess.run([PROGRAM, "check", name, "--model", MODELS / f"{MODEL}.brep"], cwd=self.folder, capture_output=True,
                             text=True, timeout=120, check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    def test_the_program_checks_them_against_the_model(self):
        for name in ("m.msh", "old.msh", "all.msh", "all_old.msh", "m.vtu"):
            with self.subTest(file=name):
                told = self.check(name)
                self.assertIn("volume of Solid1: 1\n", told)
                self.assertIn("volume of Solid2: 2\n", told)

    def test_the_program_finds_what_was_doctored(self):
        text = (self.folder / "m.msh").read_text()
        nodes = text.index("$Nodes")
        moved = re.compile(r"(?m)^1 0\.3333333333333333 0$").sub("1 0.3333333333333333 1e-3", text, count=1)
        self.assertNotEqual(moved, text)
        cut = re.sub(r"(?m)^2 \d+ 2 \d+\n(?:\d+ \d+ \d+ \d+\n)+", lambda m: m.group(0) if m.start() < nodes else "", text, count=1)
        for name, content in (("moved.msh", moved), ("cut.msh", cut)):
            with self.subTest(file=name):
                (self.folder / name).write_text(content)
                run = subprocess.run([PROGRAM, "check", name, "--model", MODELS / f"{MODEL}.brep"], cwd=self.folder,
                                     capture_output=True, text=True, timeout=120, check=False)
                self.assertEqual(run.returncode, 1, run.stdout)
                self.assertIn("mesher: ", run.stderr)

    @unittest.skipUnless(HAS_VTK, "VTK for Python is not installed")
    def test_vtk_reads_grids(self):
        for name, reader in (("m.vtu", vtkXMLUnstructuredGridReader), ("m.vtk", vtkUnstructuredGridReader)):
            with self.subTest(file=name):
                source = reader()
                source.SetFileName(str(self.folder / name))
                source.Update()
                grid = source.GetOutput()
                self.assertEqual(grid.GetNumberOfPoints(), self.counts["vertices"])
                kinds = [grid.GetCellType(i) for i in range(grid.GetNumberOfCells())]
                self.assertEqual((kinds.count(10), kinds.count(5)), (self.counts["tets"], self.counts["triangles"]))
                cells, points = grid.GetCellData(), grid.GetPointData()
                for data, arrays in ((cells, ("entity", "dimension")), (points, ("entity", "dimension", "parameters"))):
                    for array in arrays:
                        self.assertIsNotNone(data.GetArray(array), array)
                entity = cells.GetArray("entity")
                volumes = {}
                for i in (i for i, kind in enumerate(kinds) if kind == 10):
                    corners = [grid.GetPoint(grid.GetCell(i).GetPointId(k)) for k in range(4)]
                    solid = int(entity.GetTuple1(i))
                    volumes[solid] = volumes.get(solid, 0.0) + volume_of(*corners)
                self.assertEqual(len(volumes), 2)
                for volume, wanted in zip(sorted(volumes.values()), (1.0, 2.0)):
                    self.assertAlmostEqual(volume, wanted, places=9)

    @unittest.skipUnless(HAS_VTK, "VTK for Python is not installed")
    def test_vtk_finds_the_names_of_groups(self):
        source = vtkXMLUnstructuredGridReader()
        source.SetFileName(str(self.folder / "m.vtu"))
        source.Update()
        grid = source.GetOutput()
        group, names = grid.GetCellData().GetArray("group"), grid.GetFieldData()
        for name, dimension in (("Solid1", 3), ("Solid2", 3), ("Face11", 2), ("Edge20", 1), ("Vertex12", 0)):
            number = names.GetArray(name)
            self.assertIsNotNone(number, name)
            members = [i for i in range(grid.GetNumberOfCells()) if group.GetTuple1(i) == number.GetTuple1(0)]
            self.assertTrue(members, name)
            self.assertEqual({grid.GetCell(i).GetCellDimension() for i in members}, {dimension})

    @unittest.skipUnless(HAS_VTK, "VTK for Python is not installed")
    def test_vtk_reads_the_surface(self):
        source = vtkSTLReader()
        source.SetFileName(str(self.folder / "m.stl"))
        source.Update()
        surface = source.GetOutput()
        inner = self.inner_triangles()
        self.assertGreater(inner, 0)
        self.assertEqual(surface.GetNumberOfCells(), self.counts["triangles"] - inner)
        edges = {}
        for i in range(surface.GetNumberOfCells()):
            corners = [surface.GetPoint(surface.GetCell(i).GetPointId(k)) for k in range(3)]
            for k in range(3):
                edge = frozenset((corners[k], corners[(k + 1) % 3]))
                edges[edge] = edges.get(edge, 0) + 1
        self.assertEqual(set(edges.values()), {2})

    def inner_triangles(self):
        """Those between the two boxes, at x = 1."""
        text = (self.folder / "m.msh").read_text()
        places = re.findall(r"(?m)^(\S+) (\S+) (\S+)$", text.split("$Nodes\n")[1].split("$EndNodes")[0])
        triangles = re.findall(r"(?m)^2 \d+ 2 \d+\n((?:\d+ \d+ \d+ \d+\n)+)", text.split("$Elements\n")[1])
        return sum(all(float(places[int(n) - 1][0]) == 1.0 for n in row.split()[1:]) for rows in triangles
                   for row in rows.strip().split("\n"))

    @unittest.skipUnless(HAS_MESHIO, "meshio is not installed")
    def test_meshio_reads_every_group(self):
        for name in ("m.msh", "old.msh", "m.vtu", "m.vtk", "m.ply", "m.stl", "m.inp"):
            with self.subTest(file=name), contextlib.redirect_stdout(io.StringIO()):
                grid = meshio.read(self.folder / name)
                count = lambda kind: sum(len(cells.data) for cells in grid.cells if cells.type == kind)
                if name in ("m.ply", "m.stl"):
                    self.assertEqual(count("triangle"), self.counts["triangles"] - self.inner_triangles())
                    continue
                self.assertEqual(count("tetra"), self.counts["tets"])
                if name == "m.inp":
                    self.assertTrue({"Solid1", "Solid2"} <= set(grid.cell_sets))
                elif name != "m.vtk":
                    self.check_groups(grid, "group" if name == "m.vtu" else "gmsh:physical")

    def check_groups(self, grid, array):
        """Each name stands for cells of its dimension, and no number for two names."""
        numbers = [int(number) for number, _ in grid.field_data.values()]
        self.assertEqual(len(numbers), len(set(numbers)))
        dimensions = {"vertex": 0, "line": 1, "triangle": 2, "tetra": 3}
        for name, (number, dimension) in grid.field_data.items():
            kinds = {cells.type for cells, groups in zip(grid.cells, grid.cell_data[array]) if (groups == number).any()}
            self.assertEqual([dimensions[kind] for kind in kinds], [dimension], name)
        self.assertTrue({"Solid1", "Solid2", "Face1", "Face11"} <= set(grid.field_data))

    @unittest.skipUnless(shutil.which("gmsh"), "Gmsh is not installed")
    def test_gmsh_keeps_solids_and_groups(self):
        """What Gmsh writes of our file is the same mesh, by the program's own reader."""
        wanted = self.check("all.msh").split("\n")[:3]
        for name, target in (("all.msh", "msh22"), ("all_old.msh", "msh41")):
            with self.subTest(file=name):
                run = subprocess.run(["gmsh", name, "-save", "-format", target, "-o", "again.msh"], cwd=self.folder,
                                     capture_output=True, text=True, timeout=120, check=False)
                self.assertNotRegex(run.stdout + run.stderr, "(?m)^(Error|Warning)")
                self.assertEqual(self.check("again.msh").split("\n")[:3], wanted)
                names = re.findall(r'(?m)^[0-3] \d+ "(Solid|Face|Edge|Vertex)\d+"$', (self.folder / "again.msh").read_text())
                self.assertEqual({kind: names.count(kind) for kind in GROUPS}, GROUPS)

    @unittest.skipUnless(shutil.which("gmsh"), "Gmsh is not installed")
    def test_gmsh_reads_surfaces(self):
        for name in ("m.ply", "m.stl"):
            with self.subTest(file=name):
                run = subprocess.run(["gmsh", name, "-save", "-format", "msh22", "-o", "again.msh"], cwd=self.folder,
                                     capture_output=True, text=True, timeout=120, check=False)
                self.assertNotRegex(run.stdout + run.stderr, "(?m)^(Error|Warning)")
                rows = re.findall(r"(?m)^\d+ 2 \d", (self.folder / "again.msh").read_text().split("$Elements")[1])
                self.assertEqual(len(rows), self.counts["triangles"] - self.inner_triangles())

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_calculix_loads_the_sets(self):
        """A bar of two materials, held at one end and pulled at the other: the reaction is the pull, the stress is uniform."""
        pull = 3.0
        left, right = self.ends()
        self.assertTrue(left and right)
        (self.folder / "bar.inp").write_text(f"""*INCLUDE, INPUT=m.inp
*MATERIAL, NAME=soft
*ELASTIC
1000., 0.
*MATERIAL, NAME=hard
*ELASTIC
2000., 0.
*SOLID SECTION, ELSET=Solid1, MATERIAL=soft
*SOLID SECTION, ELSET=Solid2, MATERIAL=hard
*BOUNDARY
{left}, 1, 3, 0.
*STEP
*STATIC
*DSLOAD
{right}, P, {-pull}
*NODE PRINT, NSET={right}
U
*END STEP
""")
        run = subprocess.run(["ccx", "bar"], cwd=self.folder, capture_output=True, text=True, timeout=120, check=False)
        self.assertIn("Job finished", run.stdout, run.stdout[-2000:])
        rows = re.findall(r"(?m)^\s+\d+\s+(\S+)\s+(\S+)\s+(\S+)\s*$", (self.folder / "bar.dat").read_text())
        self.assertGreater(len(rows), 8)
        for row in rows:
            self.assertAlmostEqual(float(row[0]), pull * 1.0 / 1000.0 + pull * 2.0 / 2000.0, places=7)

    def ends(self):
        """The names of the faces at x = 0 and x = 3, by the nodes of their sets."""
        text = (self.folder / "m.inp").read_text()
        x = {int(n): float(value) for n, value in re.findall(r"(?m)^(\d+),(\S+?),\S+,\S+$", text.split("*ELEMENT")[0])}
        ends = {}
        for name, body in re.findall(r"\*NSET, NSET=(Face\d+)\n((?:\d.*\n)+)", text):
            places = {x[int(n)] for n in re.findall(r"\d+", body)}
            if places in ({0.0}, {3.0}):
                ends[places.pop()] = name
        return ends.get(0.0), ends.get(3.0)

    @unittest.skipUnless(shutil.which("freecadcmd"), "FreeCAD is not installed")
    def test_freecad_reads_meshes(self):
        environment = {**os.environ, "FREECAD_USER_HOME": str(self.folder), "MESHER_FOLDER": str(self.folder)}
        run = subprocess.run(["freecadcmd", HERE / "read_in_freecad.py"], env=environment, stdin=subprocess.DEVNULL,
                             capture_output=True, text=True, timeout=120, check=False)
        answer = self.folder / "answer.json"
        self.assertTrue(answer.exists(), run.stdout + run.stderr)
        answers = json.loads(answer.read_text())
        for name in ("m.unv", "m.inp", "m.vtk"):
            with self.subTest(file=name):
                self.assertEqual(answers[name]["volumes"], self.counts["tets"])
                self.assertEqual(answers[name]["nodes"], self.counts["vertices"])
                self.assertAlmostEqual(answers[name]["volume"], 3.0, places=9)
        groups = answers["m.unv"]["groups"]
        self.assertTrue({"Solid1", "Solid2", "Face1", "Face11"} <= set(groups), groups)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[5:]])

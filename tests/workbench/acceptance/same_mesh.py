"""FreeCAD, the command line and Python make the same mesh of the same file, bit for bit."""
import json
import os
import subprocess
import tempfile
import unittest

import FreeCAD
import Part

import mesher
import shapes
from acceptance_arguments import ARGUMENTS
from MesherWorkbench import make_mesh

PROGRAM, DEMOS = ARGUMENTS


class SameMesh(unittest.TestCase):
    def setUp(self):
        self.document = FreeCAD.newDocument()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def check(self, path, size, dimension=3):
        shape = Part.read(path)
        feature = self.document.addObject("Part::Feature", "Shape")
        feature.Shape = shape
        self.document.recompute()
        in_freecad = json.loads(make_mesh(feature, size=size, curvature=12, dimension=dimension).Report)["mesh_hash"]
        in_python = mesher.mesh(path, size=size, curvature=12, dimension=dimension).report["mesh_hash"]
        with tempfile.TemporaryDirectory() as directory:
            report = os.path.join(directory, "report.json")
            subprocess.run([PROGRAM, "mesh", path, "--size", repr(size), "--curvature", "12", "--dimension", str(dimension),
                            "-o", os.path.join(directory, "mesh.msh"), "--report", report], check=True, capture_output=True)
            with open(report) as file:
                on_the_command_line = json.load(file)["mesh_hash"]
        self.assertEqual(in_python, on_the_command_line)
        self.assertEqual(in_freecad, on_the_command_line)

    def test_bracket(self):
        self.check(os.path.join(DEMOS, "bracket.brep"), 8.0)

    def test_plane_faces(self):
        self.check(os.path.join(DEMOS, "gasket.brep"), 8.0, dimension=2)

    def test_shapes_written_by_freecad(self):
        for name in ("plate with a hole", "loft", "two solids"):
            with self.subTest(name), tempfile.TemporaryDirectory() as directory:
                path = os.path.join(directory, "shape.brep")
                shapes.ALL[name]().exportBrep(path)
                self.check(path, 4.0)

"""Meshes that a solver takes: what theory says within two per cent, and reactions that bear the load."""
import json
import math
import os
import re
import tempfile
import unittest

import FreeCAD
import ObjectsFem
from femtools import ccxtools

import shapes
from acceptance_arguments import ARGUMENTS
from MesherWorkbench import make_mesh
from MesherWorkbench.tools.meshed_shape import first_size

YOUNGS_MODULUS = 210000.0  # MPa
FORCE = 1000.0  # N


def make_solver(document):
    """By the name of this FreeCAD's maker, which has changed."""
    make = getattr(ObjectsFem, "makeSolverCalculiXCcxTools", None) or ObjectsFem.makeSolverCalculixCcxTools
    return make(document)


class Bars(unittest.TestCase):
    """Bodies that are fixed at one face and drawn at the opposite one."""

    def setUp(self):
        self.document = FreeCAD.newDocument()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def solve(self, part, mesh, fixed, loaded, direction, force=FORCE):
        """The results object, and the sum of the reactions as a list of three."""
        analysis = ObjectsFem.makeAnalysis(self.document)
        solver = make_solver(self.document)
        material = ObjectsFem.makeMaterialSolid(self.document)
        steel = material.Material
        steel.update(Name="Steel", YoungsModulus=f"{YOUNGS_MODULUS} MPa", PoissonRatio="0.30")
        material.Material = steel
        fixing = ObjectsFem.makeConstraintFixed(self.document, "Fixed")
        fixing.References = [(part, fixed)]
        load = ObjectsFem.makeConstraintForce(self.document, "Force")
        load.References = [(part, loaded)]
        # A quantity from FreeCAD 0.21 on, whose number would be millinewtons, and a number of newtons before.
        load.Force = f"{force} N" if load.getTypeIdOfProperty("Force") == "App::PropertyForce" else force
        load.Direction = (part, [direction])
        for member in (solver, material, fixing, load, mesh):
            analysis.addObject(member)
        self.document.recompute()
        with tempfile.TemporaryDirectory() as directory:
            run = ccxtools.FemToolsCcx(analysis, solver)
            run.update_objects()
            run.setup_working_dir(directory)
            run.setup_ccx()
            self.assertEqual(run.check_prerequisites(), "")
            run.purge_results()
            run.write_inp_file()
            self.assertEqual(run.ccx_run(), 0)
            run.load_results()
            with open(os.path.splitext(run.inp_file_name)[0] + ".dat") as file:
                told = file.read()
        totals = re.findall(r"total force .* for set FIXED .*\n\s*\n\s*(\S+)\s+(\S+)\s+(\S+)", told)
        self.assertEqual(len(totals), 1, told)
        return self.document.getObject("CCX_Results"), [float(number) for number in totals[0]]

    def expect_balance(self, reactions, along, force=FORCE):
        """Reactions are the load, and nothing across it; `along` is the axis of the load."""
        for axis, reaction in enumerate(reactions):
            wanted = force if axis == along else 0.0
            self.assertAlmostEqual(abs(reaction), wanted, delta=1e-4 * force)

    def mean_over(self, nodes, results, values):
        taken = [value for value, node in zip(values, results.NodeNumbers) if node in nodes]
        self.assertGreater(len(taken), 4)
        return sum(taken) / len(taken)

    def test_bar_in_tension(self):
        bar = self.document.addObject("Part::Box", "Bar")
        bar.Length = bar.Width = 10
        bar.Height = 100
        self.document.recompute()
        mesh = make_mesh(bar, size=3.0)
        results, reactions = self.solve(bar, mesh, "Face5", "Face6", "Edge1")
        self.expect_balance(reactions, along=2)
        stress = FORCE / 100.0
        stretch = stress * 100.0 / YOUNGS_MODULUS
        self.assertAlmostEqual(max(results.DisplacementLengths), stretch, delta=0.02 * stretch)
        # Two widths away from the fixed end, which keeps the bar from narrowing, the stress is uniform.
        middle = {number for number, place in mesh.FemMesh.Nodes.items() if 20.0 < place.z < 80.0}
        self.assertAlmostEqual(self.mean_over(middle, results, results.NodeStressZZ), stress, delta=0.02 * stress)
        self.assertAlmostEqual(self.mean_over(middle, results, results.vonMises), stress, delta=0.02 * stress)

    def test_cantilever_as_the_panel_proposes_it(self):
        beam = self.document.addObject("Part::Box", "Beam")
        beam.Length, beam.Width, beam.Height = 8000, 1000, 1000
        self.document.recompute()
        mesh = make_mesh(beam, size=first_size(beam.Shape), curvature=12)
        force = 9e6
        results, reactions = self.solve(beam, mesh, "Face1", "Face2", "Edge1", force)
        self.expect_balance(reactions, along=2, force=force)
        moved = max(results.DisplacementLengths)
        # Of a slender beam, without shear. Linear tetrahedra are stiffer than that, and never softer.
        slender = force * 8000.0**3 / (3.0 * YOUNGS_MODULUS * 1000.0**4 / 12.0)
        self.assertLess(moved, 1.02 * slender)
        self.assertGreater(moved, 0.5 * slender)
        # For whoever compares releases.
        told = f"{json.loads(mesh.Report)['mesh_hash']} {mesh.ElementCount} tetrahedra, the tip moves {moved:.4g} mm"
        print(f"cantilever: {told}")
        with open(ARGUMENTS[0], "w") as file:
            file.write(told + "\n")

    def test_plate_with_a_hole_in_tension(self):
        shape = shapes.plate_with_hole(radius=5)
        plate = self.document.addObject("Part::Feature", "Plate")
        plate.Shape = shape
        self.document.recompute()
        ends = {}
        for number, face in enumerate(shape.Faces, 1):
            if face.Surface.TypeId == "Part::GeomPlane" and abs(face.normalAt(0, 0).x) > 0.9:
                ends[round(face.CenterOfMass.x)] = f"Face{number}"
        along = next(f"Edge{i}" for i, edge in enumerate(shape.Edges, 1)
                     if edge.Curve.TypeId == "Part::GeomLine" and abs(edge.tangentAt(edge.FirstParameter).x) > 0.9)
        mesh = make_mesh(plate, size=4.0, curvature=16)
        results, reactions = self.solve(plate, mesh, ends[0], ends[100], along)
        self.expect_balance(reactions, along=0)
        # A small hole of radius a in a sheet of width W and length L adds 3 pi a^2 / (W L) to the compliance: by energy, the
        # dilute limit of a body with circular holes under uniaxial stress.
        stress = FORCE / 250.0
        stretch = stress * 100.0 / YOUNGS_MODULUS * (1.0 + 3.0 * math.pi * 5.0**2 / (50.0 * 100.0))
        end = set(mesh.FemMesh.getNodesByFace(shape.getElement(ends[100])))
        moved = self.mean_over(end, results, [vector.x for vector in results.DisplacementVectors])
        self.assertAlmostEqual(abs(moved), stretch, delta=0.02 * stretch)
        # Far from the hole the force flows through the whole width.
        far = {number for number, place in mesh.FemMesh.Nodes.items() if place.x > 80.0}
        self.assertAlmostEqual(self.mean_over(far, results, results.NodeStressXX), stress, delta=0.02 * stress)

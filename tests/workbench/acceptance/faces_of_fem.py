"""FEM finds the nodes of every face where the mesher says they are, and they are on the exact face.

Otherwise FEM applies loads to fewer nodes than it should, or to none, and says nothing."""
import os
import unittest

import FreeCAD
import Part

import shapes
from acceptance_arguments import ARGUMENTS
from MesherWorkbench import make_mesh

DEMOS = ARGUMENTS[0]
# What FEM's own search allows, which is the tolerance of faces that are made exactly.
LARGEST_DISTANCE = 1e-7


def nodes_of_groups(fem_mesh):
    return {fem_mesh.getGroupName(group): {node for element in fem_mesh.getGroupElements(group)
                                           for node in fem_mesh.getElementNodes(element)}
            for group in fem_mesh.Groups}


class FacesOfFem(unittest.TestCase):
    def setUp(self):
        self.document = FreeCAD.newDocument()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def check(self, shape):
        feature = self.document.addObject("Part::Feature", "Shape")
        feature.Shape = shape
        self.document.recompute()
        shape = feature.Shape
        mesh = make_mesh(feature, size=shape.BoundBox.DiagonalLength / 12, curvature=12).FemMesh
        nodes = mesh.Nodes
        groups = nodes_of_groups(mesh)
        self.assertEqual(sorted(groups), sorted([f"Face{i}" for i, _ in enumerate(shape.Faces, 1)] +
                                                [f"Solid{i}" for i, _ in enumerate(shape.Solids, 1)]))
        for number, face in enumerate(shape.Faces, 1):
            own = groups[f"Face{number}"]
            self.assertEqual(set(mesh.getNodesByFace(face)), own, f"Face{number}")
            worst = max(Part.Vertex(nodes[node]).distToShape(face)[0] for node in own)
            self.assertLessEqual(worst, LARGEST_DISTANCE, f"Face{number}")

    def test_bracket(self):
        self.check(Part.read(os.path.join(DEMOS, "bracket.brep")))


def _test_of(build):
    return lambda self: self.check(build())


for name, build in shapes.ALL.items():
    setattr(FacesOfFem, "test_" + name.replace(",", "").replace(" ", "_"), _test_of(build))

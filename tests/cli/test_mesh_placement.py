#!/usr/bin/python3
"""Tests that `mesher mesh` meshes faces in any plane of space.

    test_mesh_placement.py PROGRAM DATA-FOLDER [unittest options]
"""
import json
import math

from program_case import DATA, Case, read_msh, run_tests


def turned(axis, angle):
    """The matrix of a rotation, by Rodrigues' formula."""
    length = math.hypot(*axis)
    x, y, z = (c / length for c in axis)
    c, s = math.cos(angle), math.sin(angle)
    return [[c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
            [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
            [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)]]


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


if __name__ == "__main__":
    run_tests()

#!/usr/bin/python3
"""Round parts, whose coordinates have all digits that a number can have, in the solver that cuts what is longer than it reads.

    test_round_parts.py PROGRAM MODULE-FOLDER MODELS-FOLDER DEMOS-FOLDER [unittest options]
"""
import math
import re
import shutil
import subprocess
import unittest

from solid_case import MODELS, Case, run_tests

PARTS = sorted(path.stem for path in MODELS.glob("round_*.brep"))

# Held at one face, pressed on all others.
DECK = """*INCLUDE, INPUT=m.inp
*MATERIAL, NAME=steel
*ELASTIC
210000., 0.3
{sections}*BOUNDARY
Face1, 1, 3, 0.
*STEP
*STATIC
*DSLOAD
{loads}*NODE FILE
U
*END STEP
"""


def nodes_of(deck):
    """The coordinates by number, of the first part of the file."""
    rows = re.findall(r"(?m)^(\d+),([^,\n]+),([^,\n]+),([^,\n]+)$", deck.split("*ELEMENT")[0])
    return {int(number): tuple(rest) for number, *rest in rows}


class RoundParts(Case):
    def mesh(self, part):
        size = 8.0 * self.unit_of(part)
        run = self.run_mesher(MODELS / f"{part}.brep", "--size", size, "-o", "m.inp", "-o", "m.msh")
        self.assertEqual(run.returncode, 0, run.stderr)
        return (self.folder / "m.inp").read_text()

    def unit_of(self, part):
        return 1.0 if "turned" not in part else (1.0, 1.0 / 25.4, 1000.0)[int(part[-1]) % 3]

    def places_in_msh(self):
        blocks = (self.folder / "m.msh").read_text().split("$Nodes\n")[1].split("$EndNodes")[0]
        return [tuple(map(float, row)) for row in re.findall(r"(?m)^(\S+) (\S+) (\S+)$", blocks)]

    def test_numbers_fit_the_reader_and_are_the_nodes(self):
        self.assertEqual(len(PARTS), 14)
        for part in PARTS:
            with self.subTest(part=part):
                nodes = nodes_of(self.mesh(part))
                self.assertLessEqual(max(len(word) for row in nodes.values() for word in row), 20)
                places = self.places_in_msh()
                self.assertEqual(len(nodes), len(places))
                for number, place in enumerate(places, 1):
                    for word, x in zip(nodes[number], place):
                        self.assertLessEqual(abs(float(word) - x), 1e-13 * abs(x))

    def test_what_is_zero_is_written_so(self):
        """A coordinate of a node on the boundary that rounding alone keeps from zero."""
        for part in (part for part in PARTS if "turned" not in part):
            with self.subTest(part=part):
                self.mesh(part)
                low = [x for place in self.places_in_msh() for x in place if 0.0 < abs(x) < 1e-14]
                self.assertEqual(low, [])

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_calculix_solves_them_with_nodes_in_their_places(self):
        for part in PARTS:
            with self.subTest(part=part):
                deck = self.mesh(part)
                sections = "".join(f"*SOLID SECTION, ELSET={name}, MATERIAL=steel\n" for name in re.findall(r"ELSET=(\w+)", deck))
                faces = [name for name in re.findall(r"\*SURFACE, NAME=(\w+)", deck) if name != "Face1"]
                loads = "".join(f"{face}, P, 1.\n" for face in faces)
                (self.folder / "run.inp").write_text(DECK.format(sections=sections, loads=loads))
                run = subprocess.run(["ccx", "run"], cwd=self.folder, capture_output=True, text=True, timeout=120, check=False)
                self.assertIn("Job finished", run.stdout, run.stdout[-1000:])
                self.expect_places(nodes_of(deck))

    def expect_places(self, nodes):
        """What the solver tells of its nodes has six digits."""
        result = (self.folder / "run.frd").read_text()
        told = re.findall(r"(?m)^ -1([ \d]{10})(.{12})(.{12})(.{12})$", result.split(" -3\n")[0])
        self.assertEqual(len(told), len(nodes))
        for number, *words in told:
            wanted = tuple(map(float, nodes[int(number)]))
            largest = max(map(abs, wanted))
            self.assertLessEqual(math.dist(wanted, tuple(map(float, words))), 2e-5 * largest)


if __name__ == "__main__":
    run_tests()

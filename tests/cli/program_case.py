"""What the tests of the program share: where it is, by the command line, and a case with a folder of its own.

    test_….py PROGRAM DATA-FOLDER [unittest options]
"""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

# Whether the program is built with sanitizers.
SANITIZED = "MESHER_SANITIZED" in os.environ
PROGRAM, DATA = (Path(word).resolve() for word in sys.argv[1:3])


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


def run_tests():
    unittest.main(module="__main__", argv=[sys.argv[0], *sys.argv[3:]])

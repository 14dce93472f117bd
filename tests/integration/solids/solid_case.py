"""What the tests of this folder share: where things are, by the command line, and a case with a folder of its own.

    test_….py PROGRAM MODULE-FOLDER MODELS-FOLDER DEMOS-FOLDER [unittest options]
"""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, MODULES, MODELS, DEMOS = (Path(word).resolve() for word in sys.argv[1:5])
if (MODULES / "mesher").is_dir():
    sys.path.insert(0, str(MODULES))
    import mesher
else:
    mesher = None


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_mesher(self, model, *arguments):
        return subprocess.run([PROGRAM, "mesh", model, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True,
                              timeout=120, check=False)

    def report(self):
        return json.loads((self.folder / "r.json").read_text())


def run_tests():
    unittest.main(module="__main__", argv=[sys.argv[0], *sys.argv[5:]])

#!/usr/bin/python3
"""One model and one set of options give one mesh, bit for bit: in two runs, on any number of threads, in every build, from the
program, from Python and from FreeCAD.

    test_same_mesh.py PROGRAM MODULE-FOLDER MODELS-FOLDER DEMOS-FOLDER [unittest options]

pinned_meshes.json has the meshes as every build on every machine with Open CASCADE 7.6 makes them. Where the mesher is changed
on purpose, MESHER_PIN=1 writes them anew; look at their numbers of tetrahedra and smallest angles before you keep it.
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, MODULES, MODELS, DEMOS = (Path(word).resolve() for word in sys.argv[1:5])
HERE = Path(__file__).resolve().parent
PINS = HERE / "pinned_meshes.json"
OPTIONS = {
    "box_with_hole": {"size": 0.6},
    "cut_ball": {"size": 0.8},
    "loft": {"size": 0.7},
    "glued_boxes": {"size": 0.3},
    "bracket": {"size": 12.0, "curvature": 8},
}


def path_of(name):
    return (DEMOS if name == "bracket" else MODELS) / f"{name}.brep"


def run_program(name, threads=1):
    """The report of a run."""
    with tempfile.TemporaryDirectory() as folder:
        words = [word for option, value in OPTIONS[name].items() for word in (f"--{option}", str(value))]
        run = subprocess.run([PROGRAM, "mesh", path_of(name), *words, "--threads", str(threads), "-o", "m.msh", "--report", "r.json"],
                             cwd=folder, capture_output=True, text=True, timeout=300, check=False)
        if run.returncode != 0:
            raise AssertionError(run.stderr)
        return json.loads((Path(folder) / "r.json").read_text())


class SameMesh(unittest.TestCase):
    def test_every_build_makes_the_pinned_mesh(self):
        made = {}
        for name in OPTIONS:
            report = run_program(name)
            made[name] = {"mesh_hash": report["mesh_hash"], "tets": report["counts"]["tets"],
                          "min_dihedral": report["quality"]["min_dihedral"]}
        if os.environ.get("MESHER_PIN"):
            PINS.write_text(json.dumps(made, indent=4) + "\n")
        pinned = json.loads(PINS.read_text())
        for name, facts in made.items():
            with self.subTest(model=name):
                self.assertEqual(facts["tets"], pinned[name]["tets"])
                self.assertEqual(facts["mesh_hash"], pinned[name]["mesh_hash"])
                self.assertAlmostEqual(facts["min_dihedral"], pinned[name]["min_dihedral"], places=9)

    def test_two_runs_and_any_number_of_threads(self):
        for name in OPTIONS:
            hashes = [run_program(name, threads)["mesh_hash"] for threads in (1, 1, 2, 3)]
            with self.subTest(model=name):
                self.assertEqual(len(set(hashes)), 1, hashes)

    def test_python_makes_the_mesh_of_the_program(self):
        if not (MODULES / "mesher").is_dir():
            self.skipTest("the Python package is not built")
        sys.path.insert(0, str(MODULES))
        import mesher  # pylint: disable=import-outside-toplevel,import-error
        for name, options in OPTIONS.items():
            with self.subTest(model=name):
                mesh = mesher.mesh(str(path_of(name)), **options)
                self.assertEqual(f"{mesh.hash:016x}", run_program(name)["mesh_hash"].removeprefix("0x"))

    def test_freecad_makes_the_mesh_of_the_program(self):
        freecad = shutil.which("freecadcmd")
        if not freecad or not (MODULES / "MesherWorkbench").is_dir():
            self.skipTest("FreeCAD is not installed, or the workbench not built")
        with tempfile.TemporaryDirectory() as folder:
            answer = Path(folder) / "answer.json"
            question = {"modules": str(MODULES), "answer": str(answer),
                        "models": {name: [str(path_of(name)), options] for name, options in OPTIONS.items()}}
            environment = {**os.environ, "FREECAD_USER_HOME": folder, "MESHER_QUESTION": json.dumps(question)}
            run = subprocess.run([freecad, HERE / "same_mesh_in_freecad.py"], env=environment, stdin=subprocess.DEVNULL,
                                 capture_output=True, text=True, timeout=300, check=False)
            self.assertTrue(answer.exists(), run.stdout + run.stderr)
            for name, (made, wanted) in json.loads(answer.read_text()).items():
                with self.subTest(model=name):
                    self.assertEqual(made, wanted)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[5:]])

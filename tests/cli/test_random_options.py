#!/usr/bin/python3
"""Runs the program with options drawn at random: whatever they are, it ends by itself with a status of its own, tells why, and leaves
nothing behind but what was asked for.

    test_random_options.py PROGRAM DATA-FOLDER [unittest options]

MESHER_RANDOM_SETS is the number of sets (default 24), MESHER_RANDOM_SEED the first seed, MESHER_RANDOM_MODELS a folder with models of
others' making in place of the small ones here.
"""
import json
import os
import random
import subprocess
from pathlib import Path

from program_case import DATA, PROGRAM, Case, run_tests

SETS = int(os.environ.get("MESHER_RANDOM_SETS", "24"))
FIRST_SEED = int(os.environ.get("MESHER_RANDOM_SEED", "1"))
MODELS = os.environ.get("MESHER_RANDOM_MODELS")
FORMATS = ["msh", "vtu", "vtk", "su2", "stl", "ply", "inp", "unv", "png"]
TIMEOUT = 3.0
GUARD = 60.0  # a run that takes so long hangs, on however busy a machine

# As users mistype them, and as programs hand them over.
ODD_NUMBERS = ["0", "-1", "1e-300", "1e300", "nan", "inf", "-0.0", "1e-9", "1e9", "", "x", "3,5", "0x10", "1e", "--", "½"]


class Draw(random.Random):
    def number(self, low, high):
        """Mostly of the range that makes sense."""
        if self.random() < 0.07:
            return self.choice(ODD_NUMBERS)
        return f"{low * (high / low) ** self.random():.4g}"

    def entity(self):
        return self.choice(["Vertex", "Edge", "Face", "Solid"]) + str(self.choice([1, 1, 2, 3, 4, 6, 99]))

    def place(self):
        return ",".join(self.number(0.05, 3.0) for _ in range(3))


def _size(draw, unit):
    return draw.number(0.08 * unit, 2.0 * unit)


OPTIONS = {
    "--dimension": lambda d, u: d.choice(["2", "2", "3", "3", "3", "3", "3", "4"]),
    "--faces": lambda d, u: ",".join(d.entity() for _ in range(d.randint(1, 3))),
    "--size": _size,
    "--min-size": lambda d, u: d.number(0.01 * u, 0.5 * u),
    "--curvature": lambda d, u: d.number(3, 60),
    "--sag": lambda d, u: d.number(0.002 * u, 0.2 * u),
    "--refinement": lambda d, u: d.number(1, 4),
    "--grading": lambda d, u: d.number(0.5, 6),
    "--local-size": lambda d, u: f"{d.entity()}={_size(d, u)}",
    "--size-distance": lambda d, u: f"{d.entity()}={_size(d, u)},{d.number(0.1, 3)}",
    "--size-box": lambda d, u: f"{d.place()},{d.place()}={_size(d, u)}",
    "--size-ball": lambda d, u: f"{d.place()},{d.number(0.1, 2)}={_size(d, u)},{d.number(0.1, 3)}",
    "--size-formula": lambda d, u: d.choice(["0.3+0.1*x", "0.2", "x", "1/0", "sqrt(-1)", "((", "1e-300+abs(x)", "log(y)"]),
    "--size-points": lambda d, u: d.choice(["points.txt", "nowhere.txt"]),
    "--background": lambda d, u: d.choice(["nowhere.msh", "points.txt"]),
    "--min-angle": lambda d, u: d.number(1, 33),
    "--max-turn": lambda d, u: d.number(30, 90),
    "--measure": lambda d, u: d.choice([f"q{i}" for i in range(0, 10)]),
    "--threshold": lambda d, u: d.number(0.05, 0.5),
    "--max-dihedral": lambda d, u: d.number(120, 180),
    "--no-improve": None,
    "--order": lambda d, u: d.choice(["1", "1", "2", "3"]),
    "--threads": lambda d, u: d.choice(["1", "2", "4", "64", "0", "100000"]),
    "--max-elements": lambda d, u: d.number(10, 1e5),
    "--max-wall-elements": lambda d, u: d.choice(["0", "1000", "1000000"]),
    "--overlap": lambda d, u: d.choice(["separate", "refuse", "other"]),
    "--heal": None,
    "--check": None,
    "--keep-partial": None,
    "--curved-boundary": lambda d, u: "boundary.json",
    "--boundary-order": lambda d, u: d.choice(["2", "3", "4", "5"]),
    "--no-such-option": None,
}


def drawn_options(draw, unit):
    names = draw.sample(sorted(OPTIONS), draw.randint(1, 6))
    if draw.random() < 0.95 and "--no-such-option" in names:
        names.remove("--no-such-option")
    words = []
    for name in names:
        words.append(name)
        if OPTIONS[name] is not None:
            words.append(OPTIONS[name](draw, unit))
    return words


def models():
    """(path, a length of about a third of its size)"""
    if MODELS:
        return [(path, None) for path in sorted(Path(MODELS).iterdir()) if path.suffix in (".brep", ".step", ".stp")]
    return [(DATA / f"{name}.brep", unit)
            for name, unit in (("box", 0.5), ("plate", 0.5), ("cylinder_wall", 0.5), ("inclusion", 0.5), ("angled_squares", 0.5))]


class RandomOptions(Case):
    def test_ends_by_itself_and_leaves_nothing_behind(self):
        for seed in range(FIRST_SEED, FIRST_SEED + SETS):
            draw = Draw(seed)
            model, unit = draw.choice(models())
            outputs = [f"out{i}.{draw.choice(FORMATS)}" for i in range(draw.randint(1, 2))]
            words = drawn_options(draw, unit or self.unit_of(model))
            command = draw.choice(["mesh", "mesh", "mesh", "estimate"])
            arguments = [command, str(model), *words, "--timeout", str(TIMEOUT)]
            if command == "mesh":
                arguments += [word for name in outputs for word in ("-o", name)] + ["--report", "report.json"]
            else:
                outputs = []
            with self.subTest(seed=seed, arguments=" ".join(arguments)):
                self.check(arguments, outputs)

    def unit_of(self, model):
        facts = json.loads(self.run_mesher("info", "--json", model).stdout)
        return max(high - low for low, high in zip(facts["box_low"], facts["box_high"])) / 3.0

    def check(self, arguments, outputs):
        (self.folder / "points.txt").write_text("0 0 0 0.3\n1 1 1 0.5\n")
        run = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=GUARD, cwd=self.folder,
                             check=False)
        said = run.stdout + run.stderr
        self.assertIn(run.returncode, (0, 1, 2), said)
        self.assertNotRegex(said, r"terminate called|Standard_|-?\bnan\b elements")
        if run.returncode != 0:
            self.assertRegex(run.stderr, r"^mesher: .+\.\n")
        left = set(os.listdir(self.folder))
        wanted = {"points.txt", "report.json", "boundary.json", *outputs}
        self.assertEqual(left - wanted, set(), said)
        if run.returncode == 0:
            self.assertLessEqual(set(outputs), left, said)
        for name in left:
            (self.folder / name).unlink()


if __name__ == "__main__":
    run_tests()

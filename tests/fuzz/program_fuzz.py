#!/usr/bin/python3
"""Runs the program on hard solids with options drawn at random, and judges what it says and writes.

    program_fuzz.py --program MESHER --maker MAKE_HARD_SOLID [--solids 100] [--seed 1] [--timeout 60] [--keep FOLDER] [--judge MESHCHECK]

A line for each solid: its seed, the verdict, seconds, recipe, options, and what was said. The verdicts:
  meshed      status 0; `mesher check` with the model, and MESHCHECK if there is one, find nothing
  limited     status 1 for the time or the number of elements, within the time
  refused     status 1 with an entity, and the kernel's own checks find the solid unsound as well
  skipped     the kernel could not make the solid
  CHALLENGED  refused, though the kernel's checks find nothing
  FAILED      anything else: a signal, a hang, files left behind, a bad mesh, a refusal without a reason
Ends with 1 if one FAILED, or if one was CHALLENGED under --strict.
"""
import argparse
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

GRACE = 2.0  # seconds that a run may take beyond its time
LIMITS = re.compile(r"--timeout|--max-elements|ran out|time limit|limit of", re.IGNORECASE)


def drawn_options(draw, diagonal):
    """Sizes that make some thousands of elements, and a few further wishes."""
    words = []
    if draw.random() < 0.85:
        words += ["--size", f"{diagonal / draw.uniform(4, 25):.6g}"]
    if draw.random() < 0.5:
        words += ["--curvature", str(draw.choice([6, 8, 12, 12, 20, 36]))]
    further = {
        "--grading": lambda: f"{draw.uniform(0.5, 5):.3g}",
        "--refinement": lambda: f"{draw.uniform(1, 2.5):.3g}",
        "--sag": lambda: f"{diagonal * 10 ** draw.uniform(-4, -2):.4g}",
        "--max-turn": lambda: f"{draw.uniform(30, 90):.3g}",
        "--measure": lambda: f"q{draw.randint(1, 8)}",
        "--min-angle": lambda: f"{draw.uniform(10, 33):.3g}",
        "--lambda": lambda: f"{draw.uniform(1, 20):.3g}",
        "--no-improve": None,
        "--check": None,
        "--threads": lambda: "2",
        "--heal": None,
        "--max-wall-elements": lambda: draw.choice(["0", "10000"]),
        "--local-size": lambda: f"Face1={diagonal / draw.uniform(10, 60):.4g}",
        "--size-distance": lambda: f"Edge1={diagonal / draw.uniform(20, 80):.4g},{draw.uniform(0.1, 1):.3g}",
        "--dimension": lambda: "2",
    }
    for name in draw.sample(sorted(further), draw.choice([0, 0, 1, 1, 2, 3])):
        words += [name] + ([further[name]()] if further[name] else [])
    return words


class Fuzz:
    def __init__(self, arguments, folder):
        self.arguments = arguments
        self.folder = folder

    def run(self, *words, timeout):
        return subprocess.run([str(word) for word in words], capture_output=True, text=True, errors="replace",
                              timeout=timeout, cwd=self.folder, check=False)

    def verdict(self, seed):
        """(verdict, seconds, recipe, options, what was said)"""
        draw = random.Random(seed)
        model = self.folder / f"solid.{'brep' if draw.random() < 0.6 else 'step'}"
        try:
            made = self.run(self.arguments.maker, seed, model, timeout=60)
        except subprocess.TimeoutExpired:
            return "skipped", 0.0, "", "", "the kernel takes too long"
        if made.returncode != 0:
            return "skipped", 0.0, made.stdout.strip(), "", ""
        try:
            facts = self.run(self.arguments.program, "info", "--json", model, timeout=120)
            box = json.loads(facts.stdout)
        except subprocess.TimeoutExpired:
            return "FAILED", 120.0, made.stdout.strip(), "", "info takes too long"
        except ValueError:
            return "FAILED", 0.0, made.stdout.strip(), "", "info: " + " ".join(facts.stderr.split())
        diagonal = sum((b - a) ** 2 for a, b in zip(box["box_low"], box["box_high"])) ** 0.5
        options = drawn_options(draw, diagonal)
        begin = time.monotonic()
        try:
            run = self.run(self.arguments.program, "mesh", model, "-o", "out.msh", "--report", "report.json", "--timeout",
                           self.arguments.timeout, *options, timeout=self.arguments.timeout + 60)
        except subprocess.TimeoutExpired:
            return "FAILED", time.monotonic() - begin, made.stdout.strip(), " ".join(options), "hangs"
        seconds = time.monotonic() - begin
        verdict, said = self.judged(run, seconds, model, made.stdout)
        return verdict, seconds, made.stdout.strip(), " ".join(options), said

    def judged(self, run, seconds, model, recipe):
        said = " ".join((run.stderr.strip() or run.stdout.strip()).split())
        if run.returncode not in (0, 1):
            return "FAILED", f"status {run.returncode}: {said}"
        if re.search(r"terminate called|Standard_|\bnan\b", run.stdout + run.stderr):
            return "FAILED", said
        if seconds > self.arguments.timeout + GRACE:
            return "FAILED", f"{seconds:.1f} seconds: {said}"
        left = {path.name for path in self.folder.iterdir()} - {model.name, "report.json", "out.msh"}
        if left:
            return "FAILED", f"left behind {left}: {said}"
        if run.returncode == 1:
            return self.refused(run, model, said)
        return self.checked(model, run)

    def refused(self, run, model, said):
        if (self.folder / "out.msh").exists():
            return "FAILED", f"status 1 and a mesh: {said}"
        if not re.search(r"^mesher: .+\.$", run.stderr, re.MULTILINE):
            return "FAILED", f"no reason: {said}"
        report = json.loads((self.folder / "report.json").read_text())
        if report.get("stop_reason") not in ("done", None, "") or LIMITS.search(said):
            return "limited", said
        try:
            argued = self.run(self.arguments.maker, "--check", model, timeout=120)
        except subprocess.TimeoutExpired:
            return "CHALLENGED", f"(the kernel's check takes too long) {said}"
        sound = "valid" in argued.stdout and "crosses-itself" not in argued.stdout
        return ("CHALLENGED" if sound else "refused"), f"({' '.join(argued.stdout.split()) or 'invalid'}) {said}"

    def checked(self, model, run):
        report = json.loads((self.folder / "report.json").read_text())
        # What is healed has entities of its own.
        against = [] if "--heal" in run.args else ["--model", model]
        check = self.run(self.arguments.program, "check", "out.msh", *against, timeout=600)
        if check.returncode != 0:
            return "FAILED", "check: " + " ".join((check.stdout + check.stderr).split())
        if self.arguments.judge and report["counts"].get("tets", 0):
            judged = json.loads(self.run(self.arguments.judge, "out.msh", timeout=600).stdout)
            if not judged.get("valid"):
                return "FAILED", f"judged {judged}"
        quality = report.get("quality") or {}
        figures = f"{report['counts'].get('tets')} tets {quality.get('min_dihedral')} {quality.get('max_dihedral')}"
        return "meshed", f"{figures} {' '.join(run.stderr.split())}"

    def kept(self, seed):
        if not self.arguments.keep:
            return
        Path(self.arguments.keep).mkdir(parents=True, exist_ok=True)
        for path in self.folder.glob("solid.*"):
            shutil.copy(path, Path(self.arguments.keep) / f"{seed}{path.suffix}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, type=os.path.abspath)
    parser.add_argument("--maker", required=True, type=os.path.abspath)
    parser.add_argument("--solids", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--timeout", type=float, default=60.0)
    parser.add_argument("--keep")
    parser.add_argument("--judge")
    parser.add_argument("--strict", action="store_true")
    arguments = parser.parse_args()
    tally = Counter()
    for seed in range(arguments.seed, arguments.seed + arguments.solids):
        with tempfile.TemporaryDirectory() as folder:
            fuzz = Fuzz(arguments, Path(folder))
            verdict, seconds, recipe, options, said = fuzz.verdict(seed)
            tally[verdict] += 1
            if verdict.isupper():
                fuzz.kept(seed)
            print(f"{seed}\t{verdict}\t{seconds:.1f}\t{recipe}\t{options}\t{said}", flush=True)
    print(" ".join(f"{name} {count}" for name, count in sorted(tally.items())))
    return 1 if tally["FAILED"] or (arguments.strict and tally["CHALLENGED"]) else 0


if __name__ == "__main__":
    sys.exit(main())

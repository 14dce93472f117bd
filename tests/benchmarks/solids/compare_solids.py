#!/usr/bin/python3
"""Compares the mesher of solids with Gmsh at the same requested size, and prints or writes the page docs/benchmarks/solids.md.

    compare_solids.py BIN-FOLDER MODELS-FOLDER DEMOS-FOLDER [--tets N …] [--repeats N] [--peer NAME=COMMAND …]
                      [--only MODEL …] [--write PAGE]

BIN-FOLDER holds the program mesher, MODELS-FOLDER what solid_models writes, DEMOS-FOLDER the demonstrations. Gmsh is the program
on the path, asked for size, curvature and its usual optimisation. A peer given by --peer is called with the command line of the
mesher: COMMAND mesh MODEL -o OUT.msh --size H --curvature 12 --threads 1, and left out where it would take minutes. Each run is a
process of its own on one thread; times are its CPU seconds from reading the model to the written file, the least of the repeats,
which take turns.
"""
import argparse
import json
import os
import re
import resource
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

CURVATURE = "12"
# What the mesher fills a volume with at size h: that many tetrahedra per h^3, so that all models come to about the same number.
TETS_PER_CUBE = 4.5
MODELS = {"box_with_hole": "box with a hole: planes, a cylinder", "cut_ball": "ball cut by a plane: a sphere",
          "loft": "loft: B-splines", "glued_boxes": "two boxes that share a face", "bracket": "bracket: planes, cylinders, fillets"}
LARGE_MODELS = ("box_with_hole", "bracket")
LARGE = 500_000  # tetrahedra: fewer models, no peers but Gmsh
OURS = "this mesher"
RAW = "this mesher, without improvement"
GMSH = {"Gmsh, Delaunay": [], "Gmsh, HXT": ["-algo", "hxt"]}
STAGES = ("reading", "surfaces", "tetrahedralization", "refinement", "classification", "improvement", "measures", "writing")


def spend(command, log, limit):
    """Exit status, CPU seconds and peak megabytes of a program; what it prints goes to the log."""
    def bound():
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 5))
    with log.open("wb") as file:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=file, stderr=subprocess.STDOUT, preexec_fn=bound,
                                   env=dict(os.environ, OMP_NUM_THREADS="1"))
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.0


class Comparison:
    def __init__(self, arguments, folder):
        self.mesher = arguments.programs.resolve() / "mesher"
        self.models = arguments.models.resolve()
        self.demos = arguments.demos.resolve()
        self.repeats = arguments.repeats
        self.limit = arguments.limit
        self.peers = dict(peer.split("=", 1) for peer in arguments.peer)
        self.only = arguments.only
        self.folder = folder

    def path(self, model):
        return self.demos / "bracket.brep" if model == "bracket" else self.models / f"{model}.brep"

    def size_for(self, model, tets):
        """From the volume of a coarse mesh."""
        report = self.folder / "coarse.json"
        subprocess.run([self.mesher, "mesh", self.path(model), "-o", self.folder / "coarse.msh", "--no-improve",
                        "--report", report], check=True, capture_output=True)
        volume = json.loads(report.read_text())["mesh"]["volume"]
        return float(f"{(TETS_PER_CUBE * volume / tets) ** (1.0 / 3.0):.4g}")

    def command(self, name, model, size, out):
        path = str(self.path(model))
        ours = ["mesh", path, "-o", str(out), "--size", repr(size), "--curvature", CURVATURE, "--threads", "1"]
        if name in (OURS, RAW):
            options = ["--no-improve"] if name == RAW else []
            return [str(self.mesher), *ours, *options, "--report", str(out.with_suffix(".json"))]
        if name in self.peers:
            return [*shlex.split(self.peers[name]), *ours]
        return ["gmsh", "-3", "-nt", "1", path, "-clmax", repr(size), "-setnumber", "Mesh.MeshSizeFromCurvature", CURVATURE,
                *GMSH[name], "-format", "msh22", "-o", str(out)]

    def measure(self, name, model, size):
        out, log = self.folder / "mesh.msh", self.folder / "log"
        for file in (out, out.with_suffix(".json")):
            file.unlink(missing_ok=True)
        status, seconds, megabytes = spend(self.command(name, model, size, out), log, self.limit)
        if not out.exists():
            return {"failure": f"no mesh (exit status {status})"}
        result = {"seconds": seconds, "megabytes": megabytes, "stages": {}, **self.describe(out)}
        if name in (OURS, RAW):
            result["stages"] = json.loads(out.with_suffix(".json").read_text())["cpu_seconds"]
        else:
            phases = re.findall(r"Done meshing (\dD) \(Wall [\d.e+-]+s, CPU ([\d.e+-]+)s\)", log.read_text(errors="replace"))
            result["stages"] = {phase: float(spent) for phase, spent in phases}
        return result

    def describe(self, mesh):
        """Tetrahedra and their range of dihedral angles, as the mesher's own check of a file tells them."""
        told = subprocess.run([self.mesher, "check", mesh], capture_output=True, text=True, check=False).stdout
        tets = re.search(r"(\d+) tetrahedra", told)
        angles = re.search(r"dihedral angles: ([\d.e+-]+) to ([\d.e+-]+) degrees", told)
        return {"tets": int(tets.group(1)) if tets else 0,
                "angles": [float(angle) for angle in angles.groups()] if angles else [0.0, 0.0]}

    def rows(self, model, tets):
        """The size, and the best result of each mesher by name."""
        size = self.size_for(model, tets)
        best = {}
        for _ in range(self.repeats):
            for name in (OURS, RAW, *GMSH, *(self.peers if tets < LARGE else ())):
                result = self.measure(name, model, size)
                known = best.get(name)
                if known is None or "failure" in known or result.get("seconds", 1e99) < known["seconds"]:
                    best[name] = result
        return best


def time_table(rows_of):
    lines = ["| model | mesher | tetrahedra | CPU, ours = 1 | CPU per tetrahedron, ours = 1 | angles | peak MB |",
             "|---|---|---:|---:|---:|---:|---:|"]
    for model, rows in rows_of.items():
        ours = rows[OURS]
        for name, row in rows.items():
            if "failure" in row:
                lines.append(f"| {MODELS[model]} | {name} | {row['failure']} | | | | |")
                continue
            whole = row["seconds"] / ours["seconds"]
            each = whole * ours["tets"] / max(1, row["tets"])
            low, high = row["angles"]
            lines.append(f"| {MODELS[model]} | {name} | {row['tets']} | {whole:.2f} | {each:.2f} | {low:.1f}–{high:.1f} | "
                         f"{row['megabytes']:.0f} |")
    return lines


def stage_table(rows_of):
    lines = ["| model | " + " | ".join(STAGES) + " | other |", "|---|" + "---:|" * (len(STAGES) + 1)]
    for model, rows in rows_of.items():
        row = rows[OURS]
        if "failure" in row:
            continue
        shares = [100.0 * row["stages"].get(stage, 0.0) / row["seconds"] for stage in STAGES]
        cells = " | ".join(f"{share:.0f} %" for share in (*shares, 100.0 - sum(shares)))
        lines.append(f"| {MODELS[model]} | {cells} |")
    return lines


def gmsh_stage_table(rows_of):
    lines = ["| model | mesher | curves | surfaces | volume | other |", "|---|---|---:|---:|---:|---:|"]
    for model, rows in rows_of.items():
        for name in GMSH:
            row = rows[name]
            if "failure" in row:
                continue
            shares = [100.0 * row["stages"].get(stage, 0.0) / row["seconds"] for stage in ("1D", "2D", "3D")]
            cells = " | ".join(f"{share:.0f} %" for share in (*shares, 100.0 - sum(shares)))
            lines.append(f"| {MODELS[model]} | {name} | {cells} |")
    return lines


def section(comparison, tets):
    models = MODELS if tets < LARGE else LARGE_MODELS
    rows_of = {model: comparison.rows(model, tets) for model in models if model in comparison.only}
    return [f"## About {tets:,} tetrahedra", "", *time_table(rows_of), "", "Where this mesher's time goes:", "",
            *stage_table(rows_of), "", "Where Gmsh's goes:", "", *gmsh_stage_table(rows_of), ""]


def told_repeats(repeats):
    return f"Each figure is the least of {repeats} runs." if repeats > 1 else "Each figure is from one run, good to about a fifth."


def page(comparison, counts):
    lines = [
        "# The mesher of solids beside its peers", "",
        "Written by `tests/benchmarks/solids/compare_solids.py` with `--write docs/benchmarks/solids.md`. One thread, CPU seconds from "
        "reading the", "model to the written file, all rows of a model in one run: the ratios are what counts. All are asked for the "
        "same size and", f"for {CURVATURE} elements in a full turn. At the same size this mesher makes about as many tetrahedra as Gmsh; "
        "the", "fifth column compares the time for each. " + told_repeats(comparison.repeats), ""]
    for tets in counts:
        lines += section(comparison, tets)
    return lines[:-1]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=Path)
    parser.add_argument("models", type=Path)
    parser.add_argument("demos", type=Path)
    parser.add_argument("--tets", type=int, nargs="+", default=[100_000, 1_000_000])
    parser.add_argument("--repeats", type=int, default=2)
    parser.add_argument("--limit", type=int, default=600, help="CPU seconds of a run")
    parser.add_argument("--peer", action="append", default=[], metavar="NAME=COMMAND")
    parser.add_argument("--only", nargs="+", choices=MODELS, default=list(MODELS), metavar="MODEL")
    parser.add_argument("--write", type=Path)
    arguments = parser.parse_args()
    if shutil.which("gmsh") is None:
        sys.exit("compare_solids.py: there is no program gmsh")
    with tempfile.TemporaryDirectory() as folder:
        lines = page(Comparison(arguments, Path(folder)), arguments.tets)
    text = "\n".join(lines) + "\n"
    if arguments.write is None:
        print(text, end="")
    else:
        arguments.write.parent.mkdir(parents=True, exist_ok=True)
        arguments.write.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()

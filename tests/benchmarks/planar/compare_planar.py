#!/usr/bin/python3
"""Compares the planar mesher with CGAL's Delaunay_mesh_2 and with Gmsh, and prints or writes the page docs/benchmarks/planar.md.

    compare_planar.py BIN-FOLDER [--triangles N] [--repeats N] [--write PAGE]

BIN-FOLDER holds planar_ours and planar_peer_cgal; Gmsh is the program on the path. Each peer is a process of its own. Times
are CPU seconds on one thread as each program counts them for the meshing alone (Gmsh: its log's "Done meshing 2D"), the least
of the repeats, which take turns.
"""
import argparse
import json
import math
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

BOUND = 30.0
DENSE_DEGREES = 5.0  # a polyline that CAD viewers would draw as smooth
SPEED_DOMAINS = {"square": "straight: unit square", "annulus": "curved: annulus, two circles",
                 "airfoil": "curved: three-element airfoil, splines"}
AREAS = {"square": 1.0, "annulus": 3.0 * math.pi, "airfoil": 9.0 * math.pi}
# Programs mean different things by a size: triangles per area / size^2, so that all come to the same number of triangles.
TRIANGLES_PER_SQUARE = {"ours": 2.72, "cgal": 5.02, "front2d": 2.31, "del2d": 2.31}
GMSH_ALGORITHMS = {"front2d": "Gmsh, Frontal-Delaunay", "del2d": "Gmsh, Delaunay"}


def run_json(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, timeout=3600)
    if done.returncode != 0:
        return None
    return json.loads(done.stdout)


def read_outline(path):
    vertices, edges = [], []
    for line in path.read_text(encoding="ascii").splitlines():
        kind, first, second = line.split()
        if kind == "v":
            vertices.append((float(first), float(second)))
        if kind == "e":
            edges.append((int(first), int(second)))
    return vertices, edges


def loops_of(edges):
    following = dict(edges)
    loops = []
    while following:
        start, vertex = following.popitem()
        loop = [start]
        while vertex != start:
            loop.append(vertex)
            vertex = following.pop(vertex)
        loops.append(loop)
    return loops


def polyline_geometry(outline, size):
    """Gmsh's own language. Without a size each segment stays one edge, and sizes inside follow from the boundary."""
    vertices, edges = read_outline(outline)
    lines = [f"Point({i + 1}) = {{{x!r}, {y!r}, 0}};" for i, (x, y) in enumerate(vertices)]
    number = {}
    for i, (first, last) in enumerate(edges):
        number[first] = i + 1
        lines.append(f"Line({i + 1}) = {{{first + 1}, {last + 1}}};")
    loops = loops_of(edges)
    for i, loop in enumerate(loops):
        lines.append(f"Curve Loop({i + 1}) = {{{', '.join(str(number[v]) for v in loop)}}};")
    # The loop that reaches farthest is the outer one.
    outer = max(range(len(loops)), key=lambda i: max(vertices[v][0] for v in loops[i]))
    order = [outer] + [i for i in range(len(loops)) if i != outer]
    lines.append(f"Plane Surface(1) = {{{', '.join(str(i + 1) for i in order)}}};")
    if size == 0.0:
        lines.append(f"Transfinite Curve {{1:{len(edges)}}} = 2;")
    return lines


def annulus_geometry():
    lines = ["Point(1) = {0, 0, 0};"]
    for k, radius in enumerate((2, 1)):
        p = 10 * (k + 1)
        for i, (x, y) in enumerate(((1, 0), (0, 1), (-1, 0), (0, -1))):
            lines.append(f"Point({p + i}) = {{{radius * x}, {radius * y}, 0}};")
        for i in range(4):
            lines.append(f"Circle({p + i}) = {{{p + i}, 1, {p + (i + 1) % 4}}};")
        lines.append(f"Curve Loop({k + 1}) = {{{', '.join(str(p + i) for i in range(4))}}};")
    return lines + ["Plane Surface(1) = {1, 2};"]


def run_gmsh(geometry, size, algorithm, folder):
    """Counts, angles and CPU seconds of Gmsh's own log."""
    options = ["Mesh.MeshSizeFromPoints = 0;"]
    if size > 0.0:
        options += [f"Mesh.MeshSizeMin = {size!r};", f"Mesh.MeshSizeMax = {size!r};"]
    source = folder / "domain.geo"
    source.write_text("\n".join(geometry + options) + "\n", encoding="ascii")
    target = folder / "domain.msh"
    done = subprocess.run(["gmsh", "-2", "-nt", "1", "-v", "5", "-algo", algorithm, "-format", "msh22", "-o", target, source],
                          capture_output=True, text=True, check=False, timeout=3600)
    seconds = re.search(r"Done meshing 2D \(Wall [\d.e+-]+s, CPU ([\d.e+-]+)s\)", done.stdout)
    if done.returncode != 0 or seconds is None or re.search(r"^Error", done.stdout, re.MULTILINE):
        return None
    result = read_mesh(target)
    result["cpu_seconds"] = float(seconds.group(1))
    return result


def read_mesh(path):
    """Number of vertices and triangles and the range of angles of a Gmsh 2.2 file."""
    nodes, used, triangles = {}, set(), 0
    smallest, largest = 180.0, 0.0
    with path.open(encoding="ascii") as file:
        for line in file:
            if line.startswith("$Nodes"):
                for _ in range(int(next(file))):
                    words = next(file).split()
                    nodes[words[0]] = (float(words[1]), float(words[2]))
            if line.startswith("$Elements"):
                for _ in range(int(next(file))):
                    words = next(file).split()
                    if words[1] != "2":
                        continue
                    triangles += 1
                    corners = words[-3:]
                    used.update(corners)
                    a, b, c = (nodes[corner] for corner in corners)
                    angles = angles_of(a, b, c)
                    smallest = min(smallest, *angles)
                    largest = max(largest, *angles)
    return {"vertices": len(used), "triangles": triangles, "min_angle": smallest, "max_angle": largest}


def angles_of(a, b, c):
    squares = [math.dist(b, c) ** 2, math.dist(c, a) ** 2, math.dist(a, b) ** 2]
    angles = []
    for i in range(3):
        p, q, r = squares[i], squares[i - 1], squares[i - 2]
        cosine = (q + r - p) / (2.0 * math.sqrt(q * r))
        angles.append(math.degrees(math.acos(max(-1.0, min(1.0, cosine)))))
    return angles


class Comparison:
    def __init__(self, programs, triangles, repeats, folder):
        self.programs = programs
        self.triangles = triangles
        self.repeats = repeats
        self.folder = folder

    def ours(self, domain, size, degrees=90.0):
        return run_json(self.programs / "planar_ours", "mesh", domain, size, degrees)

    def outline(self, domain, degrees):
        path = self.folder / f"{domain}_{degrees}.txt"
        segments = run_json(self.programs / "planar_ours", "outline", domain, degrees, path)["segments"]
        return path, segments

    def cgal(self, outline, size):
        return run_json(self.programs / "planar_peer_cgal", outline, size)

    def size_for(self, program, domain):
        return math.sqrt(TRIANGLES_PER_SQUARE[program] * AREAS[domain] / self.triangles)

    def speed_runs(self, domain):
        """One run of each program on the domain at the wanted number of triangles: (name, run) pairs."""
        # CGAL's annulus comes with edges of the wanted size, as one would cut it by hand.
        degrees = {"square": 90.0, "annulus": math.degrees(self.size_for("cgal", domain)),
                   "airfoil": DENSE_DEGREES}[domain]
        outline, _ = self.outline(domain, degrees)
        runs = [("this mesher", lambda: self.ours(domain, self.size_for("ours", domain))),
                ("CGAL Delaunay_mesh_2", lambda: self.cgal(outline, self.size_for("cgal", domain)))]
        for algorithm, name in GMSH_ALGORITHMS.items():
            size = self.size_for(algorithm, domain)
            geometry = annulus_geometry() if domain == "annulus" else polyline_geometry(outline, size)
            runs.append((name, lambda a=algorithm, g=geometry, s=size: run_gmsh(g, s, a, self.folder)))
        return runs

    def speed(self, domain):
        """Rows (name, best result) of the domain."""
        runs = self.speed_runs(domain)
        best = {}
        for _ in range(self.repeats):
            for name, run in runs:
                result = run()
                if result is None:
                    best.setdefault(name, None)
                elif best.get(name) is None or result["cpu_seconds"] < best[name]["cpu_seconds"]:
                    best[name] = result
        return [(name, best[name]) for name, _ in runs]

    def vertices(self):
        """Rows (name, segments given, result) of the three-element airfoil, refined for quality alone."""
        rows = []
        for text, degrees in (("π/2", 90.0), ("π/3", 60.0), ("π/6", 30.0)):
            rows.append((f"this mesher, exact splines, TV = {text}", None, self.ours("airfoil", 0.0, degrees)))
        for degrees in (30.0, 15.0, 10.0, DENSE_DEGREES):
            outline, segments = self.outline("airfoil", degrees)
            name = f"polylines that turn by {degrees:g}° a segment"
            rows.append((f"CGAL Delaunay_mesh_2, {name}", segments, self.cgal(outline, 0.0)))
            rows.append((f"Gmsh Frontal-Delaunay, {name}", segments,
                         run_gmsh(polyline_geometry(outline, 0.0), 0.0, "front2d", self.folder)))
        return rows


def vertices_table(rows):
    lines = ["| mesher and input | segments given | vertices | triangles | smallest angle | largest angle |",
             "|---|---:|---:|---:|---:|---:|"]
    for name, segments, result in rows:
        given = "" if segments is None else str(segments)
        if result is None:
            lines.append(f"| {name} | {given} | refused: the polylines cross | | | |")
        else:
            lines.append(f"| {name} | {given} | {result['vertices']} | {result['triangles']} | "
                         f"{result['min_angle']:.1f} | {result['max_angle']:.1f} |")
    return lines


def speed_table(rows_of):
    lines = ["| domain | mesher | triangles | CPU seconds | triangles per CPU second | times slower | bytes per triangle |",
             "|---|---|---:|---:|---:|---:|---:|"]
    for domain, rows in rows_of.items():
        ours = rows[0][1]
        for name, result in rows:
            if result is None:
                lines.append(f"| {SPEED_DOMAINS[domain]} | {name} | failed | | | | |")
                continue
            rate = result["triangles"] / result["cpu_seconds"]
            slower = ours["triangles"] / ours["cpu_seconds"] / rate
            memory = f"{result['peak_bytes_per_triangle']:.0f}" if "peak_bytes_per_triangle" in result else ""
            lines.append(f"| {SPEED_DOMAINS[domain]} | {name} | {result['triangles']} | {result['cpu_seconds']:.2f} | "
                         f"{rate:,.0f} | {slower:.1f} | {memory} |")
    return lines


def share_table(rows_of):
    lines = ["| domain | sampling and enrichment, share of the time | mesh, bytes per triangle |", "|---|---:|---:|"]
    for domain, rows in rows_of.items():
        ours = rows[0][1]
        lines.append(f"| {SPEED_DOMAINS[domain]} | {100.0 * ours['enrichment_share']:.3f} % | "
                     f"{ours['mesh_bytes_per_triangle']:.0f} |")
    return lines


def page(comparison):
    vertex_rows = comparison.vertices()
    rows_of = {domain: comparison.speed(domain) for domain in SPEED_DOMAINS}
    at = {degrees: row[2]["vertices"] for degrees, row in zip((90, 60, 30), vertex_rows)}
    fewer = 100.0 * (1.0 - at[90] / at[30])
    return [
        "# The planar mesher beside its peers", "",
        "Written by `tests/benchmarks/planar/compare_planar.py build/release/bin --write docs/benchmarks/planar.md`. "
        "One thread; all rows in one", "run on one machine, so ratios tell more than seconds.", "",
        "## Vertices on curves", "",
        f"The three-element airfoil of [examples.md](../examples.md), bound {BOUND:g}°, no sizes. With the exact curves and "
        f"subcurves that turn by up to", f"π/2 it takes {fewer:.1f} % fewer vertices than with π/6. Peers are given "
        "polylines; coarse ones cross each other where slat, cove and", "tail are thin, and are no domain at all. Gmsh has no "
        "bound on angles: it keeps each segment and grades from there.", "",
        *vertices_table(vertex_rows), "",
        "## Speed at a million triangles", "",
        "A uniform size, bound 30°. Sizes are chosen so that each program makes about as many triangles. \"Times slower\": "
        "triangles per second of", "this mesher over the row's. Bytes: growth of the peak resident memory over triangles.",
        "", *speed_table(rows_of), "", *share_table(rows_of)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=Path)
    parser.add_argument("--triangles", type=int, default=1_000_000)
    parser.add_argument("--repeats", type=int, default=2)
    parser.add_argument("--write", type=Path)
    arguments = parser.parse_args()
    if shutil.which("gmsh") is None:
        sys.exit("compare_planar.py: there is no program gmsh")
    with tempfile.TemporaryDirectory() as folder:
        lines = page(Comparison(arguments.programs.resolve(), arguments.triangles, arguments.repeats, Path(folder)))
    text = "\n".join(lines) + "\n"
    if arguments.write is None:
        print(text, end="")
    else:
        arguments.write.parent.mkdir(parents=True, exist_ok=True)
        arguments.write.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()

#!/usr/bin/python3
"""Prints what a report of `mesher mesh --report` tells, as a small table.

    show_report.py REPORT.json     exit 0, 2 wrong usage or no report
"""
import json
import sys


def rows_of(report):
    counts, quality = report["counts"], report["quality"]
    yield "status", report["status"]
    for key in ("vertices", "lines", "triangles", "tets"):
        if counts.get(key):
            yield key, f"{counts[key]:,}"
    if quality:
        kind = "dihedral" if "min_dihedral" in quality else "angle"
        yield "angles", f"{quality['min_' + kind]:.2f} to {quality['max_' + kind]:.2f} degrees"
        yield "radius ratio", f"least {quality['min_radius_ratio']:.3f}, mean {quality['mean_radius_ratio']:.3f}"
        total = sum(quality[kind + "_histogram"])
        for i, count in enumerate(quality[kind + "_histogram"]):
            if count:
                yield f"  {10 * i:3} to {10 * i + 10:3}", f"{'#' * max(1, round(60 * count / total))} {100 * count / total:.1f} %"
    if report["model"]["area"] is not None:
        yield "area", f"{report['mesh']['area']:.6g}, of the model {report['model']['area']:.6g} {report['model']['unit']}^2"
    if report["model"]["volume"] is not None:
        yield "volume", f"{report['mesh']['volume']:.6g}, of the model {report['model']['volume']:.6g} {report['model']['unit']}^3"
    for stage, seconds in report["seconds"].items():
        yield stage.replace("_", " "), f"{seconds:.3f} s"
    yield "mesh hash", report["mesh_hash"]


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        with open(arguments[0], encoding="utf-8") as file:
            rows = list(rows_of(json.load(file)))
    except (OSError, ValueError, KeyError, TypeError) as error:
        print(f"show_report: {arguments[0]}: no report of mesher ({error})", file=sys.stderr)
        return 2
    for key, value in rows:
        print(f"{key:22} {value}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

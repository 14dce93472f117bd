#!/usr/bin/python3
"""Refuses what does not belong into the repository: paths of one machine, build products, large files,
unfinished work and untidy text. Looks at the tracked files, or in an unpacked archive at all outside of build/.

    check_tree.py [ROOT]     exit 0 nothing found, 1 findings on stdout, 2 wrong usage
"""
import re
import subprocess
import sys
from pathlib import Path

LARGEST_FILE = 1_000_000
BUILD_PRODUCTS = {".o", ".a", ".so", ".pyc", ".orig", ".rej", ".log"}
LINE_RULES = [
    # The first letter of each name is in brackets so that this file is not found by its own rules.
    (re.compile(r"(?<![\w./$}-])/([w]ork|[h]ome|[r]oot|[U]sers|[t]mp)/"), "names a folder of one machine"),
    (re.compile(r"\b([T]ODO|[F]IXME|[X]XX)\b"), "marks unfinished work"),
    (re.compile(r"[ \t]+$"), "ends in blanks"),
    (re.compile(r"\t"), "contains a tab"),
    (re.compile(r"\r"), "ends in a carriage return"),
    (re.compile(r"^([<]{7}|[>]{7})( |$)"), "is left from a merge conflict"),
]
VERBATIM_FILES = {"LICENSE"}
VERBATIM_SUFFIXES = {".brep", ".step"}  # models as the CAD kernel writes them


def names_to_check(root):
    if not (root / ".git").exists():
        paths = (path.relative_to(root) for path in root.rglob("*") if path.is_file())
        return sorted(path.as_posix() for path in paths if path.parts[0] != "build")
    command = ["git", "-c", "safe.directory=*", "-C", str(root), "ls-files", "-z"]
    names = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split("\0")[:-1]
    return [name for name in names if (root / name).is_file()]


def check_file(root, name):
    path = root / name
    if path.suffix in BUILD_PRODUCTS:
        return [f"{name}: looks like a build product"]
    content = path.read_bytes()
    if len(content) > LARGEST_FILE:
        return [f"{name}: is larger than {LARGEST_FILE} bytes"]
    if name in VERBATIM_FILES or path.suffix in VERBATIM_SUFFIXES or b"\0" in content:
        return []
    findings = []
    if content and not content.endswith(b"\n"):
        findings.append(f"{name}: does not end in a line break")
    for number, line in enumerate(content.decode("utf-8").split("\n"), start=1):
        findings += [f"{name}:{number}: {complaint}" for rule, complaint in LINE_RULES if rule.search(line)]
    return findings


def main(arguments):
    if len(arguments) > 1:
        print(__doc__, file=sys.stderr)
        return 2
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent
    names = names_to_check(root)
    findings = [finding for name in names for finding in check_file(root, name)]
    for finding in findings:
        print(finding)
    if not findings:
        print(f"tree: {len(names)} files are clean")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

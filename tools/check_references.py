#!/usr/bin/python3
"""Verifies that every [key] that a comment of MesherCore cites is an entry of docs/references.bib.

    check_references.py [ROOT]     exit 0 nothing found, 1 findings on stdout, 2 wrong usage
"""
import re
import sys
from pathlib import Path

ENTRY = re.compile(r"^@\w+\{\s*([^,\s]+)\s*,", re.MULTILINE)
COMMENT = re.compile(r"//.*")
# A key ends in a year; the thesis that everything follows has a key without one.
CITATION = re.compile(r"\[([A-Za-z]+\d{4}[a-z]?|gosselin)\]")


def main(arguments):
    if len(arguments) > 1:
        print(__doc__, file=sys.stderr)
        return 2
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent
    keys = ENTRY.findall((root / "docs" / "references.bib").read_text(encoding="utf-8"))
    findings = [f"docs/references.bib: '{key}' has two entries" for key in sorted(set(keys)) if keys.count(key) > 1]
    citations = 0
    for path in sorted((root / "MesherCore").rglob("*")):
        if path.suffix not in {".h", ".cpp"}:
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), start=1):
            for comment in COMMENT.findall(line):
                for key in CITATION.findall(comment):
                    citations += 1
                    if key not in keys:
                        where = path.relative_to(root).as_posix()
                        findings.append(f"{where}:{number}: [{key}] is not in docs/references.bib")
    for finding in findings:
        print(finding)
    if not findings:
        print(f"references: {citations} citations are in docs/references.bib")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

"""check_references.py must accept citations that have an entry and refuse those that have none."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "tools" / "check_references.py"
BIBLIOGRAPHY = "@article{lawson1977,\n  year = 1977\n}\n@phdthesis{gosselin,\n}\n"


class CheckReferences(unittest.TestCase):
    def run_on(self, header, bibliography=BIBLIOGRAPHY):
        with tempfile.TemporaryDirectory() as root:
            for name, text in {"MesherCore/base/a.h": header, "docs/references.bib": bibliography}.items():
                path = Path(root, name)
                path.parent.mkdir(parents=True)
                path.write_text(text, encoding="utf-8")
            run = subprocess.run([sys.executable, str(SCRIPT), root], capture_output=True, text=True, check=False)
        self.assertEqual(run.stderr, "")
        return run.returncode, run.stdout

    def test_accepts_known_keys_and_what_is_no_citation(self):
        status, output = self.run_on("/// Reference  [lawson1977] [gosselin] §1\nint a[size2000];  // see a[i]\n")
        self.assertEqual((status, output), (0, "references: 2 citations are in docs/references.bib\n"))

    def test_refuses_unknown_keys(self):
        for key in ("lawson1978", "Lawson1977", "lawson1977b"):
            status, output = self.run_on(f"\n/// Reference  [{key}]\n")
            self.assertEqual((status, output), (1, f"MesherCore/base/a.h:2: [{key}] is not in docs/references.bib\n"))

    def test_refuses_two_entries_of_one_key(self):
        status, output = self.run_on("", BIBLIOGRAPHY + "@misc{gosselin,\n}\n")
        self.assertEqual(status, 1)
        self.assertIn("'gosselin' has two entries", output)


if __name__ == "__main__":
    unittest.main()

"""check_tree.py must accept a clean repository and refuse each kind of stray content."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "tools" / "check_tree.py"


class CheckTree(unittest.TestCase):
    def run_on(self, files, untracked=None):
        """`untracked` names files that git does not know; without it the tree is no repository."""
        with tempfile.TemporaryDirectory() as root:
            for name, content in files.items():
                path = Path(root, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
            if untracked is not None:
                tracked = [name for name in files if name not in untracked]
                subprocess.run(["git", "init", "--quiet", root], check=True)
                subprocess.run(["git", "-C", root, "add", *tracked], check=True)
            run = subprocess.run([sys.executable, str(SCRIPT), root], capture_output=True, text=True, check=False)
        self.assertEqual(run.stderr, "")
        return run.returncode, run.stdout

    def assert_refused(self, name, content, complaint):
        status, output = self.run_on({name: content})
        self.assertEqual(status, 1, output)
        self.assertIn(name, output)
        self.assertIn(complaint, output)

    def test_accepts_a_clean_tree(self):
        files = {"a.cpp": b"int a;\n", "b.txt": b"see docs/home/page, /usr/bin/python3 and \"$HOME/x\"\n",
                 "build/x.o": b"\0", "data.bin": b"\0\t\0"}
        expected = (0, "tree: 3 files are clean\n")
        self.assertEqual(self.run_on(files), expected)
        self.assertEqual(self.run_on(files, untracked={"build/x.o"}), expected)

    def test_refuses_paths_of_one_machine(self):
        for folder in (b"work", b"home", b"root", b"tmp"):
            self.assert_refused("a.txt", b"first\nin /" + folder + b"/someone/x\n", "a.txt:2: names a folder")

    def test_refuses_unfinished_work(self):
        self.assert_refused("a.cpp", b"// TO" + b"DO later\n", "unfinished")
        self.assert_refused("a.cpp", b"<" * 7 + b" HEAD\n", "merge conflict")

    def test_refuses_untidy_text(self):
        self.assert_refused("a.txt", b"x \n", "ends in blanks")
        self.assert_refused("a.txt", b"\tx\n", "tab")
        self.assert_refused("a.txt", b"x\r\n", "carriage return")
        self.assert_refused("a.txt", b"x", "line break")

    def test_refuses_build_products_and_large_files(self):
        self.assert_refused("lib.a", b"x\n", "build product")
        self.assert_refused("a.txt", b"x\n" * 600_000, "larger")

    def test_looks_at_tracked_files_of_a_repository_only(self):
        files = {"a.txt": b"x\n", "notes.txt": b"untidy "}
        self.assertEqual(self.run_on(files, untracked={"notes.txt"}), (0, "tree: 1 files are clean\n"))
        self.assertEqual(self.run_on(files, untracked={})[0], 1)


if __name__ == "__main__":
    unittest.main()

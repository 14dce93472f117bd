"""setup.sh in releases of all kinds: programs that stand in for those of Debian know which packages there are."""
import os
import shutil
import subprocess
import tempfile
import textwrap
import unittest

TOOLS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools")

# INSTALLED and KNOWN are files with a package a line; LOG gets what apt-get is asked to do.
STAND_INS = {
    "dpkg-query": """
        sed 's/$/ installed/' "$INSTALLED"
        """,
    "apt-cache": """
        case $1 in
            policy)
                shift
                for name; do
                    grep -qx "$name" "$KNOWN" && printf '%s:\n  Candidate: 1.0\n' "$name" || printf '%s:\n  Candidate: (none)\n' "$name"
                done
                # Whoever stops reading early would end a real one.
                seq 100000 || exit 141
                ;;
            depends) [ "$2" = freecad-python3 ] && echo "  Depends: $QT" ;;
        esac
        exit 0
        """,
    "apt-get": """
        echo "$@" >>"$LOG"
        case "$*" in
            *--simulate*) exit 0 ;;
            *update*) [ -z "$UPDATED" ] || cp "$UPDATED" "$KNOWN"; exit 0 ;;
        esac
        is_behind=no
        for word in "$@"; do
            [ $is_behind = no ] || case $word in -*) ;; *) [ "$word" != "$BROKEN" ] || exit 100; echo "$word" >>"$INSTALLED" ;; esac
            [ "$word" != install ] || is_behind=yes
        done
        """,
    "id": "echo 0",
}
PACKAGES = """
[build]
compiler      # a comment
tool | tool-of-old

[workbench]
freecad-python3
old-qt, where freecad-python3 needs libqt5
new-qt, where freecad-python3 needs libqt6

[solver]
solver

[checks]
format-14
other
"""


class Setup(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.directory)
        for name, text in STAND_INS.items():
            path = self.place(name)
            with open(path, "w") as file:
                file.write("#!/bin/sh\n" + textwrap.dedent(text))
            os.chmod(path, 0o755)
        shutil.copy(os.path.join(TOOLS, "setup.sh"), self.place("setup.sh"))
        self.write("packages.txt", PACKAGES)

    def place(self, name):
        return os.path.join(self.directory, name)

    def write(self, name, text):
        with open(self.place(name), "w") as file:
            file.write(text)

    def run_setup(self, *arguments, known, installed=(), updated=None, qt="libqt6widgets6", broken=""):
        """(status, what is told, packages there are then, what apt-get was asked)."""
        self.write("known", "".join(f"{name}\n" for name in known))
        self.write("installed", "".join(f"{name}\n" for name in installed))
        self.write("log", "")
        if updated is not None:
            self.write("updated", "".join(f"{name}\n" for name in updated))
        environment = {"PATH": f"{self.directory}:/usr/bin:/bin", "KNOWN": self.place("known"), "INSTALLED": self.place("installed"),
                       "LOG": self.place("log"), "UPDATED": self.place("updated") if updated is not None else "", "QT": qt,
                       "BROKEN": broken, "MESHER_SETUP_PAUSE": "0"}
        done = subprocess.run([self.place("setup.sh"), *arguments], env=environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60)
        with open(self.place("installed")) as file:
            there = set(file.read().split())
        with open(self.place("log")) as file:
            return done.returncode, done.stdout, there, file.read()

    def test_all_that_is_known(self):
        status, _, there, _ = self.run_setup("build", "workbench", known=("compiler", "tool", "tool-of-old", "freecad-python3", "new-qt"))
        self.assertEqual((status, there), (0, {"compiler", "tool", "freecad-python3", "new-qt"}))

    def test_the_name_of_another_release(self):
        status, _, there, _ = self.run_setup("build", known=("compiler", "tool-of-old"))
        self.assertEqual((status, there), (0, {"compiler", "tool-of-old"}))

    def test_any_of_the_names_will_do(self):
        status, told, _, log = self.run_setup("build", known=("tool",), installed=("compiler", "tool-of-old"))
        self.assertEqual((status, told, log), (0, "", ""))

    def test_the_qt_of_freecad(self):
        known = ("freecad-python3", "old-qt", "new-qt")
        for qt, package in (("libqt5widgets5t64", "old-qt"), ("libqt6widgets6", "new-qt")):
            status, _, there, _ = self.run_setup("workbench", known=known, qt=qt)
            self.assertEqual((status, there), (0, {"freecad-python3", package}))

    def test_what_is_optional_may_be_missing_and_is_told(self):
        status, told, there, _ = self.run_setup("build", "--optional", "solver", "checks", known=("compiler", "tool", "other"))
        self.assertEqual((status, there), (0, {"compiler", "tool", "other"}))
        self.assertRegex(told, "left out: solver format-14\n")

    def test_what_is_optional_may_be_broken(self):
        status, told, there, _ = self.run_setup("build", "--optional", "solver", "checks", known=("compiler", "tool", "solver", "other"),
                                                broken="solver")
        self.assertEqual((status, there), (0, {"compiler", "tool", "other"}))
        self.assertRegex(told, "left out: format-14 solver\n")

    def test_what_is_needed_may_not(self):
        status, told, there, _ = self.run_setup("build", "solver", known=("compiler", "tool"))
        self.assertEqual((status, there), (1, set()))
        self.assertIn("no package solver", told)
        status, told, _, _ = self.run_setup("build", known=("compiler", "tool"), broken="tool")
        self.assertEqual(status, 1)
        self.assertIn("could not install", told)

    def test_lists_are_read_where_there_are_none(self):
        status, _, there, log = self.run_setup("build", known=(), updated=("compiler", "tool"))
        self.assertEqual((status, there), (0, {"compiler", "tool"}))
        self.assertIn("update", log)

    def test_section_that_is_not_there(self):
        status, told, _, _ = self.run_setup("bild", known=("compiler", "tool"))
        self.assertEqual(status, 2)
        self.assertIn("[bild]", told)

    def test_sections_of_the_project(self):
        shutil.copy(os.path.join(TOOLS, "packages.txt"), self.place("packages.txt"))
        with open(self.place("packages.txt")) as file:
            names = {word for line in file if line.strip() and line[0] not in "#["
                     for word in line.split("#")[0].split(", where")[0].replace("|", " ").split()}
        status, _, there, _ = self.run_setup(known=names - {"calculix-ccx", "clang-format-14", "libtet1.5-dev"})
        self.assertEqual(status, 0)
        self.assertIn("libtet-dev", there)
        self.assertIn("qt6-base-dev", there)
        self.assertNotIn("qtbase5-dev", there)


if __name__ == "__main__":
    unittest.main()

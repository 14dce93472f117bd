"""Builds the package of Debian, unpacks it and uses what is in it: test_package.py BUILD_DIRECTORY PLANE_MODEL."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD_DIRECTORY, MODEL = sys.argv[1:3]
MODULE = "usr/lib/mesher/Mod/Mesher"

WORKBENCH_MACRO = """
import sys, traceback
status = 1
try:
    import FreeCAD, Part
    import mesher, MesherWorkbench
    root = sys.argv[-1]
    for module in (mesher, MesherWorkbench):
        assert module.__file__.startswith(root), module.__file__
    box = FreeCAD.newDocument().addObject("Part::Box", "Box")
    box.Document.recompute()
    mesh = MesherWorkbench.make_mesh(box, size=5.0)
    assert mesh.FemMesh.TetraCount == mesh.ElementCount > 20, mesh.ElementCount
    status = 0
except BaseException:
    traceback.print_exc()
sys.exit(status)
"""


def run(*command, environment=None):
    """What the command tells; a failure shows it."""
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env={**os.environ, "PATH": "/usr/bin:/bin", **(environment or {})}, timeout=200)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(command)} ends with {done.returncode}:\n{done.stdout}")
    return done.stdout


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.directory)
        made = os.path.join(cls.directory, "made")
        run("cpack", "--config", os.path.join(BUILD_DIRECTORY, "CPackConfig.cmake"), "-B", made)
        packages = [name for name in os.listdir(made) if name.endswith(".deb")]
        assert len(packages) == 1, packages
        cls.package = os.path.join(made, packages[0])
        cls.root = os.path.join(cls.directory, "root")
        run("dpkg-deb", "--extract", cls.package, cls.root)

    def inside(self, path):
        return os.path.join(self.root, path)

    def test_names_what_it_needs(self):
        depends = run("dpkg-deb", "--field", self.package, "Depends")
        needed = set(re.findall(r"(?:^|, )([a-z0-9.+-]+)", depends))
        # Names of libraries end in their version.
        for package in ("python3", "python3-numpy", "libocct-modeling-data-", "libqt[56]widgets", r"libstdc\+\+6", "libc6"):
            self.assertTrue(any(re.match(package, name) for name in needed), f"{package} is not in {depends}")
        for program in ("gmsh", "netgen", "cgal", "tetgen", "libtet"):
            self.assertNotIn(program, depends)
        self.assertIn("freecad", run("dpkg-deb", "--field", self.package, "Recommends"))

    def test_version_tells_the_release(self):
        version = run("dpkg-deb", "--field", self.package, "Version").strip()
        with open("/etc/os-release") as file:
            release = re.search(r'^VERSION_ID="?([0-9.]+)', file.read(), re.MULTILINE)
        self.assertRegex(version, rf"^[0-9.]+-1~deb{release[1]}$" if release else r"^[0-9.]+-1$")

    def test_has_everything_and_nothing_of_the_build(self):
        for path in ("usr/bin/mesher", f"{MODULE}/InitGui.py", f"{MODULE}/package.xml",
                     f"{MODULE}/MesherWorkbench/factory.py", f"{MODULE}/Resources/icons/MesherWorkbench.svg",
                     f"{MODULE}/mesher/__init__.pyi", "usr/share/doc/mesher/copyright", "usr/share/doc/mesher/README.md",
                     "usr/share/doc/mesher/docs/architecture.md", "usr/share/mesher/demos/bracket.step"):
            self.assertTrue(os.path.isfile(self.inside(path)), path)
        for directory, _, names in os.walk(self.root):
            for name in names:
                self.assertNotRegex(name, r"\.(pyc|o|a|h|cmake)$", os.path.join(directory, name))

    def test_same_files_as_the_build(self):
        built = os.path.join(BUILD_DIRECTORY, "Mod", "Mesher")
        for directory, _, names in os.walk(self.inside(MODULE)):
            for name in names:
                if name.endswith(".so"):
                    continue  # stripped
                packed = os.path.join(directory, name)
                path = os.path.join(built, os.path.relpath(packed, self.inside(MODULE)))
                with open(packed, "rb") as one, open(path, "rb") as other:
                    self.assertEqual(one.read(), other.read(), path)

    def test_links_are_relative_and_lead_somewhere(self):
        for path in ("usr/share/freecad/Mod/Mesher", "usr/lib/python3/dist-packages/mesher"):
            self.assertFalse(os.path.isabs(os.readlink(self.inside(path))))
            self.assertTrue(os.path.isdir(self.inside(path)), path)

    def test_nothing_refers_to_where_it_was_built(self):
        place = os.path.abspath(BUILD_DIRECTORY).encode()
        for directory, _, names in os.walk(self.root):
            for name in names:
                with open(os.path.join(directory, name), "rb") as file:
                    self.assertNotIn(place, file.read(), name)

    def test_program(self):
        out = os.path.join(self.directory, "gasket.msh")
        run(self.inside("usr/bin/mesher"), "mesh", MODEL, "--dimension", "2", "--size", "10", "-o", out)
        self.assertGreater(os.path.getsize(out), 1000)

    def test_python(self):
        code = "import mesher, sys; print(len(mesher.mesh(sys.argv[1], dimension=2, size=10.0).triangles), mesher.__file__)"
        told = run("/usr/bin/python3", "-B", "-c", code, MODEL,
                   environment={"PYTHONPATH": self.inside("usr/lib/python3/dist-packages")}).split()
        self.assertGreater(int(told[0]), 50)
        self.assertTrue(told[1].startswith(self.root), told[1])

    def test_workbench(self):
        # The folder of all users cannot be moved; that of one user is scanned in the same way.
        profile = os.path.join(self.directory, "profile")
        os.makedirs(os.path.join(profile, "Mod"))
        os.symlink(self.inside("usr/share/freecad/Mod/Mesher"), os.path.join(profile, "Mod", "Mesher"))
        macro = os.path.join(self.directory, "use.FCMacro")
        with open(macro, "w") as file:
            file.write(WORKBENCH_MACRO)
        run("freecadcmd", macro, "--", self.directory,
            environment={"FREECAD_USER_HOME": profile, "PYTHONDONTWRITEBYTECODE": "1"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)

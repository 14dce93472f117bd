"""A checkout in FreeCAD's folder of add-ons, before and after it is built: test_addon.py CHECKOUT BUILD_DIRECTORY."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

CHECKOUT, BUILD_DIRECTORY = sys.argv[1:3]
NAMES = {"": "https://wiki.freecad.org/Package_Metadata"}
MACRO = """
import sys, traceback
status = 1
try:
    import mesher, MesherWorkbench
    print("found", mesher.__file__, "unit tests", "TestMesherApp" in FreeCAD.__unit_test__)
    status = 0
except BaseException:
    traceback.print_exc()
sys.stdout.flush()
sys.exit(status)
"""


class AddOn(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.directory)
        self.checkout = os.path.join(self.directory, "Mod", "Mesher")
        os.makedirs(os.path.join(self.checkout, "build"))
        shutil.copy(os.path.join(CHECKOUT, "package.xml"), self.checkout)
        shutil.copytree(os.path.join(CHECKOUT, "packaging", "addon"), os.path.join(self.checkout, "packaging", "addon"))
        self.macro = os.path.join(self.directory, "look.FCMacro")
        with open(self.macro, "w") as file:
            file.write(MACRO)

    def look(self):
        return subprocess.run(["freecadcmd", self.macro], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, timeout=200, env={**os.environ, "PATH": "/usr/bin:/bin", "PYTHONDONTWRITEBYTECODE": "1",
                                                           "FREECAD_USER_HOME": self.directory})

    def test_before_it_is_built(self):
        self.assertIn(f"Run {os.path.join(self.checkout, 'run.sh')}", self.look().stdout)

    def test_after_it_is_built(self):
        os.symlink(BUILD_DIRECTORY, os.path.join(self.checkout, "build", "release"))
        done = self.look()
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertRegex(done.stdout, rf"found {re.escape(self.checkout)}/build/release/Mod/Mesher/\S+ unit tests True")
        self.assertNotIn("not built", done.stdout)

    def test_tells_the_same_as_the_workbench(self):
        both = [xml.parse(path).getroot() for path in (os.path.join(CHECKOUT, "package.xml"),
                                                       os.path.join(BUILD_DIRECTORY, "Mod", "Mesher", "package.xml"))]
        for name in ("name", "version", "license", ".//classname", ".//freecadmin"):
            one, other = (root.find(name, NAMES).text for root in both)
            self.assertEqual(one, other, name)
        content = both[0].find(".//workbench", NAMES)
        folder = os.path.join(CHECKOUT, content.find("subdirectory", NAMES).text)
        self.assertTrue(os.path.isfile(os.path.join(folder, "InitGui.py")))
        self.assertTrue(os.path.isfile(os.path.join(folder, content.find("icon", NAMES).text)))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)

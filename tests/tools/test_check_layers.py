"""check_layers.py must accept a sound tree and refuse each kind of wrong include."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "tools" / "check_layers.py"

SOUND_TREE = {
    "MesherCore/CMakeLists.txt": "# lowest first\nadd_subdirectory(base)\nadd_subdirectory(middle)\nadd_subdirectory(top)\n",
    "MesherCore/base/CMakeLists.txt": "mesher_layer(base SOURCES a.cpp)\n",
    "MesherCore/base/a.h": "#pragma once\n#include <vector>\n#include <immintrin.h>\n",
    "MesherCore/base/a.cpp": '#include "base/a.h"\n',
    "MesherCore/middle/CMakeLists.txt": "mesher_layer(middle SOURCES b.cpp USES base)\n",
    "MesherCore/middle/b.h": '#include "base/a.h"\n',
    "MesherCore/top/CMakeLists.txt": "mesher_layer(top\n  SOURCES c.cpp\n  USES middle)\n",
    "MesherCore/top/c.cpp": '#include "middle/b.h"\n',
    "tests/benchmarks/compare/peer.cpp": "#include <CGAL/Delaunay_triangulation_3.h>\n",
    "tests/unit/a_test.cpp": '#include "base/a.h"\n#include <CGAL/Simple_cartesian.h>\n',
}


class CheckLayers(unittest.TestCase):
    def run_on(self, changes):
        with tempfile.TemporaryDirectory() as root:
            for name, text in {**SOUND_TREE, **changes}.items():
                path = Path(root, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            run = subprocess.run([sys.executable, str(SCRIPT), root], capture_output=True, text=True, check=False)
        self.assertEqual(run.stderr, "")
        return run.returncode, run.stdout

    def assert_refused(self, changes, *parts):
        status, output = self.run_on(changes)
        self.assertEqual(status, 1, output)
        self.assertEqual(output.count("\n"), 1, output)
        for part in parts:
            self.assertIn(part, output)

    def test_accepts_a_sound_tree(self):
        status, output = self.run_on({})
        self.assertEqual((status, output), (0, "layers: 4 files of MesherCore keep to the layers\n"))

    def test_refuses_an_upward_include(self):
        self.assert_refused({"MesherCore/base/a.cpp": '\n#include "middle/b.h"\n'},
                            "MesherCore/base/a.cpp:2:", "'base' does not declare that it uses 'middle'")

    def test_refuses_a_layer_reached_only_through_another(self):
        self.assert_refused({"MesherCore/top/c.cpp": '#include "base/a.h"\n'}, "'top' does not declare")

    def test_refuses_to_declare_a_use_of_a_higher_layer(self):
        self.assert_refused({"MesherCore/base/CMakeLists.txt": "mesher_layer(base SOURCES a.cpp USES middle)\n"},
                            "'base' may not use 'middle'")

    def test_refuses_a_folder_that_is_no_layer(self):
        self.assert_refused({"MesherCore/extra/d.h": "#pragma once\n"}, "'extra' is not declared as a layer")

    def test_refuses_tests_in_the_core(self):
        self.assert_refused({"MesherCore/top/c.cpp": '#include "support/temp_dir.h"\n'}, "in no layer")

    def test_refuses_includes_not_written_from_the_root_of_the_core(self):
        self.assert_refused({"MesherCore/base/a.cpp": '#include "a.h"\n'}, "not written from MesherCore")
        self.assert_refused({"MesherCore/base/a.cpp": '#include "../base/a.h"\n'}, "not written from MesherCore")

    def test_refuses_a_header_that_does_not_exist(self):
        self.assert_refused({"MesherCore/base/a.cpp": '#include "base/gone.h"\n'}, "does not exist")

    def test_refuses_foreign_headers_in_the_core(self):
        for header in ("TopoDS_Shape.hxx", "tbb/parallel_for.h", "CGAL/Simple_cartesian.h", "gtest/gtest.h"):
            self.assert_refused({"MesherCore/top/c.cpp": f"# include <{header}>\n"}, f"<{header}>")

    def test_accepts_an_adapter_in_itself_and_in_its_users_only(self):
        tree = {
            "MesherCore/CMakeLists.txt": ("add_subdirectory(base)\nadd_subdirectory(brep)\nadd_subdirectory(middle)\n"
                                          "add_subdirectory(top)\nadd_subdirectory(cli)\n"),
            "MesherCore/brep/CMakeLists.txt": "mesher_layer(brep SOURCES e.cpp)\n",
            "MesherCore/middle/CMakeLists.txt": "mesher_layer(middle SOURCES b.cpp USES base brep)\n",
            "MesherCore/cli/CMakeLists.txt": "mesher_layer(cli SOURCES main.cpp USES brep)\n",
            "MesherCore/brep/occt/e.h": "#pragma once\n",
            "MesherCore/brep/occt/e.cpp": '#include "brep/occt/e.h"\n',
            "MesherCore/cli/main.cpp": '#include "brep/occt/e.h"\n',
        }
        status, output = self.run_on(tree)
        self.assertEqual(status, 0, output)
        refusal = "may not include the adapter 'brep/occt'"
        for place in ("brep/e.cpp", "brep/analytic/e.cpp", "middle/b.cpp"):
            with self.subTest(place=place):
                self.assert_refused({**tree, f"MesherCore/{place}": '#include "brep/occt/e.h"\n'}, f"MesherCore/{place}:1:", refusal)

    def test_accepts_occt_headers_in_their_folder_only(self):
        brep = {
            "MesherCore/CMakeLists.txt": SOUND_TREE["MesherCore/CMakeLists.txt"] + "add_subdirectory(brep)\n",
            "MesherCore/brep/CMakeLists.txt": "mesher_layer(brep SOURCES e.cpp)\n",
        }
        status, output = self.run_on({**brep, "MesherCore/brep/occt/e.h": "#include <TopoDS_Shape.hxx>\n"})
        self.assertEqual(status, 0, output)
        self.assert_refused({**brep, "MesherCore/brep/e.h": "#include <TopoDS_Shape.hxx>\n"}, "TopoDS_Shape.hxx")

    def test_refuses_gpl_headers_outside_of_the_peer_programs(self):
        self.assert_refused({"tests/unit/a_test.cpp": "#include <CGAL/Delaunay_triangulation_2.h>\n"}, "GPL")
        self.assert_refused({"examples/e.cpp": "#include <tetgen.h>\n"}, "GPL")

    def test_refuses_the_core_in_peer_programs(self):
        self.assert_refused({"tests/benchmarks/compare/peer.cpp": '#include <tetgen.h>\n#include "base/a.h"\n'},
                            "may not include the core")


if __name__ == "__main__":
    unittest.main()

"""compare_delaunay must print one sound JSON object per set and program, and on points in general position, where
the Delaunay triangulation is unique, every program must find the same number of simplices."""
import json
import subprocess
import sys
import unittest

PROGRAM = sys.argv[1]
PEERS = [name for name in sys.argv[2].split(",") if name]


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False)


class CompareDelaunay(unittest.TestCase):
    def assert_agreement(self, dimension, sets, programs):
        done = run("--points", "3000", "--repeats", "2", "--dimension", str(dimension), "--sets", ",".join(sets),
                   "--programs", ",".join(programs))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([(line["set"], line["program"]) for line in lines],
                         [(name, program) for name in sets for program in programs])
        for name in sets:
            counts = {line["program"]: (line["vertices"], line["simplices"]) for line in lines if line["set"] == name}
            self.assertEqual(len(set(counts.values())), 1, (name, counts))
        for line in lines:
            self.assertEqual((line["dimension"], line["points"], line["repeats"]), (dimension, 3000, 2))
            self.assertEqual((line["vertices"], line["scaffold"]), (3000, 0))
            self.assertLessEqual(line["cpu_seconds_min"], line["cpu_seconds"])
            self.assertLessEqual(line["cpu_seconds"], line["cpu_seconds_max"])
            self.assertGreater(line["simplices"], 5000)
            self.assertGreater(line["bytes_per_simplex"], 20)

    def test_programs_agree_in_general_position(self):
        self.assert_agreement(3, ["uniform", "torus", "sphere"], ["mesher_plain", *PEERS])
        self.assert_agreement(2, ["uniform", "clustered"], ["mesher", *(peer for peer in PEERS if peer != "tetgen")])

    def test_scaffold_points_are_told(self):
        done = run("--points", "20000", "--repeats", "1", "--dimension", "3", "--sets", "torus", "--programs", "mesher")
        line = json.loads(done.stdout)
        self.assertGreater(line["scaffold"], 0)
        self.assertEqual(line["vertices"], 20000 + line["scaffold"])

    @unittest.skipUnless("cgal" in PEERS, "CGAL was not found when this was built")
    def test_two_dimensions_leave_out_programs_of_three(self):
        done = run("--points", "1000", "--repeats", "1", "--dimension", "2", "--sets", "grid")
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([line["program"] for line in lines], ["mesher", "cgal"])
        self.assertEqual([line["vertices"] for line in lines], [1000, 1000])

    def test_wrong_arguments_are_refused(self):
        for arguments in (["--points"], ["--points", "0"], ["--points", "7x"], ["--programs", "other"],
                          ["--dimension", "4"], ["--unknown", "1"]):
            done = run(*arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""), arguments)
            self.assertIn("usage", done.stderr)

    def test_an_unknown_set_is_an_error(self):
        done = run("--points", "10", "--dimension", "3", "--sets", "none_such", "--programs", "mesher")
        self.assertEqual(done.returncode, 1)
        self.assertIn("none_such", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

#!/usr/bin/python3
"""What a run leaves that fails, runs into a limit or is cancelled: nothing, unless --keep-partial asks for what there is; never
half a file, and never a status that says that all is well.

    test_partial_results.py PROGRAM MODULE-FOLDER MODELS-FOLDER DEMOS-FOLDER [unittest options]
"""
import os
import signal
import subprocess
import time

from solid_case import MODELS, PROGRAM, Case, mesher, run_tests


class PartialResults(Case):
    def setUp(self):
        super().setUp()
        self.target = self.folder / "m.msh"

    def run_mesher(self, model, *arguments):
        return super().run_mesher(MODELS / f"{model}.brep", *arguments, "-o", "m.msh", "--report", "r.json")

    def count(self, name):
        """Elements by kind, of a file that the check finds no fault in."""
        run = subprocess.run([PROGRAM, "check", name], cwd=self.folder, capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        words = run.stdout.split("\n")[0].replace(",", "").split()
        return dict(zip(words[1::2], map(int, words[0::2])))

    def test_triangles_below_their_angle_are_told(self):
        run = self.run_mesher("needle_prism", "--dimension", 2, "--size", 0.3)
        self.assertEqual(run.returncode, 0)
        report = self.report()
        self.assertLess(report["quality"]["min_angle"], 11)
        places = report["left"]["places"]
        self.assertEqual(report["quality"]["min_angle"], min(place["min_angle"] for place in places))
        self.assertEqual({len(place["entities"]) for place in places}, {1})
        self.assertRegex(run.stderr, r"triangles at Face1, Face3, Face4, Face5 have angles below the 30 degrees .* small angle")

    def test_an_angle_out_of_reach_is_given_up(self):
        run = self.run_mesher("pin_in_bore", "--dimension", 2, "--size", 0.1, "--min-angle", 34)
        self.assertEqual(run.returncode, 0)
        self.assertRegex(run.stderr, r"34 degrees .* out of reach on Face\d.* 30 degrees were kept")
        self.assertGreaterEqual(self.report()["quality"]["min_angle"], 30 - 1e-6)

    def test_surfaces_of_solids_that_overlap(self):
        self.target.write_text("precious")
        refused = ("crossing_boxes", "--size", 0.3, "--overlap", "refuse")
        self.assertEqual(self.run_mesher(*refused).returncode, 1)
        self.assertEqual(self.target.read_text(), "precious")
        run = self.run_mesher(*refused, "--keep-partial")
        self.assertEqual(run.returncode, 1)
        self.assertIn("overlap", run.stderr)
        counts = self.count("m.msh")
        self.assertEqual(counts["tetrahedra"], 0)
        self.assertGreater(counts["triangles"], 200)
        self.assertEqual(self.report()["status"], "failed")

    def test_the_mesh_so_far_at_the_limit_of_elements(self):
        limit = 2000
        arguments = ("--size", 0.33, "--max-elements", limit)
        self.assertEqual(self.run_mesher("box_with_hole", *arguments).returncode, 1)
        self.assertFalse(self.target.exists())
        self.assertEqual(self.run_mesher("box_with_hole", *arguments, "--keep-partial").returncode, 1)
        counts = self.count("m.msh")
        self.assertGreater(counts["tetrahedra"], 500)
        self.assertLess(counts["tetrahedra"], 2 * limit)
        self.assertEqual(self.report()["stop_reason"], "element_limit")

    def test_the_mesh_so_far_at_the_limit_of_time(self):
        """Wherever the limit falls: there is a sound mesh, or none."""
        for seconds in (0.02, 0.1, 0.3, 0.8):
            with self.subTest(seconds=seconds):
                self.target.unlink(missing_ok=True)
                run = self.run_mesher("cut_ball", "--size", 0.06, "--timeout", seconds, "--keep-partial")
                self.assertEqual(run.returncode, 1, run.stderr)
                self.assertEqual(self.report()["stop_reason"], "time_limit")
                self.assertIn("time limit", run.stderr)
                if self.target.exists() and self.report()["counts"].get("tets", 0) > 0:
                    self.assertGreater(self.count("m.msh")["tetrahedra"], 0)

    def test_python_hands_out_what_there_is(self):
        if mesher is None:
            self.skipTest("the Python package is not built")
        with self.assertRaises(mesher.MeshingError) as failed:
            mesher.mesh(str(MODELS / "crossing_boxes.brep"), size=0.3, overlap="refuse")
        self.assertGreater(len(failed.exception.mesh.triangles), 200)
        self.assertEqual(len(failed.exception.mesh.tets), 0)

    def test_an_interrupt_leaves_the_old_file(self):
        for delay in (0.6, 1.0, 1.6):
            with self.subTest(delay=delay):
                self.target.write_text("precious")
                command = [PROGRAM, "mesh", MODELS / "loft.brep", "--size", "0.03", "--keep-partial", "-o", "m.msh"]
                with subprocess.Popen(command, cwd=self.folder, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL) as process:
                    time.sleep(delay)
                    process.send_signal(signal.SIGINT)
                    self.assertIn(b"cancelled", process.communicate(timeout=60)[1])
                self.assertEqual(process.returncode, 130)
                self.assertEqual(os.listdir(self.folder), ["m.msh"])
                self.assertEqual(self.target.read_text(), "precious")


if __name__ == "__main__":
    run_tests()

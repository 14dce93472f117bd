#!/usr/bin/python3
"""Files and status say the same: all outputs or none, whatever ends a run, and the report in every case.

    test_outputs.py PROGRAM DATA-FOLDER [unittest options]
"""
import json
import os
import resource
import signal
import subprocess
import threading
import time
import unittest

from program_case import DATA, PROGRAM, SANITIZED, Case, run_tests

BOX = ("mesh", DATA / "box.brep")
PLATE = ("mesh", DATA / "plate.brep", "--dimension", 2)


class Outputs(Case):
    def setUp(self):
        super().setUp()
        for name in ("a.msh", "b.vtu"):
            (self.folder / name).write_text("precious")
        self.outputs = ("-o", "a.msh", "-o", "b.vtu", "--report", "r.json")

    def limited(self, kind, limit, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=120, cwd=self.folder,
                              check=False, preexec_fn=lambda: resource.setrlimit(kind, (limit, limit)))

    def expect_untouched(self, others=("r.json",)):
        for name in ("a.msh", "b.vtu"):
            self.assertEqual((self.folder / name).read_text(), "precious")
        self.assertEqual(set(os.listdir(self.folder)), {"a.msh", "b.vtu", *others})

    def report(self):
        return json.loads((self.folder / "r.json").read_text())

    def test_a_limit_on_the_size_of_files(self):
        """The first output fits, the second does not. The signal of the limit is as the system has it."""
        self.expect(0, *BOX, "--size", 0.3, *self.outputs)
        sizes = [(self.folder / name).stat().st_size for name in ("a.msh", "b.vtu")]
        self.setUp()
        first, second = ("a.msh", "b.vtu") if sizes[0] < sizes[1] else ("b.vtu", "a.msh")
        run = self.limited(resource.RLIMIT_FSIZE, sum(sizes) // 2, *BOX, "--size", 0.3, "-o", first, "-o", second, "--report",
                           "r.json")
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertRegex(run.stderr, f"^mesher: {second}: .*large.*\n$")
        self.expect_untouched()
        self.assertEqual(self.report()["status"], "failed")

    def test_a_second_output_that_fails(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("there is no /dev/full")
        for outputs in (("-o", "a.msh", "-o", "/dev/full"), ("-o", "/dev/full", "-o", "a.msh")):
            self.expect(1, *BOX, "--size", 0.4, *outputs, "--format", "msh", "--format", "msh", "--report", "r.json")
            self.expect_untouched()
            self.assertIn("/dev/full", self.report()["failures"][0]["entity"])

    @unittest.skipIf(SANITIZED, "sanitizers reserve more memory than this")
    def test_memory_that_does_not_suffice(self):
        run = self.limited(resource.RLIMIT_AS, 400_000_000, *BOX, "--size", 0.02, *self.outputs)
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertIn("memory", run.stderr)
        self.expect_untouched()
        self.assertIn("memory", self.report()["failures"][0]["reason"])

    def started(self, *arguments):
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, stderr=subprocess.PIPE,
                                   stdout=subprocess.DEVNULL)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def test_a_signal_at_any_time_leaves_all_or_nothing(self):
        for delay in (0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6):
            with self.subTest(delay=delay):
                self.setUp()
                process = self.started(*BOX, "--size", 0.15, *self.outputs)
                time.sleep(0.05 + delay)
                process.send_signal(signal.SIGTERM)
                process.wait(timeout=60)
                if process.returncode == 0:
                    self.assertNotIn("precious", (self.folder / "a.msh").read_text() + (self.folder / "b.vtu").read_text())
                    self.assertEqual(self.report()["status"], "done")
                elif process.returncode == 130:
                    self.expect_untouched()
                    self.assertEqual(self.report()["status"], "cancelled")
                else:  # before the program had begun
                    self.assertEqual(process.returncode, -signal.SIGTERM)

    def test_two_signals_leave_a_report(self):
        process = self.started(*BOX, "--size", 0.02, *self.outputs)
        time.sleep(0.7)
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(timeout=60), 130)
        self.expect_untouched()
        self.assertEqual(self.report()["status"], "cancelled")

    def test_a_kill_leaves_nothing_behind(self):
        for delay in (0.2, 0.4, 0.6):
            process = self.started(*BOX, "--size", 0.12, "-o", f"{delay}.msh", "-o", f"{delay}.vtu", "--report", f"{delay}.json")
            time.sleep(delay)
            process.kill()
            process.wait()
            self.assertEqual([name for name in os.listdir(self.folder) if "partial" in name], [])

    def test_links_that_point_to_nothing_yet(self):
        os.symlink("made.msh", self.folder / "link.msh")
        self.expect(0, *BOX, "--size", 0.5, "-o", "link.msh")
        self.assertTrue((self.folder / "link.msh").is_symlink())
        self.assertIn("$MeshFormat", (self.folder / "made.msh").read_text())

    def test_pipes(self):
        os.mkfifo(self.folder / "pipe.msh")
        run = self.expect(1, *BOX, "--size", 0.5, "-o", "pipe.msh", "-o", "a.msh")
        self.assertRegex(run.stderr, "pipe.msh: is read by no program.*; .+")
        self.expect_untouched(("pipe.msh",))
        got = []
        reader = threading.Thread(target=lambda: got.append((self.folder / "pipe.msh").read_text()))
        reader.start()
        self.expect(0, *BOX, "--size", 0.2, "-o", "pipe.msh", "-o", "c.msh")
        reader.join()
        self.assertEqual(got[0], (self.folder / "c.msh").read_text())


class Wishes(Case):
    """What cannot be met is told before the run, which takes longer than these tests."""

    def test_are_refused_before_the_run(self):
        self.expect_refusal(2, "--curved-boundary is of plane faces", *BOX, "--size", 0.003, "-o", "m.msh", "--curved-boundary", "b.json")
        self.expect_refusal(2, "--faces: names what is meshed in two dimensions", *BOX, "--faces", "Face1", "--size", 0.003, "-o", "m.msh")
        self.expect_refusal(1, "--curved-boundary: is of faces in one plane", "mesh", DATA / "cylinder_wall.brep", "--dimension", 2,
                            "--size", 0.001, "-o", "m.msh", "--curved-boundary", "b.json")
        self.expect_refusal(1, "m.su2: Face1 is not at constant z", "mesh", DATA / "cylinder_wall.brep", "--dimension", 2,
                            "--size", 0.001, "-o", "m.su2")

    def test_are_met_where_they_can(self):
        self.expect(0, *PLATE, "--size", 0.4, "-o", "m.su2", "-o", "m.msh", "--curved-boundary", "b.json")


if __name__ == "__main__":
    run_tests()

#!/usr/bin/python3
"""Tests how ends of a run that it cannot tell itself are told: crashes, signals, and a run that does not listen.

    test_supervision.py PROGRAM DATA-FOLDER [unittest options]
"""
import json
import os
import signal
import subprocess
import time
import unittest
from pathlib import Path

from program_case import DATA, PROGRAM, SANITIZED, Case, run_tests

PATIENCE = 60  # seconds


class TestSupervision(Case):
    def start(self, *arguments):
        """A run of a minute or more, and the process in which it is."""
        waiting = subprocess.Popen([PROGRAM, "mesh", DATA / "plate.brep", "--dimension", "2", "--size", "0.0008", "-o", "m.msh",
                                    "--report", "r.json", *arguments], cwd=self.folder, stderr=subprocess.PIPE, text=True)
        self.addCleanup(waiting.stderr.close)
        self.addCleanup(waiting.wait)
        self.addCleanup(waiting.kill)
        children = Path(f"/proc/{waiting.pid}/task/{waiting.pid}/children")
        self.wait_for(lambda: children.read_text().split() and self.is_busy(int(children.read_text().split()[0])))
        return waiting, int(children.read_text().split()[0])

    @staticmethod
    def is_busy(process):
        """Beyond the start: it has used some time of the processor."""
        times = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
        return int(times[11]) + int(times[12]) > 20

    def wait_for(self, holds):
        end = time.monotonic() + PATIENCE
        while not holds():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)

    def expect_end(self, waiting, status, pattern):
        _, said = waiting.communicate(timeout=PATIENCE)
        self.assertEqual(waiting.returncode, status, said)
        self.assertRegex(said, pattern)
        self.assertNotIn("m.msh", os.listdir(self.folder))

    @unittest.skipIf(SANITIZED, "sanitizers tell crashes themselves")
    def test_a_crash_is_told_with_its_stage_and_in_the_report(self):
        waiting, run = self.start()
        os.kill(run, signal.SIGSEGV)
        self.expect_end(waiting, 1, r"^mesher: .*plate.brep: the run crashed \(Segmentation fault\), in the stage '.+'; .+\.\n$")
        report = json.loads((self.folder / "r.json").read_text())
        self.assertEqual(report["status"], "failed")
        self.assertIn("crashed", report["failures"][0]["reason"])

    def test_a_run_that_the_system_ends_is_told(self):
        waiting, run = self.start()
        os.kill(run, signal.SIGKILL)
        self.expect_end(waiting, 1, "the memory does not suffice")

    def test_a_run_that_does_not_listen_ends_soon_after_its_time(self):
        waiting, run = self.start("--timeout", "2")
        os.kill(run, signal.SIGSTOP)
        self.expect_end(waiting, 1, "the time limit is over")
        self.assertEqual(json.loads((self.folder / "r.json").read_text())["stop_reason"], "time_limit")

    def test_signals_go_on_to_the_run(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=number):
                waiting, _ = self.start()
                waiting.send_signal(number)
                self.expect_end(waiting, 130, "cancelled")

    def test_a_signal_to_both_processes_is_heard_once(self):
        """As `timeout` sends it: to the waiting process and to its group, while the run has no time to look."""
        waiting, run = self.start()
        os.kill(run, signal.SIGSTOP)
        os.kill(run, signal.SIGTERM)
        waiting.send_signal(signal.SIGTERM)
        time.sleep(0.2)
        os.kill(run, signal.SIGCONT)
        self.expect_end(waiting, 130, "cancelled")

    def test_no_run_outlives_who_waits_for_it(self):
        waiting, run = self.start()
        waiting.kill()
        waiting.wait()
        self.wait_for(lambda: not Path(f"/proc/{run}").exists())


if __name__ == "__main__":
    run_tests()

#!/usr/bin/python3
"""What is wrong with a solid is told by name, from the program and from Python alike, and nothing is written.

    test_bad_solids.py PROGRAM MODULE-FOLDER MODELS-FOLDER DEMOS-FOLDER [unittest options]
"""
import math
import os
import re
import subprocess
import sys

from solid_case import MODELS, PROGRAM, Case, mesher, run_tests

# By model: a pattern for the whole sentence, and what the report names as the entity.
REFUSED = {
    "without_lid": (r"Solid1: has an open shell, that of Face1; .*dimension.2", "Solid1"),
    "open_box_of_faces": (r"has no solid; .*dimension.2", "model"),
    "box_and_empty_solid": (r"Solid2: the solid is empty.*; delete it", "Solid2"),
    "pulled_through": (r"(Edge|Face)\d+.* at \(.*\): .+; .+", r"(Edge|Face)\d+.*"),
    "bow_tie_prism": (r"Face5 at \(.*\): its edges cross; .+", "Face5"),
    "without_height": (r"Face1 and Face2 at \(.*\): .+; .+", "Face1 and Face2"),
    "absurdly_small": (r"1\.73e-06 mm across, and sizes from 1e-05 to 1e\+09 can be meshed; scale the model", "model"),
    "absurdly_large": (r"1\.73e\+60 mm across, .*; scale the model", "model"),
}
# Solids that overlap, with the volume in common and how far the meshes may be off it.
OVERLAPPING = {"crossing_boxes": (0.5 * 0.6 * 0.7, 1e-3), "same_box_twice": (1.0, 1e-3), "ball_in_box": (math.pi / 6 / 8, 0.3),
               "box_in_box_on_floor": (0.125, 1e-3), "bar_through_box": (0.04, 1e-3)}
TOUCHING = ("boxes_face_to_face", "small_box_on_box", "boxes_edge_to_edge", "boxes_corner_to_corner", "ball_on_box", "pin_in_bore")
APART = ("boxes_apart", "pin_loose_in_bore", "glued_boxes")


class RefusalCase(Case):
    def expect_refusal(self, model, pattern, *arguments):
        """Status 1, a sentence that fits, nothing written over what was there; the report of the run."""
        (self.folder / "m.msh").write_text("precious")
        run = self.run_mesher(model, "-o", "m.msh", "--report", "r.json", *arguments)
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        for sentence in run.stderr.strip().split("\n"):
            self.assertRegex(sentence, r"^mesher: .+\.$")
        self.assertRegex(run.stderr, pattern)
        self.assertEqual((self.folder / "m.msh").read_text(), "precious")
        self.assertEqual(sorted(os.listdir(self.folder)), sorted({"m.msh", "r.json", *self.kept}))
        return self.report()

    kept = ()


class BadSolids(RefusalCase):
    def test_are_refused_by_name(self):
        for name, (pattern, entity) in REFUSED.items():
            with self.subTest(model=name):
                size = 1e59 if name == "absurdly_large" else 0.3
                report = self.expect_refusal(MODELS / f"{name}.brep", pattern, "--size", size)
                self.assertEqual(report["status"], "failed")
                failure = report["failures"][0]
                self.assertRegex(failure["entity"], f"^{entity}$")
                self.assertTrue(failure["reason"] and failure["remedy"])

    def test_a_model_that_is_an_empty_solid_names_it(self):
        self.expect_refusal(MODELS / "empty_solid.brep", r"empty_solid.brep, Solid1: the solid is empty")

    def test_are_refused_by_python_with_the_same_failure(self):
        if mesher is None:
            self.skipTest("the Python package is not built")
        for name, (pattern, entity) in REFUSED.items():
            with self.subTest(model=name), self.assertRaises(mesher.MeshingError) as refused:
                mesher.mesh(str(MODELS / f"{name}.brep"), size=1e59 if name == "absurdly_large" else 0.3)
            failure = refused.exception.failures[0]
            self.assertRegex(failure["entity"], f"^{entity}$")
            self.assertRegex(f"{failure['entity']}: {failure['reason']}; {failure['remedy']}", pattern.replace(r" at \(.*\):", ".*:"))
            self.assertEqual(r" at \(" in pattern, failure["point"] is not None)

    def test_thin_wall_is_meshed_flat_or_refused_by_name(self):
        run = self.run_mesher(MODELS / "thin_plate.brep", "--size", 1, "--check", "-o", "m.msh")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("the wall between Face5 and Face6, down to 0.001 thick, is left with flat tetrahedra", run.stderr)
        self.expect_refusal(MODELS / "thin_plate.brep", r"Face5 and Face6 .*: the wall between them is 0.001 thick, .*300 elements even with flat ones; choose a larger --size",
                            "--size", 1, "--max-elements", 300)

    def test_open_shells_are_meshed_as_faces(self):
        for name in ("without_lid", "shell_only"):
            with self.subTest(model=name):
                run = self.run_mesher(MODELS / f"{name}.brep", "--dimension", 2, "--size", 0.5, "--check", "-o", "m.msh")
                self.assertEqual(run.returncode, 0, run.stderr)

    def test_python_wants_a_shape(self):
        if mesher is None:
            self.skipTest("the Python package is not built")
        for nothing in (None, 3, b""):
            with self.subTest(nothing=nothing), self.assertRaises((TypeError, mesher.ModelError)):
                mesher.mesh(nothing)


class SolidsInContact(RefusalCase):
    def test_are_meshed_and_told(self):
        for name in TOUCHING:
            with self.subTest(model=name):
                run = self.run_mesher(MODELS / f"{name}.brep", "--size", 0.3, "--check", "-o", "m.msh", "--report", "r.json")
                self.assertEqual(run.returncode, 0, run.stderr)
                told = [w for w in self.report()["warnings"] if "touch" in w]
                self.assertEqual(len(told), 1)
                self.assertRegex(told[0], r"^Solid1 and Solid2 at \(.*\): the solids touch without a common face, .*; .+")
                self.assertIn("Solid1 and Solid2", run.stderr)

    def test_that_overlap_are_meshed_each_for_itself_and_told(self):
        for name, (common, off) in OVERLAPPING.items():
            with self.subTest(model=name):
                run = self.run_mesher(MODELS / f"{name}.brep", "--size", 0.3, "--check", "-o", "m.msh", "--report", "r.json")
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertIn("Solid1 and Solid2", run.stderr)
                report = self.report()
                self.assertEqual(len(report["warnings"]), 1)
                told = re.match(r"Solid1 and Solid2 at \(.*\): the solids overlap, and each has a mesh of its own there; "
                                r"they have about (\S+) mm\^3 in common; .+", report["warnings"][0])
                self.assertIsNotNone(told, report["warnings"])
                self.assertAlmostEqual(float(told.group(1)) / common, 1.0, delta=off + 0.005)
                self.assertAlmostEqual(report["mesh"]["volume"] / report["model"]["volume"], 1.0, delta=0.1)

    def test_that_overlap_are_refused_on_a_wish(self):
        pattern = r"Solid1 and Solid2 at \(.*\): the solids overlap; cut one from the other or fuse them .*"
        for name in OVERLAPPING:
            with self.subTest(model=name):
                report = self.expect_refusal(MODELS / f"{name}.brep", pattern, "--size", 0.3, "--overlap", "refuse")
                self.assertEqual(report["failures"][0]["entity"], "Solid1 and Solid2")
                self.assertEqual(report["options"]["overlap"], "refuse")
        run = self.run_mesher(MODELS / "crossing_boxes.brep", "--overlap", "never", "-o", "m.msh")
        self.assertEqual(run.returncode, 2)
        self.assertIn("--overlap is separate or refuse, not 'never'", run.stderr)

    def test_that_overlap_in_python(self):
        if mesher is None:
            self.skipTest("the Python package is not built")
        source = str(MODELS / "crossing_boxes.brep")
        self.assertIn("in common", mesher.mesh(source, size=0.3).report["warnings"][0])
        with self.assertRaises(mesher.MeshingError) as refused:
            mesher.mesh(source, size=0.3, overlap="refuse")
        self.assertIn("or leave overlap as it is", refused.exception.failures[0]["remedy"])
        with self.assertRaises(mesher.OptionError):
            mesher.mesh(source, size=0.3, overlap="never")

    def test_nothing_is_told_of_others(self):
        for name in APART:
            with self.subTest(model=name):
                run = self.run_mesher(MODELS / f"{name}.brep", "--size", 0.3, "--check", "-o", "m.msh")
                self.assertEqual((run.returncode, run.stderr), (0, ""))


class BadFiles(RefusalCase):
    def test_damaged_files(self):
        text = (MODELS / "box_with_hole.brep").read_text()
        curve = re.search(r"(?m)^1 (\S+ \S+ \S+ \S+ \S+ \S+) $", text)
        self.assertIsNotNone(curve)
        files = {"cut.brep": (text[:len(text) // 2], "truncated"), "cut_late.brep": (text[:-40], "truncated"),
                 "empty.brep": ("", "empty"), "garbage.brep": ("no model", "neither STEP nor"),
                 "nan.brep": (text.replace(curve.group(0), "1 nan " + curve.group(1).split(" ", 1)[1] + " ", 1), "not finite|damaged")}
        self.kept = tuple(files)
        for name, (content, _) in files.items():
            (self.folder / name).write_text(content)
        for name, (_, pattern) in files.items():
            with self.subTest(file=name):
                self.expect_refusal(name, f"{name}.*({pattern})", "--size", 0.5)
                if mesher is not None:
                    with self.assertRaises(mesher.ModelError):
                        mesher.mesh(str(self.folder / name), size=0.5)

    def test_full_disk(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("there is no /dev/full")
        for kind in ("msh", "msh2", "vtu", "vtk", "inp", "unv", "stl"):
            with self.subTest(format=kind):
                run = self.run_mesher(MODELS / "glued_boxes.brep", "--size", 0.5, "-o", "/dev/full", "--format", kind)
                self.assertEqual(run.returncode, 1)
                self.assertRegex(run.stderr, "^mesher: /dev/full: .*space.*; .+\n$")
        if mesher is not None:
            mesh = mesher.mesh(str(MODELS / "glued_boxes.brep"), size=0.5)
            with self.assertRaises(mesher.WriteError):
                mesh.write("/dev/full", format="msh")

    def test_a_disk_that_fills_up_keeps_the_old_file(self):
        """A limit on the size of files stands for a disk without space."""
        (self.folder / "m.msh").write_text("precious")
        limit = "import resource, os, signal, sys; signal.signal(signal.SIGXFSZ, signal.SIG_IGN); " \
                "resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)); os.execv(sys.argv[1], sys.argv[1:])"
        run = subprocess.run([sys.executable, "-c", limit, PROGRAM, "mesh", MODELS / "glued_boxes.brep", "--size", "0.3",
                              "-o", "m.msh"], cwd=self.folder, capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertRegex(run.stderr, r"^mesher: .*m\.msh: .+; .+\.\n$")
        self.assertEqual(os.listdir(self.folder), ["m.msh"])
        self.assertEqual((self.folder / "m.msh").read_text(), "precious")


if __name__ == "__main__":
    run_tests()

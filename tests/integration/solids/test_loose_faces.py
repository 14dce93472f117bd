#!/usr/bin/python3
"""Faces that bound a volume are made solids, faces side by side are sewn, and what is no part of the mesh is told by name.

    test_loose_faces.py PROGRAM MODULE-FOLDER MODELS-FOLDER DEMOS-FOLDER [unittest options]
"""
from solid_case import MODELS, Case, mesher, run_tests

# By model: the volume, and what the notes name.
MADE = {
    "shell_only": (6.0, [r"Solid1 was made of the closed shell of Face1, .*Face6"]),
    "box_of_faces": (6.0, [r"faces without edges in common were sewn: Edge\d+ to Edge\d+", r"Solid1 was made of .*Face6"]),
    "box_with_lid_in_halves": (6.0, [r"2 edges were split", r"sewn", r"Solid1 was made of .*Face7"]),
    "hollow_of_faces": (56.0, [r"sewn", r"Solid1 was made of .*Face12"]),
}
# … and what they name as not meshed.
LEFT_OUT = {
    "box_with_inner_face": [r"Face7 bounds no solid and is not meshed"],
    "box_with_strays": [r"Face7 bounds no solid and is not meshed", r"Edge17 and Vertex15 bound no face and are not meshed"],
}


def nodes_of(path):
    text = path.read_text()
    lines = text[text.index("$Nodes\n"):text.index("$EndNodes")].split("\n")[2:]
    return [tuple(map(float, line.split())) for line in lines if len(line.split()) == 3]


class LooseFaces(Case):
    def expect_mesh(self, model, *arguments):
        run = self.run_mesher(MODELS / f"{model}.brep", "-o", "m.msh", "--report", "r.json", "--check", *arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run, self.report()

    def expect_told(self, run, report, patterns):
        for pattern in patterns:
            self.assertRegex(run.stderr, pattern)
            self.assertRegex("\n".join(report["warnings"]), pattern)

    def test_closed_shells_are_made_solids(self):
        for model, (volume, patterns) in MADE.items():
            with self.subTest(model=model):
                run, report = self.expect_mesh(model, "--size", 0.7)
                self.assertAlmostEqual(report["mesh"]["volume"], volume, places=9)
                self.expect_told(run, report, patterns)

    def test_faces_side_by_side_are_sewn(self):
        for model in ("box_of_faces", "open_box_of_faces", "box_with_lid_in_halves", "shell_only"):
            with self.subTest(model=model):
                self.expect_mesh(model, "--size", 0.4, "--dimension", 2)
                nodes = nodes_of(self.folder / "m.msh")
                self.assertEqual(len(nodes), len({tuple(round(x, 6) for x in node) for node in nodes}))

    def test_what_is_not_meshed_is_told(self):
        for model, patterns in LEFT_OUT.items():
            with self.subTest(model=model):
                run, report = self.expect_mesh(model, "--size", 0.7)
                self.expect_told(run, report, patterns)

    def test_python_warns(self):
        if mesher is None:
            self.skipTest("the Python package is not built")
        with self.assertWarnsRegex(mesher.MesherWarning, "Face7 bounds no solid and is not meshed"):
            mesher.mesh(MODELS / "box_with_strays.brep", size=0.7)


if __name__ == "__main__":
    run_tests()

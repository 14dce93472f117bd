#!/usr/bin/python3
"""Tests the sizes that `mesher mesh` may be asked for.

    test_mesh_sizes.py PROGRAM DATA-FOLDER [unittest options]
"""
import json
import math
import re

from program_case import DATA, Case, read_msh, run_tests


class TestSizes(Case):
    """Sizes from the command line arrive in the mesh; what they do there is tested with the library."""

    def mesh(self, *arguments, model="plate.brep"):
        """Corners of the triangles and the report."""
        self.expect(0, "mesh", DATA / model, "--dimension", 2, "--check", "-o", "m.msh", "--report", "r.json", *arguments)
        report = json.loads((self.folder / "r.json").read_text())
        nodes, triangles = read_msh(self.folder / "m.msh")
        return [[nodes[n] for n in corners] for corners in triangles], report

    def sizes_near(self, triangles, point, radius):
        """Edge lengths of triangles whose middle is near the point."""
        edges = []
        for corners in triangles:
            middle = [sum(c[i] for c in corners) / 3 for i in range(3)]
            if math.dist(middle, point) < radius:
                edges += [math.dist(corners[i], corners[(i + 1) % 3]) for i in range(3)]
        return edges

    def expect_sizes(self, small_at, arguments, size=0.05):
        """Edges of about the size there, and of the general size of 0.4 at the other end."""
        triangles, report = self.mesh("--size", 0.4, *arguments)
        near = self.sizes_near(triangles, small_at, 0.1)
        self.assertTrue(near, arguments)
        self.assertLess(max(near), 2.2 * size)
        self.assertGreater(max(self.sizes_near(triangles, (4 - small_at[0], 2 - small_at[1], 0), 0.8)), 0.2)
        return report

    def test_every_kind_of_size(self):
        (self.folder / "points.txt").write_text("# x y z size\n\n3.5 1.5 0 0.05 # the only one\n")
        for small_at, arguments in [
                ((3.5, 1.5, 0), ["--size-box", "3,1,0,4,2,0=0.05"]),
                ((3.5, 1.5, 0), ["--size-ball", "3.5,1.5,0,0.4=0.05,0.3"]),
                ((3.5, 1.5, 0), ["--size-formula", "0.05 + 0.3*sqrt((x-3.5)^2 + (y-1.5)^2)"]),
                ((3.5, 1.5, 0), ["--size-points", "points.txt", "--grading", 3]),
                ((3.95, 1.95, 0), ["--local-size", "Vertex3=0.05"]),
                ((3.95, 1, 0), ["--size-distance", "Edge2=0.05,0.3,0.2"])]:
            with self.subTest(arguments=arguments):
                self.expect_sizes(small_at, arguments)

    def test_report_holds_the_sizes(self):
        report = self.expect_sizes((3.5, 1.5, 0), [
            "--size-box", "3,1,0,4,2,0=0.05", "--size-box", "0,0,0,1,1,0=0.3,0.5", "--size-ball", "1,1,0,0.5=0.3",
            "--size-distance", "Edge5=0.2,0.1", "--size-formula", "0.3"])
        options = report["options"]
        self.assertEqual(options["size_box"], [{"first": [3, 1, 0], "last": [4, 2, 0], "size": 0.05, "growth": 1},
                                               {"first": [0, 0, 0], "last": [1, 1, 0], "size": 0.3, "growth": 0.5}])
        self.assertEqual(options["size_ball"], [{"centre": [1, 1, 0], "radius": 0.5, "size": 0.3, "growth": 1}])
        self.assertEqual(options["size_distance"], [{"entity": "Edge5", "size": 0.2, "growth": 0.1, "plateau": 0}])
        self.assertEqual(options["size_formula"], "0.3")
        self.assertLess(abs(report["counts"]["expected_triangles"] / report["counts"]["triangles"] - 1), 0.5)

    def test_size_of_one_face_of_several(self):
        self.expect(0, "mesh", DATA / "inclusion.brep", "--dimension", 2, "--size", 0.4, "--local-size", "Face2=0.05", "-o", "m.msh",
                    "--grading", 2, "--check")
        nodes, triangles = read_msh(self.folder / "m.msh")
        disc = self.sizes_near([[nodes[n] for n in corners] for corners in triangles], (1, 1, 0), 0.45)
        self.assertGreater(len(disc), 3 * 300)
        self.assertLess(max(disc), 0.1)
        self.assertGreater(max(self.sizes_near([[nodes[n] for n in c] for c in triangles], (3.5, 1, 0), 0.5)), 0.2)

    def test_only_the_faces_that_are_named(self):
        self.expect(0, "mesh", DATA / "inclusion.brep", "--dimension", 2, "--size", 0.1, "--faces", "Face2", "-o", "m.msh")
        nodes, triangles = read_msh(self.folder / "m.msh")
        used = {n for corners in triangles for n in corners}
        self.assertLess(max(math.dist(nodes[n], (1, 1, 0)) for n in used), 0.5 + 1e-12)
        self.expect(0, "mesh", DATA / "box.brep", "--dimension", 2, "--size", 0.3, "--faces", "Face3", "-o", "b.msh")
        self.expect(0, "check", "b.msh", "--model", DATA / "box.brep")
        for faces in ("Face3", "Face1,Face2"):
            self.expect(0, "estimate", DATA / "inclusion.brep", "--dimension", 2, "--faces", "Face2,Face1")
        self.expect_refusal(1, "Face7: the model has no such face", "mesh", DATA / "box.brep", "--dimension", 2, "--faces", "Face7",
                            "-o", "a.msh")
        self.expect_refusal(1, "Face1: the face is named twice", "mesh", DATA / "box.brep", "--dimension", 2,
                            "--faces", "Face1,Face1", "-o", "a.msh")

    def test_named_faces_that_have_no_plane_in_common(self):
        """They are meshed in space, under the names of the model, and share the nodes of their edges."""
        box = ["mesh", DATA / "box.brep", "--dimension", 2, "--size", 0.5, "-o", "m.msh", "--faces"]
        for faces in (["Face1", "Face3"], ["Face2", "Face1"], ["Face6", "Face4", "Face1"]):
            with self.subTest(faces=faces):
                self.expect(0, *box, ",".join(faces), "--local-size", f"{faces[0]}=0.2", "--check")
                self.expect(0, "check", "m.msh", "--model", DATA / "box.brep")
                listed = re.findall(r"area of (Face\d+)", self.expect(0, "check", "m.msh").stdout)
                self.assertEqual(sorted(listed), sorted(faces))
                nodes, triangles = read_msh(self.folder / "m.msh")
                used = {n for corners in triangles for n in corners}
                self.assertEqual(len({tuple(round(c, 9) for c in nodes[n]) for n in used}), len(used))
        self.expect_refusal(1, "Face9: the model has no such face", *box, "Face1,Face9")
        self.expect_refusal(1, "Face2: the face is named twice", *box, "Face1,Face2,Face2")
        self.expect(0, "mesh", DATA / "cylinder_wall.brep", "--dimension", 2, "--faces", "Face1", "--size", 0.5, "-o", "w.msh", "--check")
        self.expect(0, "check", "w.msh", "--model", DATA / "cylinder_wall.brep")

    def test_size_of_a_background_mesh(self):
        corners = [(0, 0), (4, 0), (4, 2), (0, 2)]
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", "4"]
        lines += [f"{i} {x} {y} 0" for i, (x, y) in enumerate(corners, 1)]
        lines += ["$EndNodes", "$Elements", "2", "1 2 2 1 1 1 2 3", "2 2 2 1 1 1 3 4", "$EndElements"]
        lines += ["$NodeData", "1", '"size"', "1", "0", "3", "0", "1", "4", "1 0.4", "2 0.04", "3 0.04", "4 0.4", "$EndNodeData", ""]
        (self.folder / "sizes.msh").write_text("\n".join(lines))
        triangles, _ = self.mesh("--background", "sizes.msh")
        self.assertLess(max(self.sizes_near(triangles, (3.9, 1, 0), 0.2)), 0.12)
        self.assertGreater(max(self.sizes_near(triangles, (0.2, 1.8, 0), 0.4)), 0.2)
        (self.folder / "plain.msh").write_text("\n".join(lines[:lines.index("$NodeData")]) + "\n")
        self.expect_refusal(1, "plain.msh: has no number at its nodes", "mesh", DATA / "plate.brep", "--dimension", 2,
                            "--background", "plain.msh", "-o", "a.msh")
        (self.folder / "zero.msh").write_text("\n".join(lines).replace("2 0.04", "2 0"))
        self.expect_refusal(1, "zero.msh: background node 1", "mesh", DATA / "plate.brep", "--dimension", 2,
                            "--background", "zero.msh", "-o", "a.msh")

    def test_absurd_sizes_are_told_before_memory_is_taken(self):
        plate = DATA / "plate.brep"
        for arguments in (["--size", "1e-300"], ["--size-box", "1,0.2,0,1.001,0.2001,0=1e-9"], ["--local-size", "Vertex1=1e-12"],
                          ["--size-formula", "1e-7"], ["--size-ball", "3,1,0,1e-3=1e-8"]):
            expensive = arguments[0] in ("--size", "--size-formula", "--size-box", "--size-ball")
            with self.subTest(arguments=arguments):
                if expensive:
                    self.expect_refusal(1, "elements and .* would be needed, more than --max-elements", "mesh", plate,
                                        "--dimension", 2, "-o", "a.msh", *arguments)
                    self.assertEqual(self.run_mesher("estimate", plate, "--dimension", 2, *arguments).returncode, 1)
                else:  # a single place can be as small as it likes
                    self.expect(0, "mesh", plate, "--dimension", 2, "-o", "m.msh", *arguments)

    def test_size_files_that_cannot_be_read(self):
        (self.folder / "empty.txt").touch()
        (self.folder / "comment.txt").write_text("# nothing\n")
        (self.folder / "short.txt").write_text("0 0 0 1\n1 2 3\n4\n")
        (self.folder / "words.txt").write_text("0 0 0 fine\n")
        (self.folder / "negative.txt").write_text("0 0 0 1\n0 0 0 -1\n")
        (self.folder / "nan.txt").write_text("0 0 nan 1\n")
        (self.folder / "folder.txt").mkdir()
        for name, pattern in [("missing.txt", "no such file"), ("empty.txt", "empty"), ("comment.txt", "without a point"),
                              ("short.txt", "line 2: four numbers"), ("words.txt", "line 1: four numbers"),
                              ("negative.txt", "line 2: the size is no length"), ("nan.txt", "line 1: the place is not finite"),
                              ("folder.txt", "is a folder")]:
            for command in (["mesh", "-o", "a.msh"], ["estimate"]):
                with self.subTest(name=name, command=command[0]):
                    self.expect_refusal(1, f"{name}: .*{pattern}", *command, DATA / "plate.brep", "--dimension", 2,
                                        "--size-points", name)
        self.expect_refusal(1, "missing.msh: there is no such file", "mesh", DATA / "plate.brep", "--dimension", 2,
                            "--background", "missing.msh", "-o", "a.msh")


if __name__ == "__main__":
    run_tests()

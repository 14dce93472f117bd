#!/usr/bin/python3
"""Tests what `mesher mesh` refuses: usage, models, targets.

    test_refusals.py PROGRAM DATA-FOLDER [unittest options]
"""
import json
import os
import re
import shutil
import subprocess

from program_case import DATA, PROGRAM, Case, run_tests


# A unit square, as small as AP203 allows.
STEP_SQUARE = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','',(''),(''),'','','');
FILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('');
#2=MECHANICAL_CONTEXT('',#1,'mechanical');
#3=PRODUCT('p','p','',(#2));
#4=PRODUCT_DEFINITION_FORMATION('','',#3);
#5=DESIGN_CONTEXT('',#1,'design');
#6=PRODUCT_DEFINITION('','',#4,#5);
#7=PRODUCT_DEFINITION_SHAPE('','',#6);
#8=SHAPE_DEFINITION_REPRESENTATION(#7,#9);
#9=MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#10,#17),#11);
#10=SHELL_BASED_SURFACE_MODEL('',(#18));
#11=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#12))GLOBAL_UNIT_ASSIGNED_CONTEXT((#13,#14,#15))REPRESENTATION_CONTEXT('',''));
#12=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-7),#13,'','');
#13=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#14=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#15=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#16=CARTESIAN_POINT('',(0.,0.,0.));
#17=AXIS2_PLACEMENT_3D('',#16,#26,#27);
#18=OPEN_SHELL('',(#19));
#19=ADVANCED_FACE('',(#20),#25,.T.);
#20=FACE_BOUND('',#21,.T.);
#21=EDGE_LOOP('',(#51,#52,#53,#54));
#25=PLANE('',#17);
#26=DIRECTION('',(0.,0.,1.));
#27=DIRECTION('',(1.,0.,0.));
#28=DIRECTION('',(0.,1.,0.));
#29=DIRECTION('',(-1.,0.,0.));
#30=CARTESIAN_POINT('',(1.,0.,0.));
#31=CARTESIAN_POINT('',(1.,1.,0.));
#32=CARTESIAN_POINT('',(0.,1.,0.));
#33=DIRECTION('',(0.,-1.,0.));
#34=VERTEX_POINT('',#16);
#35=VERTEX_POINT('',#30);
#36=VERTEX_POINT('',#31);
#37=VERTEX_POINT('',#32);
#38=VECTOR('',#27,1.);
#39=VECTOR('',#28,1.);
#40=VECTOR('',#29,1.);
#41=VECTOR('',#33,1.);
#42=LINE('',#16,#38);
#43=LINE('',#30,#39);
#44=LINE('',#31,#40);
#45=LINE('',#32,#41);
#46=EDGE_CURVE('',#34,#35,#42,.T.);
#47=EDGE_CURVE('',#35,#36,#43,.T.);
#48=EDGE_CURVE('',#36,#37,#44,.T.);
#49=EDGE_CURVE('',#37,#34,#45,.T.);
#51=ORIENTED_EDGE('',*,*,#46,.T.);
#52=ORIENTED_EDGE('',*,*,#47,.T.);
#53=ORIENTED_EDGE('',*,*,#48,.T.);
#54=ORIENTED_EDGE('',*,*,#49,.T.);
ENDSEC;
END-ISO-10303-21;
"""


class TestRefusals(Case):
    def test_wrong_usage(self):
        plate = DATA / "plate.brep"
        for pattern, arguments in [
                ("command is missing", []),
                ("unknown command 'mush'", ["mush"]),
                ("model is missing", ["mesh", "-o", "a.msh"]),
                ("output is missing", ["mesh", plate]),
                ("too much", ["mesh", plate, plate, "-o", "a.msh"]),
                ("unrecognised option '--sise", ["mesh", plate, "-o", "a.msh", "--sise", 1]),
                ("unknown format 'nonsense'", ["mesh", plate, "-o", "a.msh", "--format", "nonsense"]),
                ("extension '.xyz'", ["mesh", plate, "-o", "a.xyz"]),
                ("no extension", ["mesh", plate, "-o", "a"]),
                ("more --format", ["mesh", plate, "-o", "a.msh", "--format", "msh", "--format", "vtu"]),
                ("named twice", ["mesh", plate, "-o", "a.msh", "-o", "./a.msh"]),
                ("named twice", ["mesh", plate, "-o", plate, "--format", "msh"]),
                ("wants a number, not '1,5'", ["mesh", plate, "-o", "a.msh", "--size", "1,5"]),
                ("--size: the size 0 makes no sense", ["mesh", plate, "-o", "a.msh", "--size", 0]),
                ("--size: the size -1 makes no sense", ["mesh", plate, "-o", "a.msh", "--size=-1"]),
                ("--size: the size nan makes no sense", ["mesh", plate, "-o", "a.msh", "--size", "nan"]),
                ("--size: the size inf makes no sense", ["mesh", plate, "-o", "a.msh", "--size", "inf"]),
                ("Face6=0.5", ["mesh", plate, "-o", "a.msh", "--local-size", "Fase6=1"]),
                ("Face6=0.5", ["mesh", plate, "-o", "a.msh", "--local-size", "Face1=1,2"]),
                ("Edge3=0.1,0.2", ["mesh", plate, "-o", "a.msh", "--size-distance", "Edge3=0.1"]),
                ("Edge3=0.1,0.2", ["mesh", plate, "-o", "a.msh", "--size-distance", "Kante3=0.1,0.2"]),
                ("0,0,0,1,1,1=0.1", ["mesh", plate, "-o", "a.msh", "--size-box", "0,0,1,1=0.1"]),
                ("0,0,0,1,1,1=0.1", ["mesh", plate, "-o", "a.msh", "--size-box", "0,0,0,1,1,1"]),
                ("0,0,0,1,1,1=0.1", ["mesh", plate, "-o", "a.msh", "--size-box", "0,0,0,1,1,b=0.1"]),
                ("0,0,0,1=0.1", ["mesh", plate, "-o", "a.msh", "--size-ball", "0,0,0,1=0.1,0.2,0.3"]),
                ("0,0,0,1=0.1", ["mesh", plate, "-o", "a.msh", "--size-ball", "=0.1"]),
                ("--size-box: the size 0 makes no sense", ["mesh", plate, "-o", "a.msh", "--size-box", "0,0,0,1,1,1=0"]),
                ("--size-ball: the radius -1 makes no sense", ["mesh", plate, "-o", "a.msh", "--size-ball", "0,0,0,-1=1"]),
                ("--size-formula: formula, character 4", ["mesh", plate, "-o", "a.msh", "--size-formula", "x+1)"]),
                ("--local-size: the size 0 of Edge1 makes no sense", ["estimate", plate, "--local-size", "Edge1=0"]),
                ("--faces: 'Edge1' is no name of a face", ["mesh", plate, "-o", "a.msh", "--faces", "Edge1"]),
                ("q1 to q8", ["mesh", plate, "-o", "a.msh", "--measure", "q9"]),
                ("--dimension", ["mesh", plate, "-o", "a.msh", "--dimension", 4]),
                ("mesh is missing", ["check"]),
                ("output is missing", ["draw", "a.msh"])]:
            with self.subTest(arguments=arguments):
                self.expect_refusal(2, re.escape(pattern), *arguments)

    def expect_model_refusal(self, name, pattern, *arguments):
        """By every command that reads models, with the name of the file; `arguments` of mesh and estimate."""
        for command in (["mesh", "-o", "a.msh", "--report", "/dev/null"], ["estimate"]):
            with self.subTest(name=name, command=command[0]):
                self.expect_refusal(1, f"{re.escape(str(name))}.*{pattern}.*; .+\\.$", *command, name, "--dimension", 2, *arguments)

    def test_models_that_cannot_be_read(self):
        plate = (DATA / "plate.brep").read_text()
        (self.folder / "empty.step").touch()
        (self.folder / "garbage.step").write_text("no model at all")
        (self.folder / "cut.brep").write_text(plate[:400])
        (self.folder / "cut_late.brep").write_text(plate[:-30])
        (self.folder / "mesh.brep").write_text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")
        (self.folder / "damaged.brep").write_text(plate.replace("Curves 5", "Curbes 5"))
        (self.folder / "miscounted.brep").write_text(plate.replace("Curves 5", "Curves 4"))
        (self.folder / "numbers.brep").write_text(plate.replace("1 4 2 0 -1 0 0", "1 4 2 0 0 0 0"))
        (self.folder / "nan.brep").write_text(plate.replace("1 4 2 0 -1 0 0", "1 nan 2 0 -1 0 0"))
        (self.folder / "cut.step").write_text(STEP_SQUARE[:len(STEP_SQUARE) // 2])
        (self.folder / "damaged.step").write_text(STEP_SQUARE.replace("#30=CARTESIAN_POINT", "#30=CARTESIAN_PAINT"))
        (self.folder / "dangling.step").write_text(STEP_SQUARE.replace("#30=CARTESIAN_POINT", "#130=CARTESIAN_POINT"))
        (self.folder / "folder.step").mkdir()
        (self.folder / "locked.step").write_text(STEP_SQUARE)
        (self.folder / "locked.step").chmod(0)
        for name, pattern in [("missing.step", "no such file"), ("empty.step", "empty"), ("garbage.step", "neither STEP nor"),
                              ("cut.brep", "truncated"), ("cut_late.brep", "truncated"), ("mesh.brep", "neither STEP nor"),
                              ("damaged.brep", "damaged"), ("miscounted.brep", "damaged"), ("numbers.brep", "Edge3: the edge has no curve"),
                              ("nan.brep", "Edge3: the edge's curve has places that are not finite"),
                              ("cut.step", "truncated"), ("damaged.step", "damaged at #"), ("dangling.step", "damaged at #"),
                              ("folder.step", "folder")]:
            self.expect_model_refusal(name, pattern)
            with self.subTest(name=name, command="info"):
                self.expect_refusal(1, re.escape(name), "info", name)
        if os.geteuid() != 0:
            self.expect_model_refusal("locked.step", "cannot be opened")

    def test_a_damaged_model_writes_nothing_to_stdout(self):
        (self.folder / "damaged.brep").write_text((DATA / "plate.brep").read_text().replace("Curves 5", "Curbes 5"))
        self.assertEqual(self.expect(1, "info", "damaged.brep", "--json").stdout, "")

    def test_step_model(self):
        (self.folder / "square.step").write_text(STEP_SQUARE)
        self.expect(0, "mesh", "square.step", "--dimension", 2, "--size", 0.2, "-o", "m.msh", "--check")
        self.expect(0, "check", "m.msh", "--model", "square.step")

    def test_iges_model(self):
        run = self.expect(0, "mesh", DATA / "box.iges", "--size", 1, "-o", "m.msh", "--check")
        self.assertRegex(run.stderr, "faces without edges in common were sewn")
        self.assertIn("format: IGES", self.expect(0, "info", DATA / "box.iges").stdout)

    def test_a_program_without_its_modules_says_so(self):
        """Copied to where the readers of STEP and IGES are not."""
        (self.folder / "square.step").write_text(STEP_SQUARE)
        alone = self.folder / "bin" / "mesher"
        alone.parent.mkdir()
        shutil.copy(PROGRAM, alone)
        run = subprocess.run([alone, "info", "square.step"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stderr, r"^mesher: mesher_read_step\.so: the module that reads this format is not beside the program; .+\.\n$")
        self.assertEqual(subprocess.run([alone, "info", DATA / "box.brep"], cwd=self.folder, capture_output=True).returncode, 0)

    def test_fields_left_unset_are_no_damage(self):
        unset = STEP_SQUARE.replace("SHELL_BASED_SURFACE_MODEL(''", "SHELL_BASED_SURFACE_MODEL($").replace("PLANE(''", "PLANE($")
        unset = unset.replace("CARTESIAN_POINT(''", "CARTESIAN_POINT($").replace("EDGE_CURVE(''", "EDGE_CURVE($")
        (self.folder / "unset.step").write_text(unset)
        self.expect(0, "mesh", "unset.step", "--dimension", 2, "--size", 0.2, "-o", "m.msh", "--check")
        self.assertNotEqual(unset, STEP_SQUARE)
        (self.folder / "needed.step").write_text(unset.replace("CARTESIAN_POINT($,(1.,0.,0.))", "CARTESIAN_POINT($,$)"))
        self.expect_model_refusal("needed.step", "damaged at #30.*coordinates")

    def test_names_of_parts_that_are_not_kept_are_told(self):
        part = ("#{0}0=PRODUCT('{1}','{1}','',(#2));\n#{0}1=PRODUCT_DEFINITION_FORMATION('','',#{0}0);\n"
                "#{0}2=PRODUCT_DEFINITION('','',#{0}1,#5);\n#{0}3=NEXT_ASSEMBLY_USAGE_OCCURRENCE('{0}','','',#6,#{0}2,$);\n")
        parts = part.format(6, "Bolt") + part.format(7, "Nut")
        (self.folder / "parts.step").write_text(STEP_SQUARE.replace("ENDSEC;\nEND-ISO", parts + "ENDSEC;\nEND-ISO"))
        run = self.expect(0, "mesh", "parts.step", "--dimension", 2, "--size", 0.2, "-o", "m.msh")
        self.assertRegex(run.stderr, "names of its parts are not kept.*: Bolt and Nut\n")

    def test_models_that_cannot_be_meshed(self):
        self.expect_refusal(1, "plate.brep: has no solid; .*--dimension 2", "mesh", DATA / "plate.brep", "-o", "a.msh")
        for name, pattern in [
                ("open_wire.brep", r"Face1 at \(0, 1, 0\): its wire is open between Edge3 and Edge1"),
                ("crossing_wire.brep", r"Edge1 and Edge3 at \(1\.333.*, 0\.666.*, 0\): the edges meet away from"),
                ("no_area.brep", "Face1: the face has no area"),
                ("no_wire.brep", "Face1: the face has no area or no end"),
                ("wire_only.brep", "has no face"),
                ("nothing.brep", "has no face")]:
            self.expect_model_refusal(DATA / name, pattern)

    def test_absurd_sizes_of_a_model(self):
        self.expect_model_refusal(DATA / "plate.brep", "--max-elements 50000000", "--size", 1e-7)
        self.expect_model_refusal(DATA / "plate.brep", "--max-elements 10000", "--refinement", 1000, "--max-elements", 10000)
        self.expect_model_refusal(DATA / "plate.brep", "Edge6: cannot have a size of its own", "--local-size", "Edge6=1")
        self.expect_model_refusal(DATA / "plate.brep", "Solid1: cannot have a size of its own", "--size-distance", "Solid1=1,1")
        self.expect(0, "mesh", DATA / "plate.brep", "--dimension", 2, "--size", 1e300, "-o", "m.msh")

    def test_targets_that_cannot_be_written_are_told_before_meshing(self):
        (self.folder / "folder.msh").mkdir()
        for pattern, target in [("does not exist", "missing/a.msh"), ("folder", "folder.msh")]:
            for option in ("-o", "--report", "--curved-boundary"):
                outputs = ["-o", target] if option == "-o" else ["-o", "a.msh", option, target]
                with self.subTest(option=option, target=target):
                    self.expect_refusal(1, pattern, "mesh", DATA / "missing.brep", "--dimension", 2, *outputs)

    def test_full_disk(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("there is no /dev/full")
        mesh = ["mesh", DATA / "plate.brep", "--dimension", 2]
        for name in ("msh", "msh2", "vtu", "vtk", "su2", "stl", "ply", "inp", "unv", "png"):
            with self.subTest(format=name):
                self.expect_refusal(1, "/dev/full: .*space.*; .+", *mesh, "-o", "/dev/full", "--format", name)
        self.expect(1, *mesh, "-o", "m.msh", "--report", "/dev/full")
        self.expect(1, *mesh, "-o", "n.msh", "--curved-boundary", "/dev/full")
        self.expect_refusal(1, "/dev/full: .*space.*; .+", "draw", "m.msh", "-o", "/dev/full")

    def test_write_protected_target(self):
        if os.geteuid() == 0:
            self.skipTest("nothing is write-protected for this user")
        self.folder.chmod(0o555)
        self.expect_refusal(1, "a.msh: .*; .+", "mesh", DATA / "plate.brep", "--dimension", 2, "-o", "a.msh")
        self.folder.chmod(0o755)

    def test_a_failed_run_leaves_what_was_there(self):
        (self.folder / "m.msh").write_text("precious")
        self.expect_refusal(1, "no area", "mesh", DATA / "no_area.brep", "--dimension", 2, "-o", "m.msh")
        self.assertEqual((self.folder / "m.msh").read_text(), "precious")

    def test_failed_run_is_told_in_the_report(self):
        self.expect(1, "mesh", DATA / "crossing_wire.brep", "--dimension", 2, "-o", "a.msh", "--report", "r.json")
        report = json.loads((self.folder / "r.json").read_text())
        self.assertEqual(report["status"], "failed")
        failure = report["failures"][0]
        self.assertEqual(failure["entity"], "Edge1 and Edge3")
        self.assertTrue(failure["reason"] and failure["remedy"] and len(failure["point"]) == 3)


if __name__ == "__main__":
    run_tests()

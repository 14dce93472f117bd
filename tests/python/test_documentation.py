"""Runs the examples of docs/python.md, and holds its table of options to the package, the program and the workbench:
test_documentation.py MODULE_DIRECTORY PAGE DEMO_DIRECTORY PROGRAM."""
import inspect
import os
import pathlib
import re
import runpy
import subprocess
import sys
import tempfile

module_directory, page, demos, program = (os.path.abspath(argument) for argument in sys.argv[1:5])
sys.path.insert(0, module_directory)

with open(page, encoding="utf-8") as file:
    text = file.read()
examples = [(text.count("\n", 0, block.start(1)), block[1]) for block in re.finditer(r"```python\n(.*?)```", text, re.DOTALL)]
assert len(examples) >= 5, f"{page} has {len(examples)} examples"
os.chdir(demos)
with tempfile.TemporaryDirectory() as directory:
    names = {"output": pathlib.Path(directory)}
    for line, example in examples:
        # The line numbers of a traceback are those of the page.
        exec(compile("\n" * line + example, page, "exec"), names)
    written = sorted(os.listdir(directory))
assert written == ["bracket.gmsh", "bracket.msh", "bracket.unv"], written
print(f"{len(examples)} examples ran")


def words_of(column):
    return {word for cells in table for word in re.findall(r"`([^`]+)`", cells[column])}


table = [line.strip("|").split("|") for line in text.split("## Before meshing")[0].split("\n") if line.startswith("| `") and "--" in line]
import mesher  # noqa: E402

options = set(inspect.signature(mesher.mesh).parameters) - {"source", "progress"}
assert words_of(0) == options, words_of(0) ^ options
text_of_help = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
of_mesh_and_estimate = text_of_help.split("Options of mesh and estimate")[1].split("Options of mesh:")[0]
switches = set(re.findall(r"(?m)^  (?:-\w \[ )?(--[a-z-]+)", of_mesh_and_estimate)) | {"--check"}
assert words_of(1) == switches, words_of(1) ^ switches
workbench = runpy.run_path(os.path.join(module_directory, "MesherWorkbench", "objects", "mesh.py"))
of_object = {name for _, name, group, *_ in workbench["_PROPERTIES"] if group != "Result"} - {"Part", "Shape"}
assert words_of(2) == of_object, words_of(2) ^ of_object
print(f"{len(table)} rows of options are true")

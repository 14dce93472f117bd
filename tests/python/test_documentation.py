"""Runs the examples of docs/python.md: test_documentation.py MODULE_DIRECTORY PAGE DEMO_DIRECTORY."""
import os
import pathlib
import re
import sys
import tempfile

module_directory, page, demos = (os.path.abspath(argument) for argument in sys.argv[1:4])
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
assert written == ["bracket.gmsh", "bracket.msh"], written
print(f"{len(examples)} examples ran")

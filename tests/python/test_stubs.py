"""Holds mesher/__init__.pyi to the package: test_stubs.py MODULE_DIRECTORY. Every public name is in both, functions take the
same arguments with the same defaults, and exceptions have the same bases."""
import ast
import inspect
import json
import os
import sys
import unittest

MODULE_DIRECTORY = sys.argv[1]
sys.path.insert(0, MODULE_DIRECTORY)
import mesher  # noqa: E402

# Kinds of values that only a stub has names for.
TYPE_NAMES = {"Path", "Point", "Progress", "Failure", "Estimate"}


def read_stub():
    with open(os.path.join(MODULE_DIRECTORY, "mesher", "__init__.pyi"), encoding="utf-8") as file:
        return {_name_of(node): node for node in ast.parse(file.read()).body
                if isinstance(node, (ast.FunctionDef, ast.ClassDef, ast.AnnAssign, ast.Assign))}


def _name_of(node):
    if isinstance(node, ast.AnnAssign):
        return node.target.id
    return node.targets[0].id if isinstance(node, ast.Assign) else node.name


def members_of(node):
    return {_name_of(member): member for member in node.body if isinstance(member, (ast.FunctionDef, ast.AnnAssign))}


def arguments_of(function):
    """(name, default as text) of each argument of a stub."""
    arguments = function.args
    first_default = len(arguments.args) - len(arguments.defaults)
    told = [(argument.arg, ast.literal_eval(arguments.defaults[i - first_default]) if i >= first_default else None)
            for i, argument in enumerate(arguments.args)]
    told += [(argument.arg, ast.literal_eval(default)) for argument, default in
             zip(arguments.kwonlyargs, arguments.kw_defaults)]
    return told + ([(arguments.kwarg.arg, None)] if arguments.kwarg else [])


def arguments_at_run_time(function):
    return [(parameter.name, None if parameter.default is parameter.empty else parameter.default)
            for parameter in inspect.signature(function).parameters.values()]


class Stubs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.stub = read_stub()

    def test_same_names(self):
        self.assertEqual(set(self.stub) - TYPE_NAMES, set(mesher.__all__) | {"__version__"})
        for name in self.stub.keys() - TYPE_NAMES:
            self.assertTrue(hasattr(mesher, name), name)

    def test_same_arguments(self):
        for name, node in self.stub.items():
            if isinstance(node, ast.FunctionDef):
                with self.subTest(name):
                    self.assertEqual(arguments_of(node), arguments_at_run_time(getattr(mesher, name)))

    def test_same_members(self):
        for name in ("Mesh", "Model"):
            with self.subTest(name):
                public = {member for member in dir(getattr(mesher, name)) if not member.startswith("_")}
                # The report is handed to a mesh when it is made.
                self.assertEqual(set(members_of(self.stub[name])) - {"report"}, public)

    def test_properties_and_methods_are_what_they_are_called(self):
        for name in ("Mesh", "Model"):
            for member, node in members_of(self.stub[name]).items():
                if not isinstance(node, ast.FunctionDef):
                    continue
                is_property = any(getattr(decorator, "id", "") == "property" for decorator in node.decorator_list)
                self.assertEqual(is_property, isinstance(inspect.getattr_static(getattr(mesher, name), member), property),
                                 f"{name}.{member}")

    def test_methods_written_in_python_have_the_same_arguments(self):
        for member in ("to_fem_mesh", "quality"):
            told = [name for name, _ in arguments_of(members_of(self.stub["Mesh"])[member])][1:]
            self.assertEqual(told, [name for name, _ in arguments_at_run_time(getattr(mesher.Mesh, member))][1:])

    def test_same_bases(self):
        for name, node in self.stub.items():
            if isinstance(node, ast.ClassDef) and name not in TYPE_NAMES:
                told = [base.id for base in node.bases] or ["pybind11_object"]
                self.assertEqual(told, [base.__name__ for base in getattr(mesher, name).__bases__], name)


class Defaults(unittest.TestCase):
    def test_are_those_of_the_core(self):
        """What the core does with no option at all is what the arguments of mesh() say."""
        model = mesher.Model.read(os.path.join(sys.argv[2], "plate.brep"))
        options = {"dimension": 2}
        _, text = mesher._core.run(model, options)
        with_defaults = mesher.mesh(model, **options).report["options"]
        self.assertEqual(json.loads(text)["options"], with_defaults)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)

# SPDX-License-Identifier: BSD-3-Clause
"""The stubs for editors and type checkers (*.pyi) have the names of the module."""

import ast
import copy
import pathlib
import subprocess
import sys
import tempfile
import unittest

import boxplus
from boxplus import _boxplus

PACKAGE = pathlib.Path(boxplus.__file__).parent
SOURCES = pathlib.Path(__file__).parents[2] / "python"
# Modules of the package with names of their own; boxplus does not import plot.
MODULES = ("plot", "rows")
# Only for the stubs: aliases, and the base class of enumerations.
STUB_ONLY = {"Array", "Ids", "Vertex", "Camera", "Manifold", "Estimate", "VertexType", "Enum"}


def names_in_stub(node):
    """{name: node} of the functions, classes and variables in a module or class."""
    names = {}
    for child in node.body:
        if isinstance(child, (ast.FunctionDef, ast.ClassDef)):
            names[child.name] = child
        elif isinstance(child, ast.AnnAssign):
            names[child.target.id] = child
        elif isinstance(child, ast.Assign):
            names[child.targets[0].id] = child
    return {name: child for name, child in names.items() if not name.startswith("_")}


def names_in_class(cls):
    names = {name for name in vars(cls) if not name.startswith("_")}
    return names - {"name", "value"} if hasattr(cls, "__members__") else names


def parsed(path):
    return ast.parse(path.read_text(encoding="utf-8"))


def arguments(function):
    """The arguments of a function without their types."""
    copied = copy.deepcopy(function.args)
    for argument in copied.posonlyargs + copied.args + copied.kwonlyargs:
        argument.annotation = None
    return ast.unparse(copied)


class Stubs(unittest.TestCase):
    def assert_same_names(self, stub, cls, where):
        expected = {} if issubclass(cls, boxplus.Edge) and cls is not boxplus.Edge else names_in_stub(stub)
        if issubclass(cls, Exception):
            return
        self.assertEqual(set(expected), names_in_class(cls), where)
        for name, child in expected.items():
            if isinstance(child, ast.ClassDef):
                self.assert_same_names(child, getattr(cls, name), f"{where}.{name}")

    def test_the_stubs_have_the_names_of_the_module(self):
        names = names_in_stub(parsed(PACKAGE / "__init__.pyi"))
        self.assertEqual(set(names) - STUB_ONLY, set(boxplus.__all__))
        for name, child in names.items():
            if isinstance(child, ast.ClassDef) and name not in STUB_ONLY:
                self.assert_same_names(child, getattr(boxplus, name), name)

    def test_every_type_of_the_stubs_is_known(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "__init__.pyi"
            command = [sys.executable, SOURCES / "make_stubs.py", _boxplus.__file__, SOURCES / "stubs.pyi", path]
            process = subprocess.run(command, capture_output=True, text=True, check=True)
            self.assertEqual(process.stderr, "")
            self.assertEqual(path.read_bytes(), (PACKAGE / path.name).read_bytes())

    def test_the_stubs_of_other_modules_have_their_functions_and_arguments(self):
        for name in MODULES:  # compares the sources, because the module may lack what it needs
            module, stub = parsed(PACKAGE / f"{name}.py"), parsed(PACKAGE / f"{name}.pyi")
            exported = next(ast.literal_eval(node.value) for node in module.body
                            if isinstance(node, ast.Assign) and node.targets[0].id == "__all__")
            functions = {node.name: node for node in module.body if isinstance(node, ast.FunctionDef)}
            self.assertEqual(sorted(names_in_stub(stub)), exported)
            for function, node in names_in_stub(stub).items():
                self.assertEqual(arguments(node), arguments(functions[function]), function)
                self.assertTrue(ast.get_docstring(functions[function]), function)

    def test_the_module_has_the_version_of_the_project(self):
        self.assertRegex(boxplus.__version__, r"^\d+\.\d+\.\d+$")

    def test_every_class_and_function_has_a_documentation(self):
        for name in boxplus.__all__:
            self.assertTrue(getattr(boxplus, name).__doc__, name)


if __name__ == "__main__":
    unittest.main()

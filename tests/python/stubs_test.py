# SPDX-License-Identifier: BSD-3-Clause
"""The stubs for editors and type checkers (*.pyi) have the names of the module."""

import ast
import pathlib
import unittest

import boxplus

# Only for the stubs: aliases, and the base class of enumerations.
STUB_ONLY = {"Array", "Ids", "Vertex", "Estimate", "VertexType", "Enum"}


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
        names = {}
        for path in pathlib.Path(boxplus.__file__).parent.glob("*.pyi"):
            names.update(names_in_stub(ast.parse(path.read_text(encoding="utf-8"))))
        self.assertEqual(set(names) - STUB_ONLY, set(boxplus.__all__))
        for name, child in names.items():
            if isinstance(child, ast.ClassDef) and name not in STUB_ONLY:
                self.assert_same_names(child, getattr(boxplus, name), name)

    def test_every_class_and_function_has_a_documentation(self):
        for name in boxplus.__all__:
            self.assertTrue(getattr(boxplus, name).__doc__, name)


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the types of the module boxplus, for editors and type checkers. The build calls it.

    make_stubs.py MODULE STUBS OUTPUT

MODULE is the library _boxplus, STUBS are the types written by hand (stubs.pyi), and OUTPUT gets these and the types of all
other names. pybind11 writes the types of functions and attributes into their documentation. An argument that a function
converts itself is a `handle` or an `object` there; ARGUMENTS has its type. A name without a type becomes Any, and a message
on stderr says so.
"""

import ast
import builtins
import importlib.util
import pathlib
import re
import sys
import textwrap

#: Types as pybind11 writes them, and as the stubs do. A class that is bound later has its name in C++.
TYPES = ((r"\b(?:[a-z]\w*::)+", ""), ("::", "."), ("CovarianceObject", "Covariance"), (r"\bboxplus\.", ""),
         (r"\bList\[", "list["), (r"\bTuple\[", "tuple["), (r"numpy\.ndarray\[numpy\.float64\]", "Array"),
         (r"numpy\.ndarray\[numpy\.int64\]", "Ids"), (r"os\.PathLike", "str | os.PathLike[str]"), ("-> object", "-> Any"),
         (r"= (<.*?>|-?inf)", "= ..."))
#: The types of arguments by their names, which mean the same in all functions.
ARGUMENTS = {
    **dict.fromkeys(("coefficients", "color", "delta", "direction", "estimates", "minimal", "moment", "other", "point",
                     "rotation_vector", "tangent", "translation", "vector"), "ArrayLike"),
    **dict.fromkeys(("evidence", "false_alarm", "seconds", "tolerance"), "float"),
    **dict.fromkeys(("max_escapes", "new_id", "window"), "int"),
    **dict.fromkeys(("a", "b", "id", "vertex"), "Vertex"),
    "directions": "Sequence[int]",
    "edge": "Edge | type[Edge] | BatchedEdge | Callable[..., Any]",
    "edges": "EdgeRef | Sequence[EdgeRef]",
    "element": "EdgeRef | Vertex",
    "estimate": "Estimate",
    "ids": "ArrayLike | Sequence[Vertex]",
    "information": "float | ArrayLike",
    "kernel": "RobustKernel | str | None",
    "measurement": "Estimate | float",
    "options": "Options",
    "rotation": "SO3 | ArrayLike",
    "severity": "Finding.Severity | str",
    "suspects": "Suspects | str",
    "type": "VertexType",
    "verdict": "Verdict | str",
    "vertices": "Sequence[Vertex]",
}
OPERATORS = ("__call__", "__init__", "__lt__", "__mul__")


def loaded(path):
    """The library without its package, which needs NumPy: the machine of the build may lack it."""
    spec = importlib.util.spec_from_file_location("_boxplus", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def signatures(documentation, name=""):
    """The overloads of a function, or the type of an attribute: "name(x: float) -> int"."""
    found = re.findall(rf"^(?:\d+\. )?({name}\(.*\) -> .*)$", documentation or "", re.MULTILINE)
    for pattern, text in TYPES:
        found = [re.sub(pattern, text, signature) for signature in found]
    return found


def function_of(signature):
    node = ast.parse(f"def {signature}: ...").body[0]
    positional, by_name = node.args.args, node.args.kwonlyargs
    defaults = [None] * (len(positional) - len(node.args.defaults)) + node.args.defaults + node.args.kw_defaults
    for argument, default in zip(positional + by_name, defaults):
        if argument.arg == "arg0":
            argument.arg = "other"
        if argument.arg == "self":
            argument.annotation = None
        elif ast.unparse(argument.annotation) in ("handle", "object"):
            text = ARGUMENTS.get(argument.arg, "handle")
            argument.annotation = ast.Name(text + " | None" if default and ast.unparse(default) == "None" else text)
    if node.args.kwarg:
        node.args.kwarg = ast.arg("changes", ast.Name("Any"))
    return ast.unparse(node)


def functions(name, function):
    """The texts of a function: one for each overload."""
    is_static = isinstance(function, staticmethod)
    found = [function_of(signature) for signature in signatures((function.__func__ if is_static else function).__doc__, name)]
    decorators = "@overload\n" * (len(found) > 1) + "@staticmethod\n" * is_static
    return [decorators + text for text in found]


def attribute(name, value, enumerations):
    """The text of an attribute. If it can be set, it takes any sequence, and the text of an enumerator."""
    returned = signatures(value.fget.__doc__)[0].split(" -> ")[1]
    if value.fset is None:
        return f"@property\ndef {name}(self) -> {returned}: ..."
    takes_text = returned in [enumeration.__qualname__ for enumeration in enumerations]
    return f"{name}: " + (f"{returned} | str" if takes_text else returned.replace("list[", "Sequence["))


def class_of(cls, enumerations):
    lines = []
    for name, value in vars(cls).items():
        if name.startswith("_") and name not in OPERATORS or name in ("name", "value") and cls in enumerations:
            continue
        if isinstance(value, type):
            lines += [class_of(value, enumerations)]
        elif isinstance(value, property):
            lines += [attribute(name, value, enumerations)]
        elif name == "__init__" and hasattr(cls, "parameter_names"):  # a camera: from nothing, or from its parameters
            numbers = "".join(f", {parameter}: float" for parameter in cls.parameter_names)
            lines += [f"@overload\ndef __init__(self{text}) -> None: ..." for text in ("", numbers)]
        elif callable(value) or isinstance(value, staticmethod):
            lines += functions(name, value)
        else:
            lines += [f"{name}: {'tuple[str, ...]' if isinstance(value, tuple) else type(value).__qualname__}"]
    bases = [base.__name__ for base in cls.__bases__ if not base.__name__.startswith(("_", "pybind11"))]
    bases = ["Enum"] if cls in enumerations else bases
    return f"class {cls.__name__}({', '.join(bases)}):\n" + textwrap.indent("\n".join(lines) or "...", "    ")


def vector_of(size):
    numbers = "".join(f"x{i}: float, " for i in range(size))
    return f"class Vector{size}(Array):\n    def __init__(self, {numbers}/) -> None: ..."


def enumerations_in(scope):
    for value in vars(scope).values():
        if isinstance(value, type):
            yield from [value] if hasattr(value, "__members__") else enumerations_in(value)


def stubs_of(module):
    """The types of all names of the module, and of the classes of vectors, which the package adds."""
    public = {name: value for name, value in vars(module).items() if not name.startswith("_")}
    enumerations = list(enumerations_in(module))
    lines = [vector_of(size) for size in range(1, 13)]
    lines += ["Camera = " + " | ".join(name for name, value in public.items() if hasattr(value, "parameter_names"))]
    for name, value in public.items():
        lines += [class_of(value, enumerations)] if isinstance(value, type) else functions(name, value)
    return ast.parse("\n".join(lines))


def name_of(node):
    if isinstance(node, ast.Assign):
        return node.targets[0].id
    return node.target.id if isinstance(node, ast.AnnAssign) else getattr(node, "name", None)


def merge(written, generated):
    """Adds to a module or class what it lacks."""
    own = {name_of(node): node for node in written.body}
    for node in generated.body:
        if name_of(node) not in own:
            written.body.append(node)
        elif isinstance(node, ast.ClassDef):
            own[node.name].bases = own[node.name].bases or node.bases
            merge(own[node.name], node)


def replace_unknown_types(tree):
    imported = [alias.asname or alias.name for node in tree.body if isinstance(node, (ast.Import, ast.ImportFrom))
                for alias in node.names]
    known = {*dir(builtins), *imported, *map(name_of, tree.body)}
    for parent in ast.walk(tree):
        if isinstance(parent, (ast.FunctionDef, ast.AnnAssign)):
            for node in ast.walk(parent):
                if isinstance(node, ast.Name) and node.id not in known and node is not getattr(parent, "target", None):
                    print(f"make_stubs.py: unknown type {node.id} in {ast.unparse(parent)}", file=sys.stderr)
                    node.id = "Any"


def main():
    library, written, output = map(pathlib.Path, sys.argv[1:])
    tree = ast.parse(written.read_text(encoding="utf-8"))
    merge(tree, stubs_of(loaded(library)))
    replace_unknown_types(tree)
    head = "# SPDX-License-Identifier: BSD-3-Clause\n# make_stubs.py has written this file.\n"
    output.write_text(head + ast.unparse(tree) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that folders include only lower folders, that no includes form a circle, and that public headers include no
private headers.

    check_includes.py [--circles] [ROOT]

Reads all C++ files below ROOT, which is the project by default. Checks each #include that finds a file of the
project: first next to the including file and in the folders above it, then in SEARCHED. Prints file:line of each
include that the table ALLOWED does not permit. The public headers of the g2o API must not include boxplus/ at all,
because they are C++17.

A unit is a header with its source: include/boxplus/a/b.h, src/a/b.h and src/a/b.cpp are the unit a/b, and
g2o/include/g2o/a/b.h and g2o/src/a/b.cpp are the unit g2o/a/b. Units must not include each other in a circle. The
children of a folder are its subfolders, each with all that is in them, and the units directly in it. They must not
include each other in a circle, either. The table CIRCLES contains the exceptions. With --circles, prints all circles
with their includes instead.
"""

import collections
import math
import os
import pathlib
import re
import sys

# The files of the folder on the left may include files of their own folder and of the folders on the right. The
# lowest folder comes first. ARCHITECTURE.md explains the order.
ALLOWED = {
    "platform": "",
    "base": "platform",
    "kernels": "",
    "autodiff": "base",
    "manifold": "base autodiff",
    "robust": "base",
    "graph": "base kernels manifold autodiff robust",
    "linear": "base platform kernels",
    "gauge": "base manifold autodiff robust graph",
    "options": "base graph linear gauge",
    "plan": "base platform manifold autodiff robust graph linear gauge",
    "linearize": "base kernels manifold autodiff robust graph linear plan",
    "system": "base graph linear gauge options plan linearize",
    "algorithm": "base linear options system",
    "guess": "base manifold graph linear options plan",
    "covariance": "base graph linear gauge options plan linearize system",
    "diagnose": "base manifold robust graph linear gauge options plan",
    "optimize": "base robust graph linear gauge options plan linearize system algorithm guess covariance diagnose",
    "outliers": "base manifold robust graph options optimize",
    "certify": "base manifold graph linear options guess optimize",
    "settings": "base robust graph options outliers",
    "types": "base kernels manifold autodiff robust graph covariance",
    "incremental":
        "base autodiff robust graph linear gauge options plan linearize optimize outliers types",
    "io": "base platform manifold autodiff robust graph types",
    "trajectory": "base manifold autodiff robust graph types io",
    # A library of its own.
    "viewer":
        "base platform manifold graph linear options plan covariance diagnose optimize outliers settings types io trajectory",
    # Checkers and simulators with which users test their own types.
    "testing": "base manifold autodiff robust graph types",
}
LIBRARY = set(ALLOWED) - {"testing", "viewer"}
MAY_INCLUDE = {folder: set(below.split()) | {folder} for folder, below in ALLOWED.items()}
MAY_INCLUDE["boxplus.h"] = LIBRARY  # the umbrella header
# Programs may include all folders. Examples, which users copy, fuzz targets and the Python module must not include
# private headers.
PROGRAMS = ("apps", "bench", "examples", "fuzz", "g2o", "plugins", "python", "tests", "viewer")
PUBLIC_ONLY = ("examples", "fuzz", "python")
for folder in set(PROGRAMS) - set(ALLOWED):
    MAY_INCLUDE[folder] = {*ALLOWED, "boxplus.h", *PROGRAMS}
PUBLIC, PRIVATE = ("include/", "g2o/include/"), ("src/", "g2o/src/")

# The circles that may exist, each with its reason. The name of a subfolder ends with a slash. A circle of more than
# three members has the name of the first one, and the number of the others.
CIRCLES = {
    "g2o/core/ g2o/engine/":
        "The engine works on the classes of the API, whose optimizer runs on the engine.",
    "g2o/core/base_edge and 16 more":
        "In g2o, a graph owns caches and actions that refer to it, and clients rely on the includes of its headers.",
    "graph/graph graph/incidence":
        "The index of the edges of a vertex is a private part of Graph, in a file of its own.",
    "types/ba/reprojection types/ba/reprojection_lanes":
        "Every pool of these edges must find the kernels in the library, which are declared for these edges.",
}

SEARCHED = ("include", "src", "g2o/include", "g2o/src", "plugins/mpi/include", "plugins/mpi/src", "plugins/petsc/include",
            "plugins/petsc/src", "apps/boxplus", "apps/boxplus_mpi", "apps/g2o_programs")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"]', re.MULTILINE)
FUZZED = re.compile(r"/src/\(([a-z|]+)\)/")  # in fuzz/CMakeLists.txt, which names the files of kernels one by one
BEFORE_UNIT = re.compile(r"(?:include/boxplus|src|(g2o/)(?:include/g2o|src))/")

# An include of a file of the project. `file` and `target` are relative to the root, and `name` is as it is written.
Include = collections.namedtuple("Include", "file line name target")


def read_sources(root, folders=("include", "src", *PROGRAMS)):
    """The texts of the C++ files in these folders, by their paths relative to the root, sorted."""
    texts = {}
    for folder in folders:
        for parent, subfolders, names in os.walk(root / folder):
            subfolders[:] = [name for name in subfolders if name != "node_modules"]
            for name in names:
                if name.endswith((".h", ".hpp", ".cpp", ".cc")):
                    path = pathlib.Path(parent, name)
                    texts[path.relative_to(root).as_posix()] = path.read_text(encoding="utf-8")
    return dict(sorted(texts.items()))


def includes_of(texts):
    """All includes of files in `texts` by files in `texts`."""
    for file, text in texts.items():
        above = [file[:slash.start()] for slash in re.finditer("/", file)][::-1] + [""]
        for match in INCLUDE.finditer(text):
            quote, name = match.groups()
            places = (*above, *SEARCHED) if quote == '"' else SEARCHED
            paths = (os.path.normpath(os.path.join(place, name)) for place in places)
            if target := next((path for path in paths if path in texts), None):
                yield Include(file, text.count("\n", 0, match.start(1)) + 1, name, target)


def row_of(file):
    """The name of the row in MAY_INCLUDE for a file: "graph", "boxplus.h", "apps"."""
    parts = file.split("/")
    return parts[2] if parts[0] == "include" else parts[1] if parts[0] == "src" else parts[0]


def violations(texts, includes):
    for file in texts:
        if row_of(file) not in MAY_INCLUDE:
            yield f"{file}:1: folder '{row_of(file)}' has no row in the table of scripts/check_includes.py"
    for file, line, name, target in includes:
        row, to = row_of(file), row_of(target)
        if to not in MAY_INCLUDE.get(row, (to,)):
            yield f"{file}:{line}: {row} must not include {to} ({name})"
        if file.startswith(PUBLIC) and not target.startswith(PUBLIC):
            yield f"{file}:{line}: a public header must not include a private one ({name})"
        if file.startswith("g2o/include/") and target.startswith("include/"):
            yield f"{file}:{line}: the g2o API must not include boxplus ({name})"
        if row in PUBLIC_ONLY and target.startswith(PRIVATE):
            yield f"{file}:{line}: {row}/ must not include a private header ({name})"


def unit_of(file):
    tree = BEFORE_UNIT.match(file)
    return ((tree[1] or "") + file[tree.end():] if tree else file).rsplit(".", 1)[0]


def children_of_common_folder(*units):
    """The children of the lowest folder that contains both units: a/x and a/b/c are in the children a/x and a/b/."""
    paths = [re.findall("[^/]+/?", unit) for unit in units]
    depth = len(os.path.commonprefix(paths)) + 1
    return tuple("".join(path[:depth]) for path in paths)


def components(graph):
    """The strongly connected components with more than one node, each sorted (Tarjan 1972)."""
    number, lowest, stack, found = {}, {}, [], []

    def visit(node):
        number[node] = lowest[node] = len(number)
        stack.append(node)
        for other in graph.get(node, ()):
            if other not in number:
                visit(other)
            lowest[node] = min(lowest[node], lowest[other])
        if lowest[node] == number[node]:
            members = [stack.pop()]
            while members[-1] != node:
                members.append(stack.pop())
            lowest.update(dict.fromkeys(members, math.inf))  # their component is complete
            if len(members) > 1:
                found.append(sorted(members))

    sys.setrecursionlimit(10_000)
    for node in graph:
        if node not in number:
            visit(node)
    return found


def circles_of(includes):
    """The circles of units, and of children of a folder: {name: includes between its members}."""
    of_units, of_children = {}, {}  # node -> {other node: includes}
    for include in includes:
        units = unit_of(include.file), unit_of(include.target)
        if units[0] != units[1]:
            for graph, (node, other) in ((of_units, units), (of_children, children_of_common_folder(*units))):
                graph.setdefault(node, {}).setdefault(other, []).append(include)
    circles = {}
    for graph in of_units, of_children:
        for members in components(graph):
            if graph is of_units or any(member.endswith("/") for member in members):
                name = " ".join(members) if len(members) < 4 else f"{members[0]} and {len(members) - 1} more"
                circles[name] = [include for node in members for other, between in graph[node].items()
                                 if other in members for include in between]
    return dict(sorted(circles.items()))


def differences(circles, allowed):
    for name in circles.keys() - allowed.keys():
        file, line, *_ = circles[name][0]
        yield f"{file}:{line}: a circle of includes: {name} (--circles prints them all)"
    for name in allowed.keys() - circles.keys():
        yield f"scripts/check_includes.py:1: the table CIRCLES has a circle that does not exist: {name}"


def missing_in_fuzz_targets(root, texts, includes):
    """Private headers that the sources of the fuzz targets include, although these lack the folder of their source."""
    file = root / "fuzz" / "CMakeLists.txt"
    if not file.exists():
        return
    compiled = FUZZED.search(file.read_text(encoding="utf-8"))[1].split("|")
    for file, line, name, target in includes:
        has_source = target.startswith("src/") and target.removesuffix(".h") + ".cpp" in texts
        if file.startswith("src/") and row_of(file) in compiled and has_source and \
                row_of(target) not in (*compiled, "kernels"):
            yield f"{file}:{line}: fuzz/CMakeLists.txt lacks the folder {row_of(target)} ({name})"


def problems(root, allowed_circles):
    """All that the script reports about the files below `root`."""
    texts = read_sources(root)
    includes = list(includes_of(texts))
    return [*violations(texts, includes), *missing_in_fuzz_targets(root, texts, includes),
            *sorted(differences(circles_of(includes), allowed_circles))]


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--circles"]
    root = pathlib.Path(arguments[0] if arguments else pathlib.Path(__file__).parent.parent).resolve()
    if "--circles" in sys.argv:
        for name, includes in circles_of(includes_of(read_sources(root))).items():
            print(name, *(f"    {i.file}:{i.line}: {i.target}" for i in includes), sep="\n")
        return 0
    found = problems(root, CIRCLES)
    print(*found, sep="\n", end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that folders include only lower folders, that subfolders of src include each other in one direction, and that
public headers include no private headers.

    check_includes.py [ROOT]

Reads all C++ files below ROOT, which is the project by default. Checks each #include of a public header
("boxplus/<folder>/...") or of a private header ("<folder>/..."). Prints file:line of each include that the table
ALLOWED does not permit. The public headers of the g2o API must not include boxplus/ at all, because they are
C++17.
"""

import pathlib
import re
import sys

# The files of the folder on the left may include files of their own folder and of the folders on the right. The
# lowest folder comes first. ARCHITECTURE.md explains the order.
ALLOWED = {
    "base": "",
    "kernels": "",
    "autodiff": "base",
    "manifold": "base autodiff",
    "robust": "base",
    "graph": "base kernels manifold autodiff robust",
    "linear": "base kernels",
    "gauge": "base manifold autodiff robust graph",
    "options": "base graph linear gauge",
    "plan": "base manifold autodiff robust graph linear gauge",
    "linearize": "base kernels manifold autodiff robust graph linear plan",
    "system": "base graph linear gauge options plan linearize",
    "algorithm": "base linear options system",
    "guess": "base manifold graph linear options plan",
    "covariance": "base graph linear gauge options plan linearize system",
    "diagnose": "base manifold robust graph linear gauge options plan",
    "optimize": "base robust graph linear gauge options plan linearize system algorithm guess covariance diagnose",
    "outliers": "base manifold robust graph options optimize",
    "certify": "base manifold graph linear options guess optimize",
    "types": "base kernels manifold autodiff robust graph covariance",
    "io": "base manifold autodiff robust graph types",
    "trajectory": "base manifold autodiff robust graph types io",
    # A library of its own.
    "viewer": "base manifold graph linear options plan guess algorithm covariance diagnose optimize outliers types io trajectory",
    # Checkers and simulators with which users test their own types.
    "testing": "base manifold autodiff robust graph types",
}
LIBRARY = set(ALLOWED) - {"testing", "viewer"}
MAY_INCLUDE = {folder: set(below.split()) | {folder} for folder, below in ALLOWED.items()}
MAY_INCLUDE["boxplus.h"] = LIBRARY  # the umbrella header
# Programs may include all folders. Examples, which users copy, fuzz targets and the Python module must not include
# private headers.
PROGRAMS = ("apps", "bench", "examples", "fuzz", "g2o", "python", "tests", "viewer")
PUBLIC_ONLY = ("examples", "fuzz", "python")
for folder in PROGRAMS:
    MAY_INCLUDE[folder] = set(ALLOWED) | {"boxplus.h"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def folder_of_file(path):
    """The name of the row in ALLOWED for a file, whose path is relative to the root."""
    parts = path.parts
    if parts[0] in PROGRAMS:
        return parts[0]
    inside = parts[2:] if parts[0] == "include" else parts[1:]
    return inside[0] if inside else None


def target_of_include(root, path, quote, name):
    """(folder, is_private) of an included file of the project, or None for any other file."""
    parts = pathlib.PurePosixPath(name).parts
    if parts[0] == "boxplus":
        return parts[1], False
    if quote == '"':
        # The path is relative to src/ (such as "graph/x.h") or to the folder of the including file.
        for base in (root / "src", (root / path).parent):
            file = (base / name).resolve()
            if file.is_file() and file.is_relative_to((root / "src").resolve()):
                return file.relative_to((root / "src").resolve()).parts[0], True
    return None


def violations(root):
    files = (p for top in ("include", "src", *PROGRAMS) for p in (root / top).rglob("*"))
    for file in sorted(f for f in files if f.suffix in (".h", ".hpp", ".cpp", ".cc")):
        path = file.relative_to(root)
        folder = folder_of_file(path)
        text = file.read_text(encoding="utf-8")
        if folder not in MAY_INCLUDE:
            yield f"{path}:1: folder '{folder}' has no row in the table of scripts/check_includes.py"
            continue
        for match in INCLUDE.finditer(text):
            target = target_of_include(root, path, *match.groups())
            if target is None:
                continue
            where = f"{path}:{text.count(chr(10), 0, match.start(1)) + 1}"
            to, private = target
            if to not in MAY_INCLUDE[folder]:
                yield f"{where}: {folder} must not include {to} ({match.group(2)})"
            if private and path.parts[0] == "include":
                yield f"{where}: a public header must not include a private one ({match.group(2)})"
            if private and folder in PUBLIC_ONLY:
                yield f"{where}: {folder}/ must not include a private header ({match.group(2)})"


def circles(root):
    """Circles among the subfolders of a folder of src, such as io/bal and io/colmap."""
    includes = {}  # subfolder -> {other subfolder of the same folder: where}
    for file in sorted((root / "src").rglob("*")):
        parts = file.relative_to(root / "src").parts
        if file.suffix not in (".h", ".cpp") or len(parts) < 3:
            continue
        text = file.read_text(encoding="utf-8")
        for match in INCLUDE.finditer(text):
            other = pathlib.PurePosixPath(match.group(2)).parts
            if match.group(1) == '"' and len(other) > 2 and other[0] == parts[0] and other[1] != parts[1]:
                line = text.count("\n", 0, match.start(1)) + 1
                where = f"{file.relative_to(root)}:{line}"
                includes.setdefault(parts[:2], {}).setdefault(other[:2], where)

    def reaches(start, end, seen):
        if start == end:
            return True
        seen.add(start)
        return any(reaches(next_, end, seen) for next_ in includes.get(start, {}) if next_ not in seen)

    for folder, others in includes.items():
        for other, where in others.items():
            if reaches(other, folder, set()):
                yield f"{where}: {'/'.join(folder)} and {'/'.join(other)} include each other"


def violations_of_g2o(root):
    for file in sorted((root / "g2o" / "include").rglob("*.h*")):
        text = file.read_text(encoding="utf-8")
        for match in INCLUDE.finditer(text):
            if match.group(2).startswith("boxplus/"):
                line = text.count("\n", 0, match.start(1)) + 1
                yield f"{file.relative_to(root)}:{line}: the g2o API must not include boxplus ({match.group(2)})"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    found = [*violations(root), *circles(root), *violations_of_g2o(root)]
    print(*found, sep="\n", end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the core test suites that the changes since a commit may have touched, such as "optimize io".

    changed_suites.py COMMIT [ROOT]

A suite is the folder of the same name in tests/. It is touched by a change of its own files, of a folder of src/ or
include/boxplus/ that its sources include, and of a folder that these may include (the table of check_includes.py). A
change of anything else that a build reads, such as CMakeLists.txt or a header directly in tests/, touches all suites.
"""

import pathlib
import subprocess
import sys

import check_includes

CORE = ("platform", "base", "kernels", "manifold", "autodiff", "robust", "graph", "linear", "gauge", "plan", "linearize", "system",
        "algorithm", "optimize", "incremental", "io")
G2O = "g2o_core"
BUILD = ("cmake", "scripts/debian-packages")  # beginnings of paths that every suite depends on
IGNORED = (".md", ".py", ".pyi", ".ts", ".mjs", ".css", ".html")


def below(folders):
    """The folders, and all that they may include."""
    known, left = set(), [folder for folder in folders if folder in check_includes.ALLOWED]
    while left:
        folder = left.pop()
        if folder not in known:
            known.add(folder)
            left += check_includes.ALLOWED[folder].split()
    return known


def folders_of_suite(includes, suite):
    """The folders of the library on which the sources of a suite depend."""
    used = {suite, *(check_includes.row_of(include.target) for include in includes)}
    return set(check_includes.ALLOWED) if "boxplus.h" in used else below(used)


def touched(root, changed):
    everything, folders, tests = False, set(), set()
    for path in changed:
        parts = path.split("/")
        if path.endswith(IGNORED):
            continue
        if path.endswith("CMakeLists.txt") or path.startswith(BUILD) or path.startswith("CMakePresets"):
            everything = True
        elif parts[0] == "src" or path.startswith("include/boxplus/"):
            folders.add(parts[1 if parts[0] == "src" else 2])
        elif parts[0] in ("tests", "g2o"):
            tests.add(parts[1] if parts[0] == "tests" and len(parts) > 2 else parts[0])
    if everything or "tests" in tests:
        return [*CORE, G2O]
    texts = check_includes.read_sources(root, ("include", "src", "tests"))
    includes = list(check_includes.includes_of(texts))
    suites = []
    for suite in CORE:
        own = [include for include in includes if include.file.startswith(f"tests/{suite}/")]
        # Tests of one folder may use headers of another one.
        used_tests = {include.target.split("/")[1] for include in own if include.target.startswith("tests/")}
        if tests & {suite, *used_tests} or folders & folders_of_suite(own, suite):
            suites.append(suite)
    return suites + [G2O] * bool(folders or "g2o" in tests)


def main():
    root = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else pathlib.Path(__file__).parent.parent).resolve()
    listing = subprocess.run(["git", "-C", root, "diff", "--name-only", sys.argv[1]], capture_output=True, text=True,
                             check=True).stdout
    print(*touched(root, listing.split()))


if __name__ == "__main__":
    main()

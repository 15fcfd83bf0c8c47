#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the C++ in README.md is what examples/01_pose_graph.cpp compiles: every line of it, in order."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
shown = re.search(r"```cpp\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL)
example = iter((ROOT / "examples/01_pose_graph.cpp").read_text(encoding="utf-8").splitlines())
if not shown:
    sys.exit("README.md shows no C++")
for line in shown[1].splitlines():
    if line.strip() and line not in example:
        sys.exit(f"README.md: not in examples/01_pose_graph.cpp, or out of order: {line}")

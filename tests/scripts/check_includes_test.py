#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check_includes.py finds each kind of wrong include, and nothing in a tree without one."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECKER = pathlib.Path(__file__).parents[2] / "scripts" / "check_includes.py"

CLEAN = {
    "include/boxplus/base/error.h": "#include <string>\n",
    "include/boxplus/graph/graph.h": '#include "boxplus/base/error.h"\n',
    "include/boxplus/linear/solver.h": '#include "boxplus/base/error.h"\n',
    "include/boxplus/testing/check_edge.h": '#include "boxplus/graph/graph.h"\n',
    "include/boxplus/boxplus.h": "#include <boxplus/graph/graph.h>\n",
    "src/graph/detail.h": "",
    "src/graph/graph.cpp": '#include "boxplus/graph/graph.h"\n\n#include "graph/detail.h"\n#include "detail.h"\n',
    "apps/boxplus/main.cpp": '#include "boxplus/boxplus.h"\n',
    "g2o/include/g2o/core/solver.h": '#include "g2o/core/factory.h"\n',
    "tests/graph/graph_test.cpp": '#include "boxplus/testing/check_edge.h"\n#include "graph/detail.h"\n',
}

def check(changes):
    """Exit status and lines of the checker on the clean tree with these files written over it."""
    with tempfile.TemporaryDirectory() as root:
        for name, text in {**CLEAN, **changes}.items():
            path = pathlib.Path(root, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        done = subprocess.run([sys.executable, CHECKER, root], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout.splitlines()

class CheckIncludes(unittest.TestCase):
    def assert_caught(self, changes, line):
        self.assertEqual(check(changes), (1, [line]))

    def test_a_tree_of_downward_includes_passes(self):
        self.assertEqual(check({}), (0, []))

    def test_an_upward_include_is_caught_with_its_line(self):
        self.assert_caught(
            {"include/boxplus/base/error.h": '#include <string>\n#include "boxplus/graph/graph.h"\n'},
            "include/boxplus/base/error.h:2: base must not include graph (boxplus/graph/graph.h)")

    def test_linear_knows_nothing_of_graph(self):
        self.assert_caught(
            {"src/linear/solver.cpp": "#include <boxplus/graph/graph.h>\n"},
            "src/linear/solver.cpp:1: linear must not include graph (boxplus/graph/graph.h)")

    def test_an_upward_include_of_a_private_header_is_caught(self):
        self.assert_caught(
            {"src/base/error.cpp": '#include "graph/detail.h"\n'},
            "src/base/error.cpp:1: base must not include graph (graph/detail.h)")

    def test_an_example_and_a_fuzz_target_include_no_private_header(self):
        for folder in ("examples", "fuzz"):
            self.assert_caught(
                {f"{folder}/x.cpp": '#include "graph/detail.h"\n'},
                f"{folder}/x.cpp:1: {folder}/ must not include a private header (graph/detail.h)")

    def test_a_benchmark_and_the_g2o_api_may_include_private_headers(self):
        self.assertEqual(check({"bench/x.cpp": '#include "graph/detail.h"\n',
                                "g2o/src/x.cpp": '#include "graph/detail.h"\n'}), (0, []))

    def test_a_public_header_includes_no_private_one(self):
        self.assert_caught(
            {"include/boxplus/graph/graph.h": '#include "graph/detail.h"\n'},
            "include/boxplus/graph/graph.h:1: a public header must not include a private one (graph/detail.h)")

    def test_the_library_does_not_include_the_law_checkers(self):
        self.assert_caught(
            {"src/optimize/optimize.cpp": '#include "boxplus/testing/check_edge.h"\n'},
            "src/optimize/optimize.cpp:1: optimize must not include testing (boxplus/testing/check_edge.h)")

    def test_the_library_does_not_include_the_umbrella(self):
        self.assert_caught(
            {"src/optimize/optimize.cpp": '#include "boxplus/boxplus.h"\n'},
            "src/optimize/optimize.cpp:1: optimize must not include boxplus.h (boxplus/boxplus.h)")

    def test_a_new_folder_needs_a_row(self):
        self.assert_caught(
            {"src/surprise/surprise.cpp": ""},
            "src/surprise/surprise.cpp:1: folder 'surprise' has no row in the table of scripts/check_includes.py")

    def test_a_header_of_the_g2o_api_that_includes_the_engine_is_caught(self):
        self.assert_caught(
            {"g2o/include/g2o/core/solver.h": '#include "boxplus/graph/graph.h"\n'},
            "g2o/include/g2o/core/solver.h:1: the g2o API must not include boxplus (boxplus/graph/graph.h)",
        )

if __name__ == "__main__":
    unittest.main()

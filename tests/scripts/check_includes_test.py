#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check_includes.py reports each kind of forbidden include, and nothing else."""

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
    """Writes CLEAN and then these files to a folder. Returns the exit status and the lines of the script for it."""
    with tempfile.TemporaryDirectory() as root:
        for name, text in {**CLEAN, **changes}.items():
            path = pathlib.Path(root, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        done = subprocess.run([sys.executable, CHECKER, root], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout.splitlines()

class CheckIncludes(unittest.TestCase):
    def assert_reported(self, changes, line):
        self.assertEqual(check(changes), (1, [line]))

    def test_a_tree_without_forbidden_includes_passes(self):
        self.assertEqual(check({}), (0, []))

    def test_an_include_of_a_higher_layer_is_reported_with_its_line(self):
        self.assert_reported(
            {"include/boxplus/base/error.h": '#include <string>\n#include "boxplus/graph/graph.h"\n'},
            "include/boxplus/base/error.h:2: base must not include graph (boxplus/graph/graph.h)")

    def test_linear_must_not_include_graph(self):
        self.assert_reported(
            {"src/linear/solver.cpp": "#include <boxplus/graph/graph.h>\n"},
            "src/linear/solver.cpp:1: linear must not include graph (boxplus/graph/graph.h)")

    def test_an_include_of_a_private_header_of_a_higher_layer_is_reported(self):
        self.assert_reported(
            {"src/base/error.cpp": '#include "graph/detail.h"\n'},
            "src/base/error.cpp:1: base must not include graph (graph/detail.h)")

    def test_examples_and_fuzz_targets_must_not_include_private_headers(self):
        for folder in ("examples", "fuzz"):
            self.assert_reported(
                {f"{folder}/x.cpp": '#include "graph/detail.h"\n'},
                f"{folder}/x.cpp:1: {folder}/ must not include a private header (graph/detail.h)")

    def test_benchmarks_and_the_g2o_api_may_include_private_headers(self):
        self.assertEqual(check({"bench/x.cpp": '#include "graph/detail.h"\n',
                                "g2o/src/x.cpp": '#include "graph/detail.h"\n'}), (0, []))

    def test_a_public_header_must_not_include_a_private_header(self):
        self.assert_reported(
            {"include/boxplus/graph/graph.h": '#include "graph/detail.h"\n'},
            "include/boxplus/graph/graph.h:1: a public header must not include a private one (graph/detail.h)")

    def test_the_library_must_not_include_the_headers_in_testing(self):
        self.assert_reported(
            {"src/optimize/optimize.cpp": '#include "boxplus/testing/check_edge.h"\n'},
            "src/optimize/optimize.cpp:1: optimize must not include testing (boxplus/testing/check_edge.h)")

    def test_the_library_must_not_include_boxplus_h(self):
        self.assert_reported(
            {"src/optimize/optimize.cpp": '#include "boxplus/boxplus.h"\n'},
            "src/optimize/optimize.cpp:1: optimize must not include boxplus.h (boxplus/boxplus.h)")

    def test_a_folder_without_a_row_in_the_table_is_reported(self):
        self.assert_reported(
            {"src/surprise/surprise.cpp": ""},
            "src/surprise/surprise.cpp:1: folder 'surprise' has no row in the table of scripts/check_includes.py")

    def test_subfolders_that_include_each_other_are_reported(self):
        one_way = {"src/graph/a/x.cpp": '#include "graph/b/y.h"\n', "src/graph/b/z.h": '#include "graph/c/z.h"\n'}
        self.assertEqual(check(one_way), (0, []))
        self.assertEqual(
            check({**one_way, "src/graph/c/z.cpp": '\n#include "graph/a/x.h"\n'}),
            (1, ["src/graph/a/x.cpp:1: graph/a and graph/b include each other",
                 "src/graph/b/z.h:1: graph/b and graph/c include each other",
                 "src/graph/c/z.cpp:2: graph/c and graph/a include each other"]))

    def test_a_public_header_of_the_g2o_api_must_not_include_boxplus(self):
        self.assert_reported(
            {"g2o/include/g2o/core/solver.h": '#include "boxplus/graph/graph.h"\n'},
            "g2o/include/g2o/core/solver.h:1: the g2o API must not include boxplus (boxplus/graph/graph.h)",
        )

if __name__ == "__main__":
    unittest.main()

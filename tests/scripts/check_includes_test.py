#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check_includes.py reports each kind of forbidden include, and nothing else."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "scripts"))

import check_includes  # noqa: E402

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
CIRCLE = "a circle of includes"


def check(changes, allowed_circles=()):
    """Writes CLEAN and then these files to a folder. Returns the lines of the script for it."""
    with tempfile.TemporaryDirectory() as root:
        for name, text in {**CLEAN, **changes}.items():
            path = pathlib.Path(root, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return check_includes.problems(pathlib.Path(root), dict.fromkeys(allowed_circles, "reason"))


class CheckIncludes(unittest.TestCase):
    def assert_reported(self, changes, line):
        # An include of a higher folder often closes a circle, too.
        self.assertEqual([found for found in check(changes) if CIRCLE not in found], [line])

    def assert_circle(self, changes, where, name):
        self.assertEqual(check(changes), [f"{where}: {CIRCLE}: {name} (--circles prints them all)"])
        self.assertEqual(check(changes, [name]), [])

    def test_a_tree_without_forbidden_includes_passes(self):
        self.assertEqual(check({}), [])

    def test_an_include_of_a_higher_layer_is_reported_with_its_line(self):
        self.assert_reported(
            {"include/boxplus/base/error.h": '#include <string>\n#include "boxplus/graph/graph.h"\n'},
            "include/boxplus/base/error.h:2: base must not include graph (boxplus/graph/graph.h)")

    def test_a_folder_that_the_fuzz_targets_lack_is_reported(self):
        changes = {"fuzz/CMakeLists.txt": 'INCLUDE REGEX "/src/(graph|io)/|/src/kernels/x")\n',
                   "src/platform/files.h": "", "src/platform/files.cpp": "",
                   "src/kernels/add.h": "",
                   "src/base/file.cpp": '#include "platform/files.h"\n',
                   "src/io/file.cpp": '#include "kernels/add.h"\n#include "platform/files.h"\n'}
        line = "src/io/file.cpp:2: fuzz/CMakeLists.txt lacks the folder platform (platform/files.h)"
        self.assertIn(line, check(changes))
        changes["fuzz/CMakeLists.txt"] = 'INCLUDE REGEX "/src/(graph|io|platform)/")\n'
        self.assertNotIn(line, check(changes))

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
                                "g2o/src/x.cpp": '#include "graph/detail.h"\n'}), [])

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

    def test_the_library_must_not_include_a_program(self):
        self.assert_reported(
            {"viewer/scene/errors.h": "", "src/io/x.cpp": '#include "viewer/scene/errors.h"\n',
             "apps/boxplus/a.h": "", "tests/x.cpp": '#include "apps/boxplus/a.h"\n'},
            "src/io/x.cpp:1: io must not include viewer (viewer/scene/errors.h)")

    def test_the_viewer_must_not_include_the_command(self):
        self.assert_reported(
            {"apps/boxplus/a.h": "", "viewer/x.cpp": '#include "apps/boxplus/a.h"\n'},
            "viewer/x.cpp:1: viewer must not include apps (apps/boxplus/a.h)")

    def test_a_relative_include_is_followed(self):
        self.assert_reported(
            {"src/base/x.cpp": '#include "../graph/detail.h"\n'},
            "src/base/x.cpp:1: base must not include graph (../graph/detail.h)")

    def test_an_include_that_finds_no_file_of_the_project_is_left_out(self):
        self.assertEqual(check({"src/base/x.cpp": '#include "zlib.h"\n#include <graph.h>\n'}), [])

    def test_units_that_include_each_other_are_a_circle(self):
        self.assert_circle(
            {"include/boxplus/graph/a.h": "", "src/graph/a.cpp": '\n#include "graph/b.h"\n',
             "src/graph/b.h": '#include "boxplus/graph/a.h"\n'},
            "src/graph/a.cpp:2", "graph/a graph/b")

    def test_units_of_the_g2o_api_and_of_programs_can_be_a_circle(self):
        self.assert_circle(
            {"g2o/include/g2o/core/a.h": "", "g2o/src/core/a.cpp": '#include "core/b.h"\n',
             "g2o/src/core/b.h": "#include <g2o/core/a.h>\n"},
            "g2o/src/core/a.cpp:1", "g2o/core/a g2o/core/b")
        self.assert_circle(
            {"apps/boxplus/plot/a.h": '#include "b.h"\n', "apps/boxplus/plot/b.h": '#include "plot/a.h"\n'},
            "apps/boxplus/plot/a.h:1", "apps/boxplus/plot/a apps/boxplus/plot/b")

    def test_a_header_and_its_source_are_no_circle(self):
        self.assertEqual(check({"src/graph/detail.cpp": '#include "graph/detail.h"\n'}), [])

    def test_subfolders_that_include_each_other_are_a_circle(self):
        one_way = {"src/graph/a/x.cpp": '#include "graph/b/y.h"\n', "src/graph/b/y.h": "", "src/graph/a/x2.h": "",
                   "src/graph/b/z.h": '#include "graph/c/z.h"\n', "src/graph/c/z.h": ""}
        self.assertEqual(check(one_way), [])
        self.assert_circle({**one_way, "src/graph/c/z.cpp": '\n#include "graph/a/x2.h"\n'},
                           "src/graph/a/x.cpp:1", "graph/a/ graph/b/ graph/c/")

    def test_a_subfolder_and_a_unit_beside_it_can_be_a_circle(self):
        self.assert_circle(
            {"include/boxplus/types/ba.h": '#include "boxplus/types/ba/image.h"\n',
             "include/boxplus/types/ba/image.h": "", "src/types/ba/parts.cpp": '#include "boxplus/types/ba.h"\n'},
            "include/boxplus/types/ba.h:1", "types/ba types/ba/")

    def test_the_table_of_circles_must_not_have_a_circle_that_does_not_exist_or_has_grown(self):
        obsolete = "scripts/check_includes.py:1: the table CIRCLES has a circle that does not exist: "
        self.assertEqual(check({}, ["graph/a and 3 more"]), [f"{obsolete}graph/a and 3 more"])
        ring = {f"src/graph/{a}.h": f'#include "graph/{b}.h"\n' for a, b in ("ab", "bc", "cd", "de", "ea")}
        self.assertEqual(check(ring, ["graph/a and 4 more"]), [])
        self.assertIn(f"{obsolete}graph/a and 3 more", check(ring, ["graph/a and 3 more"]))

    def test_a_public_header_of_the_g2o_api_must_not_include_boxplus(self):
        self.assert_reported(
            {"g2o/include/g2o/core/solver.h": '#include "boxplus/graph/graph.h"\n'},
            "g2o/include/g2o/core/solver.h:1: the g2o API must not include boxplus (boxplus/graph/graph.h)")


if __name__ == "__main__":
    unittest.main()

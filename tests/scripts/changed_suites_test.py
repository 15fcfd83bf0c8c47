#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/changed_suites.py names each core suite that a change may have touched."""

import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import changed_suites  # noqa: E402


def touched(*changed):
    return changed_suites.touched(ROOT, changed)


class ChangedSuites(unittest.TestCase):
    ALL = [*changed_suites.CORE, changed_suites.G2O]

    def test_a_document_touches_no_suite(self):
        self.assertEqual(touched("README.md", "docs/solving.md", "python/boxplus/rows.py"), [])

    def test_a_program_touches_no_suite(self):
        self.assertEqual(touched("apps/boxplus/main.cpp", "viewer/server/server.cpp"), [])

    def test_a_test_touches_its_suite(self):
        self.assertEqual(touched("tests/io/text_file_test.cpp"), ["io"])

    def test_the_lowest_folder_touches_all_suites(self):
        self.assertEqual(touched("src/platform/memory.h"), self.ALL)

    def test_a_folder_touches_the_suites_that_may_include_it(self):
        suites = touched("src/plan/plan.cpp")
        self.assertTrue({"plan", "linearize", "optimize", "g2o_core"} <= {*suites})
        self.assertNotIn("base", suites)
        self.assertNotIn("autodiff", suites)

    def test_a_test_header_touches_the_suites_that_include_it(self):
        self.assertIn("optimize", touched("tests/linear/every_solver.h"))

    def test_what_every_build_reads_touches_all_suites(self):
        for path in ("CMakeLists.txt", "src/CMakeLists.txt", "cmake/BoxplusCompiler.cmake", "CMakePresets.json",
                     "tests/allocation_counter.cpp"):
            self.assertEqual(touched(path), self.ALL, path)


if __name__ == "__main__":
    unittest.main()

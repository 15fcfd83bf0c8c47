#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check_guarantees.py finds promises whose tests do not exist. It also checks docs/guarantees.md itself."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECKER = pathlib.Path(__file__).parents[2] / "scripts" / "check_guarantees.py"

TREE = {
    "tests/graph/graph_test.cpp": "TEST(Graph, IsEmpty) {}\nTEST_P(Every,\n       Works) {}\nTYPED_TEST(Type, Is) {}\n"
                                  "RC_GTEST_PROP(Random, Holds, (int x)) {}\n// TEST(Graph, IsAComment) {}\n"
                                  "TEST(Graph, DISABLED_IsOff) {}\n",
    "tests/apps/CMakeLists.txt": "file(GLOB suites *_test.py)\nforeach(suite IN LISTS suites)\n"
                                 "  add_test(NAME apps.${name} COMMAND python ${suite} $<TARGET_FILE:x> (y))\nendforeach()\n"
                                 "set(optima a.g2o 1 b.g2o 2)\nlist(POP_FRONT optima file best)\n"
                                 "add_test(NAME optimum.${file} COMMAND python optimum.py)\n"
                                 "add_test(NAME same_bits COMMAND python ${CMAKE_CURRENT_SOURCE_DIR}/same_bits.py)\n"
                                 "# add_test(NAME apps.comment COMMAND x)\n",
    "tests/apps/convert_test.py": "class A:\n    def test_keeps(self):\n        pass\n",
    "tests/apps/same_bits.py": "",
    "tests/scripts/CMakeLists.txt": "foreach(script one two)\n  add_test(NAME scripts.${script} COMMAND python\n"
                                    "    ${CMAKE_CURRENT_SOURCE_DIR}/${script}_test.py)\nendforeach()\n",
    "tests/scripts/two_test.py": "def test_two():\n    pass\n",
    "tests/compile/CMakeLists.txt": "function(must_fail name message)\n  add_test(\n    NAME must_fail.${name} COMMAND c++ ${name}.cpp)\n"
                                    "endfunction()\nmust_fail(span \"text\")\n",
}


def check(*cells, header="| Promise | Limits | Proved by |\n|---|---|---|\n"):
    """Writes TREE and a document whose rows end with these cells. Returns the exit status and the lines of the script."""
    with tempfile.TemporaryDirectory() as root:
        document = "# Guarantees\n\n" + header + "".join(f"| a promise | a limit | {cell} |\n" for cell in cells)
        for name, text in {**TREE, "docs/guarantees.md": document}.items():
            path = pathlib.Path(root, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        done = subprocess.run([sys.executable, CHECKER, root], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout.splitlines()


class CheckGuarantees(unittest.TestCase):
    def test_every_promise_of_the_project_has_tests_that_exist(self):
        done = subprocess.run([sys.executable, CHECKER], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, ""))

    def test_tests_of_all_kinds_are_found(self):
        self.assertEqual(check("`Graph.IsEmpty`, `Every.Works`, `Type.Is`, `Random.Holds`", "`apps.convert`", "`same_bits`",
                               "`optimum.a.g2o`, `optimum.b.g2o`", "`scripts.one`, `scripts.two`", "`must_fail.span`"), (0, []))

    def test_a_test_that_does_not_exist_is_reported_with_its_line(self):
        for name in ("Graph.IsFull", "apps.conver", "optimum.2", "scripts.three", "must_fail.other", "no.test"):
            self.assertEqual(check("`Graph.IsEmpty`", f"`Graph.IsEmpty`, `{name}`"),
                             (1, [f"docs/guarantees.md:6: there is no test '{name}'"]))

    def test_comments_and_disabled_tests_prove_nothing(self):
        for name in ("Graph.IsAComment", "Graph.DISABLED_IsOff", "apps.comment"):
            self.assertEqual(check(f"`Graph.IsEmpty`, `{name}`"),
                             (1, [f"docs/guarantees.md:5: there is no test '{name}'"]))

    def test_functions_of_scripts_are_found(self):
        self.assertEqual(check("`apps.convert` (`test_keeps`)", "`scripts.two` (`test_two`)"), (0, []))
        self.assertEqual(check("`apps.convert` (`test_loses`)"),
                         (1, ["docs/guarantees.md:5: tests/apps/convert_test.py has no function 'test_loses'"]))

    def test_a_function_needs_its_script(self):
        self.assertEqual(check("`Graph.IsEmpty`, `test_keeps`"),
                         (1, ["docs/guarantees.md:5: 'test_keeps' does not follow the test whose script contains it"]))

    def test_a_promise_without_a_test_is_reported(self):
        self.assertEqual(check("believe us"), (1, ["docs/guarantees.md:5: no test proves 'a promise'"]))

    def test_a_document_without_promises_is_reported(self):
        self.assertEqual(check(), (1, ["docs/guarantees.md:1: there is no table with promises"]))


if __name__ == "__main__":
    unittest.main()

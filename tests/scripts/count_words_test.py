#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/count_words.py counts the words in comments and documents, but not the words in code."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

COUNTER = pathlib.Path(__file__).parents[2] / "scripts" / "count_words.py"


def count(name, text, *options):
    """Runs the script on a folder with one file. Returns its exit status and the lines that it prints."""
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / name).write_text(text, encoding="utf-8")
        done = subprocess.run([sys.executable, COUNTER, *options, folder], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout.splitlines()


class CountWords(unittest.TestCase):
    def assert_words(self, name, text, words):
        self.assertEqual(int(count(name, text)[1][-1].split()[0]), words)

    def test_comments_in_cpp_files_are_counted_but_code_and_strings_are_not(self):
        text = 'int x = 1\'000;  // one two\n/* three\n   four */ f("// no", R"(// no)", \'"\'); // five\n'
        self.assert_words("a.cpp", text, 5)

    def test_comments_and_docstrings_in_python_files_are_counted(self):
        self.assert_words("a.py", '"""One two."""\nx = "# no"  # three\ndef f():\n    """Four\n    five."""\n', 5)

    def test_comments_in_cmake_and_shell_files_are_counted(self):
        self.assert_words("CMakeLists.txt", '# one two\nset(x "# no")  # three\n', 3)
        self.assert_words("a.sh", '#!/bin/sh\n# one\necho $# "${x#no}" \'# no\'  # two\n', 2)

    def test_code_in_documents_is_not_counted(self):
        self.assert_words("a.md", "One `no` [two](no.md) <!-- no -->\n```cpp\nno\n```\nthree\n", 3)

    def test_license_lines_are_not_counted(self):
        self.assert_words("a.h", "// SPDX-License-Identifier: BSD-3-Clause\n// one\n", 1)

    def test_frequencies_are_printed_per_1000_words(self):
        _, lines = count("a.md", "Where if when what " + "x " * 996)
        self.assertEqual(lines[-1].split(), ["1000", "1.0", "2.0", "1.0", "all"])

    def test_the_check_fails_for_too_many_where_or_too_few_if_and_when(self):
        self.assertEqual(count("a.md", "if when if when where " + "x " * 995, "--check")[0], 0)
        self.assertEqual(count("a.md", "if when if when " + "where " * 4 + "x " * 992, "--check")[0], 1)
        self.assertEqual(count("a.md", "if when if " + "x " * 997, "--check")[0], 1)

    def test_show_prints_the_lines_that_contain_a_word(self):
        _, lines = count("a.cpp", "int where;\n// one\n// Where two\n", "--show", "where")
        self.assertEqual([line.split(":", 1)[1] for line in lines], ["3: // Where two"])


if __name__ == "__main__":
    unittest.main()

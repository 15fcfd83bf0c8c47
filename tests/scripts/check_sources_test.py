#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check_sources.py finds output, exits, missing licenses and headers of other libraries, and nothing else."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECKER = pathlib.Path(__file__).parents[2] / "scripts" / "check_sources.py"
LICENSE = "// SPDX-License-Identifier: BSD-3-Clause\n"


def check(files):
    """Writes these files, with the license, to a folder. Returns the exit status and the lines of the script for it."""
    with tempfile.TemporaryDirectory() as root:
        for name, text in files.items():
            path = pathlib.Path(root, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(LICENSE + text, encoding="utf-8")
        done = subprocess.run([sys.executable, CHECKER, root], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout.splitlines()


class CheckSources(unittest.TestCase):
    def assert_reported(self, name, text, complaint):
        self.assertEqual(check({name: text}), (1, [f"{name}:2: {complaint}"]))

    def test_the_sources_of_the_project_pass(self):
        done = subprocess.run([sys.executable, CHECKER], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, ""))

    def test_a_deprecated_name_must_say_what_to_use(self):
        self.assert_reported("include/boxplus/a.h", "[[deprecated]] void f();\n", 'expected [[deprecated("use …")]]')
        self.assertEqual(check({"include/boxplus/a.h": '[[deprecated("use g()")]] void f();\n'}), (0, []))

    def test_the_changelog_and_package_xml_must_have_the_version(self):
        files = {"CMakeLists.txt": "project(boxplus VERSION 1.2.0 LANGUAGES CXX)\n", "CHANGELOG.md": "\n## 1.1.0\n"}
        self.assertEqual(check(files), (1, ["CHANGELOG.md:1: there is no section for version 1.2.0"]))
        files["CHANGELOG.md"] = "\n## 1.2.0\n"
        self.assertEqual(check(files), (0, []))
        self.assertEqual(check({**files, "package.xml": "<version>1.1.0</version>"}),
                         (1, ["package.xml:1: expected version 1.2.0, as in CMakeLists.txt"]))

    def test_each_way_to_print_exit_or_abort_is_reported(self):
        for statement, name in (("std::cout << x;", "std::cout"), ("std::cerr << x;", "std::cerr"), ("printf(x);", "printf"),
                                ("std::puts(x);", "puts"), ("fmt::print(x);", "fmt::print"), ("perror (x);", "perror"),
                                ("std::exit(1);", "exit"), ("std::abort();", "abort"), ("std::terminate();", "terminate"),
                                ("std::fprintf(file, x);", "fprintf"), ("std::fwrite(x, 1, 1, stderr);", "stderr")):
            self.assert_reported("src/a/b.cpp", f"{statement}\n", f"the library must not print, exit or abort ({name})")

    def test_comments_texts_and_other_functions_may_have_these_names(self):
        self.assertEqual(check({"src/a/b.cpp": "// std::cout << x\n/* exit(1)\n abort() */\n"
                                               'f("exit(1)", "\\"stderr", \'"\'); snprintf(x); run.exit(); on_abort(); exits(1);\n',
                                "include/boxplus/a.h": "#include <cstdio>\n"}), (0, []))

    def test_the_line_is_right_after_a_long_comment(self):
        self.assertEqual(check({"src/a.cpp": "/*\n\n*/\nexit(1);\n"})[1],
                         ["src/a.cpp:5: the library must not print, exit or abort (exit)"])

    def test_programs_and_the_g2o_api_may_print(self):
        self.assertEqual(check({"apps/boxplus/main.cpp": "std::cerr << x;\n", "g2o/src/a.cpp": "std::cerr << x;\n"}), (0, []))

    def test_the_viewer_and_the_python_module_are_quiet_too(self):
        for name in ("viewer/a.cpp", "python/src/a.cpp"):
            self.assert_reported(name, "abort();\n", "the library must not print, exit or abort (abort)")

    def test_a_header_of_a_library_that_is_not_in_the_table_is_reported(self):
        self.assert_reported("src/a.cpp", "#include <suitesparse/cholmod.h>\n", "src must not include suitesparse/cholmod.h")
        self.assert_reported("include/boxplus/a.h", "#include <fmt/format.h>\n", "include must not include fmt/format.h")
        self.assert_reported("g2o/src/core/a.cpp", "# include <cs.h>\n", "g2o/src must not include cs.h")

    def test_only_opt_in_solvers_may_include_cholmod(self):
        self.assertEqual(check({"g2o/src/solvers/suitesparse/a.cpp": "#include <cholmod.h>\n"}), (0, []))

    def test_headers_of_the_standard_of_the_compiler_and_of_the_project_are_allowed(self):
        self.assertEqual(check({"src/a.cpp": "#include <vector>\n#include <cxxabi.h>\n#include <boxplus/a.h>\n"
                                             "#include <Eigen/Core>\n#include <amd.h>\n"}), (0, []))

    def test_only_the_folder_platform_may_use_the_operating_system(self):
        posix = "#include <unistd.h>\n#include <sys/stat.h>\nsigaction(SIGINT, nullptr, &old);\n"
        for name in ("include/boxplus/a.h", "src/io/a.cpp", "viewer/a.cpp", "apps/boxplus/a.h"):
            self.assertEqual(check({name: posix}), (1, [f"{name}:{line}: only src/platform/ may use {used}" for line, used in
                                                        ((2, "unistd.h"), (3, "sys/stat.h"), (4, "sigaction"))]))
        self.assertEqual(check({"src/platform/a.cpp": posix, "g2o/src/a.cpp": posix, "plugins/mpi/src/a.cpp": posix,
                                "src/a.cpp": "#include <csignal>\nstd::signal(SIGINT, SIG_IGN);  // not sigaction()\n",
                                "viewer/server/server.cpp": "#include <sys/socket.h>\n"}), (0, []))

    def test_a_file_without_the_license_is_reported(self):
        with tempfile.TemporaryDirectory() as root:
            path = pathlib.Path(root, "src/a.cpp")
            path.parent.mkdir()
            path.write_text("int x;\n", encoding="utf-8")
            done = subprocess.run([sys.executable, CHECKER, root], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (1, f"src/a.cpp:1: the license is missing ({LICENSE[3:-1]})\n"))


if __name__ == "__main__":
    unittest.main()

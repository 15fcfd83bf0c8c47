#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""boxplus.h declares at most 60 names, and scripts/public_names.py finds each kind of name."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).parents[2] / "scripts" / "public_names.py"


def run(*arguments):
    return subprocess.run([sys.executable, SCRIPT, *arguments], capture_output=True, text=True, check=False)


def names(text):
    """The names that the script finds in a header with this text."""
    with tempfile.TemporaryDirectory() as folder:
        header = pathlib.Path(folder, "header.h")
        header.write_text(text, encoding="utf-8")
        done = run(str(header))
        assert done.returncode == 0, done.stderr
        return {line.split()[0] for line in done.stdout.splitlines()[:-1]}


class PublicNames(unittest.TestCase):
    def test_boxplus_h_declares_at_most_60_names(self):
        done = run("--at-most", "60")
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_the_script_fails_if_there_are_more_names_than_allowed(self):
        self.assertEqual(run("--at-most", "3").returncode, 1)

    def test_the_names_in_boxplus_h_include_the_graph_and_the_optimizer(self):
        found = {line.split()[0] for line in run().stdout.splitlines()}
        self.assertLessEqual({"Graph", "Optimizer", "SE3", "Range", "optimize", "read_graph", "kPi"}, found)

    def test_types_aliases_concepts_functions_and_constants_are_listed(self):
        self.assertEqual(names("""
            namespace boxplus {
            class Forward;
            struct Plain { int member; void method(); };
            enum class Choice : char { kFirst, kSecond };
            using Alias = Plain;
            template <class T> concept Sized = requires(T t) { t.size(); };
            template <class A, class B = Less<A, 3>> requires Sized<A> A pick(const A& a) { return a; }
            inline constexpr int kSize = 3;
            template <class T> inline constexpr bool kFlag = requires { T(); };
            std::vector<int> list(int n, double x = f(3));
            [[nodiscard]] Plain checked();
            }
        """), {"Forward", "Plain", "Choice", "Alias", "Sized", "pick", "kSize", "kFlag", "list", "checked"})

    def test_names_in_inner_namespaces_members_operators_and_specializations_are_not_listed(self):
        self.assertEqual(names("""
            namespace boxplus::detail { class Hidden {}; }
            namespace other { class Foreign {}; }
            // class Comment {};
            namespace boxplus {
            namespace detail { class Inner; void helper(); }
            template <> struct Plain<int> {};
            template <> struct detail::Inner<int> {};
            template <class T> inline constexpr bool kFlag<Box<T>> = true;
            template <class T> requires(!same<T>) struct Plain<T> : Base {};
            inline int Plain::method() const { return 1; }
            std::ostream& operator<<(std::ostream& out, const Plain& plain);
            Plain operator*(Plain a, Plain b);
            extern template class Box<int>;
            template <class T> Plain(T) -> Plain<T>;
            const char* kText = "class Text {};";
            }
        """), {"kText"})


if __name__ == "__main__":
    unittest.main()

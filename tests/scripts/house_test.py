#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/house.py finds each kind of function, and counts only code."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "scripts"))

import house  # noqa: E402

SOURCE = """
#define MACRO(x) { x
A_MACRO(of_a_line)
namespace a {  // f() {
const int kTable[] = {1, 2};
template <class T>
requires(sizeof(T) > 1)
class X : public Y<T> {
 public:
  X() : a_{1}, b_(2) {}
  explicit X(double x = 0.5) noexcept : a_{1} {
    if (x > 1e-9) {
      call([&] { return "}"; });
    }
  }
};
enum class Kind { kOne };
template <class T>
concept Has = requires(T x) { x.f(); };
template <>
struct X<int> {
  bool operator<(const X&) const { return static_cast<bool>('{'); }
};
TEST(Suite, name) {
  struct Inner {
    int x;
  };
}
}  // namespace a
"""


class House(unittest.TestCase):
    def test_functions_are_found_with_their_lengths(self):
        self.assertEqual(list(house.function_lengths(house.code_of(SOURCE))), [1, 5, 1, 5])

    def test_types_literals_casts_and_units_are_counted(self):
        texts = {"src/a/x.cpp": SOURCE, "src/a/x.h": "// 0.5 static_cast\n", "src/a/y.h": "\n" * 970}
        table = house.measure(texts, {"a/x", "b/z"})
        self.assertEqual(table["lines"], "1.0k")
        self.assertEqual(table["header median / max"], "486/970")
        self.assertEqual(table["function p99 / longest"], "5/5")
        self.assertEqual(table["functions > 60 lines"], "0 of 4")
        self.assertEqual(table["units in a circle of includes"], "1 of 2")
        self.assertEqual(table["types per 1000 lines"], "2.0")
        self.assertEqual(table["decimal literals per 1000 lines"], "2.0")
        self.assertEqual(table["static_cast per 1000 lines"], "1.0")


if __name__ == "__main__":
    unittest.main()

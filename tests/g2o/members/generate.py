#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Generates a C++ source from the table of members.

    generate.py TABLE SOURCE
"""

import sys

PROLOGUE = """// Made by tests/g2o/members/generate.py.
#include <array>
#include <iostream>
#include <set>
#include <stack>
#include <string>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <vector>

"""
CUSTOM_TYPES = """
struct CustomVertex : g2o::BaseVertex<3, Eigen::Vector3d> {
  void setToOriginImpl() override {}
  void oplusImpl(const double*) override {}
  bool read(std::istream&) override { return true; }
  bool write(std::ostream&) const override { return true; }
};
struct OtherVertex : CustomVertex {};

"""


def statement(number, line):
    kind, code = (part.strip() for part in line.split(" | ", 1))
    if kind == "line":
        return code
    verb, type_name = kind.split(" ", 1)
    if verb == "use":
        return f"void use_{number}([[maybe_unused]] {type_name}& x) {{ static_cast<void>({code}); }}"
    if verb == "inside":
        return f"struct Inside{number} : {type_name} {{ void use() {{ static_cast<void>({code}); }} }};"
    raise ValueError(f"line {number}: expected use, inside or line, got {verb}")


def main():
    table, source = sys.argv[1:]
    includes, statements = [], []
    with open(table, encoding="utf-8") as lines:
        for number, line in enumerate(lines, 1):
            line = line.strip()
            if line.startswith("#include "):
                includes.append(f'#include "{line.split()[1]}"')
            elif line and not line.startswith("#"):
                statements += [f'#line {number} "{table}"', statement(number, line)]
    with open(source, "w", encoding="utf-8") as out:
        out.write(PROLOGUE + "\n".join(includes) + "\n" + CUSTOM_TYPES + "\n".join(statements))
        out.write("\n")


if __name__ == "__main__":
    main()

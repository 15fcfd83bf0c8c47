#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the C++ sources, and prints a table with a column for each part of the project.

    house.py [ROOT]

Reads the files below ROOT, which is the project by default, that git tracks. The rows are:

- lines: all lines of C++ files, with comments and empty lines
- header median / max: the lines of a header (.h)
- function p99 / longest: the lines of a function, from its opening to its closing brace; 99 % of the functions are not
  longer than p99. Functions are those in a namespace or a class; a lambda belongs to the function around it, and a test
  is a function.
- functions > 60 lines: and the number of all functions
- units in a circle: of those in the part, as check_includes.py finds them
- types per 1000 lines: the names of classes and structs that are defined; specializations have the same name
- decimal literals per 1000 lines: the lines of code with a number such as 0.5 or 1e-9
- static_cast per 1000 lines: how often the word occurs in code

The last line is the total of all lines of C++, Python and TypeScript without tests, examples, benchmarks and fuzz
targets.
"""

import pathlib
import re
import statistics
import subprocess
import sys

import check_includes

PARTS = {
    "include + src": ("include/", "src/"),
    "g2o API": ("g2o/",),
    "apps": ("apps/",),
    "viewer C++": ("viewer/",),
    "python/src": ("python/src/",),
    "tests": ("tests/",),
}
TOTAL = ("include", "src", "g2o", "python", "viewer", "apps")
LONG = 60  # lines of a function

NO_CODE = re.compile(r"""//[^\n]*|/\*.*?\*/|R"(?P<tag>[^()\s]*)\(.*?\)(?P=tag)"|"(?:\\.|[^"\\\n])*"
                         |(?<!\w)'(?:\\.|[^'\\\n])+'|^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*""",
                     re.DOTALL | re.MULTILINE | re.VERBOSE)
TYPE = re.compile(r"^\s*(?:class|struct)\s+(?:\[\[\w+\]\]\s+)?(?:\w+_API\s+)?(\w+)\s*[^;(){}]*\{", re.MULTILINE)
DECIMAL = re.compile(r"(?<![\w.])(?:\d[\d']*\.\d*|\.\d+|\d+(?=[eE]))(?:[eE][+-]?\d+)?")

# The beginning of a statement that ends with a brace.
MACROS = re.compile(r"(?:\s*[A-Z][A-Z0-9_]+\([^()]*\)[ \t]*\n)+")
TEMPLATE = re.compile(r"\s*template\s*<")
SCOPE = re.compile(r"\s*(?:(?:inline\s+)?namespace\b|extern\s*\""
                   r"|(?:requires\b[^{}]*\n\s*|typedef\s+)?(?:class|struct|union|enum)\b)")
EXPRESSION = re.compile(r"(?:[=(,&|]|\breturn|\brequires\s*(?:\([^(){}]*\))?)\s*$|[\w>\])]$")


def code_of(text):
    """The text without comments and directives and with empty strings, on the same lines."""
    return NO_CODE.sub(lambda match: '""' * (match[0][0] in "\"R'") + "\n" * match[0].count("\n"), text)


def after_bracket(code, at, pair):
    """The position after the bracket that closes the bracket at `at`."""
    depth = 0
    for match in re.compile("[" + re.escape(pair) + "]").finditer(code, at):
        depth += 1 if match[0] == pair[0] else -1
        if depth == 0:
            return match.end()
    return len(code)


def declaration_of(head):
    """The beginning of a statement without the macros and template headers in front."""
    head = MACROS.sub("", head, count=1) if MACROS.match(head) else head
    while match := TEMPLATE.match(head):
        head = head[after_bracket(head, match.end() - 1, "<>"):]
    return head


def function_lengths(code):
    """The lines of each function."""
    begin, at = 0, 0  # of the statement; of the search
    while match := re.compile(r"[{};]|\b(?:public|protected|private)\s*:").search(code, at):
        at = match.end()
        if match[0] != "{":
            begin = at
            continue
        head = code[begin:match.start()]
        declaration = declaration_of(head)
        if EXPRESSION.search(head):
            at = after_bracket(code, match.start(), "{}")
        elif "(" in declaration and not SCOPE.match(declaration):
            at = after_bracket(code, match.start(), "{}")
            yield code.count("\n", match.start(), at) + 1
            begin = at
        else:
            begin = at


def measure(texts, in_circle):
    codes = [code_of(text) for text in texts.values()]
    lines = sum(text.count("\n") for text in texts.values())
    headers = [text.count("\n") for file, text in texts.items() if file.endswith(".h")]
    functions = sorted(length for code in codes for length in function_lengths(code))
    units = {check_includes.unit_of(file) for file in texts}
    types = {name for code in codes for name in TYPE.findall(code)}
    decimals = sum(bool(DECIMAL.search(line)) for code in codes for line in code.split("\n"))
    casts = sum(len(re.findall(r"\bstatic_cast\b", code)) for code in codes)
    return {
        "lines": f"{lines / 1000:.1f}k",
        "header median / max": f"{statistics.median(headers):.0f}/{max(headers)}",
        "function p99 / longest": f"{functions[len(functions) * 99 // 100]}/{functions[-1]}",
        f"functions > {LONG} lines": f"{sum(length > LONG for length in functions)} of {len(functions)}",
        "units in a circle of includes": f"{len(units & in_circle)} of {len(units)}",
        "types per 1000 lines": f"{1000 * len(types) / lines:.1f}",
        "decimal literals per 1000 lines": f"{1000 * decimals / lines:.1f}",
        "static_cast per 1000 lines": f"{1000 * casts / lines:.1f}",
    }


def tracked(root, *folders):
    listing = subprocess.run(["git", "-C", root, "ls-files", *folders], capture_output=True, text=True, check=True)
    return listing.stdout.splitlines()


def total(root):
    files = [file for file in tracked(root, *TOTAL) if file.endswith((".h", ".cpp", ".py", ".pyi", ".ts"))]
    return sum((root / file).read_bytes().count(b"\n") for file in files)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    known = {*tracked(root)}
    texts = {file: text for file, text in check_includes.read_sources(root).items() if file in known}
    graph = {}
    for include in check_includes.includes_of(texts):
        graph.setdefault(check_includes.unit_of(include.file), set()).add(check_includes.unit_of(include.target))
    in_circle = {unit for circle in check_includes.components(graph) for unit in circle}
    columns = {part: measure({file: text for file, text in texts.items() if file.startswith(begins)}, in_circle)
               for part, begins in PARTS.items()}
    print("|", *(f"| {part}" for part in columns), "|")
    print("|---" + "|--:" * len(columns) + "|")
    for row in columns["tests"]:
        print(f"| {row} |", *(f"{column[row]} |" for column in columns.values()))
    print(f"\n{total(root)} lines in {', '.join(TOTAL)} (.h .cpp .py .pyi .ts)")


if __name__ == "__main__":
    main()

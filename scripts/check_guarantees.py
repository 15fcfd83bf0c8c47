#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails if docs/guarantees.md names a test that does not exist, or has a promise without a test.

    check_guarantees.py [ROOT]

The last column of each table contains the tests that prove the promise of the row, in backticks:

    `Suite.Name`    a test of GoogleTest or RapidCheck in tests/
    `apps.convert`  a test that a CMakeLists.txt in tests/ adds, with the name that ctest lists
    `test_name`     a function of the script of the last test of this kind in the same row
"""

import pathlib
import re
import sys

DOCUMENT = "docs/guarantees.md"
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
GTEST = re.compile(r"^(?:TEST|TEST_F|TEST_P|TYPED_TEST|TYPED_TEST_P|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(\s*(\w+),\s*(\w+)",
                   re.MULTILINE)
CMAKE_COMMENT = re.compile(r"#[^\n]*")
ADD_TEST = re.compile(r"add_test\(\s*NAME\s+(\S+)([^()]*(?:\([^()]*\)[^()]*)*)\)")
FUNCTION = re.compile(r"function\((\w+)\s+(\w+)[^)]*\)(.*?)endfunction\(\)", re.DOTALL)
FOREACH = re.compile(r"foreach\((\w+)\s+(?!IN\b)([^)]*)\)")
SCRIPT = re.compile(r"[\w./]*\w\.(?:py|sh)\b")
SUITE = re.compile(r"_test\.(?:py|sh)$")
VARIABLE = re.compile(r"\$\{(\w+)\}")


def gtests(root):
    """The names Suite.Name of the tests in C++. Disabled tests are left out."""
    for file in sorted((root / "tests").rglob("*.cpp")):
        text = COMMENT.sub("", file.read_text(encoding="utf-8"))
        yield from (f"{suite}.{name}" for suite, name in GTEST.findall(text)
                    if not (suite + name).startswith("DISABLED_") and not name.startswith("DISABLED_"))


def values(variable, text, folder):
    """The values that a variable of the CMakeLists.txt takes, each with the script that it names, or None."""
    for name, items in FOREACH.findall(text):
        if name == variable:
            yield from ((item, None) for item in items.split())
            return
    popped = re.search(rf"list\(POP_FRONT (\w+) {variable}\b([^)]*)\)", text)
    if popped:
        items = re.search(rf"set\({popped[1]}\b([^)]*)\)", text)[1].split()
        yield from ((item, None) for item in items[::1 + len(popped[2].split())])
        return
    # The CMakeLists.txt takes all scripts of its folder.
    for file in sorted(folder.iterdir()):
        if SUITE.search(file.name):
            yield SUITE.sub("", file.name), file


def script_in(arguments, folder, replaced=("", "")):
    """The script of the project that the command of a test runs, or None."""
    for match in SCRIPT.finditer(arguments.replace(*replaced)):
        file = folder / match[0].lstrip("/")
        if file.is_file():
            return file
    return None


def added_tests(folder, text):
    """The names and the scripts of all tests that a CMakeLists.txt adds."""
    text = CMAKE_COMMENT.sub("", text)
    calls = [(name, rest) for name, rest in ADD_TEST.findall(FUNCTION.sub("", text))]
    for function, parameter, body in FUNCTION.findall(text):
        for name, rest in ADD_TEST.findall(body):
            for call in re.finditer(rf"\b{function}\((\S+?)[\s)]([^()]*)", FUNCTION.sub("", text)):
                mark = f"${{{parameter}}}"
                calls.append((name.replace(mark, call[1]), rest.replace(mark, call[1]) + call[2]))
    for name, rest in calls:
        if name.startswith("examples."):  # the examples, which are not in tests/
            continue
        variable = VARIABLE.search(name)
        if not variable:
            yield name, script_in(rest, folder)
            continue
        for value, file in values(variable[1], text, folder):
            yield (name.replace(variable[0], value),
                   file or script_in(rest, folder, (variable[0], value)))


def rows(text):
    """The line number and the cells of each row of a table, without the header."""
    lines = text.splitlines()
    for k, line in enumerate(lines):
        is_separator = k + 1 < len(lines) and re.fullmatch(r"\|[-:| ]+\|", lines[k + 1])
        if line.startswith("|") and not re.fullmatch(r"\|[-:| ]+\|", line) and not is_separator:
            yield k + 1, [cell.strip() for cell in line.strip("|").split("|")]


def violations(root):
    known = {name: None for name in gtests(root)}
    for file in sorted((root / "tests").rglob("CMakeLists.txt")):
        known |= dict(added_tests(file.parent, file.read_text(encoding="utf-8")))
    promises = 0
    for line, cells in rows((root / DOCUMENT).read_text(encoding="utf-8")):
        promises += 1
        where = f"{DOCUMENT}:{line}"
        names = re.findall(r"`([^`]+)`", cells[-1])
        if not any(name in known for name in names):
            yield f"{where}: no test proves '{cells[0]}'"
        script = None
        for name in names:
            if not name.startswith("test_"):
                script = known.get(name)
                if name not in known:
                    yield f"{where}: there is no test '{name}'"
            elif script is None:
                yield f"{where}: '{name}' does not follow the test whose script contains it"
            elif not re.search(rf"^ *def {name}\(", script.read_text(encoding="utf-8"), re.MULTILINE):
                yield f"{where}: {script.relative_to(root)} has no function '{name}'"
    if promises == 0:
        yield f"{DOCUMENT}:1: there is no table with promises"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    found = list(violations(root))
    print(*found, sep="\n", end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

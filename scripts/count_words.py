#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Counts words in comments and documents that show if the text is plain English.

    count_words.py [--check] [PATH...]
    count_words.py --show WORD [PATH...]

Reads the comments of C++, CMake, Python (docstrings, too) and shell sources, and the prose of *.md files
without code blocks and inline code. The default for PATH is each folder of the project. For each PATH, prints
how often these words occur per 1000 words: "where", "if" plus "when", and "what". Conditions should be written
with "if" and "when"; "where" is for places. With --check, the exit code is 1 if the total violates one of the
LIMITS. With --show, prints file:line of each occurrence of WORD instead.
"""

import argparse
import collections
import io
import pathlib
import re
import sys
import tokenize

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIMITS = "where at most 3, if+when at least 4 per 1000 words"
MOST_WHERE, LEAST_IF_WHEN = 3.0, 4.0

WORD = re.compile(r"[A-Za-z]+(?:['’-][A-Za-z]+)*")
# Strings come first in each pattern, so that a comment sign inside a string does not start a comment.
CPP = re.compile(r"""R"(?P<tag>[^()\s]*)\(.*?\)(?P=tag)" | "(?:\\.|[^"\\\n])*" | (?<!\w)'(?:\\.|[^'\\\n])+'
                 | (?P<comment>//[^\n]*|/\*.*?\*/)""", re.DOTALL | re.VERBOSE)
SHELL = re.compile(r"""\[\[.*?\]\] | "(?:\\.|[^"\\])*" | '[^']*' | (?P<comment>(?<!\S)\#[^\n]*)""",
                   re.DOTALL | re.VERBOSE)
CODE_IN_DOCUMENT = re.compile(r"```.*?```|`[^`\n]*`|<!--.*?-->|\]\([^)]*\)", re.DOTALL)
NO_PROSE = re.compile(r"SPDX-License-Identifier[^\n]*|NOLINT\w*(?:\([^)]*\))?|^#!.*|clang-format (?:on|off)")


def blank(match):
    """The line breaks of the match, without its text."""
    return "\n" * match[0].count("\n") + " "


def comments(pattern, text):
    """The comments, each in its original line. All other lines are empty."""
    kept, end = [], 0
    for match in pattern.finditer(text):
        kept.append("\n" * text.count("\n", end, match.start()))
        kept.append(match["comment"] + " " if match["comment"] else blank(match))
        end = match.end()
    return "".join(kept)


def python_comments(text):
    lines = [""] * (text.count("\n") + 2)
    previous = tokenize.NEWLINE
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        starts_statement = previous in (tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT)
        if token.type == tokenize.COMMENT or (token.type == tokenize.STRING and starts_statement):
            for offset, line in enumerate(token.string.split("\n")):
                lines[token.start[0] + offset - 1] += line
        if token.type not in (tokenize.NL, tokenize.COMMENT):
            previous = token.type
    return "\n".join(lines)


def prose(file):
    """The prose of a file, each sentence in its original line. None if files of this type have no prose."""
    suffix = ".cmake" if file.name == "CMakeLists.txt" else file.suffix
    if suffix not in (".h", ".hpp", ".cpp", ".cc", ".py", ".md", ".sh", ".cmake"):
        return None
    text = file.read_text(encoding="utf-8")
    if suffix == ".md":
        found = CODE_IN_DOCUMENT.sub(blank, text)
    elif suffix == ".py":
        found = python_comments(text)
    else:
        found = comments(SHELL if suffix in (".sh", ".cmake") else CPP, text)
    return NO_PROSE.sub(" ", found)


def sources(path):
    """Every file below the path, without builds and hidden folders."""
    files = [path] if path.is_file() else sorted(f for f in path.rglob("*") if f.is_file())
    for file in files:
        folders = file.relative_to(path).parts[:-1]
        if not any(name in ("build", "node_modules") or name.startswith(".") for name in folders):
            yield file


def count(path):
    counts = collections.Counter()
    for file in sources(path):
        counts.update(word.lower() for word in WORD.findall(prose(file) or ""))
    return counts


def rates(counts):
    """(words, where, if+when, what), the last three per 1000 words. Nearly every "what" begins a clause."""
    words = counts.total()
    per_thousand = 1000 / max(words, 1)
    return (words, counts["where"] * per_thousand, (counts["if"] + counts["when"]) * per_thousand,
            counts["what"] * per_thousand)


def show(word, paths):
    pattern = re.compile(rf"\b{re.escape(word)}\b", re.IGNORECASE)
    for path in paths:
        for file in sources(path):
            for number, line in enumerate((prose(file) or "").split("\n"), start=1):
                if pattern.search(line):
                    name = file.relative_to(ROOT) if file.is_relative_to(ROOT) else file
                    print(f"{name}:{number}: {line.strip()}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--check", action="store_true", help=f"fail unless {LIMITS}")
    parser.add_argument("--show", metavar="WORD", help="print where a word occurs")
    parser.add_argument("paths", metavar="PATH", type=pathlib.Path, nargs="*")
    arguments = parser.parse_args()
    paths = [path.resolve() for path in arguments.paths] or [
        path for path in sorted(ROOT.iterdir()) if path.name != "build" and not path.name.startswith(".")]
    if arguments.show:
        show(arguments.show, paths)
        return 0
    print(f"{'words':>8} {'where':>6} {'if+when':>8} {'what':>6}   per 1000 words")
    total = collections.Counter()
    for path in paths:
        counts = count(path)
        total += counts
        if counts:
            words, *per_thousand = rates(counts)
            name = path.relative_to(ROOT) if path.is_relative_to(ROOT) else path
            print(f"{words:8} {per_thousand[0]:6.1f} {per_thousand[1]:8.1f} {per_thousand[2]:6.1f}   {name}")
    words, where, if_when, what = rates(total)
    print(f"{words:8} {where:6.1f} {if_when:8.1f} {what:6.1f}   all")
    if arguments.check and (where > MOST_WHERE or if_when < LEAST_IF_WHEN):
        print(f"expected: {LIMITS}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

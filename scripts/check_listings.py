#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that README.md and docs/ show the code of examples/, and the output that programs print.

    check_listings.py [--fix] [PROGRAMS]

In these pages, the line before each C++ block must name the source of the block. The line before each block of text
must name the command that prints the text, or say that the block is a drawing:

    <!-- examples/02_custom_edge.cpp [edge] -->      the lines between // [edge] and // [/edge],
                                                     or between # [edge] and # [/edge]
    <!-- output of boxplus info data/01_town.g2o --> the standard output of a command that succeeds
    <!-- complaint of boxplus info nowhere.g2o -->   the standard error of a command that refuses its
                                                     input (exit code 2)
    <!-- drawing -->                                 no program prints this block

PROGRAMS is the folder of the examples in a build. If it is given, the outputs are checked, too; the command boxplus is
taken from the same build. Each command runs in an empty folder that contains only the project's data/. Numbers may
differ by rounding. Times (which have four decimals) and numbers of threads are not compared. With --fix, the
script corrects the pages. docs/cli.md must equal the output of `boxplus help --markdown`; its blocks are not checked.
docs/formats.md must contain all tags that src/io registers, and links must lead to existing files.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"(?:<!-- (?P<source>.+?) -->\n)?```(?P<language>\w*)\n(?P<text>.*?)```", re.DOTALL)
MARKER = re.compile(r"^ *(?://|#) \[/?\w+\]\n", re.MULTILINE)
VARIES = re.compile(r"\b\d+\.\d{4}\b|\d+ of \d+ threads?")
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
WORD = re.compile(r'(?:vertex|parameter|edge|old_vertex|old_edge)<.*?>\(\s*"([^"]+)"')
LINK = re.compile(r"\]\(([^)#:]+)(?:#[^)]*)?\)")


def region(source):
    """The lines between the markers of "examples/x.cpp [name]", or all of "examples/x.cpp"."""
    file, _, name = source.partition(" ")
    text = (ROOT / file).read_text(encoding="utf-8")
    if name:
        found = re.search(rf"^ *(?://|#) \[{name[1:-1]}\]\n(.*?)^ *(?://|#) \[/{name[1:-1]}\]\n",
                          text, re.DOTALL | re.MULTILINE)
        if not found:
            raise LookupError(f"{file} has no region {name}")
        text = found[1]
    return textwrap.dedent(MARKER.sub("", text))


def run(programs, command):
    """Runs the command to its end. The programs of the build come first in the PATH."""
    path = os.pathsep.join([str(programs), str(programs.parents[1] / "bin"), os.environ["PATH"]])
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "data").symlink_to(ROOT / "data")
        (pathlib.Path(folder) / "build").mkdir()
        return subprocess.run(["bash", "-c", command], check=False, capture_output=True, text=True, cwd=folder,
                              env={**os.environ, "PATH": path})


def printed_by(programs, source):
    """The standard output of the command in "output of …", or its standard error if the line says "complaint of …"."""
    kind, _, command = source.partition(" of ")
    done = run(programs, command)
    expected = 0 if kind == "output" else 2
    if done.returncode != expected:
        raise LookupError(f"{command}: exit code {done.returncode}, expected {expected}: {done.stderr.strip()}")
    return done.stdout if kind == "output" else done.stderr


def alike(shown, printed):
    """True if the texts are equal and their numbers differ only by rounding."""
    shown, printed = VARIES.sub("…", shown), VARIES.sub("…", printed)
    if NUMBER.sub("0", shown) != NUMBER.sub("0", printed):
        return False
    pairs = zip(NUMBER.findall(shown), NUMBER.findall(printed))
    return all(abs(float(a) - float(b)) <= 1e-6 * max(1, abs(float(a))) for a, b in pairs)


def check_block(match, programs, complain):
    """Checks a block. Returns the block, with corrections if it is wrong."""
    source, language, shown = match["source"], match["language"], match["text"]
    try:
        if source and source.startswith("examples/"):
            expected = region(source)
            right = shown == expected
        elif source and source.startswith(("output of ", "complaint of ")):
            if not programs:
                return match[0]
            expected = printed_by(programs, source)
            right = alike(shown, expected)
        else:
            if language == "cpp":
                complain("C++ that does not say which example compiles it", match)
            if language in ("", "text", "console") and source != "drawing":
                complain("text that does not say which command prints it", match)
            return match[0]
    except (LookupError, OSError) as error:
        complain(str(error), match)
        return match[0]
    if right:
        return match[0]
    complain(f"differs from: {source}", match)
    return f"<!-- {source} -->\n```{language}\n{expected}```"


def check_page(page, programs, fix):
    text, complaints = page.read_text(encoding="utf-8"), []

    def complain(what, match):
        line = match.string.count("\n", 0, match.start()) + 1
        complaints.append(f"{page.relative_to(ROOT)}:{line}: {what}")

    corrected = BLOCK.sub(lambda match: check_block(match, programs, complain), text)
    if fix and corrected != text:
        page.write_text(corrected, encoding="utf-8")
    prose = BLOCK.sub(lambda match: "\n" * match[0].count("\n"), text)
    for match in LINK.finditer(prose):
        if not (page.parent / match[1]).exists():
            complain(f"no such file: {match[1]}", match)
    return complaints


def check_command_page(programs, fix):
    page = ROOT / "docs/cli.md"
    done = run(programs, "boxplus help --markdown")
    if done.returncode != 0:
        return [f"docs/cli.md: boxplus help --markdown: exit code {done.returncode}: {done.stderr.strip()}"]
    if page.read_text(encoding="utf-8") == done.stdout:
        return []
    if fix:
        page.write_text(done.stdout, encoding="utf-8")
    return ["docs/cli.md: differs from the output of boxplus help --markdown"]


def missing_words(root):
    page = (root / "docs/formats.md").read_text(encoding="utf-8")
    files = sorted((root / "src/io").rglob("register_*.cpp"))
    if not files:
        yield "src/io: no register_*.cpp, so no tag of docs/formats.md was checked"
    for file in files:
        for word in sorted(set(WORD.findall(file.read_text(encoding="utf-8")))):
            if f"`{word}`" not in page:
                yield f"docs/formats.md: does not explain {word} of {file.relative_to(root)}"


def main():
    arguments = sys.argv[1:]
    fix = "--fix" in arguments
    folders = [pathlib.Path(a).resolve() for a in arguments if a != "--fix"]
    programs = folders[0] if folders else None
    complaints = list(missing_words(ROOT))
    if programs:
        complaints += check_command_page(programs, fix)
    for page in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        if page != ROOT / "docs/cli.md":
            complaints += check_page(page, programs, fix)
    print(*complaints, sep="\n", end="\n" if complaints else "")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())

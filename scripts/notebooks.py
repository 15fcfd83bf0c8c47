#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the notebooks in examples/python/notebooks from the numbered examples in examples/python.

    notebooks.py [--check]

Comments between empty lines become text, and the code between them and between the markers # [name] becomes cells. The
lines between # [script] and # [/script] are left out. With --check, the script names the notebooks that differ, and changes
nothing.
"""

import ast
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "examples/python"
MARKER = re.compile(r"^# \[/?\w+\]$")
SCRIPT = re.compile(r"^# \[script\]\n.*?^# \[/script\]\n", re.DOTALL | re.MULTILINE)


def blocks(text):
    """(kind, lines) of texts and codes, one after the other."""
    kind, lines, after_empty = "code", [], True
    for line in text.splitlines():
        is_text = line.startswith("#") and not MARKER.match(line) and (after_empty or kind == "markdown")
        if MARKER.match(line) or is_text != (kind == "markdown"):
            yield kind, lines
            kind, lines = "markdown" if is_text else "code", []
        if not MARKER.match(line):
            lines.append(line.lstrip("# ") if is_text else line)
        after_empty = not line.strip() or bool(MARKER.match(line))
    yield kind, lines


def is_complete(code):
    try:
        ast.parse(code)
    except SyntaxError:
        return False
    return True


def cells(text):
    """(kind, text) of the cells. Code is never cut inside of a statement."""
    found = []
    for kind, lines in blocks(SCRIPT.sub("", text.split("\n", 1)[1])):  # without the line of the license
        content = "\n".join(lines).strip("\n")
        if not content.strip():
            continue
        if kind == "code" and found and found[-1][0] == "code" and (
                not is_complete(found[-1][1]) or re.match(r"(else|elif|except|finally)\b", content)):
            found[-1] = ("code", found[-1][1] + "\n" + content)
        else:
            found.append((kind, content))
    return found


def notebook(path):
    number, _, name = path.stem.partition("_")
    parts = [("markdown", f"# {number} · {name.replace('_', ' ')}"), *cells(path.read_text(encoding="utf-8"))]
    result = {"cells": [], "metadata": {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
                                        "language_info": {"name": "python"}}, "nbformat": 4, "nbformat_minor": 5}
    for index, (kind, content) in enumerate(parts):
        cell = {"cell_type": kind, "id": f"cell-{index}", "metadata": {}, "source": content.splitlines(keepends=True)}
        if kind == "code":
            cell.update(execution_count=None, outputs=[])
        result["cells"].append(cell)
    return json.dumps(result, indent=1, ensure_ascii=False) + "\n"


def main():
    is_check = "--check" in sys.argv[1:]
    folder = FOLDER / "notebooks"
    expected = {folder / f"{path.stem}.ipynb": notebook(path) for path in sorted(FOLDER.glob("[0-9]*.py"))}
    differing = [path for path, text in expected.items() if not path.exists() or path.read_text(encoding="utf-8") != text]
    differing += sorted(set(folder.glob("*.ipynb")) - set(expected))
    for path in differing:
        if is_check:
            print(f"{path.relative_to(ROOT)}: differs from its example; run scripts/notebooks.py")
        elif path in expected:
            path.parent.mkdir(exist_ok=True)
            path.write_text(expected[path], encoding="utf-8")
        else:
            path.unlink()
    return 1 if is_check and differing else 0


if __name__ == "__main__":
    sys.exit(main())

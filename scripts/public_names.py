#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lists the names that a header puts into namespace boxplus.

    public_names.py [--at-most N] [HEADER]

Reads HEADER, by default include/boxplus/boxplus.h, and every boxplus header that it includes. Prints each type,
concept, alias, function and constant that is declared in namespace boxplus itself, with its headers. Overloads
count once. Operators, and names in nested namespaces such as boxplus::detail, do not count. With --at-most, the
exit code is 1 if there are more than N names.
"""

import argparse
import collections
import pathlib
import re
import sys

INCLUDE = pathlib.Path(__file__).resolve().parent.parent / "include"
NO_CODE = re.compile(r"""//[^\n]* | /\*.*?\*/ | ^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*
                     | (?P<text>"(?:\\.|[^"\\\n])*" | (?<!\w)'(?:\\.|[^'\\\n])+')""", re.DOTALL | re.MULTILINE | re.VERBOSE)
NAMESPACE = re.compile(r"\bnamespace\s*([\w:]*)\s*$")
REQUIRES_EXPRESSION = re.compile(r"\brequires\s*(?:\([^)]*\))?\s*$")
ATTRIBUTE = re.compile(r"\[\[.*?\]\]|\balignas\([^)]*\)|\bBOXPLUS_\w+\b")
NAMELESS = re.compile(r"static_assert\b|extern template\b|template\b|friend\b|using namespace\b|$")
ALIAS = re.compile(r"(?:concept|using)\s+(\w+)\s*=")
USING = re.compile(r"using\s+(?:\w+::)+(\w+)$")
TYPE = re.compile(r"(?:class|struct|union|enum(?:\s+class|\s+struct)?)\s+(\w+)\s*(<|::)?")
FUNCTION = re.compile(r"(.*?)(\w+)\s*\(", re.DOTALL)
VARIABLE = re.compile(r".*?(\w+)\s*(<.*>)?\s*$", re.DOTALL)


def headers_below(header):
    """The text of the header and of all boxplus headers that it includes, by path."""
    texts, queue = {}, [header]
    while queue:
        path = queue.pop()
        if path not in texts:
            texts[path] = path.read_text(encoding="utf-8")
            queue += [INCLUDE / name for name in re.findall(r'^#include [<"](boxplus/.*?)[>"]', texts[path], re.MULTILINE)]
    return texts


def after_bracket(text, at, pair):
    """The position after the bracket that closes the bracket at `at`."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == pair[0]) - (text[i] == pair[1])
        if depth == 0:
            return i + 1
    return len(text)


def without_constraint(text):
    """The text without the requires clause with which it begins, such as requires A<T> && !(b) …"""
    at = len("requires")
    while match := re.compile(r"\s*!*\s*(?:&&|\|\|)?\s*!*\s*(?=\(|(?:\w+::)*\w+\s*<|requires\b)").match(text, at):
        if at > len("requires") and not re.search(r"&&|\|\|", match[0]):
            break
        at = re.compile(r"(?:\w+::)*\w*\s*").match(text, match.end()).end()
        if text[at:at + 1] in ("(", "<"):
            at = after_bracket(text, at, "()" if text[at] == "(" else "<>")
    return text[at:].lstrip()


def declared_name(statement):
    """The name that a statement at namespace level declares, or None."""
    text = ATTRIBUTE.sub(" ", statement).strip()
    while re.match(r"template\s*<", text):
        text = text[after_bracket(text, text.index("<"), "<>"):].lstrip()
        if re.match(r"requires\b", text):
            text = without_constraint(text)
    if NAMELESS.match(text):
        return None
    if match := ALIAS.match(text) or USING.match(text):
        return match[1]
    if match := TYPE.match(text):
        return None if match[2] else match[1]  # a specialization, or a member of a namespace or class, adds no name
    if re.search(r"\boperator\b", text):
        return None
    declarator = re.split(r"(?<![<>!=])=(?!=)", text)[0]
    if match := FUNCTION.match(declarator):
        is_member, is_guide = match[1].endswith("::"), not match[1].strip()
        return None if is_member or is_guide else match[2]
    match = VARIABLE.match(declarator)
    return match[1] if match and not match[2] else None


def names_in(text):
    """The names that are declared in namespace boxplus itself."""
    text = NO_CODE.sub(lambda match: '""' if match["text"] else " ", text)
    names, namespaces, statement, at = [], [], "", 0

    def finish():
        nonlocal statement
        if namespaces == ["boxplus"] and (name := declared_name(statement)):
            names.append(name)
        statement = ""

    while at < len(text):
        if text[at] == "{" and (match := NAMESPACE.search(statement)):
            namespaces.append(match[1])
            statement = ""
        elif text[at] == "{":
            at = after_bracket(text, at, "{}")
            # The statement continues after a requires expression, and after an initializer before a semicolon.
            if not REQUIRES_EXPRESSION.search(statement) and not re.match(r"\s*;", text[at:]):
                finish()
            continue
        elif text[at] == "}":
            namespaces.pop()
            statement = ""
        elif text[at] == ";":
            finish()
        else:
            statement += text[at]
        at += 1
    return names


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--at-most", type=int, metavar="N")
    parser.add_argument("header", nargs="?", type=pathlib.Path, default=INCLUDE / "boxplus/boxplus.h")
    arguments = parser.parse_args()
    places = collections.defaultdict(set)
    for path, text in headers_below(arguments.header).items():
        for name in names_in(text):
            places[name].add(path.name)
    for name in sorted(places):
        print(f"{name:24} {', '.join(sorted(places[name]))}")
    print(f"{len(places)} names")
    return arguments.at_most is not None and len(places) > arguments.at_most


if __name__ == "__main__":
    sys.exit(main())

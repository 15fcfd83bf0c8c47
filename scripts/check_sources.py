#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks guarantees in the C++ sources.

    check_sources.py [ROOT]

Quiet: no source of the library prints, exits or aborts. (The g2o API prints errors on stderr, as g2o does; programs
may print.)
Permissive: each file has the license of the project, and includes headers of other libraries only if the table below
has them. The opt-in solvers of the g2o API alone may include the headers of CHOLMOD and CXSparse.
Portable: what depends on the operating system is in src/platform/.
Stable: a deprecated name says what to use instead, and the changelog has a section for the version of the project,
which package.xml has, too (docs/versions.md).
"""

import pathlib
import re
import sys

LICENSE = "SPDX-License-Identifier: BSD-3-Clause"

# The sources of the library.
QUIET = ("include", "src", "viewer", "plugins", "python/src")

# Folders, and the libraries that they may include besides those of the C++ standard and of POSIX. AMD and CAMD are the
# parts of SuiteSparse under the BSD license.
EIGEN, OPENGL = ("Eigen/",), ("GL/", "OpenGL/")
MAY_INCLUDE = {
    "include": EIGEN,
    "src": (*EIGEN, "fmt/", "fast_float/", "zlib.h", "amd.h", "camd.h"),
    "viewer": (*EIGEN, "fmt/", "httplib.h", "nlohmann/"),
    "plugins/mpi": ("mpi.h",),
    "plugins/petsc": ("mpi.h", "petscksp.h", "petscmat.h", "petscsys.h"),
    "python/src": (*EIGEN, "pybind11/"),
    "apps": (*EIGEN, "fmt/", "CLI/", "nlohmann/", "cairo.h", "cairo-pdf.h", "zlib.h"),
    "g2o/include": (*EIGEN, *OPENGL),
    "g2o/src": (*EIGEN, "fmt/", "amd.h"),
}
NOT_BY_DEFAULT = ("cholmod.h", "cs.h", "suitesparse/cholmod.h", "suitesparse/cs.h")
OPT_IN = ("g2o/src/solvers/suitesparse/", "g2o/include/g2o/solvers/cholmod/cholmod_ext.h",
          "g2o/include/g2o/solvers/csparse/csparse_helper.h")
OPERATING_SYSTEM = re.compile(r"sys/\w+\.h|(?:dlfcn|fcntl|fnmatch|poll|pthread|signal|spawn|termios|unistd)\.h")
SYSTEM = re.compile(rf"[a-z0-9_]+|{OPERATING_SYSTEM.pattern}|(?:boxplus|g2o)/.*|(?:arm_neon|cxxabi|immintrin)\.h")

# The sources that must run on any operating system, the folder for the others, and exceptions, each with its reason.
PORTABLE = ("include", "src", "viewer", "apps/boxplus")
PLATFORM = "src/platform/"
NOT_PORTABLE = {
    ("viewer/server/server.cpp", "sys/socket.h"): "httplib.h passes a socket to a function that sets options of it.",
}
# Names of POSIX that headers of the C++ standard declare, too.
POSIX = re.compile(r"\bsig(?:action|set_t|wait)\b|\bSIG(?:HUP|KILL)\b|\bmk(?:d|s|os)temp\b|\bPATH_MAX\b|\benviron\b")

DEPRECATED = re.compile(r"\[\[deprecated(?!\(\"use )")
VERSION = re.compile(r"^project\(boxplus VERSION ([0-9.]+)", re.MULTILINE)
INCLUDE = re.compile(r"^[ \t]*#[ \t]*include[ \t]*<([^>]+)>", re.MULTILINE)
COMMENT_OR_TEXT = re.compile(r"""//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'""", re.DOTALL)
LOUD = re.compile(r"\bstd::(?:cout|cerr|clog|wcout|wcerr)\b|\b(?:stdout|stderr)\b|\bfmt::print\b"
                  r"|(?<![.>\w])(?:v?f?printf|puts|fputs|putchar|perror|abort|exit|_exit|_Exit|quick_exit|terminate)\s*\(")


def blank(match):
    """A comment or a text without its content, on the same number of lines."""
    return '"' + "\n" * match[0].count("\n") + '"'


def cpp_files(root, folder):
    files = (root / folder).rglob("*")
    return sorted(f for f in files if f.suffix in (".h", ".hpp", ".cpp") and "node_modules" not in f.parts)


def violations(root):
    for folder, libraries in MAY_INCLUDE.items():
        for file in cpp_files(root, folder):
            path = file.relative_to(root).as_posix()
            text = file.read_text(encoding="utf-8")
            if LICENSE not in text[:500]:
                yield f"{path}:1: the license is missing ({LICENSE})"
            for match in INCLUDE.finditer(text):
                header = match[1]
                is_opt_in = header in NOT_BY_DEFAULT and path.startswith(OPT_IN)
                if not (SYSTEM.fullmatch(header) or header.startswith(libraries) or is_opt_in):
                    line = text.count("\n", 0, match.start(1)) + 1
                    yield f"{path}:{line}: {folder} must not include {header}"
            if folder not in QUIET:
                continue
            code = COMMENT_OR_TEXT.sub(blank, text)
            for match in LOUD.finditer(code):
                line = code.count("\n", 0, match.start()) + 1
                yield f"{path}:{line}: the library must not print, exit or abort ({match[0].rstrip(' (')})"


def not_portable(root):
    files = [file for folder in PORTABLE for file in cpp_files(root, folder)]
    for file in files:
        path = file.relative_to(root).as_posix()
        code = COMMENT_OR_TEXT.sub(blank, file.read_text(encoding="utf-8"))
        headers = [match for match in INCLUDE.finditer(code) if OPERATING_SYSTEM.fullmatch(match[1])]
        for match in [] if path.startswith(PLATFORM) else [*headers, *POSIX.finditer(code)]:
            name = match[match.lastindex or 0]
            if (path, name) not in NOT_PORTABLE:
                line = code.count("\n", 0, match.end()) + 1
                yield f"{path}:{line}: only {PLATFORM} may use {name}"


def unstable(root):
    for folder in ("include", "g2o/include"):
        for file in cpp_files(root, folder):
            text = file.read_text(encoding="utf-8")
            for match in DEPRECATED.finditer(text):
                line = text.count("\n", 0, match.start()) + 1
                yield f'{file.relative_to(root).as_posix()}:{line}: expected [[deprecated("use …")]]'
    lists, changes = root / "CMakeLists.txt", root / "CHANGELOG.md"
    version = VERSION.search(lists.read_text(encoding="utf-8")) if lists.exists() else None
    if version and f"\n## {version[1]}\n" not in changes.read_text(encoding="utf-8"):
        yield f"CHANGELOG.md:1: there is no section for version {version[1]}"
    package = root / "package.xml"
    if version and package.exists() and f"<version>{version[1]}</version>" not in package.read_text(encoding="utf-8"):
        yield f"package.xml:1: expected version {version[1]}, as in CMakeLists.txt"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    found = [*violations(root), *not_portable(root), *unstable(root)]
    print(*found, sep="\n", end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

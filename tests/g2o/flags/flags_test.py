#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A client without CMake whose flags differ from those of the g2o API works, or is told which flag to set.

    flags_test.py COMPILER WORK_DIR CLIENT INCLUDE_DIR EIGEN_DIR LIBRARY...
"""

import pathlib
import platform
import re
import subprocess
import sys

COMPILER, WORK, CLIENT, INCLUDE, EIGEN, *LIBRARIES = sys.argv[1:]
SET_ALIGNMENT = "-DEIGEN_MAX_ALIGN_BYTES=16"


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return done.returncode, done.stdout


def compile_client(*flags):
    """Returns the exit status and the messages."""
    return run(COMPILER, *flags, "-I", INCLUDE, "-isystem", EIGEN, "-c", CLIENT, "-o", f"{WORK}/client.o")


def link_client():
    folders = {f"-Wl,-rpath,{pathlib.Path(library).parent}" for library in LIBRARIES if "/" in library}
    return run(COMPILER, f"{WORK}/client.o", *LIBRARIES, *folders, "-o", f"{WORK}/client")


def cpu_runs_avx():
    try:
        return bool(re.search(r"\bavx\b", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")))
    except OSError:
        return False


def expect(condition, fact, messages):
    if not condition:
        sys.exit(f"expected: {fact}\n{messages}")


def check_language_levels():
    code, messages = compile_client("-std=c++11", SET_ALIGNMENT)
    errors = re.findall(r"error: .*", messages)
    expect(code != 0 and "needs C++17" in errors[0], "C++11 is refused, and the first error names C++17", messages)
    expect(len(errors) <= 2, "the compiler stops after this error", messages)
    code, messages = compile_client("-std=c++14", SET_ALIGNMENT, "-Wall", "-Wextra", "-Wpedantic")
    expect(code == 0 and not messages, "C++14 compiles without a message", messages)


def check_alignment():
    code, messages = compile_client("-std=c++17", "-mavx", SET_ALIGNMENT)
    expect(code == 0 and not messages, "a client with -mavx and the alignment of g2o compiles", messages)
    code, messages = link_client()
    expect(code == 0, "this client links", messages)
    if cpu_runs_avx():
        code, messages = run(f"{WORK}/client")
        expect(code == 0, "this client runs", messages)
    for flags, cure in (
        (("-mavx",), "add_EIGEN_MAX_ALIGN_BYTES_16"),
        (("-mavx", "-include", "Eigen/Core"), "add_EIGEN_MAX_ALIGN_BYTES_16"),
        (("-DEIGEN_DONT_ALIGN",), "remove_EIGEN_DONT_ALIGN"),
    ):
        code, messages = compile_client("-std=c++17", *flags)
        expect(code == 0, f"a client with {' '.join(flags)} compiles", messages)
        if "-mavx" in flags:
            expect(SET_ALIGNMENT in messages, "the compiler names the flag to set", messages)
        code, messages = link_client()
        expect(code != 0 and cure in messages, f"the missing symbol contains {cure}", messages)


def main():
    pathlib.Path(WORK).mkdir(parents=True, exist_ok=True)
    check_language_levels()
    if platform.machine() in ("x86_64", "AMD64"):
        check_alignment()


if __name__ == "__main__":
    main()

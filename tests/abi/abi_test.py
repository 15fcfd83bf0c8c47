#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Client programs whose compiler or flags differ from those of the library either run without errors or do not link.

    abi_test.py CMAKE BUILD_DIR WORK_DIR

Installs the build, then builds the programs in client/ against the installed library with g++ and with clang++.
A program with all flags of the target boxplus::boxplus always links, and AddressSanitizer finds no error in it. A
program NAME_bare is compiled without the flag that sets Eigen's alignment. If Eigen's default alignment for the
remaining flags equals the alignment of the library, this program also links and runs without errors. Otherwise the
linker reports an undefined symbol whose name ends with the alignment of the program.
"""

import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys

CMAKE, BUILD, WORK = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
COMPILERS = [compiler for compiler in ("g++", "clang++") if shutil.which(compiler)]
LIBRARY_ALIGNMENT = 16

def run(*command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False)
    return done.returncode, done.stdout

def must_run(*command):
    code, text = run(*command)
    if code:
        sys.exit(f"{' '.join(map(str, command))}\n{text}")
    return text

def eigen_alignment(compiler, *flags):
    """Eigen's default alignment, in bytes, with these compiler flags."""
    macros = must_run(compiler, *flags, "-dM", "-E", "-x", "c++", "/dev/null")
    return 64 if "__AVX512F__" in macros else 32 if "__AVX__" in macros else 16

def cpu_runs_avx2():
    try:
        return bool(re.search(r"\bavx2\b", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")))
    except OSError:
        return False

def check(folder, program, alignment, runnable):
    """Builds and runs a program. Returns None if it behaves as expected, else a message that says why it does not."""
    code, text = run(CMAKE, "--build", folder, "--target", program)
    if alignment != LIBRARY_ALIGNMENT:
        symbol = f"boxplus_abi_1_{alignment}"
        if code == 0:
            return f"linked, although the library does not define {symbol}"
        named = re.search(rf"undefined (reference|symbol).*\b{symbol}\b", text)
        return None if named else f"failed to build, but no error names the undefined symbol {symbol}:\n{text}"
    if code:
        return f"does not build:\n{text}"
    if not runnable:
        return None
    code, text = run(folder / program)
    return None if code == 0 else f"exits with status {code}:\n{text}"

def check_compiler(compiler, prefix):
    folder = WORK / compiler
    must_run(CMAKE, "-S", pathlib.Path(__file__).parent / "client", "-B", folder, "-G", "Ninja",
             f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_CXX_COMPILER={compiler}",
             f"-DCMAKE_CXX_COMPILER_LAUNCHER={shutil.which('ccache') or ''}")
    # Builds all programs in parallel. With -k 0, it continues after programs that must not link.
    run(CMAKE, "--build", folder, "--parallel", os.cpu_count(), "--", "-k", "0")

    bare = {"plain": 16, "debug": 16, "native": eigen_alignment(compiler, "-march=native")}
    if platform.machine() in ("x86_64", "AMD64"):
        bare |= {"avx2": 32, "avx2_stripped": 32}
    for name in bare:
        runnable = cpu_runs_avx2() or "avx2" not in name
        for program, alignment in ((name, LIBRARY_ALIGNMENT), (f"{name}_bare", bare[name])):
            trouble = check(folder, program, alignment, runnable)
            expected = ("links" + " and runs" * runnable if alignment == LIBRARY_ALIGNMENT
                        else f"does not link with alignment {alignment}")
            print(f"{compiler:8} {program:20} {trouble or 'ok: ' + expected}", flush=True)
            yield trouble is None

def main():
    shutil.rmtree(WORK, ignore_errors=True)
    prefix = WORK / "prefix"
    must_run(CMAKE, "--install", BUILD, "--prefix", prefix)
    results = [good for compiler in COMPILERS for good in check_compiler(compiler, prefix)]
    return 0 if results and all(results) else 1

if __name__ == "__main__":
    sys.exit(main())

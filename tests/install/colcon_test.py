#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""colcon_test.py SOURCE WORK_DIR: builds a workspace of ROS 2 with colcon: this checkout, as it is, and a package of
ament-cmake that uses boxplus and g2o. Without colcon or ament-cmake, the test is skipped (exit code 77).
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree

SOURCE, WORK = map(pathlib.Path, sys.argv[1:])
HERE = pathlib.Path(__file__).resolve().parent

# Both run with Debian's interpreter. Other interpreters in the PATH lack their modules.
ENVIRONMENT = os.environ | {"PATH": f"/usr/bin:{os.environ['PATH']}"}


def expect(condition, fact):
    if not condition:
        sys.exit(f"expected: {fact}")


def missing():
    """What the test needs and is not there, or None."""
    if not shutil.which("colcon"):
        return "colcon (the package colcon)"
    for package, plugin in (("python3-colcon-cmake", "colcon_cmake"), ("python3-colcon-ros", "colcon_ros"),
                            ("ament-cmake", "ament_package")):
        if subprocess.run(["/usr/bin/python3", "-c", f"import {plugin}"], capture_output=True, check=False).returncode:
            return package
    return None


def check_manifest():
    manifest = xml.etree.ElementTree.parse(SOURCE / "package.xml").getroot()
    version = re.search(r"project\(boxplus VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"))
    expect(manifest.get("format") == "3", "package.xml has format 3")
    expect(manifest.findtext("version") == version[1], f"package.xml has the version of CMake, {version[1]}")


def make_workspace():
    shutil.rmtree(WORK, ignore_errors=True)
    shutil.copytree(HERE / "colcon_client", WORK / "src" / "client")
    shutil.copy(HERE.parent / "g2o" / "install" / "ways" / "plain.cpp", WORK / "src" / "client")
    shutil.copytree(SOURCE, WORK / "src" / "boxplus", symlinks=True,
                    ignore=shutil.ignore_patterns("build", ".git", ".cache", "node_modules"))


def build():
    """With the flags and the folders of `make test`, so that ccache has all of the library. Other tests install programs
    and modules."""
    subprocess.run(["colcon", "build", "--event-handlers", "console_direct+",
                    "--build-base", "src/boxplus/build", "--cmake-args", "-GNinja",
                    "-DBOXPLUS_WARNINGS_ARE_ERRORS=ON", "-DBOXPLUS_BUILD_PYTHON=OFF", "-DBOXPLUS_BUILD_APPS=OFF"],
                   cwd=WORK, env=ENVIRONMENT, check=True)


def check_installation():
    prefix = WORK / "install" / "boxplus"
    for file in ("share/boxplus/package.xml", "share/ament_index/resource_index/packages/boxplus"):
        expect((prefix / file).is_file(), f"{file} is installed")
    cache = (WORK / "src" / "boxplus" / "build" / "boxplus" / "CMakeCache.txt").read_text(encoding="utf-8")
    expect("BOXPLUS_BUILD_TESTS:BOOL=OFF" in cache, "colcon does not build the tests of boxplus")
    for program in ("with_boxplus", "with_g2o"):
        line = f". install/setup.sh && install/client/lib/client/{program}"
        subprocess.run(["bash", "-c", line], cwd=WORK, env=ENVIRONMENT, check=True)


if __name__ == "__main__":
    check_manifest()
    if needed := missing():
        print(f"SKIPPED: a workspace of ROS 2 needs {needed}")
        sys.exit(77)
    make_workspace()
    build()
    check_installation()

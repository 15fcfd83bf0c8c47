# SPDX-License-Identifier: BSD-3-Clause
"""Builds the wheel of the Python module with CMake, for pip (PEP 517).

The wheel contains the shared libraries that the module needs, other than those of the C++ runtime. So it can be imported
on a machine without the packages of the build. It needs nothing but Python's standard library, CMake, Ninja, a compiler
and the libraries in scripts/debian-packages.txt.
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
#: Libraries that every machine with Python and a C++ runtime has.
SYSTEM_LIBRARIES = re.compile(r"^(ld-linux|lib(c|m|dl|rt|pthread|util|stdc\+\+|gcc_s)\.so)")


def version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(boxplus VERSION ([\d.]+)", text).group(1)


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    return f"{python}-{python}-{platform}"


def metadata():
    return (f"Metadata-Version: 2.1\nName: boxplus\nVersion: {version()}\n"
            "Summary: Nonlinear least squares on graphs: SLAM, bundle adjustment, calibration\n"
            "License: BSD-3-Clause\nRequires-Python: >=3.9\nRequires-Dist: numpy\n"
            "Provides-Extra: plot\nRequires-Dist: matplotlib>=3.6; extra == \"plot\"\n"
            "Description-Content-Type: text/markdown\n\n") + (ROOT / "docs/python.md").read_text(encoding="utf-8")


def run(*command):
    # pip isolates builds with these variables, and CMake asks the interpreter for its folders.
    environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYTHONNOUSERSITE")}
    subprocess.run([str(word) for word in command], check=True, env=environment)


def build_module(folder, build):
    """Builds the module, and installs it below `folder`. Returns the folders of the packages boxplus and g2o. `build` is the
    folder of an existing build, or None."""
    if build is None:
        build = ROOT / "build" / f"wheel-{tag()}"
        run("cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
            f"-DBOXPLUS_PYTHON={sys.executable}", "-DBOXPLUS_BUILD_APPS=OFF", "-DBOXPLUS_BUILD_G2O=OFF",
            "-DBOXPLUS_BUILD_TESTS=OFF")
    run("cmake", "--build", build, "--target", "boxplus_python")
    for component in ("python", "python_g2o"):
        run("cmake", "--install", build, "--prefix", folder, "--component", component, "--strip")
    package = next(pathlib.Path(folder).glob("lib/python*/*-packages/boxplus"))
    return package, package.with_name("g2o")


def needed_libraries(modules):
    """The shared libraries, as {name: path}, that the modules need and that a machine may not have."""
    text = "".join(subprocess.run(["ldd", str(module)], check=True, capture_output=True, text=True).stdout for module in modules)
    found = dict(re.findall(r"^\s*(\S+) => (\S+)", text, re.MULTILINE))
    return {name: path for name, path in found.items() if not SYSTEM_LIBRARIES.match(name)}


class Wheel:
    """A zip archive with a list of its files. The same files make the same bytes."""

    def __init__(self, path):
        self.archive = zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED)
        self.record = []

    def add(self, name, data):
        entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
        entry.external_attr = 0o644 << 16
        entry.compress_type = zipfile.ZIP_DEFLATED
        self.archive.writestr(entry, data)
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        self.record.append(f"{name},sha256={digest},{len(data)}\n")

    def close(self, info):
        self.archive.writestr(zipfile.ZipInfo(f"{info}/RECORD", (1980, 1, 1, 0, 0, 0)),
                              "".join(self.record) + f"{info}/RECORD,,\n")
        self.archive.close()


def licenses_of(libraries):
    """The licenses of libraries that come from Debian packages, as {package: path}."""
    paths = [str(pathlib.Path(path).resolve()) for path in libraries.values()]
    names = [path for real in paths for path in (real, real.removeprefix("/usr"))]
    try:
        found = subprocess.run(["dpkg-query", "-S", *names], capture_output=True, text=True, check=False).stdout
    except FileNotFoundError:
        return {}
    packages = set(re.findall(r"^([^:\s]+):", found, re.MULTILINE))
    files = {package: pathlib.Path(f"/usr/share/doc/{package}/copyright") for package in packages}
    return {package: path for package, path in files.items() if path.exists()}


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """PEP 517. The setting build-dir names an existing build, for example build/release."""
    name = f"boxplus-{version()}-{tag()}.whl"
    info = f"boxplus-{version()}.dist-info"
    with tempfile.TemporaryDirectory() as folder:
        package, g2o = build_module(folder, (config_settings or {}).get("build-dir"))
        wheel = Wheel(pathlib.Path(wheel_directory) / name)
        for path in (*sorted(package.iterdir()), *sorted(g2o.iterdir())):
            wheel.add(f"{path.parent.name}/{path.name}", path.read_bytes())
        libraries = needed_libraries(package.glob("_*.so"))  # _boxplus, and _viewer if there is one
        for name_of_package, path in sorted(licenses_of(libraries).items()):
            wheel.add(f"{info}/licenses/{name_of_package}", path.read_bytes())
        for library, path in sorted(libraries.items()):
            wheel.add(f"boxplus/libraries/{library}", pathlib.Path(path).read_bytes())
        wheel.add(f"{info}/METADATA", metadata().encode())
        wheel.add(f"{info}/WHEEL", f"Wheel-Version: 1.0\nGenerator: boxplus\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode())
        wheel.add(f"{info}/LICENSE", (ROOT / "LICENSE").read_bytes())
        wheel.close(info)
    return name


def build_sdist(sdist_directory, config_settings=None):
    """The files of the last commit."""
    name = f"boxplus-{version()}"
    path = pathlib.Path(sdist_directory) / f"{name}.tar.gz"
    subprocess.run(["git", "-C", str(ROOT), "archive", f"--prefix={name}/", "-o", str(path), "HEAD"], check=True)
    return path.name

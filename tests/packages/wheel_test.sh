#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# wheel_test.sh PYTHON SOURCE_DIR BUILD_DIR WORK_DIR: makes a wheel of the module, and imports it without the build.
set -euo pipefail
python="$1" source="$2" build="$3" work="$4"
fail() { echo "$*" >&2; exit 1; }

rm -rf "$work"
mkdir -p "$work/unpacked"
wheel="$(PYTHONPATH="$source/python/wheel" "$python" -c "
import boxplus_wheel, sys
name = boxplus_wheel.build_wheel('$work', {'build-dir': '$build'})
print(name, file=sys.stderr)" 2>&1 >/dev/null | tail -1)"
"$python" -m zipfile -e "$work/$wheel" "$work/unpacked"

# The modules use the libraries in the wheel, and no path of the build.
mapfile -t modules < <(find "$work/unpacked/boxplus" -name '_*.so')
((${#modules[@]} >= 1)) || fail "the wheel has no module"
[[ -f "$work/unpacked/boxplus/__init__.pyi" ]] || fail "the wheel has no types"
for module in "${modules[@]}"; do
  ldd "$module" | grep -E 'lib(amd|camd|fmt|suitesparse|cpp-httplib)' | grep -v "$work/unpacked/boxplus" && fail "the wheel lacks libraries"
  readelf -d "$module" | grep -qF "$build" && fail "the module contains the path of the build"
done

cd "$work"
PYTHONPATH="$work/unpacked" "$python" -c "
import boxplus, g2o
assert boxplus.__file__.startswith('$work/unpacked'), boxplus.__file__
assert g2o.__file__.startswith('$work/unpacked'), g2o.__file__
graph = boxplus.Graph()
a, b = graph.add_vertex(boxplus.SE2(0, 0, 0)), graph.add_vertex(boxplus.SE2(0, 0, 0))
graph.fix(a)
graph.add_edge(boxplus.Between(boxplus.SE2(1, 2, 0.5)), a, b)
assert boxplus.optimize(graph).converged()
if any('_viewer' in module for module in '${modules[*]}'.split()):
    import urllib.request
    with boxplus.view(graph) as viewer, urllib.request.urlopen(viewer.url, timeout=20) as page:
        assert page.status == 200
else:
    print('SKIPPED: the viewer')"

# pip accepts the wheel, with the digest of each file.
if "$python" -m pip --version >/dev/null 2>&1; then
  "$python" -m pip install --quiet --no-index --no-deps --target "$work/installed" "$work/$wheel"
  [[ -f "$work/installed/boxplus/__init__.py" ]] || fail "pip did not install the module"
fi

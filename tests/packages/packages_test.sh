#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# packages_test.sh CMAKE BUILD_DIR WORK_DIR COMPILER: makes the Debian packages of the build, installs them in a fresh root,
# uses each of them from there, and removes them.
set -euo pipefail
cmake="$1" build="$2" work="$3" compiler="$4"
tests="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
for tool in dpkg dpkg-deb dpkg-shlibdeps; do
  command -v "$tool" >/dev/null || { echo "SKIPPED: Debian packages need $tool"; exit 77; }
done
fail() { echo "$*" >&2; exit 1; }

rm -rf "$work"
mkdir -p "$work"
"$(dirname "$cmake")/cpack" --config "$build/CPackConfig.cmake" -B "$work/packages" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip >"$work/log" 2>&1 ||
  { cat "$work/log" >&2; exit 1; }
mapfile -t packages < <(find "$work/packages" -maxdepth 1 -name '*.deb' | sort)
((${#packages[@]} >= 4)) || fail "only ${#packages[@]} packages were made"

# Each package says what it is, has its license, and needs only packages that are here, where it was built.
for package in "${packages[@]}"; do
  name="$(dpkg-deb -f "$package" Package)"
  [[ -n "$(dpkg-deb -f "$package" Description)" ]] || fail "$name has no description"
  grep -q "/usr/share/doc/$name/copyright$" <<<"$(dpkg-deb -c "$package")" || fail "$name has no license"
  while read -r needed; do
    [[ " ${packages[*]} " == *"/${needed}_"* ]] || dpkg-query -W -f '${db:Status-Status}' "$needed" 2>/dev/null | grep -q '^installed' ||
      fail "$name needs $needed, which is not installed"
  done < <(dpkg-deb -f "$package" Depends | tr ',' '\n' | sed -e 's/|.*//' -e 's/(.*//' -e 's/[[:space:]]//g' -e '/^$/d')
done
for package in libg2o-boxplus libg2o-boxplus-dev python3-g2o-boxplus; do
  [[ "$package" != python3-* || "${packages[*]}" == *python3-boxplus* ]] || continue
  dpkg-deb -f "$work/packages/$package"_*.deb Replaces | grep -q g2o || fail "$package does not say what it replaces"
done

root="$work/root"
mkdir -p "$root/var/lib/dpkg/updates" "$root/var/lib/dpkg/info" "$root/var/lib/dpkg/triggers" "$root/tmp"
touch "$root/var/lib/dpkg/status" "$root/var/lib/dpkg/available"
# The scripts of packages run outside of the root, which has no shell, so ldconfig must do nothing.
mkdir -p "$work/bin"
printf '#!/bin/sh\n' >"$work/bin/ldconfig"
chmod +x "$work/bin/ldconfig"
in_root() {
  PATH="$work/bin:/usr/sbin:/sbin:$PATH" dpkg --root="$root" --force-not-root --force-script-chrootless --force-depends --log=/dev/null "$@" \
    >>"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
}
in_root --install "${packages[@]}"

# The command, with its manual page and completion.
export PATH="$root/usr/bin:$PATH"
boxplus="$root/usr/bin/boxplus"
"$boxplus" simulate manhattan --poses 100 -o "$work/graph.g2o" 2>>"$work/log"
"$boxplus" optimize "$work/graph.g2o" -o "$work/optimized.g2o" 2>>"$work/log"
grep -q '^.SS boxplus optimize$' "$root/usr/share/man/man1/boxplus.1" || fail "the manual page does not describe optimize"
bash -n "$root/usr/share/bash-completion/completions/boxplus"
grep -q lm_var <<<"$("$root/usr/bin/g2o" -listSolvers 2>&1)" || fail "g2o lists no solvers"
"$root/usr/bin/g2o_incremental" -i "$work/graph.g2o" -o "$work/grown.g2o" 2>>"$work/log"
for simulator in g2o_simulator2d g2o_simulator3d; do
  "$root/usr/bin/$simulator" -hasOdom -hasGPS "$work/simulated.g2o" 2>>"$work/log"
  "$root/usr/bin/g2o_hierarchical" "$work/simulated.g2o" 2>>"$work/log"
done
"$root/usr/bin/create_sphere" -laps 3 -nodesPerLevel 5 -o "$work/sphere.g2o" 2>>"$work/log"
grep -q '^VERTEX_XYT 3 1 2 0$' <<<"$("$root/usr/bin/g2o_online" 2>/dev/null <<<'ADD VERTEX_XYT 3 1 2 0; QUERY_STATE;')" ||
  fail "g2o_online does not answer"

# The project of a user, and a client of g2o.
"$cmake" -S "$tests/install/consumer" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$root/usr" -DCMAKE_CXX_COMPILER="$compiler" >>"$work/log"
"$cmake" --build "$work/build" >>"$work/log"
"$work/build/consumer"
"$cmake" -S "$tests/g2o/install/consumer" -B "$work/g2o_build" -G Ninja -DCMAKE_PREFIX_PATH="$root/usr" -DCMAKE_CXX_COMPILER="$compiler" >>"$work/log"
"$cmake" --build "$work/g2o_build" >>"$work/log"
"$work/g2o_build/consumer"

# The Python module, if it is built for Debian's interpreter.
if [[ "${packages[*]}" == *python3-boxplus* ]]; then
  folder="$(dirname "$(find "$root/usr/lib" -type d -name boxplus -path '*-packages*')")"
  [[ -f "$folder/boxplus/__init__.pyi" ]] || fail "the package has no types"
  PYTHONPATH="$folder" /usr/bin/python3 -B -c "
import boxplus
assert boxplus.__file__.startswith('$root'), boxplus.__file__
graph = boxplus.load('$work/graph.g2o')
assert boxplus.optimize(graph).converged()
import urllib.request
with boxplus.view(graph) as viewer:
    assert urllib.request.urlopen(viewer.url, timeout=20).status == 200
import g2o
assert g2o.__file__.startswith('$root'), g2o.__file__
assert g2o.SparseOptimizer().load('$work/graph.g2o')"
fi

# Nothing is left after the packages are removed.
mapfile -t names < <(for package in "${packages[@]}"; do dpkg-deb -f "$package" Package; done)
in_root --purge "${names[@]}"
left="$(find "$root/usr" -mindepth 1 2>/dev/null || true)"
[[ -z "$left" ]] || fail "after the packages were removed, these files are left: $left"

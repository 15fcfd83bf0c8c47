#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# plugin_test.sh CMAKE BUILD_DIR WORK_DIR COMPILER PLUGINS: checks that the installed tool loads plug-ins that the
# separate project in PLUGINS builds, and that it refuses plug-ins with a different ABI.
set -euo pipefail
cmake="$1" build="$2" work="$3" compiler="$4" plugins="$5"
rm -rf "$work"
"$cmake" --install "$build" --prefix "$work/installed" >/dev/null
"$cmake" -S "$plugins" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$work/installed" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_BUILD_TYPE=Debug >/dev/null
"$cmake" --build "$work/build"
tool="$work/installed/bin/g2o" types="$work/build/libexample_types_range.so" solver="$work/build/libexample_solver_ldlt.so"

cat > "$work/beacon.g2o" <<END
VERTEX_SE2 0 0 0 0
VERTEX_SE2 1 4 0 0
VERTEX_SE2 2 0 4 0
VERTEX_BEACON 3 1 2
FIX 0 1 2
EDGE_RANGE 0 3 5 1
EDGE_RANGE 1 3 4.123105625617661 1
EDGE_RANGE 2 3 3 1
END
found_at() { awk '$1 == "VERTEX_BEACON" { printf "%.3f %.3f", $3, $4 }'; }
run() { "$tool" -i 20 -o - "$@" "$work/beacon.g2o" 2> "$work/err.txt" | found_at; }

expected="3.000 4.000"
[[ $(run -typeslib "$types") == "$expected" ]]
(cd "$work/build" && unset LD_LIBRARY_PATH && [[ $(run -typeslib "$(basename "$types")") == "$expected" ]])
[[ $(run -typeslib "$types" -typeslib "$types") == "$expected" ]]
# The engine, which does not know the types of plug-ins, leaves them to the algorithm.
[[ $("$(dirname "$tool")/g2o_hierarchical" -typeslib "$types" -o - "$work/beacon.g2o" 2> "$work/err.txt" | found_at) == "$expected" ]]
[[ $(run -typeslib "$types" -solverlib "$solver" -solver lm_ldlt) == "$expected" ]]
[[ $(G2O_TYPES_DIR="$work/build" G2O_SOLVER_DIR="$work/build" run -solver lm_ldlt) == "$expected" ]]
[[ $(G2O_TYPES_DIR="$work/build" G2O_SOLVERS_DIR="$work/build" run -solver lm_ldlt) == "$expected" ]]
cp "$types" "$work/installed/lib"
[[ $(run) == "$expected" ]]
rm "$work/installed/lib/$(basename "$types")"
[[ -z $(run) ]] && grep -q "unknown tag .VERTEX_BEACON" "$work/err.txt"

[[ $(G2O_TYPES_DIR="$work/build" G2O_SOLVER_DIR="$work" G2O_SOLVERS_DIR="$work/build" run -solver lm_ldlt) == "$expected" ]]
G2O_TYPES_DIR="$work/nowhere" run > /dev/null
grep -q "G2O_TYPES_DIR: there is no folder $work/nowhere" "$work/err.txt"

# refuses SYMBOL FLAGS...: checks that the tool does not load a plug-in that is compiled with FLAGS, and names SYMBOL.
refuses() {
  "$compiler" -std=c++17 -shared -fPIC "${@:2}" -I "$work/installed/include" -isystem /usr/include/eigen3 \
    "$plugins/range_types.cpp" -o "$work/other_types_abi.so"
  run -typeslib "$work/other_types_abi.so" > /dev/null || true
  grep -q "cannot be loaded.*$1" "$work/err.txt"
  grep -q "unknown tag .VERTEX_BEACON" "$work/err.txt" # the tool continues without the plug-in
}
refuses g2o_abi_1_32_add_EIGEN_MAX_ALIGN_BYTES_16 -DEIGEN_MAX_ALIGN_BYTES=32
refuses g2o_abi_1_16_remove_EIGEN_MAX_STATIC_ALIGN_BYTES -DEIGEN_MAX_ALIGN_BYTES=16 -DEIGEN_MAX_STATIC_ALIGN_BYTES=0
refuses g2o_abi_1_16_remove_EIGEN_DEFAULT_TO_ROW_MAJOR -DEIGEN_MAX_ALIGN_BYTES=16 -DEIGEN_DEFAULT_TO_ROW_MAJOR
refuses g2o_abi_1_16_remove_GLIBCXX_DEBUG -DEIGEN_MAX_ALIGN_BYTES=16 -D_GLIBCXX_DEBUG
sed 's/EDGE_RANGE 0 3 5/EDGE_RANGE 0 3 five/' "$work/beacon.g2o" > "$work/broken.g2o"
if "$tool" -typeslib "$types" "$work/broken.g2o" 2> "$work/err.txt"; then exit 1; fi
grep -q "line 6: EDGE_RANGE: expected a number, got 'five'" "$work/err.txt"

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# linking_test.sh CMAKE BUILD_DIR WORK_DIR COMPILER IS_STATIC: checks that the linker does not remove the code that
# registers types and algorithms, even with link-time optimization and --gc-sections. If a program names a type group or
# an algorithm library, all types of the group and all algorithms of the library must be registered. If a program uses
# only the class of a type, the file tag of the type must be registered. Moreover, two copies of the g2o API in one
# process must not interfere. IS_STATIC is 1 if the build has static libraries, else 0.
set -euo pipefail
cmake="$1" build="$2" work="$3" compiler="$4" is_static="$5"
consumer="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/consumer"
rm -rf "$work"
"$cmake" --install "$build" --prefix "$work/installed" >/dev/null
"$cmake" -S "$consumer" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$work/installed" -DCMAKE_CXX_COMPILER="$compiler" \
  -DG2O_USE_STATIC_LIBS="$is_static" >/dev/null
"$cmake" --build "$work/build"
"$work/build/stripped"
"$work/build/unnamed"
"$work/build/two_copies" "$work/build/libfirst.so" "$work/build/libsecond.so" "$is_static"
"$work/build/joined"
"$work/build/reopened" "$(dirname "$(find "$work/installed" -name libg2o_core.so)")"
"$work/build/host" "$work/build/libfirst.so"
if [[ $is_static == 1 ]]; then "$work/build/beside_another"; fi
exported=$(objdump -T "$(find "$work/installed" -name libg2o_core.so)" | grep -v UND)
grep -q "BOXPLUS_G2O_1.*SparseOptimizer8optimize" <<<"$exported"
if grep "_ZN[0-9K]*7boxplus" <<<"$exported"; then
  echo "libg2o_core.so exports symbols of the engine" >&2
  exit 1
fi

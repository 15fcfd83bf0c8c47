#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# install_test.sh CMAKE BUILD_DIR WORK_DIR COMPILER IS_STATIC: installs the build, moves the installed folder, and
# builds clients of it. Some clients use find_package(g2o), and others know only the folders of the headers and
# libraries. IS_STATIC is 1 if the build also has static libraries, else 0.
set -euo pipefail
cmake="$1" build="$2" work="$3" compiler="$4" is_static="$5"
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"

rm -rf "$work"
"$cmake" --install "$build" --prefix "$work/first" >/dev/null
mv "$work/first" "$work/moved"
if grep -rn "#include.*boxplus/" "$work/moved/include/g2o"; then
  echo "a header of the g2o API includes a header of the engine" >&2
  exit 1
fi
launcher=$(command -v ccache || true)
configure() { # SOURCE BUILD OPTIONS...
  "$cmake" -S "$1" -B "$2" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" "${@:3}" >/dev/null
}
library=$(dirname "$(find "$work/moved" -name libg2o_core.so)")
for name in stuff core types_data incremental csparse_extension solver_cholmod solver_csparse; do
  [[ -e "$library/libg2o_$name.so" ]] || { echo "libg2o_$name.so is not installed" >&2; exit 1; }
done

configure "$here/consumer" "$work/build" -DCMAKE_PREFIX_PATH="$work/moved"
"$cmake" --build "$work/build"
"$work/build/consumer"
"$work/build/old_consumer"
configure "$here/consumer" "$work/by_folder" -Dg2o_DIR="$library/cmake/g2o"

# Build and run the clients in ways/, with shared libraries and, if the build has them, with static libraries.
variants=(OFF)
if [[ $is_static == 1 ]]; then variants+=(ON); fi
for static in "${variants[@]}"; do
  ways="$work/ways_$static"
  configure "$here/ways" "$ways" -DCMAKE_PREFIX_PATH="$work/moved" -DG2O_USE_STATIC_LIBS="$static"
  "$cmake" --build "$ways"
  "$ways/icp" >/dev/null
  "$ways/stuff_alone" >/dev/null
  "$ways/short_paths"
  "$ways/algorithms" lm_var_cholmod
  "$ways/algorithms_cholmod" lm_var_cholmod
  "$ways/algorithms_eigen" lm_var
done

# Build and run a C++14 client without CMake. It must link with every order of the libraries.
flags=(-I "$work/moved/include" -isystem /usr/include/eigen3)
compile() { $launcher "$compiler" "${flags[@]}" "$@"; }
compile -std=c++14 -Wall -Wextra -Werror -DEIGEN_MAX_ALIGN_BYTES=16 -c "$here/ways/plain.cpp" -o "$work/plain.o"
for libraries in "-lg2o_core -lg2o_stuff -lg2o_types_slam3d" "-lg2o_types_slam3d -lg2o_stuff -lg2o_core" \
                 "-lg2o_stuff -lg2o_types_slam3d -lg2o_core"; do
  # shellcheck disable=SC2086
  "$compiler" "$work/plain.o" -L "$library" $libraries -Wl,-rpath,"$library" -o "$work/plain" 2>"$work/err.txt" ||
    { cat "$work/err.txt" >&2; exit 1; }
  "$work/plain" >/dev/null 2>"$work/err.txt"
  grep -q "g2o: .*parameter" "$work/err.txt" || { echo "expected a message about the refused edge on stderr" >&2; exit 1; }
done

# A client without CMake that names the algorithms and libraries of CHOLMOD and CSparse runs on the engine.
compile -std=c++17 -DEIGEN_MAX_ALIGN_BYTES=16 "$here/ways/algorithms.cpp" -L "$library" -lg2o_core -lg2o_stuff \
  -lg2o_types_slam2d -lg2o_solver_cholmod -lg2o_solver_csparse -Wl,-rpath,"$library" -o "$work/algorithms"
"$work/algorithms" lm_var_cholmod

# No installed library needs CHOLMOD or CSparse, except for the opt-in libraries that are named after them.
for file in "$library"/lib*.so; do
  [[ $file == *suitesparse* ]] && continue
  if objdump -p "$file" | grep -E "NEEDED.*(cholmod|cxsparse)"; then
    echo "$file needs libraries under the GPL or the LGPL" >&2
    exit 1
  fi
done

# A client whose flags change the alignment of Eigen's types must not link. The name of the missing symbol must contain
# the flag that the client must add.
compile -std=c++17 -DEIGEN_MAX_ALIGN_BYTES=64 -c "$here/ways/plain.cpp" -o "$work/plain.o"
if "$compiler" "$work/plain.o" -L "$library" -lg2o_core -lg2o_stuff -lg2o_types_slam3d -o "$work/plain" 2>"$work/err.txt"; then exit 1; fi
grep -q "g2o_abi_1_64_add_EIGEN_MAX_ALIGN_BYTES_16" "$work/err.txt"

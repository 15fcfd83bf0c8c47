#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# install_test.sh CMAKE BUILD_DIR WORK_DIR COMPILER: installs the build, moves it, and builds a consumer against it.
set -euo pipefail
cmake="$1" build="$2" work="$3" compiler="$4"
consumer="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/consumer"

rm -rf "$work"
"$cmake" --install "$build" --prefix "$work/first" >/dev/null
mv "$work/first" "$work/moved"
if grep -rnF -e "$work" -e "$build" "$work/moved" --include='*.cmake'; then
  echo "the package names the place where it was built or first installed" >&2
  exit 1
fi

"$cmake" -S "$consumer" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$work/moved" -DCMAKE_CXX_COMPILER="$compiler"
"$cmake" --build "$work/build"
"$work/build/consumer"

# Installed programs start from the folder that they were moved to.
for program in "$work"/moved/bin/*; do
  if [[ -x "$program" ]]; then "$program" --help >/dev/null; fi
done

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Simulates a noisy pose graph on a sphere, optimizes it, and draws it before and after the optimization.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

boxplus=build/release/bin/boxplus
folder=build/demo
mkdir -p "$folder"

# Prints a command as a user would type it, and then runs it.
run() {
  printf '\n$ %s\n' "$*"
  "$@"
}

run "$boxplus" simulate sphere --poses 2500 -o "$folder/sphere.g2o"
run "$boxplus" optimize "$folder/sphere.g2o" -o "$folder/sphere_optimized.g2o"
run "$boxplus" plot "$folder/sphere.g2o" "$folder/sphere_optimized.g2o" -o "$folder/sphere.svg"

cat <<END

These files were written:
  $folder/sphere.g2o            the simulated graph; its estimates come from the odometry
  $folder/sphere_optimized.g2o  the optimized graph
  $folder/sphere.svg            the picture of the graph before and after the optimization

To see the graph in a browser, and to optimize it there, type:
  $boxplus view $folder/sphere.g2o
END

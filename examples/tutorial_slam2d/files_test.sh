#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# files_test.sh TUTORIAL G2O BOXPLUS WORK_DIR: checks the files that the tutorial writes. boxplus must compute the same
# chi2 as the tutorial, and must plot the files. First, the tool g2o replaces the tutorial's tags in the files by tags
# that boxplus can read.
set -euo pipefail
tutorial_program="$1" g2o_program="$2" boxplus_program="$3" work="$4"
rm -rf "$work" && mkdir -p "$work" && cd "$work"
tutorial_slam2d() { "$tutorial_program" "$@"; }
g2o() { "$g2o_program" "$@"; }
boxplus() { "$boxplus_program" "$@"; }

# [picture]
tutorial_slam2d -o . > said.txt
names=TUTORIAL_VERTEX_SE2=VERTEX_SE2,TUTORIAL_VERTEX_POINT_XY=VERTEX_XY,TUTORIAL_PARAMS_SE2_OFFSET=PARAMS_SE2OFFSET
names+=,TUTORIAL_EDGE_SE2=EDGE_SE2,TUTORIAL_EDGE_SE2_POINT_XY=EDGE_SE2_POINTXY_OFFSET
for when in before after; do
  g2o -i 0 -renameTypes "$names" -o "$when.g2o" "tutorial_$when.g2o"
done
boxplus plot before.g2o after.g2o -o tutorial.svg
# [/picture]
grep -q "</svg>" tutorial.svg

# boxplus must compute the chi2 that the tutorial printed, up to the last printed digit.
for when in before after; do
  said=$(sed -n "s/^$when: *chi2 = \([0-9.]*\);.*/\1/p" said.txt)
  found=$(boxplus info "$when.g2o" | sed -n 's/.*chi2[^0-9]*\([0-9.e+]*\).*/\1/p' | head -1)
  awk -v a="$said" -v b="$found" 'BEGIN { exit !(a > 0 && (a - b)^2 < (0.06 + 1e-5 * a)^2) }' ||
    { echo "chi2 $when: the tutorial says $said, boxplus $found" >&2; exit 1; }
done

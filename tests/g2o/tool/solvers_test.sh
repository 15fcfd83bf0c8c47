#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# solvers_test.sh TOOL WORK_DIR DATA: runs every algorithm on 2-D and 3-D graphs, with and without landmarks. Also runs
# some algorithms on public data sets if the folder DATA contains them.
source "$(dirname "$0")/tool_case.sh" "$1" "$2"
data="$3"

(grep -v TRACK space.g2o
 echo "EDGE_SE3:QUAT 0 2 2.1 0 0 0 0 0.01 0.99995 10 0 0 0 0 0 10 0 0 0 0 10 0 0 0 40 0 0 40 0 40") > loop.g2o
cat > scales.g2o <<END
VERTEX_SIM3:EXPMAP 0 0 0 0 0 0 0 0 1 1 0 0
VERTEX_SIM3:EXPMAP 1 0 0 0 -1.1 0 0.1 0.1 1 1 0 0
VERTEX_TRACKXYZ 10 0.1 0.2 2
VERTEX_TRACKXYZ 11 -0.4 0.3 3
EDGE_SIM3:EXPMAP 0 1 0 0 0 -1 0 0 0 1 0 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1
EDGE_PROJECT_SIM3_XYZ:EXPMAP 10 0 0.05 0.11 9 0 9
EDGE_PROJECT_SIM3_XYZ:EXPMAP 10 1 0.5 0.1 9 0 9
EDGE_PROJECT_SIM3_XYZ:EXPMAP 11 0 -0.13 0.1 9 0 9
EDGE_PROJECT_SIM3_XYZ:EXPMAP 11 1 0.2 0.11 9 0 9
END

names=$("$tool" -listSolvers 2>&1 | awk '!/^#/ && !/^g2o:/ { print $1 }')
count=$(wc -w <<< "$names")
# There are 46 algorithms, and 9 more for each opt-in plug-in of SuiteSparse that is built.
expected_count=46
for plugin in suitesparse_cholmod suitesparse_csparse; do
  if grep -qx "lm_var_$plugin" <<< "$names"; then
    expected_count=$((expected_count + 9))
  else
    echo "skipped: the algorithms *_$plugin, because G2O_USE_${plugin^^} is OFF"
  fi
done
((count == expected_count)) || complain "expected $expected_count algorithms, got $count:" <(echo "$names")
if ldd "$tool" | grep -E "cholmod|cxsparse"; then
  complain "expected that the tool links neither CHOLMOD nor CSparse; ldd:" <(ldd "$tool")
fi

# same_end GRAPH SUITABLE: checks that all algorithms whose names match the pattern SUITABLE reach the same final chi2
# (except structure_only: it only has to decrease chi2), and that the tool exits with 3 for all other algorithms.
same_end() {
  local graph="$1" suitable="$2" expected="" found=0
  for name in $names; do
    if [[ ! $name =~ ^($suitable)((_suitesparse)?(_cholmod|_csparse))?$ ]]; then
      expect 3 "does not support" -solver $name "$graph"
      continue
    fi
    expect 0 "final chi2" -i 50 -solver $name "$graph"
    is_not "failed" err.txt
    if [[ $name == structure_only* ]]; then
      holds "$(final) < $(initial)"
      continue
    fi
    found=$((found + 1))
    expected=${expected:-$(final)}
    holds "($expected - $(final)) ^ 2 <= 1e-10 * $expected ^ 2"
  done
  ((found >= 20)) || complain "$graph: expected at least 20 suitable algorithms, got $found of:" <(echo "$names")
}
any="(gn|lm|dl)_var|(gn|lm)_(dense|pcg)"
sizes() { echo "(gn|lm)_(fix|dense|pcg)$1"; }
same_end square.g2o "$any|$(sizes 3_2)|structure_only_2"
same_end poses.g2o "$any|$(sizes 3_2)|2dlinear"
same_end space.g2o "$any|$(sizes 6_3)|structure_only_3"
same_end loop.g2o "$any|$(sizes 6_3)"
same_end scales.g2o "$any|$(sizes 7_3)|structure_only_3"

# best FILE CHI2 SOLVER...: checks that each SOLVER reaches CHI2 if it starts from the initial guess of the option
# -guess. Skips a FILE or a SOLVER that is not available.
best() {
  local file="$data/$1" chi2="$2"
  shift 2
  [[ -e $file ]] || return 0
  for name in "$@"; do
    if ! grep -qx "$name" <<< "$names"; then continue; fi
    expect 0 "final chi2" -i 10 -guess -solver $name "$file"
    holds "$(final) <= $chi2 * 1.0001"
  done
}
best posegraph2d/csail.g2o 38.9563 gn_var gn_fix3_2 dl_var 2dlinear gn_var_cholmod gn_fix3_2_csparse \
  gn_var_suitesparse_cholmod gn_fix3_2_suitesparse_csparse
best posegraph3d/smallGrid3D.g2o 458.154 gn_var lm_var dl_var lm_fix6_3 gn_pcg lm_dense lm_var_cholmod gn_fix6_3_csparse \
  lm_var_suitesparse_cholmod gn_fix6_3_suitesparse_csparse

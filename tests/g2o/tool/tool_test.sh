#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# tool_test.sh TOOL WORK_DIR: the switches of the tool g2o, and how it ends.
set -uo pipefail
tool="$1" work="$2"
rm -rf "$work" && mkdir -p "$work" && cd "$work"

cat > square.g2o <<END
VERTEX_SE2 0 0 0 0
VERTEX_SE2 1 1.1 0.1 1.57
VERTEX_SE2 2 0.9 1.2 3.1
VERTEX_SE2 3 -0.1 0.9 -1.6
VERTEX_XY 7 0.4 0.4
EDGE_SE2 0 1 1.00 0 1.57 10 0 0 10 0 40
EDGE_SE2 1 2 1.02 0 1.57 10 0 0 10 0 40
EDGE_SE2 2 3 1.01 0 1.57 10 0 0 10 0 40
EDGE_SE2 3 0 1.00 0 1.57 10 0 0 10 0 40
EDGE_SE2_XY 0 7 0.5 0.5 20 0 20
EDGE_SE2_XY 2 7 0.5 0.5 20 0 20
END
sed 's/EDGE_SE2 3 0 .*/EDGE_SE2 3 0 nan/' square.g2o > broken.g2o

# expect CODE TEXT ARGUMENT...: the tool ends with CODE, and says TEXT on standard error.
expect() {
  local code="$1" text="$2"
  shift 2
  "$tool" "$@" > out.txt 2> err.txt
  local ended=$?
  if [[ $ended != "$code" ]] || ! grep -qF -e "$text" err.txt; then
    echo "g2o $*: expected to end with $code and to say '$text'; it ended with $ended and said:" >&2
    cat err.txt >&2
    exit 1
  fi
}

expect 0 "no input"
expect 0 "no solver nonsense" -solver nonsense square.g2o
expect 1 "cannot be opened" no_such_file.g2o
expect 2 "line 9" broken.g2o
expect 2 "no vertex 99" -gaugeList 99 square.g2o
expect 3 "does not suit" -solver lm_fix6_3 square.g2o
expect 1 "unknown parameter" -nonsense square.g2o
expect 0 "final chi2" -o - square.g2o
grep -q "^VERTEX_XY 7 " out.txt
expect 0 "iteration= 9" -v -i 10 square.g2o
expect 0 "lambda=" -v -solver lm_var square.g2o
expect 0 "schur= 1" -v -solver gn_fix3_2 square.g2o
expect 0 "schur= 1" -v -marginalize square.g2o
expect 0 "VERTEX_SE2" -listTypes
expect 0 "EDGE_SIM3:EXPMAP" -listTypes
expect 0 "VERTEX_PLANE" -listTypes
expect 0 "lm_dense7_3" -listSolvers
expect 0 "2dlinear" -listSolvers
grep -v VERTEX_XY square.g2o | grep -v EDGE_SE2_XY > poses.g2o
expect 0 "final chi2" -solver 2dlinear poses.g2o
for plugin in cholmod csparse; do  # where they were built, the tool finds them beside itself
  if [[ -e $(dirname "$tool")/../lib/g2o/libg2o_solver_$plugin.so ]]; then
    expect 0 "lm_fix7_3_$plugin" -listSolvers
    expect 0 "schur= 1" -v -solver lm_fix3_2_$plugin square.g2o
    expect 0 "step=" -v -solver dl_var_$plugin square.g2o
  fi
done
expect 0 "Huber" -listRobustKernels
expect 0 "maxTrialsAfterFailure	2" -solver lm_var -solverProperties maxTrialsAfterFailure=2 -printSolverProperties square.g2o
expect 0 "Vertices 1 2" -computeMarginals square.g2o
expect 0 "final chi2" -robustKernel Cauchy -robustKernelWidth 2 -nonSequential square.g2o
expect 0 "no robust kernel X" -robustKernel X square.g2o
expect 0 "fixed by vertex 0" square.g2o
expect 0 "final chi2" -gaugeId 2 -guess square.g2o
if grep -q "fixed by" err.txt; then echo "-gaugeId fixes the gauge" >&2; exit 1; fi
expect 0 "final chi2" -inc -update 2 square.g2o
expect 0 "final chi2" -inc -update 2 -guiout square.g2o
if (($(grep -c "^plot " out.txt) != 3 || $(grep -c "^e$" out.txt) != 3)); then
  echo "expected three plots for gnuplot:" >&2
  cat out.txt >&2
  exit 1
fi
expect 0 "final chi2" -i -1 -gain 1e-4 -stats stats.txt -summary summary.csv square.g2o
lines=$(wc -l < stats.txt)
if ((lines < 2 || lines > 20)) || ! grep -q "chi2= " stats.txt || (($(wc -l < summary.csv) != 2)); then
  echo "expected a few lines of statistics, and a summary" >&2
  exit 1
fi
expect 0 "final chi2" -gnudump plot square.g2o
if (($(wc -l < plot_vertices) != 5 || $(wc -l < plot_edges) != 18 || $(wc -l < plot_landmarks_edges) != 6 ||
     $(wc -l < plot_odom_edges) != 9)); then
  echo "expected 5 vertices, 6 edges, 2 of them to landmarks and 3 of odometry for gnuplot" >&2
  exit 1
fi
sed 's/VERTEX_XY/POINT/' square.g2o | "$tool" -renameTypes POINT=VERTEX_XY - 2> err.txt && grep -q "final chi2" err.txt

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# tool_test.sh TOOL WORK_DIR: tests each option of the tool g2o.
source "$(dirname "$0")/tool_case.sh" "$1" "$2"

# -h, -help, and no input
expect 0 "no input"
for switch in -h -help --help; do
  "$tool" $switch > out.txt 2> err.txt || exit 1
  is "Usage: $tool [options] [graph-input]" out.txt
  for name in i gain ig v guess guessOdometry inc update guiout marginalize printSolverProperties solverProperties gnudump \
    robustKernel robustKernelWidth nonSequential computeMarginals gaugeId gaugeList o solver solverlib typeslib stats summary \
    listTypes listSolvers listRobustKernels renameTypes help; do
    is "-$name " out.txt
  done
done

# -i: five iterations by default, or the given number, which may be 0
expect 0 "iteration= 4" -v square.g2o
is_not "iteration= 5" err.txt
expect 0 "iteration= 9" -v -i 10 square.g2o
expect 0 "final chi2 = 4.6827" -i 0 square.g2o
is_not "failed" err.txt

# -i with a negative number: iterates until the relative decrease of chi2 is below the limit of -gain, or until chi2 no
# longer decreases, but at most as often as -ig allows
expect 0 "final chi2 = 0.00189884" -v -i -1 square.g2o
is_not "iteration= 10" err.txt
expect 0 "iteration= 1" -v -i -1 -gain 1e9 square.g2o
is_not "iteration= 2" err.txt
expect 0 "iteration= 1" -v -i -1 -ig 2 -gain 0 square.g2o
is_not "iteration= 2" err.txt
expect 0 "final chi2 = 4.6827" -i -1 -ig 0 square.g2o
is_not "failed" err.txt
expect 0 "final chi2 = 0.00189884" -i -1 -gain 0 square.g2o
printf 'VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0.1\nEDGE_SE2 0 1 1.1 0.3 0.7 1 0 0 1 0 1\n' > exact.g2o
expect 0 "final chi2" -i -1 exact.g2o

# -solver, -listSolvers, -solverProperties, -printSolverProperties
expect 0 "lambda=" -v -solver lm_var square.g2o
expect 0 "schur= 0" -v square.g2o
expect 0 "schur= 1" -v -solver gn_fix3_2 square.g2o
expect 0 "lm_dense7_3" -listSolvers
expect 0 "2dlinear" -listSolvers
expect 0 "maxTrialsAfterFailure	2" -solver lm_var -solverProperties maxTrialsAfterFailure=2 -printSolverProperties square.g2o
expect 0 "lambda= 0.000100" -v -i 1 -solver lm_var -solverProperties initialLambda=0.0003,maxTrialsAfterFailure=2 square.g2o
expect 0 "could not set all of these properties" -solverProperties nonsense=1 square.g2o

# -marginalize
expect 0 "schur= 1" -v -marginalize square.g2o
is "final chi2 = 0.00189884" err.txt
expect 0 "schur= 0" -v -marginalize poses.g2o

# -guess, -guessOdometry
sed -E 's/^(VERTEX_SE2 [123]) .*/\1 5 5 0/' square.g2o > far.g2o
expect 0 "final chi2" -i 0 far.g2o
far=$(initial)
expect 0 "final chi2" -i 0 -guess far.g2o
along_tree=$(initial)
expect 0 "final chi2" -i 0 -guessOdometry far.g2o
along_odometry=$(initial)
holds "$along_tree < $far / 10 && $along_odometry < $far / 10 && $along_tree != $along_odometry"

# -gaugeId, -gaugeList, and the vertex that the tool fixes without these options
expect 0 "fixed by vertex 0" square.g2o
expect 0 "final chi2" -gaugeId 2 -o - square.g2o
is_not "fixed by" err.txt
is "FIX 2" out.txt
expect 0 "final chi2" -gaugeList 1,3 -gaugeId 2 -o - square.g2o
for id in 1 2 3; do is "FIX $id" out.txt; done
is_not "FIX 0" out.txt
expect 2 "no vertex 99" -gaugeList 0,99 square.g2o
expect 2 "no vertex 98" -gaugeId 98 square.g2o
(cat square.g2o; echo "EDGE_PRIOR_SE2 1 1 0 1.57 10 0 0 10 0 40") > prior.g2o
expect 0 "final chi2" prior.g2o
is_not "fixed by" err.txt
(cat square.g2o; printf 'VERTEX_SE2 20 0 0 0\nVERTEX_SE2 21 1 0 0\nEDGE_SE2 20 21 1 0 0 1 0 0 1 0 1\n') > island.g2o
expect 0 "not connected to a fixed vertex: 2" -solver lm_var island.g2o

# -robustKernel, -robustKernelWidth, -nonSequential, -listRobustKernels
for kernel in Huber PseudoHuber Cauchy GemanMcClure Welsch Fair Tukey Saturated DCS; do
  expect 0 "$kernel" -listRobustKernels
  expect 0 "final chi2" -robustKernel $kernel square.g2o
done
expect 0 "no robust kernel X" -robustKernel X square.g2o
is "final chi2 = 0.00189884" err.txt
sed 's/EDGE_SE2 3 0 1.00 0/EDGE_SE2 3 0 9.00 9/' square.g2o > outlier.g2o
chi2_with() {
  expect 0 "final chi2" -i 0 "$@" outlier.g2o
  final
}
without=$(chi2_with) wide=$(chi2_with -robustKernel Cauchy) narrow=$(chi2_with -robustKernel Cauchy -robustKernelWidth 0.1)
loops=$(chi2_with -robustKernel Cauchy -robustKernelWidth 0.1 -nonSequential)
holds "$wide < $without && $narrow < $wide && $narrow < $loops && $loops < $without"

# -computeMarginals: prints the diagonal blocks and the blocks beside them, also after 0 iterations or with -marginalize
expect 0 "Vertices 1 1" -computeMarginals square.g2o
is "Vertices 1 2" err.txt
is "Vertices 7 7" err.txt
is_not "Vertices 1 3" err.txt
covariance() { grep -A 2 "^Vertices 7 7" err.txt | awk 'NR == 2 { printf "%.5f", $1 }'; }
plain=$(covariance)
expect 0 "Vertices 7 7" -computeMarginals -marginalize square.g2o
holds "$plain > 0 && $plain == $(covariance)"
expect 0 "Vertices 7 7" -computeMarginals -inc square.g2o
holds "($plain - $(covariance)) ^ 2 < 1e-6 * $plain ^ 2"
expect 0 "Vertices 1 1" -computeMarginals -i 0 square.g2o
expect 0 "covariances cannot be computed" -computeMarginals -solver structure_only_2 square.g2o

# -inc, -update, -guiout: adds the vertices one by one; after the number of vertices given by -update, runs one
# iteration, or as many as -i requests
count() { grep -c "$1" "$2"; }
expect 0 "final chi2 = 0.0018" -inc -update 2 -v square.g2o
holds "$(count '^iteration= 0' err.txt) == 3 && $(count '^iteration= 1' err.txt) == 0"
expect 0 "iteration= 2" -inc -update 2 -i 3 -v square.g2o
expect 0 "final chi2" -inc -v square.g2o
holds "$(count '^iteration= ' err.txt) == 1"
expect 0 "final chi2 = 0.00189884" -inc -update 1 -i -1 -stats inc_stats.txt square.g2o
holds "$(wc -l < inc_stats.txt) > 8"
expect 0 "final chi2 = 0.0018" -inc -update 1 -gaugeId 3 -o - square.g2o
is_not "failed" err.txt
is_not "FIX 0" out.txt
expect 0 "final chi2" -inc -update 2 -guiout square.g2o
holds "$(count '^plot ' out.txt) == 3 && $(count '^e$' out.txt) == 3"
expect 0 "final chi2" -inc -guiout space.g2o
is "splot" out.txt
expect 0 "final chi2" -guiout square.g2o  # -guiout has no effect without -inc
lines 0 out.txt

# -o, -stats, -summary, -gnudump
expect 0 "final chi2" -o - square.g2o
is "VERTEX_XY 7 " out.txt
expect 0 "final chi2" -o result.g2o square.g2o
lines 0 out.txt
expect 0 "initial chi2 = 0.0018988" result.g2o
expect 0 "final chi2" -i 3 -stats stats.txt -summary summary.csv square.g2o
lines 3 stats.txt
is "chi2= " stats.txt
expect 0 "final chi2" -i -1 -solver lm_var -robustKernel Huber -summary summary.csv square.g2o
lines 3 summary.csv
is "filename, n_vertices, n_edges, n_poses, n_landmarks, edge_types, load_chi, init_chi, final_chi, solver, robustKernel, maxIterations, realIterations" summary.csv
is "square.g2o, 5, 6, 4, 1, EDGE_SE2 EDGE_SE2_XY, 4.6827, 4.6827, 0.00189884, gn_var, , 3, 3" summary.csv
is "lm_var, Huber, -1, " summary.csv
expect 0 "final chi2" -gnudump plot square.g2o
lines 5 plot_vertices
lines 18 plot_edges
lines 6 plot_landmarks_edges
lines 9 plot_odom_edges

# -listTypes, -renameTypes, standard input (plugin_test.sh tests -typeslib and -solverlib)
for type in VERTEX_SE2 EDGE_SE2_SEGMENT2D EDGE_SE2_CALIB EDGE_SIM3:EXPMAP VERTEX_PLANE EDGE_V_V_GICP VERTEX_CAM; do expect 0 "$type" -listTypes; done
sed 's/VERTEX_XY/POINT/; s/EDGE_SE2_XY/SEEN/' square.g2o > renamed.g2o
expect 0 "final chi2 = 0.00189884" -renameTypes POINT=VERTEX_XY,SEEN=EDGE_SE2_XY renamed.g2o
expect 0 "expected old=new, got POINT" -renameTypes POINT square.g2o
expect 0 "expected a known tag after =, got NONSENSE" -renameTypes POINT=NONSENSE square.g2o
"$tool" - < square.g2o 2> err.txt || exit 1
is "final chi2 = 0.00189884" err.txt

# An interrupt signal stops the iterations, but the tool still writes its results.
interrupt() {
  "$tool" -i 1000000000 "$@" square.g2o 2> err.txt &
  program=$!
  for _ in $(seq 100); do grep -q "initial chi2" err.txt && break; sleep 0.1; done
  sleep 0.2
  kill -INT $program
  wait $program || complain "g2o $*: expected exit code 0 after the interrupt signal; standard error:" err.txt
}
interrupt -o interrupted.g2o
is "final chi2 = 0.00189884" err.txt
is "VERTEX_XY 7 " interrupted.g2o
interrupt -inc -update 1

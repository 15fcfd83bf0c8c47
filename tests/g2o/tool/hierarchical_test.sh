#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# hierarchical_test.sh TOOL WORK_DIR DATA: tests g2o_hierarchical. DATA is the folder of the public graphs; without it,
# their tests are skipped.
source "$(dirname "$0")/tool_case.sh" "$1" "$2"
data="$3"

"$tool" -help > out.txt
for name in si hi li v uThreshold hierarchicalDiameter guess debug update guiout gnudump robustKernel robustKernelWidth \
  huberWidth computeMarginals o solver hsolver solverlib typeslib listTypes listSolvers listRobustKernels renameTypes summary; do
  is "-$name " out.txt
done
expect 0 "no input"
expect 1 "parameter -hi: expected 0 or more" -hi -1 square.g2o
expect 1 "parameter -update: expected 1 or more" -update 0 square.g2o
expect 1 "unknown parameter: -i" -i 3 square.g2o
expect 1 "cannot be opened" none.g2o

# A graph whose estimates say nothing: five iterations from them do not reach the optimum, but the start of the engine does.
sed -E 's/^(VERTEX_SE2 [123]) .*/\1 5 -5 2.5/' square.g2o > far.g2o
expect 0 "final chi2 = 0.00189884" -li 0 far.g2o
is "# start of the engine: chi2 = 0.00189884" err.txt
expect 0 "final chi2 = 0.00189884" far.g2o
expect 0 "final chi2 = 0.00189884" -hi 0 -li 50 far.g2o
expect 0 "final chi2 = 0.00189884" -hi 0 -li -1 -solver gn_var far.g2o

# -li 0 -hi 0: the start is the better one of the estimates and the chordal guess, and never worse than the estimates.
expect 0 "final chi2" -hi 0 -li 0 square.g2o
holds "$(final) <= 4.6827 + 1e-9"

# The switches of the stars have no effect, and the program says so.
expect 0 "# -hsolver has no effect: there are no stars" -si 3 -hierarchicalDiameter 2 -uThreshold 1 -hsolver gn_var square.g2o
for name in si hierarchicalDiameter uThreshold; do is "# -$name has no effect" err.txt; done
expect 0 "final chi2" square.g2o
is_not "no effect" err.txt

# -debug prints the report of the engine; -v prints the iterations of -solver.
expect 0 "gradient" -debug far.g2o
expect 0 "iteration= 0" -v -li 2 far.g2o
is_not "iteration= 2" err.txt

# Fixed vertices keep their estimates; with robust kernels, the engine uses them, too.
(cat far.g2o; echo "FIX 2") > fixed.g2o
expect 0 "final chi2 = 0.00189884" -o - fixed.g2o
is "VERTEX_SE2 2 5 -5 2.5" out.txt
(cat far.g2o; echo "EDGE_SE2 0 2 9 9 0 10 0 0 10 0 40") > outlier.g2o
expect 0 "final chi2" -robustKernel Huber -robustKernelWidth 0.1 outlier.g2o
huber=$(final)
expect 0 "final chi2" -huberWidth 0.1 outlier.g2o
holds "($(final) - $huber)^2 < 1e-6 * $huber^2"
expect 0 "final chi2" outlier.g2o
holds "$(final) > 5 * $huber"

# -guess, -guiout, -update, -o, -summary, -computeMarginals, standard input
expect 0 "final chi2 = 0.00189884" -guess -guiout -update 2 -li 4 -hi 0 far.g2o
holds "$(grep -c '^plot ' out.txt) >= 1"
expect 0 "Vertices" -computeMarginals -o result.g2o -summary summary.csv far.g2o
is "VERTEX_XY 7 " result.g2o
is "lm_var_cholmod" summary.csv
"$tool" - < far.g2o 2> err.txt || exit 1
is "final chi2 = 0.00189884" err.txt

# In space, and public graphs. (The last digits of BEST are not printed.)
expect 0 "final chi2" space.g2o
optimum() {
  if [[ ! -f "$data/$1" ]]; then echo "SKIPPED: there is no $1 in BOXPLUS_DATA"; return; fi
  expect 0 "final chi2" "$data/$1"
  holds "($(final) - $2)^2 < (1e-5 * $2)^2"
}
optimum posegraph2d/M3500.g2o 137.912951
optimum posegraph3d/sphere2500.g2o 727.149412
optimum posegraph3d/torus3D.g2o 14574.7464
optimum landmark2d/victoriaPark-full.g2o 389.787423

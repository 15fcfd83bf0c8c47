#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# misuse_test.sh TOOL WORK_DIR: checks the messages and exit codes of the tool g2o for bad arguments, files and
# plug-ins.
source "$(dirname "$0")/tool_case.sh" "$1" "$2"

# arguments
expect 0 "no solver nonsense" -solver nonsense square.g2o
expect 3 "does not support vertices of these dimensions: 2 3" -solver lm_fix6_3 square.g2o
expect 1 "unknown parameter: -nonsense" -nonsense square.g2o
expect 1 "too many arguments: b.g2o" square.g2o b.g2o
expect 1 "parameter -i: expected an integer, got 'abc'" -i abc square.g2o
expect 1 "parameter -i: expected an integer, got '1.5'" -i 1.5 square.g2o
expect 1 "parameter -gain: expected a number, got 'x'" -gain x square.g2o
expect 1 "parameter -gaugeList: expected integers separated by commas, got '1,x'" -gaugeList 1,x square.g2o
expect 1 "parameter -o: expected a value, got nothing" square.g2o -o
expect 1 "parameter -typeslib: expected a value, got nothing" square.g2o -typeslib
expect 1 "parameter -gain: expected 0 or more" -gain -1 square.g2o
expect 1 "parameter -ig: expected 0 or more" -ig -1 square.g2o
expect 1 "parameter -update: expected 1 or more" -update 0 square.g2o
is_not "chi2" err.txt

# files that are not graphs
expect 1 "no_such_file.g2o cannot be opened" no_such_file.g2o
expect 1 ". cannot be opened" .
: > empty.g2o
expect 2 "empty.g2o has no vertices" empty.g2o
head -c 100000 "$tool" > binary.g2o
expect 2 "binary.g2o has no vertices" binary.g2o
is "unknown tag '\x7fELF" err.txt
is "other unknown tags" err.txt
lines 7 err.txt
if LC_ALL=C grep -q "$(printf '[\001-\010]')" err.txt; then complain "expected no control characters in:" err.txt; fi

# tags that are not UTF-8, and file names with control characters
(cat square.g2o; printf 'W\377\302\233 1\n') > bytes.g2o
expect 0 "unknown tag 'W\\xff\\xc2\\x9b'" bytes.g2o
expect 1 "g2o: no\\xff\\x1b[31m.g2o cannot be opened" "$(printf 'no\377\033[31m.g2o')"

# lines that cannot be read
# broken TEXT LINE: checks that square.g2o with an additional LINE is refused with the message TEXT.
broken() {
  (cat square.g2o; echo "$2") > broken.g2o
  expect 2 "line 12: $1" broken.g2o
  is "broken.g2o has lines that cannot be read" err.txt
}
broken "VERTEX_SE2 9: expected x (a finite number), got 'nan'" "VERTEX_SE2 9 nan 0 0"
broken "VERTEX_SE2 9: expected more fields, got the end of the line" "VERTEX_SE2 9 0 0"
broken "VERTEX_SE2: expected the end of the line, got '7'" "VERTEX_SE2 9 0 0 0 7"
broken "VERTEX_SE2 3: the id is taken" "VERTEX_SE2 3 0 0 0"
broken "VERTEX_SE2: expected the id of a vertex, got 'a'" "VERTEX_SE2 a 0 0 0"
broken "EDGE_SE2: there is no vertex 99" "EDGE_SE2 0 99 1 0 0 1 0 0 1 0 1"
broken "EDGE_SE2: expected more fields" "EDGE_SE2 0 2 1 0 0 1 0 0"
broken "EDGE_SE2_XY: the edge does not fit the graph" "EDGE_SE2_XY 0 1 1 0 1 0 1"
is "the vertices do not have the types that the edge expects" err.txt
broken "EDGE_SE2_POINTXY_OFFSET: the edge does not fit the graph" "EDGE_SE2_POINTXY_OFFSET 0 7 5 1 0 1 0 1"
is "the edge needs parameter 5" err.txt
broken "EDGE_SE2_XY: information" "EDGE_SE2_XY 0 7 1 0 1 2 1"
broken "FIX: there is no vertex 99" "FIX 99"
(cat square.g2o; echo "NONSENSE 1 2 3") > unknown.g2o
expect 0 "line 12: unknown tag 'NONSENSE', 1 line is skipped" unknown.g2o
is "final chi2 = 0.00189884" err.txt
(echo "PARAMS_SE3OFFSET 5 0 0 0 0 0 0 1"; cat square.g2o; echo "EDGE_SE2_POINTXY_OFFSET 0 7 5 1 0 1 0 1") > parameter.g2o
expect 2 "parameter 5 does not have the type" parameter.g2o

# graphs that cannot be optimized are written unchanged
(cat square.g2o; echo "FIX 0 1 2 3 7") > fixed.g2o
expect 0 "nothing to optimize" -o written.g2o -gnudump fixed -summary fixed.csv -stats fixed.txt -computeMarginals fixed.g2o
"$tool" -i 0 -o - written.g2o 2> /dev/null | diff -q written.g2o - > /dev/null || complain "expected the same graph after reading and writing:" written.g2o
is "FIX 7" written.g2o
lines 5 fixed_vertices
lines 18 fixed_edges
is "fixed.g2o, 5, 6, 4, 1, EDGE_SE2 EDGE_SE2_XY, 4.6827, 4.6827, 4.6827" fixed.csv
lines 0 fixed.txt
grep VERTEX square.g2o > vertices.g2o
expect 0 "nothing to optimize" -o - vertices.g2o
lines 6 out.txt  # five vertices and a FIX line

# systems that cannot be solved
sed -E 's/ 10 0 0 10 0 40$/ 0 0 0 0 0 0/; s/ 20 0 20$/ 0 0 0/' square.g2o > weightless.g2o
(cat poses.g2o; printf 'VERTEX_XY 7 0.4 0.4\nEDGE_BEARING_SE2_XY 0 7 0.5 1\n') > singular.g2o
for solver in gn_var gn_dense gn_pcg gn_var_cholmod gn_var_csparse gn_var_suitesparse_cholmod gn_var_suitesparse_csparse; do
  if ! "$tool" -listSolvers 2>&1 | grep -q "^$solver "; then continue; fi  # the build does not have this solver
  for graph in weightless.g2o singular.g2o; do
    expect 0 "positive definite" -solver $solver -o unsolved.g2o $graph
    is "the algorithm failed" err.txt
    is "VERTEX_XY 7 0.4 0.4" unsolved.g2o
  done
done
expect 0 "final chi2" -solver lm_var singular.g2o
is_not "failed" err.txt
(cat square.g2o; printf 'VERTEX_XY 8 1 1\nEDGE_POINTXY 7 8 1 0 1 0 1\n') > landmarks.g2o
expect 0 "an edge joins them" -solver gn_fix3_2 landmarks.g2o
is "the algorithm failed" err.txt
(cat square.g2o; printf 'PARAMS_SE3OFFSET 0 0 0 0 0 0 0 1\nVERTEX_TRACKXYZ 8 1 1 1\n') > mixed.g2o
expect 0 "final chi2 = 0.00189884" mixed.g2o

# files that cannot be written: the tool reports each of them and writes the other files
expect 1 "/no/such/folder/x cannot be written" -o /no/such/folder/x -stats written.txt square.g2o
lines 5 written.txt
for switch in -stats -gnudump -summary; do
  rm -f written.g2o
  expect 1 "/no/such/folder/x cannot be written" $switch /no/such/folder/x -o written.g2o square.g2o
  is "VERTEX_XY 7 " written.g2o
done
if [[ -e /dev/full ]]; then
  for switch in -o -stats -summary; do expect 1 "/dev/full cannot be written" $switch /dev/full square.g2o; done
  if "$tool" -o - square.g2o > /dev/full 2> err.txt; then complain "expected exit code 1:" err.txt; fi
  is "cannot be written to standard output" err.txt
fi
[[ ! -e debug.txt ]] || complain "expected that the tool does not write debug.txt:" debug.txt

# files that are not plug-ins: the tool reports them and continues
expect 0 "no_such_types_x.so cannot be loaded" -typeslib no_such_types_x.so square.g2o
expect 0 "no_such_solver_x.so cannot be loaded" -solverlib no_such_solver_x.so square.g2o
mkdir plugins
for name in libtext_types_x.so libtext_solver_x.so libtext_types_x.txt; do echo "this is text" > plugins/$name; done
export G2O_TYPES_DIR="$PWD/no_such_folder:$PWD/plugins" G2O_SOLVERS_DIR="$PWD/plugins"
expect 0 "plugins/libtext_types_x.so cannot be loaded" square.g2o
is "plugins/libtext_solver_x.so cannot be loaded" err.txt
is_not "x.txt" err.txt
is "final chi2 = 0.00189884" err.txt
is "G2O_TYPES_DIR: there is no folder $PWD/no_such_folder" err.txt
G2O_SOLVER_DIR="$PWD" expect 0 "final chi2" square.g2o  # the name of the variable in the g2o document
is "libtext_solver_x.so" err.txt

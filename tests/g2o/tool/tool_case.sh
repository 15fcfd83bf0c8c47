# SPDX-License-Identifier: BSD-3-Clause
# Common functions for the tests of the tool g2o. Usage: source tool_case.sh TOOL WORK_DIR. Empties WORK_DIR, makes it
# the current folder, and writes square.g2o, poses.g2o (which is square.g2o without its landmark) and space.g2o to it.
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
grep -v XY square.g2o > poses.g2o
cat > space.g2o <<END
PARAMS_SE3OFFSET 0 0 0 0 0 0 0 1
VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1
VERTEX_SE3:QUAT 1 1.1 0.05 -0.1 0 0 0.1 0.99498744
VERTEX_SE3:QUAT 2 1.9 0.1 0.1 0.05 0 0 0.99874922
VERTEX_TRACKXYZ 10 1 1.9 0.9
VERTEX_TRACKXYZ 11 2.1 1 -1
VERTEX_TRACKXYZ 12 0.1 -1 1
EDGE_SE3:QUAT 0 1 1 0 0 0 0 0 1 10 0 0 0 0 0 10 0 0 0 0 10 0 0 0 40 0 0 40 0 40
EDGE_SE3:QUAT 1 2 1 0.02 0 0 0 0.01 0.99995 10 0 0 0 0 0 10 0 0 0 0 10 0 0 0 40 0 0 40 0 40
EDGE_SE3_TRACKXYZ 0 10 0 1 2 1.01 20 0 0 20 0 20
EDGE_SE3_TRACKXYZ 1 10 0 0 2 1 20 0 0 20 0 20
EDGE_SE3_TRACKXYZ 1 11 0 1 1 -1 20 0 0 20 0 20
EDGE_SE3_TRACKXYZ 2 11 0 0 1 -1.02 20 0 0 20 0 20
EDGE_SE3_TRACKXYZ 0 12 0 0 -1 1 20 0 0 20 0 20
EDGE_SE3_TRACKXYZ 2 12 0 -2 -1.01 1 20 0 0 20 0 20
END

# complain MESSAGE FILE: prints the message and the content of the file, and ends the test.
complain() {
  echo "$(basename "$0"): $1" >&2
  cat -v "$2" >&2
  exit 1
}
# expect CODE TEXT ARGUMENT...: checks that the tool exits with CODE and prints TEXT to standard error.
expect() {
  local code="$1" text="$2"
  shift 2
  timeout 100 "$tool" "$@" > out.txt 2> err.txt
  local ended=$?
  if [[ $ended != "$code" ]] || ! grep -qF -e "$text" err.txt; then
    complain "g2o $*: expected exit code $code and the message '$text'; got exit code $ended and:" err.txt
  fi
}
# is TEXT FILE: checks that FILE contains TEXT.
# is_not TEXT FILE: checks that FILE does not contain TEXT.
# lines COUNT FILE: checks that FILE has COUNT lines.
is() { grep -qF -e "$1" "$2" || complain "expected '$1' in $2:" "$2"; }
is_not() { if grep -qF -e "$1" "$2"; then complain "expected that '$1' is not in $2:" "$2"; fi; }
lines() { (($(wc -l < "$2") == $1)) || complain "expected $1 lines in $2:" "$2"; }
# holds CONDITION: checks a numeric condition in awk's syntax.
holds() { awk "BEGIN { exit !($1) }" || complain "expected $1; standard error of the last run:" err.txt; }
# initial, final: print the initial and the final chi2 of the last run.
initial() { sed -n 's/^# initial chi2 = //p' err.txt; }
final() { sed -n 's/^# final chi2 = //p' err.txt; }

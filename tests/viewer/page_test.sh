#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# page_test.sh PAGE BOXPLUS DATA: tests the viewer's page in a browser. Exit code 77 means that the tests are skipped, because a
# tool or the first data set is missing.
set -euo pipefail
command -v node >/dev/null || { echo "skipped: node is missing (scripts/page_tools.sh installs it)"; exit 77; }

is_first=1
failed=()
for test in "$1"/test/view_*.mjs; do
  name="$(basename "$test")"
  echo "== $name"
  code=0
  node "$test" "$2" "$3" || code=$?
  if ((code == 77)) && ((is_first)); then exit 77; fi
  if ((code != 0 && code != 77)); then failed+=("$name"); fi
  is_first=0
done
if ((${#failed[@]})); then
  echo "failed: ${failed[*]}" >&2
  exit 1
fi

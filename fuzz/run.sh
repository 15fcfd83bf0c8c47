#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# run.sh SECONDS: runs each fuzz target in build/sanitize for this many seconds. A run starts with the inputs in
# fuzz/regressions, the seeds, and the inputs that earlier runs saved in build/sanitize/corpus. If an input fails, the
# run stops and saves the input in build/sanitize/findings. After you fix the bug, move the input to fuzz/regressions.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=build/sanitize
for dictionary in fuzz/*.dict; do
  format=$(basename "$dictionary" .dict)
  mkdir -p "$build/corpus/$format" "$build/findings"
  cat "$dictionary" "$build/fuzz/seeds/$format.dict" >"$build/$format.dict"
  log="$build/$format.log"
  if ! "$build/bin/fuzz_$format" "$build/corpus/$format" "$build/fuzz/seeds/$format" fuzz/regressions \
    -max_total_time="$1" -max_len=2048 -timeout=10 -rss_limit_mb=2048 -dict="$build/$format.dict" \
    -artifact_prefix="$build/findings/$format-" -print_final_stats=1 >"$log" 2>&1; then
    tail -n 60 "$log"
    exit 1
  fi
  echo "fuzz_$format: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") inputs in $1 s, no findings"
done

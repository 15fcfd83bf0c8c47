#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# sanitize_changes.sh [COMMIT]: builds the core suites that the changes since COMMIT (by default that of base_commit.sh)
# may have touched, with the sanitizers of `make sanitize`, and runs them. JOBS is the number of parallel jobs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

since=$(scripts/base_commit.sh "$@")
read -ra suites <<<"$(scripts/changed_suites.py "$since")"
cmake --preset sanitize
if ((${#suites[@]} == 0)); then
  echo "sanitize: no core suite depends on what changed since ${since:0:7}"
  exit 0
fi
echo "sanitize: ${suites[*]}, because of the changes since ${since:0:7}"
cmake --build --preset sanitize --parallel "${JOBS:-$(nproc)}" --target "${suites[@]/%/_test}"
ctest --preset sanitize-core --parallel "${JOBS:-$(nproc)}" -L "^($(IFS='|'; echo "${suites[*]}"))_test\$"

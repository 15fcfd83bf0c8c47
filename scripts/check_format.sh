#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fails if clang-format would change a C++ file. Checks all C++ files except those that git ignores. With
# --fix, formats the files instead.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mode=(--dry-run -Werror)
if [[ "${1:-}" == --fix ]]; then mode=(-i); fi
git ls-files -z --cached --others --exclude-standard -- '*.h' '*.hpp' '*.cpp' '*.cc' |
  while IFS= read -r -d '' file; do if [[ -f "$file" ]]; then printf '%s\0' "$file"; fi; done |
  xargs -0 --no-run-if-empty clang-format "${mode[@]}"

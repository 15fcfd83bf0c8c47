#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# tidy_changes.sh [COMMIT]: runs clang-tidy on the sources that changed since COMMIT, with the compile
# commands of build/sanitize (run `make sanitize` first). By default, COMMIT is the commit at which this
# branch left the main branch or, on the main branch, the previous commit. A changed header is checked through
# the source of the same name.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=build/sanitize
[[ -f $build/compile_commands.json ]] || { echo "tidy_changes.sh: there is no $build; run make sanitize first" >&2; exit 1; }
since=${1:-$(git merge-base HEAD origin/main 2>/dev/null || git rev-parse HEAD)}
[[ $(git rev-parse "$since") != $(git rev-parse HEAD) ]] || since=$(git rev-parse --verify --quiet HEAD^ || git rev-parse HEAD)

# The sources that changed, and the sources of the headers that changed.
sources=$(git diff --name-only --diff-filter=d "$since" -- '*.h' '*.cpp' | sed 's/[.]h$/.cpp/; s:^include/boxplus/:src/:' | sort -u)
compiled=$(grep -o '"file": "[^"]*"' "$build/compile_commands.json" | cut -d'"' -f4 | sort -u)
checked=$(comm -12 <(sed "s:^:$PWD/:" <<<"$sources" | sort) <(echo "$compiled"))
[[ -n $checked ]] || { echo "clang-tidy: no source changed since ${since:0:7}"; exit 0; }
xargs --max-args=1 --max-procs="$(nproc)" clang-tidy -p "$build" --quiet <<<"$checked" 2> >(grep -v 'warnings\? generated' >&2)
echo "clang-tidy: $(wc -l <<<"$checked") sources that changed since ${since:0:7}, no findings"

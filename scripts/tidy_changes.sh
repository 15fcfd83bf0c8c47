#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# tidy_changes.sh [COMMIT]: runs clang-tidy on the sources whose code changed since COMMIT, with the compile
# commands of build/sanitize (run `make sanitize` first). By default, COMMIT is that of base_commit.sh. The newest
# changes come first, and at most TIDY_SOURCES (16) sources are checked; `make tidy` checks every source.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=build/sanitize
[[ -f $build/compile_commands.json ]] || { echo "tidy_changes.sh: there is no $build; run make sanitize first" >&2; exit 1; }
since=$(scripts/base_commit.sh "$@")

# C++ files with a changed line that is not just a comment, those of the newest commits first.
changed_files() {
  local code='^ *([^ /]|/[^/])'
  git diff --name-only --diff-filter=d -G"$code" HEAD -- '*.h' '*.cpp'
  git log --format= --name-only --diff-filter=d -G"$code" "$since..HEAD" -- '*.h' '*.cpp'
}

# The source through which a file is checked: itself, the source of the same name, or one that includes it.
source_of() {
  local source
  source=$(sed 's/[.]h$/.cpp/; s:^include/boxplus/:src/:' <<<"$1")
  if [[ -f $source ]]; then
    echo "$source"
  else
    git grep -l "#include [\"<]${1#*include/}[\">]" -- '*.cpp' | head -1
  fi
}

compiled=$(grep -o '"file": "[^"]*"' "$build/compile_commands.json" | cut -d'"' -f4)
checked=$(changed_files | awk '!seen[$0]++' | while read -r file; do source_of "$file"; done | awk '!seen[$0]++' | sed "s:^:$PWD/:" |
  grep -Fxf <(echo "$compiled") | head -"${TIDY_SOURCES:-16}" || true)
[[ -n $checked ]] || { echo "clang-tidy: no code changed since ${since:0:7}"; exit 0; }
# The compile commands name precompiled headers, also those of programs that `make sanitize` does not build.
headers=$(grep -Ff <(sed 's:.*:"file"\: "&":' <<<"$checked") -B1 "$build/compile_commands.json" |
  grep -o '[^ ]*/cmake_pch[.]hxx[.]pch' | sort -u | sed "s:^$PWD/$build/::" || true)
[[ -z $headers ]] || xargs ninja -C "$build" <<<"$headers" >/dev/null
xargs --max-args=1 --max-procs="$(nproc)" clang-tidy -p "$build" --quiet <<<"$checked" 2> >(grep -v 'warnings\? generated' >&2)
echo "clang-tidy: no findings in $(wc -l <<<"$checked") sources that changed since ${since:0:7}"

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# base_commit.sh [COMMIT]: prints the commit since which changes are checked: COMMIT, or by default the commit at which
# this branch left the main branch. On the main branch, it is the last commit that is over a day old.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

head=$(git rev-parse HEAD)
since=${1:-$(git merge-base HEAD origin/main 2>/dev/null || echo "$head")}
[[ $(git rev-parse "$since") != "$head" ]] || since=$(git rev-list -1 --before='1 day ago' HEAD)
[[ -n $since ]] || since=$(git rev-list --max-parents=0 HEAD | tail -1)
echo "$since"

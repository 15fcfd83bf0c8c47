#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what building and testing the viewer's page needs: node, npm and chromium, if their commands are missing, and the
# packages of viewer/page. If nothing is missing, does nothing and prints nothing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

list="$(mktemp)"
trap 'rm -f "$list"' EXIT
command -v node >/dev/null || echo nodejs >>"$list"
command -v npm >/dev/null || echo npm >>"$list"
command -v chromium >/dev/null || echo chromium >>"$list"
if [[ -s "$list" ]]; then scripts/install_dependencies.sh "$list"; fi

if ! command -v npm >/dev/null; then
  echo "boxplus: npm is missing; install node (version 18 or later) and npm" >&2
  exit 1
fi
if (($(node -p 'parseInt(process.versions.node)') < 18)); then
  echo "boxplus: node is version $(node --version); the viewer's page needs 18 or later" >&2
  exit 1
fi

cd viewer/page
installed=node_modules/.package-lock.json
if [[ ! -e "$installed" || "$installed" -ot package-lock.json ]]; then
  echo "boxplus: installing the packages of viewer/page"
  npm ci --silent --no-audit --no-fund
fi

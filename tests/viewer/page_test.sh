#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# page_test.sh PAGE BOXPLUS DATA: tests the viewer's page in a browser. Exit code 77 means that the test is skipped.
set -euo pipefail
command -v node >/dev/null || { echo "skipped: node is missing (scripts/page_tools.sh installs it)"; exit 77; }
exec node "$1/test/view_intel.mjs" "$2" "$3"

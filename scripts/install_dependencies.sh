#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the packages of a list that are missing. If no package is missing, does nothing and prints nothing.
#
#     install_dependencies.sh [LIST]      the default for LIST is debian-packages.txt
set -euo pipefail

list="${1:-$(dirname "${BASH_SOURCE[0]}")/debian-packages.txt}"

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  echo "boxplus: not a Debian system, so nothing is installed; $list lists the packages that boxplus needs" >&2
  exit 0
fi

mapfile -t wanted < <(sed -e 's/#.*//' -e 's/[[:space:]]*$//' -e '/^$/d' "$list")
# A name may have an architecture, as libfmt-dev:arm64. Otherwise, it means that of this machine.
native="$(dpkg --print-architecture)"
installed="$(dpkg-query --show --showformat '${db:Status-Status} ${Package}:${Architecture}\n' "${wanted[@]}" 2>/dev/null |
  sed -n 's/^installed //p' | sed -E "p; s/:($native|all)$//" || true)"
mapfile -t missing < <(comm -23 <(printf '%s\n' "${wanted[@]}" | sort) <(sort -u <<<"$installed"))
((${#missing[@]})) || exit 0
mapfile -t architectures < <(printf '%s\n' "${missing[@]}" | sed -n 's/.*://p' | sort -u |
  comm -23 - <({ echo "$native"; dpkg --print-foreign-architectures; } | sort))

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    {
      echo "boxplus: these packages are missing, and only root can install them:"
      for architecture in "${architectures[@]}"; do echo "    dpkg --add-architecture $architecture && apt-get update"; done
      echo "    apt-get install --no-install-recommends ${missing[*]}"
      echo "Run that line as root, or install sudo, then repeat the command."
    } >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "boxplus: installing ${missing[*]}"
for architecture in "${architectures[@]}"; do "${as_root[@]}" dpkg --add-architecture "$architecture"; done
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "${missing[@]}"

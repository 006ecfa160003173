#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# Installs the wheel beside this file in the system where it runs, as root, which has no compiler, and uses it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
export DEBIAN_FRONTEND=noninteractive
apt-get -q -y --no-install-recommends install python3-venv python3-numpy >apt.log 2>&1 || { cat apt.log && false; }
for tool in cc c++ gcc g++ clang cmake; do
  ! command -v "$tool" || { echo "this system has a compiler" && false; }
done
./try_wheel.sh ./hardball-*.whl

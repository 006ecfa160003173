#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# Builds, runs and installs the program as README.md and docs/install.md say, in the system where this runs, as root, from
# the clone hardball beside this file, and compares the golden hashes. Leaves a wheel in /root/kept, where what was
# compiled is kept, too.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
export CCACHE_DIR=/root/kept/cache
DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install git >apt.log 2>&1 || { cat apt.log && false; }
cd hardball
./dev demo
test -s build/demo/report.html
cmake --preset release -DHARDBALL_TESTS=OFF -DHARDBALL_EXAMPLES=OFF -DHARDBALL_GOLDEN=ON
cmake --build --preset release --target golden_hashes
ctest --test-dir build/release -L golden --no-tests=error --output-on-failure
./dev install /usr/local
/usr/local/bin/hardball --version
/usr/local/bin/hardball verify scenarios/newtons_cradle.toml
./dev wheel
cp build/wheel/*.whl /root/kept

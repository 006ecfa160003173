#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# try_wheel.sh WHEEL [PYTHON]: installs a wheel into an empty environment that has NumPy and nothing else, and uses all
# that is in it.
set -euo pipefail
wheel=$(realpath "$1")
python=${2:-/usr/bin/python3}
tests=$(dirname "$(realpath "${BASH_SOURCE[0]}")")

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
"$python" -m venv empty
# NumPy is what Debian has, and the only package of its folder that is seen.
packages=$("$python" -c 'import numpy, pathlib; print(pathlib.Path(numpy.__file__).parents[1])')
mkdir numpy_alone
ln -s "$packages"/numpy "$packages"/numpy-*info "$packages"/numpy.libs numpy_alone 2>/dev/null || true
echo "$PWD/numpy_alone" >"$(echo empty/lib/python*/site-packages)/numpy_alone.pth"
# With no index, a package that it needs beside NumPy is an error.
empty/bin/pip -q --disable-pip-version-check install --no-index "$wheel"
env -i HOME="$scratch" TMPDIR="$scratch" LC_ALL=C.UTF-8 PATH="$scratch/empty/bin:/usr/bin:/bin" python -B "$tests/use_wheel.py"

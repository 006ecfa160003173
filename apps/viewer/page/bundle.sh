#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# bundle.sh FOLDER: bundles src/ and the packages of the lock file, which npm fetches from the network, into FOLDER/dist.
# Neither they nor the bundle appear in the source tree.
set -euo pipefail
page=$(dirname "$(realpath "$0")")
mkdir -p "$1"
cd "$1"
rm -rf src dist
cp -r "$page"/{src,build.mjs,package.json,package-lock.json} .
npm ci --no-audit --no-fund --loglevel=error
npm run --silent build

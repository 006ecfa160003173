#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# build.sh MODULE SCRATCH FOLDER: makes the playground in FOLDER, from the module of WebAssembly in the folder MODULE and the
# packages of the lock file, which npm fetches from the network into SCRATCH. Nothing appears in the source tree.
set -euo pipefail
playground=$(dirname "$(realpath "$0")")
project=$(dirname "$playground")
module=$(realpath "$1")
mkdir -p "$2" "$3"
scratch=$(realpath "$2")
folder=$(realpath "$3")
cd "$scratch"
rm -rf src package
cp -r "$playground"/{src,build.mjs,package.json,package-lock.json} .
cp -r "$project/wasm/package" package
cp "$module/module.js" "$module/module.wasm" package/
if ! cmp --silent package-lock.json node_modules/.lock; then
  npm ci --no-audit --no-fund --loglevel=error
  cp package-lock.json node_modules/.lock
fi
node build.mjs "$project" "$folder"

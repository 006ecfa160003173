#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# build_container.sh: builds the container of Containerfile from a clone, by buildah, and runs program and Python package
# in it. Bare systems made by mmdebstrap take the place of the images that it begins with, which may be out of reach. Exit
# status: 77 if no container can be built here.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
images() {
  buildah --root "$scratch/images" --runroot "$scratch/run" --storage-driver vfs "$@"
}

{
  mmdebstrap --variant=minbase --dpkgopt=force-unsafe-io bookworm "$scratch/debian.tar"
  base=$(images from scratch)
  images add -q "$base" "$scratch/debian.tar" / >/dev/null
  images commit -q "$base" docker.io/library/debian:12
  images tag docker.io/library/debian:12 docker.io/library/debian:12-slim
} || exit 77

git clone -q . "$scratch/source"
# It takes half an hour without the cache of compilers.
cache=()
if command -v ccache >/dev/null; then
  cache=(--volume "$(ccache --get-config cache_dir):/root/.cache/ccache")
fi
images build "${cache[@]}" --pull-never --isolation chroot --layers=false --tag hardball "$scratch/source"
container=$(images from --pull-never localhost/hardball)
in_container() {
  images run --isolation chroot "$container" -- "$@"
}
in_container hardball --version
in_container python3 -c "import hardball; print(hardball.check(hardball.scenarios() / 'paper.toml'))"
[[ $(images inspect --format '{{.OCIv1.Config.Entrypoint}}' "$container") == "[hardball]" ]]

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# in_bare_system.sh PACKAGE: makes a bare system of this machine's release, tests the package in it with use.sh, and
# removes it. Needs mmdebstrap and a mirror of Debian. Exit status: 77 if no such system can be made here.
set -euo pipefail
tests=$(dirname "$(dirname "$(realpath "${BASH_SOURCE[0]}")")")
. /etc/os-release
components=main
[[ $ID != ubuntu ]] || components=main,universe

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
chmod 755 "$scratch"
mkdir "$scratch/package"
cp -r "$1" "$tests/package/use.sh" "$tests/structure/consumer" "$tests/../examples/game_loop.c" \
  "$tests/../examples/expected/game_loop.txt" "$scratch/package"

# Nothing of this machine's environment may help. What is written need not survive a crash.
status=0
mmdebstrap --variant=minbase --components="$components" \
  --aptopt='Acquire::Retries "3"' --dpkgopt=force-unsafe-io \
  --customize-hook="copy-in $scratch/package /root" \
  --customize-hook="touch $scratch/made" \
  --customize-hook='chroot "$1" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin bash /root/package/use.sh' \
  "$VERSION_CODENAME" /dev/null || status=$?
[[ $status == 0 || -e $scratch/made ]] || exit 77
exit $status

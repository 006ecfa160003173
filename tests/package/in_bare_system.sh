#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# in_bare_system.sh SCRIPT FILE...: makes a bare system of this machine's release, or of the one that RELEASE names, runs
# the script in it, beside which the files are, and removes the system. Needs mmdebstrap and a mirror of Debian. Exit
# status: 77 if no such system can be made here.
set -euo pipefail
. /etc/os-release
components=main
[[ $ID != ubuntu ]] || components=main,universe

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
chmod 755 "$scratch"
mkdir "$scratch/package"
cp -r "$@" "$scratch/package"
script=/root/package/$(basename "$1")

# Nothing of this machine's environment may help. What is written need not survive a crash.
status=0
mmdebstrap --variant=minbase --components="$components" \
  --aptopt='Acquire::Retries "3"' --dpkgopt=force-unsafe-io \
  --customize-hook="copy-in $scratch/package /root" \
  --customize-hook="touch $scratch/made" \
  --customize-hook="chroot \"\$1\" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin bash $script" \
  "${RELEASE:-$VERSION_CODENAME}" /dev/null || status=$?
[[ $status == 0 || -e $scratch/made ]] || exit 77
exit $status

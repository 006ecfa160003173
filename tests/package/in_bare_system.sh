#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# in_bare_system.sh SCRIPT FILE...: makes a bare system of this machine's release, or of the one of Debian or Ubuntu that
# RELEASE names, runs the script in it, beside which the files are, and removes the system. What the script leaves in
# /root/kept is copied into the folder that KEPT names, and is there again the next time. Needs mmdebstrap and a mirror of
# the release. Exit status: 77 if no such system can be made here.
set -euo pipefail
. /etc/os-release
release=${RELEASE:-$VERSION_CODENAME}
options=(--components=main)
if grep -q ",$release," /usr/share/distro-info/ubuntu.csv; then
  options=(--components=main,universe)
  # Debian has no package with the keys of Ubuntu. The system runs nothing but our files, and is thrown away.
  if [[ ! -e /usr/share/keyrings/ubuntu-archive-keyring.gpg ]]; then
    options+=(--aptopt='Acquire::AllowInsecureRepositories "true"' --aptopt='APT::Get::AllowUnauthenticated "true"')
  fi
fi
kept=()
if [[ -n ${KEPT:-} ]]; then
  mkdir -p "$KEPT"
  options+=(--customize-hook="mkdir \"\$1/root/kept\"" --customize-hook="sync-in $KEPT /root/kept")
  kept=(--customize-hook="sync-out /root/kept $KEPT")
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
chmod 755 "$scratch"
mkdir "$scratch/package"
cp -r "$@" "$scratch/package"
script=/root/package/$(basename "$1")

# Nothing of this machine's environment may help. What is written need not survive a crash.
made=0
mmdebstrap --variant=minbase --include=apt "${options[@]}" \
  --aptopt='Acquire::Retries "3"' --dpkgopt=force-unsafe-io \
  --customize-hook="copy-in $scratch/package /root" \
  --customize-hook="status=0; chroot \"\$1\" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin bash $script || status=\$?
    echo \$status >$scratch/status" \
  "${kept[@]}" "$release" /dev/null || made=$?
[[ -e $scratch/status ]] || exit 77
[[ $(<"$scratch/status") == 0 ]] || exit 1
exit $made

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# fetch_sources.sh FOLDER: unpacks the sources of the libraries that a wheel contains, which are those of the Debian or
# Ubuntu of this machine, into FOLDER/zstd and FOLDER/cpp-httplib. Settings and packages of the machine stay as they are.
set -euo pipefail
mkdir -p "$1/lists"
cd "$1"
# The archives of sources beside those of packages that the machine uses.
apt-get indextargets --format 'deb-src $(SITE) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' >sources.list
apt-get indextargets --format 'deb-src $(SITE) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Ubuntu' >>sources.list
options=(-q -o "Dir::Etc::SourceList=$PWD/sources.list" -o Dir::Etc::SourceParts=/dev/null -o "Dir::State::Lists=$PWD/lists"
  -o "Dir::Cache=$PWD/lists" -o APT::Sandbox::User=root)
apt-get "${options[@]}" update >&2
for package in libzstd cpp-httplib; do
  folder=${package#lib}
  rm -rf "$folder" ./"${package}"_*
  apt-get "${options[@]}" source --download-only "$package" >&2
  dpkg-source --no-check --extract "${package}"_*.dsc "$folder" >&2
done
rm -rf lists

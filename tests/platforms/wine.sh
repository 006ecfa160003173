#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# usage: wine.sh PROGRAM.exe [ARGUMENT...]: runs a program of Windows, with a Windows of its own in build/platforms/wine.
folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/build/platforms/wine
mkdir -p "$folder"
export WINEPREFIX=$folder WINEDEBUG=${WINEDEBUG:--all}
exec /usr/lib/wine/wine64 "$@"

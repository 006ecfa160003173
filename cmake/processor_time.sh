#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# processor_time.sh FILE COMMAND...: runs a command, such as that of a compiler, and appends a line to FILE: its processor
# time in seconds, in user and in system mode, and what it makes, the argument after -o.
set -u
file=$1
shift
made="" previous=""
for argument in "$@"; do
  [[ $previous != -o ]] || made=$argument
  previous=$argument
done
TIMEFORMAT="%3U %3S ${made//%/%%}"
{ time "$@" 2>&3 3>&-; } 3>&2 2>>"$file"

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# bundle_test.sh PAGE_FOLDER SCRATCH_FOLDER: the bundle in the repository is what its sources give.
set -euo pipefail
"$1/bundle.sh" "$2"
if ! diff -rq "$1/dist" "$2/dist"; then
  echo "apps/viewer/page/dist is not what its sources give: run ./dev page, and commit the result"
  exit 1
fi

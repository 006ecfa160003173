# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The address of the project, which a release sets in CMakeLists.txt, and pages that name it."""

import re
from pathlib import Path

ADDRESS = re.search(r'HOMEPAGE_URL "([^"]*)"', (Path(__file__).parents[2] / "CMakeLists.txt").read_text())[1]


def with_address(text, address=ADDRESS):
    """The text of a page with the address in place of the word ADDRESS; unchanged if there is no address yet."""
    return re.sub(r"\bADDRESS\b", lambda _: address, text) if address else text

# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""`python -m hardball` runs the program that was installed with this package."""

import os
import sys
from pathlib import Path


def program() -> Path:
    """The program of this package, in the bin folder of the prefix that the package is in. Exits with the remedy if
    there is none."""
    package = Path(__file__).absolute().parent
    # At most lib/pythonX.Y/site-packages is in between.
    for folder in list(package.parents)[:4]:
        path = folder / "bin" / "hardball"
        if path.is_file() and folder != Path(folder.root):
            return path
    sys.exit(
        f"the program hardball was not installed with the package in {package}: install the package with pip, which "
        "brings both, or build the program with './dev build'"
    )


if __name__ == "__main__":
    found = str(program())
    os.execv(found, [found, *sys.argv[1:]])

# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""`python -m hardball` runs the program that was installed with this package."""

import os
import sys
import sysconfig
from pathlib import Path


def program() -> Path:
    """The program of this package: in the bin folder of the prefix that the package is in, or where this Python has
    its scripts. Exits with the remedy if there is none."""
    package = Path(__file__).absolute().parent
    # At most lib/pythonX.Y/site-packages is in between.
    folders = [folder / "bin" for folder in list(package.parents)[:4]]
    for folder in [*folders, Path(sysconfig.get_path("scripts"))]:
        if (folder / "hardball").is_file():
            return folder / "hardball"
    sys.exit(
        f"the program hardball was not installed with the package in {package}: install the package with pip, which "
        "brings both, or build the program with './dev build'"
    )


if __name__ == "__main__":
    path = program()
    os.execv(path, [str(path), *sys.argv[1:]])

# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""What the package needs to be imported."""

import importlib
import sys


def require() -> None:
    """Error (ImportError), with the remedy: NumPy is missing, or the part in C++ is not for this Python."""
    try:
        importlib.import_module("numpy")
    except ImportError as error:
        raise ImportError(
            f"hardball needs NumPy, and {sys.executable} does not have it: install it with "
            f"'{sys.executable} -m pip install numpy', or on Debian 'apt-get install python3-numpy' for /usr/bin/python3"
        ) from error
    try:
        importlib.import_module("hardball._hardball")
    except ModuleNotFoundError as error:
        if error.name != "hardball._hardball":
            raise
        version = f"{sys.version_info.major}.{sys.version_info.minor}"
        raise ImportError(
            f"the part of hardball in C++ is not built for {sys.executable}, which is Python {version}: use the Python "
            "for which the package was built, that of the system for './dev python', or install the package for this one"
        ) from error

# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Builds the part of the Python package that is written in C++ with CMake; pyproject.toml says the rest."""

import os
import re
import shutil
import subprocess
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


class BuildWithCMake(build_ext):
    def build_extension(self, extension):
        folder = Path(self.get_ext_fullpath(extension.name)).resolve().parents[1]
        build = Path(self.build_temp).resolve()
        options = ["-G", "Ninja"] if shutil.which("ninja") else []
        options += ["-DCMAKE_BUILD_TYPE=Release", "-DHARDBALL_PYTHON_PACKAGE=ON", f"-DHARDBALL_PYTHON_FOLDER={folder}"]
        options += [f"-DHARDBALL_{part}=OFF" for part in ("APPS", "C", "EXAMPLES", "TESTS", "INSTALL", "PYTHON_LINKS")]
        subprocess.run(["cmake", "-S", ROOT, "-B", build, *options], check=True)
        subprocess.run(
            ["cmake", "--build", build, "--target", "hardball_python", "--parallel", str(os.cpu_count() or 1)],
            check=True,
        )


address = re.search(r'HOMEPAGE_URL "([^"]*)"', (ROOT / "CMakeLists.txt").read_text())[1]
version = ".".join(re.findall(r"#define HARDBALL_VERSION_\w+ (\d+)", (ROOT / "hardball/errors/version.hpp").read_text()))
setup(
    version=version,
    project_urls={"Homepage": address} if address else {},
    ext_modules=[Extension("hardball._hardball", [])],
    cmdclass={"build_ext": BuildWithCMake},
)

# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Builds the parts of the Python package that are written in C++ with CMake; pyproject.toml says the rest.

The environment variable CMAKE_ARGS has further options for CMake; docs/install.md has those of wheels."""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.install_scripts import install_scripts
from setuptools.command.sdist import sdist

ROOT = Path(__file__).resolve().parent


def pybind11_options():
    """Where pybind11 is a Python package, CMake does not find it by itself."""
    try:
        import pybind11
    except ImportError:
        return []
    return [f"-Dpybind11_DIR={pybind11.get_cmake_dir()}"]


class BuildWithCMake(build_ext):
    """Builds module and program, and puts the scenarios beside the module."""

    def build_extension(self, extension):
        folder = Path(self.get_ext_fullpath(extension.name)).resolve().parents[1]
        build = Path(self.build_temp).resolve()
        options = ["-G", "Ninja"] if shutil.which("ninja") else []
        options += ["-DCMAKE_BUILD_TYPE=Release", "-DHARDBALL_PYTHON_PACKAGE=ON", f"-DHARDBALL_PYTHON_FOLDER={folder}"]
        options += [f"-DHARDBALL_PYTHON={sys.executable}", *pybind11_options()]
        options += [f"-DHARDBALL_{part}=OFF" for part in ("C", "EXAMPLES", "TESTS", "INSTALL", "PYTHON_LINKS")]
        options += shlex.split(os.environ.get("CMAKE_ARGS", ""))
        subprocess.run(["cmake", "-S", ROOT, "-B", build, *options], check=True)
        targets = ["--target", "hardball_python", "hardball_program"]
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", build, *targets, "--parallel", jobs], check=True)
        shutil.copytree(ROOT / "scenarios", folder / "hardball" / "scenario_files", dirs_exist_ok=True)


class InstallProgram(install_scripts):
    """Installs the program where scripts are, so that it is on the PATH of an environment."""

    def run(self):
        super().run()
        program = Path(self.get_finalized_command("build_ext").build_temp, "hardball")
        self.mkpath(self.install_dir)
        self.outfiles += self.copy_file(str(program), self.install_dir)[:1]


class SdistWithCommit(sdist):
    """Writes down the commit, as git archive does: a source distribution has no repository."""

    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        script, header = Path(base_dir, "cmake/commit.cmake"), Path(base_dir, "commit.hpp")
        subprocess.run(["cmake", f"-DSOURCE={ROOT}", f"-DHEADER={header.resolve()}", "-P", ROOT / "cmake/commit.cmake"], check=True)
        commit = re.search(r'kCommit\[\] = "(.*)"', header.read_text())[1]
        header.unlink()
        text = script.read_text().replace('string(SUBSTRING "$Format:%H$" 0 12 commit)', f"set(commit {commit})")
        script.unlink()  # it may be linked to the original
        script.write_text(text)


address = re.search(r'HOMEPAGE_URL "([^"]*)"', (ROOT / "CMakeLists.txt").read_text())[1]
version = ".".join(re.findall(r"#define HARDBALL_VERSION_\w+ (\d+)", (ROOT / "hardball/errors/version.hpp").read_text()))
setup(
    version=version,
    project_urls={"Homepage": address} if address else {},
    ext_modules=[Extension("hardball._hardball", [])],
    cmdclass={"build_ext": BuildWithCMake, "install_scripts": InstallProgram, "sdist": SdistWithCommit},
)

# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Conan 2: the static library in C++. `conan create packaging/conan` in a clone."""

import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class Hardball(ConanFile):
    name = "hardball"
    description = "Every collision among many moving spheres, exactly and in order"
    license = "MIT"
    package_type = "static-library"
    settings = "os", "arch", "compiler", "build_type"

    def set_version(self):
        header = load(self, os.path.join(self.recipe_folder, "../../hardball/errors/version.hpp"))
        self.version = ".".join(re.findall(r"#define HARDBALL_VERSION_\w+ (\d+)", header))

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "../..")
        for part in ("CMakeLists.txt", "LICENSE", "cmake/*", "docs/*.md", "hardball/*", "scenarios/*"):
            copy(self, part, root, self.export_sources_folder)

    def requirements(self):
        self.requires("zstd/[>=1.5 <2]")
        # Headers, which users do not see.
        for name in ("tomlplusplus/[>=3.3 <4]", "nlohmann_json/[>=3.11 <4]", "xxhash/[>=0.8 <1]"):
            self.requires(name, visible=False)

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for part in ("APPS", "C", "TESTS", "EXAMPLES"):
            toolchain.cache_variables[f"HARDBALL_{part}"] = False
        folders = {"ZSTD": "zstd", "XXHASH": "xxhash", "NLOHMANN_JSON": "nlohmann_json", "TOMLPLUSPLUS": "tomlplusplus"}
        for variable, dependency in folders.items():
            folder = self.dependencies[dependency].cpp_info.includedirs[0]
            toolchain.cache_variables[f"HARDBALL_{variable}_INCLUDE_DIR"] = folder
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        self.cpp_info.libs = ["hardball"]
        # Results depend on it, in what users compile, too.
        self.cpp_info.cxxflags = ["-ffp-contract=off"]

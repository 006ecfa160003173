#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The recipes of packages agree with the project: they can be read, and name its version, its options and the libraries
that it needs; and the page of installations names them.

usage: recipes_test.py PROJECT_FOLDER
"""

import ast
import json
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

import yaml
from checking import files_of

PROJECT = Path(sys.argv.pop()).resolve()
PACKAGING = PROJECT / "packaging"
VERSION = ".".join(re.findall(r"#define HARDBALL_VERSION_\w+ (\d+)", (PROJECT / "hardball/errors/version.hpp").read_text()))
# What the library is compiled with, and what the program needs beside it.
LIBRARY = {"zstd", "xxhash", "nlohmannjson", "tomlplusplus"}
PROGRAM = {"cli11", "cpphttplib", "fmt"}
RECIPES = ["conda/recipe.yaml", "conan/conanfile.py", "vcpkg/hardball/portfile.cmake", "vcpkg/hardball/vcpkg.json", "homebrew/hardball.rb"]


def plain(names):
    """Names of libraries without what recipes add, and without versions."""
    return {re.sub(r"[-_]|/.*", "", name) for name in names}


class Recipes(unittest.TestCase):
    def test_options_are_those_of_the_project(self):
        declared = "".join(file.read_text() for file in files_of(PROJECT) if file.name == "CMakeLists.txt")
        files = [*(PACKAGING / recipe for recipe in RECIPES), PROJECT / "pyproject.toml", PROJECT / "setup.py"]
        for file in files:
            for option in re.findall(r"-D(HARDBALL_\w+)=", file.read_text()):
                self.assertRegex(declared, rf"(option|set|find_path|find_program|find_library)\({option}\b", f"{file}: {option}")

    def test_conda(self):
        recipe = yaml.safe_load((PACKAGING / "conda/recipe.yaml").read_text())
        self.assertEqual(recipe["context"]["version"], VERSION)
        self.assertEqual((PACKAGING / "conda" / recipe["source"]["path"]).resolve(), PROJECT)
        host = plain(recipe["requirements"]["host"])
        self.assertLessEqual(LIBRARY | PROGRAM | {"pybind11", "setuptools", "numpy"}, host)
        self.assertTrue((PROJECT / recipe["about"]["license_file"]).is_file())

    def test_vcpkg(self):
        port = PACKAGING / "vcpkg/hardball"
        manifest = json.loads((port / "vcpkg.json").read_text())
        self.assertEqual(manifest["version"], VERSION)
        names = {each for each in manifest["dependencies"] if isinstance(each, str)}
        self.assertEqual(plain(names), LIBRARY)
        # CMake runs the port with functions that only say how they are called, over a package as the project installs it.
        with tempfile.TemporaryDirectory() as folder:
            config = Path(folder) / "share/hardball/hardballConfig.cmake"
            config.parent.mkdir(parents=True)
            config.write_text('set_target_properties(hardball PROPERTIES X "$<LINK_ONLY:zstd>")\n')
            functions = ["cmake_configure", "cmake_install", "cmake_config_fixup", "fixup_pkgconfig", "install_copyright"]
            script = [f'function(vcpkg_{name})\nmessage("{name} ${{ARGV}}")\nendfunction()' for name in functions]
            script += ["function(vcpkg_replace_string file from to)", "file(READ ${file} text)",
                       'string(REPLACE "${from}" "${to}" text "${text}")', 'file(WRITE ${file} "${text}")', "endfunction()",
                       f"set(CURRENT_PACKAGES_DIR {folder})", f"include({port}/portfile.cmake)"]
            (Path(folder) / "run.cmake").write_text("\n".join(script))
            done = subprocess.run(["cmake", "-P", Path(folder) / "run.cmake"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"cmake_configure SOURCE_PATH;{PROJECT};OPTIONS;", done.stderr)
            self.assertIn("find_dependency(zstd)\nset_target_properties", config.read_text())
            self.assertIn("LINK_ONLY:zstd::libzstd>", config.read_text())

    def test_cibuildwheel(self):
        settings = tomllib.loads((PROJECT / "pyproject.toml").read_text())
        required = plain(re.sub("[<>=].*", "", name) for name in settings["build-system"]["requires"])
        self.assertLessEqual({"setuptools", "pybind11", "cmake", "numpy"}, required)
        wheels = settings["tool"]["cibuildwheel"]
        self.assertIn("cp311-*", wheels["build"])
        self.assertTrue((PROJECT / re.search(r"\{project\}/(\S+)", wheels["test-command"])[1]).is_file())
        for folder in re.findall(r"=/project/(\S+)/[\w-]+", wheels["linux"]["environment"]["CMAKE_ARGS"]):
            self.assertIn(f"libraries=$PWD/{folder}", (PROJECT / "dev").read_text())

    def test_conan(self):
        text = (PACKAGING / "conan/conanfile.py").read_text()
        recipe = next(node for node in ast.parse(text).body if isinstance(node, ast.ClassDef))
        methods = {node.name for node in recipe.body if isinstance(node, ast.FunctionDef)}
        self.assertLessEqual({"set_version", "export_sources", "requirements", "build", "package", "package_info"}, methods)
        self.assertEqual(plain(re.findall(r'"([a-z_]+/\[)', text)), LIBRARY)

    def test_homebrew(self):
        formula = PACKAGING / "homebrew/hardball.rb"
        text = formula.read_text()
        self.assertLessEqual(LIBRARY | PROGRAM, plain(re.findall(r'depends_on "([^"]+)"', text)))
        if shutil.which("ruby"):
            subprocess.run(["ruby", "-c", formula], check=True, stdout=subprocess.DEVNULL)

    def test_the_container_copies_what_is_there(self):
        text = (PROJECT / "Containerfile").read_text()
        stages = re.findall(r"^FROM (\S+)(?: AS (\w+))?$", text, re.MULTILINE)
        self.assertEqual([name for _, name in stages], ["build", ""])
        self.assertIn("RUN ./dev package\n", text)

    def test_each_line_of_the_page_is_tested_or_says_that_it_is_not(self):
        page = (PROJECT / "docs/install.md").read_text()
        table = re.search(r"^\| who you are .*\n\|[-|]+\n((?:\|.*\n)+)", page, re.MULTILINE)[1]
        listed = "".join(file.read_text() for file in PROJECT.glob("tests/**/CMakeLists.txt"))
        dev = (PROJECT / "dev").read_text()
        rows = [line.strip("|").split("|") for line in table.splitlines()]
        self.assertGreater(len(rows), 10)
        for who, _, tested in rows:
            tests = re.findall("`([^`]+)`", tested)
            self.assertTrue(tests, who)
            for test in tests:
                if command := re.fullmatch(r"\./dev (\w+) --test", test):
                    self.assertRegex(dev, rf"(?s)\ncommand_{command[1]}\(\) \{{[^}}]*--test", who)
                else:
                    name = re.sub("^embed[.].*", "embed.${by}", test)
                    self.assertTrue(f"NAME {name}\n" in listed or f"NAME {name} " in listed, f"{who}: there is no test {test}")
            if tests == ["structure.recipes"]:
                self.assertIn("not built", tested, who)

    def test_the_page_names_each_recipe(self):
        page = (PROJECT / "docs/install.md").read_text()
        for name in ("packaging/conda", "packaging/conan", "packaging/vcpkg", "packaging/homebrew/hardball.rb", "Containerfile", "cibuildwheel"):
            self.assertIn(name, page)


if __name__ == "__main__":
    unittest.main()

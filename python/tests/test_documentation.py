# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Everything public is documented and typed."""

import contextlib
import inspect
import io
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import hardball
from support import ROOT, gas


class Documentation(unittest.TestCase):
    def test_everything_public_has_a_docstring(self):
        # Of what a name says, the docstring has nothing to add.
        plain = {"Quantity.value", "Surface.name"}
        for name in hardball.__all__:
            entity = getattr(hardball, name)
            if isinstance(entity, str):
                continue
            self.assertTrue(entity.__doc__, name)
            if not inspect.isclass(entity):
                continue
            for member, value in vars(entity).items():
                text = inspect.getdoc(value) or ""
                if member.startswith("_") or f"{name}.{member}" in plain or issubclass(entity, Exception):
                    continue
                # What pybind11 itself writes is the signature.
                said = [line for line in text.splitlines() if line and "->" not in line]
                self.assertTrue(said, f"{name}.{member}")

    def test_everything_public_is_on_the_page_of_reference(self):
        page = (ROOT / "docs/site/python_reference.md").read_text()
        shown = re.findall(r"^\.\. auto\w+:: hardball\.(\w+)$", page, re.MULTILINE)
        self.assertEqual(sorted(shown), sorted(set(hardball.__all__) - {"__version__"}))

    def test_stubs_are_true(self):
        command = [sys.executable, "-m", "mypy.stubtest", "hardball._hardball"]
        options = ["--allowlist", ROOT / "python/tests/allowed_differences.txt"]
        options += ["--ignore-unused-allowlist", "--mypy-config-file", ROOT / "pyproject.toml"]
        done = subprocess.run(command + options, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_types_are_sound(self):
        command = [sys.executable, "-B", "-m", "mypy", "--config-file", ROOT / "pyproject.toml", "-p", "hardball"]
        done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT / "python")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def run_page(self, page):
        """Runs the examples of a page, one after the other, and returns what they print."""
        examples = re.findall(r"^```python\n(.*?)^```", (ROOT / page).read_text(), re.DOTALL | re.MULTILINE)
        self.assertTrue(examples)
        names = {}
        with contextlib.ExitStack() as stack:
            folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
            (folder / "scenarios").symlink_to(ROOT / "scenarios")
            stack.enter_context(mock.patch("tempfile.tempdir", str(folder)))
            stack.enter_context(mock.patch("webbrowser.open"))
            stack.callback(os.chdir, os.getcwd())
            os.chdir(folder)
            stack.enter_context(contextlib.redirect_stderr(io.StringIO()))
            printed = stack.enter_context(contextlib.redirect_stdout(io.StringIO()))
            for example in examples:
                exec(compile(example, page, "exec"), names)
        return printed.getvalue()

    def test_the_example_of_the_readme_runs(self):
        printed = self.run_page("README.md")
        # Within five standard errors of the theory.
        value, error, theory = map(float, re.search(r": (\S+) \+- (\S+), theory (\S+)>", printed).groups())
        self.assertLess(abs(value - theory), 5 * error)
        self.assertLess(error, 0.05)

    def test_the_examples_of_the_documentation_run(self):
        for page in ("docs/python.md", "docs/python_how_to.md"):
            with self.subTest(page):
                self.run_page(page)

    def test_the_example_makes_its_figure(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, ROOT / "examples/equation_of_state.py"], check=True, cwd=folder, capture_output=True)
            self.assertTrue((Path(folder) / "equation_of_state.png").read_bytes().startswith(b"\x89PNG"))

    def test_pictures(self):
        simulation = gas()
        self.assertIn("125 spheres", repr(simulation))
        html = simulation._repr_html_()
        self.assertEqual(html.count("<circle"), 125)
        self.assertIn(simulation.event_log_hash, html)
        self.assertIn("0", hardball.Simulation(hardball.Box.open(), positions=[])._repr_html_())


if __name__ == "__main__":
    unittest.main()

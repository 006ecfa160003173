# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The short programs in examples/, and the page that shows them."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import hardball
from support import ROOT

PROGRAMS = sorted((ROOT / "examples").glob("*.py"))
PAGE = (ROOT / "docs/examples.md").read_text()
MOST_LINES, MOST_BYTES = 60, 60_000


def figure_of(program):
    """The picture of a program on the page, if it has one."""
    return ROOT / "docs/figures" / f"{program.stem}.svg"


class Examples(unittest.TestCase):
    def check_run(self, program, *arguments):
        """Runs it in an empty folder without a display, compares what it prints, and returns its pictures."""
        with tempfile.TemporaryDirectory() as folder:
            command = [sys.executable, "-B", program, *arguments]
            done = subprocess.run(command, capture_output=True, text=True, cwd=folder, env={**os.environ, "MPLBACKEND": "agg"})
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stderr, "")
            self.assertEqual(done.stdout, (ROOT / f"examples/expected/{program.stem}.txt").read_text())
            return {file.name: file.read_text() for file in Path(folder).glob("*.svg")}

    def test_they_print_what_is_expected(self):
        self.assertGreaterEqual(len(PROGRAMS), 9)
        for program in PROGRAMS:
            # That with a plot that is watched ends by itself only if it is saved.
            if program.stem != "live_plot":
                with self.subTest(program.stem):
                    self.assertEqual(self.check_run(program), {})

    def test_they_draw_what_the_page_shows(self):
        for program in PROGRAMS:
            if figure_of(program).exists():
                with self.subTest(program.stem):
                    pictures = self.check_run(program, "drawn.svg")
                    self.assertEqual(list(pictures), ["drawn.svg"])
                    self.assertIn("</svg>", pictures["drawn.svg"])
                    self.assertLess(len(figure_of(program).read_bytes()), MOST_BYTES)

    def test_they_are_short(self):
        for program in [*PROGRAMS, ROOT / "examples/game_loop.c", *(ROOT / "examples/fetch_content").iterdir()]:
            self.assertLess(len(program.read_text().splitlines()), MOST_LINES, program)

    def test_their_types_are_sound(self):
        command = [sys.executable, "-B", "-m", "mypy", "--config-file", ROOT / "pyproject.toml", *PROGRAMS]
        done = subprocess.run(command, capture_output=True, text=True, cwd=Path(hardball.__file__).parents[1])
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_page_shows_what_they_print(self):
        shown = re.findall(r"^```sh\n(.*?)^```\n+```text\n(.*?)^```", PAGE, re.DOTALL | re.MULTILINE)
        outputs = {re.search(r"examples/(\w+)", commands)[1]: printed for commands, printed in shown}
        names = [*(program.stem for program in PROGRAMS), "game_loop", "fetch_content"]
        self.assertEqual(sorted(outputs), sorted(names))
        for name in names:
            self.assertEqual(outputs[name], (ROOT / f"examples/expected/{name}.txt").read_text(), name)
        for program in PROGRAMS:
            self.assertEqual(f"](figures/{program.stem}.svg)" in PAGE, figure_of(program).exists(), program.stem)


if __name__ == "__main__":
    unittest.main()

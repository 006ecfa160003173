# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Every notebook runs, and ends in a figure."""

import os
import tempfile
import unittest

import nbclient
import nbformat

from support import ROOT


class Notebooks(unittest.TestCase):
    def setUp(self):
        # Whoever runs the tests may have no home to write to.
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        for name in ("IPYTHONDIR", "JUPYTER_RUNTIME_DIR", "MPLCONFIGDIR"):
            os.environ[name] = folder.name

    def test_all(self):
        notebooks = sorted((ROOT / "notebooks").glob("*.ipynb"))
        self.assertGreaterEqual(len(notebooks), 5)
        for path in notebooks:
            with self.subTest(path.name):
                notebook = nbformat.read(path, as_version=4)
                nbformat.validate(notebook)
                for cell in notebook.cells:
                    self.assertFalse(cell.get("outputs"), "stored without outputs")
                resources = {"metadata": {"path": str(path.parent)}}
                nbclient.NotebookClient(notebook, timeout=200, resources=resources).execute()
                shown = [output for output in notebook.cells[-1].outputs if "image/png" in output.get("data", {})]
                self.assertEqual(len(shown), 1)


if __name__ == "__main__":
    unittest.main()

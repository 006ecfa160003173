#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Builds the documentation site: the pages in docs/, the notebooks with their figures, the references.

usage: PYTHONPATH=build/python python3 docs/site/build_site.py FOLDER
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import nbclient
import nbformat
from address import with_address
from checks import faults_of_site, missing_from_reference
from conf import KATEX
from nbconvert import MarkdownExporter

ROOT = Path(__file__).resolve().parents[2]
SITE = ROOT / "docs" / "site"
NORMALIZE = "/javascript/normalize.css/normalize.css"
REPOSITORY_LINK = re.compile(r"\]\((?:\.\./)+((?:README|CHANGELOG|ARCHITECTURE|scenarios|notebooks|hardball|examples|tests|bench)\b[^)]*)\)")


def write_page(page, target):
    # What is not on the site is named, not linked.
    text = re.sub(r"\[([^\]]+)" + REPOSITORY_LINK.pattern, r"`\2`", with_address(page.read_text()))
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(text)


def write_notebook(path, folder):
    """Runs a notebook and writes it as a page. Every one ends in a figure, and is stored without outputs."""
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    if any(cell.get("outputs") for cell in notebook.cells):
        sys.exit(f"{path}: stored with outputs; clear them")
    nbclient.NotebookClient(notebook, timeout=200, resources={"metadata": {"path": str(path.parent)}}).execute()
    if not any("image/png" in output.get("data", {}) for output in notebook.cells[-1].outputs):
        sys.exit(f"{path}: does not end in a figure")
    text, resources = MarkdownExporter().from_notebook_node(notebook, {"output_files_dir": path.stem})
    (folder / path.stem).mkdir(parents=True, exist_ok=True)
    (folder / f"{path.stem}.md").write_text(text)
    for name, content in resources["outputs"].items():
        (folder / name).write_bytes(content)


def main():
    folder = Path(sys.argv[1]).resolve()
    source = folder / "source"
    shutil.rmtree(source, ignore_errors=True)
    # Whoever runs this may have no home to write to.
    for name in ("IPYTHONDIR", "JUPYTER_RUNTIME_DIR", "MPLCONFIGDIR"):
        os.environ[name] = str(folder / "home")
    for page in [*(ROOT / "docs").glob("*.md"), *(ROOT / "docs" / "decisions").glob("*.md")]:
        write_page(page, source / page.relative_to(ROOT / "docs"))
    shutil.copytree(ROOT / "docs" / "figures", source / "figures")
    for page in SITE.glob("*.md"):
        write_page(page, source / page.name)
    for name in ("conf.py", "katex.js"):
        shutil.copy(SITE / name, source)
    (source / "_static").mkdir()
    shutil.copy(SITE / "site.css", source / "_static")
    shutil.copytree(KATEX / "fonts", source / "_static" / "katex" / "fonts")
    shutil.copy(KATEX / "katex.min.css", source / "_static" / "katex")
    decisions = sorted(page.stem for page in (ROOT / "docs" / "decisions").glob("*.md"))
    listed = "\n".join(["# Decisions", "", "```{toctree}", ":maxdepth: 1", "", *decisions, "```", ""])
    (source / "decisions" / "index.md").write_text(listed)
    for path in sorted((ROOT / "notebooks").glob("*.ipynb")):
        write_notebook(path, source / "notebooks")

    settings = [
        f"INPUT={ROOT / 'hardball'}",
        "RECURSIVE=YES",
        "FILE_PATTERNS=*.hpp",
        f"OUTPUT_DIRECTORY={source / 'doxygen'}",
        "GENERATE_XML=YES",
        "GENERATE_HTML=NO",
        "GENERATE_LATEX=NO",
        "MACRO_EXPANSION=YES",
        "EXPAND_ONLY_PREDEF=YES",
        "PREDEFINED=HARDBALL_ALWAYS_INLINE= HARDBALL_EXPORT=",
        "QUIET=YES",
        "WARN_IF_UNDOCUMENTED=NO",
        "WARNINGS=NO",
    ]
    (source / "doxygen").mkdir()
    subprocess.run(["doxygen", "-"], input="\n".join(settings), text=True, check=True)
    reference = SITE / "cpp_reference.md"
    if missing := missing_from_reference(source / "doxygen" / "xml", "hardball::Simulation", reference.read_text()):
        sys.exit(f"{reference}: lacks {', '.join(missing)}, which users of Simulation meet")
    command = [sys.executable, "-m", "sphinx", "-q", "-E", "-W", "--keep-going", "-b", "html", source, folder / "html"]
    subprocess.run(command, check=True, env={**os.environ, "LC_ALL": "C.UTF-8"})
    # Debian's theme expects this at the root of a web server.
    theme = folder / "html" / "_static" / "styles" / "furo.css"
    if NORMALIZE in theme.read_text():
        shutil.copy(Path("/usr/share") / NORMALIZE[1:], theme.parent)
        theme.write_text(theme.read_text().replace(NORMALIZE, Path(NORMALIZE).name))
    if faults := faults_of_site(folder / "html"):
        sys.exit("\n".join(faults))
    print(f"the site begins at {folder / 'html' / 'index.html'}")


if __name__ == "__main__":
    main()

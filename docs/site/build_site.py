#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Builds the documentation site: the front page, the pages in docs/, the gallery with its replays, the lessons, the
notebooks with their figures, the references.

usage: PYTHONPATH=build/python python3 docs/site/build_site.py FOLDER [--without-notebooks] [--playground PLAYGROUND]
"""

import argparse
import html
import json
import os
import re
import shlex
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


def comparison():
    """The section of README.md that compares the project with others, with links as the site has them."""
    section = re.search(r"^## Compared with others\n+(.*?)^## ", (ROOT / "README.md").read_text(), re.DOTALL | re.MULTILINE)
    return section[1].replace("[docs/", "[").replace("](docs/", "](")


def write_front_page(source, has_playground):
    page = source / "index.md"
    text = page.read_text().replace("<!-- comparison -->", comparison())
    if has_playground:
        text = text.replace("See the [gallery]", 'Try it in the <a href="playground/index.html">playground</a>, see the [gallery]')
    page.write_text(text)


def write_lessons(folder, has_playground):
    """The lessons of the playground as pages, in their order, each with its scenario."""
    folder.mkdir()
    lessons = []
    for page in (ROOT / "playground" / "lessons").glob("*.md"):
        _, matter, text = page.read_text().split("---\n", 2)
        lesson = dict(line.split(": ", 1) for line in matter.splitlines())
        scenario = page.parent / lesson["scenario"]
        name = scenario.resolve().relative_to(ROOT)
        run = f"Run it with `hardball view {name}`."
        if has_playground:
            run = f'<a href="../playground/index.html#lesson={page.stem}">Open it in the playground</a>, or run it with `hardball view {name}`.'
        heading, text = re.sub(r"<!--.*?-->\n*", "", text, flags=re.DOTALL).strip().split("\n", 1)
        listing = [f"<details><summary>{name}</summary>", f"```toml\n{scenario.read_text().rstrip()}\n```", "</details>"]
        parts = [heading, run, text.strip(), "## The scenario", *listing]
        (folder / page.name).write_text("\n\n".join(parts) + "\n")
        lessons.append((int(lesson["order"]), page.stem, lesson))
    lessons.sort(key=lambda each: each[0])
    listed = [f"{order}. [{lesson['title']}]({name}.md). {lesson['summary']}" for order, name, lesson in lessons]
    begin = "Each lesson is a text, a run to look at, and questions with answers. The numbers in the texts are those of the runs."
    tree = ["```{toctree}", ":maxdepth: 1", ":hidden:", "", *(name for _, name, _ in lessons), "```"]
    (folder / "index.md").write_text("\n".join(["# Lessons", "", begin, "", *listed, "", *tree, ""]))


def write_gallery(page, extra, has_playground):
    """Runs the scenarios of gallery.json, writes each as a page that replays it, and a page of their pictures."""
    (extra / "replays").mkdir(parents=True)
    shutil.copytree(ROOT / "docs" / "figures" / "gallery", extra / "pictures")
    cards = []
    for run in json.loads((SITE / "gallery.json").read_text()):
        name = run["scenario"]
        options = [word for setting in run["settings"] for word in ("--set", setting)]
        words = ["replay", f"scenarios/{name}.toml", *options, "--out"]
        target = extra / "replays" / f"{name}.html"
        subprocess.run([sys.executable, "-m", "hardball", *words, target, "--quiet"], cwd=ROOT, check=True)
        title, text = html.escape(run["title"]), html.escape(run["text"])
        links = [f'<a href="replays/{name}.html">Replay</a>']
        if has_playground:
            links.append(f'<a href="playground/index.html#scenario={name}">Open in the playground</a>')
        cards += [
            "<figure>",
            f'<a href="replays/{name}.html"><img src="pictures/{name}.webp" width="640" height="480" loading="lazy" alt="{title}"></a>',
            f"<figcaption><strong>{title}.</strong> {text} {' · '.join(links)}",
            f"<br><code>{html.escape(shlex.join(['hardball', *words, f'{name}.html']))}</code></figcaption>",
            "</figure>",
        ]
    page.write_text(page.read_text().replace("<!-- gallery -->", "\n".join(['<div class="gallery">', *cards, "</div>"])))


def write_notebook(path, folder, is_run):
    """Writes a notebook as a page, with the results of running it if it `is_run`. Every one has a figure, and is stored
    without outputs."""
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    if any(cell.get("outputs") for cell in notebook.cells):
        sys.exit(f"{path}: stored with outputs; clear them")
    if is_run:
        nbclient.NotebookClient(notebook, timeout=200, resources={"metadata": {"path": str(path.parent)}}).execute()
        outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
        if not any("image/png" in output.get("data", {}) for output in outputs):
            sys.exit(f"{path}: has no figure")
    text, resources = MarkdownExporter().from_notebook_node(notebook, {"output_files_dir": path.stem})
    (folder / path.stem).mkdir(parents=True, exist_ok=True)
    (folder / f"{path.stem}.md").write_text(text)
    for name, content in resources["outputs"].items():
        (folder / name).write_bytes(content)


def complete_theme(static):
    """What Debian leaves out of its theme: a style that it expects at the root of a web server, and the bundling of scripts."""
    style = static / "styles" / "furo.css"
    if NORMALIZE in style.read_text():
        shutil.copy(Path("/usr/share") / NORMALIZE[1:], style.parent)
        style.write_text(style.read_text().replace(NORMALIZE, Path(NORMALIZE).name))
    script = static / "scripts" / "furo.js"
    imported = 'import Gumshoe from "./gumshoe-patched.js";'
    if imported in script.read_text():
        script.write_text(script.read_text().replace(imported, (script.parent / "gumshoe-patched.js").read_text()))


def main():
    parser = argparse.ArgumentParser(description="Builds the documentation site.")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--without-notebooks", action="store_true", help="show the code of notebooks, but do not run it")
    parser.add_argument("--playground", type=Path, help="the folder of the playground, which becomes a part of the site")
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    has_playground = arguments.playground is not None
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
    write_front_page(source, has_playground)
    write_lessons(source / "lessons", has_playground)
    write_gallery(source / "gallery.md", source / "extra", has_playground)
    if has_playground:
        shutil.copytree(arguments.playground, source / "extra" / "playground")
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
        write_notebook(path, source / "notebooks", not arguments.without_notebooks)

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
    complete_theme(folder / "html" / "_static")
    if faults := faults_of_site(folder / "html"):
        sys.exit("\n".join(faults))
    print(f"the site begins at {folder / 'html' / 'index.html'}")


if __name__ == "__main__":
    main()

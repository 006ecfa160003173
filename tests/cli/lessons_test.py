#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The lessons of the playground: their front matter, that their scenarios run to the end, and that the numbers in their
texts are those of the runs. A page says beside a sentence which number it has from the run, in a comment

    <!-- measured: KEY = VALUE ± TOLERANCE -->
    <!-- measured with ARGUMENT...: KEY = VALUE ± TOLERANCE -->

where each ARGUMENT is an option of `hardball run`, such as --cell-edge=10, or what follows --set. KEY is the way to a number
in summary.json, such as events.collision or walls.plane_1.work; or measures.NAME.QUANTITY, of measures/quantities.csv; or
frame.AXIS.mean or frame.AXIS.deviation, of the centers at the end. The digits of VALUE must be in the text.

Usage: lessons_test.py PROGRAM PROJECT [LESSON...]
"""
import csv
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

KEYS = {"title", "order", "scenario", "summary"}
COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
MARK = re.compile(r"<!-- measured(?: with (?P<arguments>[^:]+))?: (?P<key>[\w.]+) = (?P<value>-?[\d.,]+) ± (?P<tolerance>[\d.,e-]+) -->")
PATIENCE = 300


def parts_of(page):
    """The front matter as a dict of texts, and the text below it."""
    begin, matter, text = page.read_text().split("---\n", 2)
    assert not begin, f"{page}: does not begin with its front matter"
    return dict(line.split(": ", 1) for line in matter.splitlines()), text


def number(text):
    return float(text.replace(",", ""))


def marks_of(text):
    """What a text says to be measured: by the arguments of a run, a list of keys, values and tolerances."""
    marks = {}
    for comment in COMMENT.findall(text):
        mark = MARK.fullmatch(comment)
        assert mark, f"{comment} is no mark of a number"
        arguments = tuple((mark["arguments"] or "").split())
        marks.setdefault(arguments, []).append((mark["key"], mark["value"], number(mark["tolerance"])))
    return marks


def check_text(page, text):
    shown = COMMENT.sub("", text)
    for marks in marks_of(text).values():
        for key, value, _ in marks:
            digits = re.escape(value.lstrip("-"))
            assert re.search(rf"(?<![\d.,]){digits}(?!\d|[.,]\d)", shown), f"{page}: the text does not say that {key} is {value}"
    assert shown.count("<details>") == shown.count("</details>") == shown.count("<summary>Answer</summary>") >= 3, f"{page}: answers"
    for address in re.findall(r"\]\(([^)#]+)", shown):
        assert (page.parent / address).exists(), f"{page}: {address} is not there"


def run(program, scenario, arguments, folder):
    """The summary of a run, whose files are in `folder`."""
    until = next((each.split("=")[1] for each in arguments if each.startswith("run.until=")), None)
    until = until or tomllib.loads(scenario.read_text())["run"]["until"]
    options = [word for each in arguments for word in ([each] if each.startswith("--") else ["--set", each])]
    command = [program, "run", scenario, "--out", folder, "--overwrite", "--quiet", "--json", "--set", f"output.snapshots_every={until}"]
    done = subprocess.run([*command, *options], check=True, timeout=PATIENCE, stdout=subprocess.PIPE, text=True)
    summary = json.loads(done.stdout)
    assert summary["time"] == float(until), f"{scenario}: ended at {summary['time']}"
    return summary


def measured(program, summary, folder, key):
    first, *others = key.split(".")
    if first == "measures":
        with open(folder / "measures" / "quantities.csv", encoding="utf-8") as table:
            return next(float(row["value"]) for row in csv.DictReader(table) if [row["measure"], row["name"]] == others)
    if first == "frame":
        axis, kind = others
        subprocess.run([program, "convert", folder / "trajectory.xyz", folder / "end.csv", "--overwrite"], check=True, stdout=subprocess.DEVNULL)
        with open(folder / "end.csv", encoding="utf-8") as table:
            values = [float(row[axis]) for row in csv.DictReader(table)]
        return {"mean": statistics.fmean, "deviation": statistics.stdev}[kind](values)
    found = summary[first]
    for name in others:
        found = next(each for each in found if each["name"] == name) if isinstance(found, list) else found[name]
    return found


def check_lesson(page, program):
    matter, text = parts_of(page)
    assert set(matter) == KEYS, f"{page}: {sorted(matter)}"
    check_text(page, text)
    scenario = page.parent / matter["scenario"]
    assert scenario.exists(), f"{page}: {scenario} is not there"
    subprocess.run([program, "check", scenario], check=True, timeout=PATIENCE, stdout=subprocess.DEVNULL)
    marks = marks_of(text)
    assert () in marks, f"{page}: states no number of its scenario"
    for arguments, claims in marks.items():
        with tempfile.TemporaryDirectory() as folder:
            summary = run(program, scenario, arguments, folder)
            for key, value, tolerance in claims:
                found = measured(program, summary, Path(folder), key)
                where = " ".join([page.name, *arguments, key])
                assert abs(found - number(value)) <= tolerance, f"{where}: the text says {value} ± {tolerance}, the run has {found}"
                print(f"{where} = {found:.6g}, in the text {value}", flush=True)


def main():
    program, project = map(Path, map(os.path.abspath, sys.argv[1:3]))
    pages = sorted((project / "playground" / "lessons").glob("*.md"))
    assert len(pages) >= 12, "lessons are missing"
    scenarios = {(page.parent / parts_of(page)[0]["scenario"]).resolve() for page in pages}
    for file in (project / "playground" / "lessons").glob("*.toml"):
        assert file.resolve() in scenarios, f"{file}: belongs to no lesson"
    orders = sorted(int(parts_of(page)[0]["order"]) for page in pages)
    assert orders == list(range(1, len(pages) + 1)), f"orders are {orders}"
    for page in pages:
        if not sys.argv[3:] or page.stem in sys.argv[3:]:
            check_lesson(page, program)


if __name__ == "__main__":
    main()

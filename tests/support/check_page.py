#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Checks that a page is well-formed, self-contained, and accessible.

usage: check_page.py PAGE

Says what is wrong, a fault a line, and exits 1 if there is any.
"""

import re
import sys
import xml.etree.ElementTree
from html.parser import HTMLParser
from pathlib import Path

VOID_ELEMENTS = {"meta", "br", "hr", "img", "input", "link", "col"}
FETCHING_ELEMENTS = set("script link img image iframe object embed video audio source base form use".split())
FETCHING_ATTRIBUTES = {"src", "srcset", "action", "data", "poster", "background", "xlink:href"}
# Source: Web Content Accessibility Guidelines 2.2, success criteria 1.4.3 and 1.4.11.
TEXT_CONTRAST, GRAPHIC_CONTRAST = 4.5, 3.0
TEXT_COLORS = ("ink", "muted", "accent", "good", "bad")
SERIES_COLORS = tuple(f"series-{number}" for number in range(1, 9))


class OpenElements(HTMLParser):
    """Reads a page as browsers do; records mismatched end tags."""

    def __init__(self):
        super().__init__()
        self.open, self.faults = [], []

    def handle_starttag(self, tag, attributes):
        if tag not in VOID_ELEMENTS:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        # In HTML the slash closes only void elements and those within an SVG picture.
        if tag not in VOID_ELEMENTS and "svg" not in self.open:
            self.faults.append(f"<{tag}/> stays open in HTML")

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append(f"</{tag}> closes another element")


def luminance(color):
    def linear(value):
        return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4

    red, green, blue = (linear(int(color[i : i + 2], 16) / 255) for i in (1, 3, 5))
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one, other):
    lighter, darker = sorted((luminance(one), luminance(other)), reverse=True)
    return (lighter + 0.05) / (darker + 0.05)


def check_colors(style):
    blocks = re.findall(r":root {([^}]*)}", style)
    palettes = [dict(re.findall(r"--([a-z0-9-]+): (#[0-9a-f]{6});", block)) for block in blocks]
    if len(palettes) != 3:
        yield f"{len(palettes)} palettes instead of three: light, dark, print"
    for number, palette in enumerate(palettes):
        for names, least in ((TEXT_COLORS, TEXT_CONTRAST), (SERIES_COLORS, GRAPHIC_CONTRAST)):
            for name in names:
                for ground in ("paper", "panel") if name in TEXT_COLORS else ("paper",):
                    if name not in palette or ground not in palette:
                        yield f"palette {number} has no {name} or no {ground}"
                    elif (found := contrast(palette[name], palette[ground])) < least:
                        yield f"palette {number}: {name} on {ground} has a contrast of {found:.2f} instead of {least}"


def text_of(element):
    return "".join(element.itertext()).strip()


def check(text):
    parser = OpenElements()
    parser.feed(text)
    parser.close()
    yield from parser.faults
    yield from (f"<{tag}> is never closed" for tag in parser.open)
    try:
        page = xml.etree.ElementTree.fromstring(text)
    except xml.etree.ElementTree.ParseError as error:
        yield f"no well-formed XML: {error}"
        return
    if not page.get("lang"):
        yield "the language is missing"
    if not text_of(page.find("head/title")):
        yield "the title is missing"

    ids = [element.get("id") for element in page.iter() if element.get("id")]
    yield from (f"the id {name} appears twice" for name in set(ids) if ids.count(name) > 1)
    for element in page.iter():
        if element.tag in FETCHING_ELEMENTS:
            yield f"there is a <{element.tag}>"
        for name, value in element.attrib.items():
            if name in FETCHING_ATTRIBUTES or name.startswith("on"):
                yield f"there is an attribute {name}"
            if name == "href" and not (value.startswith("#") and value[1:] in ids):
                yield f"{value} is not an id of the page"
            if name in ("aria-labelledby", "aria-describedby"):
                yield from (f"{name} names {each}, which is not there" for each in value.split() if each not in ids)
            if "url(" in value:
                yield f"{name} requests {value}"
        if element.tag == "style":
            yield from (f"the style has {word}" for word in ("url(", "@import", "//", "src") if word in element.text)
            yield from check_colors(element.text)
        if element.tag == "svg":
            if element.get("role") != "img":
                yield "a picture does not say that it is one"
            for part in ("title", "desc"):
                if element.find(part) is None or not text_of(element.find(part)):
                    yield f"a picture has no {part}"
        if element.tag == "th" and element.get("scope") not in ("row", "col"):
            yield "a head of a table has no scope"

    level = 0
    for element in page.iter():
        if match := re.fullmatch("h([1-6])", element.tag):
            if int(match.group(1)) > level + 1 or (level > 0 and match.group(1) == "1"):
                yield f"<{element.tag}> {text_of(element)} follows <h{level}>"
            level = int(match.group(1))


def main():
    faults = list(check(Path(sys.argv[1]).read_text(encoding="utf-8")))
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

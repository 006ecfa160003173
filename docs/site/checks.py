# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Checks of the documentation site: that it needs no network, that its links lead somewhere, that its formulas are
formulas, and that the C++ reference is complete."""

import re
import urllib.parse
import xml.etree.ElementTree
from html.parser import HTMLParser

NETWORK = re.compile(r"(?:[a-z]+:)?//", re.IGNORECASE)
SCHEME = re.compile(r"(?:[a-z][a-z0-9+.-]*:|//)", re.IGNORECASE)
STYLE_REQUEST = re.compile(r"""(?:url\(\s*|@import\s+)["']?(?!url\()([^"')\s]+)""")
FORMULA = re.compile(r'<annotation encoding="application/x-tex">(.*?)</annotation>', re.DOTALL)
TEXT_IN_FORMULA = re.compile(r"\\(?:text|mathrm|textrm|operatorname)\{[^}]*\}")
PROSE = re.compile(r"(?<![\\a-z])[a-z]{2,},? [a-z]{2,},? [a-z]{2,}")
REFERENCE_ENTRY = re.compile(r"^\.\. doxygen(?:class|struct|enum|typedef):: (\S+)", re.MULTILINE)


class Requests(HTMLParser):
    """What a browser fetches to show a page, and, apart from that, the links that its reader may follow."""

    def __init__(self, text):
        super().__init__()
        self.addresses = []
        self.links = []
        self.in_style = False
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        for name in ("src", "data", "poster"):
            self.addresses.append(attributes.get(name))
        if tag == "a" and attributes.get("href"):
            self.links.append(attributes["href"])
        if tag == "link" and attributes.get("rel") not in ("canonical", "next", "prev"):
            self.addresses.append(attributes.get("href"))
        self.addresses += [each.split()[0] for each in (attributes.get("srcset") or "").split(",") if each.strip()]
        self.addresses += STYLE_REQUEST.findall(attributes.get("style") or "")
        self.in_style = tag == "style"

    def handle_data(self, data):
        if self.in_style:
            self.addresses += STYLE_REQUEST.findall(data)


def faults_of_site(folder):
    """What is wrong with the built pages in `folder`, as a list of texts: addresses that are fetched from the network
    or are not there, links within the site that lead nowhere, and prose between formulas that is set as a formula, as where a
    dollar sign is missing."""
    faults = []
    for page in sorted([*folder.rglob("*.html"), *folder.rglob("*.css")]):
        text = page.read_text(encoding="utf-8")
        for formula in FORMULA.findall(text):
            if prose := PROSE.search(TEXT_IN_FORMULA.sub("", formula)):
                faults.append(f"{page.relative_to(folder)} sets prose as a formula: {prose[0]}")
        requests = Requests(text if page.suffix == ".html" else "")
        addresses = requests.addresses if page.suffix == ".html" else STYLE_REQUEST.findall(text)
        for link in sorted(set(requests.links)):
            path = urllib.parse.unquote(re.split(r"[?#]", link)[0])
            if not SCHEME.match(link) and path and not (page.parent / path).exists():
                faults.append(f"{page.relative_to(folder)} leads to {link}, which is not there")
        for address in sorted({address for address in addresses if address}):
            if address.startswith(("data:", "#")):
                continue
            if NETWORK.match(address):
                faults.append(f"{page.relative_to(folder)} fetches {address}")
            elif not (page.parent / re.split(r"[?#]", address)[0]).exists():
                faults.append(f"{page.relative_to(folder)} needs {address}, which is not there")
    return faults


def types_reachable(doxygen, begin):
    """The qualified names of the types that a user of the class `begin` meets: those that its public signatures name,
    and those that the signatures of these name. `doxygen`: the folder of Doxygen's XML."""
    members = {
        member.get("id"): member
        for page in doxygen.glob("namespace*.xml")
        for member in xml.etree.ElementTree.parse(page).iter("memberdef")
        if member.get("kind") in ("enum", "typedef")
    }
    index = xml.etree.ElementTree.parse(doxygen / "index.xml")
    names = {compound.get("refid"): compound.findtext("name") for compound in index.iter("compound")}
    found = {}
    waiting = [(next(identity for identity, name in names.items() if name == begin), 0)]
    while waiting:
        identity, level = waiting.pop(0)
        if identity in found:
            continue
        if identity in members:
            found[identity] = members[identity].findtext("qualifiedname")
            # An alias is no more than what it stands for.
            signatures = [members[identity]]
        elif identity in names:
            found[identity] = names[identity]
            definitions = xml.etree.ElementTree.parse(doxygen / f"{identity}.xml").iter("memberdef")
            signatures = [member for member in definitions if member.get("prot") == "public"] if level < 2 else []
            level += 1
        else:
            continue  # a member of a type, which belongs to it
        for member in signatures:
            for part in [*member.findall("type"), *member.findall("param/type")]:
                waiting += [(reference.get("refid"), level) for reference in part.iter("ref")]
    return set(found.values())


def missing_from_reference(doxygen, begin, reference):
    """The types that types_reachable() finds and the page `reference` does not list."""
    return sorted(types_reachable(doxygen, begin) - set(REFERENCE_ENTRY.findall(reference)))

# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The viewer: a page that shows what happens next."""

from __future__ import annotations

import os
import sys
import tempfile
import webbrowser
from html import escape
from math import inf
from pathlib import Path

import numpy as np

from . import _hardball
from ._arguments import path_text

_CONTACTS_OF_EACH_SPHERE = 10
_FEWEST_CONTACTS = 100
_CROSSINGS = 10  # of the box, by a sphere of the usual speed
_LONGEST = 1e100  # [T]
_HEIGHT = 600  # pixels, in a notebook


class View:
    """A page that shows a part of a simulation's history: a single HTML file that needs no server.

    As the result of a notebook cell, it is shown inline.
    """

    __slots__ = ("_page",)

    def __init__(self, page: bytes) -> None:
        self._page = page

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the page to a file, which any browser shows."""
        Path(path_text(path, "path")).write_bytes(self._page)

    def open(self) -> Path:
        """Opens the page in the browser, if there is one, and returns its temporary file."""
        with tempfile.NamedTemporaryFile(prefix="hardball-", suffix=".html", delete=False) as file:
            file.write(self._page)
        path = Path(file.name)
        if not (_has_display() and webbrowser.open(path.as_uri())):
            print(f"open {path} in a browser", file=sys.stderr)
        return path

    def __repr__(self) -> str:
        return f"<hardball.View of {len(self._page)} bytes>"

    def _repr_html_(self) -> str:
        page = escape(self._page.decode())
        style = f"width:100%;height:{_HEIGHT}px;border:0"
        return f'<iframe srcdoc="{page}" style="{style}" allowfullscreen></iframe>'


def view_of(simulation: _hardball.Simulation, until: float | None, contacts: int | None) -> View:
    """What happens next, up to these limits or usual ones."""
    if until is None and contacts is None:
        contacts = max(_FEWEST_CONTACTS, _CONTACTS_OF_EACH_SPHERE * len(simulation) // 2)
        until = simulation.time + _usual_span(simulation)
        if simulation.until is not None and simulation.until > simulation.time:
            until = min(until, simulation.until)
    with tempfile.TemporaryDirectory(prefix="hardball-") as folder:
        recording = os.path.join(folder, "recording.hbr")
        return View(simulation._replay(recording, inf if until is None else until, contacts))


def is_notebook() -> bool:
    """Whether results are shown as pages, as Jupyter does."""
    if "IPython" not in sys.modules:
        return False
    shell = sys.modules["IPython"].get_ipython()
    return hasattr(shell, "kernel")


# The time in which there is something to see, even if nothing ever touches [T].
def _usual_span(simulation: _hardball.Simulation) -> float:
    positions = simulation.positions
    if len(positions) == 0:
        return 1.0
    is_bounded = [boundary in ("wall", "periodic") for boundary in simulation.box.boundary]
    spread = np.ptp(positions, axis=0) + 2 * simulation.radii.max()
    extent = float(np.where(is_bounded, simulation.box.size, spread).max())
    speed = float(np.sqrt(np.mean(simulation.velocities**2) * simulation.box.dimensions))
    falling = float(np.sqrt(np.linalg.norm(simulation.gravity) * extent))
    fastest = max(speed, falling)
    return min(_CROSSINGS * extent / fastest, _LONGEST) if fastest > 0 else 1.0


def _has_display() -> bool:
    if not sys.platform.startswith("linux"):
        return True
    return any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER"))

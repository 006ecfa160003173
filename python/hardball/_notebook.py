# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The picture of a simulation in a notebook: the spheres and the certificate of the run."""

from __future__ import annotations

from html import escape

import numpy as np

from . import _hardball

_WIDTH = 320  # pixels
_MOST_SPHERES = 3000  # more are thinned out, evenly
_SLOW = np.array([49.0, 84.0, 160.0])  # colors of the slowest and the fastest sphere
_FAST = np.array([214.0, 82.0, 49.0])


def picture_of(simulation: _hardball.Simulation) -> str:
    """The spheres seen along z, the highest in front, colored by their speed, as SVG."""
    positions = simulation.positions
    radii = simulation.radii
    speeds = np.linalg.norm(simulation.velocities, axis=1)
    box = simulation.box
    if len(positions) == 0:
        return ""
    low = np.min(positions - radii[:, np.newaxis], axis=0)[:2]
    high = np.max(positions + radii[:, np.newaxis], axis=0)[:2]
    for axis in range(2):
        if box.boundary[axis] in ("wall", "periodic"):
            low[axis], high[axis] = 0, box.size[axis]
    scale = _WIDTH / max(high - low)
    width, height = scale * (high - low)
    shown = np.linspace(0, len(positions) - 1, min(len(positions), _MOST_SPHERES)).astype(int)
    shown = shown[np.argsort(positions[shown, 2], kind="stable")]
    fastest = max(speeds.max(), np.finfo(float).tiny)
    circles = []
    for sphere in shown:
        x, y = scale * (positions[sphere, :2] - low)
        red, green, blue = (_SLOW + (_FAST - _SLOW) * speeds[sphere] / fastest).astype(int)
        circles.append(
            f'<circle cx="{x:.2f}" cy="{height - y:.2f}" r="{max(scale * radii[sphere], 0.3):.2f}" '
            f'fill="rgb({red},{green},{blue})"/>'
        )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
        f'viewBox="0 0 {width:.2f} {height:.2f}" role="img" aria-label="spheres seen along z">'
        f'<rect width="100%" height="100%" fill="white" stroke="gray"/>'
        f'<g stroke="black" stroke-opacity="0.3" stroke-width="0.5">{"".join(circles)}</g></svg>'
    )


def html_of(simulation: _hardball.Simulation) -> str:
    """The picture beside the numbers."""
    certificate = simulation.certificate
    rows = {
        "spheres": f"{len(simulation)}",
        "time": f"{simulation.time:g}",
        "collisions": f"{certificate['collisions']}",
        "wall contacts": f"{certificate['wall_contacts']}",
        "energy": f"{certificate['energy']:.12g}",
        "energy at the start": f"{certificate['initial_energy']:.12g}",
        "deepest overlap, diameters": f"{certificate['max_overlap']:.2g}",
        "event log hash": certificate["event_log_hash"],
        "engine": simulation.engine,
    }
    table = "".join(
        f'<tr><th style="text-align:left">{escape(name)}</th><td style="text-align:left">{escape(text)}</td></tr>'
        for name, text in rows.items()
    )
    return (
        f'<div style="display:flex;gap:1em;align-items:flex-start">{picture_of(simulation)}'
        f"<table>{table}</table></div>"
    )

# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Plots of measures."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping

import numpy as np

from . import _hardball
from ._sweep import Sweep

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_PANEL = (5.0, 3.6)  # inches
_COLUMNS = 2


def plot(results: Mapping[str, _hardball.Measurement] | _hardball.Measurement | Sweep) -> Figure:
    """Draws measured functions with their errors and theories, as reports do: a panel for each.

    `results` is what Simulation.results returns, one Measurement, or a Sweep, of which each quantity is drawn. Returns a
    matplotlib Figure. Error: there is nothing to draw; ImportError: matplotlib is not installed.
    """
    try:
        from matplotlib.figure import Figure
    except ImportError as error:
        raise ImportError(
            "plot needs matplotlib, which is not installed: install it with 'pip install matplotlib'"
        ) from error

    if isinstance(results, Sweep):
        charts = results._charts
        remedy = "run members that finish, with several numbers for a key"
    else:
        measurements = [results] if isinstance(results, _hardball.Measurement) else list(results.values())
        charts = [chart for measurement in measurements for chart in _hardball._charts(measurement)]
        remedy = "run the simulation while it measures"
    if not charts:
        raise _hardball.Error(f"results: they have no functions to draw; {remedy}")
    columns = min(_COLUMNS, len(charts))
    rows = -(-len(charts) // columns)
    figure = Figure(figsize=(_PANEL[0] * columns, _PANEL[1] * rows), layout="constrained")
    for number, chart in enumerate(charts):
        _draw(figure.add_subplot(rows, columns, number + 1), chart)
    return figure


def _draw(axes: Any, chart: dict[str, Any]) -> None:
    color = 0
    for number, series in enumerate(chart["series"]):
        color += 1 if number > 0 and not series["like_previous"] else 0
        shown = f"C{color}"
        style = "--" if series["dashed"] else "-" if series["line"] else "none"
        line = {"color": shown, "linestyle": style, "label": series["name"] or None}
        has_errors = len(series["y_error"]) > 0
        if has_errors and not series["error_band"]:
            axes.errorbar(series["x"], series["y"], series["y_error"], marker=".", capsize=2, **line)
            continue
        axes.plot(series["x"], series["y"], marker="." if series["marks"] else "none", **line)
        if has_errors:
            error = np.nan_to_num(series["y_error"])
            axes.fill_between(series["x"], series["y"] - error, series["y"] + error, color=shown, alpha=0.25)
    axes.set_title(chart["title"])
    axes.set_xlabel(chart["x_label"])
    axes.set_ylabel(chart["y_label"])
    axes.set_xscale("log" if chart["x_logarithmic"] else "linear")
    axes.set_yscale("log" if chart["y_logarithmic"] else "linear")
    if any(series["name"] for series in chart["series"]):
        axes.legend(fontsize="small")

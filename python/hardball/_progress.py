# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""A progress bar for runs."""

from __future__ import annotations

from contextlib import contextmanager
from math import isfinite
from typing import Callable, Iterator


@contextmanager
def shown_progress(begin: float, until: float | None) -> Iterator[Callable[[float], object] | None]:
    """Shows a tqdm bar and yields the function that updates it; None if tqdm is missing."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        yield None
        return
    total = until - begin if until is not None and isfinite(until) and until > begin else None
    form = "{desc}{percentage:3.0f}%|{bar}| {n:.4g}/{total:.4g} [{elapsed}<{remaining}]" if total else None
    with tqdm(total=total, unit=" time units", bar_format=form) as bar:
        yield lambda time: bar.update(time - begin - bar.n)

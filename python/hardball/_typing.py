# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Types of arguments."""

from typing import Callable, Sequence, Union

from numpy.typing import ArrayLike

from ._hardball import (
    Andersen,
    Bounce,
    Contact,
    Heating,
    Merging,
    Outcome,
    Rescale,
    ResponseTable,
    TabulatedRestitution,
    ViscoelasticRestitution,
)

AnyBounce = Union[float, ViscoelasticRestitution, TabulatedRestitution, Bounce]
Response = Union[AnyBounce, Merging, ResponseTable, Callable[[Contact], Union[Outcome, Sequence[ArrayLike]]]]
Thermostat = Union[Andersen, Rescale, Heating]

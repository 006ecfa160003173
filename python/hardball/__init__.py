# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Every collision among many moving spheres, exactly and in order.

For example::

    import hardball
    simulation = hardball.Simulation(hardball.Box.periodic(10.0), positions=..., velocities=..., radius=0.5)
    simulation.run(until=100)

Lengths are in any unit [L], times in another [T], masses in a third [M]; all other units follow.
"""

from ._hardball import (
    Andersen,
    Bounce,
    Box,
    BrokenInvariant,
    Clearance,
    Contact,
    Error,
    Heating,
    Measurement,
    Merging,
    NextContact,
    Outcome,
    Quantity,
    RayHit,
    Rescale,
    ResponseTable,
    RunFailure,
    StepAttempt,
    StepPotential,
    StepTable,
    Surface,
    TabulatedRestitution,
    ViscoelasticRestitution,
    __version__,
    measure_names,
)
from ._calls import ArgumentError, explain_calls
from ._packing import Packing, PackingFailed, pack
from ._simulation import Simulation
from ._view import View

__all__ = [
    "Andersen",
    "ArgumentError",
    "Bounce",
    "Box",
    "BrokenInvariant",
    "Clearance",
    "Contact",
    "Error",
    "Heating",
    "Measurement",
    "Merging",
    "NextContact",
    "Outcome",
    "Packing",
    "PackingFailed",
    "Quantity",
    "RayHit",
    "Rescale",
    "ResponseTable",
    "RunFailure",
    "Simulation",
    "StepAttempt",
    "StepPotential",
    "StepTable",
    "Surface",
    "TabulatedRestitution",
    "View",
    "ViscoelasticRestitution",
    "measure_names",
    "pack",
    "__version__",
]

explain_calls(Simulation.__mro__[1])
for _name in __all__:
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = "hardball"
        explain_calls(globals()[_name])
del _name, explain_calls

# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Every collision among many moving spheres, exactly and in order.

For example::

    import hardball
    simulation = hardball.Simulation(hardball.Box.periodic(10.0), positions=..., velocities=..., radius=0.5)
    simulation.run(until=100)

Lengths are in any unit [L], times in another [T], masses in a third [M]; all other units follow.
"""

from ._requirements import require

require()

from ._attributes import refuse_unknown_attributes
from ._hardball import (
    Andersen,
    Bounce,
    Box,
    BrokenInvariant,
    Clearance,
    Contact,
    DrivenMotion,
    Error,
    FaceForces,
    Heating,
    JointTrajectory,
    Measurement,
    Merging,
    Mesh,
    Motion,
    NextContact,
    Obstacles,
    Outcome,
    Processes,
    Quantity,
    RayHit,
    Rescale,
    ResponseTable,
    Robot,
    RobotContact,
    RunFailure,
    StepAttempt,
    StepPotential,
    StepTable,
    Surface,
    TabulatedRestitution,
    ViscoelasticRestitution,
    __version__,
    first_contact,
    first_contacts,
    least_clearance,
    least_clearances,
    measure_names,
    mpi_processes,
    read_spheres,
)
from ._calls import ArgumentError, explain_calls, explained
from ._commands import Check, Tuning, Verification, VerifiedRun, check, convert, info, tune, verify
from ._frames import Frame, Recording, Trajectory, read
from ._live import LiveView
from ._output import Output
from ._packing import Packing, PackingFailed, pack
from ._plots import plot
from ._replica_exchange import ReplicaExchange
from ._robots import read_joints
from ._scenario import scenarios
from ._simulation import Simulation
from ._sweep import Sweep, sweep
from ._view import View

__all__ = [
    "Andersen",
    "ArgumentError",
    "Bounce",
    "Box",
    "BrokenInvariant",
    "Check",
    "Clearance",
    "Contact",
    "DrivenMotion",
    "Error",
    "FaceForces",
    "Frame",
    "Heating",
    "JointTrajectory",
    "LiveView",
    "Measurement",
    "Merging",
    "Mesh",
    "Motion",
    "NextContact",
    "Obstacles",
    "Outcome",
    "Output",
    "Packing",
    "PackingFailed",
    "Processes",
    "Quantity",
    "RayHit",
    "Recording",
    "ReplicaExchange",
    "Rescale",
    "ResponseTable",
    "Robot",
    "RobotContact",
    "RunFailure",
    "Simulation",
    "StepAttempt",
    "StepPotential",
    "StepTable",
    "Surface",
    "Sweep",
    "TabulatedRestitution",
    "Trajectory",
    "Tuning",
    "Verification",
    "VerifiedRun",
    "View",
    "ViscoelasticRestitution",
    "check",
    "convert",
    "first_contact",
    "first_contacts",
    "info",
    "least_clearance",
    "least_clearances",
    "measure_names",
    "mpi_processes",
    "pack",
    "plot",
    "read",
    "read_joints",
    "read_spheres",
    "scenarios",
    "sweep",
    "tune",
    "verify",
    "__version__",
]

for _base in (Simulation, Packing, Frame):
    explain_calls(_base.__mro__[1])
for _name in __all__:
    _entity = globals()[_name]
    if isinstance(_entity, type):
        _entity.__module__ = "hardball"
        explain_calls(_entity)
        if not issubclass(_entity, BaseException):
            refuse_unknown_attributes(_entity)
    elif callable(_entity):
        globals()[_name] = explained(_entity, _name)
del _base, _entity, _name, explain_calls, explained, refuse_unknown_attributes, require

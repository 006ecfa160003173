# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""An arm among balls: which of many ways to its goal are free? With the name of a file, draws the widest one."""

import math
import sys

import matplotlib.pyplot as plt
import numpy as np
from numpy.typing import NDArray

import hardball

random = np.random.default_rng(5)
JOINTS, LINK = 4, 0.5
robot = hardball.Robot.from_spheres(
    links={f"link {k}": [[x, 0, 0, 0.07] for x in np.linspace(0.1, LINK, 5)] for k in range(JOINTS)},
    joints=[
        {"name": f"joint {k}", "parent": f"link {k - 1}" if k else "base", "child": f"link {k}", "origin": [LINK if k else 0, 0, 0]}
        for k in range(JOINTS)
    ],
)
# Balls in the plane of the arm, none at its foot.
balls = [at for at in random.uniform(-2, 2, (60, 2)) if 0.6 < math.hypot(*at) and (at[0] < 0 or abs(at[1]) > 0.4)][:12]
obstacles = hardball.Obstacles()
obstacles.add_spheres([[x, y, 0] for x, y in balls], 0.1)

START, GOAL = np.zeros(JOINTS), np.array([2.0, 0.3, -0.4, 0.3])
middles = [0.5 * GOAL + random.normal(0, 0.7, JOINTS) for _ in range(2000)]
ways = [hardball.JointTrajectory.cubic([0, 1, 2], [START, middle, GOAL], ends="clamped") for middle in middles]
contacts = hardball.first_contacts(robot, ways, obstacles)
free = [k for k, contact in enumerate(contacts) if contact is None]
touched = [contact.time for contact in contacts if contact is not None]
print(f"{len(free)} of {len(ways)} ways are free; the others touch something after {np.mean(touched):.2f} s on average")
nearest = [hardball.least_clearance(robot, ways[k], obstacles) for k in free]
clearances = [contact.distance if contact else math.inf for contact in nearest]
widest = free[int(np.argmax(clearances))]
print(f"the widest keeps {max(clearances):.4f} m from everything")


def elbows(angles: NDArray[np.float64]) -> NDArray[np.float64]:
    turned = np.cumsum(angles)
    return np.concatenate([[[0, 0]], np.cumsum(LINK * np.stack([np.cos(turned), np.sin(turned)], axis=1), axis=0)])


if len(sys.argv) > 1:
    figure, axes = plt.subplots(figsize=(5, 5), layout="tight")
    for time in np.linspace(0, 2, 25):
        axes.plot(*elbows(ways[widest].coordinates_at(time)).T, color=plt.get_cmap("viridis")(time / 2), linewidth=1)
    for x, y in balls:
        axes.add_patch(plt.Circle((x, y), 0.1, color="black"))
    axes.set(aspect="equal", xlim=(-2.1, 2.1), ylim=(-2.1, 2.1))
    figure.savefig(sys.argv[1])

# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Shows grains that cool and gather while they are simulated. With the name of a file, saves the picture after 40 frames."""

import sys

import matplotlib.pyplot as plt

import hardball

simulation = hardball.Simulation.gas(300, packing_fraction=0.25, dimensions=2, seed=1)
simulation.response = 0.85
edge = simulation.box.size[0]

figure, (left, right) = plt.subplots(1, 2, figsize=(8, 4), layout="tight")
# The size of a marker is its diameter in points, squared.
(grains,) = left.plot([], [], "o", markersize=3)
left.set(aspect="equal", xlim=(0, edge), ylim=(0, edge), xticks=[], yticks=[])
(curve,) = right.loglog([], [])
right.set(xlabel="time", ylabel="kT")

print("time  collisions     kT")
times: list[float] = []
temperatures: list[float] = []
collisions = 0
for frame in range(1, 41 if len(sys.argv) > 1 else 401):
    collisions += simulation.run(until=0.5 * frame)
    times.append(simulation.time)
    temperatures.append(simulation.temperature)
    grains.set_data(simulation.positions[:, 0], simulation.positions[:, 1])
    curve.set_data(times, temperatures)
    right.relim()
    right.autoscale_view()
    plt.pause(0.001)
    if frame % 10 == 0:
        print(f"{times[-1]:4.0f}  {collisions:10}  {temperatures[-1]:.3f}")

if len(sys.argv) > 1:
    figure.savefig(sys.argv[1])
else:
    plt.show()

# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The equation of state of hard spheres by a sweep: four runs of each density, which a second call would not repeat."""

import sys

import hardball

SCENARIO = {
    "box": {"packing_fraction": 0.1, "boundary": ["periodic"] * 3},
    "spheres": [{"count": 500, "radius": 0.5, "placement": "random", "temperature": 1.0}],
    "run": {"until": 40.0},
    "measures": {"names": ["pressure"], "from": 2.0},
}
STUDY = {
    "scenario": SCENARIO,
    "seed": 1,
    "quantities": ["pressure.compressibility"],
    "sweep": {"replicas": 4, "product": {"box.packing_fraction": {"from": 0.05, "to": 0.35, "count": 7}}},
}


def carnahan_starling(packing_fraction: float) -> float:
    x = packing_fraction
    return float((1 + x + x**2 - x**3) / (1 - x) ** 3)


# The directory has all runs; any executor may carry them out.
found = hardball.sweep(STUDY, out="equation_of_state")

print("packing fraction  PV/NkT  between  within  Carnahan-Starling")
for point in found.points:
    fraction, z = point["box.packing_fraction"], point["pressure.compressibility"]
    between, within = (point[f"pressure.compressibility_error_{kind}"] for kind in ("between", "within"))
    print(f"{fraction:16.2f}  {z:6.3f}  {between:7.4f}  {within:6.4f}  {carnahan_starling(fraction):17.3f}")

if len(sys.argv) > 1:
    hardball.plot(found).savefig(sys.argv[1])

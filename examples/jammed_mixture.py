# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Packs spheres of two sizes until they jam, and writes them to a data file of LAMMPS: mixture.data."""

import hardball

# Two small spheres for each large one; sizes are relative to the mean diameter.
packing = hardball.pack(150, sizes="discrete:1=2,1.4=1", phi="max", rate=0.1, seed=1)
packing.write("mixture.data")

print(f"packing fraction {packing.phi:.4f}, {packing.isostaticity:.3f} of the contacts that rigidity needs")
print("diameter  spheres  rattlers  contacts of each")
frame = hardball.read("mixture.data")[0]
ends = [*packing.contacts["i"], *packing.contacts["j"]]
for radius in sorted(set(frame.radii)):
    members = [k for k in range(len(frame)) if frame.radii[k] == radius]
    rattlers = sum(packing.rattlers[k] for k in members)
    contacts = sum(ends.count(k) for k in members) / (len(members) - rattlers)
    print(f"{2 * radius:8.4f}  {len(members):7}  {rattlers:8}  {contacts:16.2f}")

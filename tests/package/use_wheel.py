# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Uses all that a wheel brings: module, program, page of the viewer, scenarios. Run in the environment that has it."""

import json
import re
import shutil
import signal
import subprocess
import sys
import urllib.request
from pathlib import Path

import numpy as np

import hardball

PREFIX = Path(sys.prefix)
PROGRAM = PREFIX / "bin" / "hardball"


def printed(*command):
    return subprocess.run(list(map(str, command)), check=True, capture_output=True, text=True).stdout


def refused(*command):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    assert done.returncode == 2, done
    return done.stderr


# Nothing else of ours may be in the way.
assert PREFIX in Path(hardball.__file__).parents, hardball.__file__
assert Path(shutil.which("hardball")) == PROGRAM

print("-- the module")
places = np.stack(np.meshgrid(*[np.arange(6) * 1.5 + 0.75] * 3), axis=-1).reshape(-1, 3)
velocities = np.random.default_rng(1).normal(size=places.shape)
simulation = hardball.Simulation(hardball.Box.periodic(9.0), positions=places, velocities=velocities, radius=0.5)
simulation.measure("pressure")
simulation.run(until=2.0)
assert simulation.results()["pressure"]["compressibility"].value > 1
view = simulation.view()
view.save("view.html")
assert "<canvas" in Path("view.html").read_text() and Path("view.html").stat().st_size > 500_000
try:
    hardball.pack(60, phi="max", polish=True)
    raise AssertionError("this wheel has COIN-OR CLP")
except hardball.Error as error:
    assert "HARDBALL_POLISH=ON" in str(error), error

print("-- the program")
assert printed("hardball", "--version") == printed(sys.executable, "-m", "hardball", "--version")
assert hardball.__version__ in printed("hardball", "--version")
cradle = hardball.scenarios() / "newtons_cradle.toml"
run = json.loads(printed("hardball", "run", cradle, "--json", "--quiet", "--out", "out"))
same = hardball.Simulation.from_scenario(cradle)
same.run()
assert run["event_log_hash"] == same.event_log_hash, (run["event_log_hash"], same.event_log_hash)
assert Path("out/report.html").is_file()
assert "all runs are the same" in printed("hardball", "verify", cradle)
assert "HARDBALL_POLISH=ON" in refused("hardball", "pack", "--count", 60, "--phi", "max", "--polish")

print("-- the viewer")
with subprocess.Popen(["hardball", "view", cradle, "--no-open"], stdout=subprocess.PIPE, text=True) as viewer:
    try:
        address = viewer.stdout.readline().strip()
        with urllib.request.urlopen(address) as answer:
            assert "<canvas" in answer.read().decode()
    finally:
        viewer.send_signal(signal.SIGINT)
    assert viewer.wait(60) == 0

print("-- all scenarios")
for scenario in sorted(hardball.scenarios().glob("*.toml")):
    assert hardball.check(scenario)["spheres"] > 0, scenario
json.loads((hardball.scenarios() / "scenario.schema.json").read_text())
version = re.sub(r"\n", " ", printed("hardball", "--version"))
print("--", version, "with NumPy", np.__version__, "in Python", sys.version.split()[0])

# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Everything public is documented and typed."""

import contextlib
import inspect
import io
import math
import os
import re
import subprocess
import sys
import tempfile
import textwrap
import unittest
from pathlib import Path
from unittest import mock

import hardball
from support import ROOT, gas


class Documentation(unittest.TestCase):
    def test_everything_public_has_a_docstring(self):
        # Of what a name says, the docstring has nothing to add.
        plain = {"Quantity.value", "Surface.name"}
        for name in hardball.__all__:
            entity = getattr(hardball, name)
            if isinstance(entity, str):
                continue
            self.assertTrue(entity.__doc__, name)
            if not inspect.isclass(entity):
                continue
            for member, value in vars(entity).items():
                text = inspect.getdoc(value) or ""
                if member.startswith("_") or f"{name}.{member}" in plain or issubclass(entity, Exception):
                    continue
                # What pybind11 itself writes is the signature.
                said = [line for line in text.splitlines() if line and "->" not in line]
                self.assertTrue(said, f"{name}.{member}")

    def test_everything_public_is_on_the_page_of_reference(self):
        page = (ROOT / "docs/site/python_reference.md").read_text()
        shown = re.findall(r"^\.\. auto\w+:: hardball\.(\w+)$", page, re.MULTILINE)
        self.assertEqual(sorted(shown), sorted(set(hardball.__all__) - {"__version__"}))

    def test_stubs_are_true(self):
        command = [sys.executable, "-m", "mypy.stubtest", "hardball._hardball"]
        options = ["--allowlist", ROOT / "python/tests/allowed_differences.txt"]
        options += ["--ignore-unused-allowlist", "--mypy-config-file", ROOT / "pyproject.toml"]
        done = subprocess.run(command + options, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_signatures_name_types(self):
        stub = Path(hardball.__file__).with_name("_hardball.pyi").read_text()
        self.assertNotRegex(stub, r"def (?!_[a-z])\w+\(.*: object\b")

    def test_types_are_sound(self):
        calls = """import hardball
            hardball.Box.walls([1, 2, 3], faces={"z_min": {"temperature": 2}})
            hardball.Packing(hardball.pack(9)).write("packing.xyz")
            hardball.Simulation(hardball.Box.open(), positions=[], processes=None).next_event()
            hardball.StepPotential(((1.5, -1),))
            simulation = hardball.Simulation.gas(100, packing_fraction=0.2)
            simulation.velocities = 2 * simulation.velocities
            simulation.thermostat = hardball.Heating(1.0, 0.1)
            simulation.response = 0.9
            simulation.set_user_data([1, 2], 4)
            rays = simulation.rays([1, 1, 1], [[1, 0, 0], [0, 1, 0]], 5, threads=2, groups=4, walls=False)
            print(rays["distance"].min(), simulation.overlap([1, 1, 1], 2, species=[0, 1]) + 1, simulation.user_data[0])
            print([hit.body for hit in simulation.ray_hits([1, 1, 1], [1, 0, 0], 5, species=1)])
            with simulation.output("out", trajectory=["xyz"], snapshots_every=1) as output:
                print(output.directory)
            frames = hardball.read("out/trajectory.xyz")
            print(frames[::2][-1].positions[0, 0], frames[0].to_frame(), frames.path)
            print(hardball.check("a.toml")["spheres"], hardball.tune({}).best, hardball.verify("a.toml")[0].collisions)
            robot = hardball.Robot.from_spheres({"a": [[0, 0, 0, 1]]}, hardball.read_joints("a.urdf"), [("a", "b")])
            contact = hardball.first_contact(robot, hardball.JointTrajectory.linear([0, 1], [[0], [1]]), hardball.Obstacles())
            print(None if contact is None else contact.obstacle, len(hardball.read_spheres("a.yml")[1]))
            hardball.plot(simulation.results())"""
        for checked in (["-p", "hardball"], ["-c", textwrap.dedent("            " + calls)]):
            command = [sys.executable, "-B", "-m", "mypy", "--config-file", ROOT / "pyproject.toml", *checked]
            done = subprocess.run(command, capture_output=True, text=True, cwd=Path(hardball.__file__).parents[1])
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def run_page(self, page):
        """Runs the examples of a page, one after the other, and returns what they print."""
        examples = re.findall(r"^```python\n(.*?)^```", (ROOT / page).read_text(), re.DOTALL | re.MULTILINE)
        self.assertTrue(examples)
        names = {}
        with contextlib.ExitStack() as stack:
            folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
            (folder / "scenarios").symlink_to(ROOT / "scenarios")
            stack.enter_context(mock.patch("tempfile.tempdir", str(folder)))
            stack.enter_context(mock.patch("webbrowser.open"))
            stack.callback(os.chdir, os.getcwd())
            os.chdir(folder)
            stack.enter_context(contextlib.redirect_stderr(io.StringIO()))
            printed = stack.enter_context(contextlib.redirect_stdout(io.StringIO()))
            for example in examples:
                exec(compile(example, page, "exec"), names)
        return printed.getvalue()

    def test_the_example_of_the_readme_runs(self):
        printed = self.run_page("README.md")
        # Within five standard errors of the theory.
        value, error, theory = map(float, re.search(r": (\S+) \+- (\S+), theory (\S+)>", printed).groups())
        self.assertLess(abs(value - theory), 5 * error)
        self.assertLess(error, 0.05)

    def test_the_examples_of_the_documentation_run(self):
        for page in ("docs/python.md", "docs/python_how_to.md", "docs/robots.md"):
            with self.subTest(page):
                self.run_page(page)

    def test_texts_show_what_objects_are_made_of(self):
        for text in (
            "hardball.Bounce(0.9)",
            "hardball.Bounce(0.9, elastic_below=0.01, contact_duration=0.001, tangential_restitution=-0.5)",
            "hardball.Bounce(hardball.TabulatedRestitution([1, 2], [0.9, 0.8]))",
            "hardball.Merging()",
            "hardball.TabulatedRestitution([1], [0.5])",
            "hardball.Andersen(temperature=2, rate=0.5)",
            "hardball.Rescale(temperature=2, every=0.5)",
            "hardball.Heating(strength=2, every=0.5)",
            "hardball.Box(('wall', 'periodic', 'open'), [3, 4, 0])",
            "hardball.Surface.plane([0, 0, 1])",
            "hardball.Surface.plane([1, 0, 0], point=[1, 2, 3], velocity=[0, 0, -1], restitution=0.5)",
            "hardball.Surface.plane([0, 0, 1], amplitude=0.5, frequency=2, temperature=1.5, seed=7)",
            "hardball.Surface.cylinder([0, 0, 1], 2, point=[1, 1, 0])",
            "hardball.Surface.cone([0, 0, 1], 0.5, point=[1, 1, 0])",
            "hardball.Surface.sphere(5.5)",
            "hardball.Surface.obstacle(0.5, velocity=[1, 0, 0])",
        ):
            self.assertEqual(repr(eval(text)), text)
        law = hardball.ViscoelasticRestitution(0.7, speed=2.5)
        self.assertEqual(repr(law), "hardball.ViscoelasticRestitution(0.7, speed=2.5)")
        self.assertAlmostEqual(eval(repr(law)).at(1.0), law.at(1.0), places=14)
        table = hardball.ResponseTable(0.9, hardball.Bounce(0.8))
        self.assertEqual(repr(table), "<hardball.ResponseTable(hardball.Bounce(0.9), hardball.Bounce(0.8))>")
        table.set(0, 2, hardball.Merging())
        table.set_wall(1, 0.5)
        self.assertIn("; species 0 and 2: hardball.Merging(); species 1 and walls: hardball.Bounce(0.5)>", repr(table))
        contact = gas().contacts_within(1, most=1)[0]
        self.assertRegex(repr(hardball.Outcome(contact, contact.before, merges=True)), r"velocities=\[\[.*merges=True")

    def test_texts_of_measurements_show_values_with_errors(self):
        simulation = gas()
        simulation.measure(["pressure", "temperature"])
        simulation.run(until=20)
        results = simulation.results()
        compressibility = results["pressure"]["compressibility"]
        text = repr(results["pressure"])
        self.assertTrue(text.startswith("<hardball.Measurement: Pressure\n  compressibility: "))
        value, error = re.search(r"compressibility: (\S+) \+- (\S+), theory \S+\n", text).groups()
        self.assertLess(abs(float(value) - compressibility.value), 0.1 * compressibility.error)
        self.assertLess(abs(float(error) - compressibility.error), 0.05 * compressibility.error)
        # Both end at the second digit of the error; zeros at the end are not written.
        decimals = 1 - math.floor(math.log10(float(error)))
        self.assertEqual(f"{float(value):.{decimals}f}".rstrip("0"), value.rstrip("0"))
        self.assertIn(" M L^-1 T^-2", text)
        self.assertRegex(text, r"\d+ rows of time, compressibility, pressure>$")
        # Without any result at all, numbers are nan, of no sign.
        empty = gas()
        empty.measure("all")
        empty.run(until=1e-9)
        for result in empty.results().values():
            self.assertNotIn("-nan", repr(result))
            for quantity in result.quantities.values():
                self.assertNotIn("-nan", repr(quantity))

    def test_pictures(self):
        simulation = gas()
        self.assertIn("125 spheres", repr(simulation))
        html = simulation._repr_html_()
        self.assertEqual(html.count("<circle"), 125)
        self.assertIn(simulation.event_log_hash, html)
        self.assertIn("0", hardball.Simulation(hardball.Box.open(), positions=[])._repr_html_())


if __name__ == "__main__":
    unittest.main()

# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""What is wrong is refused, with what, where and the remedy."""

import subprocess
import sys
import unittest

import hardball
from support import gas


class Arguments(unittest.TestCase):
    def refused(self, call, *words):
        with self.assertRaises(hardball.Error) as raised:
            call()
        for word in words:
            self.assertIn(word, str(raised.exception))

    def test_of_pack(self):
        for options, words in (
            ({"radius": 1}, ["pack: unknown argument radius=", "diameter"]),
            ({"phi": 2}, ["2 of the volume", "give a packing fraction"]),
            ({"phi": "most"}, ["phi: 'most'", "give"]),
            ({"sizes": ("lognormal", "wide")}, ["sizes: ", "give a number"]),
            ({"sizes": ["a", "b"], "count": None}, ["sizes: ", "list of numbers"]),
            ({"box": object()}, ["box: ", "list of numbers"]),
            ({"walls": 5}, ["walls: it is 5", "'z'"]),
            ({"container": 5}, ["container: it is 5", "cylinder"]),
            ({"start": 5}, ["start: it is 5", "path"]),
            ({"polish": "yes"}, ["polish: it is 'yes'", "True or False"]),
            ({"limit": -1}, ["limit: it is -1", "not negative"]),
            ({"limit": float("nan")}, ["limit: it is nan", "not negative"]),
        ):
            arguments = {"count": 10, **({} if "phi" in options else {"phi": 0.3}), **options}
            self.refused(lambda: hardball.pack(**arguments), *words)
        self.refused(lambda: hardball.pack(10, 20, phi=0.3), "too many positional arguments", "it takes (count=None, *,")
        packing = hardball.pack(10, phi=0.3)
        self.refused(lambda: packing.write(3), "Packing.write", "os.PathLike")
        self.refused(lambda: packing.simulation(temperature=-1), "temperature: it is -1", "not negative")

    def test_numbers_that_belong_in_a_list(self):
        for call, remedy in (
            (lambda: hardball.Box.walls(10, 10, 10), "as in hardball.Box.walls([10, 10, 10])"),
            (lambda: hardball.Box.flat_periodic(10, 12.5), "as in hardball.Box.flat_periodic([10, 12.5])"),
            (lambda: hardball.Box(["wall"] * 3, 4, 5, 6), "one list: [4, 5, 6]"),
        ):
            self.refused(call, "give them as one list", remedy)
        self.refused(lambda: gas().clearance(1, 2, 3), "give them as one list, as in clearance([1, 2, 3])")
        self.refused(lambda: hardball.Andersen(1, 1, 1), "Andersen: these arguments do not fit; it takes (temperature")

    def test_that_are_missing_or_no_paths(self):
        self.refused(lambda: hardball.Simulation(hardball.Box.open()), "missing a required argument: 'positions'", "it takes (box,")
        self.refused(lambda: hardball.measure_names(3), "measure_names: ")
        simulation = gas()
        for call in (
            lambda: simulation.save(3),
            lambda: hardball.Simulation.load(3),
            lambda: hardball.Simulation.from_scenario(3),
            lambda: hardball.Simulation.from_file(3),
            lambda: hardball.View(b"").save(3),
        ):
            self.refused(call, "it is 3; give the path of a file")

    def test_of_measurements(self):
        simulation = gas()
        simulation.measure("pressure")
        simulation.run(collisions=1000)
        measurement = simulation.results()["pressure"]
        self.assertIn("compressibility", measurement)
        self.assertNotIn("compresibility", measurement)
        with self.assertRaisesRegex(KeyError, "no quantity or column compresibility; choose among .*compressibility"):
            measurement["compresibility"]

    def test_errors_inside_are_not_taken_for_those_of_the_call(self):
        def response(contact):
            raise TypeError("of the response")

        with self.assertRaisesRegex(TypeError, "of the response") as raised:
            gas(response=response).run(collisions=1)
        self.assertNotIsInstance(raised.exception, hardball.Error)


class Attributes(unittest.TestCase):
    def refused(self, entity, name, *words):
        with self.assertRaises(AttributeError) as raised:
            setattr(entity, name, 3)
        for word in words:
            self.assertIn(word, str(raised.exception))

    def test_that_do_not_exist_are_refused_by_all_objects(self):
        simulation = gas()
        simulation.measure("pressure")
        simulation.run(collisions=100)
        measurement = simulation.results()["pressure"]
        entities = [
            simulation,
            hardball.Andersen(1, 1),
            hardball.Bounce(),
            hardball.Box.open(),
            next(simulation.events()),
            hardball.Heating(1, 1),
            measurement,
            measurement["compressibility"],
            hardball.Merging(),
            simulation.first_contact(0, [1, 0, 0], simulation.time + 1e9),
            hardball.pack(10, phi=0.3),
            hardball.Rescale(1, 1),
            hardball.ResponseTable(),
            hardball.StepPotential([(1.5, -1)]),
            hardball.StepTable(),
            hardball.Surface.sphere(1.0),
            hardball.TabulatedRestitution([1, 2], [0.5, 0.6]),
            hardball.View(b""),
            hardball.ViscoelasticRestitution(0.8, 1.0),
        ]
        for entity in entities:
            self.refused(entity, "raduis", f"hardball.{type(entity).__name__} has no attribute raduis")
        classes = [entity for entity in map(vars(hardball).get, hardball.__all__) if isinstance(entity, type)]
        for kind in classes:
            if not issubclass(kind, BaseException):
                self.assertEqual(kind.__setattr__.__module__, "hardball._attributes", kind)

    def test_come_with_the_remedy(self):
        self.refused(gas(), "tempreture", "hardball.Simulation has no attribute tempreture; did you mean temperature?")
        self.refused(hardball.pack(10, phi=0.3), "raddi", "did you mean radii?")
        self.refused(hardball.Andersen(1, 1), "xyz", "it has rate, temperature")
        self.refused(gas(), "time", "hardball.Simulation.time is read-only")
        self.refused(gas(), "run", "hardball.Simulation.run is a method")

    def test_that_exist_are_set(self):
        simulation = gas()
        simulation.until = 3.0
        self.assertEqual(simulation.until, 3.0)


class Imports(unittest.TestCase):
    def test_without_numpy_say_how_to_install_it(self):
        code = "import sys; sys.modules['numpy'] = None; import hardball"
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        last = done.stderr.strip().splitlines()[-1]
        self.assertRegex(last, r"^ImportError: hardball needs NumPy, .* -m pip install numpy'")

    def test_of_another_python_say_so(self):
        code = "import sys; sys.modules['hardball._hardball'] = None; import hardball"
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        self.assertRegex(done.stderr, r"ImportError: the part of hardball in C\+\+ is not built for .*\./dev python")


if __name__ == "__main__":
    unittest.main()

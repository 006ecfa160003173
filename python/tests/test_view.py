# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The page that shows how a simulation continues."""

import base64
import contextlib
import io
import json
import os
import re
import sys
import tempfile
import unittest
from html import unescape
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import numpy as np

import hardball
from hardball._view import view_of
from support import gas


def recording_in(page):
    """The header of the recording in a page, and its bytes."""
    element = re.search(r'<script type="application/octet-stream" id="recording">([^<]*)</script>', page)
    data = base64.b64decode(element[1])
    length = int.from_bytes(data[8:12], "little")
    return {**json.loads(data[12 : 12 + length]), "version": int(data[5:8])}, data[12 + length :]


def recorded(simulation, until=None, contacts=None):
    """The header, and of all contacts time, first and second."""
    header, data = recording_in(view_of(simulation, until, contacts)._page.decode())
    count, has_bodies = header["spheres"], header["bodies"]
    found = []
    at = 16 * count + 8
    while at < len(data):
        number = int.from_bytes(data[at + 4 : at + 8], "little")
        width = 168 if has_bodies else 112
        begin = at + 40 + (136 if has_bodies else 56) * count
        rows = np.frombuffer(data, "u1", number * width, begin).reshape(number, width)
        times = rows[:, :8].copy().view("f8")[:, 0]
        ids = rows[:, 8:16].copy().view("i4")
        found += list(zip(times.tolist(), *ids.T.tolist()))
        at = begin + number * width + 8
    return header, found


def history(simulation, **limits):
    """The contacts of a run of a copy, with the numbers of walls as recordings have them."""
    events = simulation.__copy__().run(record=True, **limits)
    seconds = [int(e["second"]) if e["kind"] == 0 else -int(e["second"]) - 1 for e in events]
    return list(zip(events["time"].tolist(), events["first"].tolist(), seconds))


@contextlib.contextmanager
def browser(**environment):
    """A desktop, and the addresses that are opened there."""
    names = {"DISPLAY": "", "WAYLAND_DISPLAY": "", "BROWSER": "", **environment}
    with mock.patch.dict(os.environ, names), mock.patch("webbrowser.open", return_value=True) as opened:
        yield opened


class Views(unittest.TestCase):
    def test_shows_what_a_run_would_do(self):
        simulation = gas(box=hardball.Box.walls(8.0))
        simulation.run(until=0.5)
        before = simulation.event_log_hash
        header, found = recorded(simulation, until=2.0)
        self.assertEqual(found, history(simulation, until=2.0))
        self.assertGreater(len(found), 100)
        self.assertTrue(any(second < 0 for _, _, second in found))
        self.assertEqual((header["spheres"], header["begin"], header["until"]), (125, 0.5, 2.0))
        self.assertEqual((simulation.time, simulation.event_log_hash), (0.5, before))

    def test_limits(self):
        simulation = gas()
        self.assertEqual(len(recorded(simulation, contacts=17)[1]), 17)
        self.assertEqual(len(recorded(simulation, until=1e-9)[1]), 0)
        self.assertEqual(len(recorded(simulation)[1]), 625)
        simulation.until = 0.25
        header, found = recorded(simulation)
        self.assertEqual(found, history(simulation, until=0.25))
        self.assertEqual(header["until"], 0.25)
        simulation.run(until=0.25)
        self.assertEqual(len(recorded(simulation)[1]), 625)
        with self.assertRaisesRegex(hardball.Error, "0.125 is in the past; the time is 0.25"):
            simulation.view(until=0.125)

    def test_of_what_never_meets_ends(self):
        alone = {"positions": [[1, 2, 3]], "radius": 0.5}
        for box in (hardball.Box.open(), hardball.Box.periodic(10.0), hardball.Box.walls(10.0)):
            for more in ({}, {"velocities": [1, 0, 0]}, {"gravity": [0, 0, -1]} if box != hardball.Box.periodic(10.0) else {}):
                header, _ = recorded(hardball.Simulation(box, **alone, **more))
                self.assertTrue(0 < header["until"] < 1e4, header["until"])
        self.assertEqual(recorded(hardball.Simulation(hardball.Box.open(), positions=np.zeros((0, 3))))[0]["spheres"], 0)

    def test_of_spheres_that_have_merged_or_been_removed(self):
        simulation = gas(response=hardball.Merging())
        simulation.run(collisions=20)
        simulation.remove(int(simulation.ids[0]))
        header, found = recorded(simulation, contacts=30)
        self.assertEqual((header["bodies"], header["spheres"]), (True, int(simulation.ids[-1]) + 1))
        self.assertEqual(found, history(simulation, contacts=30))

    def test_of_a_response_in_python(self):
        calls = []

        def reversal(contact):
            calls.append(contact.time)
            first, second = contact.before
            return (-first, -second)

        simulation = gas(response=reversal)
        self.assertEqual(recorded(simulation, contacts=40)[1], history(simulation, contacts=40))
        self.assertGreaterEqual(len(calls), 80)

    def test_of_a_thermostat_has_its_changes(self):
        simulation = gas(thermostat=hardball.Andersen(1.0, rate=5.0))
        _, found = recorded(simulation, until=0.5)
        changes = [first for _, first, second in found if first == second]
        self.assertTrue(200 < len(changes) < 450, len(changes))
        self.assertEqual([event for event in found if event[1] != event[2]], history(simulation, until=0.5))

    def test_listeners_are_not_called(self):
        simulation = gas()
        simulation.on_contact(lambda contact: self.fail("called"))
        recorded(simulation, contacts=10)

    def test_errors_leave_the_simulation_as_it_was(self):
        simulation = gas(response=lambda contact: (contact.before[0] * np.nan, contact.before[1]))
        with self.assertRaises(hardball.Error):
            view_of(simulation, None, 10)
        self.assertEqual(simulation.collisions, 0)
        simulation.respond_with(1.0)
        simulation.run(collisions=10)

    def test_a_recording_too_large_for_browsers_is_refused(self):
        with self.assertRaisesRegex(hardball.Error, "has more than 200000000 bytes.*earlier time or fewer contacts"):
            view_of(gas(), None, 10**9)

    def test_opens_the_browser(self):
        simulation = gas()
        with browser(DISPLAY=":0") as opened:
            page = simulation.view(contacts=10)
        (address,) = opened.call_args.args
        path = Path(address.removeprefix("file://"))
        self.addCleanup(path.unlink)
        self.assertEqual(path.read_bytes(), page._page)
        with tempfile.TemporaryDirectory() as folder:
            page.save(Path(folder) / "page.html")
            self.assertEqual((Path(folder) / "page.html").read_bytes(), page._page)

    @unittest.skipUnless(sys.platform.startswith("linux"), "elsewhere there is always a display")
    def test_names_the_file_where_there_is_no_display(self):
        with browser() as opened, contextlib.redirect_stderr(io.StringIO()) as messages:
            gas().view(contacts=10)
        opened.assert_not_called()
        path = Path(re.search(r"open (\S+\.html) in a browser", messages.getvalue())[1])
        self.addCleanup(path.unlink)
        self.assertTrue(path.read_bytes().startswith(b"<!"))

    def test_is_inline_in_a_notebook(self):
        shell = SimpleNamespace(kernel=object())
        notebook = SimpleNamespace(get_ipython=lambda: shell)
        with mock.patch.dict(sys.modules, IPython=notebook), browser(DISPLAY=":0") as opened:
            page = gas().view(contacts=10)
        opened.assert_not_called()
        frame = re.fullmatch(r'<iframe srcdoc="([^"]*)"[^>]*></iframe>', page._repr_html_())
        self.assertEqual(unescape(frame[1]).encode(), page._page)


if __name__ == "__main__":
    unittest.main()

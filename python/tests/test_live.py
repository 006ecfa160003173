# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""The view of a simulation in a notebook that follows its runs, with a stand-in for anywidget."""

import sys
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import numpy as np

import hardball
from support import gas


class StandIn:
    """Keeps what is sent."""

    def __init__(self):
        self.sent = []
        self.hears = None

    def send(self, message, buffers=()):
        self.sent.append((message, [bytes(each) for each in buffers]))

    def on_msg(self, answer):
        self.hears = answer

    def of(self, what):
        return [each for each in self.sent if each[0]["what"] == what]


def live(simulation):
    with mock.patch.dict(sys.modules, {"anywidget": SimpleNamespace(AnyWidget=StandIn)}):
        view = simulation.live()
    return view, view._widget


class Live(unittest.TestCase):
    def test_runs_are_sent_while_they_go_on(self):
        simulation = gas(50)
        view, widget = live(simulation)
        self.assertIsInstance(view, hardball.LiveView)
        self.assertIs(simulation.live(), view)
        ((opened, (page, spheres)),) = widget.of("open")
        self.assertIn(b'id="recording"></script>', page)
        self.assertEqual(opened["header"]["spheres"], len(simulation))
        np.testing.assert_array_equal(np.frombuffer(spheres)[: len(simulation)], simulation.radii)
        seen = []
        on_progress = view._following(seen.append)
        simulation.run(contacts=2500)
        on_progress(simulation.time)
        self.assertEqual(seen, [simulation.time])
        simulation.run(contacts=700)
        sent = widget.of("chunk")
        self.assertEqual([message["number"] for message, _ in sent], list(range(len(sent))))
        self.assertGreaterEqual(len(sent), 3)
        status = widget.of("status")[-1][0]["status"]
        self.assertEqual(status["reached"], simulation.time)
        self.assertEqual(status["event_log_hash"], simulation.event_log_hash)
        self.assertFalse(status["finished"])
        view.close()
        view.close()
        self.assertTrue(widget.of("status")[-1][0]["status"]["finished"])
        # What was sent is the recording of the same run.
        again = gas(50)
        with tempfile.TemporaryDirectory() as folder:
            with again.output(folder, recording=True):
                again.run(contacts=3200)
            recording = (Path(folder) / "recording.hbr").read_bytes()
        contacts = sum(int.from_bytes(piece[4:8], "little") for _, (piece,) in widget.of("chunk"))
        self.assertEqual(contacts, 3200)
        self.assertIn(widget.of("chunk")[0][1][0][32:1000], recording)
        before = len(widget.sent)
        simulation.run(contacts=10)
        self.assertEqual(len(widget.sent), before)

    def test_a_page_that_comes_late_gets_everything(self):
        simulation = gas(50)
        view, widget = live(simulation)
        simulation.run(contacts=3000)
        count = len(widget.of("chunk"))
        widget.sent.clear()
        widget.hears(widget, {"what": "ready", "from": 0, "is_open": False}, [])
        self.assertEqual([message["what"] for message, _ in widget.sent], ["open", *["chunk"] * count, "status"])
        widget.sent.clear()
        widget.hears(widget, {"what": "ready", "from": 2, "is_open": True}, [])
        self.assertEqual([message["number"] for message, _ in widget.of("chunk")], list(range(2, count)))
        view.close()

    def test_long_runs_are_sent_in_parts(self):
        simulation = gas(50)
        view, widget = live(simulation)
        simulation.run(contacts=10)
        widget.sent.clear()
        with mock.patch("hardball._live._MOST_AT_ONCE", 1), mock.patch.object(type(view), "_complete"):
            simulation.run(contacts=20000)
        kinds = [message["what"] for message, _ in widget.sent]
        self.assertIn("chunk", kinds)
        self.assertNotIn(("chunk", "chunk"), list(zip(kinds, kinds[1:])))
        view._complete()
        with mock.patch("hardball._live._MOST", 1000):
            simulation.run(contacts=3000)
        self.assertIn("more is recorded", widget.of("status")[-1][0]["status"]["failed"])
        view.close()

    def test_files_that_are_written_are_followed(self):
        simulation = gas(50)
        with tempfile.TemporaryDirectory() as folder:
            with simulation.output(folder, recording=True):
                view, widget = live(simulation)
                simulation.run(contacts=1500)
                self.assertGreater(len(widget.of("chunk")), 0)
                view.close()
            self.assertTrue((Path(folder) / "summary.json").exists())
            with simulation.output(folder, recording=False, event_log=True, overwrite=True):
                with self.assertRaisesRegex(hardball.Error, "no recording"):
                    live(simulation)

    def test_it_needs_anywidget(self):
        with mock.patch.dict(sys.modules, {"anywidget": None}), self.assertRaisesRegex(ImportError, "pip install"):
            gas(50).live()


if __name__ == "__main__":
    unittest.main()

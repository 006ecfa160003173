# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""A view of a simulation in a notebook that follows its runs."""

from __future__ import annotations

import json
import os
import struct
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable

from ._hardball import Error

if TYPE_CHECKING:
    from ._simulation import Simulation

_MOST_AT_ONCE = 4_000_000  # bytes, in each half second of a run
_MOST = 200_000_000  # bytes, more than which pages do not keep
# The layout of a recording, as docs/recording.md describes it.
_LENGTH_AT = 8
_HEADER_AT = 12
_CHECKSUM = 8
_CHUNK_HEAD = struct.Struct("<IIQdd")


class LiveView:
    """The viewer in a notebook, which shows the runs of a simulation while they go on; made by Simulation.live.

    As the result of a notebook cell, it is shown inline.
    """

    __slots__ = ("_at", "_chunks", "_folder", "_header", "_path", "_sent", "_simulation", "_spheres", "_widget")

    def __init__(self, simulation: Simulation, widget: Any) -> None:
        self._simulation = simulation
        self._widget = widget
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        if simulation._output_directory is None:
            self._folder = tempfile.TemporaryDirectory(prefix="hardball-")
            simulation.output(self._folder.name, recording=True, overwrite=True)
        self._path = Path(str(simulation._output_directory)) / "recording.hbr"
        if not self._path.exists():
            raise Error("the files that are being written have no recording; call close() before live()")
        with self._path.open("rb") as file:
            start = file.read(_HEADER_AT)
            (length,) = struct.unpack_from("<I", start, _LENGTH_AT)
            self._header: dict[str, Any] = json.loads(file.read(length))
            self._spheres = file.read(16 * self._header["spheres"])
        self._at = _HEADER_AT + length + len(self._spheres) + _CHECKSUM  # of the next chunk
        self._chunks: list[tuple[int, int, float]] = []  # where they are, their lengths, and when they end
        self._sent = 0  # chunks
        widget.on_msg(self._answer)
        self._open()

    def close(self) -> None:
        """Ends the view, which shows what it has; runs are followed and recorded no longer."""
        if self._simulation._live is not self:
            return
        self._simulation._follow(None)
        if self._folder is not None:
            self._simulation.close()
        self._update(_MOST)
        if self._folder is not None:
            self._folder.cleanup()

    def _following(self, bar: Callable[[float], object] | None) -> Callable[[float], object]:
        """What runs report their progress to, besides a bar."""

        def follow(time: float) -> None:
            if bar is not None:
                bar(time)
            self._update(_MOST_AT_ONCE)

        return follow

    def _complete(self) -> None:
        """Shows a run to its end."""
        self._simulation._flush_recording()
        self._update(_MOST)

    def _repr_mimebundle_(self, **keys: Any) -> Any:
        return self._widget._repr_mimebundle_(**keys)

    # Sends what there is to be seen that has not been sent, up to a number of bytes.
    def _update(self, most: int) -> None:
        self._find_chunks()
        with self._path.open("rb") as file:
            while self._sent < len(self._chunks) and most > 0:
                at, length, end = self._chunks[self._sent]
                if at + length > _MOST:
                    break
                file.seek(at)
                piece = {"what": "chunk", "number": self._sent, "end": end}
                self._widget.send(piece, [file.read(length)])
                self._sent += 1
                most -= length
        self._widget.send({"what": "status", "status": self._status()})

    def _open(self) -> None:
        message = {"what": "open", "header": self._header, "status": self._status()}
        self._widget.send(message, [self._simulation._viewer_page(), self._spheres])

    def _answer(self, _widget: Any, message: dict[str, Any], _buffers: Any) -> None:
        if message.get("what") != "ready":
            return
        if not message["is_open"]:
            self._open()
        if self._path.exists():
            self._sent = min(message["from"], len(self._chunks))
            self._update(_MOST)

    def _find_chunks(self) -> None:
        size = os.path.getsize(self._path)
        with self._path.open("rb") as file:
            while size - self._at >= _CHUNK_HEAD.size:
                file.seek(self._at)
                _, _, length, _, end = _CHUNK_HEAD.unpack(file.read(_CHUNK_HEAD.size))
                if size - self._at < length:
                    return
                self._chunks.append((self._at, length, end))
                self._at += length

    # As the viewer's server gives it.
    def _status(self) -> dict[str, Any]:
        simulation = self._simulation
        is_too_long = self._sent < len(self._chunks) and sum(self._chunks[self._sent][:2]) > _MOST
        return {
            "finished": simulation._live is not self and self._sent == len(self._chunks),
            "failed": "more is recorded than a page keeps" if is_too_long else None,
            "damaged": None,
            "reached": simulation.time,
            "collisions": simulation.collisions,
            "mergers": self._header["spheres"] - len(simulation),
            "walls": simulation.wall_contacts,
            "event_log_hash": simulation.event_log_hash,
        }


def live_view_of(simulation: Simulation) -> LiveView:
    """A view that follows the simulation. Error (ImportError): anywidget is missing."""
    try:
        import anywidget
    except ImportError as error:
        raise ImportError("live() needs anywidget: 'pip install hardball[live]', or call view()") from error

    class LiveWidget(anywidget.AnyWidget):  # type: ignore[misc]
        _esm = Path(__file__).with_name("live_view.js")

    return LiveView(simulation, LiveWidget())

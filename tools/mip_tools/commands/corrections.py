"""`mip corrections`: RTCM corrections from an NTRIP caster to a device."""

from __future__ import annotations

import argparse
import math
import sys
import time
from collections import Counter
from contextlib import suppress
from datetime import datetime, timezone
from typing import Any

from ..binding import DEVICES, MipError, PortClosed
from ..devices.known import KnownDevice
from ..devices.names import value_named
from ..errors import Failure, Misuse
from ..files import outputs, signals
from ..logs.recognize import recognized
from ..names.selection import one_field
from ..options import add_baud, add_device, line_of, seconds
from ..ports import connection, ntrip
from ..ports.listing import command_type
from ..rtcm import Frames, number
from ..sentences import gga, nmea_place, nmea_sentence
from ..text.numbers import count_text, readable

EPILOG = """\
examples:
  mip corrections ntrip://USER:PASSWORD@caster.example:2101/MOUNT /dev/ttyACM0
  mip corrections ntrip://caster.example/VRS /dev/ttyACM0 --gga    with the position of the device
  mip corrections ntrip://caster.example/VRS /dev/ttyACM1 --at 48.1,11.6,520

The port must receive RTCM: `system.interface_control`. The command asks the device for its fix once
per second, and prints each change. Other programs cannot use the port meanwhile. A lost connection
is opened again. Without a mount point, those of the caster are listed.
"""
#: Seconds between positions, between questions to the device, and without RTCM until the connection is opened again.
_GGA, _ASK, _QUIET = 10.0, 1.0, 15.0
_FIRST_PAUSE, _LONGEST_PAUSE = 1.0, 30.0
_FIX, _POSITION = "gnss_1.fix_info", "gnss_1.llh_position"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("caster", metavar="NTRIP-URL", help=f"a mount point: {ntrip.FORM}, or https://…")
    add("port", metavar="PORT", help="a port such as /dev/ttyACM0, COM3, HOST:PORT")
    add("--gga", action="store_true", help="send the position of the device to the caster, every 10 s")
    add("--at", type=_place, metavar="LAT,LON[,H]", help="send this position instead, in degrees and metres")
    add("--duration", type=seconds, metavar="S", help="stop after S seconds")
    add_device(parser)
    add_baud(parser)


def _place(text: str) -> tuple[float, float, float]:
    try:
        latitude, longitude, height = [*map(float, text.split(",")), 0.0][:3]
    except ValueError:
        latitude = longitude = height = math.nan
    if not (abs(latitude) <= 90 and abs(longitude) <= 180 and abs(height) < 1e5):
        raise argparse.ArgumentTypeError(f"'{text}' is not a position; write 48.1,11.6,520")
    return latitude, longitude, height


def run(options: argparse.Namespace) -> int:
    if options.port.startswith("ntrip://"):
        raise Misuse("the mount point comes first: mip corrections NTRIP-URL PORT")
    source = ntrip.source_of(options.caster)
    known = KnownDevice(options.device)
    with signals.handled(signals.interrupt), connection.opened(line_of(options, options.port)) as device:
        known.ask(device)
        feed = _Feed(device, source, options)
        feed.check(known.id)
        try:
            feed.run()
        except KeyboardInterrupt:  # the usual way to end it
            pass
        except PortClosed as error:
            raise Failure(f"{options.port}: {connection.reason(error)}") from None
        finally:
            outputs.progress("")
    outputs.note(feed.summary())
    return 0


def _say(text: str) -> None:
    outputs.progress("")
    print(f"mip corrections: {text}", file=sys.stderr, flush=True)


class _Feed:
    """Passes frames from the caster to the device, and positions back."""

    def __init__(self, device: Any, source: ntrip.Source, options: argparse.Namespace) -> None:
        self._device, self._source, self._options = device, source, options
        self._end = math.inf if options.duration is None else time.monotonic() + options.duration
        self._fix, self._position = one_field(_FIX), one_field(_POSITION)
        wanted = (self._position.kind.DESCRIPTOR, self._fix.kind.DESCRIPTOR)
        self._question = command_type("3dm.poll_data")(self._fix.set, True, wanted)
        self._asked = self._sent = self._heard = -math.inf
        self._place = options.at and nmea_place(*map(math.radians, options.at[:2]))
        self._heights = (options.at[2], 0.0) if options.at else (0.0, 0.0)  # above the sea level, and of that
        self._used = 10  # satellites
        self._state = ""
        self._numbers: Counter[int] = Counter()
        self._bytes = 0
        self._seen = b""  # the last bytes of the stream

    def check(self, model: str | None) -> None:
        """Raises Failure if the device cannot use corrections; says if none of its ports receives RTCM."""
        profile = DEVICES.get(model or "")
        why = profile and profile.why(self._fix.set, self._fix.kind.DESCRIPTOR)
        if profile is None:
            return
        if why and why.absence:
            raise Failure(f"{profile.title} {why.absence}, so it cannot use corrections")
        if not profile.has(self._question.SET, self._question.DESCRIPTOR):
            name = self._question.NAME
            raise Failure(f"{profile.title} has no {name} to read its fix, and is not known to receive RTCM 3")
        control, ways = command_type("system.interface_control"), []
        for port in profile.ports:
            with suppress(MipError):
                ways.append(self._device.request(control.read(port.id)).protocols_incoming)
        if ways and not any(way & value_named(type(way), ("rtcm",)) for way in ways):
            command = f"mip send {self._options.port} {control.NAME} write main 'mip|rtcm' mip"
            _say(f"no port of the device receives RTCM; enable it: {command}")

    def run(self) -> None:
        """Raises Failure if no frame ever arrives, and PortClosed."""
        pause = _FIRST_PAUSE
        while (begun := time.monotonic()) < self._end:
            try:
                self._follow()
            except Failure as failure:
                if not self._numbers:
                    raise
                pause = _FIRST_PAUSE if self._heard > begun else min(2 * pause, _LONGEST_PAUSE)
                _say(f"{failure}; next attempt in {pause:g} s")
                time.sleep(max(min(pause, self._end - time.monotonic()), 0))
        if not self._numbers:
            raise Failure(f"{self._source} has sent no RTCM 3{self._what()}")

    def _follow(self) -> None:
        with ntrip.opened(self._source) as stream:
            begun, frames, self._seen = time.monotonic(), Frames(), b""
            self._sent = -math.inf
            while (now := time.monotonic()) < self._end:
                self._ask(now)
                if self._place and now - self._sent >= _GGA:
                    self._sent = now
                    stream.send(nmea_sentence("GP" + self._gga()))
                data = stream.read(0.2)
                if data == b"":
                    raise Failure(f"{self._source} has ended the stream{self._what()}")
                for frame in frames.feed(data or b""):
                    self._device.write(frame)
                    self._numbers[number(frame)] += 1
                    self._bytes += len(frame)
                    self._heard = now
                self._seen = (self._seen + (data or b""))[-4096:]
                if now - max(begun, self._heard) > _QUIET:
                    raise Failure(f"{self._source} sends no RTCM 3{self._what()}")
                outputs.progress(f"{self.summary()}, {max(now - self._heard, 0):.0f} s old; {self._state}")

    def _gga(self) -> str:
        return gga(datetime.now(timezone.utc), self._place, self._used, 1.0, *self._heights)

    def _what(self) -> str:
        """Says what a mount point sends that has sent no frame."""
        if self._numbers:
            return ""
        if self._seen.strip():
            return f", but {recognized(self._seen).what}"
        if self._place:
            return ", and nothing else"
        if self._options.gga:
            return ": it may wait for a position, and the device has none yet"
        return ": it may wait for a position; send one with --gga or --at"

    def _ask(self, now: float) -> None:
        """Reads what has arrived from the device, and asks for its fix and its position."""
        while (arrival := self._device.next(0)) is not None:
            if arrival.packet.set == self._fix.set:
                with suppress(MipError):  # a field of a length that the specification does not know
                    self._learn(arrival.find(self._fix.kind), arrival.find(self._position.kind))
        if now - self._asked >= _ASK:
            self._asked = now
            self._device.send(self._question)

    def _learn(self, fix: Any, position: Any) -> None:
        if fix is not None:
            self._used = fix.num_sv
            values = fix.to_dict()
            state = ", ".join([str(values["fix_type"]), *map(str, values["fix_flags"])])
            if state != self._state:
                self._state = state
                _say(f"{state}, {count_text(fix.num_sv, 'satellite')}")
        if position is not None and self._options.gga and not self._options.at and position.is_valid("latitude"):
            self._place = nmea_place(math.radians(position.latitude), math.radians(position.longitude))
            self._heights = position.msl_height, position.ellipsoid_height - position.msl_height

    def summary(self) -> str:
        """Summarizes what was passed on."""
        types = ", ".join(str(one) for one in sorted(self._numbers))
        return f"{count_text(sum(self._numbers.values()), 'RTCM frame')} ({types}), {readable(self._bytes)}"

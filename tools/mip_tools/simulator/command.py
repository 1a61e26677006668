"""`mip simulate`: the command line of the virtual device."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Mapping
from contextlib import ExitStack
from datetime import datetime, timezone
from pathlib import Path
from typing import Any

from ..binding import DEVICES, SETS, Device
from ..cli import outputs, signals
from ..errors import Failure, Misuse
from . import earth
from .endpoints import Endpoint, pty_at, tcp_at
from .fault_kinds import parse_faults, table
from .faults import Faults, json_log
from .profiles import assumed_rates, certain, device_named, port_named
from .serve import Server

_KNOWN = sorted(DEVICES.values(), key=lambda d: (bool(d.incomplete), -len(d.ports)))
_EXAMPLE = _KNOWN[0].id if _KNOWN else "DEVICE"
_PORTS = ([p.name for p in _KNOWN[0].ports] if _KNOWN else []) or ["NAME"]

EPILOG = f"""\
examples:
  mip simulate {_EXAMPLE} --pty /tmp/mip          a terminal at /tmp/mip, until Ctrl-C
  mip simulate {_EXAMPLE} --tcp 5000 --speed 10   TCP, ten times as fast as real time
  mip simulate {_EXAMPLE} --port "{_PORTS[0]}=pty:/tmp/first" --port "{_PORTS[-1]}=tcp:5000"
  mip simulate {_EXAMPLE} --fault lose=0.01,noise=0.1:16,lose_answer@3 --fault-log faults.jsonl

When the device can be reached, its endpoints are printed, one in a line: those of --pty, --tcp and
--port, in the order in which they are given.

faults: KIND=RATE with a probability, KIND=RATE:AMOUNT with how much at most, KIND@N at the Nth
chance; all=RATE is every kind.
{table()}
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("device", nargs="?", metavar="DEVICE", help="which device, as listed by --list")
    add("--list", action="store_true", help="list the devices and end")
    add("--no-effect", action="store_true", help="list the commands that change nothing on a virtual device and end")
    add("--certain", action="store_true", help="only the commands and data that the device is known to have")
    add("--pty", action="append", default=[], metavar="PATH", help="a pseudo-terminal, with a link to it at PATH")
    add("--tcp", action="append", default=[], metavar="[HOST:]PORT", help="a TCP port; 0: the system chooses one")
    add(
        "--port",
        action="append",
        default=[],
        metavar="NAME=ENDPOINT",
        help="a port of the device, as its profile names it, at pty:PATH, pty or tcp:[HOST:]PORT",
    )
    add(
        "--motion",
        default="standing",
        metavar="MOTION",
        help="standing (default), circle:radius=20,speed=5, track:file=CSV or replay:file=LOG",
    )
    add(
        "--signal",
        type=_signal,
        action="append",
        default=[],
        metavar="PIN=HZ",
        help="a square wave at a pin of the device",
    )
    add("--noise", type=_noise, default=1.0, metavar="X", help="times the usual noise (default: 1); 0: none")
    add("--seed", type=int, default=0, metavar="N", help="for noise and faults (default: 0)")
    add(
        "--speed",
        type=_speed,
        default=1.0,
        metavar="X",
        help="times real time (default: 1); 0: as fast as clients read",
    )
    add(
        "--start",
        type=start_time,
        metavar="TIME",
        help="simulated time at the start: ISO 8601, UTC, or `now` "
        "(default: 2024-01-06T23:59:42, or that of a replayed log)",
    )
    add("--duration", type=_seconds, metavar="S", help="end after this many simulated seconds")
    add("--storage", type=Path, metavar="FILE", help="keeps saved settings (default: they are lost at the end)")
    add("--strict-baud", action="store_true", help="baud rates limit the data, and wrong ones garble them")
    add("--fault", action="append", default=[], metavar="FAULT,...", help="inject faults; see below")
    add("--fault-log", type=Path, metavar="FILE", help="log each fault as a line of JSON")
    add("--log-packets", action="store_true", help="also log each packet that is sent")


def run(options: argparse.Namespace) -> int:
    if options.list:
        width = max(len(d.id) for d in DEVICES.values())
        for known in DEVICES.values():
            incomplete = f" (incomplete: {_known(known)})" if known.incomplete else ""
            print(f"{known.id:<{width}}  {known.title}{incomplete}")
        return 0
    if options.no_effect:
        from .knowledge import without_effect

        print("\n".join(without_effect()))
        return 0
    whole = _profile(options.device)
    profile = certain(whole) if options.certain else whole
    endpoints = _endpoints(options, profile)
    if options.log_packets and options.fault_log is None:
        raise Misuse("--log-packets needs a file; add --fault-log FILE")
    with ExitStack() as stack:
        faults = _faults(options, stack)
        device = _device(options, profile, faults)
        server = Server(
            device,
            endpoints,
            options.speed,
            duration=options.duration,
            strict_baud=options.strict_baud,
            seed=options.seed,
            ready=lambda text: print(text, flush=True),
            complain=_complain,
        )
        stack.enter_context(signals.handled(lambda number, frame: server.stop()))
        stack.enter_context(server)
        _complain(_evidence(whole, options.certain))
        if profile.incomplete:
            _complain(
                f"the profile of {profile.title} is incomplete ({_known(profile)}): " + " ".join(profile.incomplete)
            )
        if rates := {set: rate for set, rate in assumed_rates(profile).items() if rate}:
            _complain(_assumed(rates))
        server.run()
    return 0


def _device(options: argparse.Namespace, profile: Device, faults: Faults | None) -> Any:
    from .device import VirtualDevice
    from .motion import parse_motion
    from .state import MotionError

    try:
        motion = parse_motion(options.motion)
    except MotionError as error:
        raise Failure(f"--motion {error}", 1 if "file=" in options.motion else 2) from None
    device = VirtualDevice(
        profile,
        motion=motion,
        seed=options.seed,
        noise=options.noise,
        start=options.start,
        storage=options.storage,
        faults=faults,
    )
    for pin, hertz in options.signal:
        try:
            device.wave(pin, hertz)
        except ValueError as error:
            raise Misuse(f"--signal {pin}={hertz:g}: {error}") from None
    return device


def _faults(options: argparse.Namespace, stack: ExitStack) -> Faults | None:
    plans = parse_faults(",".join(options.fault))
    log = None
    if options.fault_log is not None:
        replayed = re.search(r"[:,]file=([^,]+)", options.motion)
        if replayed is not None:
            outputs.refuse_input(str(options.fault_log), replayed[1])
        try:
            if outputs.holds_bytes(options.fault_log):
                with options.fault_log.open("rb") as earlier:
                    if earlier.read(1) != b"{":
                        raise Failure(f"{options.fault_log} is no log of faults; name another file")
            file = stack.enter_context(options.fault_log.open("w", encoding="utf-8"))
        except OSError as error:
            raise Failure(f"{options.fault_log} cannot be written: {error.strerror}") from None
        log = json_log(file)
    if not plans and log is None:
        return None
    return Faults(seed=options.seed, log=log, every_packet=options.log_packets, plans=plans)


def _evidence(profile: Device, certain: bool) -> str:
    """How much of a profile is certain."""
    sure, probable = len(profile.certain), len(profile.fields - profile.certain)
    left_out = " and left out" if certain and probable else ""
    return f"{profile.title}: {sure} commands and data fields are certain, {probable} probable{left_out}"


def _known(profile: Device) -> str:
    """How complete a profile is, for those that are incomplete."""
    commands = sum(1 for set, _ in profile.fields if set < 0x80)
    data = len(profile.fields) - commands
    return f"{_count(commands, 'command')}, {_count(data, 'data field')}"


def _count(number: int, what: str) -> str:
    return f"{number} {what}{'s' * (number != 1)}"


def _complain(text: str) -> None:
    print(f"mip simulate: {text}", file=sys.stderr, flush=True)


# --------------------------------------------------------------------------- what is wanted


def _profile(name: str | None) -> Device:
    if name is None:
        raise Misuse("which device? `mip simulate --list` lists them all")
    return device_named(name)


def _endpoints(options: argparse.Namespace, profile: Device) -> list[Endpoint]:
    endpoints = [pty_at(path) for path in options.pty] + [tcp_at(text) for text in options.tcp]
    for text in options.port:
        name, _, where = text.partition("=")
        kind, _, place = where.partition(":")
        if kind not in ("pty", "tcp"):
            raise Misuse(f"--port '{text}' cannot be read; write NAME=pty:PATH or NAME=tcp:[HOST:]PORT")
        port = port_named(profile, name).name
        endpoints.append(pty_at(place, port) if kind == "pty" else tcp_at(place, port))
    paths = [e.path for e in endpoints if e.path]
    for path in paths:
        if paths.count(path) > 1:
            raise Misuse(f"{path} is given for two terminals; choose different paths")
    return endpoints or [pty_at("")]


def _signal(text: str) -> tuple[int, float]:
    pin, _, hertz = text.partition("=")
    what = "signal; write PIN=HZ, such as 1=10"
    return int(_number(pin, 1, 255, what)), _number(hertz, 1e-6, 1e6, what)


def _seconds(text: str) -> float:
    return _number(text, 1e-9, 1e10, "duration in seconds; use a number above 0")


def _noise(text: str) -> float:
    return _number(text, 0, 1e3, "noise; use 1 for the usual one, 0 for none")


def _speed(text: str) -> float:
    return _number(text, 0, 1e6, "speed; use 1 for real time, 0 for as fast as possible")


def _number(text: str, least: float, most: float, what: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = -1.0
    if not least <= value <= most:
        raise argparse.ArgumentTypeError(f"'{text}' is not a {what}")
    return value


def start_time(text: str) -> int:
    """Nanoseconds since the GPS epoch."""
    try:
        when = datetime.now(timezone.utc) if text == "now" else datetime.fromisoformat(text.replace("Z", "+00:00"))
        if when.tzinfo is not None:
            when = when.astimezone(timezone.utc).replace(tzinfo=None)
    except (ValueError, OverflowError):
        raise argparse.ArgumentTypeError(f"'{text}' is not a time; write 2024-05-01T12:00:00") from None
    if when < datetime(1980, 1, 6):
        raise argparse.ArgumentTypeError(f"{text} is before GPS time, which began on 1980-01-06")
    if when.year > 3000:
        raise argparse.ArgumentTypeError(f"{text} is too late; use a year up to 3000")
    return earth.from_utc(when)


def _assumed(rates: Mapping[int, float]) -> str:
    """The base rates that no source states."""
    each = ", ".join(f"{SETS[set][0]} {rate:g} Hz" for set, rate in rates.items())
    return f"base rates that no source states are assumed: {each}"

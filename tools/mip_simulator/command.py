"""`mip simulate`: the command line of the virtual device."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from datetime import datetime, timezone
from pathlib import Path
from typing import TextIO

from mip_tools.binding import DEVICES, SETS, Device
from mip_tools.devices.profiles import assumed_ports, assumed_rates, certain, device_named
from mip_tools.errors import Failure, Misuse
from mip_tools.files import outputs, signals
from mip_tools.geometry import earth
from mip_tools.text import field_texts
from mip_tools.text.numbers import count_text

from .device import VirtualDevice
from .endpoints.endpoint import Endpoint, pty_at, tcp_at, udp_at
from .endpoints.serve import Server
from .faults import Faults, Injected, json_log
from .faults.kinds import kinds_table, parse_faults
from .motion import MotionError, parse_motion
from .scenario import endpoint, read_scenario

Log = Callable[[Injected], None]

_KNOWN = sorted(DEVICES.values(), key=lambda d: (bool(d.incomplete), -len(d.ports)))
_EXAMPLE = _KNOWN[0].id if _KNOWN else "DEVICE"
_PORTS = ([p.name for p in _KNOWN[0].ports] if _KNOWN else []) or ["NAME"]

EPILOG = f"""\
examples:
  mip simulate {_EXAMPLE} --pty /tmp/mip          a terminal at /tmp/mip, until Ctrl-C
  mip simulate {_EXAMPLE} --tcp 5000 --speed 10   TCP, ten times as fast as real time
  mip simulate {_EXAMPLE} --port "{_PORTS[0]}=pty:/tmp/first" --port "{_PORTS[-1]}=tcp:5000"
  mip simulate {_EXAMPLE} --tcp 5000 --scenario test.yaml     with the events of a file
  mip simulate {_EXAMPLE} --fault lose=0.01,noise=0.1:16,lose_answer@3 --fault-log faults.jsonl

When the device is ready, its endpoints are printed, one per line: first those of --pty, then --tcp, --udp and
--port.

faults: KIND=RATE with a probability, KIND=RATE:AMOUNT also with a maximum amount, KIND@N at the Nth
chance; all=RATE stands for every kind.
{kinds_table()}
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("device", nargs="?", metavar="DEVICE", help="name of the device; `mip fields --devices` lists them")
    add("--certain", action="store_true", help="only the commands and data that the device is known to have")
    add("--pty", action="append", default=[], metavar="PATH", help="a pseudo-terminal, with a link to it at PATH")
    add("--tcp", action="append", default=[], metavar="[HOST:]PORT", help="a TCP port; 0: the system chooses one")
    add("--udp", action="append", default=[], metavar="[HOST:]PORT", help="a UDP port; 0: the system chooses one")
    add(
        "--port",
        action="append",
        default=[],
        metavar="NAME=ENDPOINT",
        help="a port of the device, as its profile names it, at pty:PATH, pty, tcp:[HOST:]PORT or udp:[HOST:]PORT",
    )
    add(
        "--motion",
        metavar="MOTION",
        help="standing (default), circle:radius=20,speed=5, trajectory:file=CSV or replay:file=LOG",
    )
    add("--scenario", type=Path, metavar="FILE", help="a YAML file with events")
    add("--noise", type=_noise, default=1.0, metavar="X", help="scales the noise (default: 1); 0: only constant biases")
    add("--seed", type=int, default=0, metavar="N", help="seed of noise and faults (default: 0)")
    add(
        "--speed",
        type=_speed,
        default=1.0,
        metavar="X",
        help="multiple of real time (default: 1); 0: as fast as clients read",
    )
    add(
        "--start",
        type=start_time,
        metavar="TIME",
        help="simulated time at the start: ISO 8601, UTC, or `now` "
        "(default: 2024-01-06T23:59:42, or that of a replayed log)",
    )
    add(
        "--sync",
        action=argparse.BooleanOptionalAction,
        help="a pulse per second and its time arrive from outside; --no-sync: nor do receivers have reception "
        "(default: only receivers have a time, and a replayed log that has dates)",
    )
    add("--duration", type=_seconds, metavar="S", help="stop after this many simulated seconds")
    add("--storage", type=Path, metavar="FILE", help="keep saved settings in this file (default: lost at the end)")
    add("--strict-baud", action="store_true", help="baud rates limit the data, and a wrong one garbles it")
    add("--fault", action="append", default=[], metavar="FAULT,...", help="inject faults; see below")
    add("--fault-log", type=Path, metavar="FILE", help="log each fault as a line of JSON")
    add("--log-packets", action="store_true", help="also log each packet that is sent")


def run(options: argparse.Namespace) -> int:
    with ExitStack() as stack:
        device, server = served(options, stack, lambda text: print(text, flush=True), _complain)
        stack.enter_context(signals.handled(lambda number, frame: server.stop()))
        stack.enter_context(server)
        profile = _profile(options.device)
        _introduce(profile, options.certain)
        server.run()
    if device.rtcm_frames:
        _complain(f"{profile.title} has received {count_text(device.rtcm_frames, 'RTCM frame')}")
    return 0


def served(
    options: argparse.Namespace, stack: ExitStack, ready: Callable[[str], None], complain: Callable[[str], None]
) -> tuple[VirtualDevice, Server]:
    """Makes a device and its server. `stack` closes its log of faults; `ready` is called with each endpoint."""
    profile = _profile(options.device)
    endpoints = _endpoints(options, profile)
    _different(endpoints)
    if options.log_packets and options.fault_log is None:
        raise Misuse("--log-packets needs a file; add --fault-log FILE")
    file = _log(options, stack)
    device = _device(profile, options, None if file is None else json_log(file))
    return device, Server(
        device,
        endpoints,
        options.speed,
        duration=options.duration,
        strict_baud=options.strict_baud,
        seed=options.seed,
        ready=ready,
        complain=complain,
    )


def _device(profile: Device, options: argparse.Namespace, log: Log | None) -> VirtualDevice:
    """Makes the device. Raises Failure."""
    events = () if options.scenario is None else read_scenario(options.scenario)
    motion = None
    if options.motion is not None:
        try:
            motion = parse_motion(options.motion)
        except MotionError as error:
            raise Failure(f"--motion {error}", 1 if "file=" in options.motion else 2) from None
    plans = parse_faults(",".join(options.fault))
    faults = None
    if plans or log is not None or any(event.event == "faults" for event in events):
        faults = Faults(seed=options.seed, log=log, every_packet=options.log_packets, plans=plans)
    return VirtualDevice(
        certain(profile) if options.certain else profile,
        motion=motion,
        seed=options.seed,
        noise=options.noise,
        start=options.start,
        sync=options.sync,
        storage=options.storage,
        faults=faults,
        events=events,
    )


def _log(options: argparse.Namespace, stack: ExitStack) -> TextIO | None:
    if options.fault_log is None:
        return None
    replayed = re.search(r"[:,]file=([^,]+)", options.motion or "")
    for path in (replayed and replayed[1], options.scenario):
        if path:
            outputs.refuse_input(str(options.fault_log), str(path))
    try:
        if outputs.holds_bytes(options.fault_log):
            with options.fault_log.open("rb") as earlier:
                if earlier.read(1) != b"{":
                    raise Failure(f"{options.fault_log} is not a log of faults; name another file")
        return stack.enter_context(open(options.fault_log, "w", encoding="utf-8"))
    except OSError as error:
        raise Failure(f"{options.fault_log} cannot be written: {error.strerror}") from None


def _introduce(whole: Device, sure: bool) -> None:
    """Prints how much of a device is certain, and what is assumed."""
    profile = certain(whole) if sure else whole
    _complain(_evidence(whole, sure))
    if profile.incomplete:
        _complain(
            f"the profile of {profile.title} is incomplete ({field_texts.extent(profile)}): "
            + " ".join(profile.incomplete)
        )
    if rates := {set_number: rate for set_number, rate in assumed_rates(profile).items() if rate}:
        _complain(_assumed(rates))
    if any(port not in profile.ports for port in assumed_ports(profile)):
        _complain("no source states the baud rates; all that other devices have are assumed")


def _evidence(profile: Device, certain: bool) -> str:
    """States how much of a profile is certain."""
    sure, likely, assumed = len(profile.certain), len(profile.likely), len(profile.assumed)
    left_out = " (left out)" if certain and likely + assumed else ""
    return f"{profile.title}: {sure} commands and data fields are certain, {likely} likely, {assumed} assumed{left_out}"


def _complain(text: str) -> None:
    print(f"mip simulate: {text}", file=sys.stderr, flush=True)


# --------------------------------------------------------------------------- what is wanted


def _profile(name: str | None) -> Device:
    if name is None:
        raise Misuse("the device is missing; `mip fields --devices` lists them")
    return device_named(name)


def _endpoints(options: argparse.Namespace, profile: Device) -> list[Endpoint]:
    endpoints = [pty_at(path) for path in options.pty]
    endpoints += [tcp_at(text) for text in options.tcp] + [udp_at(text) for text in options.udp]
    return endpoints + [endpoint(text, profile) for text in options.port] or [pty_at("")]


def _different(endpoints: list[Endpoint]) -> None:
    """Raises Misuse if two terminals have the same path."""
    paths = [e.path for e in endpoints if e.path]
    for path in paths:
        if paths.count(path) > 1:
            raise Misuse(f"{path} is given for two terminals; choose different paths")


def _seconds(text: str) -> float:
    return _number(text, 1e-9, 1e10, "duration in seconds; use a number above 0")


def _noise(text: str) -> float:
    return _number(text, 0, 1e3, "noise; use 1 for the usual noise, 0 for none")


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
    """Parses a start time. Returns nanoseconds since the GPS epoch."""
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
    """Lists the base rates that no source states."""
    each = ", ".join(f"{SETS[set_number][0]} {rate:g} Hz" for set_number, rate in rates.items())
    return f"base rates that no source states are assumed: {each}"

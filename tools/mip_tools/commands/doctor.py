"""`mip doctor`: finds the faults of a device, a port or a log, and their causes."""

from __future__ import annotations

import argparse
import dataclasses
import json
from typing import TYPE_CHECKING

from ..doctor import findings
from ..doctor.examined import Examined
from ..doctor.findings import Finding
from ..doctor.port import Patient
from ..errors import Misuse
from ..files import signals
from ..logs import inputs
from ..logs.assumed import print_assumptions
from ..options import add_baud, add_device, parse_rates, seconds
from ..text.numbers import count_text

if TYPE_CHECKING:
    from ..columns import Log

EPILOG = """\
examples:
  mip doctor /dev/ttyACM0
  mip doctor /dev/ttyACM0 sensor.scaled_accel@500      is this rate reached, and if not, why?
  mip doctor drive.bin --device 3dm-gq7                with the warnings of its filter

At a port, it identifies the device and then only listens; no setting is changed. In a log, it finds
gaps and their causes: line damage, overload, pause, reset, clock step, changed format; packets that
are repeated or out of order; values that are not numbers, frozen, dead, saturated or spikes; and a
wrong scale or orientation. Filter warnings are listed for the last data and for the whole log.

exit status: 0 if nothing is wrong, 1 if something is
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("input", metavar="PORT|LOG", help="a port such as /dev/ttyACM0, COM3, HOST:PORT; a log; - for standard input")
    add("names", nargs="*", default=[], metavar="NAME@HZ", help="rates that a device should reach")
    add("--duration", type=seconds, default=5.0, metavar="S", help="seconds to watch a device (default: 5)")
    add("--json", action="store_true", help="print a JSON object, in one line")
    add_device(parser)
    add_baud(parser)


def run(options: argparse.Namespace) -> int:
    names, rates = parse_rates(options.names, None)
    if len(names) != len(rates):
        raise Misuse("each name needs a rate, as in sensor.scaled_accel@100")
    device = options.device
    if inputs.is_port(options.input) or options.input.startswith("/dev/"):
        patient = Patient(options.input, options.baud)
        with signals.handled(signals.interrupt):
            patient.watch(options.duration, rates)
        examined = _examined(patient.data, device, patient.model)
        patient.line(options.duration)
        patient.rates(rates if patient.data else {}, examined)
        messages = patient.findings + (findings.in_stream(examined) if examined.packets else [])
    elif rates:
        raise Misuse(f"{options.input} is not a port; rates are for devices")
    else:
        with inputs.open_columns(options.input, device, empty=True) as log:
            examined = _examined(log)
        messages = findings.in_stream(examined)
    if options.json:
        print(json.dumps({"input": options.input, "findings": [dataclasses.asdict(f) for f in messages]}))
    else:
        _print(options.input, examined, messages)
    return 1 if any(f.cause not in _NOTES for f in messages) else 0


#: Findings that are not faults.
_NOTES = ("unknown device", "no timestamps", "cut off")


def _examined(log: Log | bytes, device: str | None = None, model: str | None = None) -> Examined:
    """Examines a log, or data from a port: `model` is what the device there says it is."""
    inputs.need_numpy()
    from ..columns import read_log
    from ..columns.sender import Sender
    from ..doctor.stream import examine_log

    if isinstance(log, bytes):
        log = read_log(log, device=Sender(device, model))
    examined = examine_log(log)
    print_assumptions("doctor", log, times=False)
    return examined


def _print(name: str, examined: Examined, messages: list[Finding]) -> None:
    span = examined.seconds
    print(f"{name}: {count_text(examined.packets, 'packet')}{f' in {span:.1f} s' if span else ''}")
    for f in messages:
        print(f"{f.cause}: {f.text}")
        if f.remedy:
            print(f"  {f.remedy}")
        for text in f.details:
            print(f"    {text}")
    if not examined.packets:
        return
    fields, sets = len(examined.names), len({number for number, _ in examined.names})
    what = (
        f"examined damage, gaps, clocks, flags and values of {count_text(fields, 'field')} in {count_text(sets, 'set')}"
    )
    print(f"{'' if messages else 'nothing is wrong; '}{what}")

"""`mip bandwidth`: the baud rate that streams need."""

from __future__ import annotations

import argparse

from ..binding import DEVICES, OVERHEAD
from ..errors import Failure, Misuse
from ..options import add_device, bits_per_second
from ..ports import bandwidth
from ..text import show

EPILOG = """\
examples:
  mip bandwidth sensor.scaled_accel@100 sensor.scaled_gyro@100
  mip bandwidth sensor:shared.gps_timestamp@500 sensor.scaled_accel@500 --device 3dm-cv7-gnss-ins

The device sends fields of a set in one packet as far as their rates allow. A byte takes ten bits on
a serial line. Allow headroom for replies to commands: 80 % of the line is a good limit.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add(
        "streams",
        nargs="+",
        metavar="NAME@HZ",
        help="a field and its rate; SET:NAME@HZ for a shared field; NAME@HZ*N with N elements",
    )
    add_device(parser, "check rates and ports of this device")
    add("--baud", type=bits_per_second, metavar="BD", help="show how much of this rate is used")


def run(options: argparse.Namespace) -> int:
    streams = [bandwidth.stream(text) for text in options.streams]
    for stream in streams:
        if stream.set == 0xFF:
            raise Misuse(f"{stream.name} is in every data set; name one: sensor:{stream.name}@{stream.rate:g}")
    profile = DEVICES.get(options.device)
    loads = bandwidth.loads(streams, profile)
    need = bandwidth.bauds(loads)
    if options.baud is not None and need > options.baud:
        raise Failure(f"{options.baud} Bd are not enough; {need} are needed")
    rows = [("", "bytes", "Hz", "bytes/s")]
    for load in loads:
        rows += [(f"  {s.name}", str(s.size), f"{s.rate:g}", f"{s.size * s.rate:.0f}") for s in load.streams]
        title = f"{show.set_name(load.set)}: packets"
        rows.append((title, str(OVERHEAD), f"{load.packets:g}", f"{load.packets * OVERHEAD:.0f}"))
    rows.append(("all", "", "", f"{sum(load.bytes for load in loads):.0f}"))
    widths = [max(len(row[i]) for row in rows) for i in range(4)]
    for row in rows:
        print(f"{row[0]:<{widths[0]}}", *(f"{t:>{w}}" for t, w in zip(row[1:], widths[1:])), sep="  ")
    print(f"\nminimum baud rate: {need}")
    for port, rates in bandwidth.port_rates(profile):
        fits = next((r for r in sorted(rates) if r >= need), None)
        if fits is None:
            print(f"{port}: none of its rates is sufficient; the highest is {max(rates)}")
        else:
            print(f"{port}: {fits} ({need / fits:.0%} used)")
    if options.baud is not None:
        print(f"{options.baud}: {need / options.baud:.0%} used")
    return 0

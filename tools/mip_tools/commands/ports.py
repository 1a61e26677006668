"""`mip ports`: the serial ports of this machine, and the devices at them."""

from __future__ import annotations

import argparse
from importlib import import_module
from typing import Any, NamedTuple

from ..binding import MipError, MissingExtra
from ..errors import Failure
from ..options import add_baud
from ..ports import connection
from ..ports.listing import Listing, command_type
from ..ports.silence import Line

EPILOG = """\
examples:
  mip ports
  mip ports /dev/ttyUSB0 localhost:5005 --baud auto      identify the devices at these ports

Without names, only USB ports of the vendor are asked who is there; others are listed. The first USB
port of a device is its main port, the second an auxiliary one, which may be set to other protocols.
"""
#: The USB number of the vendor.
_VENDOR = 0x199B
#: Seconds to wait for a reply.
_PATIENCE = 0.5


class _Port(NamedTuple):
    name: str
    asked: bool
    about: str  # by the system
    role: str


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    parser.add_argument("ports", nargs="*", default=[], metavar="PORT", help="only these, such as COM3, HOST:PORT")
    add_baud(parser)


def run(options: argparse.Namespace) -> int:
    ports = [_Port(name, True, "", "") for name in options.ports] or _system()
    if not ports:
        raise Failure("there is no serial port; plug in the device, or name a port such as localhost:5005")
    rows = [("port", "model", "serial number", "firmware", "")]
    rows += [
        (port.name, *(_device(port, options) if port.asked else (port.about, "", "", "not asked"))) for port in ports
    ]
    widths = [max(len(row[i]) for row in rows) for i in range(5)]
    for row in rows:
        print("  ".join(f"{text:<{width}}" for text, width in zip(row, widths)).rstrip())
    return 0


def _system() -> list[_Port]:
    """Lists the serial ports of this machine. Raises Failure without pyserial."""
    try:
        listing: Any = import_module("serial.tools.list_ports")
    except ImportError:
        raise Failure(str(MissingExtra("pyserial", "serial"))) from None
    found = sorted(listing.comports(), key=lambda port: (port.serial_number or "", port.location or "", port.device))
    ports, before = [], None
    for port in found:
        ours = port.vid == _VENDOR
        role = ("auxiliary" if port.serial_number == before else "main") if ours else ""
        before = port.serial_number if ours else None
        ports.append(_Port(port.device, ours, (port.description or "").removeprefix("n/a"), role))
    return ports


def _device(port: _Port, options: argparse.Namespace) -> tuple[str, str, str, str]:
    """Asks the device at a port. Returns model, serial number, firmware, and a remark."""
    try:
        with connection.opened(Line(port.name, options.baud, options.command)) as device:
            reply = device.request(command_type("base.get_device_info")(), timeout=_PATIENCE)
    except connection.Silent as silent:
        remark = f"no reply, but {silent.sent}" if silent.sent else "no reply"
        return port.about, "", "", f"{port.role}, {remark}".lstrip(", ")
    except Failure as failure:
        return (
            port.about,
            "",
            "",
            str(failure).removeprefix(f"{port.name} cannot be opened: ").removeprefix("no_device: "),
        )
    except (OSError, MipError) as error:
        return port.about, "", "", connection.reason(error)
    listing = Listing(reply.device_info, ())
    return listing.title, reply.device_info.serial_number.strip(), listing.firmware, port.role

"""`mip serve`: the command line."""

from __future__ import annotations

import argparse
import os
import sys
from typing import Any

from ..binding import MipError, connect
from ..errors import Failure
from ..files import signals
from ..options import add_baud
from ..ports import connection
from ..web.server import Server

EPILOG = """\
examples:
  mip serve /dev/ttyACM0                        finds the baud rate of the device
  mip serve localhost:5000 --tcp 5766

The first line of the output is an address with a token. Paste it into the live view of the
workbench (`make workbench`, then build/workbench/live.html) on this machine. The server listens on
127.0.0.1 only, and rejects pages without the token, which is new at each start. Only one page can
be connected at a time.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("port", metavar="PORT", help="a port such as /dev/ttyACM0, COM3, HOST:PORT, rfc2217://HOST:PORT")
    add("--tcp", type=_number, default=0, metavar="N", help="TCP port on this machine (default: the system chooses)")
    add_baud(parser)
    parser.set_defaults(baud=None)


def _number(text: str) -> int:
    if not (text.isascii() and text.isdigit()) or int(text) > 65535:
        raise argparse.ArgumentTypeError(f"'{text}' is not a TCP port; use a number up to 65535")
    return int(text)


def run(options: argparse.Namespace) -> int:
    with (
        Server(lambda: _port(options.port, options.baud), options.tcp, say=_say) as server,
        signals.handled(lambda number, frame: server.stop()),
    ):
        print(server.address, flush=True)
        server.run()
    return 0


def _port(name: str, baud: int | None) -> Any:
    """Opens the port of a device, at the baud rate at which it answers. Raises Failure."""
    if os.path.isfile(name):
        raise Failure(f"{name} is a file, not a port")
    try:
        port = connect(name, baud)
    except (OSError, ImportError, MipError, ValueError) as error:
        raise Failure(connection.why_not(name, error)) from None
    if baud is None and getattr(port, "baudrate", None) is not None:
        _say(f"the device answers at {port.baudrate} Bd")
    return port


def _say(text: str) -> None:
    print(f"mip serve: {text}", file=sys.stderr, flush=True)

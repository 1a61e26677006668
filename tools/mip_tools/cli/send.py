"""`mip send`: sends one command, and shows the reply."""

from __future__ import annotations

import argparse
import json
import re
from typing import Any

from ..binding import Answer, Command, MipError, TimedOut
from ..errors import Failure, Misuse
from . import ports, show, typed, values
from .arguments import add_device, device_id, seconds
from .selection import fields

REFUSED, SILENT = 3, 4
_NEGATIVE = re.compile(r"(?i)-([\d.]|inf|nan)")

EPILOG = """\
examples:
  mip send /dev/ttyACM0 base.ping
  mip send /dev/ttyACM0 base.get_device_info
  mip send /dev/ttyACM0 3dm.message_format write sensor scaled_accel:10,scaled_gyro:10
  mip send /dev/ttyACM0 3dm.message_format write descriptor_set=0x80 descriptors=0x04:10,0x05:10
  mip send --hex 3dm.message_format read sensor        the bytes, without a device

Enter values in order or as NAME=VALUE: numbers (10, 0x0A, -1.5), names of enumeration values, true
and false, flags (a|b), lists (1,2,3), structures (4:10), lists of structures (4:10,5:10), or JSON.
Where a byte is required, the name of a set or field stands for its number. `mip fields COMMAND`
lists the parameters of a command.

exit status: 3 if the device rejects the command, 4 if it does not reply
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    parser.usage = "mip send [options] PORT COMMAND [FUNCTION] [VALUE ...]"
    add = parser.add_argument
    add("port", metavar="PORT", help="a port such as /dev/ttyACM0, COM3, HOST:PORT; left out with --hex")
    # Optional for argparse, because with --hex, the command is the first word, in place of the port.
    add("command_name", metavar="COMMAND", nargs="?", help="name of the command, as in `mip fields`")
    add("function", metavar="FUNCTION", nargs="?", help="write, read, save, load or default")
    add("values", metavar="VALUE", nargs="*", default=[], help="values in order, or NAME=VALUE")
    add("--hex", action="store_true", help="print the bytes of the packet, send nothing")
    add("--timeout", type=seconds, metavar="S", help="seconds to wait (default: 1, or as specified)")
    add("--json", action="store_true", help="print the reply as JSON")
    add_device(parser)
    ports.add_arguments(parser)


def shielded(given: list[str]) -> list[str]:
    """Prefixes words that begin with a negative number, such as -1,0,0, with a space.

    Otherwise argparse takes them for options.
    """
    return [f" {word}" if _NEGATIVE.match(word) else word for word in given]


def _bare(word: str) -> str:
    """Removes the space that `shielded` has added. Options with numbers ignore it themselves."""
    return word[1:] if word.startswith(" -") else word


def run(options: argparse.Namespace) -> int:
    options.port = _bare(options.port)
    words = [w for w in (options.command_name, options.function) if w is not None] + options.values
    words = [_bare(word) for word in words]
    if options.hex:
        words = [options.port, *words]
    if not words:
        raise Misuse("the command is missing; `mip fields` lists the sets, `mip fields SET` their commands")
    command = typed.command(_kind(words[0]), words[1:])
    device = device_id(options.device and _bare(options.device))
    if options.hex:
        print(bytes(command.packet()).hex(" "))
        return 0
    with ports.opened(options.port, options) as link:
        try:
            (outcome,) = link.exchange(command, timeout=options.timeout)
        except (OSError, MipError) as error:
            raise Failure(f"{options.port}: {ports.reason(error)}") from None
    return _said(command, outcome, options, device)


def _said(command: Command, outcome: Any, options: argparse.Namespace, device: str | None) -> int:
    if outcome is None:
        _print(options, command, "sent", None, "sent; the device does not answer it", [])
        return 0
    if isinstance(outcome, TimedOut):
        raise Failure(f"{options.port} did not answer {command.NAME}; check the port and --baud", SILENT)
    assert isinstance(outcome, Answer)
    if not outcome.accepted:
        name = values.names(outcome.code)
        raise Failure(f"the device refused {command.NAME}: {name} ({int(outcome.code)})", REFUSED)
    if outcome.error is not None:
        raise Failure(f"the answer to {command.NAME} is wrong: {outcome.error.detail}")
    response = outcome.response
    lines = [] if response is None else list(show.leaves(response, device))
    _print(options, command, "acknowledged", response, "acknowledged", lines)
    return 0


def _print(
    options: argparse.Namespace, command: Command, outcome: str, response: Any, text: str, lines: list[str]
) -> None:
    if options.json:
        held = None if response is None else values.plain(response, True)
        print(json.dumps({"command": command.NAME, "outcome": outcome, "response": held}))
    else:
        print("\n".join(lines) if lines else text)


def _kind(name: str) -> type[Command]:
    kinds = [kind for _, kind in fields(name) if issubclass(kind, Command)]
    if not kinds:
        raise Misuse(f"{name} is not a command; `mip fields --search {name}` finds others")
    if len(kinds) > 1:
        raise Misuse(f"'{name}' is in several sets; write {' or '.join(k.NAME for k in kinds)}")
    return kinds[0]

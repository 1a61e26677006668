"""`mip send`: sends one command, and shows the reply."""

from __future__ import annotations

import argparse
import json
import re
import sys
from typing import Any

from ..binding import Answer, Command, FunctionSelector, NoAnswer, Refused, TimedOut, info, session
from ..devices.known import KnownDevice
from ..errors import Failure, Misuse
from ..names import typed
from ..names.selection import matching_fields
from ..options import add_baud, add_device, line_of, seconds
from ..ports import connection
from ..text import show, values
from ..text.references import references

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
lists the parameters of a command. When `write` changes the baud rate of a serial port, the new rate
is tried and shown; after `load` or `default`, `--baud auto` finds it.

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
    add_baud(parser)


def shielded(words: list[str]) -> list[str]:
    """Prefixes words that begin with a negative number, such as -1,0,0, with a space.

    Otherwise argparse takes them for options.
    """
    return [f" {word}" if _NEGATIVE.match(word) else word for word in words]


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
    if options.hex:
        print(bytes(command.packet()).hex(" "))
        return 0
    device = KnownDevice(options.device)
    patience = {} if options.timeout is None else {"timeout": options.timeout}
    with connection.opened(line_of(options, options.port), **patience) as link:
        if (
            link.baud is not None
            and getattr(command, "baud", None)
            and getattr(command, "function", None) == FunctionSelector.WRITE
        ):
            return _follow(command, options, link)
        (outcome,) = link.exchange(command, timeout=options.timeout)
        if isinstance(outcome, TimedOut):
            raise NoAnswer(command, [outcome])
        if isinstance(outcome, Answer) and not outcome.accepted:
            cause = link.cause(command) if session() else None
            raise Failure(str(Refused(command, outcome.code, cause=cause)), REFUSED)
        if isinstance(outcome, Answer) and _varies(outcome.response):
            device.ask(link)
    for text in device.news():
        print(f"mip send: {text}", file=sys.stderr)
    return _print_outcome(command, outcome, options, device.id)


def _follow(command: Any, options: argparse.Namespace, link: Any) -> int:
    """Changes the baud rate, and shows at which one the device replies."""
    before = link.baud
    try:
        rate = link.change_baud(command)
    except Refused as error:
        raise Failure(str(error), REFUSED) from None
    except NoAnswer:
        message = f"{options.port} answers neither at {before} Bd nor at {command.baud} Bd; try --baud auto"
        raise Failure(message, SILENT) from None
    text = (
        f"acknowledged; use --baud {rate} from now on" if rate != before else "acknowledged; the rate here is the same"
    )
    _print(options, command, "acknowledged", None, None, text, baud=rate)
    return 0


def _varies(response: Any) -> bool:
    """Do values of a response have another meaning on other devices?"""
    parameters = [] if response is None else info(type(response)).parameters
    return any(v.by == "device" for p in parameters for v in p.variants)


def _print_outcome(command: Command, outcome: Any, options: argparse.Namespace, device: str | None) -> int:
    if outcome is None:
        _print(options, command, "sent", device, None, "sent; the device does not answer it")
        return 0
    assert isinstance(outcome, Answer)
    if outcome.error is not None:
        raise Failure(f"the answer to {command.NAME} is wrong: {outcome.error.detail}")
    _print(options, command, "acknowledged", device, outcome.response, "acknowledged")
    return 0


def _print(
    options: argparse.Namespace,
    command: Command,
    outcome: str,
    device: str | None,
    response: Any,
    text: str,
    **more: int,
) -> None:
    inside = {} if response is None else references(response, response.SET)
    if options.json:
        values_by_name = None if response is None else values.to_plain(response, True, device, inside)
        print(json.dumps({"command": command.NAME, "outcome": outcome, "response": values_by_name, **more}))
    else:
        print("\n".join(() if response is None else show.leaves(response, device, inside)) or text)


def _kind(name: str) -> type[Command]:
    kinds = [kind for _, kind in matching_fields(name) if issubclass(kind, Command)]
    if not kinds:
        raise Misuse(f"{name} is not a command; `mip fields --search {name}` finds others")
    if len(kinds) > 1:
        raise Misuse(f"'{name}' is in several sets; write {' or '.join(k.NAME for k in kinds)}")
    return kinds[0]

"""`mip config`: all settings of a device as one file, and back."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import date
from pathlib import Path
from typing import Any

from ..configuration import parsed, written
from ..configuration.settings import UNKNOWN, Place
from ..configuration.talk import Pushed, Talk, differs
from ..errors import Failure, Misuse
from ..files import outputs, signals
from ..options import add_baud, add_device, line_of
from ..ports import connection
from ..ports.listing import REFUSED
from ..text.numbers import count_text

EPILOG = """\
examples:
  mip config pull /dev/ttyACM0 > settings.yaml       all settings, with names and units
  mip config pull /dev/ttyACM0 -o settings.yaml      the same; an older file is kept if it fails
  mip config diff settings.yaml /dev/ttyACM0         what differs; also of two files, or two ports
  mip config push /dev/ttyACM0 settings.yaml         writes what differs; power-off undoes it
  mip config save /dev/ttyACM0                       saves all current settings in flash memory

`push` checks the whole file before it writes anything. It then writes what differs, and reads it
back. Ports and the baud rate are changed last, and restored if the device then stops answering. A
streaming device is set to idle meanwhile and resumes afterwards. Reading a file needs the extra
`yaml` (PyYAML).

exit status: 1 if `diff` finds differences, 3 if the device rejects a setting, 4 if it does not
answer
"""

_NEEDED = {"pull": ("PORT",), "diff": ("FILE", "FILE or PORT"), "push": ("PORT", "FILE"), "save": ("PORT",)}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("action", choices=list(_NEEDED), metavar="ACTION", help=", ".join(_NEEDED))
    add("names", nargs="+", metavar="PORT|FILE", help="a port such as /dev/ttyACM0, COM3, HOST:PORT; a settings file")
    add("-o", dest="output", metavar="FILE", default="-", help="pull: write to this file (default: standard output)")
    add_device(parser)
    add_baud(parser)


def run(options: argparse.Namespace) -> int:
    needed = _NEEDED[options.action]
    if len(options.names) != len(needed):
        raise Misuse(f"`mip config {options.action}` needs {' and '.join(needed)}")
    if options.output != "-" and options.action != "pull":
        raise Misuse("-o is only for `mip config pull`")
    action: Callable[[argparse.Namespace], int] = {"pull": _pull, "diff": _diff, "push": _push, "save": _save}[
        options.action
    ]
    return action(options)


# --------------------------------------------------------------------------- pull and save


def _pull(options: argparse.Namespace) -> int:
    with _talk(options.names[0], options) as talk:
        settings = talk.pull()
    header = (
        talk.model.id if talk.model.profile else talk.listing.title,
        talk.listing.firmware,
        date.today().isoformat(),
    )
    text = written.file_text(settings, talk.profile, *header)
    with outputs.whole(options.output) as file:
        file.write(text.encode("utf-8"))
    outputs.note(f"{options.names[0]}: {talk.profile.title}: {count_text(len(settings), 'setting')}")
    return 0


def _save(options: argparse.Namespace) -> int:
    with _talk(options.names[0], options) as talk:
        saved, refused = talk.save()
    for place, why in refused.items():
        _complain(f"{_named(place, talk.profile)} was not saved: {why}")
    how_many = "all settings" if saved is None else count_text(saved, "setting")
    print(f"{options.names[0]}: {talk.profile.title}: {how_many} saved")
    return REFUSED if refused else 0


# --------------------------------------------------------------------------- push


def _push(options: argparse.Namespace) -> int:
    port, path = options.names[0], Path(options.names[1])
    file = parsed.parsed_settings(path)  # before the device is touched
    with _talk(port, options) as talk:
        own = talk.model.id if talk.model.profile else talk.listing.title
        if own != (file.profile.id or file.model):
            remedy = f"`model: {own}` in the file, to check it for this device"
            raise Failure(f"{path} has the settings of a {file.model}, but {port} is a {own}; write {remedy}")
        file = parsed.parsed_settings(path, talk.profile)
        missing = [place for place, now in talk.read_all(file.commands).items() if now is None]
        if missing:
            messages = [f"{file.at[p]}: this device has no {_named(p, talk.profile)}; remove it" for p in missing]
            raise Failure("\n".join(messages))
        try:
            done = talk.push(file.commands)
        except KeyboardInterrupt:
            _complain("interrupted: some settings may have been written; none were saved")
            raise
        spoken = talk.link.baud
    code = _pushed(port, file, done)
    if spoken != options.baud and spoken is not None and options.baud is not None:
        print(f"{port}: the baud rate is now {spoken}; use --baud {spoken}")
    return code


def _pushed(port: str, file: parsed.File, done: Pushed) -> int:
    for place, why in done.refused.items():
        _complain(f"{file.at[place]}: {_named(place, file.profile)} was refused: {why}")
    for place, now in done.read_differently.items():
        lines = "; ".join(_changes(place, file.commands[place], now, file.profile))
        _complain(f"{file.at[place]}: {_named(place, file.profile)} was written, but reads back differently: {lines}")
    changed = len([place for place in done.written if place not in done.refused])
    same = len(file.commands) - len({*done.written, *done.refused})
    keep = f"; `mip config save {port}` keeps them at power-off" if changed else ""
    print(f"{port}: {count_text(changed, 'setting')} changed, {same} as before, {len(done.refused)} refused{keep}")
    return REFUSED if done.refused or done.read_differently else 0


# --------------------------------------------------------------------------- diff


def _diff(options: argparse.Namespace) -> int:
    (a, profile, model_a), (b, other, model_b) = (_settings_of(name, options) for name in options.names)
    lines = [] if model_a == model_b else [f"model: {model_a} -> {model_b}"]
    for place in {**a, **b}:
        if place not in a or place not in b:
            where = options.names[0 if place in a else 1]
            lines.append(f"{_named(place, profile if place in a else other)}: only in {where}")
        elif differs(a[place], b[place]):
            lines.append(f"{_named(place, profile)}: {'; '.join(_changes(place, a[place], b[place], profile))}")
    for line in lines:
        print(line)
    return 1 if lines else 0


def _settings_of(name: str, options: argparse.Namespace) -> tuple[dict[Place, Any], Any, str]:
    """Reads the settings, the profile and the model from a file or a device."""
    if os.path.isfile(name) or name.endswith((".yaml", ".yml")):
        file = parsed.parsed_settings(Path(name))
        return file.commands, file.profile, file.profile.id or file.model
    with _talk(name, options) as talk:
        return talk.pull(), talk.profile, talk.model.id if talk.model.profile else talk.listing.title


def _changes(place: Place, before: Any, after: Any, profile: Any) -> Iterator[str]:
    """Yields the differences between two values of a setting, one per parameter."""
    if before is None or after is None:
        yield "it cannot be read" if after is None else "it could not be read"
        return
    a, b = (written.written_values(place, value, profile) for value in (before, after))
    for name in {**a, **b}:
        if a.get(name) != b.get(name):
            texts = (written.flow(x[name]) if name in x else "nothing" for x in (a, b))
            yield f"{name} {' -> '.join(texts)}"


def _named(place: Place, profile: Any) -> str:
    family, name, *keys = written.path_of(place, profile or UNKNOWN)
    return " ".join([f"{family}.{name}", *keys])


# --------------------------------------------------------------------------- devices


@contextmanager
def _talk(port: str, options: argparse.Namespace) -> Iterator[Talk]:
    """Opens the port of a device and sets it to idle. Resumes its streams afterwards, even after an interrupt."""
    with (
        signals.handled(signals.interrupt),
        connection.opened(line_of(options, port)) as link,
        Talk.idle(link, port, _complain),
    ):
        yield Talk(link, port, _complain, options.device)


def _complain(text: str) -> None:
    print(f"mip config: {text}", file=sys.stderr)

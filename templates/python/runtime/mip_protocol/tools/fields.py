"""`mip fields`: the specification, in a terminal."""

from __future__ import annotations

import argparse
import json
import shutil
from typing import Any

from .. import registry
from ..errors import Failure
from ..field import Field
from . import show
from .selection import fields, keys

EPILOG = """\
examples:
  mip fields                          the descriptor sets
  mip fields sensor                   the fields of a set
  mip fields sensor.scaled_accel      one field; 0x80:0x04 and a vendor's name find it, too
  mip fields --search temperature     what has this word
  mip fields 3dm --device 3dm-gx5-15  what a device has
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("name", nargs="?", metavar="NAME", help="a set or a field")
    add("--search", metavar="TEXT", help="fields that have this text in their name or description")
    add("--device", metavar="DEVICE", help="what this device has")
    add("--json", action="store_true", help="print JSON, for programs")


def run(options: argparse.Namespace) -> int:
    chosen = _chosen(options)
    if options.json:
        print(json.dumps([as_json(number, kind) for number, kind in chosen], indent=2))
    elif options.name is None and options.search is None and options.device is None:
        for number in registry.MODULES:
            count = sum(1 for set, _ in chosen if set == number)
            print(f"0x{number:02X}  {show.set_name(number):<16} {count:>3} fields")
    elif options.name is not None and len({kind.NAME for _, kind in chosen}) == 1:
        for i, (_, kind) in enumerate(chosen):
            print("\n" * (i > 0) + text(kind))
    else:
        width = max((len(kind.NAME) for _, kind in chosen), default=0)
        for number, kind in chosen:
            print(
                f"0x{number:02X},0x{kind.DESCRIPTOR:02X}  {kind.NAME:<{width}}  "
                f"{kind.ROLE:<8}  {kind.INFO.title}"
            )
    return 0


def _chosen(options: argparse.Namespace) -> list[tuple[int, type[Field]]]:
    found = registry.all_types()
    if options.name is not None:
        wanted = keys(options.name)
        within = [k for k in found if (k[0], None) in wanted or (k[0], k[1].DESCRIPTOR) in wanted]
        if all(descriptor is not None for _, descriptor in wanted):
            try:  # a response may have the descriptor of another one
                names = {kind.NAME for _, kind in fields(options.name)}
                within = [k for k in within if k[1].NAME in names]
            except Failure:
                pass
        found = within
        if not found:
            raise Failure(f"the specification has no {options.name}; `mip fields` lists the sets")
    if options.device is not None:
        from ..simulator.profiles import device_named

        profile = device_named(options.device)
        found = [k for k in found if _supports(profile, *k)]
    if options.search is not None:
        found = [k for k in found if options.search.lower() in _searched(k[1])]
    if not found:
        raise Failure("no field has all of this; ask for less")
    return found


def _supports(profile: Any, number: int, kind: type[Field]) -> bool:
    commands = getattr(kind, "COMMANDS", ())
    if kind.ROLE == "response":
        return any(profile.may_support(c.SET, c.DESCRIPTOR) for c in commands)
    return bool(profile.may_support(number, kind.DESCRIPTOR))


def _searched(kind: type[Field]) -> str:
    known = info(kind)
    parts = [known.name, known.title, known.text, *known.also]
    for p in known.parameters:
        parts += [p.name, p.text]
    return " ".join(parts).lower()


# --------------------------------------------------------------------------- for people


def text(kind: type[Field]) -> str:
    """All that is known of a field."""
    width = min(shutil.get_terminal_size().columns, 100)
    known = info(kind)
    lines = [
        f"{known.name} (0x{kind.SET:02X},0x{kind.DESCRIPTOR:02X}), {known.role}: {known.title}"
    ]
    return "\n".join(lines)

"""`mip fields`: shows the specification in a terminal."""

from __future__ import annotations

import argparse
import json
import sys
from collections import defaultdict
from typing import Any

from ..binding import DEVICES, Field, Response, info, registry
from ..errors import Failure, Misuse
from ..names.occurrence import Occurrence
from ..names.search import all_fields, missing, ranked
from ..names.selection import matching_fields, resolve_keys
from ..options import add_device
from ..text import field_texts, show

EPILOG = """\
examples:
  mip fields                          the descriptor sets
  mip fields sensor                   the fields of a set
  mip fields sensor.scaled_accel      one field; 0x80:0x04 and the vendor's name also work
  mip fields --search gyro bias       fields with these words, the best first
  mip fields 3dm --device 3dm-gx5-15  only the fields of a device
  mip fields --devices                the devices
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("name", nargs="*", metavar="NAME", help="a set or a field; several words are searched")
    add("--search", nargs="+", metavar="WORD", help="fields that have these words, the best first")
    add_device(parser, "only the fields of this device")
    add("--devices", action="store_true", help="list the devices")
    add("--json", action="store_true", help="print a JSON object for each field or device, one per line")


def run(options: argparse.Namespace) -> int:
    if options.devices and options.json:
        for device in DEVICES.values():
            print(json.dumps({"device": device.id, "title": device.title, "incomplete": device.incomplete}))
        return 0
    if options.devices:
        width = max((len(name) for name in DEVICES), default=0)
        for device in DEVICES.values():
            incomplete = f" (incomplete: {field_texts.extent(device)})" if device.incomplete else ""
            print(f"{device.id:<{width}}  {device.title}{incomplete}")
        return 0
    words = options.search or (options.name if options.name[1:] else [])
    options.search = " ".join(words) if words else None
    options.name = options.name[0] if len(options.name) == 1 else None
    chosen = _chosen(options)
    if options.json:
        print("\n".join(json.dumps(field_texts.as_json(field)) for field in chosen))
    elif options.name is None and options.search is None and options.device is None:
        for number in registry.MODULES:
            count = sum(1 for set_number, _ in chosen if set_number == number)
            print(f"0x{number:02X}  {show.set_name(number):<16} {count:>3} fields")
    elif options.name is not None and len({field.name for field in chosen}) == 1:
        for i, field in enumerate(chosen):
            print("\n" * (i > 0) + field_texts.text(field))
    else:
        print("\n".join(_lines(chosen, by_kind=options.search is not None)))
    return 0


def _lines(fields: list[Occurrence], by_kind: bool) -> list[str]:
    """Returns a line for each occurrence of a field, or one for each field that names its other sets."""
    groups: dict[object, list[Occurrence]] = defaultdict(list)
    for field in fields:
        groups[field.kind if by_kind else field].append(field)
    width = max((len(first.name) for first, *_ in groups.values()), default=0)
    lines = []
    for (number, kind), *others in groups.values():
        name = kind.name_in(number)
        also = "; also in " + ", ".join(f"0x{one.set:02X}" for one in others) if others else ""
        text = f"{name:<{width}}  {kind.ROLE:<8}  {info(kind).title}{also}"
        lines.append(f"0x{number:02X},0x{kind.DESCRIPTOR:02X}  {text}")
    return lines


def _chosen(options: argparse.Namespace) -> list[Occurrence]:
    kinds = all_fields()
    if options.name is not None:
        wanted = resolve_keys(options.name)
        if wanted[0][1] is None:
            kinds = [k for k in kinds if k[0] == wanted[0][0]]
        else:
            named = matching_fields(options.name)
            kinds = [k for k in kinds if k in named]
        if not kinds:
            raise Misuse(f"the specification has no {options.name}; `mip fields` lists the sets")
    if options.device is not None:
        profile = DEVICES[options.device]
        kinds = [k for k in kinds if _supports(profile, *k)]
    if options.search is not None:
        kinds = ranked(kinds, options.search)
        for word, other in missing(options.search) if kinds else ():
            more = f"; searched for '{other}'" if other else ""
            print(f"mip fields: nothing has '{word}'{more}", file=sys.stderr)
    if not kinds:
        raise Failure(_nothing(options))
    return kinds


def _nothing(options: argparse.Namespace) -> str:
    """Reports why no field is found."""
    if options.search is None or options.name is not None or options.device is not None:
        return "no field matches NAME, --search and --device together; leave one out"
    return f"no field has a word of '{options.search}'; `mip fields` lists the sets"


def _supports(profile: Any, number: int, kind: type[Field]) -> bool:
    if issubclass(kind, Response):
        return any(profile.has(c.SET, c.DESCRIPTOR) for c in kind.COMMANDS)
    return bool(profile.has(number, kind.DESCRIPTOR))

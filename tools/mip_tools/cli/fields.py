"""`mip fields`: shows the specification in a terminal."""

from __future__ import annotations

import argparse
import difflib
import json
import re
import shutil
import textwrap
from collections.abc import Iterable
from typing import Any

from ..binding import Command, EnumInfo, Field, Parameter, Response, Structure, info, registry
from ..errors import Failure, Misuse
from ..occurrence import Occurrence
from . import show, typed
from .selection import fields, keys

EPILOG = """\
examples:
  mip fields                          the descriptor sets
  mip fields sensor                   the fields of a set
  mip fields sensor.scaled_accel      one field; 0x80:0x04 and the vendor's name also work
  mip fields --search temperature     all fields with this word
  mip fields 3dm --device 3dm-gx5-15  only the fields of a device
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("name", nargs="?", metavar="NAME", help="a set or a field")
    add("--search", metavar="TEXT", help="fields that have this text in their name or description")
    add("--device", metavar="DEVICE", help="only the fields of this device")
    add("--json", action="store_true", help="print JSON, for programs")


def run(options: argparse.Namespace) -> int:
    chosen = _chosen(options)
    if options.json:
        print(json.dumps([as_json(one) for one in chosen], indent=2))
    elif options.name is None and options.search is None and options.device is None:
        for number in registry.MODULES:
            count = sum(1 for set, _ in chosen if set == number)
            print(f"0x{number:02X}  {show.set_name(number):<16} {count:>3} fields")
    elif options.name is not None and len({one.name for one in chosen}) == 1:
        for i, one in enumerate(chosen):
            print("\n" * (i > 0) + text(one))
    else:
        width = max((len(one.name) for one in chosen), default=0)
        for one in chosen:
            number, kind = one
            print(f"0x{number:02X},0x{kind.DESCRIPTOR:02X}  {one.name:<{width}}  {kind.ROLE:<8}  {info(kind).title}")
    return 0


def _chosen(options: argparse.Namespace) -> list[Occurrence]:
    kinds = _all()
    if options.name is not None:
        wanted = keys(options.name)
        if wanted[0][1] is None:
            kinds = [k for k in kinds if k[0] == wanted[0][0]]
        else:
            named = fields(options.name)
            kinds = [k for k in kinds if k in named]
        if not kinds:
            raise Misuse(f"the specification has no {options.name}; `mip fields` lists the sets")
    if options.device is not None:
        from ..simulator.profiles import device_named

        profile = device_named(options.device)
        kinds = [k for k in kinds if _supports(profile, *k)]
    if options.search is not None:
        kinds = [k for k in kinds if options.search.lower() in _searched(k)]
    if not kinds:
        raise Failure(_nothing(options))
    return kinds


def _nothing(options: argparse.Namespace) -> str:
    """Reports why no field is found, and suggests names."""
    if options.search is None or options.name is not None or options.device is not None:
        return "no field matches NAME, --search and --device together; leave one out"
    words = {word for k in _all() for word in re.split(r"[._]", k.name)}
    close = difflib.get_close_matches(options.search.lower(), sorted(words), 3)
    remedy = f"did you mean {' or '.join(close)}?" if close else "`mip fields` lists the sets"
    return f"no field has '{options.search}' in its name or description; {remedy}"


def has_words(text: str) -> bool:
    """Does a search find any field?"""
    return any(text.lower() in _searched(one) for one in _all())


def _supports(profile: Any, number: int, kind: type[Field]) -> bool:
    if issubclass(kind, Response):
        return any(profile.has(c.SET, c.DESCRIPTOR) for c in kind.COMMANDS)
    return bool(profile.has(number, kind.DESCRIPTOR))


def _all() -> list[Occurrence]:
    return [Occurrence(*pair) for pair in registry.all_types()]


def _searched(one: Occurrence) -> str:
    known = info(one.kind)
    parts = [one.name, known.title, known.text, *known.also]
    for p in known.parameters:
        parts += [p.name, p.text]
    return " ".join(parts).lower()


# --------------------------------------------------------------------------- for people


def text(one: Occurrence) -> str:
    """Describes a field completely."""
    number, kind = one
    known = info(kind)
    lines = [f"{one.name} (0x{number:02X},0x{kind.DESCRIPTOR:02X}), {known.role}", known.title]
    lines += ["", *_wrapped(known.text, "")]
    lines += _command(kind)
    shown: list[type] = []
    if known.parameters:
        lines += ["", "parameters"]
        _parameters(known.parameters, "  ", lines, shown)
    for type in shown:
        lines += ["", *_type(type)]
    if known.sources:
        lines += ["", "sources", *(f"  {source}" for source in known.sources)]
    return "\n".join(lines)


def _wrapped(said: str, indent: str) -> list[str]:
    width = min(shutil.get_terminal_size().columns, 100)
    return textwrap.wrap(said, max(width, 40), initial_indent=indent, subsequent_indent=indent)


def _command(kind: type[Field]) -> list[str]:
    if issubclass(kind, Response):
        return [f"answers {', '.join(c.NAME for c in kind.COMMANDS)}"] if kind.COMMANDS else []
    if not issubclass(kind, Command):
        return []
    lines = []
    functions = typed.functions(kind)
    if functions:
        lines.append(f"functions: {', '.join(functions)}")
    if kind.RESPONSES:
        lines.append(f"answered with {', '.join(r.NAME for r in kind.RESPONSES)}")
    for function in functions or [""]:
        names = typed.wanted(kind, function)
        lines.append(" ".join(("mip send PORT", kind.NAME, function, *names)).replace("  ", " "))
    return ["", *lines] if lines else []


def _parameters(parameters: Iterable[Parameter], indent: str, lines: list[str], shown: list[type]) -> None:
    for p in parameters:
        unit = f" [{p.unit}]" if p.unit not in ("", "1") else ""
        lines.append(f"{indent}{p.name}: {p.layout}{unit}")
        lines += _wrapped(p.text, f"{indent}    ")
        for case in p.cases.values():
            if case is not None:
                _parameters((case,), f"{indent}  ", lines, shown)
        if isinstance(p.type, type) and issubclass(p.type, Structure):
            _parameters(info(p.type).parameters, f"{indent}  ", lines, shown)
        elif isinstance(p.type, type) and p.type not in shown:
            shown.append(p.type)


def _type(kind: Any) -> list[str]:
    known: Any = info(kind)
    lines = [f"{known.name}: {known.text}".rstrip(": ")]
    if isinstance(known, EnumInfo):
        rows = [(str(v.value), v.name, v.text) for v in known.values]
    else:
        rows = [(str(b.first) if b.first == b.last else f"{b.first}-{b.last}", b.name, b.text) for b in known.bits]
    widths = [max((len(row[i]) for row in rows), default=0) for i in range(2)]
    what = "value" if isinstance(known, EnumInfo) else "bit"
    for number, name, said in rows:
        lines.append(f"  {what} {number:>{widths[0]}}  {name:<{widths[1]}}  {said}".rstrip())
    return lines


# --------------------------------------------------------------------------- for programs


def as_json(one: Occurrence) -> dict[str, Any]:
    """Describes a field for JSON."""
    number, kind = one
    known = info(kind)
    return {
        "name": one.name,
        "set": number,
        "descriptor": kind.DESCRIPTOR,
        "role": known.role,
        "title": known.title,
        "text": known.text,
        "also": known.also,
        "functions": known.functions,
        "devices": known.devices,
        "perhaps": known.perhaps,
        "sources": known.sources,
        "parameters": [_parameter(p) for p in known.parameters],
    }


def _parameter(p: Parameter) -> dict[str, Any]:
    row: dict[str, Any] = {
        "name": p.name,
        "layout": p.layout,
        "text": p.text,
        "units": p.units,
        "frame": p.frame,
        "valid": p.valid,
        "range": p.range,
        "default": p.default,
    }
    if p.cases:
        row["cases"] = {tag: c and _parameter(c) for tag, c in p.cases.items()}
    if isinstance(p.type, type) and issubclass(p.type, Structure):
        row["parameters"] = [_parameter(q) for q in info(p.type).parameters]
    elif isinstance(p.type, type):
        known: Any = info(p.type)
        enum = isinstance(known, EnumInfo)
        row["values" if enum else "bits"] = (
            {v.name: v.value for v in known.values} if enum else {b.name: b.mask for b in known.bits}
        )
    return row

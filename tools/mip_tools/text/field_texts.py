"""Describes fields completely: as text for people, and as JSON for programs."""

from __future__ import annotations

import shutil
import textwrap
from collections.abc import Iterable
from typing import Any

from ..binding import Command, Device, EnumInfo, Field, Parameter, Response, Structure, info
from ..names import typed
from ..names.occurrence import Occurrence
from .numbers import count_text


def text(occurrence: Occurrence) -> str:
    """Describes a field completely."""
    number, kind = occurrence
    about = info(kind)
    lines = [f"{occurrence.name} (0x{number:02X},0x{kind.DESCRIPTOR:02X}), {about.role}", about.title]
    lines += ["", *_wrapped(about.text, "")]
    lines += _command(kind)
    shown: list[type] = []
    if about.parameters:
        lines += ["", "parameters"]
        _parameters(about.parameters, "  ", lines, shown)
    for shown_type in shown:
        lines += ["", *_type(shown_type)]
    if about.sources:
        lines += ["", "sources", *(f"  {source}" for source in about.sources)]
    return "\n".join(lines)


def extent(profile: Device) -> str:
    """States how many commands and data fields a device has."""
    commands = sum(1 for set_number, _ in profile.fields if set_number < 0x80)
    return f"{count_text(commands, 'command')}, {count_text(len(profile.fields) - commands, 'data field')}"


def _wrapped(text: str, indent: str) -> list[str]:
    width = min(shutil.get_terminal_size().columns, 100)
    return textwrap.wrap(text, max(width, 40), initial_indent=indent, subsequent_indent=indent)


def _command(kind: type[Field]) -> list[str]:
    if issubclass(kind, Response):
        return [f"answers {', '.join(c.NAME for c in kind.COMMANDS)}"] if kind.COMMANDS else []
    if not issubclass(kind, Command):
        return []
    lines = []
    functions = typed.constructor_functions(kind)
    if functions:
        lines.append(f"functions: {', '.join(functions)}")
    if kind.RESPONSES:
        lines.append(f"answered with {', '.join(r.NAME for r in kind.RESPONSES)}")
    for function in functions or [""]:
        names = typed.value_names(kind, function)
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
        for kind in _types(p):
            if issubclass(kind, Structure):
                _parameters(info(kind).parameters, f"{indent}  ", lines, shown)
            elif kind not in shown:
                shown.append(kind)


def _types(p: Parameter) -> list[type]:
    """Returns the type of a parameter, or those that name its values on some devices or in some cases."""
    kinds = [p.type] if isinstance(p.type, type) else [v.changes.get("type") for v in p.variants]
    return [kind for kind in dict.fromkeys(kinds) if isinstance(kind, type)]


def _type(kind: Any) -> list[str]:
    about: Any = info(kind)
    lines = [f"{about.name}: {about.text}".rstrip(": ")]
    if isinstance(about, EnumInfo):
        rows = [(str(v.value), v.name, v.text) for v in about.values]
    else:
        rows = [(str(b.first) if b.first == b.last else f"{b.first}-{b.last}", b.name, b.text) for b in about.bits]
    widths = [max((len(row[i]) for row in rows), default=0) for i in range(2)]
    what = "value" if isinstance(about, EnumInfo) else "bit"
    for number, name, meaning in rows:
        lines.append(f"  {what} {number:>{widths[0]}}  {name:<{widths[1]}}  {meaning}".rstrip())
    return lines


def as_json(occurrence: Occurrence) -> dict[str, Any]:
    """Describes a field for JSON."""
    number, kind = occurrence
    about = info(kind)
    return {
        "name": occurrence.name,
        "set": number,
        "descriptor": kind.DESCRIPTOR,
        "role": about.role,
        "title": about.title,
        "text": about.text,
        "also": about.also,
        "functions": about.functions,
        "devices": about.devices,
        "likely": about.likely,
        "assumed": about.assumed,
        "sources": about.sources,
        "parameters": [_parameter(p) for p in about.parameters],
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
        row |= _names(p.type)
    elif p.variants:
        kinds = [(v, v.changes.get("type")) for v in p.variants]
        row["variants"] = [
            {"by": v.by, "keys": list(v.keys)} | _names(kind) for v, kind in kinds if isinstance(kind, type)
        ]
    return row


def _names(kind: type) -> dict[str, Any]:
    """Returns the values or the bits of a type, and the states in which bits mean something."""
    about: Any = info(kind)
    if isinstance(about, EnumInfo):
        return {"values": {v.name: v.value for v in about.values}}
    states = {b.name: {b.state[0]: list(b.state[1])} for b in about.bits if b.state}
    return {"bits": {b.name: b.mask for b in about.bits}} | ({"states": states} if states else {})

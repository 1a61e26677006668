"""Writes settings as YAML text."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from enum import IntFlag
from typing import Any

from ..binding import Device, Parameter, Structure, info, meant
from ..devices.checks import set_of
from ..text import yaml_text
from ..text.values import rounded, value_text
from .settings import Place, on, own_parameters
from .words import name_for

WIDTH = 110

HEAD = """\
# Settings of a device. `mip config push PORT FILE` writes them to a device, and `mip config save PORT` makes it keep
# them. A setting that is removed from the file remains as it is on the device.
"""

#: Values as in the file: words, in mappings and lists.
Tree = dict[str, Any] | list[Any] | str


def file_text(commands: Mapping[Place, Any], profile: Device, model: str, firmware: str, date: str) -> str:
    """Composes the whole file. The value of a setting is a command, or a response with the same parameters."""
    title = f"  # {profile.title}, model number {profile.model_number}" if profile.model_number else ""
    lines = [
        f"model: {yaml_text.scalar_text(model)}{title}",
        f"firmware: {yaml_text.scalar_text(firmware)}",
        f"date: {date}",
    ]
    lines.append("settings:" if commands else "settings: {}")
    before: tuple[str, ...] = ()
    for place, value in commands.items():
        path = tuple(path_of(place, profile))
        alone = len(path) == 2
        units = dict(_units(own_parameters(place.kind), value if alone else None))
        same = next((i for i, (a, b) in enumerate(zip(before, path)) if a != b), len(before))
        for i in range(same, len(path) - 1):
            lines.append(f"{'  ' * (i + 1)}{path[i]}:{_comment(units) if i == 1 else ''}")
        indent = "  " * len(path)
        lines += _lines(f"{indent}{path[-1]}:", written_values(place, value, profile), indent, units if alone else {})
        before = path
    return HEAD + "\n".join(lines) + "\n"


def path_of(place: Place, profile: Device) -> list[str]:
    """Returns the keys above the values of a setting in the file: set, command, and the selectors of an instance."""
    family, _, name = place.command.partition(".")
    keys = []
    for attribute in selectors(place.kind, place.keys):
        p = info(place.kind)[attribute]
        keys.append(name_for(on(p, profile), place.selected[attribute], _set(p, place.selected), profile))
    return [yaml_text.scalar_text(x) if not x.isdigit() else x for x in (family, name, *keys)]


def selectors(kind: type[Any], keys: Iterable[str]) -> list[str]:
    """Returns the parameters that are keys in the file."""
    return [name for name in keys if not info(kind)[name].reserved]


def _set(p: Parameter, beside: Mapping[str, Any]) -> int | None:
    return set_of(p, Beside(beside))


class Beside:
    """Values as attributes, in which a parameter looks up the values that it depends on."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        self._values = values

    def __getattr__(self, name: str) -> Any:
        return self._values.get(name)


# --------------------------------------------------------------------------- values


def written_values(place: Place, command: Any, profile: Device) -> dict[str, Tree]:
    """Returns the values of a setting as in the file, without those that select the instance."""
    return _members(
        command, [p for p in own_parameters(place.kind) if p.attribute not in place.selected], profile, None
    )


def _members(record: Any, members: list[Parameter], profile: Device, inside: int | None) -> dict[str, Tree]:
    tree: dict[str, Tree] = {}
    for p in members:
        value = getattr(record, p.attribute)
        if value is not None:
            tree[p.name] = _tree(p.of(record, profile.id or None), value, record, profile, inside)
    return tree


def _tree(p: Parameter, value: Any, record: Any, profile: Device, inside: int | None) -> Tree:
    """Converts a value to words. `inside`: the set of the field descriptors in a structure."""
    set_number = set_of(p, record) if p.fields_of else inside
    if p.kind == "switch":
        case = p.cases.get(getattr(record, p.tag))
        return _tree(case, value, record, profile, set_number) if case else value_text(p, value)
    if isinstance(value, Structure):
        return _members(value, own_parameters(type(value)), profile, set_number)
    if isinstance(value, (tuple, list)):
        if p.elements and p.length is None:
            return {name: rounded(x, p.scalar) for name, x in zip(p.elements, value)}
        return [_tree(replace(p, length=None, fields_of=""), x, record, profile, set_number) for x in value]
    return _word(p, value, set_number, profile)


def _word(p: Parameter, value: Any, set_number: int | None, profile: Device) -> Tree:
    if isinstance(value, str):
        return yaml_text.quoted(value)
    if isinstance(value, float):
        return rounded(value, p.scalar)
    if isinstance(meant(p, value), IntFlag):
        return [] if not value else value_text(p, value).split("|")
    if p.refers or (p.type is not None and p.scalar != "bool"):
        text = name_for(p, int(value), set_number, profile)
        return text if text[0].isdigit() else yaml_text.scalar_text(text)
    return value_text(p, value)


# --------------------------------------------------------------------------- lines


def _lines(head: str, tree: Tree, indent: str, units: Mapping[str, str]) -> Iterator[str]:
    """Writes a key with its value, on one line if it fits, else on several."""
    whole = f"{head} {flow(tree)}"
    comment = _comment(units, head.strip(" :"))
    plain = isinstance(tree, str) or not any(isinstance(x, (dict, list)) for x in _inner(tree))
    if len(whole + comment) <= WIDTH or (plain and not isinstance(tree, dict)):
        yield whole + comment
    elif isinstance(tree, dict):
        yield head
        for name, inner in tree.items():
            own = {k: unit for k, unit in units.items() if k == name or k in _names(inner)}
            yield from _lines(f"{indent}  {name}:", inner, indent + "  ", own)
    else:
        yield head + comment
        yield from (f"{indent}  - {flow(inner)}" for inner in tree)


def _inner(tree: Tree) -> list[Any]:
    return list(tree.values()) if isinstance(tree, dict) else tree if isinstance(tree, list) else []


def _names(tree: Tree) -> set[str]:
    """Returns all names in a tree."""
    own = set(tree) if isinstance(tree, dict) else set[str]()
    return own.union(*map(_names, _inner(tree)))


def _comment(units: Mapping[str, str], key: str = "") -> str:
    """Writes the comment about units.

    >>> _comment({"roll": "rad", "pitch": "rad", "rate": "Hz"}), _comment({"rate": "Hz"}, "rate")
    ('  # roll, pitch in rad; rate in Hz', '  # Hz')
    """
    by_unit: dict[str, list[str]] = {}
    for name, unit in units.items():
        by_unit.setdefault(unit, []).append(name)
    comment = "; ".join(unit if names == [key] else f"{', '.join(names)} in {unit}" for unit, names in by_unit.items())
    return f"  # {comment}" if comment else ""


def flow(tree: Tree) -> str:
    """Writes a value on one line.

    >>> flow({"a": "1", "b": ["x", "y"]})
    '{a: 1, b: [x, y]}'
    """
    if isinstance(tree, dict):
        return f"{{{', '.join(f'{name}: {flow(x)}' for name, x in tree.items())}}}"
    return f"[{', '.join(map(flow, tree))}]" if isinstance(tree, list) else tree


def _units(members: list[Parameter], record: Any = None) -> Iterator[tuple[str, str]]:
    """Yields the parameters that have a unit, with their units; some depend on other values."""
    for p in members:
        here = p if record is None else p.of(record)
        cases = [case for case in p.cases.values() if case is not None]
        for q in cases or [here]:
            if isinstance(q.type, type) and issubclass(q.type, Structure):
                yield from _units(own_parameters(q.type))
            elif set(q.units) - {"1"}:
                yield p.name, q.unit + (f" ({q.name})" if cases else "")

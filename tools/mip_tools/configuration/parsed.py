"""Reads settings from a file; reports each mistake with its position and the remedy."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import IntFlag
from pathlib import Path
from typing import Any

from ..binding import DEVICES, Device, EncodeError, Parameter, Structure, UnknownName, device_id, info
from ..devices.checks import SAME, in_limits, set_of
from ..devices.facts import mask_of
from ..devices.settings import stored_by
from ..errors import Failure
from ..names import typed
from ..text.yaml_reader import Wrong, YamlReader, hint, kind_of
from .settings import UNKNOWN, Place, on, own_parameters, settings, stored_settings
from .words import accepted_names
from .written import Beside, selectors

#: The first descriptor of shared data.
SHARED = 0xD0

KEYS = ("model", "firmware", "date", "settings")


@dataclass
class File:
    """The settings in a file, each with its position."""

    path: Path
    model: str
    profile: Device
    commands: dict[Place, Any] = field(default_factory=dict)
    at: dict[Place, str] = field(default_factory=dict)


def parsed_settings(path: Path, device: Device | None = None) -> File:
    """Reads a file, and checks it for `device`, if given: a device that has reported its fields.

    Raises Failure with all mistakes.
    """
    return _Reader(path, device).file()


class _Reader(YamlReader):
    def __init__(self, path: Path, device: Device | None) -> None:
        super().__init__(path)
        self.profile = UNKNOWN
        self.device = device

    def file(self) -> File:
        root = self.root("a settings file; `mip config pull` writes one")
        parts = self.keys(root, KEYS, "a settings file")
        if "model" not in parts:
            self.wrong(Wrong(root, "'model' is missing; add the name of the device, as `mip config pull` does"))
        model = str(parts["model"].value) if "model" in parts else ""
        try:
            self.profile = DEVICES[device_id(model)]
        except UnknownName as error:
            if error.near and "model" in parts and "did you mean" in error.detail:
                self.wrong(Wrong(parts["model"], error.detail))
        file = File(self.path, model, self.profile)
        if "settings" in parts:
            self.families(parts["settings"], file)
        elif not self.mistakes:
            self.wrong(Wrong(root, "'settings' is missing; `mip config pull` writes a complete file"))
        self.end()
        return file

    # ----------------------------------------------------------------- commands

    def families(self, node: Any, file: File) -> None:
        by_family: dict[str, list[str]] = {}
        for name in settings():
            family, _, own = name.partition(".")
            by_family.setdefault(family, []).append(own)
        for family, commands in self.keys(node, by_family, "'settings'").items():
            for own, values in self.keys(commands, by_family[family], f"'{family}'").items():
                kind = settings()[f"{family}.{own}"]
                if self.device is None or self.has(kind, commands, own):
                    self.instances(kind, selectors(kind, Place(kind.NAME).keys), {}, values, values, file)

    def has(self, kind: Any, node: Any, own: str) -> bool:
        """Does the device have this setting, with this command?"""
        assert self.device is not None
        available = stored_settings(self.device)
        if kind in available:
            return True
        key = next(key for key, _ in node.value if key.value == own)
        others = [other.NAME for other in available if stored_by(other) is stored_by(kind)]
        instead = f"use {others[0]} instead" if others else "remove it"
        self.wrong(Wrong(key, f"this device has no setting '{kind.NAME}'; {instead}"))
        return False

    def instances(self, kind: Any, rest: list[str], selected: dict[str, int], key: Any, node: Any, file: File) -> None:
        """Reads the values of a setting, which are below the keys that select its instances."""
        if not rest:
            self.setting(kind, selected, key, node, file)
            return
        p = info(kind)[rest[0]]
        for inner, values in self.pairs(node, f"'{kind.NAME}'"):
            try:
                number = self.word(on(p, self.profile), inner, set_of(p, Beside(selected)))
                self.check(on(p, self.profile), number, inner, set_of(p, Beside(selected)))
            except Wrong as mistake:
                self.wrong(mistake)
                continue
            self.instances(kind, rest[1:], {**selected, p.attribute: int(number)}, inner, values, file)

    def setting(self, kind: Any, selected: dict[str, int], key: Any, node: Any, file: File) -> None:
        before = len(self.mistakes)
        place = Place.selected_by(kind.NAME, selected)
        members = [p for p in own_parameters(kind) if p.attribute not in place.selected]
        required = {p.attribute for p in members if "write" in p.required}
        values = self.members(kind.NAME, node, members, required, {**place.selected}, None)
        if len(self.mistakes) > before:
            return
        try:
            command = kind.write(**{n: v for n, v in values.items() if not info(kind)[n].reserved})
            command.packet()
        except EncodeError as error:
            self.wrong(Wrong(node, f"'{kind.NAME}' cannot be sent: {error.detail}"))
            return
        if place in file.commands:
            self.wrong(Wrong(key, f"this setting is already at {file.at[place]}; remove one"))
            return
        file.commands[place], file.at[place] = command, self.place(key)

    def members(
        self,
        what: str,
        node: Any,
        members: list[Parameter],
        required: set[str],
        values: dict[str, Any],
        set_number: int | None,
    ) -> dict[str, Any]:
        """Reads the values of parameters, in an order in which each finds the values that it depends on."""
        before = len(self.mistakes)
        nodes = self.keys(node, [p.name for p in members], f"'{what}'")
        unknown = len(self.mistakes) > before  # an unknown key may be a misspelled parameter
        missing = []
        for p in sorted(members, key=_depends):
            if p.name in nodes:
                here = p.of(Beside(values), self.profile.id or None)  # type: ignore[arg-type]
                try:
                    values[p.attribute] = self.value(here, nodes[p.name], values, set_number)
                except Wrong as mistake:
                    self.wrong(mistake)
                    values[p.attribute] = None
            elif p.kind == "switch" and p.cases.get(values.get(p.tag, 0)) is None:
                values[p.attribute] = None
            elif p.attribute in required:
                missing.append(p.name)
        if missing and not unknown:
            self.wrong(Wrong(node, f"'{what}' needs {', '.join(missing)} too"))
        return values

    # ----------------------------------------------------------------- values

    def value(self, p: Parameter, node: Any, values: Mapping[str, Any], inside: int | None) -> Any:
        set_number = set_of(p, Beside(values)) if p.fields_of else inside
        if p.kind == "switch":
            case = p.cases.get(values.get(p.tag) or 0)
            if case is None:
                raise Wrong(node, f"'{p.name}' is not used with this '{p.tag}'; remove it")
            return self.value(replace(case, name=p.name), node, values, set_number)
        if p.length is not None and p.kind == "array":
            return self.items(replace(p, length=None, fields_of=""), node, values, set_number, p.length)
        if isinstance(p.type, type) and issubclass(p.type, Structure):
            return self.structure(p, node, set_number)
        if p.elements:
            return self.vector(p, node)
        return self.element(p, node, set_number)

    def items(
        self, p: Parameter, node: Any, values: Mapping[str, Any], set_number: int | None, length: Any
    ) -> tuple[Any, ...]:
        if kind_of(node) != "sequence":
            raise Wrong(node, f"'{p.name}' needs a list, [...]")
        if isinstance(length, int) and len(node.value) != length:
            raise Wrong(node, f"'{p.name}' needs {length} values, not {len(node.value)}")
        items = []
        item_parameter = replace(p, kind="scalar")
        for item in node.value:
            try:
                items.append(self.value(item_parameter, item, values, set_number))
            except Wrong as mistake:
                self.wrong(mistake)
        return tuple(items)

    def structure(self, p: Parameter, node: Any, set_number: int | None) -> Any:
        before = len(self.mistakes)
        members = own_parameters(p.type)
        values = self.members(p.name, node, members, {m.attribute for m in members}, {}, set_number)
        if len(self.mistakes) > before:
            return None
        try:
            return p.type(**values)
        except EncodeError as error:
            raise Wrong(node, f"'{p.name}' cannot be sent: {error.detail}") from None

    def vector(self, p: Parameter, node: Any) -> tuple[float, ...]:
        nodes = self.keys(node, p.elements, f"'{p.name}'")
        missing = [name for name in p.elements if name not in nodes]
        if missing:
            raise Wrong(node, f"'{p.name}' needs {', '.join(missing)} too")
        values = tuple(self.element(p, nodes[name], None) for name in p.elements)
        least, most = p.magnitude
        size = sum(x * x for x in values) ** 0.5
        if (least is not None and size < least) or (most is not None and size > most):
            limits = f"from {least or 0} to {most}" if most is not None else f"at least {least}"
            raise Wrong(node, f"the magnitude of '{p.name}' must be {limits}")
        return values

    def element(self, p: Parameter, node: Any, set_number: int | None) -> Any:
        if isinstance(p.type, type) and issubclass(p.type, IntFlag):
            value = self.flags(p, node)
        else:
            value = self.word(p, node, set_number)
        self.check(p, value, node, set_number)
        return value

    def flags(self, p: Parameter, node: Any) -> Any:
        if kind_of(node) != "sequence" or any(kind_of(x) != "scalar" for x in node.value):
            raise Wrong(node, f"'{p.name}' needs a list of flags, [{', '.join(b.name for b in info(p.type).bits[:3])}]")
        bits = 0
        for word in node.value:
            bits |= int(self.scalar(p, word, word.value))
        return p.type(bits)

    def word(self, p: Parameter, node: Any, set_number: int | None) -> Any:
        if kind_of(node) != "scalar":
            raise Wrong(node, f"'{p.name}' needs one value")
        numbers_by_name = accepted_names(p, set_number, self.profile)
        if node.value in numbers_by_name:
            return p.type(numbers_by_name[node.value]) if p.type is not None else numbers_by_name[node.value]
        if numbers_by_name and not node.value[:1].isdigit():
            few = f"; known: {', '.join(numbers_by_name)}" if len(numbers_by_name) <= 12 else ""
            raise Wrong(node, f"'{p.name}' cannot be '{node.value}'{hint(node.value, numbers_by_name, few)}")
        return self.scalar(p, node, node.value)

    def scalar(self, p: Parameter, node: Any, text: str) -> Any:
        try:
            return typed.parse_scalar(p, text)
        except Failure as failure:
            raise Wrong(node, str(failure)) from None

    def check(self, p: Parameter, value: Any, node: Any, set_number: int | None) -> None:
        """Raises Wrong if the device cannot have this value."""
        if self.device is not None and p.refers == "field" and not self.sends(set_number, int(value)):
            raise Wrong(node, f"this device does not have the field '{node.value}'; remove it")
        numbers_by_name = accepted_names(p, set_number, self.profile)
        enumerated = numbers_by_name and not p.refers and not isinstance(value, IntFlag)
        if enumerated and int(value) not in numbers_by_name.values():
            raise Wrong(node, f"'{p.name}' has no value {node.value}; known: {', '.join(numbers_by_name)}")
        extra = value & ~mask_of(p.type, p.only) if isinstance(value, IntFlag) and p.only else 0
        if extra:
            flags = p.format(p.type(extra))
            raise Wrong(node, f"'{p.name}' cannot have {flags} on this device; known: {', '.join(p.only)}")
        if isinstance(value, (int, float)) and not isinstance(value, (bool, IntFlag)) and not in_limits(p, value, SAME):
            unit = f" {p.unit}" if p.unit not in ("", "1") else ""
            limits = f"{p.range or 'a number'}{unit}" if p.constant is None else p.constant
            raise Wrong(node, f"'{p.name}' must be {limits}, not {node.value}")

    def sends(self, set_number: int | None, descriptor: int) -> bool:
        """Does the device have this field, or is it believed to? It may list shared data in only one set."""
        assert self.device is not None
        fields = self.device.fields | self.profile.fields
        return set_number is None or descriptor >= SHARED or (set_number, descriptor) in fields


def _depends(p: Parameter) -> bool:
    """Does its layout depend on another value, which may follow later on the wire?"""
    return bool(p.tag) or any(v.by != "device" for v in p.variants)

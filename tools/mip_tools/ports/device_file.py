"""Writes what a device reports as a device file of a specification, or adds it to an existing file."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..binding import DEVICES, SETS, Device, identify, model_number, types
from ..devices.known import KnownDevice
from ..errors import Failure
from ..text.yaml_text import YamlFile, child, flow_list, node_value, parsed_yaml, quoted, scalar_text
from .listing import ListedPort, Listing

SHARED = 0xFF
#: The keys of an evidence entry that a new list replaces.
OWN = ("kind", "firmware", "date", "fields", "undefined")
NEW = "Only what the device itself reported is known."


@dataclass(frozen=True)
class Model:
    """The model of a device. `profile` is None if the generated package does not know it."""

    id: str
    title: str
    number: int | None
    profile: Device | None


def model(listing: Listing) -> Model:
    """Identifies the device by its model number, or by its name if it has no number."""
    number = model_number(listing.info.model_number) or model_number(listing.info.serial_number)
    profile = identify(listing.info)
    same = _by_name(listing.title)
    if profile is None and same is not None and (same.model_number is None or number is None):
        profile = same
    if profile is not None:
        return Model(profile.id, profile.title, number, profile)
    title = listing.title or f"Model {number or 'without a number'}"
    if same is not None:  # another device has the name
        title = f"{title} ({number})"
    return Model(re.sub("[^a-z0-9]+", "-", title.lower()).strip("-") or "device", title, number, None)


def named(listing: Listing, device: str | None, complain: Callable[[str], None]) -> Model:
    """Returns the model that the user named, else the one that the device replies; reports if they differ."""
    found = model(listing)
    if device is None:
        return found
    for text in KnownDevice(device, found.profile.id if found.profile else None).lines():
        complain(text)
    return Model(device, DEVICES[device].title, found.number, DEVICES[device])


def _by_name(name: str) -> Device | None:
    wanted = name.lower()
    return next((d for d in DEVICES.values() if wanted in {x.lower() for x in (d.id, d.title, *d.also)}), None)


# --------------------------------------------------------------------------- what is written


@dataclass(frozen=True)
class Facts:
    """The facts that a device reported, with the names of the specification."""

    model: Model
    listing: Listing
    date: str

    def fields(self) -> dict[str, list[str]]:
        """Set -> names of commands and data fields. Responses are left out, because they follow from their commands."""
        by_set: dict[str, list[str]] = {}
        for key in sorted(self.listing.descriptors, key=self._set):
            kinds = types(*key)
            if kinds and kinds[0].ROLE != "response":
                full = kinds[0].name_in(key[0])
                set_name, _, name = full.partition(".")
                if name not in by_set.setdefault(set_name, []):
                    by_set[set_name].append(name)
        return {set_name: names for set_name, names in by_set.items() if names}

    def undefined(self) -> dict[str, list[str]]:
        """Set -> descriptors that the specification does not define."""
        by_set: dict[str, list[str]] = {}
        for set_number, descriptor in self.listing.descriptors:
            if not types(set_number, descriptor):
                name = SETS[set_number][0] if set_number in SETS else f"0x{set_number:02X}"
                by_set.setdefault(name, []).append(f"0x{descriptor:02X}")
        return by_set

    @staticmethod
    def _set(key: tuple[int, int]) -> tuple[int, int]:
        """Sorts shared data last, whichever set the device lists it in."""
        kinds = types(*key)
        return (SHARED if kinds and kinds[0].NAME.startswith("shared.") else key[0]), key[1]

    def rates(self) -> dict[str, int | None]:
        """Data set -> base rate; None if neither the device nor the profile knows it."""
        base_rates = self.model.profile.base_rates if self.model.profile else {}
        sets = sorted(
            {
                set_number
                for set_number, d in self.listing.descriptors
                if 0x80 <= set_number < SHARED and types(set_number, d)
            }
        )
        rates = {number: self.listing.base_rates.get(number) for number in sets if number in SETS}
        return {SETS[n][0]: rate for n, rate in rates.items() if rate is not None or n not in base_rates}

    def ports(self) -> Iterator[ListedPort]:
        """Yields the ports that the profile lacks, provided that the device reported their protocols."""
        ids = {port.id for port in self.model.profile.ports} if self.model.profile else set[int]()
        for port in self.listing.ports:
            if port.id not in ids and port.receives is not None and port.sends is not None:
                yield port

    def note(self) -> str:
        """Composes a note of the facts that no key of the file can hold."""
        profile, remarks = self.model.profile, []
        if profile is not None and profile.model_number is None and self.model.number:
            remarks.append(f"The model number is {self.model.number}.")
        written = {port.id for port in self.ports()}
        bauds = {port.id: port.baud_rates for port in profile.ports} if profile else {}
        for port in self.listing.ports:
            if port.id in written:
                remarks.append(f"{port.name} is listed with the settings that it had.")
            elif port.baud is not None and port.baud not in bauds.get(port.id, ()) and not (profile and port.virtual):
                remarks.append(f"{port.name} was set to {port.baud} Bd.")
        shared = {
            set_number
            for set_number, d in self.listing.descriptors
            if (k := types(set_number, d)) and k[0].NAME.startswith("shared.")
        }
        data = {set_number for set_number, _ in self.listing.descriptors if 0x80 <= set_number < SHARED}
        if shared and SHARED not in shared and shared != data:
            remarks.append(
                f"Shared data is listed in {', '.join(f'0x{set_number:02X}' for set_number in sorted(shared))} only."
            )
        return " ".join(remarks)

    def remark(self) -> list[str]:
        """Returns the line of the key `notes`; empty if there is nothing to note."""
        return [f"notes: [{quoted(self.note())}]"] if self.note() else []

    def contradictions(self) -> dict[str, str]:
        """Data set -> how the device contradicts the profile of the generated package."""
        contradictions = {}
        base_rates = self.model.profile.base_rates if self.model.profile else {}
        for number, rate in self.listing.base_rates.items():
            if number in base_rates and base_rates[number] != rate and number in SETS:
                name = SETS[number][0]
                contradictions[name] = f"the device says {rate} Hz for {name}, its profile {base_rates[number]:g} Hz"
        return contradictions

    # ----------------------------------------------------------------- as YAML

    def entry(self, more: list[str]) -> list[str]:
        """Returns the lines of the evidence entry, with `more` keys."""
        lines = ["kind: listed", f"firmware: {self.listing.firmware}", f"date: {self.date}", *more]
        for key, by_set in (("fields", self.fields()), ("undefined", self.undefined())):
            if by_set:
                lines += [
                    f"{key}:",
                    *(f"  {line}" for set_name, names in by_set.items() for line in flow_list(set_name, names)),
                ]
        return lines

    def flow_entry(self, more: list[str]) -> str:
        """Returns the evidence entry in one line, in braces."""
        parts = ["kind: listed", f"firmware: {self.listing.firmware}", f"date: {self.date}", *more]
        for key, by_set in (("fields", self.fields()), ("undefined", self.undefined())):
            if by_set:
                sets = ", ".join(f"{set_name}: [{', '.join(names)}]" for set_name, names in by_set.items())
                parts.append(f"{key}: {{{sets}}}")
        return f"{{{', '.join(parts)}}}"


def _rate(rate: int | None) -> str:
    return "~" if rate is None else str(rate)


def _rates(rates: dict[str, int | None]) -> str:
    return f"{{{', '.join(f'{name}: {_rate(rate)}' for name, rate in rates.items())}}}"


def _port(port: ListedPort) -> str:
    rates = f"baud_rates: [{port.baud or ''}]"
    receives, sends = (", ".join(p.upper() if not p.startswith("0x") else quoted(p) for p in way or ())
                       for way in (port.receives, port.sends))  # fmt: skip
    return f"{{name: {port.name}, id: 0x{port.id:02X}, {rates}, receives: [{receives}], sends: [{sends}]}}"


# --------------------------------------------------------------------------- a new file


def new_file(facts: Facts, folder: Path) -> str:
    """Composes a new file: an extension of a known device, or the profile of an unknown one."""
    model = facts.model
    is_known = model.profile is not None or _elsewhere(model.id, folder)
    schema = "device_extension" if is_known else "device"
    lines = []
    if (folder / f"schema/{schema}.schema.json").is_file():
        lines.append(f"# yaml-language-server: $schema=../schema/{schema}.schema.json")
    if is_known:
        lines.append(f"extend: {model.id}")
    else:
        name = re.sub("[^a-z0-9]+", "_", model.id.removeprefix("3dm-")).strip("_")
        lines += [f"device: {model.id}", f"name: {name}", f"title: {scalar_text(model.title)}"]
        if model.number:
            lines.append(f"model_number: {model.number}")
        lines += [f"description: {scalar_text(_description(model))}", f"incomplete: [{NEW}]"]
    first, *rest = facts.entry(facts.remark())
    lines += ["evidence:", f"  - {first}", *(f"    {line}" for line in rest)]
    if facts.rates():
        lines.append(f"base_rates: {_rates(facts.rates())}")
    ports = [_port(port) for port in facts.ports()]
    if ports:
        lines += ["ports:", *(f"  - {port}" for port in ports)]
    return "\n".join(lines) + "\n"


def _description(model: Model) -> str:
    return f"Device with the model number {model.number}." if model.number else "Device without a model number."


def _elsewhere(other_id: str, folder: Path) -> bool:
    """Does another file in the folder define the device, although the generated package does not know it yet?"""
    pattern = re.compile(rf"^[ \t]*(- )?\{{?[ \t]*device: *{re.escape(other_id)}[ \t]*(,|#|$)", re.M)
    for path in sorted((folder / "devices").glob("*.yaml")):
        if path.stem != other_id and pattern.search(path.read_text("utf-8", "replace")):
            return True
    return False


# --------------------------------------------------------------------------- an existing file


def updated(facts: Facts, path: Path) -> tuple[str, dict[str, str]]:
    """Adds the facts to the text of a file, in which everything else remains. Raises Failure for another device's file.

    Returns the new text, and the contradictions between file and device by data set or port, each with its position.
    """
    file = YamlFile(path)
    wanted = facts.model.id
    own = child(file.root, "device")
    named = own if own is not None else child(file.root, "extend")
    if named is None:
        raise Failure(f"{path}:1:1: the file needs `extend: {wanted}` or `device: {wanted}`; add one, or move the file")
    if named.value != wanted:
        raise Failure(f"{file.place(named)}: this is '{named.value}', but the device is '{wanted}'; rename the file")
    expected = node_value(file.root)
    _add_evidence(file, facts, expected)
    contradictions = {**_add_rates(file, facts, expected, own is not None), **_add_ports(file, facts, expected)}
    text = file.changed()
    if parsed_yaml(text, path) != expected:
        raise Failure(f"{path} cannot be changed without losing something; use --dry-run, and edit it by hand")
    return text, contradictions


def _add_evidence(file: YamlFile, facts: Facts, expected: dict[str, Any]) -> None:
    evidence = file.get("evidence", "sequence")
    entries = list(evidence.value) if evidence is not None else []
    flow = facts.flow_entry(facts.remark())
    new = _plain(flow, file.path)
    for i, entry in enumerate(entries):
        stated = node_value(entry)
        if not isinstance(stated, dict) or (stated.get("kind"), stated.get("firmware")) != ("listed", new["firmware"]):
            continue
        if all(stated.get(key) == new.get(key) for key in ("fields", "undefined")):
            return  # the same list: the entry keeps its date
        more = [file.source(key, value) for key, value in entry.value if key.value not in OWN]
        more += facts.remark() if "notes" not in stated else []
        file.replace_item(entry, facts.entry(more), facts.flow_entry(more))
        expected["evidence"][i] = new | {key: value for key, value in stated.items() if key not in OWN}
        return
    first, *rest = lines = facts.entry(facts.remark())
    if evidence is not None:
        file.add_item(evidence, lines, flow)
    else:
        whole = ["evidence:", f"  - {first}", *(f"    {line}" for line in rest)]
        file.add_key(file.root, whole, f"evidence: [{flow}]")
    expected.setdefault("evidence", []).append(new)


def _add_rates(file: YamlFile, facts: Facts, expected: dict[str, Any], whole: bool) -> dict[str, str]:
    """Adds base rates. `whole`: the file is a profile, which may inherit the rates that the generated package knows."""
    node = file.get("base_rates", "mapping")
    profile = facts.model.profile
    new: dict[str, int | None] = {}
    contradictions = {}
    for name, rate in facts.rates().items():
        rates_node = child(node, name) if node is not None else None
        number = next(n for n, names in SETS.items() if names[0] == name)
        if rates_node is None:
            if not (whole and profile is not None and profile.base_rates.get(number) == rate):
                new[name] = rate
        elif rate is not None and rates_node.value in ("", "~", "null"):
            file.replace(rates_node, str(rate))
            expected["base_rates"][name] = str(rate)
        elif rate is not None and _number(rates_node.value) != rate:
            place = file.place(rates_node)
            contradictions[name] = (
                f"{place}: the device says {rate} Hz for {name}, not {rates_node.value}; the file is kept"
            )
    if new and node is None:
        file.add_key(file.root, [f"base_rates: {_rates(new)}"], f"base_rates: {_rates(new)}")
    elif node is not None:
        for name, rate in new.items():
            file.add_key(node, [f"{name}: {_rate(rate)}"], f"{name}: {_rate(rate)}")
    if new:
        expected.setdefault("base_rates", {}).update({name: _rate(rate) for name, rate in new.items()})
    return contradictions


def _add_ports(file: YamlFile, facts: Facts, expected: dict[str, Any]) -> dict[str, str]:
    node = file.get("ports", "sequence")
    entries = list(node.value) if node is not None else []
    new = []
    contradictions = {}
    for port in facts.ports():
        same = [x for x in entries if _is_port(x, port)]
        if not same:
            new.append(port)
        for entry in same:
            text, number = child(entry, "name"), child(entry, "id")
            if number is None or text is None or (text.value, _number(number.value)) != (port.name, port.id):
                remark = f"the device calls the port {port.name}, with the number 0x{port.id:02X}"
                contradictions[port.name] = f"{file.place(entry)}: {remark}; the file is kept"
    lines = [_port(port) for port in new]
    if node is not None:
        for line in lines:
            file.add_item(node, [line], line)
    elif lines:
        file.add_key(file.root, ["ports:", *(f"  - {line}" for line in lines)], f"ports: [{', '.join(lines)}]")
    if lines:
        expected.setdefault("ports", []).extend(_plain(line, file.path) for line in lines)
    return contradictions


def _is_port(node: Any, port: ListedPort) -> bool:
    name, number = child(node, "name"), child(node, "id")
    return bool((name is not None and name.value == port.name)
                or (number is not None and _number(number.value) == port.id))  # fmt: skip


def _number(text: str) -> float | None:
    try:
        return float(int(text, 16) if text.startswith("0x") else text)
    except ValueError:
        return None


def _plain(flow: str, path: Path) -> Any:
    return parsed_yaml(flow, path)

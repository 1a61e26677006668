"""Writes what a device reports as a device file of a specification."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from ..binding import DEVICES, SETS, Device, identify, model_number, types
from ..devices.known import KnownDevice
from ..errors import Failure
from ..text.yaml_text import flow_list, quoted, scalar_text
from .listing import ListedPort, Listing

SHARED = 0xFF
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

    def contradictions(self) -> Iterator[str]:
        """Yields how the device contradicts the profile of the generated package."""
        base_rates = self.model.profile.base_rates if self.model.profile else {}
        for number, rate in self.listing.base_rates.items():
            if number in base_rates and base_rates[number] != rate and number in SETS:
                name = SETS[number][0]
                yield f"the device says {rate} Hz for {name}, its profile {base_rates[number]:g} Hz"

    # ----------------------------------------------------------------- as YAML

    def entry(self) -> list[str]:
        """Returns the lines of the evidence entry."""
        lines = ["kind: listed", f"firmware: {self.listing.firmware}", f"date: {self.date}"]
        lines += [f"notes: [{quoted(self.note())}]"] if self.note() else []
        for key, by_set in (("fields", self.fields()), ("undefined", self.undefined())):
            if by_set:
                lines += [
                    f"{key}:",
                    *(f"  {line}" for set_name, names in by_set.items() for line in flow_list(set_name, names)),
                ]
        return lines


def _rate(rate: int | None) -> str:
    return "~" if rate is None else str(rate)


def _rates(rates: dict[str, int | None]) -> str:
    return f"{{{', '.join(f'{name}: {_rate(rate)}' for name, rate in rates.items())}}}"


def _port(port: ListedPort) -> str:
    rates = f"baud_rates: [{port.baud or ''}]"
    receives, sends = (", ".join(p.upper() if not p.startswith("0x") else quoted(p) for p in way or ())
                       for way in (port.receives, port.sends))  # fmt: skip
    return f"{{name: {port.name}, id: 0x{port.id:02X}, {rates}, receives: [{receives}], sends: [{sends}]}}"


# --------------------------------------------------------------------------- the file


def place(facts: Facts, folder: Path) -> Path:
    """Returns the path of the file, which does not exist. Raises Failure if a file has the list of this firmware."""
    firmware, first = facts.listing.firmware, folder / "devices" / f"{facts.model.id}.yaml"
    further = first.with_name(f"{facts.model.id}-{firmware}.yaml")
    listed = re.compile(rf"kind: listed[,\s]+firmware: {re.escape(firmware)}(?![.\d])")
    for path in (further, first):
        if path.exists() and (path is further or listed.search(path.read_text("utf-8", "replace"))):
            raise Failure(f"{path} has the list of firmware {firmware}; --dry-run prints it as it is now")
    return further if first.exists() else first


def file_text(facts: Facts, folder: Path) -> str:
    """Composes the file: an extension of a known device, or the profile of an unknown one."""
    model = facts.model
    is_known = model.profile is not None or _is_defined(model.id, folder)
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
    first, *rest = facts.entry()
    lines += ["evidence:", f"  - {first}", *(f"    {line}" for line in rest)]
    if facts.rates():
        lines.append(f"base_rates: {_rates(facts.rates())}")
    ports = [_port(port) for port in facts.ports()]
    if ports:
        lines += ["ports:", *(f"  - {port}" for port in ports)]
    return "\n".join(lines) + "\n"


def _description(model: Model) -> str:
    return f"Device with the model number {model.number}." if model.number else "Device without a model number."


def _is_defined(device: str, folder: Path) -> bool:
    """Does a file in the folder define the device, although the generated package does not know it yet?"""
    pattern = re.compile(rf"^[ \t]*(- )?\{{?[ \t]*device: *{re.escape(device)}[ \t]*(,|#|$)", re.M)
    return any(pattern.search(path.read_text("utf-8", "replace")) for path in (folder / "devices").glob("*.yaml"))

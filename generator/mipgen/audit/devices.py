"""Compares the devices of the specification with facts from another source.

These facts are not part of the project. They are in two files of one folder: `models.yaml` lists the names and numbers
of the models, and `devices.yaml` lists the known commands, data and base rates of each device. A missing file is
skipped. The same folder may contain `witness.yaml`, with facts about all layouts, which `witnesses` compares.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from mipgen import model as m
from mipgen.read.nodes import Node, read
from mipgen.read.problems import Problems

from .manuals import Finding

MODELS, DEVICES, WITNESS = "models.yaml", "devices.yaml", "witness.yaml"

#: The source's certainty about a field: seen in a manual, or only listed in its table of contents or inferred from it.
CERTAIN, PERHAPS = ("seen",), ("contents", "inferred")


def audit(model: m.Model, folder: Path) -> list[Finding]:
    """Returns all differences. Raises SpecError if a file cannot be read."""
    problems = Problems()
    findings: list[Finding] = []
    for name, compare in ((MODELS, _models), (DEVICES, _devices)):
        root = read(folder / name, name, problems) if (folder / name).is_file() else None
        findings += compare(model, root) if root is not None else ()
    problems.raise_if_any()
    return sorted(set(findings))


def _finding(place: m.Position, message: str) -> Finding:
    return Finding(place.file, place.line, message)


def _by_number(model: m.Model, number: int) -> m.Device | m.NamedDevice | None:
    devices: tuple[m.Device | m.NamedDevice, ...] = (*model.devices, *model.named)
    return next((d for d in devices if d.model_number == number), None)


def _models(model: m.Model, root: Node) -> Iterator[Finding]:
    """Checks that each model is a device of the specification, with all its names."""
    for node in root["models"]:
        number = node["number"]
        device = _by_number(model, number.value)
        if device is None:
            yield _finding(number.position, f"no device has the model number {number.value}")
            continue
        for key in ("name", "also"):
            if key in node and node[key].value not in (device.title, *device.also):
                yield _finding(node[key].position, f"{device.id} is not called '{node[key].value}'")
        if isinstance(device, m.Device) and node["generation"].value != device.generation:
            yield _finding(
                node["generation"].position, f"{device.id} is generation {device.generation} in the specification"
            )


def _devices(model: m.Model, root: Node) -> Iterator[Finding]:
    for name, node in root["devices"].items():
        for number in _numbers(node["model_number"]):
            device = _by_number(model, number)
            if device is None:
                yield _finding(root["devices"].keys[name], f"no device has the model number {number}")
            if not isinstance(device, m.Device):  # of a device known by name only, there is nothing to compare
                continue
            for kind in ("commands", "data"):
                for key, lists in node[kind].items() if kind in node else ():
                    yield from _support(model, device, int(key, 16), lists)
            yield from _rates(device, node)


def _numbers(node: Node) -> list[int]:
    """Returns the model number of one device, or the model numbers of several."""
    entries = [node["value"]] if "value" in node else node.value.values()
    return [entry.value for entry in entries if isinstance(entry.value, int)]


def _support(model: m.Model, device: m.Device, number: int, lists: Node) -> Iterator[Finding]:
    """Checks that support that is certain in the source is certain here, and that other support is at least listed."""
    certain = {(s.set, s.field.descriptor) for s in device.certain}
    listed = {(s.set, s.field.descriptor) for s in device.supports}
    for words, known in ((CERTAIN, certain), (PERHAPS, listed)):
        for entry in (entry for word in words for entry in lists.get(word) or ()):
            key = (number, entry.value)
            if key not in known and model.candidates(*key):
                where = f"(0x{number:02X},0x{entry.value:02X})"
                doubt = " for certain" if words == CERTAIN and key in listed else ""
                yield _finding(entry.position, f"{device.id} does not support {where}{doubt}")


def _rates(device: m.Device, node: Node) -> Iterator[Finding]:
    ours = {r.set.number: r.hertz for r in device.base_rates}
    for key, entry in node["base_rates"].items() if "base_rates" in node else ():
        rate = entry.get("value") or entry
        if key.startswith("0x") and ours.get(int(key, 16)) != rate.value:
            yield _finding(
                rate.position, f"{device.id} has base rate {ours.get(int(key, 16))} for set {key} in the specification"
            )

"""Compares the devices of the specification with `spec/witness/devices.yaml`: facts of models from the vendor's SDK,
from MSCL and from pages of manuals.

Each fact that the witness states must be the same here. What it does not state is counted, as debt.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from mipgen import model as m

#: Facts that have one value, and those with a value for each port, set, limit, command or field.
SEVERAL = ("base_rates", "baud_rates", "limits", "functions", "yes", "likely", "assumed")


@dataclass(frozen=True)
class Finding:
    at: str
    text: str


def compared_devices(model: m.Model, facts: dict[str, Any]) -> Iterator[tuple[str, Finding | None]]:
    """Yields the kind of each fact, and the difference or None."""
    devices: tuple[m.Device | m.NamedDevice, ...] = (*model.devices, *model.named)
    for device_id, stated in facts["models"].items():
        device = next((d for d in devices if d.id == device_id), None)
        ours = _named(device) if isinstance(device, m.NamedDevice) else _facts(device) if device else {}
        for kind, value in stated.items():
            several = value if kind in SEVERAL else {"": value}
            for key, wanted in several.items():
                found = ours.get(kind, {}).get(key) if kind in SEVERAL else ours.get(kind)
                missing = sorted({*wanted} - {*(found or ())}) if kind in ("yes", "likely", "assumed") else None
                text = f"{kind} {_key(key)}".rstrip() + f": {_short(found)}, witness {_short(wanted)}"
                if missing is not None:
                    text = f"not {kind}: {', '.join(f'{_key(key)},0x{x:02X}' for x in missing)}"
                differs = bool(missing) if missing is not None else found != wanted
                yield f"{kind} of devices", Finding(device_id, text) if differs else None
    for path, rows in facts["readings"].items():
        for row in rows:
            wanted = {key: value for key, value in row.items() if key != "devices"}
            for device_id in row["devices"]:
                found = _reading(model, device_id, path, wanted)
                text = f"{path}: {_short(found)}, witness {_short(wanted)}"
                yield "readings of devices", None if found == wanted else Finding(device_id, text)


def debt(model: m.Model, facts: dict[str, Any]) -> Counter[str]:
    """Counts the facts of devices that the witness does not state, by kind."""
    missing: Counter[str] = Counter()
    for device in model.devices:
        stated = facts["models"].get(device.id, {})
        for kind, value in _facts(device).items():
            for key, here in value.items() if kind in SEVERAL else (("", value),):
                there = stated.get(kind, {}).get(key) if kind in SEVERAL else stated.get(kind)
                if kind not in ("yes", "likely", "assumed"):
                    missing[kind] += there is None
                    continue
                missing[kind] += len({*here} - {*(there or ())})
        readings = {(path, d) for path, rows in facts["readings"].items() for row in rows for d in row["devices"]}
        missing["readings"] += len({(v.path, device.id) for v in device.variants} - readings)
    return +missing


def _facts(device: m.Device) -> dict[str, Any]:
    facts: dict[str, Any] = {
        "number": device.model_number,
        "generation": device.generation,
        "sensors": sorted(device.hardware.sensors or ()) or None,
        "receivers": device.hardware.receivers,
        "antennas": device.hardware.antennas,
        "ack_codes": list(device.ack_codes) or None,
        "base_rates": {_key(rate.set.number): rate.hertz for rate in device.base_rates},
        "baud_rates": {port.name: list(port.baud_rates) for port in device.ports if port.baud_rates},
        "limits": {limit.name: [limit.value, limit.unit or "1"] for limit in device.limits},
        "functions": {s.name: "".join(f.letter for f in s.functions) for s in device.supports if s.differs},
    }
    for answer in m.SUPPORTED:
        facts[answer] = {}
        for s in device.supports:
            if s.evidence.answer == answer:
                facts[answer].setdefault(_key(s.set), []).append(s.field.descriptor)
    return {key: value for key, value in facts.items() if value is not None}


def _named(device: m.NamedDevice) -> dict[str, Any]:
    return {"number": device.model_number}


def _reading(model: m.Model, device_id: str, path: str, wanted: dict[str, Any]) -> dict[str, Any] | None:
    """Returns these properties of a parameter on a device; None if it has no reading of its own."""
    for device in model.devices:
        for v in device.variants if device.id == device_id else ():
            if v.path == path:
                every = properties(v.variant)
                return {key: every.get(key) for key in wanted}
    return None


def properties(variant: m.Variant) -> dict[str, Any]:
    """What is different on a device, as the witness states it."""
    bounds = [variant.minimum, variant.maximum]
    found = {
        "type": variant.type.name if variant.type else None,
        "only": sorted(x.name for x in variant.only) or None,
        "range": bounds if bounds != [None, None] else None,
        "default": variant.default,
        "const": variant.constant,
        "unit": list(variant.units) or None,
        "frame": variant.frame,
        "valid": list(variant.valid) if variant.valid is not None else None,
    }
    return {key: value for key, value in found.items() if value is not None}


def _key(key: object) -> str:
    return f"0x{key:02X}" if isinstance(key, int) else str(key)


def _short(value: object) -> str:
    if isinstance(value, dict):
        return ", ".join(f"{k} {_short(v)}" for k, v in value.items())
    return ", ".join(map(str, value)) if isinstance(value, list) else "nothing" if value is None else str(value)

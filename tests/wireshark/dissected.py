"""What the tests of the dissector share: packets of the specification, and the trees that tshark makes of captures."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from mipgen.lower import codec
from shark import Shark
from support import SPECS, model, need, set_of

Element = ElementTree.Element
PORT = 6565


@cache
def shark(spec: str = "real") -> Shark:
    need("tshark")
    return Shark(SPECS[spec][1] / "wireshark/mip.lua")


def trees(tmp_path: Path, capture: bytes, *arguments: str, spec: str = "real") -> list[Element]:
    path = tmp_path / "capture.pcap"
    path.write_bytes(capture)
    return [copied(tree) for tree in shark(spec).trees(path, *arguments)]


def copied(tree: Element) -> Element:
    """A copy, as the parser empties a tree when it goes on."""
    return ElementTree.fromstring(ElementTree.tostring(tree))


def shown(of: Element, name: str) -> list[str]:
    return [part.get("show", "") for part in of.iter("field") if part.get("name") == name]


def field_bytes(name: str, **values: Any) -> tuple[int, int, bytes]:
    f = model("real").field(name)
    assert f is not None
    given = {p.name: codec.canonical(p, values[p.name], p.name) for p in f.parameters if p.name in values}
    return set_of(f, model("real")), f.descriptor, codec.encode(f, given)


def packet(*fields: tuple[int, int, bytes]) -> bytes:
    return codec.build(model("real"), fields[0][0], [(descriptor, data) for _, descriptor, data in fields])


def accel(x: float) -> bytes:
    return packet(field_bytes("sensor.scaled_accel", scaled_accel=[x, 0, 1]))


def acknowledge(number: int, descriptor: int, code: int, *more: tuple[int, bytes]) -> bytes:
    return codec.build(model("real"), number, [(0xF1, bytes((descriptor, code))), *more])


def broken(whole: bytes) -> bytes:
    return whole[:-1] + bytes([whole[-1] ^ 1])

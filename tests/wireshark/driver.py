"""The conformance driver for Wireshark: tshark decodes a capture of all packets, and its trees become answers.

It knows nothing of MIP but the filters and labels that the dissector shows.
"""

from __future__ import annotations

import json
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from shark import Shark, datagrams

PORT = 6565
Element = ElementTree.Element

#: What is shown beside the parameters of a field.
_NOT_VALUES = ("mip.field.", "mip.request_in", "mip.answer_", "_ws.expert")
_PROBLEMS = ("truncated", "count", "constant")


def main() -> None:
    requests = [parsed(line) for line in sys.stdin]
    packets = [p for p in map(packet_of, requests) if p is not None]
    answers = iter(decoded(Shark(Path(sys.argv[1])), packets))
    for request in requests:
        print(json.dumps(next(answers) if packet_of(request) is not None else {"error": "request"}))


def parsed(line: str) -> Any:
    try:
        return json.loads(line)
    except ValueError:
        return None


def packet_of(request: Any) -> bytes | None:
    if not isinstance(request, dict) or request.get("op") != "decode":
        return None
    try:
        return bytes.fromhex(request["packet"])
    except (KeyError, TypeError, ValueError):
        return None


def decoded(shark: Shark, packets: list[bytes]) -> Iterator[dict[str, Any]]:
    """One answer for each packet, which has a datagram of its own."""
    if not packets:
        return
    types = shark.types()
    with tempfile.TemporaryDirectory() as folder:
        capture = Path(folder) / "packets.pcap"
        capture.write_bytes(datagrams(packets, PORT))
        trees = shark.trees(capture, "-o", f"mip_protocol.udp_ports:{PORT}")
        for packet, tree in zip(packets, trees, strict=True):
            yield answer(packet, tree, types)


def answer(packet: bytes, tree: Element, types: dict[str, str]) -> dict[str, Any]:
    shown = [
        part
        for part in tree
        if part.get("name") == "mip_protocol" or part.find("field[@name='mip.skipped']") is not None
    ]
    if not shown:
        return {"error": "sync"}  # an empty datagram
    first = shown[0]
    whole = int(first.get("size", 0)) == len(packet)
    if first.get("name") != "mip_protocol":
        reason = first.find("field/field[@name='mip.skipped.reason']")
        assert reason is not None
        return {"error": skipped(int(reason.get("show", "")), packet)}
    if not whole:
        return {"error": "length"}
    status = first.find("field/field[@name='mip.checksum.status']")
    assert status is not None
    if status.get("show") != "1":
        return {"error": "checksum"}
    return {"set": number(first, "mip.set"), "fields": [field(f, types) for f in fields(first)]}


def skipped(reason: int, packet: bytes) -> str:
    if reason == 0:
        return "sync"
    return "checksum" if reason == 3 and packet[3] + 6 == len(packet) else "length"


def number(of: Element, name: str) -> int:
    found = of.find(f"field[@name='{name}']")
    assert found is not None, name
    return int(found.get("show", ""), 0)


def fields(packet: Element) -> Iterator[Element]:
    """The fields that have a descriptor, and the length of one that is malformed."""
    for part in packet:
        if part.find("field[@name='mip.field.descriptor']") is not None or part.get("name") == "mip.field.length":
            yield part


def field(of: Element, types: dict[str, str]) -> dict[str, Any]:
    if of.get("name") == "mip.field.length":
        return {"error": "field_length"}
    problem = next((p for p in _PROBLEMS if of.find(f".//field[@name='mip.expert.{p}']") is not None), None)
    data, trailing = (of.find(f"field[@name='mip.field.{name}']") for name in ("data", "trailing"))
    shown: dict[str, Any] = {"descriptor": number(of, "mip.field.descriptor")}
    if data is not None:
        return shown | ({"error": problem} if problem else {}) | {"raw": data.get("value", "")}
    name, role = (of.find(f"field[@name='mip.field.{name}']") for name in ("name", "role"))
    assert name is not None and role is not None
    shown |= {"name": name.get("show"), "role": role.get("show"), "values": record(of, types)}
    return shown | {"trailing": int(trailing.get("size", 0)) if trailing is not None else 0}


def record(of: Element, types: dict[str, str]) -> dict[str, Any]:
    return {
        label(part): value(part, types) for part in values(of) if not part.get("showname", "").endswith(" (constant)")
    }


def values(of: Element) -> list[Element]:
    return [part for part in of if not part.get("name", "").startswith(_NOT_VALUES)]


def label(of: Element) -> str:
    """The name of a parameter: the last part of the filter, or the text before the colon."""
    if is_container(of):
        return of.get("showname", "").partition(":")[0]
    return of.get("name", "").rpartition(".")[2]


def is_container(of: Element) -> bool:
    return of.get("show") == "" and of.get("value") == ""


def value(of: Element, types: dict[str, str]) -> Any:
    if is_container(of):
        _, colon, text = of.get("showname", "").partition(": ")
        if colon and not text.startswith(("case ", "no case")):
            return [value(part, types) for part in values(of)]  # an array or a vector
        return record(of, types)
    raw, kind = of.get("value", ""), types[of.get("name", "")]
    if kind in ("FT_FLOAT", "FT_DOUBLE"):
        return f"0x{raw}"
    if kind == "FT_STRING":
        return bytes.fromhex(raw).decode("latin-1")
    if kind == "FT_BYTES":
        return list(bytes.fromhex(raw))
    if kind in ("FT_BOOLEAN", "FT_CHAR"):
        return int(raw, 16)
    return int(of.get("show", ""), 0)


if __name__ == "__main__":
    main()

"""The inspector in Chromium, from disk: for every printed packet, it shows what the Python binding decodes."""

from __future__ import annotations

import importlib
import json
import re
import struct
import sys
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from typing import Any

import browser
import pytest
from mipgen.lower import codec
from random_values import drawn
from support import ROOT, all_fields, heavy, model, set_of
from workbench import workbench

pytestmark = heavy("Chromium")

#: What the page shows, as data.
READ = """
(() => [...document.querySelectorAll(".mip-packet")].map((packet) => ({
    kind: packet.dataset.kind,
    bytes: packet.dataset.bytes,
    title: packet.querySelector("h2").textContent,
    verdict: packet.querySelector(".mip-verdict").textContent,
    notes: [...packet.querySelectorAll(":scope > .mip-note")].map((note) => note.textContent),
    fields: [...packet.querySelectorAll(".mip-field")].map((field) => ({
        name: field.dataset.field,
        wrong: field.querySelector(".mip-wrong")?.textContent ?? null,
        rows: [...field.querySelectorAll("tbody tr")].map((row) => ({
            path: row.dataset.path,
            bytes: row.cells[0].textContent,
            number: row.cells[2].querySelector(".mip-number").textContent,
            name: row.cells[2].querySelector("code")?.textContent ?? null,
            value: row.cells[2].textContent,
            meaning: row.cells[3].textContent,
            flags: [...row.cells[3].querySelectorAll(".mip-flag")].map((flag) => flag.textContent),
        })),
    })),
})))()
"""


@pytest.fixture(scope="module")
def page() -> Iterator[browser.Page]:
    with browser.page() as opened:
        opened.open(workbench("real") / "inspector.html")
        yield opened
        assert opened.complaints == []
        assert all(url.startswith("file://") for url in opened.asked), opened.asked


def inspected(page: browser.Page, text: str, device: str = "") -> list[Any]:
    """What the page shows for a pasted text."""
    page.run(f"document.querySelector('select').value = {device!r}")
    page.run(
        f"(() => {{ const input = document.querySelector('textarea'); input.value = {text!r};"
        " input.dispatchEvent(new Event('input')); })()"
    )
    found: list[Any] = page.run(READ)
    return found


# --------------------------------------------------------------------------- the Python binding


@cache
def binding(name: str) -> Any:
    path = str(ROOT / "generated/python")
    sys.path.insert(0, path)
    try:
        return importlib.import_module(name)
    finally:
        sys.path.remove(path)


Row = tuple[str, Any, Any, str]  # path, parameter, value, unit


def rows(record: Any, path: str = "") -> Iterator[Row]:
    """Every value of a field as the Python binding has it."""
    for p in binding("mip_protocol.reflection").info(type(record)).parameters:
        name = f"{path}.{p.name}" if path else p.name
        beside = p.of(record)
        p = replace(p, units=beside.units, elements=beside.elements)
        if p.kind == "constant":
            yield name, p, p.constant, ""
        elif p.kind == "counter":
            items = getattr(record, p.counts)
            if items is not None:
                yield name, p, len(items), ""
        elif p.kind == "switch":
            case_, held = p.cases.get(getattr(record, p.tag)), getattr(record, p.attribute)
            if case_ is not None and held is not None:
                yield from values(case_, held, f"{name}.{case_.name}")
        elif getattr(record, p.attribute) is not None:
            yield from values(p, getattr(record, p.attribute), name)


def values(p: Any, value: Any, path: str) -> Iterator[Row]:
    if p.kind == "text":
        yield path, p, value, ""
    elif p.length is not None and p.kind in ("array", "struct"):
        for i, item in enumerate(value):
            yield from one(p, item, f"{path}[{i}]")
    else:
        yield from one(p, value, path)


def one(p: Any, value: Any, path: str) -> Iterator[Row]:
    if p.elements:
        for i, (name, element) in enumerate(zip(p.elements, value, strict=True)):
            yield f"{path}.{name}", p, element, unit(p, i)
    elif p.kind == "struct" or isinstance(value, binding("mip_protocol.field").Structure):
        yield from rows(value, path)
    else:
        yield path, p, value, unit(p, 0)


def unit(p: Any, i: int) -> str:
    """Plain numbers have none."""
    found = p.units[i if len(p.units) > 1 else 0] if p.units else ""
    return "" if found == "1" else str(found)


def decoded(packet: bytes) -> Iterator[tuple[str, list[Row]]]:
    mip, registry = binding("mip_protocol"), binding("mip_protocol.registry")
    chosen = binding("mip_protocol.field").chosen
    for raw in mip.Packet(packet):
        kind = chosen(registry.types(raw.set, raw.descriptor), raw)
        value = kind.decode(raw.data) if kind else None
        yield (kind.NAME, list(rows(value))) if kind else ("", [])


def words(constant: str) -> str:
    """The name in the specification; one that begins with a digit has an N before it in Python."""
    return (constant[1:] if re.match(r"N\d", constant) else constant).lower()


def check(row: Any, path: str, p: Any, value: Any, unit: str) -> None:
    """One line of the page against one value of the binding."""
    assert row["path"] == path
    raw = bytes.fromhex(row["bytes"].replace(" ", ""))
    if p.scalar in ("float", "double"):
        shown = row["number"]
        form = ">f" if p.scalar == "float" else ">d"
        if shown.startswith("NaN ("):
            assert value != value and shown == f"NaN (0x{raw.hex()})"
        else:
            assert struct.pack(form, float(shown)) == raw
            assert float(shown) == pytest.approx(value, rel=1e-6, nan_ok=True)
    elif p.kind == "text":
        assert json.loads(row["number"]) == value.rstrip("\0 ")
    elif row["number"].startswith("0x"):
        assert int(row["number"], 16) == int(value)
        single = {words(m.name) for m in p.type or () if m.value & (m.value - 1) == 0 and m.value & value}
        assert (
            {flag for flag in row["flags"] if " " not in flag} <= single <= {flag.split()[0] for flag in row["flags"]}
        )
    elif p.scalar == "bits":
        assert int.from_bytes(raw, "little") == int(value)
    else:
        assert int(row["number"]) == int(value)
        if hasattr(value, "name") and p.scalar != "bool" and row["name"] not in (None, "unknown"):
            assert row["name"] == words(value.name) or value.name.startswith("UNKNOWN"), (row, value)
    name = f" {row['name']}" if row["name"] else ""
    assert row["value"] == row["number"] + (f" {unit}" if unit else "") + name


def compare(page: browser.Page, packets: list[bytes]) -> None:
    """Compares all packets in one paste."""
    found = inspected(page, " ".join(p.hex() for p in packets))
    for packet, shown in zip(packets, found, strict=True):
        assert shown["kind"] == "packet" and bytes.fromhex(shown["bytes"]) == packet
        assert shown["verdict"] == f"Checksum {packet[-2:].hex(' ').upper()} is right."
        for field, (name, wanted) in zip(shown["fields"], decoded(packet), strict=True):
            assert field["name"] == name and field["wrong"] is None
            for row, line in zip(field["rows"], wanted, strict=True):
                check(row, *line)


def test_every_printed_packet(page: browser.Page) -> None:
    packets = [e.packet for e in model("real").examples if e.role != "field"]
    assert len(packets) > 100
    compare(page, packets)


def test_every_field(page: browser.Page) -> None:
    of = model("real")
    packets = []
    for f in all_fields(of):
        values = drawn(f, 8)[0]
        packets.append(codec.build(of, set_of(f, of), [(f.descriptor, codec.encode(f, values))]))
    compare(page, packets)


def test_all_of_them_at_once_with_anything_between(page: browser.Page) -> None:
    packets = [e.packet for e in model("real").examples if e.role != "field"]
    between = ["", "\n-- log --\n", " 75 ", "\n$GPGGA,12\n", " 75 65 80 ff "]
    text = "".join(p.hex(" ") + between[i % len(between)] for i, p in enumerate(packets))
    assert [bytes.fromhex(p["bytes"]) for p in inspected(page, text) if p["kind"] == "packet"] == packets


PING = codec.checksum(bytes.fromhex("756501020201"))


@pytest.mark.parametrize(
    "text",
    [
        "756501020201E0C6",
        "75 65 01 02 02 01 e0 c6",
        "0x75, 0x65, 0x01, 0x02, 0x02, 0x01, 0xE0, 0xC6",
        "0x7565 0x0102 0x0201 0xE0C6",
        r"\x75\x65\x01\x02\x02\x01\xe0\xc6",
        "75h 65h 01h 02h 02h 01h E0h C6h",
        "7565:0102:0201:e0c6",
        r"b'ue\x01\x02\x02\x01\xe0\xc6'",
        "uint8_t ping[] = {0x75, 0x65, 0x1, 0x2, 0x2, 0x1, 0xE0, 0xC6};",
        "00000000  75 65 01 02 02 01 e0 c6                           |ue......|",
        "00000000: 7565 0102 0201 e0c6                      ue......",
        "0000   75 65 01 02 02 01 e0 c6   ue......",
        "75 65 1 2 2 1 e0 c6",
        "sent: 75 65 1 2 2 1 e0 c6\n",
        "75 65 1 2\n2 1 e0 c6",
        "[0x75, 0x65, 1, 2, 2, 1, 0xE0, 0xC6]",
        "{0x75,0x65,1,2,2,1,0xE0,0xC6}; // 3 ms",
        "1 75 65 01 02 02 01 e0 c6",
        "75 65 1 2 2 1 e0 c6 is a ping",
        "75650102  0201 E0C6",
        "7565  0102 0201 e0c6",
        "sent: 75 65 01 02 02\nthen: 01 e0 c6",
    ],
)
def test_any_form(page: browser.Page, text: str) -> None:
    (shown,) = inspected(page, text)
    assert shown["kind"] == "packet" and shown["bytes"] == "75 65 01 02 02 01 E0 C6"
    assert [f["name"] for f in shown["fields"]] == ["base.ping"]


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("a b 75 65", "75 65"),
        ("75 65 a packet", "75 65"),
        ("3 4 5 packets: 75 65", "75 65"),
        ("75 65 1 2 2 1 b 5", "75 65 01 02 02 01 0B 05"),
        ("after 0.5 s: 75 65 1, 2", "75 65 01 02"),
    ],
)
def test_single_digits(page: browser.Page, text: str, wanted: str) -> None:
    """Between bytes, and at the end of a list, they are bytes; in words, they are not."""
    inspected(page, text)
    shown = page.run(
        "[...document.querySelectorAll('.mip-other code, .mip-packet > .mip-bytes')].map(x => x.textContent)"
    )
    assert shown == [wanted]


def test_a_text_without_bytes_is_told_from_none(page: browser.Page) -> None:
    shown = {}
    for text in ("", "hello world"):
        assert inspected(page, text) == []
        shown[text] = page.run("document.querySelector('.mip-output').textContent")
    assert shown == {
        "": "Nothing to read yet.",
        "hello world": ("No bytes were found in this text; hexadecimal is needed. Not read as bytes: hello world"),
    }


def others(page: browser.Page, text: str) -> list[str]:
    assert inspected(page, text) == []
    found: list[str] = page.run("[...document.querySelectorAll('.mip-other .mip-wrong')].map((one) => one.textContent)")
    return found


def test_why_bytes_are_no_packet(page: browser.Page) -> None:
    begin, rest = "The bytes from byte", "look like a packet, but are not one"
    assert others(page, "75 65 01 02 00 01 E0 C6") == [f"{begin} 1 {rest}: a field of length 0 in 2 bytes."]
    assert others(page, "AA 75 65 01 02 03 01 E0 C6") == [f"{begin} 2 {rest}: a field of length 3 in 2 bytes."]
    assert others(page, "75 65 00 00 DA 4F") == [f"{begin} 1 {rest}: descriptor set 0x00, which no packet has."]
    assert others(page, "12 34 56") == []


def test_sets_and_fields_are_named(page: browser.Page) -> None:
    """Numbers of a field itself, and in a structure, whose set is beside it."""
    (shown,) = inspected(page, "75 65 0C 0B 0B 0F 01 80 02 04 00 0A 05 00 0A AB 00")
    found = {row["path"]: (row["number"], row["meaning"]) for row in shown["fields"][0]["rows"]}
    assert found["descriptor_set"] == ("0x80", "Sensor data")
    assert found["descriptors[0].descriptor"] == ("0x04", "Scaled accel")
    assert found["descriptors[1].descriptor"] == ("0x05", "Scaled gyro")
    assert found["descriptors[1].decimation"][0] == "10"
    (shown,) = inspected(page, "75 65 0C 0D 0D 0F 01 82 02 D3 00 0A 05 00 0A 00 00")
    found = {row["path"]: (row["number"], row["meaning"]) for row in shown["fields"][0]["rows"]}
    wanted = {f.descriptor: f.title for f in model("real").fields if f.set in (0x82, 0xFF)}
    assert found["descriptors[0].descriptor"] == ("0xD3", wanted[0xD3])
    assert found["descriptors[1].descriptor"] == ("0x05", wanted[5])


def test_a_field_of_several_sets_is_named_in_its_own(page: browser.Page) -> None:
    f = model("real").field("gnss_data.dop")
    assert f is not None
    for number, name in ((0x81, "gnss_data.dop"), (0x92, "gnss_2.dop")):
        inspected(page, codec.build(model("real"), number, [(f.descriptor, bytes(f.max_size))]).hex())
        heading = page.run("document.querySelector('.mip-field h3').textContent")
        assert heading.endswith(f" (0x{number:02X},0x{f.descriptor:02X}) {name}")


def test_a_wrong_checksum(page: browser.Page) -> None:
    (shown,) = inspected(page, "75 65 01 02 02 01 E0 C7")
    assert shown["kind"] == "damaged" and [f["name"] for f in shown["fields"]] == ["base.ping"]
    assert shown["verdict"] == "Checksum E0 C7 is wrong; correct: E0 C6."


def test_an_incomplete_packet(page: browser.Page) -> None:
    (shown,) = inspected(page, "75 65 80 1C 0E 04 3E 7A 63 A0 BB 8E 3B 29 7F E5 BF 7F 0E 05 00")
    assert shown["kind"] == "incomplete" and shown["verdict"] == "The packet is incomplete: 13 bytes missing."
    assert [f["name"] for f in shown["fields"]] == ["sensor.scaled_accel"]


def test_what_cannot_be_decoded(page: browser.Page) -> None:
    short = codec.build(model("real"), 0x80, [(0x04, b"\0\0"), (0xEE, b"\1")])
    (shown,) = inspected(page, short.hex())
    accel, unknown = shown["fields"]
    assert accel["wrong"] == "It cannot be decoded: the data is 2 bytes short." and unknown["name"] == ""


def test_misprints_are_named(page: browser.Page) -> None:
    """Each printed packet with wrong bytes is recognized, if its text is one of whole bytes."""
    known = 0
    for e in model("real").examples:
        printed = "".join(e.string.split()).lower() if e.string else ""
        if e.role == "field" or len(printed) % 2 or printed in ("", e.packet.hex()):
            continue
        notes = [note for part in inspected(page, printed) for note in part["notes"]]
        if notes:
            known += 1
            assert e.packet.hex(" ").upper() in notes[0] and " See " in notes[0], e.id
    assert known > 5


def test_the_reading_of_a_device(page: browser.Page) -> None:
    """A parameter that every device reads in its own way, and one that some do."""
    of = model("real")
    f = next(f for f in of.fields if f.full_name == "filter_data.status")
    packet = codec.build(of, f.set, [(f.descriptor, bytes.fromhex("000400010002"))])
    found = {}
    for device in ("", "3dm-gx5-15", "3dm-cv7-gnss-ins"):
        (shown,) = inspected(page, packet.hex(), device)
        found[device] = [(row["value"], row["flags"]) for row in shown["fields"][0]["rows"]]
    assert found["3dm-gx5-15"] != found["3dm-cv7-gnss-ins"]


def test_what_depends_on_the_device_is_said(page: browser.Page) -> None:
    words = "Depends on the device; choose one above."
    packet = "75 65 82 08 08 10 00 04 00 01 00 01 82 F7"
    (shown,) = inspected(page, packet)
    assert [words in row["meaning"] for row in shown["fields"][0]["rows"]] == [True] * 3
    (shown,) = inspected(page, packet, "3dm-cv7-gnss-ins")
    assert [words in row["meaning"] for row in shown["fields"][0]["rows"]] == [False] * 3


def test_a_log_is_dropped(page: browser.Page) -> None:
    """With damage and a gap: its fields, rates and gaps, and any packet of it, page by page."""
    of = model("real")
    time, accel = of.field("shared.reference_timestamp"), of.field("sensor.scaled_accel")
    assert time is not None and accel is not None
    parts = []
    for i in [*range(700), *range(710, 2000)]:
        data = ((5 * 10**9 + i * 10**7).to_bytes(8, "big"), bytes(12))
        parts.append(codec.build(of, 0x80, [(f.descriptor, x) for f, x in zip((time, accel), data, strict=True)]))
    text = ",".join(str(x) for x in b"".join(parts) + b"noise")
    page.run(
        "(() => { const held = new DataTransfer();"
        f" held.items.add(new File([Uint8Array.of({text})], 'drive.bin'));"
        " const event = new DragEvent('drop', { dataTransfer: held, bubbles: true });"
        " document.querySelector('#tool').dispatchEvent(event); })()"
    )
    wait = (
        "(async () => {{ for (let i = 0; i < 500 && !({0}); i++) await new Promise((done) => setTimeout(done, 20));"
        " return {0}; }})()"
    )
    assert page.run(wait.format("document.querySelector('.mip-log table') !== null"))
    rows = page.run(
        "[...document.querySelectorAll('.mip-log tbody tr')]"
        ".map((row) => [...row.cells].map((cell) => cell.textContent))"
    )
    assert [row[1:] for row in rows] == [
        ["0x80,0x04", "1990", "100", "1, 10 samples missing"],
        ["0x80,0xD5", "1990", "100", "1, 10 samples missing"],
    ]
    said = page.run("document.querySelector('.mip-log .mip-summary').textContent")
    assert said.startswith(f"{sum(map(len, parts)) + 5} bytes, 1990 packets; 5 bytes outside packets.")
    page.run("document.querySelector('.mip-pages').open = true")
    assert page.run(wait.format("document.querySelectorAll('.mip-pages .mip-packet').length > 100"))
    page.run(
        "(() => { const input = document.querySelector('#mip-log-packet'); input.value = 1500;"
        " input.dispatchEvent(new Event('change')); })()"
    )
    wanted = parts[1499].hex(" ").upper()
    found = f"[...document.querySelectorAll('.mip-pages .mip-packet')].some((one) => one.dataset.bytes === '{wanted}')"
    assert page.run(wait.format(found))


def test_what_is_no_packet_leads_to_the_hits_of_the_finder(page: browser.Page) -> None:
    inspected(page, "mip_3dm_pps_source_control")
    assert page.run("document.querySelector('.mip-results li').dataset.field") == "3dm.pps_source_control"


def test_bytes_and_values_are_linked(page: browser.Page) -> None:
    """Pointing at the bytes of a value marks its row, and the other way round."""
    inspected(page, "75650C04042801041B55")
    page.run("document.querySelector('[data-value=source]').dispatchEvent(new Event('mouseover', { bubbles: true }))")
    assert page.run("[...document.querySelectorAll('tr.mip-pointed')].map((row) => row.dataset.path)") == ["source"]
    colour = "getComputedStyle(document.querySelector({!r})).backgroundColor"
    assert page.run(colour.format("[data-value=source]")) == page.run(colour.format("[data-path=source] td"))

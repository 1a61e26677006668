"""The inspector in Chromium, from disk: for every printed packet, it shows what the reference codec decodes."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator
from typing import Any

import browser
from mipgen import model as m
from mipgen.lower import codec
from random_values import drawn
from support import all_fields, heavy, model, set_of
from workbench import visit

pytestmark = heavy("Chromium")
TOOL = "inspector"

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


def inspected(page: browser.Page, text: str, device: str = "") -> list[Any]:
    """What the page shows for a pasted text."""
    later = f"pause(500).then(() => {READ.strip()})"  # a long text is read a moment after the last key
    read = later if len(text) > 10_000 else READ
    found: list[Any] = page.run(f"put('select', {device!r}); put('textarea', {text!r}); {read}")
    return found


# --------------------------------------------------------------------------- what the reference codec decodes


def parts(p: m.Parameter, value: Any, path: str) -> Iterator[tuple[str, m.Parameter, Any]]:
    """Every number and text of a value; the names of elements depend on the frame."""
    if p.struct:
        yield from rows(p.struct, value, f"{path}.")
    elif p.union:
        for q in (q for q in p.alternatives if q.name in value):
            yield from parts(q, value[q.name], f"{path}.{q.name}")
    elif p.kind == "array":
        for i, item in enumerate(value):
            yield from parts(p.item, item, f"{path}." if p.vector else f"{path}[{i}]")
    else:
        yield path, p, value


def rows(record: m.Record, values: codec.Values, path: str = "") -> Iterator[tuple[str, m.Parameter, Any]]:
    for p in record.parameters:
        if p.name in values:
            yield from parts(p, values[p.name], f"{path}{p.name}")


def check(row: Any, path: str, p: m.Parameter, value: Any) -> None:
    """One line of the page against one value."""
    assert row["path"].startswith(path) and (path.endswith(".") or row["path"] == path)
    number, raw = row["number"], bytes.fromhex(row["bytes"].replace(" ", ""))
    if p.kind == "text":
        assert json.loads(number) == value.rstrip("\0 ")
    elif p.kind == "bits":
        assert list(raw) == value
    elif p.scalar.kind == "float":
        shown = (
            raw.hex() if number == f"NaN ({value})" else struct.pack(">f" if p.size == 4 else ">d", float(number)).hex()
        )
        assert shown == value[2:]
    else:
        assert int(number, 0) == value
    if isinstance(p.named, m.Enum) and not p.readings:
        known = [v.name for v in p.named.values if v.value == value]
        assert row["name"] in (known or [None, "unknown"])
    elif isinstance(p.named, m.Bitfield) and p.named.scalar and not p.readings:
        single = {b.name for b in p.named.bits if b.width == 1 and not b.alias and value & b.mask}
        assert single <= {flag.split()[0] for flag in row["flags"]}


def compare(page: browser.Page, packets: list[bytes]) -> None:
    """Compares all packets in one paste."""
    of = model("real")
    for packet, shown in zip(packets, inspected(page, " ".join(p.hex() for p in packets)), strict=True):
        assert shown["kind"] == "packet" and bytes.fromhex(shown["bytes"]) == packet
        assert shown["verdict"] == f"Checksum {packet[-2:].hex(' ').upper()} is right."
        for field, (descriptor, data) in zip(shown["fields"], codec.split(of, packet), strict=True):
            known = codec.choose(of.candidates(packet[2], descriptor), data)
            assert field["name"] == (known.full_name if known else "") and field["wrong"] is None
            if known is not None:
                constants = {p.name for p in known.parameters if p.constant is not None}
                found = [row for row in field["rows"] if row["path"] not in constants]
                for row, line in zip(found, rows(known, codec.decode(known, data)[0]), strict=True):
                    check(row, *line)


def test_every_printed_packet(page: browser.Page) -> None:
    packets = [e.packet for e in model("real").examples if e.role != "field"]
    assert len(packets) > 100
    compare(page, packets)


def test_every_field(page: browser.Page) -> None:
    of = model("real")
    chosen = ((f, drawn(f, 8)[0]) for f in all_fields(of))
    compare(page, [codec.build(of, set_of(f, of), [(f.descriptor, codec.encode(f, v))]) for f, v in chosen])


def test_a_text_without_bytes_is_told_from_none(page: browser.Page) -> None:
    shown = {}
    for text in ("", "xyzzy plugh"):
        assert inspected(page, text) == []
        shown[text] = page.run("text('.mip-output')")
    said = "No bytes were found in this text; hexadecimal is needed. Not read as bytes: xyzzy plugh"
    assert shown == {"": "Nothing to read yet.", "xyzzy plugh": said}


def others(page: browser.Page, text: str) -> list[str]:
    assert inspected(page, text) == []
    found: list[str] = page.run("texts('.mip-other .mip-wrong')")
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
        assert page.run("text('.mip-field h3')").endswith(f" (0x{number:02X},0x{f.descriptor:02X}) {name}")


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


def dropped(page: browser.Page, log: bytes) -> None:
    inspected(page, "")
    page.run(
        "(() => { const held = new DataTransfer();"
        f" held.items.add(new File([Uint8Array.of({','.join(map(str, log))})], 'drive.bin'));"
        " const event = new DragEvent('drop', { dataTransfer: held, bubbles: true });"
        " document.querySelector('#tool').dispatchEvent(event); })()"
    )
    page.run("until(() => document.querySelector('.mip-log table'))")
    page.run("document.querySelector('.mip-pages').open = true")
    page.run("until(() => document.querySelectorAll('.mip-pages .mip-packet').length > 1)")


def test_bits_of_a_log_are_those_of_its_device_in_the_state_of_their_record(page: browser.Page) -> None:
    of = model("real")
    status = next(f for f in of.fields if f.full_name == "filter_data.status")
    information = bytes(2) + b"3DM-GX5-25".rjust(16) + b"6253-9999".rjust(16) + bytes(48)
    log = codec.build(of, 1, [(0xF1, b"\x03\0"), (0x81, information)])
    for state in (1, 2):
        log += codec.build(of, 0x82, [(status.descriptor, bytes([0, state, 0, 1, 0x10, 0x01]))])
    dropped(page, log)
    flags = page.run(
        "[...document.querySelectorAll('.mip-pages [data-field=\"filter_data.status\"] [data-path=status_flags]')]"
        ".map((row) => row.innerText)"
    )
    assert ["init_no_attitude" in one for one in flags] == [True, False]
    assert ["run_mag_bias_est_high_warning" in one for one in flags] == [False, True]


def test_a_log_is_dropped(page: browser.Page) -> None:
    """With damage and a gap: its fields, rates and gaps, and any packet of it, page by page."""
    of = model("real")
    time, accel = of.field("shared.reference_timestamp"), of.field("sensor.scaled_accel")
    assert time is not None and accel is not None
    parts = []
    for i in [*range(700), *range(710, 2000)]:
        data = ((5 * 10**9 + i * 10**7).to_bytes(8, "big"), bytes(12))
        parts.append(codec.build(of, 0x80, [(f.descriptor, x) for f, x in zip((time, accel), data, strict=True)]))
    visit(page, TOOL)
    dropped(page, b"".join(parts) + b"noise")
    assert page.run("document.querySelectorAll('.mip-output .mip-packet').length") == 0  # the example is gone
    rows = page.run(
        "[...document.querySelector('.mip-log table').tBodies[0].rows]"
        ".map((row) => [...row.cells].map((cell) => cell.textContent))"
    )
    assert [row[1:] for row in rows] == [
        ["0x80,0x04", "1990", "100", "1, 10 samples missing"],
        ["0x80,0xD5", "1990", "100", "1, 10 samples missing"],
    ]
    said = page.run("text('.mip-log .mip-summary')")
    assert said == f"drive.bin: {sum(map(len, parts)) + 5} bytes, 1990 packets; 5 bytes outside packets."
    assert page.run("document.querySelectorAll(':is([role=status], [aria-live]) :is(table, section)').length") == 0
    page.run("put('#mip-log-packet', 1500)")
    wanted = parts[1499].hex(" ").upper()
    page.run(f"until(() => data('.mip-pages .mip-packet', 'bytes').includes('{wanted}'))")


def test_what_is_no_packet_leads_to_the_hits_of_the_finder(page: browser.Page) -> None:
    inspected(page, "mip_3dm_pps_source_control")
    assert page.run("document.querySelector('.mip-results li').dataset.field") == "3dm.pps_source_control"


def test_bytes_and_values_are_linked(page: browser.Page) -> None:
    """Pointing at the bytes of a value marks its row, and the other way round."""
    inspected(page, "75650C04042801041B55")
    page.run("document.querySelector('[data-value=source]').dispatchEvent(new Event('mouseover', { bubbles: true }))")
    assert page.run("data('tr.mip-pointed', 'path')") == ["source"]
    colour = "getComputedStyle(document.querySelector({!r})).backgroundColor"
    assert page.run(colour.format("[data-value=source]")) == page.run(colour.format("[data-path=source] td"))

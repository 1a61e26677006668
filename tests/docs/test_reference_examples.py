"""Every example is decoded byte by byte, on the page of examples and with the fields that it shows."""

from __future__ import annotations

import re
import shutil
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from mipgen import model as m
from mipgen.resolve.load import load_model
from mipgen.targets.markdown.view.manuals import parts_of_examples
from reference import Manual, made, manual_of, path_of, prose, table_with, words
from support import SPECS, some


def shown(e: m.Example) -> bytes:
    return e.packet[4:-2] if e.role == "field" else e.packet


ROLES = {"command": "command", "reply": "reply", "data": "data", "field": "one field, without a packet"}


def test_every_example_has_its_section(manual: Manual) -> None:
    for e in manual.model.examples:
        section = manual.example(e)
        seen = words(section)
        (block,) = re.findall(r"^`(.*)`$", section, re.M)
        rows = table_with(section, "Bytes", "Part")
        assert bytes.fromhex(block) == shown(e)
        assert bytes.fromhex(" ".join(words(row["Bytes"]) for row in rows)) == shown(e), e.id
        device = f", {e.device.title}" if e.device else ""
        assert f"\n### {e.id}\n\n{e.title} ({ROLES[e.role]}{device}), in “{e.section}”." in seen
        assert prose(e.note, manual.model) in seen
        assert (e.string is not None) == ("String in the manual" in seen)
        assert e.string is None or f"String in the manual: {e.string}\n" in seen
        table = " ".join("??" if b is None else f"{b:02X}" for b in e.table or ())
        assert (e.table is not None) == (f"Table in the manual: {table}\n" in seen)
        check_values(manual.model, e, rows)


def test_examples_are_with_their_fields(manual: Manual) -> None:
    of = manual.model
    for e in of.examples:
        for x in e.fields:
            about = [x.field] if x.field else []
            if x.field == of.protocol.acknowledge.full_name:
                commands = [f for f in of.fields if f.role == m.COMMAND and (f.set, f.descriptor) == (e.set, x.data[0])]
                about = [f.full_name for f in commands]
            for name in about:
                f = some(of.field(name))
                (line,) = re.findall(r"^- Examples in the manuals: (.*)$", manual.page(path_of(f)), re.M)
                assert f"#example.{e.id})" in line and e.title in words(line)


def flat(value: Any, path: str) -> Iterator[tuple[str, Any]]:
    """Single values by their paths; lists of numbers stay whole."""
    if isinstance(value, dict):
        for name, inner in value.items():
            yield from flat(inner, f"{path}.{name}" if path else name)
    elif isinstance(value, list) and value and isinstance(value[0], (dict, list)):
        for i, inner in enumerate(value):
            yield from flat(inner, f"{path}[{i}]")
    else:
        yield path, value


def check_values(model: m.Model, e: m.Example, rows: list[dict[str, str]]) -> None:
    """The decoded values are in the table, in order."""
    values = [pair for x in e.fields if x.values is not None for pair in flat(x.values, "")]
    at = 0
    for path, value in values:
        if value == [] or value == "" or value == {}:
            continue
        while words(rows[at]["Part"]) != path:
            at += 1
            assert at < len(rows), (e.id, path)
        text = words(rows[at]["Value"])
        at += 1
        for one in value if isinstance(value, list) and "0x" not in text else [value]:
            if isinstance(one, int):
                assert re.search(rf"(?<!\w){one}(?!\w)|0x0*{one:X}(?!\w)", text), (e.id, path)
            elif isinstance(one, str) and re.fullmatch(r"0x([0-9a-f]{8}){1,2}", one):
                raw = bytes.fromhex(one[2:])
                form = ">f" if len(raw) == 4 else ">d"
                numbers = re.findall(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]\d+)?(?![\w.])", text)
                assert raw in [struct.pack(form, float(n)) for n in numbers] or raw.hex().upper() in text, (e.id, path)


def test_examples_are_in_the_order_of_their_manual(manual: Manual) -> None:
    """The sections in the order of the manual; in each, the examples in the order of their file."""
    pages = {path: text for path, text in manual.pages.items() if path.startswith("docs/examples/")}
    seen = {path: re.findall(r'<a id="example\.([^"]*)"></a>', text) for path, text in pages.items()}
    assert sorted(x for ids in seen.values() for x in ids) == sorted(e.id for e in manual.model.examples)
    for of in manual.model.protocol.manuals:
        own = [e for e in manual.model.examples if e.manual == of.id]
        if of.sections:
            own = [e for section in of.sections for e in own if e.section == section]
        parts = [x for x in parts_of_examples(manual.model) if x.manual == of]
        assert seen.get(f"docs/examples/{of.id}.md", []) == [e.id for x in parts for e in x.entries]
        for x in parts:
            assert [e.id for e in x.entries] == [e.id for e in own if e in x.entries]
            assert f"](examples/{of.id}.md#{x.anchor}) | {len(x.entries)} |" in manual.page("examples.md")


def test_two_devices_with_one_manual(tmp_path: Path) -> None:
    """The meaning of a value is known if the example names its device, or if its manual covers one device only."""
    spec = tmp_path / "spec"
    shutil.copytree(SPECS["invented"][0], spec)
    device = spec / "devices/model_b.yaml"
    device.write_text(device.read_text("utf-8").replace("manual: leaflet", "manual: guide"), "utf-8")
    both = load_model(spec)
    assert {e.id: e.device.id if e.device else None for e in both.examples if e.role == "reply"} == {
        "ping-reply": None,
        "ping-reply-of-b": "model-b",
    }
    manual = made(both)
    for name, device_, code in (("ping-reply", "", "ok (0)"), ("ping-reply-of-b", "Model B", "default (0)")):
        section = words(manual.example(next(e for e in both.examples if e.id == name)))
        assert f"| 00 | code | {code} |" in section and f"(reply{', ' if device_ else ''}{device_})" in section


def test_values_mean_what_they_mean_on_the_device() -> None:
    """Names and units are those of the device of the example."""
    shown_ = manual_of("invented")
    section = words(shown_.example(next(e for e in shown_.model.examples if e.id == "accel-bytes")))
    assert "| scaled_accel | x 1 m, y -1 m, z NaN (0x7FE5BF7F) s |" in section

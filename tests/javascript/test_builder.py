"""The builder in Chromium, from disk: filled in by hand, it builds what the Python binding encodes."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import browser
import pytest
from mipgen import codec
from mipgen import model as m
from support import ROOT, all_fields, driver, encode_request, heavy, model, set_of

pytestmark = [] if browser.installed() else heavy("chromium")

#: Fills in the form by its labels; defines `fill`.
FILL = (Path(__file__).parent / "fill.js").read_text("utf-8")


@pytest.fixture(scope="module")
def page() -> Iterator[browser.Page]:
    with browser.page() as opened:
        opened.open(ROOT / "generated/javascript/tools/builder.html")
        opened.run(f"{FILL}; 0")
        yield opened
        assert opened.complaints == []


def texts(value: Any) -> Any:
    if isinstance(value, dict):
        return {k: texts(v) for k, v in value.items()}
    return [texts(v) for v in value] if isinstance(value, list) else str(value)


def built(page: browser.Page, f: m.Field, number: int, values: dict[str, Any]) -> Any:
    """What the page shows; counters have no input."""
    given = {k: v for k, v in values.items() if k != "function" or not f.functions}
    selector = str(values["function"]) if f.functions else None
    arguments = [f.full_name, number, selector, texts(uncounted(f.operations, given))]
    return page.run(f"fill({', '.join(json.dumps(a) for a in arguments)})")


def uncounted(operations: tuple[m.Operation, ...], values: Any) -> Any:
    """Values without those that the page counts itself."""
    left = dict(values)
    for op in [x for o in operations for x in (o.body if isinstance(o, m.GroupOp) else (o,))]:
        name = op.member if not isinstance(op, m.GroupOp) else ""
        if name not in left:
            continue
        match op:
            case m.CounterOp():
                del left[name]
            case m.StructOp():
                left[name] = uncounted(op.struct.operations, left[name])
            case m.ArrayOp(item=m.StructOp() as item):
                left[name] = [uncounted(item.struct.operations, one) for one in left[name]]
            case m.SwitchOp():
                inner = tuple(c.operation for c in op.cases if c.operation and c.operation.member in left[name])[:1]  # type: ignore[union-attr]
                left[name] = uncounted(inner, left[name])
    return left


def required_only(f: m.Field, values: dict[str, Any]) -> bool:
    """The builder fills in what a function requires, and nothing else."""
    function = values.get("function")
    if f.functions and function not in {x.value for x in f.functions}:
        return False
    call = next(c for c in f.calls if c.function is None or c.function.value == function)
    names = {p.name for p in call.required if p.constant is None} | ({"function"} if f.functions else set())
    return set(values) == names


def test_every_printed_packet(page: browser.Page) -> None:
    of, requests, shown = model("real"), [], []
    for e in model("real").examples:
        for part in e.fields:
            f = of.field(part.field) if part.field else None
            if f is None or part.trailing or part.values is None or not required_only(f, part.values):
                continue
            number = e.set if e.set in (set_of(f, of), e.set) else set_of(f, of)
            requests.append(encode_request(number, f, part.values))
            shown.append(built(page, f, number, part.values)["bytes"])
    assert len(requests) > 150
    for request, answer, bytes_ in zip(requests, driver("python", "real").ask(requests), shown, strict=True):
        assert bytes_ == bytes.fromhex(answer["packet"]).hex(" ").upper(), request


def test_values_by_default_of_every_field(page: browser.Page) -> None:
    """What the form begins with can be sent: the Python binding decodes and encodes it to the same bytes."""
    of, requests, shown = model("real"), [], []
    for f in random.Random(1).sample(all_fields(of), 120):
        for function in [x.value for x in f.functions] or [None]:
            values = {} if function is None else {"function": function}
            found = built(page, f, set_of(f, of), values)
            requests.append({"op": "decode", "packet": found["bytes"].replace(" ", "")})
            shown.append((f, found))
    for (f, found), answer in zip(shown, driver("python", "real").ask(requests), strict=True):
        (got,) = answer["fields"]
        assert got["name"] == f.full_name and got["trailing"] == 0, (f.full_name, found)


def test_source_code(page: browser.Page) -> None:
    f = model("real").field("base.ping")
    assert f is not None
    assert built(page, f, 1, {})["sources"] == {
        "c": "static const uint8_t packet[] = {0x75, 0x65, 0x01, 0x02, 0x02, 0x01, 0xE0, 0xC6};",
        "python": r'packet = b"\x75\x65\x01\x02\x02\x01\xe0\xc6"',
        "rust": "const PACKET: [u8; 8] = [0x75, 0x65, 0x01, 0x02, 0x02, 0x01, 0xE0, 0xC6];",
    }


def test_answers(page: browser.Page) -> None:
    """Each command and function: a response where the model has one, else the acknowledge, or nothing."""
    of = model("real")
    for f in [f for f in of.fields if f.role == m.COMMAND and f.sent_by == "host"][::4]:
        for function in f.functions or (None,):
            found = built(page, f, f.set, {"function": function.value} if function else {})
            assert found["answer"] is not None, (f.full_name, found)
            responds = bool(f.responses) and (function is None or function.responds)
            assert found["responses"] == ([r.full_name for r in of.responses(f)] if responds else []), f.full_name
            if function is not None and not function.reply:
                assert found["answer"] == f"The function {function.name} is not answered."
            elif not responds:
                ack = codec.build(of, f.set, [(of.protocol.acknowledge.descriptor, bytes([f.descriptor, 0]))])
                assert ack.hex(" ").upper() in found["answer"]


def test_wrong_values_are_named(page: browser.Page) -> None:
    f = model("real").field("3dm.uart_baud_rate")
    assert f is not None
    assert "does not fit" in built(page, f, 0x0C, {"function": 1, "baud": 1 << 40})["bytes"]
    assert "is not a whole number" in built(page, f, 0x0C, {"function": 1, "baud": "fast"})["bytes"]

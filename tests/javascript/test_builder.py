"""The builder in Chromium, from disk: filled in by hand, it builds what the Python binding encodes."""

from __future__ import annotations

import json
import math
import random
import urllib.parse
from collections.abc import Iterator
from typing import Any

import browser
import pytest
from mipgen import model as m
from mipgen.facts.sample_values import SampleValues
from mipgen.lower import codec
from support import all_fields, driver, encode_request, heavy, model, set_of
from workbench import visit

pytestmark = heavy("Chromium")
TOOL = "builder"


def texts(value: Any) -> Any:
    if isinstance(value, dict):
        return {k: texts(v) for k, v in value.items()}
    return [texts(v) for v in value] if isinstance(value, list) else str(value)


def built(page: browser.Page, f: m.Field, number: int, values: dict[str, Any]) -> Any:
    """What the page shows; counters have no input."""
    given = {k: v for k, v in values.items() if k != "function" or not f.functions}
    selector = str(values["function"]) if f.functions else None
    arguments = [f.full_name, number, selector, texts(uncounted(f.parameters, given))]
    return page.run(f"fill({', '.join(json.dumps(a) for a in arguments)})")


def uncounted(parameters: tuple[m.Parameter, ...], values: Any) -> Any:
    """Values without those that the page counts itself."""
    left = dict(values)
    for p in parameters:
        if p.name not in left:
            continue
        if p.counts:
            del left[p.name]
        elif p.struct:
            left[p.name] = uncounted(p.struct.parameters, left[p.name])
        elif p.item.struct:
            left[p.name] = [uncounted(p.item.struct.parameters, one) for one in left[p.name]]
        elif p.union:
            left[p.name] = uncounted(tuple(q for q in p.alternatives if q.name in left[p.name])[:1], left[p.name])
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
        "cpp": "constexpr std::array<std::uint8_t, 8> packet{0x75, 0x65, 0x01, 0x02, 0x02, 0x01, 0xE0, 0xC6};",
        "python": r'packet = b"\x75\x65\x01\x02\x02\x01\xe0\xc6"',
        "rust": "const PACKET: [u8; 8] = [0x75, 0x65, 0x01, 0x02, 0x02, 0x01, 0xE0, 0xC6];",
        "javascript": "const packet = Uint8Array.of(0x75, 0x65, 0x01, 0x02, 0x02, 0x01, 0xE0, 0xC6);",
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


# --------------------------------------------------------------------------- devices, several fields, addresses


def packet(page: browser.Page) -> bytes:
    return bytes.fromhex(page.run("document.querySelector('.mip-packet-bytes').textContent"))


def address(page: browser.Page) -> str:
    """The fragment of the address, which follows what is built after a moment."""
    text: str = page.run("pause(500).then(() => location.hash.slice(1))")
    return text


@pytest.fixture
def own(page: browser.Page) -> Iterator[browser.Page]:
    """The page, for tests that open other addresses; it is opened anew afterwards."""
    yield page
    visit(page, TOOL)


def test_it_begins_with_what_the_page_of_the_field_shows(own: browser.Page) -> None:
    of = model("real")
    samples = SampleValues(of)
    for name in ("3dm.message_format", "aiding.llh_position", "sensor.scaled_accel"):
        f = of.field(name)
        assert f is not None
        visit(own, TOOL, f"#{name}")
        assert packet(own) == samples.packet(f)
    visit(own, TOOL, "#3dm.message_format")
    assert own.run("texts('.mip-meant')") == ["Sensor data", "Scaled accel", "Scaled gyro"]


def test_numbers_in_hexadecimal_follow_the_set(own: browser.Page) -> None:
    visit(own, TOOL, "#3dm.message_format")
    own.run("put('.mip-hex', '0x82')")
    set_, *fields = own.run("texts('.mip-meant')")
    assert set_ == "Filter data" and fields != ["Scaled accel", "Scaled gyro"]
    own.run("put('.mip-hex', '0x7')")
    assert packet(own)[7] == 7 and own.run("texts('.mip-meant')") == ["", "", ""]
    own.run("put('.mip-hex', '0x')")
    assert "is not a whole number" in own.run("text('.mip-wrong')")


def test_elements_and_units_follow_the_frame(own: browser.Page) -> None:
    visit(own, TOOL, "#filter.initialization_config")
    labels = (
        "[...document.querySelectorAll('fieldset')].find((one) => one.querySelector('legend').textContent"
        ".startsWith('initial_position')).innerText.split(/\\s+/)"
    )
    shown = own.run(labels)
    assert {"latitude", "longitude", "height", "deg", "m"} <= {*shown} and "x" not in shown
    frame = "[...document.querySelectorAll('select')].find((one) => one.textContent.includes('1 ecef'))"
    own.run(f"{frame}.id = 'frame'; put('#frame', '1')")
    shown = own.run(labels)
    assert {"x", "y", "z", "m"} <= {*shown} and "latitude" not in shown and "deg" not in shown


def test_several_fields(own: browser.Page) -> None:
    of = model("real")
    visit(own, TOOL, "#base.ping")
    own.run("enter('#mip-add', 'base.set_idle')")
    own.run("enter('#mip-add', 'base.resume')")
    assert packet(own) == codec.build(of, 1, [(1, b""), (2, b""), (6, b"")])
    own.run("document.querySelector('[aria-label=\"Up: field 3\"]').click()")
    assert packet(own) == codec.build(of, 1, [(1, b""), (6, b""), (2, b"")])
    own.run("document.querySelector('[aria-label=\"Remove: field 1\"]').click()")
    assert packet(own) == codec.build(of, 1, [(6, b""), (2, b"")])
    offered = own.run("put('#mip-add', 'pps'); data('.mip-forms .mip-hits li', 'field')")
    assert not [name for name in offered if name.startswith("3dm")], "of another set"


@pytest.mark.parametrize(
    ("fragment", "field"),
    [
        ("mip_3dm_pps_source_control_write", "3dm.pps_source_control"),
        ("lever arm", "filter.speed_lever_arm"),
        ("zzzz", ""),
    ],
)
def test_what_is_no_field_leads_to_the_hits_of_the_finder(own: browser.Page, fragment: str, field: str) -> None:
    """It leads to no packet: the first command of the specification is not what was meant."""
    visit(own, TOOL, f"#{fragment}")
    hits = own.run("data('.mip-hits li', 'field')")
    assert (field in hits) if field else not hits
    assert own.run("document.querySelector('.mip-packet-bytes')") is None
    assert own.run("document.querySelector('#mip-field').value") == fragment
    if field:
        own.run(f"document.querySelector('.mip-hits [data-field=\"{field}\"] button').click()")
        assert packet(own)


def test_what_the_address_cannot_give_is_said(own: browser.Page) -> None:
    """The reason, and the address stays until something is changed."""
    why = "The packet in the address cannot be used: "
    for fragment, problem in {
        "756501030301775924": "Bytes that belong to no parameter are left out: 1 at the end of base.ping.",
        "756501020201E0C7": f"{why}its checksum is e0 c7, but should be e0 c6.",
        "756501020201E0C6756501020201E0C6": f"{why}its 16 bytes are not a whole packet.",
        "75650100DB05": f"{why}it has no fields.",
        codec.build(model("real"), 1, [(0x7D, b"")]).hex(): f"{why}there is no field with descriptor 0x7D in its set.",
        codec.build(model("real"), 1, [(0x09, b"")]).hex(): f"{why}the data is 1 byte short.",
        "no such thing": "The address contains neither the name of a field nor a packet.",
        "%": "The address contains neither the name of a field nor a packet.",
        "base.ping": None,
    }.items():
        visit(own, TOOL, f"#{fragment}")
        assert own.run("document.querySelector('[role=status].mip-wrong')?.textContent ?? null") == problem, fragment
        assert urllib.parse.unquote(own.run("location.hash.slice(1)")) == fragment
        nothing = own.run("document.querySelector('.mip-packet-bytes')") is None
        assert nothing == (problem is not None and "left out" not in problem), "no packet that nobody asked for"
    own.run("enter('#mip-add', 'base.set_idle')")
    assert address(own) == f"packet={packet(own).hex().upper()}"


def test_a_device_limits_what_may_be_sent(own: browser.Page) -> None:
    of = model("real")
    visit(own, TOOL, "#base.ping")
    for d in of.devices:
        own.run(f"put('#mip-device', {d.id!r})")
        shown = set(browsed(own))
        known = {s.name for s in d.supports}
        if d.incomplete:
            known = {f.name_in(number) for f in of.fields for number in ([0] if f.everywhere else f.sets)}
            known -= {s.name for s in d.refuses}
            lacked = {s.name for e in d.evidence for s in e.sets}
            known = {name for name in known if name.partition(".")[0] not in lacked}
        answers = {f.full_name for f in of.fields if f.role == m.RESPONSE}
        assert shown - answers == known - answers - {"protocol.acknowledge"}


def browsed(page: browser.Page) -> dict[str, str]:
    """The names of all fields that are offered, with their titles and marks."""
    shown: dict[str, str] = page.run(
        "new Promise((done) => { const list = document.querySelector('.mip-browse');"
        " list.addEventListener('toggle', () => setTimeout(() =>"
        " done(Object.fromEntries([...list.querySelectorAll('li')]"
        ".map((one) => [one.querySelector('code').textContent, one.querySelector('strong').textContent])))),"
        " { once: true });"
        " list.open = true; })"
    )
    page.run("document.querySelector('.mip-browse').open = false")
    return shown


def test_a_field_of_several_sets_is_built_into_the_named_one(own: browser.Page) -> None:
    visit(own, TOOL, "#gnss_2.dop")
    assert packet(own)[2] == 0x92
    own.run("enter('#mip-field', 'gnss_1.dop')")
    assert packet(own)[2] == 0x91


def test_what_is_not_known_of_a_device_is_offered_and_marked(own: browser.Page) -> None:
    """The device may have what the sources of an incomplete profile do not mention."""
    visit(own, TOOL, "#3dm-gq7 filter.run")
    offered = browsed(own)
    assert offered["filter.run"] == "Run navigation filter"
    assert offered["base.ping"] == "Ping (likely)"
    assert offered["3dm.poll_imu_data"] == "Poll IMU data (not known)"
    tool = "text('#tool > [role=status]')"
    assert "The profile of the 3DM-GQ7-GNSS/INS is incomplete: Only some pages" in own.run(tool)
    own.run("enter('#mip-field', '3dm.poll_imu_data')")
    assert own.run("texts('.mip-device-notes li')") == ["3DM-GQ7-GNSS/INS: it is not known whether it supports this"]
    own.run("enter('#mip-field', '3dm.poll_gnss_data'); put('#mip-device', '3dm-cv7-ar')")
    assert own.run("texts('.mip-device-notes li')") == ["3DM-CV7-AR: it does not support this"]
    own.run("put('#mip-device', '3dm-gx5-15')")
    assert "incomplete" not in own.run(tool)


def test_a_device_says_what_differs(own: browser.Page) -> None:
    d, s = next((d, s) for d in model("real").devices for s in d.certain if s.differs and s.field.role == m.COMMAND)
    visit(own, TOOL, f"#{d.id} {s.field.full_name}")
    notes = own.run("texts('.mip-device-notes li')")
    assert f"{d.title}: only {', '.join(f.name for f in s.functions)}" in notes
    visit(own, TOOL, "#3dm-gx5-15 3dm.message_format")
    assert own.run("texts('.mip-device-notes li')") == ["3DM-GX5-15: it is not known to support this"]
    visit(own, TOOL, "#3dm-gx5-15 3dm.data_stream_control")
    said = "3DM-GX5-15: descriptor_set: values of 3dm.legacy_data_stream; only imu, filter"
    assert said in own.run("texts('.mip-device-notes li')")


def test_optional_parameters(own: browser.Page) -> None:
    f = model("real").field("filter.accel_magnitude_error_adaptive_measurement")
    assert f is not None
    visit(own, TOOL, f"#{f.full_name}")
    least = packet(own)
    for _ in range(6):
        own.run("document.querySelector('.mip-more').click()")
    ((_, data),) = codec.split(model("real"), packet(own))
    values, left = codec.decode(f, data)
    assert left == 0 and len(values) == 8 and own.run("document.querySelector('.mip-more')") is None
    for _ in range(6):
        own.run("document.querySelector('.mip-less').click()")
    assert packet(own) == least


def test_rates_in_hz_become_decimations(own: browser.Page) -> None:
    """On a device whose base rate is known; what the port must carry stays in view."""
    visit(own, TOOL, "#3dm.message_format")
    assert own.run("document.querySelector('.mip-hertz')") is None
    assert own.run("document.querySelector('.mip-totals').hidden")
    own.run("put('#mip-device', '3dm-cv7-gnss-ins')")
    rates = "[...document.querySelectorAll('.mip-hertz')].map((one) => one.value)"
    assert own.run(rates) == ["100", "100"]
    own.run("put('.mip-hertz', '300')")
    assert packet(own)[9:12] == bytes((4, 0, 3))  # scaled_accel at a third of 1000 Hz
    assert own.run(rates) == ["333.333", "100"]
    need = (6 + 14) * 1000 / 3 + 14 * 100
    wanted = f"These rates need {math.ceil(need)} bytes/s; over a UART at least {math.ceil(10 * need)} Bd."
    assert own.run("text('.mip-totals')") == wanted
    own.run("put('p:has(.mip-hertz) input', '2')")
    assert own.run(rates) == ["500", "100"] and packet(own)[11] == 2
    own.size(1400)
    own.run("window.scrollTo(0, document.body.scrollHeight)")
    top = own.run("document.querySelector('.mip-totals').getBoundingClientRect().top")
    assert 0 <= top < 900
    own.run("put('#mip-device', '')")
    assert own.run("document.querySelector('.mip-hertz')") is None
    assert own.run("document.querySelector('.mip-totals').hidden")


def test_the_focus_stays_when_the_form_changes(own: browser.Page) -> None:
    """A key in a number, a choice, and buttons, whose successor has the focus; what was typed stays as it was."""
    visit(own, TOOL, "#3dm.message_format")
    active = "document.activeElement"
    own.run("document.querySelector('.mip-hex').focus()")
    own.run(f"{active}.value = '0x8'; {active}.setSelectionRange(3, 3); {active}.dispatchEvent(new Event('input')); 0")
    assert own.run(f"[{active}.className, {active}.value, {active}.selectionStart]") == ["mip-hex", "0x8", 3]
    select = "[...document.querySelectorAll('.mip-forms select')].at(0)"
    own.run(f"{select}.focus(); {active}.value = 2; {active}.dispatchEvent(new Event('input')); 0")
    assert own.run(f"{active} === {select} && {active}.value") == "2"
    visit(own, TOOL, "#base.ping")
    own.run("document.querySelector('#mip-add').focus()")
    own.run("enter('#mip-add', 'base.set_idle')")
    assert own.run(f"{active}.id") == "mip-add"
    for label in ("Down: field 1", "Remove: field 2"):
        own.run(f"document.querySelector('[aria-label=\"{label}\"]').focus(); {active}.click()")
        assert own.run(f"document.querySelector('.mip-forms').contains({active})"), label


def clipboard(page: browser.Page) -> str:
    text: str = page.run("navigator.clipboard.readText()")
    return text


@pytest.mark.parametrize("way", ["the clipboard", "a selection"])
def test_everything_can_be_copied(own: browser.Page, way: str) -> None:
    """Bytes, text and source code, even where a page may not write to the clipboard itself."""
    own.call("Emulation.setFocusEmulationEnabled", enabled=True)
    own.browser.call("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
    visit(own, TOOL, "#3dm.pps_source_control")
    if way == "a selection":
        own.run("navigator.clipboard.writeText = () => Promise.reject(new Error('not allowed')); 0")
    buttons = "[...document.querySelectorAll('.mip-output .mip-copy')]"
    shown = [packet(own).hex(" ").upper(), *own.run("texts('[data-language]')")]
    assert len(shown) == 1 + 5
    copied = []
    for i in range(own.run(f"{buttons}.length")):
        click = f"(() => {{ window.button = {buttons}[{i}]; window.button.click(); }})()"
        own.call("Runtime.evaluate", expression=click, userGesture=True)
        assert own.run("pause(50).then(() => window.button.textContent)") == "Copied"
        copied.append(clipboard(own))
    assert {*shown} <= {*copied} and all(copied)
    values = [text for text in copied if "GPIO" in text.upper() and text not in shown]
    assert values, copied

"""The finder in Chromium, from disk: what people type, and the field that they mean."""

from __future__ import annotations

from typing import Any

import browser
import pytest
from searches import FIELDS
from support import heavy
from workbench import visit

pytestmark = heavy("Chromium")
TOOL = "finder"


def found(page: browser.Page, text: str) -> list[Any]:
    fields: list[Any] = page.run(f"put('input', {text!r}); data('li[data-field]', 'field')")
    return fields


@pytest.mark.parametrize(("text", "field"), FIELDS.items())
def test_what_people_type(page: browser.Page, text: str, field: str) -> None:
    assert field in found(page, text)[:3]


def test_nothing_found(page: browser.Page) -> None:
    assert found(page, "xyzzy") == []
    assert page.run("text('[role=status]')") == "Nothing found."
    assert found(page, "gimbal lock") and page.run("text('[role=status]')").startswith("Nothing has “gimbal”. ")
    assert found(page, "") == [] and page.run("text('[role=status]')") == ""


def test_without_a_reference_hits_lead_to_the_builder(page: browser.Page) -> None:
    found(page, "0x0D13")
    links = page.run("[...document.querySelectorAll('.mip-results a')].map((link) => link.getAttribute('href'))")
    assert links == ["builder.html#filter.antenna_offset"]


@pytest.mark.parametrize(
    ("field", "href"),
    [
        ("filter.antenna_offset", "fields/filter/antenna_offset.html#filter.antenna_offset"),
        ("3dm.gyro_bias_response", "fields/3dm/gyro_bias.html#3dm.gyro_bias_response"),
        ("protocol.acknowledge", "packets.html#protocol.acknowledge"),
    ],
)
def test_enter_goes_to_the_first(page: browser.Page, field: str, href: str) -> None:
    """A response is on the page of its command, and the acknowledge on one of its own."""
    page.run(
        "mip.finder(document.getElementById('tool'), new mip.Protocol(mip.model), {"
        " fieldPage: 'fields/{set}/{page}.html#{field}', acknowledgePage: 'packets.html#{field}' }); 0"
    )
    found(page, field)
    page.run(
        "window.gone = []; document.addEventListener('click', (event) => {"
        " gone.push(event.target.closest('a').getAttribute('href')); event.preventDefault(); }, { once: true })"
    )
    page.run("document.querySelector('form').requestSubmit()")
    assert page.run("window.gone") == [href]


@pytest.mark.parametrize(
    "text", ["75 65 01 02 02 01 E0 C6", "7565010202 01e0c6", r'b"\x75\x65\x01\x02\x02\x01\xe0\xc6"']
)
def test_a_packet_is_for_the_inspector(page: browser.Page, text: str) -> None:
    visit(page, TOOL)
    found(page, text)
    first = "document.querySelector('.mip-results li a')"
    assert page.run(f"{first}.textContent") == "Packet: open in the inspector"
    assert page.run(f"{first}.getAttribute('href')") == "inspector.html#75%2065%2001%2002%2002%2001%20E0%20C6"
    found(page, "7565")
    assert page.run(f"{first}?.textContent ?? null") is None

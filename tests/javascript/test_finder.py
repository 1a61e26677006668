"""The finder in Chromium, from disk: what people type, and the field that they mean."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import browser
import pytest
from support import ROOT, heavy

pytestmark = [] if browser.installed() else heavy("chromium")


@pytest.fixture(scope="module")
def page() -> Iterator[browser.Page]:
    with browser.page() as opened:
        opened.open(ROOT / "generated/javascript/tools/finder.html")
        yield opened
        assert opened.complaints == []


def found(page: browser.Page, text: str) -> list[Any]:
    page.run(
        f"(() => {{ const input = document.querySelector('input'); input.value = {text!r};"
        " input.dispatchEvent(new Event('input')); })()"
    )
    fields: list[Any] = page.run("[...document.querySelectorAll('li[data-field]')].map((item) => item.dataset.field)")
    return fields


@pytest.mark.parametrize(
    ("text", "field"),
    [
        ("0x0D13", "filter.antenna_offset"),
        ("0x0D,0x13", "filter.antenna_offset"),
        ("0D 13", "filter.antenna_offset"),
        ("82 10", "filter_data.status"),
        ("(0x82,0x10)", "filter_data.status"),
        ("80 D3", "shared.gps_timestamp"),
        ("0xF1", "protocol.acknowledge"),
        ("nack", "protocol.acknowledge"),
        ("ack", "protocol.acknowledge"),
        ("ping", "base.ping"),
        ("set to idle", "base.set_idle"),
        ("lever arm", "filter.speed_lever_arm"),
        ("save settings", "3dm.device_settings"),
        ("baud rate", "3dm.uart_baud_rate"),
        ("scaled accelerometer", "sensor.scaled_accel"),
        ("mip_3dm_pps_source_control_write", "3dm.pps_source_control"),
        ("MIP_3DM_PPS_SOURCE_GENERATED", "3dm.pps_source_control"),
        ("PpsSourceControl", "3dm.pps_source_control"),
        ("sensor::ScaledAccel", "sensor.scaled_accel"),
        ("poll_imu_message", "3dm.poll_imu_data"),
        ("mip_3dm_poll_imu_message", "3dm.poll_imu_data"),
    ],
)
def test_what_people_type(page: browser.Page, text: str, field: str) -> None:
    assert found(page, text)[0] == field


def test_nothing_found(page: browser.Page) -> None:
    assert found(page, "xyzzy") == []
    assert page.run("document.querySelector('.mip-results').textContent") == "Nothing found."
    assert found(page, "") == [] and page.run("document.querySelector('.mip-results').textContent") == ""


def test_enter_goes_to_the_first(page: browser.Page) -> None:
    found(page, "0x0D13")
    page.run(
        "window.gone = []; document.addEventListener('click', (event) => {"
        " gone.push(event.target.closest('a').getAttribute('href')); event.preventDefault(); }, { once: true })"
    )
    page.run("document.querySelector('form').requestSubmit()")
    assert page.run("window.gone") == ["../fields/filter/antenna_offset/"]

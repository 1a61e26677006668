"""The live view in Chromium, from disk, at a virtual device behind `mip serve`, and at a serial port that it plays."""

from __future__ import annotations

import json
import math
import threading
from collections.abc import Iterator
from contextlib import contextmanager

import browser
import pytest
from mip_protocol import Parser, mip_3dm, sensor
from mip_tools.simulator import Faults, LivePort, VirtualDevice
from mip_tools.simulator.fault_kinds import parse_faults
from mip_tools.simulator.motion import parse_motion
from mip_tools.web.server import Server
from support import heavy
from workbench import workbench

pytestmark = heavy("Chromium")

DEVICE = "3dm-cv7-gnss-ins"
PATIENCE = 30.0

#: Presses a button by its words; `until` waits for a condition; downloads are kept in `saved`.
HELP = """
window.press = (words) => {
    const found = [...document.querySelectorAll("button")].find((one) => one.textContent === words && one.offsetParent);
    if (!found) throw new Error(`there is no button ${words}`);
    found.click();
};
window.until = async (condition, seconds = 30) => {
    for (const end = performance.now() + seconds * 1000; performance.now() < end; ) {
        const found = condition();
        if (found) return found;
        await new Promise((done) => setTimeout(done, 20));
    }
    throw new Error(`never: ${condition}`);
};
window.text = (selector) => document.querySelector(selector)?.textContent ?? "";
window.saved = [];
URL.createObjectURL = (blob) => { saved.push(blob); return "#"; };
HTMLAnchorElement.prototype.click = function () { saved.at(-1).called = this.download; };
window.fold = (title) => [...document.querySelectorAll("details.mip-section")]
    .find((one) => one.querySelector("h2").textContent === title).open = true;
0
"""

STREAMS = (
    "sensor.scaled_accel@100,sensor.scaled_gyro@50,filter_data.euler_angles@50,filter_data.attitude_quaternion@50,"
    "filter_data.attitude_dcm@50"
)


class Served:
    """A virtual device behind `mip serve`, whose port can be pulled."""

    def __init__(self, faults: str = "", motion: str = "circle:radius=20,speed=5", device: str = DEVICE) -> None:
        plans = parse_faults(faults)
        self.device = VirtualDevice(device, motion=parse_motion(motion), faults=Faults(plans=plans) if plans else None)
        self.ports: list[LivePort] = []
        self.server = Server(self._open)

    def _open(self) -> LivePort:
        self.ports.append(LivePort(self.device))
        return self.ports[-1]

    def unplug(self) -> None:
        self.ports[-1].close()


@contextmanager
def served(**options: str) -> Iterator[Served]:
    found = Served(**options)
    with found.server:
        threading.Thread(target=found.server.run, daemon=True).start()
        yield found


@pytest.fixture
def page() -> Iterator[browser.Page]:
    with browser.page() as opened:
        opened.size(1400)
        yield opened
        assert opened.complaints == []


def opened(page: browser.Page, fragment: str) -> None:
    page.open("about:blank")
    page.open((workbench("real") / "live.html").as_uri() + "#" + fragment)
    page.run(HELP)


def connected(page: browser.Page, served: Served, streams: str = STREAMS) -> None:
    opened(page, f"serve={served.server.address}&streams={streams}")
    page.run("press('Connect')")
    page.run("until(() => /^Connected to|^Not|not identified/.test(text('.mip-status')))")
    assert page.run("text('.mip-status')") == "Connected to 3DM-CV7-GNSS/INS."


def started(page: browser.Page) -> None:
    page.run("press('Start')")
    page.run("until(() => text('.mip-attitude + .mip-angles') && document.querySelectorAll('.mip-reading').length > 5)")


def test_identify_stream_and_see(page: browser.Page) -> None:
    with served() as at:
        connected(page, at)
        assert "6292-" in page.run("text('.mip-identity')")
        assert page.run("document.querySelector('.mip-identity').dataset.device") == DEVICE
        started(page)
        names = page.run("[...document.querySelectorAll('.mip-each > .mip-reading')].map((one) => one.dataset.field)")
        assert sorted(names) == sorted(part.split("@")[0] for part in STREAMS.split(","))
        values = page.run(
            "[...document.querySelectorAll('[data-field=\"sensor.scaled_accel\"] dd')].map((one) => one.textContent)"
        )
        assert len(values) == 3 and math.isclose(float(values[2].removesuffix(" g")), -1, abs_tol=0.05)
        # What is drawn is drawn: there are pixels in the plots and in the picture.
        painted = (
            "[...document.querySelectorAll('canvas:not([hidden])')].map((one) => one.getContext('2d')"
            ".getImageData(0, 0, one.width, one.height).data.some((byte) => byte))"
        )
        page.run(f"until(() => {painted}.every(Boolean))")
        assert len(page.run(painted)) == 4
        page.run("press('Stop'); until(() => /device is idle/.test(document.querySelector('#tool').innerText), 5)")
        page.run(f"until(() => location.hash.startsWith('#device={DEVICE}&streams=sensor.scaled_accel@100,'))")
        page.run("press('Disconnect'); until(() => text('.mip-status') === 'Not connected.')")


def test_all_forms_of_the_attitude_are_the_same(page: browser.Page) -> None:
    """Angles, quaternions and matrices, of packets that the device sends while it turns."""
    with served() as at:
        connected(page, at)
        page.run("press('Start'); until(() => document.querySelectorAll('.mip-reading').length > 5)")
        page.run("press('Stop'); until(() => /idle/.test(document.querySelector('#tool').innerText))")
        shown = page.run(
            "Object.fromEntries([...document.querySelectorAll('.mip-each > .mip-reading')]"
            ".map((one) => [one.dataset.field,"
            " [...one.querySelectorAll('dd')].map((value) => Number.parseFloat(value.textContent))]))"
        )
        rotations = page.run(
            "((shown) => { const of = new mip.Protocol(mip.model); const field = (name) => of.field(name);"
            " const [roll, pitch, yaw] = shown['filter_data.euler_angles'];"
            " return [mip.rotationOf(field('filter_data.euler_angles'), { roll, pitch, yaw }),"
            " mip.rotationOf(field('filter_data.attitude_quaternion'),"
            " { q: shown['filter_data.attitude_quaternion'] }),"
            " mip.rotationOf(field('filter_data.attitude_dcm'), { dcm: shown['filter_data.attitude_dcm'] })]; })"
            f"({json.dumps(shown)})"
        )
        for other in rotations[1:]:
            for row, wanted in zip(other, rotations[0], strict=True):
                assert row == pytest.approx(wanted, abs=1e-3)


def test_commands_from_their_page(page: browser.Page) -> None:
    """One that is acknowledged, one with a response, and one that the device rejects."""
    with served() as at:
        connected(page, at)
        page.run("fold('Commands')")
        for name, change, wanted in (
            ("3dm.pps_source_control", "", "PPS Source Control acknowledged."),
            ("base.get_device_info", "", "model_name"),
            ("3dm.pps_source_control", "99", "PPS Source Control refused: invalid parameter."),
        ):
            page.run(
                f"(() => {{ const search = document.querySelector('#mip-field'); search.value = {name!r};"
                " search.dispatchEvent(new Event('input')); search.form.requestSubmit(); })()"
            )
            if change:
                page.run(
                    "(() => { const choice = [...document.querySelectorAll('.mip-form select')].at(-1);"
                    " choice.value = 'other'; choice.dispatchEvent(new Event('input'));"
                    " const number = choice.parentElement.querySelector('input');"
                    f" number.value = {change!r}; number.dispatchEvent(new Event('input')); }})()"
                )
            page.run("press('Send')")
            page.run(f"until(() => text('.mip-outcome').includes({wanted!r}), 5)")


def test_a_recording_has_what_the_device_sent(page: browser.Page) -> None:
    with served() as at:
        connected(page, at, "sensor.scaled_accel@100")
        page.run("press('Record'); press('Start')")
        page.run("until(() => Number.parseInt(text('.mip-totals [role=status]')) > 3000)")
        page.run("press('Stop and save')")
        name, data = page.run("saved[0].arrayBuffer().then((bytes) => [saved[0].called, [...new Uint8Array(bytes)]])")
        assert name.startswith(f"{DEVICE}-") and name.endswith(".bin")
        parser = Parser()
        packets = parser.feed(bytes(data)) + parser.flush()
        assert parser.skipped == 0 and sum(p.set == sensor.ScaledAccel.SET for p in packets) > 100


def test_settings_go_to_a_file_and_come_back(page: browser.Page) -> None:
    with served() as at:
        connected(page, at)
        page.run("fold('Settings'); press('Save to a file'); until(() => saved.length)")
        held = json.loads(page.run("saved[0].text()"))
        names = {one["command"] for one in held["settings"]}
        assert held["device"] == DEVICE and {"3dm.message_format", "3dm.gpio_config", "filter.antenna_offset"} <= names
        assert len(held["settings"]) > 80
        link = at.ports[-1]._link
        changed = mip_3dm.PpsSourceControl.write(mip_3dm.PpsSource.GENERATED)
        with at.ports[-1]._wake:
            link.write(bytes(changed.packet()))
        load = (
            "(() => {{ const input = document.querySelector('#mip-settings'); const held = new DataTransfer();"
            " held.items.add(new File([{}], 'x.json')); input.files = held.files;"
            " input.dispatchEvent(new Event('change')); }})()"
        )
        page.run(load.format(json.dumps(json.dumps(held))))
        page.run("until(() => /already as/.test(document.body.innerText))")
        said = page.run("document.body.innerText")
        assert f"{len(held['settings']) - 1} already as in the file" in said
        assert "1 written, until the next power-off: 3dm.pps_source_control" in said
        page.run(load.format(json.dumps("no file of this page")))
        page.run("until(() => /failed: the file is not one/.test(document.body.innerText))")


def test_unplugged_and_plugged_in_again(page: browser.Page) -> None:
    """The recording is kept, and one click brings the streams back."""
    with served() as at:
        connected(page, at)
        started(page)
        page.run("press('Record'); until(() => Number.parseInt(text('.mip-totals [role=status]')) > 100)")
        at.unplug()
        page.run("until(() => /The connection is lost: the port is lost/.test(text('.mip-status')))")
        assert page.run("saved[0].size") > 100
        page.run("press('Connect again')")
        page.run("until(() => text('.mip-status') === 'Connected to 3DM-CV7-GNSS/INS.')")
        page.run("until(() => document.querySelectorAll('.mip-each > .mip-reading').length === 5)")
    page.run("until(() => /mip serve has ended/.test(text('.mip-status')))")
    page.run("press('Connect again'); until(() => /^Not connected: .*cannot be reached/.test(text('.mip-status')))")
    assert all("WebSocket" in one for one in page.complaints)
    page.complaints.clear()


def test_a_device_that_loses_answers(page: browser.Page) -> None:
    with served(faults="lose_answer=1") as at:
        opened(page, f"serve={at.server.address}")
        page.run("press('Connect')")
        page.run("until(() => /was not identified: .*no answer/.test(text('.mip-status')))")
        page.run("fold('Commands'); press('Send'); until(() => /no answer/.test(text('.mip-outcome')))")


def test_damaged_data_is_counted(page: browser.Page) -> None:
    with served(faults="noise=0.2:16") as at:
        opened(page, f"serve={at.server.address}&streams=sensor.scaled_accel@100")
        page.run("press('Connect')")
        page.run("until(() => /^Connected/.test(text('.mip-status')) && document.querySelector('.mip-actions button'))")
        page.run("until(() => { press('Start'); return true; })")
        page.run("until(() => /\\d+ packets, \\d+ bytes outside packets/.test(document.body.innerText))")


def test_a_page_without_the_token_reaches_nothing(page: browser.Page) -> None:
    """Not by WebSocket, and not by anything that it can fetch."""
    with served() as at:
        page.open("data:text/html,<title>somebody else</title>")
        base = at.server.address.rpartition("/")[0]
        for address in (base, f"{base}/", f"{base}/{'x' * 22}"):
            said = page.run(
                f"new Promise((done) => {{ const s = new WebSocket({address!r}); s.onopen = () => done('open');"
                " s.onerror = () => done('refused'); })"
            )
            assert said == "refused"
        url = at.server.address.replace("ws:", "http:")
        assert page.run(f"fetch({url!r}).then((answer) => answer.status, (error) => error.name)") == "TypeError"
        assert at.ports == []
    page.complaints.clear()


#: A serial port of the browser behind which a WebSocket is; it has the device at one baud rate only.
SERIAL = """
(() => {
    class Port {
        async open({ baudRate }) {
            tried.push(baudRate);
            const socket = baudRate === RIGHT ? new WebSocket(ADDRESS) : undefined;
            if (socket) {
                socket.binaryType = "arraybuffer";
                await new Promise((done) => { socket.onopen = done; });
            }
            this.socket = socket;
            this.readable = new ReadableStream({ start: (to) => {
                if (!socket) return;
                socket.onmessage = ({ data }) => to.enqueue(new Uint8Array(data));
                socket.onclose = () => { this.readable = null; to.error(new Error("The device has been lost.")); };
            } });
            this.writable = new WritableStream({ write: (bytes) => socket?.send(bytes) });
        }
        async close() {
            if (!this.socket) return;
            this.socket.onclose = null;
            this.socket.close();
        }
    }
    window.tried = [];
    const serial = new EventTarget();
    serial.requestPort = async () => new Port();
    Object.defineProperty(navigator, "serial", { value: serial, configurable: true });
})();
0
"""


def test_a_serial_port_whose_baud_rate_is_searched(page: browser.Page) -> None:
    with served() as at:
        page.open("about:blank")
        script = SERIAL.replace("RIGHT", "460800").replace("ADDRESS", json.dumps(at.server.address))
        page.call("Page.addScriptToEvaluateOnNewDocument", source=script)
        page.open((workbench("real") / "live.html").as_uri() + f"#streams={STREAMS}")
        page.run(HELP)
        page.run("press('Open a serial port …'); until(() => text('.mip-status') === 'Connected to 3DM-CV7-GNSS/INS.')")
        assert page.run("tried") == [115200, 3000000, 921600, 460800]
        started(page)
        at.unplug()
        page.run("until(() => /The connection is lost: .*The device has been lost/.test(text('.mip-status')))")


def test_without_web_serial_it_is_said(page: browser.Page) -> None:
    page.call(
        "Page.addScriptToEvaluateOnNewDocument",
        source="Object.defineProperty(navigator, 'serial', { value: undefined, configurable: true })",
    )
    opened(page, "")
    assert "This browser has no Web Serial" in page.run("text('.mip-connect')")
    assert page.run("document.querySelector('.mip-connect button').disabled")

"""The live view in Chromium, from disk, at a virtual device behind `mip serve`, and at a serial port that it plays."""

from __future__ import annotations

import json
import math
import threading
from collections.abc import Iterator
from contextlib import contextmanager

import browser
import pytest
from mip_protocol import PacketBuilder, Parser, sensor
from mip_simulator import Faults, LivePort, VirtualDevice
from mip_simulator.faults.kinds import parse_faults
from mip_simulator.motion import parse_motion
from mip_tools.web.server import Server
from support import heavy
from workbench import tab, visit

pytestmark = heavy("Chromium")

DEVICE = "3dm-cv7-gnss-ins"

#: Downloads are kept in `saved`; `fold` opens a part of the page.
HELP = """
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
    with tab() as opened:
        opened.size(1400)
        yield opened
        assert opened.complaints == []


def opened(page: browser.Page, fragment: str) -> None:
    visit(page, "live", f"#{fragment}")
    page.run(HELP)


def connected(page: browser.Page, served: Served, streams: str = STREAMS) -> None:
    opened(page, f"serve={served.server.address}&streams={streams}")
    page.run("press('Connect'); press('Connect')")  # the second one does nothing
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
        names = page.run("data('.mip-each > .mip-reading', 'field')")
        wanted = [part.split("@")[0] for part in STREAMS.split(",")]
        assert sorted(set(names)) == sorted([*wanted, "shared.reference_timestamp"])  # of each set
        values = page.run("texts('[data-field=\"sensor.scaled_accel\"] dd')")
        assert len(values) == 3 and math.isclose(float(values[2].removesuffix(" g")), -1, abs_tol=0.05)
        # The plots and the picture are not empty: they have pixels.
        painted = (
            "[...document.querySelectorAll('canvas:not([hidden])')].map((one) => one.getContext('2d')"
            ".getImageData(0, 0, one.width, one.height).data.some((byte) => byte))"
        )
        page.run(f"until(() => {painted}.filter(Boolean).length === 5)")  # four fields and the attitude
        page.run("press('Stop'); until(() => /device is idle/.test(document.querySelector('#tool').innerText), 5)")
        page.run(f"until(() => location.hash.startsWith('#device={DEVICE}&streams=sensor.scaled_accel@100,'))")
        page.run("press('Disconnect'); until(() => text('.mip-status') === 'Not connected.')")


@pytest.mark.parametrize(
    ("device", "attitude"), [(DEVICE, "filter_data.euler_angles"), ("3dm-gx5-35", "sensor.comp_euler_angles")]
)
def test_connecting_shows_inertial_data_attitude_and_position_at_once(
    device: str, attitude: str, page: browser.Page
) -> None:
    with served(device=device) as at:
        opened(page, f"serve={at.server.address}")
        page.run("press('Connect'); until(() => text('.mip-attitude + .mip-angles'))")
        fields = {"sensor.scaled_accel", "sensor.scaled_gyro", attitude}
        shown = "data('.mip-each > .mip-reading:has(canvas)', 'field')"
        page.run(f"until(() => {json.dumps(sorted(fields))}.every((one) => {shown}.includes(one)))")
        if device != DEVICE:
            return
        page.run("until(() => document.querySelector('[aria-label=Track]'))")
        latitude = page.run("text('[data-field=\"filter_data.llh_position\"] dd')")
        assert len(latitude.partition(".")[2]) == len("12345678 deg")
        units = page.run("[...document.querySelectorAll('canvas.mip-plot')].map((one) => one.ariaLabel)")
        assert "Plot of LLH position in m" in units and "Plot of LLH position in deg" not in units


def test_commands_from_their_page(page: browser.Page) -> None:
    """One that is acknowledged, one with a response, and one that the device rejects."""
    with served() as at:
        connected(page, at)
        page.run("fold('Commands')")
        for name, change, wanted in (
            ("3dm.pps_source_control", "", "PPS source control acknowledged."),
            ("base.get_device_info", "", "model_name"),
            ("base.continuous_built_in_test", "", "filter_process_fault = 0"),  # as this device names it
            ("3dm.pps_source_control", "99", "PPS source control refused: invalid parameter."),
        ):
            page.run(f"enter('#mip-field', {name!r})")
            if change:
                page.run(
                    "(() => { const choice = [...document.querySelectorAll('.mip-form select')].at(-1);"
                    " choice.value = 'other'; choice.dispatchEvent(new Event('input'));"
                    " const number = choice.parentElement.querySelector('input');"
                    f" number.value = {change!r}; number.dispatchEvent(new Event('input')); }})()"
                )
            page.run("press('Send')")
            page.run(f"until(() => text('.mip-outcome').includes({wanted!r}), 5)")


def test_a_rejected_command_names_the_field_to_blame(page: browser.Page) -> None:
    sent = PacketBuilder(0x0C).add(0x0F, bytes([1, 0x82, 2, 0x10, 0, 1, 0x01, 0, 1])).build()
    with served(device="3dm-cv7-ahrs") as at:
        opened(page, f"serve={at.server.address}&packet={bytes(sent).hex()}")
        page.run("press('Connect'); until(() => /^Connected to/.test(text('.mip-status')))")
        page.run("fold('Commands'); press('Send')")
        page.run("until(() => text('.mip-outcome').includes('3DM-CV7-AHRS does not send filter_data.llh_pos'), 5)")


def test_a_recording_has_what_the_device_sent(page: browser.Page) -> None:
    with served() as at:
        connected(page, at, "sensor.scaled_accel@100")
        page.run("press('Record'); press('Start')")
        page.run("until(() => Number.parseInt(text('.mip-totals [role=status]')) > 3000)")
        leaves = "dispatchEvent(new Event('beforeunload', { cancelable: true }))"
        assert not page.run(leaves)
        page.run("press('Stop and save')")
        assert page.run(leaves)
        name, data = page.run("saved[0].arrayBuffer().then((bytes) => [saved[0].called, [...new Uint8Array(bytes)]])")
        assert name.startswith(f"{DEVICE}-") and name.endswith(".bin")
        parser = Parser()
        packets = parser.feed(bytes(data)) + parser.flush()
        assert parser.skipped == 0 and sum(p.set == sensor.ScaledAccel.SET for p in packets) > 100
        page.run("press('Record'); until(() => Number.parseInt(text('.mip-totals [role=status]')) < 3000)")
        page.run("mip.live(document.querySelector('#tool'), new mip.Protocol(mip.model))")
        page.run("until(() => saved[1]?.size)")


def key(page: browser.Page, name: str, code: int, text: str = "") -> None:
    page.call("Input.dispatchKeyEvent", type="keyDown", key=name, code=name, windowsVirtualKeyCode=code, text=text)
    page.call("Input.dispatchKeyEvent", type="keyUp", key=name, code=name, windowsVirtualKeyCode=code)


#: The element that has the focus: its name, and whether the focus is visible.
FOCUS = """(() => {
    const it = document.activeElement;
    const name = it.ariaLabel || it.labels?.[0]?.textContent || it.textContent;
    const { outlineStyle, boxShadow } = getComputedStyle(it);
    return [name.trim().slice(0, 40), outlineStyle !== "none" || boxShadow !== "none", it.offsetParent !== null];
})()"""


def tabbed(page: browser.Page, until: str) -> list[str]:
    """The names of the elements to which Tab leads, up to `until`; each is visible, and so is its focus."""
    names: list[str] = []
    while until not in names:
        key(page, "Tab", 9)
        name, outlined, visible = page.run(FOCUS)
        assert name and outlined and visible and name not in names[-1:], (names, name)
        names.append(name)
        assert len(names) < 60, names
    return names


def test_by_keyboard_alone(page: browser.Page) -> None:
    """Connect, stream, stop and disconnect; the order of Tab is that of the page."""
    with served() as at:
        opened(page, f"serve={at.server.address}&streams=sensor.scaled_accel@100")
        page.call("Emulation.setFocusEmulationEnabled", enabled=True)
        page.run("document.querySelector('#tool').tabIndex = -1; document.querySelector('#tool').focus()")
        assert tabbed(page, "Connect")[-2:] == ["or the address that mip serve prints", "Connect"]
        key(page, "Enter", 13, "\r")
        page.run("until(() => /^Connected to/.test(text('.mip-status')))")
        page.run("until(() => !document.querySelector('.mip-totals button').disabled)")
        page.run("document.querySelector('.mip-status').tabIndex = -1; document.querySelector('.mip-status').focus()")
        assert tabbed(page, "Record")[-3:] == ["Start", "Stop", "Record"]
        page.run("document.querySelector('.mip-status').focus()")
        assert tabbed(page, "Start")[0] == "Disconnect"
        key(page, "Enter", 13, "\r")
        page.run("until(() => document.querySelectorAll('.mip-each > .mip-reading:not(.mip-last)').length === 1)")
        assert tabbed(page, "plot")[:2] == ["Stop", "Record"]
        page.run("document.querySelector('.mip-status').focus()")
        tabbed(page, "Stop")
        key(page, " ", 32, " ")
        page.run("until(() => /device is idle/.test(document.querySelector('#tool').innerText), 5)")
        page.run("document.querySelector('.mip-status').focus()")
        names = tabbed(page, "Commands")
        assert [name for name in names if name in ("Streams", "plot")] == ["Streams", "plot"], names
        page.run("document.querySelector('.mip-status').focus()")
        tabbed(page, "Disconnect")
        key(page, "Enter", 13, "\r")
        page.run("until(() => text('.mip-status') === 'Not connected.')")


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
        page.run("until(() => document.querySelectorAll('.mip-each > .mip-reading:not(.mip-last)').length === 5)")
    page.run("until(() => /mip serve has ended/.test(text('.mip-status')))")
    page.run("press('Connect again'); until(() => /^Not connected: .*cannot be reached/.test(text('.mip-status')))")
    assert all("WebSocket" in one for one in page.complaints)
    page.complaints.clear()


def test_a_device_that_loses_answers(page: browser.Page) -> None:
    with served(faults="lose_answer=1") as at:
        opened(page, f"device=3dm-gq7&serve={at.server.address}")
        page.run("press('Connect')")
        page.run("until(() => /was not identified: .*no answer/.test(text('.mip-status')))")
        page.run("fold('Commands'); press('Send'); until(() => /no answer/.test(text('.mip-outcome')))")
        page.run("until(() => !location.hash.includes('device='))")  # it need not be the linked one


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


#: A serial port of the browser behind which a WebSocket is; it has the device at one baud rate only. Another device of
#: the same kind is always there.
SERIAL = """
(() => {
    class Port {
        async open({ baudRate }) {
            if (this.isOpen) throw new DOMException("The port is already open.", "InvalidStateError");
            if (this !== present) throw new DOMException("Failed to open serial port.", "NetworkError");
            this.isOpen = true;
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
                socket.onclose = () => {
                    this.readable = this.writable = null;
                    to.error(new DOMException("The device has been lost.", "NetworkError"));
                };
            } });
            this.writable = new WritableStream({ write: (bytes) => socket?.send(bytes) });
        }
        async close() {
            if (!this.isOpen) throw new DOMException("The port is already closed.", "InvalidStateError");
            this.isOpen = false;
            if (!this.socket) return;
            this.socket.onclose = null;
            this.socket.close();
        }
        getInfo() {
            return { usbVendorId: 0x199b };
        }
    }
    const other = new Port();
    let present = new Port();
    window.plug = (on) => { present = on ? new Port() : undefined; };
    window.tried = [];
    const serial = new EventTarget();
    serial.requestPort = async () => present;
    serial.getPorts = async () => [other, present].filter(Boolean);
    Object.defineProperty(navigator, "serial", { value: serial, configurable: true });
})();
0
"""


def test_a_serial_port_whose_baud_rate_is_searched(page: browser.Page) -> None:
    with served() as at:
        script = SERIAL.replace("RIGHT", "460800").replace("ADDRESS", json.dumps(at.server.address))
        page.call("Page.addScriptToEvaluateOnNewDocument", source=script)
        opened(page, f"streams={STREAMS}")
        page.run("press('Open a serial port …'); until(() => text('.mip-status') === 'Connected to 3DM-CV7-GNSS/INS.')")
        assert page.run("tried") == [115200, 3000000, 921600, 460800]
        started(page)
        said = "until(() => text('.mip-status') === {!r})".format
        streams = "until(() => document.querySelectorAll('.mip-each > .mip-reading:not(.mip-last)').length === 5)"
        at.unplug()
        page.run(said("The connection is lost: The device has been lost. Connect again"))
        page.run("fold('Commands')")
        buttons = "[...document.querySelectorAll('.mip-totals button, .mip-forms button.mip-main')]"
        assert page.run(f"{buttons}.map((one) => [one.textContent, one.disabled])") == [
            [name, True] for name in ("Start", "Stop", "Record", "Send")
        ]
        page.run("press('Connect again')")
        page.run(said("Connected to 3DM-CV7-GNSS/INS."))
        page.run(streams)
        assert not page.run(f"{buttons}.at(-1).disabled")
        page.run("plug(false)")  # it will be another port
        at.unplug()
        page.run(said("The connection is lost: The device has been lost. Connect again"))
        page.run("navigator.serial.dispatchEvent(new Event('disconnect')); press('Connect again')")
        page.run(said("Not connected: Failed to open serial port. Try again"))
        page.run("plug(true); press('Try again')")
        page.run(said("Connected to 3DM-CV7-GNSS/INS."))
        page.run(streams)


def test_without_web_serial_it_is_said(page: browser.Page) -> None:
    page.call(
        "Page.addScriptToEvaluateOnNewDocument",
        source="Object.defineProperty(navigator, 'serial', { value: undefined, configurable: true })",
    )
    opened(page, "")
    assert "This browser has no Web Serial" in page.run("text('.mip-connect')")
    assert page.run("document.querySelector('.mip-connect button').disabled")
    page.call(
        "Page.addScriptToEvaluateOnNewDocument",
        source="Object.defineProperty(window, 'isSecureContext', { value: false })",
    )
    opened(page, "")
    assert "open serial ports only for pages from https://" in page.run("text('.mip-connect')")

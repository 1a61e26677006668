"""Scenario files: scripted events, UDP; mistakes with their places."""

from __future__ import annotations

import re
import socket
from pathlib import Path
from typing import Any

import pytest
from mip_protocol import Parser, gnss_data, mip_3dm, sensor, types
from mip_simulator import Faults, Injected, ScriptedEvent, VirtualDevice
from mip_simulator.endpoints.endpoint import pty_at, tcp_at, udp_at
from mip_simulator.motion.trajectory import COLUMNS
from mip_simulator.scenario import read_scenario
from mip_simulator.script import KINDS
from mip_tools.errors import Failure
from program import DEVICE, run, until
from support import ROOT
from test_serve import ACKNOWLEDGE, PING, Client, serving, stream

EVERYTHING = """\
events:
  - {at: 1.5, event: faults, for: 2, faults: "lose=0.1,noise=0.1:16"}
  - {at: 10, event: gnss_outage, for: 30}
  - {at: 50, event: magnetic_disturbance, field: [0.2, 0, -0.1]}
  - {at: 60, event: unplug, for: 2, every: 100}
  - {at: 70, event: disconnect, for: 0}
  - {at: 80, event: restart}
"""


def written(folder: Path, text: str) -> Path:
    path = folder / "s.yaml"
    path.write_text(text)
    return path


def test_what_a_file_says(tmp_path: Path) -> None:
    events = read_scenario(written(tmp_path, EVERYTHING))
    assert events[0].faults == "lose=0.1,noise=0.1:16" and events[2].field == (0.2, 0, -0.1)
    assert events[3] == ScriptedEvent("unplug", 60, 2, 100)
    assert {e.event for e in events} == set(KINDS)


#: A file, and its first mistake.
MISTAKES = [
    ("device: [{device: 3dm-gx5-15}]", "1:1: a scenario has no 'device'"),
    ("[]", "1:1: this is not a scenario; it needs 'events'"),
    ("events: []", "1:9: 'events' must be a list with at least one item"),
    ("events: [{at: 1}]", "1:10: 'event' is missing; an event has, for example, {at: 10, event: unplug, for: 5}"),
    ("events: [{event: restart}]", "1:10: 'at' is missing"),
    ("events: [{at: 1, event: outage}]", "1:25: there is no event 'outage'; did you mean 'gnss_outage'?"),
    ("events: [{at: soon, event: restart}]", "1:15: 'at' needs a number of seconds, 0 or more"),
    ("events: [{at: -1, event: restart}]", "1:15: 'at' needs a number of seconds, 0 or more"),
    ("events: [{at: 1, event: restart, for: 1}]", "1:39: a restart has no 'for'; remove it"),
    ("events: [{at: 1, event: restart, every: 0}]", "1:41: 'every' needs a number of seconds, more than 0"),
    ("events: [{at: 1, event: unplug, for: 2, every: 1}]", "1:48: an event every 1 s must end before the next"),
    ("events: [{at: 1, event: faults}]", "1:10: 'faults' is missing; faults needs it"),
    ("events: [{at: 1, event: faults, faults: loose=1}]", "1:41: fault 'loose' is unknown; do you mean 'lose'?"),
    ("events: [{at: 1, event: unplug, faults: lose=1}]", "1:41: 'faults' is only for faults; remove it"),
    ("events: [{at: 1, event: magnetic_disturbance}]", "1:10: 'field' is missing; magnetic_disturbance needs it"),
    (
        "events: [{at: 1, event: magnetic_disturbance, field: [1, 2]}]",
        "1:54: 'field' needs three numbers in gauss",
    ),
    (
        "events: [{at: 1, event: magnetic_disturbance, field: [1, 200, 3]}]",
        "1:54: 'field' needs three numbers in gauss, [x, y, z], of less than 100",
    ),
    ("events: [{at: 1, at: 2, event: restart}]", "1:18: 'at' is already on line 1; remove one"),
    ("events: [", "1:10: not YAML: "),
]


@pytest.mark.parametrize("text, message", MISTAKES)
def test_mistakes(tmp_path: Path, text: str, message: str) -> None:
    path = written(tmp_path, text)
    with pytest.raises(Failure) as error:
        read_scenario(path)
    assert str(error.value).splitlines()[0].startswith(f"{path}:{message}")


def test_all_mistakes_at_once(tmp_path: Path) -> None:
    with pytest.raises(Failure) as error:
        read_scenario(written(tmp_path, "events: [{at: x, event: unplug}, {event: fly}]"))
    assert len(str(error.value).splitlines()) == 2


def test_the_page(tmp_path: Path) -> None:
    """Its scenarios and its trajectory are what the program reads, and it names every event and every column."""
    page = (ROOT / "docs/simulate-reference.md").read_text("utf-8")
    motion, scenarios = (
        page.partition(f"\n## {title}\n")[2].partition("\n## ")[0] for title in ("Motion", "Scenarios")
    )
    for text in re.findall(r"```yaml\n(.*?)```", scenarios, re.S):
        (tmp_path / "scenario.yaml").write_text(text)
        assert read_scenario(tmp_path / "scenario.yaml")
    assert all(f"| `{kind}` |" in scenarios for kind in KINDS)
    for name, units in COLUMNS.items():
        assert all(f"`{word}`" in motion for word in (name, *units))


# --------------------------------------------------------------------------- events


def fields(device: VirtualDevice, link: Any, kind: Any, seconds: float) -> list[Any]:
    device.advance(seconds)
    return [f for packet in Parser().feed(link.read()) for f in kind.find_all(packet)]


def sending(kind: Any, *events: ScriptedEvent, decimation: int = 1) -> tuple[VirtualDevice, Any]:
    device = VirtualDevice(DEVICE, noise=0, events=events)
    link = device.connect()
    number = 0x91 if kind is gnss_data.FixInfo else kind.SETS[0]
    entry = types.DescriptorRate(kind.DESCRIPTOR, decimation)
    for command in (mip_3dm.MessageFormat.write(number, (entry,)), mip_3dm.DataStreamControl.write(number, True)):
        link.write(bytes(command.packet()))
    return device, link


def test_an_outage_of_gnss() -> None:
    """Two that overlap end with the last one."""
    events = (ScriptedEvent("gnss_outage", 10, 5), ScriptedEvent("gnss_outage", 12, 6))
    device, link = sending(gnss_data.FixInfo, *events)
    fix, none = types.GnssFixType.FIX_3D, types.GnssFixType.FIX_NONE
    for seconds, wanted in ((9.9, {fix}), (0.6, None), (7, {none}), (1, None), (5, {fix})):
        seen = {f.fix_type for f in fields(device, link, gnss_data.FixInfo, seconds)}
        assert wanted in (None, seen)


def test_a_magnetic_disturbance() -> None:
    events = (ScriptedEvent("magnetic_disturbance", 10, 5, field=(0.5, 0, 0)),)
    device, link = sending(sensor.ScaledMag, *events, decimation=100)
    before, during, after = (fields(device, link, sensor.ScaledMag, seconds)[-1].scaled_mag for seconds in (9.9, 3, 5))
    assert during.x - before.x == pytest.approx(0.5, abs=1e-5) and after.x == pytest.approx(before.x, abs=1e-5)
    assert (during.y, during.z) == pytest.approx((before.y, before.z), abs=1e-5)


def test_faults_for_a_while() -> None:
    device, link = sending(sensor.ScaledMag, ScriptedEvent("faults", 10, 5, faults="lose_packet=1"), decimation=100)
    counts = [len(fields(device, link, sensor.ScaledMag, 4.99)) for _ in range(4)]
    assert counts[2] == 0 and min(counts[0], counts[1], counts[3]) > 40


def test_the_log_says_when_events_begin_and_end() -> None:
    log: list[Injected] = []
    events = (ScriptedEvent("gnss_outage", 1, 2), ScriptedEvent("restart", 2))
    VirtualDevice(DEVICE, events=events, faults=Faults(log=log.append)).advance(5)
    assert [(x.now, x.kind, x.detail) for x in log] == [
        (1 * 10**9, "gnss_outage", "begins"),
        (2 * 10**9, "restart", "begins"),
        (3 * 10**9, "gnss_outage", "ends"),
    ]


def test_restarts_that_recur() -> None:
    device, _ = sending(sensor.ScaledMag, ScriptedEvent("restart", 2, every=3), decimation=100)
    device.advance(12)
    assert device.booted == 11 * 10**9


def test_unplugging_ends_links_and_takes_power() -> None:
    events = (ScriptedEvent("disconnect", 1, 1), ScriptedEvent("unplug", 3, 1))
    device, link = sending(sensor.ScaledMag, *events, decimation=100)
    device.advance(1.5)
    assert link.closed and not device.plugged and not device.busy
    with pytest.raises(ConnectionError, match="the device is unplugged"):
        device.connect()
    device.advance(1)
    again = device.connect()
    assert len(fields(device, again, sensor.ScaledMag, 0.4)) > 3  # it has gone on
    device.advance(2)
    assert again.closed and device.plugged and device.booted == 4 * 10**9
    last = device.connect()
    assert not fields(device, last, sensor.ScaledMag, 1)  # it has lost its settings
    last.write(PING)
    assert last.read() == ACKNOWLEDGE


# --------------------------------------------------------------------------- serving


def test_the_ports_of_an_unplugged_device_are_gone(tmp_path: Path) -> None:
    """They come back at the same places."""
    path = tmp_path / "mip"
    device = VirtualDevice(DEVICE, events=(ScriptedEvent("unplug", 0.5, 0.5),))
    with serving(device, pty_at(str(path)), tcp_at("0"), udp_at("0")) as server:
        places = list(server.places)
        with Client(places[0]) as terminal, Client(places[1]) as client:
            terminal.send(stream())
            assert client.at_end() and terminal.at_end()
        until(lambda: len(server.places) == 6)
        assert server.places[3:] == places
        for place in places[:2]:
            with Client(place) as again:
                until(lambda again=again: (again.send(PING), again.read(), ACKNOWLEDGE in again.packets)[2])


def test_time_passes_while_unplugged_at_any_speed(tmp_path: Path) -> None:
    """Nobody can read then, so it must not wait for readers."""
    path = tmp_path / "mip"
    device = VirtualDevice(DEVICE, events=(ScriptedEvent("disconnect", 5, 0.1),))
    with serving(device, pty_at(str(path)), speed=0) as server:
        with Client(str(path)) as client:
            client.send(stream())
            assert client.at_end()
        until(lambda: len(server.places) == 2)


class UdpClient:
    def __init__(self, place: str) -> None:
        host, _, number = place.rpartition(":")
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.connect((host, int(number)))
        self.socket.settimeout(0.2)

    def receive(self) -> bytes:
        try:
            return self.socket.recv(65536)
        except TimeoutError:
            return b""


def test_udp() -> None:
    """Answers and data go to the host that has sent last; each datagram has whole packets."""
    device = VirtualDevice(DEVICE)
    with serving(device, udp_at("0"), speed=20) as server:
        first, second = UdpClient(server.places[0]), UdpClient(server.places[0])
        for client in (first, second):
            client.socket.send(PING)
            assert until(client.receive) == ACKNOWLEDGE
        second.socket.send(stream(1000))
        datagrams = [until(second.receive) for _ in range(200)]
        assert max(map(len, datagrams)) > 100 and not first.receive()
        for datagram in datagrams:
            parser = Parser()
            assert parser.feed(datagram) and not parser.pending and not parser.skipped
            assert len(datagram) <= 1400
        second.socket.close()  # a port that is no longer in use
        until(lambda: (first.socket.send(PING), ACKNOWLEDGE in first.receive())[1])
        first.socket.close()


def test_a_udp_port_in_use(capsys: pytest.CaptureFixture[str]) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("127.0.0.1", 0))
        number = taken.getsockname()[1]
        code, _, text = run(capsys, "simulate", DEVICE, "--udp", str(number))
    assert code == 1 and f"UDP port {number} is in use; end the program that uses it, or choose another: --udp" in text

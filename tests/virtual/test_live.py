"""The clients at real ports of `mip simulate`, in real time: TCP, and a pseudo-terminal."""

from __future__ import annotations

import json
import socket
from pathlib import Path
from threading import Thread
from typing import Any

import pytest
from mipgen import model as m
from mipgen.lower import codec
from support import driver, expected_decode, heavy, model, offering, simulated
from virtual.commands import Trial, commands
from virtual.ledger import OUTCOMES
from virtual.scenario import few, formats, write

DEVICE = "3dm-gx5-45"
FAULTS = "change=0.01,lose=0.01,noise=0.05,nmea=0.05,false_header=0.02,double_packet=0.02,delay=0.05:0.02"


def device() -> m.Device:
    return next(d for d in model("real").devices if d.id == DEVICE)


def steps() -> list[dict[str, Any]]:
    """Some commands while all data are streamed; then silence, so that nothing is still on the way."""
    known = {s.field.full_name: s for s in commands(device())}
    plan: list[Trial] = [*formats(device(), 10), *few(device(), 1)[::5], *formats(device(), 10)]
    found: list[dict[str, Any]] = []
    for trial in plan:
        found += [{"step": "send", "set": trial.command.set, "fields": [trial.entry]}, {"step": "answers"}]
    found.append({"step": "listen", "milliseconds": 800})
    idle = write(known["base.set_idle"])
    for _ in range(3):  # a fault may strike
        found += [{"step": "send", "set": idle.command.set, "fields": [idle.entry]}, {"step": "answers"}]
    return [*found, {"step": "listen", "milliseconds": 200}, {"step": "end"}]


def intact(log: Path) -> list[bytes]:
    """The packets that arrive whole, by the log of the device."""
    found: list[bytes] = []
    for line in log.read_text("utf-8").splitlines():
        entry = json.loads(line)
        packet = bytes.fromhex(entry.get("packet", ""))
        if entry["kind"] == "sent" or entry["kind"] == "double_packet":
            found.append(packet)
        elif entry.get("damaged"):
            assert found[-1] == packet
            found.pop()
    return found


TERMINALS = pytest.param("pty", marks=heavy("pseudo-terminals"))


@pytest.mark.parametrize("port", ["tcp", TERMINALS])
@pytest.mark.parametrize("language", offering("live"))
def test_real_ports(language: str, port: str, tmp_path: Path) -> None:
    log = tmp_path / "faults.jsonl"
    place = ["--tcp", "localhost:0"] if port == "tcp" else ["--pty", str(tmp_path / "port")]
    run = driver(language, "real")
    with simulated(
        *place, "--fault", FAULTS, "--fault-log", str(log), "--log-packets", "--seed", "4", device=DEVICE
    ) as found:
        at = found if port == "tcp" else str(tmp_path / "port")
        answer = run.ask([{"op": "live", "port": at, "steps": steps()}])[0]
    events = answer["events"]
    sent = sum(len(e["commands"]) for e in events if e["event"] == "sent")
    ends = [e for e in events if e["event"] in OUTCOMES]
    assert sorted(e["command"] for e in ends) == list(range(sent))
    assert sum(e["event"] == "acknowledged" for e in ends) > sent / 2
    assert events[-1]["event"] == "end" and events[-1]["waiting"] == []
    of = model("real")
    wanted = [{"event": "received", **expected_decode(of, p)} for p in intact(log) if p[2] >= 0x80]
    assert len(wanted) > 20
    assert [e for e in events if e["event"] == "received" and e["set"] >= 0x80] == wanted


@pytest.mark.parametrize("language", offering("live"))
def test_a_device_that_goes_away(language: str) -> None:
    """The client says that the port is closed, and that the command was not answered."""
    ping = next(s for s in commands(device()) if s.field.name == "ping")
    entry = {"descriptor": ping.field.descriptor, "name": ping.field.full_name, "values": {}}
    send = {"step": "send", "set": ping.field.set, "fields": [entry]}
    plan = [send, {"step": "answers"}, {"step": "listen", "milliseconds": 400}, send, {"step": "answers"}]
    reply = codec.build(model("real"), ping.field.set, [(0xF1, bytes((ping.field.descriptor, 0)))])
    with socket.create_server(("localhost", 0)) as server:
        leaver = Thread(target=answer_and_leave, args=(server, reply))
        leaver.start()
        port = f"localhost:{server.getsockname()[1]}"
        answer = driver(language, "real").ask([{"op": "live", "port": port, "steps": plan}])[0]
        leaver.join()
    assert [e["event"] for e in answer["events"]] == ["sent", "acknowledged", "closed", "sent", "timed_out"]


def answer_and_leave(server: socket.socket, reply: bytes) -> None:
    connection, _ = server.accept()
    with connection:
        connection.recv(100)
        connection.sendall(reply)

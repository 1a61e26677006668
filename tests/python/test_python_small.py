"""The package of a specification of two fields: it has only what such a specification needs."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from mipgen import cli
from support import ROOT, heavy, mypy

RUNTIME = ROOT / "runtime/python/mip_protocol"

#: Talks to a device that answers each command; then the same with asyncio.
CLIENT = """
import asyncio
import importlib
import pkgutil
import queue

import own_protocol as mip
from own_protocol import aio, measurements, open_port, registry, tools


class Lamp:
    def __init__(self) -> None:
        self.sent: queue.Queue[bytes] = queue.Queue()
        self.mode, self.rate = tools.LightMode.OFF, 1

    def read(self, size: int, /) -> bytes:
        try:
            return self.sent.get(timeout=0.01)
        except queue.Empty:
            return b""

    def write(self, data: bytes, /) -> int:
        (command,) = registry.decode_packet(mip.Packet(data))
        assert isinstance(command, (tools.Light, tools.Ping))
        answer = mip.PacketBuilder(command.SET).add(0xF1, mip.Acknowledge(command.DESCRIPTOR, mip.AckCode.OK).encode())
        if isinstance(command, tools.Ping):
            pass
        elif command.function == mip.FunctionSelector.READ:
            answer.add(0x82, tools.LightResponse(self.mode, self.rate).encode())
        elif command.mode is not None and command.rate is not None:
            self.mode, self.rate = command.mode, command.rate
        self.sent.put(bytes(answer.build()) + bytes(measurements.Temperature(21.5).packet()))
        return len(data)

    def close(self) -> None:
        pass


for module in pkgutil.walk_packages(mip.__path__, f"{mip.__name__}."):
    importlib.import_module(module.name)
for name in (*mip.__all__, *dir(mip)):
    getattr(mip, name)

with mip.Device(Lamp()) as device:
    device.request(tools.Light.write(tools.LightMode.BLINKING, 3))
    device.request(tools.Ping())
    print(device.request(tools.Light.read()))
    for _, value in device.fields(measurements.Temperature):
        print(value)
        break


async def talk() -> None:
    async with aio.Device(Lamp()) as device:
        await device.request(tools.Light.write(tools.LightMode.ON, 2))
        print(await device.request(tools.Light.read()))


asyncio.run(talk())
try:
    open_port("127.0.0.1:1", None)
except mip.PortError as error:
    print(error.kind)
"""


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The Python package of what `mipgen new` writes, without functions that not every specification has."""
    folder = tmp_path_factory.mktemp("own")
    assert cli.main(["new", str(folder / "spec")]) == 0
    protocol = folder / "spec/protocol.yaml"
    text, count = re.subn("package: my_device .*", "package: own", protocol.read_text("utf-8"))
    assert count == 1
    text, count = re.subn(r"  (save|load|default): .*\n", "", text)
    assert count == 3
    protocol.write_text(text, "utf-8")
    tools = folder / "spec/sets/tools.yaml"
    ping = "\n  - {command: 0x01, name: ping, description: Does nothing.}\n"
    tools.write_text(tools.read_text("utf-8").replace("WRSLD", "WR").rstrip() + ping, "utf-8")
    assert cli.main(["generate", "--spec", str(folder / "spec"), "--out", str(folder), "--target", "python"]) == 0
    return folder / "python"


def test_it_is_small(own: Path) -> None:
    lines = sum(len(p.read_text("utf-8").splitlines()) for p in own.rglob("*.py"))
    assert 3000 < lines < 6200
    texts = "".join(p.read_text("utf-8") for p in own.rglob("*.py"))
    assert not re.search(r"argparse|numpy|pyarrow|simulator", texts)


def test_what_needs_a_fact_is_omitted(own: Path) -> None:
    there = {p.stem for p in (own / "own_protocol").iterdir()}
    left_out = {p.stem for p in RUNTIME.iterdir() if p.stem != "__pycache__"} - there
    assert left_out == {"baud", "rejected", "sampling", "streaming"}
    for name in ("device.py", "aio.py", "conversation.py", "__init__.py"):
        text = (own / "own_protocol" / name).read_text("utf-8")
        assert not re.search(r"# needs:|def (stream|change_baud|_follow)\b|detect_baud|\bsamples\b|Dialog", text), name
    readme = (own / "README.md").read_text("utf-8")
    assert not re.search(r"`stream|change_baud|detect_baud|`samples|GpsTimestamp", readme)


@heavy("mypy on Python packages and their users")
def test_its_types_are_right(own: Path, tmp_path: Path) -> None:
    program = tmp_path / "client.py"
    program.write_text(CLIENT, "utf-8")
    checked = mypy(own, "own_protocol", program)
    assert checked.returncode == 0, checked.stdout


def test_it_imports_and_talks(own: Path, tmp_path: Path) -> None:
    program = tmp_path / "client.py"
    program.write_text(CLIENT, "utf-8")
    done = subprocess.run([sys.executable, program], capture_output=True, text=True, env={"PYTHONPATH": str(own)})
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == [
        "tools.light_response: mode = blinking, rate = 3 Hz",
        "measurements.temperature: temperature = 21.5 degC",
        "tools.light_response: mode = on, rate = 2 Hz",
        "port",
    ]

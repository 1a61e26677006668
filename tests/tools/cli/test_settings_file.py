"""`mip config`: whatever settings a virtual device has, another one has them too after a file has carried them over."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import pytest
from mip_protocol import devices
from mip_tools.configuration import parsed
from mip_tools.errors import Failure
from mip_tools.simulator import VirtualDevice
from settings_files import LEFT_OUT, pulled, pushed, settable, told
from support import heavy, model, need, uses
from workbench import workbench

#: The workbench is built with npm.
with_node = uses("npm")

#: Settings that a device has in a form of its own: a rotation that was written as a matrix is read as a quaternion.
ROUNDED = ("transform", "rotation")


def kept(virtual: VirtualDevice) -> dict[Any, Any]:
    return {place: value for place, value in virtual.settings.items() if place[0] not in LEFT_OUT}


#: The devices that `make test` samples: of each generation, with few settings and with many.
SAMPLE = ("3dm-cv7-gnss-ins", "3dm-gx5-45", "3dm-gq7", "3dm-gx3-35", "3dm-mv5-ar")
#: A device, and which third of the values it has; one of the sample has all.
CASES = [*((SAMPLE[0], only) for only in range(3)), *((device_id, i % 3) for i, device_id in enumerate(SAMPLE[1:]))]
ALL = [(device_id, only) for device_id in sorted(devices.DEVICES) for only in range(3)]


@pytest.mark.parametrize(
    ("device_id", "only"), [*CASES, *(pytest.param(*x, marks=heavy("all models")) for x in ALL if x not in CASES)]
)
def test_all_settings_of_a_device(tmp_path: Path, device_id: str, only: int) -> None:
    found = model("real").device(device_id)
    assert found is not None
    first, second = VirtualDevice(device_id), VirtualDevice(device_id)
    names = told(found, first, only)
    assert names or only or not settable(found)
    path = tmp_path / "settings.yaml"
    path.write_text(pulled(first))
    done = pushed(second, path)
    assert not done.refused and not done.read_differently
    assert pulled(second) == path.read_text()
    for place, value in kept(first).items():
        if not any(word in place[0] for word in ROUNDED):
            assert second.settings.current(value) == value, place


def test_what_acts_only_once_is_no_setting() -> None:
    virtual = VirtualDevice("3dm-gx5-25")
    assert virtual.knows("filter.tare_orientation") and "tare_orientation" not in pulled(virtual)


# --------------------------------------------------------------------------- the same files in the browser


def in_browser(requests: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The answers of the workbench."""
    command = [need("node"), Path(__file__).parent / "settings_files.mjs", workbench("real")]
    asked = "".join(f"{json.dumps(x)}\n" for x in requests)
    done = subprocess.run(command, input=asked, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines()]


@with_node
@pytest.mark.parametrize("ids", [SAMPLE[:2], pytest.param(sorted(devices.DEVICES), marks=heavy("all models"))])
def test_the_browser_reads_and_writes_the_same_files(tmp_path: Path, ids: Iterable[str]) -> None:
    """The same commands in the same order, from and to a file, with values of each setting."""
    path, requests, held = tmp_path / "settings.yaml", [], []
    for device_id in ids:
        virtual, found = VirtualDevice(device_id), model("real").device(device_id)
        assert found is not None
        told(found, virtual, 0)
        path.write_text(pulled(virtual))
        commands = [bytes(c.packet()).hex() for c in parsed.parsed_settings(path).commands.values()]
        about = {"model": device_id, "firmware": "1.0.00", "date": "2026-01-31"}
        requests += [
            {"device": device_id, "text": path.read_text()},
            {"device": device_id, "packets": commands, **about},
        ]
        held.append((device_id, commands))
    answers = in_browser(requests)
    assert sum(len(commands) for _, commands in held) > 100
    for (device_id, commands), read, written in zip(held, answers[::2], answers[1::2], strict=True):
        assert read == {"model": device_id, "packets": commands}, device_id
        path.write_text(written["text"])
        assert [bytes(c.packet()).hex() for c in parsed.parsed_settings(path).commands.values()] == commands, device_id
    assert (
        in_browser([{"device": device_id, "text": x["text"]} for (device_id, _), x in zip(held, answers[1::2])])
        == answers[::2]
    )


#: Parts of files with mistakes.
WRONG = (
    "settings: {3dm: {pps_source_control: {source: receiver_9}}}",
    "settings: {3dm: {pps_source_control: {sauce: gpio}}}",
    "settings: {3dm: {pps_source_control: {source}}}",
    "settings: {3dm: {pps_source: {source: gpio}}}",
    "settings: {3dn: {}}",
    "settings: {3dm: {pps_source_control: {}}}",
    "settings:\n  3dm:\n    pps_source_control: {source: gpio, source: gpio}",
    "settings: {filter: {antenna_offset: {offset: {x: 1, y: 2}}}}",
    "settings: {filter: {antenna_offset: {offset: {x: 100, y: 2, z: 3}}}}",
    "settings: {filter: {antenna_offset: {offset: {x: a, y: 2, z: 3}}}}",
    "settings: {3dm: {message_format: {sensor: {descriptors: [{descriptor: scaled_acel, decimation: 1}]}}}}",
    "settings: {3dm: {message_format: {sensor: {descriptors: [{descriptor: scaled_accel}]}}}}",
    "settings: {3dm: {message_format: {sensor: {descriptors: scaled_accel}}}}",
    "settings: {3dm: {message_format: {senser: {descriptors: []}}}}",
    "settings: {3dm: {gpio_config: {1: {feature: gpio, behavior: inptu, pin_mode: [pullup]}}}}",
    "settings: {base: {comm_speed: {uart_1: {baud: fast}}}}",
    "settings: {filter: {initialization_config: 3}}",
)


@with_node
def test_the_browser_refuses_the_same(tmp_path: Path) -> None:
    """With the same messages, except for the name of the file."""
    texts = [f"model: 3dm-cv7-gnss-ins\n{part}\n" for part in WRONG]
    answers = in_browser([{"device": "3dm-cv7-gnss-ins", "text": text} for text in texts])
    path = tmp_path / "s.yaml"
    for text, answer in zip(texts, answers, strict=True):
        path.write_text(text)
        with pytest.raises(Failure) as raised:
            parsed.parsed_settings(path)
        assert answer["error"] == str(raised.value).replace(f"{path}:", ""), text

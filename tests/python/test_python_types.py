"""What type checkers report to users of the installed package: on its programs, and on arguments of constructors."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import sysconfig
import venv
from pathlib import Path

from packages import REAL
from support import ROOT, heavy, mypy

PAGES = ("README.md", "docs/columns.md", "docs/fleet.md", "docs/simulate.md", "generated/python/README.md")

#: Each line with a comment is wrong.
ARRAYS = """\
from pathlib import Path
from typing_extensions import assert_type
from mip_protocol import FunctionSelector, aio, gnss, mip_3dm, open_port, sensor, types

device = open_port(Path("/dev/ttyACM0"))
rates = {sensor.ScaledAccel: 100, sensor.ScaledGyro: 50}
device.stream(rates)
device.stream(device.stream({sensor.ScaledAccel: 100}))
device.stream({100: sensor.ScaledAccel})  # not a type of field
aio.open_port(Path("/dev/ttyACM0"))

rate = types.DescriptorRate(4, 10)
command = mip_3dm.MessageFormat.write(0x80, [rate])
assert_type(command.descriptors, tuple[types.DescriptorRate, ...] | None)
mip_3dm.MessageFormat.write(0x80, (rate, rate))
gnss.RtkDongleConfig(FunctionSelector.WRITE, 1, [0, 0, 0])
mip_3dm.MessageFormat.write(0x80, None)  # not optional
mip_3dm.MessageFormat.write(0x80, [4])  # not a rate
mip_3dm.MessageFormat.write(0x80, rate)  # not a sequence
"""

ANSWERS = """\
from typing_extensions import assert_type
import dataclasses
import mip_protocol
from mip_protocol import Arrival, Command, Data, Device, Response, aio, base, change, gnss_data, mip_3dm, sensor
from mip_protocol.base import GpsTimeUpdateTowResponse, GpsTimeUpdateWeekNumberResponse

def requests(device: Device, some: Command, kind: base.GpsTimeUpdate) -> None:
    assert_type(device.request(base.Ping()), None)
    assert_type(device.request(base.Ping()), int)  # nothing
    assert_type(device.request(base.GetDeviceInfo()), base.GetDeviceInfoResponse)
    assert_type(device.request(base.CommSpeed.read(1)), base.CommSpeedResponse)
    assert_type(device.request(base.CommSpeed.write(1, 115200)), None)
    assert_type(device.request(base.CommSpeed.save(1)), None)
    assert_type(device.request(kind), Response | None)
    assert_type(device.request(some), Response | None)
    assert_type(
        device.request(base.GpsTimeUpdate.read(base.GpsTimeField.TOW)),
        GpsTimeUpdateWeekNumberResponse | GpsTimeUpdateTowResponse,
    )
    assert_type(
        device.request_all(mip_3dm.GetBaseRate(0x80), base.Ping(), base.CommSpeed.read(1)),
        tuple[mip_3dm.GetBaseRateResponse, None, base.CommSpeedResponse],
    )
    commands: list[Command] = [base.Ping(), base.CommSpeed.read(1)]
    device.exchange(*commands)
    for arrival in device:
        assert_type(arrival, Arrival)
        assert_type(arrival.find(sensor.ScaledAccel), sensor.ScaledAccel | None)
    for stamp, accel in device.fields(sensor.ScaledAccel):
        assert_type(stamp.device, float)
        assert_type(accel, sensor.ScaledAccel)
    for _, field in device.fields(sensor.ScaledAccel, sensor.ScaledGyro, timeout=5):
        assert_type(field, sensor.ScaledAccel | sensor.ScaledGyro)
    changed = change(device.request(base.CommSpeed.read(1)), baud=460800)
    assert_type(device.request(changed), Response | None)
    change(changed, baud=460800)  # no response
    kinds: list[type[Data]] = [sensor.ScaledAccel, sensor.ScaledGyro]
    for _, any_field in device.fields(*kinds):
        assert_type(any_field, Data)

async def asynchronous(device: aio.Device) -> None:
    assert_type(await device.request(base.GetDeviceInfo()), base.GetDeviceInfoResponse)
    assert_type(
        await device.request_all(mip_3dm.GetBaseRate(0x80), base.Ping()), tuple[mip_3dm.GetBaseRateResponse, None]
    )
    async for arrival in device:
        assert_type(arrival, Arrival)
    async with aio.open_port("socket://localhost:5000") as other:
        assert_type(other, aio.Device)
    assert_type(await aio.open_port("socket://localhost:5000"), aio.Device)
    async for _, accel in other.fields(sensor.ScaledAccel):
        assert_type(accel, sensor.ScaledAccel)
    async for _, field in other.fields(sensor.ScaledAccel, sensor.ScaledGyro, gnss_data.SatelliteStatus):
        assert_type(field, sensor.ScaledAccel | sensor.ScaledGyro | gnss_data.SatelliteStatus)

def modules_and_elements() -> float:
    for fields in mip_protocol.Decoder().feed(memoryview(b"")):
        found: list[mip_protocol.Field | mip_protocol.RawField] = list(fields)
    mip_protocol.nothing  # no such module
    return dataclasses.replace(mip_protocol.sensor.ScaledAccel([1, 2, 3]), scaled_accel=(4, 5, 6)).scaled_accel.x
"""


def programs(folder: Path) -> list[Path]:
    """Every program that the pages show, each in a file, and the one that a page links to."""
    found = []
    for page in PAGES:
        shown = re.findall(r"```python\n(.*?)```", (ROOT / page).read_text("utf-8"), re.S)
        for number, code in enumerate(shown):
            found.append(folder / f"{page.removesuffix('.md').replace('/', '_')}_{number}.py")
            found[-1].write_text(code, "utf-8")
    assert len(found) > 12
    return [*found, ROOT / "docs/simulate/check_parser.py"]


def wrong_lines(source: str) -> set[int]:
    return {number for number, line in enumerate(source.splitlines(), 1) if "# " in line}


@heavy("mypy on Python packages and their users")
def test_mypy(tmp_path: Path) -> None:
    """It finds nothing in the programs of the documentation; it knows the types of answers, of modules and of elements;
    arrays are made of any sequence, and of nothing else."""
    wrong = {"arrays.py": ARRAYS, "answers.py": ANSWERS}
    for name, source in wrong.items():
        (tmp_path / name).write_text(source, "utf-8")
    files = [*programs(tmp_path), *(tmp_path / name for name in wrong)]
    done = mypy(REAL, *files)
    errors = re.findall(r"(\w+\.py):(\d+): error", done.stdout)
    lines = {(name, str(n)) for name, source in wrong.items() for n in wrong_lines(source)}
    assert set(errors) == lines, done.stdout


@heavy("pyright")
def test_pyright(tmp_path: Path) -> None:
    """For users who have installed the package, it finds nothing in the programs, and knows the same of arrays."""
    venv.create(tmp_path / "env", symlinks=True)
    python = tmp_path / "env/bin/python"
    (packages,) = (tmp_path / "env/lib").glob("python3*/site-packages")
    (packages / "installed.pth").write_text(f"{REAL}\n{ROOT / 'tools'}\n{sysconfig.get_path('purelib')}\n")
    (tmp_path / "arrays.py").write_text(ARRAYS, "utf-8")
    files = [*programs(tmp_path), tmp_path / "arrays.py"]
    settings = {"include": [str(f) for f in files], "typeCheckingMode": "standard", "pythonPlatform": "All"}
    (tmp_path / "pyrightconfig.json").write_text(json.dumps(settings))
    command = [sys.executable, "-m", "basedpyright", "--outputjson", "--project", tmp_path, "--pythonpath", python]
    done = subprocess.run(command, capture_output=True, text=True)
    found = json.loads(done.stdout)
    assert found["summary"]["filesAnalyzed"] == len(files), done.stdout
    errors = [x for x in found["generalDiagnostics"] if x["severity"] == "error"]
    lines = {(Path(x["file"]).name, x["range"]["start"]["line"] + 1) for x in errors}
    assert lines == {("arrays.py", n) for n in wrong_lines(ARRAYS)}, errors

"""The program `mip` as its users run it, and logs for it; sections, commands and programs of pages."""

from __future__ import annotations

import os
import re
import resource
import shlex
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from functools import cache
from io import TextIOWrapper
from pathlib import Path
from tempfile import TemporaryFile
from typing import Any

import support
from mip_protocol import base, mip_3dm, types
from mip_simulator import VirtualDevice
from mip_tools import __main__
from pytest import MonkeyPatch
from support import PATIENCE, PYTHONPATH

DEVICE = "3dm-cv7-gnss-ins"
ENVIRONMENT = {
    **{k: v for k, v in os.environ.items() if not k.startswith("PYTHON") or k == "PYTHONPYCACHEPREFIX"},
    "PYTHONPATH": PYTHONPATH,
    "COLUMNS": "100",
}


def command(*arguments: object, extras: bool = True) -> list[str]:
    """`mip` with these arguments; without `extras`, on the standard library alone."""
    return [sys.executable, *([] if extras else ["-S"]), "-m", "mip_tools", *map(str, arguments)]


def mip(*arguments: object, data: bytes = b"", extras: bool = True) -> tuple[int, str, str]:
    """The exit status, output and errors; anything unforeseen is a failure.

    It runs in this process, which takes a tenth of the time, with files as its streams; a process of its own is for
    what depends on one: see `started`.
    """
    if not extras:
        return started(*arguments, data=data, extras=False)
    with TemporaryFile() as given, TemporaryFile() as out, TemporaryFile() as error, MonkeyPatch.context() as patch:
        given.write(data)
        given.seek(0)
        streams = {
            "stdin": TextIOWrapper(given),
            "stdout": TextIOWrapper(out),
            "stderr": TextIOWrapper(error, write_through=True),
        }
        for name, stream in streams.items():
            patch.setattr(sys, name, stream)
        patch.setenv("COLUMNS", ENVIRONMENT["COLUMNS"])
        try:
            code = __main__.main([str(a) for a in arguments])
        except SystemExit as end:
            code = int(end.code or 0)
        for stream in streams.values():
            stream.flush()
        out.seek(0)
        error.seek(0)
        return code, out.read().decode("utf-8", "surrogateescape"), error.read().decode()


def started(*arguments: object, data: bytes = b"", extras: bool = True) -> tuple[int, str, str]:
    """The same in a process of its own, as users start it."""
    done = subprocess.run(command(*arguments, extras=extras), input=data, capture_output=True, env=ENVIRONMENT)
    out, error = done.stdout.decode("utf-8", "surrogateescape"), done.stderr.decode()
    assert "Traceback" not in error, error
    return done.returncode, out, error


def run(capsys: Any, *arguments: object) -> tuple[int, str, str]:
    """The same in this process, with the streams of the test."""
    try:
        code = __main__.main([str(a) for a in arguments])
    except SystemExit as end:
        code = int(end.code or 0)
    out, error = capsys.readouterr()
    return code, out, error


def on_a_full_disk(size: int, *arguments: object) -> tuple[int, bytes]:
    """The exit status and errors where no file can be larger.

    That would cut short what Python writes of compiled modules, too, and then none could be imported any more.
    """

    def limited() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)

    environment = {**ENVIRONMENT, "PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run(command(*arguments), preexec_fn=limited, capture_output=True, env=environment)
    return done.returncode, done.stderr


#: What commands that name values say of such a log, which has no reply of its device.
RECOGNIZED = "filter_data.status: flags read as those of generation 7 (recognized)"
_DEVICE = re.compile(r"(mip \w+: device .* \((from the log|at the port)\)\n)?")


def printed(line: str, folder: Path) -> str:
    """What a line of a page prints in a folder: programs that succeed, each with the output of the one before."""
    data, (pipe, _, file) = b"", line.partition(" > ")
    for name, *words in (shlex.split(part, comments=True) for part in pipe.split(" | ")):
        with MonkeyPatch.context() as patch:
            patch.chdir(folder)
            if name == "mip":
                code, out, error = mip(*words, data=data)
            else:
                done = subprocess.run([name, *words], input=data, capture_output=True)
                code, out, error = done.returncode, done.stdout.decode(), done.stderr.decode()
        assert code == 0 and _DEVICE.fullmatch(error), (line, error)
        data = out.encode("utf-8", "surrogateescape")
    if file:
        (folder / file.strip()).write_bytes(data)
    return data.decode()


def until(condition: Callable[[], Any], process: subprocess.Popen[Any] | None = None) -> Any:
    """Waits for something, not for a time; a process that is named must not end before."""
    end = time.monotonic() + PATIENCE
    while not (found := condition()):
        assert time.monotonic() < end and (process is None or process.poll() is None), "it did not happen"
        time.sleep(0.005)
    return found


@contextmanager
def running(*arguments: object, **options: Any) -> Iterator[subprocess.Popen[bytes]]:
    process = subprocess.Popen(
        command(*arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=ENVIRONMENT, **options
    )
    try:
        yield process
    finally:
        process.kill()
        process.communicate()


def simulated(*options: str, device: str = DEVICE) -> AbstractContextManager[str]:
    """A virtual device at a TCP port, as `mip` names it."""
    return support.simulated("--tcp", "0", *options, device=device)


RATES = {
    0x80: ((0xD3, 10), (0x04, 10), (0x05, 10), (0x06, 20)),
    0x82: ((0xD3, 50), (0x05, 50), (0x01, 50), (0x10, 50)),
    0x91: ((0xD3, 1), (0x03, 1), (0x09, 5)),
}


Rates = dict[int, tuple[tuple[int, int], ...]]


def streaming(device: VirtualDevice, rates: Rates = RATES) -> Any:
    """A link with a device that sends these fields: set -> descriptors and decimations."""
    link = device.connect()
    commands: list[Any] = [base.SetIdle()]
    for number, fields in rates.items():
        formats = tuple(types.DescriptorRate(*field) for field in fields)
        commands += [mip_3dm.MessageFormat.write(number, formats), mip_3dm.DataStreamControl.write(number, True)]
    for c in [*commands, base.Resume()]:
        link.write(bytes(c.packet()))
        device.advance(0.05)
    link.read()
    return link


def sent(device: VirtualDevice, link: Any, seconds: float) -> bytes:
    """What arrives in the next seconds."""
    data = b""
    for _ in range(round(seconds * 10)):
        device.advance(0.1)
        data += link.read()
    return data


@cache
def log(seconds: float = 4.0) -> bytes:
    """What a device sends in some seconds: inertial data, a filter and a receiver."""
    device = VirtualDevice(DEVICE)
    return sent(device, streaming(device), seconds)


def reply(device: str) -> bytes:
    """The packet in which a device says who it is."""
    link = (virtual := VirtualDevice(device)).connect()
    link.write(bytes(base.GetDeviceInfo().packet()))
    virtual.advance(0.05)
    return bytes(link.read())


def section(page: str, title: str) -> str:
    """A section of a page, which must be there."""
    found = f"\n{page}".partition(f"\n## {title}\n")[2].partition("\n## ")[0]
    assert found, title
    return found


def commands(text: str, program: str = "") -> list[str]:
    """The indented commands, of one program or of any; those in fenced blocks are not among them."""
    return re.findall(rf"^    (?=\S)({program}.*)$", re.sub(r"```.*?```", "", text, flags=re.S), re.M)


def blocks(text: str, language: str) -> list[str]:
    """The fenced blocks of a language."""
    return re.findall(rf"```{language}\n(.*?)```", text, re.S)


def programs(folder: Path, **modules: str) -> Path:
    """A folder with programs that run modules of Python."""
    folder.mkdir()
    for name, module in modules.items():
        words = [sys.executable, *(["-m", module] if module else [])]
        (folder / name).write_text(f'#!/bin/sh\nexec {shlex.join(words)} "$@"\n')
        (folder / name).chmod(0o755)
    return folder

"""`mip corrections`: RTCM from a caster of the test to a virtual device, in both versions of NTRIP."""

from __future__ import annotations

import base64
import re
import signal
import socket
import threading
from collections.abc import Iterator

import pytest
from mip_simulator import VirtualDevice
from mip_tools.commands import corrections
from mip_tools.rtcm import Frames, checksum, number
from program import mip, running, simulated

TABLE = b"STR;NEAR;town;RTCM 3.2\r\nSTR;FAR;town;RTCM 3.2\r\nENDSOURCETABLE\r\n"
LOGIN = base64.b64encode(b"me:p@ss")


def frame(kind: int, size: int = 20) -> bytes:
    message = (kind << 4).to_bytes(2, "big") + bytes(size)
    whole = b"\xd3" + len(message).to_bytes(2, "big") + message
    return whole + checksum(whole).to_bytes(3, "big")


FRAMES = frame(1005) + frame(1077, 300)


class Caster:
    """One mount point for each thing that can happen."""

    def __init__(self) -> None:
        self._server = socket.create_server(("127.0.0.1", 0))
        self.place = f"127.0.0.1:{self._server.getsockname()[1]}"
        self.sentences = b""
        self.streams = 0
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self) -> None:
        try:
            while True:
                threading.Thread(target=self._serve, args=self._server.accept()[:1], daemon=True).start()
        except OSError:  # closed
            pass

    def close(self) -> None:
        self._server.close()

    def _serve(self, client: socket.socket) -> None:
        with client:
            head = b""
            while b"\r\n\r\n" not in head:
                head += client.recv(4096)
            mount = head.split()[1].decode()[1:]
            client.sendall({
                "V1": b"ICY 200 OK\r\n\r\n",
                "V2": b"HTTP/1.1 200 OK\r\nContent-Type: gnss/data\r\nTransfer-Encoding: chunked\r\n\r\n",
                "SHORT": b"ICY 200 OK\r\n",
                "SILENT": b"ICY 200 OK\r\n\r\n",
                "UBX": b"ICY 200 OK\r\n\r\n" + 9 * (b"\xb5\x62\x01\x02\x04\0" + bytes(6)),
                "PASSWORD": b"ERROR - Bad Password\r\n",
                "LOGIN": b"HTTP/1.1 401 Unauthorized\r\nContent-Length: 0\r\n\r\n",
                "GONE": b"HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n",
                "BROKEN": b"HTTP/1.1 500 Internal Server Error\r\nContent-Length: 0\r\n\r\n",
            }.get(mount, b"SOURCETABLE 200 OK\r\n\r\n" + TABLE))  # fmt: skip
            if mount in ("V1", "V2", "SHORT") and LOGIN in head:
                self.streams += 1
                self._stream(client, mount)
            elif mount in ("SILENT", "UBX"):
                client.recv(1)  # until the program leaves

    def _stream(self, client: socket.socket, mount: str) -> None:
        client.settimeout(0.05)
        for data in [FRAMES[:7], FRAMES[7:], FRAMES] if mount == "SHORT" else 1000 * [FRAMES[:7], FRAMES[7:]]:
            try:
                client.sendall(b"%x\r\n%s\r\n" % (len(data), data) if mount == "V2" else data)
                self.sentences += client.recv(4096)
            except TimeoutError:
                pass
            except OSError:  # the program has ended
                return


@pytest.fixture
def caster(monkeypatch: pytest.MonkeyPatch) -> Iterator[Caster]:
    for name, value in (("_QUIET", 0.5), ("_FIRST_PAUSE", 0.05), ("_ASK", 0.1)):
        monkeypatch.setattr(corrections, name, value)
    made = Caster()
    yield made
    made.close()


@pytest.mark.parametrize("mount", ["V1", "V2"])
def test_a_device_gets_corrections_and_the_caster_a_position(mount: str, caster: Caster) -> None:
    with running("simulate", "3dm-cv7-gnss-ins", "--tcp", "0") as process:
        assert process.stdout is not None
        place = process.stdout.readline().decode().strip()
        url = f"ntrip://me:p%40ss@{caster.place}/{mount}"
        code, out, error = mip("corrections", url, place, "--gga", "--duration", "5")
        assert (code, out) == (0, ""), error
        assert re.search(r"^mip corrections: fix_rtk_fixed, sbas_used, dgnss_used, \d+ satellites$", error, re.M)
        assert re.match(rb"\$GPGGA,\d{6}\.\d\d,4[67]\d\d\.\d{5},N,00[78]\d\d\.\d{5},E,1,\d\d,", caster.sentences)
        process.send_signal(signal.SIGTERM)
        said = process.communicate()[1].decode()
    received = re.search(r"3DM-CV7-GNSS/INS has received (\d+) RTCM frames", said)
    assert received and int(received[1]) > 3


def test_a_stream_that_ends_is_opened_again(caster: Caster) -> None:
    url = f"me:p%40ss@{caster.place}/SHORT"
    with simulated() as place:
        code, _, error = mip("corrections", url, place, "--at", "48.5,-11.25,520", "--duration", "3")
    assert code == 0 and caster.streams > 1 and f"{caster.place}/SHORT has ended the stream; next attempt" in error
    assert b",4830.00000,N,01115.00000,W,1,10,1.00,520.00,M,0.00,M,," in caster.sentences


@pytest.mark.parametrize(
    ("mount", "error"),
    [
        ("NEAREST", ": the caster has no mount point 'NEAREST'; it has NEAR"),
        ("GONE", ": the caster has no mount point 'GONE'; it has NEAR, FAR"),
        ("", ": name a mount point; it has NEAR, FAR"),
        ("LOGIN", ": the caster rejects the login; write ntrip://USER:PASSWORD@HOST:PORT/MOUNT"),
        ("PASSWORD", ": the caster rejects the login; write ntrip://USER:PASSWORD@HOST:PORT/MOUNT"),
        ("BROKEN", ": the caster replies: 500 Internal Server Error"),
        ("SILENT", " sends no RTCM 3: it may wait for a position; send one with --gga or --at"),
        ("UBX", " sends no RTCM 3, but UBX of a u-blox receiver"),
    ],
)
def test_what_a_caster_refuses_or_does_not_send(mount: str, error: str, caster: Caster) -> None:
    source = f"{caster.place}/{mount}"
    with simulated() as place:
        code, out, said = mip("corrections", source, place)
    *before, last = said.splitlines()
    assert (code, out, last) == (1, "", f"mip corrections: {source}{error}")
    assert before == [] or mount in ("SILENT", "UBX")


def test_devices_that_cannot_use_them(caster: Caster) -> None:
    with simulated(device="3dm-cv7-ar") as place:
        error = "mip corrections: 3DM-CV7-AR has no GNSS receiver, so it cannot use corrections\n"
        assert mip("corrections", f"{caster.place}/V1", place) == (1, "", error)
    with simulated(device="3dm-gx5-45") as place:
        error = "3DM-GX5-45 has no 3dm.poll_data to read its fix, and is not known to receive RTCM 3\n"
        assert mip("corrections", f"{caster.place}/V1", place) == (1, "", f"mip corrections: {error}")
    with simulated() as place:
        for port in ("main", "uart_1", "usb_1"):
            assert mip("send", place, "system.interface_control", "write", port, "mip", "mip")[0] == 0
        error = mip("corrections", f"{caster.place}/LOGIN", place)[2].splitlines()[0]
        command = f"mip send {place} system.interface_control write main 'mip|rtcm' mip"
        assert error == f"mip corrections: no port of the device receives RTCM; enable it: {command}"
        assert mip(*command.replace("'", "").split()[1:])[0] == 0
        assert "no port" not in mip("corrections", f"{caster.place}/LOGIN", place)[2]


def test_a_caster_that_is_not_there() -> None:
    with simulated() as place, socket.create_server(("127.0.0.1", 0)) as server:
        gone = f"127.0.0.1:{server.getsockname()[1]}"
        server.close()
        assert mip("corrections", f"{gone}/M", place)[2].endswith(f"{gone} cannot be reached: Connection refused\n")


@pytest.mark.parametrize("size", [1, 7, 1000])
def test_frames_among_other_bytes(size: int) -> None:
    damaged = FRAMES[:-1] + bytes([FRAMES[-1] ^ 1])
    data = b"\xd3noise\xd3\xff" + FRAMES + b"$GPGGA\r\n" + damaged + b"\xd3" + FRAMES
    frames = Frames()
    found = [one for i in range(0, len(data), size) for one in frames.feed(data[i : i + size])]
    assert [number(one) for one in found] == [1005, 1077, 1005, 1005, 1077]


def test_ports_without_rtcm_input_count_none() -> None:
    device = VirtualDevice("3dm-cv7-gnss-ins")
    device.advance(1)
    for port, count in (("UART 1", 2), ("UART 2", 2)):
        device.connect(port).write(FRAMES)
        assert device.rtcm_frames == count

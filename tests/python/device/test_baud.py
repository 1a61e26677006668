"""The search for a baud rate, step by step, with a simulated clock."""

from __future__ import annotations

from types import SimpleNamespace

import mip_protocol as mip
import pytest
from mip_protocol import baud
from mip_protocol.port import READ_TIMEOUT

PING = bytes.fromhex("756501020201e0c6")
DATA = bytes(mip.PacketBuilder(0x80).add(0x04, bytes(12)).build())


class Port:
    """Answers at one rate. Reading takes a hundredth of a second."""

    timeout = 7.0

    def __init__(self, rate: int = 0, answer: bytes = DATA) -> None:
        self.right, self.answer = rate, answer
        self.now, self.rate, self.unread = 0.0, 9600, b""
        self.done: list[object] = []

    @property
    def baudrate(self) -> int:
        return self.rate

    @baudrate.setter
    def baudrate(self, rate: int) -> None:
        self.rate = rate
        self.done.append(rate)

    def reset_input_buffer(self) -> None:
        self.done.append("clear")

    def write(self, data: bytes) -> int:
        assert data == PING
        self.done.append(f"ping at {self.now:.2f}")
        if self.rate == self.right:
            self.unread = self.answer
        return len(data)

    def read(self, size: int) -> bytes:
        assert self.timeout == READ_TIMEOUT
        self.now = round(self.now + 0.01, 2)
        data, self.unread = self.unread, b""
        return data


@pytest.fixture
def search(monkeypatch: pytest.MonkeyPatch):  # type: ignore[no-untyped-def]
    def run(port: Port, *rates: int) -> int:
        monkeypatch.setattr(baud, "time", SimpleNamespace(monotonic=lambda: port.now))
        return mip.detect_baud(port, rates, listen=0.3)

    return run


def test_each_rate_is_tried_once_with_two_pings(search) -> None:  # type: ignore[no-untyped-def]
    port = Port()
    with pytest.raises(mip.NoDevice, match="at 1200, 2400 Bd"):
        search(port, 1200, 2400, 1200)
    assert port.done == [
        1200, "clear", "ping at 0.00", "ping at 0.16", 2400, "clear", "ping at 0.30", "ping at 0.46", 9600
    ]  # fmt: skip
    assert port.now == 0.6 and port.timeout == 7.0


def test_it_ends_with_the_first_packet(search) -> None:  # type: ignore[no-untyped-def]
    port = Port(2400)
    assert search(port, 1200, 2400, 4800) == 2400
    assert port.done[-3:] == [2400, "clear", "ping at 0.30"] and port.now == 0.31 and port.timeout == 7.0


def test_a_packet_behind_noise_is_found(search) -> None:  # type: ignore[no-untyped-def]
    """The noise looks like the beginning of a long packet, whose end never comes."""
    port = Port(1200, b"ue\x80\xff" + DATA)
    assert search(port, 1200) == 1200 and port.now == 0.01


def test_noise_is_no_device(search) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(mip.NoDevice):
        search(Port(1200, b"ue\x80" + bytes(40)), 1200)


def test_without_rates() -> None:
    with pytest.raises(mip.NoDevice, match="at no rate"):
        mip.detect_baud(Port(), [])
    with pytest.raises(mip.NoDevice, match="has no baud rate"):
        mip.detect_baud(SimpleNamespace(read=lambda size: b"", write=len))


def test_the_usual_rate_is_first() -> None:
    found = baud.rates()
    assert found[0] == 115200 == baud.USUAL and len(set(found)) == len(found) > 3
    assert list(found[1:]) == sorted(found[1:], reverse=True)

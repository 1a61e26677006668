"""The latest values that `mip monitor` shows."""

from __future__ import annotations

import pytest
from mip_protocol import PacketBuilder
from mip_tools.logs.scan import Piece, Scanner
from mip_tools.monitor.latest import Latest
from mip_tools.names.selection import Selection
from program import log


@pytest.mark.parametrize(("timed", "rate"), [(True, "100 Hz"), (False, "50 Hz")])
def test_the_rate_is_that_of_the_device(timed: bool, rate: str) -> None:
    """Packets may arrive in bursts; only without a time do arrivals count."""
    latest = Latest(Selection(["sensor.scaled_accel"]), None)
    packets = [p.packet for p in Scanner().feed(log(1.0)) if p.packet is not None and p.packet.set == 0x80]
    for i, packet in enumerate(packets):
        builder = PacketBuilder(packet.set)
        for raw in packet:
            if timed or raw.descriptor == 0x04:
                builder.add(raw.descriptor, raw.data)
        latest.add(Piece(0, b"", builder.build()), 0.1 * (i // 5) if timed else 0.02 * i)
    (one,) = latest.shown(0.02 * len(packets))
    assert (one.name, one.hertz, one.old) == ("scaled_accel", rate, "")

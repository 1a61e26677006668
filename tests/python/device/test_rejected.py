"""Python names the field for which a device rejects a command, by the cases that all languages share."""

from __future__ import annotations

import json
from typing import Any

import mip_protocol as mip
import pytest
from both import Kind, Peer, acknowledge, packet
from mip_protocol import devices, filter_data, mip_3dm, registry, types
from mip_protocol.errors import Cause
from mip_protocol.packet import RawField
from mip_protocol.rejected import ConnectedDevice, find_cause
from support import ROOT

CASES: list[dict[str, Any]] = json.loads((ROOT / "tests/rejected.json").read_text("utf-8"))


@pytest.mark.parametrize("case", CASES, ids=[case["title"] for case in CASES])
def test_the_field_to_blame(case: dict[str, Any]) -> None:
    listed = bytes.fromhex(case.get("descriptors", ""))
    connected = ConnectedDevice(
        devices.by_name(case["device"]) if "device" in case else None, set(zip(listed[::2], listed[1::2], strict=True))
    )
    command: Any = registry.decode(RawField(*bytes.fromhex(case["command"]), bytes.fromhex(case["data"])))
    cause = find_cause(command, connected)
    got = cause and [cause.index, f"{cause.set:02X}", f"{cause.descriptor:02X}", cause.reason, cause.text]
    assert got == case["cause"]


def place(cause: Cause | None) -> tuple[int, int, int] | None:
    return cause and (cause.index, cause.set, cause.descriptor)


def test_a_device_is_asked_once(kind: Kind, peer: Peer) -> None:
    """What it is, and all that it lists: the filter's position is in neither list."""
    info = packet(0x01, "f1 03 00", "81" + "0000" + b"3DM-CV7-AHRS    6286-9999       ".hex() + "20" * 48)
    lists = packet(0x01, "f1 04 00", "82 0101 0107 8004"), packet(0x01, "f1 07 00", "86 8210")
    command = mip_3dm.MessageFormat.write(0x82, [types.DescriptorRate(d, 1) for d in (0x10, 0x01)])
    rejected = acknowledge(0x0C, 0x0F, 3)
    text = "3dm.message_format rejected (invalid parameter): 3DM-CV7-AHRS does not send filter_data.llh_position"
    with kind.at(peer.near) as device:
        peer.answering(rejected, info, *lists, rejected, packet(0x0C, "f1 0e 00", "8e 82 01f4"), rejected)
        for _ in range(2):
            with pytest.raises(mip.Refused) as caught:
                device.request(command)
            assert str(caught.value) == text and place(caught.value.cause) == (1, 0x82, 0x01)
        with pytest.raises(mip.Refused) as caught:
            device.stream({filter_data.Status: 0, filter_data.LlhPosition: 0}, timestamp=None)
        assert str(caught.value) == text and place(caught.value.cause) == (1, 0x82, 0x01)


def test_a_device_that_does_not_say_what_it_is(kind: Kind, peer: Peer) -> None:
    """The error has the code alone, and no other error takes its place."""
    with kind.at(peer.near) as device:
        peer.answering(acknowledge(0x0C, 0x0F, 3), acknowledge(0x01, 0x03, 1))
        with pytest.raises(mip.Refused) as caught:
            device.request(mip_3dm.MessageFormat.write(0x82, [types.DescriptorRate(1, 1)]))
    assert str(caught.value) == "3dm.message_format rejected (invalid parameter)" and caught.value.cause is None

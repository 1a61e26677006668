"""`mip simulate --certain`, and what a simulated device lists: what it has, for certain, likely and as is assumed."""

from __future__ import annotations

import pytest
from mip_protocol import Parser, base, devices, mip_3dm, types
from mip_protocol.devices import Support
from mip_simulator import VirtualDevice
from mip_tools import __main__
from mip_tools.devices.profiles import assumed_rates, certain
from simulated import Host

IDS = list(devices.DEVICES)


def listed(device: VirtualDevice) -> set[tuple[int, int]]:
    host = Host(device)
    found = [*host.ok(base.GetDeviceDescriptors()).descriptors]
    if len(found) > 100:
        found += host.ok(base.GetExtendedDescriptors()).descriptors
    assert len(found) == len(set(found))
    return {divmod(number, 256) for number in found}


def said(device_id: str, *answers: Support) -> set[tuple[int, int]]:
    """The fields for which any evidence has one of these answers."""
    return {
        (set_number, descriptor)
        for e in devices.DEVICES[device_id].evidence
        if e.answer in answers
        for set_number, descriptors in e.descriptors.items()
        for descriptor in descriptors
    }


@pytest.mark.parametrize("device_id", IDS)
def test_what_a_device_lists(device_id: str) -> None:
    probable = {(0x01, 0x04), (0x01, 0x07)} & said(device_id, Support.YES, Support.LIKELY, Support.ASSUMED)
    former = {key for key, versions in devices.DEVICES[device_id].firmware.items() if versions.startswith("<")}
    assert listed(VirtualDevice(device_id)) == said(device_id, Support.YES, Support.LIKELY, Support.ASSUMED) - former
    if probable <= said(device_id, Support.YES) and (0x01, 0x04) in probable:
        assert listed(VirtualDevice(certain(devices.DEVICES[device_id]))) == said(device_id, Support.YES) - former


def test_a_device_that_is_certain_refuses_the_rest() -> None:
    profile = next(d for d in devices.DEVICES.values() if (0x01, 0x09) in d.fields - d.certain)
    command = base.CommSpeed.read(0x11)
    assert Host(VirtualDevice(certain(profile))).ask(command)[0].accepted is False
    assert any(e.answer is Support.NO for d in devices.DEVICES.values() for e in certain(d).evidence)


@pytest.mark.parametrize("option", [(), ("--certain",)])
def test_the_first_line_says_how_many(option: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    for device_id in ("3dm-gq7", "3dm-cv7-gnss-ins"):
        assert __main__.main(["simulate", device_id, "--tcp", "0", "--duration", "0.01", *option]) == 0
        out, error = capsys.readouterr()
        sure = said(device_id, Support.YES)
        likely, assumed = len(said(device_id, Support.LIKELY)), len(said(device_id, Support.ASSUMED))
        more = " (left out)" if option and likely + assumed else ""
        title = devices.DEVICES[device_id].title
        counts = f"{title}: {len(sure)} commands and data fields are certain, {likely} likely, {assumed} assumed{more}"
        assert out.startswith("localhost:") and error.splitlines()[0] == f"mip simulate: {counts}"


def test_what_is_assumed_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    assert __main__.main(["simulate", "3dm-cx5-45", "--tcp", "0", "--duration", "0.01"]) == 0
    assert "assumed: sensor 500 Hz, gnss_data 4 Hz, filter_data 500 Hz" in capsys.readouterr().err


def test_a_base_rate_that_no_source_states_is_that_of_other_devices() -> None:
    """Programs that ask for it compute a decimation from it."""
    profile = devices.DEVICES["3dm-cx5-45"]
    assert not profile.base_rates
    assert assumed_rates(profile) == {0x80: 500, 0x81: 4, 0x82: 500}
    host = Host(VirtualDevice(profile))
    assert host.ok(mip_3dm.GetImuBaseRate()).rate == 500
    host.ok(mip_3dm.ImuMessageFormat.write((types.DescriptorRate(0x04, 50),)))
    host.device.advance(1.0)
    assert len(Parser().feed(host.link.read())) == 10


@pytest.mark.parametrize("device_id", IDS)
def test_only_unknown_base_rates_are_assumed(device_id: str) -> None:
    profile = devices.DEVICES[device_id]
    rates = assumed_rates(profile)
    assert not rates.keys() & profile.base_rates.keys()
    assert {
        set_number for set_number, _ in profile.fields if 0x80 <= set_number < 0xFF
    } <= rates.keys() | profile.base_rates.keys()
    assert all(rate <= 10 for rate in rates.values()) or profile.generation in (4, 5, 7)

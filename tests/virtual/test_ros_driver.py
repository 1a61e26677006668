"""The vendor's ROS driver at its start: the commands that it sends with its default parameters, in its order.

It asks the device for its descriptors, sends each of these commands if it is among them, and gives up when one is
rejected, except where that is expected.
"""

from __future__ import annotations

from typing import Any

import pytest
from mipgen import model as m
from support import model, nightly
from virtual.commands import Trial, commands, data_fields, settled
from virtual.scenario import OWN_FORMATS, OWN_STREAMS
from virtual.session import Session, Witness

#: One model of each generation.
MODELS = ("3dm-gx3-45", "3dm-gx4-45", "3dm-gx5-45", "3dm-cv7-gnss-ins")
REST = [
    pytest.param(d.id, marks=nightly("the start of the vendor's ROS driver, with every model"))
    for d in model("real").devices
    if commands(d) and d.id not in MODELS
]

ZEROS = ["0x00000000"] * 3

#: How the rate is read of a set that has a message format of its own.
OWN_RATES = {name: f"3dm.get_{name[4:].split('_')[0]}_base_rate" for name in OWN_FORMATS.values()}

#: In Hz.
RATE = 2

#: What it configures, where the device lists the descriptor; values that are not named are the plainest ones of the
#: device.
CONFIGURES: list[tuple[str, dict[str, Any]]] = [
    ("3dm.pps_source_control", {}),
    ("3dm.odometer_config", {"mode": 0, "scaling": ZEROS[0], "uncertainty": ZEROS[0]}),
    ("3dm.gnss_sbas_settings", {"enable_sbas": 0, "sbas_options": 0, "included_prns": []}),
    ("gnss.rtk_dongle_config", {"enable": 1}),
    ("gnss.signal_config", {"gps_enable": 1, "glonass_enable": 1, "galileo_enable": 1, "beidou_enable": 1}),
    ("filter.magnetic_declination_source", {}),
    ("filter.antenna_offset", {"offset": ZEROS}),
    ("filter.multi_antenna_offset", {"receiver_id": 1, "antenna_offset": ZEROS}),
    ("filter.multi_antenna_offset", {"receiver_id": 2, "antenna_offset": ZEROS}),
    ("filter.vehicle_dynamics_mode", {"mode": 1}),
    ("filter.gnss_source", {}),
    ("filter.heading_source", {"source": 1}),
    ("filter.auto_initialization_control", {"enable": 1}),
    ("filter.adaptive_filter_options", {"level": 2, "time_limit": 15000}),
    *(("filter.aiding_measurement_enable", {"aiding_source": n, "enable": int(n < 2)}) for n in range(6)),
    ("filter.speed_lever_arm", {"source": 1, "lever_arm_offset": ZEROS}),
    ("filter.wheeled_vehicle_constraint_control", {"enable": 0}),
    ("filter.vertical_gyro_constraint_control", {"enable": 0}),
    ("filter.gnss_antenna_calibration_control", {"enable": 0, "max_offset": "0x3dcccccd"}),
    ("filter.initialization_config", {"initial_condition_source": 0, "reference_frame_selector": 2}),
    ("filter.reference_point_lever_arm", {"reference_point": 1, "lever_arm_offset": ZEROS}),
]

#: After rejection of an invalid parameter, it goes on.
MAY_BE_INVALID = {"filter.aiding_measurement_enable", "filter.heading_source"}
INVALID = 3


class Start:
    """Its conversation with one device."""

    def __init__(self, device: m.Device) -> None:
        self.device, self.session = device, Session(device, Witness())
        self.listed: set[tuple[int, int]] = set()

    def ask(self, name: str, function: int | None = None, **values: Any) -> dict[str, Any]:
        """The outcome of a command."""
        field = model("real").field(name)
        assert field is not None, name
        call = next(c for c in field.calls if c.function is None or c.function.value == (function or 1))
        first = {} if call.function is None else {"function": call.function.value}
        trial = Trial(field, first | settled(call.required, first | values, self.device), True)
        number = len(self.session.trials)
        return next(e for e in self.session.ask(trial) if e.get("command") == number)

    def lists(self, name: str) -> bool:
        field = model("real").field(name)
        assert field is not None, name
        return (field.set, field.descriptor) in self.listed

    def run(self) -> None:
        self.accepted("base.set_idle")
        self.accepted("base.get_device_info")
        for name in ("base.get_device_descriptors", "base.get_extended_descriptors"):
            answer = self.ask(name)
            for number in answer.get("response", {}).get("values", {}).get("descriptors", []):
                self.listed.add(divmod(number, 256))
        assert self.lists("base.get_device_descriptors")
        if self.lists("aiding.frame_config"):
            frames = 0
            while self.ask("aiding.frame_config", 2, frame_id=frames + 1, format=2)["event"] == "acknowledged":
                frames += 1
            assert 0 < frames < 255
        self.stream()
        for name, values in CONFIGURES:
            if self.lists(name):
                answer = self.ask(name, 1, **values)
                assert answer["event"] in ("acknowledged", "silent") or (
                    name in MAY_BE_INVALID and answer.get("code") == INVALID
                ), (name, values, answer)
        if self.lists("3dm.device_settings"):
            self.accepted("3dm.device_settings", 3)
        if self.lists("filter.reset"):
            self.accepted("filter.reset")
        self.accepted("base.resume")

    def stream(self) -> None:
        """Each set has its rate read, its format written, and is enabled."""
        for number, descriptors in data_fields(self.device).items():
            wanted = [d for d in descriptors if (number, d) in self.listed][:6]
            own = OWN_FORMATS.get(number, "")
            if not wanted or not (self.lists("3dm.message_format") or (own and self.lists(own))):
                continue
            which = {"descriptor_set": number} if self.lists("3dm.message_format") else {}
            format_of, rate_of = ("3dm.message_format", "3dm.get_base_rate") if which else (own, OWN_RATES[own])
            rate = self.accepted(rate_of, **which)["response"]["values"]["rate"]
            formats = [{"descriptor": d, "decimation": max(1, rate // RATE)} for d in wanted]
            self.accepted(format_of, 1, **which, descriptors=formats)
            if self.ask("3dm.data_stream_control", 1, descriptor_set=number, enable=1).get("code") == INVALID:
                self.accepted("3dm.data_stream_control", 1, descriptor_set=OWN_STREAMS[number], enable=1)

    def accepted(self, name: str, function: int | None = None, **values: Any) -> dict[str, Any]:
        answer = self.ask(name, function, **values)
        assert answer["event"] == "acknowledged", (name, values, answer)
        return answer


@pytest.mark.parametrize("name", [*MODELS, *REST])
def test_it_starts(name: str) -> None:
    start = Start(next(d for d in model("real").devices if d.id == name))
    start.run()
    before = len(start.session.client.events)
    start.session.wait(3000)
    sets = {e["set"] for e in start.session.client.events[before:] if e["event"] == "received" and e["set"] >= 0x80}
    assert name not in MODELS or {0x80, 0x82} <= sets, sets

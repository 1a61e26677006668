"""MCAP and bags of ROS 2, read by readers that are not ours; the axes of REP 103."""

from __future__ import annotations

import json
import math
import random
import struct
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import jsonschema_rs
import pytest
from mip_protocol import PacketBuilder, Parser, filter_data, registry, shared
from mip_simulator import VirtualDevice
from mip_tools.binding import info
from mip_tools.columns import read_log
from mip_tools.formats import messages
from mip_tools.formats.json_messages import message_values, schema
from mip_tools.names.occurrence import occurrence_in
from mip_tools.ros import axes, standard
from mip_tools.ros.types import Types
from program import DEVICE, log, mip, sent, streaming
from support import heavy, later
from test_log_tables import drawn
from timed_packets import packet

np = later("numpy")

NAVIGATION = {
    0x80: ((0xD3, 10), (0x04, 10), (0x05, 10), (0x06, 10)),
    0x82: ((0xD3, 50), (0x03, 50), (0x01, 50), (0x02, 50), (0x08, 50), (0x09, 50), (0x0A, 50), (0x0E, 50)),
    0x91: ((0xD3, 1), (0x03, 1), (0x0B, 1)),
}


@pytest.mark.parametrize("named, device", [(False, None), (True, None), (True, DEVICE)])
def test_messages_obey_their_schemas(named: bool, device: str | None) -> None:
    seen = set()
    for received in Parser().feed(log(1.0)):
        for field in registry.decode_packet(received):
            if isinstance(field, tuple):
                continue
            jsonschema_rs.validate(schema(type(field), named, device), message_values(field, named, device))
            seen.add(type(field))
    assert len(seen) > 5
    for _, kind in registry.all_types():
        jsonschema_rs.meta.validate(schema(kind, named, device))
        assert set(schema(kind, named, device)["properties"]) == {p.name for p in info(kind).members}


def test_what_is_no_number_is_left_out() -> None:
    kind = registry.by_name("sensor.scaled_accel")
    assert message_values(kind((1.0, math.nan, -1.0)), False, None) == {"scaled_accel": {"x": 1.0, "z": -1.0}}


def test_elements_that_are_not_valid_are_left_out() -> None:
    kind = registry.by_name("aiding.magnetic_field")
    field = kind.decode(struct.pack(">BBQB6fH", 1, 1, 5, 1, *range(6), 5))
    assert message_values(field, False, None, masked=True)["magnetic_field"] == {"x": 0.0, "z": 2.0}
    assert message_values(field, False, None)["magnetic_field"] == {"x": 0.0, "y": 1.0, "z": 2.0}


def mcap(path: Path) -> Iterator[tuple[Any, Any, Any]]:
    from mcap.reader import make_reader

    with path.open("rb") as file:
        yield from make_reader(file).iter_messages()


@heavy("mcap")
def test_an_mcap_file_has_what_jsonl_has(tmp_path: Path) -> None:
    from mcap.reader import make_reader

    (tmp_path / "log").write_bytes(log())
    assert mip("export", tmp_path / "log", "-o", tmp_path / "log.mcap") == (0, "", "")
    rows = [json.loads(x) for x in mip("export", tmp_path / "log", "--format", "jsonl", "-o", "-")[1].splitlines()]
    found = list(mcap(tmp_path / "log.mcap"))
    assert len(found) > 1000
    counts: dict[str, int] = {}
    for kind, channel, one in found:
        jsonschema_rs.validate(json.loads(kind.data), json.loads(one.data))
        assert kind.name == f"mip.{channel.topic[5:].replace('/', '.')}" and kind.encoding == "jsonschema"
        counts[channel.topic] = counts.get(channel.topic, 0) + 1
    assert counts["/mip/sensor/scaled_accel"] == sum("sensor.scaled_accel.x" in row for row in rows) > 100
    assert json.loads(found[0][0].data)["properties"]["tow"]["description"] == "in s"
    # Times are those of the device.
    gps = [one.log_time for _, c, one in found if c.topic == "/mip/sensor/scaled_accel"]
    assert {b - a for a, b in pairwise(gps)} == {10_000_000} and 1.7e18 < gps[0] < 1.8e18
    with (tmp_path / "log.mcap").open("rb") as file:
        (about,) = make_reader(file).iter_metadata()
    assert about.metadata["clock"] == "gps" and "UTC" in about.metadata["time"]


@heavy("mcap")
def test_mcap_from_a_pipe_and_from_a_stream(tmp_path: Path) -> None:
    (tmp_path / "log").write_bytes(log(1.0))
    mip("export", tmp_path / "log", "-o", tmp_path / "a.mcap")
    assert mip("export", "-", "-o", tmp_path / "b.mcap", data=log(1.0)) == (0, "", "")
    assert mip("stream", tmp_path / "log", "--format", "mcap", "-o", tmp_path / "c.mcap") == (0, "", "")
    a, b, c = ((tmp_path / f"{x}.mcap").read_bytes() for x in "abc")
    assert a == b == c


@heavy("mcap")
def test_messages_of_fields_without_a_time(tmp_path: Path) -> None:
    """Other sets have one. A stream has the time of the host, a log none."""
    stamp = (0xD3, shared.GpsTimestamp(5.0, 2300, shared.GpsTimestampFlags(3)).encode())
    status = packet(0x82, stamp, (0x10, bytes(6)))
    path, out = tmp_path / "log", tmp_path / "out.mcap"
    path.write_bytes(packet(0x80, (0x04, bytes(12))) * 3 + status)
    for form in ("mcap", "ros2"):
        code, _, error = mip("export", path, "--only", "sensor", "--format", form, "-o", out)
        assert code == 1 and "these fields have no valid time" in error and not out.exists()
    assert mip("export", path, "-o", out)[0] == 0 and len(list(mcap(out))) == 5
    assert mip("export", "-", "--only", "sensor", "-o", out, data=path.read_bytes())[0] == 0
    assert len(list(mcap(out))) == 3


@heavy("mcap")
@pytest.mark.parametrize("command", ["export", "stream"])
def test_values_that_mcap_leaves_out(command: str, tmp_path: Path) -> None:
    """The same as JSON lines do."""
    times = iter(range(3))

    def data(number: int, descriptor: int, form: str, *values: float) -> bytes:
        stamp = shared.GpsTimestamp(next(times), 2300, shared.GpsTimestampFlags(3))
        return packet(number, (0xD3, stamp.encode()), (descriptor, struct.pack(form, *values)))

    path, out = tmp_path / "log", tmp_path / "out"
    angles = b"".join(data(0x82, 0x05, ">3fH", 1, 2, 3, flag) for flag in (1, 0))
    path.write_bytes(angles + data(0x91, 0x05, ">8fH", *range(8), 5))
    words = (command, path, "--invalid", "mask", "-o", out, "--format")
    assert mip(*words, "jsonl")[0] == 0
    rows = [{k.partition("_data.")[2]: v for k, v in json.loads(x).items()} for x in out.read_text().splitlines()]
    assert mip(*words, "mcap")[0] == 0
    found = [json.loads(one.data) for _, c, one in mcap(out) if "timestamp" not in c.topic]
    assert found == [{"roll": 1, "pitch": 2, "yaw": 3, "valid_flags": 1}, {"valid_flags": 0}, found[2]]
    assert found[2] == {"velocity": {"north": 0, "east": 1, "down": 2}, "ground_speed": 4, "valid_flags": 5}
    assert [sum(k.startswith("euler_angles.") for k in row) for row in rows] == [4, 1, 0]


@heavy("mcap")
@pytest.mark.parametrize("command", ["export", "stream"])
def test_names_of_mcap_are_those_of_the_device(command: str, tmp_path: Path) -> None:
    """Bit 12 has another meaning while the filter of a 3DM-GX5 initializes; state 2 has another name on a 3DM-CV7."""
    stamp = (0xD3, shared.GpsTimestamp(5.0, 2300, shared.GpsTimestampFlags(3)).encode())
    status = [(0x10, struct.pack(">3H", state, 1, 0x1000)) for state in (1, 2)]
    (tmp_path / "log").write_bytes(b"".join(packet(0x82, stamp, each) for each in status))
    form = [] if command == "export" else ["--format", "mcap"]
    for device, *wanted in (
        ("3dm-gx5-25", ("init", ["init_no_attitude"]), ("run_solution_valid", ["run_mag_bias_est_high_warning"])),
        ("3dm-cv7-ahrs", *((name, ["filter_condition=0", "solution_error=1"]) for name in ("init", "vertical_gyro"))),
    ):
        out = tmp_path / f"{device}.mcap"
        assert mip(command, tmp_path / "log", *form, "--names", "--device", device, "-o", out)[0] == 0
        found = [json.loads(one.data) for _, c, one in mcap(out) if c.topic == "/mip/filter_data/status"]
        assert [(x["filter_state"], x["status_flags"]) for x in found] == wanted


@heavy("rosbags")
def test_a_bag_leaves_no_values_out(tmp_path: Path) -> None:
    (tmp_path / "log").write_bytes(log(0.5))
    words = ("export", tmp_path / "log", "--format", "ros2", "-o", tmp_path / "bag", "--invalid", "mask")
    code, _, error = mip(*words)
    assert code == 2 and "--invalid mask leaves values out, which standard messages cannot do" in error


@heavy("rosbags")
def test_a_bag(tmp_path: Path) -> None:
    from rosbags.rosbag2 import Reader
    from rosbags.typesys import Stores, get_typestore

    device = VirtualDevice(DEVICE)
    (tmp_path / "log").write_bytes(sent(device, streaming(device, NAVIGATION), 4))
    words = ("export", tmp_path / "log", "--format", "ros2", "-o", tmp_path / "drive")
    assert mip(*words) == (0, "", "")
    store = get_typestore(Stores.ROS2_HUMBLE)
    found: dict[str, list[Any]] = {}
    with Reader(tmp_path / "drive") as bag:
        for connection, time, data in bag.messages():
            one = store.deserialize_cdr(data, connection.msgtype)
            stamp = one.header.stamp
            assert stamp.sec * 10**9 + stamp.nanosec == time
            found.setdefault(connection.topic, []).append(one)
    raw, imu = read_log(tmp_path / "log")["sensor.scaled_accel"]["scaled_accel"], found["/imu/data"]
    assert len(raw) == len(imu) == 400
    for (x, y, z), b in zip(raw.tolist(), imu):
        force = b.linear_acceleration
        assert (force.x, force.y, force.z) == pytest.approx((9.80665 * x, -9.80665 * y, -9.80665 * z))
    turned = [one for one in imu if one.orientation_covariance[0] != -1]
    assert len(turned) == len(read_log(tmp_path / "log")["filter_data.attitude_quaternion"]) > 30
    assert {one.orientation.w for one in turned} <= {x.pose.pose.orientation.w for x in found["/filter/odometry"]}
    assert imu[0].linear_acceleration.z == pytest.approx(9.81, abs=0.1)
    assert len(found["/imu/mag"]) == 400 and abs(found["/imu/mag"][0].magnetic_field.x) < 1e-4
    fix = found["/gnss_1/fix"][0]
    assert (fix.latitude, fix.longitude) == pytest.approx((47, 8), abs=1e-4) and fix.position_covariance[8] == 2.25
    odometry = found["/filter/odometry"][-1]
    assert odometry.pose.covariance[0] > 0 and odometry.header.frame_id == "odom"
    assert odometry.child_frame_id == imu[0].header.frame_id
    reference = found["/time_reference"][0]
    assert reference.time_ref.sec == reference.header.stamp.sec and reference.source == "gps"
    assert mip(*words)[0] == 1  # it exists


HALF = math.sqrt(0.5)


@heavy("rosbags")
@pytest.mark.parametrize(
    "attitude, wanted",
    [
        ((1, 0, 0, 0), (HALF, 0, 0, HALF)),  # level, to the north, which is at 90 degrees in REP 103
        ((HALF, 0, 0, HALF), (1, 0, 0, 0)),  # to the east
        ((0, 0, 0, 1), (HALF, 0, 0, -HALF)),  # to the south
        ((HALF, HALF, 0, 0), (0.5, 0.5, 0.5, 0.5)),  # on its left side, to the north
    ],
)
def test_the_orientation_of_the_filter_by_time(attitude: Any, wanted: Any, tmp_path: Path) -> None:
    """Attitudes are in other packets, at half the rate, before or after those of the same time; some are not valid."""
    from rosbags.rosbag2 import Reader

    packets = []
    for i in range(40):
        stamp = (0xD5, struct.pack(">Q", 5 * 10**9 + i * 10**7))
        own = [packet(0x80, stamp, (0x04, struct.pack(">3f", 0, 0, -1)), (0x05, struct.pack(">3f", 0.1, 0.2, 0.3)),
            (0x0A, struct.pack(">4f", 1, 0, 0, 0)))]  # fmt: skip
        if i % 2 == 0:
            uncertainty = (0x0A, struct.pack(">3fH", 0.1, 0.2, 0.3, 1))
            filtered = packet(0x82, stamp, uncertainty, (0x03, struct.pack(">4fH", *attitude, i != 10)))
            own.insert(i % 4 // 2, filtered)
        packets += own
    (tmp_path / "log").write_bytes(b"".join(packets))
    code, _, _ = mip("export", tmp_path / "log", "--format", "ros2", "-o", tmp_path / "bag")
    assert code == 0
    store, found = Types().store, {}
    with Reader(tmp_path / "bag") as bag:
        for connection, time, data in bag.messages():
            found.setdefault(connection.topic, []).append((time, store.deserialize_cdr(data, connection.msgtype)))
    assert {topic: len(messages) for topic, messages in found.items()} == {
        "/imu/data": 40,
        "/imu/complementary_filter": 40,
    }
    for i, (time, one) in enumerate(found["/imu/data"]):
        assert time == 5 * 10**9 + i * 10**7 == one.header.stamp.sec * 10**9 + one.header.stamp.nanosec
        q, rate, force = one.orientation, one.angular_velocity, one.linear_acceleration
        assert (rate.x, rate.y, rate.z) == pytest.approx((0.1, -0.2, -0.3))
        assert (force.x, force.y, force.z) == pytest.approx((0, 0, 9.80665))
        if i % 2 or i == 10:
            assert one.orientation_covariance[0] == -1
        else:
            assert (q.w, q.x, q.y, q.z) == pytest.approx(wanted, abs=1e-6)
            assert list(one.orientation_covariance[::4]) == pytest.approx([0.01, 0.04, 0.09])
    for _, one in found["/imu/complementary_filter"]:
        assert (one.orientation.w, one.orientation.z) == pytest.approx((HALF, HALF))
        assert not one.orientation_covariance.any()


@heavy("rosbags")
@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("whole", [True, False])
def test_a_bag_is_the_same_however_the_log_is_divided(
    whole: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    device = VirtualDevice(DEVICE)
    (tmp_path / "log").write_bytes(sent(device, streaming(device, NAVIGATION), 2) if whole else drawn(1, 400))
    bags = []
    for part in (messages.PART, 3000):
        monkeypatch.setattr(messages, "PART", part)
        bag = tmp_path / str(part) / "drive"
        assert mip("export", tmp_path / "log", "--format", "ros2", "-o", bag) == (0, "", "")
        bags.append({path.name: path.read_bytes() for path in bag.iterdir()})
    assert bags[0] == bags[1] and len(bags[0]["drive.mcap"]) > 10_000


# --------------------------------------------------------------------------- axes


def rotated(q: axes.Quaternion, v: axes.Vector) -> list[float]:
    return [sum(row[i] * v[i] for i in range(3)) for row in axes.rotation_matrix(q)]


@heavy("rosbags")
@pytest.mark.parametrize("week", [3029, 6000])
def test_a_time_that_messages_cannot_have(week: int, tmp_path: Path) -> None:
    path = tmp_path / "log.bin"
    packets = []
    for number in (2296, week):
        stamped = PacketBuilder(0x80).add(0xD3, shared.GpsTimestamp(5.0, number, shared.GpsTimestampFlags(3)).encode())
        packets.append(bytes(stamped.add(0x04, bytes(12)).build()))
    path.write_bytes(b"".join(packets))
    status, out, said = mip("export", path, "--format", "ros2", "-o", tmp_path / "bag")
    assert (status, out) == (1, "") and not (tmp_path / "bag").exists()
    assert said.startswith(f"mip export: {path}: packet 1 has the time ") and "2038-01-19T03:14:07.000Z" in said
    assert mip("export", path, "--format", "mcap", "-o", tmp_path / "log.mcap") == (0, "", "")


def test_attitudes_of_rep_103() -> None:
    assert axes.attitude((1, 0, 0, 0)) == pytest.approx((HALF, 0, 0, HALF))  # north is at +90 degrees
    assert axes.attitude((HALF, 0, 0, HALF)) == pytest.approx((1, 0, 0, 0))  # east is at 0
    generator = random.Random(1)
    for _ in range(100):
        numbers = [generator.gauss(0, 1) for _ in range(4)]
        length = math.hypot(*numbers)
        w, x, y, z = (v / length for v in numbers)
        v = (generator.gauss(0, 1), generator.gauss(0, 1), generator.gauss(0, 1))
        # A vector of the body, turned into the world in both conventions.
        ned = rotated((w, x, y, z), v)
        assert rotated(axes.attitude((w, x, y, z)), axes.body(v)) == pytest.approx(axes.world(ned), abs=1e-9)
        assert axes.into_body(axes.attitude((w, x, y, z)), axes.world(ned)) == pytest.approx(axes.body(v), abs=1e-9)


def test_odometry_while_it_moves() -> None:
    """Heading east: positions, velocities in the body, and covariances turned with it."""
    converter = standard.Converter()

    def at(longitude: float, *others: Any) -> dict[str, list[Any]]:
        values = (
            filter_data.LlhPosition(47.0, longitude, 500.0, 1),
            filter_data.AttitudeQuaternion((HALF, 0, 0, HALF), 1),  # heads east
            filter_data.NedVelocity(0.0, 5.0, 1.0, 1),
            *others,
        )
        builder = PacketBuilder(0x82)
        for field in values:
            builder.add(field.DESCRIPTOR, field.encode())
        log = read_log(bytes(builder.build()))
        kinds = [occurrence_in(0x82, type(field)) for field in values]
        found = standard.message_fields(log, kinds, lambda column: np.ones(len(column), bool), "device")
        (made,) = converter.messages(found)
        assert made.topic == "/filter/odometry"
        return {path: values[0].tolist() for path, values in made.values.items()}

    first = at(8.0, filter_data.NedVelocityUncertainty(0.1, 0.2, 0.3, 1))
    second = at(8.0001)
    assert [first[f"pose.pose.position.{v}"] for v in "xyz"] == pytest.approx([0, 0, 0])
    assert [second[f"pose.pose.position.{v}"] for v in "xyz"] == pytest.approx([7.604, 0, 0], abs=0.01)
    assert [second[f"twist.twist.linear.{v}"] for v in "xyz"] == pytest.approx([5, 0, -1], abs=1e-6)
    for covariance in (first["twist.covariance"], second["twist.covariance"]):  # of the last uncertainty
        assert [covariance[0], covariance[7], covariance[14]] == pytest.approx([0.04, 0.01, 0.09])

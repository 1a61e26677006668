"""NMEA sentences: framing and checksums, and contents that agree with the data fields."""

from __future__ import annotations

from datetime import datetime
from math import degrees, dist, hypot, isclose
from typing import Any

import pytest
from mip_protocol import mip_3dm
from mip_protocol.types import NmeaMessage, NmeaMessageId, NmeaTalkerId
from mip_simulator import VirtualDevice
from mip_simulator.motion import Circle, Standing
from mip_simulator.streams import nmea
from mip_tools.sentences import nmea_checksum
from simulated import Host, Shown

SENSOR, FILTER, GNSS_1, GNSS_2 = 0x80, 0x82, 0x91, 0x92
FREE = {"GGA", "GLL", "RMC", "VTG", "HDT", "GST"}  # of any source but the sensor
KNOT = 0.514444


def said(shown: Shown, name: str, source: int = GNSS_1, talker: int = NmeaTalkerId.GNSS) -> list[list[str]]:
    """The fields of the sentences; their framing is checked."""
    entry = NmeaMessage(NmeaMessageId[name], NmeaTalkerId(talker), source, 1)
    text = nmea.compose_sentences([entry], shown.world).decode("ascii")
    assert not text or text.endswith("\r\n")
    found = []
    for line in text.split("\r\n")[:-1]:
        assert line[0] == "$" and line[-3] == "*" and len(line) <= 80, line
        check = 0
        for c in line[1:-3]:
            check ^= ord(c)
        assert f"{check:02X}" == line[-2:], line
        found.append(line[1:-3].split(","))
    return found


def one(*arguments: Any) -> list[str]:
    (found,) = said(*arguments)
    return found


@pytest.fixture(params=[(47.0, 8.0), (-33.9, -151.2), (0.00001, 0.00001)])
def shown(request: pytest.FixtureRequest) -> Shown:
    return Shown(Circle(30, 9, *request.param)).at(1234.567)


def place(latitude: str, ns: str, longitude: str, ew: str) -> tuple[float, float]:
    assert len(latitude) == 10 and len(longitude) == 11, "ddmm.mmmmm and dddmm.mmmmm"
    north = int(latitude[:2]) + float(latitude[2:]) / 60
    east = int(longitude[:3]) + float(longitude[3:]) / 60
    return north * {"N": 1, "S": -1}[ns], east * {"E": 1, "W": -1}[ew]


def fix(shown: Shown, source: int) -> tuple[Any, tuple[float, float, float]]:
    """Position and velocity as the data fields show them."""
    name = {FILTER: "filter_data", GNSS_1: "gnss_1", GNSS_2: "gnss_2"}[source]
    v = shown(f"{name}.ned_velocity")
    return shown(f"{name}.llh_position"), (v.north, v.east, v.down) if source == FILTER else v.velocity


@pytest.mark.parametrize("source", [FILTER, GNSS_1, GNSS_2])
def test_position_velocity_and_time(shown: Shown, source: int) -> None:
    """The position to 2 cm, which is one unit of the last decimal of a minute."""
    p, (north, east, _down) = fix(shown, source)
    speed = hypot(north, east)
    utc = datetime(2024, 1, 7, 0, 20, 16, 560_000)
    gga, gll, rmc, vtg = (one(shown, name, source) for name in ("GGA", "GLL", "RMC", "VTG"))
    for time in (gga[1], gll[5], rmc[1]):
        assert time == f"{utc:%H%M%S}.56"
    for numbers in (gga[2:6], gll[1:5], rmc[3:7]):
        assert dist(place(*numbers), (p.latitude, p.longitude)) < 1.8e-7
    assert gga[6] == "1" and int(gga[7]) == shown("gnss_1.fix_info").num_sv
    assert isclose(float(gga[8]), shown("gnss_1.dop").hdop, abs_tol=0.006)
    assert isclose(float(gga[9]) + float(gga[11]), p.ellipsoid_height, abs_tol=0.006) and gga[10] == gga[12] == "M"
    assert rmc[2] == "A" and rmc[9] == f"{utc:%d%m%y}" and rmc[12] == gll[7] == vtg[9] == "A"
    assert isclose(float(rmc[7]) * KNOT, speed, abs_tol=0.001) and isclose(float(vtg[7]) / 3.6, speed, abs_tol=0.001)
    assert rmc[7] == vtg[5] and rmc[8] == vtg[1] and vtg[2:9:2] == ["T", "M", "N", "K"]
    v = shown("gnss_1.ned_velocity" if source == GNSS_1 else "gnss_2.ned_velocity")
    if source != FILTER:
        assert isclose(float(rmc[8]), v.heading, abs_tol=0.006)
    declination = degrees(shown("filter_data.magnetic_model").declination)
    assert isclose(float(rmc[10]) * {"E": 1, "W": -1}[rmc[11]], declination, abs_tol=0.06)
    assert isclose((float(vtg[1]) - float(vtg[3]) - declination + 180) % 360, 180, abs_tol=0.02)


def test_heading_and_angles(shown: Shown) -> None:
    e = shown("filter_data.euler_angles")
    for source in (FILTER, GNSS_1):
        hdt = one(shown, "HDT", source)
        assert isclose(float(hdt[1]), degrees(e.yaw) % 360, abs_tol=0.006) and hdt[2] == "T"
    angles = one(shown, "MSRA", FILTER, NmeaTalkerId.IGNORED)
    assert angles[0] == "PMSRA" and angles[1] == "002016.56" and all(len(x.partition(".")[2]) == 3 for x in angles[2:])
    assert dist([float(x) for x in angles[2:]], [degrees(x) for x in (e.roll, e.pitch, e.yaw)]) < 0.001


def test_acceleration_and_rate(shown: Shown) -> None:
    found = one(shown, "MSRR", SENSOR, NmeaTalkerId.IGNORED)
    assert found[0] == "PMSRR" and all(len(x.partition(".")[2]) == 6 for x in found[2:])
    assert dist([float(x) for x in found[2:5]], shown("sensor.scaled_accel").scaled_accel) < 2e-6
    rates = [degrees(x) for x in shown("sensor.scaled_gyro").scaled_gyro]
    assert dist([float(x) for x in found[5:]], rates) < 1e-5


def test_time_and_date(shown: Shown) -> None:
    assert one(shown, "ZDA") == ["GNZDA", "002016.56", "07", "01", "2024", "00", "00"]


def test_errors_of_the_position(shown: Shown) -> None:
    p = shown("gnss_1.llh_position")
    gst = [float(x) for x in one(shown, "GST")[2:]]
    assert isclose(hypot(gst[4], gst[5]), p.horizontal_accuracy, rel_tol=0.01) and gst[6] == p.vertical_accuracy
    u = shown("filter_data.llh_position_uncertainty")
    assert [float(x) for x in one(shown, "GST", FILTER)[6:]] == pytest.approx([u.north, u.east, u.down], abs=0.0051)


def test_satellites_in_view(shown: Shown) -> None:
    """All satellites, by constellation, at most four in a sentence; GLONASS numbers begin at 65."""
    talkers = {"GP": (1, 0), "GL": (2, 64), "GA": (3, 0), "GB": (4, 0)}
    lines = said(shown, "GSV", GNSS_1, NmeaTalkerId.IGNORED)
    wanted = {(s.gnss_id, s.satellite_id): s for s in shown.all("gnss_1.satellite_status")}
    seen = {}
    for talker, (constellation, offset) in talkers.items():
        own = [line for line in lines if line[0] == f"{talker}GSV"]
        assert [(int(x[1]), int(x[2])) for x in own] == [(len(own), i) for i in range(1, len(own) + 1)]
        count = sum(1 for number, _ in wanted if number == constellation)
        for line in own:
            assert int(line[3]) == count and len(line) in (8, 12, 16, 20)
            for i in range(4, len(line), 4):
                seen[constellation, int(line[i]) - offset] = [int(x) for x in line[i + 1 : i + 4]]
    assert seen.keys() == wanted.keys()
    for key, (elevation, azimuth, strength) in seen.items():
        s = wanted[key]
        assert abs(elevation - s.elevation) <= 0.5 and abs((azimuth - s.azimuth + 180) % 360 - 180) <= 0.5
        assert 35 <= strength <= 50


def test_without_reception() -> None:
    shown = Shown(Standing()).at(1)
    assert one(shown, "GGA", FILTER)[6] == "1"
    shown.world.gnss = False
    shown.at(2)
    assert not any(said(shown, name) for name in (*FREE - {"HDT"}, "ZDA")), "the data is not valid"
    lines = said(shown, "GSV", GNSS_1, NmeaTalkerId.IGNORED)
    assert lines == [[f"{talker}GSV", "1", "1", "00"] for talker in ("GP", "GL", "GA", "GB")]
    # The filter goes on from the last position, and the clock of the device runs.
    gga, gll, rmc, vtg = (one(shown, name, FILTER) for name in ("GGA", "GLL", "RMC", "VTG"))
    assert gga[6] == "6" and gga[1] and gga[2] and rmc[2] == gll[6] == "A" and rmc[9]
    assert gll[7] == rmc[12] == vtg[9] == "E"
    shown.world.filter.reset()
    shown.at(2.5)
    assert not any(said(shown, name, FILTER) for name in (*FREE, "MSRA"))
    # It has no position if it never had reception.
    device = VirtualDevice("3dm-cv7-gnss-ins", sync=False)
    device.advance(2)
    entry = NmeaMessage(NmeaMessageId.RMC, NmeaTalkerId.GNSS, FILTER, 1)
    assert nmea.compose_sentences([entry], device.world) == b""


def test_with_corrections() -> None:
    shown = Shown(Standing()).at(1)
    shown.world.corrected = shown.world.now
    gga, gll, rmc, vtg = (one(shown, name) for name in ("GGA", "GLL", "RMC", "VTG"))
    assert (gga[6], gll[7], rmc[12], vtg[9]) == ("4", "D", "R", "D")


@pytest.mark.parametrize("talker, letters", {"GNSS": "GN", "GPS": "GP", "GALILEO": "GA", "GLONASS": "GL"}.items())
def test_talkers(talker: str, letters: str) -> None:
    shown = Shown(Standing()).at(1)
    for name in (*FREE, "ZDA"):
        assert one(shown, name, GNSS_2, NmeaTalkerId[talker])[0] == letters + name


def test_what_there_is() -> None:
    """The sentences of each source, as the manual lists them."""
    sources = {
        SENSOR: {"MSRR"},
        FILTER: FREE | {"MSRA"},
        GNSS_1: FREE | {"GSV", "ZDA"},
        GNSS_2: FREE | {"GSV", "ZDA"},
        0x81: FREE | {"GSV", "ZDA"},
        0xA0: set(),
    }
    for source, names in sources.items():
        for message in NmeaMessageId:
            entry = NmeaMessage(message, NmeaTalkerId.GNSS, source, 1)
            assert nmea.is_supported(entry) == (message.name in names), (message, source)
    unknown = NmeaMessage(NmeaMessageId(99), NmeaTalkerId.GPS, GNSS_1, 1)
    assert not nmea.is_supported(unknown) and nmea.compose_sentences([unknown], Shown(Standing()).world) == b""
    for talker in (NmeaTalkerId.IGNORED, NmeaTalkerId(77)):
        assert not nmea.is_supported(NmeaMessage(NmeaMessageId.GGA, talker, GNSS_1, 1)), "GGA must name its talker"
        assert nmea.is_supported(NmeaMessage(NmeaMessageId.GSV, talker, GNSS_1, 1))


def test_the_rate_of_a_sentence_is_limited() -> None:
    """To 10 Hz of the filter and 2 Hz of a receiver."""
    host = Host(VirtualDevice("3dm-cv7-gnss-ins"))
    for name, source, most in (("GGA", FILTER, 10), ("HDT", GNSS_1, 2)):
        decimation = -(-host.ok(mip_3dm.GetBaseRate(source)).rate // most)
        entries = [NmeaMessage(NmeaMessageId[name], NmeaTalkerId.GNSS, source, d) for d in (decimation - 1, decimation)]
        assert host.refused(mip_3dm.NmeaMessageFormat.write(entries[:1])) == 3
        host.ok(mip_3dm.NmeaMessageFormat.write(entries[1:]))


def test_the_checksums_of_the_manual() -> None:
    assert nmea_checksum("PMSRA,221336.93,-0.172,-0.681,3.072") == "5D"
    assert nmea_checksum("PMSRR,221336.93,-0.012996,0.004631,-1.000471,0.280331,0.130576,0.207637") == "4D"

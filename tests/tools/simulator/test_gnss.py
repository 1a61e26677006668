"""GNSS data: satellites, ephemerides and raw measurements lead to the position that the receiver shows."""

from __future__ import annotations

from math import hypot, isclose

import pytest
from mip_simulator.motion import Standing
from simulated_world import Shown


def test_dilution_of_precision() -> None:
    """The parts add up."""
    d = Shown(Standing())("gnss_1.dop")
    for whole, parts in (("gdop", ("pdop", "tdop")), ("pdop", ("hdop", "vdop")), ("hdop", ("ndop", "edop"))):
        assert isclose(getattr(d, whole), hypot(*(getattr(d, part) for part in parts)), rel_tol=1e-2)


def test_satellites_are_numbered() -> None:
    shown = Shown(Standing())
    status = shown.all("gnss_1.satellite_status")
    assert [s.index for s in status] == list(range(1, 21)) and {s.count for s in status} == {20}
    assert shown("gnss_1.fix_info").num_sv == 20 and len(shown.all("gnss_2.raw")) == 20
    shown.world.gnss = False
    assert shown.all("gnss_1.satellite_status") == [] and shown("gnss_1.fix_info").num_sv == 0


def test_the_receiver_clock_swings() -> None:
    """Its drift is the rate of its bias; a year later it is no farther away."""
    shown = Shown(Standing())
    for t in (1.0, 40_000.0, 365 * 86_400.0 + 3):
        a, b = (shown.at(t + d)("gnss_1.clock_info_2") for d in (-50, 50))
        drift = shown.at(t)("gnss_1.clock_info_2").drift
        assert isclose((b.bias - a.bias) / 100, drift, abs_tol=1e-13) and abs(a.bias) <= 1e-4
    assert shown("gnss_2.clock_info_2").bias != shown("gnss_1.clock_info_2").bias
    corrections = shown.all("filter_data.clock_correction")
    assert [c.receiver_id for c in corrections] == [1, 2]
    assert [c.bias for c in corrections] == pytest.approx(
        [shown(f"gnss_{i}.clock_info_2").bias for i in (1, 2)], rel=1e-6
    )

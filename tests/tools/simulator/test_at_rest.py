"""The simulated device, level and at rest, shows the values that the specification states for this."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import astuple, is_dataclass
from typing import Any

import pytest
from mip_simulator.motion import Standing
from mipgen import model as m
from simulated_world import Shown
from support import model


def stated() -> Iterator[tuple[str, m.Field, m.Parameter]]:
    for f in model("real").fields:
        for p in f.parameters:
            if p.at_rest and f.role == m.DATA:
                yield f"{f.name_in(f.sets[-1])}.{p.name}", f, p


def numbers(value: Any) -> list[float]:
    """The elements of a vector, or the number."""
    if isinstance(value, (int, float)):
        return [value]
    return list(astuple(value)) if is_dataclass(value) and not isinstance(value, type) else list(value)


@pytest.mark.parametrize("heading", [0.0, 60.0, -150.0])
def test_what_a_level_device_at_rest_shows(heading: float) -> None:
    """To half a percent, as gravity depends on the place."""
    shown, wrong = Shown(Standing(heading=heading)).at(20.0), []
    for name, f, p in stated():
        set_name = name.split(".")[0]
        value = numbers(getattr(shown(f"{set_name}.{f.name}"), p.name))
        for element, got, want in zip(p.elements or ("",), value, p.at_rest, strict=True):
            if want is not None and abs(got - want) > 0.005 * max(abs(want), 0.02):
                wrong.append(f"{name}.{element}: {got:g}, stated {want}")
    assert not wrong, "\n".join(wrong)


def test_physical_quantities_state_it() -> None:
    found = {name for name, _, _ in stated()}
    assert found >= {
        "sensor.scaled_accel.scaled_accel", "sensor.scaled_gyro.scaled_gyro", "filter_data.comp_accel.accel",
        "filter_data.gravity_vector.gravity", "filter_data.euler_angles.roll", "filter_data.attitude_dcm.dcm",
    }  # fmt: skip


@pytest.mark.parametrize(
    ("motion", "name", "sign"),
    [
        (Standing(roll=10), "roll", 1), (Standing(pitch=10), "pitch", 1), (Standing(heading=10), "yaw", 1),
    ],
)  # fmt: skip
def test_signs_of_angles_are_those_of_the_axes(motion: Standing, name: str, sign: int) -> None:
    """Right side down, nose up, clockwise: gravity, which points down, shows itself on y and z, or x and z."""
    shown = Shown(motion).at(20.0)
    angles, gravity = shown("filter_data.euler_angles"), numbers(shown("filter_data.gravity_vector").gravity)
    assert getattr(angles, name) * sign == pytest.approx(0.17453, abs=1e-3)
    x, y, _ = gravity
    assert (y > 1) == (name == "roll") and (x < -1) == (name == "pitch")

"""The bandwidth of streams in Chromium, from disk, against the formula of the manuals."""

from __future__ import annotations

import math
import random

import browser
import pytest
from mipgen import model as m
from support import heavy, model

pytestmark = heavy("Chromium")
TOOL = "bandwidth"


def baud(streams: dict[str, list[tuple[m.Field, float]]]) -> float:
    """10 * (6 * F + sum of S * f) for each set, as the notes of the protocol say."""
    return sum(
        10 * (6 * max(rate for _, rate in fields) + sum((f.max_size + 2) * rate for f, rate in fields))
        for fields in streams.values()
    )


@pytest.mark.parametrize("device", [d.id for d in model("real").devices if d.base_rates])
def test_base_rates(page: browser.Page, device: str) -> None:
    """A rate of 0 is known: such a set is sent as it arrives."""
    page.run(f"choose({device!r}, [])")
    d = model("real").device(device)
    assert d is not None
    known = {r.set.name: f"base rate {r.hertz:g} Hz" if r.hertz else "sent as it arrives" for r in d.base_rates}
    sets = "[...document.querySelectorAll('[data-set]')]"
    shown = page.run(f"Object.fromEntries({sets}.map((one) => [one.dataset.set, one.firstChild.textContent]))")
    assert shown
    for name, text in shown.items():
        assert text.rpartition(", ")[2] == known.get(name, "base rate not known")


@pytest.mark.parametrize("device", [d.id for d in model("real").devices if d.base_rates and d.ports])
def test_random_streams(page: browser.Page, device: str) -> None:
    of, chance = model("real"), random.Random(device)
    d = of.device(device)
    assert d is not None
    bases = {r.set.name: r.hertz for r in d.base_rates}
    for _ in range(5):
        data = [s for s in d.supports if s.field.role == m.DATA]
        places = [(s.name.partition(".")[0], s.field) for s in data if s.set != m.SHARED_SET]
        sets = sorted({name for name, _ in places})
        places += [(name, s.field) for s in data if s.set == m.SHARED_SET for name in sets]
        streams: dict[str, list[tuple[m.Field, float]]] = {}
        wanted = []
        for name, f in chance.sample(places, min(4, len(places))):
            number = chance.choice([1, 2, 5, 10, 100])
            base = bases.get(name) or None
            rate = base / number if base else number
            streams.setdefault(name, []).append((f, rate))
            wanted.append([name, f.full_name, rate])
        found = page.run(f"choose({device!r}, {wanted})")
        need = baud(streams)
        assert found["need"].endswith(f"at least {math.ceil(round(need, 6))} Bd.")
        for port in d.ports:
            enough = [r for r in port.baud_rates if r >= need]
            none = "no baud rate" if port.name.startswith("USB") else "not known"
            none = "none of its baud rates is sufficient" if port.baud_rates else none
            assert found["ports"][port.name] == (str(min(enough)) if enough else none)


def test_an_incomplete_profile_has_everything(page: browser.Page) -> None:
    """The device may have what its sources do not mention: it is offered, and marked."""
    assert page.run("choose('3dm-dh3', [['sensor', 'sensor.scaled_accel', 10]])")["need"]
    row = 'document.querySelector(\'[data-set="{}"] [data-field="{}"] label\').textContent'
    assert page.run(row.format("sensor", "sensor.scaled_accel")).endswith("(not known)")
    assert "is incomplete: No manual is known." in page.run("text('#tool')")
    page.run("choose('3dm-gx5-35', [])")
    of = model("real").device("3dm-gx5-35")
    assert of is not None and of.incomplete
    for s in of.supports:
        if s.name.startswith("sensor.") and s.field.role == m.DATA:
            assert page.run(row.format("sensor", s.field.full_name)).endswith(("(likely)", "(assumed)")) != s.certain


@pytest.mark.parametrize("rate", ["", "0", "-5", "2000"])
def test_a_rate_that_the_device_cannot_send(page: browser.Page, rate: str) -> None:
    """The page says so, and counts no other rate instead."""
    chosen = page.run(f"choose('3dm-gx5-15', [['sensor', 'sensor.scaled_accel', {rate!r}]])")
    assert chosen == {"need": None, "ports": {}}
    said = "Scaled accel needs a rate above 0 Hz and up to 1000 Hz."
    assert page.run("text('.mip-output')") == said
    assert page.run("text('.mip-rate.mip-wrong')") == "a rate above 0 Hz and up to 1000 Hz"


def test_the_nearest_rate_is_what_counts(page: browser.Page) -> None:
    """Devices divide the base rate by whole numbers."""
    found = page.run("choose('3dm-gx5-15', [['sensor', 'sensor.scaled_accel', 300]])")
    assert page.run("text('tr:has(:checked) .mip-rate')") == "333.333 Hz, the nearest (decimation 3)"
    assert found["need"].startswith(f"{math.ceil(20 * 1000 / 3)} bytes/s")


def test_another_device_keeps_what_it_has(page: browser.Page) -> None:
    """The rates of the fields are kept, and come back. That a link opens the same is in test_pages.py."""
    page.run("choose('3dm-gx5-15', [['sensor', 'sensor.scaled_accel', 10], ['sensor', 'sensor.up_vector', 5]])")
    change = (
        "put('select', '%s'); Object.fromEntries([...document.querySelectorAll('[data-set=sensor] tr:has(:checked)')]"
        ".map((row) => [row.dataset.field, row.querySelector('.mip-rate').textContent]))"
    )
    of = model("real").device("3dm-cv7-gnss-ins")
    assert of is not None and "sensor.up_vector" not in {s.field.full_name for s in of.supports}
    first = page.run(change % "3dm-gx5-15")
    assert set(first) == {"sensor.scaled_accel", "sensor.up_vector"}
    second = page.run(change % "3dm-cv7-gnss-ins")
    assert second == {"sensor.scaled_accel": first["sensor.scaled_accel"]}
    assert page.run(change % "3dm-gx5-15") == first
    anything = page.run(change % "")
    assert {name: rate.partition(" (")[0] for name, rate in first.items()} == anything

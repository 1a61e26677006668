"""The core and some layouts are proved, and the proofs see planted bugs."""

from __future__ import annotations

import random

import proofs
import pytest
from support import SEED, heavy, rounds

DRAWN = random.Random(SEED)


def cbmc() -> str:
    found = proofs.prover()
    assert found, "cbmc is missing; `make prove` says how to get it"
    return found


@heavy("CBMC")
@pytest.mark.parametrize("proof", [*proofs.core()], ids=lambda p: p.name)
def test_the_core_is_proved(proof: proofs.Proof) -> None:
    assert proofs.prove(proof, cbmc(), 180).outcome == "proved"  # seconds; enough for a slow machine


@heavy("CBMC")
def test_nothing_refutes_layouts() -> None:
    """Drawn by the seed. A proof that would need more time refutes nothing."""
    drawn = DRAWN.sample([*proofs.layouts()], rounds(10, 40))
    outcomes = {p.name: proofs.prove(p, cbmc(), 8).outcome for p in drawn}
    assert "refuted" not in outcomes.values(), outcomes
    assert "proved" in outcomes.values(), outcomes


@heavy("CBMC")
def test_planted_bugs_are_seen() -> None:
    for number in DRAWN.sample(range(len(proofs.PLANTS)), rounds(3, len(proofs.PLANTS))):
        assert proofs.planted(number, cbmc()).outcome == "refuted", proofs.PLANTS[number]


def test_what_is_planted_is_there() -> None:
    assert f"{len(proofs.PLANTS)} bugs are planted" in proofs.TABLE.read_text("utf-8")
    names = {p.name for p in (*proofs.core(), *proofs.layouts())}
    for file, old, _, name in proofs.PLANTS:
        assert old in (proofs.SOURCES / "mip" / file).read_text("utf-8"), file
        assert name in names

"""The core is proved, and the proofs see planted bugs."""

from __future__ import annotations

import random
from pathlib import Path

import proofs
import pytest
from c_build import SANITIZED, archive, folder, include, run
from support import SEED, all_fields, heavy, model, need, rounds

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
def test_planted_bugs_are_seen() -> None:
    for number in DRAWN.sample(range(len(proofs.PLANTS)), rounds(3, len(proofs.PLANTS))):
        assert proofs.planted(number, cbmc()).outcome == "refuted", proofs.PLANTS[number]


def test_what_is_planted_is_there() -> None:
    names = {p.name for p in proofs.core()}
    for file, old, _, name in proofs.PLANTS:
        assert old in proofs.of_library(file).read_text("utf-8"), file
        assert name in names


# ----------------------------------------------------------------------------- well-formed codecs


def ill_formed(spec: str, out: Path, *also: str) -> list[str]:
    """What programs.c prints: names of ill-formed codecs, and the number of the others. `also`: sources that come
    before those of the library."""
    flags = [*SANITIZED, "-Wno-unused-function", include(spec)]
    run(need("cc"), *flags, proofs.HERE / "programs.c", *also, archive(spec, "cc", *SANITIZED), "-o", out)
    return run(out).splitlines()


@pytest.mark.parametrize("spec", ["real", "invented"])
def test_all_codecs_are_well_formed(spec: str, tmp_path: Path) -> None:
    """So that the proofs of codec.c and interpreter.c hold for them."""
    assert ill_formed(spec, tmp_path / "out") == [str(len([*all_fields(model(spec))]))]


#: Changes to the codecs of 3dm.c, and the layouts that are ill-formed then.
DAMAGED = [
    ("num_descriptors), 83, 3,\n                MIP_AT(struct mip_3dm_poll_imu_data", "84", "83", "poll_imu_data"),
    ("MIP_EACH(1, struct mip_3dm_poll_entry, 5, MIP_AT(struct mip_3dm_poll_gnss_data", " 6,", " 5,", "poll_gnss_data"),
    ("MIP_CASE(17, 0x02),\n    MIP_8_BITS(4, MIP_AT(struct mip_3dm_event_trigger_config, ", "16", "17",
     "event_trigger_config"),
    ("MIP_16_BITS(1, MIP_AT(struct mip_3dm_gnss_sbas_settings, included_prns", "S(2", "S(1", "gnss_sbas_settings"),
]  # fmt: skip


def test_ill_formed_codecs_are_found(tmp_path: Path) -> None:
    text = (folder("real") / "src/mip/sets/3dm.c").read_text("utf-8")
    for line, new, old, _ in DAMAGED:
        assert text.count(line) == 1, line
        text = text.replace(line, line.replace(old, new))
    source = tmp_path / "3dm.c"
    source.write_text(text, "utf-8")
    *found, well = ill_formed("real", tmp_path / "out", str(source))
    assert sorted(found) == sorted(f"{name} is not well-formed" for *_, name in DAMAGED)
    assert int(well) == len([*all_fields(model("real"))]) - len(DAMAGED)

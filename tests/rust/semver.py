"""`make semver`: what cargo-semver-checks says about the crate. The tool takes minutes to compile, so neither
`make test` nor `make test-all` demands it.

Each test makes two crates from the invented specification, with one change between them. To add something must be a
minor version, to remove it a major one: docs/versions.md promises it. If there is a release, the crate as it is now is
compared with that, and the version must have been raised far enough.
"""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from crates import WORK, without_dependencies
from mipgen import render, revisions
from mipgen.resolve import load_model
from support import ROOT, SPECS, locked, need

SET = """# yaml-language-server: $schema=../../../../spec/schema/set.schema.json
set: 0x84
name: extra
title: Extra
description: A set more.
fields:
  - data: 0x01
    name: one
    title: One
    description: A field.
    sources: [{manual: guide, section: Own, length: 3}]
    parameters: [{name: mode, type: mode, description: Of the set.}]
"""

DEVICE = """# yaml-language-server: $schema=../../../../spec/schema/device.schema.json
device: model-d
name: model_d
title: Model D
manual: guide
description: Another one.
supports: {tools: [ping]}
base_rates: {}
incomplete: [Its acknowledge codes are not known.]
"""

OWN = "parameters: [{name: mode, type: mode, description: Of the second sensor.}]\n"
FIELD = (SET.partition("fields:\n")[2]).replace("0x01", "0x08").replace("name: one", "name: another")

#: What is added -> the file, a text of it, and what comes in its place; a file that is new has no text.
ADDITIONS: dict[str, list[tuple[str, str, str]]] = {
    "field": [("sets/more.yaml", OWN, OWN + FIELD)],
    "set": [("sets/extra.yaml", "", SET)],
    "device": [("devices/model_d.yaml", "", DEVICE)],
    "value": [("types/types.yaml", "slow: {value: 2,", "idle: {value: 3, description: N.}\n      slow: {value: 2,")],
    "bit": [("types/types.yaml", "level: {bits: 4-6,", "cold: {bit: 2, description: C.}\n      level: {bits: 4-6,")],
    "alternative": [
        ("sets/tools.yaml", "solid: 1, striped: 2}", "solid: 1, striped: 2, dotted: 3}"),
        ("sets/tools.yaml", "striped: {type: stripes}}",
         "striped: {type: stripes}, dotted: {type: u8, description: D.}}"),
    ],
}  # fmt: skip

#: What is changed in the field that was added. The tool does not look at the types of members; `mipgen diff` does.
BREAKS = {
    "a parameter more": [
        ("length: 3", "length: 4"),
        ("Of the set.}]", "Of the set.}, {name: more, type: u8, description: Appended.}]"),
    ],
    "the name of a field": [("name: another", "name: other")],
    "the name of a parameter": [("name: mode", "name: state")],
}

#: Without those that bring dependencies.
FEATURES = ("--default-features", "--features", "std", "--features", "dynamic")


@cache
def made(name: str) -> Path:
    """The crate of the invented specification with a change."""
    spec = WORK / "semver" / "spec" / name
    with locked(WORK / "semver.made"):
        shutil.rmtree(spec, ignore_errors=True)
        shutil.copytree(SPECS["invented"][0], spec)
        broken = [("sets/more.yaml", old, new) for old, new in BREAKS.get(name, [])]
        for file, old, new in [*ADDITIONS.get("field" if broken else name, []), *broken]:
            text = (spec / file).read_text("utf-8") if old else ""
            at = text.rindex(old)
            (spec / file).write_text(text[:at] + new + text[at + len(old) :], "utf-8")
        folder = WORK / "semver" / name
        render.write(without_dependencies(render.render("rust", load_model(spec))), folder)
    return folder


def verdict(old: Path, new: Path, *arguments: str) -> tuple[bool, str]:
    """Is the new crate as compatible as the release type, or its version, says?"""
    command = [need("cargo"), "semver-checks", "--manifest-path", str(new / "Cargo.toml"), "--baseline-root", str(old)]
    with locked(WORK / "semver.run"):
        done = subprocess.run(
            [*command, "--color=never", *arguments],
            capture_output=True, text=True, cwd=new,
        )  # fmt: skip
    said = done.stdout + done.stderr
    assert "Checked [" in said, said[-4000:]
    return done.returncode == 0, said


@pytest.mark.parametrize("what", ADDITIONS)
def test_an_addition_is_minor(what: str) -> None:
    fits, said = verdict(made("none"), made(what), *FEATURES, "--release-type", "minor")
    assert fits, said


@pytest.mark.parametrize("what", ADDITIONS)
def test_a_removal_is_major(what: str) -> None:
    fits, said = verdict(made(what), made("none"), *FEATURES, "--release-type", "minor")
    assert not fits and "Summary semver requires new major version" in said, said


@pytest.mark.parametrize("what", BREAKS)
def test_other_changes_are_major(what: str) -> None:
    fits, said = verdict(made("field"), made(what), *FEATURES, "--release-type", "minor")
    assert not fits and "Summary semver requires new major version" in said, said


@pytest.fixture
def release(tmp_path: Path) -> Iterator[Path | None]:
    """The crate of the last release, if there is one."""
    tag = revisions.last_release(ROOT / "spec")
    if tag is None:
        yield None
        return
    with revisions.folder(tag, ROOT / "generated/rust") as folder:
        yield folder


def test_the_version_was_raised_far_enough(release: Path | None) -> None:
    if release is None:
        return  # nothing is released yet, so anything goes
    fits, said = verdict(release, ROOT / "generated/rust", "--all-features")
    assert fits, said

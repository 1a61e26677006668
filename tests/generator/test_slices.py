"""Files of an earlier run are kept only if nothing that was read for them has changed: see `emit.slices`."""

from __future__ import annotations

import random
import re
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from mipgen import model as m
from mipgen.base import reads
from mipgen.base.reads import Memo, kept
from mipgen.emit import discovery, output, render
from mipgen.emit.slices import NAMES, PLAN, Anew, Pieces, Slice, Slices, _plain
from mipgen.read.problems import SpecError
from mipgen.resolve.load import load_model
from support import SEED, SPECS, heavy, rounds

TARGETS = discovery.names()


class Runs:
    """Runs of the generator, one after the other, on a specification that is edited in between."""

    def __init__(self, spec: Path, folder: Path) -> None:
        self.spec = folder / "spec"
        self.out = folder / "out"
        shutil.copytree(spec, self.spec)
        self.made: dict[str, set[str]] = {}  # target -> the files that the last run made anew

    def run(self) -> m.Model:
        """Makes what is out of date since the last run."""
        model = load_model(self.spec)
        slices = Slices(model, self.out, "")
        for name in TARGETS:
            past = slices.of(name)
            assert isinstance(past, Slice)
            files = render.renew(discovery.built_in(name), model, past)
            output.write(files, self.out / name)
            self.made[name] = set(past.read)
        slices.keep()
        return model

    def check(self, model: m.Model) -> None:
        """A run that makes everything finds nothing to change."""
        for name in TARGETS:
            assert output.compare(render.render(name, model), self.out / name) == [], name

    def files(self, target: str) -> dict[str, bytes]:
        folder = self.out / target
        return {p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()}

    def replace(self, file: str, old: str, new: str) -> None:
        path = self.spec / file
        text = path.read_text("utf-8")
        assert text.count(old) == 1, (file, old)
        path.write_text(text.replace(old, new), "utf-8")


#: What may be edited: a word of a text, a number, one of several names in a list, a line of comment.
_EDITS = (
    (re.compile(r"(?<=[a-z]) (?=[a-z]+[ .,])"), " q"),
    (re.compile(r"(?<=: )[1-9][0-9]*(?=[,}\n])"), "2"),
    (re.compile(r"(?<=unit: )[a-zA-Z]+"), "m"),
    (re.compile(r"(?<=: )\[(?=[a-z])"), "[ "),
    (re.compile(r"\n(?=- )"), "\n# A comment.\n"),
)


def edits(spec: Path) -> Iterator[tuple[Path, str, str]]:
    """File, its text, and the text with one thing changed, without end."""
    rng = random.Random(SEED)
    files = sorted(p for p in spec.rglob("*.yaml") if "schema" not in p.parts)
    while True:
        path = rng.choice(files)
        text = path.read_text("utf-8")
        pattern, new = rng.choice(_EDITS)
        places = list(pattern.finditer(text))
        if places:
            place = rng.choice(places)
            yield path, text, text[: place.start()] + new + text[place.end() :]


@pytest.mark.parametrize("spec", ["invented", pytest.param("real", marks=heavy("edits of the whole specification"))])
def test_after_any_edit_the_output_is_that_of_a_complete_run(spec: str, tmp_path: Path) -> None:
    """For the real specification after the last edit only, as a complete run takes long."""
    runs = Runs(SPECS[spec][0], tmp_path)
    runs.run()
    wanted = rounds(2, 20) if spec == "real" else rounds(4, 200)
    for path, text, edited in edits(runs.spec):
        path.write_text(edited, "utf-8")
        try:
            model = runs.run()
        except SpecError:
            path.write_text(text, "utf-8")
            continue
        wanted -= 1
        if spec == "invented" or not wanted:
            runs.check(model)
        if not wanted:
            return


@pytest.mark.parametrize(
    ("file", "text"),
    [
        pytest.param("sets/measurements.yaml", "Specific force.", id="parameter"),
        pytest.param("sets/tools.yaml", "Commands of every shape.", id="set"),
        pytest.param("sets/tools.yaml", "Which member the union has.", id="type of a union's tag"),
        pytest.param("types/types.yaml", "What the device does.", id="type"),
    ],
)
def test_only_what_shows_a_description_is_made_again(file: str, text: str, tmp_path: Path) -> None:
    runs = Runs(SPECS["invented"][0], tmp_path)
    runs.run()
    runs.run()
    assert not any(runs.made.values())
    before = {name: runs.files(name) for name in TARGETS}
    runs.replace(file, text, text.replace("e", "ee", 1))
    runs.run()
    for name in TARGETS:
        after = runs.files(name)
        assert after.keys() == before[name].keys()
        assert runs.made[name] - {PLAN} == {path for path in after if after[path] != before[name][path]}, name
    assert any(runs.made.values())


def test_another_shape_makes_all_again_that_reads_the_part(tmp_path: Path) -> None:
    """It is unknown which objects of the part are the same, and all files read something of the sets."""
    runs = Runs(SPECS["invented"][0], tmp_path)
    runs.run()
    first = dict(runs.made)
    runs.replace("sets/measurements.yaml", "{name: u16, type: u16, description", "{name: w16, type: u16, description")
    runs.check(runs.run())
    kept = {(name, path) for name in TARGETS for path in first[name] - runs.made[name]}
    assert kept == set()


def test_in_another_shape_every_object_of_the_part_differs(tmp_path: Path) -> None:
    """Also for what has read a detail of one and nothing of the part."""
    runs = Runs(SPECS["invented"][0], tmp_path)
    runs.run()
    runs.replace("sets/measurements.yaml", "{name: u16, type: u16, description", "{name: w16, type: u16, description")
    model = load_model(runs.spec)
    slices = Slices(model, runs.out, "")
    assert all(slices.differ([slices.places[id(s)]]) for s in model.sets)
    assert not any(slices.differ([slices.places[id(d)]]) for d in model.devices)


def test_two_edits_of_different_targets_make_only_what_shows_each(tmp_path: Path) -> None:
    """No file of C shows the first edit; C is still the output of the run before."""
    runs = Runs(SPECS["invented"][0], tmp_path)
    runs.run()
    runs.replace("guides/1_first.yaml", "answer: Ask it, and listen", "answer: Ask it and listen")
    runs.run()
    assert not runs.made["c"] and runs.made["markdown"]
    runs.replace("sets/tools.yaml", "Commands of every shape.", "Commands of each shape.")
    runs.run()
    assert runs.made["c"] - {PLAN} == {"src/mip/tools.h"}


def test_in_a_file_that_is_made_again_only_pieces_that_show_an_edit_are_new(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    runs = Runs(SPECS["invented"][0], tmp_path)
    runs.run()
    made: list[str] = []
    text = Pieces.text

    def noted(self: Pieces, name: str, place: int, make: Callable[..., str], *arguments: Any) -> str:
        def once(thing: Any, *more: str) -> str:
            made.append(f"{name.rpartition(' ')[0]} {getattr(thing, 'name', '')}")
            return make(thing, *more)

        return text(self, name, place, once, *arguments)

    monkeypatch.setattr(Pieces, "text", noted)
    runs.replace("sets/measurements.yaml", "description: Specific force.", "description: Of two springs.")
    runs.check(runs.run())
    assert {"header accel", "line accel", "field accel"} <= set(made) and {x.split()[1] for x in made} == {"accel"}
    made.clear()
    runs.replace("sets/measurements.yaml", "description: Of two springs.", "description: Specific force.")
    with monkeypatch.context() as lost:
        lost.setattr(Slice, "_stored", lambda *_: None)
        model = runs.run()
    assert len(set(made)) > 10
    runs.check(model)


def test_a_file_that_was_edited_is_made_again(tmp_path: Path) -> None:
    runs = Runs(SPECS["invented"][0], tmp_path)
    model = runs.run()
    edited, lost = runs.out / "c/README.md", runs.out / "rust/README.md"
    edited.write_text("mine", "utf-8")
    lost.unlink()
    runs.check(runs.run())
    assert runs.made["c"] == {PLAN, "README.md"} == runs.made["rust"]
    runs.check(model)


def test_a_run_that_was_interrupted_is_not_relied_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Some targets have kept what they made, others have not."""
    runs = Runs(SPECS["invented"][0], tmp_path)
    runs.run()
    text = "description: Specific force."
    runs.replace("sets/measurements.yaml", text, "description: Of two springs.")
    with monkeypatch.context() as interrupted:
        interrupted.setattr(Slices, "keep", lambda _: None)
        runs.run()
    runs.replace("sets/measurements.yaml", "description: Of two springs.", "description: Of three springs.")
    runs.check(runs.run())


def test_values_of_different_kinds_differ() -> None:
    values: list[object] = [None, "None", "", 1, 1.0, True, "1", (1,), (1.0,), "(1,)", float("nan")]
    assert len({repr(_plain(v)) for v in values}) == len(values)
    assert all(_plain(a) != _plain(b) for i, a in enumerate(values) for b in values[:i])
    assert _plain(float("nan")) == _plain(float("nan"))


# --------------------------------------------------------------------------- what is read


class Thing:
    def __init__(self, name: str) -> None:
        self.name = name

    @kept
    def loud(self) -> str:
        """In capitals."""
        return self.name.upper()


class Slotted:
    __slots__ = ("name", "other")


reads.watch(Thing, ["name"])
reads.watch(Slotted, ["name"])


def test_reads_are_noted() -> None:
    thing, other = Thing("a"), Slotted()
    other.name, other.other = "b", "c"
    assert reads.during(lambda: thing.name + other.name + other.other) == (
        "abc",
        {(id(thing), "name"), (id(other), "name")},
    )
    assert reads.during(lambda: other.other) == ("c", set())
    inner: list[frozenset[reads.Read]] = []
    _, outer = reads.during(lambda: (thing.name, inner.append(reads.during(lambda: other.name)[1])))
    assert inner == [{(id(other), "name")}] and outer == {(id(thing), "name"), *inner[0]}


def test_a_result_that_is_kept_was_read_by_all_who_use_it() -> None:
    thing, memo = Thing("a"), Memo[str, str]()
    for _ in range(2):
        assert reads.during(lambda: thing.loud) == ("A", {(id(thing), "name")})
        assert reads.during(lambda: memo.get("x", lambda: thing.loud + "!")) == ("A!", {(id(thing), "name")})
    thing.name = "b"
    assert (thing.loud, memo.get("x", str)) == ("A", "A!")
    assert Thing.loud.__doc__ == "In capitals."


def test_a_failure_ends_what_is_noted() -> None:
    thing = Thing("a")
    with pytest.raises(ZeroDivisionError):
        reads.during(lambda: (thing.name, 1 // 0))
    assert reads.during(lambda: None) == (None, set())


def test_without_an_earlier_run_everything_is_made() -> None:
    past = Anew()
    assert (past.unchanged(NAMES), past.right("a"), past.all_right(), past.make("a", str, 1)) == (
        False,
        None,
        None,
        "1",
    )

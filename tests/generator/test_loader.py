"""YAML 1.2 scalars, places, and the messages of the schema."""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path

import pytest
from bad_spec_files import BASE
from mipgen.model import SCALARS
from mipgen.read import nodes, spelling
from mipgen.read.nodes import Node
from mipgen.read.problems import MANY, Position, Problems, SpecError, nearest
from mipgen.resolve.load import load_model
from support import ROOT, model


def parse(text: str | bytes, folder: Path) -> tuple[Node | None, list[str]]:
    path = folder / "file.yaml"
    path.write_bytes(text.encode("utf-8") if isinstance(text, str) else text)
    problems = Problems()
    return nodes.read(path, "file.yaml", problems), [str(p) for p in problems.sorted()]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("true", True), ("false", False), ("True", "True"), ("yes", "yes"), ("no", "no"), ("on", "on"), ("off", "off"),
        ("~", None), ("null", None), ("", None), ("Null", "Null"), ("0", 0), ("-7", -7),
        ("0x1F", 31), ("0xff", 255), ("0x", "0x"), ("12:30", "12:30"), ("1-2", "1-2"), ("1.2.3", "1.2.3"),
        ("1.5", 1.5), ("1e3", 1000.0), ("-2.5E-1", -0.25), ("1e999", "1e999"), (".", "."), ("_1", "_1"),
        (".inf", ".inf"), (".nan", ".nan"), ("2026-01-01", "2026-01-01"), ("=", "="), ("<<", "<<"),
        ("'1'", "1"), ('"true"', "true"), ("''", ""), ("9" * 41, "9" * 41), ("9" * 40, int("9" * 40)),
        ("0" * 41, "0" * 41),
    ],
)  # fmt: skip
def test_scalars(text: str, value: object, tmp_path: Path) -> None:
    root, problems = parse(f"key: {text}\n", tmp_path)
    assert problems == []
    assert root is not None
    found = root["key"].value
    assert (type(found), found) == (type(value), value)


def test_keys_are_text(tmp_path: Path) -> None:
    root, _ = parse("{true: 1, 2: 3, ~: 4, '': 5}", tmp_path)
    assert root is not None and list(root.value) == ["true", "2", "~", ""]


def test_places(tmp_path: Path) -> None:
    root, _ = parse("a:\n  b: [1, {c: é, d: x}]\n  e: |\n    text\nf: ~\n", tmp_path)
    assert root is not None

    def at(*path: str | int) -> tuple[int, int]:
        place = root.at(list(path))
        return place.line, place.column

    assert at() == (1, 1)
    assert at("a") == (1, 1) and at("a", "b") == (2, 3) and at("a", "e") == (3, 3)
    assert at("a", "b", 0) == (2, 7) and at("a", "b", 1) == (2, 10)
    assert at("a", "b", 1, "c") == (2, 11) and at("a", "b", 1, "d") == (2, 17)
    assert at("a", "nowhere", "c") == (1, 1)
    assert str(root.value_at(["a", "b", 1, "d"])) == "file.yaml:2:20"
    assert str(root.value_at(["f"])) == "file.yaml:5:1"
    assert root.plain() == {"a": {"b": [1, {"c": "é", "d": "x"}], "e": "text\n"}, "f": None}


def test_a_node_answers_for_what_it_lacks(tmp_path: Path) -> None:
    root, _ = parse("a: ~\nb: 1\n", tmp_path)
    assert root is not None
    assert root.scalar("a", 5) == 5 and root.scalar("b", 5) == 1 and root.scalar("c", 5) == 5
    assert "a" in root and "c" not in root and root.get("c") is None
    assert root["b"].get("x") is None and "x" not in root["b"]


@pytest.mark.parametrize("text", ["\ufeffa: 1\n", "a: 1\r\n", "%YAML 1.2\n---\na: 1\n", "a: 1\n...\n"])
def test_harmless_forms(text: str, tmp_path: Path) -> None:
    root, problems = parse(text, tmp_path)
    assert problems == [] and root is not None and root.plain() == {"a": 1}


def test_an_alias_of_what_holds_it(tmp_path: Path) -> None:
    _, problems = parse("a: &a [*a]\n", tmp_path)
    assert [p.split(": ")[0] for p in problems] == ["file.yaml:1:4", "file.yaml:1:8"]


def test_all_duplicates_of_a_file(tmp_path: Path) -> None:
    _, problems = parse("a: {b: 1, b: 2}\nc: 1\na: 2\nc: 3\n", tmp_path)
    assert [p.split(" error: ")[0] for p in problems] == ["file.yaml:1:11:", "file.yaml:3:1:", "file.yaml:4:1:"]


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("\ufeffa: [1\n", "1:4: error: not YAML: the '[' that opens here is not closed"),
        ('a: "x\r\n  y"\r\nb: [1\r\n', "3:4: error: not YAML: the '[' that opens here is not closed"),
        ("a: [{b: 1\n", "1:5: error: not YAML: the '{' that opens here is not closed"),
        ("a\n\nb: 1\n", "1:1: error: not YAML: a key without its colon; write 'key: value'"),
        ("a\n# A remark.\n\nb: 1\n", "1:1: error: not YAML: a key without its colon; write 'key: value'"),
    ],
)
def test_where_the_mistake_is(text: str, problem: str, tmp_path: Path) -> None:
    assert parse(text, tmp_path)[1] == [f"file.yaml:{problem}"]


def test_manuals_come_in_the_order_of_their_numbers() -> None:
    assert [x.id for x in model("real").protocol.manuals][:4] == [
        "3dm-gx5-45", "3dm-gx5-15", "3dm-cv5-10", "3dm-cx5-25"
    ]  # fmt: skip


def test_a_folder_in_place_of_a_file(tmp_path: Path) -> None:
    for name in ("protocol.yaml",):
        (tmp_path / name).write_bytes((BASE / name).read_bytes())
    (tmp_path / "sets/odd.yaml").mkdir(parents=True)
    with pytest.raises(SpecError, match=r"sets/odd.yaml:1:1: error: cannot be read: Is a directory"):
        load_model(tmp_path)


def test_what_is_no_file_and_a_name_that_is_no_text(tmp_path: Path) -> None:
    spec = Path(shutil.copytree(BASE, tmp_path / "spec"))
    os.mkfifo(spec / "sets/pipe.yaml")
    shutil.copy(spec / "protocol.yaml", os.fsdecode(os.fsencode(spec) + b"/sets/odd\xff.yaml"))
    shutil.copy(spec / "protocol.yaml", spec / "sets/new\nline.yaml")
    with pytest.raises(SpecError) as caught:
        load_model(spec)
    assert [(p.file.rpartition("sets/")[2], p.message) for p in caught.value.problems] == [
        ("new\\nline.yaml", "the name of this file contains an unprintable character; rename it"),
        ("odd\\udcff.yaml", "the name of this file is not UTF-8 text; rename it"),
        ("pipe.yaml", "this is not a file"),
    ]


def test_files_that_are_not_of_the_specification(tmp_path: Path) -> None:
    """Files of editors are ignored; those that an author would believe to be read are reported."""
    spec = Path(shutil.copytree(BASE, tmp_path / "spec"))
    (spec / "sets/.#tools.yaml").symlink_to("me@here.1234")
    (spec / "sets/._tools.yaml").write_bytes(b"\0\5\xff")
    (spec / "sets/tools.yaml~").write_text("set: 1\n")
    assert len(load_model(spec).fields) == 5
    for name in ("more.yml", "more.YAML", "old/more.yaml"):
        (spec / "sets" / name).parent.mkdir(exist_ok=True)
        (spec / "sets" / name).write_text("set: 1\n")
    with pytest.raises(SpecError) as caught:
        load_model(spec)
    assert [p.file.rpartition("sets/")[2] for p in caught.value.problems] == ["more.YAML", "more.yml", "old/more.yaml"]
    assert all(p.message.startswith("this file is ignored; only these are read: ") for p in caught.value.problems)


def test_no_folder_at_all(tmp_path: Path) -> None:
    with pytest.raises(SpecError, match=r"nowhere:1:1: error: this is not a specification"):
        load_model(tmp_path / "nowhere")


def test_problems_are_sorted_and_counted_once() -> None:
    problems = Problems()
    for line, message in ((10, "b"), (9, "z"), (10, "a"), (10, "a")):
        problems.add(Position("f", line, 1), message)
    assert [str(p) for p in problems.sorted()] == ["f:9:1: error: z", "f:10:1: error: a", "f:10:1: error: b"]
    assert len(problems) == 3 and bool(problems)


def test_many_choices_are_cut() -> None:
    whole, many = ([f"a{i:03}" for i in range(n)] for n in (MANY, 3 * MANY))
    assert nearest("zzz", whole) == f"; known: {', '.join(whole)}"
    assert nearest("zzz", many) == f"; known: {', '.join(many[:MANY])}, … ({3 * MANY} in all)"


def test_characters_of_the_choices_are_not_strange() -> None:
    assert nearest("An “excample”", ["An “example”"]) == ", did you mean 'An “example”'?"
    assert "U+201C" in nearest("An “excample”", ["An example"])


def test_choices_keep_their_order() -> None:
    assert nearest("zzz", ["u8", "u16", "bool", "u8"]) == "; known: u8, u16, bool"
    assert nearest("zzz", {"b", "a"}) == "; known: a, b"


def test_usual_spellings_are_ours() -> None:
    """Each synonym leads to a word of the main specification, and none is a word of ours already."""
    found = model("real")
    ours = {*SCALARS, *(t.name for t in found.types), *(u.symbol for u in found.protocol.units)}
    keys = {"description", "range", "count"}
    for word, spellings in spelling.SYNONYMS.items():
        assert word in ours | keys, word
        for spelled in spellings:
            assert spelling.usual_word(spelled, [word]) == word
            assert spelled not in ours or word in keys or (word, spelled) == ("u8", "byte")
    assert len({s.casefold() for x in spelling.SYNONYMS.values() for s in x}) == sum(
        map(len, spelling.SYNONYMS.values())
    )


def test_samples_of_the_language_can_be_read(tmp_path: Path) -> None:
    pages = [path.read_text("utf-8") for path in (ROOT / "spec").rglob("README.md")]
    samples = [sample for page in pages for sample in re.findall(r"```yaml\n(.*?)```", page, re.DOTALL)]
    assert len(pages) == 6 and len(samples) >= 7
    for sample in samples:
        assert parse(sample, tmp_path)[1] == []

"""The wording of our own texts: turns of phrase that no vendor's manual would use must not come back.

Where one of them is right after all, narrow its pattern."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml
from support import ROOT

#: Turn -> what to write instead.
TURNS = {
    r"\bstands?\b(?! for (?:issue)\b)": "is, appears; means",
    r"\bfor ever\b": "forever",
    r"\bshall\b": "must, will",
    r"\bown reading\b": "what a value means on a device",
    r"\b(?:whosoever|whatsoever|whereof|thereof|hitherto)\b": "a plain sentence",
    r"\b(?:is|are|was|were|be|first) asked for\b": "requested, used",
    r"\bvouch": "a valid flag",
    r"\b(?:within|for|after|of|in) so many\b": "this many, or the number itself",
    r"\bby MSCL\b": "according to MSCL",
    r"\bbelongs? to no (?:packet|field)\b": "outside packets, not part of a packet",
    r"\bgets? lost\b": "is lost",
    r"\bwhat became of\b": "the outcome of",
    r"\btold (?:apart )?from\b": "distinguished from",
    r"\bdata are\b(?! listed)": "data is",
    r"\b(?:name|names|describe|call) (?:\w+ ){0,3}so\.": "use these names, describe it this way",
    r"\bgives? up (?:the|an?) (?:incomplete|pending)\b": "discards",
    r"\bleave room for (?:the )?answers\b": "allow headroom for replies",
    r"\bThe rest is an example\b": "other values will differ",
    r"\bPrograms that read the data\b": "to read this data",
    r"\b(?:lead|leads) corrections\b": "route corrections",
    r"\bas far as is known\b": "is believed to",
    r"\bnames? nothing like\b": "has no equivalent",
}
#: Turns that only texts about programs may use.
REFERENCE = {r"\bprints?\b": "gives, says, shows"}


def texts(node: yaml.Node, key: str = "") -> Iterator[tuple[int, str]]:
    """The texts of a file of the specification, with their lines, but for what a manual says."""
    match node:
        case yaml.MappingNode():
            for k, v in node.value:
                yield from texts(v, k.value)
        case yaml.SequenceNode():
            for v in node.value:
                yield from texts(v, key)
        case yaml.ScalarNode() if key not in ("section", "sections", "printed"):
            yield node.start_mark.line + 1, node.value


def turns_in(path: Path, turns: dict[str, str]) -> list[str]:
    text = path.read_text("utf-8")
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    lines = texts(yaml.compose(text, loader)) if path.suffix == ".yaml" else enumerate(text.splitlines(), 1)
    return [
        f"{path}:{line}: {text.strip()[:120]}: write: {better}"
        for line, text in lines
        for turn, better in turns.items()
        if re.search(turn, text, re.IGNORECASE)
    ]


REFERENCE_TEXTS = [*(ROOT / "spec").rglob("*.yaml"), *(ROOT / "templates/markdown").glob("*.j2")]
OTHER_TEXTS = [
    *(
        ROOT / name
        for name in (
            "README.md",
            "CONTRIBUTING.md",
            "CHANGELOG.md",
            "spec/README.md",
            "generator/mipgen/facts/describe.py",
        )
    ),
    *(ROOT / "docs").glob("*.md"),
    *(ROOT / "spec/programs").iterdir(),
    *(ROOT / "templates").glob("*/README.md.j2"),
]


def test_reference() -> None:
    assert [x for path in REFERENCE_TEXTS for x in turns_in(path, TURNS | REFERENCE)] == []


def test_other_texts() -> None:
    assert [x for path in OTHER_TEXTS for x in turns_in(path, TURNS)] == []


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("printed: It stands here.\nreason: It stands\n  there.\n", [2]),
        ("notes:\n  - fine\n  - >-\n    The data\n    are valid.\n", [3]),
    ],
)
def test_a_turn_is_seen(text: str, lines: list[int], tmp_path: Path) -> None:
    """Where it is divided between lines, too; not in what a manual says."""
    path = tmp_path / "a.yaml"
    path.write_text(text, "utf-8")
    assert [int(x.removeprefix(f"{path}:").partition(":")[0]) for x in turns_in(path, TURNS)] == lines

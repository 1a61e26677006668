"""The longest tests take turns, and each has one."""

from __future__ import annotations

import re
from collections import Counter
from itertools import chain
from typing import Any

import pytest
import turns
from support import ROOT


class Item:
    def __init__(self, nodeid: str, *marks: str) -> None:
        self.nodeid, self.marks = nodeid, marks

    def get_closest_marker(self, name: str) -> str | None:
        return name if name in self.marks else None


def test_what_is_named_exists() -> None:
    for line in chain(*turns.sections().values()):
        file, _, test = line.partition("::")
        text = (ROOT / file).read_text("utf-8")
        assert not test or re.search(rf"^def {test}\(", text, re.MULTILINE), line


def test_each_has_its_turn(monkeypatch: pytest.MonkeyPatch) -> None:
    named = {"test": ["b.py::test_l"], "test-all": ["a.py", "b.py::test_p", "c.py::test_q"]}
    monkeypatch.setattr(turns, "sections", lambda: named)
    names = ["a.py::test_1", "a.py::test_2", *(f"b.py::test_p[{i}]" for i in range(5)), "c.py::test_q", "c.py::test_r"]
    items: Any = [Item(name, "cross" if name.startswith("c") else "heavy") for name in names]
    items += [Item(name) for name in ("b.py::test_p[light]", "b.py::test_l")]
    runs = Counter(
        item.nodeid
        for turn in range(7, 7 + turns.TURNS)
        for item in items
        if item not in turns.waiting(items, turn)
    )  # fmt: skip
    always = {"c.py::test_r": turns.TURNS, "b.py::test_p[light]": turns.TURNS}
    assert runs == dict.fromkeys([*names, "b.py::test_l"], 1) | always
    here = [item.nodeid for item in items if item not in turns.waiting(items, 0)]
    assert here == ["b.py::test_p[4]", "c.py::test_r", "b.py::test_p[light]", "b.py::test_l"]

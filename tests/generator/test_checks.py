"""How manuals count lengths, and how printed packets are compared."""

from __future__ import annotations

import pytest
from mipgen import model as m
from mipgen.facts.examples import misprint_text
from mipgen.lower.extent import computed_length
from small_specs import field
from support import model

INVENTED = model("invented")


def test_the_selector_counts() -> None:
    f = field("[{name: a, type: u16, for: W}]", functions="W")
    assert computed_length(f, "wire") == "5"


def test_a_structure_that_varies_counts_as_its_counter_says() -> None:
    types = "{tail: {struct: [{name: n, type: u8}, {name: a, type: u8, count: n}]}}"
    f = field("[{name: a, type: tail}]", types=types)
    assert (computed_length(f, "wire"), computed_length(f, "scalars")) == ("3 + a.n", "2")


def example(string: str | None = None, table: str | None = None, role: str = "command") -> m.Example:
    cells = None if table is None else tuple(None if "?" in x else int(x, 16) for x in table.split())
    packet = bytes.fromhex("756501020201e0c6")
    return m.Example("x", "guide", "", "", role, string, cells, packet, (), "")  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("printed", "found"),
    [
        (example("7565 0102 0201 E0C6", "75 65 01 02 02 01 E0 C6"), []),
        (example("7565 0102 0201 e0c6", "75 65 01 02 02 01 ?? ??"), []),
        (example("7565 0102 0201"), ["string has 6 bytes, should have 8"]),
        (example(table="75 65 ?? 03 02 01 ?? ??"), ["table byte at offset 3 is 03, should be 02"]),
        (example("02 01", role="field"), []),
        (example("02 02", role="field"), ["string byte at offset 1 is 02, should be 01"]),
    ],
)
def test_differences(printed: m.Example, found: list[str]) -> None:
    assert misprint_text(printed) == found

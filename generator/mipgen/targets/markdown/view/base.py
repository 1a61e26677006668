"""A thing on a page, and the sections of manuals that describe it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic, TypeVar

from mipgen import model as m
from mipgen.lower.extent import computed_length, same

from ..offsets import length
from ..places import Page, label
from ..text import code, inline

Thing = TypeVar("Thing", covariant=True)


@dataclass(frozen=True)
class View(Generic[Thing]):
    page: Page
    of: Thing

    @property
    def model(self) -> m.Model:
        return self.page.model

    @property
    def citations(self) -> list[str]:
        """The sections of the manuals that describe it, one line for each."""
        return [citation(self.page, self.of, s) for s in getattr(self.of, "sources", ())]


def citation(page: Page, thing: object, s: m.Source) -> str:
    remark = length_remark(page, thing, s) if isinstance(thing, m.Field) else ""
    return f"{manual_link(page, s)}: {inline(s.section)}{f' ({remark})' if remark else ''}"


def manual_link(page: Page, s: m.Source) -> str:
    return page.link(next(x for x in page.model.protocol.manuals if x.id == s.manual))


def length_remark(page: Page, f: m.Field, s: m.Source) -> str:
    """States how the length of a field in a manual differs from the right one; empty if it does not."""
    if s.length is None or s.length == "unavailable":
        return ""
    correct = length(f.parameters)
    errata = page.index.errata_of_length(f, s.manual)
    if errata:
        links = ", ".join(page.link(e, f"erratum {label(e)}") for e in errata)
        return f"length given as {code(s.length)} instead of {correct}: {links}"
    if same(s.length, computed_length(f, "wire")):
        return ""
    return f"length given as {code(s.length)} without vectors, structures and unions, instead of {correct}"

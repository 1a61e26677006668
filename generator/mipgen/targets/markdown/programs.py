"""How programs use a field, in each language that has a target here."""

from __future__ import annotations

from dataclasses import dataclass

from ... import model as m
from ..c import snippets as c
from ..python import snippets as python
from .places import Page


@dataclass(frozen=True, slots=True)
class Program:
    title: str
    language: str  # of the fenced block
    lines: str


def programs(page: Page, f: m.Field) -> list[Program]:
    typical, rust = page.index.typical, page.index.rust
    if f.role == m.COMMAND:
        found = (c.command(f, typical), python.command(f, typical), rust.command(f))
    else:
        found = (c.data(f), python.data(f), rust.data(f))
    return [Program(*x) for x in zip(("C", "Python", "Rust"), ("c", "python", "rust"), found, strict=True)]

"""Ways to make a structure or a command: which values a program gives, and which follow from these."""

from __future__ import annotations

from dataclasses import dataclass

from mipgen import model as m

from .presence import Record


@dataclass(frozen=True, slots=True)
class Constructor:
    """One for each function of a command, or just one."""

    function: m.Function | None
    required: tuple[m.Parameter, ...]  # in wire order, without the selector
    optional: tuple[m.Parameter, ...]

    @property
    def given(self) -> tuple[m.Parameter, ...]:
        """What a caller gives who also fills in counters and tags: neither constants nor reserved values."""
        return tuple(p for p in self.required if p.constant is None and p.reserved is None)

    @property
    def values(self) -> tuple[m.Parameter, ...]:
        """The same without counters, where an array knows its length."""
        return tuple(p for p in self.given if p.counts is None)

    @property
    def unions(self) -> dict[str, m.Parameter]:
        """Tag -> the union that it selects an alternative of: where a union knows its alternative, the tag follows."""
        return {p.tag: p for p in self.required if p.tag}

    @property
    def addable(self) -> tuple[m.Parameter, ...]:
        """The optional parameters that a caller may give."""
        return tuple(p for p in self.optional if p.reserved is None and not p.derived)


def constructors(record: Record) -> list[Constructor]:
    """None of what a device sends."""
    if isinstance(record, m.Struct):
        return [Constructor(None, record.parameters, ())]
    if record.role != m.COMMAND:
        return []
    return [Constructor(c.function, c.required, c.optional) for c in record.calls]


def replies(f: m.Field, function: m.Function | None, model: m.Model) -> list[m.Reply]:
    """What may answer a command that is sent with this function."""
    return [r for r in model.replies(f) if function is None or function in r.functions]

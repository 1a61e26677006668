"""Fields in Rust: where they occur, how commands are answered, and what the registry contains."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from mipgen import model as m

from .. import docs, names
from .records import BOOL, Constructor, Member, Record, derives

#: Parameters, each with those inside.
Tree = list[tuple[m.Parameter, "Tree"]]


@dataclass(frozen=True, slots=True)
class Command:
    """How a command is answered."""

    response: str  # the type
    any_response: str  # if the function is known only at run time
    clauses: list[str]
    variants: list[tuple[str, Record]]  # the responses, if there are several
    derives: list[str]  # what all of these derive


@dataclass(frozen=True, eq=False)
class Field(Record):
    of: m.Field

    @property
    def deprecated(self) -> str | None:
        return self.of.deprecated

    @property
    def doc(self) -> list[docs.Block]:
        return self.crate.docs.field(self.of)

    @property
    def title(self) -> str:
        return docs.title(self.of)

    @property
    def clauses(self) -> Iterator[str]:
        """Where it occurs, how the layout is recognized, and the commands that it answers."""
        f, sizes, commands = self.of, self.crate.model.sizes(self.of), self.crate.model.commands(self.of)
        yield f"in [{set_numbers(f.sets, ' ')}]"
        if f.signature:
            yield "constants" + "".join(f" [{at}: {' '.join(map(str, octets))}]" for at, octets in f.signature)
        if sizes != range(m.MAX_FIELD_DATA + 1):
            yield f"sizes {sizes.start}..={sizes.stop - 1 if sizes.stop <= m.MAX_FIELD_DATA else 'usize::MAX'}"
        if commands:
            yield f"answers {' '.join(names.type_name(c.name) for c in commands)}"

    # ------------------------------------------------------------------ the registry

    @property
    def variant(self) -> str:
        """Its name among the fields of all families."""
        return names.type_name(f"{self.of.family}_{self.of.name}")

    @property
    def layouts(self) -> int:
        """The number of layouts of the descriptor."""
        return len(self.crate.model.layouts(self.of))

    @property
    def occurrences(self) -> list[tuple[int, str, str]]:
        """The sets in which it occurs, with its name there and a title that differs; none if one name is enough."""
        f = self.of
        if len(f.occurrences) == 1 and f.name_in(f.set) == f.full_name:
            return []
        return [(o.set, f.name_in(o.set), "" if o.title == f.title else o.title) for o in f.occurrences]

    @property
    def linked(self) -> list[str]:
        """The responses of a command, or the commands of a response."""
        return [x.full_name for x in (self.crate.model.responses(self.of) or self.crate.model.commands(self.of))]

    @property
    def values(self) -> Tree:
        return parameter_tree(self.of.parameters)

    # ------------------------------------------------------------------ commands

    @property
    def command(self) -> Command | None:
        if not self.is_command:
            return None
        f, responses = self.of, self.crate.model.responses(self.of) if len(self.of.responses) > 1 else ()
        derived = [derives(r.parameters, r.max_size) for r in responses]
        response = names.response_type(f)
        return Command(
            response,
            f"Option<{response}>" if f.selector and f.responses else response,
            list(self._answers(response)),
            [(names.response_variant(r, f), self.crate.record(r)) for r in responses],
            [name for name in ("Copy", "Eq", "Hash") if all(name in traits for traits in derived)],
        )

    @property
    def changing(self) -> tuple[str, Constructor] | None:
        """The response that contains all values of the command, and the constructor that writes them."""
        way = next((w for w in self.constructors if w.function and w.function.sets and w.arguments), None)
        responses = self.crate.model.responses(self.of)
        if way is None or [r.command for r in responses] != [self.of.name]:
            return None
        response = self.crate.record(responses[0])
        types = {x.name: x.whole_type for x in response.members}
        return (response.name, way) if all(types.get(x.name) == x.type for x in way.arguments) else None

    def _answers(self, response: str) -> Iterator[str]:
        f = self.of
        answered = [x for x in f.functions if x.responds and f.responses]
        for answer, functions in (("()", [x for x in f.functions if x not in answered]), (response, answered)):
            if functions:
                yield f"for {names.selector_macros(functions)} -> {answer}"
        for reply in self.crate.model.replies(f):
            types = " | ".join(names.type_name(layout.name) for layout in reply.layouts)
            within = f" for {names.selector_macros(reply.functions)}" if reply.functions else ""
            yield f"responds {types}{within}{', if ' if reply.when else ''}{self._conditions(reply.when)}"
        if silent := [x for x in f.functions if not x.reply]:
            yield f"silent for {names.selector_macros(silent)}"
        if f.silent_when:
            yield f"silent if {self._conditions(f.silent_when)}"
        if f.timeout:
            yield f"timeout {int(f.timeout * 1000)}"
        if self.ranges:
            yield "checks Ranged"

    def _conditions(self, conditions: Iterable[m.Condition]) -> str:
        """Writes conditions on a command as members and their values: `part = types::Mode::FAST`."""
        members = {x.parameter.name: x for x in self.members}
        return ", ".join(f"{members[c.parameter].name} = {_value(c, members[c.parameter])}" for c in conditions)


def _value(condition: m.Condition, x: Member) -> str:
    value, element = str(condition.value), x.parameter.element
    named = element.by_name(condition.label) if isinstance(element, m.Enum) else None
    if named:
        value = f"{x.type}::{names.constant(named.name)}"
    elif isinstance(element, m.Enum) or x.type == BOOL:
        value = f"{x.type}({value})"
    return f"Some({value})" if x.may_be_absent else value


def parameter_tree(parameters: Iterable[m.Parameter]) -> Tree:
    """Returns the parameters that are members of types, with those of structures, and the alternatives of unions."""
    inside = ((p, p.item.struct.parameters if p.item.struct else p.alternatives) for p in parameters if not p.derived)
    return [(p, parameter_tree(parts)) for p, parts in inside]


def set_numbers(sets: Sequence[int], separator: str) -> str:
    """Writes the numbers of descriptor sets: as a range, or one by one.

    >>> set_numbers(range(1, 128), " "), set_numbers((0x81, 0x91), " | ")
    ('0x01..=0x7F', '0x81 | 0x91')
    """
    if isinstance(sets, range):
        return f"0x{sets[0]:02X}..=0x{sets[-1]:02X}"
    return separator.join(f"0x{n:02X}" for n in sets)

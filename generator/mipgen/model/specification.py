"""A whole specification, with its lookups."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, TypeVar

from .devices import SUPPORTED, Answer, Device, NamedDevice, Support
from .evidence import Erratum, Example
from .fields import MAX_FIELD_DATA, RESPONSE, Family, Field, Record, Reply, Set
from .guides import Guide
from .protocol import Protocol
from .simulation import Simulation
from .types import Bitfield, Bits, Function, Type, structs

Key = TypeVar("Key")
Item = TypeVar("Item")


@dataclass(frozen=True)
class Model:
    """A whole specification, with lookups of references, which are indexed once."""

    protocol: Protocol
    types: tuple[Type, ...]  # of spec/types, in dependency order
    families: tuple[Family, ...]  # by number
    devices: tuple[Device, ...] = ()
    named: tuple[NamedDevice, ...] = ()  # known by name only
    examples: tuple[Example, ...] = ()
    errata: tuple[Erratum, ...] = ()
    simulation: Simulation = field(default_factory=Simulation)
    guides: tuple[Guide, ...] = ()
    programs: tuple[tuple[str, str], ...] = ()  # programs that show the bindings with fields of this specification

    def derived(self, make: Callable[[Model], Item]) -> Item:
        """Returns the result of a class or a function for this model, which is made once and kept with the model."""
        if make not in self._derived:
            self._derived[make] = make(self)
        derived: Item = self._derived[make]
        return derived

    def program(self, name: str) -> str:
        """Returns the text of a program; empty if the specification contains none of that name."""
        return dict(self.programs).get(name, "")

    @cached_property
    def fields(self) -> tuple[Field, ...]:
        """Every field, without the acknowledge field."""
        return tuple(f for x in self.families for f in x.fields)

    @cached_property
    def read_as(self) -> tuple[tuple[int, str], ...]:
        """The model numbers, each with the id of the device as which its data is read: of a device of which only the
        name is known, the one most like it."""
        ids = {d.id for d in self.devices}
        named = [(d.model_number, d.like) for d in self.named if d.like in ids]
        return tuple((n, id_) for n, id_ in [*((d.model_number, d.id) for d in self.devices), *named] if n)

    @cached_property
    def sets(self) -> tuple[Set, ...]:
        """Every descriptor set, by number."""
        return tuple(sorted((s for x in self.families for s in x.sets), key=lambda s: s.number))

    @cached_property
    def all_types(self) -> tuple[Type, ...]:
        """The types of spec/types, then those of the families."""
        return (*self.types, *(t for x in self.families for t in x.types))

    @cached_property
    def records(self) -> tuple[Record, ...]:
        """Everything with parameters: fields, without the acknowledge field, and structures."""
        return (*self.fields, *structs(self.all_types))

    def set(self, number: int) -> Set | None:
        return self._sets.get(number)

    def set_named(self, name: str) -> Set | None:
        return self._sets_by_name.get(name)

    def family(self, name: str) -> Family | None:
        return self._families.get(name)

    def field(self, full_name: str) -> Field | None:
        """Finds a field by its full name, or by its name in one of its sets: "gnss_2.dop"."""
        return self._fields.get(full_name)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The full names of all fields, and their names in each of their sets."""
        return tuple(dict.fromkeys(name for f in self.fields for name in f.names))

    def set_of(self, full_name: str) -> int:
        """Returns the number of the set with which the name of a field begins."""
        first = full_name.partition(".")[0]
        named = self.set_named(first)
        return named.number if named else self._fields[full_name].set

    def fields_in(self, s: Set) -> tuple[Field, ...]:
        """Returns the fields that occur in a set, without those that occur everywhere."""
        family = self._families[s.family]
        return tuple(f for f in family.fields if any(o.set == s.number for o in f.occurrences))

    def type(self, name: str) -> Type | None:
        """Finds a type by its full name: "set.type", or the name alone for one of spec/types."""
        return self._types.get(name)

    def candidates(self, set_number: int, descriptor: int) -> tuple[Field, ...]:
        """Returns the layouts that a descriptor may have inside a packet of that set."""
        own = self._descriptors.get((set_number, descriptor), ())
        return own or tuple(f for f in self._everywhere.get(descriptor, ()) if set_number in f.sets)

    def layouts(self, f: Field) -> tuple[Field, ...]:
        """Returns the layouts of a field's descriptor: the field itself, and those from which it must be
        distinguished."""
        alike = (g for o in f.occurrences for g in self._descriptors.get((o.set, f.descriptor), ()))
        return tuple({g.full_name: g for g in alike}.values()) or (f,)

    def sizes(self, f: Field) -> range:
        """Returns the sizes of data with which the descriptor has this layout, given its constants.

        Of several layouts whose constants match, the longest that fits into the data applies, else the shortest; of
        equal ones, the first.
        """
        others = [g.min_size for g in self.layouts(f) if set(g.signature) <= set(f.signature)]
        first = f.min_size if min(others) < f.min_size else 0
        return range(first, min((n for n in others if n > f.min_size), default=MAX_FIELD_DATA + 1))

    def responses(self, command: Field) -> tuple[Field, ...]:
        """Returns the possible responses to a command."""
        return tuple(self._fields[f"{command.family}.{name}"] for name in command.responses)

    def replies(self, command: Field) -> tuple[Reply, ...]:
        """Returns the responses to a command, and their conditions on the parameters of the command that owns a
        response; another command that has the same response is always answered with it."""
        cached = self._replies.get(command.full_name)
        if cached is None or cached[0] is not command:
            functions = tuple(f for f in command.functions if f.responds)
            layouts = _grouped((r.when if r.command == command.name else (), r) for r in self.responses(command))
            replies = tuple(Reply(fields, functions, when) for when, fields in layouts.items())
            cached = self._replies[command.full_name] = command, replies
        return cached[1]

    def answers(self, command: Field, device: str) -> tuple[Field, ...]:
        """Returns the responses that one device sends: of a response with several layouts, the device's own, or else
        those for any device."""
        fields: list[Field] = []
        for reply in self.replies(command):
            own = [f for f in reply.layouts if device in f.devices]
            fields += own or [f for f in reply.layouts if not f.devices] or reply.layouts
        return tuple(fields)

    def commands(self, response: Field) -> tuple[Field, ...]:
        """Returns the commands that a response answers."""
        return self._commands.get(response.full_name, ())

    def supports(self, f: Field, number: int | None = None) -> tuple[tuple[Device, Support], ...]:
        """Returns the devices that support, or may support, a command or data field, in one set or in any."""
        supporting = self._supports.get(f.full_name, ())
        return supporting if number is None else tuple((d, s) for d, s in supporting if s.set == number)

    def refusing(self, f: Field) -> tuple[Device, ...]:
        """Returns the devices that are known not to support a command or data field, in some set."""
        ids = self._refusing.get(f.full_name, ())
        return tuple(d for d in self.devices if d.id in ids)

    def devices_of(self, f: Field, answer: Answer = "yes", number: int | None = None) -> tuple[Device, ...]:
        """Returns the devices with this answer to whether they support a field, in one set or in any; a device supports
        a response if it sends it. If the answers differ, the strongest counts."""
        if (f.full_name, number) not in self._answers:
            answers = self._strongest(f, number)
            self._answers[f.full_name, number] = _grouped((answers[d.id], d) for d in self.devices if d.id in answers)
        return self._answers[f.full_name, number].get(answer, ())

    @cached_property
    def _answers(self) -> dict[tuple[str, int | None], dict[Answer, tuple[Device, ...]]]:
        return {}

    def _strongest(self, f: Field, number: int | None) -> dict[str, Answer]:
        if f.role == RESPONSE:
            asked = [(c, d, s) for c in self.commands(f) for d, s in self.supports(c) if s.responds]
            supporting = [(d, s) for c, d, s in asked if f.full_name in {r.full_name for r in self.answers(c, d.id)}]
        else:
            supporting = list(self.supports(f, number))
        answers: dict[str, Answer] = {}
        for d, s in supporting:
            answers[d.id] = min(answers.get(d.id, s.evidence.answer), s.evidence.answer, key=SUPPORTED.index)
        return answers

    def affected(self, command: Field, certain: bool = True) -> tuple[Field | Set, ...]:
        """Returns the effects of a command: data fields, and sets all of whose fields may change. A part of a
        specification may lack some of them."""
        named = command.affects if certain else command.may_affect
        things: list[Field | Set] = []
        for name in named:
            f = self._fields.get(name)
            things += [f] if f else [s for s in self.sets if name in (s.name, s.family)]
        return tuple(things)

    def changed_by(self, thing: Field | Set, certain: bool = True) -> tuple[Field, ...]:
        """Returns the commands that change a data field, or all fields of a set."""
        return (self._changes if certain else self._may_change).get(_name(thing), ())

    def flagged_by(self, f: Field) -> tuple[tuple[Bitfield, Bits], ...]:
        """Returns the bits that concern a field."""
        return self._flags.get(f.full_name, ())

    def taken(self, command: Field) -> tuple[Function, ...]:
        """Returns the functions that at least one device accepts; all of them if no device is known."""
        names = {x.name for _, s in self.supports(command) for x in s.functions}
        return tuple(x for x in command.functions if x.name in names) or command.functions

    def device(self, device_id: str) -> Device | None:
        return next((d for d in self.devices if d.id == device_id), None)

    # ----------------------------------------------------------------------- indexes

    @cached_property
    def _derived(self) -> dict[Callable[[Model], Any], Any]:
        return {}

    @cached_property
    def _replies(self) -> dict[str, tuple[Field, tuple[Reply, ...]]]:
        """By the full name of a command, with the command: another one may have the same name."""
        return {}

    @cached_property
    def _sets(self) -> dict[int, Set]:
        return {s.number: s for s in self.sets}

    @cached_property
    def _sets_by_name(self) -> dict[str, Set]:
        return {s.name: s for s in reversed(self.sets)}  # the first one, if a name is repeated

    @cached_property
    def _fields(self) -> dict[str, Field]:
        every = (*self.fields, self.protocol.acknowledge)
        return {name: f for f in every for name in f.names} | {f.full_name: f for f in every}

    @cached_property
    def _families(self) -> dict[str, Family]:
        return {x.name: x for x in self.families}

    @cached_property
    def _types(self) -> dict[str, Type]:
        own = {f"{x.name}.{t.name}": t for x in self.families for t in x.types}
        return {**own, **{t.name: t for t in self.types}}

    @cached_property
    def _descriptors(self) -> dict[tuple[int, int], tuple[Field, ...]]:
        return _grouped(((o.set, f.descriptor), f) for f in self.fields for o in f.occurrences)

    @cached_property
    def _everywhere(self) -> dict[int, tuple[Field, ...]]:
        return _grouped((f.descriptor, f) for f in (*self.fields, self.protocol.acknowledge) if f.everywhere)

    @cached_property
    def _commands(self) -> dict[str, tuple[Field, ...]]:
        return _grouped((f"{f.family}.{name}", f) for f in self.fields for name in f.responses)

    @cached_property
    def _changes(self) -> dict[str, tuple[Field, ...]]:
        return _grouped((name, f) for f in self.fields for name in self._names_affected(f, certain=True))

    @cached_property
    def _may_change(self) -> dict[str, tuple[Field, ...]]:
        return _grouped((name, f) for f in self.fields for name in self._names_affected(f, certain=False))

    def _names_affected(self, f: Field, certain: bool) -> dict[str, None]:
        return dict.fromkeys(map(_name, self.affected(f, certain)))

    @cached_property
    def _flags(self) -> dict[str, tuple[tuple[Bitfield, Bits], ...]]:
        flags = ((t, b) for t in self.all_types if isinstance(t, Bitfield) for b in t.bits)
        named = ((t, b, self._fields.get(name)) for t, b in flags for name in b.concerns)
        return _grouped((f.full_name, (t, b)) for t, b, f in named if f is not None)

    @cached_property
    def _supports(self) -> dict[str, tuple[tuple[Device, Support], ...]]:
        return _grouped((s.field.full_name, (d, s)) for d in self.devices for s in d.supports)

    @cached_property
    def _refusing(self) -> dict[str, tuple[str, ...]]:
        return _grouped((s.field.full_name, d.id) for d in self.devices for s in d.refuses)


def _name(thing: Field | Set) -> str:
    return thing.full_name if isinstance(thing, Field) else thing.name


def _grouped(pairs: Iterable[tuple[Key, Item]]) -> dict[Key, tuple[Item, ...]]:
    grouped: dict[Key, list[Item]] = {}
    for key, item in pairs:
        grouped.setdefault(key, []).append(item)
    return {key: tuple(items) for key, items in grouped.items()}

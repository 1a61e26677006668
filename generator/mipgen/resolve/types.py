"""Resolves definitions of types, each on first use."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial

from mipgen import model as m
from mipgen.read.nodes import Node
from mipgen.read.problems import Problems, nearest

from .beside import ALL_VALID
from .layout import Layout, Record
from .variation import Scope
from .vocabulary import Vocabulary, cited, short_name, texts_of_node

#: The greatest depth of nested structures: far beyond need, and below Python's own limit.
MAX_NESTING = 16


@dataclass
class Types:
    """Finds types by name, first in the set, then in spec/types, and resolves them on demand."""

    vocabulary: Vocabulary
    problems: Problems
    shared: dict[str, Node] = field(default_factory=dict)
    local: dict[str, dict[str, Node]] = field(default_factory=dict)
    parts: dict[str, dict[str, Node]] = field(default_factory=dict)  # lists of parameters, by set
    concerned: list[Node] = field(default_factory=list)  # what bits concern; checked when all fields are known
    needed: list[Node] = field(default_factory=list)  # the hardware that is required; checked with the devices
    marked: dict[tuple[str | None, str], dict[str, str]] = field(default_factory=dict)  # see beside.marked_by_bits
    _included: set[tuple[str, str]] = field(default_factory=set)
    _done: dict[tuple[str | None, str], m.Type | None] = field(default_factory=dict)
    _open: list[str] = field(default_factory=list)

    def define(self, owner: str | None, types: Node | None) -> None:
        """Registers the types of a file."""
        scope = self.shared if owner is None else self.local.setdefault(owner, {})
        for name, node in types.items() if types else ():
            place = types.keys[name] if types else node.position
            taken = (*m.SCALARS, self.vocabulary.selector.name)
            if owner is not None and "vector" in node:
                self.problems.add(place, f"the vector '{name}' must be in types/*.yaml, for all sets; move it there")
            earlier = scope.get(name) or self.shared.get(name)
            if earlier or name in taken:
                where = f" at {earlier.position}" if earlier else ""
                self.problems.add(place, f"the type '{name}' is already defined{where}; choose another name")
            else:
                scope[name] = Node(node.value, place, node.keys)

    def scope(self, owner: str | None) -> Scope:
        """Returns the names to which a parameter of that owner may refer."""
        return Scope(self.vocabulary, partial(self.find, owner=owner), self.problems.add)

    def of(self, owner: str | None) -> tuple[m.Type, ...]:
        """Returns all types of one owner, each after the types that it uses."""
        scope = self.shared if owner is None else self.local.get(owner, {})
        for name in scope:
            self.find(name, None, owner)
        return tuple(t for (o, _), t in self._done.items() if o == owner and t is not None)

    def find(self, name: str, position: m.Position | None, owner: str | None) -> m.Type | None:
        local = self.local.get(owner or "", {})
        where = owner if name in local else None
        node = local.get(name) or self.shared.get(name)
        if node is None:
            choices = [*m.SCALARS, *local, *self.shared]
            self.problems.add(position, f"unknown type '{name}'{nearest(name, choices)}")
            return None
        if (where, name) not in self._done:
            if name in self._open:
                loop = " -> ".join([*self._open[self._open.index(name) :], name])
                self.problems.add(position, f"the type contains itself: {loop}; break the loop")
                return None
            if len(self._open) == MAX_NESTING:
                self.problems.add(position, f"'{name}' is nested more than {MAX_NESTING} deep; flatten it")
                return None
            self._open.append(name)
            resolved = self._resolve(name, where, node)
            self._open.pop()
            self._done[where, name] = resolved
        return self._done[where, name]

    def _kind(self, name: str, node: Node) -> str | None:
        """Returns the key that determines the kind of a type; None if there is none, or if other keys contradict it."""
        kinds = [k for k in ("enum", "bitfield", "struct", "vector") if k in node]
        if len(kinds) != 1:
            wanted = "exactly one of enum, bitfield, struct, vector"
            self.problems.add(node.position, f"the type '{name}' needs {wanted}")
            return None
        parts = {"enum": "values", "bitfield": "bits", "vector": "elements"}
        part = parts.get(kinds[0])
        if "include" in node and part != "bits":
            self.problems.add(node.keys["include"], f"'include' does not belong in the {kinds[0]} '{name}'")
            return None
        for other in ("values", "bits", "elements"):
            if other == "bits" and "bits" not in node and "include" in node:
                continue
            if (other in node) != (other == part):
                fault = "is missing in" if other == part else "does not belong in"
                place = node.keys.get(other, node.position)
                self.problems.add(place, f"'{other}' {fault} the {kinds[0]} '{name}'")
                return None
        return kinds[0]

    def _resolve(self, name: str, owner: str | None, node: Node) -> m.Type | None:
        kind = self._kind(name, node)
        if kind is None:
            return None
        if kind == "vector":
            return self._vector(name, node)
        short = short_name(node, name, self.problems)
        origin = (
            node.scalar("description", ""),
            owner,
            cited(f"{owner}.{name}" if owner else name, self.vocabulary, self.problems),
            texts_of_node(node, "uncertain"),
        )
        if kind == "enum":
            values = self._values(node)
            scalar = m.SCALARS[node["enum"].value]
            return m.Enum(name, scalar, values, *origin, short=short, position=node.position)
        if kind == "struct":
            record = self.record(list(node["struct"]), owner, inside=True)
            return m.Struct(
                name, record.parameters, record.min_size, record.max_size, *origin, short=short, position=node.position,
            )  # fmt: skip
        base = m.SCALARS.get(node["bitfield"].value)
        size = base.size if base else node["bitfield"].value
        bits = self._bits(node.get("bits"), owner, size * 8, node.get("when")) + self._included_bits(
            node, owner, size * 8
        )
        bits = _described(bits, self.marked.get((owner, name), {}))
        if "include" in node:
            bits = tuple(sorted(bits, key=lambda b: (b.first, -b.last)))
        return m.Bitfield(name, base, size, bits, *origin, short=short, position=node.position)

    def _vector(self, name: str, node: Node) -> m.Vector:
        if "short" in node:
            self.problems.add(node.keys["short"], f"the vector '{name}' has no 'short'; remove it")
        elements = node["elements"].plain()
        for i, entry in enumerate(node["elements"]):
            if entry.value in elements[:i]:
                self.problems.add(entry.position, f"'{entry.value}' is used twice in the vector '{name}'; rename one")
        scalar, description = m.SCALARS[node["vector"].value], node.scalar("description", "")
        uncertain = texts_of_node(node, "uncertain")
        return m.Vector(name, scalar, tuple(elements), description, uncertain, position=node.position)

    def _values(self, node: Node) -> tuple[m.EnumValue, ...]:
        places = node["values"].keys
        return tuple(
            m.EnumValue(name, v.value, "", position=places[name])
            if isinstance(v.value, int)
            else m.EnumValue(
                name,
                v["value"].value,
                v.scalar("description", ""),
                v.scalar("deprecated", False),
                texts_of_node(v, "uncertain"),
                short_name(v, name, self.problems),
                self.needs(v),
                places[name],
            )
            for name, v in node["values"].items()
        )

    def _bits(self, node: Node | None, owner: str | None, width: int, when: Node | None = None) -> tuple[m.Bits, ...]:
        several = []
        for name, entry in node.items() if node else ():
            span = self._span(name, entry.get("bit") or entry, width)
            if span is None:
                several.append(_nowhere(name))
                continue
            low, high = span
            place = node.keys[name] if node else None
            enum = self._enum_of(entry, owner)
            description, alias = entry.scalar("description", ""), entry.scalar("alias", False)
            uncertain, short = texts_of_node(entry, "uncertain"), short_name(entry, name, self.problems)
            concerns = texts_of_node(entry, "concerns")
            self.concerned += entry.get("concerns") or ()
            needs, state = self.needs(entry), self._state(entry.get("when") or when, owner)
            several.append(
                m.Bits(name, low, high, description, alias, enum, concerns, uncertain, short, needs, place, state)
            )
        return tuple(several)

    def _state(self, node: Node | None, owner: str | None) -> m.State | None:
        """Resolves `when`: the state in which a bit means something."""
        if node is None:
            return None
        ((parameter, states),) = node.items()
        first = next(iter(states))
        name = first.value.partition(".")[0]
        named = self.find(name, first.position, owner)
        if not isinstance(named, m.Enum):
            if named is not None:
                self.problems.add(first.position, f"'{named.name}' is not an enumeration")
            return None
        numbers = {f"{name}.{v.name}": v.value for v in named.values}
        for state in states:
            if state.value not in numbers:
                near = nearest(state.value, numbers)
                self.problems.add(state.position, f"'{state.value}' is not a value of '{named.name}'{near}")
        values = [state.value for state in states if state.value in numbers]
        return m.State(
            parameter, named.full_name, tuple(v.partition(".")[2] for v in values), tuple(numbers[v] for v in values)
        )

    def needs(self, node: Node) -> tuple[str, ...]:
        """Returns the hardware that a set, a field, a value or a bit requires."""
        self.needed += node.get("needs") or ()
        return texts_of_node(node, "needs")

    def _span(self, name: str, span: Node, width: int) -> tuple[int, int] | None:
        """Parses the lowest and the highest bit from 3 or 3-5."""
        parts = re.fullmatch(r"([0-9]{1,4})(?:-([0-9]{1,4}))?", str(span.value))
        if parts is None:
            self.problems.add(span.position, f"'{name}': '{span.value}' is not a bit; write 3, or 3-5 for a range")
            return None
        low, high = int(parts[1]), int(parts[2] or parts[1])
        if high < low or high >= width:
            wrong = f"write {high}-{low}, the lower bit first" if high < low else f"there are only 0 to {width - 1}"
            self.problems.add(span.position, f"'{name}' is at bit {span.value}; {wrong}")
            return None
        return low, high

    def _included_bits(self, node: Node, owner: str | None, width: int) -> tuple[m.Bits, ...]:
        """Returns the bits of other bitfields that lie in the ranges of `include`."""
        several: list[m.Bits] = []
        own = node.get("bits")
        for name, ranges in node["include"].items() if "include" in node else ():
            place = node["include"].keys[name]
            other = self.find(name, place, owner)
            if not isinstance(other, m.Bitfield):
                if other is not None:
                    self.problems.add(place, f"'{name}' is not a bitfield; include bits of one")
                continue
            for entry in ranges:
                span = self._span(name, entry, width)
                if span is None:
                    continue
                chosen = [b for b in other.bits if span[0] <= b.first and b.last <= span[1]]
                if other.bits and not chosen:
                    self.problems.add(entry.position, f"'{name}' has no bits in {entry.value}; correct the range")
                for bit in chosen:
                    if (own and bit.name in own) or any(b.name == bit.name for b in several):
                        twice = f"'{bit.name}' of '{name}' is already defined here; remove it from {entry.value}"
                        self.problems.add(entry.position, twice)
                    else:
                        several.append(replace(bit, position=entry.position))
        return tuple(several)

    def _enum_of(self, bits: Node, owner: str | None) -> m.Enum | None:
        """Returns the enumeration of a number inside a bitfield."""
        entry = bits.get("enum")
        if entry is None:
            return None
        named = self.find(entry.value, entry.position, owner)
        if isinstance(named, m.Enum):
            return named
        if named is not None:
            self.problems.add(entry.position, f"'{named.name}' is not an enumeration")
        return None

    # ----------------------------------------------------------------------- records

    def record(
        self,
        nodes: Sequence[Node],
        owner: str | None,
        functions: str = "",
        plain: bool = False,
        inside: bool = False,
        whole: Node | None = None,
        unknown: str = "",
    ) -> Record:
        """Resolves the layout of these parameters. `functions`: the letters of a command with a selector.
        `plain`: a response that repeats its command's parameters, whose presence does not matter.
        `inside`: a structure, whose parameters are always present.
        `whole`: the field, whose `valid` applies to all values without their own.
        `unknown`: letters of the command that belong to no function."""
        build = Layout(self, owner, functions, plain, inside, whole, unknown=unknown)
        for node in self.included(nodes, owner):
            build.add(node)
        return build.finish()

    def included(self, nodes: Sequence[Node], owner: str | None) -> Iterator[Node]:
        """Replaces the name of each part by its parameters."""
        parts = self.parts.get(owner or "", {})
        for node in nodes:
            name = node.scalar("include")
            if name is None:
                yield node
            elif name in parts:
                self._included.add((owner or "", name))
                yield from parts[name]
            else:
                near = nearest(name, parts) or "; define it under 'parts' of the set"
                self.problems.add(node["include"].position, f"unknown part '{name}'{near}")

    def unused(self) -> None:
        """Reports the parts that are not included anywhere, because their parameters are never checked."""
        for owner, parts in self.parts.items():
            for name, node in parts.items():
                if (owner, name) not in self._included:
                    self.problems.add(node.position, f"no field includes the part '{name}'; include it, or remove it")


def _described(bits: tuple[m.Bits, ...], marked: Mapping[str, str]) -> tuple[m.Bits, ...]:
    """Describes the bits of validity flags that state nothing else; an alias of several stands for all of them."""
    return tuple(
        b if b.description or not marked else replace(b, description=ALL_VALID if b.alias else marked.get(b.name, ""))
        for b in bits
    )


def _nowhere(name: str) -> m.Bits:
    """Returns a substitute for a bit whose number is wrong, so that references to it are not reported as well."""
    return m.Bits(name, 0, 0, "", alias=True)

"""Turns nodes into parameters.

The wire layout is determined here and nowhere else: sizes, capacities, presence.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from mipgen import model as m
from mipgen.lower import codec, extent
from mipgen.read.nodes import Node
from mipgen.read.problems import nearest

from . import meaning, variation
from .vocabulary import texts_of_node

if TYPE_CHECKING:
    from .types import Types


@dataclass(frozen=True, slots=True)
class Record:
    """The layout of a field or of a structure."""

    parameters: tuple[m.Parameter, ...]
    min_size: int
    max_size: int


@dataclass
class Layout:
    """Resolves the parameters of one record, in wire order."""

    types: Types
    owner: str | None
    functions: str = ""
    plain: bool = False
    inside: bool = False
    whole: Node | None = None  # the field, whose keys may apply to all its values
    before: int = 0  # for a case of a union: the bytes of the record before it
    unknown: str = ""  # letters of the command that are not functions; reported elsewhere
    unclear: bool = False  # a parameter is required for an unknown function, so the order cannot be checked
    nodes: list[Node] = field(default_factory=list)
    done: list[m.Parameter] = field(default_factory=list)

    def problem(self, position: m.Position | None, message: str) -> None:
        self.types.problems.add(position, message)

    @property
    def least(self) -> int:
        """The minimum size of all parameters so far."""
        return self.taken(self.done)

    def taken(self, parameters: Sequence[m.Parameter]) -> int:
        """Returns the minimum size of a field with these parameters."""
        return self.before + (1 if self.functions else 0) + extent.fewest(parameters)

    def earlier(self, name: str) -> m.Parameter | None:
        return next((p for p in self.done if p.name == name), None)

    # ------------------------------------------------------------------ one parameter

    def add(self, node: Node) -> None:
        name = node["name"].value
        if self.earlier(name) or (self.functions and name == "function"):
            self.problem(node["name"].position, f"the parameter '{name}' is defined twice; rename one")
            return
        if self.done and open_ended(self.done[-1]):
            last = self.done[-1].name
            self.problem(node.position, f"'{name}' cannot follow '{last}', which fills the rest of the field")
            return
        parameter = self.union(node) if "switch" in node or "cases" in node else self.value(node)
        if parameter is not None:
            self.done.append(self.meaning(node, parameter))
            self.nodes.append(node)

    def union(self, node: Node) -> m.Parameter | None:
        name = node["name"].value
        if "switch" not in node or "cases" not in node or "type" in node:
            self.problem(node.position, f"the union '{name}' needs switch and cases, and no type")
            return None
        for key in ("count", "const", "reserved", "unit", "frame", "positive"):
            if key in node:
                self.problem(node.keys[key], f"the union '{name}' has no '{key}'; state it in the cases, or remove it")
        tag_name = node["switch"].value
        tag = self.earlier(tag_name)
        if tag is None:
            near = nearest(tag_name, [p.name for p in self.done])
            self.problem(node["switch"].position, f"no parameter '{tag_name}' comes before '{name}'{near}")
            return None
        if not isinstance(tag.element, m.Enum) or tag.length is not None:
            self.problem(node["switch"].position, f"'{tag_name}' is not an enumeration, so it cannot select a case")
            return None
        cases: list[m.Case] = []
        for label, case in node["cases"].items():
            value = tag.element.by_name(label)
            if value is None:
                near = nearest(label, [v.name for v in tag.element.values])
                self.problem(node["cases"].keys[label], f"'{tag.element.name}' has no value '{label}'{near}")
            elif not case.value:
                cases.append(m.Case(value, None))
            else:
                member = self.case(label, case, node["cases"].keys[label])
                if member is None:
                    continue
                if any(c.parameter and c.parameter.name == member.name for c in cases):
                    self.problem(member.position, f"two cases of '{name}' are called '{member.name}'; rename one")
                cases.append(m.Case(value, member))
        missing = [v.name for v in tag.element.values if v.name not in node["cases"].value]
        if missing:
            self.problem(
                node.keys["cases"],
                f"the union '{name}' has no case for {', '.join(missing)} of '{tag.element.name}'; "
                "add one ({} if it is empty)",
            )
        union = m.Union(tag_name, tag.element, tuple(cases), node.scalar("union", ""))
        return m.Parameter(name, None, None, union=union, position=node.position)

    def case(self, label: str, node: Node, place: m.Position) -> m.Parameter | None:
        """Resolves the parameter of a union's case."""
        if "type" not in node:
            self.problem(place, f"the case '{label}' needs a type, or to be empty: {{}}")
            return None
        count = node.scalar("count")
        if isinstance(count, str) and count != m.REST:
            self.problem(
                node["count"].position, f"the case '{label}' cannot be counted; use a structure with a counter"
            )
            return None
        named = Node({**node.value, "name": node.get("name") or Node(label, place)}, place, node.keys)
        alone = Layout(self.types, self.owner, plain=True, before=self.least)
        alone.add(named)
        parameter = next(iter(alone.finish().parameters), None)
        return replace(parameter, description=node.scalar("description", "")) if parameter else None

    def value(self, node: Node) -> m.Parameter | None:
        name = node["name"].value
        if "type" not in node:
            self.problem(node.position, f"the parameter '{name}' needs a type, or switch and cases")
            return None
        type_name = node["type"].value
        element: m.Scalar | m.Type | None = m.SCALARS.get(type_name)
        if element is None:
            element = self.types.find(type_name, node["type"].position, self.owner)
        if element is None:
            return None
        if "const" in node:
            return self.constant(node, name, element)
        length = node.scalar("count")
        if isinstance(element, m.Struct) and element.min_size > m.MAX_FIELD_DATA:
            length = None  # reported for the structure; no need to repeat it for the array
        if length is not None and isinstance(element, m.Struct) and not element.fixed:
            self.problem(node["count"].position, f"the size of '{type_name}' varies, so there can be no array of it")
            return None
        if length is not None and isinstance(element, m.Bitfield) and element.scalar is None:
            self.problem(node["count"].position, f"'{type_name}' is a wide bitfield, so there can be no array of it")
            return None
        if isinstance(length, str) and length != m.REST and not self.counter(node, name, length):
            return None
        return m.Parameter(name, element, length, position=node.position)

    def constant(self, node: Node, name: str, element: m.Scalar | m.Type) -> m.Parameter | None:
        value = node["const"].value
        if not (isinstance(element, m.Scalar) and element.kind == "unsigned" and "count" not in node):
            self.problem(node.keys["const"], f"the constant '{name}' must be one unsigned number")
            return None
        if value >> element.width:
            self.problem(node["const"].position, f"{value} does not fit in {element.name}")
        return m.Parameter(name, element, None, constant=value, position=node.position)

    def counter(self, node: Node, name: str, counter: str) -> bool:
        """Marks the parameter `counter` as the number of elements of `name`."""
        place = node["count"].position
        for i, p in enumerate(self.done):
            if p.name == counter:
                single = isinstance(p.element, m.Scalar) and p.element.kind == "unsigned" and p.length is None
                if not single or p.constant is not None or p.reserved is not None:
                    self.problem(place, f"'{counter}' cannot count '{name}': it is not one unsigned number")
                    return False
                if p.counts:
                    self.problem(place, f"'{counter}' already counts '{p.counts}'; give '{name}' its own counter")
                    return False
                self.done[i] = replace(p, counts=name)
                return True
        near = nearest(counter, [p.name for p in self.done])
        self.problem(place, f"the counter '{counter}' of '{name}' must be a parameter before it{near}")
        return False

    def meaning(self, node: Node, p: m.Parameter) -> m.Parameter:
        """Adds the meaning of the value to the parameter's layout."""
        words = self.types.vocabulary
        named = p.element if isinstance(p.element, (m.Enum, m.Bitfield, m.Struct)) else None
        if limits := meaning.resolve_range(node, p, self.problem):
            p = replace(p, **limits)
        frame = meaning.resolve_frame(node, words.frames, self.problem)
        elements = meaning.frame_elements(p, frame, words.frames)
        if elements and isinstance(p.element, m.Vector):
            wanted = f"vectors in the frame {frame} have the elements {', '.join(elements)}"
            remedy = f"{p.element.name} has {', '.join(p.element.elements)}; use another type"
            self.problem(node["type"].position, f"{wanted}, but {remedy}")
        return replace(
            p,
            reserved=meaning.resolve_reserved(node, p, self.problem),
            description=node.scalar("description", named.description if named else ""),
            units=meaning.resolve_units(node, p, words.units, self.problem),
            any_unit="unit" in node and node["unit"].value is None,
            frame=frame,
            at_rest=meaning.at_rest(node, p, self.problem),
            positive=node.scalar("positive", ""),
            default=meaning.resolve_default(node, p, self.problem),
            shown=node.scalar("shown"),
            fields_of=node.scalar("fields_of", ""),
            valid=meaning.resolve_valid(node),  # judged in `finish`, because the flags usually come last
            required_for=self.presence(node, p),
            optional=self.may_be_absent(node, p),
            by_device=variation.differs_by_device(node),
            deprecated=node.scalar("deprecated", False),
            notes=texts_of_node(node, "notes"),
            uncertain=texts_of_node(node, "uncertain"),
        )

    def presence(self, node: Node, p: m.Parameter) -> tuple[m.Function, ...]:
        """Returns the functions that require a parameter: those that it names, and those that are `like` them."""
        if self.plain:
            return ()
        letters, optional = node.scalar("for"), node.scalar("optional", False)
        if not self.functions:
            if letters is not None:
                self.problem(
                    node.keys["for"], f"'{p.name}' has 'for', but the field has no function selector; remove it"
                )
            return ()
        if (letters is None) == (not optional):
            accepted = "".join(self.functions)
            place = node.keys.get("for", node.position)
            self.problem(place, f"'{p.name}' must state which functions require it: for: {accepted}, or optional: true")
            self.unclear = True
            return ()
        extra = [c for c in letters or "" if c not in self.functions]
        self.unclear = self.unclear or bool(extra)
        extra = [c for c in extra if c not in self.unknown]
        if extra:
            self.problem(
                node["for"].position,
                f"'{p.name}' is required for {''.join(extra)}, but the command accepts only {self.functions}",
            )
        functions = self.types.vocabulary.letters(self.functions)
        named = {f.name for f in functions if f.letter in (letters or "")}
        return tuple(f for f in functions if f.name in named or f.like in named)

    def may_be_absent(self, node: Node, p: m.Parameter) -> bool:
        if self.inside and "optional" in node:
            self.problem(
                node.keys["optional"], f"'{p.name}' is in a structure, where nothing is optional; remove 'optional'"
            )
        return "optional" in node and not self.plain and not self.inside

    # ------------------------------------------------------------------ the whole

    def finish(self) -> Record:
        for node, p in zip(self.nodes, self.done, strict=True):
            if p.valid:
                meaning.valid_bits(node, p, self.done, self.problem)
        if self.whole is not None and "valid" in self.whole:
            self.vouch(self.whole)
        scope = self.types.scope(self.owner)
        self.done = [
            replace(p, variants=variants) if (variants := variation.by_sibling(node, p, self.done, scope)) else p
            for node, p in zip(self.nodes, self.done, strict=True)
        ]
        self.check_size()
        capacities = self.capacities()
        stated = {p.counts: p.maximum for p in self.done if p.counts and p.maximum is not None}
        self.done = [
            replace(p, most=most, stated=int(stated.get(p.name, most))) if (most := capacities.get(p.name)) else p
            for p in self.done
        ]
        parameters = tuple(self.typical(node, p) for node, p in zip(self.nodes, self.done, strict=True))
        if self.functions:
            return self.with_selector(parameters)
        first = next((i for i, p in enumerate(parameters) if p.optional), len(parameters))
        for p in parameters[first:]:
            if not p.optional:
                self.problem(p.position, f"'{p.name}' is required but comes after an optional parameter; reorder them")
        for p in parameters[:first]:
            if p.counts in [q.name for q in parameters[first:]]:
                self.problem(
                    p.position, f"'{p.name}' is required, but the array that it counts is optional; make both optional"
                )
        self.check_groups(parameters[first:])
        return Record(parameters, extent.fewest(parameters[:first]), extent.most(parameters))

    def typical(self, node: Node, p: m.Parameter) -> m.Parameter:
        """Returns the parameter with its typical value, in the codec's canonical form."""
        meaning.check_shown(node, p, self.problem)
        if "typical" not in node:
            return p
        stated, complaints = node["typical"], list[tuple[m.Position, str]]()
        meaning.check_typical(node, p, lambda place, message: complaints.append((place, message)))
        try:
            value = codec.canonical(p, stated.plain(), p.name)
        except ValueError as error:
            for place, message in complaints or [(stated.position, f"the typical value of {error}")]:
                self.problem(place, message)
            return p
        for place, message in complaints:
            self.problem(place, message)
        if p.several and len(value) > p.capacity:
            self.problem(stated.position, f"the typical value of '{p.name}' has {len(value)} items; {p.capacity} fit")
        return replace(p, typical=value)

    def vouch(self, whole: Node) -> None:
        """Applies the field's `valid` to each value without its own, except to the flags and derived values."""
        flags = whole["valid"].value.partition(".")[0]
        concerned = [
            i
            for i, (node, p) in enumerate(zip(self.nodes, self.done, strict=True))
            if not ("valid" in node or p.name == flags or p.derived or p.reserved is not None)
        ]
        for i in concerned:
            self.done[i] = replace(self.done[i], valid=meaning.resolve_valid(whole))
        if concerned:
            meaning.valid_bits(whole, self.done[concerned[0]], self.done, self.problem)
        else:
            self.problem(whole.keys["valid"], "each value has a 'valid' of its own; remove that of the field")

    def with_selector(self, parameters: tuple[m.Parameter, ...]) -> Record:
        words = self.types.vocabulary
        selector = m.Parameter("function", words.selector, None, "Operation on the setting.", selector=True)
        if not self.unclear and self.check_order(parameters):
            self.check_groups(parameters)
        whole = (selector, *parameters)
        return Record(whole, selector.size, extent.most(whole))

    def check_order(self, parameters: Sequence[m.Parameter]) -> bool:
        """Reports each parameter that a function does not require although it requires a later one."""
        late: dict[tuple[str, str], list[str]] = {}
        places = {p.name: p.position for p in parameters}
        for function in self.types.vocabulary.letters(self.functions):
            needs = [function in p.required_for for p in parameters]
            if not all(needs[: sum(needs)]):
                first = needs.index(False)
                behind = needs.index(True, first)
                late.setdefault((parameters[first].name, parameters[behind].name), []).append(function.name)
        for (early, name), functions in late.items():
            self.problem(
                places[name],
                f"'{name}' is required for {', '.join(functions)}, but '{early}' before it is not; "
                "what a function requires must come first",
            )
        return not late

    def check_groups(self, parameters: Sequence[m.Parameter]) -> None:
        """Requires that the presence of optional parameters is detectable, and the same for a counter and its array."""
        for group in m.optional_groups(parameters, 0):
            first, last = group.parameters[0], group.parameters[-1]
            if all(p.constant is not None for p in group.parameters):
                self.problem(
                    first.position,
                    f"the constant '{first.name}' may be absent, but its absence cannot be detected; "
                    "put it before every parameter that may be absent",
                )
            for p in group.parameters:
                if p.required_for != first.required_for or p.optional != first.optional:
                    what = f"all from '{first.name}' to '{last.name}'"
                    self.problem(
                        p.position, f"a counter and its array must be present together; give {what} the same 'for'"
                    )
                    break

    def check_size(self) -> None:
        """Reports the parameter that makes even the shortest form of a field too long."""
        used = self.before + (1 if self.functions else 0)
        for p in self.done:
            used += extent.size(p)[0]
            if isinstance(p.element, m.Struct) and p.element.min_size > m.MAX_FIELD_DATA:
                return  # reported for the structure
            if used > m.MAX_FIELD_DATA:
                self.problem(
                    p.position, f"with '{p.name}' the field has {used} bytes of data; the maximum is {m.MAX_FIELD_DATA}"
                )
                return

    def capacities(self) -> dict[str, int]:
        """Returns the maximum number of items of each array without a fixed length, if no optional parameter is
        present."""
        capacities = {}
        for i, p in enumerate(self.done):
            if isinstance(p.length, str):
                before, behind = self.done[: i + 1], self.done[i + 1 :]
                always = [*before, *(q for q in behind if not (self.functions or q.optional))]
                most = max(0, m.MAX_FIELD_DATA - self.taken(always)) // max(1, extent.item_size(p))
                counter = self.earlier(p.length)
                if counter is not None and isinstance(counter.element, m.Scalar):
                    most = min(most, (1 << counter.element.width) - 1)
                capacities[p.name] = most
        return capacities


def open_ended(p: m.Parameter) -> bool:
    """True if a parameter extends, or could extend, to the end of the field."""
    if p.struct:
        return bool(p.struct.parameters) and open_ended(p.struct.parameters[-1])
    return p.union is not None or p.fills

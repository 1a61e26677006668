"""Turns parameters into operations, and type definitions into types.

What the wire looks like is decided here: sizes, capacities, presence. Nothing downstream computes.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

from . import model as m
from .loader import Node
from .problems import Problems, nearest

REST = "rest"


@dataclass(frozen=True, slots=True)
class Record:
    """The layout of a field or of a structure."""

    parameters: tuple[m.Parameter, ...]
    operations: tuple[m.Operation, ...]
    min_size: int
    max_size: int
    required: tuple[tuple[int, int], ...] = ()
    required_count: int = 0


@dataclass
class Vocabulary:
    """What names may refer to: units, frames, manuals, devices and function selectors."""

    units: set[str]
    frames: set[str]
    manuals: set[str]
    devices: set[str]
    functions: tuple[m.Function, ...]
    selector: m.Enum

    def letters(self, text: str) -> tuple[m.Function, ...]:
        return tuple(f for f in self.functions if f.letter in text)


@dataclass
class Types:
    """Finds types by name: first those of the set, then those of spec/types. Resolves on demand."""

    vocabulary: Vocabulary
    problems: Problems
    shared: dict[str, Node] = field(default_factory=dict)
    local: dict[str, dict[str, Node]] = field(default_factory=dict)
    _done: dict[tuple[str | None, str], m.Type | None] = field(default_factory=dict)
    _open: list[str] = field(default_factory=list)

    def define(self, owner: str | None, types: Node | None) -> None:
        """Makes the types of a file known."""
        known = self.shared if owner is None else self.local.setdefault(owner, {})
        for name, node in types.items() if types else ():
            place = types.keys[name] if types else node.position
            if name in known or name in self.shared or name in m.SCALARS:
                self.problems.add(place, f"the type '{name}' is defined already; choose another name")
            else:
                known[name] = node

    def of(self, owner: str | None) -> tuple[m.Type, ...]:
        """All types of one owner, each after those that it uses."""
        known = self.shared if owner is None else self.local.get(owner, {})
        for name in known:
            self.find(name, owner, None)
        return tuple(t for (o, _), t in self._done.items() if o == owner and t is not None)

    def find(self, name: str, owner: str | None, position: m.Position | None) -> m.Type | None:
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
                self.problems.add(node.position, f"the type contains itself: {loop}")
                return None
            self._open.append(name)
            found = self._resolve(name, where, node)
            self._open.pop()
            self._done[where, name] = found
        return self._done[where, name]

    def _resolve(self, name: str, owner: str | None, node: Node) -> m.Type | None:
        kinds = [k for k in ("enum", "bitfield", "bytes", "struct", "vector") if k in node]
        if len(kinds) != 1:
            wanted = "exactly one of enum, bitfield, bytes, struct, vector"
            self.problems.add(node.position, f"the type '{name}' needs {wanted}")
            return None
        parts = {"enum": "values", "bitfield": "bits", "bytes": "bits", "vector": "elements"}
        part = parts.get(kinds[0])
        for other in ("values", "bits", "elements"):
            if (other in node) != (other == part):
                fault = "is missing in" if other == part else "does not belong into"
                self.problems.add(node.position, f"'{other}' {fault} the {kinds[0]} '{name}'")
                return None
        description = node.scalar("description", "")
        if kinds[0] == "vector":
            scalar = m.SCALARS[node["vector"].value]
            return m.Vector(name, scalar, tuple(node["elements"].plain()), description)
        origin = (description, owner, sources(node, self.vocabulary, self.problems))
        if kinds[0] == "enum":
            return m.Enum(name, m.SCALARS[node["enum"].value], self._values(node), *origin, position=node.position)
        if kinds[0] == "struct":
            record = self.record(list(node["struct"]), owner, "")
            return m.Struct(
                name, record.parameters, record.operations, record.min_size, record.max_size, *origin,
                position=node.position,
            )  # fmt: skip
        base = m.SCALARS[node["bitfield"].value] if "bitfield" in node else None
        size = base.size if base else node["bytes"].value
        return m.Bitfield(name, base, size, self._bits(node, owner, size * 8), *origin, position=node.position)

    def _values(self, node: Node) -> tuple[m.EnumValue, ...]:
        return tuple(
            m.EnumValue(name, v.value, "")
            if isinstance(v.value, int)
            else m.EnumValue(name, v["value"].value, v.scalar("description", ""), v.scalar("deprecated", False))
            for name, v in node["values"].items()
        )

    def _bits(self, node: Node, owner: str | None, width: int) -> tuple[m.Bits, ...]:
        found = []
        for name, entry in node["bits"].items():
            whole = isinstance(entry.value, dict)
            span = (entry.scalar("bits") or entry.scalar("bit")) if whole else entry.value
            if whole and ("bit" in entry) == ("bits" in entry):
                self.problems.add(entry.position, f"'{name}' needs either bit: 3 or bits: 3-5")
                continue
            first, _, last = str(span if span is not None else 0).partition("-")
            if not (first.isdigit() and (last.isdigit() or not last)):
                self.problems.add(entry.position, f"'{name}': '{span}' is no bit; write 3 or 3-5")
                continue
            low, high = int(first), int(last or first)
            if high < low or high >= width:
                self.problems.add(entry.position, f"'{name}': bits {span} do not lie in 0-{width - 1}")
                continue
            enum = None
            if whole and "enum" in entry:
                enum = self.find(entry["enum"].value, owner, entry["enum"].position)
                if enum is not None and not isinstance(enum, m.Enum):
                    self.problems.add(entry["enum"].position, f"'{enum.name}' is no enumeration")
                    enum = None
            description = entry.scalar("description", "") if whole else ""
            alias = entry.scalar("alias", False) if whole else False
            found.append(m.Bits(name, low, high, description, alias, enum))
        return tuple(found)

    # ----------------------------------------------------------------------- records

    def record(self, nodes: Sequence[Node], owner: str | None, functions: str, plain: bool = False) -> Record:
        """The layout of these parameters. `functions`: letters of a command that has a selector.
        `plain`: a response that repeats its command's parameters, where presence plays no part."""
        build = _Build(self, owner, functions, plain)
        for node in nodes:
            build.add(node)
        return build.finish()


@dataclass
class _Build:
    """Works through the parameters of one record, in wire order."""

    types: Types
    owner: str | None
    functions: str
    plain: bool
    nodes: list[Node] = field(default_factory=list)
    done: list[m.Parameter] = field(default_factory=list)

    def problem(self, position: m.Position, message: str) -> None:
        self.types.problems.add(position, message)

    def earlier(self, name: str) -> m.Parameter | None:
        return next((p for p in self.done if p.name == name), None)

    # ------------------------------------------------------------------ one parameter

    def add(self, node: Node) -> None:
        name = node["name"].value
        if self.earlier(name) or (self.functions and name == "function"):
            self.problem(node["name"].position, f"the parameter '{name}' stands twice; rename one")
            return
        if self.done and _open_ended(self.done[-1].operation):
            last = self.done[-1].name
            self.problem(node.position, f"'{name}' cannot follow '{last}', which reaches to the end of the field")
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
        tag_name = node["switch"].value
        tag = self.earlier(tag_name)
        if tag is None:
            near = nearest(tag_name, [p.name for p in self.done])
            self.problem(node["switch"].position, f"no parameter '{tag_name}' comes before '{name}'{near}")
            return None
        if not isinstance(tag.element, m.Enum) or tag.length is not None:
            self.problem(node["switch"].position, f"'{tag_name}' is no enumeration, so it cannot select a case")
            return None
        cases = []
        for label, case in node["cases"].items():
            value = tag.element.by_name(label)
            if value is None:
                near = nearest(label, [v.name for v in tag.element.values])
                self.problem(node["cases"].keys[label], f"'{tag.element.name}' has no value '{label}'{near}")
            elif not case.value:
                cases.append(m.Case(value, None, None))
            else:
                member = self.case(label, case)
                if member is not None:
                    cases.append(m.Case(value, member, member.operation))
        missing = [v.name for v in tag.element.values if v.name not in node["cases"].value]
        if missing:
            self.problem(
                node["cases"].position,
                f"the union '{name}' has no case for {', '.join(missing)} of '{tag.element.name}'; "
                "add one ({} if it is empty)",
            )
        op = m.SwitchOp(name, tag_name, tag.element, tuple(cases))
        return m.Parameter(name, None, None, op, tag=tag_name, cases=tuple(cases), position=node.position)

    def case(self, label: str, node: Node) -> m.Parameter | None:
        if "type" not in node:
            self.problem(node.position, f"the case '{label}' needs a type, or to be empty: {{}}")
            return None
        named = Node({**node.value, "name": node.get("name") or Node(label, node.position)}, node.position)
        alone = _Build(self.types, self.owner, "", True)
        alone.add(named)
        return alone.done[0] if alone.done else None

    def value(self, node: Node) -> m.Parameter | None:
        name = node["name"].value
        if "type" not in node:
            self.problem(node.position, f"the parameter '{name}' needs a type, or switch and cases")
            return None
        type_name = node["type"].value
        element: m.Scalar | m.Type | None = m.SCALARS.get(type_name)
        if element is None:
            element = self.types.find(type_name, self.owner, node["type"].position)
        if element is None:
            return None
        if "const" in node:
            return self.constant(node, name, element)
        length = node.scalar("count")
        if length is not None and isinstance(element, m.Struct) and not element.fixed:
            self.problem(node.position, f"'{name}' is an array of '{type_name}', whose size varies; that cannot be read")
            return None
        if isinstance(length, str) and length != REST and not self.counter(node, name, length):
            return None
        op = operation(name, element, length)
        reserved = node.scalar("reserved")
        if reserved is not None and not _whole(element):
            self.problem(node.position, f"the reserved parameter '{name}' must be a whole number")
        return m.Parameter(name, element, length, op, reserved=reserved, position=node.position)

    def constant(self, node: Node, name: str, element: m.Scalar | m.Type) -> m.Parameter | None:
        value = node["const"].value
        if not (isinstance(element, m.Scalar) and element.kind == "unsigned" and "count" not in node):
            self.problem(node.position, f"the constant '{name}' must be one unsigned number")
            return None
        if value >> (8 * element.size):
            self.problem(node["const"].position, f"{value} does not fit into {element.name}")
        op = m.ConstantOp(name, element, value, element.size)
        return m.Parameter(name, element, None, op, constant=value, position=node.position)

    def counter(self, node: Node, name: str, counter: str) -> bool:
        """Marks the parameter `counter` as the number of elements of `name`."""
        place = node["count"].position
        for i, p in enumerate(self.done):
            if p.name == counter:
                single = isinstance(p.element, m.Scalar) and p.element.kind == "unsigned" and p.length is None
                if not single or p.constant is not None:
                    self.problem(place, f"'{counter}' cannot count '{name}': it is not one unsigned number")
                    return False
                if p.counts:
                    self.problem(place, f"'{counter}' counts '{p.counts}' already; give '{name}' its own counter")
                    return False
                assert isinstance(p.element, m.Scalar)
                op = m.CounterOp(counter, p.element, name, p.element.size)
                self.done[i] = replace(p, counts=name, operation=op)
                return True
        near = nearest(counter, [p.name for p in self.done])
        self.problem(place, f"the counter '{counter}' of '{name}' must be a parameter before it{near}")
        return False

    def meaning(self, node: Node, p: m.Parameter) -> m.Parameter:
        """Adds what the value means to how it is laid out."""
        words = self.types.vocabulary
        unit = node.get("unit")
        units = () if unit is None else tuple(unit.plain()) if isinstance(unit.value, list) else (unit.value,)
        for symbol in units:
            if symbol not in words.units:
                assert unit is not None
                self.problem(unit.position, f"unknown unit '{symbol}'{nearest(symbol, words.units)}")
        width = len(p.element.elements) if isinstance(p.element, m.Vector) else p.length
        if len(units) > 1 and len(units) != width:
            self.problem(node["unit"].position, f"'{p.name}' has {len(units)} units; give one, or one for each element")
        frame = node.scalar("frame")
        if frame is not None and frame not in words.frames:
            self.problem(node["frame"].position, f"unknown frame '{frame}'{nearest(frame, words.frames)}")
        low, high = node["range"].plain() if "range" in node else (None, None)
        if low is not None and high is not None and low > high:
            self.problem(node["range"].position, f"the range of '{p.name}' is empty; write the smaller number first")
        return replace(
            p,
            description=node.scalar("description", ""),
            units=units,
            frame=frame,
            minimum=low,
            maximum=high,
            default=self.default(node, p),
            valid_when=self.valid(node),
            reading=self.reading(node, p),
            functions=self.presence(node, p),
            optional=node.scalar("optional", False) and not self.plain,
            deprecated=node.scalar("deprecated", False),
            notes=tuple(node["notes"].plain()) if "notes" in node else (),
        )

    def default(self, node: Node, p: m.Parameter) -> object:
        if "default" not in node:
            return None
        value: object = node["default"].plain()
        if isinstance(p.element, m.Enum) and isinstance(value, str) and p.element.by_name(value) is None:
            near = nearest(value, [v.name for v in p.element.values])
            self.problem(node["default"].position, f"'{p.element.name}' has no value '{value}'{near}")
        return value

    def valid(self, node: Node) -> str | None:
        """Checked in `finish`, because the flags usually stand last."""
        found: str | None = node.scalar("valid")
        return found

    def reading(self, node: Node, p: m.Parameter) -> m.Reading | None:
        if "read_as" not in node:
            return None
        spec = node["read_as"]
        by = spec["by"].value
        if by == "device":
            choices = sorted(self.types.vocabulary.devices)
        else:
            sibling = self.earlier(by)
            if sibling is None or not isinstance(sibling.element, m.Enum):
                near = nearest(by, ["device", *(q.name for q in self.done)])
                self.problem(spec["by"].position, f"'{by}' is neither 'device' nor an enumeration before '{p.name}'{near}")
                return None
            choices = [v.name for v in sibling.element.values]
        found = []
        for key, entry in spec["types"].items():
            if key not in choices:
                self.problem(spec["types"].keys[key], f"'{key}' is not known to '{by}'{nearest(key, choices)}")
            t = self.types.find(entry.value, self.owner, entry.position)
            if t is None:
                continue
            if not isinstance(t, (m.Enum, m.Bitfield)):
                self.problem(entry.position, f"'{t.name}' is neither an enumeration nor a bitfield")
            elif _size(p.operation)[1] != (t.scalar.size if isinstance(t, m.Enum) else t.size):
                self.problem(entry.position, f"'{t.name}' does not have the size of '{p.name}'")
            else:
                found.append((key, t))
        return m.Reading(by, tuple(found))

    def presence(self, node: Node, p: m.Parameter) -> str | None:
        if self.plain:
            return None
        letters, optional = node.scalar("for"), node.scalar("optional", False)
        if not self.functions:
            if letters is not None:
                self.problem(node["for"].position, f"'{p.name}' has 'for', but its record has no functions; remove it")
            return None
        if (letters is None) == (not optional):
            known = "".join(self.functions)
            self.problem(node.position, f"'{p.name}' must say for which functions it is required: for: {known}, or optional: true")
            return ""
        extra = [c for c in letters or "" if c not in self.functions]
        if extra:
            self.problem(node["for"].position, f"'{p.name}' names the functions {''.join(extra)}, which the command does not have")
        letters = letters or ""
        return letters + "A" if "W" in letters and "A" in self.functions and "A" not in letters else letters

    # ------------------------------------------------------------------ the whole

    def finish(self) -> Record:
        self.check_valid_bits()
        capacities = self.capacities()
        parameters = tuple(replace(p, operation=_with_capacity(p.operation, capacities)) for p in self.done)
        if self.functions:
            return self.with_selector(parameters)
        first = next((i for i, p in enumerate(parameters) if p.optional), len(parameters))
        for p in parameters[first:]:
            if not p.optional:
                place = p.position or m.Position("<spec>", 1, 1)
                self.problem(place, f"'{p.name}' is required but comes after an optional parameter; reorder them")
        always = tuple(p.operation for p in parameters[:first])
        groups = self.groups(parameters[first:], first)
        return Record(
            parameters, always + groups, sum(_size(o)[0] for o in always),
            min(m.MAX_FIELD_DATA, sum(_size(p.operation)[1] for p in parameters)), (), first,
        )  # fmt: skip

    def with_selector(self, parameters: tuple[m.Parameter, ...]) -> Record:
        words = self.types.vocabulary
        u8 = m.SCALARS["u8"]
        op = m.ScalarOp("function", u8, words.selector, 1)
        selector = m.Parameter("function", words.selector, None, op, "What to do with the setting.", selector=True)
        required = []
        for function in words.letters(self.functions):
            needs = [function.letter in (p.functions or "") for p in parameters]
            count = sum(needs)
            if not all(needs[:count]):
                late = parameters[len(needs) - 1 - needs[::-1].index(True)]
                place = late.position or m.Position("<spec>", 1, 1)
                self.problem(
                    place,
                    f"'{late.name}' is required for {function.name}, but a parameter before it is not; "
                    "what a function requires must come first",
                )
            required.append((function.value, count))
        whole = min(m.MAX_FIELD_DATA, 1 + sum(_size(p.operation)[1] for p in parameters))
        return Record((selector, *parameters), (op, *self.groups(parameters, 0)), 1, whole, tuple(required), 0)

    def groups(self, parameters: Sequence[m.Parameter], before: int) -> tuple[m.Operation, ...]:
        """Parameters that come and go together: one each, but a counter keeps up to its array."""
        names = [p.name for p in parameters]
        found: list[m.Operation] = []
        i = 0
        while i < len(parameters):
            end = i
            j = i
            while j <= end:
                counted = parameters[j].counts
                if counted in names:
                    end = max(end, names.index(counted))
                j += 1
            members = parameters[i : end + 1]
            for p in members:
                if p.functions != members[0].functions or p.optional != members[0].optional:
                    place = p.position or m.Position("<spec>", 1, 1)
                    self.problem(place, f"'{p.name}' and its counter must be required for the same functions")
                    break
            found.append(m.GroupOp(before + i + 1, before + end + 1, tuple(p.operation for p in members)))
            i = end + 1
        return tuple(found)

    def check_valid_bits(self) -> None:
        names = {p.name: p for p in self.done}
        for node, p in zip(self.nodes, self.done, strict=True):
            if p.valid_when is None:
                continue
            flags, _, bit = p.valid_when.partition(".")
            place = node["valid"].position
            other = names.get(flags)
            if other is None:
                self.problem(place, f"there is no parameter '{flags}' beside '{p.name}'{nearest(flags, names)}")
                continue
            readable = [other.element, *(t for _, t in (other.reading.types if other.reading else ()))]
            fields = [t for t in readable if isinstance(t, m.Bitfield)]
            known = {b.name for t in fields for b in t.bits}
            if bit not in known:
                self.problem(place, f"'{flags}' has no bit '{bit}'{nearest(bit, known)}")

    def capacities(self) -> dict[str, int]:
        """How many items each array of open length can hold at most."""
        least = (1 if self.functions else 0) + sum(_size(p.operation)[0] for p in self.done)
        if least > m.MAX_FIELD_DATA:
            place = self.nodes[0].position
            self.problem(place, f"{least} bytes do not fit into the {m.MAX_FIELD_DATA} data bytes of a field")
        found = {}
        for p in self.done:
            if isinstance(p.length, str):
                op = p.operation
                assert isinstance(op, (m.ArrayOp, m.TextOp))
                item = 1 if isinstance(op, m.TextOp) else _size(op.item)[1]
                most = max(0, m.MAX_FIELD_DATA - least) // item
                counter = self.earlier(p.length)
                if counter is not None and isinstance(counter.element, m.Scalar):
                    most = min(most, (1 << (8 * counter.element.size)) - 1)
                found[p.name] = most
        return found


# --------------------------------------------------------------------------- helpers


def operation(name: str, element: m.Scalar | m.Type, length: int | str | None) -> m.Operation:
    """How one value, or `length` of them, are read and written."""
    single = _single(name if length is None else "item", element)
    if length is None:
        return single
    count = length if isinstance(length, int) else None
    counter = length if isinstance(length, str) and length != REST else None
    if isinstance(element, m.Scalar) and element.kind == "char":
        return m.TextOp(name, count, counter, count or 0)
    assert isinstance(single, (m.ScalarOp, m.StructOp, m.ArrayOp))
    return m.ArrayOp(name, single, count, counter, count or 0)


def _single(name: str, element: m.Scalar | m.Type) -> m.Operation:
    match element:
        case m.Scalar():
            return m.ScalarOp(name, element, None, element.size)
        case m.Enum():
            return m.ScalarOp(name, element.scalar, element, element.scalar.size)
        case m.Bitfield():
            if element.scalar is None:
                return m.BitsOp(name, element, element.size)
            return m.ScalarOp(name, element.scalar, element, element.size)
        case m.Vector():
            item = m.ScalarOp("item", element.scalar, None, element.scalar.size)
            count = len(element.elements)
            return m.ArrayOp(name, item, count, None, count, element)
        case m.Struct():
            return m.StructOp(name, element)


def _size(op: m.Operation | None) -> tuple[int, int]:
    """The fewest and the most bytes of an operation."""
    match op:
        case None:
            return 0, 0
        case m.ScalarOp() | m.ConstantOp() | m.CounterOp() | m.BitsOp():
            return op.size, op.size
        case m.TextOp():
            return op.count or 0, op.capacity
        case m.ArrayOp():
            item = _size(op.item)[1]
            return (op.count or 0) * item, op.capacity * item
        case m.StructOp():
            return op.struct.min_size, op.struct.max_size
        case m.SwitchOp():
            sizes = [_size(c.operation) for c in op.cases] or [(0, 0)]
            return 0, max(s[1] for s in sizes)
        case m.GroupOp():
            return 0, sum(_size(o)[1] for o in op.body)


def _with_capacity(op: m.Operation, capacities: dict[str, int]) -> m.Operation:
    if isinstance(op, (m.ArrayOp, m.TextOp)) and op.count is None:
        return replace(op, capacity=capacities.get(op.member, 0))
    return op


def _open_ended(op: m.Operation) -> bool:
    """Does it reach to the end of the field, or could it, for all that a reader knows?"""
    match op:
        case m.SwitchOp():
            return True
        case m.ArrayOp() | m.TextOp():
            return op.count is None and op.counter is None
        case m.StructOp():
            return bool(op.struct.operations) and _open_ended(op.struct.operations[-1])
        case _:
            return False


def _whole(element: m.Scalar | m.Type) -> bool:
    return isinstance(element, m.Scalar) and element.kind in ("unsigned", "signed")


def sources(node: Node, vocabulary: Vocabulary, problems: Problems) -> tuple[m.Source, ...]:
    """The `sources` of a node, with unknown manuals reported."""
    found = []
    for entry in node.get("sources") or ():
        manual = entry["manual"].value
        if manual not in vocabulary.manuals:
            problems.add(entry["manual"].position, f"unknown manual '{manual}'{nearest(manual, vocabulary.manuals)}")
        length = entry.scalar("length")
        found.append(m.Source(manual, entry["section"].value, None if length is None else str(length), entry.position))
    return tuple(found)


def names_of(parameters: Iterable[m.Parameter]) -> list[str]:
    return [p.name for p in parameters]

"""Resolves devices: the fields that each supports, and the meaning of values that differ."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from mipgen import model as m
from mipgen.read.nodes import Node
from mipgen.read.problems import Problems, elsewhere, nearest

from . import inheritance, meaning
from .types import Types
from .variation import UNKNOWN, resolve_variant
from .vocabulary import check_able, check_needs, hardware, left, needed_hardware, sources_of_node, texts_of_node

#: The keys that a profile must have unless it is declared incomplete.
REQUIRED = ("supports", "base_rates", "ack_codes")


def resolve(nodes: list[Node], families: list[Node], model: m.Model, types: Types, problems: Problems) -> m.Model:
    """Adds the devices to the model, and their differences to its parameters."""
    names = [name for node in nodes for name in (node["title"], *(node.get("also") or ()))]
    _unique((node["name"] for node in nodes), "two devices are called '{}', {}; rename one", problems)
    _unique(names, "two devices are titled '{}', {}; rename one", problems)
    numbers = (node["model_number"] for node in nodes if "model_number" in node)
    _unique(numbers, "two devices have the model number {}, {}; correct one", problems)
    nodes = sorted(nodes, key=lambda node: str(node["device"].value))
    check_needs((*nodes, *families), types.needed, problems)
    whole = inheritance.resolve(nodes, families, model, problems)
    variants = [(path, v) for node in whole for path, v in _variants(node, model, types, problems)]
    model = _with_variants(model, variants)
    made = tuple(_Device(node, model, types, problems).resolve() for node in whole)
    model = replace(model, devices=made)
    _check_series(model, problems)
    _check_layouts(model, problems)
    return model


def known_by_name(nodes: list[Node], model: m.Model, problems: Problems) -> tuple[m.NamedDevice, ...]:
    """Resolves the devices of which only the names are known. No name or number may be that of another device."""
    ids = {d.id for d in model.devices}
    taken: set[object] = {x for d in model.devices for x in (d.id, d.title, *d.also, d.model_number)}
    made = []
    for node in nodes:
        also = tuple(node["also"].plain()) if "also" in node else ()
        numbers = [node["model_number"]] if "model_number" in node else []
        for own in (node["device"], node["title"], *(node.get("also") or ()), *numbers):
            if own.value in taken:
                problems.add(own.position, f"another device has '{own.value}'; correct one")
            taken.add(own.value)
        like = node["like"]
        if like.value not in ids:
            problems.add(like.position, f"unknown device '{like.value}'{nearest(like.value, ids)}")
        made.append(
            m.NamedDevice(node["device"].value, node["title"].value, like.value, also, node.scalar("model_number"))
        )
    return tuple(sorted(made, key=lambda d: d.id))


def _check_layouts(model: m.Model, problems: Problems) -> None:
    """Requires that a device which sends a layout of a response supports a command that is answered with it."""
    for f in (f for f in model.fields if f.devices):
        able = {d.id for c in model.commands(f) for d, s in model.supports(c) if s.responds}
        for name in f.devices:
            if name not in able and model.device(name) is not None:
                remedy = f"add '{f.family}.{f.command}' to what it supports, or remove it from devices"
                problems.add(f.position, f"the device '{name}' does not send '{f.full_name}': {remedy}")


def _check_series(model: m.Model, problems: Problems) -> None:
    """Requires that what a note says of a series is in `varies` of each of its devices that supports the field."""
    for f in model.fields:
        for series in sorted({int(n) for note in f.notes for n in re.findall(r"\b([0-9])-series", note)}):
            for d in (d for d, _ in model.supports(f) if d.generation == series):
                if all(v.field.full_name != f.full_name for v in d.variants):
                    remedy = "add to varies of the device or its family what the note states"
                    wrong = f"a note of '{f.full_name}' is about the {series}-series, but nothing differs on the device"
                    problems.add(d.position, f"{wrong}; {remedy}")


def _by_strength(evidence: Iterable[m.Evidence]) -> tuple[m.Evidence, ...]:
    """Returns the evidence without duplicates, the strongest first."""
    return tuple(dict.fromkeys(sorted(evidence, key=lambda e: m.strength(e.kind))))


def _twice(name: str, a: m.Evidence, b: m.Evidence) -> str | None:
    """Returns the problem with two statements about a field, if there is one. A device may list what others state, and
    list it again with another firmware."""
    listed = [e.kind for e in (a, b)].count("listed")
    if listed == 1 and "refused" in (a.kind, b.kind) and a.firmware == b.firmware and a.firmware is not None:
        return f"'{name}' is listed and refused by the firmware {a.firmware}; remove one"
    if listed == 0 or (listed == 2 and a.firmware == b.firmware):
        return f"'{name}' is listed twice; remove one"
    return None


def _number(set_name: str) -> int | None:
    """Parses the number of a set that has no name.

    >>> _number("0x0F"), _number("0x00"), _number("rtk")
    (15, None, None)
    """
    return (int(set_name, 16) or None) if re.fullmatch("0x[0-9A-Fa-f]{2}", set_name) else None


def _unique(entries: Iterable[Node], message: str, problems: Problems) -> None:
    seen: dict[object, Node] = {}
    for entry in entries:
        earlier = seen.setdefault(entry.value, entry)
        if earlier is not entry:
            problems.add(entry.position, message.format(entry.value, elsewhere(earlier)))


# --------------------------------------------------------------------------- variants


def _variants(node: Node, model: m.Model, types: Types, problems: Problems) -> Iterable[tuple[str, m.Variant]]:
    """Resolves `varies` of a device: yields the path of each parameter, and its facts on the device."""
    device, spec, owned, stated = node["device"].value, node.get("varies"), hardware(node), set()
    for path, case in spec.items() if spec else ():
        assert spec is not None
        name, _, last = path.rpartition(".")
        f = model.field(name)
        if f is None:
            near = nearest(name, [x.full_name for x in (*model.fields, model.protocol.acknowledge)])
            problems.add(spec.keys[path], f"'{path}' is not a set.field.parameter: unknown field '{name}'{near}")
            continue
        p = next((p for p in f.parameters if p.name == last), None)
        if p is None:
            near = nearest(last, [p.name for p in f.parameters])
            problems.add(spec.keys[path], f"'{name}' has no parameter '{last}'{near}")
            continue
        v = resolve_variant(case, p, m.DEVICE, device, None, types.scope(f.family))
        for entry in (*(case.get("values") or ()), *(case.get("bits") or ())) if case.value != UNKNOWN else ():
            named = next((x for x in v.only if x.name == entry.value), None)
            check_able(entry.value, owned.lacking(named.needs) if named else None, entry, problems)
        yield f"{f.full_name}.{last}", replace(v, only=left(v.type or p.element, owned, v.only) or v.only)
        stated.add((f.full_name, last))
    for f in _supported(node, model):  # a response has the values of its command
        for p in f.parameters:
            few = left(p.element, owned) if (f.full_name, p.name) not in stated else ()
            if few:
                yield f"{f.full_name}.{p.name}", m.Variant(m.DEVICE, device, only=few)


def _supported(node: Node, model: m.Model) -> Iterator[m.Field]:
    """Yields the commands and data fields of a profile."""
    lists = [node["supports"]] if "supports" in node else []
    lists += [g["fields"] for g in node.get("evidence") or () if g["kind"].value != "refused"]
    names = dict.fromkeys(f"{name}.{x.value}" for group in lists for name, entries in group.items() for x in entries)
    yield from {f.full_name: f for name in names if (f := model.field(name)) is not None}.values()


def _with_variants(model: m.Model, variants: list[tuple[str, m.Variant]]) -> m.Model:
    """Adds variants to the parameters of fields."""
    by_path: dict[str, list[m.Variant]] = {}
    for path, v in variants:
        by_path.setdefault(path, []).append(v)

    concerned = {path.rpartition(".")[0] for path in by_path}

    def varied(f: m.Field) -> m.Field:
        if f.full_name not in concerned:
            return f
        parameters = (
            replace(p, variants=(*p.variants, *by_path.get(f"{f.full_name}.{p.name}", ()))) for p in f.parameters
        )
        return replace(f, parameters=tuple(parameters))

    protocol = replace(model.protocol, acknowledge=varied(model.protocol.acknowledge))
    families = tuple(replace(x, fields=tuple(varied(f) for f in x.fields)) for x in model.families)
    return replace(model, protocol=protocol, families=families)


def _by_device(model: m.Model) -> dict[str, list[m.DeviceVariant]]:
    """Returns the variants of parameters by device."""
    by_device: dict[str, list[m.DeviceVariant]] = {}
    for f in (model.protocol.acknowledge, *model.fields):
        for p in f.parameters:
            for v in p.variants:
                if v.by_device:
                    by_device.setdefault(v.key, []).append(m.DeviceVariant(f, p, v))
    return by_device


def _asked(model: m.Model) -> dict[int, dict[str, m.Field]]:
    """Returns the command or data field by set and name, for everything that a device may support."""
    return {s.number: {f.name: f for f in model.fields_in(s) if f.role != m.RESPONSE} for s in model.sets}


# --------------------------------------------------------------------------- one device


@dataclass(frozen=True, slots=True)
class _Device:
    node: Node
    model: m.Model
    types: Types
    problems: Problems

    @property
    def id(self) -> str:
        return str(self.node["device"].value)

    def place(self, key: str) -> m.Position:
        """Returns the position for an omission: the key that lacks the entry, else the device."""
        return self.node.keys.get(key, self.node.position)

    def resolve(self) -> m.Device:
        node = self.node
        self.complete()
        manual = node.get("manual")
        manuals = [x.id for x in self.model.protocol.manuals]
        if manual is not None and manual.value not in manuals:
            self.problems.add(manual.position, meaning.unknown_manual(manual.value, manuals))
        for key in ("limits", "notes"):
            entries = (entry["name"] for entry in node.get(key) or ())
            _unique(entries, f"'{{}}' is used twice in {key}; rename one", self.problems)
        statements = list(self.listed())
        support = self.support_of(statements)
        self.check_hardware(statements)
        supports = tuple(s for s in support if s.evidence.answer != "no")
        without = self.absent_sets(supports)
        support = (*support, *self.without_hardware(support, without))
        complete = self.complete_sets(statements)
        support = (*support, *self.unlisted(support, complete))
        self.check_varies(supports, support)
        like = node.scalar("like")
        return m.Device(
            id=self.id,
            name=node["name"].value,
            title=node["title"].value,
            description=node.scalar("description", ""),
            also=texts_of_node(node, "also"),
            model_number=node.scalar("model_number"),
            generation=node.scalar("generation"),
            manual=manual.value if manual else None,
            sources=sources_of_node(node, self.types.vocabulary, self.problems),
            like=like if like in self.types.vocabulary.devices else None,
            hardware=hardware(node),
            complete=complete,
            evidence=_by_strength(
                [*(s.evidence for s in support), *(e for _, e in statements if e.undefined), *without.values()]
            ),
            supports=supports,
            refuses=tuple(
                sorted(
                    (s for s in support if s.evidence.answer == "no"), key=lambda s: (s.set, s.field.descriptor)
                )
            ),
            base_rates=self.rates(supports),
            ports=tuple(self.port(p) for p in node.get("ports") or ()),
            limits=tuple(self.limit(n) for n in node.get("limits") or ()),
            notes=tuple(
                m.Note(
                    n["name"].value, n["title"].value, n["description"].value,
                    tuple(tuple(str(c) for c in row) for row in n["rows"].plain()) if "rows" in n else (),
                )
                for n in node.get("notes") or ()
            ),
            variants=tuple(self.model.derived(_by_device).get(self.id, ())),
            ack_codes=self.codes(),
            incomplete=texts_of_node(node, "incomplete"),
            uncertain=texts_of_node(node, "uncertain"),
            position=node.position,
        )  # fmt: skip

    def complete(self) -> None:
        """Requires all keys, unless the profile is declared incomplete."""
        if "description" not in self.node:
            self.problems.add(self.node.position, "'description' is missing; describe the device in one short sentence")
        for key in REQUIRED if not texts_of_node(self.node, "incomplete") else ():
            if key not in self.node or (key != "base_rates" and not self.node[key].value):
                place = self.node.position
                self.problems.add(place, f"'{key}' is missing; add it, or state in 'incomplete' what is unknown")

    # ----------------------------------------------------------------------- support

    def listed(self) -> Iterator[tuple[Node, m.Evidence]]:
        """Returns the lists of fields by set, each with its evidence."""
        if "supports" in self.node:
            yield self.node["supports"], m.Evidence("documented")
        for group in self.node.get("evidence") or ():
            yield group["fields"], self.evidence(group)

    def evidence(self, node: Node) -> m.Evidence:
        kind, of = node["kind"].value, list(node.get("of") or ())
        if of and kind not in ("family", "sister"):
            self.problems.add(
                node.keys["of"], f"'{kind}' is about the device itself; remove 'of', or use kind 'family' or 'sister'"
            )
        ids = self.types.vocabulary.devices
        for name in of:
            if name.value not in ids:
                self.problems.add(name.position, f"unknown device '{name.value}'{nearest(name.value, ids)}")
        undefined = node.get("undefined")
        return m.Evidence(
            kind=kind,
            sources=sources_of_node(node, self.types.vocabulary, self.problems),
            of=tuple(name.value for name in of),
            firmware=node.scalar("firmware"),
            date=node.scalar("date"),
            note=" ".join(texts_of_node(node, "notes")),
            undefined=tuple(self.undefined(undefined)) if undefined else (),
        )

    def undefined(self, node: Node) -> Iterator[tuple[int, int]]:
        """Yields the fields of the device that the specification does not define."""
        sets = {s.name: s for s in self.model.sets}
        for name, entries in node.items():
            number = sets[name].number if name in sets else _number(name)
            of = next((s.name for s in self.model.sets if s.number == number), None)
            if number is None:
                near = f"{nearest(name, sets)}; for a set that is not defined, write its number, such as 0x0F"
                self.problems.add(node.keys[name], f"unknown set '{name}'{near}")
                continue
            if of not in (name, None):
                self.problems.add(node.keys[name], f"the set {name} is defined; write '{of}'")
                continue
            for entry in entries:
                for f in self.model.candidates(number, entry.value):
                    remedy = f"write '{f.name}' in fields"
                    self.problems.add(entry.position, f"0x{entry.value:02X} of '{name}' is defined; {remedy}")
                yield number, entry.value

    def port(self, node: Node) -> m.Port:
        receives, sends = tuple(node["receives"].plain()), tuple(node["sends"].plain())
        firmware = []
        for protocol, versions in node["firmware"].items() if "firmware" in node else ():
            if protocol not in (*receives, *sends):
                place, name = node["firmware"].keys[protocol], node["name"].value
                remedy = "add it to what it receives or sends, or remove it"
                self.problems.add(place, f"the port '{name}' has no protocol '{protocol}'; {remedy}")
            firmware.append(m.ProtocolFirmware(protocol, versions.value))
        rates = tuple(node["baud_rates"].plain())
        return m.Port(node["name"].value, node.scalar("id"), rates, receives, sends, tuple(firmware))

    def support_of(self, statements: list[tuple[Node, m.Evidence]]) -> tuple[m.Support, ...]:
        """Returns an entry for each field that is stated to be supported or missing, with the strongest evidence, in
        the order of sets and descriptors."""
        supports: dict[str, m.Support] = {}
        witnesses: dict[str, list[m.Evidence]] = {}
        functions, deprecated, firmware = self.functions(), self.node.get("deprecated"), self.node.get("firmware")
        for node, evidence in statements:
            for set_name, entries in node.items():
                of = self.model.set_named(set_name)
                if of is None:
                    near = nearest(set_name, [s.name for s in self.model.sets])
                    self.problems.add(node.keys[set_name], f"unknown set '{set_name}'{near}")
                    continue
                defined = self.model.derived(_asked)[of.number]
                for entry in entries:
                    f, full = defined.get(entry.value), f"{set_name}.{entry.value}"
                    if f is None:
                        self.problems.add(entry.position, f"unknown field '{full}'{nearest(entry.value, defined)}")
                        continue
                    before = witnesses.setdefault(full, [])
                    twice = next(filter(None, (_twice(full, e, evidence) for e in before)), None)
                    if twice is not None:
                        self.problems.add(entry.position, twice)
                    elif all(m.strength(evidence.kind) < m.strength(e.kind) for e in before):
                        own = functions.get(full)
                        taken = tuple(x for x in f.functions if own is None or x.letter in own.value)
                        instead = deprecated.scalar(full) if deprecated else None
                        since = next((firmware.scalar(x) for x in (full, set_name) if firmware and x in firmware), None)
                        supports[full] = m.Support(f, of.number, taken, evidence, since, instead)
                    before.append(evidence)
        sets = {full.partition(".")[0] for full in supports}
        for key in ("functions", "deprecated", "firmware"):
            for full, _ in self.node[key].items() if key in self.node else ():
                f = self.model.field(full)
                if key == "firmware" and full in sets:
                    continue
                if full not in supports and not (key == "functions" and (f is None or not f.functions)):
                    self.unsupported(key, full, full)
        return tuple(sorted(supports.values(), key=lambda s: (s.set, s.field.descriptor)))

    def check_hardware(self, statements: list[tuple[Node, m.Evidence]]) -> None:
        """Requires the hardware for each field that the device is stated to support."""
        has, sets = hardware(self.node), {s.name: s for s in self.model.sets}
        for name, entry in ((n, x) for node, e in statements if e.answer != "no" for n, xs in node.items() for x in xs):
            full = f"{name}.{entry.value}"
            f = self.model.field(full)
            check_able(full, has.lacking(needed_hardware(f, sets.get(name))) if f else None, entry, self.problems)

    def absent_sets(self, supports: tuple[m.Support, ...]) -> dict[str, m.Evidence]:
        """Returns hardware that the device lacks, and evidence against the data sets that require it."""
        has, own = hardware(self.node), {s.set for s in supports}
        lacked: dict[str, list[m.Set]] = {}
        for of in self.model.sets:
            need = has.none_of(has.lacking(of.needs))
            if need is not None and of.kind == "data" and of.number not in own:
                lacked.setdefault(need, []).append(of)
        return {need: m.Evidence("hardware", needs=need, sets=tuple(sets)) for need, sets in lacked.items()}

    def without_hardware(self, supports: tuple[m.Support, ...], without: dict[str, m.Evidence]) -> Iterator[m.Support]:
        """Yields the fields that the device cannot have for lack of hardware, of the sets of which it has fields."""
        has, stated = hardware(self.node), {s.name for s in supports}
        for number in sorted({s.set for s in supports if s.evidence.answer != "no"}):
            of = next(s for s in self.model.sets if s.number == number)
            for f in self.model.derived(_asked)[number].values():
                lacked = has.lacking(needed_hardware(f, of))
                if lacked is not None and f.name_in(number) not in stated:
                    yield m.Support(f, number, (), without.get(lacked) or m.Evidence("hardware", needs=lacked))

    def complete_sets(self, statements: list[tuple[Node, m.Evidence]]) -> tuple[m.Set, ...]:
        """Returns the sets that the manual lists completely; about these, nothing weaker may be stated."""
        names = {entry.value: entry for entry in self.node.get("complete") or ()}
        sets = {s.name: s for s in self.model.sets}
        for name, entry in names.items():
            if name not in sets:
                self.problems.add(entry.position, f"unknown set '{name}'{nearest(name, sets)}")
        for node, evidence in statements:
            for name, entries in node.items() if evidence.answer in ("likely", "assumed") else ():
                for entry in entries if name in names else ():
                    wrong = f"the manual's list of '{name}' is complete, and lacks '{entry.value}'; remove it"
                    self.problems.add(entry.position, wrong)
        return tuple(sets[name] for name in names if name in sets)

    def unlisted(self, supports: tuple[m.Support, ...], complete: tuple[m.Set, ...]) -> Iterator[m.Support]:
        """Yields the fields that the manual's list of their set does not contain."""
        stated = {s.name for s in supports}
        for s in complete:
            for f in self.model.derived(_asked)[s.number].values():
                if f.name_in(s.number) not in stated:
                    yield m.Support(f, s.number, (), m.Evidence("unlisted"))

    def unsupported(self, key: str, entry: str, field: str) -> None:
        target = self.model.field(field)
        if self.model.set_named(field):
            place = self.node[key].keys[entry]
            self.problems.add(place, f"the device supports no field of the set '{field}'; remove it, or add the fields")
        elif target is None:
            near = nearest(field, [f.full_name for f in self.model.fields])
            self.problems.add(self.node[key].keys[entry], f"unknown field '{field}'{near}")
        else:
            place = self.node[key].keys[entry]
            self.problems.add(place, f"the device does not support '{field}'; add it to supports")

    def functions(self) -> dict[str, Node]:
        """Returns the letters of the functions by full name, if they differ from the definition."""
        node = self.node.get("functions")
        stated = {}
        for name, letters in node.items() if node else ():
            assert node is not None
            field = self.model.field(name)
            if field is None or not field.functions:
                near = nearest(name, [f.full_name for f in self.model.fields if f.functions])
                self.problems.add(node.keys[name], f"there is no command '{name}' with functions{near}")
                continue
            extra = set(letters.value) - set(m.letters(field.functions))
            if extra:
                more = "".join(sorted(extra))
                self.problems.add(
                    letters.position, f"'{name}' is not defined with the functions {more}; add them to its definition"
                )
            stated[name] = letters
        return stated

    # ----------------------------------------------------------------------- what differs

    def check_varies(self, supports: tuple[m.Support, ...], support: tuple[m.Support, ...]) -> None:
        """Requires that variations are for fields that the device may have, and that parameters which vary by device
        have one."""
        incomplete = bool(texts_of_node(self.node, "incomplete"))
        absent = {s.field.full_name for s in support if s.evidence.answer == "no"}
        fields = [f for s in supports for f in (s.field, *self.model.responses(s.field))]
        supported = {s.field.full_name for s in supports if s.evidence.kind != "listed"}  # a list has no readings
        untold = {
            f.full_name
            for s in supports
            if s.field.full_name not in supported
            for f in (s.field, *self.model.responses(s.field))
        }
        names = {name for f in (self.model.protocol.acknowledge, *fields) for name in f.names}
        for path in self.node["varies"].value if "varies" in self.node else ():
            name = path.rpartition(".")[0]
            f = self.model.field(name)
            if f is not None and name not in names and not (incomplete and f.full_name not in absent):
                self.unsupported("varies", path, name)
        for f in {f.full_name: f for f in fields}.values():
            for p in f.parameters:
                if p.by_device and f.full_name not in untold:
                    self.check_reading(f, p)
                if p.valid or p.variants:
                    self.check_valid(f, p)

    def own(self, p: m.Parameter) -> m.Variant | None:
        return next((v for v in p.variants if v.by_device and v.key == self.id), None)

    def check_reading(self, f: m.Field, p: m.Parameter) -> None:
        """Requires the reading of a parameter whose values differ by device."""
        own = self.own(p)
        if not (own and (own.type or own.unknown)):
            path = f"{f.full_name}.{p.name}"
            self.problems.add(
                self.place("varies"),
                f"the meaning of '{path}' is missing; add {path}: {{type: ...}} to varies, or {path}: unknown",
            )

    def check_valid(self, f: m.Field, p: m.Parameter) -> None:
        """Requires that the valid flag of a value is a bit that the flags have on this device."""
        own = self.own(p)
        explicit = own is not None and own.valid is not None
        path = f"{f.full_name}.{p.name}"
        if explicit:
            varies = self.node.get("varies")
            node = varies.get(path) if varies is not None else None  # None: inherited from the similar device
            if node is not None and node["valid"].value is not None:
                meaning.valid_bits(node, p, f.parameters, self.problems.add)
        for word in dict.fromkeys((own.valid or ()) if own and explicit else p.valid):
            name, dot, bit = word.partition(".")
            flags = next((q for q in f.parameters if q.name == name), None)
            bits = self.bits(flags) if dot and flags else None
            if bits is not None and flags is not None and bit in meaning.bit_names(flags) - bits:
                remedy = f"add the bit that marks '{p.name}' as valid, {path}: {{valid: ...}}, or ~ if there is none"
                self.problems.add(self.place("varies"), f"'{name}' has no bit '{bit}' on the device; {remedy}")

    def bits(self, flags: m.Parameter) -> set[str] | None:
        """Returns the bits of flags on this device, if they differ from the definition."""
        own = self.own(flags)
        if own is not None and own.only:
            return {x.name for x in own.only}
        return {b.name for b in own.type.bits} if own is not None and isinstance(own.type, m.Bitfield) else None

    # ----------------------------------------------------------------------- the rest

    def rates(self, supports: tuple[m.Support, ...]) -> tuple[m.Rate, ...]:
        """Returns the known base rates."""
        node = self.node.get("base_rates")
        sets = {s.name: s for s in self.model.sets if s.kind == "data"}
        rates = dict(node.items()) if node else {}
        for name in rates:
            if name not in sets:
                assert node is not None
                self.problems.add(node.keys[name], f"unknown data set '{name}'{nearest(name, sets)}")
        for name in sorted({s.name.partition(".")[0] for s in supports}):
            if name in sets and name not in rates:
                self.problems.add(
                    self.place("base_rates"),
                    f"the rate of '{name}' is missing (0 if its data is sent as it arrives, ~ if it is not known)",
                )
        return tuple(
            m.Rate(sets[name], rate.value) for name, rate in rates.items() if name in sets and rate.value is not None
        )

    def limit(self, node: Node) -> m.Limit:
        unit = meaning.unit(node, self.model.protocol.units, self.problems)
        return m.Limit(
            node["name"].value, node["value"].value, unit, node["description"].value, node.scalar("firmware")
        )

    def codes(self) -> tuple[int, ...]:
        node, of = self.node.get("ack_codes"), self.model.protocol.ack_code
        if node is None:
            return ()
        values = {v.value for v in of.values}
        for code in node if of is not self.model.protocol.function_selector else ():
            if code.value not in values:
                self.problems.add(code.position, f"'{of.name}' has no value {code.value}; add it to the enumeration")
        return tuple(node.plain())

"""Compares the model with witnesses: facts that programs extracted from other sources, in `spec/witness`.

A fact that could be wrong without causing an error, such as a unit, a bit or a default, is compared with each witness
that states it. Reviewed differences are listed with reasons in `accepted.yaml`, by their exact text: another mistake in
the same parameter is still reported, and so is a listed difference that no longer exists.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from difflib import SequenceMatcher
from itertools import pairwise, product, takewhile
from pathlib import Path
from typing import Any

from mipgen import model as m
from mipgen.read import loader
from mipgen.read.problems import Position, Problems

from . import devices, rules
from .leaves import Leaf, Reader, of_field, written_out

#: Word in a layout's name -> possible frames of its vectors; LLH allows NED, as its uncertainties are in metres.
_NAMED_FRAMES = {"ecef": {"ecef"}, "llh": {"llh", "ned"}, "ned": {"ned"}}

#: Names of vector elements in witnesses; in the specification, they depend on the frame.
_ELEMENTS = frozenset("abcdefghixyzw")


@dataclass(frozen=True)
class Difference:
    """A difference between the specification and a witness, in a field, a type or a descriptor."""

    witness: str
    at: str
    text: str
    position: Position | None = field(default=None, compare=False)

    def __str__(self) -> str:
        where = f"{self.position.file}:{self.position.line}: " if self.position else ""
        return f"{where}{self.at}: {self.text} ({self.witness})"


@dataclass
class Report:
    differences: list[Difference]  # without the accepted ones
    stale: list[str]  # accepted differences that no longer exist, with their positions
    accepted: int
    counts: Counter[str]  # how many facts of each kind were compared
    alone: list[str]  # fields that no witness contains
    debt: Counter[str]  # facts of devices without a witness

    def lines(self) -> list[str]:
        return [*(str(d) for d in self.differences), *self.stale]

    def summary(self) -> str:
        facts = ", ".join(f"{number} {kind}" for kind, number in sorted(self.counts.items()))
        rest = f"{self.accepted} differences are accepted; {len(self.alone)} fields have no witness"
        debt = ", ".join(f"{number} {kind}" for kind, number in sorted(self.debt.items()))
        return f"witnesses: {facts}; {rest}" + f"; nor have these facts of devices: {debt}" * bool(debt)


def audit_all(model: m.Model, folder: Path, revision: dict[str, Any] | None = None, name: str = "sdk") -> Report:
    """Compares the model with all files of a folder, or with another SDK revision only: the facts in `revision`, as the
    witness `name`. Accepted differences are then not reported as stale. Raises SpecError if a file cannot be read."""
    problems = Problems()
    documents = loader.load_witnesses(folder, problems)
    problems.raise_if_any()
    witnesses = {Path(d.path).stem: d.root.plain() for d in documents if d.kind == "witness"}
    if revision is not None:
        witnesses = {name: revision}
    witnesses = {name: written_out(facts) for name, facts in witnesses.items()}
    accepted = [d.root for d in documents if d.kind == "accepted"]
    judged = [(entry, entry.plain()) for root in accepted for entry in root.get("differences") or ()]
    compared = _Compared(model, witnesses, [root.plain() for root in accepted])
    compared.run()
    if revision is None:
        for root in (d.root.plain() for d in documents if d.kind == "rules"):
            compared.rules(root["rules"])
            compared.constants(root.get("constants", {}))
        for root in (d.root.plain() for d in documents if d.kind == "device_facts"):
            compared.devices(root)
    differing = {(d.witness, d.at, d.text): d for d in compared.differences}
    allowed = {
        (witness, at, text): node.position
        for node, entry in judged
        for witness, places in entry["at"].items()
        for at, text in product(places, entry["texts"])
    }
    stale = (
        []
        if revision is not None
        else [
            f"{place.file}:{place.line}: {at}: there is no difference '{text}' ({witness}); remove it"
            for (witness, at, text), place in allowed.items()
            if (witness, at, text) not in differing
        ]
    )
    fresh = [d for key, d in differing.items() if key not in allowed]
    alone = [f.full_name for f in model.fields if f.full_name not in compared.seen]
    return Report(fresh, stale, len(differing) - len(fresh), compared.counts, alone, compared.debt)


def normal(name: str) -> str:
    return name.lower().replace("_", "")


class Names:
    """What names of witnesses mean here: pairs, prefixes that they put before names, and words that they shorten."""

    def __init__(self, accepted: list[dict[str, Any]]) -> None:
        self.pairs = {(a, b) for x in accepted for a, names in x.get("names", {}).items() for b in names}
        self.prefixes = ["", *(prefix for x in accepted for prefix in x.get("prefixes", ()))]
        self.words = {short: word for x in accepted for short, word in x.get("words", {}).items()}

    def same(self, ours: str, theirs: str) -> bool:
        return (ours, theirs) in self.pairs or normal(ours) in {normal(theirs), *map(self._whole, self._bare(theirs))}

    def _bare(self, theirs: str) -> list[str]:
        return [theirs.removeprefix(prefix) for prefix in self.prefixes]

    def _whole(self, name: str) -> str:
        return "".join(self.words.get(word, word) for word in name.lower().split("_"))


class _Compared:
    """One comparison, with its `differences`."""

    def __init__(self, model: m.Model, witnesses: dict[str, Any], accepted: list[dict[str, Any]]) -> None:
        self.model, self.witnesses, self.accepted = model, witnesses, accepted
        self.reader = Reader(witnesses.values())
        self.names = Names(accepted)
        self.differences: list[Difference] = []
        self.seen: set[str] = set()
        self.leaves: dict[str, list[Leaf]] = {}
        self.counts: Counter[str] = Counter()
        self.debt: Counter[str] = Counter()

    def run(self) -> None:
        for name, facts in self.witnesses.items():
            for layout in facts["layouts"]:
                self.layout(name, facts, layout)
            for key in facts.get("named", {}):
                if not self.has_descriptor(*_numbers(key)):
                    text = f"not listed; the witness names it {facts['named'][key]}"
                    self.differences.append(Difference(name, key, text))
            for x in self.accepted:
                self.standalone(name, facts, x)

    def has_descriptor(self, number: int, descriptor: int) -> bool:
        named = (n.descriptor for f in self.model.families for s in f.sets if s.number == number for n in f.named)
        return bool(self.model.candidates(number, descriptor)) or descriptor in named

    def devices(self, facts: dict[str, Any]) -> None:
        for kind, finding in devices.compared_devices(self.model, facts):
            self.counts[kind] += 1
            if finding:
                self.differences.append(Difference("devices", finding.at, finding.text))
        self.debt = devices.debt(self.model, facts)

    def constants(self, stated: dict[str, Any]) -> None:
        for kind, finding in rules.compare_constants(self.model, stated):
            self.counts[kind] += 1
            if finding:
                self.differences.append(Difference("rules", finding.at, finding.text, finding.position))

    def rules(self, witness_rules: list[dict[str, Any]]) -> None:
        for kind, finding in rules.compare_rules(self.model, witness_rules):
            self.counts[f"{kind} by rule".replace("if_", "").replace("_of", "")] += 1
            if finding:
                self.differences.append(Difference("rules", finding.at, finding.text, finding.position))

    # ------------------------------------------------------------------ layouts

    def layout(self, name: str, facts: dict[str, Any], layout: dict[str, Any]) -> None:
        """Compares a witness's layout with the field; if a descriptor has several layouts, with the most similar
        one."""
        number, descriptor = _numbers(layout["key"])
        sets = [number, *(int(x, 16) for x in facts.get("same_layouts", {}).get(f"0x{number:02X}", ()))]
        fields = [f for f in self.model.candidates(number, descriptor) if f.role == layout["role"]]
        if not fields:
            text = f"no such {layout['role']}; the witness has {layout['name']}: {_listed(layout['parameters'])}"
            self.differences.append(Difference(name, layout["key"], text))
            return
        symbols = {token: symbol for symbol, tokens in facts.get("units", {}).items() for token in tokens}
        theirs = self.reader.layout(layout, symbols)
        tries = [self.attempt(name, facts, layout, f, theirs) for f in fields]
        best = min(tries, key=lambda attempt: len(attempt.differences))
        self.differences += best.differences
        self.counts += best.counts
        self.seen.add(best.field.full_name)
        for other in sets:
            if other != m.SHARED_SET and other not in best.field.sets:
                self.differences.append(Difference(name, best.field.full_name, f"does not occur in 0x{other:02X}"))

    def attempt(
        self, name: str, facts: dict[str, Any], layout: dict[str, Any], field: m.Field, theirs: list[Leaf]
    ) -> _Layout:
        if field.full_name not in self.leaves:
            self.leaves[field.full_name] = of_field(field)
        ours = self.leaves[field.full_name]
        attempt = _Layout(name, self.model, field, self.names, bool(facts.get("partial")))
        attempt.about(layout)
        attempt.sequence(ours, theirs)
        attempt.frames_in_names(ours, layout)
        attempt.valid_flags(ours, theirs)
        return attempt

    # ------------------------------------------------------------------ types without a parameter

    def standalone(self, name: str, facts: dict[str, Any], accepted: dict[str, Any]) -> None:
        """Compares types that no layout of the witness uses, and constants, with their counterparts here."""
        types = facts.get("enums", {}) | facts.get("bitfields", {})
        for entry in accepted.get("types", ()):
            if entry["witness"] in types:
                theirs = {**types[entry["witness"]], "name": entry["witness"], "part": entry.get("partly", False)}
                self.of_type(name, entry["type"], theirs)
        for entry in accepted.get("constants", ()):
            if entry["group"] in facts.get("constants", {}):
                group = facts["constants"][entry["group"]]
                mine = {k: v for k, v in group.items() if k.startswith(entry["prefix"])}
                t = self.model.type(entry["type"])
                if isinstance(t, m.Bitfield):
                    bits = {k: [v.bit_length() - 1, 1] for k, v in mine.items()}
                    self.of_type(name, entry["type"], {"bits": bits, "name": entry["group"], "loose": True})
                else:
                    self.of_type(name, entry["type"], {"values": mine, "name": entry["group"], "loose": True})

    def of_type(self, name: str, type_name: str, theirs: dict[str, Any]) -> None:
        ours = self.model.type(type_name)
        if type_name == "functions":
            numbers = _grouped((f.value, f.name) for f in self.model.protocol.functions)
            layout = _Layout(name, self.model, None, self.names, False)
            layout.compare(
                Leaf(type_name, ""), "value", numbers, _grouped((v, k) for k, v in theirs["values"].items()), theirs
            )
            self.differences += layout.differences
            return
        if ours is None:
            self.differences.append(Difference(name, type_name, f"no such type; the witness has {theirs['name']}"))
            return
        layout = _Layout(name, self.model, None, self.names, False)
        layout.type(Leaf(type_name, "", position=ours.position), (ours,), theirs)
        self.differences += layout.differences
        self.counts += layout.counts


class _Layout:
    """The comparison of one field with one layout of a witness."""

    def __init__(self, witness: str, model: m.Model, field: m.Field | None, names: Names, partial: bool) -> None:
        self.witness, self.model, self.partial, self.same = witness, model, partial, names.same
        self._field = field
        self.differences: list[Difference] = []
        self.counts: Counter[str] = Counter()

    @property
    def field(self) -> m.Field:
        assert self._field is not None
        return self._field

    def note(self, text: str, position: Position | None = None) -> None:
        at = self._field.full_name if self._field else ""
        if self._field is None:
            at, _, text = text.partition(": ")
        self.differences.append(
            Difference(self.witness, at, text, position or (self._field.position if self._field else None))
        )

    def same_names(self, ours: Sequence[str], theirs: Sequence[str]) -> bool:
        """Does each of our names equal one of theirs, or is it known to mean the same?"""
        return all(any(self.same(a, b) for b in theirs) for a in ours)

    # ------------------------------------------------------------------ the field as a whole

    def about(self, layout: dict[str, Any]) -> None:
        f = self.field
        self.counts["layouts"] += 1
        _, scoped, name = layout["name"].partition("::")  # a manual's titles are not names
        self.counts["names"] += bool(scoped)
        if scoped and not any(self.same(name_known, name.replace("::", "")) for name_known in (f.name, *f.also)):
            self.note(f"names {', '.join((f.name, *f.also))}, witness {layout['name']}")
        ours, theirs = m.letters(f.functions).replace("A", ""), layout.get("functions")
        if bool(f.functions) != (theirs is not None) and (theirs is not None or not self.partial):
            self.note(f"functions {ours or 'none'}, witness {theirs or 'none'}")
        elif theirs is not None and (not set(theirs) <= {*ours, "A"} if self.partial else ours != theirs):
            self.note(f"functions {ours}, witness {theirs}")
        if f.role == m.COMMAND and not self.partial:
            answers = sorted({f"0x{r.descriptor:02X}" for r in self.model.responses(f)})
            wanted = [layout["response"]] if "response" in layout else []
            if answers != wanted:
                self.note(f"responses {', '.join(answers) or 'none'}, witness {', '.join(wanted) or 'none'}")

    # ------------------------------------------------------------------ numbers in order

    def sequence(self, ours: list[Leaf], theirs: list[Leaf]) -> None:
        index = next((i for i, b in enumerate(theirs) if b.scalar == "unknown"), None)
        if index is not None:
            ours, theirs = ours[:index], theirs[:index]
        if len(ours) != len(theirs):
            self.note(f"{len(ours)} numbers, witness {len(theirs)} ({_brief(ours)}; witness {_brief(theirs)})")
            ours, theirs = _common(ours, theirs)
        self.repeats(ours, theirs)
        self.names(ours, theirs)
        for a, b in zip(ours, theirs, strict=False):
            self.number(a, b)

    def number(self, a: Leaf, b: Leaf) -> None:
        """Compares each fact that the witness states about one number."""
        self.counts["numbers"] += 1
        self.form(a, b)
        self.measure(a, b)
        self.limits(a, b)
        if b.valid is not None:
            text = f"valid by bit {_all(a.valid)}, witness {_all(b.valid)}"
            self.fact("valid flags", a.valid == b.valid, text, a)
        for theirs in b.types:
            self.type(a, a.types, theirs)
        if a.scalar == b.scalar == "union":
            self.union(a, b)

    def fact(self, kind: str, same: bool, text: str, a: Leaf) -> None:
        """Counts one fact that both state, and reports the difference in `text`, if there is one."""
        self.counts[kind] += 1
        if not same:
            self.note(f"{a.path}: {text}", a.position)

    def form(self, a: Leaf, b: Leaf) -> None:
        if a.scalar != b.scalar and not (b.label and (a.scalar, b.scalar) == ("bool", "u8")):
            self.note(f"{a.path}: type {a.scalar}, witness {b.scalar}", a.position)
        if b.needed is not None or (a.needed and not self.partial and self.field.functions):
            ours, theirs = a.needed or "", b.needed or ""
            text = f"for {ours or 'none'}, witness {theirs or 'none'}"
            self.fact("functions of parameters", ours == theirs, text, a)
        if a.optional and not self.partial:
            self.note(f"{a.path}: optional", a.position)

    def measure(self, a: Leaf, b: Leaf) -> None:
        if b.units is not None:
            same = (a.units or frozenset()) == b.units or (b.units == {"1"} and not a.units)
            self.fact("units", same, f"unit {_all(a.units or frozenset())}, witness {_all(b.units)}", a)
        if b.frames is not None and a.frames:
            self.fact("frames", a.frames <= b.frames, f"frame {_all(a.frames)}, witness {_all(b.frames)}", a)

    def limits(self, a: Leaf, b: Leaf) -> None:
        ours = dict(a.bounds or ())
        if b.bounds is not None and not a.types and a.scalar != "bool":
            same = all(ours.get(name) == value for name, value in b.bounds)
            self.fact("ranges", same, f"range {_range(a.bounds)}, witness {_range(b.bounds)}", a)
        if b.most is not None and ours:
            text = f"range {_range(a.bounds)}, witness maximum {b.most}"
            self.fact("ranges", ours.get("maximum") == b.most, text, a)
        if b.default is not None:
            self.fact("defaults", a.default == b.default, f"default {a.default}, witness {b.default}", a)

    def repeats(self, ours: list[Leaf], theirs: list[Leaf]) -> None:
        places = [{x.top: i for i, x in reversed(list(enumerate(leaves)))} for leaves in (ours, theirs)]
        for a, b in zip(ours, theirs, strict=False):
            first, second = places[0].get(a.repeat or ""), places[1].get(b.repeat or "")
            rest = [x.repeat == m.REST for x in (a, b)]
            unlike = (a.repeat is None) != (b.repeat is None) or rest[0] != rest[1] or first != second
            if unlike and not (self.partial and b.repeat and second is None):
                self.note(f"{a.path}: repeated by {a.repeat or 'none'}, witness {b.repeat or 'none'}", a.position)

    def names(self, ours: list[Leaf], theirs: list[Leaf]) -> None:
        spent = set[tuple[str, str]]()
        for a, b in zip(ours, theirs, strict=False):
            for x, y in list(zip(a.path.split("."), b.path.split("."), strict=False))[:2]:
                if b.label or (x, y) in spent or (y in _ELEMENTS and "." in b.path):
                    continue
                spent.add((x, y))
                if not self.same_names([x], [y]):
                    self.note(f"{a.path}: name {x}, witness {y}", a.position)
        pairs = list(zip(ours, theirs, strict=False))
        for (a, b), (c, d) in pairwise(pairs):
            if b.label and d.label and a.path != c.path:
                straight = _alike(a.path, b.path) + _alike(c.path, d.path)
                if straight < _alike(a.path, d.path) + _alike(c.path, b.path) - 0.1:
                    self.note(f"{a.path}, {c.path}: order {a.path} first, witness {b.path}", a.position)

    def union(self, a: Leaf, b: Leaf) -> None:
        if not self.same(a.cases[0], b.cases[0]):
            self.note(f"{a.path}: selected by {a.cases[0]}, witness {b.cases[0]}", a.position)
        ours = {number: leaves for number, leaves in a.cases[1].items() if leaves}
        for number in sorted({*ours, *b.cases[1]}):
            if number not in ours or number not in b.cases[1]:
                whose = "specification" if number in ours else "witness"
                self.note(f"{a.path}: case {number} is only in the {whose}", a.position)
            else:
                self.sequence(_expanded(ours[number]), b.cases[1][number])

    # ------------------------------------------------------------------ facts that follow from names

    def frames_in_names(self, ours: list[Leaf], layout: dict[str, Any]) -> None:
        """Checks that the vectors of a layout that is named after a frame are in that frame."""
        name = normal(layout["name"])
        named = [frames for word, frames in _NAMED_FRAMES.items() if word in name]
        if len(named) != 1 or "frames" in layout:
            return
        (unit_name,) = named
        for a in ours:
            if a.frames:
                self.counts["frames"] += 1
                if not a.frames <= unit_name:
                    self.note(f"{a.path}: frame {_all(a.frames)}, witness {_all(unit_name)} by its name", a.position)

    def valid_flags(self, ours: list[Leaf], theirs: list[Leaf]) -> None:
        """Checks that a value's valid flag is the bit of the same name; if bits have no names, bit 0 covers all."""
        pairs = list(zip(ours, theirs, strict=False))
        flags = next(((a, b) for a, b in pairs if normal(b.path) == "validflags"), None)
        if flags is None or len(ours) != len(theirs):
            return
        bits = next((t["bits"] for t in flags[1].types if "bits" in t), None)
        if bits is None and not flags[1].types and (self.partial or self.field.role != m.DATA):
            return  # its bits are not described
        for a, b in pairs:
            if a is flags[0]:
                continue
            expected = 0 if bits is None else self.flag(a, b, bits)
            if expected is None or (a.repeat and not a.valid):
                continue
            self.counts["valid flags"] += 1
            if a.valid != frozenset({expected}):
                self.note(f"{a.path}: valid by bit {_all(a.valid)}, witness {expected}", a.position)

    def flag(self, a: Leaf, b: Leaf, bits: dict[str, tuple[int, int]]) -> int | None:
        single = {name: first for name, (first, width) in bits.items() if width == 1}
        for ours, theirs in ((a.name, b.name), (a.top, b.top)):
            for name, first in single.items():
                if normal(name) == normal(theirs) or self.same(ours, name):
                    return first
        return None

    # ------------------------------------------------------------------ enumerations and bitfields

    def type(self, a: Leaf, ours: Iterable[Any], theirs: dict[str, Any]) -> None:
        kinds = tuple(ours)
        enum = "values" in theirs
        if not kinds:
            if not theirs.get("loose"):
                self.note(f"{a.path}: a plain number, witness {theirs['name']}", a.position)
            return
        if (
            enum
            and isinstance(kinds[0], m.Bitfield)
            and theirs.get("loose")
            and set(theirs["values"].values()) == {0, 1}
        ):
            theirs = {"bits": {k: [0, 1] for k, v in theirs["values"].items() if v}, "name": "its table", "loose": True}
            enum = False
        wrong = next((t.name for t in kinds if isinstance(t, m.Enum) != enum), None)
        if wrong:
            self.note(
                f"{a.path}: {wrong} is no {'enumeration' if enum else 'bitfield'}, {theirs['name']} is", a.position
            )
            return
        scalars = {t.scalar.name for t in kinds if t.scalar}
        if "type" in theirs and scalars - {theirs["type"]}:
            self.note(f"{a.path}: type {_all(scalars)}, witness {theirs['type']} of {theirs['name']}", a.position)
        if enum:
            self.values(a, kinds, theirs)
        else:
            self.bits(a, kinds, theirs)

    def values(self, a: Leaf, kinds: Sequence[m.Enum], theirs: dict[str, Any]) -> None:
        ours = _grouped((v.value, v.name) for t in kinds for v in t.values)
        numbers = _grouped((number, name) for name, number in theirs["values"].items())
        self.compare(a, "value", ours, numbers, theirs)

    def bits(self, a: Leaf, kinds: Sequence[m.Bitfield], theirs: dict[str, Any]) -> None:
        ours = _grouped(((b.first, b.width), b.name) for t in kinds for b in t.bits)
        numbers = _grouped(((first, width), name) for name, (first, width) in theirs["bits"].items())
        for spans, others in ((ours, numbers), (numbers, ours)):
            for span in [s for s in spans if s not in others and (_composed(s, others) or _composed(s, spans))]:
                del spans[span]
        self.compare(a, "bit", ours, numbers, theirs)

    def compare(self, a: Leaf, what: str, ours: Any, stated: Any, theirs: dict[str, Any]) -> None:
        """Compares values or bits by number; an incomplete table is no evidence about the entries that it lacks."""
        of = theirs["name"]
        for key in sorted({*ours, *stated}):
            place = f"{a.path}: {what} {_number(key)}"
            if key not in stated:
                if not theirs.get("loose"):
                    self.note(f"{place} ({'/'.join(ours[key])}) is not in {of}", a.position)
                continue
            if key not in ours and theirs.get("part"):
                continue
            self.counts[f"{what}s"] += 1
            if key not in ours:
                self.note(f"{place} ({'/'.join(stated[key])} of {of}) is missing", a.position)
            elif not self.same_names(ours[key], stated[key]):
                self.note(f"{place} is {'/'.join(ours[key])}, witness {'/'.join(stated[key])}", a.position)


# --------------------------------------------------------------------------- small things


def _numbers(key: str) -> tuple[int, int]:
    first, _, second = key.partition(",")
    return int(first, 16), int(second, 16)


def _grouped(pairs: Iterable[tuple[Any, str]]) -> dict[Any, list[str]]:
    grouped: dict[Any, list[str]] = {}
    for key, name in pairs:
        grouped.setdefault(key, []).append(name)
    return {key: list(dict.fromkeys(names)) for key, names in grouped.items()}


def _composed(span: tuple[int, int], spans: Iterable[tuple[int, int]]) -> bool:
    """Do smaller ranges make up this range of bits?"""
    first, width = span
    covered = 0
    for low, n in spans:
        if (low, n) != span and low >= first and low + n <= first + width:
            covered |= ((1 << n) - 1) << low
    return covered == ((1 << width) - 1) << first


def _common(ours: list[Leaf], theirs: list[Leaf]) -> tuple[list[Leaf], list[Leaf]]:
    """Returns the numbers that certainly correspond in spite of different lengths: up to the first other type."""
    pairs = takewhile(lambda pair: pair[0].scalar == pair[1].scalar, zip(ours, theirs, strict=False))
    count = len(list(pairs))
    return ours[:count], theirs[:count]


def _expanded(leaves: list[Leaf]) -> list[Leaf]:
    """Replaces each union whose cases all consist of the same types by the numbers of its first case."""
    return list(_expand(leaves))


def _expand(leaves: list[Leaf]) -> Iterator[Leaf]:
    for leaf in leaves:
        shapes = [x for x in leaf.cases[1].values() if x] if leaf.scalar == "union" else []
        if shapes and len({tuple(y.scalar for y in x) for x in shapes}) == 1:
            yield from shapes[0]
        else:
            yield leaf


def _alike(a: str, b: str) -> float:
    return SequenceMatcher(None, normal(a), normal(b)).ratio()


def _all(items: Iterable[Any] | None) -> str:
    return "/".join(str(x) for x in sorted(items or ())) or "none"


def _range(bounds: tuple[tuple[str, float], ...] | None) -> str:
    return ", ".join(f"{name} {value:g}" for name, value in bounds or ()) or "none"


def _number(key: Any) -> str:
    return str(key) if isinstance(key, int) else f"{key[0]}" if key[1] == 1 else f"{key[0]}-{key[0] + key[1] - 1}"


def _listed(parameters: list[dict[str, Any]]) -> str:
    return ", ".join(f"{p.get('name') or p['label']}:{p['type']}" for p in parameters) or "no parameters"


def _brief(leaves: list[Leaf]) -> str:
    tops = Counter(f"{x.top}:{x.scalar}" for x in leaves)
    return ", ".join(name + (f"*{n}" if n > 1 else "") for name, n in tops.items())

"""What files beside the definitions state about them, by name: sources in evidence/, typical values in packets/,
keywords in searches/."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from mipgen import model as m
from mipgen.read.nodes import Node
from mipgen.read.problems import Problems, nearest


def merged_entries(roots: Iterable[Node], key: str, problems: Problems) -> dict[str, tuple[m.Position, Node]]:
    """Returns the entries of all files by name, each with the position of its name."""
    entries: dict[str, tuple[m.Position, Node]] = {}
    for root in roots:
        for name, node in root[key].items():
            place = root[key].keys[name]
            if name in entries:
                problems.add(place, f"'{name}' is already listed at {entries[name][0]}; put all there")
            entries.setdefault(name, (place, node))
    return entries


class Lists:
    """Lists by the names of definitions, such as the sources of fields."""

    def __init__(self, roots: Iterable[Node], key: str, problems: Problems) -> None:
        self.entries = merged_entries(roots, key, problems)
        self.problems = problems
        self.names: set[str] = set()  # of everything that can have a list

    def entries_of(self, name: str) -> Sequence[Node]:
        """Returns the entries about something that exists."""
        self.names.add(name)
        return list(self.entries[name][1]) if name in self.entries else ()

    def unused(self, what: str) -> None:
        """Reports names of nothing; `what` can have a list."""
        for name, (place, _) in self.entries.items():
            if name not in self.names:
                self.problems.add(place, f"no {what} is called '{name}'{nearest(name, sorted(self.names))}")


def with_typical(types: list[Node], sets: list[Node], packets: list[Node], problems: Problems) -> None:
    """Adds typical values to the parameters in files of types and sets."""
    values = merged_entries(packets, "typical", problems)
    names: set[str] = set()
    for roots, owned in ((types, False), (sets, True)):
        roots[:] = [_filled(root, f"{root['name'].value}." if owned else "", values, names, problems) for root in roots]
    for name, (place, _) in values.items():
        if name not in names:
            near = nearest(name, sorted(names))
            problems.add(place, f"no field, response, part or structure is called '{name}'{near}")


Values = dict[str, tuple[m.Position, Node]]


def _filled(root: Node, prefix: str, values: Values, names: set[str], problems: Problems) -> Node:
    """Fills the records of one file."""

    def record(name: str, node: Node, key: str) -> Node:
        parameters = node.get(key)
        if parameters is None or not isinstance(parameters.value, list):
            return node
        return _with(node, key, parts(name, parameters))

    def parts(name: str, parameters: Node) -> Node:
        names.add(prefix + name)
        entry = values.get(prefix + name)
        return parameters if entry is None else _typical(prefix + name, parameters, entry[1], problems)

    def field(node: Node) -> Node:
        name = node["name"].value
        node = record(name, node, "parameters")
        if "responses" not in node:
            return node
        own = (record(x.scalar("name", f"{name}_response"), x, "parameters") for x in node["responses"])
        return _with(node, "responses", replace(node["responses"], value=list(own)))

    if "types" in root:
        types = {name: record(name, node, "struct") for name, node in root["types"].items()}
        root = _with(root, "types", replace(root["types"], value=types))
    if "parts" in root:
        included = {name: parts(name, node) for name, node in root["parts"].items()}
        root = _with(root, "parts", replace(root["parts"], value=included))
    if "fields" in root:
        root = _with(root, "fields", replace(root["fields"], value=[field(node) for node in root["fields"]]))
    return root


def _typical(record: str, parameters: Node, values: Node, problems: Problems) -> Node:
    """Adds the values of one record to its parameters."""
    names = [p["name"].value for p in parameters if "name" in p]
    for name in values.value:
        if name not in names:
            problems.add(values.keys[name], f"'{record}' has no parameter '{name}'{nearest(name, names)}")
    return replace(parameters, value=list(_each(parameters, values, problems)))


def _each(parameters: Node, values: Node, problems: Problems) -> Iterator[Node]:
    for p in parameters:
        name = p.scalar("name", "")
        value = values.get(name)
        if value is None:
            yield p
        elif "cases" in p and isinstance(value.value, dict):
            cases = dict(p["cases"].items())
            for label, own in value.items():
                if label in cases:
                    cases[label] = _with(cases[label], "typical", own, value.keys[label])
                else:
                    near = nearest(label, cases)
                    problems.add(value.keys[label], f"'{name}' has no case '{label}'{near}")
            yield _with(p, "cases", replace(p["cases"], value=cases))
        else:
            yield _with(p, "typical", value, values.keys[name])


ALL_VALID = "All values are valid."


def marked_by_bits(roots: Iterable[Node]) -> dict[tuple[str | None, str], dict[str, str]]:
    """Returns what each bit says that marks values as valid, by the owner and the name of its type: "`x` is valid."."""
    names: dict[tuple[str | None, str], dict[str, dict[str, None]]] = {}
    for root in roots:
        types, owner = root.get("types"), root.scalar("name")
        for parameters in _records(root):
            kinds = {p.scalar("name"): p.scalar("type", "") for p in parameters}
            for p in parameters:
                holder, _, bit = str(p.scalar("valid", "")).partition(".")
                if kind := kinds.get(holder):
                    own = owner if types and kind in types else None
                    names.setdefault((own, kind), {}).setdefault(bit, {})[p["name"].value] = None
    return {key: {bit: _are_valid(list(own)) for bit, own in bits.items()} for key, bits in names.items()}


def _are_valid(names: Sequence[str]) -> str:
    """Joins the names of values.

    >>> _are_valid(["age"]), _are_valid(["latitude", "longitude", "height"])
    ('`age` is valid.', '`latitude`, `longitude` and `height` are valid.')
    """
    *several, last = (f"`{name}`" for name in names)
    return f"{', '.join(several)} and {last} are valid." if several else f"{last} is valid."


def _records(root: Node) -> Iterator[list[Node]]:
    """Yields the parameters of each record of one file: of fields, responses and structures."""
    parts, fields = root.get("parts"), list(root.get("fields") or ())
    types = (x for _, x in root["types"].items()) if "types" in root else ()
    records = [*fields, *(x for f in fields for x in f.get("responses") or ())]
    for record in [*(x.get("parameters") for x in records), *(x.get("struct") for x in types)]:
        if record is not None and isinstance(record.value, list):
            yield [p for q in record for p in ((parts and parts.get(q.scalar("include", ""))) or (q,))]


def _with(node: Node, key: str, value: Node, place: m.Position | None = None) -> Node:
    keys = node.keys if place is None else {**node.keys, key: place}
    return replace(node, value={**node.value, key: value}, keys=keys)

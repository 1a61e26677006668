"""Inheritance of device profiles: devices that are like another device or a family, and how they differ.

Profiles are inherited as nodes, before anything is resolved, so that every mistake keeps its position.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Set
from dataclasses import dataclass, replace
from functools import cached_property

from mipgen import model as m
from mipgen.read.nodes import Node
from mipgen.read.problems import Problems, nearest

from .vocabulary import hardware, needed_hardware

#: Keys that are inherited as a whole, unless they are given.
TAKEN = ("generation", "sensors", "receivers", "antennas", "description", "ack_codes", "incomplete", "uncertain")
#: Keys that are inherited entry by entry: by the name of a field, a parameter or a set.
KEYED = ("functions", "deprecated", "firmware", "varies", "base_rates")
#: Keys of lists that are inherited entry by entry: by the name of each entry.
NAMED = ("ports", "limits", "notes")


def resolve(devices: Iterable[Node], families: Iterable[Node], model: m.Model, problems: Problems) -> list[Node]:
    """Returns the devices, each with all that it inherits."""
    return _Profiles(list(devices), list(families), model, problems).devices()


@dataclass
class _Profiles:
    own: list[Node]
    families: list[Node]
    model: m.Model
    problems: Problems

    def devices(self) -> list[Node]:
        self.profiles: dict[str, Node] = {}
        for node in (*self.own, *self.families):
            name = _name(node)
            if name.value in self.profiles:
                self.problems.add(name.position, f"'{name.value}' is defined twice; rename one")
            self.profiles.setdefault(name.value, node)
        whole = [self.whole(node, ()) for node in self.own]
        used = {node["like"].value for node in self.profiles.values() if "like" in node}
        for node in self.families:
            if node["family"].value not in used:
                place = node["family"].position
                self.problems.add(place, f"no device is like the family '{node['family'].value}'; remove it")
        return whole

    def whole(self, node: Node, below: tuple[str, ...]) -> Node:
        """Returns a profile with all that it inherits; `below` names the profiles that inherit from it."""
        like = node.get("like")
        if like is None:
            for key in ("lacks", "without"):
                if key in node:
                    self.problems.add(node.keys[key], f"'{key}' requires 'like'; remove it")
            return node
        chain = (*below, _name(node).value)
        if like.value in chain:
            loop = " -> ".join((*chain[chain.index(like.value) :], like.value))
            self.problems.add(like.position, f"the device is like itself: {loop}; break the loop")
            return _orphan(node)
        parent = self.profiles.get(like.value)
        if parent is None:
            names = [name for name in self.profiles if name not in chain]
            near = nearest(like.value, names)
            self.problems.add(like.position, f"there is no device or family '{like.value}'{near}")
            return _orphan(node)
        return _Heir(node, self.whole(parent, chain), like.value, self.model, self.problems).node()


def _name(node: Node) -> Node:
    return node["device"] if "device" in node else node["family"]


def _orphan(node: Node) -> Node:
    """Completes a profile whose parent is unknown, so that nothing else is reported as missing."""
    reason = Node("The inherited profile is unknown.", node["like"].position)
    return replace(node, value={"description": reason, **node.value, "incomplete": Node([reason], reason.position)})


@dataclass(frozen=True)
class _Heir:
    own: Node
    parent: Node
    like: str
    model: m.Model
    problems: Problems

    @cached_property
    def kinds(self) -> dict[str, str]:
        """Field -> the kind of the other profile's statement about it."""
        return _kinds(self.parent)

    def node(self) -> Node:
        value = {key: node for key, node in self.own.items() if key not in ("lacks", "without")}
        for key in TAKEN:
            if key in self.parent:
                value.setdefault(key, self.parent[key])
        if "sources" in self.parent:
            value["sources"] = self.listed("sources", [*self.parent["sources"], *(self.own.get("sources") or ())])
        whole = replace(self.own, value=value)
        lacked = self.lacked() | self.impossible(whole, {*_fields(self.parent.get("supports")), *self.kinds})
        value["supports"] = self.supports(lacked)
        value["evidence"] = self.evidence(lacked)
        has = self.names(value["supports"], value["evidence"])
        for key in KEYED:
            value[key] = self.keyed(key, has if key != "varies" else has | self.possible(whole, lacked))
        for key in NAMED:
            value[key] = self.named(key)
        keys = {key: self.own.keys.get(key, self.own.position) for key in value}
        return replace(self.own, value=value, keys=keys)

    def listed(self, key: str, value: list[Node]) -> Node:
        return Node(value, self.own.keys.get(key, self.own.position))

    def mapped(self, key: str, value: dict[str, Node], keys: dict[str, m.Position]) -> Node:
        return Node(value, self.own.keys.get(key, self.own.position), keys)

    # ----------------------------------------------------------------------- fields

    def lacked(self) -> set[str]:
        """Returns the fields that the other device supports but this one does not."""
        names = set()
        available = {*_fields(self.parent.get("supports")), *self.kinds}
        for full, entry in _fields(self.own.get("lacks")).items():
            if full not in available:
                near = nearest(full, available)
                self.problems.add(entry.position, f"'{self.like}' does not support '{full}'{near}")
            names.add(full)
        return names

    def impossible(self, node: Node, names: set[str]) -> set[str]:
        """Returns the fields for which this device lacks the hardware, and those of the sets that its own manual lists
        completely."""
        has, of = hardware(node), {s.name: s for s in self.model.sets}
        whole = self.own["complete"].plain() if "complete" in self.own else ()
        fields = {name: f for name in names if (f := self.model.field(name)) is not None}
        lacking = {
            x for x, f in fields.items() if has.lacking(needed_hardware(f, of.get(x.partition(".")[0]))) is not None
        }
        return lacking | {name for name in names if name.partition(".")[0] in whole}

    def possible(self, node: Node, lacked: set[str]) -> set[str]:
        """Returns the fields that an incomplete profile does not exclude: if the device has one of them, it reads it as
        its family does."""
        names = {name for f in self.model.fields for name in f.names} if "incomplete" in node else set[str]()
        refused = {full for full, kind in (*self.kinds.items(), *_kinds(self.own).items()) if kind == "refused"}
        return names - lacked - refused - self.impossible(node, names)

    def supports(self, lacked: set[str]) -> Node:
        """Returns the fields of the other device without those that are lacked, then those that are added."""
        by_set: dict[str, list[Node]] = {}
        inherited = _fields(self.parent.get("supports"))
        added = _listed(self.own.get("supports"))
        for full, entry in added:
            self.check_new(full, entry, lacked, "documented")
        own = {full for full, kind in _kinds(self.own).items() if kind != "listed"}  # of both, documented counts
        out = lacked | {full for full, _ in added} | own
        for full, entry in (*((f, x) for f, x in inherited.items() if f not in out), *added):
            by_set.setdefault(full.partition(".")[0], []).append(entry)
        keys: dict[str, m.Position] = {}
        for node in (self.parent, self.own):
            keys |= node["supports"].keys if "supports" in node else {}
        return self.mapped("supports", {name: self.listed(name, entries) for name, entries in by_set.items()}, keys)

    def evidence(self, lacked: set[str]) -> Node:
        """Returns the same for other evidence: the device's own evidence replaces inherited evidence."""
        for kind, full, entry in _evident(self.own):
            self.check_new(full, entry, lacked, kind)
        kinds = _kinds(self.own)
        again = {full for full, kind in kinds.items() if kind == "listed"}  # a list does not weaken what is documented
        left = []
        for group in self.inherited():
            out = lacked | (kinds.keys() - again if group["kind"].value == "documented" else kinds.keys())
            left += _left(group, out)
        return self.listed("evidence", [*left, *(self.own.get("evidence") or ())])

    def inherited(self) -> Iterator[Node]:
        """Yields the evidence of the other device. A field that only that device itself lists is assumed here."""
        if "family" in self.parent:
            yield from self.parent.get("evidence") or ()
            return
        statements = _evident(self.parent)
        lists = {full for kind, full, _ in statements if kind == "listed"}
        others = {full for kind, full, _ in statements if kind not in ("listed", "refused")} | {
            *_fields(self.parent.get("supports"))
        }
        for group in self.parent.get("evidence") or ():
            if group["kind"].value != "listed":
                yield from _left(group, lists if group["kind"].value == "refused" else set())
                continue
            for kept in _left(group, others):
                yield self.of_sister(kept)
            others |= {*_fields(group["fields"])}

    def of_sister(self, group: Node) -> Node:
        kind, name = (replace(group["kind"], value=word) for word in ("sister", self.like))
        kept = {key: node for key, node in group.items() if key not in ("firmware", "date", "undefined")}
        return replace(group, value={**kept, "kind": kind, "of": replace(name, value=[name])})

    def check_new(self, full: str, entry: Node, lacked: set[str], kind: str) -> None:
        """Requires a statement that is stronger than the inherited one, or contradicts it. A device's own list may
        repeat it."""
        inherited = self.kinds.get(full)
        if inherited is None or full in lacked or (inherited == "refused") != (kind == "refused") or kind == "listed":
            return
        if m.strength(kind) >= m.strength(inherited):
            self.problems.add(entry.position, f"'{self.like}' already has '{full}' ({inherited}); remove it")

    def names(self, supports: Node | None, evidence: Node | None) -> set[str]:
        """Returns the fields that are supported or believed to be, their responses, and their sets."""
        names = set()
        groups = [group for group in evidence or () if group["kind"].value != "refused"]
        for full in (*_fields(supports), *(full for group in groups for full in _fields(group["fields"]))):
            f = self.model.field(full)
            names |= {full, full.partition(".")[0], *(r.full_name for r in (self.model.responses(f) if f else ()))}
        return names

    # ----------------------------------------------------------------------- the rest

    def keyed(self, key: str, has: set[str]) -> Node:
        """Returns inherited statements about fields and sets that the device supports, then its own."""
        inherited, own = self.parent.get(key), self.own.get(key)
        without = self.without(key, list(inherited.value) if inherited else [])
        nodes: dict[str, Node] = {}
        keys: dict[str, m.Position] = {}
        for name, node in inherited.items() if inherited else ():
            of = name.rpartition(".")[0] if key == "varies" else name
            if name not in without and self.concerned(of, has):
                assert inherited is not None
                nodes[name], keys[name] = node, inherited.keys[name]
        return self.mapped(key, {**nodes, **(own.value if own else {})}, {**keys, **(own.keys if own else {})})

    def concerned(self, name: str, has: set[str]) -> bool:
        """True if the device has this field or set. A statement of a family is kept, since some of its devices have the
        field; an unknown name is kept, so that it is reported."""
        f = self.model.field(name)
        if f is None:
            return name in has or all(name != s.name for s in self.model.sets)
        return "family" in self.own or f is self.model.protocol.acknowledge or not has.isdisjoint(f.names)

    def named(self, key: str) -> Node:
        """Returns the entries of both; an own entry replaces an inherited one with the same name."""
        entries = {entry["name"].value: entry for entry in self.parent.get(key) or ()}
        for name in self.without(key, list(entries)):
            entries.pop(name, None)
        own = list(self.own.get(key) or ())
        again = {entry["name"].value: entry for entry in own}
        kept = [again.pop(name, entry) for name, entry in entries.items()]
        return self.listed(key, [*kept, *(x for x in own if x not in kept)])

    def without(self, key: str, names: list[str]) -> set[str]:
        """Returns the names of the entries that are not inherited."""
        lists = self.own.get("without")
        entries = list(lists[key]) if lists is not None and key in lists else []
        for entry in entries:
            if entry.value not in names:
                near = nearest(entry.value, names)
                self.problems.add(entry.position, f"'{self.like}' has no '{entry.value}' in {key}{near}")
        return {entry.value for entry in entries}


def _listed(node: Node | None) -> list[tuple[str, Node]]:
    """Yields full name and entry of each field in a list by set."""
    return [(f"{name}.{entry.value}", entry) for name, entries in (node.items() if node else ()) for entry in entries]


def _fields(node: Node | None) -> dict[str, Node]:
    return dict(_listed(node))


def _evident(node: Node) -> list[tuple[str, str, Node]]:
    """Yields the same for the fields that other evidence names, each with the kind of evidence."""
    groups = node.get("evidence") or ()
    return [(group["kind"].value, full, x) for group in groups for full, x in _listed(group["fields"])]


def _kinds(node: Node) -> dict[str, str]:
    """Returns the kind of the strongest evidence for each field in a profile, by full name."""
    weakest_first = sorted(_evident(node), key=lambda statement: m.strength(statement[0]), reverse=True)
    return {
        **{full: kind for kind, full, _ in weakest_first},
        **dict.fromkeys(_fields(node.get("supports")), "documented"),
    }


def _left(group: Node, out: Set[str]) -> list[Node]:
    """Returns an entry of the evidence without some fields; an empty list if nothing is left."""
    fields = {}
    for name, entries in group["fields"].items():
        kept = [x for x in entries if f"{name}.{x.value}" not in out]
        if kept:
            fields[name] = replace(entries, value=kept)
    return [replace(group, value={**group.value, "fields": replace(group["fields"], value=fields)})] if fields else []

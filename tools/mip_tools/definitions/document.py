"""Reads a `mip.json`: finds the items to which names refer, and their names in Python."""

from __future__ import annotations

import json
import keyword
from functools import cached_property
from importlib import import_module
from pathlib import Path
from typing import Any

from ..errors import NoBinding

#: Names that attributes of fields cannot have; below, those that bits and elements of vectors cannot have.
MEMBERS = frozenset(
    """codec types wire encode decode decode_with_trailing meaning answered expected matches find packet packet_set
    is_valid to_dict to_text mro cls self field len int float bool str bytes tuple property classmethod""".split()  # noqa: SIM905
)
BITS = frozenset(
    """name value real imag numerator denominator conjugate as_integer_ratio to_bytes from_bytes bit_length bit_count
    is_integer""".split()  # noqa: SIM905
)
ELEMENTS = frozenset(("count", "index", "rows"))

Item = dict[str, Any]


class Document:
    """The content of a file. Raises NoBinding if it is not a `mip.json`, or has another format."""

    def __init__(self, path: Path, package: str) -> None:
        self.path, self.package = path, package
        try:
            self.content: Item = json.loads(path.read_text("utf-8"))
            if str(self.content["format"]).partition(".")[0] != "1":
                raise NoBinding(f"{path} has format {self.content['format']}, but these tools read 1")
        except OSError as error:
            raise NoBinding(f"{path}: {error.strerror}") from None
        except (ValueError, KeyError, TypeError):
            raise NoBinding(f"{path} is not a mip.json, which `mipgen generate --target json` writes") from None
        self.types: dict[str, Item] = {t["name"]: t for t in self.content["types"]}
        self.fields: dict[str, Item] = {f["name"]: f for f in self.content["fields"]}
        self.functions: dict[str, Item] = {f["name"]: f for f in self.content["functions"]}
        self.sets: dict[int, Item] = {s["number"]: s for s in self.content["sets"]}

    @cached_property
    def homes(self) -> dict[str, Item]:
        """Module -> the first set of its family."""
        found: dict[str, Item] = {}
        for s in self.content["sets"]:
            found.setdefault(self.module(s["family"]), s)
        return found

    # ----------------------------------------------------------------- what refers to what

    @cached_property
    def _places(self) -> dict[str, tuple[int, Item]]:
        """Name of a field, in each of its sets -> set number, and the field."""
        found = {f["name"]: (f["set"], f) for f in self.content["fields"]}
        return found | {o["name"]: (o["set"], f) for f in self.content["fields"] for o in f.get("occurrences", ())}

    def place(self, name: str) -> tuple[int, Item]:
        """Returns the set that the name of a field states, and the field."""
        return self._places[name]

    def sets_of(self, f: Item) -> range | tuple[int, ...]:
        """Returns the sets that have a field: the acknowledge is in all command sets, shared ones in all data sets."""
        if f["name"] == self.content["acknowledge"]:
            return range(0x01, 0x80)
        if self.sets[f["set"]]["kind"] == "shared":
            return range(0x80, 0xFF)
        return tuple(o["set"] for o in f.get("occurrences", ({"set": f["set"]},)))

    def layouts(self, f: Item) -> list[Item]:
        """Returns all layouts with the descriptor of a field, among which the data decide."""
        places = {(set, f["descriptor"]) for set in self._numbers(f)}
        return [g for g in self.content["fields"] if places & {(set, g["descriptor"]) for set in self._numbers(g)}]

    def _numbers(self, f: Item) -> list[int]:
        return [o["set"] for o in f.get("occurrences", ({"set": f["set"]},))]

    @cached_property
    def _devices(self) -> dict[str, dict[str, bool]]:
        """Name of a field -> the devices that have it, and whether that is certain."""
        found: dict[str, dict[str, bool]] = {}
        for d in self.content["devices"]:
            for s in d.get("supports", ()):
                f = self.place(s["field"])[1]
                certain = d["evidence"][s["evidence"]]["answer"] == "yes"
                for name in [f["name"], *self._answers(f, s, d["id"])]:
                    known = found.setdefault(name, {})
                    known[d["id"]] = known.get(d["id"], False) or certain
        return found

    def devices_of(self, f: Item) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Returns the ids of the devices that certainly have a field, and of those that probably have it."""
        known = self._devices.get(f["name"], {})
        ids = [d["id"] for d in self.content["devices"] if d["id"] in known]
        return tuple(x for x in ids if known[x]), tuple(x for x in ids if not known[x])

    def _answers(self, command: Item, support: Item, device: str) -> list[str]:
        """Returns the responses with which a device answers a command."""
        functions = support.get("functions", [c["function"] for c in command.get("calls", ())])
        if command.get("calls") and not any(self.functions[x]["responds"] for x in functions):
            return []
        answers: list[str] = []
        for _, layouts in self.replies(command):
            own = [f for f in layouts if device in f.get("devices", ())]
            answers += [f["name"] for f in own or [f for f in layouts if not f.get("devices")] or layouts]
        return answers

    def replies(self, command: Item) -> list[tuple[list[Item], list[Item]]]:
        """Returns the conditions for each response to a command, and its layouts."""
        replies: list[tuple[list[Item], list[Item]]] = []
        for name in command.get("responses", ()):
            f = self.fields[name]
            when = f.get("when", []) if f.get("command") == command["name"] else []
            known = next((layouts for other, layouts in replies if other == when), None)
            if known is None:
                replies.append((when, [f]))
            else:
                known.append(f)
        return replies

    # ----------------------------------------------------------------- names in Python

    def module(self, family: str) -> str:
        symbols = [f["symbols"]["python"] for f in self.content["fields"] if f["name"].partition(".")[0] == family]
        return self.checked(symbols[0].split(".")[-2]) if symbols else self.checked(family)

    def symbol(self, name: str) -> tuple[str, str]:
        """Returns the names of the module and the class of a type or a field."""
        thing = self.types.get(name) or self.fields[name]
        if thing.get("kind") == "vector":
            return "types", self.checked(thing["name"][:1].upper() + thing["name"][1:])
        _, *home, last = thing["symbols"]["python"].split(".")
        return (home[0] if home else "protocol"), self.checked(last)

    def get(self, name: str) -> Any:
        """Returns the class of a type or a field."""
        home, called = self.symbol(name)
        return getattr(import_module(f"{self.package}.{home}"), called)

    def member(self, name: str, reserved: frozenset[str] = MEMBERS) -> str:
        """Returns the Python name of a parameter, a function or a part of a value."""
        name = f"n{name}" if name[:1].isdigit() else name
        return self.checked(f"{name}_" if name in reserved or keyword.iskeyword(name) else name)

    def constant(self, name: str) -> str:
        return self.checked((f"N{name}" if name[:1].isdigit() else name).upper())

    def checked(self, name: str) -> str:
        """Checks a name that becomes part of executed code. Raises NoBinding if it is not an identifier."""
        if not name.isidentifier() or name.startswith("__"):
            raise NoBinding(f"{self.path}: {name!r} is not a name")
        return name

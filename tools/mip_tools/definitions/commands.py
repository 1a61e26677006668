"""Makes the classes of fields, with constructors and responses of commands."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .document import Item
from .records import Records, default, derived, doc


class Fields(Records):
    """Makes the classes of fields of one module."""

    def add_field(self, f: Item) -> type:
        name, bases = self.document.symbol(f["name"])[1], []
        sets = self.document.sets_of(f)
        if len(sets) > 1:
            bases.append(self.field.Shared)
        bases.append(getattr(self.field, f["role"].capitalize()))
        several = len(f.get("occurrences", ())) > 1
        descriptors = f"0x{f['descriptor']:02X}" if several else f"0x{f['set']:02X},0x{f['descriptor']:02X}"
        content: dict[str, Any] = {
            "__doc__": doc(f, f"{f['title']} ({descriptors})."),
            "SETS": sets,
            "DESCRIPTOR": f["descriptor"],
            "NAME": f["name"],
            "ROLE": f["role"],
            **self.record(f),
        }
        if not several:
            content["SET"] = f["set"]
        matches = self.matches(f)
        if matches is not None:
            content["matches"] = classmethod(matches)
        if f["role"] == "command":
            content |= self.command(f)
        return self.add(name, tuple(bases), content)

    def command(self, f: Item) -> dict[str, Any]:
        functions = self.document.functions
        content: dict[str, Any] = {
            "RESPONSES": tuple(self.document.get(name) for name in f.get("responses", ())),
            "SILENCED_BY": tuple(
                (of["set"], of["descriptor"], self.document.member(c["parameter"]), c["value"])
                for c in f.get("silenced_by", ())
                for of in [self.document.fields[c["command"]]]
            ),
        }
        if "timeout" in f:
            content["TIMEOUT"] = f["timeout"]
        if "calls" in f:
            content["REQUIRED"] = {functions[c["function"]]["value"]: len(c["required"]) for c in f["calls"]}
            for call in f["calls"]:
                function = functions[call["function"]]
                content[self.document.member(function["name"])] = classmethod(self.constructor(f, call, function))
        unanswered = [
            functions[c["function"]]["value"] for c in f.get("calls", ()) if not functions[c["function"]]["reply"]
        ]
        silent = [self.condition(c) for c in f.get("silent_when", ())]
        if unanswered or silent:
            content["answered"] = property(
                lambda self: (
                    getattr(self, "function", None) not in unanswered
                    and (not silent or not all(holds(self) for holds in silent))
                )
            )
        expected = self.expected(f)
        if expected is not None:
            content["expected"] = property(expected)
        return content

    def constructor(self, f: Item, call: Item, function: Item) -> Any:
        """Makes the constructor of a command for a function, with the parameters that this function has."""
        parameters = {p["name"]: p for p in f["parameters"]}
        required = [parameters[name] for name in call["required"]]
        optional = [parameters[name] for name in call["optional"]]
        addable = [p for p in optional if "reserved" not in p and not derived(p)]
        member = self.document.member
        names: dict[str, Any] = {
            "_function": self.document.get(self.document.content["function_selector"])(function["value"])
        }
        asked = [member(p["name"]) for p in required if "reserved" not in p and not derived(p)]
        asked += [f"{member(p['name'])}=None" for p in addable]
        passed = []
        for i, p in enumerate(required):
            if not derived(p):
                names[f"_d{i}"] = default(p, False) if "reserved" in p else None
                passed.append(f"{member(p['name'])}={f'_d{i}' if 'reserved' in p else member(p['name'])}")
        for i, p in enumerate(optional):
            later = [q for q in optional[i:] if q in addable]
            if p in addable:
                passed.append(f"{member(p['name'])}={member(p['name'])}")
            elif "reserved" in p and later:  # it is present if the parameters after it are
                names[f"_o{i}"] = default(p, False)
                passed.append(f"{member(p['name'])}=_o{i} if {member(later[0]['name'])} is not None else None")
        exec(f"def made({', '.join(['cls', *asked])}): return cls({', '.join(['_function', *passed])})", names)
        names["made"].__name__ = member(function["name"])
        names["made"].__doc__ = function["description"]
        return names["made"]

    def condition(self, c: Item) -> Callable[[Any], bool]:
        """Makes a predicate: does a command have this value? For a Boolean, all values but 0 are true."""
        name, value = self.document.member(c["parameter"]), c["value"]
        if c["label"] in ("true", "false"):
            return lambda command: bool(getattr(command, name)) == bool(value)
        return lambda command: bool(getattr(command, name) == value)

    def expected(self, f: Item) -> Any:
        """Makes the function that selects the response to a command; None if it does not depend on the values."""
        functions = self.document.functions
        given = [functions[c["function"]] for c in f.get("calls", ())]
        responding = [x["value"] for x in given if x["responds"]]
        replies = [
            ([self.condition(c) for c in when], tuple(self.document.get(x["name"]) for x in layouts))
            for when, layouts in self.document.replies(f)
        ]
        if not replies or (not responding and not any(when for when, _ in replies)):
            return None

        def expected(self: Any) -> tuple[Any, ...]:
            if responding and self.function not in responding:
                return ()
            return next((layouts for when, layouts in replies if all(holds(self) for holds in when)), ())

        return expected

    def matches(self, f: Item) -> Any:
        """Makes a predicate: can this field have these data, judged by their size and constants?"""
        signature = constants(f)
        others = [g["min_size"] for g in self.document.layouts(f) if {*constants(g)} <= {*signature}]
        least = f["min_size"] if min(others) < f["min_size"] else 0
        most = min((n for n in others if n > f["min_size"]), default=256)
        if not least and most == 256 and not signature:
            return None

        def matches(cls: type, data: bytes) -> bool:
            return least <= len(data) < most and all(
                octets.startswith(data[at : at + len(octets)]) for at, octets in signature
            )

        return matches


def constants(f: Item) -> list[tuple[int, bytes]]:
    """Returns the constants at fixed offsets in the data."""
    return [(c["offset"], c["value"].to_bytes(c["size"], "big")) for c in f.get("constants", ())]

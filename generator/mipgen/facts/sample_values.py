"""Typical values of fields, for the packets and programs in documentation.

A value comes from the first of these sources that states one: an example in a manual, `typical` in the specification, a
simulated device, the factory default, the setting of a new device. If none does, the value is simple and within its
range; `made_up` lists such parameters.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from mipgen import model as m
from mipgen.lower import codec, validity
from mipgen.model.parameters import alike
from mipgen.model.simulation import Value

from .examples import is_plain
from .records import Filled, lists
from .simulated_values import number_of_name, parameter_at, set_path, simulated_value


@dataclass(frozen=True)
class SampleValues:
    model: m.Model

    def values(self, f: m.Field, call: m.Call) -> codec.Values:
        """Returns the values that a field requires in this form, as the codec represents them. They are computed only
        once, so do not change them."""
        key = (f.full_name, call.function.value if call.function else None)
        if key not in self._values:
            self._values[key] = self._made(f, call, [])
        return self._values[key]

    def whole(self, f: m.Field, call: m.Call) -> codec.Values:
        """Returns the same without the function, and with the optional values."""
        sample = self.values(f, call)
        if call.optional:
            asked = tuple(p for p in (*call.required, *call.optional) if p.constant is None)
            sample = Filled(asked, self._stated(f) | sample, []).values()
        return {name: value for name, value in sample.items() if name != "function" or not f.selector}

    def made_up(self, f: m.Field, call: m.Call) -> list[str]:
        """Returns the parameters, and members of structures, whose values no source states."""
        paths: list[str] = []
        self._made(f, call, paths)
        return paths

    def _made(self, f: m.Field, call: m.Call, made_up: list[str]) -> codec.Values:
        chosen: codec.Values = {"function": call.function.value} if call.function else {}
        printed = self._printed.get(f.full_name, {}).get(chosen.get("function"), {})
        needed = [p for p in call.required if p.constant is None]
        if needed and all(p.name in printed for p in needed):
            tags = {q.tag for q in needed}  # they select the members of unions
            own = {p.name: p.typical for p in needed if p.typical is not None and p.name not in tags}
            values = chosen | {p.name: printed[p.name] for p in needed} | own
            return values | {p.name: len(values[p.counts]) for p in needed if p.counts is not None}
        return chosen | Filled(tuple(needed), self._stated(f), made_up).values()

    def _stated(self, f: m.Field) -> codec.Values:
        """Returns the known values of a field, as the codec represents them; structures may lack members."""
        by_name = {p.name: p for p in f.parameters}
        stated: codec.Values = {}
        for name, value in self._initial.get(f.full_name, ()):
            if value is not None:
                _state(stated, by_name[name], value)
        for p in f.parameters:
            if p.default is not None:
                _state(stated, p, p.default)
        stated |= self._asked(f)
        stated |= self._simulated(f)
        if f.role == m.COMMAND:
            for values in self._printed.get(f.full_name, {}).values():
                stated |= {key: value for key, value in values.items() if key != "function"}
        return stated | {p.name: p.typical for p in f.parameters if p.typical is not None}

    def _asked(self, f: m.Field) -> codec.Values:
        """Returns the values of a response that repeat those of its command."""
        command = self.model.field(f"{f.family}.{f.command}") if f.command else None
        if command is None:
            return {}
        same = {p.name: p for p in command.counted if p.constant is None}
        values = self.values(command, command.calls[0])
        asked = {p.name: values[p.name] for p in f.parameters if p.name in values and _same_form(p, same[p.name])}
        return asked | {c.parameter: c.value for c in f.when if c.parameter in {p.name for p in f.parameters}}

    def _simulated(self, f: m.Field) -> codec.Values:
        """Returns the values of a simulated device, with the flags that mark them as valid."""
        source = self._sources.get(f.full_name)
        if source is None:
            return {}
        simulated: codec.Values = {}
        for v in source:
            p = parameter_at(f.parameters, v.path)
            value = None if p is None else self._shown(v, p)
            if value is not None:
                set_path(simulated, v.path, value)
        for flag in (flag for p in f.parameters for flag in validity.flags_named(p.valid, f)):
            simulated[flag.parameter] = simulated.get(flag.parameter, 0) | (flag.mask or 1)
        return simulated

    def _shown(self, v: Value, p: m.Parameter) -> Any:
        if v.names or v.bits:
            return number_of_name(p, v)
        value: Any = v.number if v.number is not None else v.text
        if v.quantity:
            value = self._quantities.get(v.quantity)  # a missing quantity is reported elsewhere
        if value is None:
            return None
        return simulated_value(p, value, v.factor)

    def shown(self, f: m.Field) -> list[m.Call]:
        """Returns the forms of a command that show its use: the first one, and the first one that requests values."""
        calls = self.sent(f)
        asking = next((c for c in calls if self.replies(f, c)), calls[0])
        return [calls[0]] if asking is calls[0] else [calls[0], asking]

    def sent(self, f: m.Field) -> list[m.Call]:
        """Returns the forms of a field that some device accepts."""
        taken = self.model.taken(f)
        return [c for c in f.calls if c.function is None or c.function in taken]

    def replies(self, f: m.Field, call: m.Call) -> list[m.Reply]:
        """Returns the responses to a command in this form."""
        values = self.values(f, call)
        return [
            r
            for r in self.model.replies(f)
            if (call.function is None or call.function in r.functions)
            and all(c.holds(values.get(c.parameter)) for c in r.when)
        ]

    def data(self, f: m.Field, call: m.Call | None = None) -> bytes:
        return codec.encode(f, self.values(f, call or f.calls[0]))

    def packet(self, f: m.Field, call: m.Call | None = None) -> bytes:
        """Builds a packet with only this field; a field of all data sets is sent in the first of them."""
        sets = [s.number for s in self.model.sets if s.number in f.sets] if f.everywhere else []
        number = sets[0] if sets else f.set
        return codec.build(self.model, number, [(f.descriptor, self.data(f, call))])

    @cached_property
    def _values(self) -> dict[tuple[str, int | None], codec.Values]:
        return {}

    @cached_property
    def _quantities(self) -> dict[str, Any]:
        return {q.name: q.typical for q in self.model.simulation.quantities}

    @cached_property
    def _sources(self) -> dict[str, tuple[Value, ...]]:
        return {s.field.full_name: s.values for s in reversed(self.model.simulation.sources)}

    @cached_property
    def _initial(self) -> dict[str, list[tuple[str, Any]]]:
        """Returns the settings of each command on a new device."""
        initial: dict[str, list[tuple[str, Any]]] = {}
        for b in self.model.simulation.behaviors:
            initial.setdefault(b.command.full_name, []).extend(b.initial)
        return initial

    @cached_property
    def _printed(self) -> dict[str, dict[int | None, codec.Values]]:
        """Returns, by field and function, the values of the first example that can serve as typical."""
        printed: dict[str, dict[int | None, codec.Values]] = {}
        for x in self.model.examples:
            for part in x.fields:
                f = self.model.field(part.field) if part.field else None
                if f is None or part.values is None or part.trailing or not is_plain(f.parameters, part.values):
                    continue
                function: Any = part.values.get("function") if f.selector else None
                printed.setdefault(f.full_name, {}).setdefault(function, part.values)
        return printed


@dataclass(frozen=True)
class GivenValues(SampleValues):
    """Supplies given values for one field instead of typical ones."""

    call: m.Call
    stated: codec.Values
    host: str = ""  # what a program does after the reply

    def values(self, f: m.Field, call: m.Call) -> codec.Values:
        return self.stated

    def shown(self, f: m.Field) -> list[m.Call]:
        return [self.call]


def title_of(f: m.Field, values: GivenValues) -> str:
    """Writes the comment beside a line of a program that sends a command."""
    return f"{f.title}, {values.call.function.name}" if values.call.function else f.title


def _same_form(p: m.Parameter, q: m.Parameter) -> bool:
    return p.element is q.element and p.length == q.length and alike(p.cases, q.cases)


def _state(values: codec.Values, p: m.Parameter, value: object) -> None:
    """Adds a default, unless it is in words."""
    try:
        values[p.name] = codec.canonical(p, lists(value), p.name)
    except ValueError:
        pass

"""The functions for a command: one sends it, others send it and wait for its response."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import session as lower
from mipgen.lower.calls import replies
from mipgen.lower.memory import members

from .members import Constructor, argument, constructors, takes_enum
from .names import argument_name, constant, field_name, macro, member, module, short, type_name


@dataclass(frozen=True, slots=True)
class Send:
    """A function of the client that sends a command."""

    name: str
    response: m.Field | None
    doc: list[str]


@dataclass(frozen=True, slots=True)
class Put:
    """A number or the elements of an array in a command's data, and the value to write."""

    scalar: m.Scalar
    at: int
    value: str
    index: str = ""  # "[i].rate": for an element, the suffix of the value
    count: str = ""  # of an array
    most: int = 0  # the maximum number of elements; 0 if it is fixed
    stride: int = 0  # bytes of an element


@dataclass(frozen=True, slots=True)
class Data:
    """The data of a command, written without its structure."""

    puts: tuple[Put, ...]
    size: int
    array: Put | None = None  # the array at the end whose elements the caller counts, if there is one


@dataclass(frozen=True, slots=True)
class Call:
    """A function that sends a command and waits for its reply."""

    name: str
    field: m.Field
    response: m.Field | None
    doc: list[str]
    way: Constructor | None = None  # makes the command's structure from the arguments
    given: tuple[m.Parameter, ...] = ()  # the arguments
    passed: tuple[str, ...] = ()  # the arguments of the constructor
    whole: bool = False  # is the command's structure the argument?
    data: Data | None = None  # None: it is encoded from the structure

    @property
    def arguments(self) -> tuple[str, ...]:
        if self.whole:
            return (f"const struct {field_name(self.field)} *command",)
        return tuple(argument(p, self.field) for p in self.given)

    @property
    def value(self) -> str:
        """An expression: the address of the command's structure."""
        if self.way is None:
            return "command" if self.whole else "NULL"
        return f"{field_name(self.field)}_{self.way.name}({', '.join(('&command', *self.passed))})"

    @property
    def makes(self) -> bool:
        """True if the function makes the command's structure."""
        return self.way is not None


def commands(family: m.Family) -> list[m.Field]:
    return [f for f in family.fields if f.role == m.COMMAND]


def sends(f: m.Field, model: m.Model) -> list[Send]:
    """Returns the function that sends a command, and one for each of several possible responses or layouts."""
    what = f"Adds the command to a packet and tracks its reply: see mip_client_send. {f.title}."
    responses = model.responses(f)
    if len(responses) == 1:
        where = "If the command requests the response, it is stored in `response`, which may be NULL."
        return [Send(_name("send", f), responses[0], [f"{what} {where}"])]
    plain = Send(_name("send", f), None, [what])
    return [plain, *(Send(_name("send_for", r), r, [f"{what} Expects this response."]) for r in responses)]


# --------------------------------------------------------------------------- the first minutes


@dataclass(frozen=True, slots=True)
class Older:
    """Like `Session`, for one data set of an older device."""

    set: int
    base_rate: str
    base_rates: str
    rate: str
    format: str
    stream: int


@dataclass(frozen=True, slots=True)
class Session:
    """The names that mip_device_connect and mip_device_stream use: functions, structures and members."""

    headers: tuple[str, ...]
    bauds: tuple[int, ...]
    ping: str
    idle: str
    resume: str
    identify: str
    identity: str  # the structure of its response
    model_numbers: tuple[str, ...]
    base_rate: str
    base_rates: str
    rate: str
    format: str
    item: str  # the structure of a field and its decimation
    descriptor: str
    decimation: str
    capacity: int
    stream: str
    older: tuple[Older, ...]


def session(model: m.Model) -> Session | None:
    """Resolves the session; None if the specification, or the selected part of it, lacks one of the commands."""
    start = lower.session(model)
    if start is None:
        return None

    def call(f: m.Field) -> str:
        return next(iter(calls(f, model))).name

    (identity,) = model.responses(start.identify)
    item = start.entries.item.struct
    assert item
    descriptor, decimation = item.parameters
    return Session(
        headers=tuple(sorted({f"{module(f.family)}_commands" for f in start.commands})),
        bauds=start.bauds,
        ping=call(start.ping),
        idle=call(start.idle),
        resume=call(start.resume),
        identify=call(start.identify),
        identity=field_name(identity),
        model_numbers=tuple(".".join(map(member, path.split("."))) for path in start.model_numbers),
        base_rate=call(start.base_rate.command),
        base_rates=field_name(start.base_rate.response),
        rate=member(start.base_rate.parameter.name),
        format=call(start.format),
        item=type_name(item),
        descriptor=member(descriptor.name),
        decimation=member(decimation.name),
        capacity=start.entries.capacity,
        stream=call(start.stream),
        older=tuple(
            Older(
                set=x.set,
                base_rate=call(x.base_rate.command),
                base_rates=field_name(x.base_rate.response),
                rate=member(x.base_rate.parameter.name),
                format=call(x.format),
                stream=x.stream,
            )
            for x in start.older
        ),
    )


# --------------------------------------------------------------------------- calls


def calls(f: m.Field, model: m.Model) -> list[Call]:
    """Returns a call for each function of a command and for each response, and one with its structure, if it has
    one."""
    if not members(f):
        return list(_ways(f, None, model))
    made = [c for way in constructors(f) for c in _ways(f, way, model)]
    responses = model.responses(f)
    doc = f"{f.title}: calls the command with these values, including optional parameters. See mip_device_call."
    response = responses[0] if len(responses) == 1 else None
    return [*made, Call(f"{_name('call', f)}_with", f, response, [doc], whole=True)]


def _ways(f: m.Field, way: Constructor | None, model: m.Model) -> Iterator[Call]:
    """Yields the calls of one function of a command. If several responses are possible, each has its own call, which
    fixes the parameters that select it; the first call expects only an acknowledge."""
    function = way.function if way else None
    layouts = [(layout, r) for r in replies(f, function, model) for layout in r.layouts]
    end = f"_{function.name}" if function else ""
    if len(layouts) == 1:
        yield _call(f, f"{_name('call', f)}{end}", way, *layouts[0], fixed=False, model=model)
        return
    yield _call(f, f"{_name('call', f)}{end}", way, None, None, fixed=False, model=model)
    for layout, reply in layouts:
        yield _call(f, f"{_name('call_for', layout)}{end}", way, layout, reply, fixed=True, model=model)


def _call(
    f: m.Field,
    name: str,
    way: Constructor | None,
    response: m.Field | None,
    reply: m.Reply | None,
    fixed: bool,
    model: m.Model,
) -> Call:
    values = {c.parameter: c.value for c in reply.when} if reply and fixed else {}
    function = way.function if way else None
    doc = f"{f.title}: {function.name}. {function.description}" if function else f"{f.title}."
    doc += " The reply is decoded as this response." if fixed else ""
    doc += " See mip_device_call."
    asked = way.asked if way else ()
    passed: list[str] = []
    for p in asked:
        passed += [_literal(p, values[p.name])] if p.name in values else _passed(p)
    given = tuple(p for p in asked if p.name not in values)
    data = _data(f, function, asked, passed) if _determined(f, function, response, model) else None
    return Call(name, f, response, [doc], way, given, tuple(passed), data=data)


def _determined(f: m.Field, function: m.Function | None, response: m.Field | None, model: m.Model) -> bool:
    """Is the reply always this response, or only an acknowledge, whatever the values are?"""
    if f.silent_when or (function is not None and not function.reply):
        return False
    ways = replies(f, function, model)
    if not ways or response is None:
        return not ways
    return len(ways) == 1 and not ways[0].when and all(r.descriptor == response.descriptor for r in ways[0].layouts)


def _data(f: m.Field, function: m.Function | None, asked: tuple[m.Parameter, ...], passed: list[str]) -> Data | None:
    """Returns plain numbers at fixed offsets, and at most one array at the end; None for any other data."""
    if any(p.fills for p in asked):
        return None
    values = dict(zip((p.name for p in asked), passed, strict=True))
    puts: list[Put] = []
    at, array = 0, None
    if function is not None:
        puts.append(Put(m.SCALARS["u8"], 0, f"{macro('mip_function_selector')}_{macro(function.name)}"))
        at = 1
    for p in next(c for c in f.calls if c.function == function).required:
        value = values.get(p.name, "")
        if array is not None:
            return None
        if p.constant is not None:
            puts += [Put(m.SCALARS["u8"], at + i, str(byte)) for i, byte in enumerate(p.octets)]
            at += p.size
        elif p.reserved is not None and p.kind == "scalar" and p.scalar.kind != "float":
            puts.append(Put(p.scalar, at, str(p.reserved)))
            at += p.size
        elif value and p.kind in ("scalar", "counter"):
            puts.append(Put(p.scalar, at, f"mip_truth({value})" if p.scalar.kind == "bool" else value))
            at += p.size
        elif value and p.kind == "array":
            elements = _elements(p, at, value)
            if not elements:
                return None
            puts += elements
            if p.count is None:
                array = elements[0]
            else:
                at += elements[0].stride * p.count
        else:
            return None
    return Data(tuple(puts), at, array)


def _elements(p: m.Parameter, at: int, value: str) -> list[Put]:
    """Returns the numbers in the elements of an array; none if an element contains anything else."""
    parts = p.item.struct.parameters if p.item.struct else (p.item,)
    if not all(q.kind in ("scalar", "counter") and q.reserved is None for q in parts):
        return []
    stride = sum(q.size for q in parts)
    count, most = (str(p.count), 0) if p.count is not None else (argument_name(p.counter or ""), p.capacity)
    puts = []
    for q in parts:
        index = f"[i].{member(q.name)}" if p.item.struct else "[i]"
        puts.append(Put(q.scalar, at, value, index, count, most, stride))
        at += q.size
    return puts


def _passed(p: m.Parameter) -> list[str]:
    """Returns the names of the arguments for a parameter."""
    name = argument_name(p.name)
    return [f"{name}_count", name] if p.fills else [name]


def _literal(p: m.Parameter, value: int) -> str:
    """Writes the value of a parameter that selects the response."""
    if not isinstance(p.element, m.Enum) or not takes_enum(p):
        return str(value)
    named = next((v for v in p.element.values if v.value == value), None)
    return constant(p.element, named) if named else f"(enum {type_name(p.element)}){value}"


def identifiers(f: m.Field, model: m.Model) -> Iterator[str]:
    if f.role == m.COMMAND:
        yield f"{field_name(f)}_command"
        yield f"{field_name(f)}_exchange"
        yield from (s.name for s in sends(f, model))
        yield from (c.name for c in calls(f, model))


def _name(verb: str, f: m.Field) -> str:
    return f"mip_{verb}_{f.family}_{short(f)}"

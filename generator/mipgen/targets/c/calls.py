"""The functions for a command: one sends it, others send it and wait for its response."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import extent
from mipgen.lower import session as lower
from mipgen.lower.calls import replies
from mipgen.lower.memory import stored

from .comments import Comments
from .direct import at_offset, put_number, unsigned
from .members import CFunction, Constructor, argument, capacity, constructors, selector, takes_enum
from .names import argument_name, constant, count_argument, field_name, member, module, short, type_name


def _declared(response: m.Field | None) -> list[str]:
    """Declares the argument for the response."""
    return [f"struct {field_name(response)} *response"] if response else []


def _decoded(response: m.Field | None) -> str:
    """Writes the arguments for decoding the response."""
    return f"&{field_name(response)}_codec, response" if response else "NULL, NULL"


@dataclass(frozen=True, slots=True)
class Data:
    """The data of a command, written without its structure: numbers, and the elements of arrays."""

    exchange: str
    numbers: list[tuple[m.Scalar, int, str]]  # each with its offset
    loops: list[str]  # the statements that write the elements
    size: int  # without an array that the caller counts
    length: str  # the size with such an array at its end; empty if there is none

    @property
    def octets(self) -> list[str]:
        """The bytes of data that contains no larger numbers; otherwise empty."""
        single = [unsigned(scalar, value) for scalar, _, value in self.numbers if scalar.size == 1]
        return single if len(single) == len(self.numbers) and not self.loops else []

    @property
    def statements(self) -> list[str]:
        if self.octets:
            return [f"const uint8_t data[] = {{{', '.join(self.octets)}}};"]
        numbers = [put_number(scalar, at_offset("data", at), value) for scalar, at, value in self.numbers]
        declared = f"uint8_t data[{'MIP_MAX_FIELD_DATA' if self.length else self.size}];"
        return [declared, *numbers, *self.loops] if numbers or self.loops else []

    @property
    def arguments(self) -> str:
        """The data and its length."""
        return f"data, {self.length or self.size}" if self.length or self.size else f"MIP_NO_DATA({self.exchange}), 0"


@dataclass(frozen=True, slots=True)
class Call:
    """A function that sends a command and waits for its reply."""

    name: str
    field: m.Field
    response: m.Field | None
    summary: str
    way: Constructor | None = None  # makes the command's structure from the arguments
    parameters: tuple[m.Parameter, ...] = ()  # the arguments
    passed: tuple[str, ...] = ()  # the arguments of the constructor
    whole: bool = False  # is the command's structure the argument?
    fixed: m.Reply | None = None  # the one of several replies whose parameters it fixes
    data: Data | None = None  # None: it is encoded from the structure

    @property
    def arguments(self) -> tuple[str, ...]:
        if self.whole:
            return (f"const struct {field_name(self.field)} *command",)
        return tuple(argument(p, self.field) for p in self.parameters)

    @property
    def statements(self) -> list[str]:
        command = field_name(self.field)
        if self.data is None:
            made = [f"struct {command} command;"] if self.way else []
            sent = f"&{command}_command, {self.value}, {_decoded(self.response)}"
            return [*made, f"return mip_device_call(device, {sent});"]
        sent = f"(device, &{self.data.exchange}, {self.data.arguments}"
        end = f"request{sent}, {_decoded(self.response)}" if self.response else f"send{sent}"
        return [*self.data.statements, f"return mip_device_{end});"]

    @property
    def macro(self) -> tuple[str, ...]:
        """The end of a macro's name, and its arguments, if one defines the function: it passes a structure, or there is
        only the function selector to send."""
        if self.whole and self.response:
            return ("_WITH", self.name, field_name(self.field), field_name(self.response))
        function = self.way.function if self.way else None
        chosen = selector(function) if function else ""
        if self.data is None or self.parameters or [value for _, _, value in self.data.numbers] != [chosen]:
            return ()
        made = (self.name, field_name(self.field), chosen)
        return ("_FOR", *made, field_name(self.response)) if self.response else ("", *made)

    def function(self, docs: Comments) -> CFunction:
        """It is inline if compilers should see the array of a caller."""
        doc = [self.summary, *docs.arguments(self.parameters, self.field)]
        result = f"{'MIP_INLINE' if self.data and self.data.length else 'static inline'} struct mip_result"
        declarations = ["struct mip_device *device", *self.arguments, *_declared(self.response)]
        return CFunction(self.name, doc, result, declarations, self.statements)

    @property
    def value(self) -> str:
        """An expression: the address of the command's structure."""
        if self.way is None:
            return "command" if self.whole else "NULL"
        return f"{field_name(self.field)}_{self.way.name}({', '.join(('&command', *self.passed))})"


def sent_with(f: m.Field, model: m.Model) -> tuple[str, ...]:
    """Returns the arguments of MIP_SEND; empty if the command has no structure, or several responses or none."""
    responses = model.responses(f)
    return (_name("send", f), field_name(f), field_name(responses[0])) if stored(f) and len(responses) == 1 else ()


def functions(f: m.Field, model: m.Model) -> list[CFunction]:
    return [
        *(sends(f, model) if not sent_with(f, model) else []),
        *(c.function(Comments(model)) for c in calls(f, model) if not c.macro),
    ]


def sends(f: m.Field, model: m.Model) -> list[CFunction]:
    """Returns the function that sends a command, and one for each of several possible responses or layouts."""
    responses = model.responses(f)
    if len(responses) == 1:
        return [_send(f, _name("send", f), responses[0], "")]
    several = (_send(f, _name("send_for", r), r, " Expects this response.") for r in responses)
    return [_send(f, _name("send", f), None, ""), *several]


def _send(f: m.Field, name: str, response: m.Field | None, more: str) -> CFunction:
    doc = f"{f.title}: adds the command to a packet.{more} See mip_client_send."
    client = ["struct mip_client *client", "struct mip_request *request", "struct mip_builder *packet"]
    command = [f"const struct {field_name(f)} *command"] if stored(f) else []
    sent = f"&{field_name(f)}_command, {'command' if command else 'NULL'}, {_decoded(response)}"
    call = f"return mip_client_send(client, request, packet, {sent}, now);"
    declarations = [*client, *command, *_declared(response), "uint32_t now"]
    return CFunction(name, [doc], "static inline mip_error", declarations, [call])


# --------------------------------------------------------------------------- the first minutes


@dataclass(frozen=True, slots=True)
class Rates:
    """The functions that read a base rate and write which fields are sent, with the names that they use."""

    of: lower.Session | lower.Older
    base_rate: str
    response: str
    rate: str
    format: str
    command: str  # the structure of the latter


@dataclass(frozen=True, slots=True)
class Session:
    """The names that mip_device_connect and mip_device_stream use: functions, structures and members."""

    of: lower.Session
    headers: list[str]
    ping: str
    idle: str
    resume: str
    identify: str
    identity: str  # the structure of its response
    model_numbers: list[str]
    rates: Rates
    older: list[Rates]  # of older devices, each for one set
    item: str  # that of a field and its decimation
    descriptor: str
    decimation: str
    stream: str


def session_calls(model: m.Model) -> Session | None:
    """Resolves the session; None if the specification, or the selected part of it, lacks one of the commands."""
    start = lower.session(model)
    if start is None:
        return None

    def call(f: m.Field) -> str:
        return next(iter(calls(f, model))).name

    def rates(of: lower.Session | lower.Older) -> Rates:
        rate = of.base_rate
        names = call(rate.command), field_name(rate.response), member(rate.parameter.name)
        return Rates(of, *names, call(of.format), field_name(of.format))

    (identity,) = model.responses(start.identify)
    item = start.entries.item.struct
    assert item
    descriptor, decimation = item.parameters
    return Session(
        of=start,
        headers=sorted({f"{module(f.family)}_commands" for f in start.commands}),
        ping=call(start.ping),
        idle=call(start.idle),
        resume=call(start.resume),
        identify=call(start.identify),
        identity=field_name(identity),
        model_numbers=[".".join(map(member, path.split("."))) for path in start.model_numbers],
        rates=rates(start),
        older=[rates(x) for x in start.older],
        item=type_name(item),
        descriptor=member(descriptor.name),
        decimation=member(decimation.name),
        stream=call(start.stream),
    )


# --------------------------------------------------------------------------- calls


def calls(f: m.Field, model: m.Model) -> list[Call]:
    """Returns a call for each function of a command and for each response, and one with its structure, if it has
    one."""
    made = model.derived(_made)
    if f.full_name not in made:
        made[f.full_name] = _calls(f, model)
    return made[f.full_name]


def _made(_: m.Model) -> dict[str, list[Call]]:
    """Returns the calls of each field, once they have been made."""
    return {}


def _calls(f: m.Field, model: m.Model) -> list[Call]:
    if not stored(f):
        return list(_ways(f, None, model))
    made = [c for way in constructors(f) for c in _ways(f, way, model)]
    responses = model.responses(f)
    doc = f"{f.title}, with these values, including optional parameters."
    response = responses[0] if len(responses) == 1 else None
    return [*made, Call(f"{_name('call', f)}_with", f, response, doc, whole=True)]


def _ways(f: m.Field, way: Constructor | None, model: m.Model) -> Iterator[Call]:
    """Yields the calls of one function of a command. If several responses are possible, each has its own call, which
    fixes the parameters that select it; the first call expects only an acknowledge."""
    function = way.function if way else None
    layouts = [(layout, r) for r in replies(f, function, model) for layout in r.layouts]
    end = f"_{function.name}" if function else ""
    name = f"{_name('call', f)}{end}"
    yield _call(f, name, way, layouts[0][0] if len(layouts) == 1 else None, None, model)
    for layout, reply in layouts if len(layouts) > 1 else ():
        yield _call(f, f"{_name('call_for', layout)}{end}", way, layout, reply, model)


def _call(
    f: m.Field, name: str, way: Constructor | None, response: m.Field | None, fixed: m.Reply | None, model: m.Model
) -> Call:
    """Returns a call of a function. Its values are those that select the reply `fixed`, if there is one."""
    values = {c.parameter: c.value for c in fixed.when} if fixed else {}
    function, parameters = (way.function, way.parameters) if way else (None, ())
    doc = f"{f.title}: {function.name}." if function else f"{f.title}."
    doc += " The reply is decoded as this response." if fixed else ""
    passed: list[str] = []
    for p in parameters:
        passed += [literal(p, values[p.name])] if p.name in values else _passed(p)
    remaining = tuple(p for p in parameters if p.name not in values)
    data = _data(f, function, parameters, passed) if _determined(f, function, response, model) else None
    return Call(name, f, response, doc, way, remaining, tuple(passed), data=data, fixed=fixed)


def _determined(f: m.Field, function: m.Function | None, response: m.Field | None, model: m.Model) -> bool:
    """Is the reply always this response, or only an acknowledge, whatever the values are?"""
    if f.silent_when or (function is not None and not function.reply):
        return False
    ways = replies(f, function, model)
    if not ways or response is None:
        return not ways
    return len(ways) == 1 and not ways[0].when and all(r.descriptor == response.descriptor for r in ways[0].layouts)


def _data(
    f: m.Field, function: m.Function | None, parameters: tuple[m.Parameter, ...], passed: list[str]
) -> Data | None:
    """Writes plain numbers at fixed offsets, and at most one array at the end; None for any other data."""
    if any(p.fills for p in parameters):
        return None
    values = dict(zip((p.name for p in parameters), passed, strict=True))
    octet = m.SCALARS["u8"]
    numbers = [(octet, 0, selector(function))] if function else []
    loops: list[str] = []
    at, length = len(numbers), ""
    for p in next(c for c in f.calls if c.function == function).required:
        value = values.get(p.name, "")
        if length:
            return None
        if p.constant is not None:
            numbers += [(octet, at + i, str(byte)) for i, byte in enumerate(p.octets)]
        elif p.reserved is not None and p.kind == "scalar" and p.scalar.kind != "float":
            numbers.append((p.scalar, at, str(p.reserved)))
        elif value and p.kind in ("scalar", "counter"):
            numbers.append((p.scalar, at, f"mip_truth({value})" if p.scalar.kind == "bool" else value))
        elif value and p.kind == "array" and (loop := _loop(p, at, value)):
            loops += loop
            if p.counter:
                count = argument_name(p.counter)
                size = extent.item_size(p)
                length = f"{count} <= {capacity(p)} ? {at} + {size} * (size_t){count} : MIP_MAX_FIELD_DATA + 1"
        else:
            return None
        at += extent.size(p)[0]
    return Data(f"{field_name(f)}_exchange", numbers, loops, at, length)


def _loop(p: m.Parameter, at: int, value: str) -> list[str]:
    """Writes the numbers in the elements of an array; empty if an element contains anything else."""
    parts = p.item.struct.parameters if p.item.struct else (p.item,)
    if not all(q.kind in ("scalar", "counter") and q.reserved is None for q in parts):
        return []
    count = count_argument(p) if p.counter else str(p.capacity)
    checked = [f"(void)mip_counted({count}, {value}, sizeof({value}[0]));"] if p.counter else []
    lines = [*checked, f"for (size_t i = 0; i < {count}{f' && i < {capacity(p)}' if p.counter else ''}; i++) {{"]
    for q in parts:
        index = f"[i].{member(q.name)}" if p.item.struct else "[i]"
        lines.append(put_number(q.scalar, f"{at_offset('data', at)} + {extent.item_size(p)} * i", f"{value}{index}"))
        at += q.size
    return [*lines, "}"]


def _passed(p: m.Parameter) -> list[str]:
    """Returns the names of the arguments for a parameter."""
    name = argument_name(p.name)
    return [count_argument(p), name] if p.fills else [name]


def literal(p: m.Parameter, value: int) -> str:
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

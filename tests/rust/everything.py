"""Writes a Rust test that touches every type of a specification.

The generator's reference codec computes what the types must do; they are used here as a user would
use them. Nothing is listed by hand, so nothing can be forgotten.
"""

from __future__ import annotations

import json
import random
import re
from collections.abc import Iterable, Iterator
from typing import Any

import random_values
from conformance.client_model import wanted_responses
from mipgen import model as m
from mipgen.facts import describe
from mipgen.lower import codec
from mipgen.targets.rust import names as rust
from mipgen.targets.rust.view import Constructor, Crate
from support import sent

HEAD = """//! Made by everything.py.

#![allow(deprecated, unused_imports)]

use mip_protocol::registry::{FieldInfo, Listed, ParameterInfo};
use mip_protocol::{
    devices, AnyField, Bool, Command, DecodeErrorKind, DescriptorSet, EncodeErrorKind, Field, List, OneSet, Packet,
    PacketBuilder, RawField, ResponseOf, Text, VarText, View, Viewed,
};

/// A value that is encoded as these bytes, and decoded to itself.
fn same<T: Field + PartialEq + std::fmt::Debug>(value: T, data: &[u8]) {
    assert_eq!(value.to_vec().as_deref(), Ok(data), "{value:?}");
    assert_eq!(T::decode(data), Ok(value), "{}", T::NAME);
}

/// These data are the field in these sets, each with its name, and in no other.
fn occurs<T: Listed>(descriptor: u8, name: &str, sets: &[(u8, &str)], data: &[u8]) {
    assert_eq!((T::DESCRIPTOR, T::NAME), (descriptor, name));
    assert!(T::SETS.iter().map(|set| &set.0).eq(sets.iter().map(|(set, _)| set)), "{name}");
    assert_eq!((T::INFO.sets, T::INFO.descriptor, T::INFO.name), (T::SETS, descriptor, name));
    for (_, its_name) in sets {
        assert_eq!(FieldInfo::by_name(its_name), Some(&T::INFO));
    }
    let value = T::decode(data).unwrap();
    for set in (0..=255).map(DescriptorSet) {
        let its_name = sets.iter().find(|(number, _)| *number == set.0).map(|(_, its_name)| *its_name);
        assert_eq!((T::occurs_in(set), T::INFO.name_in(set)), (its_name.is_some(), its_name));
        assert_eq!(T::INFO.title_in(set).is_some(), its_name.is_some());
        let mut builder = PacketBuilder::new(set);
        let pushed = builder.push(&value).map_err(|error| (error.kind, error.got));
        let field = RawField { set, descriptor, data };
        let any = AnyField::decode_with_trailing(&field);
        let Some(its_name) = its_name else {
            assert_eq!(pushed, Err((EncodeErrorKind::Set, set.0.into())), "{name} in {set}");
            assert_eq!(field.get::<T>(), Ok(None));
            assert!(!matches!(any, Ok(Some(found)) if *found.field.info() == T::INFO));
            continue;
        };
        let packet = Packet::new(builder.bytes()).unwrap();
        assert_eq!((pushed, packet.set()), (Ok(()), set), "{its_name}");
        assert_eq!(packet.find::<T>(), Ok(Some(value.clone())), "{its_name}");
        let any = any.unwrap().unwrap();
        assert_eq!((any.set, any.name()), (set, its_name));
        assert_eq!(AnyField::decode(&field), Ok(Some(value.clone().into_any())));
        assert_eq!(any.field, value.clone().into_any());
    }
}

/// The same field as a view and decoded; with fewer bytes, both are the same error.
fn viewed<'a, T: Viewed + Listed>(field: &RawField<'a>) -> (View<'a, T>, T) {
    let short = RawField { data: &field.data[..field.data.len() - 1], ..*field };
    assert_eq!(short.view::<T>().is_err(), short.is::<T>());
    if let Err(error) = short.view::<T>() {
        assert_eq!((error.kind, error.field), (DecodeErrorKind::Truncated, T::NAME));
        assert_eq!((error.need, error.got), (field.data.len(), short.data.len()));
    }
    let mut builder = PacketBuilder::new(field.set);
    builder.push_raw(field.descriptor, field.data).unwrap();
    let value = builder.packet().find::<T>().unwrap().unwrap();
    alike(&builder.packet().view::<T>().unwrap().unwrap(), &value);
    (field.view().unwrap().unwrap(), value)
}

/// NaN is equal here.
fn alike(one: &dyn std::fmt::Debug, other: &dyn std::fmt::Debug) {
    assert_eq!(format!("{one:?}"), format!("{other:?}"));
}

fn only_in<T: OneSet>(set: u8) {
    let set = DescriptorSet(set);
    assert_eq!((T::SET, T::SETS), (set, &[set][..]));
}

fn described(all: &[ParameterInfo]) -> String {
    let one = |p: &ParameterInfo| {
        let frame = p.frame.unwrap_or("");
        format!("{} {:?} {:?} {frame:?} ({})", p.name, p.elements, p.units, described(p.members))
    };
    all.iter().map(one).collect::<Vec<_>>().join("; ")
}

fn describes<T: Listed>(wanted: &str) {
    assert_eq!(described(T::PARAMETERS), wanted, "{}", T::NAME);
    assert_eq!(FieldInfo::by_name(T::NAME).unwrap().parameters(), T::PARAMETERS);
}

fn answers<C: Command, R: ResponseOf<C>>() {}

macro_rules! copied {
    ($type:ty) => {{
        fn copies<T: Copy>() {}
        copies::<$type>();
    }};
}

/// Which of both traits is implemented would be ambiguous for a type that is `Copy`.
macro_rules! not_copied {
    ($type:ty) => {{
        trait Ambiguous<A> {
            fn name() {}
        }
        impl<T: ?Sized> Ambiguous<()> for T {}
        impl<T: ?Sized + Copy> Ambiguous<u8> for T {}
        <$type as Ambiguous<_>>::name();
    }};
}
"""


def source(model: m.Model, share: int = 1, seed: int = 0) -> str:
    """The tests; of bitfields, fields and devices one of `share`, which the seed draws."""
    writer, drawn = _Writer(model), slice(seed % share, None, share)
    parts = [HEAD]
    enumerations = [t for t in model.all_types if isinstance(t, m.Enum)]
    parts.append(test("enumerations", (line for t in enumerations for line in enumeration(t))))
    for t in [t for t in model.all_types if isinstance(t, m.Bitfield)][drawn]:
        parts.append(test(f"bits_of_{rust.home(t)}_{t.name}", bitfield(t)))
    for f in (*model.fields, model.protocol.acknowledge)[drawn]:
        parts.append(test(f"{rust.home(f)}_{f.name}", writer.field(f)))
    for d in model.devices[drawn]:
        parts.append(test(f"device_{d.name}", writer.device(d)))
    return "\n".join(parts)


def test(name: str, lines: Iterator[str]) -> str:
    body = "".join(f"    {line}\n" for line in lines)
    return f"#[test]\nfn {name}() {{\n{body}}}\n"


def path(t: m.Type | m.Field) -> str:
    """The name of a type for a user of the crate."""
    return f"mip_protocol::{rust.path(t, '').removeprefix('crate::')}"


def text(words: str) -> str:
    """A string literal."""
    return json.dumps(" ".join(words.split()), ensure_ascii=False)


def maybe(words: str | None) -> str:
    return f"Some({text(words)})" if words else "None"


def described(parameters: Iterable[m.Parameter]) -> str:
    """What Rust knows of each value at run time, including those inside of it."""
    found = []
    for p in parameters:
        if p.constant is None and p.counts is None:
            inside = p.element.parameters if isinstance(p.element, m.Struct) else [c.parameter for c in p.cases]
            elements = p.element.elements if isinstance(p.element, m.Vector) else ()
            about = " ".join(json.dumps(x) for x in (elements, p.units, p.frame or ""))
            found.append(f"{p.name} {about} ({described(x for x in inside if x)})")
    return "; ".join(found)


def data_literal(data: bytes) -> str:
    return f"&[{', '.join(str(b) for b in data)}]"


# --------------------------------------------------------------------------- enumerations and bitfields


def enumeration(t: m.Enum) -> Iterator[str]:
    for v in t.values:
        yield f"assert_eq!({path(t)}::{rust.constant(v.name)}.0, {v.value});"
        yield f'assert_eq!({path(t)}({v.value}).name(), Some("{v.name}"));'


def bitfield(t: m.Bitfield) -> Iterator[str]:
    """Every accessor of every bit: from all zeros, from all ones, and back again."""
    everything = (1 << 8 * t.size) - 1

    def raw(number: int) -> str:
        return str(number) if t.scalar else f"[{', '.join(str(b) for b in number.to_bytes(t.size, 'little'))}]"

    for b in t.bits:
        kind = rust.bits_type(b, "").removeprefix("crate::")
        of, get = path(t), rust.method(b.name)

        def value(number: int, kind: str = kind, b: m.Bits = b) -> str:
            if kind == "bool":
                return "true" if number else "false"
            return f"mip_protocol::{kind}({number})" if b.enum else str(number)

        most = (1 << b.width) - 1
        yield f"assert_eq!({of}::{rust.constant(b.name)}.0, {raw(b.mask)});"
        yield f"assert_eq!({of}({raw(everything)}).{get}(), {value(most)});"
        yield f"assert_eq!({of}({raw(everything & ~b.mask)}).{get}(), {value(0)});"
        for number in sorted({0, 1, most, most // 3, most ^ (most // 3)}):
            for before in (0, everything):
                after = before & ~b.mask | number << b.first
                yield f"let mut flags = {of}({raw(before)});"
                yield f"assert_eq!(flags.with_{b.name}({value(number)}).0, {raw(after)});"
                yield f"flags.set_{b.name}({value(number)});"
                yield f"flags.set_{b.name}({value(number)});"
                yield f"assert_eq!((flags.0, flags.{get}()), ({raw(after)}, {value(number)}));"
        yield f'assert!({of}::BITS.iter().any(|b| (b.name, b.first, b.last) == ("{b.name}", {b.first}, {b.last})));'


# --------------------------------------------------------------------------- fields


class _Writer:
    def __init__(self, model: m.Model) -> None:
        self.model = model
        self.crate = Crate(model)
        self.chance = random.Random(1)

    def field(self, f: m.Field) -> Iterator[str]:
        of = path(f)
        yield f"assert_eq!(<{of} as mip_protocol::Wire>::SIZE, {f.max_size});"
        yield f"describes::<{of}>({text(described(f.parameters))});"
        if f.role == m.COMMAND:
            for call, constructor in zip(f.calls, self.crate.record(f).constructors, strict=True):
                yield from self.constructed(f, call, constructor)
        elif f.parameters:
            ((call,), (constructor,)) = f.calls, self.crate.record(f).constructors
            expression, values = self.call(f, call.required, constructor)
            yield f"same({expression}, {data_literal(codec.encode(f, values))});"
        literal, values = self.literal(f)
        data = codec.encode(f, values)
        yield f"same({literal}, {data_literal(data)});"
        sets = ", ".join(f'({n}, "{f.name_in(n)}")' for n in sorted(f.sets))
        yield f'occurs::<{of}>({f.descriptor}, "{f.full_name}", &[{sets}], {data_literal(data)});'
        if len(f.sets) == 1:
            yield f"only_in::<{of}>({f.set});"
        fixed = f.min_size == f.max_size and all(p.constant is None for p in f.parameters)
        if f.role != m.COMMAND and fixed and f.parameters:
            of_set = f"set: DescriptorSet({min(f.sets)}), descriptor: {f.descriptor}"
            yield f"let field = RawField {{ {of_set}, data: {data_literal(data)} }};"
            yield f"let (view, value) = viewed::<{of}>(&field);"
            yield from self.values_in_view(f, "view", "value")
        if not f.selector:
            yield f"same({of}::default(), {data_literal(codec.encode(f, defaults(f)))});"
        size = "copied" if self.is_copy(f) else "not_copied"
        yield f"{size}!({of});"
        if f.role == m.COMMAND:
            timeout = f"Some({int(f.timeout * 1000)})" if f.timeout else "None"
            yield f"assert_eq!({of}::TIMEOUT_MS, {timeout});"
        for response in self.model.responses(f):
            yield f"answers::<{of}, {path(response)}>();"

    def values_in_view(self, record: m.Record, view: str, value: str) -> Iterator[str]:
        for x in self.crate.record(record).members:
            yield f"alike(&{view}.{x.name}(), &{value}.{x.name});"
            if x.parameter.struct:
                yield from self.values_in_view(x.parameter.struct, f"{view}.{x.name}()", f"{value}.{x.name}")

    def is_copy(self, f: m.Field) -> bool:
        """Small and without lists, on which a user may rely."""
        lists = any("List<" in x.type or "VarText<" in x.type for x in self.members(f))
        return f.max_size <= 64 and not lists

    def members(self, record: m.Record) -> Iterator[Any]:
        for x in self.crate.record(record).members:
            yield x
            for p in (x.parameter, *x.parameter.alternatives):
                if p.struct:
                    yield from self.members(p.struct)

    def constructed(self, f: m.Field, call: m.Call, constructor: Constructor) -> Iterator[str]:
        """A constructor must make the shortest form that the function allows."""
        function = call.function
        expression, values = self.call(f, call.required, constructor)
        if function is not None:
            values = {"function": function.value, **values}
        data = codec.encode(f, values)
        silent = [c for c in f.silent_when if values.get(c.parameter) == c.value]
        replies = (function is None or function.reply) and not (f.silent_when and len(silent) == len(f.silent_when))
        wanted = wanted_responses(self.model, f, values)
        yield f"let command = {expression};"
        yield f"same(command.clone(), {data_literal(data)});"
        yield f"assert_eq!(command.expects_reply(), {str(replies).lower()});"
        yield f"assert_eq!(command.response_check().is_some(), {str(bool(wanted)).lower()});"

    def call(
        self, record: m.Record, required: tuple[m.Parameter, ...], constructor: Constructor
    ) -> tuple[str, codec.Values]:
        """The call of a constructor with random arguments, and the values that it must make."""
        given = [x.parameter.name for x in constructor.arguments]
        values: codec.Values = {}
        for p in required:
            union = next((q for q in record.parameters if q.tag == p.name and q.name in given), None)
            if p.reserved is not None:
                values[p.name] = sent(p)
            elif union is not None:
                values[p.name] = self.chance.choice(union.cases).tag.value
            else:
                self.draw(p, values)
        return self.called(record, values, constructor), values

    def called(self, record: m.Record, values: codec.Values, constructor: Constructor) -> str:
        arguments = [self.value(x.parameter, record, values[x.parameter.name], values) for x in constructor.arguments]
        plain = [f"{a} != Bool(0)" if re.fullmatch(r"Bool\(\d+\)", a) else a for a in arguments]  # they take a `bool`
        return f"{path(record)}::{constructor.name}({', '.join(plain)})"

    def literal(self, f: m.Field) -> tuple[str, codec.Values]:
        """A structure with all members, and its values."""
        values: codec.Values = {}
        for p in f.parameters:
            if p.selector:
                # The function that requires the most: an empty union that is not required counts as absent.
                values[p.name] = max((x.value for x in f.functions), key=f.required)
            else:
                self.draw(p, values)
        return self.record(f, values), values

    def draw(self, p: m.Parameter, values: codec.Values) -> None:
        random_values.add(self.chance, p, values, 12)
        if values.get(p.name) is not None:
            values[p.name] = comparable(p, values[p.name])

    # ----------------------------------------------------------------------- given values

    def record(self, record: m.Record, values: codec.Values) -> str:
        members = {x.parameter.name: x for x in self.crate.record(record).members}
        written = []
        for p in record.parameters:
            if p.derived:
                continue
            x = members[p.name]
            if p.name not in values:
                written.append(f"{x.name}: None")
                continue
            expression = self.value(p, record, values[p.name], values)
            written.append(f"{x.name}: Some({expression})" if x.may_be_absent else f"{x.name}: {expression}")
        return f"{path(record)} {{ {', '.join(written)} }}"

    def value(self, p: m.Parameter, record: m.Record, value: Any, siblings: codec.Values) -> str:
        if p.struct:
            (constructor,) = self.crate.record(p.struct).constructors
            return self.called(p.struct, value, constructor)
        if p.union:
            tag = siblings[p.union.tag]
            name = f"mip_protocol::{rust.home(record)}::{self.crate.union(p.union, rust.home(record)).name}"
            case = next((c for c in p.cases if c.tag.value == tag), None)
            if case is None:
                return f"{name}::Other({path(p.union.type)}({tag}))"
            q, name = case.parameter, f"{name}::{rust.variant(case.tag.name)}"
            return f"{name}({self.value(q, record, value[q.name], {})})" if q else name
        if p.kind == "bits" and p.named:
            return f"{path(p.named)}({value})"
        if p.kind == "text":
            octets = data_literal(value.encode("latin-1"))
            return f"VarText(List::from({octets}))" if p.open else f"Text(*{octets})"
        if p.kind == "array":
            array = f"[{', '.join(self.value(p.item, record, v, {}) for v in value)}]"
            if p.vector:
                return f"{path(p.vector)}::from({array})"
            return f"List::from({array})" if p.open else array
        return number(p, value)

    def device(self, d: m.Device) -> Iterator[str]:
        of = f"devices::{rust.constant(d.name)}"
        for s in (*d.supports, *d.refuses):
            functions = [x.value for x in s.functions]
            yield f"let field = {of}.field(DescriptorSet({s.set}), {s.field.descriptor}).unwrap();"
            answer, why = f"devices::Support::{s.evidence.answer.capitalize()}", describe.why(s.evidence, self.model)
            yield f"assert_eq!((field.evidence.answer, field.evidence.why), ({answer}, {text(why)}));"
            yield f"assert_eq!({of}.support(DescriptorSet({s.set}), {s.field.descriptor}), {answer});"
            yield f'assert_eq!((field.set.0, field.name), ({s.set}, "{s.name}"));'
            yield f"assert_eq!(field.functions.iter().map(|f| f.0).collect::<Vec<u8>>(), {functions});"
            yield f"assert_eq!({of}.firmware_of(DescriptorSet({s.set}), {s.field.descriptor}), {maybe(s.firmware)});"
        yield f"assert_eq!(({of}.fields.len(), {of}.refuses.len()), ({len(d.supports)}, {len(d.refuses)}));"
        number = "None" if d.model_number is None else f"Some({d.model_number})"
        yield f"assert_eq!(({of}.id, {of}.title, {of}.model_number), ({text(d.id)}, {text(d.title)}, {number}));"
        yield f"assert_eq!({of}.description, {text(d.description)});"
        generation = "None" if d.generation is None else f"Some({d.generation})"
        manual = f"Some({text(d.manual)})" if d.manual else "None"
        yield f"assert_eq!(({of}.generation, {of}.manual), ({generation}, {manual}));"
        for name, texts in (("also", d.also), ("incomplete", d.incomplete)):
            yield f"assert_eq!({of}.{name}, [{', '.join(map(text, texts))}] as [&str; {len(texts)}]);"
        for name in (d.id, d.title, *d.also):
            yield f"assert_eq!(devices::Profile::find({text(name)}), Some(&{of}));"
        if d.model_number is not None:
            yield f"assert_eq!(devices::Profile::by_model({d.model_number}), Some(&{of}));"
        rates = {r.set.number: f"Some({float(r.hertz)!r})" for r in d.base_rates}
        for s in self.model.sets:
            yield f"assert_eq!({of}.base_rate(DescriptorSet({s.number})), {rates.get(s.number)});"
        for i, port in enumerate(d.ports):
            identity = "None" if port.id is None else f"Some({port.id})"
            yield f"let port = &{of}.ports[{i}];"
            yield f"assert_eq!((port.name, port.id), ({text(port.name)}, {identity}));"
            yield f"assert_eq!(port.baud_rates, [{', '.join(map(str, port.baud_rates))}]);"
            for way, names in (("receives", port.receives), ("sends", port.sends)):
                yield f"assert_eq!(port.{way}, [{', '.join(map(text, names))}] as [&str; {len(names)}]);"
        for i, x in enumerate(d.limits):
            yield f"let limit = &{of}.limits[{i}];"
            yield f"assert_eq!((limit.unit, limit.description), ({maybe(x.unit)}, {text(x.description)}));"
            yield f"assert_eq!(limit.firmware, {maybe(x.firmware)});"
            yield f'assert_eq!({of}.limit("{x.name}"), Some({float(x.value)!r}));'
        for i, v in enumerate(d.variants):
            read_as = f"Some({text(v.variant.type.name)})" if v.variant.type else "None"
            yield f"let variant = &{of}.variants[{i}];"
            yield f"assert_eq!((variant.parameter, variant.read_as), ({text(v.path)}, {read_as}));"
            for fact in (*v.variant.units, v.variant.frame, v.variant.description):
                yield f"assert!(variant.difference.contains({text((fact or '').rstrip('.'))}));"
        counts = [len(d.base_rates), len(d.ports), len(d.limits), len(d.variants)]
        tables = ", ".join(f"{of}.{name}.len()" for name in ("base_rates", "ports", "limits", "variants"))
        yield f"assert_eq!([{tables}], {counts});"
        codes = list(d.ack_codes)
        yield f"assert_eq!({of}.ack_codes.iter().map(|c| c.0).collect::<Vec<u8>>(), {codes});"


def number(p: m.Parameter, value: Any) -> str:
    if p.scalar.kind == "float":
        return f"f{8 * p.size}::from_bits({value})"
    if p.scalar.kind == "bool":
        return f"Bool({int(value)})"
    if isinstance(p.named, m.Enum):
        known = next((v for v in p.named.values if v.value == value), None)
        return f"{path(p.named)}::{rust.constant(known.name)}" if known else f"{path(p.named)}({value})"
    if p.shown == "set" and not p.readings:
        return f"DescriptorSet({value})"
    return f"{path(p.named)}({value})" if isinstance(p.named, m.Bitfield) else str(value)


def comparable(p: m.Parameter, value: Any) -> Any:
    """The same value without what Rust does not find equal to itself, or what its constructors do not take: NaN, bools
    above 1, and reserved members of structures."""
    if p.struct:
        known = {q.name: q for q in p.struct.parameters}
        reserved = {q.name: sent(q) for q in p.struct.parameters if q.reserved is not None}
        return {name: v if v is None else comparable(known[name], v) for name, v in value.items()} | reserved
    if p.union:
        known = {q.name: q for q in p.alternatives}
        return {name: comparable(known[name], v) for name, v in value.items()}
    if p.kind == "array":
        return [comparable(p.item, v) for v in value]
    if p.kind != "scalar":
        return value
    if p.scalar.kind == "float":
        return f"0x{int(value, 16) & ~(1 << 8 * p.size - 2):0{2 * p.size}x}"
    return value & 1 if p.scalar.kind == "bool" else value


def defaults(f: m.Field | m.Struct) -> codec.Values:
    """The values of a default: zeros, spaces, empty arrays, and the values to send for reserved parameters."""
    values: codec.Values = {}
    for p in f.parameters:
        if p.constant is None and not p.optional:
            values[p.name] = sent(p) if p.reserved is not None else default(p)
    return values


def default(p: m.Parameter) -> Any:
    if p.struct:
        return defaults(p.struct)
    if p.union:
        return {q.name: default(q) for c in p.cases if (q := c.parameter) and c.tag.value == 0}
    if p.kind == "bits":
        return [0] * p.size
    if p.kind == "text":
        return " " * (p.count or 0)
    if p.kind == "array":
        return [default(p.item) for _ in range(p.count or 0)]
    return "0x" + "00" * p.size if p.scalar.kind == "float" else 0

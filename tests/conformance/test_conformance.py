"""Every driver against the reference, and so against each other, in the operations that its target declares."""

from __future__ import annotations

import json
import random
from collections.abc import Iterable, Iterator
from functools import cache
from typing import Any

import pytest
from mipgen import model as m
from mipgen.lower import codec
from random_values import chance as chance_of
from random_values import drawn
from support import (
    NIGHTLY,
    all_fields,
    decode_request,
    differences,
    driver,
    each,
    each_of_the_small_one,
    encode_request,
    expected,
    model,
    offering,
    rounds,
    set_of,
)


def compare(language: str, spec: str, requests: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Asks the driver and compares its answers with the reference."""
    answers = driver(language, spec).ask(requests)
    wrong = differences(requests, wanted(spec, json.dumps(requests)), answers)
    assert not wrong, wrong
    return answers


@cache
def wanted(spec: str, requests: str) -> list[dict[str, Any]]:
    """The same for every language."""
    return [expected(model(spec), r) for r in json.loads(requests)]


# --------------------------------------------------------------------------- printed packets


@each("decode")
def test_examples_decode_to_their_values(language: str, spec: str) -> None:
    examples = model(spec).examples
    answers = compare(language, spec, [decode_request(e.packet) for e in examples])
    for example, answer in zip(examples, answers, strict=True):
        for field, got in zip(example.fields, answer["fields"], strict=True):
            assert got.get("values") == field.values, example.id
            assert got.get("name") == field.field, example.id
            for name, value in (field.stated or {}).items():
                assert got["values"][name] == value, (example.id, name)


@each("encode")
def test_examples_encode_to_their_bytes(language: str, spec: str) -> None:
    examples = [e for e in model(spec).examples if not any(f.trailing for f in e.fields)]
    requests = []
    for e in examples:
        fields = [
            {"descriptor": f.descriptor, "raw": f.data.hex()}
            if f.field is None
            else {"descriptor": f.descriptor, "name": f.field, "values": f.values}
            for f in e.fields
        ]
        requests.append({"op": "encode", "set": e.set, "fields": fields})
    for example, answer in zip(examples, compare(language, spec, requests), strict=True):
        assert answer == {"packet": example.packet.hex()}, example.id


@each_of_the_small_one("decode")
def test_every_prefix_of_every_packet_is_refused(language: str, spec: str) -> None:
    packets = {e.packet for e in model(spec).examples}
    prefixes = sorted({p[:n] for p in packets for n in range(len(p))})
    for answer in compare(language, spec, [decode_request(p) for p in prefixes]):
        assert answer["error"] in ("sync", "length")


@each_of_the_small_one("decode")
def test_every_changed_byte_is_refused(language: str, spec: str) -> None:
    packets = sorted({e.packet for e in model(spec).examples})
    changed = [p[:i] + bytes([p[i] ^ 0x10]) + p[i + 1 :] for p in packets for i in range(len(p))]
    for answer in compare(language, spec, [decode_request(p) for p in changed]):
        assert answer.get("error") in ("sync", "length", "checksum")


# --------------------------------------------------------------------------- random values


@each("encode")
def test_random_values_of_every_field_encode(language: str, spec: str) -> None:
    """The values that a packet decodes to encode to the same packet: they lack what the shortest form leaves out."""
    of, requests, packets = model(spec), random_requests(spec), random_packets(spec)
    compare(language, spec, requests)
    again = []
    for (f, _), packet in zip(random_values(spec), packets, strict=True):
        (got,) = expected(of, {"op": "decode", "packet": packet})["fields"]
        again.append(encode_request(set_of(f, of), f, got["values"]))
    assert [a["packet"] for a in compare(language, spec, again)] == packets


@each("decode")
def test_random_values_of_every_field_decode(language: str, spec: str) -> None:
    of = model(spec)
    decoded = compare(language, spec, [{"op": "decode", "packet": p} for p in random_packets(spec)])
    for (f, _), answer in zip(random_values(spec), decoded, strict=True):
        (got,) = answer["fields"]
        assert got["name"] == f.name_in(set_of(f, of)) and got["trailing"] == 0


@each_of_the_small_one("decode")
def test_every_field_decodes_in_each_of_its_sets(language: str, spec: str) -> None:
    """Its name begins with that of the set, the values are the same; in a set without it, it is unknown."""
    of = model(spec)
    places = [(f, number, codec.encode(f, values)) for f, values in one_of_each(spec) for number in numbers(f, of)]
    requests = [decode_request(codec.build(of, number, [(f.descriptor, data)])) for f, number, data in places]
    for (f, number, _), answer in zip(places, compare(language, spec, requests), strict=True):
        name = answer["fields"][0].get("name")
        assert name == f.name_in(number) if number in f.sets else name is None or of.field(name) != f
    assert len({f.name_in(number) for f, number, _ in places}) > len(all_fields(of))


@each_of_the_small_one("encode")
def test_every_field_encodes_in_each_of_its_sets(language: str, spec: str) -> None:
    """In a set in which it does not occur, and with a name that it has in another one, it is unknown."""
    of, requests, wanted = model(spec), [], []
    for f, values in one_of_each(spec):
        for number in numbers(f, of):
            for name in dict.fromkeys(f.name_in(n) for n in numbers(f, of)):
                (entry,) = encode_request(number, f, values)["fields"]
                requests.append({"op": "encode", "set": number, "fields": [{**entry, "name": name}]})
                wanted.append(number in f.sets and name == f.name_in(number))
    answers = compare(language, spec, requests)
    assert ["packet" in a for a in answers] == wanted


def numbers(f: m.Field, of: m.Model) -> list[int]:
    """Sets in which a field occurs, all of them if it does not occur everywhere; and the others of its family."""
    family = of.family(f.family)
    known = [s.number for s in family.sets] if family and not f.everywhere else [f.sets[0], f.sets[-1]]
    return [*known, next(n for n in (0x01, 0x80) if n not in f.sets)]


@cache
def one_of_each(spec: str) -> list[tuple[m.Field, dict[str, Any]]]:
    """Values for every field."""
    return list({f.full_name: (f, values) for f, values in random_values(spec)}.values())


@cache
def random_requests(spec: str) -> list[dict[str, Any]]:
    of = model(spec)
    assert {f.full_name for f, _ in random_values(spec)} == {f.full_name for f in all_fields(of)}
    return [encode_request(set_of(f, of), f, values) for f, values in random_values(spec)]


@cache
def random_packets(spec: str) -> list[str]:
    return [expected(model(spec), r)["packet"] for r in random_requests(spec)]


@cache
def random_values(spec: str) -> list[tuple[m.Field, dict[str, Any]]]:
    """Values for every field, drawn first and sent in one batch: a process for each would take minutes."""
    examples = 1 if spec == "real" and not NIGHTLY else 8
    return [(f, values) for f in all_fields(model(spec)) for values in drawn(f, examples)]


@each_of_the_small_one("decode")
def test_every_prefix_of_every_field(language: str, spec: str) -> None:
    """A field that is too short is an error, unless what is there is a shorter form."""
    of, chance = model(spec), chance_of(1)
    requests = []
    for f in all_fields(of):
        for data in samples(f, chance):
            for n in range(len(data) + 1):
                requests.append(decode_request(codec.build(of, set_of(f, of), [(f.descriptor, data[:n])])))
    compare(language, spec, requests)


@each_of_the_small_one("decode")
def test_every_length_of_several_layouts(language: str, spec: str) -> None:
    """Constants tell layouts of one descriptor apart, as far as the data reach, then the size."""
    of, requests, wanted = model(spec), [], []
    for f in of.fields:
        if len(of.layouts(f)) == 1:
            continue
        head = bytearray(f.min_size)
        for at, constant in f.signature:
            head[at : at + len(constant)] = constant
        wrong = [head[:at] + bytes([head[at] ^ 0x40]) + head[at + 1 :] for at, _ in f.signature]
        for start in (head, *wrong):
            for n in range(m.MAX_FIELD_DATA + 1):
                data = bytes(start[:n].ljust(n, b"\1"))
                requests.append(decode_request(codec.build(of, f.set, [(f.descriptor, data)])))
                wanted.append(f.name_in(f.set) if start is head and n in of.sizes(f) and n >= f.min_size else None)
    answers = compare(language, spec, requests)
    assert {a["fields"][0].get("name") for a in answers} > {None} or not requests
    for name, answer in zip(wanted, answers, strict=True):
        assert name is None or answer["fields"][0]["name"] == name


@each_of_the_small_one("decode")
def test_random_bytes_in_every_field(language: str, spec: str) -> None:
    compare(language, spec, random_bytes(spec))


@each_of_the_small_one("encode")
def test_what_random_bytes_decode_to_encodes_to_them(language: str, spec: str) -> None:
    answers = [expected(model(spec), r) for r in random_bytes(spec)]
    back = [
        {"op": "encode", "set": a["set"], "fields": [got]} for a in answers for got in a["fields"] if "values" in got
    ]
    encoded = compare(language, spec, back)
    for request, answer in zip(back, encoded, strict=True):
        if request["fields"][0]["trailing"] == 0:
            assert {"op": "decode", "packet": answer["packet"]} in random_bytes(spec)


@cache
def random_bytes(spec: str) -> list[dict[str, Any]]:
    of, chance = model(spec), chance_of(2)
    requests = []
    for f in all_fields(of):
        for _ in range(rounds(12, 300)):
            data = mutated(chance, samples(f, chance)[0], f)
            requests.append(decode_request(codec.build(of, set_of(f, of), [(f.descriptor, data)])))
    return requests


@each_of_the_small_one("decode")
def test_counts_at_and_beyond_what_a_field_holds(language: str, spec: str) -> None:
    """The fullest field decodes; one element more is a wrong count, though its bytes are there."""
    of, requests, wanted = model(spec), [], []
    for f in all_fields(of):
        for p in f.always:
            if p.counter and f.parameters[0].name == p.counter:
                for count in (p.capacity - 1, p.capacity, p.capacity + 1):
                    size = f.max_size if count <= p.capacity else 253
                    data = bytes([count]) + bytes(size - 1)
                    requests.append(decode_request(codec.build(of, set_of(f, of), [(f.descriptor, data)])))
                    wanted.append("count" if count > p.capacity else None)
    answers = compare(language, spec, requests)
    assert [a["fields"][0].get("error") for a in answers] == wanted
    assert wanted or spec == "real"


def samples(f: Any, chance: random.Random) -> list[bytes]:
    """Whole data of a field: the bytes of some random values, one for each function."""
    found = []
    for function in [x.value for x in f.functions] or [None]:
        size = f.max_size
        data = bytearray(chance.randrange(4) for _ in range(size))
        if function is not None:
            data[0] = function
        for at, constant in f.signature:
            data[at : at + len(constant)] = constant
        try:
            values, _ = codec.decode(f, bytes(data))
            found.append(codec.encode(f, values))
        except codec.CodecError:
            found.append(bytes(data))
    return found


def mutated(chance: random.Random, data: bytes, f: Any) -> bytes:
    out = bytearray(data)
    for _ in range(chance.randrange(4)):
        if out:
            byte = chance.choice([0, 1, 2, 3, 4, 5, 6, 0x7F, 0x80, 0xFF, chance.randrange(256)])
            out[chance.randrange(len(out))] = byte
    tail = chance.randrange(-3, 4)
    out = out[:tail] if tail < 0 else out + bytes(chance.randrange(256) for _ in range(tail))
    return bytes(out[:253])


# --------------------------------------------------------------------------- wrong values


def decoded(of: m.Model, chance: random.Random) -> Iterator[tuple[m.Field, dict[str, Any]]]:
    """Values of each field of whose samples the first can be decoded."""
    for f in all_fields(of):
        try:
            yield f, codec.decode(f, samples(f, chance)[0])[0]
        except codec.CodecError:
            continue


@each_of_the_small_one("encode")
def test_wrong_values_are_refused(language: str, spec: str) -> None:
    """One fault at a time; the reference says which it is."""
    of, chance = model(spec), chance_of(3)
    requests = []
    for f, values in decoded(of, chance):
        requests += [encode_request(set_of(f, of), f, wrong) for wrong in faults(f, values)]
    answers = compare(language, spec, requests)
    kinds = {a["error"] for a in answers if "error" in a}
    assert kinds >= {"missing", "range", "count", "unknown"}


@each_of_the_small_one("encode")
def test_a_shorter_text_of_fixed_length_ends_with_spaces(language: str, spec: str) -> None:
    """Whether it is empty or only one character short; a longer one is rejected. Decoding returns the spaces."""
    of, chance, requests, wanted = model(spec), chance_of(5), [], list[str | None]()
    for f, values in decoded(of, chance):
        for size, error in ((0, None), (3, None), (-1, None), (1000, "count")):
            changed = _with_texts(f.parameters, values, size)
            if changed != values:
                requests.append(encode_request(set_of(f, of), f, changed))
                wanted.append(error)
    answers = compare(language, spec, requests)
    assert [a.get("error") for a in answers] == wanted
    assert len(wanted) >= 4
    padded = [bytes.fromhex(a["packet"]) for a in answers if "packet" in a]
    assert all(b"ABC " in p or b"    " in p or b"A" * 7 + b" " in p for p in padded)


def _with_texts(parameters: Iterable[m.Parameter], values: dict[str, Any], size: int) -> dict[str, Any]:
    """The same values, in which all texts of fixed length have this one, or are shorter by one if it is negative."""
    changed = dict(values)
    for p in parameters:
        if p.name not in values:
            continue
        if p.kind == "text" and p.count is not None:
            changed[p.name] = "A" * (p.count - 1) if size < 0 else "ABC"[:size] if size <= 3 else "A" * (p.count + 1)
        elif p.struct:
            changed[p.name] = _with_texts(p.struct.parameters, values[p.name], size)
        elif p.union:
            changed[p.name] = _with_texts(p.alternatives, values[p.name], size)
    return changed


def _structure(f: m.Field, name: str) -> bool:
    return any(p.name == name and isinstance(p.element, m.Struct) and p.length is None for p in f.parameters)


def faults(f: Any, values: dict[str, Any]) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = [{**values, "no_such_parameter": 1}]
    found += [{**values, name: {**v, "no_such_parameter": 1}} for name, v in values.items() if _structure(f, name)]
    counters = {p.name for p in f.parameters if p.counts}
    tags = {p.tag for p in f.parameters if p.tag}
    for name, value in values.items():
        if name in tags or name in counters:
            continue
        array = next((p for p in f.parameters if p.name == name and isinstance(p.length, str)), None)
        if array is None and name != "function":
            found.append({k: v for k, v in values.items() if k != name})
        if isinstance(value, int) and name != "function":
            found.append({**values, name: 1 << 64})
            found.append({**values, name: -(1 << 63) - 1})
        if isinstance(value, list) and array is None:
            found.append({**values, name: [*value, value[0]] if value else value})
            found.append({**values, name: value[:-1]})
        if isinstance(value, str) and not value.startswith("0x") and array is None:
            found.append({**values, name: value + "x"})
    for name in counters:
        if name in values:
            found.append({**values, name: (values[name] + 1) % 256})
    for p in f.parameters:
        if p.tag and p.name in values:
            for other in p.cases:
                if other.tag.value != values[p.tag] and other.parameter is not None:
                    found.append({**values, p.tag: other.tag.value})
                    break
    return found


@pytest.mark.parametrize("language", offering("encode"))
def test_what_does_not_fit_is_refused(language: str) -> None:
    ping = {"descriptor": 1, "raw": ""}
    requests: list[dict[str, Any]] = [
        {"op": "encode", "set": 1, "fields": [ping] * 127},
        {"op": "encode", "set": 1, "fields": [ping] * 128},
        {"op": "encode", "set": 1, "fields": []},
        {"op": "encode", "set": 1, "fields": [{"descriptor": 9, "raw": "00" * 253}]},
        {"op": "encode", "set": 1, "fields": [{"descriptor": 9, "raw": "00" * 254}]},
        {"op": "encode", "set": 1, "fields": [{"descriptor": 1, "name": "no.such", "values": {}}]},
    ]
    answers = compare(language, "invented", requests)
    assert [a.get("error") for a in answers] == [None, "length", None, None, "length", "unknown"]


@each_of_the_small_one("encode")
def test_only_a_set_that_has_a_field_is_built_with_it(language: str, spec: str) -> None:
    """No packet is built of sets 0 and 0xFF; fields of several sets, shared ones, acknowledges only in their own."""
    of, requests, errors = model(spec), [], []
    several = next(f for f in of.fields if f.everywhere and f.set == 0xFF), of.protocol.acknowledge
    several += (next(f for f in of.fields if f.role == m.DATA and len(f.sets) > 1 and not f.everywhere),)
    for f in several:
        values = next(values for one, values in one_of_each(spec) if one == f)
        for number in (0, *f.sets[:2], 1, 2, *(s.number for s in of.sets), 0xFF):
            requests.append(encode_request(number, f, values))
            errors.append("set" if number in m.NO_SETS else None if number in f.sets else "unknown")
    for number in m.NO_SETS:
        requests += [{"op": "encode", "set": number, "fields": [{"descriptor": 1, "raw": ""}] * n} for n in (0, 1)]
        errors += ["set"] * 2
    assert [a.get("error") for a in compare(language, spec, requests)] == errors


@pytest.mark.parametrize("language", offering())
def test_no_request_kills_a_driver(language: str) -> None:
    requests: list[Any] = [
        1, None, [], {}, {"op": 1}, {"op": "none"}, {"op": "decode"}, {"op": "decode", "packet": "xx"},
        {"op": "decode", "packet": 5}, {"op": "decode", "packet": "756"}, {"op": "parse", "stream": "00"},
        {"op": "encode", "set": 1}, {"op": "encode", "set": 1, "fields": 3}, {"op": "encode", "fields": []},
        {"op": "encode", "set": -1, "fields": []}, {"op": "encode", "set": 256, "fields": []},
        {"op": "encode", "set": 1, "fields": [{"descriptor": 256, "raw": ""}]},
        {"op": "encode", "set": 1, "fields": [{"descriptor": -1, "raw": ""}]},
        {"op": "parse", "stream": "7565", "chunk": 0}, {"op": "parse", "stream": "7565", "chunk": -1},
    ]  # fmt: skip
    assert driver(language, "invented").ask(requests) == [{"error": "request"}] * len(requests)


# --------------------------------------------------------------------------- streams

#: Descriptor sets 0 and 0xFF are not packets, however right their checksum is.
NO_PACKETS = [head + codec.checksum(head) for head in (b"ue\x00\x00", b"ue\xff\x00")]
NMEA = b"$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n"


def streams(spec: str) -> list[bytes]:
    """Packets, with everything that can occur between them."""
    chance = chance_of(4)
    packets = sorted({e.packet for e in model(spec).examples})
    packets.append(codec.build(model(spec), 1, []))
    found = []
    for _ in range(rounds(60, 3000)):
        parts = []
        for _ in range(chance.randrange(1, 12)):
            packet = chance.choice(packets)
            noise = bytes(chance.choice([0x75, 0x65, 0, 1, chance.randrange(256)]) for _ in range(chance.randrange(40)))
            cut, damaged = packet[: chance.randrange(len(packet))], packet[:-1] + bytes([packet[-1] ^ 1])
            starts = (b"ue", b"u", b"ueue", b"ue\x00\x00", *NO_PACKETS, b"ue\x80\xff" + packet)
            parts.append(chance.choice([packet, packet, NMEA, *starts, cut, damaged, noise]))
        found.append(b"".join(parts))
    return found


@each_of_the_small_one("parse")
def test_streams_in_many_chunkings(language: str, spec: str) -> None:
    requests = []
    for stream in streams(spec):
        for chunk in (1, 2, 3, 7, 64, 1000):
            requests.append({"op": "parse", "stream": stream.hex(), "chunk": chunk})
    compare(language, spec, requests)

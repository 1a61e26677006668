"""The core of the Python package: fast code returns the same as plain code; objects behave as data classes do."""

from __future__ import annotations

import array
import ast
import copy
import json
import mmap
import random
import struct
import subprocess
import sys
from collections.abc import Iterator
from functools import partial
from itertools import accumulate
from pathlib import Path
from typing import Any

import pytest
from mipgen import model as m
from support import ROOT, SPECS, heavy, model, nightly, small
from test_python import REAL, Package, mip, real, user

PACKAGES = {"invented": mip, "real": real}


# --------------------------------------------------------------------------- checksums


def plain_checksum(data: bytes) -> bytes:
    return bytes((sum(data) & 255, sum(accumulate(data)) & 255))


def test_checksums_of_all_sizes() -> None:
    chance, checks = random.Random(1), mip.checks
    for size in range(256):
        header = b"ue" + bytes((chance.randrange(1, 256), size))
        heads = checks.Heads()
        heads.add_header(header)
        for payload in (chance.randbytes(size), bytes(size), b"\xff" * size):
            right = plain_checksum(header + payload)
            assert checks.checksum(header + payload) == right
            for wrong in (b"\0\0", bytes((1, 0)), bytes((0, 1)), bytes((0, 128)), bytes((255, 0))):
                packet = header + payload + bytes(a ^ b for a, b in zip(right, wrong))
                known = checks.has_checksum(b"u" + packet, 1, heads[header])
                assert checks.is_correct(packet) == known == (wrong == b"\0\0")


# --------------------------------------------------------------------------- parser


def packet(set_number: int, payload: bytes) -> bytes:
    head = b"ue" + bytes((set_number, len(payload))) + payload
    return head + plain_checksum(head)


def cut(stream: bytes, chance: random.Random) -> Iterator[bytes]:
    most = chance.choice((1, 7, 300, 5000, 1 << 30)) if len(stream) < 3000 else chance.choice((300, 5000, 1 << 30))
    at = 0
    while at < len(stream):
        size = chance.randint(1, most)
        yield stream[at : at + size]
        at += size


def test_bad_checksums_are_counted() -> None:
    parser, ping = mip.parser.Parser(), bytes(mip.tools.Ping().packet())
    parser.feed(ping[:-1] + b"\0" + ping + b"$GP\r\n")
    assert (parser.bad_checksums, parser.skipped) == (1, len(ping) + 5)
    many = mip.parser.Parser()
    many.feed(b"ue\x01\xff" * 1000)
    assert many.bad_checksums == (4000 - 261) // 4 + 1 and many.pending < 261


def test_feed_takes_any_buffer(tmp_path: Path) -> None:
    stream = b"noise" + bytes(mip.tools.Ping().packet()) * 30_000
    (tmp_path / "log").write_bytes(stream)
    with open(tmp_path / "log", "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as mapped:
        for buffer in (stream, bytearray(stream), memoryview(stream), mapped, array.array("B", stream)):
            parser = mip.parser.Parser()
            assert len(parser.feed(buffer)) == 30_000 and parser.skipped == 5
    short = bytes(mip.tools.Ping().packet())
    parser = mip.parser.Parser()
    assert parser.feed(memoryview(bytes(b for pair in zip(short, short) for b in pair))[::2]) == [
        mip.packet.Packet(short)
    ]
    assert parser.feed(array.array("H")) == [] and parser.feed(bytearray()) == []
    for wrong in (5, "ue", None, [117]):
        with pytest.raises(TypeError):
            parser.feed(wrong)
    buffer = bytearray(short)
    (packet,) = parser.feed(buffer)
    buffer[2] = 9
    assert bytes(packet) == short


# --------------------------------------------------------------------------- decoders


def told(fields: Any) -> list[Any]:
    """Everything about decoded fields, to the bit."""
    found = []
    for f in fields:
        raw = isinstance(f, tuple)
        bits = f.data if raw else f.encode()
        found.append((type(f), repr(f), bits, str(f.error) if raw else f.packet_set))
        if not raw:
            values = [getattr(f, name) for name in f._MEMBERS]
            found.append([(type(v), [type(x) for x in v] if isinstance(v, tuple) else None) for v in values])
    return found


def some_packets(package: Package, of: m.Model, chance: random.Random) -> Iterator[list[bytes]]:
    """Packets of one layout and of others that are similar."""
    types = [(s.number, t) for s in of.sets for t in all_types(package, s.number)]
    for turn in range(2 * len(types)):
        set_number, kind = types[turn % len(types)]
        if set_number == 0xFF:
            set_number = 0x80
        same = [t for number, t in types if number in (set_number, 0xFF if set_number >= 0x80 else set_number)]
        parts = [kind] if turn < len(types) else [kind, *chance.sample(same, min(len(same), chance.randrange(1, 4)))]
        heads = [(t.DESCRIPTOR if chance.random() < 0.97 else 0x7E, chance.choice(sizes(t))) for t in parts]
        out = []
        for _ in range(14):
            payload = b""
            for descriptor, size in heads:
                data = chance.randbytes(size) if chance.random() < 0.8 else special(size, chance)
                payload += bytes((size + 2, descriptor)) + data
            if chance.random() < 0.1 and payload:
                at = chance.randrange(len(payload))
                payload = payload[:at] + chance.randbytes(1) + payload[at + 1 :]
            if len(payload) < 256:
                out.append(packet(set_number, payload))
        yield out


def all_types(package: Package, set_number: int) -> list[Any]:
    return [t for number, t in package.registry.all_types() if number == set_number]


def sizes(kind: Any) -> list[int]:
    """Sizes of data that may fit, and some that do not."""
    if not kind._SIZE:
        return [0, 1, 2, 5, 9, 20, 40]
    size = kind._SIZE
    return [size] * 6 + [size + 3, max(size - 1, 0)]


def special(size: int, chance: random.Random) -> bytes:
    words = [
        struct.pack(">I", w) for w in (0, 1, 0x7F800001, 0x7FC00000, 0x7F800000, 0xFF800000, 0xFFFFFFFF, 0x3F800000)
    ]
    return b"".join(chance.choice(words) for _ in range(size // 4 + 1))[:size]


@small("fast decoders of the real specification")
def test_fast_decoders_give_what_the_general_way_gives(spec: str) -> None:
    package, chance = PACKAGES[spec], random.Random(5)
    fast = 0
    for packets in some_packets(package, model(spec), chance):
        for data in packets:
            p = package.packet.Packet(data)
            raws = [package.registry.decode_field(raw) for raw in p.fields]
            assert told(package.registry.decode_packet(p)) == told(raws)
            for raw, f in zip(p.fields, raws):
                fast += len(raw.data) == getattr(f, "_SIZE", None)
                try:
                    assert told([package.registry.decode(raw) or raw]) == told([f])
                except package.errors.DecodeError as error:
                    assert str(error) == str(f.error)
    assert fast > 200


@small("fast decoders of the real specification")
def test_decoder_gives_what_parser_and_registry_give(spec: str) -> None:
    package, chance = PACKAGES[spec], random.Random(6)
    for packets in some_packets(package, model(spec), chance):
        stream = bytearray(b"\r\n" + b"".join(chance.sample(packets, len(packets))))
        for _ in range(chance.randrange(3)):
            stream[chance.randrange(len(stream))] ^= 1 << chance.randrange(8)
        parser, decoder = package.parser.Parser(), package.decoder.Decoder()
        one = package.registry.decode_field
        wanted = [told([one(raw) for raw in p.fields]) for p in [*parser.feed(stream), *parser.flush()]]
        found = [f for piece in cut(bytes(stream), chance) for f in decoder.feed(piece)] + decoder.flush()
        assert [told(f) for f in found] == wanted
        assert (decoder.skipped, decoder.bad_checksums) == (parser.skipped, parser.bad_checksums)


def test_a_raw_field_says_why() -> None:
    known = mip.measurements.Accel.DESCRIPTOR
    data = packet(0x80, bytes((3, known, 1, 3, 0x7E, 2)))
    short, unknown = mip.registry.decode_packet(mip.packet.Packet(data))
    assert isinstance(short, mip.packet.Undecoded) and short.error.kind == "truncated"
    assert short == mip.packet.RawField(0x80, known, b"\x01") and "error=truncated" in repr(short)
    assert type(unknown) is mip.packet.RawField and unknown.error is None
    broken = mip.packet.Packet(packet(1, bytes.fromhex("0201 05")))
    assert [f.descriptor for f in broken.fields] == [1] and broken.malformed.kind == "field_length"
    assert mip.packet.Packet(data).malformed is None
    with_error = copy.copy(short)
    assert with_error == short and with_error.error is short.error


def test_any_buffer_is_data() -> None:
    ping = bytes(real.base.Ping().packet())
    twice = bytes(b for pair in zip(ping, ping) for b in pair)
    for buffer in (ping, bytearray(ping), memoryview(ping), memoryview(twice)[::2], array.array("B", ping)):
        assert bytes(real.packet.Packet(buffer)) == ping
    for kind, size in ((real.base.GetDeviceInfoResponse, 82), (real.sensor.ScaledAccel, 12)):
        for buffer in (bytearray(size), memoryview(bytes(size)), memoryview(bytes(2 * size))[::2]):
            assert kind.decode(buffer) == kind.decode(bytes(size))
            assert kind.decode_with_trailing(buffer)[1] == 0
    built = real.packet.PacketBuilder(0x80).add(4, memoryview(bytes(12))).build()
    assert built == real.sensor.ScaledAccel((0, 0, 0)).packet()
    wrongs = (
        ([1, 2], r"not list; write bytes\(\[1, 2\]\)"),
        (5, "not int$"),
        ("75", r"not text; write bytes.fromhex\('75'\)"),
    )
    for wrong, remedy in wrongs:
        for takes in (real.packet.Packet, real.sensor.ScaledAccel.decode, partial(real.packet.PacketBuilder(1).add, 1)):
            with pytest.raises(TypeError, match=f"must be bytes, {remedy}"):
                takes(wrong)


def test_a_packet_is_built_of_whole_numbers() -> None:
    for wrong in (1.0, "base", None, 0, 255, 256, -1):
        with pytest.raises(real.errors.EncodeError, match=r"set: .* is not a descriptor set; use 1 to 254"):
            real.packet.PacketBuilder(wrong)
    for wrong in (1.0, "ping", None, 256, -1):
        with pytest.raises(real.errors.EncodeError, match=r"range: .* is not a descriptor; use 0 to 255"):
            real.packet.PacketBuilder(1).add(wrong)


# --------------------------------------------------------------------------- memory


def test_values_of_bitfields_are_not_kept() -> None:
    kind = real.types.GpioPinMode
    before = len(kind._value2member_map_)
    for value in range(256):
        assert int(kind(value)) == value == int(kind(value) | kind(0)) and kind(value) == kind(value)
        assert kind(value) & kind(value) in kind(0xFF)
    assert len(kind._value2member_map_) <= before + 8  # Python 3.10 keeps single bits
    named = next(iter(kind))
    assert kind(int(named)) is named
    known = real.codec.MemberCache(kind)
    assert all(known[n % 256] == n % 256 for n in range(5000)) and len(known) <= known.SIZE


def test_known_headers_are_bounded() -> None:
    heads = real.checks.Heads()
    for n in range(5000):
        heads.add_header(struct.pack(">HH", 0x7565, n))
        assert n < 1024 or len(heads) <= 1024
    assert struct.pack(">HH", 0x7565, 4999) in heads


def test_the_package_compiles_nothing() -> None:
    """What it runs can be read: no text, least of all one made of received bytes, becomes code."""
    for path in (ROOT / "generated/python").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            called = node.func.id if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) else ""
            assert called not in ("exec", "eval", "compile", "__import__"), f"{path.name}:{node.lineno}"


# --------------------------------------------------------------------------- vectors


def test_vectors_are_named_tuples() -> None:
    types = real.types
    accel = real.sensor.ScaledAccel.decode(struct.pack(">3f", 1, 2, -3))
    vector = accel.scaled_accel
    x, y, z = vector
    assert (vector.x, vector.y, vector.z) == (x, y, z) == vector == types.Vector3f(1, 2, -3)
    assert type(vector) is types.Vector3f and repr(vector) == "Vector3f(x=1.0, y=2.0, z=-3.0)"
    quaternion = types.Quatf(1, 0, 0, 0.5)
    assert (quaternion.w, quaternion.z) == (1, 0.5)


def test_matrices_are_indexed_by_row_and_column() -> None:
    matrix = real.types.Matrix3f(*range(9))
    assert [matrix[r, c] for r in range(3) for c in range(3)] == list(range(9)) == list(matrix)
    assert matrix[-1, -2] == 7 == matrix.m32 == matrix[7] and matrix[1:3] == (1, 2)
    assert matrix.rows == ((0, 1, 2), (3, 4, 5), (6, 7, 8))
    needs = "needs one of 3 rows and one of 3 columns, from 0, not .*; for whole rows, use `rows`"
    for wrong in ((3, 0), (0, 3), (-4, 0)):
        with pytest.raises(IndexError, match=needs):
            matrix[wrong]
    for kind in ((0, slice(None)), (slice(1), 0), (0,), (0, 1, 2), (0, "x")):
        with pytest.raises(TypeError, match=needs):
            matrix[kind]


class Array:
    """The parts of a NumPy array that the package uses."""

    def __init__(self, values: list[Any]) -> None:
        self.values = values

    def __len__(self) -> int:
        return len(self.values)

    def __iter__(self) -> Iterator[Any]:
        return iter(self.values)

    def tolist(self) -> list[Any]:
        return self.values


def test_vectors_are_made_of_any_sequence_of_numbers() -> None:
    accel = real.sensor.ScaledAccel
    for numbers in ([1, 2, 3], (1, 2, 3), range(1, 4), array.array("d", (1, 2, 3)), Array([1.0, 2.0, 3.0])):
        made = accel(numbers)
        assert made.scaled_accel.y == 2 and type(made.scaled_accel) is real.types.Vector3f
        assert made.encode() == struct.pack(">3f", 1, 2, 3)
        made.scaled_accel = numbers
        assert made.scaled_accel.z == 3 and made == accel((1, 2, 3))
    rows = [[1, 2, 3], [4, 5, 6], [7, 8, 9]]
    matrix = real.sensor.CompOrientationMatrix
    for value in (rows, Array(rows), range(1, 10), [Array(row) for row in rows]):
        assert matrix(value).encode() == struct.pack(">9f", *range(1, 10))
    wrongs = (b"abc", "abc", bytearray(3), memoryview(b"abc"), {1, 2, 3}, {1: 2}, (1, 2), 5, [[1, 2, 3]] * 2, [b"abc"])
    for wrong in (*wrongs, (1, 2, 3, 4)):
        with pytest.raises(real.errors.EncodeError, match=r"scaled_accel(\[0\])? (is|has)"):
            accel(wrong)
    with pytest.raises(real.errors.EncodeError, match="missing: scaled_accel is None"):
        accel(None)
    arrays = mip.measurements.Arrays
    zero = mip.types.Point(0, 0)
    made = arrays((0, 0, 0), (0, 0), [[0, 0, 0], Array([1, 2, 3])], (zero, zero), mip.types.Segment(zero, zero, (0, 0)))
    assert made.vectors[1].y == 2 and arrays.decode(made.encode()).vectors[1] == (1, 2, 3)
    assert type(arrays.decode(made.encode()).vectors[0]) is mip.types.Vector3f


def test_arrays_are_made_of_any_sequence() -> None:
    rates = [real.types.DescriptorRate(4, 10), real.types.DescriptorRate(5, 10)]
    command = real.mip_3dm.MessageFormat.write(0x80, rates)
    assert command.descriptors == tuple(rates) and type(command).decode(command.encode()) == command
    config = real.gnss.RtkDongleConfig
    some = [1, 2, 3]
    for numbers in (some, range(1, 4), bytearray(some), b"\1\2\3", array.array("H", some), Array(some)):
        made = config(real.top.FunctionSelector.WRITE, 1, numbers)
        assert made.reserved == (1, 2, 3) and config.decode(made.encode()) == made
    for wrong in ("abc", {1, 2, 3}, {1: 2}, 5, (1, 2)):
        with pytest.raises(real.errors.EncodeError, match="reserved"):
            config(real.top.FunctionSelector.WRITE, 1, wrong).encode()


# --------------------------------------------------------------------------- objects


def test_fields_are_what_data_classes_are() -> None:
    code = """
import copy, dataclasses, pickle
import mip_protocol
from mip_protocol import sensor, base, system
a = sensor.ScaledAccel((1, 2, 3))
assert a == sensor.ScaledAccel(scaled_accel=[1, 2, 3]) != sensor.ScaledGyro((1, 2, 3)) and a != (1, 2, 3)
assert repr(a) == "ScaledAccel(scaled_accel=Vector3f(x=1, y=2, z=3))" == repr(copy.deepcopy(a))
for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
    try: again = pickle.loads(pickle.dumps(a, protocol))
    except TypeError: assert protocol < 2
    else: assert again == a and type(again.scaled_accel) is type(a.scaled_accel)
flags = mip_protocol.types.GpioPinMode(0x83)
assert pickle.loads(pickle.dumps(flags)) == flags == copy.deepcopy(flags)
b = dataclasses.replace(a, scaled_accel=(4, 5, 6))
assert (b.scaled_accel.x, a.scaled_accel.x) == (4, 1)
assert [f.name for f in dataclasses.fields(system.InterfaceControl)] == list(system.InterfaceControl.__match_args__)
assert dataclasses.asdict(system.CommModeResponse(1)) == {"mode": 1} and dataclasses.is_dataclass(a)
match b:
    case sensor.ScaledAccel((x, y, z)): assert (x, y, z) == (4, 5, 6)
try: hash(a)
except TypeError: pass
else: raise AssertionError
for wrong in ("a.other = 1", "sensor.ScaledAccel()", "sensor.ScaledAccel((1, 2, 3), 4)", "sensor.ScaledAccel(x=1)"):
    try: exec(wrong)
    except (AttributeError, TypeError): pass
    else: raise AssertionError(wrong)
@dataclasses.dataclass
class Mine(sensor.ScaledAccel):
    note: str = ""
mine = Mine((1, 2, 3), "x")
assert mine.note == "x" and mine.encode() == a.encode()
print("done")
"""
    assert user(REAL, code) == "done\n"


def test_the_package_is_enough_to_reach_its_modules() -> None:
    code = """
import sys, mip_protocol
late = "dataclasses inspect asyncio socket threading select".split()
late += [f"mip_protocol.{x}" for x in "sensor client device conversation sampling registry reflection".split()]
assert not [k for k in sys.modules if k in late]
assert {"sensor", "registry", "devices", "Client", "Decoder"} <= set(dir(mip_protocol))
assert not {"Any", "annotations", "TYPE_CHECKING", "errors"} & set(dir(mip_protocol))
assert mip_protocol.sensor.ScaledAccel.SET == 0x80 and mip_protocol.Client and mip_protocol.registry.types(0x80, 4)
assert "dataclasses" not in sys.modules or "mip_protocol.client" in sys.modules
try: mip_protocol.nothing
except AttributeError as error: print(error)
"""
    assert user(REAL, code) == "module 'mip_protocol' has no attribute 'nothing'\n"


@heavy("pyright")
@pytest.mark.parametrize("spec", ["invented", pytest.param("real", marks=nightly("pyright on the real package"))])
def test_pyright_finds_nothing(spec: str, tmp_path: Path) -> None:
    """Editors show what it finds; mypy is stricter in other things."""
    folder = SPECS[spec][1] / "python"
    settings = {"include": [str(folder / "mip_protocol")], "typeCheckingMode": "standard", "pythonPlatform": "All"}
    (tmp_path / "pyrightconfig.json").write_text(json.dumps(settings))
    done = subprocess.run(
        [sys.executable, "-m", "basedpyright", "--project", tmp_path, "--pythonpath", sys.executable],
        capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0 and "0 errors" in done.stdout, done.stdout + done.stderr

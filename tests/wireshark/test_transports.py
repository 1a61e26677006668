"""Streams of bytes in TCP segments, datagrams, serial chunks and logs: the packets that are in them, and no others."""

from __future__ import annotations

import random
import re
import subprocess
from pathlib import Path

import pytest
import shark as captures
from conformance.test_conformance import samples
from dissected import PORT, Element, accel, acknowledge, broken, field_bytes, packet, shark, shown, trees
from mipgen.lower import codec
from support import all_fields, expected_parse, heavy, model, need, set_of

pytestmark = heavy("tshark")

NMEA = b"$GNRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*6A\r\n"
FALSE_SYNC = b"ue\x80\x20"  # a header, whose bytes are those of the packets behind it


def stream() -> bytes:
    """Packets of several sets with everything between them that may be there."""
    ping = codec.build(model("real"), 0x01, [(0x01, b"")])
    parts = [
        b"\xff\x00garbage", ping, NMEA, accel(0.5), acknowledge(0x01, 0x01, 0), FALSE_SYNC, accel(float("nan")),
        broken(accel(3.0)), ping, b"u", accel(1.0), b"ue", accel(2.0), b"ue\x00\x00", ping, accel(4.0)[:9], ping,
    ]  # fmt: skip
    return b"".join(parts) + accel(5.0) * 3  # behind a false header: as many bytes as it asks for


def checksums(data: bytes) -> list[str]:
    """The last bytes of the packets that the reference finds."""
    return [p[-4:] for p in expected_parse(data)["packets"]]


def found(frames: list[Element]) -> list[str]:
    """The same for the packets that are shown with a right checksum."""
    sums = [part for frame in frames for part in frame.iter("field") if part.get("name") == "mip.checksum"]
    return [part.get("value", "") for part in sums if shown(part, "mip.checksum.status") == ["1"]]


def skipped(frames: list[Element]) -> int:
    parts = [part for frame in frames for part in frame.iter("field") if part.get("name") == "mip.skipped"]
    return sum(int(part.get("size", 0)) for part in parts)


def check(frames: list[Element], data: bytes) -> None:
    """All packets are shown; each other byte is skipped, or in a packet that is shown with a wrong checksum."""
    assert found(frames) == checksums(data)
    wrong = [proto for frame in frames for proto in frame if shown(proto, "mip.checksum.status") == ["0"]]
    damaged = sum(int(proto.get("size", 0)) for proto in wrong if proto.get("name") == "mip_protocol")
    assert skipped(frames) + damaged == expected_parse(data)["skipped"]


# --------------------------------------------------------------------------- TCP


@pytest.mark.parametrize("size", [1, 5, 23, 101])
def test_tcp_segments_of_any_size(size: int, tmp_path: Path) -> None:
    segments = [(True, part) for part in captures.chunks(stream(), size)]
    check(trees(tmp_path, captures.tcp(segments, PORT), "-o", f"mip_protocol.tcp_ports:{PORT}"), stream())


def test_tcp_cut_once_at_every_place(tmp_path: Path) -> None:
    """One connection for each place, all in one capture."""
    data = accel(0.5) + NMEA + accel(1.5) + FALSE_SYNC + accel(2.5) * 2
    places = range(1, len(data))
    halves = [[(True, data[:at]), (True, data[at:])] for at in places]
    frames = [f for at, parts in zip(places, halves, strict=True) for f in captures.connection(parts, PORT + at)]
    ports = f"mip_protocol.tcp_ports:{PORT}-{PORT + len(data)}"
    streams: dict[str, list[Element]] = {}
    for frame in trees(tmp_path, captures.capture(captures.RAW_IP, frames), "-o", ports):
        streams.setdefault(shown(frame, "tcp.stream")[0], []).append(frame)
    assert len(streams) == len(places)
    for parts in streams.values():
        check(parts, data)


@pytest.mark.parametrize(("before", "size"), [(7, 50), (0, 6), (0, 7), (0, 19)])
def test_tcp_is_recognized_by_a_packet_or_its_begin(before: int, size: int, tmp_path: Path) -> None:
    data = bytes(before) + accel(0.5) * 3
    frames = trees(tmp_path, captures.tcp([(True, part) for part in captures.chunks(data, size)], 45678))
    assert found(frames) == checksums(data)


def test_other_streams_are_left_alone(tmp_path: Path) -> None:
    others = [b"ue\x00\x00\x00\x00\x00\x00", b"GET / HTTP/1.1\r\n\r\n", b"ue\x80\x0e\xff\x04" + bytes(30), bytes(100)]
    others += [b"u", broken(accel(1.0))[:5], whole(bytes((0x50, 4, 4, 1, 0, 0)))]
    frames = [f for i, data in enumerate(others) for f in captures.connection([(True, data)], 45678 + i)]
    frames += [captures.udp(data, 45678 + i) for i, data in enumerate(others)]
    capture = captures.capture(captures.RAW_IP, frames)
    assert not trees(tmp_path, capture, "-Y", "mip_protocol || mip_stream || mip.skipped")


def test_decode_as(tmp_path: Path) -> None:
    data = accel(0.5)[:4]
    capture = captures.datagrams([data], 45678)
    assert not trees(tmp_path, capture, "-Y", "mip.skipped")
    assert trees(tmp_path, capture, "-Y", "mip.skipped", "-d", "udp.port==45678,mip_protocol")
    segments = [(True, b"\xff" * 5), (True, accel(0.5))]
    frames = trees(tmp_path, captures.tcp(segments, 45678), "-d", "tcp.port==45678,mip_protocol")
    assert (found(frames), skipped(frames)) == (checksums(accel(0.5)), 5)


# --------------------------------------------------------------------------- datagrams


def test_datagrams_are_whole(tmp_path: Path) -> None:
    """What is behind a header without a packet is found; nothing is carried over."""
    data = stream() + FALSE_SYNC + accel(1.0) + accel(0.5)[:7]
    first, cut, again = trees(tmp_path, captures.datagrams([data, accel(0.5)[7:], data], 45678))
    for frame in (first, again):
        check([frame], data)
    assert not found([cut])


# --------------------------------------------------------------------------- serial lines


@pytest.mark.parametrize("size", [1, 3, 20, 1000])
def test_serial_chunks_of_any_size(size: int, tmp_path: Path) -> None:
    for passes in ((), ("-2",)):
        check(trees(tmp_path, captures.serial(captures.chunks(stream(), size)), *passes), stream())


def test_a_chunk_says_that_its_packet_goes_on(tmp_path: Path) -> None:
    first, second = trees(tmp_path, captures.serial([accel(0.5) + accel(1.0)[:9], accel(1.0)[9:]]))
    texts = [proto.get("showname") for proto in first if proto.get("name") == "mip_stream"]
    assert texts == ["MIP, 9 bytes of a packet that continues in a later frame"]
    assert found([first, second]) == checksums(accel(0.5) + accel(1.0))


def test_packets_behind_a_false_header_at_the_end_are_shown(tmp_path: Path) -> None:
    data = accel(0.5) + FALSE_SYNC + accel(1.0)  # more bytes than the header claims never arrive
    for size in (1, 7, len(data)):
        frames = trees(tmp_path, captures.serial(captures.chunks(data, size)))
        assert found(frames) == checksums(accel(0.5) + accel(1.0)) and skipped(frames) == len(FALSE_SYNC)


@pytest.mark.parametrize("dlt", [147, 150, 162])
def test_user_dlts(dlt: int, tmp_path: Path) -> None:
    capture = captures.capture(dlt, [accel(0.5)])
    assert len(found(trees(tmp_path, capture))) == (dlt == 147)
    assert len(found(trees(tmp_path, capture, "-o", "mip_protocol.user_dlts:150-151,162"))) == (dlt != 147)


# --------------------------------------------------------------------------- logs


def test_a_log_is_a_capture(tmp_path: Path) -> None:
    """Each packet is a frame, and so are the bytes between two packets."""
    for data in (stream(), NMEA + stream() + FALSE_SYNC, stream() * 40, accel(0.5) + b"x" * 9000 + accel(1.0) + b"u"):
        for passes in ((), ("-2",)):
            frames = trees(tmp_path, data, *passes)
            check(frames, data)
            assert all(len(found([frame])) <= 1 for frame in frames)


def test_a_log_as_frames_of_a_user_dlt(tmp_path: Path) -> None:
    """By the command of the README."""
    readme = (shark("real").plugin.parent / "README.md").read_text("utf-8")
    (command,) = (line for line in readme.splitlines() if line.endswith("log.pcap"))
    assert not any(re.search(r"\bod .*-w", line) for line in readme.splitlines())  # GNU only
    (tmp_path / "log.bin").write_bytes(stream())
    need("xxd"), need("text2pcap")
    subprocess.run(["sh", "-c", command.strip()], cwd=tmp_path, check=True, capture_output=True)
    check(trees(tmp_path, (tmp_path / "log.pcap").read_bytes()), stream())


@pytest.mark.parametrize("first", [b"ue\x55\x02\x02\x01", b"ue\x80\x02\x09\x04", FALSE_SYNC + b"ue\x80\xff"])
def test_bytes_are_recognized_by_any_packet(first: bytes, tmp_path: Path) -> None:
    """Behind a packet of an unknown set, one whose field has a wrong length, and a header without a packet."""
    data = first + (b"" if first.startswith(FALSE_SYNC) else codec.checksum(first)) + accel(0.5) * 2
    for capture in (data, captures.tcp([(True, data)], 45678), captures.datagrams([data], 45678)):
        assert trees(tmp_path, capture, "-Y", "mip_protocol || mip_stream")


def test_a_log_is_recognized_by_its_first_bytes(tmp_path: Path) -> None:
    """As the README says: a packet must end in the first 65536."""
    (said,) = re.findall(r"in its first (\d+) bytes", (shark("real").plugin.parent / "README.md").read_text("utf-8"))
    for noise in (5000, int(said) - len(accel(0.5))):
        assert len(found(trees(tmp_path, b"x" * noise + accel(0.5)))) == 1
    log = tmp_path / "log.bin"
    log.write_bytes(b"x" * (noise + 1) + accel(0.5))
    with pytest.raises(AssertionError, match="capture file"):
        shark("real").run("-r", str(log))


# --------------------------------------------------------------------------- requests and answers


def conversation() -> list[tuple[bool, bytes]]:
    """Who sends (True: the device), and what."""
    speed = field_bytes("base.comm_speed", function="read", port=1)
    answer = field_bytes("base.comm_speed_response", port=1, baud=9600)
    ping = (0x01, 0x01, b"")
    return [
        (False, packet(ping, speed)),                                                # 1: answered in 3 and 4
        (True, accel(0.5)),                                                          # 2
        (True, acknowledge(0x01, 0x01, 0)),                                          # 3
        (True, acknowledge(0x01, 0x09, 0, answer[1:])),                              # 4
        (False, packet(ping)),                                                       # 5: refused in 6
        (True, acknowledge(0x01, 0x01, 3)),                                          # 6
        (False, packet(ping)),                                                       # 7: answered in 9
        (False, packet(ping)),                                                       # 8: answered in 10
        (True, acknowledge(0x01, 0x01, 0)),                                          # 9
        (True, acknowledge(0x01, 0x01, 0)),                                          # 10
        (True, acknowledge(0x01, 0x01, 0)),                                          # 11: answers nothing
    ]  # fmt: skip


LINKS = {1: [3, 4], 5: [6], 7: [9], 8: [10]}
BACK = {3: [1], 4: [1, 1], 6: [5], 9: [7], 10: [8]}  # 4: the acknowledge and the response


@pytest.mark.parametrize("transport", ["serial", "tcp", "udp"])
def test_answers_and_requests_are_linked(transport: str, tmp_path: Path) -> None:
    sent = conversation()
    shift = 3 if transport == "tcp" else 0  # behind the handshake
    if transport == "serial":
        capture = captures.serial([data for _, data in sent])
    elif transport == "tcp":
        capture = captures.tcp(sent, PORT)
    else:
        capture = captures.capture(captures.RAW_IP, (captures.udp(data, PORT, way) for way, data in sent))
    frames = trees(tmp_path, capture, "-2")[shift:]
    for number, frame in enumerate(frames, 1):
        assert shown(frame, "mip.answer_in") == [str(n + shift) for n in LINKS.get(number, [])], number
        assert shown(frame, "mip.request_in") == [str(n + shift) for n in BACK.get(number, [])], number
    times = [float(time) for frame in frames for time in shown(frame, "mip.answer_time")]
    assert times == pytest.approx([0.002, 0.003, 0.003, 0.001, 0.002, 0.002])
    assert shown(frames[5], "mip.protocol.acknowledge.code") == ["3"]
    refused = [part.get("showname") for part in frames[5].iter("field") if part.get("name") == "mip.expert.refused"]
    assert refused == ["Ping refused: invalid_parameter"]


@pytest.mark.parametrize("period", [3.0, 1.0, 0.5])
def test_a_lost_reply_shifts_no_later_one(period: float, tmp_path: Path) -> None:
    """The second of four polls is not answered."""
    ping, reply = packet((0x01, 0x01, b"")), acknowledge(0x01, 0x01, 0)
    sent = captures.serial([ping, reply, ping, accel(0.5), *[ping, reply] * 2], interval=period / 2)
    frames = trees(tmp_path, sent, "-2")
    assert [shown(frame, "mip.answer_in") for frame in frames[::2]] == [["2"], [], ["6"], ["8"]]
    assert [shown(frame, "mip.request_in") for frame in frames[1::2]] == [["1"], [], ["5"], ["7"]]


def test_silent_commands_are_not_answered(tmp_path: Path) -> None:
    entry = {"trailing": "", "suppress_ack": True, "num_descriptors": 0, "descriptors": []}
    silent, asking = (field_bytes("3dm.poll_imu_data", **{**entry, "suppress_ack": flag}) for flag in (True, False))
    frames = trees(tmp_path, captures.serial([packet(silent), packet(asking), acknowledge(0x0C, 0x01, 0)]), "-2")
    assert [shown(frame, "mip.answer_in") for frame in frames] == [[], ["3"], []]


def test_columns_say_what_a_packet_is(tmp_path: Path) -> None:
    path = tmp_path / "capture.pcap"
    sent = [data for _, data in conversation()]
    path.write_bytes(captures.serial([*sent, accel(0.5) + accel(1.0), broken(accel(1.0)), NMEA]))
    names = ("_ws.col.Protocol", "_ws.col.Source", "_ws.col.Info")
    rows = shark().run("-r", str(path), "-T", "fields", *(word for name in names for word in ("-e", name))).splitlines()
    assert [row.split("\t") for row in rows] == [
        ["MIP", "Host", "Base: Ping, Comm port speed (read)"],
        ["MIP", "Device", "Sensor data: Scaled accel"],
        ["MIP", "Device", "Base: Ping acknowledged"],
        ["MIP", "Device", "Base: Comm port speed acknowledged, Comm port speed response"],
        ["MIP", "Host", "Base: Ping"],
        ["MIP", "Device", "Base: Ping refused: invalid_parameter"],
        *[["MIP", "Host", "Base: Ping"]] * 2,
        *[["MIP", "Device", "Base: Ping acknowledged"]] * 3,
        ["MIP", "Device", "Sensor data: Scaled accel | Sensor data: Scaled accel"],
        ["MIP", "Device", "Sensor data: Scaled accel [wrong checksum]"],
        ["MIP", "", "no packet"],
    ]


# --------------------------------------------------------------------------- no error on any bytes


@pytest.mark.parametrize("spec", ["real", "invented"])
def test_no_bytes_are_an_error_of_the_dissector(spec: str, tmp_path: Path) -> None:
    """Changed packets, wrong lengths and random bytes in every transport; `trees` finds errors."""
    of, chance = model(spec), random.Random(7)
    parts = []
    for f in all_fields(of):
        data = samples(f, chance)[0]
        for _ in range(3):
            changed = bytearray(codec.build(of, set_of(f, of), [(f.descriptor, data)]))
            for _ in range(chance.randrange(1, 5)):
                changed[chance.randrange(2, len(changed))] = chance.randrange(256)
            changed[-2:] = codec.checksum(bytes(changed[:-2])) if chance.random() < 0.8 else changed[-2:]
            parts.append(bytes(changed[: chance.choice((len(changed), len(changed), chance.randrange(len(changed))))]))
    parts += [chance.randbytes(chance.randrange(1, 300)) for _ in range(200)]
    parts += [b"ue" + chance.randbytes(chance.randrange(60)) for _ in range(400)]
    parts += [whole(bytes((chance.choice((1, 12, 128, 130, 255, 77)), n)) + chance.randbytes(n)) for n in range(256)]
    segments = [(True, p) for p in parts if p]
    assert trees(tmp_path, captures.serial(parts), "-2", spec=spec)
    assert trees(tmp_path, captures.datagrams(parts, PORT), "-o", f"mip_protocol.udp_ports:{PORT}", spec=spec)
    assert trees(tmp_path, captures.tcp(segments, PORT), "-o", f"mip_protocol.tcp_ports:{PORT}", spec=spec)


def whole(head_and_payload: bytes) -> bytes:
    made = b"ue" + head_and_payload
    return made + codec.checksum(made)


def test_two_passes_show_the_same(tmp_path: Path) -> None:
    """Apart from the frame of an answer, which is known in the second only."""
    path = tmp_path / "capture.pcap"
    path.write_bytes(captures.serial(captures.chunks(stream() + b"".join(data for _, data in conversation()), 11)))
    once, twice = (shark().run("-r", str(path), "-V", *passes).splitlines() for passes in ((), ("-2",)))
    assert once == [line for line in twice if "Answer in" not in line]
    assert len(twice) > len(once)

"""C beside the vendor's SDK, built as its documentation recommends: the same streams.

Nothing of the SDK is here: `make bench PEER=FOLDER` names its folder. peer/ has the programs for both.
"""

from __future__ import annotations

import re
from pathlib import Path

import bench_c
import streams
from bench_c import BUILD, HERE, SIZE, SOURCES, Row, instructions, library, measure, run
from bench_c_board import vendor_sources
from mipgen.resolve.load import load_model

#: The title of the row for which our library is compiled without SSE2.
PORTABLE = "parse, in pieces of 4 KiB, portable checksum"
#: Title, stream, our function, that of peer/speed.c.
ROWS = (
    ("parse, in pieces of 4 KiB", "log", "ours_parse", "peer_parse"),
    ("the same, packets in random order", "shuffled", "ours_parse", "peer_parse"),
    (PORTABLE, "log", "ours_parse", "peer_parse"),
    ("parse, in pieces of 64 bytes", "log", "ours_small", "peer_small"),
    ("the same, packets in random order", "shuffled", "ours_small", "peer_small"),
    ("parse, decode every known field", "log", "ours_table", "peer_all"),
    ("parse, decode three wanted fields", "log", "ours_three", "peer_three"),
    ("the same, packets in random order", "shuffled", "ours_three", "peer_three"),
    ("skip NMEA sentences", "text", "ours_parse", "peer_parse"),
    ("skip random bytes", "noise", "ours_parse", "peer_parse"),
    ("skip sync bytes without a packet", "syncs", "ours_parse", "peer_parse"),
)


def name(sdk: Path) -> str:
    """The SDK with its version."""
    found = re.search(r'VERSION "([\d.]+)"', (sdk / "CMakeLists.txt").read_text("utf-8"))
    if found is None or not (sdk / "src/c/mip").is_dir():
        raise SystemExit(f"bench: {sdk} is not a folder of the vendor's MIP SDK 4; name one: make bench PEER=FOLDER")
    return f"MIP SDK {found[1]}"


def speed(sdk: Path) -> list[Row]:
    model = load_model(bench_c.ROOT / "spec")
    packets = streams.log(model, SIZE)
    contents = {"log": packets, "shuffled": streams.shuffled(packets), "text": streams.text(SIZE)}
    contents |= {"noise": streams.noise(SIZE), "syncs": streams.syncs(SIZE)}
    for name, content in contents.items():
        (BUILD / f"{name}.bin").write_bytes(content)
    ours, portable, theirs = BUILD / "speed", BUILD / "speed-portable", BUILD / "speed-peer"
    flags = ["-std=gnu11", "-O2", "-w", "-DNDEBUG", f"-I{HERE}"]
    for program, choice in ((ours, []), (portable, ["-DMIP_CHECKSUM=MIP_CHECKSUM_WORDS"])):
        run("cc", *flags, *choice, f"-I{SOURCES}", HERE / "speed.c", *library(), "-o", program)
    run("cc", *flags, f"-I{sdk}/src/c", HERE / "peer/speed.c", *vendor_sources(sdk), "-o", theirs)
    rows = []
    for title, stream, own, peer in ROWS:
        path = BUILD / f"{stream}.bin"
        mine = portable if title == PORTABLE else ours
        times = measure(path, {own: mine, peer: theirs})
        counts = [instructions(program, path, f) for program, f in ((mine, own), (theirs, peer))]
        rows.append([
            title, f"{times[peer] / times[own]:.1f}", *(f"{c:.2f}" if c is not None else "?" for c in counts)
        ])  # fmt: skip
    return rows


def report(sdk: Path) -> str:
    """As Markdown."""
    BUILD.mkdir(parents=True, exist_ok=True)
    out = f"Comparison with the vendor's {name(sdk)} in C, each built as its documentation recommends "
    out += "(`make bench PEER=FOLDER`).\nThe first ratio is this library's speed divided by the SDK's; both find "
    out += "the same number of packets and fields.\n\n"
    heads = ["Speed", "Ratio", "Instructions per byte", name(sdk)]
    return out + bench_c.table(heads, speed(sdk))

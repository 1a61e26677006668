"""A long stream in real time: the data that a program receives, and the simulator's report if it cannot keep up.

python tests/tools/simulator/soak.py 600    # seconds; with others busy, as by `yes >/dev/null &`
"""

from __future__ import annotations

import json
import os
import re
import socket
import subprocess
import sys
import time
from dataclasses import asdict, dataclass
from pathlib import Path

from mip_protocol import Parser, mip_3dm, shared, types

ROOT = Path(__file__).parents[3]
#: Nine fields of a set at 1 kHz, the time among them.
FIELDS = (0xD5, 0x04, 0x05, 0x06, 0x07, 0x08, 0x0A, 0x0C, 0x17)
SET, RATE = 0x80, 1000


@dataclass
class Soak:
    seconds: float
    packets: int
    missing: int
    """Packets between the first and the last one that did not come."""
    reported: int
    """Packets of which the simulator says that it has dropped them."""
    behind: float
    """Seconds by which simulated time is late at the end."""
    late: float
    """What the simulator says of that."""
    cpu: float
    """Percent of a core."""
    memory: tuple[int, int]
    """Resident kB after the first tenth, and at the end."""


def soak(seconds: float) -> Soak:
    path = os.pathsep.join((str(ROOT / "tools"), str(ROOT / "generated/python")))
    command = [sys.executable, "-m", "mip_tools", "simulate", "3dm-cv7-gnss-ins", "--tcp", "0", "--motion", "circle"]
    process = subprocess.Popen(
        command, env={**os.environ, "PYTHONPATH": path}, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    try:
        assert process.stdout is not None
        host, _, number = process.stdout.readline().strip().rpartition(":")
        client = socket.create_connection((host, int(number)))
        entries = tuple(types.DescriptorRate(field, 1) for field in FIELDS)
        client.sendall(bytes(mip_3dm.MessageFormat.write(SET, entries).packet()))
        client.sendall(bytes(mip_3dm.DataStreamControl.write(SET, True).packet()))
        parser, times, packets, begin, first = Parser(), [0, 0], 0, 0.0, 0
        memory = [0]
        while not begin or time.monotonic() - begin < seconds:
            for packet in parser.feed(client.recv(65536)):
                stamp = shared.ReferenceTimestamp.find(packet)
                if stamp is None:
                    continue  # an answer, or the rest of a message
                begin = begin or time.monotonic()
                first = first or stamp.nanoseconds
                times = [first, stamp.nanoseconds]
                packets += 1
            if not memory[0] and begin and time.monotonic() - begin > seconds / 10:
                memory[0] = _memory(process.pid)
        wall = time.monotonic() - begin
        memory.append(_memory(process.pid))
        ticks = sum(map(int, Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()[11:13]))
        client.close()
        process.terminate()
        _, said = process.communicate(timeout=60)
    finally:
        process.kill()
    simulated = (times[1] - times[0]) / 1e9
    return Soak(
        seconds=round(wall, 3),
        packets=packets,
        missing=round(simulated * RATE) + 1 - packets,
        reported=sum(int(n) for n in re.findall(r": (\d+) packets? dropped", said)),
        behind=round(wall - simulated, 3),
        late=float((re.findall(r"simulated time ends ([\d.]+) s late", said) or ["0"])[0]),
        cpu=round(100 * ticks / os.sysconf("SC_CLK_TCK") / wall, 1),
        memory=(memory[0], memory[1]),
    )


def _memory(pid: int) -> int:
    found = re.search(r"VmRSS:\s+(\d+)", Path(f"/proc/{pid}/status").read_text())
    return int(found[1]) if found else 0


if __name__ == "__main__":
    print(json.dumps(asdict(soak(float(sys.argv[1])))))

"""Parses a file that holds a stream, decodes two fields of each packet, and prints nanoseconds for each."""

import sys
import time

from mip_protocol import Parser
from mip_protocol.sensor import ScaledAccel, ScaledGyro


def run(data: bytes, decode: bool) -> float:
    parser, packets, total = Parser(), 0, 0.0
    begin = time.perf_counter_ns()
    for at in range(0, len(data), 4096):
        for packet in parser.feed(data[at : at + 4096]):
            packets += 1
            if decode:
                for raw in packet:
                    if raw.descriptor == ScaledAccel.DESCRIPTOR:
                        total += ScaledAccel.decode(raw.data).scaled_accel[0]
                    elif raw.descriptor == ScaledGyro.DESCRIPTOR:
                        total += ScaledGyro.decode(raw.data).scaled_gyro[0]
    return (time.perf_counter_ns() - begin) / packets


with open(sys.argv[1], "rb") as file:
    stream = file.read()
print(f"{run(stream, False):.1f} {run(stream, True):.1f}")

"""Reads the base rates of seven sets in turn, and counts the replies that are those of another command."""

import json
import select
import socket
import sys
import time

from mip_protocol import Device, MipError, mip_3dm

count = dict.fromkeys(("right", "stale", "other", "longest", "kept"), 0)
udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
udp.connect(("127.0.0.1", int(sys.argv[1])))


class Udp:
    """Each read returns one datagram."""

    def waits(self, seconds: float = 0) -> bool:
        return bool(select.select([udp], [], [], seconds)[0])

    def read(self, size: int) -> bytes:
        return udp.recv(65536) if self.waits(0.01) else b""

    def write(self, data: bytes) -> int:
        return udp.send(data)


with Device(Udp(), timeout=10) as device:
    shift = 0
    for i in range(int(sys.argv[2])):
        wanted = (0x80, 0x82, 0x91, 0x92, 0x93, 0x94, 0xA0)[i % 7]
        try:
            kind = "right" if device.request(mip_3dm.GetBaseRate(wanted)).descriptor_set == wanted else "stale"
        except MipError:
            kind = "other"
        count[kind] += 1
        shift = 0 if kind == "right" else shift + 1
        count["longest"] = max(count["longest"], shift)
        time.sleep(0.02)
    while (packet := device.next(0.3)) is not None:
        count["kept"] += len(packet.fields)
print(json.dumps(count))

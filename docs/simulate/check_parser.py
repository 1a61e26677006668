"""Reads from a virtual device that injects faults, and compares what a parser finds with the log."""

import json
import socket
import sys
from collections import Counter

from mip_protocol import Parser, mip_3dm, types  # put your parser in place of this one

connection = socket.create_connection(("localhost", int(sys.argv[1])))
fields = tuple(types.DescriptorRate(descriptor, 10) for descriptor in (0xD3, 0x04, 0x05))
connection.sendall(bytes(mip_3dm.MessageFormat.write(0x80, fields).packet()))
connection.sendall(bytes(mip_3dm.DataStreamControl.write(0x80, True).packet()))

parser = Parser()
found: Counter[bytes] = Counter()
while data := connection.recv(4096):  # until the simulation ends
    found.update(bytes(packet) for packet in parser.feed(data))
found.update(bytes(packet) for packet in parser.flush())

sent: Counter[bytes] = Counter()
damaged: Counter[bytes] = Counter()
added: Counter[bytes] = Counter()
with open(sys.argv[2]) as log:
    for entry in map(json.loads, log):
        if entry["kind"] == "sent":
            sent[bytes.fromhex(entry["packet"])] += 1
        elif entry.get("damaged"):
            damaged[bytes.fromhex(entry["packet"])] += 1
        elif entry["kind"] in ("double_packet", "repeat_packet", "unknown_set"):
            added[bytes.fromhex(entry["added"])] += 1

lost = sent - damaged - found
invented = found - sent - added
print(f"{sent.total()} packets sent, {damaged.total()} of them damaged")
print(f"{lost.total()} intact packets lost, {invented.total()} packets found that were never sent")
sys.exit(1 if lost or invented or not sent else 0)

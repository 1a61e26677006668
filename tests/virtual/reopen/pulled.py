"""Reads base rates while data streams; reopens the port each time it is pulled, a given number of times."""

import json
import sys
from itertools import cycle

from mip_protocol import MipError, PortClosed, mip_3dm, open_port, sensor

count = dict.fromkeys(("reopened", "streamed", "answered", "lost", "wrong", "other"), 0)
with open_port(sys.argv[1]) as device:
    device.stream({sensor.ScaledAccel: 100})
    for number in cycle((0x80, 0x82, 0x91)):
        try:
            answer = device.request(mip_3dm.GetBaseRate(number))
            count["answered"] += 1
            count["wrong"] += answer.descriptor_set != number
        except PortClosed:
            count["lost"] += 1
            count["streamed"] += device.waiting > 0
            device.clear()
            device.reopen(within=10)
            count["reopened"] += 1
        except MipError as error:
            print(error, file=sys.stderr)
            count["other"] += 1
        if count["reopened"] == int(sys.argv[2]):
            break
print(json.dumps(count))

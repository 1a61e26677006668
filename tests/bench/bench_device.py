"""Streams six fields at 1 kHz from a virtual device, and prints its share of a core in percent."""

import time

from mip_protocol import mip_3dm, sensor, shared, types
from mip_tools.simulator import VirtualDevice

SECONDS = 10
FIELDS = (
    shared.ReferenceTimestamp, sensor.ScaledAccel, sensor.ScaledGyro, sensor.CompQuaternion, sensor.CompEulerAngles,
    sensor.GpsTimestamp,
)  # fmt: skip

device = VirtualDevice("3dm-cv7-gnss-ins")
link = device.connect()
wanted = tuple(types.DescriptorRate(kind.DESCRIPTOR, 1) for kind in FIELDS)
link.write(bytes(mip_3dm.MessageFormat.write(sensor.ScaledAccel.SET, wanted).packet()))
begin, size = time.process_time(), 0
for _ in range(SECONDS * 100):
    device.advance(0.01)
    size += len(link.read())
spent = time.process_time() - begin
assert size > SECONDS * 1000 * 80
print(f"{100 * spent / SECONDS:.1f}")

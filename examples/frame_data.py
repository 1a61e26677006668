"""Opens a device, streams a data field of the reference once per second, and reads it."""

import sys

from mip_protocol import open_port
# 1. the line of the page that begins with from
from mip_protocol import sensor

# 3. the descriptor set and the type of the page
SET, FIELD = 0x80, sensor.ScaledAccel

place = sys.argv[1] if len(sys.argv) > 1 else "/dev/ttyACM0"  # or COM3, or HOST:PORT
with open_port(place, baud=None) as device:  # None: finds the baud rate
    device.stream({FIELD: 1}, set=SET)  # 1 Hz
    # 2. the other lines of the page
    for stamp, value in device.fields(sensor.ScaledAccel):
        print(stamp.device, value.scaled_accel)
    # end of 2

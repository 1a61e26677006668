"""Opens a device, and sends a command of the reference."""

import sys

from mip_protocol import open_port
# 1. the line of the page that begins with from
from mip_protocol import base

place = sys.argv[1] if len(sys.argv) > 1 else "/dev/ttyACM0"  # or COM3, or HOST:PORT
with open_port(place, baud=None) as device:  # None: finds the baud rate
    # 2. the other lines of the page
    device.request(base.Ping())
    # end of 2
    print("command: acknowledged")

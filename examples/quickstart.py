"""Requests the name of a device, and prints accelerations from a stream of bytes."""

from mip_protocol import Parser, base, sensor

print(bytes(base.GetDeviceInfo().packet()).hex(" "))

parser = Parser()
stream = b"$GPGGA noise\r\n" + bytes.fromhex("7565800e0e04 3e7a63a0 bb8e3b29 7fe5bf7f 84ee")
for packet in parser.feed(stream):
    if accel := sensor.ScaledAccel.find(packet):
        print(f"{accel.scaled_accel[0]:.4f} g along x")

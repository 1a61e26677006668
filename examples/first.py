import sys

from mip_protocol import base, open_port, sensor

place = sys.argv[1] if len(sys.argv) > 1 else "/dev/ttyACM0"  # or COM3, or HOST:PORT
with open_port(place, baud=None) as device:  # None: finds the baud rate
    info = device.request(base.GetDeviceInfo())
    print(info.device_info.model_name.strip())

    device.stream({sensor.ScaledAccel: 100})
    for stamp, accel in device.fields(sensor.ScaledAccel):
        x, y, z = accel.scaled_accel
        print(f"{x:8.4f} {y:8.4f} {z:8.4f} g", flush=True)

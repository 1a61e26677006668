from mip_protocol import Refused, base, mip_3dm, open_port, sensor

with open_port("/dev/ttyACM0", 115200) as device:
    print(device.request(base.GetDeviceInfo()).device_info.model_name)
    device.stream({sensor.ScaledAccel: 10, sensor.ScaledGyro: 10})  # in Hz
    try:
        device.request(mip_3dm.PpsSourceControl.read())
    except Refused as refusal:
        print(refusal.command, refusal.code.name)
    for stamp, accel in device.fields(sensor.ScaledAccel):
        print(f"{stamp.device:.3f} s", accel.scaled_accel)

from mip_protocol import Refused, base, change, mip_3dm, open_port, sensor

with open_port("/dev/ttyACM0", 115200) as device:
    print(device.request(base.GetDeviceInfo()).device_info.model_name)
    device.stream({sensor.ScaledAccel: 10, sensor.ScaledGyro: 10})  # in Hz
    try:
        setting = device.request(mip_3dm.ComplementaryFilter.read())
        device.request(change(setting, pitch_roll_time_constant=5.0))  # other values are kept
    except Refused as refusal:
        print(refusal.command, refusal.code.name)
    for stamp, accel in device.fields(sensor.ScaledAccel):
        print(f"{stamp.device:.3f} s", accel.scaled_accel)

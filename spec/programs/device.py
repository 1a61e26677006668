from mip_protocol import Refused, base, mip_3dm, open_port, sensor, types

with open_port("/dev/ttyACM0", 115200) as device:
    print(device.request(base.GetDeviceInfo()).device_info.model_name)
    rate = device.request(mip_3dm.GetBaseRate(sensor.ScaledAccel.SET)).rate
    wanted = types.DescriptorRate(sensor.ScaledAccel.DESCRIPTOR, rate // 10)  # 10 Hz
    try:
        device.request(mip_3dm.MessageFormat.write(sensor.ScaledAccel.SET, [wanted]))
        device.request(mip_3dm.DataStreamControl.write(sensor.ScaledAccel.SET, True))
    except Refused as refusal:
        print(refusal.command, refusal.code.name)
    for time, accel in device.fields(sensor.ScaledAccel):
        print(f"{time:.3f} s", accel.scaled_accel)

import asyncio

from mip_protocol import aio, base, sensor


async def main() -> None:
    async with aio.open_port("socket://localhost:5000") as device:
        info = await device.request(base.GetDeviceInfo())
        print(info.device_info.model_name)
        await device.stream({sensor.ScaledAccel: 100})
        async for arrival in device:
            if accel := arrival.find(sensor.ScaledAccel):
                print(accel.scaled_accel)


asyncio.run(main())

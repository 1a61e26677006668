import type { Packet } from "mip-protocol";
import { CommSpeed } from "mip-protocol/base";
import { ScaledAccel } from "mip-protocol/sensor";
import type { Device } from "mip-protocol";

export function acceleration(packet: Packet): number | undefined {
    const [x, y, z] = packet.find(ScaledAccel)?.scaledAccel ?? [];
    return x === undefined || y === undefined || z === undefined ? undefined : Math.hypot(x, y, z);
}

export async function baudRate(device: Device, port: number): Promise<number> {
    const { baud } = await device.request(CommSpeed.read({ port }));
    return baud;
}

// What strict TypeScript accepts. It is compiled only.
import { type Client, type Command, type Device, MipError, type Packet, packetOf, Parser } from "mip-protocol";
import {
    DataStreamControl,
    EventTriggerConfig,
    MessageFormat,
    PpsSource,
    PpsSourceControl,
    type PpsSourceControlResponse,
} from "mip-protocol/3dm";
import { EcefPosition } from "mip-protocol/aiding";
import { CommSpeed, GetDeviceInfo, Ping } from "mip-protocol/base";
import { EulerAngles } from "mip-protocol/filter_data";
import { Dop } from "mip-protocol/gnss_data";
import { AckCode, FunctionSelector } from "mip-protocol/protocol";
import { registry } from "mip-protocol/registry";
import { OverrangeFlags, OverrangeStatus, ScaledAccel, ScaledGyro } from "mip-protocol/sensor";
import { GpsTimestamp } from "mip-protocol/shared";
import { Clock, Times } from "mip-protocol/time";

export async function commands(device: Device): Promise<string> {
    const info = await device.request(new GetDeviceInfo());
    const { deviceInfo } = await device.identify();
    if (deviceInfo.modelName !== info.deviceInfo.modelName) throw new Error(deviceInfo.serialNumber);
    const setting: PpsSourceControlResponse = await device.request(PpsSourceControl.read());
    const nothing: undefined = await device.request(PpsSourceControl.write({ source: PpsSource.RECEIVER_1 }));
    const [ping, speed] = await device.requestAll([new Ping(), CommSpeed.read({ port: 1 })], { timeout: 2 });
    const rates = await device.stream([
        [ScaledAccel, 100],
        [ScaledGyro, 100],
    ]);
    await device.stream(new Map([[EulerAngles, 10]]), { set: 0x82, timestamp: "gps" });
    await device.send(CommSpeed.save({ port: 1 }), MessageFormat.read({ descriptorSet: 0x80 }));
    return [info.deviceInfo.modelName, PpsSource.nameOf(setting.source), nothing, ping, speed.baud, rates.get(ScaledAccel)].join();
}

export async function data(device: Device): Promise<number> {
    const times = new Times();
    for await (const packet of device) {
        const [x, y, z] = packet.find(ScaledAccel)?.scaledAccel ?? [0, 0, -1];
        const flags = packet.find(OverrangeStatus)?.status ?? 0;
        const full = OverrangeFlags.has(flags, OverrangeFlags.ACCEL_X) || OverrangeFlags.namesOf(flags).includes("MAG_X");
        for (const time of packet.findAll(GpsTimestamp)) if (full && time.set === 0x80) return time.tow;
        if (x > y && packet.arrival) return z;
        const time: bigint = packet.time(Clock.GPS, "3dm-gx5-25") ?? times.time(packet, Clock.DEVICE) ?? 0n;
        if (time > 0n && packet.find(Dop)?.isValid("gdop")) return Number(time / 1_000_000n);
    }
    for await (const field of device.fields(EulerAngles)) return field.yaw;
    return (await device.next({ timeout: 1 }))?.find(Dop)?.gdop ?? 0;
}

export function values(packet: Packet): Uint8Array {
    const accel = new ScaledAccel({ scaledAccel: [0, 0, -1] });
    const position = new EcefPosition({
        time: { timebase: 1, nanoseconds: 5n }, // without the reserved byte
        frameId: 1,
        position: [1, 2, 3],
        uncertainty: [1, 1, 1],
        validFlags: 7,
    });
    const setting = new CommSpeed({ function: FunctionSelector.READ, port: 1 });
    const stream = DataStreamControl.write({ descriptorSet: 0x80, enable: true });
    accel.scaledAccel[0] = ScaledAccel.decode(accel.encode()).scaledAccel[1];
    EventTriggerConfig.default({ instance: 1 });
    const some: Command[] = [position, setting, stream];
    try {
        return packetOf(some).bytes;
    } catch (error) {
        if (error instanceof MipError && error.kind === "refused" && error.code === AckCode.INVALID_PARAMETER) return packet.bytes;
        throw error;
    }
}

export function without(client: Client, bytes: Uint8Array): string[] {
    const found = client.receive(bytes, 0).map((event) => (event.type === "answer" ? event.command.encode().length : event.type));
    for (const packet of new Parser({ onSkipped: (skipped) => found.push(skipped.length) }).feed(bytes)) {
        for (const field of registry.decode(packet)) if (field instanceof ScaledAccel) found.push(field.scaledAccel.length);
    }
    return found.map(String);
}

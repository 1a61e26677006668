// Files of settings as the workbench reads and writes them: one JSON object per line in, one per line out.
//
//     settings_files.mjs WORKBENCH
//
// { device, text } -> { model, packets } or { error }; { device, packets, model, firmware, date } -> { text }
import path from "node:path";
import readline from "node:readline";
import { pathToFileURL } from "node:url";

await import(pathToFileURL(path.resolve(process.argv[2], "workbench.js")));
const { Protocol, model, Packet, fromHex, toHex, decodePacket, settingsIn, textOf } = globalThis.mip;
const protocol = new Protocol(model);

function answer({ device: id, text, packets, ...about }) {
    const device = model.devices.find((one) => one.id === id);
    if (text === undefined) {
        const settings = packets.map((packet) => decodePacket(protocol, Packet.from(fromHex(packet)))[0]);
        return { text: textOf(protocol, device, about, settings) };
    }
    try {
        const { model: own, settings } = settingsIn(protocol, text, device);
        return { model: own, packets: settings.map(({ packet }) => toHex(packet.bytes)) };
    } catch (error) {
        if (error.name !== "MipError") throw error;
        return { error: error.message };
    }
}

for await (const line of readline.createInterface({ input: process.stdin })) {
    process.stdout.write(`${JSON.stringify(answer(JSON.parse(line)))}\n`);
}

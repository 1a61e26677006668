// A device at a TCP connection, in Node.

import net from "node:net";
import { Device } from "./device.mjs";

export function openTcp(host, port, options) {
    return Device.open(() => connected(host, port), options);
}

function connected(host, port) {
    return new Promise((resolve, reject) => {
        const socket = net.connect({ host, port, noDelay: true });
        socket.once("error", reject);
        socket.once("connect", () => {
            socket.off("error", reject);
            resolve({
                async *bytes() {
                    for await (const chunk of socket) yield new Uint8Array(chunk.buffer, chunk.byteOffset, chunk.length);
                },
                write: (bytes) =>
                    new Promise((done, fail) => {
                        socket.write(bytes, (error) => (error ? fail(error) : done()));
                    }),
                close: () => socket.destroy(),
            });
        });
    });
}

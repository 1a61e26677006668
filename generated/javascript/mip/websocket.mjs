// A device at a WebSocket, whose binary messages carry the bytes of the device's port, divided in any way.

import { MipError } from "./bytes.mjs";
import { Device } from "./device.mjs";

export function openWebSocket(url, { WebSocket = globalThis.WebSocket, ...options } = {}) {
    if (!WebSocket) return Promise.reject(new MipError("websocket", "WebSocket is not global here; pass `WebSocket`"));
    return Device.open(() => connected(new WebSocket(url)), options);
}

function connected(socket) {
    socket.binaryType = "arraybuffer";
    const pieces = [];
    let wake = () => {};
    let ended = false;
    let why = ""; // the reason that the other end has stated
    const end = ({ reason }) => {
        ended = true;
        why = reason;
        wake();
    };
    socket.addEventListener("message", ({ data }) => {
        if (typeof data === "string") return; // not bytes of the port
        pieces.push(new Uint8Array(data));
        wake();
    });
    const port = {
        async *bytes() {
            while (pieces.length || !ended) {
                if (pieces.length) {
                    yield pieces.shift();
                    continue;
                }
                await new Promise((resolve) => {
                    wake = resolve;
                });
            }
            if (why) throw new MipError("closed", why);
        },
        write(bytes) {
            if (ended) throw new MipError("closed", why || "the WebSocket is closed");
            socket.send(bytes);
        },
        close: () => socket.close(),
    };
    return new Promise((resolve, reject) => {
        socket.addEventListener("open", () => resolve(port));
        socket.addEventListener("error", () => reject(new MipError("closed", `${socket.url} cannot be reached`)));
        socket.addEventListener("close", end);
    });
}

// A device at a serial port, in browsers with Web Serial.

import { BAUD_RATES, session } from "../session.mjs";
import { MipError } from "./bytes.mjs";
import { Device } from "./device.mjs";

/** Seconds to listen at each baud rate, and the number of attempts. */
const LISTEN = 0.3;
const ATTEMPTS = 2;

export async function openSerial(port, { baud, ...options } = {}) {
    if (baud !== undefined) return Device.open(() => opened(port, baud), options);
    for (const rate of BAUD_RATES) {
        const device = await Device.open(() => opened(port, rate), options);
        let found = false;
        try {
            found = await answers(device);
            if (found) return device;
        } finally {
            if (!found) await device.close().catch(() => {}); // a port that is lost cannot be opened before it is closed
        }
    }
    throw new MipError("no_device", `no device answers at ${BAUD_RATES.join(", ")} Bd; is it switched on, and on this port?`);
}

/** Does a device answer, even with a NACK? Bytes sent earlier may spoil the first attempt. */
async function answers(device) {
    if (!session) throw new MipError("session", "the specification has no command to detect the rate with; pass `baud`");
    for (let i = 0; i < ATTEMPTS; i++) {
        try {
            await device.request(session.ping(), { timeout: LISTEN });
            return true;
        } catch (error) {
            if (error.kind === "refused") return true;
            if (error.kind !== "timeout") throw error;
            if (device.waiting > 0) return true; // data
        }
    }
    return false;
}

async function opened(port, baudRate) {
    await port.open({ baudRate, bufferSize: 65536 });
    let reader;
    let closed = false;
    return {
        async *bytes() {
            // A damaged byte ends the port's stream, which is replaced by another; a lost port has none.
            while (port.readable && !closed) {
                reader = port.readable.getReader();
                try {
                    for (;;) {
                        const { value, done } = await reader.read();
                        if (done) return;
                        yield value;
                    }
                } catch (error) {
                    if (!port.readable) throw error;
                } finally {
                    reader.releaseLock();
                }
            }
        },
        write(bytes) {
            const writer = port.writable.getWriter();
            const written = writer.write(bytes);
            writer.releaseLock(); // the next write may begin before the end of this one
            return written;
        },
        async close() {
            closed = true;
            await reader?.cancel().catch(() => {}); // the stream may have ended
            await port.close();
        },
    };
}

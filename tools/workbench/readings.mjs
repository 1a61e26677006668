// Data from a device: the latest values, their rates, and the last seconds of those that are plotted.

import { decodeData, MipError, nameIn, partsOf } from "mip-protocol/tools";
import { Clocks, Rhythm } from "./clocks.mjs";

/** The number of seconds that a plot shows. */
export const SPAN = 10;

/** The number of seconds over which a rate is counted. */
const WINDOW = 2;

export class Readings {
    /** Key of set and descriptor -> reading, in the order of the first arrival. */
    fields = new Map();
    packets = 0;
    #protocol;
    #clocks;

    constructor(protocol) {
        this.#protocol = protocol;
        this.#clocks = new Clocks(protocol);
    }

    /** The number of missing samples of all fields. */
    get lost() {
        return [...this.fields.values()].reduce((sum, { rhythm }) => sum + rhythm.lost, 0);
    }

    /** Restarts the rhythms, so that samples that were not sent in the meantime do not count as missing. */
    restart() {
        for (const reading of this.fields.values()) reading.rhythm = new Rhythm();
    }

    /** Processes a data packet, whose `time` is the time of its arrival. */
    take(packet) {
        this.packets++;
        const time = this.#clocks.timeOf(packet);
        packet.walk((at, end) => {
            const key = packet.set * 256 + packet.bytes[at + 1];
            const data = packet.bytes.subarray(at + 2, end);
            let reading = this.fields.get(key);
            if (!reading) {
                reading = this.#begun(packet.set, packet.bytes[at + 1], data);
                this.fields.set(key, reading);
            }
            reading.data = data;
            reading.count++;
            reading.rhythm.add(time);
            reading.times.push(packet.time);
            if (reading.times.length > 4096) reading.times.splice(0, 2048);
            if (reading.plotted) reading.sample(packet.time);
        });
    }

    #begun(set, descriptor, data) {
        const field = this.#protocol.choose(set, descriptor, data);
        return new Reading(this.#protocol, { key: set * 256 + descriptor, set, descriptor, field });
    }
}

class Reading {
    #protocol;
    plotted = false;
    count = 0;
    rhythm = new Rhythm();
    data;
    times = [];
    /** Returns the path of each number -> [[time, value], …] of the last seconds. */
    series = new Map();

    constructor(protocol, of) {
        this.#protocol = protocol;
        Object.assign(this, of);
    }

    get name() {
        return this.field && nameIn(this.field, this.set);
    }

    /** Returns the latest values; undefined if they cannot be decoded. */
    get values() {
        try {
            return this.field && decodeData(this.#protocol, this.field, this.data).values;
        } catch (error) {
            if (!(error instanceof MipError)) throw error;
            return undefined;
        }
    }

    /** Returns the rate in Hz by the device's clock; without a rhythm, the arrivals per second. */
    rate(now) {
        if (this.rhythm.rate) return this.rhythm.rate;
        const first = this.times.findIndex((time) => time > now - WINDOW);
        const some = first < 0 ? [] : this.times.slice(first);
        return some.length > 1 ? (some.length - 1) / (some.at(-1) - some[0] || WINDOW) : some.length / WINDOW;
    }

    /** Stores the numbers of the latest data for plots. */
    sample(time) {
        const values = this.values;
        if (!values) return;
        for (const { path, operation, value } of partsOf(this.#protocol, this.field, values)) {
            if (this.#protocol.scalar(operation.scalar)?.kind !== "float" || typeof value !== "number") continue;
            const key = path.join(".");
            if (!this.series.has(key)) this.series.set(key, { path, points: [] });
            const { points } = this.series.get(key);
            points.push([time, value]);
            if (points[0][0] < time - 2 * SPAN)
                points.splice(
                    0,
                    points.findIndex(([at]) => at > time - SPAN),
                );
        }
    }

    /** Can the field be plotted, that is, does it contain a float? */
    get plottable() {
        const floats = (operations) =>
            operations.some((op) => {
                if (op.kind === "group") return floats(op.body);
                if (op.kind === "array") return floats([op.item]);
                if (op.kind === "struct") return floats(this.#protocol.type(op.struct).operations);
                return this.#protocol.scalar(op.scalar)?.kind === "float";
            });
        return Boolean(this.field) && floats(this.field.operations);
    }
}

// ------------------------------------------------------------------------------------------------ attitude

/**
 * Returns the rotation from the vehicle to the NED frame, as the rows of a
 * matrix, from a field's quaternion, matrix, or roll, pitch and yaw; undefined for other fields.
 */
export function rotationOf(field, values) {
    const attitude = /attitude|orientation|quaternion|euler/i.test(field?.title ?? "") && field.role === "data";
    if (!attitude || !values) return undefined;
    const { roll, pitch, yaw } = values;
    if (roll !== undefined && pitch !== undefined && yaw !== undefined) return ofAngles(roll, pitch, yaw);
    for (const { name, type, length } of field.parameters) {
        if (length !== undefined) continue;
        if (type === "quatf") return ofQuaternion(values[name]);
        if (type === "matrix3f") return transposed([0, 3, 6].map((at) => values[name].slice(at, at + 3)));
    }
    return undefined;
}

function transposed(m) {
    return m.map((_, i) => m.map((row) => row[i]));
}

function ofAngles(roll, pitch, yaw) {
    const [cr, sr, cp, sp, cy, sy] = [roll, pitch, yaw].flatMap((angle) => [Math.cos(angle), Math.sin(angle)]);
    return [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ];
}

function ofQuaternion([w, x, y, z]) {
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ];
}

/** Returns roll, pitch and yaw in degrees. */
export function anglesOf(m) {
    const angles = [Math.atan2(m[2][1], m[2][2]), Math.asin(Math.max(-1, Math.min(1, -m[2][0]))), Math.atan2(m[1][0], m[0][0])];
    return angles.map((angle) => (angle * 180) / Math.PI);
}

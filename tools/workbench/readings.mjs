// Data from a device: the latest values, their rates, and the last seconds of those that are plotted.

import { decodeData, isValid, MipError, nameIn, parametersAt, partsOf, Times, unitOf } from "mip-protocol/tools";
import { Clocks, Rhythm } from "./clocks.mjs";

/** The number of seconds that a plot shows. */
export const SPAN = 10;

/** The maximum number of points of a track. */
const TRACK = 2000;

/** The values of a position that make a track. */
const POSITION = ["latitude", "longitude"];

/** The number of seconds over which a rate is counted. */
const WINDOW = 2;

export class Readings {
    /** Key of set and descriptor -> reading, in the order of the first arrival. */
    fields = new Map();
    packets = 0;
    #protocol;
    #clocks;
    #device;

    constructor(protocol) {
        this.#protocol = protocol;
        this.#clocks = new Clocks(protocol);
    }

    /** Reads the times and flags of later packets as those of a device, by its id; of no known device if it is undefined. */
    set device(device) {
        this.#device = device;
        this.#clocks = new Clocks(this.#protocol, new Times({ device }));
    }

    get device() {
        return this.#device;
    }

    /** The number of missing samples of all fields. */
    get lost() {
        return [...this.fields.values()].reduce((sum, { rhythm }) => sum + rhythm.lost, 0);
    }

    /** Restarts the rhythms, so that samples that were not sent in the meantime do not count as missing. */
    restart() {
        for (const reading of this.fields.values()) reading.rhythm = new Rhythm();
    }

    /** Processes a data packet, with the time of its `arrival`. */
    take(packet) {
        this.packets++;
        const time = this.#clocks.timeOf(packet);
        packet.walk((at, end) => {
            const { set, descriptor, data } = packet.raw(at, end);
            const key = set * 256 + descriptor;
            let reading = this.fields.get(key);
            if (!reading) {
                reading = this.#begun(set, descriptor, data);
                this.fields.set(key, reading);
            }
            reading.data = data;
            reading.device = this.#device;
            reading.count++;
            reading.rhythm.add(time);
            reading.times.push(packet.arrival);
            if (reading.times.length > 4096) reading.times.splice(0, 2048);
            if (reading.plotted) reading.sample(time, packet.arrival);
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
    /** The path of each number -> { unit, number, points: [[time, value], …] }, of the last seconds. */
    series = new Map();
    /** Positions, the oldest first: { seconds, latitude, longitude }. */
    track = [];
    dated = true; // are times those of a date?
    #seconds = Number.NaN; // the time of the latest data
    #behind = Infinity; // seconds by which the device's clock is behind that of this computer
    #step = 0.1; // seconds between two points of the track

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
        const some = this.times.slice(first < 0 ? -2 : Math.min(first, this.times.length - 2)); // the last two, however old
        return some.length > 1 ? (some.length - 1) / (some.at(-1) - some[0] || WINDOW) : 1 / WINDOW;
    }

    /** Is the field no longer sent? Between the samples of a slow one, more than WINDOW seconds pass. */
    isLate(now) {
        return now - this.times.at(-1) > Math.max(WINDOW, 2.5 / this.rate(now));
    }

    /** Returns the attitude, like `rotationOf`; undefined if the device does not mark it as valid. */
    get rotation() {
        const { values } = this;
        const rotation = rotationOf(this.field, values);
        const names = rotation ? this.field.parameters.map(({ name }) => name) : [];
        return this.#areValid(values, names) ? rotation : undefined;
    }

    #areValid(values, names) {
        return names.every((name) => isValid(this.#protocol, this.field, values, name, this.device));
    }

    /**
     * Stores the numbers of the latest data for plots, at the time of the device, or without one at that of the arrival.
     */
    sample(time, arrival) {
        const values = this.values;
        if (!values) return;
        const seconds = time?.seconds ?? arrival;
        const passed = seconds - this.#seconds;
        if (!(passed >= 0 && passed < SPAN)) {
            this.series.clear(); // the clock was set, or the stream interrupted
            this.track = [];
            this.#behind = Infinity;
        }
        this.#seconds = seconds;
        this.#behind = Math.min(this.#behind, arrival - seconds); // without the delays of some arrivals
        this.dated = time ? time.dated : true;
        for (const { path, operation, value } of partsOf(this.#protocol, this.field, values)) {
            if (this.#protocol.scalar(operation.scalar)?.kind !== "float" || typeof value !== "number") continue;
            const key = path.join(".");
            if (!this.series.has(key)) this.series.set(key, { unit: this.#unitOf(path), number: this.series.size, points: [] });
            const { points } = this.series.get(key);
            points.push([seconds, value]);
            if (points[0][0] < seconds - 2 * SPAN)
                points.splice(
                    0,
                    points.findIndex(([at]) => at > seconds - SPAN),
                );
        }
        const finite = POSITION.every((name) => Number.isFinite(values[name]));
        if (finite && this.#areValid(values, POSITION)) this.#travel(seconds, values);
    }

    #unitOf(path) {
        const index = path.findLast((step) => typeof step === "number") ?? 0;
        return unitOf(parametersAt(this.#protocol, this.field, path).at(-1).parameter, index);
    }

    /** Extends the track; a long one keeps each second point. */
    #travel(seconds, { latitude, longitude }) {
        if (seconds - (this.track.at(-1)?.seconds ?? -1) < this.#step) return;
        this.track.push({ seconds, latitude, longitude });
        if (this.track.length < TRACK) return;
        this.track = this.track.filter((_, i) => i % 2);
        this.#step *= 2;
    }

    /** Returns the time of the device at a time of this computer. */
    timeAt(now) {
        return now - this.#behind;
    }

    /** Returns what is plotted together: for each unit { unit, series }, and for a position the { track } in place of its angles. */
    get plots() {
        const moves = POSITION.every((name) => this.series.has(name));
        const shown = [...this.series].filter(([key]) => !(moves && POSITION.includes(key))).map(([, one]) => one);
        const units = [...new Set(shown.map(({ unit }) => unit))];
        const plots = units.map((unit) => ({ unit, series: shown.filter((one) => one.unit === unit) }));
        return moves ? [{ track: this.track }, ...plots] : plots;
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
 * matrix, from a field's quaternion, matrix, or roll, pitch and yaw; undefined for other fields, and without numbers.
 */
export function rotationOf(field, values) {
    const attitude = /^(?!.*(uncertainty|update)).*(attitude|orientation|quaternion|euler)/i.test(field?.title ?? "");
    if (!attitude || field.role !== "data" || !values) return undefined;
    const from = (numbers, rotation) => (numbers.every(Number.isFinite) ? rotation(numbers) : undefined);
    const angles = [values.roll, values.pitch, values.yaw];
    if (!angles.includes(undefined)) return from(angles, ofAngles);
    for (const { name, type, length } of field.parameters) {
        if (length !== undefined) continue;
        if (type === "quatf") return from(values[name], ofQuaternion);
        if (type === "matrix3f") return from(values[name], (m) => [0, 1, 2].map((at) => [m[at], m[at + 3], m[at + 6]]));
    }
    return undefined;
}

function ofAngles(angles) {
    const [cr, sr, cp, sp, cy, sy] = angles.flatMap((angle) => [Math.cos(angle), Math.sin(angle)]);
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

// Devices that may have sent a log in which none names itself, as `mip_tools/devices/known.py` finds them.

import { bitsNumber, decodeData, enumValue, MipError } from "mip-protocol/tools";
import { supportOn } from "./build.mjs";

/** All fields and values so far decide together how they are read: as on the devices that explain most of them. */
export class Senders {
    #protocol;
    #fields = [];
    #values = new Map(); // field -> name of a parameter whose names depend on the device -> numbers
    #alike = new Map(); // field -> the ids of those that read it alike; found when all of the log is known

    constructor(protocol) {
        this.#protocol = protocol;
    }

    /** Adds a data field of a set. Returns a function that takes its data each time, if values have names by device. */
    add(set, field) {
        this.#fields.push({ set, field });
        const names = field.parameters.filter(isNamedByDevice).map(({ name }) => name);
        if (!names.length) return undefined;
        const numbers = this.#values.get(field) ?? new Map(names.map((name) => [name, new Set()]));
        this.#values.set(field, numbers);
        return (data) => {
            try {
                const { values } = decodeData(this.#protocol, field, data);
                for (const name of names) numbers.get(name).add(bitsNumber(values[name]));
            } catch (error) {
                if (!(error instanceof MipError)) throw error;
            }
        };
    }

    /** Returns the id of a device that stands for all that may have sent the data, if they read a field alike. */
    reads(field) {
        return this.#readers(field)[0];
    }

    /** Says how flags and names are read, if that makes a difference: "filter_data.status: flags read as those of …". */
    get lines() {
        const named = new Map();
        for (const field of this.#values.keys()) {
            const [device] = this.#readers(field);
            const differs = device !== undefined && readingOn(field, device) !== readingOn(field, undefined);
            const devices = device === undefined ? this.#flagged(field) : differs ? this.#readers(field) : [];
            if (!devices.length) continue;
            const those = this.#thoseOf(devices);
            named.set(those, [...(named.get(those) ?? []), field.name]);
        }
        return [...named].map(([those, names]) => `${names.join(", ")}: flags read as those of ${those} (recognized)`);
    }

    #readers(field) {
        if (!this.#alike.has(field)) {
            const likely = this.#likely().filter((id) => field.parameters.filter(isNamedByDevice).every((one) => this.#type(one, id)));
            const alike = new Set(likely.map((id) => readingOn(field, id))).size === 1;
            this.#alike.set(field, alike && field.parameters.some(isReadByDevice) ? likely : []);
        }
        return this.#alike.get(field);
    }

    #likely() {
        const counts = new Map(this.#protocol.model.devices.map((device) => [device.id, this.#against(device)]));
        const least = Math.min(...counts.values());
        return [...counts].filter(([, count]) => count === least).map(([id]) => id);
    }

    /** Counts what a device does not explain. */
    #against(device) {
        let count = this.#fields.filter(({ set, field }) => !supportOn(this.#protocol, device, field, set)).length;
        for (const [field, values] of this.#values) {
            for (const parameter of field.parameters.filter(isNamedByDevice)) {
                const type = this.#type(parameter, device.id);
                count += ![...values.get(parameter.name)].every((value) => type && isMeant(this.#protocol, type, value));
            }
            const others = this.#flagged(field);
            count += others.length > 0 && !others.includes(device.id);
        }
        return count;
    }

    /** Returns the devices on which the flags mark values as valid, if these are not the usual ones. */
    #flagged(field) {
        const bits = (name) => [...(this.#values.get(field)?.get(name) ?? [])].reduce((all, value) => all | value, 0n);
        for (const { readings = [] } of field.parameters) {
            const found = readings.find(
                ({ flags, fewer }) => fewer && bits(flags[0]?.parameter) && !(bits(flags[0].parameter) & BigInt(fewer)),
            );
            if (found) return found.devices;
        }
        return [];
    }

    #type(parameter, id) {
        return this.#protocol.types.get(onDevice(parameter, id, "type"));
    }

    #thoseOf(ids) {
        const devices = ids.map((id) => this.#protocol.model.devices.find((one) => one.id === id));
        const generations = [...new Set(devices.map(({ generation }) => generation))].sort((a, b) => a - b);
        if (!generations.every(Boolean)) return inWords(devices.map(({ title }) => title));
        return `generation${generations.length > 1 ? "s" : ""} ${inWords(generations)}`;
    }
}

function inWords(names) {
    return names.length > 1 ? `${names.slice(0, -1).join(", ")} and ${names.at(-1)}` : `${names[0]}`;
}

function variants(parameter) {
    return (parameter.variants ?? []).filter((one) => one.by === "device" && !one.member);
}

const isNamedByDevice = (parameter) => variants(parameter).some(({ type }) => type);
const isReadByDevice = (parameter) => variants(parameter).some(({ type, valid }) => type || valid);

function onDevice(parameter, id, attribute) {
    return variants(parameter).find((one) => one.key === id && one[attribute])?.[attribute] ?? parameter[attribute];
}

/** Returns how a field is read on a device, as text to compare. */
function readingOn(field, id) {
    return JSON.stringify(field.parameters.map((one) => [onDevice(one, id, "type"), onDevice(one, id, "valid")]));
}

/** Has a value of an enumeration, or each part of a bitfield, a meaning? */
function isMeant(protocol, type, value) {
    if (type.values) return enumValue(type, value) !== undefined;
    const part = ({ first, last }) => (value >> BigInt(first)) & ((1n << BigInt(last - first + 1)) - 1n);
    const known = (type.bits ?? []).filter(({ alias }) => !alias).reduce((sum, bit) => sum | (part(bit) << BigInt(bit.first)), 0n);
    return known === value && type.bits.every((bit) => !bit.enum || enumValue(protocol.types.get(bit.enum), part(bit)) !== undefined);
}

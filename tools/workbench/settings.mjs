// The settings of a device as a file: which there are, and how they are read and written, one command after another.

import { buildPacket, decodeData, FIRST_DATA_SET, MipError, nameIn, SHARED_SET, toHex } from "mip-protocol/tools";
import { certaintyOn } from "./build.mjs";

/** Effects of settings that may end the connection: a file does not change them. */
const LINK = ["protocols", "communication_mode", "baud_rate"];

/** Settings with these effects are written last, in this order. */
const LAST = ["format", "sentences", "switch"];

/** How many instances are asked for where nothing says how many there are. */
const MOST = 8;

const facts = (protocol, name) => protocol.model.simulation?.behaviors?.find((one) => one.command === name) ?? {};
const callOf = (field, name) => field.calls?.find((call) => call.function === name);

/** The commands that a device can write, read and save; of several for one setting, the one that keeps it. */
export function settingsOf(protocol, device) {
    const all = protocol.model.fields.filter(
        (field) =>
            field.role === "command" &&
            ["write", "read", "save"].every((name) => callOf(field, name)) &&
            field.parameters.length > 1 &&
            certaintyOn(protocol, device, field, field.set) !== undefined,
    );
    const names = new Set(all.map(({ name }) => name));
    return all.filter(({ name }) => {
        const { once, setting } = facts(protocol, name);
        return !once && !names.has(setting);
    });
}

/** Values for the parameters that select an instance: an array of objects. Where their number is not known, `open` is true. */
export function instancesOf(protocol, device, field) {
    const known = facts(protocol, field.name);
    const selectors = callOf(field, "read").required;
    let open = false;
    let found = [{}];
    for (const name of selectors) {
        const parameter = field.parameters.find((one) => one.name === name);
        const values = (beside) => {
            const given = valuesOf(protocol, device, parameter, known, beside);
            open ||= given === undefined;
            return given ?? Array.from({ length: MOST }, (_, i) => i + 1);
        };
        found = found.flatMap((one) => values(one).map((value) => ({ ...one, [name]: value })));
    }
    return { instances: found, open };
}

function valuesOf(protocol, device, parameter, known, beside) {
    const pairs = (of) => new Map(of ?? []);
    const source = pairs(known.instances).get(parameter.name);
    const everything = pairs(known.all).get(parameter.name);
    const translate = pairs(known.translate).get(parameter.name);
    const sets = dataSetsOf(protocol, device);
    if (source === "ports" && device?.ports?.some(({ id }) => id !== undefined)) return device.ports.map(({ id }) => id).filter(Boolean);
    if (source === "affected") {
        const set = Object.values(beside)[0];
        return known.affected.filter(([number]) => set === undefined || number === set).map(([, descriptor]) => descriptor);
    }
    if (translate) return translate.filter(([, set]) => sets.includes(set)).map(([value]) => value);
    if (parameter.shown === "set") return known.affected ? [...new Set(known.affected.map(([set]) => set))] : sets;
    const type = protocol.types.get(parameter.type);
    if (type?.kind === "enum") {
        const only = parameter.variants?.find((one) => one.by === "device" && one.key === device?.id)?.only;
        const here = type.values.filter(({ name, value }) => value !== everything && (!only || only.includes(name)));
        return here.map(({ value }) => value);
    }
    const limit = device?.limits?.find(({ name }) => name === source)?.value;
    return limit === undefined ? undefined : Array.from({ length: limit }, (_, i) => i + 1);
}

function dataSetsOf(protocol, device) {
    const names = new Set(device?.supports?.map(({ field }) => field.split(".")[0]));
    const sets = protocol.model.sets.filter((set) => set.number >= FIRST_DATA_SET && set.number !== SHARED_SET);
    return sets.filter((set) => names.has(set.name)).map((set) => set.number);
}

/** A command that reads a setting, as a packet. */
function readingOf(protocol, field, selected) {
    const read = [...protocol.functions.values()].find(({ name }) => name === "read").value;
    return buildPacket(protocol, field.set, [{ name: field.name, values: { function: read, ...selected } }]);
}

/** The command that writes what was read, as a packet; undefined if the response lacks a part of it. */
function writingOf(protocol, field, selected, values) {
    const write = [...protocol.functions.values()].find(({ name }) => name === "write").value;
    const all = { function: write, ...selected };
    for (const name of callOf(field, "write").required) {
        const parameter = field.parameters.find((one) => one.name === name);
        if (name in all || parameter.counts || parameter.constant !== undefined) continue;
        if (parameter.reserved !== undefined) all[name] = parameter.reserved;
        else if (values[name] === undefined) return undefined;
        else all[name] = values[name];
    }
    return buildPacket(protocol, field.set, [{ name: field.name, values: all }]);
}

/**
 * Reads the settings of a device: an array of { command, packet }, the packet that writes it, in hexadecimal.
 *
 * @param ask sends a packet with one command and returns { accepted, response }, a response in bytes with its field
 */
export async function pull(protocol, device, ask, progress = () => {}) {
    const found = [];
    const commands = settingsOf(protocol, device);
    for (const [i, field] of commands.entries()) {
        progress(i / commands.length, field);
        const { instances, open } = instancesOf(protocol, device, field);
        for (const selected of instances) {
            const one = await readSetting(protocol, field, selected, ask);
            if (!one && open) break; // there are no more
            if (one) found.push({ command: field.name, packet: one });
        }
    }
    return found;
}

async function readSetting(protocol, field, selected, ask) {
    const { accepted, response } = await ask(readingOf(protocol, field, selected));
    if (!accepted || !response) return undefined;
    try {
        const { values } = decodeData(protocol, response.field, response.data);
        const packet = writingOf(protocol, field, selected, values);
        return packet && toHex(packet.bytes).toUpperCase();
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return undefined;
    }
}

/** The settings that a file has: an array of { field, packet, data }. Raises a MipError that says what is wrong. */
export function settingsIn(protocol, text, packetOf) {
    let held;
    try {
        held = JSON.parse(text);
    } catch {
        throw new MipError("format", "the file is not one that this page has saved");
    }
    if (!Array.isArray(held?.settings)) throw new MipError("format", "the file has no settings");
    return held.settings.map(({ packet }) => {
        const whole = packetOf(packet);
        const [raw, ...more] = [...whole.fields()];
        const field = protocol.choose(raw.set, raw.descriptor, raw.data);
        if (more.length || !field || !callOf(field, "save")) throw new MipError("format", `${packet} is not one setting`);
        return { field, packet: whole, data: raw.data };
    });
}

/** Settings of a file in the order in which they are written, without those that may end the connection. */
export function inOrder(protocol, settings) {
    const rank = ({ field }) => LAST.indexOf(facts(protocol, field.name).effect) + 1;
    return [...settings].sort((a, b) => rank(a) - rank(b));
}

export function endsTalk(protocol, field) {
    return LINK.includes(facts(protocol, field.name).effect);
}

/**
 * Writes the settings of a file that differ from those of the device. Returns { written, same, refused, left }, each an array
 * of the names of commands.
 */
export async function push(protocol, settings, ask, progress = () => {}) {
    const done = { written: [], same: [], refused: [], left: [] };
    const ordered = inOrder(protocol, settings);
    for (const [i, { field, packet, data }] of ordered.entries()) {
        progress(i / ordered.length, field);
        const name = nameIn(field, field.set);
        const { values } = decodeData(protocol, field, data);
        const selected = Object.fromEntries(callOf(field, "read").required.map((one) => [one, values[one]]));
        const now = await readSetting(protocol, field, selected, ask);
        if (now === toHex(packet.bytes).toUpperCase()) done.same.push(name);
        else if (endsTalk(protocol, field)) done.left.push(name);
        else done[(await ask(packet)).accepted ? "written" : "refused"].push(name);
    }
    return done;
}

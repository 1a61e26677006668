// Lists, reads and writes the settings of a device, one command after another, for a settings file.

import { decodeData, FIRST_DATA_SET, MipError, namedType, sameBytes, SHARED_SET } from "mip-protocol/tools";
import { certaintyOn, packetOf } from "./build.mjs";

/** Effects of settings that may end the connection; a file does not change these settings. */
const LINK = ["protocols", "communication_mode", "baud_rate"];

/** Settings with these effects are written last, in this order. */
const LAST = ["format", "sentences", "switch"];

/**
 * The number of times that settings are written again if the device has rejected them, or other settings have changed
 * them.
 */
const ROUNDS = 3;

/** The number of instances to read if the specification does not state it. */
const MOST = 8;

const facts = (protocol, name) => protocol.model.simulation?.behaviors?.find((one) => one.command === name) ?? {};
const callOf = (field, name) => field.calls?.find((call) => call.function === name);

/** Returns the commands that a device, or any device, may write, read and save. */
export function settingsOf(protocol, device) {
    return protocol.model.fields.filter(
        (field) =>
            field.role === "command" &&
            ["write", "read", "save"].every((name) => callOf(field, name)) &&
            parametersOf(field).length > keysOf(field).length &&
            !facts(protocol, field.name).once &&
            (!device || certaintyOn(protocol, device, field, field.set) !== undefined),
    );
}

/** Returns the parameters of a setting, without the function, derived and reserved ones. */
export function parametersOf(field) {
    return field.parameters.filter(
        ({ selector, counts, constant, reserved }) => !selector && [counts, constant, reserved].every((one) => one === undefined),
    );
}

/** Returns the parameters that select an instance: those that a save requires. */
export function keysOf(field) {
    const names = parametersOf(field).map(({ name }) => name);
    return callOf(field, "save").required.filter((name) => names.includes(name));
}

/**
 * Returns values for the parameters that select an instance: an array of objects. `open` is true if their number is not
 * known.
 */
export function instancesOf(protocol, device, field) {
    const known = facts(protocol, field.name);
    const selectors = keysOf(field);
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

/** Returns the values that select an instance; undefined if their number is not known. */
function valuesOf(protocol, device, parameter, known, beside) {
    const pairs = (of) => new Map(of ?? []);
    const source = pairs(known.instances).get(parameter.name);
    const everything = pairs(known.all).get(parameter.name);
    const numbers = pairs(known.translate).get(parameter.name);
    const translate = numbers && new Map(numbers);
    const sets = dataSetsOf(protocol, device);
    if (source === "ports" && device?.ports?.length) {
        const rated = device.ports.filter(({ baud_rates: rates }) => known.effect === "baud_rate" && rates?.length);
        return (rated.length ? rated : device.ports).map(({ id }) => id).filter((id) => id !== undefined);
    }
    const type = namedType(protocol, parameter, beside, device?.id);
    if (type?.kind === "enum") {
        const only = parameter.variants?.find((one) => one.by === "device" && one.key === device?.id)?.only;
        const values = type.values.filter(({ name, value }) => value !== everything && (!only || only.includes(name)));
        const here = values.map(({ value }) => value);
        return source === "data_sets" && sets.length ? here.filter((value) => sets.includes(translate?.get(value) ?? value)) : here;
    }
    if (source === "data_sets" && parameter.shown === "set") return sets;
    if (translate) return [...translate].filter(([, set]) => sets.includes(set)).map(([value]) => value);
    if (source === "affected") {
        const set = Object.values(beside)[0];
        const here = known.affected.filter(([number]) => set === undefined || number === set);
        return here.map(([, descriptor]) => descriptor).sort((a, b) => a - b);
    }
    if (parameter.shown === "set") return known.affected ? [...new Set(known.affected.map(([set]) => set))] : sets;
    const limit = device?.limits?.find(({ name }) => name === source)?.value;
    return limit === undefined ? undefined : Array.from({ length: limit }, (_, i) => i + 1);
}

function dataSetsOf(protocol, device) {
    const names = new Set(device?.supports?.map(({ field }) => field.split(".")[0]));
    const sets = protocol.model.sets.filter((set) => set.number >= FIRST_DATA_SET && set.number !== SHARED_SET);
    return sets.filter((set) => names.has(set.name)).map((set) => set.number);
}

const numberOf = (protocol, name) => [...protocol.functions.values()].find((one) => one.name === name).value;

/** Returns those of some values that a function requires, with reserved ones, and a form if there are several. */
function valuesFor(protocol, field, name, values) {
    const all = { function: numberOf(protocol, name) };
    for (const one of callOf(field, name).required) {
        const parameter = field.parameters.find((each) => each.name === one);
        if (parameter.counts || parameter.constant !== undefined) continue;
        const form = name === "read" ? (protocol.types.get(parameter.type)?.values?.[0].value ?? 0) : undefined;
        all[one] = values[one] ?? parameter.reserved ?? form;
        if (parameter.reserved !== undefined && typeof parameter.length === "number")
            all[one] = Array(parameter.length).fill(parameter.reserved);
        if (all[one] === undefined) return undefined;
    }
    return all;
}

const packet = (protocol, field, values) => packetOf(protocol, field.set, [{ field, values }]);

/** Returns the name that a command's parameter has in the response. */
function nameInResponse(protocol, response, name) {
    const source = protocol.model.simulation?.sources?.find((one) => one.field === response.name);
    return source?.values.find((one) => one.parameter === name)?.path ?? name;
}

/**
 * Reads one setting: { field, values, packet }, the values and the packet that write it; undefined if the device has
 * none.
 * @param ask sends a packet with one command and returns { accepted, response }, a response in bytes with its field
 */
async function readSetting(protocol, field, selected, ask) {
    const { accepted, response } = await ask(packet(protocol, field, valuesFor(protocol, field, "read", selected)));
    if (!accepted || !response) return undefined;
    try {
        const { values: told } = decodeData(protocol, response.field, response.data);
        const held = field.parameters.map(({ name }) => [name, told[nameInResponse(protocol, response.field, name)] ?? selected[name]]);
        const values = valuesFor(protocol, field, "write", Object.fromEntries(held));
        return values && { field, values, packet: packet(protocol, field, values) };
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return undefined;
    }
}

/**
 * Reads the settings of a device: an array of { field, values, packet }. Of several commands for one setting, it has
 * the one that keeps it, or the first that the device knows.
 */
export async function pull(protocol, device, ask, progress = () => {}) {
    const found = new Map(); // command -> its settings
    const all = settingsOf(protocol, device);
    const homeOf = ({ name }) => facts(protocol, name).setting ?? name;
    const [own, others] = [true, false].map((same) => all.filter((field) => (homeOf(field) === field.name) === same));
    const read = new Set();
    for (const [i, field] of [...own, ...others].entries()) {
        const view = `${homeOf(field)} ${JSON.stringify(facts(protocol, field.name).key ?? [])}`;
        if (read.has(homeOf(field)) || read.has(view)) continue;
        progress(i / all.length, field);
        const settings = await readInstances(protocol, device, field, ask);
        found.set(field, settings);
        if (settings.length) read.add(homeOf(field) === field.name ? field.name : view);
    }
    return all.flatMap((field) => found.get(field) ?? []);
}

async function readInstances(protocol, device, field, ask) {
    const found = [];
    const { instances, open } = instancesOf(protocol, device, field);
    for (const selected of instances) {
        const one = await readSetting(protocol, field, selected, ask);
        if (one) found.push(one);
        else if (open) break; // there are no more
    }
    return found;
}

/** Sorts settings in the order in which they are written. */
function inOrder(protocol, settings) {
    const rank = ({ field }) => LAST.indexOf(facts(protocol, field.name).effect) + 1;
    return [...settings].sort((a, b) => rank(a) - rank(b));
}

/**
 * Writes the settings of a file that differ from those of the device, and reads them back. Rejected ones are tried
 * again once others, on which they may depend, are written. Returns { written, same, refused, different, left }, arrays
 * of settings; `left` may end the connection and is not written. Raises a MipError, before anything is written, if the
 * device lacks a setting.
 */
export async function push(protocol, settings, ask, progress = () => {}) {
    const ordered = inOrder(protocol, settings);
    const differing = async (some, share) => {
        const found = { same: [], differ: [], absent: [] };
        for (const [i, one] of some.entries()) {
            progress(share(i / some.length), one.field);
            const now = await readSetting(protocol, one.field, one.values, ask);
            found[!now ? "absent" : sameBytes(now.packet.bytes, one.packet.bytes) ? "same" : "differ"].push(one);
        }
        return found;
    };
    const { same, absent, differ: changed } = await differing(ordered, (part) => 0.6 * part);
    if (absent.length) {
        const said = absent.map(({ field, place }) => `${place}: this device has no ${field.name} like this; remove it`);
        throw new MipError("format", said.join("\n"));
    }
    const left = changed.filter(({ field }) => LINK.includes(facts(protocol, field.name).effect));
    const open = new Set(changed.filter((one) => !left.includes(one)));
    const written = new Set();
    let differ = [];
    for (let round = 0; round < ROUNDS && open.size; round++) {
        const before = open.size;
        for (const one of open) {
            progress(0.6 + (0.3 * written.size) / (written.size + open.size), one.field);
            if (!(await ask(one.packet)).accepted) continue;
            written.add(one);
            open.delete(one);
        }
        ({ differ } = await differing([...written], (part) => 0.9 + 0.1 * part));
        for (const one of differ) open.add(one); // another one has changed it
        if (!differ.length && open.size === before) break;
    }
    const different = differ.filter((one) => written.has(one));
    const refused = [...open].filter((one) => !written.has(one));
    return { written: [...written].filter((one) => !different.includes(one)), same, refused, different, left };
}

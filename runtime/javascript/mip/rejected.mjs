// The field for which a device rejects a command: the rule of "Rejected fields" in the specification's README.

import { session } from "../session.mjs";
import { MipError } from "./bytes.mjs";
import { deviceWithNumber, Protocol } from "./model.mjs";
import { FIRST_DATA_SET, SHARED_SET } from "./packet.mjs";

export function rejections(model) {
    const protocol = new Protocol(model);
    const ports = new WeakMap(); // port -> what is known about the device there
    return async (device, command, port) => {
        const { SET: set, DESCRIPTOR: descriptor } = command.constructor;
        const sent = { set, descriptor, data: command.encode() };
        if (!listed(protocol, sent).length && !alternatives(protocol, sent).length) return undefined;
        if (!ports.has(port)) ports.set(port, await asked(protocol, device));
        return cause(protocol, sent, ports.get(port));
    };
}

/** Returns what a device answers. A list of which a part is missing shows nothing, so it is left out. */
async function asked(protocol, device) {
    const known = {};
    if (!session) return known;
    try {
        const numbers = session.modelNumbers(await device.request(session.identify()));
        known.device = numbers.map((text) => deviceWithNumber(protocol, text)).find(Boolean);
        const descriptors = new Set();
        for (const command of session.descriptors()) {
            const { SET, DESCRIPTOR } = command.constructor;
            if (descriptors.size && !descriptors.has(SET * 256 + DESCRIPTOR)) continue;
            for (const number of (await device.request(command)).descriptors) descriptors.add(number);
        }
        if (descriptors.size) known.descriptors = descriptors;
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
    }
    return known;
}

/** Returns the commands that do the same on devices that lack a command. */
function alternatives(protocol, { set, descriptor }) {
    const [command] = protocol.candidates(set, descriptor);
    return (command?.alternatives ?? []).flatMap((name) => protocol.fields.get(name) ?? []);
}

/** Returns the data that a command lists; descriptor 0 is a whole set. */
function listed({ model, fields }, { set: of, descriptor, data }) {
    const number = (at) => data[at] ?? 0;
    return model.lists.flatMap((list) => {
        const command = fields.get(list.command);
        const set = list.set ?? number(list.set_at);
        if (command.set !== of || command.descriptor !== descriptor || set < FIRST_DATA_SET) return [];
        if (list.tag_at !== undefined && number(list.tag_at) !== list.tag) return [];
        const count = list.count_at === undefined ? 1 : number(list.count_at);
        if (list.first === undefined || !count) return [{ list, set, descriptor: 0 }];
        return Array.from({ length: count }, (_, i) => {
            const at = list.first + i * (list.stride ?? 1);
            const by = at + list.decimation_at;
            const decimation = list.decimation_at === undefined ? undefined : number(by) * 256 + number(by + 1);
            return { list, set, descriptor: number(at), decimation };
        });
    });
}

/**
 * Returns the field for which a device rejected a command, or the command that it has instead, undefined if nothing
 * shows it: its index in the list, set, descriptor (0: the whole set), the reason in a word, and in words.
 *
 * @param known `device`: its profile in the model; `descriptors`: a Set of set * 256 + descriptor, listed by the device
 */
export function cause(protocol, command, known) {
    const found = listed(protocol, command);
    const profile = known.device && profileOf(protocol, known.device);
    const title = known.device?.title ?? "the device";
    const named = (item) => nameOf(protocol, item);
    const sends = ({ set, descriptor }) => {
        const own = known.descriptors ?? profile?.has ?? [];
        for (const key of own) if (key === set * 256 + descriptor || (!descriptor && key >> 8 === set)) return true;
        if (known.descriptors) return known.descriptors.has(SHARED_SET * 256 + descriptor);
        return profile?.support(set, descriptor);
    };
    const first = (reason, holds, text) => {
        const index = found.findIndex(holds);
        if (index < 0) return undefined;
        const { set, descriptor } = found[index];
        return { index, set, descriptor, reason, text: text(found[index]) };
    };
    const isUnknown = (item) => sends(item) === undefined;
    const isUndefined = ({ set, descriptor }) => descriptor && !protocol.candidates(set, descriptor).length;
    const sets = found.map(({ set }) => set);
    const fits = ({ name }) =>
        protocol.model.lists.every((list) => list.command !== name || list.set === undefined || sets.includes(list.set));
    const other = sends(command) === false && alternatives(protocol, command).find((one) => sends(one) && fits(one));
    if (other) {
        const { set, descriptor } = other;
        return { index: 0, set, descriptor, reason: "other_command", text: `${title} has ${named(other)} instead` };
    }
    return (
        first(
            "absent",
            (item) => sends(item) === false,
            (item) => `${title} ${profile?.absence(item.set, item.descriptor) ?? `does not send ${named(item)}`}`,
        ) ??
        first(
            "decimation",
            ({ decimation }) => decimation === 0,
            (item) => `the decimation of ${named(item)} is 0`,
        ) ??
        first(
            "too_many",
            ({ list }, i) => i >= list.most,
            ({ list }) => `${found.length} fields are listed, at most ${list.most} are possible`,
        ) ??
        first(
            "undefined",
            (item) => isUnknown(item) && isUndefined(item),
            ({ set, descriptor }) => `0x${hex(descriptor)} is not a field of ${nameOf(protocol, { set, descriptor: 0 })}`,
        ) ??
        first(
            "unlisted",
            (item) => profile && isUnknown(item),
            (item) => `${title} is not known to send ${named(item)}`,
        )
    );
}

const hex = (number) => number.toString(16).toUpperCase().padStart(2, "0");

function nameOf(protocol, { set, descriptor }) {
    const of = protocol.sets.get(set)?.name ?? `set 0x${hex(set)}`;
    if (!descriptor) return of;
    const field = protocol.candidates(set, descriptor)[0];
    const place = field?.occurrences?.find((one) => one.set === set);
    return place?.name ?? field?.name ?? `${of} 0x${hex(descriptor)}`;
}

/** What a profile states about data. */
function profileOf({ fields, model }, { supports = [], refuses = [], evidence = [], incomplete }) {
    const statements = new Map();
    const setOf = new Map(model.sets.map(({ name, number }) => [name, number]));
    for (const { field: name, evidence: index } of [...supports, ...refuses]) {
        const { descriptor } = fields.get(name);
        statements.set(setOf.get(name.slice(0, name.indexOf("."))) * 256 + descriptor, evidence[index]);
    }
    const whole = new Map(evidence.flatMap((one) => (one.sets ?? []).map((name) => [setOf.get(name), one])));
    const why = (set, descriptor) =>
        statements.get(set * 256 + descriptor) ?? whole.get(set) ?? statements.get(SHARED_SET * 256 + descriptor);
    return {
        has: [...statements].filter(([, { answer }]) => answer !== "no").map(([key]) => key),
        absence: (set, descriptor) => why(set, descriptor)?.absence,
        support(set, descriptor) {
            const answer = why(set, descriptor)?.answer;
            return answer ? answer !== "no" : incomplete?.length ? undefined : false;
        },
    };
}

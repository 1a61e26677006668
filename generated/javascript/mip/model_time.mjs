// For tools: the validity of values and the clocks that a model describes.

import { MipError, described } from "./bytes.mjs";
import { decodeData } from "./data.mjs";
import { placesOf } from "./model.mjs";
import { maskOf, parameterOf } from "./naming.mjs";
import { FIRST_DATA_SET, SHARED_SET } from "./packet.mjs";
import { clocksOf } from "./time.mjs";
import { validity } from "./validity.mjs";

const NANOSECONDS = { week: 604_800_000_000_000, s: 1e9, ms: 1e6, us: 1e3, ns: 1 };

const found = new WeakMap(); // field -> the function of its flags

export function isValid(protocol, field, values, name, device, seen) {
    if (!parameterOf(field, name.split("[")[0])) throw new MipError("unknown", `${field.name} has no parameter ${described(name)}`);
    return validityOf(protocol, field)(values, name, device, seen);
}

function validityOf(protocol, field) {
    if (!found.has(field)) {
        const usual = {};
        const others = [];
        for (const parameter of field.parameters) {
            const readings = parameter.readings ?? [{ flags: flagsOf(protocol, field, parameter) }];
            const holder = readings.flatMap(({ flags }) => flags)[0]?.parameter;
            const own = readings.map(({ flags }) => masksOf(parameter.name, flags, holder));
            for (const [holder, masks] of Object.entries(own.at(-1))) usual[holder] = { ...usual[holder], ...masks };
            for (const [i, { devices, fewer }] of readings.slice(0, -1).entries()) others.push([devices, fewer, holder, own[i]]);
        }
        found.set(field, validity(usual, others));
    }
    return found.get(field);
}

/** Returns the usual flags of a parameter, each with the parameter that contains it and its mask. */
function flagsOf(protocol, field, { valid }) {
    return (valid ?? []).map((path) => {
        const [parameter, bit] = path.split(".");
        const bits = bit && protocol.type(parameterOf(field, parameter).type).bits;
        return { parameter, mask: bit ? maskOf(bits.find(({ name }) => name === bit)) : 0 };
    });
}

/** Returns the masks by the parameter that contains the flags; none by the `usual` one for a value without flags. */
function masksOf(name, flags, usual) {
    if (!flags.length) return usual ? { [usual]: { [name]: [] } } : {};
    const holders = [...new Set(flags.map(({ parameter }) => parameter))];
    const of = (holder) => flags.map(({ parameter, mask }) => (parameter === holder ? mask : null));
    return Object.fromEntries(holders.map((holder) => [holder, { [name]: flags.length > 1 ? of(holder) : flags[0].mask }]));
}

export function clocksIn(protocol) {
    const { clocks, leap_seconds, units } = protocol.model;
    const timed = new Map(); // field -> the sets in which it is a timestamp, and its clocks, that of a valid time first
    for (const { name, timestamps } of [...clocks].sort((a, b) => (a.epoch === undefined) - (b.epoch === undefined))) {
        for (const full of timestamps) {
            const field = protocol.field(full);
            const one = timed.get(field) ?? { sets: new Set(), own: new Set() };
            one.sets.add(placesOf(field).find((place) => place.name === full).set);
            one.own.add(name);
            timed.set(field, one);
        }
    }
    const keyOf = (unit) => units.find(({ symbol }) => symbol === unit)?.key ?? unit;
    const timestamps = [...timed].map(([field, { sets, own }]) => {
        const scaleOf = ({ units: [unit, more] = [] }) => (more === undefined ? NANOSECONDS[keyOf(unit)] : undefined);
        return {
            descriptor: field.descriptor,
            occursIn(set) {
                const layouts = set < FIRST_DATA_SET ? [] : protocol.candidates(set, field.descriptor);
                return layouts.length === 1 && layouts[0] === field && (sets.has(set) || sets.has(SHARED_SET));
            },
            size: field.min_size,
            decode: ({ bytes }, from, to) => decodeData(protocol, field, bytes.subarray(from, to)).values,
            isValid: validityOf(protocol, field),
            parts: field.parameters.map((one) => [one.name, scaleOf(one)]).filter(([, scale]) => scale),
            clocks: [...own],
        };
    });
    return clocksOf(
        clocks.map(({ name, epoch }) => [name, epoch]),
        leap_seconds,
        timestamps,
    );
}

// Which flags mark a value as valid. They may be other bits on other devices.

import { bitsNumber } from "./naming.mjs";

/**
 * Returns a function that checks the flags of a value, "speed" or "velocity[0]". It takes the values, the name, and the
 * device's id; if that is undefined, the flags are those of the usual device, unless another one, which has fewer bits,
 * defines all that are set. `seen` are the values whose bits count: those of a whole log, combined.
 *
 * @param usual name of the value that contains flags -> name of a value -> mask, or an array with one for each element; the
 *   mask 0 denotes a Boolean
 * @param others devices with other flags, fewest bits first: ids, undefined bits (0: not fewer), the name of the value that
 *   contains the bits, and flags like `usual`
 */
export function validity(usual, others = []) {
    const isValid = (values, name, device, seen = values) => {
        const [whole, element] = name.split("[");
        const index = element && Number.parseInt(element, 10);
        const concerned = others.filter(([, , , flags]) => Object.values(flags).some((one) => one[whole] !== undefined));
        const own = device === undefined ? recognized(concerned, seen) : concerned.find(([devices]) => devices.includes(device));
        const flags = own?.[3] ?? usual;
        const present = element ? values[whole]?.[index] : values[whole];
        return (
            present !== undefined &&
            Object.entries(flags).every(([holder, masks]) => {
                const own = masks[whole] ?? null;
                const wanted = Array.isArray(own) ? (element ? [own[index] ?? null] : own) : [own];
                return wanted.every((mask) => mask === null || holds(values[holder], mask));
            })
        );
    };
    const holders = [...new Set(others.map(([, , holder]) => holder))];
    return Object.assign(isValid, { holders, devices: (seen) => recognized(others, seen)?.[0] });
}

/** Returns the devices with fewer bits that define all that are set. */
function recognized(others, seen) {
    return others.find(([, bits, holder]) => bits && seen[holder] !== undefined && !common(seen[holder], bits));
}

const common = (value, mask) => bitsNumber(value) & BigInt(mask);

function holds(value, mask) {
    return value !== undefined && (mask ? common(value, mask) === BigInt(mask) : Boolean(value));
}

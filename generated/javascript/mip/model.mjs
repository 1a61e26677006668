// For tools: finds the parts of the protocol's model, mip.json, by name and by descriptor.

import { MipError, bytesOf, described } from "./bytes.mjs";
import { modelNumber } from "./naming.mjs";
import { FIRST_DATA_SET, SHARED_SET } from "./packet.mjs";

/** The major version of mip.json's format that this code supports. */
export const FORMAT = "1";

export class Protocol {
    /** @param model the parsed mip.json */
    constructor(model) {
        const format = model?.format;
        if (typeof format !== "string" || format.split(".")[0] !== FORMAT) {
            throw new MipError("format", `the model has format ${described(format)}; this code supports ${FORMAT}`);
        }
        for (const part of ["packet", "scalars", "fields", "types", "sets", "functions", "acknowledge"]) {
            if (!model[part]) throw new MipError("format", `the model has no "${part}"`);
        }
        this.model = model;
        this.maxPayload = model.packet.max_payload;
        this.maxFieldData = model.packet.max_field_data;
        this.fields = byKey(model.fields, "name");
        for (const field of model.fields) for (const place of placesOf(field)) this.fields.set(place.name, field);
        this.types = byKey(model.types, "name");
        this.sets = byKey(model.sets, "number");
        this.functions = byKey(model.functions, "value");
        this.acknowledge = this.field(model.acknowledge);
        this.layouts = new Map();
        for (const field of model.fields) {
            for (const { set } of placesOf(field)) {
                const key = set * 256 + field.descriptor;
                this.layouts.set(key, [...(this.layouts.get(key) ?? []), field]);
            }
        }
    }

    field(name) {
        return found(this.fields, name, "field");
    }

    /** Finds a type by its name: an enumeration, a bitfield, a vector or a structure. */
    type(name) {
        return found(this.types, name, "type");
    }

    scalar(name) {
        return this.model.scalars[name];
    }

    candidates(set, descriptor) {
        if (set < FIRST_DATA_SET && descriptor === this.acknowledge.descriptor) return [this.acknowledge];
        const own = this.layouts.get(set * 256 + descriptor);
        const shared = set >= FIRST_DATA_SET ? this.layouts.get(SHARED_SET * 256 + descriptor) : undefined;
        return own ?? shared ?? [];
    }

    /** Chooses the layout of data by its constants, as far as present, then by its size; undefined if none fits. */
    choose(set, descriptor, given) {
        const data = bytesOf(given);
        const layouts = this.candidates(set, descriptor);
        if (layouts.length < 2) return layouts[0];
        const fitting = layouts.filter((field) => (field.constants ?? []).every((constant) => agrees(constant, data)));
        const held = fitting.filter((field) => field.min_size <= data.length);
        const best = (fields, better) => fields.reduce((a, b) => (better(b.min_size, a.min_size) ? b : a), fields[0]);
        return held.length ? best(held, (a, b) => a > b) : best(fitting, (a, b) => a < b);
    }

    /** Returns the number of required parameters, without the function selector; an unknown function requires none. */
    required(field, selector) {
        if (!field.calls) return field.parameters.filter((parameter) => !parameter.optional).length;
        const name = this.functions.get(Number(selector))?.name;
        return field.calls.find((call) => call.function === name)?.required.length ?? 0;
    }
}

export function deviceWithNumber({ model }, number) {
    const digits = modelNumber(number);
    return digits && model.devices?.find((device) => device.model_number === digits);
}

export function placesOf(field) {
    return field.occurrences ?? [{ set: field.set, name: field.name }];
}

/** Returns the full name of a field in a set: "gnss_2.dop". A field that occurs in every set has only one name. */
export function nameIn(field, set) {
    return placesOf(field).find((place) => place.set === set)?.name ?? field.name;
}

function byKey(things, key) {
    return new Map(things.map((thing) => [thing[key], thing]));
}

function found(things, name, what) {
    const thing = things.get(name);
    if (!thing) throw new MipError("unknown", `there is no ${what} ${described(name)}`);
    return thing;
}

function agrees(constant, data) {
    for (let i = 0; i < constant.size && constant.offset + i < data.length; i++) {
        const byte = Number((BigInt(constant.value) >> BigInt(8 * (constant.size - 1 - i))) & 0xffn);
        if (data[constant.offset + i] !== byte) return false;
    }
    return true;
}

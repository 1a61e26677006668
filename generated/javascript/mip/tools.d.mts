// The interface for tools, without classes: the protocol's model, and values by their names in the specification.

import type { Bytes, Clock, MipError, Packet, RawField } from "./index.mjs";

export { checksum, fromHex, MipError, Packet, Parser, segments, Times, toHex } from "./index.mjs";

/** An object of mip.json, described by its README and schema. */
export type Item = { readonly [name: string]: any };
/** Values of a field by their names in the specification. */
export type Plain = { [name: string]: any };
/** A value that is not divided further: its path, its operation, and the position of its bytes in the data. */
export interface Part {
    path: (string | number)[];
    operation: Item;
    value: unknown;
    offset: number;
    size: number;
}
export interface Options {
    /** Every float is the text of its bits, "0x3e7a63a0". */
    floatBits?: boolean;
}

/** Descriptor set of the fields that are valid in every data set. */
export declare const SHARED_SET: 255;
/** The lowest number of a data set; command sets are below. */
export declare const FIRST_DATA_SET: 128;
/** May a packet have this descriptor set? */
export declare function isSet(number: number): boolean;
/** Are a Number and a BigInt the same number? */
export declare function isSame(a: unknown, b: unknown): boolean;
export declare function sameBytes(a: Uint8Array, b: Uint8Array): boolean;
/** Decodes a float; a NaN with unusual bits becomes the text of its bits, "0x7fe5bf7f". */
export declare function readFloat(bytes: Uint8Array): number | string;
export declare function writeFloat(value: number | string, size: 4 | 8, what: string): Uint8Array;

export declare class Protocol {
    /** @param model the parsed mip.json, or the module `mip-protocol/model` */
    constructor(model: Item);
    readonly model: Item;
    readonly fields: Map<string, Item>;
    readonly types: Map<string, Item>;
    readonly sets: Map<number, Item>;
    readonly functions: Map<number, Item>;
    readonly acknowledge: Item;
    /** Finds a field by its name, "3dm.pps_source_control", or its name in one of its sets, "gnss_2.dop". */
    field(name: string): Item;
    type(name: string): Item;
    scalar(name: string): Item;
    /** Returns the layouts that a descriptor may have in a packet of this set. */
    candidates(set: number, descriptor: number): Item[];
    /** Chooses the layout of data; undefined if none fits. */
    choose(set: number, descriptor: number, data: Bytes): Item | undefined;
    /** Returns the number of required parameters, without the function selector. */
    required(field: Item, selector?: number): number;
}
/** Returns the device with a model number: 6292, or "6292-4270"; undefined if there is none. */
export declare function deviceWithNumber(protocol: Protocol, number: number | string): Item | undefined;
/** Returns the sets in which a field occurs, with its name in each. */
export declare function placesOf(field: Item): { set: number; name: string }[];
/** Returns the full name of a field in a set: "gnss_2.dop". */
export declare function nameIn(field: Item, set: number): string;
/** Converts the name of a parameter or a function to that of a member or a constructor: "scaled_accel" to "scaledAccel". */
export declare function memberName(words: string): string;

export declare function decodeData(protocol: Protocol, field: Item, data: Bytes, options?: Options): { values: Plain; trailing: number };
export declare function encodeData(protocol: Protocol, field: Item, values: Plain): Uint8Array;
export declare function partsOf(protocol: Protocol, field: Item, values: Plain): Part[];
/** Returns the fields of a packet with their values and parts; the error of a malformed field is the last entry. */
export declare function decodePacket(
    protocol: Protocol,
    packet: Packet,
    options?: Options,
): (Partial<RawField> & { field?: Item; values?: Plain; trailing?: number; parts?: Part[]; error?: MipError })[];
/** Builds a packet from fields: `{ name, values }`, or `{ descriptor, raw }`. */
export declare function buildPacket(
    protocol: Protocol,
    set: number,
    fields: readonly ({ name: string; values: Plain; descriptor?: number } | { descriptor: number; raw: Bytes | string })[],
): Packet;

/**
 * Is a value valid, as its flags say? One without flags is, unless it is absent.
 *
 * @param values the values of the field
 * @param name the parameter, or an element: "velocity[0]"
 * @param device the id of the device, on which the flags may depend; if it is undefined, they are recognized by the bits
 *   that are set
 * @param seen the values whose bits count for that, if not these
 */
export declare function isValid(protocol: Protocol, field: Item, values: Plain, name: string, device?: string, seen?: Plain): boolean;
/** Returns the clocks of timestamps, the preferred ones first. */
export declare function clocksIn(protocol: Protocol): Clock[];

export declare function parameterOf(record: Item, name: string): Item | undefined;
export declare function parametersAt(protocol: Protocol, field: Item, path: Part["path"]): { parameter: Item; record: Item }[];
export declare function valueAt(values: Plain, path: Part["path"]): unknown;
export declare function namedType(protocol: Protocol, parameter: Item, siblings?: Plain, device?: string): Item | undefined;
export declare function measuredHere(protocol: Protocol, parameter: Item, siblings?: Plain, device?: string): Item;
export declare function enumValue(type: Item, number: number | bigint): Item | undefined;
export declare function bitsNumber(value: number | bigint | number[]): bigint;
export declare function maskOf(bits: Item): bigint;
/** @param values those of the record: bits that mean nothing in its state are left out, and remain in `rest` */
export declare function bitsOf(
    protocol: Protocol,
    type: Item,
    value: number | bigint | number[],
    values?: Plain,
): { found: { bits: Item; value: bigint; flag: boolean; named?: Item }[]; rest: bigint };
export declare function unitOf(parameter: Item, index?: number): string;
/** Returns the decimation of a base rate for the nearest rate that a device supports; 1 for 0 Hz, the highest. */
export declare function decimation(base: number, wanted: number): number;

// The interface for tools, without classes: the model of the protocol, and values by the names of the specification.

import type { Bytes, MipError, Packet, RawField } from "./index.mjs";

export { checksum, fromHex, MipError, Packet, Parser, segments, toHex } from "./index.mjs";

/** An object of mip.json, described by its README and schema. */
export type Item = { readonly [name: string]: any };
/** Values of a field by the names of the specification. */
export type Plain = { [name: string]: any };
/** A value that is not divided further: its path, its operation, and where its bytes are in the data. */
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
/** Data sets have this number or a larger one; below are command sets. */
export declare const FIRST_DATA_SET: 128;
/** May a packet have this descriptor set? */
export declare function isSet(number: number): boolean;
export declare function sameBytes(a: Uint8Array, b: Uint8Array): boolean;
/** The number of a float; a NaN with other bits than the usual one is the text of its bits, "0x7fe5bf7f". */
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
    /** A field by its name, "3dm.pps_source_control", or by its name in one of its sets, "gnss_2.dop". */
    field(name: string): Item;
    type(name: string): Item;
    scalar(name: string): Item;
    /** The layouts that a descriptor may have in a packet of this set. */
    candidates(set: number, descriptor: number): Item[];
    /** The layout of these data; undefined if there is none. */
    choose(set: number, descriptor: number, data: Bytes): Item | undefined;
    /** The number of required parameters, without the function selector. */
    required(field: Item, selector?: number): number;
}
/** The sets in which a field occurs, with its name in each. */
export declare function placesOf(field: Item): { set: number; name: string }[];
/** The full name of a field in a set: "gnss_2.dop". */
export declare function nameIn(field: Item, set: number): string;
/** "scaled_accel" -> "scaledAccel": a parameter as a member of objects, or a function as a constructor. */
export declare function memberName(words: string): string;

export declare function decodeData(protocol: Protocol, field: Item, data: Bytes, options?: Options): { values: Plain; trailing: number };
export declare function encodeData(protocol: Protocol, field: Item, values: Plain): Uint8Array;
export declare function partsOf(protocol: Protocol, field: Item, values: Plain): Part[];
/** The fields of a packet with their values and parts; a wrong length is the last entry. */
export declare function decodePacket(
    protocol: Protocol,
    packet: Packet,
    options?: Options,
): (Partial<RawField> & { field?: Item; values?: Plain; trailing?: number; parts?: Part[]; error?: MipError })[];
/** A packet of fields: `{ name, values }`, or `{ descriptor, raw }`. */
export declare function buildPacket(
    protocol: Protocol,
    set: number,
    fields: readonly ({ name: string; values: Plain; descriptor?: number } | { descriptor: number; raw: Bytes | string })[],
): Packet;

export declare function parameterOf(record: Item, name: string): Item | undefined;
export declare function parametersAt(protocol: Protocol, field: Item, path: Part["path"]): { parameter: Item; record: Item }[];
export declare function valueAt(values: Plain, path: Part["path"]): unknown;
export declare function namedType(protocol: Protocol, parameter: Item, siblings?: Plain, device?: string): Item | undefined;
export declare function measuredHere(protocol: Protocol, parameter: Item, siblings?: Plain, device?: string): Item;
export declare function enumValue(type: Item, number: number | bigint): Item | undefined;
export declare function bitsNumber(value: number | bigint | number[]): bigint;
export declare function maskOf(bits: Item): bigint;
export declare function bitsOf(
    protocol: Protocol,
    type: Item,
    value: number | bigint | number[],
): { found: { bits: Item; value: bigint; flag: boolean; named?: Item }[]; rest: bigint };
export declare function unitOf(parameter: Item, index?: number): string;
/** The number by which a base rate is divided for the nearest rate that a device can send; 1 for 0 Hz, the highest. */
export declare function decimation(base: number, wanted: number): number;

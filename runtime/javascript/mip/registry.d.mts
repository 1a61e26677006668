// Finds the class of a field by its descriptor or its name.

import type { Field, FieldClass, Packet, RawField } from "./index.mjs";

export declare class Registry {
    /** All fields. */
    readonly fields: FieldClass[];
    /** Finds the class with this name in the specification, "sensor.scaled_accel"; undefined if there is none. */
    field(name: string): FieldClass | undefined;
    /** Returns the classes that a descriptor may have in a packet of this set. */
    types(set: number, descriptor: number): FieldClass[];
    /** Returns the class that fits a field's data; undefined if there is none. */
    typeOf(set: number, descriptor: number, data: Uint8Array): FieldClass | undefined;
    /**
     * Decodes the fields of a packet. An unknown field stays a RawField, and so does one that cannot be decoded, with the
     * MipError as its `error`. A malformed field ends the list.
     */
    decode(packet: Packet): (Field | RawField)[];
}

// Finds the class of a field by its descriptor or its name.

import type { Field, FieldClass, Packet, RawField } from "./index.mjs";

export declare class Registry {
    /** All fields. */
    readonly fields: FieldClass[];
    /** The class of a name of the specification, "sensor.scaled_accel"; undefined if there is none. */
    field(name: string): FieldClass | undefined;
    /** The classes that a descriptor may have in a packet of this set. */
    types(set: number, descriptor: number): FieldClass[];
    /** The class of these data of a field; undefined if there is none. */
    typeOf(set: number, descriptor: number, data: Uint8Array): FieldClass | undefined;
    /**
     * The fields of a packet, decoded. One that is not known is a RawField, and so is one that cannot be decoded, with
     * the MipError as `error`; a wrong length ends the list.
     */
    decode(packet: Packet): (Field | RawField)[];
}

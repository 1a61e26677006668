// The MIP protocol in JavaScript: what every program uses. Fields are in modules of their own, one for each set.

import type { ClockName, Identity } from "../session.mjs";

/** Bytes that functions accept. */
export type Bytes = Uint8Array | ArrayBuffer;

/** The class of all errors of the package. */
export declare class MipError extends Error {
    constructor(kind: string, message: string, details?: object);
    /**
     * The error in one word. For data: "truncated", "count", "constant"; for values: "missing", "range", "unknown", "tag",
     * "count", "length", "set"; for packets: "sync", "length", "checksum", "field_length"; for a device: "refused",
     * "timeout", "missing_response", "closed", "no_device", "rate", "timestamp", "session".
     */
    readonly kind: string;
    /** The command, for "refused" and "timeout". */
    readonly command?: Command;
    /** The acknowledge code, for "refused". */
    readonly code?: number;
    /** The field that is to blame, for "refused", if the device has the option `explain`. */
    readonly rejected?: Rejected;
}

/** The field for which a device rejected a command that lists fields. */
export interface Rejected {
    /** Its index in the list. */
    index: number;
    set: number;
    /** 0 for the whole set. */
    descriptor: number;
    reason: "absent" | "decimation" | "other_command" | "too_many" | "undefined" | "unlisted";
    /** "3DM-CV7-AR has no GNSS receiver" */
    text: string;
}

/** Computes a packet's two checksum bytes from all bytes before them. */
export declare function checksum(bytes: Bytes): Uint8Array;
/** Converts bytes to hexadecimal text: "7565", or with a separator "75 65". */
export declare function toHex(bytes: Bytes, between?: string): string;
/** Converts pairs of hexadecimal digits to bytes; white space, "-" or ":" may separate the pairs. Throws "hex". */
export declare function fromHex(text: string): Uint8Array;

// ---------------------------------------------------------------------------------------------------- named numbers

declare const named: unique symbol;
/** A named number type: it accepts plain numbers, but not numbers of another named type. */
export type Flavor<T, Name extends string> = T & { readonly [named]?: Name };

/** An open enumeration: its names are properties with their numbers. Numbers without a name can be received and sent. */
export interface Enumeration<T> {
    /** Returns the name of a number; undefined if it has none. */
    nameOf(value: T): string | undefined;
}

/** A bitfield: its names are properties with their masks. */
export interface Bitfield<T> {
    /** Is a flag set? If the mask has several bits: is any of them set? */
    has(value: T, flag: T): boolean;
    /** Returns the number in the bits with this name. */
    get(value: T, name: Exclude<keyof this, keyof Bitfield<T>>): number;
    /** Returns the names of the flags that are set. */
    namesOf(value: T): string[];
}

// ---------------------------------------------------------------------------------------------------- fields

/** The class of a field; `Field` describes its members. */
export interface FieldClass<F extends Field = Field> {
    new (values: never): F;
    readonly NAME: string;
    readonly SET: number;
    readonly SETS: { includes(set: number): boolean };
    readonly DESCRIPTOR: number;
    readonly ROLE: "command" | "response" | "data";
    occursIn(set: number): boolean;
    matches(data: Uint8Array): boolean;
}

/** The argument of a constructor: the members of the object. */
export type Values<F, Unneeded extends PropertyKey = never> = Omit<F, keyof Command | Unneeded> & Partial<Pick<F, Unneeded & keyof F>>;

/** One field: a command, a response or data. */
export declare class Field {
    /** Its name in the specification: "base.ping". */
    static readonly NAME: string;
    /** The only descriptor set in which it occurs; undefined if there are several. */
    static readonly SET: number;
    static readonly SETS: { includes(set: number): boolean };
    static readonly DESCRIPTOR: number;
    static readonly ROLE: "command" | "response" | "data";
    static occursIn(set: number): boolean;
    /** Can this be the field's data? Checks what distinguishes a descriptor's layouts: constants and size. */
    static matches(data: Uint8Array): boolean;
    /** Decodes a field's data; bytes left over are not an error. Throws a MipError. */
    static decode<F extends Field>(this: new (values: never) => F, data: Bytes): F;
    /** Like `decode`, but also returns the number of bytes left over, which newer devices may send. */
    static decodeWithTrailing<F extends Field>(this: new (values: never) => F, data: Bytes): { field: F; trailing: number };
    /** Makes a field from what `toJSON` returned. Throws a MipError. */
    static fromJSON<F extends Field>(this: new (values: never) => F, values: object): F;
    /**
     * Returns its values as JSON can contain them: an integer of more than four bytes as a decimal text, a float that JSON
     * lacks, such as a NaN, as the text of its bits, "0x7fc00000". Throws a MipError if it cannot be encoded.
     */
    toJSON(): { [name: string]: unknown };
    /** The set of the packet that contained it, or the only set in which it occurs; undefined if unknown. */
    get set(): number | undefined;
    /**
     * Is a value valid, as its flags say? One without flags is, unless it is absent.
     *
     * @param name the member, or an element: "velocity[0]"
     * @param device the id of the device, "3dm-gx5-15", on which the flags may depend; if it is undefined, they are
     *   recognized by the bits that are set
     */
    isValid(name: string, device?: string): boolean;
    /** Encodes the field's data, without length and descriptor. Throws a MipError. */
    encode(): Uint8Array;
    /** Makes a packet with only this field, in the set that contained it or in `set`. Throws a MipError. */
    packet(set?: number): Packet;
}

/** A field that a device sends as data. */
export declare class Data extends Field {
    #data: true;
}

/** A field with which the device answers a command, after the acknowledge. */
export declare class Response extends Field {
    #response: true;
}

declare const answer: unique symbol;

/** A field that the device acknowledges, with a response of type R or without one. */
export declare class Command<R extends Response | undefined = Response | undefined> extends Field {
    readonly [answer]?: R;
    /** The types of its responses. */
    static readonly RESPONSES: FieldClass<Response>[];
    /** The time-out in seconds, if the device may take longer than usual. */
    static readonly TIMEOUT?: number;
    /** Does the device acknowledge the command with these values? */
    get answered(): boolean;
    /** The types of the response that it requests with these values; layouts may differ by device. */
    get replies(): FieldClass<Response>[];
}

/** Makes a packet with these fields. Each must occur in the set, which may be omitted if one of them occurs in no other. Throws a MipError. */
export declare function packetOf(fields: readonly Field[], set?: number): Packet;

// ---------------------------------------------------------------------------------------------------- packets

/** An undecoded field of a packet. */
export declare class RawField {
    readonly set: number;
    readonly descriptor: number;
    readonly data: Uint8Array;
    /** Its offset in the packet. */
    readonly offset: number;
    /** The reason why `registry.decode` could not decode it. */
    readonly error?: MipError;
}

export declare class Packet {
    /** Checks that bytes are a whole packet. Throws a MipError: "sync", "length" or "checksum". */
    static from(bytes: Bytes): Packet;
    /** Builds a packet from encoded fields. Throws a MipError if they do not fit. */
    static build(set: number, fields: readonly { descriptor: number; data: Uint8Array }[]): Packet;
    /** Wraps bytes in the form of a packet without checking them. */
    constructor(bytes: Uint8Array);
    readonly bytes: Uint8Array;
    /** Its descriptor set. */
    readonly set: number;
    get payload(): Uint8Array;
    get checksum(): Uint8Array;
    /** The correct checksum. */
    get rightChecksum(): Uint8Array;
    /** Is the checksum correct? */
    get sound(): boolean;
    /** For a packet from a device: when it arrived, in seconds since 1970 by this computer's clock. */
    readonly arrival?: number;
    /** For a packet from a device: the id of its model, if `device.model` was known when it arrived. */
    readonly model?: string;
    /**
     * Returns its time by a clock of `mip-protocol/time`, in nanoseconds: since 1970 in UTC if the clock has a date,
     * otherwise since the clock's start. It is null if that is not valid, and undefined if the packet has none. A time of
     * week that is not valid as a date is the time of a clock without one.
     *
     * @param device the id of the device, on which valid flags may depend: `model`, if that is known; `Times` is for logs of
     *   devices that are not known
     */
    time(clock: Clock, device?: string): bigint | null | undefined;
    /** Yields the fields; throws "field_length" at a malformed one. */
    fields(): Generator<RawField, void, undefined>;
    /** Returns the first field of a type; undefined if there is none. Throws a MipError if it cannot be decoded. */
    find<F extends Field>(kind: FieldClass<F>): F | undefined;
    /** Returns the fields of a type, in order. Throws a MipError if one cannot be decoded. */
    findAll<F extends Field>(kind: FieldClass<F>): F[];
}

/** A clock of timestamps, from `mip-protocol/time`. */
export declare class Clock {
    private constructor();
    /** Its name in the specification: "gps". */
    readonly name: string;
    /** Are its times in UTC? Otherwise, they count from its start. */
    readonly dated: boolean;
    /** Converts nanoseconds since its epoch to UTC, since 1970. A leap second becomes the second after it. */
    utc(time: bigint): bigint;
}

/** The times of a device's packets. How valid flags are read is recognized by those of all packets so far. */
export declare class Times {
    /** @param options.device the id of the device, if it is known */
    constructor(options?: { device?: string });
    /** Did later flags change how those before them are read? Then set it to false, and read a log again with this object. */
    changed: boolean;
    /** The ids of the devices whose flags were recognized; undefined if the usual ones, or those of a named device, hold. */
    readonly recognized: readonly string[] | undefined;
    /** Returns the time of a packet by a clock, like `packet.time`. */
    time(packet: Packet, clock: Clock): bigint | null | undefined;
}

/** Finds packets in a stream that may also contain other data, and arrives in pieces of any size. */
export declare class Parser {
    /** @param options.onSkipped is called with bytes that are not part of a packet, in order with the packets */
    constructor(options?: { onSkipped?: (bytes: Uint8Array) => void });
    /** The number of bytes so far that are not part of a packet. */
    readonly skipped: number;
    /** Returns the packets that these bytes, which are copied, complete. */
    feed(bytes: Bytes): Packet[];
    /** Ends the stream: returns the packets within an incomplete one. */
    flush(): Packet[];
    /** Discards an incomplete packet if a whole packet begins within it, because it was noise. */
    lookBehind(): Packet[];
}

/**
 * Divides bytes into segments, in order. "damaged" is a packet with a wrong checksum whose fields end exactly where it
 * does, and "incomplete" the beginning of a packet at the end. Neither hides a whole packet.
 */
export declare function segments(bytes: Bytes): {
    kind: "packet" | "damaged" | "incomplete" | "other";
    offset: number;
    bytes: Uint8Array;
}[];

// ---------------------------------------------------------------------------------------------------- commands

/** The device has answered a command. */
export interface Answer {
    type: "answer";
    command: Command;
    accepted: boolean;
    /** The acknowledge code: 0 if the command was accepted, otherwise the reason why it was rejected. */
    code: number;
    response?: Response;
    /** The reason why there is no response: the device sent none ("missing_response"), or one that cannot be decoded. */
    error?: MipError;
    /** The undecoded response. */
    raw?: RawField;
    /** The field that is to blame for a rejection, if the device has the option `explain`. */
    rejected?: Rejected;
}

/** The device has not answered in time. */
export interface TimedOut {
    type: "timedOut";
    command: Command;
}

/** A packet with fields that do not answer a command: data, or an unexpected reply. */
export interface Received {
    type: "received";
    packet: Packet;
    /** The fields that do not answer a command, up to a malformed one. */
    fields: RawField[];
    /** The error of a malformed field. */
    error?: MipError;
}

/** The port was lost before the command was answered. */
export interface Closed {
    type: "closed";
    command: Command;
    message: string;
}

export type ClientEvent = Answer | TimedOut | Received;

/**
 * The command client, without input or output. Times are in seconds by any clock that does not jump.
 *
 * After a command that was not answered, a barrier precedes the next ones: a packet of several commands that change
 * nothing. Replies that arrive before the barrier's are events like data, and are not matched to commands after it.
 */
export declare class Client {
    /** @param options.timeout seconds until a command times out, unless the specification states more for it */
    constructor(options?: { timeout?: number; onSkipped?: (bytes: Uint8Array) => void });
    /** The commands that wait for a reply, oldest first. */
    get pending(): Command[];
    /** The number of received bytes that are not part of a packet. */
    get skipped(): number;
    /** The time at which the next command times out; undefined if none waits. */
    get deadline(): number | undefined;
    /**
     * Returns the bytes to send: one packet with these commands, all of one set, preceded by a barrier if an earlier
     * command was not answered. If they cannot be encoded, throws a MipError and waits for nothing.
     *
     * @param options.timeout seconds for these commands, instead of their usual time-outs
     * @param options.wait false to expect no replies; any that arrive are events, like data
     */
    send(commands: readonly Command[], now: number, options?: { timeout?: number; wait?: boolean }): Uint8Array;
    /** Processes received bytes. Returns the events up to now: answers, other packets, time-outs. */
    receive(bytes: Bytes, now: number): ClientEvent[];
    /** Returns the commands that have timed out, and other events. */
    poll(now: number): ClientEvent[];
    /** Discards an incomplete packet if a whole packet begins within it. Call this when nothing has arrived for a while. */
    lookBehind(now: number): ClientEvent[];
    /** Discards an incomplete packet, for example at the end of a file, and searches its bytes. */
    flush(now: number): ClientEvent[];
    /**
     * Stops waiting for this command. A late reply to it is not matched to another one.
     *
     * @param options.silent true if the device does not reply to it
     */
    cancel(command: Command, options?: { silent?: boolean }): void;
    /**
     * Handles a lost connection: waiting commands time out, and an incomplete packet is discarded. Replies that still
     * arrive over the next connection are not matched to later commands.
     */
    interrupt(): ClientEvent[];
}

// ---------------------------------------------------------------------------------------------------- a device

/** The connection to a device, which transports the bytes. */
export interface Port {
    /** Yields the bytes that arrive; ends when the port is lost. */
    bytes(): AsyncIterable<Uint8Array>;
    write(bytes: Uint8Array): void | Promise<void>;
    close(): void | Promise<void>;
}

export interface DeviceOptions {
    /** Seconds until a command times out, 1 by default, unless the specification states more for it. */
    timeout?: number;
    /** The number of packets that can wait to be read; beyond that, the oldest are dropped. */
    capacity?: number;
    /** Called with all bytes that arrive, to record them. */
    onBytes?: (bytes: Uint8Array) => void;
    /** Called with bytes that are not part of a packet. */
    onSkipped?: (bytes: Uint8Array) => void;
    /** Finds the field for which the device rejected a command, for the error: `rejections(model)` of `mip-protocol/rejected`. */
    explain?: (device: Device, command: Command, port: Port) => Promise<Rejected | undefined>;
}

type Answers<C extends readonly Command[]> = { -readonly [I in keyof C]: C[I] extends Command<infer R> ? R : never };

/** A device at a port. Iterate over it to read its data: `for await (const packet of device)`. */
export declare class Device implements AsyncIterable<Packet> {
    private constructor();
    /** @param open opens the port, and is called again by `reopen` */
    static open(open: () => Promise<Port>, options?: DeviceOptions): Promise<Device>;
    /** Is the port closed or lost? Data that has arrived can still be read. */
    get closed(): boolean;
    /** The number of packets that were dropped because they were not read in time. */
    readonly dropped: number;
    /** The number of bytes that are not part of a packet. */
    get skipped(): number;
    /** The number of packets that can be read without waiting. */
    get waiting(): number;
    /**
     * The id of the device's model, such as "3dm-gx5-25", as which `packet.time` reads flags; undefined if it is not known.
     * It is known from the device's answer to `identify`, which `stream` also asks for, or if you set it.
     */
    model: string | undefined;
    /**
     * Sends a command, waits for the reply and returns the response; undefined if it has none.
     *
     * Throws a MipError: "refused" (with `code`), "timeout", "missing_response", "closed", or why the response cannot be
     * decoded; and, before anything is sent, why the command cannot be encoded.
     *
     * @param options.timeout seconds to wait for this command
     */
    request<R extends Response | undefined>(command: Command<R>, options?: { timeout?: number }): Promise<R>;
    /** Sends commands of one set in one packet and returns the response of each. Throws the error of the first that fails. */
    requestAll<const C extends readonly Command[]>(commands: C, options?: { timeout?: number }): Promise<Answers<C>>;
    /** Like `requestAll`, but returns all outcomes, even of failed commands; undefined for one that is never acknowledged. */
    exchange(commands: readonly Command[], options?: { timeout?: number }): Promise<(Answer | TimedOut | Closed | undefined)[]>;
    /** Sends commands of one set in one packet and does not wait for replies, which are treated as data. */
    send(...commands: Command[]): Promise<void>;
    /** Writes bytes that are not commands, such as RTCM corrections. Throws a MipError: "closed". */
    write(bytes: Uint8Array): Promise<void>;
    /** Sets the device to idle and returns its identity: the response of the command for that. */
    identify(): Promise<Identity>;
    /**
     * Starts streaming: `stream([[ScaledAccel, 100], [ScaledGyro, 100]])`. Rates are in Hz; 0 is the highest that the device
     * supports. Replaces the set's message format, discards its packets that have not been read yet, enables its stream and
     * resumes. Returns the rates. Adds the first timestamp that the device accepts, as often as the most frequent field, unless
     * `rates` has one.
     *
     * Throws a MipError: "rate", before anything is changed, if a rate is not the base rate divided by a whole number;
     * "set" if the fields have no set in common; "timestamp" if the set has no such clock; and the errors of `request`.
     *
     * @param options.set the descriptor set, if the fields occur in several
     * @param options.timestamp the clock of the timestamp, if it must be a certain one; false to add no timestamp
     */
    stream(
        rates: Iterable<readonly [FieldClass<Data>, number]>,
        options?: { set?: number; timestamp?: boolean | ClockName },
    ): Promise<Map<FieldClass<Data>, number>>;
    /** Yields data packets as they arrive, until the device is closed; throws "closed" when the port is lost. */
    [Symbol.asyncIterator](): AsyncGenerator<Packet, void, undefined>;
    /** Returns the next data packet, or undefined if none arrives within `timeout` seconds or the device is closed. */
    next(options?: { timeout?: number }): Promise<Packet | undefined>;
    /** Yields the fields of these types as they arrive. Throws a MipError at one that cannot be decoded. */
    fields<F extends Data>(...kinds: FieldClass<F>[]): AsyncGenerator<F, void, undefined>;
    /** Discards the data that has not been read yet. */
    clear(): void;
    /** Closes the port. Waiting commands end with "closed", and loops over the data end. */
    close(): Promise<void>;
    /**
     * Opens a lost port again, trying for up to `within` seconds (30). Data that waits to be read is kept. The device may
     * have restarted, so apply its settings again.
     */
    reopen(options?: { within?: number }): Promise<void>;
}

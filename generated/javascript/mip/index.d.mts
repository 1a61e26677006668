// The MIP protocol in JavaScript: what every program uses. Fields are in modules of their own, one for each set.

import type { Identity } from "../session.mjs";

/** Bytes as an argument of a function. */
export type Bytes = Uint8Array | ArrayBuffer;

/** The class of all errors of the package. */
export declare class MipError extends Error {
    constructor(kind: string, message: string, details?: object);
    /**
     * One word for programs. Of data: "truncated", "count", "constant"; of values: "missing", "range", "unknown", "tag",
     * "count", "length", "set"; of packets: "sync", "length", "checksum", "field_length"; of a device: "refused", "timeout",
     * "missing_response", "closed", "no_device", "rate", "session".
     */
    readonly kind: string;
    /** The command, for "refused" and "timeout". */
    readonly command?: Command;
    /** The code of the acknowledge, for "refused". */
    readonly code?: number;
}

/** The two bytes that end a packet, computed from all bytes before them. */
export declare function checksum(bytes: Bytes): Uint8Array;
/** "7565", or with a separator "75 65". */
export declare function toHex(bytes: Bytes, between?: string): string;
/** The bytes of pairs of hexadecimal digits, with or without white space, "-" or ":" between the pairs. Raises "hex". */
export declare function fromHex(text: string): Uint8Array;

// ---------------------------------------------------------------------------------------------------- named numbers

declare const named: unique symbol;
/** A number with a meaning: plain numbers are taken for it, but no number with another meaning. */
export type Flavor<T, Name extends string> = T & { readonly [named]?: Name };

/** An open enumeration: its names are properties with their numbers. Numbers without a name may be received, and sent. */
export interface Enumeration<T> {
    /** The name of a number; undefined if it has none. */
    nameOf(value: T): string | undefined;
}

/** A bitfield: its names are properties with their masks. */
export interface Bitfield<T> {
    /** Is a flag set? Of a mask of several bits: is any? */
    has(value: T, flag: T): boolean;
    /** The number in the bits of a name. */
    get(value: T, name: Exclude<keyof this, keyof Bitfield<T>>): number;
    /** The names of the flags that are set. */
    namesOf(value: T): string[];
}

// ---------------------------------------------------------------------------------------------------- fields

/** The class of a field. */
export interface FieldClass<F extends Field = Field> {
    new (values: never): F;
    /** Its name in the specification: "base.ping". */
    readonly NAME: string;
    /** The only descriptor set in which it occurs; undefined if there are several. */
    readonly SET: number;
    readonly SETS: { includes(set: number): boolean };
    readonly DESCRIPTOR: number;
    readonly ROLE: "command" | "response" | "data";
    occursIn(set: number): boolean;
    /** Can this be its data? Checks what distinguishes the layouts of one descriptor. */
    matches(data: Uint8Array): boolean;
}

/** The argument of a constructor: the members of the object. */
export type Values<F, Unneeded extends PropertyKey = never> = Omit<F, keyof Command | Unneeded> & Partial<Pick<F, Unneeded & keyof F>>;

/** One field: a command, a response or data. */
export declare class Field {
    /** Its name in the specification: "base.ping". */
    static readonly NAME: string;
    /** The descriptor set in which it occurs; of one that occurs in several sets there is none. */
    static readonly SET: number;
    static readonly SETS: { includes(set: number): boolean };
    static readonly DESCRIPTOR: number;
    static readonly ROLE: "command" | "response" | "data";
    static occursIn(set: number): boolean;
    /** Can this be its data? Checks what distinguishes the layouts of one descriptor: constants and size. */
    static matches(data: Uint8Array): boolean;
    /** The values of a field's data; bytes left over are not an error. Raises a MipError. */
    static decode<F extends Field>(this: new (values: never) => F, data: Bytes): F;
    /** The values, and how many bytes are left over (newer devices send more). */
    static decodeWithTrailing<F extends Field>(this: new (values: never) => F, data: Bytes): { field: F; trailing: number };
    /** The set of the packet that contained it, or the only one in which it occurs; undefined if that is not known. */
    get set(): number | undefined;
    /** The data of the field, without its length and descriptor. Raises a MipError. */
    encode(): Uint8Array;
    /** A packet with only this field: of the set that contained it, or of the given one. Raises a MipError. */
    packet(set?: number): Packet;
}

/** A measurement. */
export declare class Data extends Field {
    #data: true;
}

/** A field that follows the acknowledge of a command. */
export declare class Response extends Field {
    #response: true;
}

declare const answer: unique symbol;

/** A field that the device acknowledges: with a response of type R, or without one. */
export declare class Command<R extends Response | undefined = Response | undefined> extends Field {
    readonly [answer]?: R;
    /** The types of its responses. */
    static readonly RESPONSES: FieldClass<Response>[];
    /** Seconds, if the device may take longer than usual. */
    static readonly TIMEOUT?: number;
    /** Does the device acknowledge it, with these values? */
    get answered(): boolean;
    /** The types of the response that it asks for with these values: devices may have different layouts of it. */
    get replies(): FieldClass<Response>[];
}

/** A packet with these fields. Each must occur in the set, which need not be given if one occurs in no other. Raises a MipError. */
export declare function packetOf(fields: readonly Field[], set?: number): Packet;

// ---------------------------------------------------------------------------------------------------- packets

/** A field of a packet, not decoded. */
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
    /** A whole packet. Raises a MipError: "sync", "length" or "checksum". */
    static from(bytes: Bytes): Packet;
    /** A packet of fields that are encoded already. Raises a MipError if they do not fit. */
    static build(set: number, fields: readonly { descriptor: number; data: Uint8Array }[]): Packet;
    /** Bytes with the frame of a packet, which are not checked. */
    constructor(bytes: Uint8Array);
    readonly bytes: Uint8Array;
    /** Its descriptor set. */
    get set(): number;
    get payload(): Uint8Array;
    get checksum(): Uint8Array;
    /** The correct checksum. */
    get rightChecksum(): Uint8Array;
    /** Is the checksum correct? */
    get sound(): boolean;
    /** From a device: when it arrived, in seconds since 1970, by the clock of this computer. */
    readonly time?: number;
    /** The fields. A wrong length raises "field_length" after those before it. */
    fields(): Generator<RawField, void, undefined>;
    /** The first field of a type; undefined if there is none. Raises a MipError if it cannot be decoded. */
    find<F extends Field>(kind: FieldClass<F>): F | undefined;
    /** The fields of a type, in order. Raises a MipError if one cannot be decoded. */
    findAll<F extends Field>(kind: FieldClass<F>): F[];
}

/** Finds packets in a stream that contains anything else too and arrives in any pieces. */
export declare class Parser {
    /** @param options.onSkipped is called with bytes that belong to no packet, in order with the packets */
    constructor(options?: { onSkipped?: (bytes: Uint8Array) => void });
    /** Bytes so far that belong to no packet. */
    readonly skipped: number;
    /** The packets that are complete with these bytes, which are copied. */
    feed(bytes: Bytes): Packet[];
    /** The stream has ended: returns the packets inside an incomplete one. */
    flush(): Packet[];
    /** Gives up an incomplete packet only if whole packets follow its first bytes: it was noise. */
    lookBehind(): Packet[];
}

/**
 * The parts of bytes, in order. "damaged" is a packet with a wrong checksum whose fields end where it does, and
 * "incomplete" the beginning of one at the end. Neither hides a whole packet.
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
    /** 0 if the command is accepted, else the reason why it is rejected. */
    code: number;
    response?: Response;
    /** The reason why there is no response: the device sent none ("missing_response"), or it cannot be decoded. */
    error?: MipError;
    /** The response, not decoded. */
    raw?: RawField;
}

/** The device has not answered in time. */
export interface TimedOut {
    type: "timedOut";
    command: Command;
}

/** A packet with fields that answer no command: data, or an unexpected reply. */
export interface Received {
    type: "received";
    packet: Packet;
    /** The fields that answer no command, up to a malformed one. */
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
 * The command client, without input or output. Times are in seconds of any clock that does not jump.
 *
 * After a command without an answer, the next ones are sent after a barrier, a packet of several commands that change
 * nothing: replies before its answer are events like data, and answer no command after it.
 */
export declare class Client {
    /** @param options.timeout seconds until a command times out; longer for commands that take longer */
    constructor(options?: { timeout?: number; onSkipped?: (bytes: Uint8Array) => void });
    /** The commands that wait for an answer, the oldest first. */
    get pending(): Command[];
    /** The number of received bytes that are part of no packet. */
    get skipped(): number;
    /** The time at which the next command times out; undefined if none waits. */
    get deadline(): number | undefined;
    /**
     * The bytes to send: one packet with these commands, all of one set, behind a barrier if an earlier command was not
     * answered. Raises a MipError, and waits for no answer then.
     *
     * @param options.timeout seconds for these commands, in place of their usual time-outs
     * @param options.wait false if answers are not expected, and are events like data
     */
    send(commands: readonly Command[], now: number, options?: { timeout?: number; wait?: boolean }): Uint8Array;
    /** The events of these bytes and this time. */
    receive(bytes: Bytes, now: number): ClientEvent[];
    /** The commands that have timed out. */
    poll(now: number): ClientEvent[];
    /** Gives up an incomplete packet only if whole packets follow its first bytes. Call it when nothing arrives for a while. */
    lookBehind(now: number): ClientEvent[];
    /** Gives up an incomplete packet, for example at the end of a file. */
    flush(now: number): ClientEvent[];
    /**
     * Stops waiting for this command. A late answer to it does not answer another one.
     *
     * @param options.silent the device does not answer it
     */
    cancel(command: Command, options?: { silent?: boolean }): void;
    /**
     * The connection was lost: gives up an incomplete packet, and the commands that wait time out. Replies that still arrive
     * over the next connection are not taken for answers to later commands.
     */
    interrupt(): ClientEvent[];
}

// ---------------------------------------------------------------------------------------------------- a device

/** The transport of the bytes. */
export interface Port {
    /** The bytes that arrive; ends when the port is lost. */
    bytes(): AsyncIterable<Uint8Array>;
    write(bytes: Uint8Array): void | Promise<void>;
    close(): void | Promise<void>;
}

export interface DeviceOptions {
    /** Seconds until a command times out, 1 by default; longer for commands that take longer. */
    timeout?: number;
    /** The number of packets that are kept until they are read; the oldest are dropped. */
    capacity?: number;
    /** Is called with all bytes that arrive, to record them. */
    onBytes?: (bytes: Uint8Array) => void;
    /** Is called with bytes that belong to no packet. */
    onSkipped?: (bytes: Uint8Array) => void;
}

type Answers<C extends readonly Command[]> = { -readonly [I in keyof C]: C[I] extends Command<infer R> ? R : never };

/** A device at a port. Iterate over it to read its data: `for await (const packet of device)`. */
export declare class Device implements AsyncIterable<Packet> {
    private constructor();
    /** @param open opens the port, also if the device is opened again */
    static open(open: () => Promise<Port>, options?: DeviceOptions): Promise<Device>;
    /** Is the port closed or lost? Data that has arrived can still be read. */
    get closed(): boolean;
    /** The number of packets that were dropped because they were not read in time. */
    readonly dropped: number;
    /** The number of bytes that are part of no packet. */
    get skipped(): number;
    /** The number of packets that can be read without waiting. */
    get waiting(): number;
    /**
     * Sends a command, waits for the answer and returns the response; undefined if it has none.
     *
     * Raises a MipError: "refused" (with `code`), "timeout", "missing_response", "closed", or why the response cannot be
     * decoded; and, before anything is sent, why the command cannot be encoded.
     *
     * @param options.timeout seconds for this one
     */
    request<R extends Response | undefined>(command: Command<R>, options?: { timeout?: number }): Promise<R>;
    /** Sends commands of one set in one packet; the response of each. Raises the error of the first that has failed. */
    requestAll<const C extends readonly Command[]>(commands: C, options?: { timeout?: number }): Promise<Answers<C>>;
    /** The same, but returns the outcomes, those of failed commands too; undefined for one that is not acknowledged. */
    exchange(commands: readonly Command[], options?: { timeout?: number }): Promise<(Answer | TimedOut | Closed | undefined)[]>;
    /** Sends commands of one set in one packet and waits for nothing: answers are treated as data. */
    send(...commands: Command[]): Promise<void>;
    /** Sets the device to idle and identifies it: the response of the command for that. */
    identify(): Promise<Identity>;
    /**
     * Starts data: `stream([[ScaledAccel, 100], [ScaledGyro, 100]])`, in Hz; 0 is as often as the device can. Replaces the
     * message format of the set, switches it on and resumes. Returns the rates.
     *
     * Raises a MipError: "rate", before anything is changed, if a rate is not the base rate divided by a whole number;
     * "set" if the fields have no set in common; and those of `request`.
     *
     * @param options.set the descriptor set, if the fields occur in several
     */
    stream(rates: Iterable<readonly [FieldClass<Data>, number]>, options?: { set?: number }): Promise<Map<FieldClass<Data>, number>>;
    /** The packets of data as they arrive. Ends when the device is closed; raises "closed" when the port is lost. */
    [Symbol.asyncIterator](): AsyncGenerator<Packet, void, undefined>;
    /** The next packet of data; undefined if none arrives within `timeout` seconds, or if the device is closed. */
    next(options?: { timeout?: number }): Promise<Packet | undefined>;
    /** The fields of these types as they arrive. Raises a MipError for one that cannot be decoded. */
    fields<F extends Data>(...kinds: FieldClass<F>[]): AsyncGenerator<F, void, undefined>;
    /** Discards the data that was not read yet. */
    clear(): void;
    /** Closes the port. Commands that wait end with "closed", and loops over the data end. */
    close(): Promise<void>;
    /**
     * Opens the port again, after it was lost, and keeps trying for up to `within` seconds (30).
     * Waiting data is kept. The device may have restarted: apply its settings again.
     */
    reopen(options?: { within?: number }): Promise<void>;
}

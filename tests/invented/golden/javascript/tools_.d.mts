/**
 * Tools (0x01).
 *
 * Commands of every shape.
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

export type Shape = Flavor<number, "tools.shape">;
/** Which member the union has. */
export declare const Shape: Enumeration<Shape> & {
    readonly NONE: Shape & 0;
    readonly CIRCLE: Shape & 1;
    readonly PATH: Shape & 2;
    readonly TURN: Shape & 3;
    readonly LABEL: Shape & 4;
};

export type Fill = Flavor<number, "tools.fill">;
/** How a circle is filled. */
export declare const Fill: Enumeration<Fill> & {
    readonly EMPTY: Fill & 0;
    readonly SOLID: Fill & 1;
    readonly STRIPED: Fill & 2;
};

/** Two numbers. */
export interface Stripes {
    /** Of a stripe. Unit: m. */
    width: number;
    /** Of all stripes. Unit: deg. Range: -180 to 180. */
    angle: number;
}

/** Ends in a union of its own. */
export interface Circle {
    /** The middle. */
    center: types.Point;
    /** Which member follows. */
    fill: Fill;
    /**
     * How it is filled. Selected by `fill`.
     *
     * - If `fill` is `Fill.EMPTY`: `{}`.
     * - If `fill` is `Fill.SOLID`: `solid: number`. A colour.
     * - If `fill` is `Fill.STRIPED`: `striped: Stripes`.
     */
    filling: { solid?: number; striped?: Stripes };
}

/** A counted array at its end. */
export interface Path {
    /** Does it return to its start? */
    closed: boolean;
    /** On the wire only: num_points. Number of points. Counts the elements of `points`. */
    /** The points. */
    points: types.Point[];
}

export type Drive = Flavor<number, "tools.drive">;
/** What drives a pin. */
export declare const Drive: Enumeration<Drive> & {
    readonly OFF: Drive & 0;
    readonly PULSE: Drive & 1;
    readonly SERIAL: Drive & 2;
};

export type PulseUse = Flavor<number, "tools.pulse_use">;
/** Of a pulse. */
export declare const PulseUse: Enumeration<PulseUse> & {
    readonly INPUT: PulseUse & 1;
    readonly OUTPUT: PulseUse & 2;
};

export type SerialUse = Flavor<number, "tools.serial_use">;
/** Of a serial line. */
export declare const SerialUse: Enumeration<SerialUse> & {
    readonly RECEIVE: SerialUse & 1;
    readonly TRANSMIT: SerialUse & 33;
};

/** One of a list; what it is depends on what was asked for. */
export interface Reading {
    /** Of the reading. */
    kind: number;
    /** Of the reading. */
    value: number;
}

export type ModelAFaults = Flavor<number, "tools.model_a_faults">;
/** Of the model A. */
export declare const ModelAFaults: Bitfield<ModelAFaults> & {
    /** Bit 0. */
    readonly CLOCK: ModelAFaults;
    /** The sensor is broken. Bit 8. Concerns `measurements.Accel` and `CaptureBias`. */
    readonly SENSOR: ModelAFaults;
    /** Bit 24. */
    readonly SOLUTION: ModelAFaults;
};

export type ModelBFaults = Flavor<number, "tools.model_b_faults">;
/** Of the model B. */
export declare const ModelBFaults: Bitfield<ModelBFaults> & {
    /** Bit 0. */
    readonly GENERAL: ModelBFaults;
    /** Bit 1. */
    readonly OVERLOAD: ModelBFaults;
    /** Bit 12. */
    readonly ACCEL: ModelBFaults;
};

/**
 * Settings response (0x01,0x82).
 *
 * Response to `Settings`. Supported by Model A, Model B and Model C.
 *
 * - guide: Settings
 * - leaflet: Settings
 */
export declare class SettingsResponse extends Response {
    constructor(values: Values<SettingsResponse, "reserved">);
    /** Number of the port, 0 for all. Range: 0 to 8. */
    port: number;
    /** What to do. Default: `types.Mode.FAST`. */
    mode: types.Mode;
    /** Speed. Unit: Bd. Default: 115200. */
    baud: number;
    /**
     * Required by no function, not even by write.
     *
     * - If `mode` is `types.Mode.FAST`: unit s; range 1 to 10; default 5.
     * - If `mode` is `types.Mode.SLOW`: unit m.
     */
    limit: number;
    /** Reserved. */
    reserved: number;
}

/**
 * Set time response (0x01,0x83).
 *
 * Response to `SetTime`. Sent if `part` is `types.Mode.FAST`. Supported by Model A and Model C.
 *
 * - guide: Set time
 */
export declare class SetTimeFastResponse extends Response {
    constructor(values: Values<SetTimeFastResponse>);
    /** The fast half. Unit: s. */
    value: number;
}

/**
 * Set time response (0x01,0x84).
 *
 * Response to `SetTime`. Sent if `part` is `types.Mode.SLOW`. Supported by Model A and Model C.
 *
 * - guide: Set time
 */
export declare class SetTimeSlowResponse extends Response {
    constructor(values: Values<SetTimeSlowResponse>);
    /** The slow half. Unit: s. */
    value: number;
}

/**
 * Choice response (0x01,0x88).
 *
 * Response to `Choice`. Supported by Model A.
 *
 * - guide: Choice
 */
export declare class ChoiceResponse extends Response {
    constructor(values: Values<ChoiceResponse>);
    /** Which one. */
    instance: number;
    /** Which member follows. */
    shape: Shape;
    /**
     * The member. Selected by `shape`.
     *
     * - If `shape` is `Shape.NONE`: `{}`.
     * - If `shape` is `Shape.CIRCLE`: `circle: Circle`.
     * - If `shape` is `Shape.PATH`: `path: Path`.
     * - If `shape` is `Shape.TURN`: `rotation: types.Quatf`. A rotation. Elements: w, x, y, z. Unit: 1.
     * - If `shape` is `Shape.LABEL`: `label: string`. A name.
     */
    parameters: { circle?: Circle; path?: Path; rotation?: types.Quatf; label?: string };
}

/**
 * List response (0x01,0x89).
 *
 * Response to `List`. Supported by Model A and Model C.
 *
 * - guide: List
 */
export declare class ListResponse extends Response {
    constructor(values: Values<ListResponse>);
    /** On the wire only: count. Number of items. Counts the elements of `items`. */
    /** The items. */
    items: number[];
}

/**
 * Inventory response (0x01,0x8A).
 *
 * Response to `Inventory`. Supported by Model A and Model C.
 *
 * - guide: Inventory
 */
export declare class InventoryResponse extends Response {
    constructor(values: Values<InventoryResponse>);
    /** As many as there are. */
    descriptors: number[];
}

/**
 * Pin response (0x01,0x8B).
 *
 * Response to `Pin`. Supported by Model A and Model C.
 *
 * - guide: Pin
 */
export declare class PinResponse extends Response {
    constructor(values: Values<PinResponse>);
    /** What drives it now. */
    drive: Drive;
    /**
     * How it is used.
     *
     * - If `drive` is `Drive.PULSE`: values of `PulseUse`.
     * - If `drive` is `Drive.SERIAL`: values of `SerialUse`.
     */
    use: number;
}

/**
 * Hello response (0x01,0x8C).
 *
 * No device is known for certain to support it. Also called `keep_alive_response` and `welcome`. Response to `Hello`.
 * Known only from the Kit of names. Uncertain: When it comes.
 *
 * - sheet: Hello
 */
export declare class HelloResponse extends Response {
    constructor(values: Values<HelloResponse>);
    /** When the device was seen. Unit: s. */
    seen: number;
}

/**
 * Readings response (0x01,0x8D).
 *
 * Response to `Readings`. Supported by Model A and Model C.
 *
 * - guide: Readings
 */
export declare class ReadingsResponse extends Response {
    constructor(values: Values<ReadingsResponse>);
    /** What was asked for. */
    drive: Drive;
    /** On the wire only: count. Number of readings. Counts the elements of `readings`. */
    /**
     * The readings.
     *
     * - If `drive` is `Drive.PULSE`: `kind` has values of `PulseUse`. Seldom 2.
     * - If `drive` is `Drive.SERIAL`: `kind` has values of `SerialUse`.
     */
    readings: Reading[];
    /**
     * The last one.
     *
     * - If `drive` is `Drive.PULSE`: `value` has unit s; range 0 to 1.
     * - If `drive` is `Drive.SERIAL`: `value`: Nothing.
     */
    last: Reading;
}

/**
 * Status response (0x01,0x90).
 *
 * As long as the short layout. A further constant tells it from that one.
 *
 * Response to `Status`. Sent if `selector` is 1. Supported by Model C.
 *
 * - guide: Status
 */
export declare class StatusPaged extends Response {
    constructor(values: Values<StatusPaged>);
    /** On the wire only: model. The model. Always 4711. */
    /** On the wire only: selector. The short layout. Always 1. */
    /** On the wire only: page. The page. Always 7. */
    /** Since start. Unit: s. */
    uptime: number;
    /** How full it is. */
    level: number;
}

/**
 * Status response (0x01,0x90).
 *
 * Response to `Status`. Sent if `selector` is 1. Supported by Model A and Model B.
 *
 * - guide: Status
 */
export declare class StatusShort extends Response {
    constructor(values: Values<StatusShort>);
    /** On the wire only: model. The model. Always 4711. */
    /** On the wire only: selector. The short layout. Always 1. */
    /**
     * Faults.
     *
     * - On the Model A and Model C: values of `ModelAFaults`.
     * - On the Model B: values of `ModelBFaults`.
     */
    flags: number;
}

/**
 * Status response (0x01,0x90).
 *
 * Response to `Status`. Distinguished from `StatusOld` and `StatusFull` by the size of its data. Sent if `selector` is
 * 2. Supported by Model B.
 *
 * - guide: Status
 */
export declare class StatusLong extends Response {
    constructor(values: Values<StatusLong>);
    /** On the wire only: model. The model. Always 4711. */
    /** On the wire only: selector. The long layout. Always 2. */
    /**
     * Faults.
     *
     * - On the Model A: values of `ModelAFaults`.
     * - On the Model B: values of `ModelBFaults`.
     * - On the Model C: the values are unknown.
     */
    flags: number;
    /** Since start. Unit: s. */
    uptime: bigint;
}

/**
 * Status response (0x01,0x90).
 *
 * The long layout of old devices. Its size tells it from the others.
 *
 * Response to `Status`. Distinguished from `StatusLong` and `StatusFull` by the size of its data. Sent if `selector` is
 * 2. Supported by Model A.
 *
 * - guide: Status
 */
export declare class StatusOld extends Response {
    constructor(values: Values<StatusOld>);
    /** On the wire only: model. The model. Always 4711. */
    /** On the wire only: selector. The long layout. Always 2. */
    /** Since start. Unit: s. */
    uptime: number;
}

/**
 * Status response (0x01,0x90).
 *
 * Response to `Status`. Distinguished from `StatusLong` and `StatusOld` by the size of its data. Sent if `selector` is
 * 2. Supported by Model C.
 *
 * - guide: Status
 */
export declare class StatusFull extends Response {
    constructor(values: Values<StatusFull>);
    /** On the wire only: model. The model. Always 4711. */
    /** On the wire only: selector. The long layout. Always 2. */
    /** Where it is. */
    place: types.Point;
    /** Since start. Unit: s. */
    uptime: bigint;
    /** What it does. */
    mode: types.Mode;
}

/**
 * Bias response (0x01,0x9B).
 *
 * Response to `Bias` and `CaptureBias`. Supported by Model A and Model C.
 *
 * - guide: Bias
 * - leaflet: Bias
 */
export declare class BiasVector extends Response {
    constructor(values: Values<BiasVector>);
    /** Taken off the measurement. Elements: x, y, z. Unit: g. Frame: sensor. */
    bias: types.Vector3f;
}

/**
 * Ping (0x01,0x01).
 *
 * Tests the line.
 *
 * Supported by Model A, Model B, Model C and Old 1.
 *
 * - guide: Ping
 * - leaflet: Ping
 */
export declare class Ping extends Command<undefined> {
    constructor();
}

/**
 * Settings (0x01,0x02).
 *
 * Every function, and a prefix of parameters for each.
 *
 * Functions: `write`, `read`, `save`, `load`, `default` and `apply`. Response: `SettingsResponse`. Supported by Model
 * A, Model B and Model C. On the Model B: `write` and `read` only. On the Model C: `write`, `read` and `save` only.
 *
 * - guide: Settings
 * - leaflet: Settings
 */
export declare class Settings<R extends Response | undefined = undefined | SettingsResponse> extends Command<R> {
    constructor(values: Values<Settings, "reserved">);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Number of the port, 0 for all. Range: 0 to 8. */
    port?: number;
    /**
     * What to do. Default: `types.Mode.FAST`. Required for `write`, `read` and `apply`.
     *
     * - On the Model C: only `types.Mode.DEFAULT` and `types.Mode.FAST`; not deprecated.
     */
    mode?: types.Mode;
    /** Speed. Unit: Bd. Default: 115200. Required for `write` and `apply`. */
    baud?: number;
    /**
     * Required by no function, not even by write. Optional.
     *
     * - If `mode` is `types.Mode.FAST`: unit s; range 1 to 10; default 5.
     * - If `mode` is `types.Mode.SLOW`: unit m.
     */
    limit?: number;
    /** Reserved: send 1. Optional. */
    reserved?: number;
    /** Apply the new setting. */
    static write(values: { port: number; mode: types.Mode; baud: number; limit?: number }): Settings<undefined>;
    /** Send the current setting back in a response. */
    static read(values: { port: number; mode: types.Mode }): Settings<SettingsResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { port: number }): Settings<undefined>;
    /** Load the saved setting. */
    static load(values: { port: number }): Settings<undefined>;
    /** Load the factory default setting. */
    static default(values: { port: number }): Settings<undefined>;
    /** Apply the new setting and send no acknowledge (5-series devices). */
    static apply(values: { port: number; mode: types.Mode; baud: number; limit?: number }): Settings<undefined>;
}

/**
 * Set time (0x01,0x03).
 *
 * Two responses for one command.
 *
 * Functions: `write`, `read` and `apply`. Response: `SetTimeFastResponse` or `SetTimeSlowResponse`. Supported by Model
 * A and Model C.
 *
 * Send it once a second.
 *
 * - guide: Set time
 */
export declare class SetTime<R extends Response | undefined = undefined | SetTimeFastResponse | SetTimeSlowResponse> extends Command<R> {
    constructor(values: Values<SetTime>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Which half of the time. */
    part?: types.Mode;
    /** The new value. Unit: s. Required for `write` and `apply`. */
    value?: number;
    /** Apply the new setting. */
    static write(values: { part: types.Mode; value: number }): SetTime<undefined>;
    /** Send the current setting back in a response. */
    static read(values: { part: types.Mode }): SetTime<SetTimeFastResponse | SetTimeSlowResponse>;
    /** Apply the new setting and send no acknowledge (5-series devices). */
    static apply(values: { part: types.Mode; value: number }): SetTime<undefined>;
}

/**
 * Status (0x01,0x04).
 *
 * Layouts of one response, told apart by constants and by size.
 *
 * For advanced use. Response: `StatusPaged`, `StatusShort`, `StatusLong`, `StatusOld` or `StatusFull`. The device may
 * take 2.5 s to reply. Supported by Model A, Model B and Model C.
 *
 * - guide: Status
 */
export declare class Status extends Command<StatusPaged | StatusShort | StatusLong | StatusOld | StatusFull> {
    constructor(values: Values<Status>);
    /** On the wire only: model. The model that the layouts belong to. Always 4711. */
    /**
     * Which layout. Range: 1 to 2.
     *
     * - On the Model C: always 2. Inferred: It has one layout.
     */
    selector: number;
}

/**
 * Bias (0x01,0x05).
 *
 * Its response serves another command too.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `BiasVector`. Changes `measurements.Accel` and
 * `measurements.Gust`. Probably changes more (0x81). Supported by Model A and Model C.
 *
 * - guide: Bias
 * - leaflet: Bias
 */
export declare class Bias<R extends Response | undefined = undefined | BiasVector> extends Command<R> {
    constructor(values: Values<Bias>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Taken off the measurement. Elements: x, y, z. Unit: g. Frame: sensor. Required for `write`. */
    bias?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { bias: types.Vector3f }): Bias<undefined>;
    /** Send the current setting back in a response. */
    static read(): Bias<BiasVector>;
    /** Save the current setting to non-volatile memory. */
    static save(): Bias<undefined>;
    /** Load the saved setting. */
    static load(): Bias<undefined>;
    /** Load the factory default setting. */
    static default(): Bias<undefined>;
}

/**
 * Capture bias (0x01,0x06).
 *
 * Measures the bias.
 *
 * Response: `BiasVector`. Probably changes `measurements.Accel`. Supported by Model A and Model C. Deprecated on the
 * Model C: use `Bias` instead. On the Model C: firmware >= 1.0, < 1.1.
 *
 * - guide: Capture bias
 */
export declare class CaptureBias extends Command<BiasVector> {
    constructor(values: Values<CaptureBias>);
    /** How long. Unit: s. Range: 1 to 30. */
    time: number;
}

/**
 * Formats (0x01,0x07).
 *
 * Counted arrays of structures and of numbers; not answered if told so.
 *
 * Not acknowledged if `suppressAck` is true. Supported by Model A and Model C.
 *
 * - guide: Formats
 */
export declare class Formats extends Command<undefined> {
    constructor(values: Values<Formats>);
    /** Send no acknowledge. */
    suppressAck: boolean;
    /** On the wire only: num_segments. Number of segments. Counts the elements of `segments`. */
    /** Between a counter and its array. Deprecated. */
    checkpoint: number;
    /** The segments. */
    segments: types.Segment[];
}

/**
 * Choice (0x01,0x08).
 *
 * A tagged union with an empty variant, nested unions, arrays and strings in it.
 *
 * Functions: `write` and `read`. Response: `ChoiceResponse`. Supported by Model A.
 *
 * - guide: Choice
 */
export declare class Choice<R extends Response | undefined = undefined | ChoiceResponse> extends Command<R> {
    constructor(values: Values<Choice>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Which one. */
    instance?: number;
    /** Which member follows. Required for `write`. */
    shape?: Shape;
    /**
     * The member. Selected by `shape`. Required for `write`.
     *
     * - If `shape` is `Shape.NONE`: `{}`.
     * - If `shape` is `Shape.CIRCLE`: `circle: Circle`.
     * - If `shape` is `Shape.PATH`: `path: Path`.
     * - If `shape` is `Shape.TURN`: `rotation: types.Quatf`. A rotation. Elements: w, x, y, z. Unit: 1.
     * - If `shape` is `Shape.LABEL`: `label: string`. A name.
     */
    parameters?: { circle?: Circle; path?: Path; rotation?: types.Quatf; label?: string };
    /** Apply the new setting. */
    static write(values: { instance: number; shape: Shape; parameters: { circle?: Circle; path?: Path; rotation?: types.Quatf; label?: string } }): Choice<undefined>;
    /** Send the current setting back in a response. */
    static read(values: { instance: number }): Choice<ChoiceResponse>;
}

/**
 * List (0x01,0x09).
 *
 * Optional counted array; a read may carry a zero count.
 *
 * Functions: `write`, `read` and `save`. Response: `ListResponse`. Supported by Model A and Model C.
 *
 * - guide: List
 */
export declare class List<R extends Response | undefined = undefined | ListResponse> extends Command<R> {
    constructor(values: Values<List>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** On the wire only: count. Number of items. Counts the elements of `items`. Required for `write`. */
    /** The items. Required for `write`. */
    items?: number[];
    /** Apply the new setting. */
    static write(values: { items: number[] }): List<undefined>;
    /** Send the current setting back in a response. */
    static read(): List<ListResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): List<undefined>;
}

/**
 * Inventory (0x01,0x0A).
 *
 * Answers with an array to the end of the field.
 *
 * Response: `InventoryResponse`. Supported by Model A and Model C.
 *
 * - guide: Inventory
 */
export declare class Inventory extends Command<InventoryResponse> {
    constructor();
}

/**
 * Pin (0x01,0x0B).
 *
 * The names of one number depend on another.
 *
 * Functions: `write` and `read`. Response: `PinResponse`. Supported by Model A and Model C.
 *
 * - guide: Pin
 */
export declare class Pin<R extends Response | undefined = undefined | PinResponse> extends Command<R> {
    constructor(values: Values<Pin>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** What drives it. */
    drive?: Drive;
    /**
     * How it is used. Required for `write`.
     *
     * - If `drive` is `Drive.PULSE`: values of `PulseUse`.
     * - If `drive` is `Drive.SERIAL`: values of `SerialUse`.
     */
    use?: number;
    /** Apply the new setting. */
    static write(values: { drive: Drive; use: number }): Pin<undefined>;
    /** Send the current setting back in a response. */
    static read(values: { drive: Drive }): Pin<PinResponse>;
}

/**
 * Hello (0x01,0x0C).
 *
 * The device asks and a host answers.
 *
 * No device is known for certain to support it. Also called `keep_alive`. Response: `HelloResponse`. Sent by the
 * device; the host replies. Known only from the Kit of names.
 *
 * - sheet: Hello
 */
export declare class Hello extends Command<HelloResponse> {
    constructor(values: Values<Hello, "reserved" | "later">);
    /** Reserved: send 1.0. */
    reserved: number;
    /** Reserved: send 0.0. Optional. */
    later?: [number, number];
}

/**
 * Readings (0x01,0x0D).
 *
 * A parameter outside of a structure says how its members are read.
 *
 * Response: `ReadingsResponse`. Supported by Model A and Model C.
 *
 * - guide: Readings
 */
export declare class Readings extends Command<ReadingsResponse> {
    constructor(values: Values<Readings>);
    /** What is asked for. */
    drive: Drive;
}

/**
 * Poll (0x01,0x0E).
 *
 * Descriptors of a set that a parameter names, and of one that is always the same.
 *
 * Supported by Model C.
 *
 * - guide: Formats
 */
export declare class Poll extends Command<undefined> {
    constructor(values: Values<Poll>);
    /** Data descriptor set. Range: 0x80 to 0xFE. */
    descriptorSet: number;
    /** Field descriptor. Refers to fields of Measurements. Default: 0x01. */
    first: number;
    /** On the wire only: count. Number of fields. Counts the elements of `descriptors`. */
    /** Field descriptors. Refers to fields of `descriptorSet`. */
    descriptors: number[];
}

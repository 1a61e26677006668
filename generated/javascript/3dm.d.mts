/**
 * 3DM (0x0C).
 *
 * Commands that set up the sensors, the outputs, the pins and the events of a device.
 *
 * - 3dm-gx5-15: 4.2 3DM Commands
 * - 3dm-cv7-gnss-ins: 3DM (0x0C)
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

/**
 * A field requested by a poll.
 *
 * - 3dm-gx5-15: 4.2.1 Poll IMU Data (0x0C, 0x01)
 */
export interface PollEntry {
    /** Field descriptor. */
    descriptor: number;
    /** Reserved; occupies the position of a decimation. Reserved: send 0. */
    reserved?: number;
}

export type FactoryStreamingAction = Flavor<number, "3dm.factory_streaming_action">;
/**
 * Treatment of the existing message formats.
 *
 * - 3dm-cv7-gnss-ins: Factory Streaming (0x0C,0x10)
 */
export declare const FactoryStreamingAction: Enumeration<FactoryStreamingAction> & {
    /** The formats are replaced. */
    readonly OVERWRITE: FactoryStreamingAction & 0;
    /** The support fields are merged into the formats; the order may change. */
    readonly MERGE: FactoryStreamingAction & 1;
    /** The support fields are appended to the formats; fields may occur twice. */
    readonly ADD: FactoryStreamingAction & 2;
};

export type ConstellationId = Flavor<number, "3dm.constellation_id">;
/**
 * Constellation in receiver settings. The values differ from those of `types.GnssConstellation`, which GNSS data uses.
 *
 * - mip-sdk-4: Constellation Settings (0x0C,0x21)
 */
export declare const ConstellationId: Enumeration<ConstellationId> & {
    /** GPS, satellites G1 to G32. */
    readonly GPS: ConstellationId & 0;
    /** SBAS, satellites S120 to S158. */
    readonly SBAS: ConstellationId & 1;
    /** Galileo, satellites E1 to E36. */
    readonly GALILEO: ConstellationId & 2;
    /** BeiDou, satellites B1 to B37. */
    readonly BEIDOU: ConstellationId & 3;
    /** QZSS, satellites Q1 to Q5. */
    readonly QZSS: ConstellationId & 5;
    /** GLONASS, satellites R1 to R32. */
    readonly GLONASS: ConstellationId & 6;
};

export type ConstellationOptions = Flavor<number, "3dm.constellation_options">;
/**
 * Options of a constellation.
 *
 * - mip-sdk-4: Constellation Settings (0x0C,0x21)
 */
export declare const ConstellationOptions: Bitfield<ConstellationOptions> & {
    /** The L1-SAIF signal; QZSS only. Bit 0. */
    readonly L1SAIF: ConstellationOptions;
};

/**
 * Settings for the tracking of one constellation.
 *
 * - mip-sdk-4: Constellation Settings (0x0C,0x21)
 */
export interface ConstellationSettingsEntry {
    /** Constellation that this entry configures. */
    constellationId: ConstellationId;
    /** 1 enables the constellation, 0 disables it. Range: 0 to 1. */
    enable: number;
    /** Number of channels reserved for the constellation. Unit: 1. Range: 0 to 32. */
    reservedChannels: number;
    /** Maximum number of channels for the constellation. Unit: 1. Range: 0 to 32. */
    maxChannels: number;
    /** Options of this constellation. */
    optionFlags: ConstellationOptions;
}

export type SbasOptions = Flavor<number, "3dm.sbas_options">;
/**
 * Purposes for which SBAS is used.
 *
 * - 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22)
 */
export declare const SbasOptions: Bitfield<SbasOptions> & {
    /** SBAS pseudoranges are used in the position solution. Bit 0. */
    readonly ENABLE_RANGING: SbasOptions;
    /** SBAS differential corrections are applied. Bit 1. */
    readonly ENABLE_CORRECTIONS: SbasOptions;
    /** Only GPS satellites with SBAS integrity information are used. Bit 2. */
    readonly APPLY_INTEGRITY: SbasOptions;
};

export type AssistedFixOption = Flavor<number, "3dm.assisted_fix_option">;
/**
 * Use of a receiver's last fix at power-up.
 *
 * - mip-sdk-4: Gnss Assisted Fix (0x0C,0x23)
 */
export declare const AssistedFixOption: Enumeration<AssistedFixOption> & {
    /** The receiver ignores its last fix. */
    readonly NONE: AssistedFixOption & 0;
    /** The receiver starts from its last fix. */
    readonly ENABLED: AssistedFixOption & 1;
};

export type PpsSource = Flavor<number, "3dm.pps_source">;
/**
 * Source of the pulse per second.
 *
 * - 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28)
 * - 3dm-cv7-gnss-ins: RECEIVER Source
 */
export declare const PpsSource: Enumeration<PpsSource> & {
    /** No pulse. */
    readonly DISABLED: PpsSource & 0;
    /**
     * From GNSS receiver 1. The external time is GPS time, and valid only while the receiver has a fix. Requires a
     * receiver.
     */
    readonly RECEIVER_1: PpsSource & 1;
    /**
     * From GNSS receiver 2. The external time is GPS time, and valid only while the receiver has a fix. Requires 2
     * receivers.
     */
    readonly RECEIVER_2: PpsSource & 2;
    /** From a GPIO pin that is configured as a PPS input. */
    readonly GPIO: PpsSource & 3;
    /** From the oscillator of the device. */
    readonly GENERATED: PpsSource & 4;
};

export type EventSupportQuery = Flavor<number, "3dm.event_support_query">;
/**
 * The part of the event system that is queried.
 *
 * - 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A)
 */
export declare const EventSupportQuery: Enumeration<EventSupportQuery> & {
    /** Supported types of triggers. */
    readonly TRIGGER_TYPES: EventSupportQuery & 1;
    /** Supported types of actions. */
    readonly ACTION_TYPES: EventSupportQuery & 2;
};

/**
 * Capacity of a device for one trigger or action type.
 *
 * - 3dm-cv7-gnss-ins: Info
 */
export interface EventSupportInfo {
    /** Trigger type or action type. */
    type: number;
    /** Maximum number of instances of this type. Unit: 1. */
    count: number;
}

/**
 * Type and state of one trigger.
 *
 * - 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
 */
export interface EventTriggerStatusEntry {
    /** Configured type. */
    type: types.EventTriggerType;
    /** State. */
    status: types.EventTriggerStatus;
}

/**
 * Type and trigger of one action.
 *
 * - 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D)
 */
export interface EventActionStatusEntry {
    /** Configured type. */
    actionType: types.EventActionType;
    /** Trigger instance that the action follows. */
    triggerId: number;
}

export type ReceiverDynamics = Flavor<number, "3dm.receiver_dynamics">;
/**
 * Motion that a GNSS receiver assumes. Uncertain: The SDK of 2014 numbers the modes 0 to 8, but the list in its
 * comments lacks `fixed`, which u-blox receivers do not have either. Uncertain: The sources list only names; the
 * descriptions of the modes are inferred from them.
 *
 * - mip-sdk-2014: GPS Dynamics Mode (0x0C,0x34)
 */
export declare const ReceiverDynamics: Enumeration<ReceiverDynamics> & {
    /** Low accelerations; fits most applications. */
    readonly PORTABLE: ReceiverDynamics & 0;
    /** Fixed installation. */
    readonly FIXED: ReceiverDynamics & 1;
    /** At rest. */
    readonly STATIONARY: ReceiverDynamics & 2;
    /** Walking speed. */
    readonly PEDESTRIAN: ReceiverDynamics & 3;
    /** Road vehicles. */
    readonly AUTOMOTIVE: ReceiverDynamics & 4;
    /** Vessels at sea level. */
    readonly SEA: ReceiverDynamics & 5;
    /** Aircraft with accelerations below 1 g. */
    readonly AIRBORNE_1G: ReceiverDynamics & 6;
    /** Aircraft with accelerations below 2 g. */
    readonly AIRBORNE_2G: ReceiverDynamics & 7;
    /** Aircraft with accelerations below 4 g. */
    readonly AIRBORNE_4G: ReceiverDynamics & 8;
};

export type DataConditioningFlags = Flavor<number, "3dm.data_conditioning_flags">;
/**
 * Processing steps of 3-series devices. Uncertain: Bits 4, 5, 9 and 12 are from the single-byte protocol of the
 * 3DM-GX3. MSCL has the quaternion as 0x10000, which exceeds 16 bits. Uncertain: The sources list only names; the
 * descriptions of the bits are inferred from them.
 *
 * - mip-sdk-2014: IMU Signal Conditioning (0x0C,0x35)
 * - mscl: IMU Signal Conditioning (0x0C,0x35)
 */
export declare const DataConditioningFlags: Bitfield<DataConditioningFlags> & {
    /** Computes the orientation. Bit 0. */
    readonly ORIENTATION_CALCULATION: DataConditioningFlags;
    /** Corrects coning and sculling. Bit 1. */
    readonly CONING_SCULLING: DataConditioningFlags;
    /** Sends floats with the least significant byte first. Bit 4. */
    readonly LITTLE_ENDIAN_FLOATS: DataConditioningFlags;
    /** Suppresses values that are NaN (not a number). Bit 5. */
    readonly NAN_SUPPRESSED: DataConditioningFlags;
    /** Compensates for the distance between the accelerometers. Bit 6. */
    readonly FINITE_SIZE_CORRECTION: DataConditioningFlags;
    /** Switches the magnetometer off. Bit 8. */
    readonly DISABLE_MAG: DataConditioningFlags;
    /** Reduces the power of the magnetometer. Bit 9. */
    readonly MAG_LOW_POWER: DataConditioningFlags;
    /** Disables the heading correction. Bit 10. */
    readonly DISABLE_NORTH_COMPENSATION: DataConditioningFlags;
    /** Disables the pitch and roll correction. Bit 11. */
    readonly DISABLE_UP_COMPENSATION: DataConditioningFlags;
    /** Computes the quaternion. Bit 12. */
    readonly QUATERNION_CALCULATION: DataConditioningFlags;
};

export type MagBandwidth = Flavor<number, "3dm.mag_bandwidth">;
/**
 * Bandwidth of the magnetometer of 3-series devices.
 *
 * - mip-sdk-2014: IMU Signal Conditioning (0x0C,0x35)
 */
export declare const MagBandwidth: Enumeration<MagBandwidth> & {
    /** High bandwidth. */
    readonly HIGH: MagBandwidth & 0;
    /** Low bandwidth. */
    readonly LOW: MagBandwidth & 1;
};

export type ImuTimestampSelector = Flavor<number, "3dm.imu_timestamp_selector">;
/**
 * A time counter of the sensor data.
 *
 * - mip-sdk-2014: IMU Timestamp (0x0C,0x36)
 */
export declare const ImuTimestampSelector: Enumeration<ImuTimestampSelector> & {
    /** Seconds of the time beacon. */
    readonly BEACON_SECONDS: ImuTimestampSelector & 1;
    /** Nanoseconds of the time beacon. */
    readonly BEACON_NANOSECONDS: ImuTimestampSelector & 2;
    /** Ticks of the internal clock. Uncertain: The source states 2 both for this value and for the nanoseconds. */
    readonly INTERNAL_TICKS: ImuTimestampSelector & 3;
};

export type OdometerMode = Flavor<number, "3dm.odometer_mode">;
/**
 * Operating mode of the odometer input.
 *
 * - 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43)
 */
export declare const OdometerMode: Enumeration<OdometerMode> & {
    /** Not used. */
    readonly DISABLED: OdometerMode & 0;
    /** Quadrature encoder on two pins. */
    readonly QUADRATURE: OdometerMode & 2;
};

export type SensorRangeType = Flavor<number, "3dm.sensor_range_type">;
/**
 * A sensor whose range can be set.
 *
 * - 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52)
 */
export declare const SensorRangeType: Enumeration<SensorRangeType> & {
    /** All sensors; for save, load and default only. */
    readonly ALL: SensorRangeType & 0;
    readonly ACCEL: SensorRangeType & 1;
    readonly GYRO: SensorRangeType & 2;
    /** On models with a magnetometer. Requires a magnetometer. */
    readonly MAG: SensorRangeType & 3;
    /** The pressure sensor. Requires a pressure sensor. */
    readonly PRESSURE: SensorRangeType & 4;
};

/**
 * A range that a sensor supports.
 *
 * - 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53)
 */
export interface SensorRangeEntry {
    /** Value for `SensorRange`. */
    setting: number;
    /** Largest measurable value. */
    range: number;
}

export type InternalSensor = Flavor<number, "3dm.internal_sensor">;
/**
 * A sensor inside a 3-series device.
 *
 * - mip-sdk-2014: Device Power State (0x0C,0x61)
 */
export declare const InternalSensor: Enumeration<InternalSensor> & {
    /** The inertial sensor. */
    readonly IMU: InternalSensor & 1;
    /** The GNSS receiver. Requires a receiver. */
    readonly GNSS: InternalSensor & 2;
};

export type StreamFormat = Flavor<number, "3dm.stream_format">;
/**
 * Format of a data stream.
 *
 * - mip-sdk-2014: Data Stream Format (0x0C,0x60)
 */
export declare const StreamFormat: Enumeration<StreamFormat> & {
    /** MIP data fields. */
    readonly STANDARD: StreamFormat & 1;
    /** The sensor's own packets, each in a MIP field. */
    readonly WRAPPED_RAW: StreamFormat & 2;
};

export type SensorPowerState = Flavor<number, "3dm.sensor_power_state">;
/**
 * Power state of an internal sensor.
 *
 * - mip-sdk-2014: Device Power State (0x0C,0x61)
 */
export declare const SensorPowerState: Enumeration<SensorPowerState> & {
    /** Full power. */
    readonly ON: SensorPowerState & 1;
    /** On with reduced power. */
    readonly LOW_POWER: SensorPowerState & 2;
    /** Very low power; starts quickly. */
    readonly SLEEP: SensorPowerState & 3;
    /** Off or in deep sleep. */
    readonly OFF: SensorPowerState & 4;
};

export type DeviceStatusSelector = Flavor<number, "3dm.device_status_selector">;
/**
 * Level of detail of a device status.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 */
export declare const DeviceStatusSelector: Enumeration<DeviceStatusSelector> & {
    /** State and timer. */
    readonly BASIC: DeviceStatusSelector & 1;
    /** State, timer, and the counters of streams and port. */
    readonly DIAGNOSTIC: DeviceStatusSelector & 2;
};

export type LegacyDataStream = Flavor<number, "3dm.legacy_data_stream">;
/**
 * A data stream of a device of the generations 3 to 5.
 *
 * - 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11)
 */
export declare const LegacyDataStream: Enumeration<LegacyDataStream> & {
    /** All streams; for save, load and default only. */
    readonly ALL_STREAMS: LegacyDataStream & 0;
    /** Sensor data (0x80). */
    readonly IMU: LegacyDataStream & 1;
    /** GNSS data. Requires a receiver. */
    readonly GNSS: LegacyDataStream & 2;
    /** Estimation filter data (0x82). */
    readonly FILTER: LegacyDataStream & 3;
};

export type Gx4SystemState = Flavor<number, "3dm.gx4_system_state">;
/**
 * State of the system in the device status of the 3DM-GX4-45 and the 3DM-RQ1-45.
 *
 * - mip-sdk-2014: Device Status (0x0C,0x64)
 */
export declare const Gx4SystemState: Enumeration<Gx4SystemState> & {
    /** The system is starting. */
    readonly INIT: Gx4SystemState & 1;
    /** The sensors are starting. */
    readonly SENSOR_STARTUP: Gx4SystemState & 2;
    /** The system is running. */
    readonly RUNNING: Gx4SystemState & 3;
};

/**
 * IMU message format response (0x0C,0x80).
 *
 * Response to `ImuMessageFormat`. Confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35,
 * 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 14 more.
 *
 * - 3dm-gx5-15: 4.2.5 IMU Message Format (0x0C, 0x08)
 */
export declare class ImuMessageFormatResponse extends Response {
    constructor(values: Values<ImuMessageFormatResponse>);
    /** On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`. */
    /** Fields and decimations. Refers to fields of Sensor data. */
    descriptors: types.DescriptorRate[];
}

/**
 * GNSS message format response (0x0C,0x81).
 *
 * Response to `GnssMessageFormat`. Confirmed on 3DM-GQ4-45, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST;
 * likely or assumed on 4 more.
 *
 * - mip-sdk-4: GNSS message format (0x0C,0x09)
 * - 3dm-gx5-35: 4.2.6 GNSS Message Format (0x0C, 0x09)
 */
export declare class GnssMessageFormatResponse extends Response {
    constructor(values: Values<GnssMessageFormatResponse>);
    /** On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`. Range: 0 to 82. */
    /** Fields and decimations. Refers to fields of GNSS data. */
    descriptors: types.DescriptorRate[];
}

/**
 * Estimation filter message format response (0x0C,0x82).
 *
 * Response to `FilterMessageFormat`. Confirmed on 3DM-CV5-15, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and
 * 3DM-RQ1-45-ST; likely or assumed on 9 more.
 *
 * - 3dm-gx5-15: 4.2.6 Estimation Filter Message Format (0x0C, 0x0A)
 */
export declare class FilterMessageFormatResponse extends Response {
    constructor(values: Values<FilterMessageFormatResponse>);
    /** On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`. */
    /** Fields and decimations. Refers to fields of Filter data. */
    descriptors: types.DescriptorRate[];
}

/**
 * Get IMU data base rate response (0x0C,0x83).
 *
 * Also called `imu_get_base_rate_response`. Response to `GetImuBaseRate`. Confirmed on 3DM-CV5-10, 3DM-CV5-15,
 * 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 15 more.
 *
 * - 3dm-gx5-15: 4.2.3 Get IMU Data Base Rate (0x0C, 0x06)
 */
export declare class GetImuBaseRateResponse extends Response {
    constructor(values: Values<GetImuBaseRateResponse>);
    /** Base rate of the sensor data. Unit: Hz. */
    rate: number;
}

/**
 * Get GNSS data base rate response (0x0C,0x84).
 *
 * Also called `gnss_get_base_rate_response`. Response to `GetGnssBaseRate`. Confirmed on 3DM-GQ4-45, 3DM-GX5-35,
 * 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 4 more. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Gnss Get Base Rate (0x0C,0x07)
 */
export declare class GetGnssBaseRateResponse extends Response {
    constructor(values: Values<GetGnssBaseRateResponse>);
    /** Base rate of the GNSS data. Unit: Hz. */
    rate: number;
}

/**
 * Data stream control response (0x0C,0x85).
 *
 * Also called `datastream_control_response`. Response to `DataStreamControl`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR,
 * 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed
 * on 25 more.
 *
 * - 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11)
 * - 3dm-cv7-gnss-ins: Data Stream Control (0x0C,0x11)
 */
export declare class DataStreamControlResponse extends Response {
    constructor(values: Values<DataStreamControlResponse>);
    /**
     * Stream specified in the command.
     *
     * - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-GX3-15, 3DM-GX3-25,
     *   3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-25 and 3DM-MV5-AR: values of `LegacyDataStream`; only
     *   `LegacyDataStream.ALL_STREAMS`, `LegacyDataStream.IMU` and `LegacyDataStream.FILTER`.
     * - On the 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-35,
     *   3DM-GX5-45, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: values of `LegacyDataStream`.
     * - On the 3DM-GX5-15: values of `LegacyDataStream`; only `LegacyDataStream.IMU` and `LegacyDataStream.FILTER`.
     */
    descriptorSet: number;
    /** True if the stream is sent. */
    enabled: boolean;
}

/**
 * IMU signal conditioning response (0x0C,0x86).
 *
 * No device is known for certain to support it. Response to `ImuSignalConditioning`. Known only from the MIP SDK of
 * 2014 and MicroStrain Communication Library.
 *
 * - mip-sdk-2014: IMU signal conditioning (0x0C,0x35)
 * - mscl: IMU signal conditioning (0x0C,0x35)
 */
export declare class ImuSignalConditioningResponse extends Response {
    constructor(values: Values<ImuSignalConditioningResponse, "reserved">);
    /** Divisor of 1000 Hz that sets the rate at which the orientation is computed. Unit: 1. Range: 1 to 1000. */
    orientationDecimation: number;
    /** Processing steps. Default: 3. */
    dataConditioningFlags: DataConditioningFlags;
    /** Width of the accelerometer and gyroscope filter in samples. Unit: 1. Range: 1 to 32. Default: 15. */
    inertialFilterWidth: number;
    /** Width of the magnetometer filter in samples. Unit: 1. Range: 1 to 32. Default: 17. */
    magFilterWidth: number;
    /** Time constant of the pitch and roll correction. Unit: s. Range: 1 to 1000. Default: 10. */
    upCompensation: number;
    /** Time constant of the heading correction. Unit: s. Range: 1 to 1000. Default: 10. */
    northCompensation: number;
    /** Bandwidth of the magnetometer of 3-series devices. */
    magBandwidth: MagBandwidth;
    /** Reserved. */
    reserved: number;
}

/**
 * UART baud rate response (0x0C,0x87).
 *
 * Also called `uart_baudrate_response`. Response to `UartBaudRate`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ4-45,
 * 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 12 more.
 *
 * - 3dm-gx5-15: 4.2.13 UART Baud Rate (0x0C, 0x40)
 * - 3dm-cv7-gnss-ins: UART Baudrate (0x0C,0x40)
 */
export declare class UartBaudRateResponse extends Response {
    constructor(values: Values<UartBaudRateResponse>);
    /** New baud rate; the port must support it. Unit: Bd. */
    baud: number;
}

/**
 * Data stream format response (0x0C,0x88).
 *
 * No device is known for certain to support it. Response to `DataStreamFormat`. Known only from the MIP SDK of 2014 and
 * MicroStrain Communication Library.
 *
 * - mip-sdk-2014: Data stream format (0x0C,0x60)
 * - mscl: Data stream format (0x0C,0x60)
 */
export declare class DataStreamFormatResponse extends Response {
    constructor(values: Values<DataStreamFormatResponse>);
    /** Stream whose format is set or read. */
    stream: InternalSensor;
    /** Format of a data stream. */
    format: StreamFormat;
}

/**
 * Device power state response (0x0C,0x89).
 *
 * No device is known for certain to support it. Response to `DevicePowerState`. Known only from the MIP SDK of 2014 and
 * MicroStrain Communication Library.
 *
 * - mip-sdk-2014: Device power state (0x0C,0x61)
 * - mscl: Device power state (0x0C,0x61)
 */
export declare class DevicePowerStateResponse extends Response {
    constructor(values: Values<DevicePowerStateResponse>);
    /** The sensor. */
    device: InternalSensor;
    /** Power state of an internal sensor. */
    state: SensorPowerState;
}

/**
 * Get estimation filter data base rate response (0x0C,0x8A).
 *
 * Also called `filter_get_base_rate_response`. Response to `GetFilterBaseRate`. Confirmed on 3DM-CV5-15, 3DM-GQ4-45,
 * 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 9 more.
 *
 * - 3dm-gx5-15: 4.2.4 Get Estimation Filter Data Base Rate (0x0C, 0x0B)
 */
export declare class GetFilterBaseRateResponse extends Response {
    constructor(values: Values<GetFilterBaseRateResponse>);
    /** Base rate of the filter data. Unit: Hz. */
    rate: number;
}

/**
 * Advanced low-pass filter settings response (0x0C,0x8B).
 *
 * Also called `imu_lowpass_filter_response`. Response to `ImuLowPassFilter`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR,
 * 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 20
 * more.
 *
 * - 3dm-gx5-15: 4.2.14 Advanced Low-Pass Filter Settings (0x0C, 0x50)
 * - 3dm-cv7-gnss-ins: Advanced Low-Pass Filter Settings (0x0C,0x50)
 */
export declare class ImuLowPassFilterResponse extends Response {
    constructor(values: Values<ImuLowPassFilterResponse, "reserved">);
    /**
     * Field descriptor in the sensor data set: scaled acceleration 0x04, angular rate 0x05, magnetic field 0x06 or
     * pressure 0x17. Refers to fields of Sensor data.
     */
    targetDescriptor: number;
    /** True if the quantity is filtered. Default: true. */
    enable: boolean;
    /** True uses `frequency`; false uses half the rate of the message format. Default: false. */
    manual: boolean;
    /** Cutoff (-3 dB). It has no meaning if `manual` is false. Unit: Hz. */
    frequency: number;
    /** Reserved. */
    reserved: number;
}

/**
 * NMEA message format response (0x0C,0x8C).
 *
 * Response to `NmeaMessageFormat`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 4 more.
 *
 * - 3dm-cv7-gnss-ins: NMEA Message Format (0x0C,0x0C)
 */
export declare class NmeaMessageFormatResponse extends Response {
    constructor(values: Values<NmeaMessageFormatResponse>);
    /** On the wire only: count. Number of sentences. Counts the elements of `formatEntries`. */
    /** Sentences to stream. */
    formatEntries: types.NmeaMessage[];
}

/**
 * Get data base rate response (0x0C,0x8E).
 *
 * Response to `GetBaseRate`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or
 * assumed on 7 more.
 *
 * - 3dm-cv7-gnss-ins: Get Data Base Rate (0x0C,0x0E)
 */
export declare class GetBaseRateResponse extends Response {
    constructor(values: Values<GetBaseRateResponse>);
    /** Data descriptor set specified in the command. */
    descriptorSet: number;
    /** Base rate; 0 if the rate is variable or unknown and data is sent as it arrives. Unit: Hz. */
    rate: number;
}

/**
 * Message format response (0x0C,0x8F).
 *
 * Response to `MessageFormat`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: Message Format (0x0C,0x0F)
 */
export declare class MessageFormatResponse extends Response {
    constructor(values: Values<MessageFormatResponse>);
    /** Data descriptor set. */
    descriptorSet: number;
    /** On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`. */
    /** Fields and decimations. Refers to fields of `descriptorSet`. */
    descriptors: types.DescriptorRate[];
}

/**
 * Basic device status (inertial sensor of the 3DM-RQ1-45) (0x0C,0x90).
 *
 * Timer only, in microseconds.
 *
 * No device is known for certain to support it. Response to `DeviceStatus`. Sent if `statusSelector` is
 * `DeviceStatusSelector.BASIC`. Uncertain: The SDK of 2014 lists the names of the values and the unit of the timer; the
 * descriptions are inferred from the names.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
export declare class DeviceStatusBasicRq1ImuResponse extends Response {
    constructor(values: Values<DeviceStatusBasicRq1ImuResponse>);
    /** On the wire only: model_number. Model number of the inertial sensor. Always 6238. */
    /** On the wire only: status_selector. Basic status. Always 1. */
    /** Reserved. */
    statusFlags: number;
    /** Time since start-up. Unit: us. */
    systemTimer: bigint;
}

/**
 * Basic device status (0x0C,0x90).
 *
 * State and timer.
 *
 * Response to `DeviceStatus`. The size of its data distinguishes it from `DeviceStatusBasicWithoutStateResponse` and
 * `DeviceStatusBasicGx3Response`. Sent if `statusSelector` is `DeviceStatusSelector.BASIC`. Confirmed on 3DM-GQ4-45,
 * 3DM-GX5-15, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 9 more.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
export declare class DeviceStatusBasicResponse extends Response {
    constructor(values: Values<DeviceStatusBasicResponse>);
    /** Model number of the device. */
    modelNumber: number;
    /** On the wire only: status_selector. Basic status. Always 1. */
    /** Reserved. */
    statusFlags: number;
    /**
     * State of the system; the meaning of its values is not documented.
     *
     * - On the 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: values of `Gx4SystemState`.
     */
    systemState: number;
    /** Time since start-up. Unit: ms. */
    systemTimer: number;
}

/**
 * Basic device status (without state) (0x0C,0x90).
 *
 * Timer only.
 *
 * No device is known for certain to support it. Response to `DeviceStatus`. The size of its data distinguishes it from
 * `DeviceStatusBasicResponse` and `DeviceStatusBasicGx3Response`. Sent if `statusSelector` is
 * `DeviceStatusSelector.BASIC`. Uncertain: MSCL uses it for the 3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-10, 3DM-CX5-10 and
 * 3DM-CV5-10, the SDK of 2014 for the 3DM-GX4-15, the 3DM-GX4-25 and the inertial sensor of the 3DM-GX4-45; that the
 * 3DM-CL5-10 has it is inferred. Uncertain: The manual of the 3DM-GX5-45 documents it too, but for the model number of
 * another device; MSCL uses the layout with a state for that device.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
export declare class DeviceStatusBasicWithoutStateResponse extends Response {
    constructor(values: Values<DeviceStatusBasicWithoutStateResponse>);
    /** Model number of the device. */
    modelNumber: number;
    /** On the wire only: status_selector. Basic status. Always 1. */
    /** Reserved. */
    statusFlags: number;
    /** Time since start-up. Unit: ms. */
    systemTimer: number;
}

/**
 * Diagnostic device status (0x0C,0x90).
 *
 * State, timer, and the counters of streams and port.
 *
 * Response to `DeviceStatus`. The size of its data distinguishes it from `DeviceStatusDiagnosticGnssResponse`,
 * `DeviceStatusDiagnosticGq4_45Response`, `DeviceStatusDiagnosticRq1_45Response`, `DeviceStatusDiagnosticGx4Response`,
 * `DeviceStatusDiagnosticImuResponse`, `DeviceStatusDiagnosticGx4ImuResponse`, `DeviceStatusDiagnosticRq1ImuResponse`
 * and `DeviceStatusDiagnosticGx3Response`. Sent if `statusSelector` is `DeviceStatusSelector.DIAGNOSTIC`. Confirmed on
 * 3DM-GX5-15; likely or assumed on 7 more.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
export declare class DeviceStatusDiagnosticResponse extends Response {
    constructor(values: Values<DeviceStatusDiagnosticResponse>);
    /** Model number of the device. */
    modelNumber: number;
    /** On the wire only: status_selector. Diagnostic status. Always 2. */
    /** Reserved. */
    statusFlags: number;
    /** State of the system; the meaning of its values is not documented. */
    systemState: number;
    /** Time since start-up. Unit: ms. */
    systemTimer: number;
    /** True if sensor data is streamed. */
    imuStreamEnabled: boolean;
    /** True if filter data is streamed. */
    filterStreamEnabled: boolean;
    /** Sensor data packets that were not sent. Unit: 1. */
    imuDroppedPackets: number;
    /** Filter data packets that were not sent. Unit: 1. */
    filterDroppedPackets: number;
    /** Bytes sent over the port. Unit: byte. */
    commPortBytesWritten: number;
    /** Bytes received over the port. Unit: byte. */
    commPortBytesRead: number;
    /** Overruns while writing to the port. Unit: 1. */
    commPortWriteOverruns: number;
    /** Overruns while reading from the port. Unit: 1. */
    commPortReadOverruns: number;
    /** IMU messages that could not be parsed. Unit: 1. */
    imuParserErrors: number;
    /** IMU messages that were read. Unit: 1. */
    imuMessageCount: number;
    /** System timer at the last IMU message. Unit: ms. */
    imuLastMessageTime: number;
}

/**
 * Diagnostic device status (with GNSS) (0x0C,0x90).
 *
 * State, timer, and the counters of pulses, streams, port and receiver.
 *
 * Response to `DeviceStatus`. The size of its data distinguishes it from `DeviceStatusDiagnosticResponse`,
 * `DeviceStatusDiagnosticGq4_45Response`, `DeviceStatusDiagnosticRq1_45Response`, `DeviceStatusDiagnosticGx4Response`,
 * `DeviceStatusDiagnosticImuResponse`, `DeviceStatusDiagnosticGx4ImuResponse`, `DeviceStatusDiagnosticRq1ImuResponse`
 * and `DeviceStatusDiagnosticGx3Response`. Sent if `statusSelector` is `DeviceStatusSelector.DIAGNOSTIC`. Confirmed on
 * 3DM-GX5-35 and 3DM-GX5-45; likely or assumed on 2 more. Uncertain: MSCL uses it for the 3DM-GX4-45 and the -35 and
 * -45 of GX5 and CX5; its length is from a manual. Uncertain: MSCL lists only the names of the values, from which the
 * descriptions are inferred; the times are assumed to be in ms like the system timer.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
export declare class DeviceStatusDiagnosticGnssResponse extends Response {
    constructor(values: Values<DeviceStatusDiagnosticGnssResponse>);
    /** Model number of the device. */
    modelNumber: number;
    /** On the wire only: status_selector. Diagnostic status. Always 2. */
    /** Reserved. */
    statusFlags: number;
    /** State of the system; the meaning of its values is not documented. */
    systemState: number;
    /** Time since start-up. Unit: ms. */
    systemTimer: number;
    /** Power state of the GNSS receiver. */
    gnssPowerState: number;
    /** Number of PPS pulses counted. Unit: 1. */
    ppsCount: number;
    /** System timer at the last pulse. Unit: ms. */
    ppsLastTime: number;
    /** True if sensor data is streamed. */
    imuStreamEnabled: boolean;
    /** True if GNSS data is streamed. */
    gnssStreamEnabled: boolean;
    /** True if filter data is streamed. */
    filterStreamEnabled: boolean;
    /** Sensor data packets that were not sent. Unit: 1. */
    imuDroppedPackets: number;
    /** GNSS data packets that were not sent. Unit: 1. */
    gnssDroppedPackets: number;
    /** Filter data packets that were not sent. Unit: 1. */
    filterDroppedPackets: number;
    /** Bytes sent over the port. Unit: byte. */
    commPortBytesWritten: number;
    /** Bytes received over the port. Unit: byte. */
    commPortBytesRead: number;
    /** Overruns while writing to the port. Unit: 1. */
    commPortWriteOverruns: number;
    /** Overruns while reading from the port. Unit: 1. */
    commPortReadOverruns: number;
    /** IMU messages that could not be parsed. Unit: 1. */
    imuParserErrors: number;
    /** IMU messages that were read. Unit: 1. */
    imuMessageCount: number;
    /** System timer at the last IMU message. Unit: ms. */
    imuLastMessageTime: number;
    /** Receiver messages that could not be parsed. Unit: 1. */
    gnssParserErrors: number;
    /** Receiver messages that were read. Unit: 1. */
    gnssMessageCount: number;
    /** System timer at the last receiver message. Unit: ms. */
    gnssLastMessageTime: number;
}

/**
 * Diagnostic device status (3DM-GQ4-45) (0x0C,0x90).
 *
 * The layout with GNSS, plus flags for parts that could not be started.
 *
 * Response to `DeviceStatus`. The size of its data distinguishes it from `DeviceStatusDiagnosticResponse`,
 * `DeviceStatusDiagnosticGnssResponse`, `DeviceStatusDiagnosticRq1_45Response`, `DeviceStatusDiagnosticGx4Response`,
 * `DeviceStatusDiagnosticImuResponse`, `DeviceStatusDiagnosticGx4ImuResponse`, `DeviceStatusDiagnosticRq1ImuResponse`
 * and `DeviceStatusDiagnosticGx3Response`. Sent if `statusSelector` is `DeviceStatusSelector.DIAGNOSTIC`. Supported by
 * 3DM-GQ4-45. Uncertain: No known manual documents it. Uncertain: MSCL lists only the names of the values, from which
 * the descriptions are inferred; the times are assumed to be in ms like the system timer.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
export declare class DeviceStatusDiagnosticGq4_45Response extends Response {
    constructor(values: Values<DeviceStatusDiagnosticGq4_45Response>);
    /** Model number of the device. */
    modelNumber: number;
    /** On the wire only: status_selector. Diagnostic status. Always 2. */
    /** Reserved. */
    statusFlags: number;
    /** State of the system; the meaning of its values is not documented. */
    systemState: number;
    /** Time since start-up. Unit: ms. */
    systemTimer: number;
    /** Power state of the GNSS receiver. */
    gnssPowerState: number;
    /** Number of PPS pulses counted. Unit: 1. */
    ppsCount: number;
    /** System timer at the last pulse. Unit: ms. */
    ppsLastTime: number;
    /** True if sensor data is streamed. */
    imuStreamEnabled: boolean;
    /** True if GNSS data is streamed. */
    gnssStreamEnabled: boolean;
    /** True if filter data is streamed. */
    filterStreamEnabled: boolean;
    /** Sensor data packets that were not sent. Unit: 1. */
    imuDroppedPackets: number;
    /** GNSS data packets that were not sent. Unit: 1. */
    gnssDroppedPackets: number;
    /** Filter data packets that were not sent. Unit: 1. */
    filterDroppedPackets: number;
    /** Bytes sent over the port. Unit: byte. */
    commPortBytesWritten: number;
    /** Bytes received over the port. Unit: byte. */
    commPortBytesRead: number;
    /** Overruns while writing to the port. Unit: 1. */
    commPortWriteOverruns: number;
    /** Overruns while reading from the port. Unit: 1. */
    commPortReadOverruns: number;
    /** IMU messages that could not be parsed. Unit: 1. */
    imuParserErrors: number;
    /** IMU messages that were read. Unit: 1. */
    imuMessageCount: number;
    /** System timer at the last IMU message. Unit: ms. */
    imuLastMessageTime: number;
    /** Receiver messages that could not be parsed. Unit: 1. */
    gnssParserErrors: number;
    /** Receiver messages that were read. Unit: 1. */
    gnssMessageCount: number;
    /** System timer at the last receiver message. Unit: ms. */
    gnssLastMessageTime: number;
    /** True if the magnetometer could not be started. */
    magInitFailed: boolean;
    /** True if the pressure sensor could not be started. */
    pressureInitFailed: boolean;
    /** True if the GNSS receiver could not be started. */
    receiverInitFailed: boolean;
}

/**
 * Diagnostic device status (3DM-RQ1-45) (0x0C,0x90).
 *
 * The layout with GNSS, plus the temperature.
 *
 * Response to `DeviceStatus`. The size of its data distinguishes it from `DeviceStatusDiagnosticResponse`,
 * `DeviceStatusDiagnosticGnssResponse`, `DeviceStatusDiagnosticGq4_45Response`, `DeviceStatusDiagnosticGx4Response`,
 * `DeviceStatusDiagnosticImuResponse`, `DeviceStatusDiagnosticGx4ImuResponse`, `DeviceStatusDiagnosticRq1ImuResponse`
 * and `DeviceStatusDiagnosticGx3Response`. Sent if `statusSelector` is `DeviceStatusSelector.DIAGNOSTIC`. Supported by
 * 3DM-RQ1-45-LT and 3DM-RQ1-45-ST. Uncertain: No known manual documents it. Uncertain: MSCL lists only the names of the
 * values, from which the descriptions are inferred; the times are assumed to be in ms like the system timer.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
export declare class DeviceStatusDiagnosticRq1_45Response extends Response {
    constructor(values: Values<DeviceStatusDiagnosticRq1_45Response>);
    /** Model number of the device. */
    modelNumber: number;
    /** On the wire only: status_selector. Diagnostic status. Always 2. */
    /** Reserved. */
    statusFlags: number;
    /** State of the system; the meaning of its values is not documented. */
    systemState: number;
    /** Time since start-up. Unit: ms. */
    systemTimer: number;
    /** Power state of the GNSS receiver. */
    gnssPowerState: number;
    /** True if the receiver starts cold at power-up. */
    coldStartOnPowerOn: number;
    /** Temperature of the board. Unit: degC. Uncertain: The unit is inferred. */
    temperature: number;
    /** System timer at the last temperature measurement. Unit: ms. */
    temperatureLastTime: number;
    /** Number of PPS pulses counted. Unit: 1. */
    ppsCount: number;
    /** System timer at the last pulse. Unit: ms. */
    ppsLastTime: number;
    /** True if sensor data is streamed. */
    imuStreamEnabled: boolean;
    /** True if GNSS data is streamed. */
    gnssStreamEnabled: boolean;
    /** True if filter data is streamed. */
    filterStreamEnabled: boolean;
    /** Sensor data packets that were not sent. Unit: 1. */
    imuDroppedPackets: number;
    /** GNSS data packets that were not sent. Unit: 1. */
    gnssDroppedPackets: number;
    /** Filter data packets that were not sent. Unit: 1. */
    filterDroppedPackets: number;
    /** Bytes sent over the port. Unit: byte. */
    commPortBytesWritten: number;
    /** Bytes received over the port. Unit: byte. */
    commPortBytesRead: number;
    /** Overruns while writing to the port. Unit: 1. */
    commPortWriteOverruns: number;
    /** Overruns while reading from the port. Unit: 1. */
    commPortReadOverruns: number;
    /** IMU messages that could not be parsed. Unit: 1. */
    imuParserErrors: number;
    /** IMU messages that were read. Unit: 1. */
    imuMessageCount: number;
    /** System timer at the last IMU message. Unit: ms. */
    imuLastMessageTime: number;
    /** Receiver messages that could not be parsed. Unit: 1. */
    gnssParserErrors: number;
    /** Receiver messages that were read. Unit: 1. */
    gnssMessageCount: number;
    /** System timer at the last receiver message. Unit: ms. */
    gnssLastMessageTime: number;
}

/**
 * Diagnostic device status (3DM-GX4-15, 3DM-GX4-25) (0x0C,0x90).
 *
 * Timer, and counters of pulses, streams, port and USB.
 *
 * No device is known for certain to support it. Response to `DeviceStatus`. The size of its data distinguishes it from
 * `DeviceStatusDiagnosticResponse`, `DeviceStatusDiagnosticGnssResponse`, `DeviceStatusDiagnosticGq4_45Response`,
 * `DeviceStatusDiagnosticRq1_45Response`, `DeviceStatusDiagnosticImuResponse`, `DeviceStatusDiagnosticGx4ImuResponse`,
 * `DeviceStatusDiagnosticRq1ImuResponse` and `DeviceStatusDiagnosticGx3Response`. Sent if `statusSelector` is
 * `DeviceStatusSelector.DIAGNOSTIC`. Uncertain: No known manual documents it for these devices; the offsets 49 to 69 in
 * the manual of the 3DM-GX5-45 agree. Uncertain: MSCL lists only the names of the values, from which the descriptions
 * are inferred; the times are assumed to be in ms like the system timer.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
export declare class DeviceStatusDiagnosticGx4Response extends Response {
    constructor(values: Values<DeviceStatusDiagnosticGx4Response>);
    /** Model number of the device. */
    modelNumber: number;
    /** On the wire only: status_selector. Diagnostic status. Always 2. */
    /** Reserved. */
    statusFlags: number;
    /** Time since start-up. Unit: ms. */
    systemTimer: number;
    /** Number of PPS pulses counted. Unit: 1. */
    ppsCount: number;
    /** System timer at the last pulse. Unit: ms. */
    ppsLastTime: number;
    /** True if sensor data is streamed. */
    imuStreamEnabled: boolean;
    /** True if filter data is streamed. */
    filterStreamEnabled: boolean;
    /** Sensor data packets that were not sent. Unit: 1. */
    imuDroppedPackets: number;
    /** Filter data packets that were not sent. Unit: 1. */
    filterDroppedPackets: number;
    /** Bytes sent over the port. Unit: byte. */
    commPortBytesWritten: number;
    /** Bytes received over the port. Unit: byte. */
    commPortBytesRead: number;
    /** Overruns while writing to the port. Unit: 1. */
    commPortWriteOverruns: number;
    /** Overruns while reading from the port. Unit: 1. */
    commPortReadOverruns: number;
    /** Bytes sent over USB. Unit: byte. */
    usbBytesWritten: number;
    /** Bytes received over USB. Unit: byte. */
    usbBytesRead: number;
    /** Overruns while writing to USB. Unit: 1. */
    usbWriteOverruns: number;
    /** Overruns while reading from USB. Unit: 1. */
    usbReadOverruns: number;
    /** IMU messages that could not be parsed. Unit: 1. */
    imuParserErrors: number;
    /** IMU messages that were read. Unit: 1. */
    imuMessageCount: number;
    /** System timer at the last IMU message. Unit: ms. */
    imuLastMessageTime: number;
}

/**
 * Diagnostic device status (IMU) (0x0C,0x90).
 *
 * Timer, available sensors, temperature, and the counters of pulses, stream and port.
 *
 * No device is known for certain to support it. Response to `DeviceStatus`. The size of its data distinguishes it from
 * `DeviceStatusDiagnosticResponse`, `DeviceStatusDiagnosticGnssResponse`, `DeviceStatusDiagnosticGq4_45Response`,
 * `DeviceStatusDiagnosticRq1_45Response`, `DeviceStatusDiagnosticGx4Response`, `DeviceStatusDiagnosticGx4ImuResponse`,
 * `DeviceStatusDiagnosticRq1ImuResponse` and `DeviceStatusDiagnosticGx3Response`. Sent if `statusSelector` is
 * `DeviceStatusSelector.DIAGNOSTIC`. Uncertain: MSCL uses it for the 3DM-GX5-10, 3DM-CX5-10 and 3DM-CV5-10; no known
 * manual documents it. Uncertain: MSCL lists only the names of the values, from which the descriptions are inferred;
 * the times are assumed to be in ms like the system timer. Uncertain: The units of the ranges are not known.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
export declare class DeviceStatusDiagnosticImuResponse extends Response {
    constructor(values: Values<DeviceStatusDiagnosticImuResponse, "reserved">);
    /** Model number of the device. */
    modelNumber: number;
    /** On the wire only: status_selector. Diagnostic status. Always 2. */
    /** Reserved. */
    statusFlags: number;
    /** Time since start-up. Unit: ms. */
    systemTimer: number;
    /** True if the device has a magnetometer. */
    hasMag: boolean;
    /** True if the device has a pressure sensor. */
    hasPressure: boolean;
    /** Power state of the sensors. */
    powerState: number;
    /** Largest measurable angular rate. */
    gyroRange: number;
    /** Largest measurable acceleration. */
    accelRange: number;
    /** Reserved. */
    reserved: number;
    /** Temperature of the board. Unit: degC. Uncertain: The unit is inferred. */
    temperature: number;
    /** System timer at the last temperature measurement. Unit: ms. */
    temperatureLastTime: number;
    /** State of the temperature measurement. */
    temperatureError: number;
    /** Number of PPS pulses counted. Unit: 1. */
    ppsCount: number;
    /** System timer at the last pulse. Unit: ms. */
    ppsLastTime: number;
    /** True if sensor data is streamed. */
    imuStreamEnabled: boolean;
    /** Sensor data packets that were not sent. Unit: 1. */
    imuDroppedPackets: number;
    /** Bytes sent over the port. Unit: byte. */
    commPortBytesWritten: number;
    /** Bytes received over the port. Unit: byte. */
    commPortBytesRead: number;
    /** Overruns while writing to the port. Unit: 1. */
    commPortWriteOverruns: number;
    /** Overruns while reading from the port. Unit: 1. */
    commPortReadOverruns: number;
}

/**
 * Diagnostic device status (inertial sensor of the 3DM-GX4-45) (0x0C,0x90).
 *
 * Timer, available sensors and their ranges, temperature, and the counters of pulses, stream and port.
 *
 * No device is known for certain to support it. Response to `DeviceStatus`. The size of its data distinguishes it from
 * `DeviceStatusDiagnosticResponse`, `DeviceStatusDiagnosticGnssResponse`, `DeviceStatusDiagnosticGq4_45Response`,
 * `DeviceStatusDiagnosticRq1_45Response`, `DeviceStatusDiagnosticGx4Response`, `DeviceStatusDiagnosticImuResponse`,
 * `DeviceStatusDiagnosticRq1ImuResponse` and `DeviceStatusDiagnosticGx3Response`. Sent if `statusSelector` is
 * `DeviceStatusSelector.DIAGNOSTIC`. Uncertain: The SDK of 2014 lists the names of the values and the units of
 * temperature and times; the descriptions are inferred from the names. Uncertain: The units of the ranges are not
 * known.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
export declare class DeviceStatusDiagnosticGx4ImuResponse extends Response {
    constructor(values: Values<DeviceStatusDiagnosticGx4ImuResponse>);
    /** Model number of the inertial sensor. */
    modelNumber: number;
    /** On the wire only: status_selector. Diagnostic status. Always 2. */
    /** Reserved. */
    statusFlags: number;
    /** Time since start-up. Unit: ms. */
    systemTimer: number;
    /** True if the device has a magnetometer. */
    hasMag: boolean;
    /** True if the device has a pressure sensor. */
    hasPressure: boolean;
    /** Largest measurable angular rate. */
    gyroRange: number;
    /** Largest measurable acceleration. */
    accelRange: number;
    /** Largest measurable magnetic field. */
    magRange: number;
    /** Largest measurable pressure. */
    pressureRange: number;
    /** Temperature of the board. Unit: degC. Uncertain: The unit is inferred. */
    temperature: number;
    /** System timer at the last temperature measurement. Unit: ms. */
    temperatureLastTime: number;
    /** State of the temperature measurement; 0 is normal. */
    temperatureError: number;
    /** Number of PPS pulses counted. Unit: 1. */
    ppsCount: number;
    /** System timer at the last pulse. Unit: ms. */
    ppsLastTime: number;
    /** True if sensor data is streamed. */
    imuStreamEnabled: boolean;
    /** Sensor data packets that were not sent. Unit: 1. */
    imuDroppedPackets: number;
    /** Bytes sent over the port. Unit: byte. */
    commPortBytesWritten: number;
    /** Bytes received over the port. Unit: byte. */
    commPortBytesRead: number;
    /** Overruns while writing to the port. Unit: 1. */
    commPortWriteOverruns: number;
    /** Overruns while reading from the port. Unit: 1. */
    commPortReadOverruns: number;
}

/**
 * Diagnostic device status (inertial sensor of the 3DM-RQ1-45) (0x0C,0x90).
 *
 * Timer, temperature and supply, and the counters of pulses, stream and port.
 *
 * No device is known for certain to support it. Response to `DeviceStatus`. The size of its data distinguishes it from
 * `DeviceStatusDiagnosticResponse`, `DeviceStatusDiagnosticGnssResponse`, `DeviceStatusDiagnosticGq4_45Response`,
 * `DeviceStatusDiagnosticRq1_45Response`, `DeviceStatusDiagnosticGx4Response`, `DeviceStatusDiagnosticImuResponse`,
 * `DeviceStatusDiagnosticGx4ImuResponse` and `DeviceStatusDiagnosticGx3Response`. Sent if `statusSelector` is
 * `DeviceStatusSelector.DIAGNOSTIC`. Uncertain: The SDK of 2014 lists the names of the values and the units of
 * temperature and times; the descriptions are inferred from the names.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
export declare class DeviceStatusDiagnosticRq1ImuResponse extends Response {
    constructor(values: Values<DeviceStatusDiagnosticRq1ImuResponse>);
    /** Model number of the inertial sensor. */
    modelNumber: number;
    /** On the wire only: status_selector. Diagnostic status. Always 2. */
    /** Reserved. */
    statusFlags: number;
    /** Time since start-up. Unit: us. */
    systemTimer: bigint;
    /** Temperature of the board. Unit: degC. Uncertain: The unit is inferred. */
    temperature: number;
    /** System timer at the last temperature measurement. Unit: ms. */
    temperatureLastTime: number;
    /** True if a temperature sensor is faulty. */
    badTemperatureSensorDetected: boolean;
    /** True if the temperature is too low. */
    coldTemperatureDetected: boolean;
    /** True if a supply voltage is out of range. */
    badVoltageDetected: boolean;
    /** Number of PPS pulses counted. Unit: 1. */
    ppsCount: number;
    /** System timer at the last pulse. Unit: ms. */
    ppsLastTime: number;
    /** True if sensor data is streamed. */
    imuStreamEnabled: boolean;
    /** Sensor data packets that were not sent. Unit: 1. */
    imuDroppedPackets: number;
    /** State of the port; the meaning of its values is not known. */
    commPortState: number;
    /** Present baud rate of the port. Unit: Bd. */
    commPortBaudRate: number;
    /** Bytes sent over the port. Unit: byte. */
    commPortBytesWritten: number;
    /** Bytes received over the port. Unit: byte. */
    commPortBytesRead: number;
    /** Overruns while writing to the port. Unit: 1. */
    commPortWriteOverruns: number;
    /** Overruns while reading from the port. Unit: 1. */
    commPortReadOverruns: number;
}

/**
 * Basic device status (3DM-GX3-35, 3DM-GX3-45) (0x0C,0x90).
 *
 * State of the port.
 *
 * No device is known for certain to support it. Response to `DeviceStatus`. The size of its data distinguishes it from
 * `DeviceStatusBasicResponse` and `DeviceStatusBasicWithoutStateResponse`. Sent if `statusSelector` is
 * `DeviceStatusSelector.BASIC`. Uncertain: Only the SDK of 2014 contains it, with the names of the values; the
 * descriptions are inferred from the names.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
export declare class DeviceStatusBasicGx3Response extends Response {
    constructor(values: Values<DeviceStatusBasicGx3Response>);
    /** Model number of the device. */
    modelNumber: number;
    /** On the wire only: status_selector. Basic status. Always 1. */
    /** Part of the device that the port is connected to. */
    commMode: number;
    /** Port in use. */
    commDevice: number;
    /** Settings of the data streams; the meaning of the bits is not known. */
    settingsFlags: number;
    /** State of the port; the meaning of its values is not known. */
    commState: number;
    /** Baud rate of the port. Unit: Bd. */
    commBaudRate: number;
}

/**
 * Diagnostic device status (3DM-GX3-35, 3DM-GX3-45) (0x0C,0x90).
 *
 * State of the port, and the counters of the port, USB, receiver and IMU.
 *
 * No device is known for certain to support it. Response to `DeviceStatus`. The size of its data distinguishes it from
 * `DeviceStatusDiagnosticResponse`, `DeviceStatusDiagnosticGnssResponse`, `DeviceStatusDiagnosticGq4_45Response`,
 * `DeviceStatusDiagnosticRq1_45Response`, `DeviceStatusDiagnosticGx4Response`, `DeviceStatusDiagnosticImuResponse`,
 * `DeviceStatusDiagnosticGx4ImuResponse` and `DeviceStatusDiagnosticRq1ImuResponse`. Sent if `statusSelector` is
 * `DeviceStatusSelector.DIAGNOSTIC`. Uncertain: Only the SDK of 2014 contains it, with the names of the values; the
 * descriptions are inferred from the names.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
export declare class DeviceStatusDiagnosticGx3Response extends Response {
    constructor(values: Values<DeviceStatusDiagnosticGx3Response>);
    /** Model number of the device. */
    modelNumber: number;
    /** On the wire only: status_selector. Diagnostic status. Always 2. */
    /** Part of the device that the port is connected to. */
    commMode: number;
    /** Port in use. */
    commDevice: number;
    /** Settings of the data streams; the meaning of the bits is not known. */
    settingsFlags: number;
    /** State of the port; the meaning of its values is not known. */
    commState: number;
    /** Baud rate of the port. Unit: Bd. */
    commBaudRate: number;
    /** Bytes sent over the port. Unit: byte. */
    commPortBytesWritten: number;
    /** Bytes received over the port. Unit: byte. */
    commPortBytesRead: number;
    /** Overruns while writing to the port. Unit: 1. */
    commPortWriteOverruns: number;
    /** Overruns while reading from the port. Unit: 1. */
    commPortReadOverruns: number;
    /** State of the USB port; the meaning of its values is not known. */
    usbState: number;
    /** Bytes sent over USB. Unit: byte. */
    usbBytesWritten: number;
    /** Bytes received over USB. Unit: byte. */
    usbBytesRead: number;
    /** Overruns while writing to USB. Unit: 1. */
    usbWriteOverruns: number;
    /** Overruns while reading from USB. Unit: 1. */
    usbReadOverruns: number;
    /** State of the receiver's driver; the meaning of its values is not known. */
    gnssDriverState: number;
    /** State of the port to the receiver; the meaning of its values is not known. */
    gnssPortState: number;
    /** Bytes sent to the receiver. Unit: byte. */
    gnssBytesWritten: number;
    /** Bytes received from the receiver. Unit: byte. */
    gnssBytesRead: number;
    /** Overruns while writing to the receiver. Unit: 1. */
    gnssWriteOverruns: number;
    /** Overruns while reading from the receiver. Unit: 1. */
    gnssReadOverruns: number;
    /** Receiver messages that were read. Unit: 1. */
    gnssMessageCount: number;
    /** Receiver messages that arrived late. Unit: 1. */
    gnssDelayedMessageCount: number;
    /** State of the IMU's driver; the meaning of its values is not known. */
    imuDriverState: number;
    /** State of the port to the IMU; the meaning of its values is not known. */
    imuPortState: number;
    /** Bytes sent to the IMU. Unit: byte. */
    imuBytesWritten: number;
    /** Bytes received from the IMU. Unit: byte. */
    imuBytesRead: number;
    /** Overruns while writing to the IMU. Unit: 1. */
    imuWriteOverruns: number;
    /** Overruns while reading from the IMU. Unit: 1. */
    imuReadOverruns: number;
    /** IMU messages that were read. Unit: 1. */
    imuMessageCount: number;
    /** IMU messages that arrived late. Unit: 1. */
    imuDelayedMessageCount: number;
}

/**
 * GPS dynamics mode response (0x0C,0x92).
 *
 * No device is known for certain to support it. Response to `GpsDynamicsMode`. Known only from the MIP SDK of 2014 and
 * MicroStrain Communication Library.
 *
 * - mip-sdk-2014: GPS dynamics mode (0x0C,0x34)
 * - mscl: GPS dynamics mode (0x0C,0x34)
 */
export declare class GpsDynamicsModeResponse extends Response {
    constructor(values: Values<GpsDynamicsModeResponse>);
    /** Assumed dynamics. */
    mode: ReceiverDynamics;
}

/**
 * IMU timestamp response (0x0C,0x93).
 *
 * No device is known for certain to support it. Response to `ImuTimestamp`. Known only from the MIP SDK of 2014.
 *
 * - mip-sdk-2014: IMU timestamp (0x0C,0x36)
 */
export declare class ImuTimestampResponse extends Response {
    constructor(values: Values<ImuTimestampResponse>);
    /** Counter to set or read. */
    selector: ImuTimestampSelector;
    /** Value of the counter, in the unit that `selector` selects. */
    time: number;
}

/**
 * Complementary filter configuration response (0x0C,0x97).
 *
 * Response to `ComplementaryFilter`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15 and 3DM-GX5-35; likely or
 * assumed on 22 more.
 *
 * - 3dm-gx5-15: 4.2.15 Complementary Filter Settings (0x0C, 0x51)
 * - 3dm-cv7-gnss-ins: Complementary Filter Configuration (0x0C,0x51)
 */
export declare class ComplementaryFilterResponse extends Response {
    constructor(values: Values<ComplementaryFilterResponse>);
    /** True enables the pitch and roll correction, which 5-series manuals call up compensation. */
    pitchRollEnable: boolean;
    /** True enables the heading correction, which 5-series manuals call north compensation. */
    headingEnable: boolean;
    /** Time constant of the pitch and roll correction. Unit: s. Range: 1 to 1000. Default: 10. */
    pitchRollTimeConstant: number;
    /** Time constant of the heading correction. Unit: s. Range: 1 to 1000. Default: 10. */
    headingTimeConstant: number;
}

/**
 * Accelerometer bias configuration response (0x0C,0x9A).
 *
 * Response to `AccelBias`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and
 * 3DM-RQ1-45-ST; likely or assumed on 24 more.
 *
 * - 3dm-gx5-15: 4.2.9 Accel Bias (0x0C, 0x37)
 * - 3dm-cv7-gnss-ins: Accelerometer Bias Configuration (0x0C,0x37)
 */
export declare class AccelBiasResponse extends Response {
    constructor(values: Values<AccelBiasResponse>);
    /** Bias that the device subtracts from the measured acceleration. Elements: x, y, z. Unit: g. Frame: sensor. */
    bias: types.Vector3f;
}

/**
 * Gyroscope bias configuration response (0x0C,0x9B).
 *
 * The bias in use.
 *
 * Also called `capture_gyro_bias_response`. Response to `GyroBias` and `CaptureGyroBias`. Confirmed on 3DM-CV7-AHRS,
 * 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST;
 * likely or assumed on 21 more.
 *
 * - 3dm-gx5-15: 4.2.10 Gyro Bias (0x0C, 0x38)
 * - 3dm-cv7-gnss-ins: Gyroscope Bias Configuration (0x0C,0x38)
 */
export declare class GyroBiasResponse extends Response {
    constructor(values: Values<GyroBiasResponse>);
    /** Bias that the device subtracts from the measured angular rate. Elements: x, y, z. Unit: rad/s. Frame: sensor. */
    bias: types.Vector3f;
}

/**
 * Magnetometer hard iron offset response (0x0C,0x9C).
 *
 * Response to `MagHardIronOffset`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-45, 3DM-RQ1-45-LT
 * and 3DM-RQ1-45-ST; likely or assumed on 14 more.
 *
 * - 3dm-cv7-gnss-ins: Magnetometer Hard Iron Offset (0x0C,0x3A)
 * - 3dm-gx5-45: (0x0C, 0x3A)
 */
export declare class MagHardIronOffsetResponse extends Response {
    constructor(values: Values<MagHardIronOffsetResponse>);
    /**
     * Offset that the device subtracts from the measured magnetic field. Elements: x, y, z. Unit: gauss. Frame: sensor.
     */
    offset: types.Vector3f;
}

/**
 * Magnetometer soft iron matrix response (0x0C,0x9D).
 *
 * Response to `MagSoftIronMatrix`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-35, 3DM-RQ1-45-LT
 * and 3DM-RQ1-45-ST; likely or assumed on 14 more.
 *
 * - 3dm-cv7-gnss-ins: Magnetometer Soft Iron Matrix (0x0C,0x3B)
 * - 3dm-gx5-35: (0x0C, 0x3B)
 */
export declare class MagSoftIronMatrixResponse extends Response {
    constructor(values: Values<MagSoftIronMatrixResponse>);
    /**
     * Soft iron matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Frame:
     * sensor.
     */
    matrix: types.Matrix3f;
}

/**
 * Coning and sculling enable response (0x0C,0x9E).
 *
 * Response to `ConingScullingEnable`. Confirmed on 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or
 * assumed on 15 more.
 *
 * - 3dm-gx5-15: 4.2.12 Coning and Sculling Enable (0x0C, 0x3E)
 */
export declare class ConingScullingEnableResponse extends Response {
    constructor(values: Values<ConingScullingEnableResponse>);
    /** True if the compensation is on. Default: true. */
    enable: boolean;
}

/**
 * Constellation settings response (0x0C,0xA0).
 *
 * Tracking channels of the receiver and the setting of each constellation.
 *
 * Response to `ConstellationSettings`. Confirmed on 3DM-GQ4-45 and 3DM-GX5-35; likely or assumed on 2 more.
 *
 * - mip-sdk-4: Constellation settings (0x0C,0x21)
 * - 3dm-gx5-35: 4.2.8 GNSS Constellation Settings (0x0C, 0x21)
 */
export declare class ConstellationSettingsResponse extends Response {
    constructor(values: Values<ConstellationSettingsResponse>);
    /** Number of channels of the receiver. Unit: 1. */
    maxChannelsAvailable: number;
    /** Maximum number of channels in use. Unit: 1. */
    maxChannelsUse: number;
    /** On the wire only: config_count. Number of entries. Counts the elements of `settings`. Range: 0 to 41. */
    /** One entry for each constellation. */
    settings: ConstellationSettingsEntry[];
}

/**
 * GNSS SBAS settings response (0x0C,0xA1).
 *
 * Response to `GnssSbasSettings`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ4-45 and 3DM-GX5-35; likely or assumed on 3
 * more.
 *
 * - 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22)
 */
export declare class GnssSbasSettingsResponse extends Response {
    constructor(values: Values<GnssSbasSettingsResponse>);
    /** 1 enables SBAS, 0 disables it. Range: 0 to 1. */
    enableSbas: number;
    /** Purposes of SBAS. */
    sbasOptions: SbasOptions;
    /**
     * On the wire only: num_included_prns. Number of satellites listed; 0 searches for all. Counts the elements of
     * `includedPrns`.
     */
    /** PRN numbers of the SBAS satellites to search for. */
    includedPrns: number[];
}

/**
 * GNSS assisted fix response (0x0C,0xA2).
 *
 * Response to `GnssAssistedFix`. Confirmed on 3DM-GX5-35; likely or assumed on 2 more. Known only from the MicroStrain
 * MIP SDK.
 *
 * - mip-sdk-4: GNSS assisted fix (0x0C,0x23)
 */
export declare class GnssAssistedFixResponse extends Response {
    constructor(values: Values<GnssAssistedFixResponse, "flags">);
    /** Storage of data for a faster first fix. Default: `AssistedFixOption.NONE`. */
    option: AssistedFixOption;
    /** Reserved. */
    flags: number;
}

/**
 * GNSS time assistance response (0x0C,0xA3).
 *
 * Response to `GnssTimeAssistance`. Confirmed on 3DM-GX5-35; likely or assumed on 2 more. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: GNSS time assistance (0x0C,0x24)
 */
export declare class GnssTimeAssistanceResponse extends Response {
    constructor(values: Values<GnssTimeAssistanceResponse>);
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. */
    tow: number;
    /** GPS week number since 1980. Unit: week. */
    weekNumber: number;
    /** Estimated accuracy of the time that is sent. Unit: s. Range: at least 0. */
    accuracy: number;
}

/**
 * PPS source control response (0x0C,0xA8).
 *
 * Also called `pps_source_response`. Response to `PpsSourceControl`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed
 * on 10 more.
 *
 * - 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28)
 */
export declare class PpsSourceControlResponse extends Response {
    constructor(values: Values<PpsSourceControlResponse>);
    /** Source of the pulse. */
    source: PpsSource;
}

/**
 * Sensor-to-vehicle frame transformation Euler response (0x0C,0xB1).
 *
 * Also called `sensor_2_vehicle_transform_euler_response`. Response to `SensorToVehicleTransformEuler`. Confirmed on
 * 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 9 more.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Euler (0x0C,0x31)
 */
export declare class SensorToVehicleTransformEulerResponse extends Response {
    constructor(values: Values<SensorToVehicleTransformEulerResponse>);
    /** Roll angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive: right side down. */
    roll: number;
    /** Pitch angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive: nose up. */
    pitch: number;
    /**
     * Yaw angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive: clockwise seen from above.
     */
    yaw: number;
}

/**
 * Sensor-to-vehicle frame transformation quaternion response (0x0C,0xB2).
 *
 * Also called `sensor_2_vehicle_transform_quaternion_response`. Response to `SensorToVehicleTransformQuaternion`.
 * Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Quaternion (0x0C,0x32)
 */
export declare class SensorToVehicleTransformQuaternionResponse extends Response {
    constructor(values: Values<SensorToVehicleTransformQuaternionResponse>);
    /**
     * Rotates vectors of the vehicle frame into the sensor frame; unit quaternion, w first. Elements: w, x, y, z. Unit:
     * 1.
     */
    q: types.Quatf;
}

/**
 * Sensor-to-vehicle frame transformation direction cosine matrix response (0x0C,0xB3).
 *
 * Also called `sensor_2_vehicle_transform_dcm_response`. Response to `SensorToVehicleTransformDcm`. Confirmed on
 * 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix (0x0C,0x33)
 */
export declare class SensorToVehicleTransformDcmResponse extends Response {
    constructor(values: Values<SensorToVehicleTransformDcmResponse>);
    /**
     * Rotates vectors of the sensor frame into the vehicle frame; row-major. Elements: m11, m12, m13, m21, m22, m23,
     * m31, m32, m33. Unit: 1.
     */
    dcm: types.Matrix3f;
}

/**
 * Get supported events response (0x0C,0xB4).
 *
 * Response to `GetEventSupport`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8
 * more.
 *
 * - 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A)
 */
export declare class GetEventSupportResponse extends Response {
    constructor(values: Values<GetEventSupportResponse>);
    /** Query specified in the command. */
    query: EventSupportQuery;
    /** Number of instances, which are numbered from 1. Unit: 1. */
    maxInstances: number;
    /** On the wire only: num_entries. Number of types. Counts the elements of `entries`. */
    /**
     * The types.
     *
     * - If `query` is `EventSupportQuery.TRIGGER_TYPES`: `type` has values of `types.EventTriggerType`.
     * - If `query` is `EventSupportQuery.ACTION_TYPES`: `type` has values of `types.EventActionType`.
     */
    entries: EventSupportInfo[];
}

/**
 * Event control response (0x0C,0xB5).
 *
 * Response to `EventControl`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B)
 */
export declare class EventControlResponse extends Response {
    constructor(values: Values<EventControlResponse>);
    /** Trigger instance. */
    instance: number;
    /** Mode of the trigger. Default: `types.EventTriggerMode.DISABLED`. */
    mode: types.EventTriggerMode;
}

/**
 * Get event trigger status response (0x0C,0xB6).
 *
 * Response to `GetEventTriggerStatus`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
 */
export declare class GetEventTriggerStatusResponse extends Response {
    constructor(values: Values<GetEventTriggerStatusResponse>);
    /** On the wire only: count. Number of entries. Counts the elements of `triggers`. */
    /** One entry per trigger, in the requested order, or by instance if all were requested. */
    triggers: EventTriggerStatusEntry[];
}

/**
 * Get event action status response (0x0C,0xB7).
 *
 * Response to `GetEventActionStatus`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D)
 */
export declare class GetEventActionStatusResponse extends Response {
    constructor(values: Values<GetEventActionStatusResponse>);
    /** On the wire only: count. Number of entries. Counts the elements of `actions`. */
    /** One entry per action, in the requested order, or by instance if all were requested. */
    actions: EventActionStatusEntry[];
}

/**
 * Event trigger configuration response (0x0C,0xB8).
 *
 * Also called `event_trigger_response`. Response to `EventTriggerConfig`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and
 * 3DM-CV7-GNSS/INS; likely or assumed on 8 more.
 *
 * - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
 */
export declare class EventTriggerConfigResponse extends Response {
    constructor(values: Values<EventTriggerConfigResponse>);
    /** Trigger instance. */
    instance: number;
    /** Kind of trigger. Default: `types.EventTriggerType.NONE`. */
    type: types.EventTriggerType;
    /**
     * The condition. Selected by `type`.
     *
     * - If `type` is `types.EventTriggerType.NONE`: `{}`.
     * - If `type` is `types.EventTriggerType.GPIO`: `gpio: types.EventTriggerGpio`.
     * - If `type` is `types.EventTriggerType.THRESHOLD`: `threshold: types.EventTriggerThreshold`.
     * - If `type` is `types.EventTriggerType.COMBINATION`: `combination: types.EventTriggerCombination`.
     */
    parameters: { gpio?: types.EventTriggerGpio; threshold?: types.EventTriggerThreshold; combination?: types.EventTriggerCombination };
}

/**
 * Event action configuration response (0x0C,0xB9).
 *
 * Also called `event_action_response`. Response to `EventActionConfig`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and
 * 3DM-CV7-GNSS/INS; likely or assumed on 8 more.
 *
 * - 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
 * - 3dm-cv7-gnss-ins: Event Cycle
 */
export declare class EventActionConfigResponse extends Response {
    constructor(values: Values<EventActionConfigResponse>);
    /** Action instance. */
    instance: number;
    /** Trigger instance that the action follows. */
    trigger: number;
    /** Kind of action. Default: `types.EventActionType.NONE`. */
    type: types.EventActionType;
    /**
     * Effect of the action. Selected by `type`.
     *
     * - If `type` is `types.EventActionType.NONE`: `{}`.
     * - If `type` is `types.EventActionType.GPIO`: `gpio: types.EventActionGpio`.
     * - If `type` is `types.EventActionType.MESSAGE`: `message: types.EventActionMessage`.
     */
    parameters: { gpio?: types.EventActionGpio; message?: types.EventActionMessage };
}

/**
 * GPIO configuration response (0x0C,0xC1).
 *
 * Response to `GpioConfig`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8 more.
 *
 * - 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41)
 */
export declare class GpioConfigResponse extends Response {
    constructor(values: Values<GpioConfigResponse>);
    /** GPIO pin, counted from 1. */
    pin: number;
    /** Use of the pin. Default: `types.GpioFeature.UNUSED`. */
    feature: types.GpioFeature;
    /**
     * Role of the pin within the feature; 0 if the feature has no roles.
     *
     * - If `feature` is `types.GpioFeature.UNUSED`: values of `types.GpioUnusedBehavior`.
     * - If `feature` is `types.GpioFeature.GPIO`: values of `types.GpioBehavior`.
     * - If `feature` is `types.GpioFeature.PPS`: values of `types.GpioPpsBehavior`.
     * - If `feature` is `types.GpioFeature.ENCODER`: values of `types.GpioEncoderBehavior`.
     * - If `feature` is `types.GpioFeature.TIMESTAMP`: values of `types.GpioTimestampBehavior`.
     * - If `feature` is `types.GpioFeature.UART`: values of `types.GpioUartBehavior`.
     */
    behavior: number;
    /** Electrical options. */
    pinMode: types.GpioPinMode;
}

/**
 * GPIO state response (0x0C,0xC2).
 *
 * Response to `GpioState`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 9 more.
 *
 * - 3dm-cv7-gnss-ins: GPIO State (0x0C,0x42)
 */
export declare class GpioStateResponse extends Response {
    constructor(values: Values<GpioStateResponse>);
    /** GPIO pin, counted from 1. Range: at least 1. */
    pin: number;
    /** True means high. */
    state: boolean;
}

/**
 * Odometer configuration response (0x0C,0xC3).
 *
 * Also called `odometer_response`. Response to `OdometerConfig`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1
 * more.
 *
 * - 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43)
 */
export declare class OdometerConfigResponse extends Response {
    constructor(values: Values<OdometerConfigResponse>);
    /** Operation of the input. */
    mode: OdometerMode;
    /**
     * Pulses per distance travelled; negative if the encoder rotates backwards. Unit: pulse/m. Pulses on line A per
     * turn of the wheel, divided by the circumference of the wheel.
     */
    scaling: number;
    /** Relative uncertainty of the scaling, 1 sigma. Unit: 1. Range: at least 0. */
    uncertainty: number;
}

/**
 * Sensor range response (0x0C,0xD2).
 *
 * Response to `SensorRange`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52)
 */
export declare class SensorRangeResponse extends Response {
    constructor(values: Values<SensorRangeResponse>);
    /** Sensor whose range is set or read. */
    sensor: SensorRangeType;
    /** Number of the range. */
    setting: number;
}

/**
 * Get calibrated sensor ranges response (0x0C,0xD3).
 *
 * Also called `calibrated_sensor_ranges_response`. Response to `GetCalibratedSensorRanges`. Confirmed on
 * 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53)
 */
export declare class GetCalibratedSensorRangesResponse extends Response {
    constructor(values: Values<GetCalibratedSensorRangesResponse>);
    /** Sensor specified in the command. */
    sensor: SensorRangeType;
    /** On the wire only: num_ranges. Number of ranges. Counts the elements of `ranges`. */
    /**
     * Ranges for which the sensor is calibrated.
     *
     * - If `sensor` is `SensorRangeType.ACCEL`: `range` has unit g.
     * - If `sensor` is `SensorRangeType.GYRO`: `range` has unit deg/s.
     * - If `sensor` is `SensorRangeType.MAG`: `range` has unit gauss.
     * - If `sensor` is `SensorRangeType.PRESSURE`: `range` has unit mbar.
     */
    ranges: SensorRangeEntry[];
}

/**
 * Low-pass anti-aliasing filter response (0x0C,0xD4).
 *
 * Also called `lowpass_filter_response`. Response to `LowPassFilter`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR,
 * 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 7 more.
 *
 * - 3dm-cv7-gnss-ins: Low-Pass Anti-Aliasing Filter (0x0C,0x54)
 */
export declare class LowPassFilterResponse extends Response {
    constructor(values: Values<LowPassFilterResponse>);
    /** Descriptor set of the field. */
    descriptorSet: number;
    /** Descriptor of the field that is filtered. Refers to fields of `descriptorSet`. */
    fieldDescriptor: number;
    /** True if the field is filtered. */
    enable: boolean;
    /** True uses `frequency`; false uses half the rate of the field in the message format. */
    manual: boolean;
    /** Cutoff in use. Unit: Hz. Range: at least 0. */
    frequency: number;
}

/**
 * Poll IMU data (0x0C,0x01).
 *
 * Requests one sensor data packet (0x80) with the listed fields, in the listed order.
 *
 * Also called `poll_imu_message`. Not acknowledged if `suppressAck` is true. Devices without it may have `PollData`.
 * Confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST;
 * likely or assumed on 15 more.
 *
 * An empty list polls the fields that `ImuMessageFormat` stores; if nothing is stored, the device rejects the command.
 * Descriptors that the device does not know are ignored. The data is sent in a separate packet after the reply.
 *
 * - 3dm-gx5-15: 4.2.1 Poll IMU Data (0x0C, 0x01)
 */
export declare class PollImuData extends Command<undefined> {
    constructor(values: Values<PollImuData>);
    /** Send no acknowledge. */
    suppressAck: boolean;
    /** On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`. */
    /** Fields to send. Refers to fields of Sensor data. */
    descriptors: PollEntry[];
}

/**
 * Poll GNSS data (0x0C,0x02).
 *
 * Requests one GNSS data packet with the listed fields, in the listed order.
 *
 * Also called `poll_gnss_message`. Not acknowledged if `suppressAck` is true. Devices without it may have `PollData`.
 * Confirmed on 3DM-GQ4-45, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 5 more. Known only from
 * the MicroStrain MIP SDK. Requires a receiver.
 *
 * An empty list polls the format stored by `GnssMessageFormat`; if none is stored, the device rejects the command.
 * Descriptors that the device does not know are omitted. The data is sent in a separate packet after the reply.
 *
 * - mip-sdk-4: Poll Gnss Message (0x0C,0x02)
 */
export declare class PollGnssData extends Command<undefined> {
    constructor(values: Values<PollGnssData>);
    /** Send no acknowledge. */
    suppressAck: boolean;
    /** On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`. Range: 0 to 83. */
    /**
     * Fields to send. Refers to fields of GNSS data. Uncertain: The SDK has a decimation in place of the reserved
     * number and does not document how a poll uses it.
     */
    descriptors: PollEntry[];
}

/**
 * Poll estimation filter data (0x0C,0x03).
 *
 * Requests one filter data packet (0x82) with the listed fields, in the listed order.
 *
 * Also called `poll_filter_message`. Not acknowledged if `suppressAck` is true. Devices without it may have `PollData`.
 * Confirmed on 3DM-CV5-15, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 8
 * more.
 *
 * An empty list polls the fields that `FilterMessageFormat` stores; if none are, the device rejects the command.
 * Descriptors that the device does not know are ignored. The data is sent in a separate packet after the reply.
 *
 * - 3dm-gx5-15: 4.2.2 Poll Estimation Filter Data (0x0C, 0x03)
 */
export declare class PollFilterData extends Command<undefined> {
    constructor(values: Values<PollFilterData>);
    /** Send no acknowledge. */
    suppressAck: boolean;
    /** On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`. */
    /** Fields to send. Refers to fields of Filter data. */
    descriptors: PollEntry[];
}

/**
 * Poll NMEA data (0x0C,0x04).
 *
 * Requests the listed NMEA sentences once.
 *
 * Also called `nmea_poll_data`. Not acknowledged if `suppressAck` is true. Confirmed on 3DM-CV7-GNSS/INS and
 * 3DM-GQ7-GNSS/INS; likely or assumed on 3 more.
 *
 * An empty list polls the stored NMEA format; if none is stored, the device rejects the command. The sentences follow
 * the reply as ordinary NMEA text, on the port of the command, even if NMEA is disabled there. A sentence is sent only
 * if its data is valid.
 *
 * - 3dm-cv7-gnss-ins: Poll NMEA Data (0x0C,0x04)
 */
export declare class PollNmeaData extends Command<undefined> {
    constructor(values: Values<PollNmeaData>);
    /** Send no acknowledge. */
    suppressAck: boolean;
    /** On the wire only: count. Number of sentences. Counts the elements of `formatEntries`. */
    /** Sentences to send. */
    formatEntries: types.NmeaMessage[];
}

/**
 * Get IMU data base rate (0x0C,0x06).
 *
 * Gets the base rate, which is divided by the decimations of `ImuMessageFormat`.
 *
 * Also called `imu_get_base_rate`. Response: `GetImuBaseRateResponse`. Devices without it may have `GetBaseRate`.
 * Confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST;
 * likely or assumed on 15 more.
 *
 * - 3dm-gx5-15: 4.2.3 Get IMU Data Base Rate (0x0C, 0x06)
 */
export declare class GetImuBaseRate extends Command<GetImuBaseRateResponse> {
    constructor();
}

/**
 * Get GNSS data base rate (0x0C,0x07).
 *
 * Gets the base rate, which is divided by the decimations of `GnssMessageFormat`.
 *
 * Also called `gnss_get_base_rate`. Response: `GetGnssBaseRateResponse`. Devices without it may have `GetBaseRate`.
 * Confirmed on 3DM-GQ4-45, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 4 more. Known
 * only from the MicroStrain MIP SDK. Requires a receiver.
 *
 * - mip-sdk-4: Gnss Get Base Rate (0x0C,0x07)
 */
export declare class GetGnssBaseRate extends Command<GetGnssBaseRateResponse> {
    constructor();
}

/**
 * IMU message format (0x0C,0x08).
 *
 * Sets the fields of the sensor data packets (0x80), their order and their decimations.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `ImuMessageFormatResponse`. Devices without it
 * may have `MessageFormat`. Confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35,
 * 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 14 more.
 *
 * The decimation is the base rate, as `GetImuBaseRate` reports it, divided by the desired rate. The list replaces the
 * previous one. If any descriptor is unknown, the device rejects the command and changes nothing.
 *
 * - 3dm-gx5-15: 4.2.5 IMU Message Format (0x0C, 0x08)
 */
export declare class ImuMessageFormat<R extends Response | undefined = undefined | ImuMessageFormatResponse> extends Command<R> {
    constructor(values: Values<ImuMessageFormat>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`. Required for `write`.
     */
    /** Fields and decimations. Refers to fields of Sensor data. Required for `write`. */
    descriptors?: types.DescriptorRate[];
    /** Apply the new setting. */
    static write(values: { descriptors: types.DescriptorRate[] }): ImuMessageFormat<undefined>;
    /** Return the current setting in a response. */
    static read(): ImuMessageFormat<ImuMessageFormatResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): ImuMessageFormat<undefined>;
    /** Load the saved setting. */
    static load(): ImuMessageFormat<undefined>;
    /** Load the factory default setting. */
    static default(): ImuMessageFormat<undefined>;
}

/**
 * GNSS message format (0x0C,0x09).
 *
 * Sets the fields of the GNSS data packets, their order and their decimations.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `GnssMessageFormatResponse`. Devices without it
 * may have `MessageFormat`. Confirmed on 3DM-GQ4-45, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or
 * assumed on 4 more. Requires a receiver.
 *
 * The decimation is the base rate, as `GetGnssBaseRate` reports it, divided by the desired rate.
 *
 * - mip-sdk-4: GNSS message format (0x0C,0x09)
 * - 3dm-gx5-35: 4.2.6 GNSS Message Format (0x0C, 0x09)
 */
export declare class GnssMessageFormat<R extends Response | undefined = undefined | GnssMessageFormatResponse> extends Command<R> {
    constructor(values: Values<GnssMessageFormat>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`. Range: 0 to 82.
     * Required for `write`.
     */
    /** Fields and decimations. Refers to fields of GNSS data. Required for `write`. */
    descriptors?: types.DescriptorRate[];
    /** Apply the new setting. */
    static write(values: { descriptors: types.DescriptorRate[] }): GnssMessageFormat<undefined>;
    /** Return the current setting in a response. */
    static read(): GnssMessageFormat<GnssMessageFormatResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): GnssMessageFormat<undefined>;
    /** Load the saved setting. */
    static load(): GnssMessageFormat<undefined>;
    /** Load the factory default setting. */
    static default(): GnssMessageFormat<undefined>;
}

/**
 * Estimation filter message format (0x0C,0x0A).
 *
 * Sets the fields of the filter data packets (0x82), their order and their decimations.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `FilterMessageFormatResponse`. Devices without it
 * may have `MessageFormat`. Confirmed on 3DM-CV5-15, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and
 * 3DM-RQ1-45-ST; likely or assumed on 9 more.
 *
 * The decimation is the base rate, as `GetFilterBaseRate` reports it, divided by the desired rate. The list replaces
 * the previous one. If any descriptor is unknown, the device rejects the command and changes nothing.
 *
 * - 3dm-gx5-15: 4.2.6 Estimation Filter Message Format (0x0C, 0x0A)
 */
export declare class FilterMessageFormat<R extends Response | undefined = undefined | FilterMessageFormatResponse> extends Command<R> {
    constructor(values: Values<FilterMessageFormat>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`. Required for `write`.
     */
    /** Fields and decimations. Refers to fields of Filter data. Required for `write`. */
    descriptors?: types.DescriptorRate[];
    /** Apply the new setting. */
    static write(values: { descriptors: types.DescriptorRate[] }): FilterMessageFormat<undefined>;
    /** Return the current setting in a response. */
    static read(): FilterMessageFormat<FilterMessageFormatResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): FilterMessageFormat<undefined>;
    /** Load the saved setting. */
    static load(): FilterMessageFormat<undefined>;
    /** Load the factory default setting. */
    static default(): FilterMessageFormat<undefined>;
}

/**
 * Get estimation filter data base rate (0x0C,0x0B).
 *
 * Gets the base rate, which is divided by the decimations of `FilterMessageFormat`.
 *
 * Also called `filter_get_base_rate`. Response: `GetFilterBaseRateResponse`. Devices without it may have `GetBaseRate`.
 * Confirmed on 3DM-CV5-15, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 9
 * more.
 *
 * - 3dm-gx5-15: 4.2.4 Get Estimation Filter Data Base Rate (0x0C, 0x0B)
 */
export declare class GetFilterBaseRate extends Command<GetFilterBaseRateResponse> {
    constructor();
}

/**
 * NMEA message format (0x0C,0x0C).
 *
 * Sets the NMEA sentences that the device streams.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `NmeaMessageFormatResponse`. Confirmed on
 * 3DM-CV7-GNSS/INS; likely or assumed on 4 more.
 *
 * A sentence may be listed several times with different talkers or sources. A sentence is sent only while the device is
 * not idle and the data of the source is valid. The 3DM-CV7-GNSS/INS rejects the format if a sentence would be sent
 * more than 10 times per second, or, from a GNSS set, more than twice.
 *
 * - 3dm-cv7-gnss-ins: NMEA Message Format (0x0C,0x0C)
 */
export declare class NmeaMessageFormat<R extends Response | undefined = undefined | NmeaMessageFormatResponse> extends Command<R> {
    constructor(values: Values<NmeaMessageFormat>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** On the wire only: count. Number of sentences. Counts the elements of `formatEntries`. Required for `write`. */
    /** Sentences to stream. Required for `write`. */
    formatEntries?: types.NmeaMessage[];
    /** Apply the new setting. */
    static write(values: { formatEntries: types.NmeaMessage[] }): NmeaMessageFormat<undefined>;
    /** Return the current setting in a response. */
    static read(): NmeaMessageFormat<NmeaMessageFormatResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): NmeaMessageFormat<undefined>;
    /** Load the saved setting. */
    static load(): NmeaMessageFormat<undefined>;
    /** Load the factory default setting. */
    static default(): NmeaMessageFormat<undefined>;
}

/**
 * Poll data (0x0C,0x0D).
 *
 * Requests one data packet of the descriptor set with the listed fields, in the listed order.
 *
 * Not acknowledged if `suppressAck` is true. Devices without it may have `PollImuData`, `PollGnssData` and
 * `PollFilterData`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * An empty list polls the fields that `MessageFormat` stores; if nothing is stored, the device rejects the command.
 * Descriptors that the device does not know are ignored. The data is sent in a separate packet after the reply, on the
 * port of the command. List shared descriptors (0xD0 and up) before the others.
 *
 * - 3dm-cv7-gnss-ins: Poll Data (0x0C,0x0D)
 */
export declare class PollData extends Command<undefined> {
    constructor(values: Values<PollData>);
    /** Data descriptor set. Range: 0x80 to 0xFE. */
    descriptorSet: number;
    /** Send no acknowledge. */
    suppressAck: boolean;
    /** On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`. */
    /** Field descriptors. Refers to fields of `descriptorSet`. */
    descriptors: number[];
}

/**
 * Get data base rate (0x0C,0x0E).
 *
 * Gets the base rate, which is divided by the decimations of a descriptor set.
 *
 * Response: `GetBaseRateResponse`. Devices without it may have `GetImuBaseRate`, `GetGnssBaseRate` and
 * `GetFilterBaseRate`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed
 * on 7 more.
 *
 * - 3dm-cv7-gnss-ins: Get Data Base Rate (0x0C,0x0E)
 */
export declare class GetBaseRate extends Command<GetBaseRateResponse> {
    constructor(values: Values<GetBaseRate>);
    /** Data descriptor set. Range: 0x80 to 0xFE. */
    descriptorSet: number;
}

/**
 * Message format (0x0C,0x0F).
 *
 * Sets the fields of the data packets of a descriptor set, their order and their decimations.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `MessageFormatResponse`. Devices without it may
 * have `ImuMessageFormat`, `GnssMessageFormat` and `FilterMessageFormat`. Confirmed on 3DM-CV7-GNSS/INS; likely or
 * assumed on 10 more.
 *
 * The decimation is the base rate, as `GetBaseRate` reports it, divided by the desired rate. List shared descriptors
 * (0xD0 and up) under the set whose packets will contain them, before the others.
 *
 * - 3dm-cv7-gnss-ins: Message Format (0x0C,0x0F)
 */
export declare class MessageFormat<R extends Response | undefined = undefined | MessageFormatResponse> extends Command<R> {
    constructor(values: Values<MessageFormat>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Data descriptor set; 0 means all of them (save, load, default). */
    descriptorSet?: number;
    /**
     * On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`. Required for `write`.
     */
    /** Fields and decimations. Refers to fields of `descriptorSet`. Required for `write`. */
    descriptors?: types.DescriptorRate[];
    /** Apply the new setting. */
    static write(values: { descriptorSet: number; descriptors: types.DescriptorRate[] }): MessageFormat<undefined>;
    /** Return the current setting in a response. */
    static read(values: { descriptorSet: number }): MessageFormat<MessageFormatResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { descriptorSet: number }): MessageFormat<undefined>;
    /** Load the saved setting. */
    static load(values: { descriptorSet: number }): MessageFormat<undefined>;
    /** Load the factory default setting. */
    static default(values: { descriptorSet: number }): MessageFormat<undefined>;
}

/**
 * Factory streaming (0x0C,0x10).
 *
 * Sets all message formats to those that technical support needs in a recording.
 *
 * Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: Factory Streaming (0x0C,0x10)
 */
export declare class FactoryStreaming extends Command<undefined> {
    constructor(values: Values<FactoryStreaming, "reserved">);
    /** Treatment of the existing formats. */
    action: FactoryStreamingAction;
    /** Reserved: send 0. */
    reserved: number;
}

/**
 * Data stream control (0x0C,0x11).
 *
 * Switches a data stream on or off.
 *
 * Also called `datastream_control`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `DataStreamControlResponse`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45,
 * 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 25 more.
 *
 * Devices of the generations 3 to 5 identify the stream by a number (`LegacyDataStream`), other devices by its
 * descriptor set. A newly enabled stream starts with current data, without any from before.
 *
 * - 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11)
 * - 3dm-cv7-gnss-ins: Data Stream Control (0x0C,0x11)
 */
export declare class DataStreamControl<R extends Response | undefined = undefined | DataStreamControlResponse> extends Command<R> {
    constructor(values: Values<DataStreamControl>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Data descriptor set; 0 means all streams (save, load, default).
     *
     * - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-GX3-15, 3DM-GX3-25,
     *   3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-25 and 3DM-MV5-AR: values of `LegacyDataStream`; only
     *   `LegacyDataStream.ALL_STREAMS`, `LegacyDataStream.IMU` and `LegacyDataStream.FILTER`.
     * - On the 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-35,
     *   3DM-GX5-45, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: values of `LegacyDataStream`.
     * - On the 3DM-GX5-15: values of `LegacyDataStream`; only `LegacyDataStream.IMU` and `LegacyDataStream.FILTER`.
     */
    descriptorSet?: number;
    /**
     * True if the stream is sent. Default: true. Required for `write`. The stream starts with current data. What was
     * measured while it was disabled is not sent.
     */
    enable?: boolean;
    /** Apply the new setting. */
    static write(values: { descriptorSet: number; enable: boolean }): DataStreamControl<undefined>;
    /** Return the current setting in a response. */
    static read(values: { descriptorSet: number }): DataStreamControl<DataStreamControlResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { descriptorSet: number }): DataStreamControl<undefined>;
    /** Load the saved setting. */
    static load(values: { descriptorSet: number }): DataStreamControl<undefined>;
    /** Load the factory default setting. */
    static default(values: { descriptorSet: number }): DataStreamControl<undefined>;
}

/**
 * Raw RTCM 2.3 message (0x0C,0x20).
 *
 * Sends RTCM 2.3 corrections to the GNSS receiver.
 *
 * Supported by 3DM-GQ4-45, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST. Requires a receiver.
 *
 * The receiver uses the RTCM messages 1, 2, 3 and 9. A message may be split at any byte and sent with several of these
 * commands.
 *
 * - 3dm-gx5-45: 4.2.26 Raw RTCM 2.3 Message (0x0C, 0x20)
 * - mip-sdk-2014: Raw RTCM 2.3 message (0x0C,0x20)
 * - mscl: Raw RTCM 2.3 message (0x0C,0x20)
 */
export declare class RawRtcm2_3Message extends Command<undefined> {
    constructor(values: Values<RawRtcm2_3Message>);
    /** Bytes of the RTCM stream. */
    data: number[];
}

/**
 * Constellation settings (0x0C,0x21).
 *
 * Selects the constellations that the GNSS receiver tracks, and their shares of its tracking channels.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `ConstellationSettingsResponse`. Probably affects
 * `gnss_data.FixInfo`, `gnss_data.SvInfo` and `gnss_data.SatelliteStatus`. Confirmed on 3DM-GQ4-45 and 3DM-GX5-35;
 * likely or assumed on 2 more. Requires a receiver. Uncertain: The factory default is doubtful: the SDK names only GPS
 * and GLONASS as enabled, but has channels for SBAS and QZSS too.
 *
 * The device rejects entries that reserve more than 32 channels in total. The maximum of an entry must not be less than
 * the number of channels it reserves. GLONASS and BeiDou cannot be used together. If the antenna or its filter is made
 * for GPS only, leave GLONASS and BeiDou off. SBAS and QZSS improve the accuracy of GPS. SBAS does not make the device
 * suitable for safety-of-life use. Factory default: GPS and GLONASS are enabled. Reserved and maximum channels: GPS 8
 * and 16, GLONASS 8 and 14, SBAS 1 and 3, QZSS 0 and 3.
 *
 * - mip-sdk-4: Constellation settings (0x0C,0x21)
 * - 3dm-gx5-35: 4.2.8 GNSS Constellation Settings (0x0C, 0x21)
 */
export declare class ConstellationSettings<R extends Response | undefined = undefined | ConstellationSettingsResponse> extends Command<R> {
    constructor(values: Values<ConstellationSettings>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Maximum number of tracking channels in use; at most the number that the response reports as available. Unit: 1.
     * Required for `write`.
     */
    maxChannels?: number;
    /**
     * On the wire only: config_count. Number of entries. Counts the elements of `settings`. Range: 0 to 41. Required
     * for `write`.
     */
    /** One entry for each constellation. Required for `write`. */
    settings?: ConstellationSettingsEntry[];
    /** Apply the new setting. */
    static write(values: { maxChannels: number; settings: ConstellationSettingsEntry[] }): ConstellationSettings<undefined>;
    /** Return the current setting in a response. */
    static read(): ConstellationSettings<ConstellationSettingsResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): ConstellationSettings<undefined>;
    /** Load the saved setting. */
    static load(): ConstellationSettings<undefined>;
    /** Load the factory default setting. */
    static default(): ConstellationSettings<undefined>;
}

/**
 * GNSS SBAS settings (0x0C,0x22).
 *
 * Sets how the GNSS receivers use satellite-based augmentation (SBAS).
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `GnssSbasSettingsResponse`. Probably affects
 * `gnss_data.SbasInfo` and `gnss_data.SbasCorrection`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ4-45 and 3DM-GX5-35; likely
 * or assumed on 3 more. Requires a receiver.
 *
 * - 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22)
 */
export declare class GnssSbasSettings<R extends Response | undefined = undefined | GnssSbasSettingsResponse> extends Command<R> {
    constructor(values: Values<GnssSbasSettings>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * 1 enables SBAS, 0 disables it. Range: 0 to 1. Required for `write`.
     *
     * - On the 3DM-GX5-35: default 1.
     */
    enableSbas?: number;
    /**
     * Purposes of SBAS. Required for `write`.
     *
     * - On the 3DM-GX5-35: default `SbasOptions.ENABLE_RANGING` and `SbasOptions.ENABLE_CORRECTIONS`.
     */
    sbasOptions?: SbasOptions;
    /**
     * On the wire only: num_included_prns. Number of satellites listed; 0 searches for all. Counts the elements of
     * `includedPrns`. Required for `write`.
     */
    /** PRN numbers of the SBAS satellites to search for. Required for `write`. */
    includedPrns?: number[];
    /** Apply the new setting. */
    static write(values: { enableSbas: number; sbasOptions: SbasOptions; includedPrns: number[] }): GnssSbasSettings<undefined>;
    /** Return the current setting in a response. */
    static read(): GnssSbasSettings<GnssSbasSettingsResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): GnssSbasSettings<undefined>;
    /** Load the saved setting. */
    static load(): GnssSbasSettings<undefined>;
    /** Load the factory default setting. */
    static default(): GnssSbasSettings<undefined>;
}

/**
 * GNSS assisted fix (0x0C,0x23).
 *
 * Sets whether the GNSS receiver keeps the data of its last fix and starts from it at the next power-up.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `GnssAssistedFixResponse`. Confirmed on
 * 3DM-GX5-35; likely or assumed on 2 more. Known only from the MicroStrain MIP SDK. Requires a receiver.
 *
 * The last fix is kept in the flash memory and the FRAM of the receiver. If you send the time with `GnssTimeAssistance`
 * right after power-up, the first fix takes 1 s at best. A change from enabled to none erases the flash memory of the
 * receiver, which is rated for 100 000 erasures. It slightly increases the power consumption.
 *
 * - mip-sdk-4: GNSS assisted fix (0x0C,0x23)
 */
export declare class GnssAssistedFix<R extends Response | undefined = undefined | GnssAssistedFixResponse> extends Command<R> {
    constructor(values: Values<GnssAssistedFix, "flags">);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Storage of data for a faster first fix. Default: `AssistedFixOption.NONE`. Required for `write`.
     *
     * - On the 3DM-GX5-35: default `AssistedFixOption.NONE`.
     */
    option?: AssistedFixOption;
    /**
     * Reserved: send 255. Required for `write`.
     *
     * - On the 3DM-GX5-35: default 255.
     */
    flags?: number;
    /** Apply the new setting. */
    static write(values: { option: AssistedFixOption }): GnssAssistedFix<undefined>;
    /** Return the current setting in a response. */
    static read(): GnssAssistedFix<GnssAssistedFixResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): GnssAssistedFix<undefined>;
    /** Load the saved setting. */
    static load(): GnssAssistedFix<undefined>;
    /** Load the factory default setting. */
    static default(): GnssAssistedFix<undefined>;
}

/**
 * GNSS time assistance (0x0C,0x24).
 *
 * Sends the current GPS time to the GNSS receiver.
 *
 * Functions: `write` and `read`. Response: `GnssTimeAssistanceResponse`. Confirmed on 3DM-GX5-35; likely or assumed on
 * 2 more. Known only from the MicroStrain MIP SDK. Requires a receiver.
 *
 * It is needed right after power-up if `GnssAssistedFix` was on at power-off.
 *
 * - mip-sdk-4: GNSS time assistance (0x0C,0x24)
 */
export declare class GnssTimeAssistance<R extends Response | undefined = undefined | GnssTimeAssistanceResponse> extends Command<R> {
    constructor(values: Values<GnssTimeAssistance>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. Required for `write`. */
    tow?: number;
    /** GPS week number since 1980. Unit: week. Required for `write`. */
    weekNumber?: number;
    /** Estimated accuracy of the time that is sent. Unit: s. Range: at least 0. Required for `write`. */
    accuracy?: number;
    /** Apply the new setting. */
    static write(values: { tow: number; weekNumber: number; accuracy: number }): GnssTimeAssistance<undefined>;
    /** Return the current setting in a response. */
    static read(): GnssTimeAssistance<GnssTimeAssistanceResponse>;
}

/**
 * PPS source control (0x0C,0x28).
 *
 * Selects the source of the pulse per second (PPS).
 *
 * Also called `pps_source`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `PpsSourceControlResponse`. Affects `system_data.TimeSyncStatus`. Probably affects `shared.GpsTimestamp`,
 * `shared.ExternalTimestamp` and `sensor.GpsTimestamp`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * The pins are configured separately, by `GpioConfig`. The filter needs a valid pulse; `disabled` and `generated` are
 * rarely useful.
 *
 * - 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28)
 */
export declare class PpsSourceControl<R extends Response | undefined = undefined | PpsSourceControlResponse> extends Command<R> {
    constructor(values: Values<PpsSourceControl>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Source of the pulse. Required for `write`.
     *
     * - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS, 3DM-GV7-AHRS, 3DM-GV7-AR
     *   and 3DM-GV7-INS: only `PpsSource.DISABLED`, `PpsSource.GPIO` and `PpsSource.GENERATED`.
     * - On the 3DM-CV7-GNSS/INS: default `PpsSource.RECEIVER_1`.
     * - On the 3DM-GQ7-GNSS/INS: only `PpsSource.DISABLED`, `PpsSource.RECEIVER_1`, `PpsSource.RECEIVER_2`,
     *   `PpsSource.GPIO` and `PpsSource.GENERATED`.
     */
    source?: PpsSource;
    /** Apply the new setting. */
    static write(values: { source: PpsSource }): PpsSourceControl<undefined>;
    /** Return the current setting in a response. */
    static read(): PpsSourceControl<PpsSourceControlResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): PpsSourceControl<undefined>;
    /** Load the saved setting. */
    static load(): PpsSourceControl<undefined>;
    /** Load the factory default setting. */
    static default(): PpsSourceControl<undefined>;
}

/**
 * Get supported events (0x0C,0x2A).
 *
 * Gets the types of event triggers or actions that the device supports, and the number of each.
 *
 * Response: `GetEventSupportResponse`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on
 * 8 more.
 *
 * - 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A)
 */
export declare class GetEventSupport extends Command<GetEventSupportResponse> {
    constructor(values: Values<GetEventSupport>);
    /** Triggers or actions. */
    query: EventSupportQuery;
}

/**
 * Event control (0x0C,0x2B).
 *
 * Enables, disables or tests an event trigger.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `EventControlResponse`. Confirmed on
 * 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * Triggers are disabled by default and after configuration. A trigger of type none cannot be enabled.
 *
 * - 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B)
 */
export declare class EventControl<R extends Response | undefined = undefined | EventControlResponse> extends Command<R> {
    constructor(values: Values<EventControl>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Trigger instance; 0 means all configured triggers, except for read. */
    instance?: number;
    /** New mode. Default: `types.EventTriggerMode.DISABLED`. Required for `write`. */
    mode?: types.EventTriggerMode;
    /** Apply the new setting. */
    static write(values: { instance: number; mode: types.EventTriggerMode }): EventControl<undefined>;
    /** Return the current setting in a response. */
    static read(values: { instance: number }): EventControl<EventControlResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { instance: number }): EventControl<undefined>;
    /** Load the saved setting. */
    static load(values: { instance: number }): EventControl<undefined>;
    /** Load the factory default setting. */
    static default(values: { instance: number }): EventControl<undefined>;
}

/**
 * Get event trigger status (0x0C,0x2C).
 *
 * Gets the type and the state of event triggers.
 *
 * Response: `GetEventTriggerStatusResponse`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
 */
export declare class GetEventTriggerStatus extends Command<GetEventTriggerStatusResponse> {
    constructor(values: Values<GetEventTriggerStatus>);
    /**
     * On the wire only: requested_count. Number of requested triggers; 0 requests all instances. Counts the elements of
     * `requestedInstances`.
     */
    /** Numbers of the triggers to report; none for all. */
    requestedInstances: number[];
}

/**
 * Get event action status (0x0C,0x2D).
 *
 * Gets the type and the trigger of event actions.
 *
 * Response: `GetEventActionStatusResponse`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D)
 */
export declare class GetEventActionStatus extends Command<GetEventActionStatusResponse> {
    constructor(values: Values<GetEventActionStatus>);
    /**
     * On the wire only: requested_count. Number of requested actions; 0 requests all instances. Counts the elements of
     * `requestedInstances`.
     */
    /** Numbers of the actions to report; none for all. */
    requestedInstances: number[];
}

/**
 * Event trigger configuration (0x0C,0x2E).
 *
 * Configures the kind and the condition of an event trigger.
 *
 * Also called `event_trigger`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `EventTriggerConfigResponse`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8
 * more.
 *
 * The trigger is disabled afterwards; `EventControl` enables it. A GPIO trigger needs its pin configured by
 * `GpioConfig`.
 *
 * - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
 */
export declare class EventTriggerConfig<R extends Response | undefined = undefined | EventTriggerConfigResponse> extends Command<R> {
    constructor(values: Values<EventTriggerConfig>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Trigger instance; 0 means all (save, load, default). */
    instance?: number;
    /** Kind of trigger. Default: `types.EventTriggerType.NONE`. Required for `write`. */
    type?: types.EventTriggerType;
    /**
     * The condition. Selected by `type`. Required for `write`.
     *
     * - If `type` is `types.EventTriggerType.NONE`: `{}`.
     * - If `type` is `types.EventTriggerType.GPIO`: `gpio: types.EventTriggerGpio`.
     * - If `type` is `types.EventTriggerType.THRESHOLD`: `threshold: types.EventTriggerThreshold`.
     * - If `type` is `types.EventTriggerType.COMBINATION`: `combination: types.EventTriggerCombination`.
     */
    parameters?: { gpio?: types.EventTriggerGpio; threshold?: types.EventTriggerThreshold; combination?: types.EventTriggerCombination };
    /** Apply the new setting. */
    static write(values: { instance: number; type: types.EventTriggerType; parameters: { gpio?: types.EventTriggerGpio; threshold?: types.EventTriggerThreshold; combination?: types.EventTriggerCombination } }): EventTriggerConfig<undefined>;
    /** Return the current setting in a response. */
    static read(values: { instance: number }): EventTriggerConfig<EventTriggerConfigResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { instance: number }): EventTriggerConfig<undefined>;
    /** Load the saved setting. */
    static load(values: { instance: number }): EventTriggerConfig<undefined>;
    /** Load the factory default setting. */
    static default(values: { instance: number }): EventTriggerConfig<undefined>;
}

/**
 * Event action configuration (0x0C,0x2F).
 *
 * Configures the trigger and the effect of an event action.
 *
 * Also called `event_action`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `EventActionConfigResponse`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8 more.
 *
 * A packet holds one descriptor set; for several sets use several actions with the same trigger. A GPIO action needs
 * its pin configured as an output with the gpio feature. In each event cycle, the device updates all triggers first and
 * then runs each action at most once. The rate of the cycle is the base rate of the system data.
 *
 * - 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
 * - 3dm-cv7-gnss-ins: Event Cycle
 */
export declare class EventActionConfig<R extends Response | undefined = undefined | EventActionConfigResponse> extends Command<R> {
    constructor(values: Values<EventActionConfig>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Action instance; 0 means all (save, load, default). */
    instance?: number;
    /** Trigger instance that the action follows. Required for `write`. */
    trigger?: number;
    /** Kind of action. Default: `types.EventActionType.NONE`. Required for `write`. */
    type?: types.EventActionType;
    /**
     * Effect of the action. Selected by `type`. Required for `write`.
     *
     * - If `type` is `types.EventActionType.NONE`: `{}`.
     * - If `type` is `types.EventActionType.GPIO`: `gpio: types.EventActionGpio`.
     * - If `type` is `types.EventActionType.MESSAGE`: `message: types.EventActionMessage`.
     */
    parameters?: { gpio?: types.EventActionGpio; message?: types.EventActionMessage };
    /** Apply the new setting. */
    static write(values: { instance: number; trigger: number; type: types.EventActionType; parameters: { gpio?: types.EventActionGpio; message?: types.EventActionMessage } }): EventActionConfig<undefined>;
    /** Return the current setting in a response. */
    static read(values: { instance: number }): EventActionConfig<EventActionConfigResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { instance: number }): EventActionConfig<undefined>;
    /** Load the saved setting. */
    static load(values: { instance: number }): EventActionConfig<undefined>;
    /** Load the factory default setting. */
    static default(values: { instance: number }): EventActionConfig<undefined>;
}

/**
 * Device start up settings (0x0C,0x30).
 *
 * Saves, loads or resets all settings of the device at once.
 *
 * Functions: `save`, `load` and `default`. The device may take 2 s to reply. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ4-45,
 * 3DM-GX5-15, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 22 more.
 *
 * A save may disturb the data output for a short time. A save may take up to 1 s. Use a reply time-out of at least 2 s.
 *
 * - 3dm-gx5-15: 4.2.8 Device Startup Settings (0x0C, 0x30)
 * - 3dm-cv7-gnss-ins: Device Start Up Settings (0x0C,0x30)
 */
export declare class DeviceSettings extends Command<undefined> {
    constructor(values: Values<DeviceSettings>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Save the current setting to non-volatile memory. */
    static save(): DeviceSettings;
    /** Load the saved setting. */
    static load(): DeviceSettings;
    /** Load the factory default setting. */
    static default(): DeviceSettings;
}

/**
 * Sensor-to-vehicle frame transformation Euler (0x0C,0x31).
 *
 * Sets the mounting of the sensor in the vehicle as Euler angles.
 *
 * Also called `sensor_2_vehicle_transform_euler`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `SensorToVehicleTransformEulerResponse`. Affects `sensor.ScaledAccel`, `sensor.ScaledGyro`, `sensor.ScaledMag`,
 * `sensor.DeltaTheta`, `sensor.DeltaVelocity`, `sensor.CompOrientationMatrix`, `sensor.CompQuaternion`,
 * `sensor.CompEulerAngles`, `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`,
 * `filter_data.LinearAccel`, `filter_data.CompAngularRate` and `filter_data.GravityVector`. Probably affects
 * `filter_data.CompAccel` and `sensor.CompOrientationUpdateMatrix`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS;
 * likely or assumed on 9 more.
 *
 * `SensorToVehicleTransformQuaternion` and `SensorToVehicleTransformDcm` set the same transformation; the value read
 * back may be another form of it. Starting aligned with the vehicle frame, the sensor is rotated by yaw, pitch and roll
 * about its own z, y and x axes, in this order. `v_vehicle = Rz(yaw) * Ry(pitch) * Rx(roll) * v_sensor` Every change
 * resets the complementary filter, the estimation filter and all low-pass filters. On some older devices the setting is
 * the inverse rotation.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Euler (0x0C,0x31)
 */
export declare class SensorToVehicleTransformEuler<R extends Response | undefined = undefined | SensorToVehicleTransformEulerResponse> extends Command<R> {
    constructor(values: Values<SensorToVehicleTransformEuler>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Roll angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive: right side down. Required
     * for `write`.
     */
    roll?: number;
    /**
     * Pitch angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive: nose up. Required for
     * `write`.
     */
    pitch?: number;
    /**
     * Yaw angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive: clockwise seen from above.
     * Required for `write`.
     */
    yaw?: number;
    /** Apply the new setting. */
    static write(values: { roll: number; pitch: number; yaw: number }): SensorToVehicleTransformEuler<undefined>;
    /** Return the current setting in a response. */
    static read(): SensorToVehicleTransformEuler<SensorToVehicleTransformEulerResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): SensorToVehicleTransformEuler<undefined>;
    /** Load the saved setting. */
    static load(): SensorToVehicleTransformEuler<undefined>;
    /** Load the factory default setting. */
    static default(): SensorToVehicleTransformEuler<undefined>;
}

/**
 * Sensor-to-vehicle frame transformation quaternion (0x0C,0x32).
 *
 * Sets the mounting of the sensor in the vehicle as a quaternion.
 *
 * Also called `sensor_2_vehicle_transform_quaternion`. Functions: `write`, `read`, `save`, `load` and `default`.
 * Response: `SensorToVehicleTransformQuaternionResponse`. Affects `sensor.ScaledAccel`, `sensor.ScaledGyro`,
 * `sensor.ScaledMag`, `sensor.DeltaTheta`, `sensor.DeltaVelocity`, `sensor.CompOrientationMatrix`,
 * `sensor.CompQuaternion`, `sensor.CompEulerAngles`, `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`,
 * `filter_data.EulerAngles`, `filter_data.LinearAccel`, `filter_data.CompAngularRate` and `filter_data.GravityVector`.
 * Probably affects `filter_data.CompAccel` and `sensor.CompOrientationUpdateMatrix`. Confirmed on 3DM-CV7-GNSS/INS;
 * likely or assumed on 10 more.
 *
 * `SensorToVehicleTransformEuler` and `SensorToVehicleTransformDcm` set the same transformation; the value read back
 * may be another form of it. `p_vehicle = q^-1 * p_sensor * q`, where the vectors are quaternions with the scalar part
 * 0. This is the inverse of the quaternion that `filter.SensorToVehicleRotationQuaternion` accepts. Every change resets
 * the complementary filter, the estimation filter and all low-pass filters.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Quaternion (0x0C,0x32)
 */
export declare class SensorToVehicleTransformQuaternion<R extends Response | undefined = undefined | SensorToVehicleTransformQuaternionResponse> extends Command<R> {
    constructor(values: Values<SensorToVehicleTransformQuaternion>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Rotates vectors of the vehicle frame into the sensor frame; unit quaternion, w first. Elements: w, x, y, z. Unit:
     * 1. Required for `write`.
     */
    q?: types.Quatf;
    /** Apply the new setting. */
    static write(values: { q: types.Quatf }): SensorToVehicleTransformQuaternion<undefined>;
    /** Return the current setting in a response. */
    static read(): SensorToVehicleTransformQuaternion<SensorToVehicleTransformQuaternionResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): SensorToVehicleTransformQuaternion<undefined>;
    /** Load the saved setting. */
    static load(): SensorToVehicleTransformQuaternion<undefined>;
    /** Load the factory default setting. */
    static default(): SensorToVehicleTransformQuaternion<undefined>;
}

/**
 * Sensor-to-vehicle frame transformation direction cosine matrix (0x0C,0x33).
 *
 * Sets the mounting of the sensor in the vehicle as a direction cosine matrix.
 *
 * Also called `sensor_2_vehicle_transform_dcm`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `SensorToVehicleTransformDcmResponse`. Affects `sensor.ScaledAccel`, `sensor.ScaledGyro`, `sensor.ScaledMag`,
 * `sensor.DeltaTheta`, `sensor.DeltaVelocity`, `sensor.CompOrientationMatrix`, `sensor.CompQuaternion`,
 * `sensor.CompEulerAngles`, `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`,
 * `filter_data.LinearAccel`, `filter_data.CompAngularRate` and `filter_data.GravityVector`. Probably affects
 * `filter_data.CompAccel` and `sensor.CompOrientationUpdateMatrix`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on
 * 10 more.
 *
 * `SensorToVehicleTransformEuler` and `SensorToVehicleTransformQuaternion` set the same transformation; the value read
 * back may be another form of it. `v_vehicle = dcm * v_sensor`. This is the inverse of the matrix that
 * `filter.SensorToVehicleRotationDcm` accepts. Every change resets the complementary filter, the estimation filter and
 * all low-pass filters.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix (0x0C,0x33)
 */
export declare class SensorToVehicleTransformDcm<R extends Response | undefined = undefined | SensorToVehicleTransformDcmResponse> extends Command<R> {
    constructor(values: Values<SensorToVehicleTransformDcm>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Rotates vectors of the sensor frame into the vehicle frame; row-major. Elements: m11, m12, m13, m21, m22, m23,
     * m31, m32, m33. Unit: 1. Required for `write`.
     */
    dcm?: types.Matrix3f;
    /** Apply the new setting. */
    static write(values: { dcm: types.Matrix3f }): SensorToVehicleTransformDcm<undefined>;
    /** Return the current setting in a response. */
    static read(): SensorToVehicleTransformDcm<SensorToVehicleTransformDcmResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): SensorToVehicleTransformDcm<undefined>;
    /** Load the saved setting. */
    static load(): SensorToVehicleTransformDcm<undefined>;
    /** Load the factory default setting. */
    static default(): SensorToVehicleTransformDcm<undefined>;
}

/**
 * GPS dynamics mode (0x0C,0x34).
 *
 * Sets the dynamics that the GNSS receiver assumes of the vehicle.
 *
 * No device is known for certain to support it. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `GpsDynamicsModeResponse`. Probably affects `gnss_data.LlhPosition` and `gnss_data.NedVelocity`. Known only from the
 * MIP SDK of 2014 and MicroStrain Communication Library. Requires a receiver. Uncertain: No source lists the devices
 * that support it; the SDK of 2014 uses it in its example for the 3DM-GX3-35 only.
 *
 * - mip-sdk-2014: GPS dynamics mode (0x0C,0x34)
 * - mscl: GPS dynamics mode (0x0C,0x34)
 */
export declare class GpsDynamicsMode<R extends Response | undefined = undefined | GpsDynamicsModeResponse> extends Command<R> {
    constructor(values: Values<GpsDynamicsMode>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Assumed dynamics. Required for `write`. */
    mode?: ReceiverDynamics;
    /** Apply the new setting. */
    static write(values: { mode: ReceiverDynamics }): GpsDynamicsMode<undefined>;
    /** Return the current setting in a response. */
    static read(): GpsDynamicsMode<GpsDynamicsModeResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): GpsDynamicsMode<undefined>;
    /** Load the saved setting. */
    static load(): GpsDynamicsMode<undefined>;
    /** Load the factory default setting. */
    static default(): GpsDynamicsMode<undefined>;
}

/**
 * IMU signal conditioning (0x0C,0x35).
 *
 * Configures the filters and the orientation algorithm of 3-series devices.
 *
 * No device is known for certain to support it. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `ImuSignalConditioningResponse`. Affects `sensor.ScaledAccel`, `sensor.ScaledGyro`, `sensor.DeltaTheta`,
 * `sensor.DeltaVelocity`, `sensor.CompOrientationMatrix`, `sensor.CompQuaternion` and `sensor.CompEulerAngles`.
 * Probably affects `sensor.ScaledMag`. Known only from the MIP SDK of 2014 and MicroStrain Communication Library.
 * Uncertain: The ranges, the defaults and some of the flags are those of the single-byte protocol of the 3DM-GX3, which
 * has the same record. Uncertain: No source lists the devices that support it; the SDK of 2014 uses it in its example
 * for the 3DM-GX3-35 only. Uncertain: MSCL reads the response without `reserved`, so some devices may not send it.
 *
 * The filters are moving averages; the first zero of their response is at 1000 Hz divided by the width.
 *
 * - mip-sdk-2014: IMU signal conditioning (0x0C,0x35)
 * - mscl: IMU signal conditioning (0x0C,0x35)
 */
export declare class ImuSignalConditioning<R extends Response | undefined = undefined | ImuSignalConditioningResponse> extends Command<R> {
    constructor(values: Values<ImuSignalConditioning, "reserved">);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Divisor of 1000 Hz that sets the rate at which the orientation is computed. Unit: 1. Range: 1 to 1000. Required
     * for `write`.
     */
    orientationDecimation?: number;
    /** Processing steps. Default: 3. Required for `write`. */
    dataConditioningFlags?: DataConditioningFlags;
    /**
     * Width of the accelerometer and gyroscope filter in samples. Unit: 1. Range: 1 to 32. Default: 15. Required for
     * `write`.
     */
    inertialFilterWidth?: number;
    /** Width of the magnetometer filter in samples. Unit: 1. Range: 1 to 32. Default: 17. Required for `write`. */
    magFilterWidth?: number;
    /** Time constant of the pitch and roll correction. Unit: s. Range: 1 to 1000. Default: 10. Required for `write`. */
    upCompensation?: number;
    /** Time constant of the heading correction. Unit: s. Range: 1 to 1000. Default: 10. Required for `write`. */
    northCompensation?: number;
    /** Bandwidth of the magnetometer of 3-series devices. Required for `write`. */
    magBandwidth?: MagBandwidth;
    /** Reserved: send 0. Required for `write`. */
    reserved?: number;
    /** Apply the new setting. */
    static write(values: { orientationDecimation: number; dataConditioningFlags: DataConditioningFlags; inertialFilterWidth: number; magFilterWidth: number; upCompensation: number; northCompensation: number; magBandwidth: MagBandwidth }): ImuSignalConditioning<undefined>;
    /** Return the current setting in a response. */
    static read(): ImuSignalConditioning<ImuSignalConditioningResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): ImuSignalConditioning<undefined>;
    /** Load the saved setting. */
    static load(): ImuSignalConditioning<undefined>;
    /** Load the factory default setting. */
    static default(): ImuSignalConditioning<undefined>;
}

/**
 * IMU timestamp (0x0C,0x36).
 *
 * Sets or reads a time counter of the sensor data.
 *
 * No device is known for certain to support it. Functions: `write` and `read`. Response: `ImuTimestampResponse`. Known
 * only from the MIP SDK of 2014. Uncertain: No source lists the devices that support it; the SDK of 2014 uses it in its
 * example for the 3DM-GX3-35 only. Uncertain: A read is assumed to omit `time`, which the device would ignore.
 *
 * - mip-sdk-2014: IMU timestamp (0x0C,0x36)
 */
export declare class ImuTimestamp<R extends Response | undefined = undefined | ImuTimestampResponse> extends Command<R> {
    constructor(values: Values<ImuTimestamp>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Counter to set or read. */
    selector?: ImuTimestampSelector;
    /** Value of the counter, in the unit that `selector` selects. Required for `write`. */
    time?: number;
    /** Apply the new setting. */
    static write(values: { selector: ImuTimestampSelector; time: number }): ImuTimestamp<undefined>;
    /** Return the current setting in a response. */
    static read(values: { selector: ImuTimestampSelector }): ImuTimestamp<ImuTimestampResponse>;
}

/**
 * Accelerometer bias configuration (0x0C,0x37).
 *
 * Sets the bias that is subtracted from the scaled acceleration.
 *
 * For advanced use. Functions: `write`, `read`, `save`, `load`, `default` and `apply`. Response: `AccelBiasResponse`.
 * Affects `sensor.ScaledAccel`. Probably affects `sensor.DeltaVelocity` and `filter_data.AccelBias`. Confirmed on
 * 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 24 more.
 * On the 3DM-CV7-GNSS/INS: `write`, `read`, `save`, `load` and `default` only.
 *
 * - 3dm-gx5-15: 4.2.9 Accel Bias (0x0C, 0x37)
 * - 3dm-cv7-gnss-ins: Accelerometer Bias Configuration (0x0C,0x37)
 */
export declare class AccelBias<R extends Response | undefined = undefined | AccelBiasResponse> extends Command<R> {
    constructor(values: Values<AccelBias>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Bias that the device subtracts from the measured acceleration. Elements: x, y, z. Unit: g. Frame: sensor.
     * Required for `write` and `apply`.
     */
    bias?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { bias: types.Vector3f }): AccelBias<undefined>;
    /** Return the current setting in a response. */
    static read(): AccelBias<AccelBiasResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): AccelBias<undefined>;
    /** Load the saved setting. */
    static load(): AccelBias<undefined>;
    /** Load the factory default setting. */
    static default(): AccelBias<undefined>;
    /** Apply the new setting without sending an ACK (5-series devices). */
    static apply(values: { bias: types.Vector3f }): AccelBias<undefined>;
}

/**
 * Gyroscope bias configuration (0x0C,0x38).
 *
 * Sets the bias that is subtracted from the scaled angular rate.
 *
 * For advanced use. Functions: `write`, `read`, `save`, `load`, `default` and `apply`. Response: `GyroBiasResponse`.
 * Affects `sensor.ScaledGyro`. Probably affects `sensor.DeltaTheta`, `filter_data.GyroBias` and `filter_data.Status`.
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST;
 * likely or assumed on 23 more. On the 3DM-CV7-AHRS: `write`, `read`, `save`, `load` and `default` only. On the
 * 3DM-CV7-AR: `write`, `read`, `save`, `load` and `default` only. On the 3DM-CV7-GNSS/INS: `write`, `read`, `save`,
 * `load` and `default` only.
 *
 * - 3dm-gx5-15: 4.2.10 Gyro Bias (0x0C, 0x38)
 * - 3dm-cv7-gnss-ins: Gyroscope Bias Configuration (0x0C,0x38)
 */
export declare class GyroBias<R extends Response | undefined = undefined | GyroBiasResponse> extends Command<R> {
    constructor(values: Values<GyroBias>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Bias that the device subtracts from the measured angular rate. Elements: x, y, z. Unit: rad/s. Frame: sensor.
     * Required for `write` and `apply`.
     */
    bias?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { bias: types.Vector3f }): GyroBias<undefined>;
    /** Return the current setting in a response. */
    static read(): GyroBias<GyroBiasResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): GyroBias<undefined>;
    /** Load the saved setting. */
    static load(): GyroBias<undefined>;
    /** Load the factory default setting. */
    static default(): GyroBias<undefined>;
    /** Apply the new setting without sending an ACK (5-series devices). */
    static apply(values: { bias: types.Vector3f }): GyroBias<undefined>;
}

/**
 * Capture gyroscope bias (0x0C,0x39).
 *
 * Averages the angular rate of the device at rest and uses the result as the gyroscope bias.
 *
 * Response: `GyroBiasResponse`. Affects `sensor.ScaledGyro`. Probably affects `sensor.DeltaTheta`,
 * `filter_data.GyroBias` and `filter_data.Status`. The device may take 31 s to reply. Confirmed on 3DM-CV7-AHRS,
 * 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST;
 * likely or assumed on 21 more.
 *
 * The device must be at rest, with as little vibration as possible, for the whole time. The reply arrives after the
 * averaging time. The bias is not saved; to save it, send `GyroBias` with save. The 3DM-GX5-15 also initializes its
 * orientation from the samples.
 *
 * - 3dm-gx5-15: 4.2.11 Capture Gyro Bias (0x0C, 0x39)
 * - 3dm-cv7-gnss-ins: Capture Gyroscope Bias (0x0C,0x39)
 */
export declare class CaptureGyroBias extends Command<GyroBiasResponse> {
    constructor(values: Values<CaptureGyroBias>);
    /** Time to average over. Unit: ms. Range: 1000 to 30000. */
    averagingTimeMs: number;
}

/**
 * Magnetometer hard iron offset (0x0C,0x3A).
 *
 * Sets the offset that corrects the scaled magnetic field for hard iron.
 *
 * Functions: `write`, `read`, `save`, `load`, `default` and `apply`. Response: `MagHardIronOffsetResponse`. Affects
 * `sensor.ScaledMag`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-45, 3DM-RQ1-45-LT and
 * 3DM-RQ1-45-ST; likely or assumed on 14 more. On the 3DM-CV7-AHRS: `write`, `read`, `save`, `load` and `default` only.
 * On the 3DM-CV7-GNSS/INS: `write`, `read`, `save`, `load` and `default` only. Requires a magnetometer. Uncertain: The
 * sources do not state the formula; it is inferred from the terms.
 *
 * The values come from a calibration of the device as it is installed. On some devices,
 * `filter.MagCaptureAutoCalibration` captures them from the filter's automatic calibration. Before it sends
 * `sensor.ScaledMag`, the device corrects the field: the matrix times (measured - offset), with the matrix of
 * `MagSoftIronMatrix`.
 *
 * - 3dm-cv7-gnss-ins: Magnetometer Hard Iron Offset (0x0C,0x3A)
 * - 3dm-gx5-45: (0x0C, 0x3A)
 */
export declare class MagHardIronOffset<R extends Response | undefined = undefined | MagHardIronOffsetResponse> extends Command<R> {
    constructor(values: Values<MagHardIronOffset>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Offset that the device subtracts from the measured magnetic field. Elements: x, y, z. Unit: gauss. Frame: sensor.
     * Required for `write` and `apply`.
     *
     * - On the 3DM-GX5-45: default 0, 0, 0.
     */
    offset?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { offset: types.Vector3f }): MagHardIronOffset<undefined>;
    /** Return the current setting in a response. */
    static read(): MagHardIronOffset<MagHardIronOffsetResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): MagHardIronOffset<undefined>;
    /** Load the saved setting. */
    static load(): MagHardIronOffset<undefined>;
    /** Load the factory default setting. */
    static default(): MagHardIronOffset<undefined>;
    /** Apply the new setting without sending an ACK (5-series devices). */
    static apply(values: { offset: types.Vector3f }): MagHardIronOffset<undefined>;
}

/**
 * Magnetometer soft iron matrix (0x0C,0x3B).
 *
 * Sets the matrix that corrects the scaled magnetic field for soft iron.
 *
 * Functions: `write`, `read`, `save`, `load`, `default` and `apply`. Response: `MagSoftIronMatrixResponse`. Affects
 * `sensor.ScaledMag`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-35, 3DM-RQ1-45-LT and
 * 3DM-RQ1-45-ST; likely or assumed on 14 more. On the 3DM-CV7-AHRS: `write`, `read`, `save`, `load` and `default` only.
 * On the 3DM-CV7-GNSS/INS: `write`, `read`, `save`, `load` and `default` only. Requires a magnetometer. Uncertain: The
 * sources do not state the formula; it is inferred from the terms.
 *
 * The values come from a calibration of the device as it is installed. On some devices,
 * `filter.MagCaptureAutoCalibration` captures them from the filter's automatic calibration. Before it sends
 * `sensor.ScaledMag`, the device corrects the field: the matrix times (measured - offset), with the offset of
 * `MagHardIronOffset`.
 *
 * - 3dm-cv7-gnss-ins: Magnetometer Soft Iron Matrix (0x0C,0x3B)
 * - 3dm-gx5-35: (0x0C, 0x3B)
 */
export declare class MagSoftIronMatrix<R extends Response | undefined = undefined | MagSoftIronMatrixResponse> extends Command<R> {
    constructor(values: Values<MagSoftIronMatrix>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Soft iron matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Frame:
     * sensor. Required for `write` and `apply`.
     */
    matrix?: types.Matrix3f;
    /** Apply the new setting. */
    static write(values: { matrix: types.Matrix3f }): MagSoftIronMatrix<undefined>;
    /** Return the current setting in a response. */
    static read(): MagSoftIronMatrix<MagSoftIronMatrixResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): MagSoftIronMatrix<undefined>;
    /** Load the saved setting. */
    static load(): MagSoftIronMatrix<undefined>;
    /** Load the factory default setting. */
    static default(): MagSoftIronMatrix<undefined>;
    /** Apply the new setting without sending an ACK (5-series devices). */
    static apply(values: { matrix: types.Matrix3f }): MagSoftIronMatrix<undefined>;
}

/**
 * Coning and sculling enable (0x0C,0x3E).
 *
 * Enables or disables coning and sculling compensation.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `ConingScullingEnableResponse`. Probably affects
 * `sensor.DeltaTheta` and `sensor.DeltaVelocity`. Confirmed on 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST;
 * likely or assumed on 15 more.
 *
 * - 3dm-gx5-15: 4.2.12 Coning and Sculling Enable (0x0C, 0x3E)
 */
export declare class ConingScullingEnable<R extends Response | undefined = undefined | ConingScullingEnableResponse> extends Command<R> {
    constructor(values: Values<ConingScullingEnable>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** True if the compensation is on. Default: true. Required for `write`. */
    enable?: boolean;
    /** Apply the new setting. */
    static write(values: { enable: boolean }): ConingScullingEnable<undefined>;
    /** Return the current setting in a response. */
    static read(): ConingScullingEnable<ConingScullingEnableResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): ConingScullingEnable<undefined>;
    /** Load the saved setting. */
    static load(): ConingScullingEnable<undefined>;
    /** Load the factory default setting. */
    static default(): ConingScullingEnable<undefined>;
}

/**
 * UART baud rate (0x0C,0x40).
 *
 * Sets the baud rate of the main port.
 *
 * Also called `uart_baudrate`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `UartBaudRateResponse`. Devices without it may have `base.CommSpeed`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ4-45,
 * 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 12 more.
 *
 * The 3DM-GX5-15 replies at the old rate and accepts commands at the new rate 250 ms later. The 3DM-CV7 applies the
 * rate when the port is empty, after at most 250 ms; until then, commands and data may be lost. Set the device to idle
 * first, send the command in a separate packet, and wait 250 ms afterwards.
 *
 * - 3dm-gx5-15: 4.2.13 UART Baud Rate (0x0C, 0x40)
 * - 3dm-cv7-gnss-ins: UART Baudrate (0x0C,0x40)
 */
export declare class UartBaudRate<R extends Response | undefined = undefined | UartBaudRateResponse> extends Command<R> {
    constructor(values: Values<UartBaudRate>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * New baud rate; the port must support it. Unit: Bd. Required for `write`.
     *
     * - On the 3DM-GX5-15 and 3DM-GX5-45: default 115200.
     */
    baud?: number;
    /** Apply the new setting. */
    static write(values: { baud: number }): UartBaudRate<undefined>;
    /** Return the current setting in a response. */
    static read(): UartBaudRate<UartBaudRateResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): UartBaudRate<undefined>;
    /** Load the saved setting. */
    static load(): UartBaudRate<undefined>;
    /** Load the factory default setting. */
    static default(): UartBaudRate<undefined>;
}

/**
 * GPIO configuration (0x0C,0x41).
 *
 * Sets the use of a GPIO pin.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `GpioConfigResponse`. Probably affects
 * `system_data.GpioState` and `system_data.GpioAnalogValue`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and
 * 3DM-CV7-GNSS/INS; likely or assumed on 8 more.
 *
 * Not every pin has every feature. For an output with a feature other than gpio, configure the function that drives it
 * before the pin; otherwise, the level of the pin is undefined in the meantime. For an input, configure the pin before
 * the function that uses it. If only one pin can have a configuration, the last pin configured gets it, and the earlier
 * pin is reset. With NMEA input at most one pin may be a UART input; set it to unused before another one takes over.
 *
 * - 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41)
 */
export declare class GpioConfig<R extends Response | undefined = undefined | GpioConfigResponse> extends Command<R> {
    constructor(values: Values<GpioConfig>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** GPIO pin, counted from 1; 0 means all pins (save, load, default). */
    pin?: number;
    /** Use of the pin. Default: `types.GpioFeature.UNUSED`. Required for `write`. */
    feature?: types.GpioFeature;
    /**
     * Role of the pin within the feature; 0 if the feature has no roles. Required for `write`.
     *
     * - If `feature` is `types.GpioFeature.UNUSED`: values of `types.GpioUnusedBehavior`.
     * - If `feature` is `types.GpioFeature.GPIO`: values of `types.GpioBehavior`.
     * - If `feature` is `types.GpioFeature.PPS`: values of `types.GpioPpsBehavior`.
     * - If `feature` is `types.GpioFeature.ENCODER`: values of `types.GpioEncoderBehavior`.
     * - If `feature` is `types.GpioFeature.TIMESTAMP`: values of `types.GpioTimestampBehavior`.
     * - If `feature` is `types.GpioFeature.UART`: values of `types.GpioUartBehavior`.
     */
    behavior?: number;
    /** Electrical options. Required for `write`. */
    pinMode?: types.GpioPinMode;
    /** Apply the new setting. */
    static write(values: { pin: number; feature: types.GpioFeature; behavior: number; pinMode: types.GpioPinMode }): GpioConfig<undefined>;
    /** Return the current setting in a response. */
    static read(values: { pin: number }): GpioConfig<GpioConfigResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { pin: number }): GpioConfig<undefined>;
    /** Load the saved setting. */
    static load(values: { pin: number }): GpioConfig<undefined>;
    /** Load the factory default setting. */
    static default(values: { pin: number }): GpioConfig<undefined>;
}

/**
 * GPIO state (0x0C,0x42).
 *
 * Sets or reads the state of a GPIO pin.
 *
 * Functions: `write` and `read`. Response: `GpioStateResponse`. Affects `system_data.GpioState`. Confirmed on
 * 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 9 more.
 *
 * A read returns the level of the pin itself. A write has an effect only on a pin that is configured as an output. An
 * event action of mode `active_high` or `active_low` on the pin overrides the written state. Reading is guaranteed to
 * work only with the gpio feature. `GpioConfig` determines the state at power-up.
 *
 * - 3dm-cv7-gnss-ins: GPIO State (0x0C,0x42)
 */
export declare class GpioState<R extends Response | undefined = undefined | GpioStateResponse> extends Command<R> {
    constructor(values: Values<GpioState>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** GPIO pin, counted from 1. Range: at least 1. */
    pin?: number;
    /** True means high. Required for `write`. */
    state?: boolean;
    /** Apply the new setting. */
    static write(values: { pin: number; state: boolean }): GpioState<undefined>;
    /** Return the current setting in a response. */
    static read(values: { pin: number }): GpioState<GpioStateResponse>;
}

/**
 * Odometer configuration (0x0C,0x43).
 *
 * Configures the input from a wheel encoder.
 *
 * Also called `odometer`. Functions: `write`, `read`, `save`, `load` and `default`. Response: `OdometerConfigResponse`.
 * Affects `sensor.Odometer`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * - 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43)
 */
export declare class OdometerConfig<R extends Response | undefined = undefined | OdometerConfigResponse> extends Command<R> {
    constructor(values: Values<OdometerConfig>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Operation of the input. Required for `write`. */
    mode?: OdometerMode;
    /**
     * Pulses per distance travelled; negative if the encoder rotates backwards. Unit: pulse/m. Required for `write`.
     * Pulses on line A per turn of the wheel, divided by the circumference of the wheel.
     */
    scaling?: number;
    /** Relative uncertainty of the scaling, 1 sigma. Unit: 1. Range: at least 0. Required for `write`. */
    uncertainty?: number;
    /** Apply the new setting. */
    static write(values: { mode: OdometerMode; scaling: number; uncertainty: number }): OdometerConfig<undefined>;
    /** Return the current setting in a response. */
    static read(): OdometerConfig<OdometerConfigResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): OdometerConfig<undefined>;
    /** Load the saved setting. */
    static load(): OdometerConfig<undefined>;
    /** Load the factory default setting. */
    static default(): OdometerConfig<undefined>;
}

/**
 * Advanced low-pass filter settings (0x0C,0x50).
 *
 * Configures the low-pass filter of one sensor data quantity.
 *
 * For advanced use. Also called `imu_lowpass_filter`. Functions: `write`, `read`, `save`, `load` and `default`.
 * Response: `ImuLowPassFilterResponse`. Affects `sensor.ScaledAccel`, `sensor.ScaledGyro`, `sensor.ScaledMag` and
 * `sensor.ScaledPressure`. Devices without it may have `LowPassFilter`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR,
 * 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 20
 * more. Deprecated on the 3DM-CV7-AHRS: use `LowPassFilter` instead. Deprecated on the 3DM-CV7-AR: use `LowPassFilter`
 * instead. Deprecated on the 3DM-CV7-GNSS/INS: use `LowPassFilter` instead. Deprecated on the 3DM-GQ7-GNSS/INS: use
 * `LowPassFilter` instead. Requires firmware up to 1.0.07 on the 3DM-CV7-AHRS and 3DM-CV7-AR. Requires firmware up to
 * 1.0.10 on the 3DM-GQ7-GNSS/INS.
 *
 * The filter has one pole. By default it is on and its cutoff is half the rate of the message format.
 *
 * - 3dm-gx5-15: 4.2.14 Advanced Low-Pass Filter Settings (0x0C, 0x50)
 * - 3dm-cv7-gnss-ins: Advanced Low-Pass Filter Settings (0x0C,0x50)
 */
export declare class ImuLowPassFilter<R extends Response | undefined = undefined | ImuLowPassFilterResponse> extends Command<R> {
    constructor(values: Values<ImuLowPassFilter, "reserved">);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Field descriptor in the sensor data set: scaled acceleration 0x04, angular rate 0x05, magnetic field 0x06 or
     * pressure 0x17. Refers to fields of Sensor data.
     *
     * - On the 3DM-CV7-GNSS/INS: Field descriptor in the sensor data set: scaled acceleration 0x04, angular rate 0x05,
     *   magnetic field 0x06 or pressure 0x17; 0 means all of them, except for read.
     */
    targetDescriptor?: number;
    /** True if the quantity is filtered. Default: true. Required for `write`. */
    enable?: boolean;
    /** True uses `frequency`; false uses half the rate of the message format. Default: false. Required for `write`. */
    manual?: boolean;
    /**
     * Cutoff (-3 dB). It has no meaning if `manual` is false. Unit: Hz. Required for `write`.
     *
     * - On the 3DM-GX5-15: range at most 250.
     */
    frequency?: number;
    /** Reserved: send 0. Required for `write`. */
    reserved?: number;
    /** Apply the new setting. */
    static write(values: { targetDescriptor: number; enable: boolean; manual: boolean; frequency: number }): ImuLowPassFilter<undefined>;
    /** Return the current setting in a response. */
    static read(values: { targetDescriptor: number }): ImuLowPassFilter<ImuLowPassFilterResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { targetDescriptor: number }): ImuLowPassFilter<undefined>;
    /** Load the saved setting. */
    static load(values: { targetDescriptor: number }): ImuLowPassFilter<undefined>;
    /** Load the factory default setting. */
    static default(values: { targetDescriptor: number }): ImuLowPassFilter<undefined>;
}

/**
 * Complementary filter configuration (0x0C,0x51).
 *
 * Configures the complementary filter, which computes the attitude independently of the estimation filter.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `ComplementaryFilterResponse`. Affects
 * `sensor.CompOrientationMatrix`, `sensor.CompQuaternion` and `sensor.CompEulerAngles`. Probably affects
 * `sensor.NorthVector` and `sensor.UpVector`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15 and 3DM-GX5-35;
 * likely or assumed on 22 more.
 *
 * Pitch and roll follow the accelerometers, on the assumption that the mean acceleration is zero. The heading follows
 * the magnetometer, if the device has one. The device rejects time constants out of range. The attitude of the
 * estimation filter is better; the 3DM-GX5-15 keeps this filter for compatibility.
 *
 * - 3dm-gx5-15: 4.2.15 Complementary Filter Settings (0x0C, 0x51)
 * - 3dm-cv7-gnss-ins: Complementary Filter Configuration (0x0C,0x51)
 */
export declare class ComplementaryFilter<R extends Response | undefined = undefined | ComplementaryFilterResponse> extends Command<R> {
    constructor(values: Values<ComplementaryFilter>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * True enables the pitch and roll correction, which 5-series manuals call up compensation. Required for `write`.
     *
     * - On the 3DM-GX5-15: default true.
     */
    pitchRollEnable?: boolean;
    /**
     * True enables the heading correction, which 5-series manuals call north compensation. Required for `write`.
     *
     * - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CX5-10 and 3DM-CX5-15: MSCL has no support for it.
     * - On the 3DM-GX5-15: default true.
     */
    headingEnable?: boolean;
    /** Time constant of the pitch and roll correction. Unit: s. Range: 1 to 1000. Default: 10. Required for `write`. */
    pitchRollTimeConstant?: number;
    /** Time constant of the heading correction. Unit: s. Range: 1 to 1000. Default: 10. Required for `write`. */
    headingTimeConstant?: number;
    /** Apply the new setting. */
    static write(values: { pitchRollEnable: boolean; headingEnable: boolean; pitchRollTimeConstant: number; headingTimeConstant: number }): ComplementaryFilter<undefined>;
    /** Return the current setting in a response. */
    static read(): ComplementaryFilter<ComplementaryFilterResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): ComplementaryFilter<undefined>;
    /** Load the saved setting. */
    static load(): ComplementaryFilter<undefined>;
    /** Load the factory default setting. */
    static default(): ComplementaryFilter<undefined>;
}

/**
 * Sensor range (0x0C,0x52).
 *
 * Sets the measuring range of a sensor.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `SensorRangeResponse`. Probably affects
 * `sensor.ScaledAccel`, `sensor.ScaledGyro` and `sensor.OverrangeStatus`. Confirmed on 3DM-CV7-GNSS/INS; likely or
 * assumed on 10 more.
 *
 * `GetCalibratedSensorRanges` lists the settings. The device may reject other settings, or measure incorrectly with
 * them.
 *
 * - 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52)
 */
export declare class SensorRange<R extends Response | undefined = undefined | SensorRangeResponse> extends Command<R> {
    constructor(values: Values<SensorRange>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Sensor whose range is set or read.
     *
     * - On the 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only `SensorRangeType.ALL`, `SensorRangeType.ACCEL`,
     *   `SensorRangeType.GYRO` and `SensorRangeType.PRESSURE`.
     */
    sensor?: SensorRangeType;
    /** Number of the range. Required for `write`. */
    setting?: number;
    /** Apply the new setting. */
    static write(values: { sensor: SensorRangeType; setting: number }): SensorRange<undefined>;
    /** Return the current setting in a response. */
    static read(values: { sensor: SensorRangeType }): SensorRange<SensorRangeResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { sensor: SensorRangeType }): SensorRange<undefined>;
    /** Load the saved setting. */
    static load(values: { sensor: SensorRangeType }): SensorRange<undefined>;
    /** Load the factory default setting. */
    static default(values: { sensor: SensorRangeType }): SensorRange<undefined>;
}

/**
 * Get calibrated sensor ranges (0x0C,0x53).
 *
 * Gets the ranges that a sensor supports.
 *
 * Also called `calibrated_sensor_ranges`. Response: `GetCalibratedSensorRangesResponse`. Confirmed on 3DM-CV7-GNSS/INS;
 * likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53)
 */
export declare class GetCalibratedSensorRanges extends Command<GetCalibratedSensorRangesResponse> {
    constructor(values: Values<GetCalibratedSensorRanges>);
    /**
     * Sensor to query; `all` is not allowed.
     *
     * - On the 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only `SensorRangeType.ALL`, `SensorRangeType.ACCEL`,
     *   `SensorRangeType.GYRO` and `SensorRangeType.PRESSURE`.
     */
    sensor: SensorRangeType;
}

/**
 * Low-pass anti-aliasing filter (0x0C,0x54).
 *
 * Configures the low-pass filter of a data field.
 *
 * Also called `lowpass_filter`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `LowPassFilterResponse`. Affects `sensor.ScaledAccel`, `sensor.ScaledGyro`, `sensor.ScaledMag`,
 * `sensor.ScaledPressure`, `filter_data.CompAccel`, `filter_data.CompAngularRate` and `filter_data.LinearAccel`.
 * Devices without it may have `ImuLowPassFilter`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and
 * 3DM-GQ7-GNSS/INS; likely or assumed on 7 more. Requires firmware later than 1.0.07 on the 3DM-CV7-AHRS and
 * 3DM-CV7-AR. Requires firmware later than 1.0.10 on the 3DM-GQ7-GNSS/INS.
 *
 * Except for read, a field descriptor of 0 means all fields of the set; if both are 0, all sets are meant.
 *
 * - 3dm-cv7-gnss-ins: Low-Pass Anti-Aliasing Filter (0x0C,0x54)
 */
export declare class LowPassFilter<R extends Response | undefined = undefined | LowPassFilterResponse> extends Command<R> {
    constructor(values: Values<LowPassFilter>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Descriptor set of the field. */
    descriptorSet?: number;
    /** Field descriptor; 0 if the set is 0. Refers to fields of `descriptorSet`. */
    fieldDescriptor?: number;
    /** True if the field is filtered. Required for `write`. */
    enable?: boolean;
    /** True uses `frequency`; false uses half the rate of the field in the message format. Required for `write`. */
    manual?: boolean;
    /**
     * Cutoff; a write ignores it if `manual` is false, a read returns the cutoff in use. Unit: Hz. Range: at least 0.
     * Required for `write`.
     */
    frequency?: number;
    /** Apply the new setting. */
    static write(values: { descriptorSet: number; fieldDescriptor: number; enable: boolean; manual: boolean; frequency: number }): LowPassFilter<undefined>;
    /** Return the current setting in a response. */
    static read(values: { descriptorSet: number; fieldDescriptor: number }): LowPassFilter<LowPassFilterResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { descriptorSet: number; fieldDescriptor: number }): LowPassFilter<undefined>;
    /** Load the saved setting. */
    static load(values: { descriptorSet: number; fieldDescriptor: number }): LowPassFilter<undefined>;
    /** Load the factory default setting. */
    static default(values: { descriptorSet: number; fieldDescriptor: number }): LowPassFilter<undefined>;
}

/**
 * Data stream format (0x0C,0x60).
 *
 * Selects MIP data or the raw data of a sensor for a stream.
 *
 * No device is known for certain to support it. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `DataStreamFormatResponse`. Known only from the MIP SDK of 2014 and MicroStrain Communication Library. Uncertain: A
 * comment in the SDK of 2014 restricts it to the 3DM-GX3-35; no other source lists devices. Uncertain: Functions other
 * than write are assumed not to require `format`. The SDK of 2014 sends both parameters with every function, and a 0 in
 * place of `format`.
 *
 * In the wrapped format, packets of the sensor arrive in fields of the data sets: `sensor.aspp` and `sensor.gxsb` for
 * the IMU, `gnss_data.nmea` and `gnss_data.ubx` for the receiver.
 *
 * - mip-sdk-2014: Data stream format (0x0C,0x60)
 * - mscl: Data stream format (0x0C,0x60)
 */
export declare class DataStreamFormat<R extends Response | undefined = undefined | DataStreamFormatResponse> extends Command<R> {
    constructor(values: Values<DataStreamFormat>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Stream whose format is set or read. */
    stream?: InternalSensor;
    /** Format of a data stream. */
    format?: StreamFormat;
    /** Apply the new setting. */
    static write(values: { stream: InternalSensor; format: StreamFormat }): DataStreamFormat<undefined>;
    /** Return the current setting in a response. */
    static read(values: { stream: InternalSensor; format: StreamFormat }): DataStreamFormat<DataStreamFormatResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { stream: InternalSensor; format: StreamFormat }): DataStreamFormat<undefined>;
    /** Load the saved setting. */
    static load(values: { stream: InternalSensor; format: StreamFormat }): DataStreamFormat<undefined>;
    /** Load the factory default setting. */
    static default(values: { stream: InternalSensor; format: StreamFormat }): DataStreamFormat<undefined>;
}

/**
 * Device power state (0x0C,0x61).
 *
 * Sets the power state of an internal sensor.
 *
 * No device is known for certain to support it. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `DevicePowerStateResponse`. The device may take 5 s to reply. Known only from the MIP SDK of 2014 and MicroStrain
 * Communication Library. Uncertain: A comment in the SDK of 2014 names the 3DM-GX3-25 and the 3DM-GX3-35; no other
 * source lists devices. Uncertain: The time-out of 5 s is assumed; the SDK of 2014 uses one that is longer than usual.
 * Uncertain: Functions other than write are assumed not to require `state`. The SDK of 2014 sends `device` with every
 * function, and a 0 in place of `state`.
 *
 * - mip-sdk-2014: Device power state (0x0C,0x61)
 * - mscl: Device power state (0x0C,0x61)
 */
export declare class DevicePowerState<R extends Response | undefined = undefined | DevicePowerStateResponse> extends Command<R> {
    constructor(values: Values<DevicePowerState>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * The sensor.
     *
     * - On the 3DM-GX3-15 and 3DM-GX3-25: only `InternalSensor.IMU`.
     */
    device?: InternalSensor;
    /** Power state of an internal sensor. Required for `write`. */
    state?: SensorPowerState;
    /** Apply the new setting. */
    static write(values: { device: InternalSensor; state: SensorPowerState }): DevicePowerState<undefined>;
    /** Return the current setting in a response. */
    static read(values: { device: InternalSensor }): DevicePowerState<DevicePowerStateResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { device: InternalSensor }): DevicePowerState<undefined>;
    /** Load the saved setting. */
    static load(values: { device: InternalSensor }): DevicePowerState<undefined>;
    /** Load the factory default setting. */
    static default(values: { device: InternalSensor }): DevicePowerState<undefined>;
}

/**
 * GPS advanced settings (0x0C,0x62).
 *
 * Saves, loads or resets the settings of the GNSS receiver that were made in direct mode.
 *
 * No device is known for certain to support it. For advanced use. Functions: `save`, `load` and `default`. Known only
 * from the MIP SDK of 2014 and MicroStrain Communication Library. Requires a receiver. Uncertain: A comment in the SDK
 * of 2014 names the 3DM-GX3-35; no other source lists devices.
 *
 * In direct mode, your program configures the u-blox receiver with its own protocol; see `system.CommMode`.
 *
 * - mip-sdk-2014: GPS advanced settings (0x0C,0x62)
 * - mscl: GPS advanced settings (0x0C,0x62)
 */
export declare class GpsAdvancedSettings extends Command<undefined> {
    constructor(values: Values<GpsAdvancedSettings>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Save the current setting to non-volatile memory. */
    static save(): GpsAdvancedSettings;
    /** Load the saved setting. */
    static load(): GpsAdvancedSettings;
    /** Load the factory default setting. */
    static default(): GpsAdvancedSettings;
}

/**
 * Device status (0x0C,0x64).
 *
 * Gets the state of the device, in basic form or with counters.
 *
 * For advanced use. Response: `DeviceStatusBasicRq1ImuResponse`, `DeviceStatusBasicResponse`,
 * `DeviceStatusBasicWithoutStateResponse`, `DeviceStatusDiagnosticResponse`, `DeviceStatusDiagnosticGnssResponse`,
 * `DeviceStatusDiagnosticGq4_45Response`, `DeviceStatusDiagnosticRq1_45Response`, `DeviceStatusDiagnosticGx4Response`,
 * `DeviceStatusDiagnosticImuResponse`, `DeviceStatusDiagnosticGx4ImuResponse`, `DeviceStatusDiagnosticRq1ImuResponse`,
 * `DeviceStatusBasicGx3Response` or `DeviceStatusDiagnosticGx3Response`. Confirmed on 3DM-GQ4-45, 3DM-GX5-15,
 * 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 17 more.
 *
 * The device expects its own model number, which `base.GetDeviceInfo` returns. Device families reply in different
 * layouts. The selector and the length distinguish them.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
export declare class DeviceStatus extends Command<DeviceStatusBasicRq1ImuResponse | DeviceStatusBasicResponse | DeviceStatusBasicWithoutStateResponse | DeviceStatusBasicGx3Response | DeviceStatusDiagnosticResponse | DeviceStatusDiagnosticGnssResponse | DeviceStatusDiagnosticGq4_45Response | DeviceStatusDiagnosticRq1_45Response | DeviceStatusDiagnosticGx4Response | DeviceStatusDiagnosticImuResponse | DeviceStatusDiagnosticGx4ImuResponse | DeviceStatusDiagnosticRq1ImuResponse | DeviceStatusDiagnosticGx3Response> {
    constructor(values: Values<DeviceStatus>);
    /**
     * Model number of the device that replies.
     *
     * - On the 3DM-GX5-15: always 6254.
     * - On the 3DM-GX5-35: always 6252.
     * - On the 3DM-GX5-45: always 6251.
     */
    modelNumber: number;
    /** Level of detail of the reply. */
    statusSelector: DeviceStatusSelector;
}

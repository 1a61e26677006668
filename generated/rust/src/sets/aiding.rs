//! Aiding commands (0x13): Measurements of external sensors for the navigation filter, and the
//! frames of the sensors.
//!
//! Source: 3dm-cv7-gnss-ins: Aiding (0x13); 3dm-cv7-gnss-ins: Filter Aiding Measurements.

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: crate::DescriptorSet = crate::DescriptorSet(0x13);

open_enum! {
    /// Format of the rotation of an aiding frame.
    ///
    /// Source: 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01).
    AidingFrameFormat: u8 {
        /// Euler angles: roll, pitch, yaw.
        EULER = 1, "euler";
        /// Quaternion: w, x, y, z.
        QUATERNION = 2, "quaternion";
    }
}

open_enum! {
    /// Replies of the device to aiding measurements.
    ///
    /// Source: 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F).
    AidingEchoMode: u8 {
        /// No acknowledge.
        SUPPRESS_ACK = 0, "suppress_ack";
        /// ACK, as for any command.
        STANDARD = 1, "standard";
        /// The data is returned in a response.
        RESPONSE = 2, "response";
    }
}

open_enum! {
    /// Clock that the time of a measurement refers to.
    Timebase: u8 {
        /// Internal reference clock of the device.
        INTERNAL_REFERENCE = 1, "internal_reference";
        /// External clock, to which the PPS synchronizes the device.
        EXTERNAL_TIME = 2, "external_time";
        /// Latency relative to the arrival of the command.
        TIME_OF_ARRIVAL = 3, "time_of_arrival";
    }
}

record! {
    /// Time at which a measurement was taken.
    #[derive(Copy, Eq, Hash)]
    pub struct MeasurementTime {
        /// Clock that the time refers to.
        pub timebase: Timebase,
        /// Reserved: send 1.
        pub reserved: u8,
        /// Time by that clock.
        ///
        /// Unit: ns.
        pub nanoseconds: u64,
    }
}

item! { MeasurementTime { timebase reserved nanoseconds } }
#[rustfmt::skip]
impl core::default::Default for MeasurementTime {
    fn default() -> Self {
        Self {
            timebase: core::default::Default::default(),
            reserved: 1,
            nanoseconds: core::default::Default::default(),
        }
    }
}

view! {
    MeasurementTime
    timebase: Timebase, at 0;
    reserved: u8, at 1;
    nanoseconds: u64, at 2;
}

constructors! {
    MeasurementTime

    /// Creates it from its values.
    fn new(timebase: Timebase, nanoseconds: u64), reserved: 1;
}

bitfield! {
    /// Valid axes of a measurement; the others are ignored.
    AxisFlags: u16 {
        /// First axis. Bit 0.
        X: bool = 0,
            x, set_x, with_x;
        /// Second axis. Bit 1.
        Y: bool = 1,
            y, set_y, with_y;
        /// Third axis. Bit 2.
        Z: bool = 2,
            z, set_z, with_z;
    }
}

bitfield! {
    /// Valid coordinates of a position; the others are ignored.
    LlhAxisFlags: u16 {
        /// Latitude and its uncertainty are valid. Bit 0.
        LATITUDE: bool = 0,
            latitude, set_latitude, with_latitude;
        /// Longitude and its uncertainty are valid. Bit 1.
        LONGITUDE: bool = 1,
            longitude, set_longitude, with_longitude;
        /// Height and its uncertainty are valid. Bit 2.
        HEIGHT: bool = 2,
            height, set_height, with_height;
    }
}

record! {
    /// Frame configuration (0x13,0x01).
    ///
    /// Sets the position and the orientation of an external sensor on the vehicle.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`FrameConfigResponse`]. Affects
    /// [`filter_data::AidingFrameConfigError`](crate::filter_data::AidingFrameConfigError).
    /// Probably affects
    /// [`filter_data::AidingFrameConfigErrorUncertainty`](crate::filter_data::AidingFrameConfigErrorUncertainty).
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and [3DM-CV7-INS](crate::devices::CV7_INS);
    /// likely or assumed on 7 more.
    ///
    /// - Aiding measurements refer to the frame by its number.
    /// - `p_vehicle = R * p_frame + t`, with the rotation R and the translation t.
    /// - For GNSS positions and velocities the rotation does not matter. Send the identity: Euler
    ///   angles 0, 0, 0 or the quaternion 1, 0, 0, 0.
    /// - In a read, `format` selects the format of the rotation in the reply.
    ///
    /// Source: 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01); 3dm-cv7-gnss-ins: Aiding Frames.
    #[derive(Copy)]
    pub struct FrameConfig {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Number of the frame.
        ///
        /// Range: 1 to 4.
        pub frame_id: Option<u8>,
        /// Format of the rotation.
        ///
        /// Required for [write](types::FunctionSelector::WRITE) and
        /// [read](types::FunctionSelector::READ).
        pub format: Option<AidingFrameFormat>,
        /// True if the filter estimates the errors of the frame.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub tracking_enabled: Option<crate::Bool>,
        /// Position of the frame's origin in the vehicle frame.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub translation: Option<types::Vector3f>,
        /// Rotates vectors of this frame into the vehicle frame.
        ///
        /// Selected by [`format`](FrameConfig::format). Required for
        /// [write](types::FunctionSelector::WRITE).
        pub rotation: Option<FrameConfigRotation>,
    }
    wire 32 {
        [function selects]
        [frame_id for WRITE READ SAVE LOAD DEFAULT]
        [format for WRITE READ]
        [tracking_enabled for WRITE]
        [translation for WRITE]
        [rotation as format for WRITE]
    }
}

union! {
    /// The alternatives of `rotation` in [`FrameConfig`].
    #[derive(Copy)]
    pub enum FrameConfigRotation: AidingFrameFormat {
        /// Roll, pitch and yaw of the frame relative to the vehicle; positive are right side down,
        /// nose up, and clockwise seen from above.
        ///
        /// If [`format`](FrameConfig::format) is [`AidingFrameFormat::EULER`]. Elements: x, y, z.
        /// Unit: rad. Frame: vehicle. Range: -pi to pi.
        #[cfg_attr(feature = "serde", serde(rename = "euler"))]
        EULER => Euler(types::Vector3f) "euler",
        /// Quaternion, scalar part first.
        ///
        /// If [`format`](FrameConfig::format) is [`AidingFrameFormat::QUATERNION`]. Elements: w, x,
        /// y, z. Unit: 1.
        #[cfg_attr(feature = "serde", serde(rename = "quaternion"))]
        QUATERNION => Quaternion(types::Quatf) "quaternion",
    }
    default FrameConfigRotation::Other(AidingFrameFormat(0))
}

ranges! {
    FrameConfig
    frame_id "frame_id" in "1 to 4" From 1.0 To 4.0;
}

constructors! {
    FrameConfig

    /// Apply the new setting.
    fn write(
        frame_id: u8,
        tracking_enabled: bool,
        translation: impl Into<types::Vector3f>,
        rotation: FrameConfigRotation,
    ) -> WriteCall, format: rotation.tag();

    /// Return the current setting in a response.
    fn read(frame_id: u8, format: AidingFrameFormat) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(frame_id: u8) -> SaveCall;

    /// Load the saved setting.
    fn load(frame_id: u8) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(frame_id: u8) -> LoadDefaultCall;
}

field! {
    FrameConfig: 0x01, "aiding.frame_config";
    in [0x13];
}

command! {
    FrameConfig -> Option<FrameConfigResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> FrameConfigResponse;
    responds FrameConfigResponse for READ;
    checks Ranged;
}

change! {
    FrameConfigResponse -> WriteCall FrameConfig
    [frame_id tracking_enabled translation rotation] format: rotation.tag(),
}

record! {
    /// Sensor frame map (0x13,0x02).
    ///
    /// Sets the frame in which an aiding sensor measures.
    ///
    /// Also called `sensor_frame_mapping`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`SensorFrameMapResponse`]. Not listed in any device profile. Known only from the
    /// MicroStrain MIP SDK, versions 1 to 3. Uncertain: The layout is that of a branch of the SDK
    /// of 2024; later versions do not have it. Uncertain: No source lists the devices that support
    /// it.
    ///
    /// Source: mip-sdk-3: Sensor Frame Mapping (0x13,0x02), branch CmdCallback.
    #[derive(Copy, Eq, Hash)]
    pub struct SensorFrameMap {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Number of the sensor.
        ///
        /// Range: at least 1. Required for [write](types::FunctionSelector::WRITE).
        pub sensor_id: Option<u8>,
        /// Frame of the sensor, defined by [`FrameConfig`].
        ///
        /// Range: 1 to 4. Default: 1. Required for [write](types::FunctionSelector::WRITE).
        pub frame_id: Option<u8>,
    }
    wire 3 {
        [function selects]
        [sensor_id for WRITE]
        [frame_id for WRITE]
    }
}

ranges! {
    SensorFrameMap
    sensor_id "sensor_id" in "at least 1" From 1.0;
    frame_id "frame_id" in "1 to 4" From 1.0 To 4.0;
}

constructors! {
    SensorFrameMap

    /// Apply the new setting.
    fn write(sensor_id: u8, frame_id: u8) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    SensorFrameMap: 0x02, "aiding.sensor_frame_map";
    in [0x13];
}

command! {
    SensorFrameMap -> Option<SensorFrameMapResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> SensorFrameMapResponse;
    responds SensorFrameMapResponse for READ;
    checks Ranged;
}

change! {
    SensorFrameMapResponse -> WriteCall SensorFrameMap
    [sensor_id frame_id]
}

record! {
    /// Echo control (0x13,0x1F).
    ///
    /// Sets how the device replies to aiding measurements.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`EchoControlResponse`]. Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 8 more.
    ///
    /// - The manual does not contain the layout of the responses that carry the data back.
    ///
    /// Source: 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F); 3dm-cv7-gnss-ins: Aiding Command Echo
    /// Control.
    #[derive(Copy, Eq, Hash)]
    pub struct EchoControl {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Reply mode.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub mode: Option<AidingEchoMode>,
    }
    wire 2 {
        [function selects]
        [mode for WRITE]
    }
}

constructors! {
    EchoControl

    /// Apply the new setting.
    fn write(mode: AidingEchoMode) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    EchoControl: 0x1F, "aiding.echo_control";
    in [0x13];
}

command! {
    EchoControl -> Option<EchoControlResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> EchoControlResponse;
    responds EchoControlResponse for READ;
}

change! {
    EchoControlResponse -> WriteCall EchoControl
    [mode]
}

record! {
    /// ECEF position (0x13,0x21).
    ///
    /// Sends a measured position in Earth-fixed coordinates.
    ///
    /// Also called `pos_ecef`. Not acknowledged if [`mode`](EchoControl::mode) of [`EchoControl`]
    /// is [`AidingEchoMode::SUPPRESS_ACK`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 3 more.
    ///
    /// - Use only one form of position: ECEF or LLH.
    /// - In mode `response` of [`EchoControl`], the device sends the data back in a response of
    ///   unknown layout.
    ///
    /// Source: 3dm-cv7-gnss-ins: ECEF Position (0x13,0x21); 3dm-cv7-gnss-ins: Filter Aiding
    /// Measurements \> ECEF Position.
    #[derive(Copy, Default)]
    pub struct EcefPosition {
        /// Time of the measurement.
        pub time: MeasurementTime,
        /// Sensor frame, defined by [`FrameConfig`].
        ///
        /// Range: 1 to 4.
        pub frame_id: u8,
        /// Position of the origin of the frame.
        ///
        /// Elements: x, y, z. Unit: m. Frame: ecef. Each element has its own valid flag. x:
        /// [`valid_flags.x`](AxisFlags::x), y: [`valid_flags.y`](AxisFlags::y), z:
        /// [`valid_flags.z`](AxisFlags::z).
        pub position: types::Vector3d,
        /// Uncertainty of the position.
        ///
        /// Elements: x, y, z. Unit: m. Frame: ecef. Range: greater than 0. Each element has its own
        /// valid flag. x: [`valid_flags.x`](AxisFlags::x), y: [`valid_flags.y`](AxisFlags::y), z:
        /// [`valid_flags.z`](AxisFlags::z).
        pub uncertainty: types::Vector3f,
        /// Valid axes.
        pub valid_flags: AxisFlags,
    }
}

ranges! {
    EcefPosition
    frame_id "frame_id" in "1 to 4" From 1.0 To 4.0;
    uncertainty "uncertainty" in "greater than 0" Above 0.0;
}

constructors! {
    EcefPosition

    /// Creates the command from its parameters.
    fn new(
        time: MeasurementTime,
        frame_id: u8,
        position: impl Into<types::Vector3d>,
        uncertainty: impl Into<types::Vector3f>,
        valid_flags: AxisFlags,
    );
}

valid! {
    EcefPosition
    position_is_valid "position": valid_flags 0x1 && valid_flags 0x2 && valid_flags 0x4;
    uncertainty_is_valid "uncertainty": valid_flags 0x1 && valid_flags 0x2 && valid_flags 0x4;
}

field! {
    EcefPosition: 0x21, "aiding.ecef_position";
    in [0x13];
}

command! {
    EcefPosition -> ();
    checks Ranged;
}

record! {
    /// LLH position (0x13,0x22).
    ///
    /// Sends a measured position as latitude, longitude and height.
    ///
    /// Also called `pos_llh`. Not acknowledged if [`mode`](EchoControl::mode) of [`EchoControl`] is
    /// [`AidingEchoMode::SUPPRESS_ACK`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 3 more.
    ///
    /// - Use only one form of position: ECEF or LLH.
    /// - To send a height only, clear the valid flags of latitude and longitude. An uncertainty of
    ///   0 is no substitute.
    /// - In mode `response` of [`EchoControl`], the device sends the data back in a response of
    ///   unknown layout.
    ///
    /// Source: 3dm-cv7-gnss-ins: LLH Position (0x13,0x22); 3dm-cv7-gnss-ins: Filter Aiding
    /// Measurements \> LLH Position.
    #[derive(Copy, Default)]
    pub struct LlhPosition {
        /// Time of the measurement.
        pub time: MeasurementTime,
        /// Sensor frame, defined by [`FrameConfig`].
        ///
        /// Range: 1 to 4.
        pub frame_id: u8,
        /// Geodetic latitude.
        ///
        /// Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Valid if
        /// [`valid_flags.latitude`](LlhAxisFlags::latitude) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub latitude: f64,
        /// Geodetic longitude.
        ///
        /// Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Valid if
        /// [`valid_flags.longitude`](LlhAxisFlags::longitude) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub longitude: f64,
        /// Height above the ellipsoid.
        ///
        /// Unit: m. Frame: llh. Valid if [`valid_flags.height`](LlhAxisFlags::height) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub height: f64,
        /// Uncertainty of the position.
        ///
        /// Elements: north, east, down. Unit: m. Frame: ned. Range: greater than 0. Each element
        /// has its own valid flag. north: [`valid_flags.latitude`](LlhAxisFlags::latitude), east:
        /// [`valid_flags.longitude`](LlhAxisFlags::longitude), down:
        /// [`valid_flags.height`](LlhAxisFlags::height).
        pub uncertainty: types::Ned3f,
        /// Valid coordinates.
        pub valid_flags: LlhAxisFlags,
    }
}

ranges! {
    LlhPosition
    frame_id "frame_id" in "1 to 4" From 1.0 To 4.0;
    latitude "latitude" in "-90 to 90" From -90.0 To 90.0;
    longitude "longitude" in "-180 to 180" From -180.0 To 180.0;
    uncertainty "uncertainty" in "greater than 0" Above 0.0;
}

constructors! {
    LlhPosition

    /// Creates the command from its parameters.
    fn new(
        time: MeasurementTime,
        frame_id: u8,
        latitude: f64,
        longitude: f64,
        height: f64,
        uncertainty: impl Into<types::Ned3f>,
        valid_flags: LlhAxisFlags,
    );
}

valid! {
    LlhPosition
    latitude_is_valid "latitude": valid_flags 0x1;
    longitude_is_valid "longitude": valid_flags 0x2;
    height_is_valid "height": valid_flags 0x4;
    uncertainty_is_valid "uncertainty": valid_flags 0x1 && valid_flags 0x2 && valid_flags 0x4;
}

field! {
    LlhPosition: 0x22, "aiding.llh_position";
    in [0x13];
}

command! {
    LlhPosition -> ();
    checks Ranged;
}

record! {
    /// Height above ellipsoid (0x13,0x23).
    ///
    /// Sends a measured height above the ellipsoid.
    ///
    /// Not acknowledged if [`mode`](EchoControl::mode) of [`EchoControl`] is
    /// [`AidingEchoMode::SUPPRESS_ACK`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 3 more.
    ///
    /// - In mode `response` of [`EchoControl`], the device sends the data back in a response of
    ///   unknown layout.
    ///
    /// Source: 3dm-cv7-gnss-ins: Height Above Ellipsoid (0x13,0x23).
    #[derive(Copy, Default)]
    pub struct HeightAboveEllipsoid {
        /// Time of the measurement.
        pub time: MeasurementTime,
        /// Sensor frame, defined by [`FrameConfig`].
        ///
        /// Range: 1 to 4.
        pub frame_id: u8,
        /// Height above the ellipsoid.
        ///
        /// Unit: m. Frame: llh.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub height: f32,
        /// Uncertainty of the height.
        ///
        /// Unit: m. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub uncertainty: f32,
        /// Nonzero if the measurement is valid.
        pub valid_flags: u16,
    }
}

ranges! {
    HeightAboveEllipsoid
    frame_id "frame_id" in "1 to 4" From 1.0 To 4.0;
    uncertainty "uncertainty" in "at least 0" From 0.0;
}

constructors! {
    HeightAboveEllipsoid

    /// Creates the command from its parameters.
    fn new(
        time: MeasurementTime,
        frame_id: u8,
        height: f32,
        uncertainty: f32,
        valid_flags: u16,
    );
}

field! {
    HeightAboveEllipsoid: 0x23, "aiding.height_above_ellipsoid";
    in [0x13];
}

command! {
    HeightAboveEllipsoid -> ();
    checks Ranged;
}

record! {
    /// Pressure (old) (0x13,0x25).
    ///
    /// Sends a static air pressure measured by an external sensor (superseded by [`Pressure`]).
    ///
    /// Not acknowledged if [`mode`](EchoControl::mode) of [`EchoControl`] is
    /// [`AidingEchoMode::SUPPRESS_ACK`]. Not listed in any device profile. Known only from the
    /// MicroStrain MIP SDK, versions 1 to 3. Uncertain: The layout is that of a branch of the SDK
    /// of 2024; later versions do not have it. Uncertain: No source lists the devices that support
    /// it.
    ///
    /// Source: mip-sdk-3: Pressure (0x13,0x25), branch feature/UsbSerial.
    #[derive(Copy, Default)]
    pub struct PressureOld {
        /// Time of the measurement.
        pub time: MeasurementTime,
        /// Sensor frame, defined by [`FrameConfig`].
        ///
        /// Range: 1 to 4.
        pub frame_id: u8,
        /// Air pressure.
        ///
        /// Unit: mbar.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub pressure: f32,
        /// Standard deviation of the pressure.
        ///
        /// Unit: mbar. Range: greater than 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub uncertainty: f32,
        /// Nonzero if the measurement is valid.
        pub valid_flags: u16,
    }
}

ranges! {
    PressureOld
    frame_id "frame_id" in "1 to 4" From 1.0 To 4.0;
    uncertainty "uncertainty" in "greater than 0" Above 0.0;
}

constructors! {
    PressureOld

    /// Creates the command from its parameters.
    fn new(
        time: MeasurementTime,
        frame_id: u8,
        pressure: f32,
        uncertainty: f32,
        valid_flags: u16,
    );
}

field! {
    PressureOld: 0x25, "aiding.pressure_old";
    in [0x13];
}

command! {
    PressureOld -> ();
    checks Ranged;
}

record! {
    /// ECEF velocity (0x13,0x28).
    ///
    /// Sends a measured velocity in Earth-fixed coordinates.
    ///
    /// Also called `vel_ecef`. Not acknowledged if [`mode`](EchoControl::mode) of [`EchoControl`]
    /// is [`AidingEchoMode::SUPPRESS_ACK`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 3 more.
    ///
    /// - Use only one form of velocity: ECEF or NED.
    /// - For a sensor that is fixed to the vehicle, use [`BodyFrameVelocity`].
    /// - In mode `response` of [`EchoControl`], the device sends the data back in a response of
    ///   unknown layout.
    ///
    /// Source: 3dm-cv7-gnss-ins: ECEF Velocity (0x13,0x28); 3dm-cv7-gnss-ins: Filter Aiding
    /// Measurements \> ECEF Velocity.
    #[derive(Copy, Default)]
    pub struct EcefVelocity {
        /// Time of the measurement.
        pub time: MeasurementTime,
        /// Sensor frame, defined by [`FrameConfig`].
        ///
        /// Range: 1 to 4.
        pub frame_id: u8,
        /// Velocity of the origin of the frame.
        ///
        /// Elements: x, y, z. Unit: m/s. Frame: ecef. Each element has its own valid flag. x:
        /// [`valid_flags.x`](AxisFlags::x), y: [`valid_flags.y`](AxisFlags::y), z:
        /// [`valid_flags.z`](AxisFlags::z).
        pub velocity: types::Vector3f,
        /// Uncertainty of the velocity.
        ///
        /// Elements: x, y, z. Unit: m/s. Frame: ecef. Range: greater than 0. Each element has its
        /// own valid flag. x: [`valid_flags.x`](AxisFlags::x), y: [`valid_flags.y`](AxisFlags::y),
        /// z: [`valid_flags.z`](AxisFlags::z).
        pub uncertainty: types::Vector3f,
        /// Valid axes.
        pub valid_flags: AxisFlags,
    }
}

ranges! {
    EcefVelocity
    frame_id "frame_id" in "1 to 4" From 1.0 To 4.0;
    uncertainty "uncertainty" in "greater than 0" Above 0.0;
}

constructors! {
    EcefVelocity

    /// Creates the command from its parameters.
    fn new(
        time: MeasurementTime,
        frame_id: u8,
        velocity: impl Into<types::Vector3f>,
        uncertainty: impl Into<types::Vector3f>,
        valid_flags: AxisFlags,
    );
}

valid! {
    EcefVelocity
    velocity_is_valid "velocity": valid_flags 0x1 && valid_flags 0x2 && valid_flags 0x4;
    uncertainty_is_valid "uncertainty": valid_flags 0x1 && valid_flags 0x2 && valid_flags 0x4;
}

field! {
    EcefVelocity: 0x28, "aiding.ecef_velocity";
    in [0x13];
}

command! {
    EcefVelocity -> ();
    checks Ranged;
}

record! {
    /// NED velocity (0x13,0x29).
    ///
    /// Sends a measured velocity in the local level frame.
    ///
    /// Also called `vel_ned`. Not acknowledged if [`mode`](EchoControl::mode) of [`EchoControl`] is
    /// [`AidingEchoMode::SUPPRESS_ACK`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 3 more.
    ///
    /// - Use only one form of velocity: ECEF or NED.
    /// - For a sensor that is fixed to the vehicle, use [`BodyFrameVelocity`].
    /// - In mode `response` of [`EchoControl`], the device sends the data back in a response of
    ///   unknown layout.
    ///
    /// Source: 3dm-cv7-gnss-ins: NED Velocity (0x13,0x29); 3dm-cv7-gnss-ins: Filter Aiding
    /// Measurements \> NED Velocity.
    #[derive(Copy, Default)]
    pub struct NedVelocity {
        /// Time of the measurement.
        pub time: MeasurementTime,
        /// Sensor frame, defined by [`FrameConfig`].
        ///
        /// Range: 1 to 4.
        pub frame_id: u8,
        /// Velocity of the origin of the frame.
        ///
        /// Elements: north, east, down. Unit: m/s. Frame: ned. Each element has its own valid flag.
        /// north: [`valid_flags.x`](AxisFlags::x), east: [`valid_flags.y`](AxisFlags::y), down:
        /// [`valid_flags.z`](AxisFlags::z).
        pub velocity: types::Ned3f,
        /// Uncertainty of the velocity.
        ///
        /// Elements: north, east, down. Unit: m/s. Frame: ned. Range: greater than 0. Each element
        /// has its own valid flag. north: [`valid_flags.x`](AxisFlags::x), east:
        /// [`valid_flags.y`](AxisFlags::y), down: [`valid_flags.z`](AxisFlags::z).
        pub uncertainty: types::Ned3f,
        /// Valid axes.
        pub valid_flags: AxisFlags,
    }
}

ranges! {
    NedVelocity
    frame_id "frame_id" in "1 to 4" From 1.0 To 4.0;
    uncertainty "uncertainty" in "greater than 0" Above 0.0;
}

constructors! {
    NedVelocity

    /// Creates the command from its parameters.
    fn new(
        time: MeasurementTime,
        frame_id: u8,
        velocity: impl Into<types::Ned3f>,
        uncertainty: impl Into<types::Ned3f>,
        valid_flags: AxisFlags,
    );
}

valid! {
    NedVelocity
    velocity_is_valid "velocity": valid_flags 0x1 && valid_flags 0x2 && valid_flags 0x4;
    uncertainty_is_valid "uncertainty": valid_flags 0x1 && valid_flags 0x2 && valid_flags 0x4;
}

field! {
    NedVelocity: 0x29, "aiding.ned_velocity";
    in [0x13];
}

command! {
    NedVelocity -> ();
    checks Ranged;
}

record! {
    /// Body frame velocity (0x13,0x2A).
    ///
    /// Sends a measured velocity of the vehicle in the frame of the sensor.
    ///
    /// Also called `vel_body_frame`. Not acknowledged if [`mode`](EchoControl::mode) of
    /// [`EchoControl`] is [`AidingEchoMode::SUPPRESS_ACK`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 3 more.
    ///
    /// - The device supports up to four sensors of this kind.
    /// - For a wheeled vehicle constraint, send a velocity of 0 with only y valid, at least once
    ///   per second.
    /// - With z also valid and 0, motion is constrained to a plane (2D mode).
    /// - For a zero velocity update, send a velocity of 0 while the GNSS speed is below a threshold
    ///   that you choose.
    /// - In mode `response` of [`EchoControl`], the device sends the data back in a response of
    ///   unknown layout.
    ///
    /// Source: 3dm-cv7-gnss-ins: Body Frame Velocity (0x13,0x2A); 3dm-cv7-gnss-ins: Filter Aiding
    /// Measurements \> Body Frame Velocity; 3dm-cv7-gnss-ins: Filter Kinematic Constraints.
    #[derive(Copy, Default)]
    pub struct BodyFrameVelocity {
        /// Time of the measurement.
        pub time: MeasurementTime,
        /// Sensor frame, defined by [`FrameConfig`].
        ///
        /// Range: 1 to 4.
        pub frame_id: u8,
        /// Velocity of the origin of the frame.
        ///
        /// Elements: x, y, z. Unit: m/s. Frame: aiding. Each element has its own valid flag. x:
        /// [`valid_flags.x`](AxisFlags::x), y: [`valid_flags.y`](AxisFlags::y), z:
        /// [`valid_flags.z`](AxisFlags::z).
        pub velocity: types::Vector3f,
        /// Standard deviation of the velocity.
        ///
        /// Elements: x, y, z. Unit: m/s. Frame: aiding. Range: greater than 0. Each element has its
        /// own valid flag. x: [`valid_flags.x`](AxisFlags::x), y: [`valid_flags.y`](AxisFlags::y),
        /// z: [`valid_flags.z`](AxisFlags::z).
        pub uncertainty: types::Vector3f,
        /// Valid axes.
        pub valid_flags: AxisFlags,
    }
}

ranges! {
    BodyFrameVelocity
    frame_id "frame_id" in "1 to 4" From 1.0 To 4.0;
    uncertainty "uncertainty" in "greater than 0" Above 0.0;
}

constructors! {
    BodyFrameVelocity

    /// Creates the command from its parameters.
    fn new(
        time: MeasurementTime,
        frame_id: u8,
        velocity: impl Into<types::Vector3f>,
        uncertainty: impl Into<types::Vector3f>,
        valid_flags: AxisFlags,
    );
}

valid! {
    BodyFrameVelocity
    velocity_is_valid "velocity": valid_flags 0x1 && valid_flags 0x2 && valid_flags 0x4;
    uncertainty_is_valid "uncertainty": valid_flags 0x1 && valid_flags 0x2 && valid_flags 0x4;
}

field! {
    BodyFrameVelocity: 0x2A, "aiding.body_frame_velocity";
    in [0x13];
}

command! {
    BodyFrameVelocity -> ();
    checks Ranged;
}

record! {
    /// True heading (0x13,0x31).
    ///
    /// Sends a measured heading relative to true north.
    ///
    /// Also called `heading_true`. Not acknowledged if [`mode`](EchoControl::mode) of
    /// [`EchoControl`] is [`AidingEchoMode::SUPPRESS_ACK`]. Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 8 more.
    ///
    /// - In mode `response` of [`EchoControl`], the device sends the data back in a response of
    ///   unknown layout.
    ///
    /// Source: 3dm-cv7-gnss-ins: True Heading (0x13,0x31); 3dm-cv7-gnss-ins: Filter Aiding
    /// Measurements \> True Heading.
    #[derive(Copy, Default)]
    pub struct TrueHeading {
        /// Time of the measurement.
        pub time: MeasurementTime,
        /// Sensor frame, defined by [`FrameConfig`].
        ///
        /// Range: 1 to 4.
        pub frame_id: u8,
        /// Heading relative to true north.
        ///
        /// Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from above.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading: f32,
        /// Uncertainty of the heading.
        ///
        /// Unit: rad. Range: greater than 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub uncertainty: f32,
        /// Nonzero if the measurement is valid.
        pub valid_flags: u16,
    }
}

ranges! {
    TrueHeading
    frame_id "frame_id" in "1 to 4" From 1.0 To 4.0;
    heading "heading" in "-pi to pi" From -3.141592653589793 To 3.141592653589793;
    uncertainty "uncertainty" in "greater than 0" Above 0.0;
}

constructors! {
    TrueHeading

    /// Creates the command from its parameters.
    fn new(
        time: MeasurementTime,
        frame_id: u8,
        heading: f32,
        uncertainty: f32,
        valid_flags: u16,
    );
}

field! {
    TrueHeading: 0x31, "aiding.true_heading";
    in [0x13];
}

command! {
    TrueHeading -> ();
    checks Ranged;
}

record! {
    /// Magnetic field (0x13,0x32).
    ///
    /// Sends a magnetic field measured by an external magnetometer.
    ///
    /// Not acknowledged if [`mode`](EchoControl::mode) of [`EchoControl`] is
    /// [`AidingEchoMode::SUPPRESS_ACK`]. Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-AR](crate::devices::CV7_AR) and [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS);
    /// likely or assumed on 7 more.
    ///
    /// - The magnetometer must be calibrated.
    /// - In mode `response` of [`EchoControl`], the device sends the data back in a response of
    ///   unknown layout.
    ///
    /// Source: 3dm-cv7-gnss-ins: Magnetic Field (0x13,0x32); 3dm-cv7-gnss-ins: Filter Aiding
    /// Measurements \> External Magnetometer.
    #[derive(Copy, Default)]
    pub struct MagneticField {
        /// Time of the measurement.
        pub time: MeasurementTime,
        /// Sensor frame, defined by [`FrameConfig`].
        ///
        /// Range: 1 to 4.
        pub frame_id: u8,
        /// Calibrated magnetic field.
        ///
        /// Elements: x, y, z. Unit: gauss. Frame: aiding. Each element has its own valid flag. x:
        /// [`valid_flags.x`](AxisFlags::x), y: [`valid_flags.y`](AxisFlags::y), z:
        /// [`valid_flags.z`](AxisFlags::z).
        pub magnetic_field: types::Vector3f,
        /// Standard deviation of the magnetic field.
        ///
        /// Elements: x, y, z. Unit: gauss. Frame: aiding. Range: greater than 0. Each element has
        /// its own valid flag. x: [`valid_flags.x`](AxisFlags::x), y:
        /// [`valid_flags.y`](AxisFlags::y), z: [`valid_flags.z`](AxisFlags::z).
        pub uncertainty: types::Vector3f,
        /// Valid axes.
        pub valid_flags: AxisFlags,
    }
}

ranges! {
    MagneticField
    frame_id "frame_id" in "1 to 4" From 1.0 To 4.0;
    uncertainty "uncertainty" in "greater than 0" Above 0.0;
}

constructors! {
    MagneticField

    /// Creates the command from its parameters.
    fn new(
        time: MeasurementTime,
        frame_id: u8,
        magnetic_field: impl Into<types::Vector3f>,
        uncertainty: impl Into<types::Vector3f>,
        valid_flags: AxisFlags,
    );
}

valid! {
    MagneticField
    magnetic_field_is_valid "magnetic_field": valid_flags 0x1 && valid_flags 0x2 && valid_flags 0x4;
    uncertainty_is_valid "uncertainty": valid_flags 0x1 && valid_flags 0x2 && valid_flags 0x4;
}

field! {
    MagneticField: 0x32, "aiding.magnetic_field";
    in [0x13];
}

command! {
    MagneticField -> ();
    checks Ranged;
}

record! {
    /// Pressure (0x13,0x33).
    ///
    /// Sends a static air pressure measured by an external sensor.
    ///
    /// Not acknowledged if [`mode`](EchoControl::mode) of [`EchoControl`] is
    /// [`AidingEchoMode::SUPPRESS_ACK`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 3 more.
    ///
    /// - In mode `response` of [`EchoControl`], the device sends the data back in a response of
    ///   unknown layout.
    ///
    /// Source: 3dm-cv7-gnss-ins: Pressure (0x13,0x33); 3dm-cv7-gnss-ins: Filter Aiding Measurements
    /// \> External Pressure.
    #[derive(Copy, Default)]
    pub struct Pressure {
        /// Time of the measurement.
        pub time: MeasurementTime,
        /// Sensor frame, defined by [`FrameConfig`].
        ///
        /// Range: 1 to 4.
        pub frame_id: u8,
        /// Air pressure.
        ///
        /// Unit: mbar.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub pressure: f32,
        /// Standard deviation of the pressure.
        ///
        /// Unit: mbar. Range: greater than 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub uncertainty: f32,
        /// Nonzero if the measurement is valid.
        pub valid_flags: u16,
    }
}

ranges! {
    Pressure
    frame_id "frame_id" in "1 to 4" From 1.0 To 4.0;
    uncertainty "uncertainty" in "greater than 0" Above 0.0;
}

constructors! {
    Pressure

    /// Creates the command from its parameters.
    fn new(
        time: MeasurementTime,
        frame_id: u8,
        pressure: f32,
        uncertainty: f32,
        valid_flags: u16,
    );
}

field! {
    Pressure: 0x33, "aiding.pressure";
    in [0x13];
}

command! {
    Pressure -> ();
    checks Ranged;
}

record! {
    /// Frame configuration response (0x13,0x81).
    ///
    /// Response to [`FrameConfig`]. Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-AR](crate::devices::CV7_AR), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-CV7-INS](crate::devices::CV7_INS); likely or assumed on 7 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01); 3dm-cv7-gnss-ins: Aiding Frames.
    #[derive(Copy, Default)]
    pub struct FrameConfigResponse {
        /// Number of the frame.
        ///
        /// Range: 1 to 4.
        pub frame_id: u8,
        /// Format of the rotation.
        pub format: AidingFrameFormat,
        /// True if the filter estimates the errors of the frame.
        pub tracking_enabled: crate::Bool,
        /// Position of the frame's origin in the vehicle frame.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle.
        pub translation: types::Vector3f,
        /// Rotates vectors of this frame into the vehicle frame.
        ///
        /// Selected by [`format`](FrameConfigResponse::format).
        pub rotation: FrameConfigRotation,
    }
    wire 31 {
        [frame_id]
        [format]
        [tracking_enabled]
        [translation]
        [rotation as format]
    }
}

constructors! {
    FrameConfigResponse

    /// Creates it from its values.
    fn new(
        frame_id: u8,
        tracking_enabled: bool,
        translation: impl Into<types::Vector3f>,
        rotation: FrameConfigRotation,
    ), format: rotation.tag();
}

field! {
    FrameConfigResponse: 0x81, "aiding.frame_config_response";
    in [0x13];
    answers FrameConfig;
}

record! {
    /// Sensor frame map response (0x13,0x82).
    ///
    /// Also called `sensor_frame_mapping_response`. Response to [`SensorFrameMap`]. Known only from
    /// the MicroStrain MIP SDK, versions 1 to 3.
    ///
    /// Source: mip-sdk-3: Sensor Frame Mapping (0x13,0x02), branch CmdCallback.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct SensorFrameMapResponse {
        /// Number of the sensor.
        ///
        /// Range: at least 1.
        pub sensor_id: u8,
        /// Frame of the sensor, defined by [`FrameConfig`].
        ///
        /// Range: 1 to 4. Default: 1.
        pub frame_id: u8,
    }
}

view! {
    SensorFrameMapResponse
    sensor_id: u8, at 0;
    frame_id: u8, at 1;
}

constructors! {
    SensorFrameMapResponse

    /// Creates it from its values.
    fn new(sensor_id: u8, frame_id: u8);
}

field! {
    SensorFrameMapResponse: 0x82, "aiding.sensor_frame_map_response";
    in [0x13];
    answers SensorFrameMap;
}

record! {
    /// Echo control response (0x13,0x9F).
    ///
    /// Response to [`EchoControl`]. Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-AR](crate::devices::CV7_AR) and [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS);
    /// likely or assumed on 8 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F); 3dm-cv7-gnss-ins: Aiding Command Echo
    /// Control.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct EchoControlResponse {
        /// Reply mode.
        pub mode: AidingEchoMode,
    }
}

view! {
    EchoControlResponse
    mode: AidingEchoMode, at 0;
}

constructors! {
    EchoControlResponse

    /// Creates it from its values.
    fn new(mode: AidingEchoMode);
}

field! {
    EchoControlResponse: 0x9F, "aiding.echo_control_response";
    in [0x13];
    answers EchoControl;
}

//! Displacement commands (0x11): Commands of the DEMOD-DC, a demodulator for displacement sensors.
//! Inertial sensors do not support them.
//!
//! Source: mscl: Displacement Commands (0x11).

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: crate::DescriptorSet = crate::DescriptorSet(0x11);

record! {
    /// Get analog to displacement calibration (0x11,0x01).
    ///
    /// Reads the slope and offset with which the device converts ADC counts to displacement.
    ///
    /// No device is known for certain to support it. Also called
    /// `get_analog_displacement_calibration`. Response: [`GetCalibrationResponse`]. Known only from
    /// the MicroStrain Communication Library.
    ///
    /// Source: mscl: Get analog to displacement calibration (0x11,0x01).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetCalibration;
}

constructors! {
    GetCalibration

    /// Creates the command from its parameters.
    fn new();
}

field! {
    GetCalibration: 0x01, "displacement.get_calibration";
    in [0x11];
}

command! {
    GetCalibration -> GetCalibrationResponse;
    responds GetCalibrationResponse;
}

record! {
    /// Displacement output data rate (0x11,0x02).
    ///
    /// Reads the rate at which displacement is measured.
    ///
    /// No device is known for certain to support it. Also called `displacement_output_rate`.
    /// Functions: [read](types::FunctionSelector::READ). Response: [`OutputRateResponse`]. Known
    /// only from the MicroStrain Communication Library. Uncertain: MSCL only reads the rate; a
    /// write may not be supported.
    ///
    /// Source: mscl: Displacement output data rate (0x11,0x02).
    #[derive(Copy, Eq, Hash)]
    pub struct OutputRate {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
    }
    wire 1 {
        [function selects]
    }
}

constructors! {
    OutputRate

    /// Return the current setting in a response.
    fn read() -> ReadCall;
}

field! {
    OutputRate: 0x02, "displacement.output_rate";
    in [0x11];
}

command! {
    OutputRate -> Option<OutputRateResponse>;
    for READ -> OutputRateResponse;
    responds OutputRateResponse for READ;
}

record! {
    /// Displacement device time (0x11,0x04).
    ///
    /// Sets the clock of the device, from which
    /// [`displacement_data::Timestamp`](crate::displacement_data::Timestamp) is taken.
    ///
    /// No device is known for certain to support it. Also called `displacement_device_time`.
    /// Functions: [write](types::FunctionSelector::WRITE). Affects
    /// [`displacement_data::Timestamp`](crate::displacement_data::Timestamp). Known only from the
    /// MicroStrain Communication Library. Uncertain: MSCL only writes the time; a read may not be
    /// supported.
    ///
    /// Source: mscl: Displacement device time (0x11,0x04).
    #[derive(Copy, Eq, Hash)]
    pub struct DeviceTime {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// UTC since 1970-01-01, without leap seconds.
        ///
        /// Unit: ns.
        pub time: Option<u64>,
    }
    wire 9 {
        [function selects]
        [time for WRITE]
    }
}

constructors! {
    DeviceTime

    /// Apply the new setting.
    fn write(time: u64) -> WriteCall;
}

field! {
    DeviceTime: 0x04, "displacement.device_time";
    in [0x11];
}

command! {
    DeviceTime -> ();
    for WRITE -> ();
}

record! {
    /// Get analog to displacement calibration response (0x11,0x81).
    ///
    /// No device is known for certain to support it. Also called
    /// `get_analog_displacement_calibration_response`. Response to [`GetCalibration`]. Known only
    /// from the MicroStrain Communication Library.
    ///
    /// Source: mscl: Get analog to displacement calibration (0x11,0x01).
    #[derive(Copy, Default)]
    pub struct GetCalibrationResponse {
        /// Displacement per ADC count.
        ///
        /// Uncertain: No source states the unit; mm per count is likely.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub slope: f32,
        /// Displacement at zero counts.
        ///
        /// Uncertain: No source states the unit; mm is likely.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub offset: f32,
    }
}

view! {
    GetCalibrationResponse
    slope: f32, at 0;
    offset: f32, at 4;
}

constructors! {
    GetCalibrationResponse

    /// Creates it from its values.
    fn new(slope: f32, offset: f32);
}

field! {
    GetCalibrationResponse: 0x81, "displacement.get_calibration_response";
    in [0x11];
    answers GetCalibration;
}

record! {
    /// Displacement output data rate response (0x11,0x82).
    ///
    /// No device is known for certain to support it. Also called
    /// `displacement_output_rate_response`. Response to [`OutputRate`]. Known only from the
    /// MicroStrain Communication Library.
    ///
    /// Source: mscl: Displacement output data rate (0x11,0x02).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct OutputRateResponse {
        /// Rate of displacement data.
        ///
        /// Unit: Hz.
        pub rate: u32,
    }
}

view! {
    OutputRateResponse
    rate: u32, at 0;
}

constructors! {
    OutputRateResponse

    /// Creates it from its values.
    fn new(rate: u32);
}

field! {
    OutputRateResponse: 0x82, "displacement.output_rate_response";
    in [0x11];
    answers OutputRate;
}

//! System data (0xA0): State of the device as a whole.
//!
//! Source: 3dm-cv7-gnss-ins: System (0xA0).

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: crate::DescriptorSet = crate::DescriptorSet(0xA0);

bitfield! {
    /// Level of each GPIO pin, set for high. Bits of pins that do not exist read 0.
    GpioPinStates: u8 {
        /// GPIO pin 1 is high. Bit 0.
        PIN_1: bool = 0,
            pin_1, set_pin_1, with_pin_1;
        /// GPIO pin 2 is high. Bit 1.
        PIN_2: bool = 1,
            pin_2, set_pin_2, with_pin_2;
        /// GPIO pin 3 is high. Bit 2.
        PIN_3: bool = 2,
            pin_3, set_pin_3, with_pin_3;
        /// GPIO pin 4 is high. Bit 3.
        PIN_4: bool = 3,
            pin_4, set_pin_4, with_pin_4;
    }
}

record! {
    /// Built-in test (0xA0,0x01).
    ///
    /// Flags of the tests that run all the time.
    ///
    /// Confirmed on [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 8 more. Requires firmware
    /// later than 1.0.10 on the [3DM-GQ7-GNSS/INS](crate::devices::GQ7).
    ///
    /// - The field is long; stream it at a low rate or poll it.
    /// - A fault that has passed before the next message is still reported, because its flag stays
    ///   set until it is sent.
    /// - Each stream and each event action keeps its own copy of the flags.
    /// - Some flags may be set without a fault, for instance a receiver without a position fix.
    /// - Unnamed bits are reserved and must be ignored.
    ///
    /// Source: 3dm-cv7-gnss-ins: Built In Test (0xA0,0x01).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct BuiltInTest {
        /// Flags, defined by each device, least significant byte first: bit 8 is bit 0 of the
        /// second byte.
        ///
        /// On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
        /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-AHRS](crate::devices::CX7_AHRS),
        /// [3DM-CX7-AR](crate::devices::CX7_AR), [3DM-CX7-INS](crate::devices::CX7_INS),
        /// [3DM-GV7-AHRS](crate::devices::GV7_AHRS), [3DM-GV7-AR](crate::devices::GV7_AR) and
        /// [3DM-GV7-INS](crate::devices::GV7_INS): values of
        /// [`types::Cv7InertialContinuousBuiltInTest`]. On the
        /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values of
        /// [`types::Cv7ContinuousBuiltInTest`]. On the [3DM-GQ7-GNSS/INS](crate::devices::GQ7):
        /// values of [`types::Gq7ContinuousBuiltInTest`].
        pub result: [u8; 16],
    }
}

view! {
    BuiltInTest
    result: [u8; 16], at 0;
}

constructors! {
    BuiltInTest

    /// Creates it from its values.
    fn new(result: [u8; 16]);
}

#[rustfmt::skip]
impl BuiltInTest {
    /// Reads `result` as [`types::Cv7InertialContinuousBuiltInTest`].
    ///
    /// On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-AHRS](crate::devices::CX7_AHRS),
    /// [3DM-CX7-AR](crate::devices::CX7_AR), [3DM-CX7-INS](crate::devices::CX7_INS),
    /// [3DM-GV7-AHRS](crate::devices::GV7_AHRS), [3DM-GV7-AR](crate::devices::GV7_AR) and
    /// [3DM-GV7-INS](crate::devices::GV7_INS): values of
    /// [`types::Cv7InertialContinuousBuiltInTest`].
    #[inline]
    #[must_use]
    pub fn result_as_cv7_inertial_continuous_built_in_test(&self) -> types::Cv7InertialContinuousBuiltInTest {
        self.result.into()
    }

    /// Reads `result` as [`types::Cv7ContinuousBuiltInTest`].
    ///
    /// On the [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values of
    /// [`types::Cv7ContinuousBuiltInTest`].
    #[inline]
    #[must_use]
    pub fn result_as_cv7_continuous_built_in_test(&self) -> types::Cv7ContinuousBuiltInTest {
        self.result.into()
    }

    /// Reads `result` as [`types::Gq7ContinuousBuiltInTest`].
    ///
    /// On the [3DM-GQ7-GNSS/INS](crate::devices::GQ7): values of
    /// [`types::Gq7ContinuousBuiltInTest`].
    #[inline]
    #[must_use]
    pub fn result_as_gq7_continuous_built_in_test(&self) -> types::Gq7ContinuousBuiltInTest {
        self.result.into()
    }
}

field! {
    BuiltInTest: 0x01, "system_data.built_in_test";
    in [0xA0];
}

record! {
    /// Time sync status (0xA0,0x02).
    ///
    /// Synchronization of the device time with the pulse per second.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR)
    /// and [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 8 more. Requires
    /// firmware later than 1.0.10 on the [3DM-GQ7-GNSS/INS](crate::devices::GQ7).
    ///
    /// Source: 3dm-cv7-gnss-ins: Time Sync Status (0xA0,0x02).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct TimeSyncStatus {
        /// True while the lock is valid; false if the PPS is disabled or no pulse is found.
        pub time_sync: crate::Bool,
        /// Time since the last pulse, at most 255.
        ///
        /// Unit: s.
        pub last_pps_received: u8,
    }
}

view! {
    TimeSyncStatus
    time_sync: crate::Bool, at 0;
    last_pps_received: u8, at 1;
}

constructors! {
    TimeSyncStatus

    /// Creates it from its values.
    fn new(time_sync: bool, last_pps_received: u8);
}

field! {
    TimeSyncStatus: 0x02, "system_data.time_sync_status";
    in [0xA0];
}

record! {
    /// GPIO state (0xA0,0x03).
    ///
    /// Levels of all user GPIO pins.
    ///
    /// Confirmed on [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 9 more. Requires
    /// firmware later than 1.0.10 on the [3DM-GQ7-GNSS/INS](crate::devices::GQ7).
    ///
    /// - A pulse that is shorter than the period at which the field is sent is missed.
    /// - The pins are sampled within one base period of this set.
    /// - Levels are guaranteed to be valid only for pins that
    ///   [`mip_3dm::GpioConfig`](crate::mip_3dm::GpioConfig) configures for the GPIO feature.
    /// - For fast signals and exact times use the timestamp feature and the event system.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPIO State (0xA0,0x03).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GpioState {
        /// One bit for each pin.
        pub states: GpioPinStates,
    }
}

view! {
    GpioState
    states: GpioPinStates, at 0;
}

constructors! {
    GpioState

    /// Creates it from its values.
    fn new(states: GpioPinStates);
}

field! {
    GpioState: 0x03, "system_data.gpio_state";
    in [0xA0];
}

record! {
    /// GPIO analog value (0xA0,0x04).
    ///
    /// Voltage at one GPIO pin.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// - The pin must be configured as an analog input.
    ///
    /// Source: mip-sdk-4: GPIO analog value (0xA0,0x04).
    #[derive(Copy, Default)]
    pub struct GpioAnalogValue {
        /// GPIO pin, counted from 1.
        ///
        /// Range: at least 1.
        pub gpio_id: u8,
        /// Scaled voltage.
        ///
        /// Unit: V.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub value: f32,
    }
}

view! {
    GpioAnalogValue
    gpio_id: u8, at 0;
    value: f32, at 1;
}

constructors! {
    GpioAnalogValue

    /// Creates it from its values.
    fn new(gpio_id: u8, value: f32);
}

field! {
    GpioAnalogValue: 0x04, "system_data.gpio_analog_value";
    in [0xA0];
}

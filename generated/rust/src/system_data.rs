//! System data (0xA0): State of the device as a whole.
//!
//! - Manual 3dm-cv7-gnss-ins: System (0xA0)

use crate::macros::bitfield;
use crate::types;
use crate::{DecodeError, EncodeError, Field, Reader, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0xA0;

bitfield! {
    /// Level of each GPIO pin, set for high. Bits of pins that do not exist read 0.
    GpioPinStates: u8 {
        /// GPIO pin 1.
        PIN_1: bool = 0,
            "pin_1", pin_1, set_pin_1, with_pin_1;
        /// GPIO pin 2.
        PIN_2: bool = 1,
            "pin_2", pin_2, set_pin_2, with_pin_2;
        /// GPIO pin 3.
        PIN_3: bool = 2,
            "pin_3", pin_3, set_pin_3, with_pin_3;
        /// GPIO pin 4.
        PIN_4: bool = 3,
            "pin_4", pin_4, set_pin_4, with_pin_4;
    }
}

/// Built-in test (0xA0,0x01).
///
/// Flags of the tests that run all the time.
///
/// - The field is long; stream it at a low rate or poll it.
/// - A flag stays set until it is sent, so a short fault between two messages or during idle is not
///   lost.
/// - Each stream and each event action keeps its own copy of the flags.
/// - Some flags may be set without a fault, for instance a receiver without a position fix.
/// - Unnamed bits are reserved and must be ignored.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Built In Test (0xA0,0x01)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BuiltInTest {
    /// Flags, defined by each device, least significant byte first: bit 8 is bit 0 of the second
    /// byte.
    pub result: [u8; 16],
}

impl BuiltInTest {
    /// The meaning of `result` on the 3DM-CV7-GNSS/INS.
    #[must_use]
    pub fn result_as_cv7_continuous_built_in_test(&self) -> types::Cv7ContinuousBuiltInTest {
        types::Cv7ContinuousBuiltInTest(self.result)
    }
}

impl Wire for BuiltInTest {
    const SIZE: usize = 16;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let result = reader.read()?;
        Ok(Self { result })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.result)?;
        Ok(())
    }
}

impl Field for BuiltInTest {
    const SET: u8 = 0xA0;
    const DESCRIPTOR: u8 = 0x01;
    const NAME: &'static str = "system_data.built_in_test";
}

/// Time sync status (0xA0,0x02).
///
/// Whether the device time is locked to the pulse per second.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Time Sync Status (0xA0,0x02)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TimeSyncStatus {
    /// True while the lock is valid; false if the PPS is disabled or no pulse is found.
    pub time_sync: crate::Bool,
    /// Time since the last pulse, at most 255.
    ///
    /// Unit: s.
    pub last_pps_rcvd: u8,
}

impl Wire for TimeSyncStatus {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let time_sync = reader.read()?;
        let last_pps_rcvd = reader.read()?;
        Ok(Self { time_sync, last_pps_rcvd })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.time_sync)?;
        writer.write(&self.last_pps_rcvd)?;
        Ok(())
    }
}

impl Field for TimeSyncStatus {
    const SET: u8 = 0xA0;
    const DESCRIPTOR: u8 = 0x02;
    const NAME: &'static str = "system_data.time_sync_status";
}

/// GPIO state (0xA0,0x03).
///
/// Levels of all user GPIO pins.
///
/// - The pins are sampled within one base period of this set; shorter pulses can be missed.
/// - Only pins that are configured to the GPIO feature by (0x0C,0x41) are sure to give valid
///   levels.
/// - For fast signals and exact times use the timestamp feature and the event system.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GPIO State (0xA0,0x03)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GpioState {
    /// One bit for each pin.
    pub states: GpioPinStates,
}

impl Wire for GpioState {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let states = reader.read()?;
        Ok(Self { states })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.states)?;
        Ok(())
    }
}

impl Field for GpioState {
    const SET: u8 = 0xA0;
    const DESCRIPTOR: u8 = 0x03;
    const NAME: &'static str = "system_data.gpio_state";
}

/// GPIO analog value (0xA0,0x04).
///
/// Voltage at one GPIO pin.
///
/// - Only for pins that are configured as analog inputs.
/// - Manual mip-sdk-4: Gpio Analog Value (0xA0,0x04)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GpioAnalogValue {
    /// GPIO pin, counted from 1.
    ///
    /// Range: at least 1.
    pub gpio_id: u8,
    /// Scaled voltage.
    ///
    /// Unit: V.
    pub value: f32,
}

impl Wire for GpioAnalogValue {
    const SIZE: usize = 5;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let gpio_id = reader.read()?;
        let value = reader.read()?;
        Ok(Self { gpio_id, value })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.gpio_id)?;
        writer.write(&self.value)?;
        Ok(())
    }
}

impl Field for GpioAnalogValue {
    const SET: u8 = 0xA0;
    const DESCRIPTOR: u8 = 0x04;
    const NAME: &'static str = "system_data.gpio_analog_value";
}

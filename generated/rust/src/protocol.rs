//! The protocol itself: constants, and the acknowledge field.

use crate::types;
pub use crate::types::AckCode;
pub use crate::types::FunctionSelector;

/// Version of the specification from which this crate was generated.
pub const VERSION: &str = "0.2.0";
/// The two bytes with which every packet begins.
pub const SYNC: [u8; 2] = [0x75, 0x65];
/// Descriptor set and descriptor of the barrier command; zeros if the specification names none.
pub const BARRIER: [u8; 2] = [0x01, 0x01];

open_enum! {
    /// A descriptor set, by its number.
    ///
    /// ```
    /// use mip_protocol::{DescriptorSet, Packet};
    ///
    /// let packet = Packet::new(b"\x75\x65\x01\x04\x04\xF1\x01\x00\xD5\x6A")?;
    /// assert_eq!(packet.set(), DescriptorSet(0x01));
    /// assert_eq!(packet.set().0, 0x01);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    DescriptorSet: u8 {
        /// Base (0x01).
        BASE = 0x01, "base";
        /// 3DM (0x0C).
        MIP_3DM = 0x0C, "3dm";
        /// Filter commands (0x0D).
        FILTER = 0x0D, "filter";
        /// GNSS commands (0x0E).
        GNSS = 0x0E, "gnss";
        /// RTK commands (0x0F).
        RTK = 0x0F, "rtk";
        /// Displacement commands (0x11).
        DISPLACEMENT = 0x11, "displacement";
        /// Aiding commands (0x13).
        AIDING = 0x13, "aiding";
        /// System (0x7F).
        SYSTEM = 0x7F, "system";
        /// Sensor data (0x80).
        SENSOR = 0x80, "sensor";
        /// GNSS data (0x81).
        GNSS_DATA = 0x81, "gnss_data";
        /// Filter data (0x82).
        FILTER_DATA = 0x82, "filter_data";
        /// Displacement data (0x90).
        DISPLACEMENT_DATA = 0x90, "displacement_data";
        /// GNSS receiver 1 data (0x91).
        GNSS_1 = 0x91, "gnss_1";
        /// GNSS receiver 2 data (0x92).
        GNSS_2 = 0x92, "gnss_2";
        /// GNSS corrections data (0x93).
        GNSS_CORRECTIONS = 0x93, "gnss_corrections";
        /// External GNSS data (0x94).
        GNSS_EXTERNAL = 0x94, "gnss_external";
        /// External GNSS data 2 (0x95).
        GNSS_EXTERNAL_2 = 0x95, "gnss_external_2";
        /// System data (0xA0).
        SYSTEM_DATA = 0xA0, "system_data";
        /// Shared data (0xFF).
        SHARED = 0xFF, "shared";
    }
}

/// A command that has the function [`WRITE`](FunctionSelector::WRITE).
pub type WriteCall<C> = crate::Call<C, { FunctionSelector::WRITE.0 }>;
/// A command that has the function [`READ`](FunctionSelector::READ).
pub type ReadCall<C> = crate::Call<C, { FunctionSelector::READ.0 }>;
/// A command that has the function [`SAVE`](FunctionSelector::SAVE).
pub type SaveCall<C> = crate::Call<C, { FunctionSelector::SAVE.0 }>;
/// A command that has the function [`LOAD`](FunctionSelector::LOAD).
pub type LoadCall<C> = crate::Call<C, { FunctionSelector::LOAD.0 }>;
/// A command that has the function [`DEFAULT`](FunctionSelector::DEFAULT).
pub type LoadDefaultCall<C> = crate::Call<C, { FunctionSelector::DEFAULT.0 }>;
/// A command that has the function [`APPLY`](FunctionSelector::APPLY).
pub type ApplyCall<C> = crate::Call<C, { FunctionSelector::APPLY.0 }>;

record! {
    /// Acknowledge (0x00,0xF1).
    ///
    /// Replies to one command field. A response, if there is one, follows it in the same packet.
    ///
    /// Source: 3dm-gx5-15: 2.2.2 Example “Ping” Reply Packet; 3dm-cv7-gnss-ins: Ack/Nack Field
    /// Specification.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Acknowledge {
        /// Descriptor of the acknowledged command.
        pub command: u8,
        /// 0 (ACK) if the device carried out the command, otherwise the reason why it did not
        /// (NACK).
        pub code: types::AckCode,
    }
}

view! {
    Acknowledge
    command: u8, at 0;
    code: types::AckCode, at 1;
}

constructors! {
    Acknowledge

    /// Creates it from its values.
    fn new(command: u8, code: types::AckCode);
}

field! {
    Acknowledge: 0xF1, "protocol.acknowledge";
    in [0x01..=0x7F];
}

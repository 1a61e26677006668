//! The protocol itself: constants, and the acknowledge field.

use crate::types;
pub use crate::types::AckCode;
pub use crate::types::FunctionSelector;

/// Version of the specification from which this crate was generated.
pub const VERSION: &str = "0.1.0";
/// The two bytes with which every packet begins.
pub const SYNC: [u8; 2] = [0x75, 0x65];
/// Descriptor set and descriptor of the barrier command; zeros if the specification names none.
pub const BARRIER: [u8; 2] = [0x01, 0x01];

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

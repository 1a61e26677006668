#![doc = include_str!("../README.md")]
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]
#![deny(
    clippy::arithmetic_side_effects,
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::todo,
    clippy::unimplemented,
    clippy::unreachable,
    clippy::unwrap_used
)]
// Deprecated fields still have to be read, and there is no heap to put a large variant on.
#![allow(deprecated, clippy::large_enum_variant)]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

mod bits;
pub mod client;
pub mod codec;
pub mod field;
mod list;
mod macros;
pub mod packet;
mod parser;
#[cfg(feature = "std")]
mod stream;
mod text;

pub mod devices;
#[cfg(feature = "dynamic")]
pub mod dynamic;
pub mod protocol;
pub mod registry;
pub mod types;

pub mod aiding;
pub mod base;
pub mod filter;
pub mod filter_data;
pub mod gnss;
pub mod gnss_1;
pub mod gnss_2;
pub mod gnss_corrections;
pub mod gnss_data;
pub mod gnss_external;
pub mod gnss_external_2;
pub mod mip_3dm;
pub mod rtk;
pub mod sensor;
pub mod shared;
pub mod system;
pub mod system_data;

pub use bits::Bits;
pub use client::{Answer, Client, Event, RequestError, Ticket};
pub use codec::{Bool, DecodeError, EncodeError, Reader, Union, Wire, Writer};
pub use field::{Command, Field, RawField, Response, ResponseOf, Role};
pub use list::{CapacityError, List};
pub use packet::{checksum, FieldLengthError, Packet, PacketBuilder, PacketError};
pub use parser::Parser;
pub use registry::AnyField;
#[cfg(feature = "std")]
pub use stream::PacketReader;
pub use text::{Text, VarText};

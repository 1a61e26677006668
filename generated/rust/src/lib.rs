#![doc = include_str!("../README.md")]
#![doc = include_str!("map.md")]
#![cfg_attr(feature = "default", doc = include_str!("sets.md"))]
// Doc comments link to fields of other sets, which may be disabled.
#![cfg_attr(not(feature = "default"), allow(rustdoc::broken_intra_doc_links))]
// It would be a tenth of the documentation, and most of it invocations of macros.
#![doc(html_no_source)]
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![deny(missing_docs)]
#![deny(
    clippy::arithmetic_side_effects,
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::missing_errors_doc,
    clippy::panic,
    clippy::todo,
    clippy::unimplemented,
    clippy::unreachable,
    clippy::unwrap_used
)]
// Deprecated fields still have to be read, and there is no heap to put a large variant on.
#![allow(deprecated, clippy::large_enum_variant)]
// Clippy's pedantic lints report nothing else:
#![allow(
    // sums may wrap, and bits and sizes are known to fit;
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    // texts and numbers come from the specification;
    clippy::approx_constant,
    clippy::doc_markdown,
    clippy::unreadable_literal,
    // macros and traits use the same signatures for all types;
    clippy::default_trait_access,
    clippy::ref_option,
    clippy::trivially_copy_pass_by_ref,
    clippy::unnecessary_wraps,
    // the iterator over the fields of a packet is `fields`;
    clippy::into_iter_without_iter,
    // the gain from inlining was measured.
    clippy::inline_always
)]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

#[macro_use]
mod macros;

pub mod bits;
pub mod client;
pub mod codec;
pub mod device;
pub mod error;
pub mod field;
#[doc = include_str!("guide.md")]
pub mod guide {}
pub mod list;
#[cfg(feature = "alloc")]
mod owned;
pub mod packet;
mod parser;
#[allow(dead_code, unused_macros)] // a specification may state no ranges
mod range;
#[cfg(feature = "serde")]
mod readable;
mod slice;
#[cfg(feature = "std")]
mod stream;
mod text;
pub mod time;
mod timed;
mod view;

#[cfg(feature = "devices")]
pub mod devices;
#[cfg(feature = "dynamic")]
#[allow(dead_code, unused_imports)] // few sets use all of it
pub mod dynamic;
pub mod protocol;
#[cfg(feature = "registry")]
pub mod registry;
mod sets;
pub mod types;

#[allow(unused_imports)] // if no set is enabled
pub use sets::*;

pub use bits::Bits;
pub use client::{Client, CommandError, Event, Reason, RequestError, Ticket};
pub use codec::{Bool, Reader, Union, Wire, Writer};
pub use error::{
    DecodeError, DecodeErrorKind, EncodeError, EncodeErrorKind, RangeError, ReadError,
};
pub use field::{
    Call, Command, Field, OneSet, RawField, Response, ResponseCheck, ResponseOf, Role, Takes,
};
pub use list::{CapacityError, List};
#[cfg(feature = "alloc")]
pub use owned::PacketBuf;
pub use packet::{checksum, FieldLengthError, FromPacket, Packet, PacketBuilder, PacketError};
pub use parser::{Feed, Parser};
pub use protocol::DescriptorSet;
#[cfg(feature = "registry")]
pub use registry::{AnyField, Decoded};
pub use slice::{packets, Packets};
#[cfg(feature = "std")]
pub use stream::PacketReader;
pub use text::{Text, VarText};
pub use time::{Clock, Time, Utc};
pub use timed::Timed;
pub use view::{View, Viewed};

//! The macros used by the generated types. Hidden implementations are of traits that only the crate
//! uses: they would be a third of each page of the documentation.

#![allow(unused_macros)] // few sets use all of them

/// The name in the specification.
macro_rules! spec_name {
    ($name:ident) => {
        stringify!($name)
    };
    ($name:ident $text:literal) => {
        $text
    };
}

/// Implements `Error`, if `std` or `core` has it.
macro_rules! error {
    ($($name:ident)+) => {$(
        #[cfg(any(feature = "core-error", feature = "std"))]
        impl $crate::error::Error for $name {}
    )+};
}

#[macro_use]
mod bitfield;
#[macro_use]
mod codec;
#[macro_use]
mod field;
#[macro_use]
mod numbers;
#[macro_use]
mod record;
#[macro_use]
mod registry;
#[cfg(feature = "dynamic")]
#[macro_use]
mod tree;

//! The macros that the generated types are written with.

/// The name in the specification.
macro_rules! spec_name {
    ($name:ident) => {
        stringify!($name)
    };
    ($name:ident $text:literal) => {
        $text
    };
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

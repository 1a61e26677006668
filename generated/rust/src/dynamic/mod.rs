//! Fields as trees of named values, for tools that know no field by heart.
//!
//! [`AnyField::decode`](crate::AnyField::decode) finds the type of a field,
//! [`AnyField::to_value`](crate::AnyField::to_value) makes a tree of it with the names of the
//! specification, and [`AnyField::from_value`](crate::AnyField::from_value) goes the other way.

mod aiding;
mod base;
mod filter;
mod filter_data;
mod gnss;
mod gnss_1;
mod macros;
mod mip_3dm;
mod protocol;
mod rtk;
mod sensor;
mod shared;
mod system;
mod system_data;
mod types;
mod value;

pub use value::{FromValue, Record, ToValue, Value, ValueError};

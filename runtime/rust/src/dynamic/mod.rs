//! Fields as trees of named values, for generic tools.
//!
//! [`AnyField::decode`](crate::AnyField::decode) finds the type of a field,
//! [`AnyField::to_value`](crate::AnyField::to_value) converts it to a tree with the names of the
//! specification, and [`AnyField::from_value`](crate::AnyField::from_value) converts it back.

mod value;

pub(crate) use value::Alternative;
pub use value::{FromValue, Record, ToValue, Value, ValueError};

//! Fields as trees of named values, for tools that know no field by heart.
//!
//! [`AnyField::decode`](crate::AnyField::decode) finds the type of a field,
//! [`AnyField::to_value`](crate::AnyField::to_value) makes a tree of it with the names of the
//! specification, and [`AnyField::from_value`](crate::AnyField::from_value) goes the other way.

mod value;

pub(crate) use value::Alternative;
pub use value::{FromValue, Record, ToValue, Value, ValueError};

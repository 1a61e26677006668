//! All fields, for tools that must handle any of them.
//!
//! A program that does not use this module does not pay for it.

use crate::client::{Request, RequestError, Ticket};
use crate::codec::{DecodeError, EncodeError};
use crate::field::{Field, RawField, Role};

mod fields;

use fields::index;
pub use fields::{AnyField, FIELDS};

/// The description of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FieldInfo {
    /// The descriptor set that defines it.
    pub set: u8,
    /// The field descriptor.
    pub descriptor: u8,
    /// Its role.
    pub role: Role,
    /// The name in the specification, `set.field`.
    pub name: &'static str,
    /// Its title.
    pub title: &'static str,
    /// Names of the responses of a command, or of the commands that a response answers.
    pub linked: &'static [&'static str],
    sets: (u8, u8),
}

impl FieldInfo {
    /// The field of this name, `set.field`.
    #[must_use]
    pub fn by_name(name: &str) -> Option<&'static Self> {
        FIELDS.iter().find(|info| info.name == name)
    }

    /// The field that has these bytes; of several layouts the one that the data have.
    #[must_use]
    pub fn of(field: &RawField<'_>) -> Option<&'static Self> {
        FIELDS.get(index(field)? as usize)
    }

    /// May packets of this set hold the field?
    #[must_use]
    pub const fn in_set(&self, set: u8) -> bool {
        self.sets.0 <= set && set <= self.sets.1
    }
}

#[inline(never)]
fn decode<T: Field>(
    field: &RawField<'_>,
    wrap: fn(T) -> AnyField,
) -> Result<(AnyField, usize), DecodeError> {
    T::decode_with_trailing(field.data).map(|(value, trailing)| (wrap(value), trailing))
}

#[cfg(feature = "dynamic")]
#[inline(never)]
fn from_value<T: crate::dynamic::FromValue>(
    value: &crate::dynamic::Value,
    wrap: fn(T) -> AnyField,
) -> Result<AnyField, crate::dynamic::ValueError> {
    T::from_value(value).map(wrap)
}

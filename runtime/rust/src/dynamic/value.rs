//! The tree of values, and conversions of types to it and back.

use alloc::borrow::Cow;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use crate::codec::{Bool, Union};
use crate::error::{EncodeError, EncodeErrorKind};
use crate::list::Item;
use crate::{List, Text, VarText};

/// A value of any kind.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// An integer, an enumeration, a bitfield or a Boolean.
    Integer(i128),
    /// A float.
    Float(f32),
    /// A double.
    Double(f64),
    /// Text: one character for each byte (Latin-1).
    Text(String),
    /// An array.
    List(Vec<Value>),
    /// A field, a structure, or a union with its active member.
    Record(Record),
}

/// Named values, in wire order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    values: Vec<(Cow<'static, str>, Value)>,
}

/// Why values cannot be converted to a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ValueError {
    /// There is no field, or no value of the field, with this name.
    Unknown,
    /// A value is missing.
    Missing,
    /// A number does not fit or has the wrong type.
    Range,
    /// The number of elements is wrong: it differs from the counter, or is too high or too low.
    Count,
    /// A union does not contain the member that its tag selects.
    Tag,
    /// A value is not of the required kind: text, list or record.
    Kind,
}

impl fmt::Display for ValueError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Unknown => "there is no such field or value",
            Self::Missing => "a value is missing",
            Self::Range => "a number does not fit",
            Self::Count => "the number of elements is wrong",
            Self::Tag => "a union does not contain the member that its tag selects",
            Self::Kind => "a value is of the wrong kind",
        })
    }
}

error!(ValueError);

/// Conversion to a [`Value`].
pub trait ToValue {
    /// Converts the value to a tree.
    fn to_value(&self) -> Value;
}

/// Conversion from a [`Value`].
///
/// A float may also be text with its bits: `"0x3e7a63a0"`.
pub trait FromValue: Sized {
    /// Converts a tree to a value.
    ///
    /// # Errors
    ///
    /// The value is of the wrong kind, or a member is missing or unknown.
    fn from_value(value: &Value) -> Result<Self, ValueError>;
}

/// Conversion of a union from a [`Value`] and its tag.
pub(crate) trait Alternative: Union {
    /// Converts a tree to the alternative that the tag selects.
    fn of_value(tag: Self::Tag, value: &Value) -> Result<Self, ValueError>;
}

impl Value {
    /// Returns the items of an array.
    #[must_use]
    pub fn as_list(&self) -> Option<&[Value]> {
        match self {
            Self::List(items) => Some(items),
            _ => None,
        }
    }

    /// Returns the text, if it is one.
    #[must_use]
    pub fn as_text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            _ => None,
        }
    }

    /// Returns the named values of a record.
    #[must_use]
    pub fn as_record(&self) -> Option<&Record> {
        match self {
            Self::Record(record) => Some(record),
            _ => None,
        }
    }

    /// Returns the record; an error if it has a value that these steps do not name.
    pub(crate) fn record(&self, steps: &[&[&str]]) -> Result<&Record, ValueError> {
        let record = self.as_record().ok_or(ValueError::Kind)?;
        if record.names().all(|name| steps.iter().any(|step| step.contains(&name))) {
            Ok(record)
        } else {
            Err(ValueError::Unknown)
        }
    }

    /// Converts the only member of a union.
    pub(crate) fn member<T: FromValue>(&self, name: &str) -> Result<T, ValueError> {
        let record = self.as_record().ok_or(ValueError::Kind)?;
        match record.values.as_slice() {
            [(found, value)] if found == name => T::from_value(value),
            _ => Err(ValueError::Tag),
        }
    }

    /// Checks that a union has no member.
    pub(crate) fn no_member(&self) -> Result<(), ValueError> {
        let record = self.as_record().ok_or(ValueError::Kind)?;
        if record.values.is_empty() {
            Ok(())
        } else {
            Err(ValueError::Tag)
        }
    }

    /// Counts the items or characters.
    fn count(&self) -> Option<usize> {
        match self {
            Self::List(items) => Some(items.len()),
            Self::Text(text) => Some(text.chars().count()),
            _ => None,
        }
    }
}

impl Record {
    /// Creates a record without values.
    #[must_use]
    pub const fn new() -> Self {
        Self { values: Vec::new() }
    }

    /// Appends a value.
    pub fn push(&mut self, name: impl Into<Cow<'static, str>>, value: Value) {
        self.values.push((name.into(), value));
    }

    /// Returns the value with this name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Value> {
        self.iter().find(|(found, _)| *found == name).map(|(_, value)| value)
    }

    /// Iterates over the names, in order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.iter().map(|(name, _)| name)
    }

    /// Iterates over names and values, in order.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Value)> {
        self.values.iter().map(|(name, value)| (name.as_ref(), value))
    }

    /// Appends a value of a type.
    pub(crate) fn put(&mut self, name: &'static str, value: &impl ToValue) {
        self.push(name, value.to_value());
    }

    /// Appends a value if it is present.
    pub(crate) fn put_some(&mut self, name: &'static str, value: &Option<impl ToValue>) {
        if let Some(value) = value {
            self.put(name, value);
        }
    }

    /// Appends a counter.
    pub(crate) fn put_count(&mut self, name: &'static str, count: Option<usize>) {
        if let Some(count) = count {
            self.push(name, Value::Integer(i128::try_from(count).unwrap_or(i128::MAX)));
        }
    }

    /// Converts a required value.
    pub(crate) fn take<T: FromValue>(&self, name: &str) -> Result<T, ValueError> {
        T::from_value(self.need(name)?)
    }

    /// Returns the tree of a required value.
    pub(crate) fn need(&self, name: &str) -> Result<&Value, ValueError> {
        self.get(name).ok_or(ValueError::Missing)
    }

    /// Converts a value that may be absent.
    pub(crate) fn take_some<T: FromValue>(&self, name: &str) -> Result<Option<T>, ValueError> {
        self.get(name).map(T::from_value).transpose()
    }

    /// Converts the alternative that a tag selects.
    pub(crate) fn take_union<U: Alternative>(
        &self,
        name: &str,
        tag: U::Tag,
    ) -> Result<U, ValueError> {
        U::of_value(tag, self.need(name)?)
    }

    /// Converts the alternative that a tag selects, if both may be absent.
    pub(crate) fn take_some_union<U: Alternative>(
        &self,
        name: &str,
        tag: impl Into<Option<U::Tag>>,
    ) -> Result<Option<U>, ValueError> {
        match (self.get(name), tag.into()) {
            (Some(value), Some(tag)) => U::of_value(tag, value).map(Some),
            (Some(_), None) => Err(ValueError::Missing),
            (None, _) => Ok(None),
        }
    }

    /// Checks that a counter equals the number of elements of an array.
    pub(crate) fn check_count(&self, counter: &str, array: &str) -> Result<(), ValueError> {
        let count = self.need(counter)?;
        let elements = self.get(array).and_then(Value::count).ok_or(ValueError::Count)?;
        match count {
            Value::Integer(number) if usize::try_from(*number) == Ok(elements) => Ok(()),
            _ => Err(ValueError::Count),
        }
    }

    /// Like `check_count`, if both may be absent, but only together.
    pub(crate) fn check_some_count(&self, counter: &str, array: &str) -> Result<(), ValueError> {
        match (self.get(counter), self.get(array)) {
            (None, None) => Ok(()),
            (Some(_), Some(_)) => self.check_count(counter, array),
            _ => Err(ValueError::Missing),
        }
    }
}

impl FromIterator<(String, Value)> for Record {
    fn from_iter<I: IntoIterator<Item = (String, Value)>>(values: I) -> Self {
        Self { values: values.into_iter().map(|(name, value)| (name.into(), value)).collect() }
    }
}

impl From<EncodeError> for ValueError {
    fn from(error: EncodeError) -> Self {
        match error.kind {
            EncodeErrorKind::Missing => Self::Missing,
            EncodeErrorKind::Count | EncodeErrorKind::Length => Self::Count,
            EncodeErrorKind::Tag => Self::Tag,
            EncodeErrorKind::Set => Self::Unknown,
        }
    }
}

macro_rules! integers {
    ($($number:ty)*) => {$(
        impl ToValue for $number {
            fn to_value(&self) -> Value {
                Value::Integer((*self).into())
            }
        }

        impl FromValue for $number {
            fn from_value(value: &Value) -> Result<Self, ValueError> {
                match value {
                    Value::Integer(number) => {
                        Self::try_from(*number).map_err(|_| ValueError::Range)
                    }
                    _ => Err(ValueError::Range),
                }
            }
        }
    )*};
}

integers!(u8 u16 u32 u64 i8 i16 i32 i64);

macro_rules! floats {
    ($($number:ident($bits:ty) as $variant:ident;)*) => {$(
        impl ToValue for $number {
            fn to_value(&self) -> Value {
                Value::$variant(*self)
            }
        }

        impl FromValue for $number {
            fn from_value(value: &Value) -> Result<Self, ValueError> {
                match value {
                    Value::$variant(number) => Ok(*number),
                    Value::Text(text) => {
                        let digits = text.strip_prefix("0x").unwrap_or_default();
                        let whole = digits.len() == core::mem::size_of::<Self>().saturating_mul(2)
                            && digits.bytes().all(|b| b.is_ascii_hexdigit());
                        let bits = <$bits>::from_str_radix(digits, 16);
                        bits.ok().filter(|_| whole).map(Self::from_bits).ok_or(ValueError::Range)
                    }
                    _ => Err(ValueError::Range),
                }
            }
        }
    )*};
}

floats! {
    f32(u32) as Float;
    f64(u64) as Double;
}

impl ToValue for Bool {
    fn to_value(&self) -> Value {
        self.0.to_value()
    }
}

impl FromValue for Bool {
    fn from_value(value: &Value) -> Result<Self, ValueError> {
        u8::from_value(value).map(Self)
    }
}

impl<T: ToValue, const N: usize> ToValue for [T; N] {
    fn to_value(&self) -> Value {
        Value::List(self.iter().map(T::to_value).collect())
    }
}

impl<T: FromValue + Item, const N: usize> FromValue for [T; N] {
    fn from_value(value: &Value) -> Result<Self, ValueError> {
        let values = value.as_list().ok_or(ValueError::Kind)?;
        if values.len() != N {
            return Err(ValueError::Count);
        }
        let mut items = Self::BLANK;
        for (item, value) in items.iter_mut().zip(values) {
            *item = T::from_value(value)?;
        }
        Ok(items)
    }
}

impl<T: ToValue, const N: usize> ToValue for List<T, N> {
    fn to_value(&self) -> Value {
        Value::List(self.iter().map(T::to_value).collect())
    }
}

impl<T: FromValue + Item, const N: usize> FromValue for List<T, N> {
    fn from_value(value: &Value) -> Result<Self, ValueError> {
        let mut list = Self::new();
        for value in value.as_list().ok_or(ValueError::Kind)? {
            list.push(T::from_value(value)?).map_err(|_| ValueError::Count)?;
        }
        Ok(list)
    }
}

impl<const N: usize> ToValue for Text<N> {
    fn to_value(&self) -> Value {
        Value::Text(self.chars().collect())
    }
}

impl<const N: usize> FromValue for Text<N> {
    fn from_value(value: &Value) -> Result<Self, ValueError> {
        Ok(VarText::<N>::from_value(value)?.into())
    }
}

impl<const N: usize> ToValue for VarText<N> {
    fn to_value(&self) -> Value {
        Value::Text(self.chars().collect())
    }
}

impl<const N: usize> FromValue for VarText<N> {
    fn from_value(value: &Value) -> Result<Self, ValueError> {
        let text = value.as_text().ok_or(ValueError::Kind)?;
        if text.chars().count() > N {
            return Err(ValueError::Count);
        }
        Self::new(text).ok_or(ValueError::Range)
    }
}

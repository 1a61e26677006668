//! All fields, for tools that must handle any of them.
//!
//! [`AnyField::decode`] finds the type of a field and decodes it. A [`Visitor`] processes each type
//! without a value as large as the largest field.
//!
//! The registry lists the fields of the descriptor sets whose cargo features are enabled. It adds
//! nothing to a program that does not use it.

use core::fmt;

use crate::client::{Request, RequestError, Ticket};
use crate::codec::{Reader, Wire as _, Writer};
use crate::error::{DecodeError, EncodeError};
use crate::field::{Call, Field, RawField, Role};
use crate::protocol::DescriptorSet;

mod fields;

pub use fields::{visit, AnyField, FIELDS};

/// The description of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct FieldInfo {
    /// The descriptor sets in which it occurs, in ascending order.
    pub sets: &'static [DescriptorSet],
    /// The field descriptor.
    pub descriptor: u8,
    /// Its role.
    pub role: Role,
    /// The name in the specification, `family.field`; see [`FieldInfo::name_in`].
    pub name: &'static str,
    /// Its title; see [`FieldInfo::title_in`].
    pub title: &'static str,
    /// Names of the responses of a command, or of the commands that a response answers.
    pub linked: &'static [&'static str],
    /// Its name in a family of several sets.
    occurrences: &'static [Occurrence],
}

/// A field in one of the descriptor sets of its family.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Occurrence {
    set: DescriptorSet,
    name: &'static str,
    title: &'static str,
}

impl FieldInfo {
    /// Finds the field with this name, which may be its name in one of its sets: `set.field`.
    ///
    /// ```
    /// # #[cfg(feature = "sensor")] {
    /// use mip_protocol::registry::FieldInfo;
    ///
    /// let info = FieldInfo::by_name("sensor.scaled_accel").unwrap();
    /// assert_eq!((info.sets[0].0, info.descriptor), (0x80, 0x04));
    /// assert_eq!(info.parameters()[0].units, ["g"]);
    /// # }
    /// ```
    #[must_use]
    pub fn by_name(name: &str) -> Option<&'static Self> {
        let called = |info: &&Self| {
            info.name == name || info.occurrences.iter().any(|found| found.name == name)
        };
        FIELDS.iter().find(called)
    }

    /// Returns its descriptor set, if it occurs in only one.
    #[must_use]
    pub const fn set(&self) -> Option<DescriptorSet> {
        match *self.sets {
            [set] => Some(set),
            _ => None,
        }
    }

    /// Does it occur in this descriptor set?
    #[must_use]
    pub fn occurs_in(&self, set: DescriptorSet) -> bool {
        self.sets.contains(&set)
    }

    /// Returns its name in a set, `set.field`, if it occurs there. A field of all data sets, or of
    /// all command sets, has the same name everywhere.
    #[must_use]
    pub fn name_in(&self, set: DescriptorSet) -> Option<&'static str> {
        self.occurs_in(set).then(|| self.occurrence(set).map_or(self.name, |found| found.name))
    }

    /// Returns its title in a set, if it occurs there.
    #[must_use]
    pub fn title_in(&self, set: DescriptorSet) -> Option<&'static str> {
        self.occurs_in(set).then(|| self.occurrence(set).map_or(self.title, |found| found.title))
    }

    fn occurrence(&self, set: DescriptorSet) -> Option<&'static Occurrence> {
        self.occurrences.iter().find(|found| found.set == set)
    }

    /// Returns the description of this field; if its descriptor has several layouts, of the one
    /// that fits the data.
    #[inline]
    #[must_use]
    pub fn of(field: &RawField<'_>) -> Option<&'static Self> {
        visit(field, Describe)
    }

    /// Returns the descriptions of its values, in wire order, without constants and counters.
    ///
    /// This searches for the field. If you know its type, use [`Listed::PARAMETERS`].
    #[must_use]
    pub fn parameters(&self) -> &'static [ParameterInfo] {
        let mut all = FIELDS.iter().zip(fields::PARAMETERS);
        all.find(|(info, _)| info.name == self.name).map_or(&[], |(_, found)| *found)
    }
}

/// The description of a value of a field or of a structure.
///
/// A program contains the descriptions only if it uses [`FieldInfo::parameters`] or
/// [`Listed::PARAMETERS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct ParameterInfo {
    /// The name in the specification.
    pub name: &'static str,
    /// The names of the elements of a vector; otherwise empty.
    pub elements: &'static [&'static str],
    /// The unit of all elements, or of each: `["m/s"]`, `["deg", "deg", "m"]`; `["1"]` for a plain
    /// number; empty if there is none or another value determines it.
    pub units: &'static [&'static str],
    /// The frame of reference, if there is one and no other value determines it.
    pub frame: Option<&'static str>,
    /// The values of a structure, or of each structure in an array; the alternatives of a union.
    pub members: &'static [ParameterInfo],
}

/// The methods of every field type in the registry. Only the types of this crate implement it.
pub trait Listed:
    Field
    + bounds::Sealed
    + Clone
    + fmt::Debug
    + PartialEq
    + Into<AnyField>
    + bounds::Serde
    + bounds::Defmt
    + bounds::Tree
{
    /// The description of the field.
    const INFO: FieldInfo;

    /// The descriptions of its values, in wire order.
    const PARAMETERS: &'static [ParameterInfo];

    /// Converts the field to an [`AnyField`].
    #[must_use]
    fn into_any(self) -> AnyField;
}

/// Processes a field of any type: see [`visit`].
///
/// Methods that are added later will have a default.
///
/// ```
/// use mip_protocol::registry::{visit, Listed, Visitor};
/// use mip_protocol::{packet::Packet, RawField};
///
/// /// Prints fields as they arrive.
/// struct Print;
///
/// impl Visitor for Print {
///     type Output = ();
///
///     fn visit<T: Listed>(self, field: &RawField<'_>) {
///         match T::decode(field.data) {
///             Ok(value) => println!("{:?}: {value:?}", T::INFO.title_in(field.set)),
///             Err(error) => println!("{error}"),
///         }
///     }
///
///     fn unknown(self, field: &RawField<'_>) {
///         println!("{field:?}");
///     }
/// }
///
/// # let bytes = [0x75, 0x65, 0x01, 0x04, 0x04, 0xF1, 0x01, 0x00, 0xD5, 0x6A];
/// for field in Packet::new(&bytes).unwrap().fields() {
///     visit(&field.unwrap(), Print); // the command is acknowledged
/// }
/// ```
pub trait Visitor {
    /// The result.
    type Output;

    /// Processes a field of type `T`, not yet decoded; `field.set` is the descriptor set of its
    /// packet.
    fn visit<T: Listed>(self, field: &RawField<'_>) -> Self::Output;

    /// Processes a field that the registry does not list.
    fn unknown(self, field: &RawField<'_>) -> Self::Output;
}

/// A decoded field of any type, and its packet's descriptor set. One type may occur in several
/// sets, each for another sensor or receiver.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Decoded {
    /// The descriptor set of the packet.
    pub set: DescriptorSet,
    /// The field.
    pub field: AnyField,
    /// The number of bytes left over, because newer firmware may append some.
    pub left_over: usize,
}

impl Decoded {
    /// Returns the field's name in its set, `set.field`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        let info = self.field.info();
        info.name_in(self.set).unwrap_or(info.name)
    }

    /// Returns the field's title in its set.
    #[must_use]
    pub fn title(&self) -> &'static str {
        let info = self.field.info();
        info.title_in(self.set).unwrap_or(info.title)
    }
}

impl<C: Listed, const FUNCTION: u8> From<Call<C, FUNCTION>> for AnyField {
    fn from(call: Call<C, FUNCTION>) -> Self {
        call.into_command().into_any()
    }
}

impl AnyField {
    /// Decodes a field; returns `None` if it is unknown.
    ///
    /// [`AnyField::decode_with_trailing`] also returns the descriptor set, and how many bytes are
    /// left over.
    ///
    /// ```
    /// use mip_protocol::{AnyField, Packet};
    ///
    /// let packet = Packet::new(b"\x75\x65\x01\x04\x04\xF1\x01\x00\xD5\x6A")?;
    /// for field in &packet {
    ///     if let Some(value) = &AnyField::decode(&field?)? {
    ///         println!("{}: {value:?}", value.info().name);
    ///     }
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The data is invalid.
    #[inline]
    pub fn decode(field: &RawField<'_>) -> Result<Option<Self>, DecodeError> {
        visit(field, Decode)
    }

    /// Decodes a field, and counts the bytes left over, because newer firmware may append some;
    /// returns `None` if the field is unknown.
    ///
    /// ```
    /// use mip_protocol::{AnyField, Packet};
    ///
    /// for field in &Packet::new(b"\x75\x65\x01\x04\x04\xF1\x01\x00\xD5\x6A")? {
    ///     if let Some(found) = &AnyField::decode_with_trailing(&field?)? {
    ///         assert_eq!((found.set.0, found.left_over), (1, 0));
    ///     }
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The data is invalid.
    #[inline]
    pub fn decode_with_trailing(field: &RawField<'_>) -> Result<Option<Decoded>, DecodeError> {
        visit(field, DecodeWithTrailing)
    }
}

struct Decode;

impl Visitor for Decode {
    // The caller's whole result, so that each type writes its value directly to its destination.
    type Output = Result<Option<AnyField>, DecodeError>;

    #[inline]
    fn visit<T: Listed>(self, field: &RawField<'_>) -> Self::Output {
        let mut reader = Reader::new(field.data);
        match T::decode_from(&mut reader) {
            Ok(value) => Ok(Some(value.into_any())),
            Err(_) => wrong(reader, T::NAME),
        }
    }

    fn unknown(self, _: &RawField<'_>) -> Self::Output {
        Ok(None)
    }
}

struct DecodeWithTrailing;

impl Visitor for DecodeWithTrailing {
    type Output = Result<Option<Decoded>, DecodeError>;

    #[inline]
    fn visit<T: Listed>(self, field: &RawField<'_>) -> Self::Output {
        let mut reader = Reader::new(field.data);
        match T::decode_from(&mut reader) {
            Ok(value) => Ok(Some(Decoded {
                set: field.set,
                field: value.into_any(),
                left_over: reader.remaining(),
            })),
            Err(_) => wrong(reader, T::NAME),
        }
    }

    fn unknown(self, _: &RawField<'_>) -> Self::Output {
        Ok(None)
    }
}

/// Creates the result of both visitors after an error, compiled once for all types.
#[cold]
#[inline(never)]
fn wrong<T>(reader: Reader<'_>, field: &'static str) -> Result<Option<T>, DecodeError> {
    Err(reader.error(field))
}

struct Describe;

impl Visitor for Describe {
    type Output = Option<&'static FieldInfo>;

    fn visit<T: Listed>(self, _: &RawField<'_>) -> Self::Output {
        Some(&T::INFO)
    }

    fn unknown(self, _: &RawField<'_>) -> Self::Output {
        None
    }
}

#[cfg(feature = "dynamic")]
#[inline(never)]
fn from_value<T: Listed>(
    value: &crate::dynamic::Value,
) -> Result<AnyField, crate::dynamic::ValueError> {
    T::from_value(value).map(T::into_any)
}

/// Returns the row of each set in a table, counted from 1: the first range that contains the set.
#[allow(clippy::indexing_slicing, clippy::arithmetic_side_effects)] // evaluated at compile time
const fn rows(ranges: &[&[(u8, u8)]]) -> [u8; 256] {
    let (mut rows, mut row, mut family) = ([0; 256], 0, 0);
    while family < ranges.len() {
        let mut at = 0;
        while at < ranges[family].len() {
            let (first, last) = ranges[family][at];
            let mut set = first as usize;
            row += 1;
            while set <= last as usize {
                if rows[set] == 0 {
                    rows[set] = row;
                }
                set += 1;
            }
            at += 1;
        }
        family += 1;
    }
    rows
}

/// Returns the number of rows.
#[allow(clippy::indexing_slicing, clippy::arithmetic_side_effects)] // evaluated at compile time
const fn count(ranges: &[&[(u8, u8)]]) -> usize {
    let (mut count, mut family) = (0, 0);
    while family < ranges.len() {
        count += ranges[family].len();
        family += 1;
    }
    count
}

/// Further traits of the types, depending on the crate's features.
mod bounds {
    /// Prevents other crates from implementing [`Listed`](super::Listed), to which methods may be
    /// added.
    pub trait Sealed {}

    macro_rules! bound {
        ($name:ident: $feature:literal, $($bound:tt)+) => {
            #[cfg(feature = $feature)]
            pub trait $name: $($bound)+ {}
            #[cfg(feature = $feature)]
            impl<T: $($bound)+> $name for T {}
            #[cfg(not(feature = $feature))]
            pub trait $name {}
            #[cfg(not(feature = $feature))]
            impl<T> $name for T {}
        };
    }

    bound!(Serde: "serde", serde::Serialize + serde::de::DeserializeOwned);
    bound!(Defmt: "defmt", defmt::Format);
    bound!(Tree: "dynamic", crate::dynamic::ToValue + crate::dynamic::FromValue);
}

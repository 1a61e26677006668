//! Values in human-readable formats such as JSON: enumerations and flags by name, and a NaN with its
//! bit pattern. Other formats contain the numbers.

#![allow(dead_code)] // few parts of the specification use all of it

use core::fmt;
use core::marker::PhantomData;

use serde::de::{Error, SeqAccess, Unexpected, Visitor};
use serde::ser::SerializeTuple;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::bits::{Bits, Hexadecimal, Storage};
use crate::list::{Item, List};

/// A value with its own form in human-readable formats.
pub(crate) trait Readable: Sized {
    fn write<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error>;
    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error>;
}

/// Serializes a value, for `serde(with = …)`.
pub(crate) fn serialize<T: Readable, S: Serializer>(
    value: &T,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    value.write(serializer)
}

/// Deserializes a value, for `serde(with = …)`.
pub(crate) fn deserialize<'de, T: Readable, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<T, D::Error> {
    T::read(deserializer)
}

/// Wraps a part of a value, to implement `serde`'s traits through `Readable`.
struct Part<T>(T);

impl<T: Item> Item for Part<T> {
    const BLANK: Self = Self(T::BLANK);
}

impl<T: Readable> Serialize for Part<&T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.write(serializer)
    }
}

impl<'de, T: Readable> Deserialize<'de> for Part<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        T::read(deserializer).map(Self)
    }
}

impl<T: Readable> Readable for Option<T> {
    fn write<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.as_ref().map(Part).serialize(serializer)
    }

    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = Option::<Part<T>>::deserialize(deserializer)?;
        Ok(value.map(|part| part.0))
    }
}

// --------------------------------------------------------------------------- sequences

/// Supports arrays of any length; `serde` itself supports at most 32 items.
impl<T: Readable + Item, const N: usize> Readable for [T; N] {
    fn write<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tuple = serializer.serialize_tuple(N)?;
        self.iter().try_for_each(|item| tuple.serialize_element(&Part(item)))?;
        tuple.end()
    }

    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let items = deserializer.deserialize_tuple(N, Items::<Part<T>, N>(PhantomData))?;
        let (mut array, count) = ([T::BLANK; N], items.len());
        if count < N {
            return Err(D::Error::invalid_length(count, &Items::<Part<T>, N>(PhantomData)));
        }
        array.iter_mut().zip(items).for_each(|(place, item)| *place = item.0);
        Ok(array)
    }
}

impl<T: Readable + Item, const N: usize> Readable for List<T, N> {
    fn write<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.whole()?;
        serializer.collect_seq(self.iter().map(Part))
    }

    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        List::<Part<T>, N>::deserialize(deserializer)
            .map(|items| items.into_iter().map(|part| part.0).collect())
    }
}

/// Reads at most `N` items.
pub(crate) struct Items<T, const N: usize>(pub PhantomData<T>);

impl<'de, T: Deserialize<'de> + Item, const N: usize> Visitor<'de> for Items<T, N> {
    type Value = List<T, N>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "at most {N} items")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Self::Value, A::Error> {
        let mut list = List::new();
        while let Some(item) = items.next_element()? {
            list.push(item).map_err(A::Error::custom)?;
        }
        Ok(list)
    }
}

// --------------------------------------------------------------------------- floats

struct Float<F>(PhantomData<F>);

macro_rules! floats {
    ($($float:ident $bits:ident $visit:ident $write:ident $digits:literal;)*) => {$(
        impl Readable for $float {
            fn write<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                if self.is_finite() || !serializer.is_human_readable() {
                    return serializer.$write(*self);
                }
                if !self.is_nan() || self.to_bits() == $float::NAN.to_bits() {
                    return serializer.collect_str(self); // NaN, inf, -inf
                }
                serializer.collect_str(&format_args!(concat!("NaN(0x{:0", $digits, "x})"), self.to_bits()))
            }

            fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                if !deserializer.is_human_readable() {
                    return $float::deserialize(deserializer);
                }
                deserializer.deserialize_any(Float::<$float>(PhantomData))
            }
        }

        impl Visitor<'_> for Float<$float> {
            type Value = $float;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(concat!("a number, inf, -inf, NaN or NaN(0x…) with ", $digits, " digits"))
            }

            fn visit_f32<E: Error>(self, value: f32) -> Result<$float, E> {
                Ok(value.into())
            }

            fn visit_f64<E: Error>(self, value: f64) -> Result<$float, E> {
                Ok(value as $float)
            }

            fn visit_u64<E: Error>(self, value: u64) -> Result<$float, E> {
                Ok(value as $float)
            }

            fn visit_i64<E: Error>(self, value: i64) -> Result<$float, E> {
                Ok(value as $float)
            }

            fn visit_str<E: Error>(self, text: &str) -> Result<$float, E> {
                let bits = text.strip_prefix("NaN(0x").and_then(|text| text.strip_suffix(')'));
                let value = match bits {
                    Some(bits) => $bits::from_str_radix(bits, 16).ok().map($float::from_bits),
                    None => text.parse().ok(),
                };
                value.ok_or_else(|| E::invalid_value(Unexpected::Str(text), &self))
            }
        }
    )*};
}

floats! {
    f32 u32 visit_f32 serialize_f32 "8";
    f64 u64 visit_f64 serialize_f64 "16";
}

// --------------------------------------------------------------------------- names

/// An enumeration: a name, or a number.
pub(crate) trait Named: Copy {
    type Number: Serialize + for<'de> Deserialize<'de> + TryFrom<u64> + TryFrom<i64>;

    fn text(self) -> Option<&'static str>;
    fn number(self) -> Self::Number;
    fn of_text(text: &str) -> Option<Self>;
    fn of_number(number: Self::Number) -> Self;
}

pub(crate) fn write_name<T: Named, S: Serializer>(
    value: T,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    match value.text() {
        Some(name) if serializer.is_human_readable() => serializer.serialize_str(name),
        _ => value.number().serialize(serializer),
    }
}

pub(crate) fn read_name<'de, T: Named, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<T, D::Error> {
    if deserializer.is_human_readable() {
        return deserializer.deserialize_any(Name(PhantomData));
    }
    T::Number::deserialize(deserializer).map(T::of_number)
}

struct Name<T>(PhantomData<T>);

impl<T: Named> Visitor<'_> for Name<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a value, or its number")
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<T, E> {
        let known = T::Number::try_from(number).map(T::of_number);
        known.map_err(|_| E::invalid_value(Unexpected::Unsigned(number), &self))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<T, E> {
        let known = T::Number::try_from(number).map(T::of_number);
        known.map_err(|_| E::invalid_value(Unexpected::Signed(number), &self))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
        T::of_text(text).ok_or_else(|| E::invalid_value(Unexpected::Str(text), &self))
    }
}

// --------------------------------------------------------------------------- bits

/// A bitfield: the text that [`crate::bits::text`] writes, or its number.
pub(crate) trait Flags: Copy {
    type Storage: Storage + Hexadecimal + Serialize + for<'de> Deserialize<'de>;

    const NAMES: &'static [Bits];
    /// No bit is set.
    const NONE: Self;

    fn storage(self) -> Self::Storage;
    fn of_storage(storage: Self::Storage) -> Self;
}

pub(crate) fn write_flags<T: Flags, S: Serializer>(
    value: T,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    struct Text<T>(T);

    impl<T: Flags> fmt::Display for Text<T> {
        fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            crate::bits::text(self.0.storage(), T::NAMES, f)
        }
    }

    if serializer.is_human_readable() {
        return serializer.collect_str(&Text(value));
    }
    value.storage().serialize(serializer)
}

pub(crate) fn read_flags<'de, T: Flags, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<T, D::Error> {
    if deserializer.is_human_readable() {
        return deserializer.deserialize_any(Bitfield(PhantomData));
    }
    T::Storage::deserialize(deserializer).map(T::of_storage)
}

struct Bitfield<T>(PhantomData<T>);

impl<T: Flags> Bitfield<T> {
    /// Adds bits; `None` if they do not fit.
    fn add(storage: &mut T::Storage, first: u16, last: u16, number: u64) -> Option<()> {
        let bits = u16::try_from(core::mem::size_of::<T::Storage>()).ok()?.checked_mul(8)?;
        let before = if last < bits { storage.get(first, last) } else { return None };
        storage.set(first, last, before | number);
        (storage.get(first, last) & number == number).then_some(())
    }

    /// Adds the bits of a word such as `ready`, `level=3` or `0x40`.
    fn add_word(storage: &mut T::Storage, word: &str) -> Option<()> {
        if let Some(digits) = word.strip_prefix("0x") {
            return digits.bytes().rev().zip((0_u16..).step_by(4)).try_for_each(
                |(digit, first)| {
                    let number = char::from(digit).to_digit(16)?;
                    Self::add(storage, first, first.checked_add(3)?, number.into())
                },
            );
        }
        let (name, number) = word.split_once('=').unwrap_or((word, "1"));
        let bits = T::NAMES.iter().find(|bits| bits.name == name)?;
        Self::add(storage, bits.first, bits.last, number.parse().ok()?)
    }
}

impl<T: Flags> Visitor<'_> for Bitfield<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the names of bits, as in \"one | two | 0x40\", or their number")
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<T, E> {
        let mut storage = T::NONE.storage();
        (0..64_u16)
            .filter(|bit| number >> bit & 1 == 1)
            .try_for_each(|bit| Self::add(&mut storage, bit, bit, 1))
            .map(|()| T::of_storage(storage))
            .ok_or_else(|| E::invalid_value(Unexpected::Unsigned(number), &self))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
        let mut storage = T::NONE.storage();
        text.split('|')
            .map(str::trim)
            .filter(|word| !word.is_empty())
            .try_for_each(|word| Self::add_word(&mut storage, word))
            .map(|()| T::of_storage(storage))
            .ok_or_else(|| E::invalid_value(Unexpected::Str(text), &self))
    }
}

// --------------------------------------------------------------------------- fields of any type

#[cfg(feature = "registry")]
mod any {
    use core::fmt;

    use serde::de::{DeserializeSeed, EnumAccess, Error, SeqAccess, Unexpected, Visitor};
    use serde::ser::Error as _;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use crate::field::RawField;
    use crate::packet::MAX_FIELD_DATA;
    use crate::registry::{AnyField, FieldInfo};
    use crate::List;

    impl Serialize for AnyField {
        fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
            if serializer.is_human_readable() {
                return self.write_named(serializer);
            }
            let mut data = [0; MAX_FIELD_DATA];
            let size = self.encode(&mut data).map_err(S::Error::custom)?;
            let set = self.info().sets.first().copied().unwrap_or_default();
            let data = Data(data.iter().copied().take(size).collect());
            (set, self.info().descriptor, data).serialize(serializer)
        }
    }

    impl<'de> Deserialize<'de> for AnyField {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            if deserializer.is_human_readable() {
                return deserializer.deserialize_enum("AnyField", &[], Named);
            }
            let (set, descriptor, Data(data)) = Deserialize::deserialize(deserializer)?;
            let field = RawField { set, descriptor, data: &data };
            let unknown = || {
                D::Error::custom(format_args!("unknown field {:#x},{descriptor:#x}", field.set.0))
            };
            Self::decode(&field).map_err(D::Error::custom)?.ok_or_else(unknown)
        }
    }

    /// The bytes of a field.
    struct Data(List<u8, MAX_FIELD_DATA>);

    impl Serialize for Data {
        fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
            serializer.serialize_bytes(&self.0)
        }
    }

    impl<'de> Deserialize<'de> for Data {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            deserializer.deserialize_bytes(Bytes)
        }
    }

    struct Bytes;

    impl<'de> Visitor<'de> for Bytes {
        type Value = Data;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(f, "at most {MAX_FIELD_DATA} bytes")
        }

        fn visit_bytes<E: Error>(self, bytes: &[u8]) -> Result<Data, E> {
            List::from_slice(bytes).map(Data).map_err(E::custom)
        }

        fn visit_seq<A: SeqAccess<'de>>(self, mut bytes: A) -> Result<Data, A::Error> {
            let mut list = List::new();
            while let Some(byte) = bytes.next_element()? {
                list.push(byte).map_err(A::Error::custom)?;
            }
            Ok(Data(list))
        }
    }

    struct Named;

    impl<'de> Visitor<'de> for Named {
        type Value = AnyField;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("a field by its name")
        }

        fn visit_enum<A: EnumAccess<'de>>(self, access: A) -> Result<AnyField, A::Error> {
            let (info, value) = access.variant_seed(Name)?;
            AnyField::read_named(info.name, value)
        }
    }

    struct Name;

    impl<'de> DeserializeSeed<'de> for Name {
        type Value = &'static FieldInfo;

        fn deserialize<D: Deserializer<'de>>(
            self,
            deserializer: D,
        ) -> Result<Self::Value, D::Error> {
            deserializer.deserialize_identifier(self)
        }
    }

    impl Visitor<'_> for Name {
        type Value = &'static FieldInfo;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("the name of a field")
        }

        fn visit_str<E: Error>(self, name: &str) -> Result<Self::Value, E> {
            let unknown = || E::invalid_value(Unexpected::Str(name), &self);
            FieldInfo::by_name(name).ok_or_else(unknown)
        }
    }
}

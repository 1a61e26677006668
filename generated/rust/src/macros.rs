//! The macros that the generated types are written with.

/// An enumeration that keeps values which it does not know.
macro_rules! open_enum {
    (
        $(#[$meta:meta])*
        $name:ident: $number:ty {
            $($(#[$value_meta:meta])* $value:ident = $literal:literal, $text:literal;)*
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[cfg_attr(
            feature = "serde",
            derive(serde::Serialize, serde::Deserialize),
            serde(transparent)
        )]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $name(pub $number);

        impl $name {
            $($(#[$value_meta])* pub const $value: Self = Self($literal);)*

            /// All values that have a name.
            pub const VALUES: &'static [Self] = &[$(Self::$value),*];

            /// The name of the value in the specification, if it has one.
            #[must_use]
            pub const fn name(self) -> ::core::option::Option<&'static str> {
                match self {
                    $(Self::$value => ::core::option::Option::Some($text),)*
                    _ => ::core::option::Option::None,
                }
            }
        }

        $crate::macros::newtype!($name: $number);

        impl ::core::fmt::Display for $name {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                match self.name() {
                    ::core::option::Option::Some(name) => f.pad(name),
                    ::core::option::Option::None => ::core::fmt::Display::fmt(&self.0, f),
                }
            }
        }

        impl ::core::fmt::Debug for $name {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                f.write_str(concat!(stringify!($name), "("))?;
                ::core::fmt::Display::fmt(self, f)?;
                f.write_str(")")
            }
        }

        impl $crate::bits::Number for $name {
            fn from_bits(bits: u64) -> Self {
                Self(<$number as $crate::bits::Number>::from_bits(bits))
            }

            fn to_bits(self) -> u64 {
                $crate::bits::Number::to_bits(self.0)
            }
        }
    };
}

/// Named bits of a number or of bytes.
macro_rules! bitfield {
    (
        $(#[$meta:meta])*
        $name:ident: $storage:tt {
            $(
                $(#[$bits_meta:meta])*
                $mask:ident: $value:ty = $first:literal $(..= $last:literal)?,
                $text:literal, $get:ident, $set:ident, $with:ident;
            )*
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Default, PartialEq, Eq, Hash)]
        #[cfg_attr(
            feature = "serde",
            derive(serde::Serialize, serde::Deserialize),
            serde(transparent)
        )]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $name(pub $storage);

        impl $name {
            $($(#[$bits_meta])* pub const $mask: Self =
                Self($crate::bits::mask!($storage, $first $(, $last)?));)*

            /// All bits that have a name.
            pub const BITS: &'static [$crate::bits::Bits] = &[
                $($crate::bits::Bits {
                    name: $text,
                    first: $first,
                    last: $crate::bits::last!($first $(, $last)?),
                }),*
            ];

            /// No bit is set.
            #[must_use]
            pub fn empty() -> Self {
                ::core::default::Default::default()
            }

            /// Is no bit set?
            #[must_use]
            pub fn is_empty(self) -> bool {
                self == Self::empty()
            }

            /// Are all of these bits set?
            #[must_use]
            pub fn contains(self, bits: Self) -> bool {
                $crate::bits::Storage::and(self.0, bits.0) == bits.0
            }

            /// Is any of these bits set?
            #[must_use]
            pub fn intersects(self, bits: Self) -> bool {
                !Self($crate::bits::Storage::and(self.0, bits.0)).is_empty()
            }

            /// Sets these bits.
            pub fn insert(&mut self, bits: Self) {
                self.0 = $crate::bits::Storage::or(self.0, bits.0);
            }

            /// Clears these bits.
            pub fn remove(&mut self, bits: Self) {
                self.0 = $crate::bits::Storage::and_not(self.0, bits.0);
            }

            $(
                $(#[$bits_meta])*
                #[must_use]
                pub fn $get(self) -> $value {
                    let last = $crate::bits::last!($first $(, $last)?);
                    $crate::bits::Number::from_bits($crate::bits::Storage::get(self.0, $first, last))
                }

                /// Sets or clears it; of a number, the bits that fit.
                #[doc = concat!("See [`", stringify!($name), "::", stringify!($get), "`].")]
                pub fn $set(&mut self, value: $value) {
                    let last = $crate::bits::last!($first $(, $last)?);
                    let bits = $crate::bits::Number::to_bits(value);
                    $crate::bits::Storage::set(&mut self.0, $first, last, bits);
                }

                /// A copy with it set or cleared.
                #[doc = concat!("See [`", stringify!($name), "::", stringify!($get), "`].")]
                #[must_use]
                pub fn $with(mut self, value: $value) -> Self {
                    self.$set(value);
                    self
                }
            )*
        }

        $crate::macros::newtype!($name: $storage);

        impl ::core::ops::BitOr for $name {
            type Output = Self;

            fn bitor(self, other: Self) -> Self {
                Self($crate::bits::Storage::or(self.0, other.0))
            }
        }

        impl ::core::ops::BitAnd for $name {
            type Output = Self;

            fn bitand(self, other: Self) -> Self {
                Self($crate::bits::Storage::and(self.0, other.0))
            }
        }

        impl ::core::ops::BitOrAssign for $name {
            fn bitor_assign(&mut self, other: Self) {
                self.insert(other);
            }
        }

        impl ::core::fmt::Debug for $name {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                f.write_str(concat!(stringify!($name), "("))?;
                $crate::bits::debug(self.0, Self::BITS, f)?;
                f.write_str(")")
            }
        }
    };
}

/// A few numbers of one kind whose places have names.
macro_rules! vector {
    (
        $(#[$meta:meta])*
        $name:ident: [$number:ty; $count:literal] {
            $($(#[$element_meta:meta])* $element:ident,)*
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $name {
            $($(#[$element_meta])* pub $element: $number,)*
        }

        impl $name {
            /// The elements in the order of the wire.
            #[must_use]
            pub const fn to_array(self) -> [$number; $count] {
                [$(self.$element),*]
            }
        }

        impl ::core::convert::From<[$number; $count]> for $name {
            fn from([$($element),*]: [$number; $count]) -> Self {
                Self { $($element),* }
            }
        }

        impl ::core::convert::From<$name> for [$number; $count] {
            fn from(value: $name) -> Self {
                value.to_array()
            }
        }

        impl $crate::Wire for $name {
            const SIZE: usize = <[$number; $count] as $crate::Wire>::SIZE;

            fn decode_from(
                reader: &mut $crate::Reader<'_>,
            ) -> ::core::result::Result<Self, $crate::DecodeError> {
                reader.read::<[$number; $count]>().map(Self::from)
            }

            fn encode_to(
                &self,
                writer: &mut $crate::Writer<'_>,
            ) -> ::core::result::Result<(), $crate::EncodeError> {
                writer.write(&self.to_array())
            }
        }

        #[cfg(feature = "dynamic")]
        impl $crate::dynamic::ToValue for $name {
            fn to_value(&self) -> $crate::dynamic::Value {
                self.to_array().to_value()
            }
        }

        #[cfg(feature = "dynamic")]
        impl $crate::dynamic::FromValue for $name {
            fn from_value(
                value: &$crate::dynamic::Value,
            ) -> ::core::result::Result<Self, $crate::dynamic::ValueError> {
                <[$number; $count]>::from_value(value).map(Self::from)
            }
        }
    };
}

/// What every newtype around a number or bytes has.
macro_rules! newtype {
    ($name:ident: $inner:ty) => {
        impl ::core::convert::From<$inner> for $name {
            fn from(value: $inner) -> Self {
                Self(value)
            }
        }

        impl ::core::convert::From<$name> for $inner {
            fn from(value: $name) -> Self {
                value.0
            }
        }

        impl $crate::Wire for $name {
            const SIZE: usize = <$inner as $crate::Wire>::SIZE;

            fn decode_from(
                reader: &mut $crate::Reader<'_>,
            ) -> ::core::result::Result<Self, $crate::DecodeError> {
                reader.read().map(Self)
            }

            fn encode_to(
                &self,
                writer: &mut $crate::Writer<'_>,
            ) -> ::core::result::Result<(), $crate::EncodeError> {
                writer.write(&self.0)
            }
        }

        #[cfg(feature = "dynamic")]
        impl $crate::dynamic::ToValue for $name {
            fn to_value(&self) -> $crate::dynamic::Value {
                self.0.to_value()
            }
        }

        #[cfg(feature = "dynamic")]
        impl $crate::dynamic::FromValue for $name {
            fn from_value(
                value: &$crate::dynamic::Value,
            ) -> ::core::result::Result<Self, $crate::dynamic::ValueError> {
                $crate::dynamic::FromValue::from_value(value).map(Self)
            }
        }
    };
}

/// The several types that one command can be answered with.
macro_rules! responses {
    (
        $(#[$meta:meta])*
        $name:ident { $($(#[$variant_meta:meta])* $variant:ident($field:ident),)* }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub enum $name {
            $($(#[$variant_meta])* $variant($field),)*
        }

        impl $crate::Response for $name {
            const DESCRIPTORS: &'static [u8] = &[$(<$field as $crate::Field>::DESCRIPTOR),*];

            fn from_field(
                field: &$crate::RawField<'_>,
            ) -> ::core::option::Option<::core::result::Result<Self, $crate::DecodeError>> {
                $(
                    let found = <$field as $crate::Response>::from_field(field);
                    if let ::core::option::Option::Some(found) = found {
                        return ::core::option::Option::Some(found.map(Self::$variant));
                    }
                )*
                ::core::option::Option::None
            }
        }
    };
}

/// All fields: what is known about them, and one type that can be any of them.
macro_rules! registry {
    ($(
        $(#[$meta:meta])*
        $variant:ident($type:ty),
        $role:ident $set:literal, $descriptor:literal, in $first:literal..=$last:literal,
        of $layouts:literal, $name:literal, $title:literal, [$($linked:literal),*];
    )*) => {
        /// What is known about all fields.
        pub static FIELDS: &[FieldInfo] = &[$(FieldInfo {
            set: $set,
            descriptor: $descriptor,
            role: Role::$role,
            name: $name,
            title: $title,
            linked: &[$($linked),*],
            sets: ($first, $last),
        }),*];

        /// Where the fields stand in [`FIELDS`].
        #[derive(Clone, Copy)]
        enum Index { $($variant),* }

        /// A field of any type.
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub enum AnyField {
            $($(#[$meta])* $variant($type),)*
        }

        impl AnyField {
            /// Decodes a field and tells how many bytes are left over; `None` if it is unknown.
            #[must_use]
            pub fn decode(field: &RawField<'_>) -> Option<Result<(Self, usize), DecodeError>> {
                Some(match index(field)? {
                    $(Index::$variant => decode(field, Self::$variant),)*
                })
            }

            /// Encodes the data of the field to the front of the buffer and gives its length.
            pub fn encode(&self, buffer: &mut [u8]) -> Result<usize, EncodeError> {
                match self {
                    $(Self::$variant(field) => field.encode(buffer),)*
                }
            }

            /// Puts it into a request, if it is a command.
            pub(crate) fn add_to<const N: usize>(
                &self,
                request: &mut Request<'_, N>,
            ) -> Option<Result<Ticket<()>, RequestError>> {
                match self {
                    $(Self::$variant(field) => $crate::macros::add_to!($role, request, field),)*
                }
            }

            /// What is known about the field.
            #[must_use]
            pub fn info(&self) -> Option<&'static FieldInfo> {
                let index = match self {
                    $(Self::$variant(_) => Index::$variant,)*
                };
                FIELDS.get(index as usize)
            }

            /// The field as a tree of values.
            #[cfg(feature = "dynamic")]
            #[must_use]
            pub fn to_value(&self) -> crate::dynamic::Value {
                use crate::dynamic::ToValue;
                match self {
                    $(Self::$variant(field) => field.to_value(),)*
                }
            }

            /// The field of this name, `set.field`, with the values of a tree.
            #[cfg(feature = "dynamic")]
            pub fn from_value(
                name: &str,
                value: &crate::dynamic::Value,
            ) -> Result<Self, crate::dynamic::ValueError> {
                match name {
                    $($name => from_value(value, Self::$variant),)*
                    _ => Err(crate::dynamic::ValueError::Unknown),
                }
            }
        }

        fn index(field: &RawField<'_>) -> Option<Index> {
            Some(match (field.set, field.descriptor) {
                $(($first..=$last, $descriptor)
                    if $layouts == 1 || field.has_constants_of::<$type>() => Index::$variant,)*
                _ => return None,
            })
        }
    };
}

/// What is put into a request: commands, and nothing else.
macro_rules! add_to {
    (Command, $request:ident, $field:ident) => {
        Some($request.add($field).map(Ticket::untyped))
    };
    ($role:ident, $request:ident, $field:ident) => {{
        let _ = $field;
        None
    }};
}

/// The fields of a device.
macro_rules! device_fields {
    ($($set:literal $descriptor:literal $name:literal [$($function:ident)*];)*) => {
        &[$($crate::devices::Supported {
            set: $set,
            descriptor: $descriptor,
            name: $name,
            functions: &[$($crate::types::FunctionSelector::$function),*],
        }),*]
    };
}

pub(crate) use {add_to, bitfield, device_fields, newtype, open_enum, registry, responses, vector};

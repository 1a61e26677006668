//! Enumerations, vectors, and the implementations that all newtypes share.

/// An enumeration that preserves unnamed values.
macro_rules! open_enum {
    (
        $(#[$meta:meta])*
        $name:ident: $number:ty {
            $($(#[$value_meta:meta])* $value:ident = $literal:literal, $text:literal;)*
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $name(pub $number);

        impl $name {
            $($(#[$value_meta])* pub const $value: Self = Self($literal);)*

            /// All named values.
            pub const VALUES: &'static [Self] = &[$(Self::$value),*];

            /// Returns the value's name in the specification, if it has one.
            #[inline]
            #[must_use]
            pub const fn name(self) -> ::core::option::Option<&'static str> {
                match self {
                    $(Self::$value => ::core::option::Option::Some($text),)*
                    _ => ::core::option::Option::None,
                }
            }
        }

        /// Finds the value with this name in the specification.
        impl ::core::str::FromStr for $name {
            type Err = $crate::error::NameError;

            fn from_str(name: &str) -> ::core::result::Result<Self, $crate::error::NameError> {
                let mut values = Self::VALUES.iter().copied();
                let called = |value: &Self| value.name() == ::core::option::Option::Some(name);
                values.find(called).ok_or($crate::error::NameError)
            }
        }

        newtype!($name: $number);

        #[cfg(feature = "serde")]
        #[doc(hidden)]
        impl $crate::readable::Named for $name {
            type Number = $number;

            fn text(self) -> ::core::option::Option<&'static str> {
                self.name()
            }

            fn number(self) -> $number {
                self.0
            }

            fn of_text(text: &str) -> ::core::option::Option<Self> {
                text.parse().ok()
            }

            fn of_number(number: $number) -> Self {
                Self(number)
            }
        }

        #[cfg(feature = "serde")]
        readable!($name write_name read_name);

        impl ::core::fmt::Display for $name {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                match self.name() {
                    ::core::option::Option::Some(name) => f.pad(name),
                    ::core::option::Option::None => ::core::fmt::Display::fmt(&self.0, f),
                }
            }
        }

        impl ::core::fmt::Debug for $name {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                f.write_str(concat!(stringify!($name), "("))?;
                ::core::fmt::Display::fmt(self, f)?;
                f.write_str(")")
            }
        }

        #[doc(hidden)]
        impl $crate::bits::Number for $name {
            #[inline]
            fn from_bits(bits: u64) -> Self {
                Self(<$number as $crate::bits::Number>::from_bits(bits))
            }

            #[inline]
            fn to_bits(self) -> u64 {
                $crate::bits::Number::to_bits(self.0)
            }
        }
    };
}

/// Implements the traits of `serde` for a newtype.
#[cfg(feature = "serde")]
macro_rules! readable {
    ($name:ident $write:ident $read:ident) => {
        impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(
                &self,
                serializer: S,
            ) -> ::core::result::Result<S::Ok, S::Error> {
                $crate::readable::$write(*self, serializer)
            }
        }

        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::core::result::Result<Self, D::Error> {
                $crate::readable::$read(deserializer)
            }
        }
    };
}

/// A few numbers of one type, each with a name.
macro_rules! vector {
    (
        $(#[$meta:meta])*
        $name:ident: [$number:ty; $count:literal] {
            $($(#[$element_meta:meta])* $element:ident,)*
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $name {
            $($(#[$element_meta])* pub $element: $number,)*
        }

        impl $name {
            /// Returns the elements in wire order.
            #[inline]
            #[must_use]
            pub const fn to_array(self) -> [$number; $count] {
                [$(self.$element),*]
            }
        }

        mint!($name $number: $($element)*);

        #[doc(hidden)]
        impl $crate::list::Item for $name {
            const BLANK: Self = Self { $($element: 0 as $number),* };
        }

        #[doc(hidden)]
        impl $crate::range::Limited for $name {
            fn outside(&self, bound: $crate::range::Bound) -> ::core::option::Option<f64> {
                self.to_array().outside(bound)
            }
        }

        impl ::core::convert::From<[$number; $count]> for $name {
            #[inline]
            fn from([$($element),*]: [$number; $count]) -> Self {
                Self { $($element),* }
            }
        }

        impl ::core::convert::From<$name> for [$number; $count] {
            #[inline]
            fn from(value: $name) -> Self {
                value.to_array()
            }
        }

        through!($name: [$number; $count], Self::to_array, Self::from);

        /// Serializes as an array, as in a tree of values.
        #[cfg(feature = "serde")]
        impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(
                &self,
                serializer: S,
            ) -> ::core::result::Result<S::Ok, S::Error> {
                $crate::readable::serialize(&self.to_array(), serializer)
            }
        }

        #[cfg(feature = "serde")]
        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::core::result::Result<Self, D::Error> {
                $crate::readable::deserialize::<[$number; $count], D>(deserializer).map(Self::from)
            }
        }
    };
}

/// Conversions from and to the type of `mint`, by the names of the elements; the part of a quaternion
/// that is no vector comes first here, and last in some other crates.
macro_rules! mint {
    ($name:ident $number:ty: x y z) => {
        mint!($name, mint::Vector3<$number>, x y z, v, mint::Vector3 { x, y, z }, v.x v.y v.z);
    };
    ($name:ident $number:ty: w x y z) => {
        mint!(
            $name, mint::Quaternion<$number>, w x y z, q,
            mint::Quaternion { s: w, v: mint::Vector3 { x, y, z } }, q.s q.v.x q.v.y q.v.z
        );
    };
    ($name:ident $number:ty: m11 m12 m13 m21 m22 m23 m31 m32 m33) => {
        mint!(
            $name, mint::RowMatrix3<$number>, m11 m12 m13 m21 m22 m23 m31 m32 m33, m,
            mint::RowMatrix3 {
                x: mint::Vector3 { x: m11, y: m12, z: m13 },
                y: mint::Vector3 { x: m21, y: m22, z: m23 },
                z: mint::Vector3 { x: m31, y: m32, z: m33 },
            },
            m.x.x m.x.y m.x.z m.y.x m.y.y m.y.z m.z.x m.z.y m.z.z
        );
    };
    ($name:ident $number:ty: $($element:ident)*) => {};
    (
        $name:ident, $other:ty, $($element:ident)*, $value:ident, $made:expr,
        $($part:ident $(. $inner:ident)+)*
    ) => {
        #[cfg(feature = "mint")]
        impl ::core::convert::From<$name> for $other {
            fn from($name { $($element),* }: $name) -> Self {
                $made
            }
        }

        #[cfg(feature = "mint")]
        impl ::core::convert::From<$other> for $name {
            fn from($value: $other) -> Self {
                [$($part $(. $inner)+),*].into()
            }
        }

        #[cfg(feature = "mint")]
        #[doc(hidden)]
        impl mint::IntoMint for $name {
            type MintType = $other;
        }
    };
}

/// The implementations that all newtypes of a number or bytes share.
macro_rules! newtype {
    ($name:ident: $inner:ty) => {
        impl ::core::convert::From<$inner> for $name {
            #[inline]
            fn from(value: $inner) -> Self {
                Self(value)
            }
        }

        impl ::core::convert::From<$name> for $inner {
            #[inline]
            fn from(value: $name) -> Self {
                value.0
            }
        }

        #[doc(hidden)]
        impl $crate::list::Item for $name {
            const BLANK: Self = Self(<$inner as $crate::list::Item>::BLANK);
        }

        through!($name: $inner, <$inner>::from, Self);
    };
}

/// The wire format and the tree of values of what is inside: a function that returns it, and one
/// that makes the value of it.
macro_rules! through {
    ($name:ident: $inner:ty, $inside:expr, $made:expr) => {
        #[doc(hidden)]
        impl $crate::Wire for $name {
            const SIZE: usize = <$inner as $crate::Wire>::SIZE;
            const FIXED: bool = true;

            #[inline]
            fn decode_from(
                reader: &mut $crate::Reader<'_>,
            ) -> ::core::result::Result<Self, $crate::error::ReadError> {
                reader.read::<$inner>().map($made)
            }

            #[inline]
            fn encode_to(
                &self,
                writer: &mut $crate::Writer<'_>,
            ) -> ::core::result::Result<(), $crate::error::EncodeErrorKind> {
                writer.write(&$inside(*self))
            }
        }

        #[cfg(feature = "dynamic")]
        #[doc(hidden)]
        impl $crate::dynamic::ToValue for $name {
            fn to_value(&self) -> $crate::dynamic::Value {
                $crate::dynamic::ToValue::to_value(&$inside(*self))
            }
        }

        #[cfg(feature = "dynamic")]
        #[doc(hidden)]
        impl $crate::dynamic::FromValue for $name {
            fn from_value(
                value: &$crate::dynamic::Value,
            ) -> ::core::result::Result<Self, $crate::dynamic::ValueError> {
                <$inner as $crate::dynamic::FromValue>::from_value(value).map($made)
            }
        }
    };
}

//! Bitfields.

/// Named bits of a number or of bytes, with functions like those of the crate `bitflags`.
macro_rules! bitfield {
    (
        $(#[$meta:meta])*
        $name:ident: $storage:tt $(while $state:ty)? {
            $(
                $(#[$bits_meta:meta])*
                $mask:ident: $value:ty = $first:literal $(..= $last:literal)?
                    $(while [$($number:literal),*])?,
                $get:ident $($text:literal)?, $set:ident, $with:ident;
            )*
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $name(pub $storage);

        impl $name {
            $($(#[$bits_meta])* pub const $mask: Self =
                Self($crate::bits::mask!($storage, $first $(, $last)?));)*

            /// All named bits.
            pub const BITS: &'static [$crate::bits::Bits] = &[
                $($crate::bits::Bits {
                    name: spec_name!($get $($text)?),
                    first: $first,
                    last: $crate::bits::last!($first $(, $last)?),
                    states: &[$($($number),*)?],
                }),*
            ];

            $(
                /// Iterates over the bits that are set, with their names, without those that mean
                /// nothing in this state.
                #[inline]
                #[must_use]
                pub fn iter_names_in(&self, state: $state) -> $crate::bits::IterNames<Self> {
                    $crate::bits::IterNames::new(*self, Self::BITS, Some(state.0.into()))
                }
            )?

            const NO_BITS: Self = Self($crate::bits::none!($storage));
            const ALL_BITS: Self = Self::NO_BITS$(.union(Self::$mask))*;

            $(
                $(#[$bits_meta])*
                #[inline]
                #[must_use]
                pub fn $get(self) -> $value {
                    let last = $crate::bits::last!($first $(, $last)?);
                    $crate::bits::Number::from_bits($crate::bits::Storage::get(self.0, $first, last))
                }

                /// Sets or clears the flag, or sets the number without its excess bits.
                #[doc = concat!("See [`", stringify!($name), "::", stringify!($get), "`].")]
                #[inline]
                pub fn $set(&mut self, value: $value) {
                    let last = $crate::bits::last!($first $(, $last)?);
                    let bits = $crate::bits::Number::to_bits(value);
                    $crate::bits::Storage::set(&mut self.0, $first, last, bits);
                }

                /// Returns a copy with another value of the flag or number.
                #[doc = concat!("See [`", stringify!($name), "::", stringify!($get), "`].")]
                #[inline]
                #[must_use]
                pub fn $with(mut self, value: $value) -> Self {
                    self.$set(value);
                    self
                }
            )*
        }

        newtype!($name: $storage);
        bit_sets!($name: $storage);

        #[cfg(feature = "serde")]
        #[doc(hidden)]
        impl $crate::readable::Flags for $name {
            type Storage = $storage;

            const NAMES: &'static [$crate::bits::Bits] = Self::BITS;
            const NONE: Self = Self::NO_BITS;

            fn storage(self) -> $storage {
                self.0
            }

            fn of_storage(storage: $storage) -> Self {
                Self(storage)
            }
        }

        #[cfg(feature = "serde")]
        readable!($name write_flags read_flags);

        impl ::core::fmt::Debug for $name {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::bits::debug(stringify!($name), self.0, Self::BITS, f)
            }
        }

        $crate::bits::formats!($name $storage);
    };
}

/// The methods of every bitfield as a set of bits; unnamed bits are treated like others.
macro_rules! bit_sets {
    ($name:ident: $storage:tt) => {
        impl $name {
            /// Returns a bitfield without any bit set.
            #[inline]
            #[must_use]
            pub const fn empty() -> Self {
                Self::NO_BITS
            }

            /// Returns a bitfield with all named bits set.
            #[inline]
            #[must_use]
            pub const fn all() -> Self {
                Self::ALL_BITS
            }

            /// Returns the bits of the flag or number with this name in the specification.
            #[inline]
            #[must_use]
            pub fn from_name(name: &str) -> ::core::option::Option<Self> {
                let bits = Self::BITS.iter().find(|bits| bits.name == name)?;
                ::core::option::Option::Some(Self($crate::bits::Storage::part(
                    Self::ALL_BITS.0,
                    bits.first,
                    bits.last,
                )))
            }

            /// Is no bit set?
            #[inline]
            #[must_use]
            pub const fn is_empty(&self) -> bool {
                $crate::bits::is_none!($storage, self.0)
            }

            /// Are all of these bits set?
            #[inline]
            #[must_use]
            pub const fn contains(&self, bits: Self) -> bool {
                bits.difference(*self).is_empty()
            }

            /// Sets these bits.
            #[inline]
            pub fn insert(&mut self, bits: Self) {
                *self = self.union(bits);
            }

            /// Clears these bits.
            #[inline]
            pub fn remove(&mut self, bits: Self) {
                *self = self.difference(bits);
            }

            /// Returns the bits that are set in either.
            #[inline]
            #[must_use]
            pub const fn union(self, other: Self) -> Self {
                Self($crate::bits::merge!($storage, or, self.0, other.0))
            }

            /// Returns the bits that are set in both.
            #[inline]
            #[must_use]
            pub const fn intersection(self, other: Self) -> Self {
                Self($crate::bits::merge!($storage, and, self.0, other.0))
            }

            /// Returns the bits that are set here and not in `other`.
            #[inline]
            #[must_use]
            pub const fn difference(self, other: Self) -> Self {
                Self($crate::bits::merge!($storage, and_not, self.0, other.0))
            }

            /// Returns the bits that are set in exactly one of the two.
            #[inline]
            #[must_use]
            pub const fn symmetric_difference(self, other: Self) -> Self {
                Self($crate::bits::merge!($storage, xor, self.0, other.0))
            }

            /// Returns the named bits that are not set.
            #[inline]
            #[must_use]
            pub const fn complement(self) -> Self {
                Self::ALL_BITS.difference(self)
            }

            /// Iterates over the bits that are set, with their names.
            ///
            /// A number of several bits is included if it is not 0. Bits that belong to several
            /// names are returned only once.
            #[inline]
            #[must_use]
            pub fn iter_names(&self) -> $crate::bits::IterNames<Self> {
                $crate::bits::IterNames::new(*self, Self::BITS, None)
            }
        }

        #[doc(hidden)]
        impl $crate::bits::BitSet for $name {
            #[inline]
            fn part(self, first: u16, last: u16) -> Self {
                Self($crate::bits::Storage::part(self.0, first, last))
            }

            #[inline]
            fn without(self, other: Self) -> Self {
                self.difference(other)
            }

            #[inline]
            fn none(self) -> bool {
                self.is_empty()
            }
        }

        bit_operators! { $name
            BitOr bitor BitOrAssign bitor_assign union;
            BitAnd bitand BitAndAssign bitand_assign intersection;
            BitXor bitxor BitXorAssign bitxor_assign symmetric_difference;
            Sub sub SubAssign sub_assign difference;
        }

        impl ::core::ops::Not for $name {
            type Output = Self;

            #[inline]
            fn not(self) -> Self {
                self.complement()
            }
        }
    };
}

macro_rules! bit_operators {
    ($name:ident $($operator:ident $call:ident $assign:ident $call_assign:ident $method:ident;)*) => {$(
        impl ::core::ops::$operator for $name {
            type Output = Self;

            #[inline]
            fn $call(self, other: Self) -> Self {
                self.$method(other)
            }
        }

        impl ::core::ops::$assign for $name {
            #[inline]
            fn $call_assign(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    )*};
}

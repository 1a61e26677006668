//! Bitfields.

/// Named bits of a number or of bytes.
macro_rules! bitfield {
    (
        $(#[$meta:meta])*
        $name:ident: $storage:tt {
            $(
                $(#[$bits_meta:meta])*
                $mask:ident: $value:ty = $first:literal $(..= $last:literal)?,
                $get:ident $($text:literal)?, $set:ident, $with:ident;
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
                    name: spec_name!($get $($text)?),
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

        newtype!($name: $storage);

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

//! Records (structures and fields): their members and their wire format.

/// A record. Its wire format is a list of steps:
///
/// - `[member]`: a value that is always present;
/// - `[member selects]`: the function selector;
/// - `[member for WRITE APPLY]`: a value that these functions require;
/// - `[member optional]`: a value that may be absent;
/// - `[count: u8 counts list]`: the number of items of a list that comes later;
/// - `[list by count]`: that list;
/// - `[union as tag]`: the alternative that a tag selects, perhaps `for` functions or `optional`;
/// - `[name: u16 = 7]`: a constant;
/// - `[(a, b) for WRITE { [a] [b] }]`: members that are present or absent together.
///
/// A name that differs from the specification's is followed by that: `[type_ "type"]`. Without
/// steps, the members are on the wire in order.
macro_rules! record {
    ($(#[$meta:meta])* pub struct $name:ident;) => {
        unit!([$([$meta])*] $name);
        wire!($name {} 0, true;);
    };
    (
        $(#[$meta:meta])*
        pub struct $name:ident;
        wire $size:literal {
            $([$($step:tt)*])*
        }
    ) => {
        unit!([$([$meta])*] $name);
        wire!($name {} $size, false; $([$($step)*])*);
    };
    (
        $(#[$meta:meta])*
        pub struct $name:ident {
            $($(#[$member_meta:meta])* pub $member:ident: $type:ty,)*
        }
    ) => {
        members!([$([$meta])*] $name $([$([$member_meta])*] $member: $type,)*);
        wire!($name { $($member)* }
            0_usize$(.saturating_add(<$type as $crate::Wire>::SIZE))*,
            true $(&& <$type as $crate::Wire>::FIXED)*;
            $([$member])*);
    };
    (
        $(#[$meta:meta])*
        pub struct $name:ident {
            $(#[$selector_meta:meta])* pub $selector:ident: $selector_type:ty,
            $($(#[$member_meta:meta])* pub $member:ident: $type:ty,)*
        }
        wire $size:literal {
            [$selects:ident selects]
            $([$($step:tt)*])*
        }
    ) => {
        members!([$([$meta])*] $name
            [$([$selector_meta])*] $selector: $selector_type,
            $([$([$member_meta])*] $member: $type,)*);
        wire!($name { $selector $($member)* } $size, false; [$selects selects] $([$($step)*])*);

        impl $name {
            /// Creates a command with only its selector.
            #[inline]
            const fn bare($selector: $selector_type) -> Self {
                Self { $selector, $($member: None,)* }
            }
        }
    };
    (
        $(#[$meta:meta])*
        pub struct $name:ident {
            $($(#[$member_meta:meta])* pub $member:ident: $type:ty,)*
        }
        wire $size:literal {
            $([$($step:tt)*])*
        }
    ) => {
        members!([$([$meta])*] $name $([$([$member_meta])*] $member: $type,)*);
        wire!($name { $($member)* } $size, false; $([$($step)*])*);
    };
}

/// The type of a record without members.
macro_rules! unit {
    ([$([$meta:meta])*] $name:ident) => {
        $(#[$meta])*
        #[derive(Clone, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $name;
    };
}

/// The type of a record.
macro_rules! members {
    ([$([$meta:meta])*] $name:ident $([$([$member_meta:meta])*] $member:ident: $type:ty,)*) => {
        $(#[$meta])*
        #[derive(Clone, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $name {
            $($(#[$member_meta])* pub $member: $type,)*
        }
    };
}

/// Implements `Wire` for a record, from its members, its maximum size, whether that is its only
/// size, and its steps.
macro_rules! wire {
    ($name:ident { $($member:ident)* } $size:expr, $fixed:expr; $([$($step:tt)*])*) => {
        #[doc(hidden)]
        impl $crate::Wire for $name {
            const SIZE: usize = $size;
            const FIXED: bool = $fixed;

            #[allow(unused_variables)]
            #[inline]
            fn decode_from(reader: &mut $crate::Reader<'_>) -> Result<Self, $crate::error::ReadError> {
                if Self::FIXED {
                    reader.require(Self::SIZE)?;
                }
                $(decode!(reader selected $($step)*);)*
                Ok(Self { $($member),* })
            }

            #[allow(unused_variables)]
            #[inline]
            fn encode_to(&self, writer: &mut $crate::Writer<'_>) -> Result<(), $crate::error::EncodeErrorKind> {
                let Self { $($member),* } = self;
                if Self::FIXED {
                    writer.require(Self::SIZE)?;
                }
                $(encode!(writer selected $($step)*);)*
                Ok(())
            }
        }

        #[cfg(feature = "dynamic")]
        tree!($name { $($member)* } $([$($step)*])*);
    };
}

/// Constructors: their arguments, and the values of other members that follow from them.
///
/// For a command with a function selector, they return a [`Call`](crate::Call) with that function.
macro_rules! constructors {
    (
        $name:ident
        $(
            $(#[$meta:meta])*
            fn $new:ident($($given:tt)*) $(-> $call:ident)? $(, $set:ident: $value:expr)*;
        )*
    ) => {
        impl $name {
            $(constructor!($(#[$meta])* $new($($given)*) $($call)?; $($set: $value,)*);)*
        }
    };
}

/// One constructor. Without arguments it is a constant.
macro_rules! constructor {
    ($(#[$meta:meta])* $new:ident(); $($set:ident: $value:expr,)*) => {
        $(#[$meta])*
        #[inline]
        #[must_use]
        pub const fn $new() -> Self {
            Self { $($set: $value,)* }
        }
    };
    ($(#[$meta:meta])* $new:ident() $call:ident; $($set:ident: $value:expr,)*) => {
        $(#[$meta])*
        #[inline]
        #[must_use]
        #[allow(clippy::needless_update)]
        pub const fn $new() -> $crate::protocol::$call<Self> {
            $crate::Call::of(Self {
                $($set: Some($value),)*
                ..Self::bare($crate::protocol::$call::<Self>::FUNCTION)
            })
        }
    };
    (
        $(#[$meta:meta])*
        $new:ident($($given:ident: $type:ty),+ $(,)?); $($set:ident: $value:expr,)*
    ) => {
        $(#[$meta])*
        #[inline]
        #[must_use]
        #[allow(clippy::too_many_arguments)]
        pub fn $new($($given: $type),+) -> Self {
            Self { $($set: $value,)* $($given: ::core::convert::Into::into($given),)+ }
        }
    };
    (
        $(#[$meta:meta])*
        $new:ident($($given:ident: $type:ty),+ $(,)?) $call:ident; $($set:ident: $value:expr,)*
    ) => {
        $(#[$meta])*
        #[inline]
        #[must_use]
        #[allow(clippy::too_many_arguments, clippy::needless_update)]
        pub fn $new($($given: $type),+) -> $crate::protocol::$call<Self> {
            $crate::Call::of(Self {
                $($set: Some($value),)*
                $($given: Some(::core::convert::Into::into($given)),)+
                ..Self::bare($crate::protocol::$call::<Self>::FUNCTION)
            })
        }
    };
}

/// Converts a response to the command that writes its values.
#[allow(unused_macros)] // if no response has them all
macro_rules! change {
    ($response:ident -> $call:ident $name:ident [$($member:ident)+] $($set:ident: $value:expr,)*) => {
        /// The command that writes these values, to read, change and write them.
        impl ::core::convert::From<$response> for $crate::protocol::$call<$name> {
            #[inline]
            #[allow(clippy::needless_update)]
            fn from($response { $($member,)+ .. }: $response) -> Self {
                Self::of($name {
                    $($set: Some($value),)*
                    $($member: Some($member),)+
                    ..$name::bare(Self::FUNCTION)
                })
            }
        }
    };
}

/// Converts a tuple of all values to a structure.
macro_rules! tuple {
    ($name:ident $($member:ident: $type:ty),+) => {
        impl ::core::convert::From<($($type,)+)> for $name {
            #[inline]
            fn from(($($member,)+): ($($type,)+)) -> Self {
                Self { $($member),+ }
            }
        }
    };
}

/// Methods that add an optional value to a command, or to a call of any of its functions.
macro_rules! setters {
    ($name:ident $(fn $with:ident($member:ident: $type:ty);)*) => {
        impl $name {
            $(
                #[doc = concat!("Adds `", stringify!($member), "`, which is optional.")]
                #[inline]
                #[must_use]
                pub fn $with(mut self, $member: $type) -> Self {
                    self.$member = Some($member);
                    self
                }
            )*
        }
    };
    (call $name:ident $(fn $with:ident($member:ident: $type:ty);)*) => {
        impl<const FUNCTION: u8> $crate::Call<$name, FUNCTION> {
            $(
                #[doc = concat!("Adds `", stringify!($member), "`, which is optional.")]
                #[inline]
                #[must_use]
                pub fn $with(self, $member: $type) -> Self {
                    Self::of($name { $member: Some($member), ..self.into_command() })
                }
            )*
        }
    };
}

/// A union: its alternatives by the tag's values, with the names of their members.
macro_rules! union {
    (
        $(#[$meta:meta])*
        pub enum $name:ident: $tag:ty {
            $(
                $(#[$variant_meta:meta])*
                $value:ident => $variant:ident $(($type:ty) $text:literal)?,
            )*
        }
        default $default:expr
    ) => {
        $(#[$meta])*
        #[derive(Clone, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[non_exhaustive]
        pub enum $name {
            $($(#[$variant_meta])* $variant $(($type))?,)*
            /// No member, for a tag that the specification does not define.
            #[cfg_attr(feature = "serde", serde(rename = "other"))]
            Other($tag),
        }

        #[doc(hidden)]
        impl $crate::list::Item for $name {
            const BLANK: Self = Self::Other(<$tag as $crate::list::Item>::BLANK);
        }

        impl ::core::default::Default for $name {
            fn default() -> Self {
                $default
            }
        }

        impl $name {
            /// Returns the tag that selects this alternative.
            #[inline]
            #[must_use]
            pub const fn tag(&self) -> $tag {
                match self {
                    $(Self::$variant { .. } => <$tag>::$value,)*
                    Self::Other(tag) => *tag,
                }
            }
        }

        #[doc(hidden)]
        impl $crate::Union for $name {
            type Tag = $tag;

            #[inline]
            fn decode_as(
                tag: $tag,
                reader: &mut $crate::Reader<'_>,
            ) -> Result<Self, $crate::error::ReadError> {
                Ok(match tag {
                    $(<$tag>::$value => Self::$variant $((reader.read::<$type>()?))?,)*
                    other => Self::Other(other),
                })
            }

            #[inline]
            fn encode_as(
                &self,
                tag: $tag,
                writer: &mut $crate::Writer<'_>,
            ) -> Result<(), $crate::error::EncodeErrorKind> {
                match self {
                    _ if self.tag() != tag => {
                        let (need, got) = (tag.0 as usize, self.tag().0 as usize);
                        Err(writer.wrong($crate::error::EncodeErrorKind::Tag, need, got))
                    }
                    $($(Self::$variant(value) => writer.write::<$type>(value),)?)*
                    Self::Other(tag) if tag.name().is_some() => {
                        Err(writer.wrong($crate::error::EncodeErrorKind::Tag, tag.0 as usize, tag.0 as usize))
                    }
                    _ => Ok(()),
                }
            }
        }

        #[cfg(feature = "dynamic")]
        union_tree!($name $tag; $($value $variant $($text)?;)*);
    };
}

/// The values of a record at fixed offsets, with their types.
macro_rules! view {
    ($name:ident $($member:ident $(: $type:ty)? $(as $part:ty)?, at $at:literal;)*) => {
        /// A [view](crate::Packet::view) reads single values in place, without decoding the others:
        #[doc = concat!($("`", stringify!($member), "()` "),*)]
        impl $crate::Viewed for $name {}

        impl<'a> $crate::View<'a, $name> {
            $(viewed!($name $member $(: $type)? $(as $part)?, $at);)*
        }
    };
}

/// A view's method for one value; for a structure, it returns a view.
macro_rules! viewed {
    ($name:ident $member:ident: $type:ty, $at:literal) => {
        #[doc = concat!("See [`", stringify!($name), "::", stringify!($member), "`].")]
        #[inline]
        #[must_use]
        pub fn $member(&self) -> $type {
            $crate::view::value(self, $at)
        }
    };
    ($name:ident $member:ident as $part:ty, $at:literal) => {
        #[doc = concat!("See [`", stringify!($name), "::", stringify!($member), "`].")]
        #[inline]
        #[must_use]
        pub fn $member(&self) -> $crate::View<'a, $part> {
            $crate::view::part(self, $at)
        }
    };
}

/// Implements `Item`, so that structures can be items of lists.
macro_rules! item {
    ($name:ident { $($member:ident)* }) => {
        #[doc(hidden)]
        impl $crate::list::Item for $name {
            const BLANK: Self = Self { $($member: $crate::list::Item::BLANK),* };
        }
    };
}

/// Implements the methods that return whether values are valid, from the flags of each.
macro_rules! valid {
    ($name:ident $($is_valid:ident $text:literal: $($flags:ident $($mask:literal)?)&&+;)+) => {
        impl $name {$(
            #[doc = concat!("Is `", $text, "` valid, as its flags say?")]
            #[inline]
            #[must_use]
            pub fn $is_valid(&self) -> bool {
                $(flag!(self $flags $($mask)?))&&+
            }
        )+}
    };
}

/// Are all bits of a mask set? Without a mask: is there a value?
macro_rules! flag {
    ($self:ident $value:ident) => {
        $self.$value.is_some()
    };
    ($self:ident $flags:ident $mask:literal) => {
        $crate::bits::are_set(flags!($self $flags), $mask)
    };
}

/// The bits of a bitfield or a `Bool`.
macro_rules! flags {
    ($self:ident $flags:ident) => {
        $crate::bits::Storage::get($self.$flags.0, 0, 63)
    };
}

/// The ranges of the values of a record, and the members whose own values have ranges.
macro_rules! ranges {
    (
        $name:ident
        $($member:ident $text:literal in $range:literal $($bound:ident $limit:literal)+;)*
        $([$part:ident];)*
    ) => {
        #[doc(hidden)]
        impl $crate::range::Ranged for $name {
            fn check_in(&self, field: &'static str) -> Result<(), $crate::RangeError> {
                $($(
                    if let Some(value) =
                        $crate::range::Limited::outside(&self.$member, $crate::range::Bound::$bound($limit))
                    {
                        return Err($crate::RangeError { field, member: $text, value, range: $range });
                    }
                )+)*
                $($crate::range::Ranged::check_in(&self.$part, field)?;)*
                Ok(())
            }
        }
    };
}

/// The alternatives of a union whose values have ranges.
macro_rules! union_ranges {
    ($name:ident $($variant:ident)+) => {
        #[doc(hidden)]
        impl $crate::range::Ranged for $name {
            fn check_in(&self, field: &'static str) -> Result<(), $crate::RangeError> {
                match self {
                    $(Self::$variant(value) => value.check_in(field),)+
                    _ => Ok(()),
                }
            }
        }
    };
}

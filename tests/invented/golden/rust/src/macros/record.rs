//! Records, which are structures and fields: their members, and how these stand on the wire.

/// A record. What stands on the wire is a list of steps:
///
/// - `[member]`: a value that is always there;
/// - `[member selects]`: the function selector;
/// - `[member for WRITE APPLY]`: a value that must be there for these functions;
/// - `[member optional]`: a value that need not be there;
/// - `[count: u8 counts list]`: the number of items of a list that comes later;
/// - `[list by count]`: that list;
/// - `[union as tag]`: the alternative that a tag selects, perhaps `for` functions or `optional`;
/// - `[name: u16 = 7]`: a constant;
/// - `[(a, b) for WRITE { [a] [b] }]`: members that come and go together, and their steps.
///
/// A name that differs from the one of the specification is followed by that: `[type_ "type"]`.
/// A record without steps has its members on the wire, one after another.
macro_rules! record {
    ($(#[$meta:meta])* pub struct $name:ident;) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $name;

        wire!($name {} 0;);
    };
    (
        $(#[$meta:meta])*
        pub struct $name:ident {
            $($(#[$member_meta:meta])* pub $member:ident: $type:ty,)*
        }
    ) => {
        members!([$([$meta])*] $name $([$([$member_meta])*] $member: $type,)*);
        wire!($name { $($member)* } 0_usize$(.saturating_add(<$type as $crate::Wire>::SIZE))*;
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
        wire!($name { $selector $($member)* } $size; [$selects selects] $([$($step)*])*);

        impl $name {
            /// A command that has nothing but its selector.
            fn bare($selector: $selector_type) -> Self {
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
        wire!($name { $($member)* } $size; $([$($step)*])*);
    };
}

/// The type of a record.
macro_rules! members {
    ([$([$meta:meta])*] $name:ident $([$([$member_meta:meta])*] $member:ident: $type:ty,)*) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $name {
            $($(#[$member_meta])* pub $member: $type,)*
        }
    };
}

/// The codec of a record: its members, how many bytes it has at most, and its steps.
macro_rules! wire {
    ($name:ident { $($member:ident)* } $size:expr; $([$($step:tt)*])*) => {
        impl $crate::Wire for $name {
            const SIZE: usize = $size;

            #[allow(unused_variables)]
            fn decode_from(reader: &mut $crate::Reader<'_>) -> Result<Self, $crate::DecodeError> {
                $(decode!(reader selected $($step)*);)*
                Ok(Self { $($member),* })
            }

            #[allow(unused_variables)]
            fn encode_to(&self, writer: &mut $crate::Writer<'_>) -> Result<(), $crate::EncodeError> {
                let Self { $($member),* } = self;
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
/// Those of a command with a function selector say what the selector is.
macro_rules! constructors {
    (
        $name:ident
        $(
            $(#[$meta:meta])*
            fn $new:ident($($given:ident: $type:ty),* $(,)?) $(, $set:ident: $value:expr)*;
        )*
    ) => {
        impl $name {
            $(
                $(#[$meta])*
                #[must_use]
                #[allow(clippy::too_many_arguments)]
                pub fn $new($($given: $type),*) -> Self {
                    Self { $($set: $value,)* $($given: $given.into(),)* }
                }
            )*
        }
    };
    (
        $name:ident
        $(
            $(#[$meta:meta])*
            fn $new:ident($($given:ident: $type:ty),* $(,)?) = $selector:ident $(, $set:ident: $value:expr)*;
        )*
    ) => {
        impl $name {
            $(
                $(#[$meta])*
                #[must_use]
                #[allow(clippy::too_many_arguments, clippy::needless_update)]
                pub fn $new($($given: $type),*) -> Self {
                    Self {
                        $($set: Some($value),)*
                        $($given: Some($given.into()),)*
                        ..Self::bare($crate::protocol::FunctionSelector::$selector)
                    }
                }
            )*
        }
    };
}

/// Methods that add an optional value to a command.
macro_rules! setters {
    ($name:ident $(fn $with:ident($member:ident: $type:ty);)*) => {
        impl $name {
            $(
                #[doc = concat!("With `", stringify!($member), "`, which is optional.")]
                #[must_use]
                pub fn $with(mut self, $member: $type) -> Self {
                    self.$member = Some($member);
                    self
                }
            )*
        }
    };
}

/// A union: its alternatives by the values of its tag, with the names of their members.
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
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub enum $name {
            $($(#[$variant_meta])* $variant $(($type))?,)*
            /// Nothing, for a tag that the specification does not know.
            Other($tag),
        }

        impl ::core::default::Default for $name {
            fn default() -> Self {
                $default
            }
        }

        impl $name {
            /// The tag that goes with it.
            #[must_use]
            pub const fn tag(&self) -> $tag {
                match self {
                    $(Self::$variant { .. } => <$tag>::$value,)*
                    Self::Other(tag) => *tag,
                }
            }
        }

        impl $crate::Union for $name {
            type Tag = $tag;

            fn decode_as(
                tag: $tag,
                reader: &mut $crate::Reader<'_>,
            ) -> Result<Self, $crate::DecodeError> {
                Ok(match tag {
                    $(<$tag>::$value => Self::$variant $((reader.read::<$type>()?))?,)*
                    other => Self::Other(other),
                })
            }

            fn encode_as(
                &self,
                tag: $tag,
                writer: &mut $crate::Writer<'_>,
            ) -> Result<(), $crate::EncodeError> {
                match self {
                    _ if self.tag() != tag => Err($crate::EncodeError::Tag),
                    $($(Self::$variant(value) => writer.write::<$type>(value),)?)*
                    Self::Other(tag) if tag.name().is_some() => Err($crate::EncodeError::Tag),
                    _ => Ok(()),
                }
            }
        }

        #[cfg(feature = "dynamic")]
        union_tree!($name $tag; $($value $variant $($text)?;)*);
    };
}

//! The tables of all fields and devices.

/// All fields: their descriptions, and one type that can hold any of them.
macro_rules! registry {
    ($(
        $(#[$meta:meta])*
        $variant:ident($type:ty):
        $role:ident $set:literal, $descriptor:literal, in $first:literal..=$last:literal,
        of $layouts:literal, $name:literal, $title:literal, [$($linked:literal),*];
    )*) => {
        /// The descriptions of all fields.
        pub static FIELDS: &[FieldInfo] = &[$(FieldInfo {
            set: $set,
            descriptor: $descriptor,
            role: Role::$role,
            name: $name,
            title: $title,
            linked: &[$($linked),*],
            sets: ($first, $last),
        }),*];

        /// The positions of the fields in [`FIELDS`].
        #[derive(Clone, Copy)]
        pub(super) enum Index { $($variant),* }

        /// A field of any type.
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub enum AnyField {
            $($(#[$meta])* $variant($type),)*
        }

        impl AnyField {
            /// Decodes a field and returns the number of bytes left over; `None` if it is unknown.
            #[must_use]
            pub fn decode(field: &RawField<'_>) -> Option<Result<(Self, usize), DecodeError>> {
                Some(match index(field)? {
                    $(Index::$variant => decode(field, Self::$variant),)*
                })
            }

            /// Encodes the data of the field to the front of the buffer and returns its length.
            pub fn encode(&self, buffer: &mut [u8]) -> Result<usize, EncodeError> {
                match self {
                    $(Self::$variant(field) => field.encode(buffer),)*
                }
            }

            /// Adds it to a request, if it is a command.
            pub(crate) fn add_to<const N: usize>(
                &self,
                request: &mut Request<'_, N>,
            ) -> Option<Result<Ticket<()>, RequestError>> {
                match self {
                    $(Self::$variant(field) => add_to!($role, request, field),)*
                }
            }

            /// The description of the field.
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

        pub(super) fn index(field: &RawField<'_>) -> Option<Index> {
            Some(match (field.set, field.descriptor) {
                $(($first..=$last, $descriptor)
                    if $layouts == 1 || field.has_layout_of::<$type>() => Index::$variant,)*
                _ => return None,
            })
        }
    };
}

/// Adds commands to a request; other fields are errors.
macro_rules! add_to {
    (Command, $request:ident, $field:ident) => {
        Some($request.add($field).map(Ticket::untyped))
    };
    ($role:ident, $request:ident, $field:ident) => {{
        let _ = $field;
        None
    }};
}

/// The fields that a device supports, with the functions that it takes.
macro_rules! supported {
    ($($set:literal $descriptor:literal $name:literal [$($function:ident)*] $evidence:expr;)*) => {
        &[$($crate::devices::Supported {
            set: $set,
            descriptor: $descriptor,
            name: $name,
            functions: &[$($crate::protocol::FunctionSelector::$function),*],
            evidence: $evidence,
        }),*]
    };
}

//! The tables of all fields and devices.

/// All fields, by their family's descriptor sets: their descriptions, and a type that can hold any
/// of them.
macro_rules! registry {
    ($(
        #[cfg($when:meta)]
        $($first:literal $(..= $last:literal)?)|+ => {
            $(
                $(#[$meta:meta])*
                $variant:ident($type:ty):
                $role:ident $descriptor:literal, of $layouts:literal,
                $name:literal, $title:literal,
                $({ $($set:literal $its_name:literal $($its_title:literal)?,)+ })?
                [$($linked:literal),*], { $($parameters:tt)* };
            )*
        }
    )*) => {
        /// The descriptions of all fields.
        pub static FIELDS: &[FieldInfo] = &[$($(
            #[cfg($when)]
            <$type as Listed>::INFO,
        )*)*];

        /// Their parameters, in the same order; separate, so that only a program that uses them
        /// contains them.
        pub(super) static PARAMETERS: &[&[ParameterInfo]] = &[$($(
            #[cfg($when)]
            <$type as Listed>::PARAMETERS,
        )*)*];

        /// A field of any type.
        ///
        /// It is as large as the largest field, several hundred bytes, so borrow it rather than
        /// move it. A [`Visitor`] avoids this, because it is called with each field's own type.
        ///
        /// With `serde`, it is its name and value in human-readable formats. In others it is a set,
        /// a descriptor and bytes, which later versions of this crate read, too.
        #[derive(Clone, Debug, PartialEq)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[non_exhaustive]
        pub enum AnyField {
            $($(
                #[cfg($when)]
                $(#[$meta])*
                $variant($type),
            )*)*
        }

        #[cfg(feature = "serde")]
        impl AnyField {
            pub(crate) fn write_named<S: serde::Serializer>(
                &self,
                serializer: S,
            ) -> Result<S::Ok, S::Error> {
                match self {$($(
                    #[cfg($when)]
                    Self::$variant(value) => {
                        serializer.serialize_newtype_variant("AnyField", 0, $name, value)
                    }
                )*)*}
            }

            pub(crate) fn read_named<'de, A: serde::de::VariantAccess<'de>>(
                name: &str,
                value: A,
            ) -> Result<Self, A::Error> {
                match name {
                    $($(
                        #[cfg($when)]
                        $name => value.newtype_variant().map(Self::$variant),
                    )*)*
                    _ => Err(serde::de::Error::custom("unknown field")),
                }
            }
        }

        $($(
            #[cfg($when)]
            impl bounds::Sealed for $type {}

            #[cfg($when)]
            #[doc(hidden)]
            impl Listed for $type {
                #[inline]
                fn into_any(self) -> AnyField {
                    AnyField::$variant(self)
                }

                const INFO: FieldInfo = FieldInfo {
                    sets: <$type as Field>::SETS,
                    descriptor: $descriptor,
                    role: Role::$role,
                    name: $name,
                    title: $title,
                    linked: &[$($linked),*],
                    occurrences: &[$($(Occurrence {
                        set: DescriptorSet($set),
                        name: $its_name,
                        title: own!($title $(, $its_title)?),
                    }),+)?],
                };

                const PARAMETERS: &'static [ParameterInfo] = parameters! { $($parameters)* };
            }

            #[cfg($when)]
            #[doc(hidden)]
            impl From<$type> for AnyField {
                #[inline]
                fn from(field: $type) -> Self {
                    Self::$variant(field)
                }
            }
        )*)*

        /// Field types as numbers, to select each with one jump.
        #[derive(Clone, Copy)]
        #[repr(u16)]
        enum Id {
            Unknown,
            $($(#[cfg($when)] $variant,)*)*
        }

        /// The rows of the table: each set of a family, or the range of all sets of a kind.
        const ROWS: &[&[(u8, u8)]] = &[$(
            #[cfg($when)]
            &[$(($first, $crate::bits::last!($first $(, $last)?)),)+],
        )*];

        /// The sets and the descriptor of each type.
        const TYPES: &[(Id, &[DescriptorSet], u8)] = &[$($(
            #[cfg($when)]
            (Id::$variant, <$type as Field>::SETS, $descriptor),
        )*)*];

        /// The types of the descriptors of each row; if there are several layouts, the first one.
        /// The first row is for unknown sets.
        #[allow(clippy::indexing_slicing, clippy::arithmetic_side_effects)] // evaluated at compile time
        static TABLE: [[Id; 256]; count(ROWS) + 1] = {
            const PLACES: [u8; 256] = rows(ROWS);
            let (mut ids, mut at) = ([[Id::Unknown; 256]; count(ROWS) + 1], 0);
            while at < TYPES.len() {
                let (id, sets, descriptor) = TYPES[at];
                let mut i = 0;
                while i < sets.len() {
                    let row = PLACES[sets[i].0 as usize] as usize;
                    if let Id::Unknown = ids[row][descriptor as usize] {
                        ids[row][descriptor as usize] = id;
                    }
                    i += 1;
                }
                at += 1;
            }
            ids
        };

        /// The types of the descriptors of each set.
        #[allow(clippy::indexing_slicing, clippy::arithmetic_side_effects)] // evaluated at compile time
        static IDS: [&[Id; 256]; 256] = {
            const PLACES: [u8; 256] = rows(ROWS);
            let (mut ids, mut set) = ([&TABLE[0]; 256], 0);
            while set < ids.len() {
                ids[set] = &TABLE[PLACES[set] as usize];
                set += 1;
            }
            ids
        };

        #[inline]
        fn ids(set: DescriptorSet) -> &'static [Id; 256] {
            let [unknown, ..] = &TABLE;
            IDS.get(usize::from(set.0)).copied().unwrap_or(unknown)
        }

        /// The functions that call a visitor for each type, by the type's number: one jump, and
        /// less code than a match.
        ///
        /// The parts of a field are passed in registers; a field is created in memory only if the
        /// visitor needs it.
        struct Visits<V>(core::marker::PhantomData<V>);

        impl<V: Visitor> Visits<V> {
            const ALL: [fn(&[u8], u8, DescriptorSet, V) -> V::Output; TYPES.len() + 1] = [
                visit_unknown,
                $($(
                    #[cfg($when)]
                    if $layouts > 1 { visit_layouts } else { visit_as::<V, $type> },
                )*)*
            ];
        }

        /// Calls the visitor with the type of a field; if there are several layouts, with the one
        /// that fits the data.
        #[inline] // so that the row is looked up once for all fields of a packet
        pub fn visit<V: Visitor>(field: &RawField<'_>, visitor: V) -> V::Output {
            let RawField { set, descriptor, data } = *field;
            let id = ids(set).get(usize::from(descriptor)).copied().unwrap_or(Id::Unknown);
            let visit = Visits::ALL.get(id as usize).copied().unwrap_or(visit_unknown);
            visit(data, descriptor, set, visitor)
        }

        fn visit_as<V: Visitor, T: Listed>(
            data: &[u8],
            descriptor: u8,
            set: DescriptorSet,
            visitor: V,
        ) -> V::Output {
            visitor.visit::<T>(&RawField { set, descriptor, data })
        }

        fn visit_unknown<V: Visitor>(
            data: &[u8],
            descriptor: u8,
            set: DescriptorSet,
            visitor: V,
        ) -> V::Output {
            visitor.unknown(&RawField { set, descriptor, data })
        }

        /// Calls the visitor for a descriptor with several layouts.
        fn visit_layouts<V: Visitor>(
            data: &[u8],
            descriptor: u8,
            set: DescriptorSet,
            visitor: V,
        ) -> V::Output {
            let field = &RawField { set, descriptor, data };
            $($(
                #[cfg($when)]
                if $layouts > 1 && field.is::<$type>() {
                    return visitor.visit::<$type>(field);
                }
            )*)*
            visitor.unknown(field)
        }

        // Inline, so that they are compiled only in programs that use them: they contain the codecs
        // of all fields, and take longer to compile than the rest of the crate.
        impl AnyField {
            /// Encodes the field's data into the front of the buffer, and returns its length.
            ///
            /// # Errors
            ///
            /// A value is missing or does not fit, or the buffer is too short.
            #[inline]
            pub fn encode(&self, buffer: &mut [u8]) -> Result<usize, EncodeError> {
                let mut writer = Writer::of_field(buffer);
                let done = match self {
                    $($(
                        #[cfg($when)]
                        Self::$variant(field) => field.encode_to(&mut writer),
                    )*)*
                };
                writer.finish(done, self.info().name)
            }

            /// Adds the field to a request, if it is a command.
            #[inline]
            #[allow(unused_variables)] // if there are no commands
            pub(crate) fn add_to(
                &self,
                request: &mut Request<'_>,
            ) -> Option<Result<Ticket<()>, RequestError>> {
                match self {
                    $($(
                        #[cfg($when)]
                        Self::$variant(field) => add_to!($role, request, field),
                    )*)*
                }
            }

            /// Returns the description of the field.
            #[must_use]
            pub const fn info(&self) -> &'static FieldInfo {
                match self {
                    $($(
                        #[cfg($when)]
                        Self::$variant(_) => &<$type as Listed>::INFO,
                    )*)*
                }
            }

            /// Converts the field to a tree of values.
            #[cfg(feature = "dynamic")]
            #[inline]
            #[must_use]
            pub fn to_value(&self) -> crate::dynamic::Value {
                use crate::dynamic::ToValue;
                match self {
                    $($(
                        #[cfg($when)]
                        Self::$variant(field) => field.to_value(),
                    )*)*
                }
            }

            /// Converts a tree of values to the field with this name, which may be its name in one
            /// of its sets.
            ///
            /// # Errors
            ///
            /// There is no such field, or the tree does not contain its values.
            #[cfg(feature = "dynamic")]
            #[inline]
            pub fn from_value(
                name: &str,
                value: &crate::dynamic::Value,
            ) -> Result<Self, crate::dynamic::ValueError> {
                match FieldInfo::by_name(name).map_or("", |info| info.name) {
                    $($(
                        #[cfg($when)]
                        $name => from_value::<$type>(value),
                    )*)*
                    _ => Err(crate::dynamic::ValueError::Unknown),
                }
            }
        }
    };
}

/// The descriptions of values: name, elements, units, frame, and members.
macro_rules! parameters {
    ($(
        $name:literal
        $(: [$($element:literal)*])?
        $(in [$($unit:literal)*])?
        $(of $frame:literal)?
        $({ $($members:tt)* })?;
    )*) => {
        &[$(ParameterInfo {
            name: $name,
            elements: &[$($($element),*)?],
            units: &[$($($unit),*)?],
            frame: optional!($($frame)?),
            members: parameters! { $($($members)*)? },
        }),*]
    };
}

/// A set's own text, or the text for all sets.
macro_rules! own {
    ($common:literal) => {
        $common
    };
    ($common:literal, $own:literal) => {
        $own
    };
}

macro_rules! optional {
    () => {
        None
    };
    ($value:literal) => {
        Some($value)
    };
}

/// Adds a command to a request; `None` for other fields.
macro_rules! add_to {
    (Command, $request:ident, $field:ident) => {
        Some($request.add($field).map(Ticket::of))
    };
    ($role:ident, $request:ident, $field:ident) => {{
        let _ = $field;
        None
    }};
}

/// The fields that a device supports, with the functions that it accepts.
macro_rules! supported {
    ($($set:literal $descriptor:literal $name:literal [$($function:ident)*] $evidence:expr;)*) => {
        &[$($crate::devices::Supported {
            set: $crate::DescriptorSet($set),
            descriptor: $descriptor,
            name: $name,
            functions: &[$($crate::protocol::FunctionSelector::$function),*],
            evidence: $evidence,
        }),*]
    };
}

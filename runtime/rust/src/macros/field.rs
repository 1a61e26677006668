//! Fields: their sets and descriptors, and the responses to commands.

/// Implements the traits of a field, from the descriptor sets in which it occurs (one, several, or
/// a range), the constants and sizes that distinguish it from others with its descriptor, and the
/// commands that a response answers.
macro_rules! field {
    (
        $name:ident: $descriptor:literal, $text:literal;
        in [$($sets:tt)+];
        $(constants $([$offset:literal: $($byte:literal)+])+;)?
        $(sizes $sizes:expr;)?
        $(answers $($command:ident)+;)?
    ) => {
        impl $crate::Field for $name {
            sets! { $($sets)+ }
            const DESCRIPTOR: u8 = $descriptor;
            const NAME: &'static str = $text;
            $(const CONSTANTS: &'static [(usize, &'static [u8])] = &[$(($offset, &[$($byte),+])),+];)?
            $(const SIZES: core::ops::RangeInclusive<usize> = $sizes;)?
        }

        one_set! { $name $($sets)+ }

        $($(impl $crate::ResponseOf<$command> for $name {})+)?
    };
}

/// The members of [`Field`](crate::Field) on descriptor sets.
macro_rules! sets {
    ($first:literal..=$last:literal) => {
        const SETS: &'static [$crate::DescriptorSet] = &$crate::field::run::<{ $last - $first + 1 }>($first);

        #[inline]
        fn occurs_in(set: $crate::DescriptorSet) -> bool {
            matches!(set.0, $first..=$last)
        }
    };
    ($($set:literal)+) => {
        const SETS: &'static [$crate::DescriptorSet] = &[$($crate::DescriptorSet($set)),+];

        #[inline]
        fn occurs_in(set: $crate::DescriptorSet) -> bool {
            matches!(set.0, $($set)|+)
        }
    };
}

/// A field that occurs in a single set has a constant for it.
macro_rules! one_set {
    ($name:ident $set:literal) => {
        impl $crate::OneSet for $name {
            const SET: $crate::DescriptorSet = $crate::DescriptorSet($set);
        }
    };
    ($name:ident $($several:tt)+) => {};
}

/// Implements `Command`, from the command's response, the responses for its functions, the layouts
/// of a response, and the condition under which the device does not answer.
macro_rules! command {
    (
        $name:ident -> $response:ty;
        $(for $($function:ident)+ -> $its_response:ty;)*
        $(responds $($reply:ident)|+ $(for $($asked:ident)+)? $(, if $($part:ident = $is:expr),+)?;)*
        $(silent for $($mute:ident)+;)?
        $(silent if $($member:ident = $value:expr),+;)?
        $(timeout $milliseconds:literal;)?
        $(checks $ranges:ident;)?
    ) => {
        impl $crate::Command for $name {
            type Response = $response;
            $(const TIMEOUT_MS: Option<u32> = Some($milliseconds);)?

            $(
                fn check(&self) -> Result<(), $crate::RangeError> {
                    $crate::range::$ranges::check_in(self, <Self as $crate::Field>::NAME)
                }
            )?

            #[inline]
            fn expects_reply(&self) -> bool {
                true
                    $(&& !matches!(self.function, $($crate::protocol::FunctionSelector::$mute)|+))?
                    $(&& !($(self.$member == $value)&&+))?
            }

            #[inline]
            fn response_check(&self) -> Option<$crate::ResponseCheck> {
                $(
                    if true
                        $(&& matches!(self.function, $($crate::protocol::FunctionSelector::$asked)|+))?
                        $($(&& self.$part == $is)+)?
                    {
                        return Some(check!($($reply)+));
                    }
                )*
                None
            }
        }

        calls! { $name $($($function)+ -> $its_response;)* }
    };
}

/// The responses to a command with a function selector.
macro_rules! calls {
    ($name:ident) => {};
    ($name:ident $($($function:ident)+ -> $response:ty;)+) => {
        $(takes! { $name $response: $($function)+ })+

        impl<const FUNCTION: u8> From<$crate::Call<$name, FUNCTION>> for $name {
            #[inline]
            fn from(call: $crate::Call<$name, FUNCTION>) -> Self {
                call.into_command()
            }
        }
    };
}

macro_rules! takes {
    ($name:ident $response:ty: $($function:ident)+) => {$(
        #[doc(hidden)]
        impl $crate::Takes<{ $crate::protocol::FunctionSelector::$function.0 }> for $name {
            type Response = $response;
        }
    )+};
}

/// A check for a response that may have several layouts.
macro_rules! check {
    ($reply:ident) => {
        $crate::field::check::<$reply>
    };
    ($($reply:ident)+) => {
        |field| {
            $(
                if let Some(decodes) = $crate::field::check::<$reply>(field) {
                    return Some(decodes);
                }
            )+
            None
        }
    };
}

/// The types of a command's responses, if there are several.
macro_rules! responses {
    (
        $(#[$meta:meta])*
        pub enum $name:ident {
            $($(#[$variant_meta:meta])* $variant:ident($field:ident),)*
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[non_exhaustive]
        pub enum $name {
            $($(#[$variant_meta])* $variant($field),)*
        }

        impl $crate::Response for $name {
            const DESCRIPTORS: &'static [u8] = &[$(<$field as $crate::Field>::DESCRIPTOR),*];

            #[inline]
            fn from_field(
                field: &$crate::RawField<'_>,
            ) -> Option<Result<Self, $crate::DecodeError>> {
                $(
                    if let Some(found) = <$field as $crate::Response>::from_field(field) {
                        return Some(found.map(Self::$variant));
                    }
                )*
                None
            }
        }
    };
}

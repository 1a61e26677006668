//! The macros that turn generated types into trees of values and back.

/// A record: its members, then its values in the order of the wire.
macro_rules! record {
    (
        $type:ty { $($member:ident),* $(,)? }
        $($name:literal => $kind:ident($($argument:tt)*);)*
    ) => {
        impl $crate::dynamic::ToValue for $type {
            fn to_value(&self) -> $crate::dynamic::Value {
                #[allow(unused_mut)]
                let mut record = $crate::dynamic::Record::new();
                $($crate::dynamic::macros::put!($kind self record $name $($argument)*);)*
                $crate::dynamic::Value::Record(record)
            }
        }

        impl $crate::dynamic::FromValue for $type {
            fn from_value(
                value: &$crate::dynamic::Value,
            ) -> ::core::result::Result<Self, $crate::dynamic::ValueError> {
                let _record = value.record(&[$($name),*])?;
                $($crate::dynamic::macros::take!($kind _record $name $($argument)*);)*
                ::core::result::Result::Ok(Self { $($member),* })
            }
        }
    };
}

macro_rules! put {
    (value $self:ident $record:ident $name:literal $member:ident) => {
        $record.put($name, &$self.$member)
    };
    (some_value $self:ident $record:ident $name:literal $member:ident) => {
        $record.put_some($name, &$self.$member)
    };
    (counter $self:ident $record:ident $name:literal $array:ident, $array_name:literal) => {
        $record.put_count($name, Some($self.$array.len()))
    };
    (some_counter $self:ident $record:ident $name:literal $array:ident, $array_name:literal) => {
        $record.put_count($name, $self.$array.map(|items| items.len()))
    };
    (union $self:ident $record:ident $name:literal $member:ident, $($rest:tt)*) => {
        $record.put($name, &$self.$member)
    };
    (some_union $self:ident $record:ident $name:literal $member:ident, $($rest:tt)*) => {
        $record.put_some($name, &$self.$member)
    };
}

macro_rules! take {
    (value $record:ident $name:literal $member:ident) => {
        let $member = $record.take($name)?;
    };
    (some_value $record:ident $name:literal $member:ident) => {
        let $member = $record.take_some($name)?;
    };
    (counter $record:ident $name:literal $array:ident, $array_name:literal) => {
        $record.check_count($name, $array_name)?;
    };
    (some_counter $record:ident $name:literal $array:ident, $array_name:literal) => {
        $record.check_some_count($name, $array_name)?;
    };
    (union $record:ident $name:literal $member:ident, $tag:ident, $union:ty) => {
        let $member = <$union>::of_value($tag, $record.need($name)?)?;
    };
    (some_union $record:ident $name:literal $member:ident, $tag:ident, $union:ty) => {
        let $member = match $record.get($name) {
            Some(value) => {
                let tag = Option::from($tag).ok_or($crate::dynamic::ValueError::Missing)?;
                Some(<$union>::of_value(tag, value)?)
            }
            None => None,
        };
    };
}

/// A union: its alternatives by the values of its tag, with the names of their members.
macro_rules! union {
    (
        $type:ty, $tag:ty;
        $($value:ident => $variant:ident $(($name:literal))?;)*
    ) => {
        impl $crate::dynamic::ToValue for $type {
            fn to_value(&self) -> $crate::dynamic::Value {
                #[allow(unused_mut)]
                let mut record = $crate::dynamic::Record::new();
                match self {
                    $($(Self::$variant(value) => record.put($name, value),)?)*
                    _ => {}
                }
                $crate::dynamic::Value::Record(record)
            }
        }

        impl $type {
            pub(crate) fn of_value(
                tag: $tag,
                value: &$crate::dynamic::Value,
            ) -> ::core::result::Result<Self, $crate::dynamic::ValueError> {
                match tag {
                    $(<$tag>::$value => $crate::dynamic::macros::variant!(value $variant $($name)?),)*
                    other => value.no_member().map(|()| Self::Other(other)),
                }
            }
        }
    };
}

macro_rules! variant {
    ($value:ident $variant:ident) => {
        $value.no_member().map(|()| Self::$variant)
    };
    ($value:ident $variant:ident $name:literal) => {
        $value.member($name).map(Self::$variant)
    };
}

pub(crate) use {put, record, take, union, variant};

//! Converts the steps of a record, which [`record!`] describes, to trees of values and back.

macro_rules! tree {
    ($name:ident { $($member:ident)* } $([$($step:tt)*])*) => {
        #[doc(hidden)]
        impl $crate::dynamic::ToValue for $name {
            fn to_value(&self) -> $crate::dynamic::Value {
                let Self { $($member),* } = self;
                #[allow(unused_mut)]
                let mut record = $crate::dynamic::Record::new();
                $(put!(record $($step)*);)*
                $crate::dynamic::Value::Record(record)
            }
        }

        #[doc(hidden)]
        impl $crate::dynamic::FromValue for $name {
            fn from_value(
                value: &$crate::dynamic::Value,
            ) -> Result<Self, $crate::dynamic::ValueError> {
                #[allow(unused_variables)]
                let record = value.record(&[$(names!($($step)*)),*])?;
                $(take!(record $($step)*);)*
                Ok(Self { $($member),* })
            }
        }
    };
}

/// The names of the values of a step.
macro_rules! names {
    (
        ($($member:ident),*)
        $(optional)? $(for $($function:ident)+)? { $([$($step:tt)*])* }
    ) => {
        &[$(value_name!($($step)*)),*]
    };
    ($($step:tt)*) => {
        &[value_name!($($step)*)]
    };
}

/// The name of the value of a step; a constant has none.
macro_rules! value_name {
    ($constant:ident: $number:ident = $value:literal) => {
        ""
    };
    ($value:ident $name:literal $($rest:tt)*) => {
        $name
    };
    ($value:ident $($rest:tt)*) => {
        stringify!($value)
    };
}

/// Puts the values of a step into a tree.
macro_rules! put {
    (
        $record:ident $member:ident $($name:literal)?
        $(selects)? $(by $count:ident)? $(as $tag:ident)?
    ) => {
        $record.put(spec_name!($member $($name)?), $member);
    };
    (
        $record:ident $count:ident $($name:literal)?: $number:ident
        counts $list:ident $($list_name:literal)?
    ) => {
        $record.put_count(spec_name!($count $($name)?), Some($list.len()));
    };
    ($record:ident $constant:ident: $number:ident = $value:literal) => {};
    (
        $record:ident $member:ident $($name:literal)? $(as $tag:ident)?
        $(optional)? $(for $($function:ident)+)?
    ) => {
        put_some!($record $member $($name)?);
    };
    (
        $record:ident ($($member:ident),*)
        $(optional)? $(for $($function:ident)+)? { $([$($step:tt)*])* }
    ) => {
        $(put_some!($record $($step)*);)*
    };
}

/// Like `put`, for values that may be absent.
macro_rules! put_some {
    ($record:ident $member:ident $($name:literal)? $(by $count:ident)?) => {
        $record.put_some(spec_name!($member $($name)?), $member);
    };
    (
        $record:ident $count:ident $($name:literal)?: $number:ident
        counts $list:ident $($list_name:literal)?
    ) => {
        let count = $list.as_ref().map(|list| list.len());
        $record.put_count(spec_name!($count $($name)?), count);
    };
    ($record:ident $constant:ident: $number:ident = $value:literal) => {};
}

/// Converts the values of a step from a tree, into variables with the names of the members.
macro_rules! take {
    ($record:ident $member:ident $($name:literal)? $(selects)? $(by $count:ident)?) => {
        let $member = $record.take(spec_name!($member $($name)?))?;
    };
    ($record:ident $member:ident $($name:literal)? as $tag:ident) => {
        let $member = $record.take_union(spec_name!($member $($name)?), $tag)?;
    };
    (
        $record:ident $count:ident $($name:literal)?: $number:ident
        counts $list:ident $($list_name:literal)?
    ) => {
        $record.check_count(spec_name!($count $($name)?), spec_name!($list $($list_name)?))?;
    };
    ($record:ident $constant:ident: $number:ident = $value:literal) => {};
    (
        $record:ident $member:ident $($name:literal)? as $tag:ident
        $(optional)? $(for $($function:ident)+)?
    ) => {
        let $member = $record.take_some_union(spec_name!($member $($name)?), $tag)?;
    };
    ($record:ident $member:ident $($name:literal)? $(optional)? $(for $($function:ident)+)?) => {
        take_some!($record $member $($name)?);
    };
    (
        $record:ident ($($member:ident),*)
        $(optional)? $(for $($function:ident)+)? { $([$($step:tt)*])* }
    ) => {
        $(take_some!($record $($step)*);)*
    };
}

/// Like `take`, for values that may be absent.
macro_rules! take_some {
    ($record:ident $member:ident $($name:literal)? $(by $count:ident)?) => {
        let $member = $record.take_some(spec_name!($member $($name)?))?;
    };
    (
        $record:ident $count:ident $($name:literal)?: $number:ident
        counts $list:ident $($list_name:literal)?
    ) => {
        $record.check_some_count(spec_name!($count $($name)?), spec_name!($list $($list_name)?))?;
    };
    ($record:ident $constant:ident: $number:ident = $value:literal) => {};
}

macro_rules! union_tree {
    ($name:ident $tag:ty; $($value:ident $variant:ident $($text:literal)?;)*) => {
        #[doc(hidden)]
        impl $crate::dynamic::ToValue for $name {
            fn to_value(&self) -> $crate::dynamic::Value {
                #[allow(unused_mut)]
                let mut record = $crate::dynamic::Record::new();
                match self {
                    $($(Self::$variant(value) => record.put($text, value),)?)*
                    _ => {}
                }
                $crate::dynamic::Value::Record(record)
            }
        }

        #[doc(hidden)]
        impl $crate::dynamic::Alternative for $name {
            fn of_value(
                tag: $tag,
                value: &$crate::dynamic::Value,
            ) -> Result<Self, $crate::dynamic::ValueError> {
                match tag {
                    $(<$tag>::$value => alternative!(value $variant $($text)?),)*
                    other => value.no_member().map(|()| Self::Other(other)),
                }
            }
        }
    };
}

macro_rules! alternative {
    ($value:ident $variant:ident) => {
        $value.no_member().map(|()| Self::$variant)
    };
    ($value:ident $variant:ident $name:literal) => {
        $value.member($name).map(Self::$variant)
    };
}

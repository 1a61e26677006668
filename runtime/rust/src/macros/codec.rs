//! Reads and writes the steps of a record, which [`record!`] describes.

/// Is a value required by the selected function? Without functions, the value is optional.
macro_rules! required {
    ($selected:ident) => {
        false
    };
    ($selected:ident $($function:ident)+) => {
        matches!($selected, $($crate::protocol::FunctionSelector::$function)|+)
    };
}

/// Reads a step into variables with the names of the members.
macro_rules! decode {
    ($reader:ident $selected:ident $member:ident $($name:literal)?) => {
        let $member = $reader.read()?;
    };
    ($reader:ident $selected:ident $member:ident $($name:literal)? selects) => {
        let $member = $reader.read()?;
        let $selected = $member;
    };
    ($reader:ident $selected:ident $member:ident $($name:literal)? by $count:ident) => {
        let $member = $reader.counted($count)?;
    };
    ($reader:ident $selected:ident $member:ident $($name:literal)? as $tag:ident) => {
        let $member = $reader.union($tag)?;
    };
    (
        $reader:ident $selected:ident $count:ident $($name:literal)?: $number:ident
        counts $list:ident $($list_name:literal)?
    ) => {
        let $count: $number = $reader.read()?;
    };
    ($reader:ident $selected:ident $constant:ident: $number:ident = $value:literal) => {
        $reader.constant::<$number>($value)?;
    };
    (
        $reader:ident $selected:ident $member:ident $($name:literal)? as $tag:ident
        $(optional)? $(for $($function:ident)+)?
    ) => {
        let $member = $reader.some_union(required!($selected $($($function)+)?), $tag)?;
    };
    (
        $reader:ident $selected:ident $member:ident $($name:literal)?
        $(optional)? $(for $($function:ident)+)?
    ) => {
        let $member = $reader.some(required!($selected $($($function)+)?))?;
    };
    (
        $reader:ident $selected:ident ($($member:ident),*)
        $(optional)? $(for $($function:ident)+)? { $([$($step:tt)*])* }
    ) => {
        let group = $reader.group(required!($selected $($($function)+)?), |$reader| {
            $(decode!($reader $selected $($step)*);)*
            Ok(($($member,)*))
        })?;
        let ($($member,)*) = match group {
            Some(($($member,)*)) => ($(Some($member),)*),
            None => ::core::default::Default::default(),
        };
    };
}

/// Names the member of an error.
macro_rules! named {
    ($writer:ident $member:ident $($name:literal)?) => {
        |kind| $writer.in_member(kind, spec_name!($member $($name)?))
    };
}

/// Writes a step from references with the names of the members.
macro_rules! encode {
    ($writer:ident $selected:ident $member:ident $($name:literal)? $(by $count:ident)?) => {
        $writer.write($member)?;
    };
    ($writer:ident $selected:ident $member:ident $($name:literal)? selects) => {
        $writer.write($member)?;
        let $selected = *$member;
    };
    ($writer:ident $selected:ident $member:ident $($name:literal)? as $tag:ident) => {
        $writer.union(*$tag, $member).map_err(named!($writer $member $($name)?))?;
    };
    (
        $writer:ident $selected:ident $count:ident $($name:literal)?: $number:ident
        counts $list:ident $($list_name:literal)?
    ) => {
        $writer.count::<$number>($list.len()).map_err(named!($writer $list $($list_name)?))?;
    };
    ($writer:ident $selected:ident $constant:ident: $number:ident = $value:literal) => {
        $writer.write::<$number>(&$value)?;
    };
    (
        $writer:ident $selected:ident $member:ident $($name:literal)? as $tag:ident
        $(optional)? $(for $($function:ident)+)?
    ) => {
        $writer
            .some_union(required!($selected $($($function)+)?), *$tag, $member)
            .map_err(named!($writer $member $($name)?))?;
    };
    (
        $writer:ident $selected:ident $member:ident $($name:literal)?
        $(optional)? $(for $($function:ident)+)?
    ) => {
        $writer
            .some(required!($selected $($($function)+)?), $member)
            .map_err(named!($writer $member $($name)?))?;
    };
    (
        $writer:ident $selected:ident ($($member:ident),*)
        $(optional)? $(for $($function:ident)+)? { $([$($step:tt)*])* }
    ) => {
        let present = [$($member.is_some()),*];
        let group = $writer.group(required!($selected $($($function)+)?), present);
        group.map_err(|kind| {
            let names = [$(stringify!($member)),*];
            let missing = names.iter().zip(present).find(|(_, is_present)| !is_present);
            $writer.in_member(kind, missing.map_or("", |(name, _)| name))
        })?;
        if let ($(Some($member),)*) = ($($member,)*) {
            $(encode!($writer $selected $($step)*);)*
        }
    };
}

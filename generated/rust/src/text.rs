//! Text: one byte per character (Latin-1), usually padded with spaces.

use core::fmt::{self, Write as _};
use core::str;

use crate::codec::{Counted, Reader, Wire, Writer};
use crate::error::{EncodeErrorKind, ReadError};
use crate::list::{Item, List};

/// Exactly `N` characters.
///
/// ```
/// use mip_protocol::Text;
///
/// let text = Text::<8>::padded("GX5-15").unwrap();
/// assert_eq!(&text.0, b"GX5-15  ");
/// assert_eq!(text.as_str(), Ok("GX5-15"));
/// assert_eq!(text.to_string(), "GX5-15");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Text<const N: usize>(pub [u8; N]);

/// At most `N` characters.
///
/// ```
/// use mip_protocol::{Text, VarText};
///
/// let text = VarText::<8>::new("GX5-15").unwrap();
/// assert_eq!((text.len(), text.as_str()), (6, Ok("GX5-15")));
/// assert_eq!(Text::from(text), Text::padded("GX5-15").unwrap());
/// ```
#[derive(Clone, Default, PartialEq, Eq, Hash)]
pub struct VarText<const N: usize>(pub List<u8, N>);

impl<const N: usize> Text<N> {
    /// Pads a text with spaces; returns `None` if it is too long or not Latin-1.
    #[must_use]
    pub fn padded(text: &str) -> Option<Self> {
        let mut bytes = [b' '; N];
        let mut free = bytes.iter_mut();
        for c in text.chars() {
            *free.next()? = u8::try_from(u32::from(c)).ok()?;
        }
        Some(Self(bytes))
    }
}

/// Pads the text with spaces to exactly `N` characters.
impl<const N: usize> From<VarText<N>> for Text<N> {
    fn from(text: VarText<N>) -> Self {
        let mut bytes = [b' '; N];
        bytes.iter_mut().zip(text.0.as_slice()).for_each(|(to, from)| *to = *from);
        Self(bytes)
    }
}

impl<const N: usize> VarText<N> {
    /// Converts a text; returns `None` if it is too long or not Latin-1.
    #[must_use]
    pub fn new(text: &str) -> Option<Self> {
        let mut list = List::new();
        for c in text.chars() {
            list.push(u8::try_from(u32::from(c)).ok()?).ok()?;
        }
        Some(Self(list))
    }

    /// Returns the number of characters.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Is it empty?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

/// What both kinds of text have.
macro_rules! text {
    ($name:ident) => {
        impl<const N: usize> $name<N> {
            /// Returns the text without the spaces and zeros at its end.
            ///
            /// Leading spaces remain; some devices align serial numbers with them.
            ///
            /// # Errors
            ///
            /// The text is neither ASCII nor UTF-8.
            pub fn as_str(&self) -> Result<&str, str::Utf8Error> {
                str::from_utf8(trimmed(self.0.as_slice()))
            }

            /// Returns all characters, including the padding.
            #[must_use]
            pub fn chars(&self) -> impl DoubleEndedIterator<Item = char> + '_ {
                self.0.iter().map(|b| char::from(*b))
            }
        }

        impl<const N: usize> fmt::Display for $name<N> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                Latin1(trimmed(self.0.as_slice())).fmt(f)
            }
        }

        impl<const N: usize> fmt::Debug for $name<N> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("\"")?;
                self.chars().try_for_each(|c| write!(f, "{}", c.escape_debug()))?;
                f.write_str("\"")
            }
        }

        /// Serializes all characters, including the padding, so that decoding restores the text
        /// exactly.
        #[cfg(feature = "serde")]
        impl<const N: usize> serde::Serialize for $name<N> {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.collect_str(&Latin1(self.0.as_slice()))
            }
        }

        #[cfg(feature = "defmt")]
        impl<const N: usize> defmt::Format for $name<N> {
            fn format(&self, f: defmt::Formatter<'_>) {
                defmt::write!(f, "{=[u8]:a}", self.0.as_slice());
            }
        }
    };
}

text!(Text);
text!(VarText);

/// Characters of one byte.
struct Latin1<'a>(&'a [u8]);

impl fmt::Display for Latin1<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|b| f.write_char(char::from(*b)))
    }
}

fn trimmed(bytes: &[u8]) -> &[u8] {
    let end = bytes.iter().rposition(|b| !matches!(b, b' ' | 0));
    let length = end.map_or(0, |last| last.saturating_add(1));
    bytes.get(..length).unwrap_or_default()
}

impl<const N: usize> Default for Text<N> {
    fn default() -> Self {
        Self([b' '; N])
    }
}

impl<const N: usize> Item for Text<N> {
    const BLANK: Self = Self([b' '; N]);
}

impl<const N: usize> Item for VarText<N> {
    const BLANK: Self = Self(List::new());
}

impl<const N: usize> Wire for Text<N> {
    const SIZE: usize = N;
    const FIXED: bool = true;

    #[inline(always)]
    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, ReadError> {
        reader.bytes().map(Self)
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeErrorKind> {
        writer.put(&self.0)
    }
}

/// Encodes only the characters. A counter is another value of the field.
impl<const N: usize> Wire for VarText<N> {
    const SIZE: usize = N;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, ReadError> {
        reader.read().map(Self)
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeErrorKind> {
        writer.write(&self.0)
    }
}

impl<const N: usize> Counted for VarText<N> {
    fn decode_counted(count: usize, reader: &mut Reader<'_>) -> Result<Self, ReadError> {
        reader.counted(u64::try_from(count).unwrap_or(u64::MAX)).map(Self)
    }
}

#[cfg(feature = "serde")]
mod serde_text {
    use super::{fmt, Text, VarText};
    use serde::{de, Deserialize, Deserializer};

    struct Visitor<const N: usize>;

    impl<const N: usize> de::Visitor<'_> for Visitor<N> {
        type Value = VarText<N>;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(f, "at most {N} Latin-1 characters")
        }

        fn visit_str<E: de::Error>(self, text: &str) -> Result<VarText<N>, E> {
            VarText::new(text).ok_or_else(|| E::invalid_value(de::Unexpected::Str(text), &self))
        }
    }

    impl<'de, const N: usize> Deserialize<'de> for VarText<N> {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            deserializer.deserialize_str(Visitor)
        }
    }

    impl<'de, const N: usize> Deserialize<'de> for Text<N> {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            VarText::<N>::deserialize(deserializer).map(Self::from)
        }
    }
}

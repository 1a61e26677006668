//! Arrays whose length varies, without a heap.

use core::{fmt, ops};

use crate::codec::{Counted, DecodeError, EncodeError, Reader, Wire, Writer};

/// At most `N` items, kept in place. It is a slice for nearly all purposes.
///
/// ```
/// use mip_protocol::List;
///
/// let mut list: List<u16, 4> = [1, 2, 3].into();
/// assert!(list.push(4).is_ok());
/// assert!(list.push(5).is_err());
/// assert_eq!(list.iter().sum::<u16>(), 10);
/// ```
#[derive(Clone, Copy)]
pub struct List<T, const N: usize> {
    items: [T; N],
    length: usize,
}

/// There are more items than the list can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CapacityError;

impl fmt::Display for CapacityError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("there are more items than the list can hold")
    }
}

#[cfg(feature = "std")]
impl std::error::Error for CapacityError {}

impl<T: Copy + Default, const N: usize> List<T, N> {
    /// An empty list.
    #[must_use]
    pub fn new() -> Self {
        Self { items: [T::default(); N], length: 0 }
    }

    /// A list of these items.
    pub fn from_slice(items: &[T]) -> Result<Self, CapacityError> {
        let mut list = Self::new();
        list.items.get_mut(..items.len()).ok_or(CapacityError)?.copy_from_slice(items);
        list.length = items.len();
        Ok(list)
    }
}

impl<T, const N: usize> List<T, N> {
    /// Appends an item.
    pub fn push(&mut self, item: T) -> Result<(), CapacityError> {
        *self.items.get_mut(self.length).ok_or(CapacityError)? = item;
        self.length = self.length.saturating_add(1);
        Ok(())
    }

    /// Takes the last item off.
    pub fn pop(&mut self) -> Option<T>
    where
        T: Copy,
    {
        let last = self.length.checked_sub(1)?;
        self.length = last;
        self.items.get(last).copied()
    }

    /// Makes it empty.
    pub fn clear(&mut self) {
        self.length = 0;
    }

    /// The items.
    #[must_use]
    pub fn as_slice(&self) -> &[T] {
        self.items.get(..self.length).unwrap_or_default()
    }

    /// The items, to be changed in place.
    #[must_use]
    pub fn as_mut_slice(&mut self) -> &mut [T] {
        self.items.get_mut(..self.length).unwrap_or_default()
    }
}

impl<T: Copy + Default, const N: usize> Default for List<T, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T, const N: usize> ops::Deref for List<T, N> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        self.as_slice()
    }
}

impl<T, const N: usize> ops::DerefMut for List<T, N> {
    fn deref_mut(&mut self) -> &mut [T] {
        self.as_mut_slice()
    }
}

impl<T: fmt::Debug, const N: usize> fmt::Debug for List<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.as_slice().fmt(f)
    }
}

impl<T: PartialEq, const N: usize> PartialEq for List<T, N> {
    fn eq(&self, other: &Self) -> bool {
        self.as_slice() == other.as_slice()
    }
}

impl<T: Copy + Default, const N: usize> TryFrom<&[T]> for List<T, N> {
    type Error = CapacityError;

    fn try_from(items: &[T]) -> Result<Self, CapacityError> {
        Self::from_slice(items)
    }
}

/// Judged while compiling: an array that is too long does not build.
struct Fits<const M: usize, const N: usize>;

impl<const M: usize, const N: usize> Fits<M, N> {
    const CHECKED: () = assert!(M <= N, "more items than the list can hold");
}

impl<T: Copy + Default, const M: usize, const N: usize> From<[T; M]> for List<T, N> {
    fn from(items: [T; M]) -> Self {
        let () = Fits::<M, N>::CHECKED;
        Self::from_slice(&items).unwrap_or_default()
    }
}

impl<'a, T, const N: usize> IntoIterator for &'a List<T, N> {
    type Item = &'a T;
    type IntoIter = core::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// The items alone. What counts them, if anything does, is another value of the field.
impl<T: Wire + Copy + Default, const N: usize> Wire for List<T, N> {
    const SIZE: usize = T::SIZE.saturating_mul(N);

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let count = reader.remaining().checked_div(T::SIZE).unwrap_or(0);
        Self::decode_counted(count.min(N), reader)
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        self.iter().try_for_each(|item| writer.write(item))
    }
}

impl<T: Wire + Copy + Default, const N: usize> Counted for List<T, N> {
    fn decode_counted(count: usize, reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        if count > N || count.saturating_mul(T::SIZE) > reader.remaining() {
            return Err(DecodeError::Count);
        }
        let mut list = Self::new();
        for _ in 0..count {
            list.push(reader.read()?).map_err(|_| DecodeError::Count)?;
        }
        Ok(list)
    }
}

#[cfg(feature = "serde")]
impl<T: serde::Serialize, const N: usize> serde::Serialize for List<T, N> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self)
    }
}

#[cfg(feature = "serde")]
impl<'de, T, const N: usize> serde::Deserialize<'de> for List<T, N>
where
    T: serde::Deserialize<'de> + Copy + Default,
{
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor<T, const N: usize>(core::marker::PhantomData<T>);

        impl<'de, T, const N: usize> serde::de::Visitor<'de> for Visitor<T, N>
        where
            T: serde::Deserialize<'de> + Copy + Default,
        {
            type Value = List<T, N>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "at most {N} items")
            }

            fn visit_seq<A: serde::de::SeqAccess<'de>>(
                self,
                mut items: A,
            ) -> Result<Self::Value, A::Error> {
                let mut list = List::new();
                while let Some(item) = items.next_element()? {
                    list.push(item).map_err(serde::de::Error::custom)?;
                }
                Ok(list)
            }
        }

        deserializer.deserialize_seq(Visitor(core::marker::PhantomData))
    }
}

/// serde knows arrays of up to 32 items only; longer ones, if there are any, go through a [`List`].
#[cfg(feature = "serde")]
#[allow(dead_code)]
pub(crate) mod long_array {
    use super::List;
    use serde::{de::Error, Deserialize, Deserializer, Serialize, Serializer};

    pub(crate) trait Long: Sized {
        type List;

        fn to_list(&self) -> Self::List;
        fn from_list(list: Self::List) -> Option<Self>;
    }

    impl<T: Copy + Default, const N: usize> Long for [T; N] {
        type List = List<T, N>;

        fn to_list(&self) -> Self::List {
            List::from(*self)
        }

        fn from_list(list: Self::List) -> Option<Self> {
            Self::try_from(list.as_slice()).ok()
        }
    }

    impl<L: Long> Long for Option<L> {
        type List = Option<L::List>;

        fn to_list(&self) -> Self::List {
            self.as_ref().map(L::to_list)
        }

        fn from_list(list: Self::List) -> Option<Self> {
            list.map_or(Some(None), |list| L::from_list(list).map(Some))
        }
    }

    pub(crate) fn serialize<L, S>(array: &L, serializer: S) -> Result<S::Ok, S::Error>
    where
        L: Long,
        L::List: Serialize,
        S: Serializer,
    {
        array.to_list().serialize(serializer)
    }

    pub(crate) fn deserialize<'de, L, D>(deserializer: D) -> Result<L, D::Error>
    where
        L: Long,
        L::List: Deserialize<'de>,
        D: Deserializer<'de>,
    {
        let list = L::List::deserialize(deserializer)?;
        L::from_list(list).ok_or_else(|| D::Error::custom("the array has a wrong length"))
    }
}

#[cfg(feature = "defmt")]
impl<T: defmt::Format, const N: usize> defmt::Format for List<T, N> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{}", self.as_slice());
    }
}

//! Arrays of variable length, without a heap.

#[cfg(feature = "alloc")]
use alloc::vec::Vec;
use core::{fmt, hash, ops};

use crate::codec::{Counted, Reader, Wire, Writer};
use crate::error::{DecodeErrorKind, EncodeErrorKind, ReadError};

/// At most `N` items, stored in place. It dereferences to a slice.
///
/// ```
/// use mip_protocol::List;
///
/// let mut list: List<u16, 4> = [1, 2, 3].into();
/// assert!(list.push(4).is_ok());
/// assert!(list.push(5).is_err());
/// assert_eq!(list.iter().sum::<u16>(), 10);
/// assert_eq!(list, [1, 2, 3, 4]);
/// ```
///
/// A slice or iterator with more items than fit does not cause a panic: the list holds the first
/// `N` and is marked as [overflowed](List::overflowed), and encoding a field that contains it fails
/// ([`EncodeErrorKind::Count`]). [`List::from_slice`] and [`List::push`] fail at once.
///
/// ```
/// # use mip_protocol::List;
/// let list: List<u16, 4> = (1..=9).collect();
/// assert_eq!((list.as_slice(), list.overflowed()), (&[1, 2, 3, 4][..], true));
/// ```
#[derive(Clone)]
pub struct List<T, const N: usize> {
    items: [T; N],
    /// The number of items, and whether there were more.
    given: usize,
}

/// The bit of [`List::given`] that marks a list as overflowed.
const OVERFLOWED: usize = !(usize::MAX >> 1);

/// The elements of a [`List`] or an array: all numbers, enumerations, bitfields and structures.
pub trait Item: Sized {
    /// The value of unused items.
    const BLANK: Self;
}

impl<T: Item, const N: usize> Item for [T; N] {
    const BLANK: Self = [T::BLANK; N];
}

impl<T: Item, const N: usize> Item for List<T, N> {
    const BLANK: Self = Self::new();
}

impl<T> Item for Option<T> {
    const BLANK: Self = None;
}

/// There are more items than the list can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct CapacityError {
    /// The number of items given, or one more than fit if the rest was not counted.
    pub need: usize,
    /// The number of items that the list can hold.
    pub got: usize,
}

impl fmt::Display for CapacityError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} items were given, the list can hold {}", self.need, self.got)
    }
}

error!(CapacityError);

impl<T: Item, const N: usize> List<T, N> {
    /// A constant, so that creating a list clears memory instead of copying it.
    const NEW: Self = Self { items: [T::BLANK; N], given: 0 };

    /// Creates an empty list.
    #[inline]
    #[must_use]
    pub const fn new() -> Self {
        Self::NEW
    }

    /// Creates a list of these items.
    ///
    /// # Errors
    ///
    /// There are more than `N` items.
    pub fn from_slice(items: &[T]) -> Result<Self, CapacityError>
    where
        T: Clone,
    {
        if items.len() > N {
            return Err(CapacityError { need: items.len(), got: N });
        }
        Ok(items.into())
    }

    /// Removes and returns the last item. A list that has overflowed remains marked.
    pub fn pop(&mut self) -> Option<T> {
        let last = self.count().checked_sub(1)?;
        self.given = last | (self.given & OVERFLOWED);
        self.items.get_mut(last).map(|item| core::mem::replace(item, T::BLANK))
    }
}

impl<T, const N: usize> List<T, N> {
    /// Appends an item. A list that has overflowed accepts none until it is cleared.
    ///
    /// ```
    /// let mut list = mip_protocol::List::<u8, 2>::new();
    /// list.push(1)?;
    /// assert_eq!(list.as_slice(), [1]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The list is full.
    #[inline]
    pub fn push(&mut self, item: T) -> Result<(), CapacityError> {
        match self.items.get_mut(self.given) {
            Some(place) => {
                *place = item;
                self.given = self.given.saturating_add(1);
                Ok(())
            }
            None => Err(CapacityError { need: N.saturating_add(1), got: N }),
        }
    }

    /// Removes all items.
    pub fn clear(&mut self) {
        self.given = 0;
    }

    /// Was the list given more items than it can hold? If so, it holds only the first ones.
    ///
    /// ```
    /// let list: mip_protocol::List<u8, 2> = [1, 2, 3].into_iter().collect();
    /// assert!(list.overflowed() && list.len() == 2);
    /// ```
    #[must_use]
    pub const fn overflowed(&self) -> bool {
        self.given & OVERFLOWED != 0
    }

    #[inline]
    const fn count(&self) -> usize {
        self.given & !OVERFLOWED
    }

    /// Returns the number of items that the list can hold.
    #[must_use]
    pub const fn capacity(&self) -> usize {
        N
    }

    /// Returns the items.
    #[inline]
    #[must_use]
    pub fn as_slice(&self) -> &[T] {
        self.items.get(..self.count()).unwrap_or_default()
    }

    /// Returns the items, mutable.
    #[inline]
    #[must_use]
    pub fn as_mut_slice(&mut self) -> &mut [T] {
        let count = self.count();
        self.items.get_mut(..count).unwrap_or_default()
    }
}

impl<T: Item, const N: usize> Default for List<T, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T, const N: usize> ops::Deref for List<T, N> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        self.as_slice()
    }
}

impl<T, const N: usize> ops::DerefMut for List<T, N> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [T] {
        self.as_mut_slice()
    }
}

impl<T, const N: usize> AsRef<[T]> for List<T, N> {
    fn as_ref(&self) -> &[T] {
        self
    }
}

impl<T: fmt::Debug, const N: usize> fmt::Debug for List<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.as_slice().fmt(f)
    }
}

/// A list that overflowed is not equal to one that did not.
impl<T: PartialEq, const N: usize> PartialEq for List<T, N> {
    fn eq(&self, other: &Self) -> bool {
        self.given == other.given && self.as_slice() == other.as_slice()
    }
}

impl<T: Eq, const N: usize> Eq for List<T, N> {}

impl<T: hash::Hash, const N: usize> hash::Hash for List<T, N> {
    fn hash<H: hash::Hasher>(&self, state: &mut H) {
        self.as_slice().hash(state);
    }
}

macro_rules! equal {
    ($([$($size:tt)*] $other:ty;)*) => {$(
        impl<T: PartialEq, $($size)* const N: usize> PartialEq<$other> for List<T, N> {
            fn eq(&self, other: &$other) -> bool {
                self.given == other.len() && self.as_slice() == &other[..]
            }
        }

        impl<T: PartialEq, $($size)* const N: usize> PartialEq<List<T, N>> for $other {
            fn eq(&self, other: &List<T, N>) -> bool {
                *other == *self
            }
        }
    )*};
}

equal! {
    [] [T];
    [] &[T];
    [const M: usize,] [T; M];
}
#[cfg(feature = "alloc")]
equal!([] Vec<T>;);

/// A check at compile time that an array fits.
struct Fits<const M: usize, const N: usize>;

impl<const M: usize, const N: usize> Fits<M, N> {
    const CHECKED: () = assert!(M <= N, "more items than the list can hold");
}

impl<T: Item, const M: usize, const N: usize> From<[T; M]> for List<T, N> {
    fn from(items: [T; M]) -> Self {
        let () = Fits::<M, N>::CHECKED;
        items.into_iter().collect()
    }
}

impl<T: Item + Clone, const M: usize, const N: usize> From<&[T; M]> for List<T, N> {
    fn from(items: &[T; M]) -> Self {
        let () = Fits::<M, N>::CHECKED;
        items.as_slice().into()
    }
}

/// Keeps the first items of a slice that is too long: see [`List::overflowed`].
impl<T: Item + Clone, const N: usize> From<&[T]> for List<T, N> {
    fn from(items: &[T]) -> Self {
        items.iter().cloned().collect()
    }
}

/// Keeps the first items of a `Vec` that is too long: see [`List::overflowed`].
#[cfg(feature = "alloc")]
impl<T: Item, const N: usize> From<Vec<T>> for List<T, N> {
    fn from(items: Vec<T>) -> Self {
        items.into_iter().collect()
    }
}

/// Keeps the first items of a `Vec` that is too long: see [`List::overflowed`].
#[cfg(feature = "alloc")]
impl<T: Item + Clone, const N: usize> From<&Vec<T>> for List<T, N> {
    fn from(items: &Vec<T>) -> Self {
        items.as_slice().into()
    }
}

/// Keeps the first items of an iterator that yields too many: see [`List::overflowed`].
impl<T: Item, const N: usize> FromIterator<T> for List<T, N> {
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Self {
        let mut list = Self::new();
        list.extend(items);
        list
    }
}

/// An item that does not fit marks the list as overflowed, and the rest is not read: see
/// [`List::overflowed`].
impl<T, const N: usize> Extend<T> for List<T, N> {
    fn extend<I: IntoIterator<Item = T>>(&mut self, items: I) {
        for item in items {
            if self.push(item).is_err() {
                self.given |= OVERFLOWED;
                return; // the number of further items does not matter
            }
        }
    }
}

impl<'a, T: Clone + 'a, const N: usize> Extend<&'a T> for List<T, N> {
    fn extend<I: IntoIterator<Item = &'a T>>(&mut self, items: I) {
        self.extend(items.into_iter().cloned());
    }
}

impl<T, const N: usize> IntoIterator for List<T, N> {
    type Item = T;
    type IntoIter = core::iter::Take<core::array::IntoIter<T, N>>;

    fn into_iter(self) -> Self::IntoIter {
        let count = self.count();
        self.items.into_iter().take(count)
    }
}

impl<'a, T, const N: usize> IntoIterator for &'a List<T, N> {
    type Item = &'a T;
    type IntoIter = core::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<'a, T, const N: usize> IntoIterator for &'a mut List<T, N> {
    type Item = &'a mut T;
    type IntoIter = core::slice::IterMut<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter_mut()
    }
}

/// Encodes only the items. A counter is another value of the field.
impl<T: Wire + Item, const N: usize> Wire for List<T, N> {
    const SIZE: usize = T::SIZE.saturating_mul(N);

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, ReadError> {
        let count = reader.remaining().checked_div(T::SIZE).unwrap_or(0);
        Self::decode_counted(count.min(N), reader)
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeErrorKind> {
        if self.overflowed() {
            return Err(writer.wrong(EncodeErrorKind::Count, N.saturating_add(1), N));
        }
        self.iter().try_for_each(|item| writer.write(item))
    }
}

impl<T: Wire + Item, const N: usize> Counted for List<T, N> {
    fn decode_counted(count: usize, reader: &mut Reader<'_>) -> Result<Self, ReadError> {
        if count > N || count.saturating_mul(T::SIZE) > reader.remaining() {
            let follow = reader.remaining().checked_div(T::SIZE).unwrap_or(N).min(N);
            return Err(reader.wrong(DecodeErrorKind::Count, count, follow));
        }
        let mut list = Self::new();
        for _ in 0..count {
            list.push(reader.read()?).map_err(|_| ReadError)?;
        }
        Ok(list)
    }
}

#[cfg(feature = "serde")]
impl<T: serde::Serialize, const N: usize> serde::Serialize for List<T, N> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.whole()?;
        serializer.collect_seq(self)
    }
}

#[cfg(feature = "serde")]
impl<T, const N: usize> List<T, N> {
    /// Is an error for a list that has overflowed.
    pub(crate) fn whole<E: serde::ser::Error>(&self) -> Result<(), E> {
        let error = || E::custom("more items than the list can hold");
        (!self.overflowed()).then_some(()).ok_or_else(error)
    }
}

#[cfg(feature = "serde")]
impl<'de, T, const N: usize> serde::Deserialize<'de> for List<T, N>
where
    T: serde::Deserialize<'de> + Item,
{
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(crate::readable::Items(core::marker::PhantomData))
    }
}

/// Serializes arrays through a [`List`], because serde itself supports at most 32 items.
#[cfg(feature = "serde")]
#[allow(dead_code)]
pub(crate) mod long_array {
    use super::{Item, List};
    use serde::{de::Error, Deserialize, Deserializer, Serialize, Serializer};

    pub(crate) trait Long: Sized {
        type List;

        fn to_list(&self) -> Self::List;
        fn from_list(list: Self::List) -> Option<Self>;
    }

    impl<T: Item + Clone, const N: usize> Long for [T; N] {
        type List = List<T, N>;

        fn to_list(&self) -> Self::List {
            List::from(self)
        }

        fn from_list(list: Self::List) -> Option<Self> {
            let mut items = [T::BLANK; N];
            items.clone_from_slice(list.get(..N)?);
            Some(items)
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
        L::from_list(list).ok_or_else(|| D::Error::custom("the array has the wrong length"))
    }
}

#[cfg(feature = "defmt")]
impl<T: defmt::Format, const N: usize> defmt::Format for List<T, N> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{}", self.as_slice());
    }
}

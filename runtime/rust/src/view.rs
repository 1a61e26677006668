//! Reads fields in place, without copying their bytes.

use core::fmt;
use core::marker::PhantomData;

use crate::codec::{Reader, Wire};
use crate::error::{DecodeError, DecodeErrorKind};
use crate::field::Field;
use crate::list::Item;

/// A field or a structure whose values are at fixed offsets.
pub trait Viewed: Wire {}

/// The bytes of a field or a structure, with a method for each of its values.
///
/// A value is decoded when its method is called. This is for programs that need few values of large
/// fields, and for microcontrollers, where it avoids copies.
///
/// ```
/// use mip_protocol::{protocol::Acknowledge, Packet};
///
/// let bytes = [0x75, 0x65, 0x01, 0x04, 0x04, 0xF1, 0x01, 0x00, 0xD5, 0x6A];
/// let packet = Packet::new(&bytes)?;
/// if let Some(reply) = packet.view::<Acknowledge>()? {
///     assert_eq!(reply.command(), 1);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct View<'a, T> {
    data: &'a [u8],
    of: PhantomData<fn() -> T>,
}

// Functions rather than methods, because a view's methods are named after the field's values.

/// Creates a view of a field's bytes, if there are enough.
#[inline]
pub(crate) fn open<T: Field + Viewed>(data: &[u8]) -> Result<View<'_, T>, DecodeError> {
    enough::<T>(data).map(|()| View { data, of: PhantomData })
}

/// Are there enough bytes for a field of a fixed size?
#[inline]
pub(crate) fn enough<T: Field>(data: &[u8]) -> Result<(), DecodeError> {
    if data.len() < T::SIZE {
        let kind = DecodeErrorKind::Truncated;
        return Err(DecodeError::new(kind, T::NAME, T::SIZE, data.len()));
    }
    Ok(())
}

/// Reads the value at this offset.
#[inline]
pub(crate) fn value<T, V: Wire + Item>(view: &View<'_, T>, at: usize) -> V {
    Reader::new(behind(view.data, at)).read().unwrap_or(V::BLANK) // all bytes are there
}

/// Creates a view of the structure at this offset.
#[allow(dead_code)] // few sets have structures
#[inline]
pub(crate) fn part<'a, T, V: Viewed>(view: &View<'a, T>, at: usize) -> View<'a, V> {
    View { data: behind(view.data, at), of: PhantomData }
}

#[inline]
fn behind(data: &[u8], at: usize) -> &[u8] {
    data.get(at..).unwrap_or_default()
}

impl<T> Clone for View<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for View<'_, T> {}

impl<T: Viewed + fmt::Debug> fmt::Debug for View<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        T::decode_from(&mut Reader::new(self.data)).map_err(|_| fmt::Error)?.fmt(f)
    }
}

#[cfg(feature = "defmt")]
impl<T: Viewed + defmt::Format> defmt::Format for View<'_, T> {
    fn format(&self, f: defmt::Formatter<'_>) {
        if let Ok(value) = T::decode_from(&mut Reader::new(self.data)) {
            value.format(f);
        }
    }
}

//! The field for which a device has rejected a command, or the command that it has instead.

use core::fmt;

use super::lists::{ALTERNATIVES, LISTINGS, SETS};
use super::{Profile, Support};
use crate::field::RawField;
use crate::protocol::DescriptorSet;
#[cfg(feature = "registry")]
use crate::registry::FIELDS;

/// Why a device rejects a command or a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Rejection {
    /// The device does not send it.
    Absent,
    /// Its decimation is 0.
    Decimation,
    /// The list is longer than permitted.
    TooMany,
    /// It is not data of the set.
    Undefined,
    /// No source states that this model sends it.
    Unlisted,
    /// The device has another command for it, whose set and descriptor are stated.
    OtherCommand,
}

/// The reasons to reject a field, in the order in which they are searched.
const REASONS: [Rejection; 5] = [
    Rejection::Absent,
    Rejection::Decimation,
    Rejection::TooMany,
    Rejection::Undefined,
    Rejection::Unlisted,
];

/// What is known about a device.
#[derive(Clone, Copy, Debug, Default)]
pub struct Known<'d> {
    /// Its profile, if that is known.
    pub profile: Option<&'static Profile>,
    /// What the device lists itself, in its responses to the commands for its descriptors: the set
    /// in the high byte, the descriptor in the low one. Empty if it was not asked, or has not
    /// answered all of them.
    pub descriptors: &'d [u16],
}

impl Known<'_> {
    /// Returns whether the device has this field or, for descriptor 0, any of the set.
    #[must_use]
    pub fn sends(&self, set: DescriptorSet, descriptor: u8) -> Support {
        let lists = |number: &u16| match (number.to_be_bytes(), descriptor) {
            ([listed, _], 0) => listed == set.0,
            ([listed, field], _) => field == descriptor && (listed == set.0 || listed == 0xFF),
        };
        match self.profile {
            _ if self.descriptors.iter().any(lists) => Support::Yes,
            _ if !self.descriptors.is_empty() => Support::No,
            None => Support::Unknown,
            Some(profile) if descriptor == 0 && profile.fields.iter().any(|f| f.set == set) => {
                Support::Yes
            }
            Some(profile) => profile.support(set, descriptor),
        }
    }
}

/// The field for which a device has rejected a command, and why: "3DM-CV7-AR has no magnetometer".
///
/// A NACK does not state it. `Device::rejected` asks the device what it is and what it sends, and
/// then finds it.
///
/// ```
/// # #[cfg(all(feature = "mip_3dm", feature = "registry"))] {
/// use mip_protocol::devices::{Known, Profile, Rejected};
/// use mip_protocol::{mip_3dm::MessageFormat, Command, PacketBuilder};
///
/// # let Some(profile) = Profile::find("3DM-CV7-AR") else { return };
/// let command = MessageFormat::write(0x80, [(0x04, 10).into(), (0x06, 10).into()]);
/// let known = Known { profile: Profile::find("3DM-CV7-AR"), ..Known::default() };
/// let rejected = Rejected::of(&command, &known).unwrap();
/// assert_eq!((rejected.index, rejected.set.0, rejected.descriptor), (1, 0x80, 0x06));
/// assert_eq!(rejected.to_string(), "3DM-CV7-AR has no magnetometer");
/// # }
/// ```
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Rejected {
    /// Why the device rejects it.
    pub reason: Rejection,
    /// Its index in the list.
    pub index: u8,
    /// Its descriptor set.
    pub set: DescriptorSet,
    /// Its descriptor; 0 for the whole set.
    pub descriptor: u8,
    /// The number of fields in the list.
    pub count: u8,
    /// The greatest number that is permitted, if that is known.
    pub most: Option<u8>,
    profile: Option<&'static Profile>,
}

impl Rejected {
    /// Finds the field for which a device with this profile or these descriptors rejects a command,
    /// or the command that it has instead; `None` if the command cannot be encoded, or nothing shows
    /// it.
    #[must_use]
    pub fn of<C: crate::Command>(command: &C, known: &Known<'_>) -> Option<Self> {
        let mut data = [0; crate::packet::MAX_FIELD_DATA];
        let size = command.encode(&mut data).ok()?;
        let data = data.get(..size)?;
        Self::find(&RawField { set: C::SET, descriptor: C::DESCRIPTOR, data }, known)
    }

    /// Like [`Rejected::of`], for an encoded command.
    #[must_use]
    pub fn find(command: &RawField<'_>, known: &Known<'_>) -> Option<Self> {
        if let Some((set, descriptor)) = Self::other_command(command, known) {
            let (reason, profile) = (Rejection::OtherCommand, known.profile);
            return Some(Self { reason, index: 0, set, descriptor, count: 0, most: None, profile });
        }
        REASONS.iter().find_map(|reason| {
            let lists = LISTINGS.iter().filter(|list| list.is_in(command));
            let mut items = lists.flat_map(|list| list.items(command));
            let item = items.find(|item| item.holds(*reason, known))?;
            let Item { index, set, descriptor, count, most, .. } = item;
            let (reason, profile) = (*reason, known.profile);
            Some(Self { reason, index, set, descriptor, count, most, profile })
        })
    }

    /// Finds the command that a device has instead of one that it lacks.
    fn other_command(command: &RawField<'_>, known: &Known<'_>) -> Option<(DescriptorSet, u8)> {
        if known.sends(command.set, command.descriptor) != Support::No {
            return None;
        }
        let key = [command.set.0, command.descriptor];
        let own = ALTERNATIVES.iter().filter(|(lacking, _)| *lacking == key);
        let fits = |other: [u8; 2]| {
            let mut lists = LISTINGS.iter().filter(|list| list.command == other);
            lists.all(|list| list.set.map_or(true, |set| Self::is_about(command, set)))
        };
        let mut others = own.map(|(_, other)| *other).filter(|other| fits(*other));
        let found = others.find(|[set, descriptor]| {
            !matches!(known.sends(DescriptorSet(*set), *descriptor), Support::No | Support::Unknown)
        });
        found.map(|[set, descriptor]| (DescriptorSet(set), descriptor))
    }

    /// Does this command list data of a set?
    fn is_about(command: &RawField<'_>, set: u8) -> bool {
        let mut lists = LISTINGS.iter().filter(|list| list.is_in(command));
        lists.any(|list| list.items(command).any(|item| item.set.0 == set))
    }
}

impl fmt::Display for Rejected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { reason, set, descriptor, count, profile, .. } = *self;
        let (title, field) = (profile.map_or("the device", |p| p.title), Name(set, descriptor));
        match (reason, self.most) {
            (Rejection::Absent, _) => {
                match profile.and_then(|p| p.evidence(set, descriptor)).map(|e| e.absence) {
                    Some(absence) if !absence.is_empty() => write!(f, "{title} {absence}"),
                    _ => write!(f, "{title} does not send {field}"),
                }
            }
            (Rejection::Decimation, _) => write!(f, "the decimation of {field} is 0"),
            (Rejection::TooMany, Some(most)) => {
                write!(f, "{count} fields are listed, at most {most} are possible")
            }
            (Rejection::TooMany, None) => write!(f, "{count} fields are listed"),
            (Rejection::Undefined, _) => {
                write!(f, "0x{descriptor:02X} is not a field of {}", Name(set, 0))
            }
            (Rejection::OtherCommand, _) => write!(f, "{title} has {field} instead"),
            (Rejection::Unlisted, _) => write!(f, "{title} is not known to send {field}"),
        }
    }
}

impl fmt::Debug for Rejected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Rejected({:?}, item {}: {self})", self.reason, self.index)
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Rejected {
    fn format(&self, f: defmt::Formatter<'_>) {
        let Self { reason, index, set, descriptor, .. } = self;
        defmt::write!(f, "{} of item {}: {:#x},{:#x}", reason, index, set.0, descriptor);
    }
}

/// The name of a field, or with descriptor 0, of a set; numbers if it has none, or without the
/// registry.
struct Name(DescriptorSet, u8);

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(set, descriptor) = *self;
        #[cfg(feature = "registry")]
        {
            let mut fields = FIELDS.iter().filter(|field| field.descriptor == descriptor);
            if let Some(name) = fields.find_map(|field| field.name_in(set)) {
                return f.write_str(name);
            }
        }
        match SETS.iter().find(|(number, ..)| *number == set.0) {
            Some((_, name, _)) => f.write_str(name)?,
            None => write!(f, "set 0x{:02X}", set.0)?,
        }
        if descriptor == 0 {
            return Ok(());
        }
        write!(f, " 0x{descriptor:02X}")
    }
}

/// A list of fields in a command. Offsets count from the beginning of its data.
pub(super) struct Listing {
    /// The set and the descriptor of the command.
    pub command: [u8; 2],
    /// The set of all fields.
    pub set: Option<u8>,
    /// Otherwise, where its number is.
    pub set_at: usize,
    /// Where the number of entries is; without it, there is one.
    pub count_at: Option<usize>,
    /// Where the descriptor in the first entry is; without it, the command names only a set.
    pub first: Option<usize>,
    /// The size of an entry.
    pub stride: usize,
    /// The greatest number of entries.
    pub most: Option<u8>,
    /// Where in an entry a u16 is that must not be 0.
    pub decimation_at: Option<usize>,
    /// Where the list requires which byte.
    pub tag: Option<(usize, u8)>,
}

/// A field in a list.
struct Item {
    index: u8,
    set: DescriptorSet,
    /// 0 if the command names only a set.
    descriptor: u8,
    count: u8,
    most: Option<u8>,
    stopped: bool,
}

impl Listing {
    /// Does this command contain the list?
    fn is_in(&self, command: &RawField<'_>) -> bool {
        self.command == [command.set.0, command.descriptor]
            && self.tag.map_or(true, |(at, tag)| command.data.get(at).map_or(0, |x| *x) == tag)
    }

    fn items<'c>(&'static self, command: &RawField<'c>) -> impl Iterator<Item = Item> + 'c {
        let data = command.data;
        let byte = move |at: usize| data.get(at).copied().unwrap_or(0);
        let set = self.set.unwrap_or_else(|| byte(self.set_at));
        let count = self.count_at.map_or(1, byte);
        let first = self.first.filter(|_| count > 0);
        let items = match first {
            _ if set < 0x80 => 0,
            None => 1,
            Some(_) => count,
        };
        (0..items).map(move |index| {
            let from_first = usize::from(index).wrapping_mul(self.stride);
            let at = first.map(|first| first.wrapping_add(from_first));
            let decimation = at.zip(self.decimation_at).map(|(at, by)| at.wrapping_add(by));
            let stopped = |at: usize| byte(at) == 0 && byte(at.wrapping_add(1)) == 0;
            Item {
                index,
                set: DescriptorSet(set),
                descriptor: at.map_or(0, byte),
                count,
                most: self.most,
                stopped: decimation.map_or(false, stopped),
            }
        })
    }
}

impl Item {
    fn holds(&self, reason: Rejection, known: &Known<'_>) -> bool {
        let Self { index, set, descriptor, most, stopped, .. } = *self;
        let sends = known.sends(set, descriptor);
        match reason {
            Rejection::Absent => sends == Support::No,
            Rejection::Decimation => stopped,
            Rejection::TooMany => most.map_or(false, |most| index >= most),
            Rejection::Undefined => {
                sends == Support::Unknown && descriptor != 0 && !is_defined(set, descriptor)
            }
            Rejection::OtherCommand => false, // no field is to blame
            Rejection::Unlisted => sends == Support::Unknown && known.profile.is_some(),
        }
    }
}

/// Is this data of the set, or shared data?
fn is_defined(set: DescriptorSet, descriptor: u8) -> bool {
    let mut sets = SETS.iter().filter(|(number, ..)| [set.0, 0xFF].contains(number));
    sets.any(|(.., descriptors)| descriptors.contains(&descriptor))
}

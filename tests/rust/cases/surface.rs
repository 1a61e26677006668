//! What users expect of lists, bitfields and errors.

use std::collections::hash_map::DefaultHasher;
use std::collections::HashSet;
use std::hash::{Hash, Hasher};

use mip_protocol::device::DeviceError;
use mip_protocol::protocol::ReadCall;
use mip_protocol::types::{Health, Mode, StateFlags};
use mip_protocol::{
    checksum, measurements, shared, tools, Bool, Command, CommandError, DecodeErrorKind,
    DescriptorSet, EncodeErrorKind, Field, List, Packet, PacketBuilder, Reason, RequestError, Role,
    VarText,
};

// ------------------------------------------------------------------------------------------ lists

static EMPTY: List<u16, 4> = List::new();

#[test]
fn lists_are_collections() {
    let mut list: List<u16, 4> = [1, 2].into_iter().collect();
    list.extend([3]);
    list.extend(&[4]);
    assert_eq!(list, [1, 2, 3, 4]);
    assert_eq!((list == [1, 2, 3][..], list == &[1, 2, 3, 4][..]), (false, true));
    for item in &mut list {
        *item *= 2;
    }
    assert_eq!((&list).into_iter().copied().max(), Some(8));
    assert_eq!(list.clone().into_iter().rev().collect::<Vec<_>>(), [8, 6, 4, 2]);
    assert_eq!((list.pop(), list.len(), list.as_ref().len()), (Some(8), 3, 3));
    list.clear();
    assert_eq!((list.pop(), &list), (None, &EMPTY));
    let set: HashSet<List<u16, 4>> = [[1, 2].into(), [1, 2].into(), EMPTY.clone()].into();
    assert_eq!(set.len(), 2);
    assert_eq!(VarText::<3>::new("abc"), VarText::new("abc"));
    assert_eq!(List::<u8, 3>::try_from(&[9][..]), Ok([9].into()));
    list.push(7).unwrap();
    list[0] = 9;
    assert_eq!(format!("{list:?}"), "[9]");
}

#[test]
fn lists_are_made_of_vectors_and_compared_with_them() {
    let items = vec![1_u16, 2];
    let command = tools::List::write(&items);
    assert_eq!(command, tools::List::write(items.clone()));
    let list = command.into_command().items.unwrap();
    assert!(list == items && items == list && list == [1, 2] && [1, 2] == list);
    assert!(items[..] == list && items.as_slice() == list && list != vec![1] && vec![1] != list);
    let (all, first): (List<u8, 4>, List<u8, 4>) = (vec![7; 5].into(), (&vec![7; 4]).into());
    assert!(all.overflowed() && all != first && all != vec![7; 4] && vec![7; 4] == first);
}

#[test]
fn a_list_that_overflowed_is_never_encoded() {
    let four: List<u16, 4> = [1, 2, 3, 4].as_slice().into();
    let mut five: List<u16, 4> = (1..=5).collect();
    assert!(!four.overflowed() && five.overflowed());
    assert_eq!((five.as_slice(), five.len()), (&[1, 2, 3, 4][..], 4));
    assert!(five != four && five != [1, 2, 3, 4]);
    assert_eq!(five.clone().into_iter().count(), 4);
    assert!(five.push(6).is_err());
    let error = List::<u16, 4>::from_slice(&[0; 7]).unwrap_err();
    assert_eq!((error.need, error.got), (7, 4));
    assert_eq!(error.to_string(), "7 items were given, the list can hold 4");
    assert_eq!((five.pop(), five.overflowed(), five.as_slice()), (Some(4), true, &[1, 2, 3][..]));
    assert_eq!((five.pop(), five.pop(), five.as_mut_slice()), (Some(3), Some(2), &mut [1][..]));
    assert!(five != [1] && five.push(6).is_err());
    five.extend([6]);
    assert_eq!((five.clone().into_iter().count(), five.pop(), five.pop()), (1, Some(1), None));
    assert!(five.overflowed() && five.is_empty());
    // It holds none now, but was given five.
    let error = five.push(6).unwrap_err();
    assert_eq!(error.to_string(), "5 items were given, the list can hold 4");
    five.clear();
    assert!(!five.overflowed() && five.push(7).is_ok() && five == [7]);
    let mut items = tools::List::write([7; 300].as_slice()).into_command();
    items.items.as_mut().unwrap().pop();
    assert_eq!(items.to_vec().unwrap_err().kind, EncodeErrorKind::Count);
    let most = tools::List::write([0; 0]).into_command().items.unwrap().capacity();
    for length in 0..=300 {
        let command = tools::List::write(vec![7; length].as_slice());
        match command.to_vec() {
            Ok(data) => assert!(length <= most && data.len() == 2 * length + 2),
            Err(error) => {
                assert!(length > most);
                assert_eq!((error.kind, error.got), (EncodeErrorKind::Count, most));
                assert_eq!(error.field, "tools.list");
            }
        }
    }
    assert_eq!(tools::List::write(&[1, 2]), tools::List::write([1, 2]));
}

// -------------------------------------------------------------------------------------- bitfields

const BOTH: StateFlags = StateFlags::READY.union(StateFlags::HOT);

#[test]
fn bitfields_are_sets_of_bits() {
    assert!(!StateFlags(!StateFlags::all().0).is_empty() && StateFlags::empty().is_empty());
    assert_eq!(StateFlags::from_name("hot"), Some(StateFlags::HOT));
    assert_eq!(StateFlags::from_name("cold"), None);
    let mut flags = StateFlags::READY;
    flags ^= BOTH;
    assert_eq!(flags, StateFlags::HOT);
    flags |= StateFlags::HOT | StateFlags::READY;
    flags ^= StateFlags::READY;
    flags &= BOTH;
    assert_eq!(flags, StateFlags::HOT);
    flags -= BOTH;
    assert_eq!(flags, StateFlags::default());
    assert_eq!(BOTH - StateFlags::HOT, BOTH.difference(StateFlags::HOT));
    assert_eq!(BOTH ^ StateFlags::HOT, BOTH.symmetric_difference(StateFlags::HOT));
    assert_eq!(BOTH & StateFlags::HOT, BOTH.intersection(StateFlags::HOT));
    assert_eq!(!BOTH, BOTH.complement());
    assert_eq!((!BOTH).0, StateFlags::all().0 & !BOTH.0);
    assert!(BOTH.contains(StateFlags::HOT) && !StateFlags::HOT.contains(BOTH));
    let mut reserved = StateFlags(0x8000);
    reserved.insert(BOTH);
    reserved.remove(StateFlags::HOT);
    assert_eq!(reserved.0, 0x8001); // reserved bits stay
    assert_eq!(StateFlags::empty().with_level(0xFF).0, 0x70); // more than fits
}

#[test]
fn bitfields_name_their_bits() {
    let flags = StateFlags(0x8051);
    let names: Vec<_> = flags.iter_names().map(|(name, bits)| (name, bits.0)).collect();
    assert_eq!(names, [("ready", 0x0001), ("level", 0x0050)]); // no bit is left for `any`
    assert_eq!(format!("{:?}", StateFlags(0x8000)), "StateFlags(0x8000)");
    assert_eq!(format!("{:?}", StateFlags(0)), "StateFlags()");
    // `any` has the bits of `ready` and `hot`.
    assert_eq!(format!("{:?}", StateFlags(0x0001)), "StateFlags(ready)");
    assert_eq!(
        format!("{:?}", StateFlags(0x8353)),
        "StateFlags(ready | hot | level=5 | mode=3 | 0x8000)"
    );
}

#[test]
fn bitfields_of_bytes_are_sets_too() {
    let all = Health::all();
    assert!(all.contains(Health::CLOCK | Health::LAST) && !Health::CLOCK.contains(all));
    assert_eq!(Health([0xFF; 16]) & all, all);
    let mut health = Health::from_name("clock").unwrap();
    health ^= Health::CLOCK | Health::POWER;
    assert_eq!((health, !health & Health::POWER), (Health::POWER, Health::empty()));
    let mut unknown = [0; 16];
    (unknown[0], unknown[7]) = (1, 0x0A);
    assert_eq!(format!("{:?}", Health(unknown)), "Health(clock | 0xa00000000000000)");
    assert_eq!(Health(unknown).iter_names().count(), 1);
}

#[test]
fn bitfields_are_written_as_numbers() {
    let flags = StateFlags(0x8A51);
    assert_eq!(format!("{flags:x} {flags:X} {flags:#x} {flags:#06X}"), "8a51 8A51 0x8a51 0x8A51");
    assert_eq!(
        format!("{:o} {:#b} {:08b}", flags, StateFlags(5), StateFlags(5)),
        "105121 0b101 00000101"
    );
    let mut bytes = [0; 16];
    (bytes[0], bytes[7]) = (0x1F, 0x0A);
    let number = u128::from_le_bytes(bytes);
    let health = Health(bytes);
    assert_eq!(format!("{health:x} {health:#X}"), format!("{number:x} {number:#X}"));
    assert_eq!(format!("{health:<20x}|{health:#034x}"), format!("{number:<20x}|{number:#034x}"));
    assert_eq!(
        format!("{:x} {:#X}", Health([0xFF; 16]), Health::empty()),
        format!("{:x} 0x0", u128::MAX)
    );
}

// -------------------------------------------------------------------------------- truth, Eq, Hash

fn hash<T: Hash>(value: &T) -> u64 {
    let mut hasher = DefaultHasher::new();
    value.hash(&mut hasher);
    hasher.finish()
}

#[test]
fn whatever_is_not_zero_is_true() {
    assert_eq!(Bool(2), Bool::TRUE);
    assert_ne!(Bool(2), Bool::FALSE);
    assert_eq!(hash(&Bool(2)), hash(&Bool(1)));
    // A command that is silent if a value is true.
    let mut command = tools::Formats::new(true, 0, []);
    assert!(!command.expects_reply());
    command.suppress_ack = Bool(2);
    assert!(!command.expects_reply());
    assert_eq!(command.to_vec().unwrap()[0], 2);
}

#[test]
fn values_without_floats_are_keys() {
    let commands: [tools::Settings; 2] = [
        tools::Settings::write(1, Mode::FAST, 9600).into(),
        tools::Settings::read(1, Mode(9)).into(),
    ];
    assert_eq!(commands.into_iter().chain(commands).collect::<HashSet<_>>().len(), 2);
    assert_ne!(hash(&tools::List::write([1])), hash(&tools::List::write([2])));
}

static COMMANDS: (tools::Ping, ReadCall<tools::Bias>) = (tools::Ping::new(), tools::Bias::read());

#[test]
fn commands_without_arguments_are_constants() {
    assert_eq!(COMMANDS, (tools::Ping, tools::Bias::read()));
}

#[test]
fn answers_and_their_errors_are_keys() {
    let error = EncodeErrorKind::Count;
    let full = PacketBuilder::new(DescriptorSet(0)).push_raw(1, &[]).unwrap_err();
    let errors: HashSet<_> = [RequestError::Busy, full.into(), RequestError::Busy].into();
    assert_eq!((errors.len(), full.kind == error), (2, false));
    let late = CommandError::new("tools.ping", Reason::TimedOut);
    let failed: HashSet<_> = [DeviceError::<u8>::Closed, late.into()].into();
    assert!(failed.contains(&DeviceError::Command(late)));
    assert_eq!(format!("{:>9}|{}", Role::Command, Role::Data), "  command|data");
}

// ----------------------------------------------------------------------------------------- errors

#[test]
fn errors_tell_the_field_and_what_it_needs() {
    let error = measurements::Numbers::decode(&[0; 40]).unwrap_err();
    assert_eq!((error.kind, error.need, error.got), (DecodeErrorKind::Truncated, 44, 40));
    assert_eq!(error.to_string(), "measurements.numbers: it needs 44 bytes and has 40");
    let error = tools::Status::decode(&[0x12, 0x68, 2]).unwrap_err();
    assert_eq!((error.need, error.got), (0x1267, 0x1268));
    assert_eq!(error.to_string(), "tools.status: a constant is 0x1268 and not 0x1267");
    let error = tools::List::decode(&[2, 9, 0]).unwrap_err();
    assert_eq!(error.to_string(), "tools.list: 9 elements are counted, 0 can follow");
    let error = tools::Settings::default_write().to_vec().unwrap_err();
    assert_eq!(error.to_string(), "tools.settings.port: it is missing, or a value before it");
    let error = measurements::Numbers::default().encode(&mut [0; 43]).unwrap_err();
    assert_eq!((error.kind, error.need, error.got), (EncodeErrorKind::Length, 44, 43));
    let error = measurements::Accel::default().encode(&mut [0; 3]).unwrap_err();
    assert_eq!((error.need, error.got), (14, 3));
    let error =
        PacketBuilder::new(DescriptorSet(1)).push(&shared::Timestamp::default()).unwrap_err();
    assert_eq!((error.kind, error.need, error.got), (EncodeErrorKind::Set, 0x80, 0x01));
    assert_eq!(error.to_string(), "shared.timestamp: it occurs in set 0x80, and not in set 0x01");
    let error =
        PacketBuilder::new(DescriptorSet(0xFF)).push(&shared::Timestamp::default()).unwrap_err();
    assert_eq!(error.to_string(), "shared.timestamp: no packet has set 0xff");
    let error = PacketBuilder::new(DescriptorSet(0)).push_raw(1, &[]).unwrap_err();
    assert_eq!(error.to_string(), "no packet has set 0x00");
    let error = PacketBuilder::new(DescriptorSet(0xFF)).push_raw(1, &[]).unwrap_err();
    assert_eq!(error.to_string(), "no packet has set 0xff");
    let error = PacketBuilder::new(DescriptorSet(0x80)).push(&tools::Ping).unwrap_err();
    assert_eq!(error.to_string(), "tools.ping: it occurs in set 0x01, and not in set 0x80");
    let error: Box<dyn std::error::Error> = Box::new(error.kind);
    assert_eq!(error.to_string(), "the field does not occur in the descriptor set of the packet");
}

trait DefaultWrite {
    fn default_write() -> Self;
}

impl DefaultWrite for tools::Settings {
    fn default_write() -> Self {
        let mut settings = Self::write(1, Mode::FAST, 1).into_command();
        settings.port = None;
        settings
    }
}

#[test]
fn a_field_that_the_packet_cuts_is_no_absent_one() {
    let payload = [&[2, 7, 0x10, measurements::Accel::DESCRIPTOR][..], &[0; 14]].concat();
    for have in 0..=14 {
        // It may have all the values that it needs, but not all the bytes that its length announces.
        let bytes = sealed(measurements::MEASUREMENTS_SET, &payload[..have + 4]);
        let packet = Packet::new(&bytes).unwrap();
        let expected = (measurements::Accel::NAME, DecodeErrorKind::Truncated, 14, have);
        match packet.find::<measurements::Accel>() {
            Ok(found) => assert_eq!((have, found.is_some()), (14, true)),
            Err(e) => assert_eq!((e.field, e.kind, e.need, e.got), expected),
        }
        assert_eq!(packet.find::<measurements::Numbers>(), Ok(None));
        let other = sealed(0x82, &payload[..have + 4]);
        assert_eq!(Packet::new(&other).unwrap().find::<measurements::Accel>(), Ok(None));
    }
    // It is an error even if all values are there: 12 bytes are announced, and 10 follow.
    let bytes = sealed(0x9F, &[[14, 0xD3].as_slice(), &[0; 10]].concat());
    let error = Packet::new(&bytes).unwrap().find::<shared::Timestamp>().unwrap_err();
    assert_eq!((error.need, error.got), (12, 10));
    // Constants and sizes tell layouts apart, as far as the data reach.
    let bytes = sealed(tools::SET, &[6, tools::Status::DESCRIPTOR, 0x12]);
    let packet = Packet::new(&bytes).unwrap();
    assert!(matches!(packet.find::<tools::Status>(), Err(e) if e.got == 1));
    let bytes = sealed(tools::SET, &[6, tools::Status::DESCRIPTOR, 0x13]);
    assert_eq!(Packet::new(&bytes).unwrap().find::<tools::Status>(), Ok(None));
    // A field without a descriptor cannot be identified.
    for length in 0..2 {
        let bytes =
            sealed(measurements::MEASUREMENTS_SET, &[length, measurements::Accel::DESCRIPTOR]);
        assert_eq!(Packet::new(&bytes).unwrap().find::<measurements::Accel>(), Ok(None));
    }
}

/// A packet of any payload.
fn sealed(set: impl Into<DescriptorSet>, payload: &[u8]) -> Vec<u8> {
    let mut bytes = [&[0x75, 0x65, set.into().0, payload.len() as u8], payload].concat();
    bytes.extend(checksum(&bytes));
    bytes
}

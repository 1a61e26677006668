//! The types of fields: presence, constructors, unions, open values, links.

#![allow(deprecated)] // of the fields that are tested here

use mip_protocol::protocol::{Read, Save, Write};
use mip_protocol::types::{FunctionSelector, Mode, Point, Quatf, StateFlags, Vector3f};
use mip_protocol::{
    devices, dispatch, measurements, mip_3d, protocol, registry, shared, tools, AnyField, Bool,
    Command, DecodeErrorKind, EncodeErrorKind, Field, List, OneSet, PacketBuilder, RawField,
    Reader, Response, ResponseOf, Role, Text,
};

fn bytes<T: Field>(field: &T) -> Vec<u8> {
    field.to_vec().unwrap()
}

// --------------------------------------------------------------------------------------- presence

#[test]
fn constructors_build_the_shortest_form() {
    assert_eq!(bytes(&tools::Settings::write(3, Mode::SLOW, 9600)), [1, 3, 2, 0, 0, 0x25, 0x80]);
    assert_eq!(bytes(&tools::Settings::read(3, Mode::SLOW)), [2, 3, 2]);
    assert_eq!(bytes(&tools::Settings::save(3)), [3, 3]);
    assert_eq!(bytes(&tools::Settings::load(3)), [4, 3]);
    assert_eq!(bytes(&tools::Settings::load_default(3)), [5, 3]);
    assert_eq!(bytes(&tools::Settings::apply(3, Mode::SLOW, 1)), [6, 3, 2, 0, 0, 0, 1]);
    assert_eq!(bytes(&tools::List::write([1, 2])), [1, 2, 0, 1, 0, 2]);
    assert_eq!(bytes(&tools::List::read()), [2]);
    assert_eq!(bytes(&tools::Bias::write([1.0, -1.0, 0.0]))[..5], [1, 0x3F, 0x80, 0, 0]);
    assert_eq!(bytes(&tools::Formats::new(true, 9, [])), [1, 0, 9]);
}

#[test]
fn optional_parameters_can_be_set_in_order() {
    let command = tools::Settings::write(3, Mode::SLOW, 1).with_limit(0x0102);
    assert_eq!(bytes(&command), [1, 3, 2, 0, 0, 0, 1, 1, 2]);
    assert_eq!(bytes(&command.with_reserved(1))[9..], [1]);
    let hello = tools::Hello::new().with_later([1.0, -2.0]);
    assert_eq!(bytes(&hello)[4..], [0x3F, 0xF0, 0, 0, 0, 0, 0, 0, 0xC0, 0, 0, 0, 0, 0, 0, 0]);
    let gap = tools::Settings::write(3, Mode::SLOW, 1).with_reserved(1);
    assert_eq!(gap.to_vec().map_err(|e| e.kind), Err(EncodeErrorKind::Missing));
    let mut short = tools::Settings::write(3, Mode::SLOW, 1).into_command();
    short.baud = None;
    assert_eq!(short.to_vec().map_err(|e| e.kind), Err(EncodeErrorKind::Missing));
    // A dummy value behind what the function needs is permitted, but no gap.
    let mut read = tools::Settings::read(3, Mode::SLOW).into_command();
    read.baud = Some(5);
    assert_eq!(bytes(&read), [2, 3, 2, 0, 0, 0, 5]);
    read.mode = None;
    assert_eq!(read.to_vec().map_err(|e| e.kind), Err(EncodeErrorKind::Missing));
}

#[test]
fn what_is_there_beyond_the_required_comes_back() {
    let full = [2, 3, 2, 0, 0, 0, 7, 1, 2, 9];
    for length in 0..=full.len() {
        let data = &full[..length];
        if length < 3 {
            assert_eq!(
                tools::Settings::decode(data).map_err(|e| e.kind),
                Err(DecodeErrorKind::Truncated)
            );
            continue;
        }
        let (field, trailing) = tools::Settings::decode_with_trailing(data).unwrap();
        assert_eq!(field.baud.is_some(), length >= 7);
        assert_eq!(field.limit.is_some(), length >= 9);
        assert_eq!(field.reserved.is_some(), length >= 10);
        assert_eq!(bytes(&field), data[..length - trailing]);
        assert_eq!(trailing, [0, 1, 2, 3, 0, 1, 0, 0][length - 3]);
    }
    // An unknown function needs nothing.
    let (field, trailing) = tools::Settings::decode_with_trailing(&[99]).unwrap();
    assert_eq!((field.function, field.port, trailing), (FunctionSelector(99), None, 0));
    assert_eq!(bytes(&field), [99]);
    assert_eq!(tools::Settings::decode(&[]).map_err(|e| e.kind), Err(DecodeErrorKind::Truncated));
}

#[test]
fn newer_firmware_may_append() {
    let (growing, trailing) = measurements::Growing::decode_with_trailing(&[0, 1]).unwrap();
    assert_eq!((growing.first, growing.second, growing.third, trailing), (1, None, None, 0));
    let (growing, trailing) =
        measurements::Growing::decode_with_trailing(&[0, 1, 0, 2, 9]).unwrap();
    assert_eq!((growing.second, growing.third, trailing), (Some(2), None, 1));
    assert_eq!(tools::Ping::decode_with_trailing(&[1, 2, 3]), Ok((tools::Ping, 3)));
}

#[test]
fn a_reader_tells_its_last_error() {
    let mut reader = Reader::new(&[7]);
    assert!(reader.counted::<List<u8, 4>>(5_u8).is_err());
    let error = reader.error("list");
    assert_eq!((error.kind, error.need, error.got), (DecodeErrorKind::Count, 5, 1));
    assert!(reader.read::<u16>().is_err());
    let error = reader.error("number");
    assert_eq!((error.kind, error.need, error.got), (DecodeErrorKind::Truncated, 2, 1));
}

#[test]
fn a_zero_count_behind_a_read_comes_back() {
    let (list, trailing) = tools::List::decode_with_trailing(&[2, 0]).unwrap();
    assert_eq!((&list.items, trailing), (&Some(List::new()), 0));
    assert_eq!(bytes(&list), [2, 0]);
    assert_eq!(tools::List::decode(&[2, 9, 0]).map_err(|e| e.kind), Err(DecodeErrorKind::Count));
    assert_eq!(tools::List::decode(&[1, 1, 0]).map_err(|e| e.kind), Err(DecodeErrorKind::Count));
    assert_eq!(tools::List::decode(&[1]).map_err(|e| e.kind), Err(DecodeErrorKind::Truncated));
}

// ----------------------------------------------------------------------------------------- unions

#[test]
fn a_union_knows_its_tag() {
    let circle = tools::Circle::new(Point::new(1, -2), tools::CircleFilling::Solid(255));
    assert_eq!(circle.fill, tools::Fill::SOLID);
    let command = tools::Choice::write(1, tools::ChoiceParameters::Circle(circle));
    assert_eq!(command.shape, Some(tools::Shape::CIRCLE));
    assert_eq!(bytes(&command), [1, 1, 1, 0, 1, 0xFF, 0xFE, 1, 0, 0, 0, 255]);
    assert_eq!(tools::Choice::decode(&bytes(&command)), Ok(command.into()));

    let turn = tools::ChoiceParameters::Turn(Quatf { w: 1.0, ..Quatf::default() });
    assert_eq!(bytes(&tools::Choice::write(1, turn)).len(), 19);
    let label = tools::ChoiceParameters::Label(Text::padded("here").unwrap());
    assert_eq!(bytes(&tools::Choice::write(1, label)), b"\x01\x01\x04here    ");
    let none = tools::Choice::write(1, tools::ChoiceParameters::None);
    assert_eq!(bytes(&none), [1, 1, 0]);
    let path = tools::Path::new(true, [Point::new(1, 2)]);
    let path = tools::Choice::write(1, tools::ChoiceParameters::Path(path));
    assert_eq!(bytes(&path), [1, 1, 2, 1, 1, 0, 1, 0, 2]);
    assert_eq!(bytes(&tools::Choice::read(7)), [2, 7]);
}

#[test]
fn a_union_must_be_what_its_tag_says() {
    let mut command = tools::Choice::write(1, tools::ChoiceParameters::None).into_command();
    for parameters in [
        tools::ChoiceParameters::Turn(Quatf::default()),
        tools::ChoiceParameters::Other(tools::Shape::NONE),
        tools::ChoiceParameters::Other(tools::Shape(9)),
    ] {
        command.parameters = Some(parameters);
        assert_eq!(command.to_vec().map_err(|e| e.kind), Err(EncodeErrorKind::Tag));
    }
    command.shape = Some(tools::Shape::TURN);
    command.parameters = Some(tools::ChoiceParameters::Other(tools::Shape::TURN));
    assert_eq!(command.to_vec().map_err(|e| e.kind), Err(EncodeErrorKind::Tag));
    command.shape = None;
    assert_eq!(command.to_vec().map_err(|e| e.kind), Err(EncodeErrorKind::Missing));
}

#[test]
fn an_unknown_tag_survives_and_what_follows_is_left_over() {
    let (command, trailing) = tools::Choice::decode_with_trailing(&[1, 1, 77, 5, 6]).unwrap();
    assert_eq!(command.parameters, Some(tools::ChoiceParameters::Other(tools::Shape(77))));
    assert_eq!(trailing, 2);
    assert_eq!(bytes(&command), [1, 1, 77]);
    // Where the union is not required, one that takes no bytes counts as absent.
    let (command, trailing) = tools::Choice::decode_with_trailing(&[2, 1, 77, 5]).unwrap();
    assert_eq!((command.parameters, trailing), (None, 1));
}

#[test]
fn unions_of_command_and_response_are_one_type() {
    let response = tools::ChoiceResponse::decode(&[1, 0]).unwrap();
    assert_eq!(bytes(&tools::Choice::write(1, response.parameters)), [1, 1, 0]);
}

// ------------------------------------------------------------------------------------- open values

#[test]
fn unknown_values_and_bits_survive() {
    let mut data = bytes(&measurements::Arrays::default());
    data[0] = 0xEE;
    data[3] = 0xFF;
    let field = measurements::Arrays::decode(&data).unwrap();
    assert_eq!(field.modes[0], Mode(0xEE));
    assert_eq!(field.modes[0].name(), None);
    assert_eq!(format!("{:?} {}", field.modes[0], field.modes[0]), "Mode(238) 238");
    assert_eq!(bytes(&field), data);
    assert_eq!(format!("{:?} {}", Mode::FAST, Mode::FAST), "Mode(fast) fast");
    assert_eq!(Mode::VALUES, [Mode::DEFAULT, Mode::FAST, Mode::SLOW]);
    assert_eq!((Mode::from(7), u8::from(Mode(7))), (Mode(7), 7));
}

#[test]
fn a_bool_keeps_its_byte() {
    let mut data = [0; 44];
    data[42] = 7;
    let field = measurements::Numbers::decode(&data).unwrap();
    assert_eq!(field.bool, Bool(7));
    assert!(field.bool.get() && field.bool == true && bool::from(field.bool));
    assert_eq!(bytes(&field), data);
    assert_eq!((Bool::from(true), Bool::from(false)), (Bool::TRUE, Bool::FALSE));
    assert_eq!(format!("{:?} {:?} {:?}", Bool(0), Bool(1), Bool(7)), "false true true(7)");
}

#[test]
fn floats_keep_their_bits() {
    for bits in [0x7FE5_BF7F_u32, 0x7F80_0001, 0xFFFF_FFFF, 0x8000_0000, 1] {
        let data = [&bits.to_be_bytes()[..], &[0; 10]].concat();
        let field = measurements::Accel::decode(&data).unwrap();
        assert_eq!(field.scaled_accel.x.to_bits(), bits);
        assert_eq!(bytes(&field), data);
    }
}

#[test]
fn flags_are_set_cleared_and_read() {
    let mut flags = StateFlags::empty();
    assert!(flags.is_empty() && !flags.ready());
    flags.set_ready(true);
    flags.set_ready(true);
    assert_eq!(flags.0, 1);
    flags.set_level(5);
    flags.set_mode(Mode::SLOW);
    assert_eq!(flags.0, 0x0251);
    flags.set_level(0xFF); // more than fits
    assert_eq!((flags.0, flags.level(), flags.mode()), (0x0271, 7, Mode::SLOW));
    flags.set_ready(false);
    flags.set_ready(false);
    assert_eq!(flags.0, 0x0270);
    assert_eq!(flags.with_hot(true).with_level(0).with_mode(Mode(0)).0, 2);
    assert_eq!(StateFlags::READY | StateFlags::HOT, StateFlags::ANY);
    assert_eq!(StateFlags::ANY & StateFlags::HOT, StateFlags::HOT);
    assert!(
        StateFlags::ANY.contains(StateFlags::HOT) && !StateFlags::HOT.contains(StateFlags::ANY)
    );
    assert!(StateFlags::HOT.intersects(StateFlags::ANY));
    assert!(!StateFlags::HOT.intersects(StateFlags::READY));
    let mut flags = StateFlags(0x8000);
    flags.insert(StateFlags::ANY);
    flags |= StateFlags::READY;
    assert_eq!(flags.0, 0x8003); // reserved bits stay
    flags.remove(StateFlags::HOT);
    assert_eq!(flags.0, 0x8001);
    assert_eq!(format!("{:?}", StateFlags(0x8051)), "StateFlags(ready | level=5 | 0x8000)");
}

#[test]
fn bits_of_bytes_count_from_the_lowest_byte() {
    use mip_protocol::types::Health;
    let mut health = Health::default().with_clock(true).with_power(true).with_last(true);
    assert_eq!((health.0[0], health.0[1], health.0[15]), (1, 2, 0x80));
    health.set_count(0b1011);
    assert_eq!((health.0[3], health.0[4]), (0xC0, 0x02));
    assert_eq!(health.count(), 0b1011);
    health.set_count(0b0100);
    assert_eq!((health.0[3], health.0[4]), (0, 0x01));
    health.set_power(false);
    assert_eq!(health.0[1], 0);
    assert!(health.contains(Health::CLOCK | Health::LAST) && !health.intersects(Health::POWER));
    let field = measurements::Health { result: health, ..Default::default() };
    assert_eq!(bytes(&field)[..16], health.0);
}

// -------------------------------------------------------------------------------- constants and such

#[test]
fn constants_are_sent_and_demanded() {
    let command = tools::Status::new(2);
    assert_eq!(bytes(&command), [0x12, 0x67, 2]);
    assert_eq!(
        tools::Status::decode(&[0x12, 0x68, 2]).map_err(|e| e.kind),
        Err(DecodeErrorKind::Constant)
    );
    assert_eq!(tools::Status::decode(&[0x12]).map_err(|e| e.kind), Err(DecodeErrorKind::Truncated));
    let short = tools::StatusShort { flags: 1 };
    assert_eq!(
        tools::StatusLong::decode(&bytes(&short)).map_err(|e| e.kind),
        Err(DecodeErrorKind::Constant)
    );
    let raw = bytes(&short);
    let raw = RawField { set: 1, descriptor: 0x90, data: &raw };
    assert!(raw.is::<tools::StatusShort>() && !raw.is::<tools::StatusLong>());
    assert_eq!(raw.get::<tools::StatusLong>(), None);
    let found = tools::StatusResponses::from_field(&raw);
    assert_eq!(found, Some(Ok(tools::StatusResponses::Short(short))));
    let found = AnyField::decode_with_trailing(&raw).unwrap().unwrap();
    assert_eq!(found.field, AnyField::ToolsStatusShort(short));
    let neither = RawField { data: &[0x12, 0x67, 3, 0, 0, 0, 0], ..raw };
    assert!(AnyField::decode_with_trailing(&neither).is_none());
    assert_eq!(tools::StatusResponses::from_field(&neither), None);
}

#[test]
fn reserved_parameters_default_to_what_is_to_be_sent() {
    let mut settings = tools::Settings::write(0, Mode::FAST, 1).with_limit(1).into_command();
    assert_eq!(settings.reserved, None);
    settings.reserved = Some(3);
    assert_eq!(bytes(&settings).last(), Some(&3));
    assert_eq!(tools::SettingsResponse::default().reserved, 1);
    assert_eq!(measurements::Arrays::default().offsets, [0; 4]);
}

#[test]
fn tuples_convert_to_structures() {
    assert_eq!(Point::from((1, -2)), Point::new(1, -2));
    let stripes: tools::Stripes = (0.5, 2.0).into();
    assert_eq!((stripes.width, stripes.angle), (0.5, 2.0));
    let path = tools::Path::new(true, [(1, -2).into()]);
    assert_eq!(path.points[..], [Point::new(1, -2)]);
}

#[test]
fn a_bitfield_in_a_loop_is_its_bits() {
    let flags = StateFlags::READY | StateFlags::HOT;
    let mut found = Vec::new();
    for bit in &flags {
        found.push(bit);
    }
    assert_eq!(found, flags.iter().collect::<Vec<_>>());
    assert!(found.len() > 1 && found.into_iter().collect::<StateFlags>() == flags);
}

/// A program that handles some fields, with arms of its own.
fn first_number(field: &RawField<'_>) -> Result<f64, DecodeErrorKind> {
    let number = dispatch!(field, {
        measurements::Accel(accel) => { accel.scaled_accel.x.into() }
        shared::Timestamp(time) => time.tow,
        tools::StatusLong(status) => status.uptime as f64,
        tools::StatusShort(_) => { -1.0 },
        _ => f64::NAN,
    });
    number.map_err(|error| error.kind)
}

#[test]
fn each_field_gets_the_arm_of_its_type() {
    let accel = measurements::Accel { scaled_accel: [2.5, 0.0, 0.0].into(), ..Default::default() };
    let data = bytes(&accel);
    let field = RawField { set: 0x80, descriptor: measurements::Accel::DESCRIPTOR, data: &data };
    assert_eq!(first_number(&field), Ok(2.5));
    assert_eq!(
        dispatch!(field, { measurements::Accel(found) => assert_eq!(found, accel) }),
        Ok(())
    );
    let mut other = false;
    assert_eq!(dispatch!(field, { tools::StatusShort(_) => other = true }), Ok(()));
    assert!(!other);
    let short = RawField { data: &data[..5], ..field };
    assert_eq!(first_number(&short), Err(DecodeErrorKind::Truncated));
    assert!(first_number(&RawField { set: 1, ..field }).unwrap().is_nan());
    let time = bytes(&shared::Timestamp { tow: 7.0, ..Default::default() });
    let descriptor = shared::Timestamp::DESCRIPTOR;
    assert_eq!(first_number(&RawField { set: 0x80, descriptor, data: &time }), Ok(7.0));
    // Several layouts of one descriptor.
    let descriptor = tools::StatusShort::DESCRIPTOR;
    let long = bytes(&tools::StatusLong { flags: 1, uptime: 2 });
    assert_eq!(first_number(&RawField { set: 1, descriptor, data: &long }), Ok(2.0));
    let status = bytes(&tools::StatusShort { flags: 1 });
    assert_eq!(first_number(&RawField { set: 1, descriptor, data: &status }), Ok(-1.0));
}

#[test]
fn a_failed_decode_gives_nothing() {
    let full = bytes(&measurements::Numbers::default());
    for length in 0..full.len() {
        let decoded = measurements::Numbers::decode(&full[..length]);
        assert_eq!(decoded.map_err(|e| e.kind), Err(DecodeErrorKind::Truncated));
    }
    assert_eq!(
        tools::Formats::decode(&[0, 2, 0, 1]).map_err(|e| e.kind),
        Err(DecodeErrorKind::Count)
    );
}

#[test]
fn encoding_into_too_little_room_is_refused() {
    let field = measurements::Numbers::default();
    for length in 0..44 {
        assert_eq!(
            field.encode(&mut vec![0; length]).map_err(|e| e.kind),
            Err(EncodeErrorKind::Length)
        );
    }
    assert_eq!(field.encode(&mut [0; 44]), Ok(44));
    assert_eq!(field.encode(&mut [0; 400]), Ok(44));
}

#[test]
fn awkward_names_are_usable() {
    let field = mip_3d::Default { class: 1, type_: 2, register: 3, self_: 4, present: 5 };
    assert_eq!(bytes(&field), [1, 2, 3, 4, 5]);
    assert_eq!(bytes(&mip_3d::Default::new(1, 2, 3, 4, 5)), [1, 2, 3, 4, 5]);
    assert_eq!(mip_3d::Default::NAME, "3d.default");
}

// ------------------------------------------------------------------------------------------- links

fn answers<C: Command, R: ResponseOf<C>>() -> (&'static str, &'static str) {
    (C::NAME, R::NAME)
}

fn answered<C: Command<Response = R>, R: Response>() {}

#[test]
fn commands_and_responses_know_each_other() {
    answered::<tools::Ping, ()>();
    answered::<tools::CaptureBias, tools::BiasVector>();
    answered::<tools::Bias, Option<tools::BiasVector>>();
    answered::<Read<tools::Bias>, tools::BiasVector>();
    assert_eq!(answers::<tools::Bias, tools::BiasVector>(), ("tools.bias", "tools.bias_vector"));
    assert_eq!(answers::<tools::CaptureBias, tools::BiasVector>().0, "tools.capture_bias");
    answers::<tools::SetTime, tools::SetTimeFastResponse>();
    answers::<tools::SetTime, tools::SetTimeSlowResponse>();
    let info = registry::FieldInfo::by_name("tools.bias_vector").unwrap();
    assert_eq!(
        (info.role, info.linked),
        (Role::Response, &["tools.bias", "tools.capture_bias"][..])
    );
    let info = registry::FieldInfo::by_name("tools.set_time").unwrap();
    assert_eq!(info.linked, ["tools.set_time_fast_response", "tools.set_time_slow_response"]);
}

#[test]
fn commands_tell_what_to_expect() {
    assert!(tools::Ping.expects_reply() && tools::Ping.response_check().is_none());
    let write = tools::Settings::write(1, Mode::FAST, 1);
    assert!(write.expects_reply() && write.response_check().is_none());
    let read = tools::Settings::read(1, Mode::FAST);
    assert!(read.expects_reply() && read.response_check().is_some());
    let apply = tools::Settings::apply(1, Mode::FAST, 1);
    assert!(!apply.expects_reply() && apply.response_check().is_none());
    assert!(!tools::Formats::new(true, 0, []).expects_reply());
    assert!(tools::Formats::new(false, 0, []).expects_reply());
    assert!(tools::Inventory.response_check().is_some());
    assert_eq!((tools::Ping::TIMEOUT_MS, tools::Status::TIMEOUT_MS), (None, Some(2500)));
}

/// The result of a request is known at compile time.
fn returns<R>(_: &impl Command<Response = R>) {}

#[test]
fn the_type_of_a_command_states_its_answer() {
    returns::<()>(&tools::Ping);
    returns::<tools::InventoryResponse>(&tools::Inventory);
    returns::<tools::SettingsResponse>(&tools::Settings::read(1, Mode::FAST));
    returns::<tools::SetTimeResponses>(&tools::SetTime::read(Mode::FAST));
    returns::<()>(&tools::Settings::write(1, Mode::FAST, 1).with_limit(2));
    returns::<()>(&tools::Settings::apply(1, Mode::FAST, 1));
    // A function that is known only at run time may have a response.
    let read: tools::Settings = tools::Settings::read(1, Mode::FAST).into();
    returns::<Option<tools::SettingsResponse>>(&read);
    // The response never answers another function.
    assert_eq!(tools::Settings::save(1).function, FunctionSelector::SAVE);
    assert_eq!(<Save<tools::Settings> as Command>::RESPONSES, [0x82]);
}

#[test]
fn a_call_is_a_field_with_one_function() {
    let read = tools::Settings::read(1, Mode::FAST);
    assert_eq!(read.function, Read::<tools::Settings>::FUNCTION);
    assert_eq!(format!("{read:?}"), format!("{:?}", *read));
    let packet = PacketBuilder::with(&read).unwrap();
    assert_eq!(packet.packet().find::<Read<tools::Settings>>(), Some(Ok(read)));
    assert_eq!(packet.packet().find::<Write<tools::Settings>>(), None);
    assert_eq!(packet.packet().find::<tools::Settings>(), Some(Ok(read.into())));
    assert_eq!(AnyField::from(read), AnyField::from(read.into_command()));
    let other = Write::<tools::Settings>::decode(&bytes(&read)).unwrap_err();
    assert_eq!((other.kind, other.need, other.got), (DecodeErrorKind::Constant, 1, 2));
    let empty = Write::<tools::Settings>::decode(&[]).unwrap_err();
    assert_eq!(empty.kind, DecodeErrorKind::Truncated);
}

#[test]
fn a_layout_is_one_type_in_all_its_sets() {
    use measurements::{Accel, Own, Radio, Strings, COPY_SET, MEASUREMENTS_SET, MORE_SET};
    assert_eq!((MEASUREMENTS_SET, MORE_SET, COPY_SET), (0x80, 0x81, 0x92));
    assert_eq!(Accel::SETS, [MEASUREMENTS_SET, MORE_SET, COPY_SET]);
    assert_eq!((Strings::SETS, Radio::SETS), (&[0x80, 0x81, 0x92][..], &[0x80, 0x92][..]));
    let accel = Accel::default();
    let data = bytes(&accel);
    for (set, name, title) in [
        (MEASUREMENTS_SET, "measurements.accel", "Acceleration"),
        (MORE_SET, "more.accel", "Second acceleration"),
        (COPY_SET, "copy.accel", "Third acceleration"),
    ] {
        let raw = RawField { set, descriptor: Accel::DESCRIPTOR, data: &data };
        assert_eq!(raw.get(), Some(Ok(accel)));
        let found = AnyField::decode_with_trailing(&raw).unwrap().unwrap();
        assert_eq!((found.set, &found.field), (set, &AnyField::MeasurementsAccel(accel)));
        assert_eq!((found.name(), found.title()), (name, title));
        let info = registry::FieldInfo::by_name(name).unwrap();
        assert_eq!((info, info.name), (found.field.info(), "measurements.accel"));
        assert_eq!((info.name_in(set), info.title_in(set)), (Some(name), Some(title)));
        assert_eq!((info.name_in(0x82), info.title_in(0x82), info.set()), (None, None, None));
        let mut packet = PacketBuilder::new(set);
        packet.push(&accel).unwrap();
        assert_eq!(packet.packet().find(), Some(Ok(accel)));
    }
    let other = RawField { set: 0x82, descriptor: Accel::DESCRIPTOR, data: &data };
    assert!(!other.is::<Accel>() && other.get::<Accel>().is_none());
    assert!(AnyField::decode_with_trailing(&other).is_none());
    // The same descriptor has another layout in one of the sets.
    assert_eq!(
        (Own::DESCRIPTOR, Own::SET, Own::SETS),
        (Radio::DESCRIPTOR, MORE_SET, &[MORE_SET][..])
    );
    let raw = RawField { set: MORE_SET, descriptor: 7, data: &[2; 40] };
    assert!(raw.is::<Own>() && !raw.is::<Radio>());
    let found = AnyField::decode_with_trailing(&raw).unwrap().unwrap();
    assert_eq!((found.name(), found.left_over), ("more.own", 39));
    assert_eq!(found.field.info().set(), Some(MORE_SET));
    for set in [MEASUREMENTS_SET, COPY_SET] {
        let raw = RawField { set, ..raw };
        assert!(raw.is::<Radio>() && !raw.is::<Own>());
        assert!(matches!(
            AnyField::decode_with_trailing(&raw).unwrap().unwrap().field,
            AnyField::MeasurementsRadio(_)
        ));
    }
}

#[test]
fn the_registry_finds_every_field() {
    for info in registry::FIELDS {
        assert_eq!(registry::FieldInfo::by_name(info.name), Some(info));
    }
    let raw = RawField { set: 0x83, descriptor: 0xD3, data: &[0; 10] };
    assert_eq!(registry::FieldInfo::of(&raw).unwrap().name, "shared.timestamp");
    assert_eq!(raw.get::<shared::Timestamp>(), Some(Ok(shared::Timestamp::default())));
    let raw = RawField { set: 0x7F, descriptor: 0xF1, data: &[1, 3] };
    let any = AnyField::decode_with_trailing(&raw).unwrap().unwrap().field;
    let ack = protocol::Acknowledge { command: 1, code: protocol::AckCode::INVALID_PARAMETER };
    assert_eq!(any, AnyField::ProtocolAcknowledge(ack));
    let mut buffer = [0; 2];
    assert_eq!((any.encode(&mut buffer), buffer), (Ok(2), [1, 3]));
    assert!(registry::FieldInfo::of(&RawField { set: 0x80, descriptor: 0x63, data: &[] }).is_none());
}

#[test]
fn the_registry_describes_values() {
    let of = |name| registry::FieldInfo::by_name(name).unwrap().parameters();
    let [accel, flags] = of("measurements.accel") else { panic!() };
    assert_eq!(
        (accel.name, accel.elements, accel.units),
        ("scaled_accel", &["x", "y", "z"][..], &["g"][..])
    );
    assert_eq!((accel.frame, accel.members), (Some("sensor"), &[][..]));
    assert_eq!(
        (flags.name, flags.elements, flags.units, flags.frame),
        ("valid_flags", &[][..], &[][..], None)
    );
    // The members of structures and unions are listed, but nothing that follows from the rest.
    let names = |all: &[registry::ParameterInfo]| all.iter().map(|p| p.name).collect::<Vec<_>>();
    assert_eq!(
        names(of("measurements.gust")),
        ["station", "place", "height", "speed", "valid_flags"]
    );
    assert_eq!(names(of("measurements.gust")[1].members), ["x", "y"]);
    let cases = of("tools.choice").last().unwrap().members;
    assert_eq!((cases[0].name, cases[0].members[0].members[0].units), ("circle", &["m"][..]));
    assert!(of("tools.ping").is_empty());
}

#[test]
fn numbers_are_read_by_what_they_depend_on() {
    let pin = tools::Pin::write(tools::Drive::SERIAL, 0x21);
    assert_eq!(pin.use_as_serial_use(), Some(tools::SerialUse::TRANSMIT));
    assert_eq!(pin.use_as_pulse_use(), None);
    assert_eq!(tools::Pin::read(tools::Drive::SERIAL).use_as_serial_use(), None);
    let response = tools::PinResponse { drive: tools::Drive::PULSE, use_: 2 };
    assert_eq!(response.use_as_pulse_use(), Some(tools::PulseUse::OUTPUT));
    let status = tools::StatusShort { flags: 0x101 };
    assert!(status.flags_as_model_a_faults().contains(tools::ModelAFaults::SENSOR));
    assert!(status.flags_as_model_b_faults().general());
    let ack = protocol::Acknowledge { command: 1, code: protocol::AckCode(1) };
    assert_eq!(ack.code_as_mode(), Mode::FAST);
}

#[test]
fn devices_tell_what_they_support() {
    let a = devices::Profile::by_id("model-a").unwrap();
    assert_eq!((a, a.title, a.model_number), (&devices::MODEL_A, "Model A", Some(4711)));
    assert!(a.has::<tools::Choice>() && !devices::MODEL_B.has::<tools::Choice>());
    assert_eq!((a.base_rate(0x80), a.base_rate(0x01)), (Some(1000.0), None));
    assert_eq!(devices::MODEL_B.base_rate(0x80), Some(0.0));
    assert_eq!((a.limit("range"), a.limit("nothing")), (Some(2.5), None));
    assert_eq!((a.ports[0].id, a.ports[0].baud_rates), (Some(0x11), &[9600, 115_200][..]));
    let b = devices::MODEL_B.field(0x01, 0x02).unwrap();
    assert_eq!(b.functions, [FunctionSelector::WRITE, FunctionSelector::READ]);
    assert_eq!(a.field(0x01, 0x02).unwrap().functions.len(), 6);
    assert_eq!(devices::MODEL_B.ack_codes.len(), 2);
    let variants = devices::MODEL_B.variants;
    let ack = variants.iter().find(|v| v.parameter == "protocol.acknowledge.code").unwrap();
    assert_eq!((ack.read_as, ack.difference), (Some("mode"), "values of mode"));
    let accel = variants.iter().find(|v| v.parameter == "measurements.accel.scaled_accel").unwrap();
    assert_eq!(accel.read_as, None);
    assert!(accel.difference.starts_with("unit m, m, s; frame ned"));
    assert_eq!(Mode::from(protocol::AckCode(1)), Mode::FAST);
    assert_eq!(devices::ALL.len(), 5);
}

#[test]
fn devices_tell_what_is_not_certain() {
    let old = devices::Profile::by_model(4001).unwrap();
    assert_eq!(Some(old), devices::Profile::find("First"));
    assert_eq!((old.generation, old.manual, old.also), (Some(1), None, &["First"][..]));
    assert_eq!(old.incomplete, ["No manual is known; see `tools.ping`."]);
    assert!(
        old.has::<tools::Ping>()
            && old.has::<measurements::Numbers>()
            && !old.has::<tools::Choice>()
    );
    assert_eq!(old.support(0x01, 0x01), devices::Support::Yes);
    assert_eq!(old.support(0x80, 0x02), devices::Support::Probable);
    assert_eq!(old.support(0x80, 0x03), devices::Support::Unknown);
    let why = old.field(0x80, 0x02).unwrap().evidence.why;
    assert_eq!(why, "Supported by devices of the same generation, Model A and Model B.");
    assert_eq!(devices::MODEL_C.support(0x01, 0x08), devices::Support::No);
    assert_eq!(devices::MODEL_B.support(0x01, 0x08), devices::Support::No);
    assert!(!devices::MODEL_C.has::<tools::Choice>());
    assert_eq!(devices::Profile::find("Model See"), Some(&devices::MODEL_C));
    assert_eq!(devices::Profile::find("model-a").and_then(|d| d.manual), Some("guide"));
    assert!(devices::Profile::find("Model").is_none() && devices::Profile::by_model(0).is_none());
}

#[test]
fn model_numbers_begin_model_and_serial_numbers() {
    let found = [
        "6254",
        "  6254-4220      ",
        "6251.12345",
        "6254 x",
        "6253\0\0",
        "06254",
        "65535",
        "625",
        " 42-1",
    ];
    let numbers = [6254, 6254, 6251, 6254, 6253, 6254, 65535, 625, 42];
    for (text, number) in found.into_iter().zip(numbers) {
        assert_eq!(devices::model_number(text), Some(number), "{text:?}");
    }
    let not = [
        "",
        " ",
        "-",
        "GX5-15",
        "6254x",
        "-6254",
        "65536",
        "99999999999",
        "0000",
        "+6254",
        "6254\u{b2}",
    ];
    for text in not {
        assert_eq!(devices::model_number(text), None, "{text:?}");
    }
}

#[test]
fn vectors_are_arrays_with_names() {
    let vector = Vector3f { x: 1.0, y: 2.0, z: 3.0 };
    assert_eq!((vector.to_array(), Vector3f::from([1.0, 2.0, 3.0])), ([1.0, 2.0, 3.0], vector));
    let [w, ..]: [f32; 4] = Quatf { w: 9.0, ..Quatf::default() }.into();
    assert_eq!(w, 9.0);
}

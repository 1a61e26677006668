//! The types of fields: presence, constructors, unions, open values, links.

#![allow(deprecated)] // of the fields that are tested here

use mip_protocol::dynamic::{FromValue, ToValue, Value, ValueError};
use mip_protocol::protocol::{ReadCall, SaveCall, WriteCall};
use mip_protocol::types::{FunctionSelector, Mode, Point, Quatf, Vector3f};
use mip_protocol::{
    devices, measurements, mip_3d, protocol, registry, tools, AnyField, Bool, Command,
    DecodeErrorKind, DescriptorSet, EncodeErrorKind, Field, List, PacketBuilder, RawField, Reader,
    Response, ResponseOf, Role,
};

fn bytes<T: Field>(field: &T) -> Vec<u8> {
    field.to_vec().unwrap()
}

// --------------------------------------------------------------------------------------- presence

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
    let missing = |member| Err((EncodeErrorKind::Missing, member));
    assert_eq!(short.to_vec().map_err(|e| (e.kind, e.member)), missing("baud"));
    // A dummy value behind what the function needs is permitted, but no gap.
    let mut read = tools::Settings::read(3, Mode::SLOW).into_command();
    read.baud = Some(5);
    assert_eq!(bytes(&read), [2, 3, 2, 0, 0, 0, 5]);
    read.mode = None;
    assert_eq!(read.to_vec().map_err(|e| e.kind), Err(EncodeErrorKind::Missing));
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

// ----------------------------------------------------------------------------------------- unions

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
    assert_eq!(command.to_vec().unwrap_err().member, "parameters");
    command.shape = None;
    assert_eq!(
        command.to_vec().map_err(|e| (e.kind, e.member)),
        Err((EncodeErrorKind::Missing, "shape"))
    );
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
    assert!(Mode::VALUES.iter().all(|mode| mode.name().unwrap().parse() == Ok(*mode)));
    assert!("7".parse::<Mode>().is_err());
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

// -------------------------------------------------------------------------------- constants and such

#[test]
fn tuples_convert_to_structures() {
    assert_eq!(Point::from((1, -2)), Point::new(1, -2));
    let stripes: tools::Stripes = (0.5, 2.0).into();
    assert_eq!((stripes.width, stripes.angle), (0.5, 2.0));
    let path = tools::Path::new(true, [(1, -2).into()]);
    assert_eq!(path.points[..], [Point::new(1, -2)]);
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
    answered::<ReadCall<tools::Bias>, tools::BiasVector>();
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
    assert_eq!(<SaveCall<tools::Settings> as Command>::RESPONSES, [0x82]);
}

#[test]
fn a_call_is_a_field_with_one_function() {
    let read = tools::Settings::read(1, Mode::FAST);
    assert_eq!(read.function, ReadCall::<tools::Settings>::FUNCTION);
    assert_eq!(format!("{read:?}"), format!("{:?}", *read));
    let packet = PacketBuilder::with(&read).unwrap();
    assert_eq!(packet.packet().find::<ReadCall<tools::Settings>>(), Ok(Some(read)));
    assert_eq!(packet.packet().find::<WriteCall<tools::Settings>>(), Ok(None));
    assert_eq!(packet.packet().find::<tools::Settings>(), Ok(Some(read.into())));
    assert_eq!(AnyField::from(read), AnyField::from(read.into_command()));
    let other = WriteCall::<tools::Settings>::decode(&bytes(&read)).unwrap_err();
    assert_eq!((other.kind, other.need, other.got), (DecodeErrorKind::Constant, 1, 2));
    let empty = WriteCall::<tools::Settings>::decode(&[]).unwrap_err();
    assert_eq!(empty.kind, DecodeErrorKind::Truncated);
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
fn a_layout_has_the_name_of_its_set() {
    let [first, second] =
        [(0x80, "measurements.accel"), (0x81, "more.accel")].map(|(set, name)| {
            let raw = RawField {
                set: DescriptorSet(set),
                descriptor: measurements::Accel::DESCRIPTOR,
                data: &[0; 14],
            };
            let found = AnyField::decode_with_trailing(&raw).unwrap().unwrap();
            assert_eq!(
                (found.name(), registry::FieldInfo::of(&raw)),
                (name, Some(found.field.info()))
            );
            found.title()
        });
    assert_eq!((first, second), ("Acceleration", "Acceleration"));
    // The same descriptor has another layout in one of the sets, or several in one set.
    let raw = RawField { set: DescriptorSet(0x81), descriptor: 7, data: &[2; 40] };
    assert!(raw.is::<measurements::Own>() && !raw.is::<measurements::Radio>());
    let data = bytes(&tools::StatusShort { flags: 1 });
    let raw = RawField { set: DescriptorSet(1), descriptor: 0x90, data: &data };
    let found = tools::StatusResponses::from_field(&raw);
    assert!(matches!(found, Some(Ok(tools::StatusResponses::Short(_)))));
    let neither = RawField { data: &[0x12, 0x67, 3, 0, 0, 0, 0], ..raw };
    assert_eq!(tools::StatusResponses::from_field(&neither), None);
    assert_eq!(AnyField::decode(&neither), Ok(None));
}

#[test]
fn profiles_are_found_and_tell_what_is_not_certain() {
    let old = devices::Profile::by_model(4001).unwrap();
    assert_eq!(Some(old), devices::Profile::find("First"));
    assert_eq!(devices::Profile::by_id("model-a"), Some(&devices::MODEL_A));
    assert!(devices::Profile::find("Model").is_none() && devices::Profile::by_model(0).is_none());
    assert!(old.has::<tools::Ping>() && old.has::<measurements::Numbers>());
    assert!(!old.has::<tools::Choice>() && !devices::MODEL_C.has::<tools::Choice>());
    assert_eq!(old.support(DescriptorSet(0x80), 0x03), devices::Support::Unknown);
    assert_eq!((devices::MODEL_A.limit("nothing"), devices::ALL.len()), (None, 5));
}

#[test]
fn model_numbers_begin_model_and_serial_numbers() {
    for text in "6254|  6254-4220      |6254.12345|6254 x|6254\0\0|06254".split('|') {
        assert_eq!(devices::model_number(text), Some(6254), "{text:?}");
    }
    assert_eq!(devices::model_number("65535"), Some(65535));
    for text in "| |-|GX5-15|6254x|-6254|65536|99999999999|0000|+6254|6254\u{b2}".split('|') {
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

#[test]
fn values_are_compared_with_their_ranges() {
    assert_eq!(tools::Settings::read(8, Mode::FAST).check(), Ok(()));
    let error = tools::Settings::read(9, Mode::FAST).check().unwrap_err();
    assert_eq!(error.to_string(), "tools.settings.port: 9 is out of range: 0 to 8");
    assert_eq!(tools::Settings::read(9, Mode::FAST).into_command().check(), Err(error));
    assert_eq!(tools::Ping::new().check(), Ok(())); // it has no values
    let turned = |angle| {
        let filling = tools::CircleFilling::Striped(tools::Stripes { width: 1.0, angle });
        let circle = tools::Circle::new(Point::default(), filling);
        tools::Choice::write(1, tools::ChoiceParameters::Circle(circle)).check()
    };
    assert_eq!((turned(180.0), turned(-180.0)), (Ok(()), Ok(())));
    assert_eq!(turned(180.1).map_err(|e| (e.field, e.member)), Err(("tools.choice", "angle")));
    assert!(turned(f32::NAN).is_err());
}

// ------------------------------------------------------------------------------------ trees of values

#[test]
fn a_field_becomes_a_tree_and_comes_back() {
    let settings = tools::Settings::write(1, Mode::SLOW, 9600).into_command();
    let value = settings.to_value();
    let fields = value.as_record().unwrap();
    assert_eq!(fields.names().collect::<Vec<_>>(), ["function", "port", "mode", "baud"]);
    assert_eq!(fields.get("baud"), Some(&Value::Integer(9600)));
    assert_eq!(fields.get("limit"), None);
    assert_eq!(tools::Settings::from_value(&value), Ok(settings));
    let any = AnyField::from_value("tools.settings", &value).unwrap();
    assert_eq!(any.to_value(), value);
    assert_eq!(any, AnyField::ToolsSettings(settings));
}

#[test]
fn values_are_looked_at_by_kind() {
    let value = measurements::Accel::default().to_value();
    let accel = value.as_record().unwrap().get("scaled_accel").unwrap();
    assert!(
        matches!(accel, Value::List(items) if items.len() == 3 && items[0] == Value::Float(0.0))
    );
    assert_eq!(accel.as_record(), None);
}

#[test]
fn floats_come_as_such_or_as_their_bits() {
    assert_eq!(f32::from_value(&Value::Float(1.5)), Ok(1.5));
    assert_eq!(f64::from_value(&Value::Double(1.5)), Ok(1.5));
    assert_eq!(f32::from_value(&Value::Text("0x3fC00000".into())), Ok(1.5));
    let nan = f64::from_value(&Value::Text("0x7ff0000000000001".into())).unwrap();
    assert_eq!(nan.to_bits(), 0x7FF0_0000_0000_0001);
    for bad in ["3fc00000", "0x3fc0", "0x+fc00000", "0x3fc0000000", "", "0x"] {
        assert_eq!(f32::from_value(&Value::Text(bad.into())), Err(ValueError::Range), "{bad}");
    }
    assert_eq!(f32::from_value(&Value::Double(1.5)), Err(ValueError::Range));
    assert_eq!(f32::from_value(&Value::Integer(1)), Err(ValueError::Range));
}

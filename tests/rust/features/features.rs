//! The feature `serde`.

use mip_protocol::types::{Mode, StateFlags, Vector3f};
use mip_protocol::{measurements, mip_3d, mip_9_lives, tools, AnyField, Clock, Field, PacketBuf};
use mip_protocol::{PacketBuilder, Text, Time, Utc, VarText};
use serde::{de::DeserializeOwned, Serialize};
use serde_test::Token::{Bytes, Tuple, TupleEnd, U8};
use serde_test::{assert_de_tokens_error, assert_tokens, Configure};

/// The JSON text of a value, after a round trip.
fn json<T: Serialize + DeserializeOwned + PartialEq + std::fmt::Debug>(value: &T) -> String {
    let text = serde_json::to_string(value).unwrap();
    assert_eq!(&serde_json::from_str::<T>(&text).unwrap(), value);
    text
}

#[test]
fn fields_go_to_json_and_come_back() {
    let call = tools::Settings::write(1, Mode::SLOW, 9600);
    let settings = call.into_command();
    let text =
        r#"{"function":"write","port":1,"mode":"slow","baud":9600,"limit":null,"reserved":null}"#;
    assert_eq!(json(&settings), text);
    assert_eq!(json(&call), text);
    let read = serde_json::from_str::<mip_protocol::protocol::ReadCall<tools::Settings>>(text);
    assert!(read.unwrap_err().to_string().contains("a constant is 0x1 and not 0x2"));
    let accel = measurements::Accel {
        scaled_accel: Vector3f::from([1.0, 2.0, 3.0]),
        valid_flags: StateFlags::READY,
    };
    assert_eq!(json(&accel), r#"{"scaled_accel":[1.0,2.0,3.0],"valid_flags":"ready"}"#);
    assert_eq!(json(&AnyField::ToolsPing(tools::Ping)), r#"{"tools.ping":null}"#);
    assert_eq!(json(&tools::List::write([1, 2]).items), "[1,2]");
    let label = tools::ChoiceParameters::Label(Text::padded("é").unwrap());
    assert_eq!(json(&tools::Choice::write(1, label).parameters), r#"{"label":"é       "}"#);
    for (wrong, error) in [
        (
            r#"{"tools.pong":null}"#,
            "invalid value: string \"tools.pong\", expected the name of a field",
        ),
        (r#"{"tools.bias_vector":{"size":1}}"#, "unknown field `size`"),
    ] {
        let text = serde_json::from_str::<AnyField>(wrong).unwrap_err().to_string();
        assert!(text.starts_with(error) && text.len() < 200, "{text}");
    }
    json(&measurements::Numbers::default());
    json(&measurements::Strings::default());
    json(&measurements::Arrays::default());
    let short = tools::StatusResponses::Short(tools::StatusShort { flags: 1 });
    assert_eq!(json(&short), r#"{"status_short":{"flags":1}}"#);
}

#[test]
fn compact_formats_contain_the_bytes_of_a_field() {
    let bias = AnyField::from(tools::BiasVector { bias: Vector3f::from([1.0, 0.0, 0.0]) });
    let data = [0x3F, 0x80, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
    let tokens = |descriptor, data: &'static [u8]| {
        [Tuple { len: 3 }, U8(1), U8(descriptor), Bytes(data), TupleEnd]
    };
    let data: &'static [u8] = Box::leak(Box::new(data));
    assert_tokens(&bias.compact(), &tokens(tools::BiasVector::DESCRIPTOR, data));
    type Compact = serde_test::Compact<AnyField>;
    assert_de_tokens_error::<Compact>(&tokens(0xEE, &[]), "unknown field 0x1,0xee");
}

#[test]
fn names_are_those_of_the_specification() {
    let field = mip_3d::Default { class: 1, type_: 2, register: 3, self_: 4, present: 5 };
    let text = json(&field);
    assert_eq!(text, r#"{"class":1,"type":2,"register":3,"self":4,"present":5}"#);
    assert_eq!(json(&mip_protocol::Role::Command), "\"command\"");
    let other = tools::ChoiceParameters::Other(tools::Shape(9));
    assert_eq!(json(&other), r#"{"other":9}"#);
    assert!(serde_json::to_string(&(0..9).collect::<mip_protocol::List<u8, 2>>()).is_err());
}

#[test]
fn packets_and_times_are_kept() {
    let packet = PacketBuf::from(&PacketBuilder::with(&tools::Ping).unwrap());
    assert_eq!(json(&packet), "[117,101,1,2,2,1,224,198]");
    let cut = serde_json::from_str::<PacketBuf>("[117,101,1]").unwrap_err();
    assert!(cut.to_string().starts_with("the bytes are not one whole packet"));
    let clock = Clock::ALL[0];
    let time = Time { clock, nanoseconds: -1 };
    let text = format!(r#"{{"clock":"{}","nanoseconds":-1}}"#, clock.name());
    assert_eq!((json(&time), json(&Utc::from_unix_nanoseconds(7))), (text, "7".into()));
}

#[test]
fn arrays_of_any_length_do() {
    let mut long = mip_9_lives::Long::default();
    assert_eq!((long.reserved, long.short, long.optional), ([3; 33], [1; 2], None));
    json(&long);
    long.bytes[39] = 1;
    long.optional = Some([7; 40]);
    let text = json(&long);
    assert!(serde_json::from_str::<mip_9_lives::Long>(&text.replace("[7,", "[")).is_err());
}

#[test]
fn what_does_not_fit_is_refused() {
    assert_eq!(serde_json::from_str::<Text<3>>("\"ab\"").unwrap(), Text(*b"ab "));
    assert!(serde_json::from_str::<Text<3>>("\"abcd\"").is_err());
    assert!(serde_json::from_str::<VarText<3>>("\"€\"").is_err());
    assert!(serde_json::from_str::<mip_protocol::List<u8, 2>>("[1,2,3]").is_err());
    assert!(serde_json::from_str::<Mode>("256").is_err());
}

#[test]
fn readable_formats_have_names() {
    assert_eq!(json(&Mode::SLOW), "\"slow\"");
    assert_eq!(json(&Mode(99)), "99");
    assert_eq!(serde_json::from_str::<Mode>("2").unwrap(), Mode::SLOW);
    for wrong in ["256", "-1", "\"sluggish\"", "null", "1.5"] {
        let error = serde_json::from_str::<Mode>(wrong).unwrap_err().to_string();
        assert!(error.contains("the name of a value, or its number"), "{error}");
    }
    let flags = StateFlags::from(!0);
    let text = json(&flags);
    assert!(text.starts_with("\"ready | "), "{text}");
    assert_eq!(serde_json::from_str::<StateFlags>(&flags.0.to_string()).unwrap(), flags);
    assert_eq!(json(&StateFlags::empty()), "\"\"");
    for wrong in ["\"redy\"", "\"ready=2\"", "\"0x10000\"", "\"0xg\"", "-1", "65536"] {
        assert!(serde_json::from_str::<StateFlags>(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn floats_that_are_no_numbers_keep_their_bits() {
    let bits = [
        0x7FE5_BF7F,
        0xFFC0_0001,
        0x7F80_0001,
        f32::NAN.to_bits(),
        0x7F80_0000,
        0xFF80_0000,
        0x8000_0000,
    ];
    for bits in bits {
        let vector = Vector3f::from([f32::from_bits(bits), 0.1, 1.0]);
        let text = serde_json::to_string(&vector).unwrap();
        let back: Vector3f = serde_json::from_str(&text).unwrap();
        assert_eq!((back.x.to_bits(), back.y, back.z), (bits, 0.1, 1.0), "{text}");
    }
    let text = |x| serde_json::to_string(&Vector3f::from([x, 1.0, f32::NEG_INFINITY])).unwrap();
    assert_eq!(text(f32::from_bits(0x7FE5_BF7F)), r#"["NaN(0x7fe5bf7f)",1.0,"-inf"]"#);
    assert_eq!(text(f32::NAN), r#"["NaN",1.0,"-inf"]"#);
    let numbers = measurements::Numbers {
        float: f32::from_bits(0xFFC0_1234),
        double: f64::from_bits(0x7FF0_0000_0000_0001),
        ..Default::default()
    };
    let text = serde_json::to_string(&numbers).unwrap();
    let back: measurements::Numbers = serde_json::from_str(&text).unwrap();
    assert_eq!(back.float.to_bits(), 0xFFC0_1234, "{text}");
    assert_eq!(back.double.to_bits(), 0x7FF0_0000_0000_0001, "{text}");
    for wrong in ["\"NaN(0x1)x\"", "\"NaN(0x1ffffffff)\"", "\"one\"", "null", "[]"] {
        assert!(serde_json::from_str::<Vector3f>(&format!("[{wrong},0,0]")).is_err(), "{wrong}");
    }
}

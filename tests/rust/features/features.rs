//! What the feature `serde` brings.

use mip_protocol::dynamic::ToValue;
use mip_protocol::types::{Mode, StateFlags, Vector3f};
use mip_protocol::{measurements, mip_3d, mip_9_lives, tools, AnyField, Text, VarText};
use serde::{de::DeserializeOwned, Serialize};

/// There and back again, and what it looks like.
fn json<T: Serialize + DeserializeOwned + PartialEq + std::fmt::Debug>(value: &T) -> String {
    let text = serde_json::to_string(value).unwrap();
    assert_eq!(&serde_json::from_str::<T>(&text).unwrap(), value);
    text
}

#[test]
fn fields_go_to_json_and_come_back() {
    let settings = tools::Settings::write(1, Mode::SLOW, 9600);
    let text = r#"{"function":1,"port":1,"mode":2,"baud":9600,"limit":null,"reserved":null}"#;
    assert_eq!(json(&settings), text);
    let accel = measurements::Accel {
        scaled_accel: Vector3f::from([1.0, 2.0, 3.0]),
        valid_flags: StateFlags::READY,
    };
    assert_eq!(json(&accel), r#"{"scaled_accel":[1.0,2.0,3.0],"valid_flags":1}"#);
    assert_eq!(json(&AnyField::ToolsPing(tools::Ping)), r#"{"tools.ping":null}"#);
    assert_eq!(json(&tools::List::write([1, 2]).items), "[1,2]");
    let label = tools::ChoiceParameters::Label(Text::padded("é").unwrap());
    assert_eq!(json(&tools::Choice::write(1, label).parameters), r#"{"label":"é       "}"#);
    json(&measurements::Numbers::default());
    json(&measurements::Strings::default());
    json(&measurements::Arrays::default());
    let short = tools::StatusResponses::Short(tools::StatusShort { flags: 1 });
    assert_eq!(json(&short), r#"{"status_short":{"flags":1}}"#);
}

#[test]
fn names_are_those_of_the_specification() {
    let field = mip_3d::Default { class: 1, type_: 2, register: 3, self_: 4, present: 5 };
    let text = json(&field);
    assert_eq!(text, r#"{"class":1,"type":2,"register":3,"self":4,"present":5}"#);
    assert_eq!(serde_json::to_string(&field.to_value()).unwrap(), text);
    let accel = measurements::Accel::default();
    assert_eq!(serde_json::to_string(&accel.to_value()).unwrap(), json(&accel));
    assert_eq!(json(&mip_protocol::Role::Command), "\"command\"");
    let other = tools::ChoiceParameters::Other(tools::Shape(9));
    assert_eq!(json(&other), r#"{"other":9}"#);
    assert!(serde_json::to_string(&(0..9).collect::<mip_protocol::List<u8, 2>>()).is_err());
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
fn trees_of_values_have_the_names_of_the_specification() {
    let choice = tools::Choice::write(1, tools::ChoiceParameters::Turn(Default::default()));
    let text = serde_json::to_string(&choice.to_value()).unwrap();
    let wanted = r#"{"function":1,"instance":1,"shape":3,"#.to_owned()
        + r#""parameters":{"rotation":[0.0,0.0,0.0,0.0]}}"#;
    assert_eq!(text, wanted);
    let numbers = measurements::Numbers { u64: u64::MAX, s64: i64::MIN, ..Default::default() };
    let text = serde_json::to_string(&numbers.to_value()).unwrap();
    assert!(text.contains("18446744073709551615") && text.contains("-9223372036854775808"));
}

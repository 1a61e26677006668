//! Fields as trees of values, beyond what the conformance driver does with them.

use mip_protocol::dynamic::{FromValue, ToValue, Value, ValueError};
use mip_protocol::{measurements, tools, types, AnyField, List, Text, VarText};

fn record<const N: usize>(values: [(&str, Value); N]) -> Value {
    Value::Record(values.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
}

#[test]
fn a_field_becomes_a_tree_and_comes_back() {
    let settings = tools::Settings::write(1, types::Mode::SLOW, 9600).into_command();
    let value = settings.to_value();
    let fields = value.as_record().unwrap();
    assert_eq!(fields.names().collect::<Vec<_>>(), ["function", "port", "mode", "baud"]);
    assert_eq!(fields.get("baud"), Some(&Value::Integer(9600)));
    assert_eq!((fields.len(), fields.is_empty(), fields.get("limit")), (4, false, None));
    assert_eq!(tools::Settings::from_value(&value), Ok(settings));
    let any = AnyField::from_value("tools.settings", &value).unwrap();
    assert_eq!(any.to_value(), value);
    assert_eq!(any, AnyField::ToolsSettings(settings));
}

#[test]
fn values_are_looked_at_by_kind() {
    let value = measurements::Accel::default().to_value();
    let accel = value.as_record().unwrap().get("scaled_accel").unwrap();
    assert_eq!(accel.as_list().unwrap().len(), 3);
    assert_eq!(accel.as_list().unwrap()[0].as_f64(), Some(0.0));
    assert_eq!((accel.as_f64(), accel.as_text(), accel.as_record()), (None, None, None));
    assert_eq!(Value::Integer(-3).as_f64(), Some(-3.0));
    assert_eq!(Value::Double(0.5).as_f64(), Some(0.5));
    assert_eq!(Value::Text("a".into()).as_text(), Some("a"));
}

#[test]
fn what_does_not_fit_is_told_apart() {
    let from = |name, value| AnyField::from_value(name, &value).unwrap_err();
    assert_eq!(from("tools.nothing", record([])), ValueError::Unknown);
    assert_eq!(from("tools.ping", record([("extra", Value::Integer(1))])), ValueError::Unknown);
    assert_eq!(from("tools.ping", Value::Integer(1)), ValueError::Kind);
    assert_eq!(from("tools.capture_bias", record([])), ValueError::Missing);
    for number in [-1, 65536, i128::MAX, i128::MIN] {
        let value = record([("time", Value::Integer(number))]);
        assert_eq!(from("tools.capture_bias", value), ValueError::Range);
    }
    let value = record([("time", Value::Text("1".into()))]);
    assert_eq!(from("tools.capture_bias", value), ValueError::Range);
    assert_eq!(types::Point::from_value(&Value::List(Vec::new())), Err(ValueError::Kind));
}

#[test]
fn arrays_and_text_have_their_lengths() {
    let list = |n| Value::List(vec![Value::Integer(1); n]);
    assert_eq!(<[u8; 2]>::from_value(&list(2)), Ok([1, 1]));
    assert_eq!(<[u8; 2]>::from_value(&list(3)), Err(ValueError::Count));
    assert_eq!(List::<u8, 2>::from_value(&list(1)), Ok([1].into()));
    assert_eq!(List::<u8, 2>::from_value(&list(3)), Err(ValueError::Count));
    assert_eq!(List::<u8, 2>::from_value(&Value::Integer(1)), Err(ValueError::Kind));
    let text = |s: &str| Value::Text(s.into());
    assert_eq!(Text::<2>::from_value(&text("ab")), Ok(Text(*b"ab")));
    assert_eq!(Text::<2>::from_value(&text("a")), Ok(Text(*b"a ")));
    assert_eq!(Text::<2>::from_value(&text("abc")), Err(ValueError::Count));
    assert_eq!(VarText::<2>::from_value(&text("€")), Err(ValueError::Range));
    assert_eq!(VarText::<2>::from_value(&list(1)), Err(ValueError::Kind));
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

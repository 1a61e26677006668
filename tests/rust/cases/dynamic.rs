//! Fields as trees of values, beyond what the conformance driver does with them.

use mip_protocol::dynamic::{FromValue, ToValue, Value, ValueError};
use mip_protocol::{measurements, tools, types, AnyField};

#[test]
fn a_field_becomes_a_tree_and_comes_back() {
    let settings = tools::Settings::write(1, types::Mode::SLOW, 9600).into_command();
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

use crate::dynamic::macros::{record, union};

record! {
    crate::tools::Stripes { width, angle }
    "width" => value(width);
    "angle" => value(angle);
}

record! {
    crate::tools::Circle { center, fill, filling }
    "center" => value(center);
    "fill" => value(fill);
    "filling" => union(filling, fill, crate::tools::CircleFilling);
}

union! {
    crate::tools::CircleFilling, crate::tools::Fill;
    EMPTY => Empty;
    SOLID => Solid("solid");
    STRIPED => Striped("striped");
}

record! {
    crate::tools::Path { closed, points }
    "closed" => value(closed);
    "num_points" => counter(points, "points");
    "points" => value(points);
}

record! {
    crate::tools::Ping {}
}

record! {
    crate::tools::Settings { function, port, mode, baud, limit, reserved }
    "function" => value(function);
    "port" => some_value(port);
    "mode" => some_value(mode);
    "baud" => some_value(baud);
    "limit" => some_value(limit);
    "reserved" => some_value(reserved);
}

record! {
    crate::tools::SetTime { function, part, value }
    "function" => value(function);
    "part" => some_value(part);
    "value" => some_value(value);
}

record! {
    crate::tools::Status { selector }
    "selector" => value(selector);
}

record! {
    crate::tools::Bias { function, bias }
    "function" => value(function);
    "bias" => some_value(bias);
}

record! {
    crate::tools::CaptureBias { time }
    "time" => value(time);
}

record! {
    crate::tools::Formats { suppress_ack, checkpoint, segments }
    "suppress_ack" => value(suppress_ack);
    "num_segments" => counter(segments, "segments");
    "checkpoint" => value(checkpoint);
    "segments" => value(segments);
}

record! {
    crate::tools::Choice { function, instance, shape, parameters }
    "function" => value(function);
    "instance" => some_value(instance);
    "shape" => some_value(shape);
    "parameters" => some_union(parameters, shape, crate::tools::ChoiceParameters);
}

union! {
    crate::tools::ChoiceParameters, crate::tools::Shape;
    NONE => None;
    CIRCLE => Circle("circle");
    PATH => Path("path");
    TURN => Turn("rotation");
    LABEL => Label("label");
}

record! {
    crate::tools::List { function, items }
    "function" => value(function);
    "count" => some_counter(items, "items");
    "items" => some_value(items);
}

record! {
    crate::tools::Inventory {}
}

record! {
    crate::tools::Pin { function, drive, use_ }
    "function" => value(function);
    "drive" => some_value(drive);
    "use" => some_value(use_);
}

record! {
    crate::tools::Hello { reserved, later }
    "reserved" => value(reserved);
    "later" => some_value(later);
}

record! {
    crate::tools::SettingsResponse { port, mode, baud, limit, reserved }
    "port" => value(port);
    "mode" => value(mode);
    "baud" => value(baud);
    "limit" => value(limit);
    "reserved" => value(reserved);
}

record! {
    crate::tools::SetTimeFastResponse { value }
    "value" => value(value);
}

record! {
    crate::tools::SetTimeSlowResponse { value }
    "value" => value(value);
}

record! {
    crate::tools::ChoiceResponse { instance, shape, parameters }
    "instance" => value(instance);
    "shape" => value(shape);
    "parameters" => union(parameters, shape, crate::tools::ChoiceParameters);
}

record! {
    crate::tools::ListResponse { items }
    "count" => counter(items, "items");
    "items" => value(items);
}

record! {
    crate::tools::InventoryResponse { descriptors }
    "descriptors" => value(descriptors);
}

record! {
    crate::tools::PinResponse { drive, use_ }
    "drive" => value(drive);
    "use" => value(use_);
}

record! {
    crate::tools::HelloResponse { seen }
    "seen" => value(seen);
}

record! {
    crate::tools::StatusShort { flags }
    "flags" => value(flags);
}

record! {
    crate::tools::StatusLong { flags, uptime }
    "flags" => value(flags);
    "uptime" => value(uptime);
}

record! {
    crate::tools::BiasVector { bias }
    "bias" => value(bias);
}

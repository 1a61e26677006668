use crate::dynamic::macros::{record, union};

record! {
    crate::aiding::MeasurementTime { timebase, reserved, nanoseconds }
    "timebase" => value(timebase);
    "reserved" => value(reserved);
    "nanoseconds" => value(nanoseconds);
}

record! {
    crate::aiding::FrameConfig {
        function,
        frame_id,
        format,
        tracking_enabled,
        translation,
        rotation,
    }
    "function" => value(function);
    "frame_id" => some_value(frame_id);
    "format" => some_value(format);
    "tracking_enabled" => some_value(tracking_enabled);
    "translation" => some_value(translation);
    "rotation" => some_union(rotation, format, crate::aiding::FrameConfigRotation);
}

union! {
    crate::aiding::FrameConfigRotation, crate::aiding::AidingFrameFormat;
    EULER => Euler("euler");
    QUATERNION => Quaternion("quaternion");
}

record! {
    crate::aiding::EchoControl { function, mode }
    "function" => value(function);
    "mode" => some_value(mode);
}

record! {
    crate::aiding::EcefPosition { time, frame_id, position, uncertainty, valid_flags }
    "time" => value(time);
    "frame_id" => value(frame_id);
    "position" => value(position);
    "uncertainty" => value(uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::aiding::LlhPosition {
        time,
        frame_id,
        latitude,
        longitude,
        height,
        uncertainty,
        valid_flags,
    }
    "time" => value(time);
    "frame_id" => value(frame_id);
    "latitude" => value(latitude);
    "longitude" => value(longitude);
    "height" => value(height);
    "uncertainty" => value(uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::aiding::HeightAboveEllipsoid { time, frame_id, height, uncertainty, valid_flags }
    "time" => value(time);
    "frame_id" => value(frame_id);
    "height" => value(height);
    "uncertainty" => value(uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::aiding::EcefVelocity { time, frame_id, velocity, uncertainty, valid_flags }
    "time" => value(time);
    "frame_id" => value(frame_id);
    "velocity" => value(velocity);
    "uncertainty" => value(uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::aiding::NedVelocity { time, frame_id, velocity, uncertainty, valid_flags }
    "time" => value(time);
    "frame_id" => value(frame_id);
    "velocity" => value(velocity);
    "uncertainty" => value(uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::aiding::BodyFrameVelocity { time, frame_id, velocity, uncertainty, valid_flags }
    "time" => value(time);
    "frame_id" => value(frame_id);
    "velocity" => value(velocity);
    "uncertainty" => value(uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::aiding::TrueHeading { time, frame_id, heading, uncertainty, valid_flags }
    "time" => value(time);
    "frame_id" => value(frame_id);
    "heading" => value(heading);
    "uncertainty" => value(uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::aiding::MagneticField { time, frame_id, magnetic_field, uncertainty, valid_flags }
    "time" => value(time);
    "frame_id" => value(frame_id);
    "magnetic_field" => value(magnetic_field);
    "uncertainty" => value(uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::aiding::Pressure { time, frame_id, pressure, uncertainty, valid_flags }
    "time" => value(time);
    "frame_id" => value(frame_id);
    "pressure" => value(pressure);
    "uncertainty" => value(uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::aiding::FrameConfigResponse { frame_id, format, tracking_enabled, translation, rotation }
    "frame_id" => value(frame_id);
    "format" => value(format);
    "tracking_enabled" => value(tracking_enabled);
    "translation" => value(translation);
    "rotation" => union(rotation, format, crate::aiding::FrameConfigRotation);
}

record! {
    crate::aiding::EchoControlResponse { mode }
    "mode" => value(mode);
}

use crate::dynamic::macros::record;

record! {
    crate::sensor::ScaledAccel { scaled_accel }
    "scaled_accel" => value(scaled_accel);
}

record! {
    crate::sensor::ScaledGyro { scaled_gyro }
    "scaled_gyro" => value(scaled_gyro);
}

record! {
    crate::sensor::ScaledMag { scaled_mag }
    "scaled_mag" => value(scaled_mag);
}

record! {
    crate::sensor::DeltaTheta { delta_theta }
    "delta_theta" => value(delta_theta);
}

record! {
    crate::sensor::DeltaVelocity { delta_velocity }
    "delta_velocity" => value(delta_velocity);
}

record! {
    crate::sensor::ComplementaryFilterOrientationMatrix { m }
    "m" => value(m);
}

record! {
    crate::sensor::ComplementaryFilterQuaternion { q }
    "q" => value(q);
}

record! {
    crate::sensor::ComplementaryFilterEulerAngles { roll, pitch, yaw }
    "roll" => value(roll);
    "pitch" => value(pitch);
    "yaw" => value(yaw);
}

record! {
    crate::sensor::ComplementaryFilterStabilizedNorthVector { stabilized_mag }
    "stabilized_mag" => value(stabilized_mag);
}

record! {
    crate::sensor::ComplementaryFilterStabilizedUpVector { stabilized_accel }
    "stabilized_accel" => value(stabilized_accel);
}

record! {
    crate::sensor::GpsTimestamp { tow, week_number, valid_flags }
    "tow" => value(tow);
    "week_number" => value(week_number);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::sensor::TemperatureStatistics { min_temp, max_temp, mean_temp }
    "min_temp" => value(min_temp);
    "max_temp" => value(max_temp);
    "mean_temp" => value(mean_temp);
}

record! {
    crate::sensor::ScaledPressure { scaled_pressure }
    "scaled_pressure" => value(scaled_pressure);
}

record! {
    crate::sensor::OverrangeStatus { status }
    "status" => value(status);
}

record! {
    crate::sensor::Odometer { speed, uncertainty, valid_flags }
    "speed" => value(speed);
    "uncertainty" => value(uncertainty);
    "valid_flags" => value(valid_flags);
}

use crate::dynamic::macros::record;

record! {
    crate::sensor::RawAccel { raw_accel }
    "raw_accel" => value(raw_accel);
}

record! {
    crate::sensor::RawGyro { raw_gyro }
    "raw_gyro" => value(raw_gyro);
}

record! {
    crate::sensor::RawMag { raw_mag }
    "raw_mag" => value(raw_mag);
}

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
    crate::sensor::CompOrientationUpdateMatrix { m }
    "m" => value(m);
}

record! {
    crate::sensor::ComplementaryFilterEulerAngles { roll, pitch, yaw }
    "roll" => value(roll);
    "pitch" => value(pitch);
    "yaw" => value(yaw);
}

record! {
    crate::sensor::OrientationRawTemp { raw_temp }
    "raw_temp" => value(raw_temp);
}

record! {
    crate::sensor::InternalTimestamp { counts }
    "counts" => value(counts);
}

record! {
    crate::sensor::PpsTimestamp { seconds, useconds }
    "seconds" => value(seconds);
    "useconds" => value(useconds);
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
    crate::sensor::RawPressure { raw_pressure }
    "raw_pressure" => value(raw_pressure);
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

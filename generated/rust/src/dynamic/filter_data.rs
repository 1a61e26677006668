use crate::dynamic::macros::record;

record! {
    crate::filter_data::LlhPosition { latitude, longitude, ellipsoid_height, valid_flags }
    "latitude" => value(latitude);
    "longitude" => value(longitude);
    "ellipsoid_height" => value(ellipsoid_height);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::VelocityNed { north, east, down, valid_flags }
    "north" => value(north);
    "east" => value(east);
    "down" => value(down);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::AttitudeQuaternion { q, valid_flags }
    "q" => value(q);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::AttitudeDcm { dcm, valid_flags }
    "dcm" => value(dcm);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::EulerAngles { roll, pitch, yaw, valid_flags }
    "roll" => value(roll);
    "pitch" => value(pitch);
    "yaw" => value(yaw);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::GyroBias { bias, valid_flags }
    "bias" => value(bias);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::AccelBias { bias, valid_flags }
    "bias" => value(bias);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::LlhPositionUncertainty { north, east, down, valid_flags }
    "north" => value(north);
    "east" => value(east);
    "down" => value(down);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::NedVelocityUncertainty { north, east, down, valid_flags }
    "north" => value(north);
    "east" => value(east);
    "down" => value(down);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::EulerAnglesUncertainty { roll, pitch, yaw, valid_flags }
    "roll" => value(roll);
    "pitch" => value(pitch);
    "yaw" => value(yaw);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::GyroBiasUncertainty { bias_uncert, valid_flags }
    "bias_uncert" => value(bias_uncert);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::AccelBiasUncertainty { bias_uncert, valid_flags }
    "bias_uncert" => value(bias_uncert);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::LinearAccel { accel, valid_flags }
    "accel" => value(accel);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::CompAngularRate { gyro, valid_flags }
    "gyro" => value(gyro);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::Wgs84LocalGravityMagnitude { gravity_magnitude, valid_flags }
    "gravity_magnitude" => value(gravity_magnitude);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::Status { filter_state, dynamics_mode, status_flags }
    "filter_state" => value(filter_state);
    "dynamics_mode" => value(dynamics_mode);
    "status_flags" => value(status_flags);
}

record! {
    crate::filter_data::Timestamp { tow, week_number, valid_flags }
    "tow" => value(tow);
    "week_number" => value(week_number);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::QuaternionAttitudeUncertainty { q, valid_flags }
    "q" => value(q);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::GravityVector { gravity, valid_flags }
    "gravity" => value(gravity);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::HeadingUpdateSourceState {
        heading,
        heading_uncertainty,
        source,
        valid_flags,
    }
    "heading" => value(heading);
    "heading_uncertainty" => value(heading_uncertainty);
    "source" => value(source);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::MagneticModel {
        intensity_north,
        intensity_east,
        intensity_down,
        inclination,
        declination,
        valid_flags,
    }
    "intensity_north" => value(intensity_north);
    "intensity_east" => value(intensity_east);
    "intensity_down" => value(intensity_down);
    "inclination" => value(inclination);
    "declination" => value(declination);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::GyroScaleFactor { scale_factor, valid_flags }
    "scale_factor" => value(scale_factor);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::AccelScaleFactor { scale_factor, valid_flags }
    "scale_factor" => value(scale_factor);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::GyroScaleFactorUncertainty { scale_factor_uncertainty, valid_flags }
    "scale_factor_uncertainty" => value(scale_factor_uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::AccelScaleFactorUncertainty { scale_factor_uncertainty, valid_flags }
    "scale_factor_uncertainty" => value(scale_factor_uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::MagBias { bias, valid_flags }
    "bias" => value(bias);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::MagBiasUncertainty { bias_uncertainty, valid_flags }
    "bias_uncertainty" => value(bias_uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::CompensatedAcceleration { accel, valid_flags }
    "accel" => value(accel);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::StandardAtmosphere {
        geometric_altitude,
        geopotential_altitude,
        standard_temperature,
        standard_pressure,
        standard_density,
        valid_flags,
    }
    "geometric_altitude" => value(geometric_altitude);
    "geopotential_altitude" => value(geopotential_altitude);
    "standard_temperature" => value(standard_temperature);
    "standard_pressure" => value(standard_pressure);
    "standard_density" => value(standard_density);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::PressureAltitude { pressure_altitude, valid_flags }
    "pressure_altitude" => value(pressure_altitude);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::DensityAltitude { density_altitude, valid_flags }
    "density_altitude" => value(density_altitude);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::MagOffset { hard_iron, valid_flags }
    "hard_iron" => value(hard_iron);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::MagMatrix { soft_iron, valid_flags }
    "soft_iron" => value(soft_iron);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::MagOffsetUncertainty { hard_iron_uncertainty, valid_flags }
    "hard_iron_uncertainty" => value(hard_iron_uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::MagMatrixUncertainty { soft_iron_uncertainty, valid_flags }
    "soft_iron_uncertainty" => value(soft_iron_uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::MagCovarianceMatrix { covariance, valid_flags }
    "covariance" => value(covariance);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::MagResidualVector { residual, valid_flags }
    "residual" => value(residual);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::AntennaOffsetCorrection { offset, valid_flags }
    "offset" => value(offset);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::AntennaOffsetCorrectionUncertainty { offset_uncertainty, valid_flags }
    "offset_uncertainty" => value(offset_uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::ClockCorrection { receiver_id, bias, bias_drift, valid_flags }
    "receiver_id" => value(receiver_id);
    "bias" => value(bias);
    "bias_drift" => value(bias_drift);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::ClockCorrectionUncertainty {
        receiver_id,
        bias_uncertainty,
        bias_drift_uncertainty,
        valid_flags,
    }
    "receiver_id" => value(receiver_id);
    "bias_uncertainty" => value(bias_uncertainty);
    "bias_drift_uncertainty" => value(bias_drift_uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::MultiAntennaOffsetCorrection { receiver_id, offset, valid_flags }
    "receiver_id" => value(receiver_id);
    "offset" => value(offset);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::MultiAntennaOffsetCorrectionUncertainty {
        receiver_id,
        offset_uncert,
        valid_flags,
    }
    "receiver_id" => value(receiver_id);
    "offset_uncert" => value(offset_uncert);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::EcefPositionUncertainty { pos_uncertainty, valid_flags }
    "pos_uncertainty" => value(pos_uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::EcefVelocityUncertainty { vel_uncertainty, valid_flags }
    "vel_uncertainty" => value(vel_uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::EcefPosition { position_ecef, valid_flags }
    "position_ecef" => value(position_ecef);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::EcefVelocity { velocity_ecef, valid_flags }
    "velocity_ecef" => value(velocity_ecef);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::NedRelativePosition { relative_position, valid_flags }
    "relative_position" => value(relative_position);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::GnssPositionAidingStatus { receiver_id, time_of_week, status, reserved }
    "receiver_id" => value(receiver_id);
    "time_of_week" => value(time_of_week);
    "status" => value(status);
    "reserved" => value(reserved);
}

record! {
    crate::filter_data::GnssAttitudeAidingStatus { tow, status, reserved }
    "tow" => value(tow);
    "status" => value(status);
    "reserved" => value(reserved);
}

record! {
    crate::filter_data::HeadingAidingStatus { tow, type_, reserved }
    "tow" => value(tow);
    "type" => value(type_);
    "reserved" => value(reserved);
}

record! {
    crate::filter_data::AidingMeasurementSummary { time_of_week, source, type_, indicator }
    "time_of_week" => value(time_of_week);
    "source" => value(source);
    "type" => value(type_);
    "indicator" => value(indicator);
}

record! {
    crate::filter_data::OdometerScaleFactorError { scale_factor_error, valid_flags }
    "scale_factor_error" => value(scale_factor_error);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::OdometerScaleFactorErrorUncertainty {
        scale_factor_error_uncertainty,
        valid_flags,
    }
    "scale_factor_error_uncertainty" => value(scale_factor_error_uncertainty);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::GnssDualAntennaStatus {
        time_of_week,
        heading,
        heading_unc,
        fix_type,
        status_flags,
        valid_flags,
    }
    "time_of_week" => value(time_of_week);
    "heading" => value(heading);
    "heading_unc" => value(heading_unc);
    "fix_type" => value(fix_type);
    "status_flags" => value(status_flags);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::filter_data::AidingFrameConfigurationError { frame_id, translation, attitude }
    "frame_id" => value(frame_id);
    "translation" => value(translation);
    "attitude" => value(attitude);
}

record! {
    crate::filter_data::AidingFrameConfigurationErrorUncertainty {
        frame_id,
        translation_unc,
        attitude_unc,
    }
    "frame_id" => value(frame_id);
    "translation_unc" => value(translation_unc);
    "attitude_unc" => value(attitude_unc);
}

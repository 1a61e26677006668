use crate::dynamic::macros::record;

record! {
    crate::filter::ResetNavigationFilter {}
}

record! {
    crate::filter::SetInitialAttitude { roll, pitch, heading }
    "roll" => value(roll);
    "pitch" => value(pitch);
    "heading" => value(heading);
}

record! {
    crate::filter::SetInitialHeadingControl { heading }
    "heading" => value(heading);
}

record! {
    crate::filter::RunNavigationFilter {}
}

record! {
    crate::filter::VehicleDynamicsMode { function, mode }
    "function" => value(function);
    "mode" => some_value(mode);
}

record! {
    crate::filter::SensorToVehicleFrameTransformation { function, roll, pitch, yaw }
    "function" => value(function);
    "roll" => some_value(roll);
    "pitch" => some_value(pitch);
    "yaw" => some_value(yaw);
}

record! {
    crate::filter::SensorToVehicleOffset { function, offset }
    "function" => value(function);
    "offset" => some_value(offset);
}

record! {
    crate::filter::GnssAntennaOffsetControl { function, offset }
    "function" => value(function);
    "offset" => some_value(offset);
}

record! {
    crate::filter::EstimationControlFlags { function, flags }
    "function" => value(function);
    "flags" => some_value(flags);
}

record! {
    crate::filter::GnssAidingSourceControl { function, source }
    "function" => value(function);
    "source" => some_value(source);
}

record! {
    crate::filter::ExternalGnssUpdate {
        tow,
        week_number,
        latitude,
        longitude,
        height,
        velocity,
        position_uncertainty,
        velocity_uncertainty,
    }
    "tow" => value(tow);
    "week_number" => value(week_number);
    "latitude" => value(latitude);
    "longitude" => value(longitude);
    "height" => value(height);
    "velocity" => value(velocity);
    "position_uncertainty" => value(position_uncertainty);
    "velocity_uncertainty" => value(velocity_uncertainty);
}

record! {
    crate::filter::ExternalHeadingUpdate { heading, heading_uncertainty, type_ }
    "heading" => value(heading);
    "heading_uncertainty" => value(heading_uncertainty);
    "type" => value(type_);
}

record! {
    crate::filter::HeadingUpdateControl { function, enable }
    "function" => value(function);
    "enable" => some_value(enable);
}

record! {
    crate::filter::AutoInitializationControl { function, enable }
    "function" => value(function);
    "enable" => some_value(enable);
}

record! {
    crate::filter::AccelerometerNoiseStandardDeviation { function, noise }
    "function" => value(function);
    "noise" => some_value(noise);
}

record! {
    crate::filter::GyroscopeNoiseStandardDeviation { function, noise }
    "function" => value(function);
    "noise" => some_value(noise);
}

record! {
    crate::filter::AccelerometerBiasModelParameters { function, beta, noise }
    "function" => value(function);
    "beta" => some_value(beta);
    "noise" => some_value(noise);
}

record! {
    crate::filter::GyroscopeBiasModelParameters { function, beta, noise }
    "function" => value(function);
    "beta" => some_value(beta);
    "noise" => some_value(noise);
}

record! {
    crate::filter::AutoZupt { function, enable, threshold }
    "function" => value(function);
    "enable" => some_value(enable);
    "threshold" => some_value(threshold);
}

record! {
    crate::filter::ExternalHeadingUpdateWithTime {
        gps_time,
        gps_week,
        heading,
        heading_uncertainty,
        type_,
    }
    "gps_time" => value(gps_time);
    "gps_week" => value(gps_week);
    "heading" => value(heading);
    "heading_uncertainty" => value(heading_uncertainty);
    "type" => value(type_);
}

record! {
    crate::filter::ZeroAngularRateUpdateControl { function, enable, threshold }
    "function" => value(function);
    "enable" => some_value(enable);
    "threshold" => some_value(threshold);
}

record! {
    crate::filter::TareOrientation { function, axes }
    "function" => value(function);
    "axes" => some_value(axes);
}

record! {
    crate::filter::CommandedZupt {}
}

record! {
    crate::filter::CommandedZeroAngularRateUpdate {}
}

record! {
    crate::filter::SetReferencePosition { function, enable, latitude, longitude, altitude }
    "function" => value(function);
    "enable" => some_value(enable);
    "latitude" => some_value(latitude);
    "longitude" => some_value(longitude);
    "altitude" => some_value(altitude);
}

record! {
    crate::filter::MagCaptureAutoCal { function }
    "function" => value(function);
}

record! {
    crate::filter::GravityNoiseStandardDeviation { function, noise }
    "function" => value(function);
    "noise" => some_value(noise);
}

record! {
    crate::filter::PressureAltitudeNoise { function, noise }
    "function" => value(function);
    "noise" => some_value(noise);
}

record! {
    crate::filter::HardIronOffsetNoise { function, noise }
    "function" => value(function);
    "noise" => some_value(noise);
}

record! {
    crate::filter::SoftIronMatrixNoise { function, noise }
    "function" => value(function);
    "noise" => some_value(noise);
}

record! {
    crate::filter::EnableDisableMeasurements { function, control }
    "function" => value(function);
    "control" => some_value(control);
}

record! {
    crate::filter::MagNoise { function, noise }
    "function" => value(function);
    "noise" => some_value(noise);
}

record! {
    crate::filter::MagneticFieldDeclinationSourceControl { function, source, declination }
    "function" => value(function);
    "source" => some_value(source);
    "declination" => some_value(declination);
}

record! {
    crate::filter::GravityMagnitudeErrorAdaptiveMeasurement {
        function,
        adaptive_measurement,
        frequency,
        low_limit,
        high_limit,
        low_limit_uncertainty,
        high_limit_uncertainty,
        minimum_uncertainty,
    }
    "function" => value(function);
    "adaptive_measurement" => some_value(adaptive_measurement);
    "frequency" => some_value(frequency);
    "low_limit" => some_value(low_limit);
    "high_limit" => some_value(high_limit);
    "low_limit_uncertainty" => some_value(low_limit_uncertainty);
    "high_limit_uncertainty" => some_value(high_limit_uncertainty);
    "minimum_uncertainty" => some_value(minimum_uncertainty);
}

record! {
    crate::filter::MagMagnitudeErrorAdaptiveMeasurement {
        function,
        adaptive_measurement,
        frequency,
        low_limit,
        high_limit,
        low_limit_uncertainty,
        high_limit_uncertainty,
        minimum_uncertainty,
    }
    "function" => value(function);
    "adaptive_measurement" => some_value(adaptive_measurement);
    "frequency" => some_value(frequency);
    "low_limit" => some_value(low_limit);
    "high_limit" => some_value(high_limit);
    "low_limit_uncertainty" => some_value(low_limit_uncertainty);
    "high_limit_uncertainty" => some_value(high_limit_uncertainty);
    "minimum_uncertainty" => some_value(minimum_uncertainty);
}

record! {
    crate::filter::MagDipAngleErrorAdaptiveMeasurement {
        function,
        enable,
        frequency,
        high_limit,
        high_limit_uncertainty,
        minimum_uncertainty,
    }
    "function" => value(function);
    "enable" => some_value(enable);
    "frequency" => some_value(frequency);
    "high_limit" => some_value(high_limit);
    "high_limit_uncertainty" => some_value(high_limit_uncertainty);
    "minimum_uncertainty" => some_value(minimum_uncertainty);
}

record! {
    crate::filter::AltitudeAiding { function, selector }
    "function" => value(function);
    "selector" => some_value(selector);
}

record! {
    crate::filter::PitchRollAidingControl { function, aiding }
    "function" => value(function);
    "aiding" => some_value(aiding);
}

record! {
    crate::filter::InclinationSource { function, source, inclination }
    "function" => value(function);
    "source" => some_value(source);
    "inclination" => some_value(inclination);
}

record! {
    crate::filter::MagFieldMagnitudeSource { function, source, magnitude }
    "function" => value(function);
    "source" => some_value(source);
    "magnitude" => some_value(magnitude);
}

record! {
    crate::filter::SensorToVehicleRotationDcm { function, dcm }
    "function" => value(function);
    "dcm" => some_value(dcm);
}

record! {
    crate::filter::SensorToVehicleRotationQuaternion { function, quat }
    "function" => value(function);
    "quat" => some_value(quat);
}

record! {
    crate::filter::AidingMeasurementControl { function, aiding_source, enable }
    "function" => value(function);
    "aiding_source" => some_value(aiding_source);
    "enable" => some_value(enable);
}

record! {
    crate::filter::KinematicConstraint {
        function,
        accel_constraint,
        velocity_constraint,
        angular_constraint,
    }
    "function" => value(function);
    "accel_constraint" => some_value(accel_constraint);
    "velocity_constraint" => some_value(velocity_constraint);
    "angular_constraint" => some_value(angular_constraint);
}

record! {
    crate::filter::NavigationFilterInitialization {
        function,
        wait_for_run_command,
        initial_cond_src,
        auto_heading_alignment_selector,
        initial_heading,
        initial_pitch,
        initial_roll,
        initial_position,
        initial_velocity,
        reference_frame_selector,
    }
    "function" => value(function);
    "wait_for_run_command" => some_value(wait_for_run_command);
    "initial_cond_src" => some_value(initial_cond_src);
    "auto_heading_alignment_selector" => some_value(auto_heading_alignment_selector);
    "initial_heading" => some_value(initial_heading);
    "initial_pitch" => some_value(initial_pitch);
    "initial_roll" => some_value(initial_roll);
    "initial_position" => some_value(initial_position);
    "initial_velocity" => some_value(initial_velocity);
    "reference_frame_selector" => some_value(reference_frame_selector);
}

record! {
    crate::filter::AdaptiveFilterControl { function, level, time_limit }
    "function" => value(function);
    "level" => some_value(level);
    "time_limit" => some_value(time_limit);
}

record! {
    crate::filter::GnssMultiAntennaOffsetControl { function, receiver_id, antenna_offset }
    "function" => value(function);
    "receiver_id" => some_value(receiver_id);
    "antenna_offset" => some_value(antenna_offset);
}

record! {
    crate::filter::RelativePositionConfiguration {
        function,
        source,
        reference_frame_selector,
        reference_coordinates,
    }
    "function" => value(function);
    "source" => some_value(source);
    "reference_frame_selector" => some_value(reference_frame_selector);
    "reference_coordinates" => some_value(reference_coordinates);
}

record! {
    crate::filter::ReferencePointLeverArm { function, ref_point_sel, lever_arm_offset }
    "function" => value(function);
    "ref_point_sel" => some_value(ref_point_sel);
    "lever_arm_offset" => some_value(lever_arm_offset);
}

record! {
    crate::filter::SpeedMeasurement { source, tow, speed, speed_uncertainty }
    "source" => value(source);
    "tow" => value(tow);
    "speed" => value(speed);
    "speed_uncertainty" => value(speed_uncertainty);
}

record! {
    crate::filter::MeasurementSpeedLeverArm { function, source, lever_arm_offset }
    "function" => value(function);
    "source" => some_value(source);
    "lever_arm_offset" => some_value(lever_arm_offset);
}

record! {
    crate::filter::VerticalGyroConstraintControl { function, enable }
    "function" => value(function);
    "enable" => some_value(enable);
}

record! {
    crate::filter::WheeledVehicleConstraintControl { function, enable }
    "function" => value(function);
    "enable" => some_value(enable);
}

record! {
    crate::filter::GnssAntennaOffsetCalibrationControl { function, enable, max_offset }
    "function" => value(function);
    "enable" => some_value(enable);
    "max_offset" => some_value(max_offset);
}

record! {
    crate::filter::VehicleDynamicsModeResponse { mode }
    "mode" => value(mode);
}

record! {
    crate::filter::SensorToVehicleFrameTransformationResponse { roll, pitch, yaw }
    "roll" => value(roll);
    "pitch" => value(pitch);
    "yaw" => value(yaw);
}

record! {
    crate::filter::SensorToVehicleOffsetResponse { offset }
    "offset" => value(offset);
}

record! {
    crate::filter::GnssAntennaOffsetControlResponse { offset }
    "offset" => value(offset);
}

record! {
    crate::filter::EstimationControlFlagsResponse { flags }
    "flags" => value(flags);
}

record! {
    crate::filter::GnssAidingSourceControlResponse { source }
    "source" => value(source);
}

record! {
    crate::filter::HeadingUpdateControlResponse { enable }
    "enable" => value(enable);
}

record! {
    crate::filter::AutoInitializationControlResponse { enable }
    "enable" => value(enable);
}

record! {
    crate::filter::AccelerometerNoiseStandardDeviationResponse { noise }
    "noise" => value(noise);
}

record! {
    crate::filter::GyroscopeNoiseStandardDeviationResponse { noise }
    "noise" => value(noise);
}

record! {
    crate::filter::AccelerometerBiasModelParametersResponse { beta, noise }
    "beta" => value(beta);
    "noise" => value(noise);
}

record! {
    crate::filter::GyroscopeBiasModelParametersResponse { beta, noise }
    "beta" => value(beta);
    "noise" => value(noise);
}

record! {
    crate::filter::AutoZuptResponse { enable, threshold }
    "enable" => value(enable);
    "threshold" => value(threshold);
}

record! {
    crate::filter::ZeroAngularRateUpdateControlResponse { enable, threshold }
    "enable" => value(enable);
    "threshold" => value(threshold);
}

record! {
    crate::filter::SetReferencePositionResponse { enable, latitude, longitude, altitude }
    "enable" => value(enable);
    "latitude" => value(latitude);
    "longitude" => value(longitude);
    "altitude" => value(altitude);
}

record! {
    crate::filter::GravityNoiseStandardDeviationResponse { noise }
    "noise" => value(noise);
}

record! {
    crate::filter::PressureAltitudeNoiseResponse { noise }
    "noise" => value(noise);
}

record! {
    crate::filter::HardIronOffsetNoiseResponse { noise }
    "noise" => value(noise);
}

record! {
    crate::filter::SoftIronMatrixNoiseResponse { noise }
    "noise" => value(noise);
}

record! {
    crate::filter::TareOrientationResponse { axes }
    "axes" => value(axes);
}

record! {
    crate::filter::EnableDisableMeasurementsResponse { control }
    "control" => value(control);
}

record! {
    crate::filter::MagNoiseResponse { noise }
    "noise" => value(noise);
}

record! {
    crate::filter::MagneticFieldDeclinationSourceControlResponse { source, declination }
    "source" => value(source);
    "declination" => value(declination);
}

record! {
    crate::filter::GravityMagnitudeErrorAdaptiveMeasurementResponse {
        adaptive_measurement,
        frequency,
        low_limit,
        high_limit,
        low_limit_uncertainty,
        high_limit_uncertainty,
        minimum_uncertainty,
    }
    "adaptive_measurement" => value(adaptive_measurement);
    "frequency" => value(frequency);
    "low_limit" => value(low_limit);
    "high_limit" => value(high_limit);
    "low_limit_uncertainty" => value(low_limit_uncertainty);
    "high_limit_uncertainty" => value(high_limit_uncertainty);
    "minimum_uncertainty" => value(minimum_uncertainty);
}

record! {
    crate::filter::MagMagnitudeErrorAdaptiveMeasurementResponse {
        adaptive_measurement,
        frequency,
        low_limit,
        high_limit,
        low_limit_uncertainty,
        high_limit_uncertainty,
        minimum_uncertainty,
    }
    "adaptive_measurement" => value(adaptive_measurement);
    "frequency" => value(frequency);
    "low_limit" => value(low_limit);
    "high_limit" => value(high_limit);
    "low_limit_uncertainty" => value(low_limit_uncertainty);
    "high_limit_uncertainty" => value(high_limit_uncertainty);
    "minimum_uncertainty" => value(minimum_uncertainty);
}

record! {
    crate::filter::MagDipAngleErrorAdaptiveMeasurementResponse {
        enable,
        frequency,
        high_limit,
        high_limit_uncertainty,
        minimum_uncertainty,
    }
    "enable" => value(enable);
    "frequency" => value(frequency);
    "high_limit" => value(high_limit);
    "high_limit_uncertainty" => value(high_limit_uncertainty);
    "minimum_uncertainty" => value(minimum_uncertainty);
}

record! {
    crate::filter::AltitudeAidingResponse { selector }
    "selector" => value(selector);
}

record! {
    crate::filter::PitchRollAidingControlResponse { aiding }
    "aiding" => value(aiding);
}

record! {
    crate::filter::InclinationSourceResponse { source, inclination }
    "source" => value(source);
    "inclination" => value(inclination);
}

record! {
    crate::filter::MagFieldMagnitudeSourceResponse { source, magnitude }
    "source" => value(source);
    "magnitude" => value(magnitude);
}

record! {
    crate::filter::SensorToVehicleRotationDcmResponse { dcm }
    "dcm" => value(dcm);
}

record! {
    crate::filter::SensorToVehicleRotationQuaternionResponse { quat }
    "quat" => value(quat);
}

record! {
    crate::filter::AidingMeasurementControlResponse { aiding_source, enable }
    "aiding_source" => value(aiding_source);
    "enable" => value(enable);
}

record! {
    crate::filter::KinematicConstraintResponse {
        accel_constraint,
        velocity_constraint,
        angular_constraint,
    }
    "accel_constraint" => value(accel_constraint);
    "velocity_constraint" => value(velocity_constraint);
    "angular_constraint" => value(angular_constraint);
}

record! {
    crate::filter::NavigationFilterInitializationResponse {
        wait_for_run_command,
        initial_cond_src,
        auto_heading_alignment_selector,
        initial_heading,
        initial_pitch,
        initial_roll,
        initial_position,
        initial_velocity,
        reference_frame_selector,
    }
    "wait_for_run_command" => value(wait_for_run_command);
    "initial_cond_src" => value(initial_cond_src);
    "auto_heading_alignment_selector" => value(auto_heading_alignment_selector);
    "initial_heading" => value(initial_heading);
    "initial_pitch" => value(initial_pitch);
    "initial_roll" => value(initial_roll);
    "initial_position" => value(initial_position);
    "initial_velocity" => value(initial_velocity);
    "reference_frame_selector" => value(reference_frame_selector);
}

record! {
    crate::filter::AdaptiveFilterControlResponse { level, time_limit }
    "level" => value(level);
    "time_limit" => value(time_limit);
}

record! {
    crate::filter::GnssMultiAntennaOffsetControlResponse { receiver_id, antenna_offset }
    "receiver_id" => value(receiver_id);
    "antenna_offset" => value(antenna_offset);
}

record! {
    crate::filter::RelativePositionConfigurationResponse {
        source,
        reference_frame_selector,
        reference_coordinates,
    }
    "source" => value(source);
    "reference_frame_selector" => value(reference_frame_selector);
    "reference_coordinates" => value(reference_coordinates);
}

record! {
    crate::filter::ReferencePointLeverArmResponse { ref_point_sel, lever_arm_offset }
    "ref_point_sel" => value(ref_point_sel);
    "lever_arm_offset" => value(lever_arm_offset);
}

record! {
    crate::filter::MeasurementSpeedLeverArmResponse { source, lever_arm_offset }
    "source" => value(source);
    "lever_arm_offset" => value(lever_arm_offset);
}

record! {
    crate::filter::VerticalGyroConstraintControlResponse { enable }
    "enable" => value(enable);
}

record! {
    crate::filter::WheeledVehicleConstraintControlResponse { enable }
    "enable" => value(enable);
}

record! {
    crate::filter::GnssAntennaOffsetCalibrationControlResponse { enable, max_offset }
    "enable" => value(enable);
    "max_offset" => value(max_offset);
}

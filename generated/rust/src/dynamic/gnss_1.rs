use crate::dynamic::macros::record;

record! {
    crate::gnss_1::GnssLlhPosition {
        latitude,
        longitude,
        ellipsoid_height,
        msl_height,
        horizontal_accuracy,
        vertical_accuracy,
        valid_flags,
    }
    "latitude" => value(latitude);
    "longitude" => value(longitude);
    "ellipsoid_height" => value(ellipsoid_height);
    "msl_height" => value(msl_height);
    "horizontal_accuracy" => value(horizontal_accuracy);
    "vertical_accuracy" => value(vertical_accuracy);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::GnssEcefPosition { x, x_accuracy, valid_flags }
    "x" => value(x);
    "x_accuracy" => value(x_accuracy);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::NedVelocity {
        v,
        speed,
        ground_speed,
        heading,
        speed_accuracy,
        heading_accuracy,
        valid_flags,
    }
    "v" => value(v);
    "speed" => value(speed);
    "ground_speed" => value(ground_speed);
    "heading" => value(heading);
    "speed_accuracy" => value(speed_accuracy);
    "heading_accuracy" => value(heading_accuracy);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::GnssEcefVelocity { v, v_accuracy, valid_flags }
    "v" => value(v);
    "v_accuracy" => value(v_accuracy);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::Dop { gdop, pdop, hdop, vdop, tdop, ndop, edop, valid_flags }
    "gdop" => value(gdop);
    "pdop" => value(pdop);
    "hdop" => value(hdop);
    "vdop" => value(vdop);
    "tdop" => value(tdop);
    "ndop" => value(ndop);
    "edop" => value(edop);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::UtcTime { year, month, day, hour, min, sec, msec, valid_flags }
    "year" => value(year);
    "month" => value(month);
    "day" => value(day);
    "hour" => value(hour);
    "min" => value(min);
    "sec" => value(sec);
    "msec" => value(msec);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::GpsTime { tow, week_number, valid_flags }
    "tow" => value(tow);
    "week_number" => value(week_number);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::ClockInfo { bias, drift, accuracy_estimate, valid_flags }
    "bias" => value(bias);
    "drift" => value(drift);
    "accuracy_estimate" => value(accuracy_estimate);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::FixInfo { fix_type, num_sv, fix_flags, valid_flags }
    "fix_type" => value(fix_type);
    "num_sv" => value(num_sv);
    "fix_flags" => value(fix_flags);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::SvInfo {
        channel,
        satellite_id,
        carrier_noise_ratio,
        azimuth,
        elevation,
        sv_flags,
        valid_flags,
    }
    "channel" => value(channel);
    "satellite_id" => value(satellite_id);
    "carrier_noise_ratio" => value(carrier_noise_ratio);
    "azimuth" => value(azimuth);
    "elevation" => value(elevation);
    "sv_flags" => value(sv_flags);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::GnssHardwareStatus { receiver_state, antenna_state, antenna_power, valid_flags }
    "receiver_state" => value(receiver_state);
    "antenna_state" => value(antenna_state);
    "antenna_power" => value(antenna_power);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::DgpsInfo { age, base_station_id, base_station_status, num_channels, valid_flags }
    "age" => value(age);
    "base_station_id" => value(base_station_id);
    "base_station_status" => value(base_station_status);
    "num_channels" => value(num_channels);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::DgpsChannel {
        satellite_id,
        age,
        range_correction,
        range_rate_correction,
        valid_flags,
    }
    "satellite_id" => value(satellite_id);
    "age" => value(age);
    "range_correction" => value(range_correction);
    "range_rate_correction" => value(range_rate_correction);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::ClockInfo2 {
        bias,
        drift,
        bias_accuracy_estimate,
        drift_accuracy_estimate,
        valid_flags,
    }
    "bias" => value(bias);
    "drift" => value(drift);
    "bias_accuracy_estimate" => value(bias_accuracy_estimate);
    "drift_accuracy_estimate" => value(drift_accuracy_estimate);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::GpsLeapSeconds { leap_seconds, valid_flags }
    "leap_seconds" => value(leap_seconds);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::SbasInfo {
        time_of_week,
        week_number,
        sbas_system,
        sbas_id,
        count,
        sbas_status,
        valid_flags,
    }
    "time_of_week" => value(time_of_week);
    "week_number" => value(week_number);
    "sbas_system" => value(sbas_system);
    "sbas_id" => value(sbas_id);
    "count" => value(count);
    "sbas_status" => value(sbas_status);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::SbasCorrection {
        index,
        count,
        tow,
        week_number,
        gnss_id,
        satellite_id,
        udrei,
        pseudorange_correction,
        iono_correction,
        valid_flags,
    }
    "index" => value(index);
    "count" => value(count);
    "tow" => value(tow);
    "week_number" => value(week_number);
    "gnss_id" => value(gnss_id);
    "satellite_id" => value(satellite_id);
    "udrei" => value(udrei);
    "pseudorange_correction" => value(pseudorange_correction);
    "iono_correction" => value(iono_correction);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::RfErrorDetection {
        rf_band,
        jamming_state,
        spoofing_state,
        reserved,
        valid_flags,
    }
    "rf_band" => value(rf_band);
    "jamming_state" => value(jamming_state);
    "spoofing_state" => value(spoofing_state);
    "reserved" => value(reserved);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::SatelliteStatus {
        index,
        count,
        time_of_week,
        week_number,
        gnss_id,
        satellite_id,
        elevation,
        azimuth,
        health,
        valid_flags,
    }
    "index" => value(index);
    "count" => value(count);
    "time_of_week" => value(time_of_week);
    "week_number" => value(week_number);
    "gnss_id" => value(gnss_id);
    "satellite_id" => value(satellite_id);
    "elevation" => value(elevation);
    "azimuth" => value(azimuth);
    "health" => value(health);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::Raw {
        index,
        count,
        time_of_week,
        week_number,
        receiver_id,
        tracking_channel,
        gnss_id,
        satellite_id,
        signal_id,
        signal_strength,
        quality,
        pseudorange,
        carrier_phase,
        doppler,
        range_uncert,
        phase_uncert,
        doppler_uncert,
        lock_time,
        valid_flags,
    }
    "index" => value(index);
    "count" => value(count);
    "time_of_week" => value(time_of_week);
    "week_number" => value(week_number);
    "receiver_id" => value(receiver_id);
    "tracking_channel" => value(tracking_channel);
    "gnss_id" => value(gnss_id);
    "satellite_id" => value(satellite_id);
    "signal_id" => value(signal_id);
    "signal_strength" => value(signal_strength);
    "quality" => value(quality);
    "pseudorange" => value(pseudorange);
    "carrier_phase" => value(carrier_phase);
    "doppler" => value(doppler);
    "range_uncert" => value(range_uncert);
    "phase_uncert" => value(phase_uncert);
    "doppler_uncert" => value(doppler_uncert);
    "lock_time" => value(lock_time);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::BaseStationInfo {
        time_of_week,
        week_number,
        ecef_pos,
        height,
        station_id,
        indicators,
        valid_flags,
    }
    "time_of_week" => value(time_of_week);
    "week_number" => value(week_number);
    "ecef_pos" => value(ecef_pos);
    "height" => value(height);
    "station_id" => value(station_id);
    "indicators" => value(indicators);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::RtkCorrectionsStatus {
        time_of_week,
        week_number,
        epoch_status,
        dongle_status,
        gps_correction_latency,
        glonass_correction_latency,
        galileo_correction_latency,
        beidou_correction_latency,
        reserved,
        valid_flags,
    }
    "time_of_week" => value(time_of_week);
    "week_number" => value(week_number);
    "epoch_status" => value(epoch_status);
    "dongle_status" => value(dongle_status);
    "gps_correction_latency" => value(gps_correction_latency);
    "glonass_correction_latency" => value(glonass_correction_latency);
    "galileo_correction_latency" => value(galileo_correction_latency);
    "beidou_correction_latency" => value(beidou_correction_latency);
    "reserved" => value(reserved);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::GpsEphemeris {
        index,
        count,
        time_of_week,
        week_number,
        satellite_id,
        health,
        iodec,
        iode,
        t_oc,
        af0,
        af1,
        af2,
        t_gd,
        isc_l1ca,
        isc_l2c,
        t_oe,
        a,
        a_dot,
        mean_anomaly,
        delta_mean_motion,
        delta_mean_motion_dot,
        eccentricity,
        argument_of_perigee,
        omega,
        omega_dot,
        inclination,
        inclination_dot,
        c_ic,
        c_is,
        c_uc,
        c_us,
        c_rc,
        c_rs,
        valid_flags,
    }
    "index" => value(index);
    "count" => value(count);
    "time_of_week" => value(time_of_week);
    "week_number" => value(week_number);
    "satellite_id" => value(satellite_id);
    "health" => value(health);
    "iodec" => value(iodec);
    "iode" => value(iode);
    "t_oc" => value(t_oc);
    "af0" => value(af0);
    "af1" => value(af1);
    "af2" => value(af2);
    "t_gd" => value(t_gd);
    "isc_l1ca" => value(isc_l1ca);
    "isc_l2c" => value(isc_l2c);
    "t_oe" => value(t_oe);
    "a" => value(a);
    "a_dot" => value(a_dot);
    "mean_anomaly" => value(mean_anomaly);
    "delta_mean_motion" => value(delta_mean_motion);
    "delta_mean_motion_dot" => value(delta_mean_motion_dot);
    "eccentricity" => value(eccentricity);
    "argument_of_perigee" => value(argument_of_perigee);
    "omega" => value(omega);
    "omega_dot" => value(omega_dot);
    "inclination" => value(inclination);
    "inclination_dot" => value(inclination_dot);
    "c_ic" => value(c_ic);
    "c_is" => value(c_is);
    "c_uc" => value(c_uc);
    "c_us" => value(c_us);
    "c_rc" => value(c_rc);
    "c_rs" => value(c_rs);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::GlonassEphemeris {
        index,
        count,
        time_of_week,
        week_number,
        satellite_id,
        freq_number,
        tk,
        tb,
        sat_type,
        gamma,
        tau_n,
        x,
        v,
        a,
        health,
        p,
        nt,
        delta_tau_n,
        ft,
        en,
        p1,
        p2,
        p3,
        p4,
        valid_flags,
    }
    "index" => value(index);
    "count" => value(count);
    "time_of_week" => value(time_of_week);
    "week_number" => value(week_number);
    "satellite_id" => value(satellite_id);
    "freq_number" => value(freq_number);
    "tk" => value(tk);
    "tb" => value(tb);
    "sat_type" => value(sat_type);
    "gamma" => value(gamma);
    "tau_n" => value(tau_n);
    "x" => value(x);
    "v" => value(v);
    "a" => value(a);
    "health" => value(health);
    "p" => value(p);
    "nt" => value(nt);
    "delta_tau_n" => value(delta_tau_n);
    "ft" => value(ft);
    "en" => value(en);
    "p1" => value(p1);
    "p2" => value(p2);
    "p3" => value(p3);
    "p4" => value(p4);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::GalileoEphemeris {
        index,
        count,
        time_of_week,
        week_number,
        satellite_id,
        health,
        iodec,
        iode,
        t_oc,
        af0,
        af1,
        af2,
        t_gd,
        isc_l1ca,
        isc_l2c,
        t_oe,
        a,
        a_dot,
        mean_anomaly,
        delta_mean_motion,
        delta_mean_motion_dot,
        eccentricity,
        argument_of_perigee,
        omega,
        omega_dot,
        inclination,
        inclination_dot,
        c_ic,
        c_is,
        c_uc,
        c_us,
        c_rc,
        c_rs,
        valid_flags,
    }
    "index" => value(index);
    "count" => value(count);
    "time_of_week" => value(time_of_week);
    "week_number" => value(week_number);
    "satellite_id" => value(satellite_id);
    "health" => value(health);
    "iodec" => value(iodec);
    "iode" => value(iode);
    "t_oc" => value(t_oc);
    "af0" => value(af0);
    "af1" => value(af1);
    "af2" => value(af2);
    "t_gd" => value(t_gd);
    "isc_l1ca" => value(isc_l1ca);
    "isc_l2c" => value(isc_l2c);
    "t_oe" => value(t_oe);
    "a" => value(a);
    "a_dot" => value(a_dot);
    "mean_anomaly" => value(mean_anomaly);
    "delta_mean_motion" => value(delta_mean_motion);
    "delta_mean_motion_dot" => value(delta_mean_motion_dot);
    "eccentricity" => value(eccentricity);
    "argument_of_perigee" => value(argument_of_perigee);
    "omega" => value(omega);
    "omega_dot" => value(omega_dot);
    "inclination" => value(inclination);
    "inclination_dot" => value(inclination_dot);
    "c_ic" => value(c_ic);
    "c_is" => value(c_is);
    "c_uc" => value(c_uc);
    "c_us" => value(c_us);
    "c_rc" => value(c_rc);
    "c_rs" => value(c_rs);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::BeidouEphemeris {
        index,
        count,
        time_of_week,
        week_number,
        satellite_id,
        health,
        iodec,
        iode,
        t_oc,
        af0,
        af1,
        af2,
        t_gd,
        isc_l1ca,
        isc_l2c,
        t_oe,
        a,
        a_dot,
        mean_anomaly,
        delta_mean_motion,
        delta_mean_motion_dot,
        eccentricity,
        argument_of_perigee,
        omega,
        omega_dot,
        inclination,
        inclination_dot,
        c_ic,
        c_is,
        c_uc,
        c_us,
        c_rc,
        c_rs,
        valid_flags,
    }
    "index" => value(index);
    "count" => value(count);
    "time_of_week" => value(time_of_week);
    "week_number" => value(week_number);
    "satellite_id" => value(satellite_id);
    "health" => value(health);
    "iodec" => value(iodec);
    "iode" => value(iode);
    "t_oc" => value(t_oc);
    "af0" => value(af0);
    "af1" => value(af1);
    "af2" => value(af2);
    "t_gd" => value(t_gd);
    "isc_l1ca" => value(isc_l1ca);
    "isc_l2c" => value(isc_l2c);
    "t_oe" => value(t_oe);
    "a" => value(a);
    "a_dot" => value(a_dot);
    "mean_anomaly" => value(mean_anomaly);
    "delta_mean_motion" => value(delta_mean_motion);
    "delta_mean_motion_dot" => value(delta_mean_motion_dot);
    "eccentricity" => value(eccentricity);
    "argument_of_perigee" => value(argument_of_perigee);
    "omega" => value(omega);
    "omega_dot" => value(omega_dot);
    "inclination" => value(inclination);
    "inclination_dot" => value(inclination_dot);
    "c_ic" => value(c_ic);
    "c_is" => value(c_is);
    "c_uc" => value(c_uc);
    "c_us" => value(c_us);
    "c_rc" => value(c_rc);
    "c_rs" => value(c_rs);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::GpsIonoCorrection { tow, week_number, alpha, beta, valid_flags }
    "tow" => value(tow);
    "week_number" => value(week_number);
    "alpha" => value(alpha);
    "beta" => value(beta);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::GalileoIonoCorrection { tow, week_number, alpha, disturbance_flags, valid_flags }
    "tow" => value(tow);
    "week_number" => value(week_number);
    "alpha" => value(alpha);
    "disturbance_flags" => value(disturbance_flags);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::gnss_1::BeidouIonoCorrection {
        tow,
        week_number,
        alpha,
        beta,
        alpha_correction,
        valid_flags,
    }
    "tow" => value(tow);
    "week_number" => value(week_number);
    "alpha" => value(alpha);
    "beta" => value(beta);
    "alpha_correction" => value(alpha_correction);
    "valid_flags" => value(valid_flags);
}

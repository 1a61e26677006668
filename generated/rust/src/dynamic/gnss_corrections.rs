use crate::dynamic::macros::record;

record! {
    crate::gnss_corrections::BaseStationInfo {
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
    crate::gnss_corrections::RtkCorrectionsStatus {
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

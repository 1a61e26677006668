"""What simulated devices show and do, by full names of fields."""

from __future__ import annotations

from .facts import Behavior, Difference, FieldValues

#: Names of quantities -> unit.
QUANTITIES: dict[str, str | None] = {"device.title": None}

#: Names of effects -> their arguments.
EFFECTS: dict[str, tuple[str, ...]] = {}

#: Data fields and responses -> what their values show.
VALUES: dict[str, FieldValues] = {}

#: Commands -> what they do beside keeping a setting.
COMMANDS: dict[str, Behavior] = {}

#: Devices -> parameters of commands and responses that differ there.
DIFFERENCES: dict[str, dict[str, Difference]] = {
    "3dm-cl5-15": {"filter.heading_source.source": Difference(values=frozenset({0, 3}))},
    "3dm-cl5-25": {"filter.heading_source.source": Difference(values=frozenset({0, 1, 3}))},
    "3dm-cv5-15": {"filter.heading_source.source": Difference(values=frozenset({0, 3}))},
    "3dm-cv5-25": {"filter.heading_source.source": Difference(values=frozenset({0, 1, 3}))},
    "3dm-cv7-ahrs": {
        "3dm.pps_source_control.source": Difference(values=frozenset({0, 3, 4})),
        "filter.aiding_measurement_enable.aiding_source": Difference(
            values=frozenset({4, 5, 65535})
        ),
    },
    "3dm-cv7-ar": {
        "3dm.pps_source_control.source": Difference(values=frozenset({0, 3, 4})),
        "filter.aiding_measurement_enable.aiding_source": Difference(values=frozenset({5, 65535})),
    },
    "3dm-gq4-45": {
        "filter.heading_source.source": Difference(values=frozenset({0, 1, 2, 3})),
        "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
        "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
    },
    "3dm-gq7": {"filter.magnetic_declination_source.source": Difference(values=frozenset({2, 3}))},
    "3dm-gx3-45": {
        "filter.vehicle_dynamics_mode.mode": Difference(values=frozenset({1, 2, 3})),
        "filter.heading_source.source": Difference(values=frozenset({0, 1, 2, 3})),
        "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
        "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
    },
    "3dm-gx4-15": {
        "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
        "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
    },
    "3dm-gx4-25": {
        "filter.heading_source.source": Difference(values=frozenset({0, 1, 3})),
        "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
        "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
    },
    "3dm-gx4-45": {
        "filter.heading_source.source": Difference(values=frozenset({0, 1, 2, 3})),
        "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
        "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
    },
    "3dm-gx5-15": {
        "3dm.uart_baud_rate.baud": Difference(default=115200),
        "3dm.imu_low_pass_filter.frequency": Difference(maximum=250),
        "3dm.complementary_filter.pitch_roll_enable": Difference(default=True),
        "3dm.complementary_filter.heading_enable": Difference(default=True),
        "3dm.device_status.model_number": Difference(constant=6254),
        "filter.heading_source.source": Difference(values=frozenset({0, 3})),
    },
    "3dm-gx5-25": {"filter.heading_source.source": Difference(values=frozenset({0, 1, 3}))},
    "3dm-gx5-35": {
        "3dm.gnss_sbas_settings.enable_sbas": Difference(default=1),
        "3dm.gnss_sbas_settings.sbas_options": Difference(default=3),
        "3dm.gnss_assisted_fix.option": Difference(default=0),
        "3dm.gnss_assisted_fix.flags": Difference(default=255),
        "3dm.device_status.model_number": Difference(constant=6252),
        "system.comm_mode.mode": Difference(default=1),
    },
    "3dm-gx5-45": {
        "3dm.mag_hard_iron_offset.offset": Difference(default=(0, 0, 0)),
        "3dm.uart_baud_rate.baud": Difference(default=115200),
        "3dm.device_status.model_number": Difference(constant=6251),
        "filter.adaptive_filter_options.level": Difference(values=frozenset({0, 2})),
    },
    "3dm-rq1-45-lt": {
        "filter.heading_source.source": Difference(values=frozenset({0, 2, 3})),
        "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
        "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
    },
    "3dm-rq1-45-st": {
        "filter.heading_source.source": Difference(values=frozenset({0, 2, 3})),
        "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
        "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
    },
}

//! The fields, in the form that [`registry!`] takes.

use super::*;

registry! {
    #[cfg(feature = "tools")]
    0x01..=0x01 {
        /// Ping (0x01,0x01).
        ToolsPing(crate::tools::Ping):
            Command 0x01, 0x01, of 1,
            "tools.ping", "Ping",
            [];
        /// Settings (0x01,0x02).
        ToolsSettings(crate::tools::Settings):
            Command 0x01, 0x02, of 1,
            "tools.settings", "Settings",
            ["tools.settings_response"];
        /// Set time (0x01,0x03).
        ToolsSetTime(crate::tools::SetTime):
            Command 0x01, 0x03, of 1,
            "tools.set_time", "Set time",
            ["tools.set_time_fast_response", "tools.set_time_slow_response"];
        /// Status (0x01,0x04).
        ToolsStatus(crate::tools::Status):
            Command 0x01, 0x04, of 1,
            "tools.status", "Status",
            ["tools.status_short", "tools.status_long", "tools.status_old", "tools.status_full"];
        /// Bias (0x01,0x05).
        ToolsBias(crate::tools::Bias):
            Command 0x01, 0x05, of 1,
            "tools.bias", "Bias",
            ["tools.bias_vector"];
        /// Capture bias (0x01,0x06).
        ToolsCaptureBias(crate::tools::CaptureBias):
            Command 0x01, 0x06, of 1,
            "tools.capture_bias", "Capture bias",
            ["tools.bias_vector"];
        /// Formats (0x01,0x07).
        ToolsFormats(crate::tools::Formats):
            Command 0x01, 0x07, of 1,
            "tools.formats", "Formats",
            [];
        /// Choice (0x01,0x08).
        ToolsChoice(crate::tools::Choice):
            Command 0x01, 0x08, of 1,
            "tools.choice", "Choice",
            ["tools.choice_response"];
        /// List (0x01,0x09).
        ToolsList(crate::tools::List):
            Command 0x01, 0x09, of 1,
            "tools.list", "List",
            ["tools.list_response"];
        /// Inventory (0x01,0x0A).
        ToolsInventory(crate::tools::Inventory):
            Command 0x01, 0x0A, of 1,
            "tools.inventory", "Inventory",
            ["tools.inventory_response"];
        /// Pin (0x01,0x0B).
        ToolsPin(crate::tools::Pin):
            Command 0x01, 0x0B, of 1,
            "tools.pin", "Pin",
            ["tools.pin_response"];
        /// Hello (0x01,0x0C).
        ToolsHello(crate::tools::Hello):
            Command 0x01, 0x0C, of 1,
            "tools.hello", "Hello",
            ["tools.hello_response"];
        /// Readings (0x01,0x0D).
        ToolsReadings(crate::tools::Readings):
            Command 0x01, 0x0D, of 1,
            "tools.readings", "Readings",
            ["tools.readings_response"];
        /// Poll (0x01,0x0E).
        ToolsPoll(crate::tools::Poll):
            Command 0x01, 0x0E, of 1,
            "tools.poll", "Poll",
            [];
        /// Settings response (0x01,0x82).
        ToolsSettingsResponse(crate::tools::SettingsResponse):
            Response 0x01, 0x82, of 1,
            "tools.settings_response", "Settings response",
            ["tools.settings"];
        /// Set time response (0x01,0x83).
        ToolsSetTimeFastResponse(crate::tools::SetTimeFastResponse):
            Response 0x01, 0x83, of 1,
            "tools.set_time_fast_response", "Set time response",
            ["tools.set_time"];
        /// Set time response (0x01,0x84).
        ToolsSetTimeSlowResponse(crate::tools::SetTimeSlowResponse):
            Response 0x01, 0x84, of 1,
            "tools.set_time_slow_response", "Set time response",
            ["tools.set_time"];
        /// Choice response (0x01,0x88).
        ToolsChoiceResponse(crate::tools::ChoiceResponse):
            Response 0x01, 0x88, of 1,
            "tools.choice_response", "Choice response",
            ["tools.choice"];
        /// List response (0x01,0x89).
        ToolsListResponse(crate::tools::ListResponse):
            Response 0x01, 0x89, of 1,
            "tools.list_response", "List response",
            ["tools.list"];
        /// Inventory response (0x01,0x8A).
        ToolsInventoryResponse(crate::tools::InventoryResponse):
            Response 0x01, 0x8A, of 1,
            "tools.inventory_response", "Inventory response",
            ["tools.inventory"];
        /// Pin response (0x01,0x8B).
        ToolsPinResponse(crate::tools::PinResponse):
            Response 0x01, 0x8B, of 1,
            "tools.pin_response", "Pin response",
            ["tools.pin"];
        /// Hello response (0x01,0x8C).
        ToolsHelloResponse(crate::tools::HelloResponse):
            Response 0x01, 0x8C, of 1,
            "tools.hello_response", "Hello response",
            ["tools.hello"];
        /// Readings response (0x01,0x8D).
        ToolsReadingsResponse(crate::tools::ReadingsResponse):
            Response 0x01, 0x8D, of 1,
            "tools.readings_response", "Readings response",
            ["tools.readings"];
        /// Status response (0x01,0x90).
        ToolsStatusShort(crate::tools::StatusShort):
            Response 0x01, 0x90, of 4,
            "tools.status_short", "Status response",
            ["tools.status"];
        /// Status response (0x01,0x90).
        ToolsStatusLong(crate::tools::StatusLong):
            Response 0x01, 0x90, of 4,
            "tools.status_long", "Status response",
            ["tools.status"];
        /// Status response (0x01,0x90).
        ToolsStatusOld(crate::tools::StatusOld):
            Response 0x01, 0x90, of 4,
            "tools.status_old", "Status response",
            ["tools.status"];
        /// Status response (0x01,0x90).
        ToolsStatusFull(crate::tools::StatusFull):
            Response 0x01, 0x90, of 4,
            "tools.status_full", "Status response",
            ["tools.status"];
        /// Bias response (0x01,0x9B).
        ToolsBiasVector(crate::tools::BiasVector):
            Response 0x01, 0x9B, of 1,
            "tools.bias_vector", "Bias response",
            ["tools.bias", "tools.capture_bias"];
    }
    #[cfg(feature = "mip_3d")]
    0x0C..=0x0C {
        /// Default (0x0C,0x10).
        Mip3dDefault(crate::mip_3d::Default):
            Command 0x0C, 0x10, of 1,
            "3d.default", "Default",
            [];
    }
    #[cfg(feature = "measurements")]
    0x80..=0x80 {
        /// Acceleration (0x80,0x01).
        MeasurementsAccel(crate::measurements::Accel):
            Data 0x80, 0x01, of 1,
            "measurements.accel", "Acceleration",
            [];
        /// Numbers (0x80,0x02).
        MeasurementsNumbers(crate::measurements::Numbers):
            Data 0x80, 0x02, of 1,
            "measurements.numbers", "Numbers",
            [];
        /// Strings (0x80,0x03).
        MeasurementsStrings(crate::measurements::Strings):
            Data 0x80, 0x03, of 1,
            "measurements.strings", "Strings",
            [];
        /// Health (0x80,0x04).
        MeasurementsHealth(crate::measurements::Health):
            Data 0x80, 0x04, of 1,
            "measurements.health", "Health",
            [];
        /// Arrays (0x80,0x05).
        MeasurementsArrays(crate::measurements::Arrays):
            Data 0x80, 0x05, of 1,
            "measurements.arrays", "Arrays",
            [];
        /// Growing (0x80,0x06).
        MeasurementsGrowing(crate::measurements::Growing):
            Data 0x80, 0x06, of 1,
            "measurements.growing", "Growing",
            [];
        /// Radio (0x80,0x07).
        MeasurementsRadio(crate::measurements::Radio):
            Data 0x80, 0x07, of 1,
            "measurements.radio", "Radio",
            [];
        /// Cloud (0x80,0x08).
        MeasurementsCloud(crate::measurements::Cloud):
            Data 0x80, 0x08, of 1,
            "measurements.cloud", "Cloud",
            [];
        /// Gust (0x80,0x09).
        MeasurementsGust(crate::measurements::Gust):
            Data 0x80, 0x09, of 1,
            "measurements.gust", "Gust",
            [];
        /// Breeze (0x80,0x0A).
        MeasurementsBreeze(crate::measurements::Breeze):
            Data 0x80, 0x0A, of 1,
            "measurements.breeze", "Breeze",
            [];
    }
    #[cfg(feature = "more")]
    0x81..=0x81 {
        /// Second acceleration (0x81,0x01).
        MoreAccel(crate::more::Accel):
            Data 0x81, 0x01, of 1,
            "more.accel", "Second acceleration",
            [];
        /// Strings (0x81,0x03).
        MoreStrings(crate::more::Strings):
            Data 0x81, 0x03, of 1,
            "more.strings", "Strings",
            [];
        /// Own (0x81,0x07).
        MoreOwn(crate::more::Own):
            Data 0x81, 0x07, of 1,
            "more.own", "Own",
            [];
    }
    #[cfg(feature = "copy")]
    0x92..=0x92 {
        /// Third acceleration (0x92,0x01).
        CopyAccel(crate::copy::Accel):
            Data 0x92, 0x01, of 1,
            "copy.accel", "Third acceleration",
            [];
        /// Numbers (0x92,0x02).
        CopyNumbers(crate::copy::Numbers):
            Data 0x92, 0x02, of 1,
            "copy.numbers", "Numbers",
            [];
        /// Strings (0x92,0x03).
        CopyStrings(crate::copy::Strings):
            Data 0x92, 0x03, of 1,
            "copy.strings", "Strings",
            [];
        /// Health (0x92,0x04).
        CopyHealth(crate::copy::Health):
            Data 0x92, 0x04, of 1,
            "copy.health", "Health",
            [];
        /// Arrays (0x92,0x05).
        CopyArrays(crate::copy::Arrays):
            Data 0x92, 0x05, of 1,
            "copy.arrays", "Arrays",
            [];
        /// Growing (0x92,0x06).
        CopyGrowing(crate::copy::Growing):
            Data 0x92, 0x06, of 1,
            "copy.growing", "Growing",
            [];
        /// Radio (0x92,0x07).
        CopyRadio(crate::copy::Radio):
            Data 0x92, 0x07, of 1,
            "copy.radio", "Radio",
            [];
        /// Cloud (0x92,0x08).
        CopyCloud(crate::copy::Cloud):
            Data 0x92, 0x08, of 1,
            "copy.cloud", "Cloud",
            [];
        /// Gust (0x92,0x09).
        CopyGust(crate::copy::Gust):
            Data 0x92, 0x09, of 1,
            "copy.gust", "Gust",
            [];
        /// Breeze (0x92,0x0A).
        CopyBreeze(crate::copy::Breeze):
            Data 0x92, 0x0A, of 1,
            "copy.breeze", "Breeze",
            [];
    }
    #[cfg(feature = "shared")]
    0x80..=0xFF {
        /// Timestamp (0xFF,0xD3).
        SharedTimestamp(crate::shared::Timestamp):
            Data 0xFF, 0xD3, of 1,
            "shared.timestamp", "Timestamp",
            [];
    }
    #[cfg(all())]
    0x01..=0x7F {
        /// Acknowledge (0x00,0xF1).
        ProtocolAcknowledge(crate::protocol::Acknowledge):
            Response 0x00, 0xF1, of 1,
            "protocol.acknowledge", "Acknowledge",
            [];
    }
}

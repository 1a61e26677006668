//! The fields, in the form that [`registry!`] expects.

use super::*;

registry! {
    #[cfg(feature = "tools")]
    0x01 => {
        /// Ping (0x01,0x01).
        ToolsPing(crate::tools::Ping):
            Command 0x01, of 1,
            "tools.ping", "Ping",
            [], {};
        /// Settings (0x01,0x02).
        ToolsSettings(crate::tools::Settings):
            Command 0x02, of 1,
            "tools.settings", "Settings",
            ["tools.settings_response"], {
                "function";
                "port";
                "mode";
                "baud" in ["Bd"];
                "limit";
                "reserved";
            };
        /// Set time (0x01,0x03).
        ToolsSetTime(crate::tools::SetTime):
            Command 0x03, of 1,
            "tools.set_time", "Set time",
            ["tools.set_time_fast_response", "tools.set_time_slow_response"], {
                "function";
                "part";
                "value" in ["s"];
            };
        /// Status (0x01,0x04).
        ToolsStatus(crate::tools::Status):
            Command 0x04, of 1,
            "tools.status", "Status",
            ["tools.status_paged", "tools.status_short", "tools.status_long", "tools.status_old", "tools.status_full"], {
                "selector";
            };
        /// Bias (0x01,0x05).
        ToolsBias(crate::tools::Bias):
            Command 0x05, of 1,
            "tools.bias", "Bias",
            ["tools.bias_vector"], {
                "function";
                "bias": ["x" "y" "z"] in ["g"] of "sensor";
            };
        /// Capture bias (0x01,0x06).
        ToolsCaptureBias(crate::tools::CaptureBias):
            Command 0x06, of 1,
            "tools.capture_bias", "Capture bias",
            ["tools.bias_vector"], {
                "time" in ["s"];
            };
        /// Formats (0x01,0x07).
        ToolsFormats(crate::tools::Formats):
            Command 0x07, of 1,
            "tools.formats", "Formats",
            [], {
                "suppress_ack";
                "checkpoint";
                "segments" {
                    "from" {
                        "x" in ["m"];
                        "y" in ["m"];
                    };
                    "to" {
                        "x" in ["m"];
                        "y" in ["m"];
                    };
                    "weights";
                };
            };
        /// Choice (0x01,0x08).
        ToolsChoice(crate::tools::Choice):
            Command 0x08, of 1,
            "tools.choice", "Choice",
            ["tools.choice_response"], {
                "function";
                "instance";
                "shape";
                "parameters" {
                    "circle" {
                        "center" {
                            "x" in ["m"];
                            "y" in ["m"];
                        };
                        "fill";
                        "filling" {
                            "solid";
                            "striped" {
                                "width" in ["m"];
                                "angle" in ["deg"];
                            };
                        };
                    };
                    "path" {
                        "closed";
                        "points" {
                            "x" in ["m"];
                            "y" in ["m"];
                        };
                    };
                    "rotation": ["w" "x" "y" "z"] in ["1"];
                    "label";
                };
            };
        /// List (0x01,0x09).
        ToolsList(crate::tools::List):
            Command 0x09, of 1,
            "tools.list", "List",
            ["tools.list_response"], {
                "function";
                "items";
            };
        /// Inventory (0x01,0x0A).
        ToolsInventory(crate::tools::Inventory):
            Command 0x0A, of 1,
            "tools.inventory", "Inventory",
            ["tools.inventory_response"], {};
        /// Pin (0x01,0x0B).
        ToolsPin(crate::tools::Pin):
            Command 0x0B, of 1,
            "tools.pin", "Pin",
            ["tools.pin_response"], {
                "function";
                "drive";
                "use";
            };
        /// Hello (0x01,0x0C).
        ToolsHello(crate::tools::Hello):
            Command 0x0C, of 1,
            "tools.hello", "Hello",
            ["tools.hello_response"], {
                "reserved";
                "later";
            };
        /// Readings (0x01,0x0D).
        ToolsReadings(crate::tools::Readings):
            Command 0x0D, of 1,
            "tools.readings", "Readings",
            ["tools.readings_response"], {
                "drive";
            };
        /// Poll (0x01,0x0E).
        ToolsPoll(crate::tools::Poll):
            Command 0x0E, of 1,
            "tools.poll", "Poll",
            [], {
                "descriptor_set";
                "first";
                "descriptors";
            };
        /// Settings response (0x01,0x82).
        ToolsSettingsResponse(crate::tools::SettingsResponse):
            Response 0x82, of 1,
            "tools.settings_response", "Settings response",
            ["tools.settings"], {
                "port";
                "mode";
                "baud" in ["Bd"];
                "limit";
                "reserved";
            };
        /// Set time response (0x01,0x83).
        ToolsSetTimeFastResponse(crate::tools::SetTimeFastResponse):
            Response 0x83, of 1,
            "tools.set_time_fast_response", "Set time response",
            ["tools.set_time"], {
                "value" in ["s"];
            };
        /// Set time response (0x01,0x84).
        ToolsSetTimeSlowResponse(crate::tools::SetTimeSlowResponse):
            Response 0x84, of 1,
            "tools.set_time_slow_response", "Set time response",
            ["tools.set_time"], {
                "value" in ["s"];
            };
        /// Choice response (0x01,0x88).
        ToolsChoiceResponse(crate::tools::ChoiceResponse):
            Response 0x88, of 1,
            "tools.choice_response", "Choice response",
            ["tools.choice"], {
                "instance";
                "shape";
                "parameters" {
                    "circle" {
                        "center" {
                            "x" in ["m"];
                            "y" in ["m"];
                        };
                        "fill";
                        "filling" {
                            "solid";
                            "striped" {
                                "width" in ["m"];
                                "angle" in ["deg"];
                            };
                        };
                    };
                    "path" {
                        "closed";
                        "points" {
                            "x" in ["m"];
                            "y" in ["m"];
                        };
                    };
                    "rotation": ["w" "x" "y" "z"] in ["1"];
                    "label";
                };
            };
        /// List response (0x01,0x89).
        ToolsListResponse(crate::tools::ListResponse):
            Response 0x89, of 1,
            "tools.list_response", "List response",
            ["tools.list"], {
                "items";
            };
        /// Inventory response (0x01,0x8A).
        ToolsInventoryResponse(crate::tools::InventoryResponse):
            Response 0x8A, of 1,
            "tools.inventory_response", "Inventory response",
            ["tools.inventory"], {
                "descriptors";
            };
        /// Pin response (0x01,0x8B).
        ToolsPinResponse(crate::tools::PinResponse):
            Response 0x8B, of 1,
            "tools.pin_response", "Pin response",
            ["tools.pin"], {
                "drive";
                "use";
            };
        /// Hello response (0x01,0x8C).
        ToolsHelloResponse(crate::tools::HelloResponse):
            Response 0x8C, of 1,
            "tools.hello_response", "Hello response",
            ["tools.hello"], {
                "seen" in ["s"];
            };
        /// Readings response (0x01,0x8D).
        ToolsReadingsResponse(crate::tools::ReadingsResponse):
            Response 0x8D, of 1,
            "tools.readings_response", "Readings response",
            ["tools.readings"], {
                "drive";
                "readings" {
                    "kind";
                    "value";
                };
                "last" {
                    "kind";
                    "value";
                };
            };
        /// Status response (0x01,0x90).
        ToolsStatusPaged(crate::tools::StatusPaged):
            Response 0x90, of 5,
            "tools.status_paged", "Status response",
            ["tools.status"], {
                "uptime" in ["s"];
                "level";
            };
        /// Status response (0x01,0x90).
        ToolsStatusShort(crate::tools::StatusShort):
            Response 0x90, of 5,
            "tools.status_short", "Status response",
            ["tools.status"], {
                "flags";
            };
        /// Status response (0x01,0x90).
        ToolsStatusLong(crate::tools::StatusLong):
            Response 0x90, of 5,
            "tools.status_long", "Status response",
            ["tools.status"], {
                "flags";
                "uptime" in ["s"];
            };
        /// Status response (0x01,0x90).
        ToolsStatusOld(crate::tools::StatusOld):
            Response 0x90, of 5,
            "tools.status_old", "Status response",
            ["tools.status"], {
                "uptime" in ["s"];
            };
        /// Status response (0x01,0x90).
        ToolsStatusFull(crate::tools::StatusFull):
            Response 0x90, of 5,
            "tools.status_full", "Status response",
            ["tools.status"], {
                "place" {
                    "x" in ["m"];
                    "y" in ["m"];
                };
                "uptime" in ["s"];
                "mode";
            };
        /// Bias response (0x01,0x9B).
        ToolsBiasVector(crate::tools::BiasVector):
            Response 0x9B, of 1,
            "tools.bias_vector", "Bias response",
            ["tools.bias", "tools.capture_bias"], {
                "bias": ["x" "y" "z"] in ["g"] of "sensor";
            };
    }
    #[cfg(feature = "mip_3d")]
    0x0C => {
        /// Default (0x0C,0x10).
        Mip3dDefault(crate::mip_3d::Default):
            Command 0x10, of 1,
            "3d.default", "Default",
            [], {
                "class";
                "type";
                "register";
                "self";
                "present";
            };
    }
    #[cfg(feature = "measurements")]
    0x80 | 0x81 | 0x92 => {
        /// Acceleration (0x01).
        MeasurementsAccel(crate::measurements::Accel):
            Data 0x01, of 1,
            "measurements.accel", "Acceleration",
            {
                0x80 "measurements.accel",
                0x81 "more.accel" "Second acceleration",
                0x92 "copy.accel" "Third acceleration",
            }
            [], {
                "scaled_accel": ["x" "y" "z"] in ["g"] of "sensor";
                "valid_flags";
            };
        /// Numbers (0x02).
        MeasurementsNumbers(crate::measurements::Numbers):
            Data 0x02, of 1,
            "measurements.numbers", "Numbers",
            {
                0x80 "measurements.numbers",
                0x92 "copy.numbers",
            }
            [], {
                "u8";
                "u16";
                "u32";
                "u64";
                "s8";
                "s16";
                "s32";
                "s64";
                "float" in ["1"];
                "double" in ["1"];
                "bool";
                "char";
            };
        /// Strings (0x03).
        MeasurementsStrings(crate::measurements::Strings):
            Data 0x03, of 1,
            "measurements.strings", "Strings",
            {
                0x80 "measurements.strings",
                0x81 "more.strings",
                0x92 "copy.strings",
            }
            [], {
                "model";
                "name";
                "rest";
            };
        /// Health (0x04).
        MeasurementsHealth(crate::measurements::Health):
            Data 0x04, of 1,
            "measurements.health", "Health",
            {
                0x80 "measurements.health",
                0x92 "copy.health",
            }
            [], {
                "result";
                "code";
            };
        /// Arrays (0x05).
        MeasurementsArrays(crate::measurements::Arrays):
            Data 0x05, of 1,
            "measurements.arrays", "Arrays",
            {
                0x80 "measurements.arrays",
                0x92 "copy.arrays",
            }
            [], {
                "modes";
                "flags";
                "vectors": ["x" "y" "z"] in ["m"];
                "points" in ["m"] {
                    "x" in ["m"];
                    "y" in ["m"];
                };
                "track" {
                    "from" {
                        "x" in ["m"];
                        "y" in ["m"];
                    };
                    "to" {
                        "x" in ["m"];
                        "y" in ["m"];
                    };
                    "weights";
                };
                "offsets";
            };
        /// Growing (0x06).
        MeasurementsGrowing(crate::measurements::Growing):
            Data 0x06, of 1,
            "measurements.growing", "Growing",
            {
                0x80 "measurements.growing",
                0x92 "copy.growing",
            }
            [], {
                "first";
                "second";
                "third" in ["deg"];
            };
        /// Radio (0x07).
        MeasurementsRadio(crate::measurements::Radio):
            Data 0x07, of 1,
            "measurements.radio", "Radio",
            {
                0x80 "measurements.radio",
                0x92 "copy.radio",
            }
            [], {
                "connected";
                "strength";
                "noise" in ["m"];
                "gap";
                "gaps";
            };
        /// Own (0x81,0x07).
        MeasurementsOwn(crate::measurements::Own):
            Data 0x07, of 1,
            "measurements.own", "Own",
            {
                0x81 "more.own",
            }
            [], {
                "mode";
            };
        /// Cloud (0x08).
        MeasurementsCloud(crate::measurements::Cloud):
            Data 0x08, of 1,
            "measurements.cloud", "Cloud",
            {
                0x80 "measurements.cloud",
                0x92 "copy.cloud",
            }
            [], {
                "points" {
                    "x" in ["m"];
                    "y" in ["m"];
                };
                "stamp" in ["s"];
            };
        /// Gust (0x09).
        MeasurementsGust(crate::measurements::Gust):
            Data 0x09, of 1,
            "measurements.gust", "Gust",
            {
                0x80 "measurements.gust",
                0x92 "copy.gust",
            }
            [], {
                "station";
                "place" {
                    "x" in ["m"];
                    "y" in ["m"];
                };
                "height" in ["m"];
                "speed": ["x" "y" "z"] in ["m"];
                "valid_flags";
            };
        /// Breeze (0x0A).
        MeasurementsBreeze(crate::measurements::Breeze):
            Data 0x0A, of 1,
            "measurements.breeze", "Breeze",
            {
                0x80 "measurements.breeze",
                0x92 "copy.breeze",
            }
            [], {
                "place" {
                    "x" in ["m"];
                    "y" in ["m"];
                };
                "height" in ["m"];
                "turn": ["w" "x" "y" "z"] in ["1"];
            };
    }
    #[cfg(feature = "shared")]
    0x80..=0xFE => {
        /// Timestamp (0xFF,0xD3).
        SharedTimestamp(crate::shared::Timestamp):
            Data 0xD3, of 1,
            "shared.timestamp", "Timestamp",
            [], {
                "tow" in ["s"];
                "valid_flags";
            };
    }
    #[cfg(all())]
    0x01..=0x7F => {
        /// Acknowledge (0x00,0xF1).
        ProtocolAcknowledge(crate::protocol::Acknowledge):
            Response 0xF1, of 1,
            "protocol.acknowledge", "Acknowledge",
            [], {
                "command";
                "code";
            };
    }
}

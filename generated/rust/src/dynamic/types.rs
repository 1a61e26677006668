use crate::dynamic::macros::{record, union};
use crate::types;

record! {
    types::EventTriggerGpio { pin, mode }
    "pin" => value(pin);
    "mode" => value(mode);
}

record! {
    types::EventThresholdWindow { low_threshold, high_threshold }
    "low_threshold" => value(low_threshold);
    "high_threshold" => value(high_threshold);
}

record! {
    types::EventThresholdInterval { interval_threshold, interval }
    "interval_threshold" => value(interval_threshold);
    "interval" => value(interval);
}

record! {
    types::EventTriggerThreshold {
        descriptor_set,
        field_descriptor,
        parameter_id,
        type_,
        thresholds,
    }
    "descriptor_set" => value(descriptor_set);
    "field_descriptor" => value(field_descriptor);
    "parameter_id" => value(parameter_id);
    "type" => value(type_);
    "thresholds" => union(thresholds, type_, types::EventTriggerThresholdThresholds);
}

union! {
    types::EventTriggerThresholdThresholds, types::EventThresholdType;
    WINDOW => Window("window");
    INTERVAL => Interval("interval");
}

record! {
    types::EventTriggerCombination { logic_table, input_triggers }
    "logic_table" => value(logic_table);
    "input_triggers" => value(input_triggers);
}

record! {
    types::EventActionGpio { pin, mode }
    "pin" => value(pin);
    "mode" => value(mode);
}

record! {
    types::EventActionMessage { descriptor_set, decimation, descriptors }
    "descriptor_set" => value(descriptor_set);
    "decimation" => value(decimation);
    "num_fields" => counter(descriptors, "descriptors");
    "descriptors" => value(descriptors);
}

record! {
    types::NmeaMessage { message_id, talker_id, source_descriptor_set, decimation }
    "message_id" => value(message_id);
    "talker_id" => value(talker_id);
    "source_descriptor_set" => value(source_descriptor_set);
    "decimation" => value(decimation);
}

record! {
    types::DescriptorRate { descriptor, decimation }
    "descriptor" => value(descriptor);
    "decimation" => value(decimation);
}

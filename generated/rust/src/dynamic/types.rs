use crate::dynamic::macros::{record, union};
use crate::types;

record! {
    types::EventTriggerGpio { pin, mode }
    "pin" => value(pin);
    "mode" => value(mode);
}

record! {
    types::EventThresholdWindow { low_thres, high_thres }
    "low_thres" => value(low_thres);
    "high_thres" => value(high_thres);
}

record! {
    types::EventThresholdInterval { int_thres, interval }
    "int_thres" => value(int_thres);
    "interval" => value(interval);
}

record! {
    types::EventTriggerThreshold { desc_set, field_desc, param_id, type_, thresholds }
    "desc_set" => value(desc_set);
    "field_desc" => value(field_desc);
    "param_id" => value(param_id);
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
    types::EventActionMessage { desc_set, decimation, descriptors }
    "desc_set" => value(desc_set);
    "decimation" => value(decimation);
    "num_fields" => counter(descriptors, "descriptors");
    "descriptors" => value(descriptors);
}

record! {
    types::NmeaMessage { message_id, talker_id, source_desc_set, decimation }
    "message_id" => value(message_id);
    "talker_id" => value(talker_id);
    "source_desc_set" => value(source_desc_set);
    "decimation" => value(decimation);
}

record! {
    types::DescriptorRate { descriptor, decimation }
    "descriptor" => value(descriptor);
    "decimation" => value(decimation);
}

/* Types that more than one descriptor set uses. */
#include "mip/types.h"

void mip_event_trigger_gpio_read(struct mip_reader *r, struct mip_event_trigger_gpio *v) {
    mip_read_u8(r, &v->pin, 1);
    mip_read_u8(r, &v->mode, 1);
}

void mip_event_trigger_gpio_write(struct mip_writer *w, const struct mip_event_trigger_gpio *v) {
    mip_write_u8(w, &v->pin, 1);
    mip_write_u8(w, &v->mode, 1);
}

void mip_event_threshold_window_read(struct mip_reader *r, struct mip_event_threshold_window *v) {
    mip_read_double(r, &v->low_threshold, 1);
    mip_read_double(r, &v->high_threshold, 1);
}

void mip_event_threshold_window_write(struct mip_writer *w,
                                      const struct mip_event_threshold_window *v) {
    mip_write_double(w, &v->low_threshold, 1);
    mip_write_double(w, &v->high_threshold, 1);
}

void mip_event_threshold_interval_read(struct mip_reader *r,
                                       struct mip_event_threshold_interval *v) {
    mip_read_double(r, &v->interval_threshold, 1);
    mip_read_double(r, &v->interval, 1);
}

void mip_event_threshold_interval_write(struct mip_writer *w,
                                        const struct mip_event_threshold_interval *v) {
    mip_write_double(w, &v->interval_threshold, 1);
    mip_write_double(w, &v->interval, 1);
}

void mip_event_trigger_threshold_read(struct mip_reader *r, struct mip_event_trigger_threshold *v) {
    mip_read_u8(r, &v->descriptor_set, 1);
    mip_read_u8(r, &v->field_descriptor, 1);
    mip_read_u8(r, &v->parameter_id, 1);
    mip_read_u8(r, &v->type, 1);
    switch (v->type) {
    case MIP_EVENT_THRESHOLD_TYPE_WINDOW:
        mip_event_threshold_window_read(r, &v->thresholds.window);
        break;
    case MIP_EVENT_THRESHOLD_TYPE_INTERVAL:
        mip_event_threshold_interval_read(r, &v->thresholds.interval);
        break;
    default:
        break;
    }
}

void mip_event_trigger_threshold_write(struct mip_writer *w,
                                       const struct mip_event_trigger_threshold *v) {
    mip_write_u8(w, &v->descriptor_set, 1);
    mip_write_u8(w, &v->field_descriptor, 1);
    mip_write_u8(w, &v->parameter_id, 1);
    mip_write_u8(w, &v->type, 1);
    switch (v->type) {
    case MIP_EVENT_THRESHOLD_TYPE_WINDOW:
        mip_event_threshold_window_write(w, &v->thresholds.window);
        break;
    case MIP_EVENT_THRESHOLD_TYPE_INTERVAL:
        mip_event_threshold_interval_write(w, &v->thresholds.interval);
        break;
    default:
        break;
    }
}

void mip_event_trigger_combination_read(struct mip_reader *r,
                                        struct mip_event_trigger_combination *v) {
    mip_read_u16(r, &v->logic_table, 1);
    mip_read_u8(r, v->input_triggers, 4);
}

void mip_event_trigger_combination_write(struct mip_writer *w,
                                         const struct mip_event_trigger_combination *v) {
    mip_write_u16(w, &v->logic_table, 1);
    mip_write_u8(w, v->input_triggers, 4);
}

void mip_event_action_gpio_read(struct mip_reader *r, struct mip_event_action_gpio *v) {
    mip_read_u8(r, &v->pin, 1);
    mip_read_u8(r, &v->mode, 1);
}

void mip_event_action_gpio_write(struct mip_writer *w, const struct mip_event_action_gpio *v) {
    mip_write_u8(w, &v->pin, 1);
    mip_write_u8(w, &v->mode, 1);
}

void mip_event_action_message_read(struct mip_reader *r, struct mip_event_action_message *v) {
    mip_read_u8(r, &v->descriptor_set, 1);
    mip_read_u16(r, &v->decimation, 1);
    mip_read_u8(r, &v->num_fields, 1);
    mip_read_u8(r, v->descriptors, mip_read_count(r, v->num_fields, 249, 1));
}

void mip_event_action_message_write(struct mip_writer *w,
                                    const struct mip_event_action_message *v) {
    mip_write_u8(w, &v->descriptor_set, 1);
    mip_write_u16(w, &v->decimation, 1);
    mip_write_u8(w, &v->num_fields, 1);
    mip_write_u8(w, v->descriptors, mip_write_count(w, v->num_fields, 249));
}

void mip_nmea_message_read(struct mip_reader *r, struct mip_nmea_message *v) {
    mip_read_u8(r, &v->message_id, 1);
    mip_read_u8(r, &v->talker_id, 1);
    mip_read_u8(r, &v->source_descriptor_set, 1);
    mip_read_u16(r, &v->decimation, 1);
}

void mip_nmea_message_write(struct mip_writer *w, const struct mip_nmea_message *v) {
    mip_write_u8(w, &v->message_id, 1);
    mip_write_u8(w, &v->talker_id, 1);
    mip_write_u8(w, &v->source_descriptor_set, 1);
    mip_write_u16(w, &v->decimation, 1);
}

void mip_descriptor_rate_read(struct mip_reader *r, struct mip_descriptor_rate *v) {
    mip_read_u8(r, &v->descriptor, 1);
    mip_read_u16(r, &v->decimation, 1);
}

void mip_descriptor_rate_write(struct mip_writer *w, const struct mip_descriptor_rate *v) {
    mip_write_u8(w, &v->descriptor, 1);
    mip_write_u16(w, &v->decimation, 1);
}

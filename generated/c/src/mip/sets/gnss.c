/* GNSS commands. */
#include "mip/gnss.h"
#include "mip/gnss_commands.h"
#include "mip/core/program.h"

static const uint8_t program_receiver_info[] = {
    MIP_END,
};

MIP_CODEC(mip_gnss_receiver_info, 0x0E, 0x01, MIP_COMMAND, 0, 0, 0, program_receiver_info, NULL);

static const struct mip_response responses_receiver_info[] = {
    {NULL, 0x81, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_gnss_receiver_info, 0x0E, 0x01, 0, 1, responses_receiver_info, false);

static const uint8_t program_receiver_info_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_receiver_info_response, num_receivers)),
    MIP_COUNTED(MIP_SIZE(struct mip_gnss_receiver_info_response, num_receivers), 7, 34,
                MIP_AT(struct mip_gnss_receiver_info_response, num_receivers)),
    MIP_EACH(1, struct mip_gnss_receiver_info_entry, 4,
             MIP_AT(struct mip_gnss_receiver_info_response, receiver_info)),
    MIP_8_BITS(0, MIP_MANY(34, MIP_AT(struct mip_gnss_receiver_info_entry, receiver_id))),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_gnss_receiver_info_response, 0x0E, 0x81, MIP_RESPONSE, 0, 0, 0,
          program_receiver_info_response, &mip_program);

static const uint8_t program_signal_config[] = {
    MIP_REQUIRED(1, 5),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_signal_config, gps_enable)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_signal_config, glonass_enable)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_signal_config, galileo_enable)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_signal_config, beidou_enable)),
    MIP_GROUP(1),
    MIP_8_BITS(4, MIP_AT(struct mip_gnss_signal_config, reserved)),
    MIP_END,
};

MIP_CODEC(mip_gnss_signal_config, 0x0E, 0x02, MIP_COMMAND, 0, 0, 0, program_signal_config,
          &mip_program);

static const struct mip_response responses_signal_config[] = {
    {NULL, 0x82, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_gnss_signal_config, 0x0E, 0x02, 0, 1, responses_signal_config, true);

static const uint8_t program_signal_config_response[] = {
    MIP_8_BITS(8, MIP_AT(struct mip_gnss_signal_config_response, gps_enable)),
    MIP_END,
};

MIP_CODEC(mip_gnss_signal_config_response, 0x0E, 0x82, MIP_RESPONSE, 8, 0, 0,
          program_signal_config_response, NULL);

static const uint8_t program_receiver_reset[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_receiver_reset, receiver_id)),
    MIP_END,
};

MIP_CODEC(mip_gnss_receiver_reset, 0x0E, 0x03, MIP_COMMAND, 2, 0, 0, program_receiver_reset, NULL);

MIP_EXCHANGE(mip_gnss_receiver_reset, 0x0E, 0x03, 0, 0, NULL, false);

static const uint8_t program_rtk_config[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_rtk_config, ambiguity_fix_mode)),
    MIP_GROUP(1),
    MIP_8_BITS(4, MIP_AT(struct mip_gnss_rtk_config, reserved)),
    MIP_END,
};

MIP_CODEC(mip_gnss_rtk_config, 0x0E, 0x04, MIP_COMMAND, 0, 0, 0, program_rtk_config, &mip_program);

static const struct mip_response responses_rtk_config[] = {
    {NULL, 0x84, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_gnss_rtk_config, 0x0E, 0x04, 0, 1, responses_rtk_config, true);

static const uint8_t program_rtk_config_response[] = {
    MIP_8_BITS(5, MIP_AT(struct mip_gnss_rtk_config_response, ambiguity_fix_mode)),
    MIP_END,
};

MIP_CODEC(mip_gnss_rtk_config_response, 0x0E, 0x84, MIP_RESPONSE, 5, 0, 0,
          program_rtk_config_response, NULL);

static const uint8_t program_rtk_dongle_config[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_rtk_dongle_config, enable)),
    MIP_GROUP(1),
    MIP_8_BITS(3, MIP_AT(struct mip_gnss_rtk_dongle_config, reserved)),
    MIP_END,
};

MIP_CODEC(mip_gnss_rtk_dongle_config, 0x0E, 0x10, MIP_COMMAND, 0, 0, 0, program_rtk_dongle_config,
          &mip_program);

static const struct mip_response responses_rtk_dongle_config[] = {
    {NULL, 0x90, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_gnss_rtk_dongle_config, 0x0E, 0x10, 0, 1, responses_rtk_dongle_config, true);

static const uint8_t program_rtk_dongle_config_response[] = {
    MIP_8_BITS(4, MIP_AT(struct mip_gnss_rtk_dongle_config_response, enable)),
    MIP_END,
};

MIP_CODEC(mip_gnss_rtk_dongle_config_response, 0x0E, 0x90, MIP_RESPONSE, 4, 0, 0,
          program_rtk_dongle_config_response, NULL);

static const uint8_t program_spartn_config[] = {
    MIP_FAR,
    MIP_REQUIRED(1, 8),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_gnss_spartn_config, enable)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_gnss_spartn_config, type)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_FAR_AT(struct mip_gnss_spartn_config, current_key_tow)),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_spartn_config, current_key_week)),
    MIP_GROUP(1),
    MIP_8_BITS(0, MIP_MANY(32, MIP_FAR_AT(struct mip_gnss_spartn_config, current_key))),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_FAR_AT(struct mip_gnss_spartn_config, next_key_tow)),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_spartn_config, next_key_week)),
    MIP_GROUP(1),
    MIP_8_BITS(0, MIP_MANY(32, MIP_FAR_AT(struct mip_gnss_spartn_config, next_key))),
    MIP_END,
};

MIP_CODEC(mip_gnss_spartn_config, 0x0E, 0x20, MIP_COMMAND, 0, 0, 0, program_spartn_config,
          &mip_program);

static const struct mip_response responses_spartn_config[] = {
    {NULL, 0xA0, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_gnss_spartn_config, 0x0E, 0x20, 0, 1, responses_spartn_config, true);

static const uint8_t program_spartn_config_response[] = {
    MIP_FAR,
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_gnss_spartn_config_response, enable)),
    MIP_32_BITS(1, MIP_FAR_AT(struct mip_gnss_spartn_config_response, current_key_tow)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_spartn_config_response, current_key_week)),
    MIP_8_BITS(0, MIP_MANY(32, MIP_FAR_AT(struct mip_gnss_spartn_config_response, current_key))),
    MIP_32_BITS(1, MIP_FAR_AT(struct mip_gnss_spartn_config_response, next_key_tow)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_spartn_config_response, next_key_week)),
    MIP_8_BITS(0, MIP_MANY(32, MIP_FAR_AT(struct mip_gnss_spartn_config_response, next_key))),
    MIP_END,
};

MIP_CODEC(mip_gnss_spartn_config_response, 0x0E, 0xA0, MIP_RESPONSE, 0, 0, 0,
          program_spartn_config_response, &mip_program);

static const uint8_t program_receiver_safe_mode[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_receiver_safe_mode, receiver_id)),
    MIP_END,
};

MIP_CODEC(mip_gnss_receiver_safe_mode, 0x0E, 0x60, MIP_COMMAND, 2, 0, 0, program_receiver_safe_mode,
          NULL);

MIP_EXCHANGE(mip_gnss_receiver_safe_mode, 0x0E, 0x60, 0, 0, NULL, false);

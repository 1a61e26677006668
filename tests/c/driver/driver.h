/* Shared by the parts of the driver. Functions that can fail return an error text, or NULL. */
#ifndef DRIVER_H
#define DRIVER_H

#include "json.h"

#include "mip/core.h"
#include "mip/registry.h"

/* The error of an invalid request. */
extern const char *const REQUEST;

/* Bytes in memory of exactly their size, so that a sanitizer sees the first one too many; or NULL. */
uint8_t *bytes_of(struct arena *arena, const struct json *j, size_t *size);

/* A whole number that is not negative. */
const char *get_whole(const struct json *j, uint32_t *number);

/* A field of a request by its name, with its values in a structure. */
const char *get_named(struct arena *arena, const struct json *field, uint8_t set, const struct mip_entry **entry, uint8_t **record);

/* The values of a structure. */
void put_values(struct output *out, const struct mip_codec *codec, const uint8_t *value);

/* Writes `,"name":"gnss_2.dop"`: the name of a type in a set. */
void put_name(struct output *out, const struct mip_entry *entry, uint8_t set);

/* A field of a packet, decoded. */
void put_field(struct output *out, struct arena *arena, const struct mip_field *field);

/* The `client` request, and the same at a port. */
const char *play(struct output *out, struct arena *arena, const struct json *request);
const char *play_live(struct output *out, struct arena *arena, const struct json *request);

#endif

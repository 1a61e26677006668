/* Reads a log: prints filter positions as CSV, and the number of fields of each kind. */
#include "mip/filter_data.h"
#include "mip/extra/print.h"
#include "mip/extra/registry.h"

#include <stdio.h>

static unsigned long counts[0x10000]; /* by descriptor set and descriptor */
static double time_of_week;

static void put(void *file, const char *text, size_t size) {
    fwrite(text, 1, size, (FILE *)file);
}

static void handle(const struct mip_packet *packet) {
    const struct mip_print print = {put, stderr, NULL}; /* NULL: for any device */
    struct mip_walk walk = mip_walk_packet(packet);
    struct mip_field field;
    while (mip_walk_next(&walk, &field)) {
        const uint16_t key = mip_field_key(&field);
        struct mip_filter_data_timestamp stamp;
        struct mip_filter_data_llh_position place;
        if (counts[key]++ == 0) { /* prints the first one of each kind, with names and units */
            mip_print_field(&print, &field);
        }
        if (mip_filter_data_timestamp_decode(&stamp, &field) == MIP_OK) {
            time_of_week = stamp.tow;
        } else if (mip_filter_data_llh_position_decode(&place, &field) == MIP_OK) {
            printf("%.3f,%.9f,%.9f\n", time_of_week, place.latitude, place.longitude);
        }
    }
}

int main(int argc, char **argv) {
    static uint8_t piece[4096];
    struct mip_parser parser;
    struct mip_packet packet;
    size_t size;
    FILE *file = argc == 2 ? fopen(argv[1], "rb") : NULL;
    if (file == NULL) {
        fprintf(stderr, "usage: %s FILE\n", argv[0]);
        return 2;
    }
    mip_parser_init(&parser);
    puts("time,latitude,longitude");
    while ((size = fread(piece, 1, sizeof(piece), file)) > 0) {
        const uint8_t *at = piece;
        while (mip_parser_next(&parser, &at, &size, &packet)) {
            handle(&packet);
        }
    }
    while (mip_parser_flush(&parser, &packet)) { /* packets within an incomplete one */
        handle(&packet);
    }
    fclose(file);
    for (size_t key = 0; key < sizeof(counts) / sizeof(counts[0]); key++) {
        const uint8_t set = (uint8_t)(key >> 8);
        const struct mip_entry *known = mip_registry_next(set, (uint8_t)key, NULL);
        if (counts[key] > 0) {
            fprintf(stderr, "%lu x %s.%s\n", counts[key],
                    known != NULL ? mip_registry_set_name(known, set) : "unknown",
                    known != NULL ? known->name : "field");
        }
    }
    fprintf(stderr, "%lu bytes are not part of a packet\n", (unsigned long)parser.skipped);
    return 0;
}

/*
 * The part of the conformance driver that calls the library. driver.py starts it: it reads JSON, and makes lines of words
 * of it, and structures of values, by the reflection tables that are printed here.
 *
 *     describe                                   the order of bytes, and every type with its parameters
 *     find SET NAME                              the index of the type that has this name in a set, or -1
 *     parse CHUNK BYTES                          packets, and the number of skipped bytes
 *     decode BYTES                               the fields of a packet
 *     encode SET FIELD...                        a packet of fields: `raw DESCRIPTOR BYTES`, `value INDEX BYTES`
 *     client                                     a new client; the time of the following steps is in milliseconds
 *     send NOW SET FIELD..., receive NOW CHUNK BYTES, time NOW, end NOW
 *
 * Bytes, and structures as they are in memory, are hexadecimal behind an x. Each answer is one line of JSON.
 */
#define _POSIX_C_SOURCE 200809L
#include "mip/extra/reflect.h"
#include "mip/extra/registry.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --------------------------------------------------------------------------------------- words */

static void *must(void *memory) {
    if (memory == NULL) {
        abort();
    }
    return memory;
}

/* The next word of the line; NULL at its end. */
static const char *word(void) {
    return strtok(NULL, " \n");
}

static unsigned long number(void) {
    return strtoul((const char *)must(strtok(NULL, " \n")), NULL, 10);
}

struct bytes {
    uint8_t *data;
    size_t size;
};

static uint8_t digit(char c) {
    return (uint8_t)(c <= '9' ? c - '0' : c - 'a' + 10);
}

/* Bytes in memory of exactly their size, so that a sanitizer sees the first one too many. */
static struct bytes bytes(void) {
    const char *text = word();
    const size_t size = strlen((const char *)must((void *)(uintptr_t)text)) / 2;
    const struct bytes found = {(uint8_t *)must(malloc(size > 0 ? size : 1)), size};
    for (size_t i = 0; i < size; i++) {
        found.data[i] = (uint8_t)(digit(text[2 * i + 1]) << 4 | digit(text[2 * i + 2]));
    }
    return found;
}

/* Prints a string of JSON, behind the name of the member that it is. */
static void print_hex(const char *name, const void *from, size_t size) {
    const uint8_t *at = (const uint8_t *)from;
    printf("%s\"", name);
    for (size_t i = 0; i < size; i++) {
        putchar("0123456789abcdef"[at[i] >> 4]);
        putchar("0123456789abcdef"[at[i] & 15]);
    }
    putchar('"');
}

/* ---------------------------------------------------------------------------------- description */

static void describe_record(const struct mip_record *record);

static void describe_parameter(const struct mip_parameter *p) {
    static const char scalars[] = "BHIQbhiqfdBB"; /* as Python's struct names them */
    printf("{\"name\":\"%s\",\"kind\":%u,\"scalar\":\"%c\",\"length\":%u,\"capacity\":%u,\"elements\":%u,\"by\":%u,", p->name,
           p->kind, scalars[p->scalar], p->length, p->capacity, p->elements, p->by);
    printf("\"group\":%u,\"offset\":%u,\"item_size\":%u,\"count_offset\":%u", p->group, p->offset, p->item_size,
           p->count_offset);
    if (p->kind == MIP_KIND_STRUCT) {
        printf(",\"record\":");
        describe_record(p->record);
    } else if (p->kind == MIP_KIND_UNION) {
        printf(",\"cases\":[");
        for (size_t i = 0; i < p->count; i++) {
            printf("%s[%llu,", i > 0 ? "," : "", (unsigned long long)p->cases[i].value);
            if (p->cases[i].parameter != NULL) {
                describe_parameter(p->cases[i].parameter);
            } else {
                printf("null");
            }
            putchar(']');
        }
        putchar(']');
    }
    putchar('}');
}

static void describe_record(const struct mip_record *record) {
    putchar('[');
    for (size_t i = 0; i < record->count; i++) {
        printf(i > 0 ? "," : "");
        describe_parameter(&record->parameters[i]);
    }
    putchar(']');
}

static void describe(void) {
    static const char *const roles[] = {"command", "response", "data"};
    const uint16_t one = 1;
    uint8_t first;
    memcpy(&first, &one, 1);
    printf("{\"order\":\"%s\",\"types\":[", first == 1 ? "<" : ">");
    for (size_t i = 0; i < mip_registry_size; i++) {
        const struct mip_entry *e = &mip_registry[i];
        const struct mip_reflection *r = mip_reflect(e->codec);
        printf("%s{\"descriptor\":%u,\"role\":\"%s\",\"size\":%u,", i > 0 ? "," : "", e->descriptor, roles[e->role],
               e->codec->size);
        printf("\"present\":%d,\"required\":[", r->optional ? r->present_offset : -1);
        for (size_t k = 0; r->selector && k < r->required_size; k++) {
            printf("%s%u", k > 0 ? "," : "", r->required[k]);
        }
        printf("],\"record\":");
        describe_record(r->record);
        putchar('}');
    }
    printf("]}");
}

static void find(void) {
    const uint8_t set = (uint8_t)number();
    uint8_t of = 0;
    const struct mip_entry *entry = mip_registry_by_name((const char *)must((void *)(uintptr_t)word()), &of);
    printf("%d", entry != NULL && mip_set_has(set, of) ? (int)(entry - mip_registry) : -1);
}

/* ------------------------------------------------------------------------------------- packets */

static void parse(void) {
    const size_t chunk = number();
    const struct bytes stream = bytes();
    struct mip_parser *finder = (struct mip_parser *)must(malloc(sizeof(*finder)));
    struct mip_packet packet;
    const char *comma = "";
    mip_parser_init(finder);
    printf("{\"packets\":[");
    for (size_t at = 0; at < stream.size; at += chunk) {
        const uint8_t *data = stream.data + at;
        size_t size = chunk < stream.size - at ? chunk : stream.size - at;
        for (; mip_parser_next(finder, &data, &size, &packet); comma = ",") {
            print_hex(comma, packet.bytes, packet.size);
        }
    }
    for (; mip_parser_flush(finder, &packet); comma = ",") {
        print_hex(comma, packet.bytes, packet.size);
    }
    printf("],\"skipped\":%llu}", (unsigned long long)finder->skipped);
    free(finder);
    free(stream.data);
}

static void print_value(const struct mip_entry *entry, uint8_t set, const void *value, size_t trailing) {
    printf("\"name\":\"%s.%s\",\"type\":%u,", mip_registry_set_name(entry, set), entry->name, (unsigned)(entry - mip_registry));
    print_hex("\"value\":", value, entry->codec->size);
    printf(",\"trailing\":%u}", (unsigned)trailing);
}

static void print_field(const struct mip_field *field) {
    const struct mip_entry *entry = mip_registry_find(field);
    printf("{\"descriptor\":%u,", field->descriptor);
    if (entry != NULL) {
        size_t trailing;
        void *value = must(malloc(entry->codec->size + 1U)); /* some types have no parameters */
        const mip_error error = mip_decode(entry->codec, value, field, &trailing);
        if (error == MIP_OK) {
            print_value(entry, field->descriptor_set, value, trailing);
            free(value);
            return;
        }
        printf("\"error\":\"%s\",", mip_error_name(error));
        free(value);
    }
    print_hex("\"raw\":", field->data, field->size);
    putchar('}');
}

static void decode(void) {
    const struct bytes given = bytes();
    struct mip_packet packet;
    const mip_error error = mip_packet_check(given.data, given.size, &packet);
    if (error != MIP_OK) {
        printf("{\"error\":\"%s\"}", mip_error_name(error));
    } else {
        struct mip_walk walk = mip_walk_packet(&packet);
        struct mip_field field;
        const char *comma = "";
        printf("{\"set\":%u,\"fields\":[", packet.descriptor_set);
        for (; mip_walk_next(&walk, &field); comma = ",") {
            printf("%s", comma);
            print_field(&field);
        }
        printf("%s]}", walk.error == MIP_OK ? "" : *comma ? ",{\"error\":\"field_length\"}"
                                                          : "{\"error\":\"field_length\"}");
    }
    free(given.data);
}

static void encode(void) {
    uint8_t buffer[MIP_MAX_PACKET];
    struct mip_builder builder;
    mip_error error = mip_builder_start(&builder, buffer, sizeof(buffer), (uint8_t)number());
    for (const char *kind = word(); kind != NULL && error == MIP_OK; kind = word()) {
        const size_t index = number();
        const struct bytes given = bytes();
        error = strcmp(kind, "raw") == 0 ? mip_builder_add(&builder, (uint8_t)index, given.data, given.size)
                                         : mip_encode(mip_registry[index].codec, given.data, &builder);
        free(given.data);
    }
    if (error != MIP_OK) {
        printf("{\"error\":\"%s\"}", mip_error_name(error));
        return;
    }
    const struct mip_packet packet = mip_builder_finish(&builder);
    putchar('{');
    print_hex("\"packet\":", packet.bytes, packet.size);
    putchar('}');
}

/* ------------------------------------------------------------------------------------- a client */

/* A command that was sent. */
struct command {
    struct mip_request request; /* first, so that its address is that of the command */
    unsigned number;
    bool timed_out; /* and that was reported */
    struct command *next;
};

static struct mip_client client;
static struct mip_parser parser;
static uint32_t now;
static unsigned sent_count;
static struct command *sent; /* all, oldest first */
static struct command **sent_end = &sent;
static bool first_event;

static void event(const char *text, unsigned about) {
    printf("%s{\"event\":\"%s\",\"command\":%u", first_event ? "" : ",", text, about);
    first_event = false;
}

static void start(void) {
    while (sent != NULL) {
        struct command *next = sent->next;
        free(sent->request.response);
        free(sent);
        sent = next;
    }
    sent_end = &sent;
    sent_count = 0;
    mip_client_init(&client);
    mip_parser_init(&parser);
    printf("null");
}

/* Adds a command to a packet, and waits for its answer. */
static mip_error wait_for(const struct mip_entry *entry, const void *value, struct mip_builder *builder, struct command **end) {
    const size_t at = builder->length;
    const mip_error error = mip_encode(entry->codec, value, builder); /* any function, even one that the client rejects */
    if (error != MIP_OK) {
        return error;
    }
    struct command *c = (struct command *)must(calloc(1, sizeof(*c)));
    const struct mip_response *asked = mip_requested(entry->command->exchange, builder->buffer + at);
    c->request.exchange = entry->command->exchange;
    c->request.asked = asked;
    mip_client_wait(&client, &c->request, now);
    *end = c;
    /* A response with several layouts is decoded after it has arrived. */
    if (asked != NULL && asked->descriptor != 0 && asked->layout == NULL) {
        size_t i = 0;
        while (mip_registry_link(entry, i)->descriptor != asked->descriptor) {
            i++;
        }
        const struct mip_codec *codec = mip_registry_link(entry, i)->codec;
        if (!mip_client_expect(&c->request, codec, must(malloc(codec->size)))) {
            abort();
        }
    }
    return MIP_OK;
}

static void send(void) {
    uint8_t packet[MIP_MAX_BARRIER + MIP_MAX_PACKET];
    const struct mip_client before = client;
    const size_t barrier = mip_client_barrier(&client, packet);
    struct mip_builder builder;
    struct command *commands = NULL;
    struct command **end = &commands;
    mip_error error = mip_builder_start(&builder, packet + barrier, MIP_MAX_PACKET, (uint8_t)number());
    while (error == MIP_OK && word() != NULL) {
        const struct mip_entry *entry = &mip_registry[number()];
        const struct bytes value = bytes();
        error = wait_for(entry, value.data, &builder, end);
        end = error == MIP_OK ? &(*end)->next : end;
        free(value.data);
    }
    *sent_end = commands;
    sent_end = end;
    first_event = false;
    if (error != MIP_OK) {
        for (struct command *c = commands; c != NULL; c = c->next) {
            mip_client_cancel(&client, &c->request);
        }
        client.missed = before.missed; /* nothing is sent */
        client.behind = before.behind;
        printf("{\"event\":\"not_sent\",\"error\":\"%s\"}", mip_error_name(error));
        return;
    }
    printf("{\"event\":\"sent\",");
    print_hex("\"packet\":", packet, barrier + mip_builder_finish(&builder).size);
    printf(",\"commands\":[");
    for (struct command *c = commands; c != NULL; c = c->next) {
        c->number = sent_count++;
        printf("%s%u", c == commands ? "" : ",", c->number);
    }
    printf("]}");
    for (const struct command *c = commands; c != NULL; c = c->next) {
        if (c->request.result.outcome == MIP_SENT) {
            event("silent", c->number);
            putchar('}');
        }
    }
}

static const struct mip_entry *entry_of(const struct mip_codec *codec) {
    const struct mip_entry *entry = mip_registry;
    while (entry->codec != codec) {
        entry++;
    }
    return entry;
}

/* Decodes a response for which the command named no structure. */
static void take_response(struct mip_request *r, const struct mip_field *field) {
    if (r->result.outcome == MIP_ACKNOWLEDGED && r->asked != NULL && r->response == NULL) {
        r->response = must(malloc(r->codec->size));
        r->result.error = (uint8_t)mip_decode(r->codec, r->response, field, NULL);
        r->result.responded = r->result.error == MIP_OK;
        r->result.outcome = r->result.responded ? MIP_ACKNOWLEDGED : MIP_UNDECODABLE;
    }
}

static void print_answer(const struct command *c, const struct mip_field *field) {
    static const char *const names[] = {
        [MIP_ACKNOWLEDGED] = "acknowledged",
        [MIP_REFUSED] = "refused",
        [MIP_MISSING_RESPONSE] = "missing_response",
        [MIP_UNDECODABLE] = "undecodable",
    };
    const struct mip_request *r = &c->request;
    event(names[r->result.outcome], c->number);
    if (r->result.outcome == MIP_REFUSED) {
        printf(",\"code\":%u", r->result.code);
    }
    if (r->result.responded || r->result.outcome == MIP_UNDECODABLE) {
        printf(",\"response\":{\"descriptor\":%u,", field->descriptor);
    }
    if (r->result.outcome == MIP_UNDECODABLE) {
        printf("\"error\":\"%s\",", mip_error_name((mip_error)r->result.error));
        print_hex("\"raw\":", field->data, field->size);
        putchar('}');
    } else if (r->result.responded) { /* it is decoded again to count the trailing bytes */
        void *again = must(malloc(r->codec->size));
        size_t trailing = 0;
        mip_decode(r->codec, again, field, &trailing);
        print_value(entry_of(r->codec), field->descriptor_set, r->response, trailing);
        free(again);
    }
    putchar('}');
}

static void print_timed_out(void) {
    for (struct command *c = sent; c != NULL; c = c->next) {
        if (c->request.result.outcome == MIP_TIMED_OUT && !c->timed_out) {
            c->timed_out = true;
            event("timed_out", c->number);
            putchar('}');
        }
    }
}

/* A packet: answers, and the fields that answer nothing, in their order. */
static void take(const struct mip_packet *packet) {
    struct mip_walk walk = mip_walk_packet(packet);
    struct mip_request *answered;
    struct mip_field field;
    if (mip_client_passes(&client, packet)) {
        print_timed_out(); /* commands sent before it */
        return;
    }
    printf("%s{\"set\":%u,\"parts\":[", first_event ? "" : ",", packet->descriptor_set);
    first_event = true;
    while (mip_client_next(&client, &walk, &answered, &field)) {
        if (answered != NULL) {
            take_response(answered, &field);
            print_answer((struct command *)(void *)answered, &field);
        } else {
            printf(first_event ? "" : ",");
            print_field(&field);
        }
        first_event = false;
    }
    if (walk.error != MIP_OK) {
        printf("%s{\"error\":\"field_length\"}", first_event ? "" : ",");
    }
    printf("]}");
    first_event = false;
}

static void poll(void) {
    const uint8_t *nothing = NULL;
    size_t none = 0;
    struct mip_packet packet;
    while (mip_parser_next(&parser, &nothing, &none, &packet) || mip_client_poll(&client, &parser, now, &packet)) {
        take(&packet);
    }
    print_timed_out();
}

static void receive(void) {
    const size_t chunk = number();
    const struct bytes given = bytes();
    struct mip_packet packet;
    for (size_t at = 0; at < given.size; at += chunk) {
        const uint8_t *data = given.data + at;
        size_t size = chunk < given.size - at ? chunk : given.size - at;
        while (mip_parser_next(&parser, &data, &size, &packet)) {
            take(&packet);
        }
        poll();
    }
    free(given.data);
}

static void end(void) {
    struct mip_packet packet;
    const char *comma = "";
    while (mip_parser_flush(&parser, &packet)) {
        take(&packet);
    }
    poll();
    printf("%s{\"event\":\"end\",\"waiting\":[", first_event ? "" : ",");
    for (const struct command *c = sent; c != NULL; c = c->next) {
        if (c->request.result.outcome == MIP_WAITING) {
            printf("%s%u", comma, c->number);
            comma = ",";
        }
    }
    printf("],\"skipped\":%u}", (unsigned)parser.skipped);
}

static void step(void (*what)(void)) {
    now = (uint32_t)number();
    first_event = true;
    printf("{\"events\":[");
    what();
    printf("]}");
}

int main(void) {
    static const struct {
        const char *name;
        void (*run)(void);
        bool is_step;
    } commands[] = {
        {"describe", describe, false},
        {"find", find, false},
        {"parse", parse, false},
        {"decode", decode, false},
        {"encode", encode, false},
        {"client", start, false},
        {"send", send, true},
        {"receive", receive, true},
        {"time", poll, true},
        {"end", end, true},
    };
    char *line = NULL;
    size_t room = 0;
    while (getline(&line, &room, stdin) >= 0) {
        const char *name = strtok(line, " \n");
        for (size_t i = 0; i < sizeof(commands) / sizeof(commands[0]); i++) {
            if (strcmp(commands[i].name, name) == 0 && commands[i].is_step) {
                step(commands[i].run);
            } else if (strcmp(commands[i].name, name) == 0) {
                commands[i].run();
            }
        }
        putchar('\n');
        fflush(stdout);
    }
    free(line);
    return 0;
}

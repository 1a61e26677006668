/* The `client` and `live` requests: steps in, events out. */
#include "driver.h"
#include "port.h"

#include "mip/client.h"

#include <stdlib.h>

/* A command that was sent. */
struct command {
    struct mip_request request; /* first, so that its address is that of the command */
    uint64_t number;
    bool timed_out; /* and that was reported */
    struct command *next;
};

struct session {
    struct arena *arena;
    struct output *out;
    struct mip_client client;
    struct mip_parser *parser;
    uint32_t now;
    uint64_t count;
    bool first;
    /* Of a `live` request; NULL otherwise. */
    struct port *port;
    bool told; /* the closed port was reported */
    /* All that were sent, oldest first. */
    struct command *sent;
    struct command *last;
};

static void begin(struct session *s, const char *event) {
    put(s->out, s->first ? "{\"event\":\"" : ",{\"event\":\"");
    put(s->out, event);
    put_char(s->out, '"');
    s->first = false;
}

static void number(struct session *s, const char *name, uint64_t value) {
    put(s->out, ",\"");
    put(s->out, name);
    put(s->out, "\":");
    put_unsigned(s->out, value);
}

static void happened(struct session *s, const char *event, const struct command *c) {
    begin(s, event);
    number(s, "command", c->number);
    put_char(s->out, '}');
}

/* --------------------------------------------------------------------------------------- sending */

static const char *add(struct session *s, struct mip_builder *builder, const struct json *field, uint8_t set, struct command **end) {
    const struct mip_entry *entry;
    uint8_t *values;
    const char *wrong = get_named(s->arena, field, set, &entry, &values);
    if (wrong != NULL) {
        return wrong;
    }
    if (entry->role != MIP_COMMAND) {
        return "unknown";
    }
    struct command *c = (struct command *)arena_take(s->arena, sizeof(struct command));
    /* A driver sends any function, even one that the client rejects. */
    const size_t start = builder->length;
    const mip_error error = mip_encode(entry->codec, values, builder);
    if (error != MIP_OK) {
        return mip_error_name(error);
    }
    c->request.exchange = entry->command->exchange;
    c->request.asked = mip_requested(c->request.exchange, builder->buffer + start);
    mip_client_wait(&s->client, &c->request, s->now);
    *end = c;
    const struct mip_response *asked = c->request.asked;
    /* A response with several layouts is decoded after it has arrived. */
    if (asked != NULL && asked->descriptor != 0 && asked->layout == NULL) {
        size_t i = 0;
        while (mip_registry_link(entry, i)->descriptor != asked->descriptor) {
            i++;
        }
        const struct mip_codec *codec = mip_registry_link(entry, i)->codec;
        if (!mip_client_expect(&c->request, codec, arena_take(s->arena, codec->size))) {
            abort();
        }
    }
    return NULL;
}

/* Takes the time from a clock, if there is a port. */
static void tick(struct session *s) {
    if (s->port != NULL) {
        s->now = port_milliseconds(s->port);
    }
}

static const char *send(struct session *s, const struct json *step) {
    const struct json *fields = json_get(step, "fields");
    uint32_t set;
    if (get_whole(json_get(step, "set"), &set) != NULL || set < 1 || set > 255 || fields == NULL ||
        fields->kind != JSON_LIST || fields->size == 0) {
        return REQUEST;
    }
    tick(s);
    uint8_t barrier[MIP_MAX_BARRIER];
    const struct mip_client before = s->client;
    const size_t size = mip_client_barrier(&s->client, barrier);
    struct mip_builder builder;
    mip_builder_start(&builder, (uint8_t *)arena_take(s->arena, MIP_MAX_PACKET), MIP_MAX_PACKET, (uint8_t)set);
    struct command *commands = NULL;
    struct command **end = &commands;
    for (const struct json *field = fields->first; field != NULL; field = field->next) {
        const char *wrong = add(s, &builder, field, (uint8_t)set, end);
        if (wrong != NULL) {
            for (; commands != NULL; commands = commands->next) {
                mip_client_cancel(&s->client, &commands->request);
            }
            s->client.missed = before.missed; /* nothing is sent */
            s->client.behind = before.behind;
            if (wrong == REQUEST) {
                return REQUEST;
            }
            begin(s, "not_sent");
            put(s->out, ",\"error\":\"");
            put(s->out, wrong);
            put(s->out, "\"}");
            return NULL;
        }
        end = &(*end)->next;
    }
    const struct mip_packet packet = mip_builder_finish(&builder);
    begin(s, "sent");
    put(s->out, ",\"packet\":\"");
    put_hex(s->out, barrier, size);
    put_hex(s->out, packet.bytes, packet.size);
    put(s->out, "\",\"commands\":[");
    for (struct command *c = commands; c != NULL; c = c->next) {
        put(s->out, c == commands ? "" : ",");
        c->number = s->count++;
        put_unsigned(s->out, c->number);
    }
    put(s->out, "]}");
    if (s->port != NULL) {
        port_write(s->port, barrier, size);
        port_write(s->port, packet.bytes, packet.size);
    }
    for (const struct command *c = commands; c != NULL; c = c->next) {
        if (c->request.state == MIP_REQUEST_SILENT) {
            happened(s, "silent", c);
        }
    }
    *(s->last != NULL ? &s->last->next : &s->sent) = commands;
    for (struct command *c = commands; c != NULL; c = c->next) {
        s->last = c;
    }
    return NULL;
}

/* ------------------------------------------------------------------------------------- receiving */

static const struct mip_entry *entry_of(const struct mip_codec *codec) {
    const struct mip_entry *entry = mip_registry;
    while (entry->codec != codec) {
        entry++;
    }
    return entry;
}

/* Decodes a response for which the command named no structure. */
static void take_response(struct session *s, struct command *c, const struct mip_field *field) {
    struct mip_request *r = &c->request;
    if (r->state == MIP_REQUEST_ACKNOWLEDGED && r->asked != NULL && r->response == NULL) {
        r->response = arena_take(s->arena, r->codec->size);
        r->error = (uint8_t)mip_decode(r->codec, r->response, field, NULL);
        r->responded = r->error == MIP_OK;
        r->state = r->responded ? MIP_REQUEST_ACKNOWLEDGED : MIP_REQUEST_UNDECODABLE;
    }
}

/* Writes a response that the client decoded; it is decoded again to count the trailing bytes. */
static void put_response(struct session *s, const struct command *c, const struct mip_field *field) {
    const struct mip_codec *codec = c->request.codec;
    size_t trailing = 0;
    number(s, "response\":{\"descriptor", field->descriptor);
    if (c->request.state == MIP_REQUEST_UNDECODABLE) {
        put(s->out, ",\"error\":\"");
        put(s->out, mip_error_name((mip_error)c->request.error));
        put(s->out, "\",\"raw\":\"");
        put_hex(s->out, field->data, field->size);
        put(s->out, "\"}");
        return;
    }
    put_name(s->out, entry_of(codec), field->descriptor_set);
    put(s->out, ",\"role\":\"response\",\"values\":");
    put_values(s->out, codec, (const uint8_t *)c->request.response);
    mip_decode(codec, arena_take(s->arena, codec->size), field, &trailing);
    number(s, "trailing", trailing);
    put_char(s->out, '}');
}

static void put_answer(struct session *s, const struct command *c, const struct mip_field *field) {
    static const char *const names[] = {
        [MIP_REQUEST_ACKNOWLEDGED] = "acknowledged",
        [MIP_REQUEST_REFUSED] = "refused",
        [MIP_REQUEST_MISSING_RESPONSE] = "missing_response",
        [MIP_REQUEST_UNDECODABLE] = "undecodable",
    };
    const uint8_t state = c->request.state;
    begin(s, names[state]);
    number(s, "command", c->number);
    if (state == MIP_REQUEST_REFUSED) {
        number(s, "code", c->request.code);
    }
    if (c->request.responded || state == MIP_REQUEST_UNDECODABLE) {
        put_response(s, c, field);
    }
    put_char(s->out, '}');
}

static void tell_timed_out(struct session *s) {
    for (struct command *c = s->sent; c != NULL; c = c->next) {
        if (c->request.state == MIP_REQUEST_TIMED_OUT && !c->timed_out) {
            c->timed_out = true;
            happened(s, "timed_out", c);
        }
    }
}

static void take(struct session *s, const struct mip_packet *packet) {
    struct output others = {NULL, 0, 0};
    struct mip_walk walk = mip_walk_packet(packet);
    struct mip_request *answered;
    struct mip_field field;
    bool any = false;
    if (mip_client_passes(&s->client, packet)) {
        tell_timed_out(s); /* commands sent before it */
        return;
    }
    while (mip_client_next(&s->client, &walk, &answered, &field)) {
        if (answered != NULL) {
            any = true;
            take_response(s, (struct command *)(void *)answered, &field);
            put_answer(s, (struct command *)(void *)answered, &field);
        } else {
            put(&others, others.size == 0 ? "" : ",");
            put_field(&others, s->arena, &field);
        }
    }
    if (walk.error != MIP_OK) {
        put(&others, others.size == 0 ? "" : ",");
        put(&others, "{\"error\":\"field_length\"}");
    }
    if (!any || others.size > 0) {
        begin(s, "received");
        number(s, "set", packet->descriptor_set);
        put(s->out, ",\"fields\":[");
        put_char(&others, '\0');
        put(s->out, others.text);
        put(s->out, "]}");
    }
    free(others.text);
}

static void poll(struct session *s) {
    const uint8_t *nothing = NULL;
    size_t none = 0;
    struct mip_packet packet;
    while (mip_parser_next(s->parser, &nothing, &none, &packet) ||
           mip_client_poll(&s->client, s->parser, s->now, &packet)) {
        take(s, &packet);
    }
    tell_timed_out(s);
}

static void arrived(struct session *s, const uint8_t *data, size_t size) {
    struct mip_packet packet;
    while (mip_parser_next(s->parser, &data, &size, &packet)) {
        take(s, &packet);
    }
    poll(s);
}

static const char *receive(struct session *s, const struct json *step) {
    const struct json *given = json_get(step, "chunk");
    size_t left;
    const uint8_t *at = bytes_of(s->arena, json_get(step, "bytes"), &left);
    uint32_t chunk = UINT32_MAX;
    if (at == NULL || (given != NULL && (get_whole(given, &chunk) != NULL || chunk == 0))) {
        return REQUEST;
    }
    while (left > 0) {
        const size_t size = chunk < left ? chunk : left;
        arrived(s, at, size);
        at += size;
        left -= size;
    }
    return NULL;
}

/* ------------------------------------------------------------------------------ time and the end */

static const char *wait(struct session *s, const struct json *step) {
    uint32_t milliseconds;
    if (get_whole(json_get(step, "milliseconds"), &milliseconds) != NULL) {
        return REQUEST;
    }
    s->now += milliseconds;
    poll(s);
    return NULL;
}

static const char *end(struct session *s, const struct json *step) {
    struct mip_packet packet;
    bool first = true;
    (void)step;
    while (mip_parser_flush(s->parser, &packet)) {
        take(s, &packet);
    }
    poll(s);
    begin(s, "end");
    put(s->out, ",\"waiting\":[");
    for (const struct command *c = s->sent; c != NULL; c = c->next) {
        if (c->request.state == MIP_REQUEST_WAITING) {
            put(s->out, first ? "" : ",");
            put_unsigned(s->out, c->number);
            first = false;
        }
    }
    put_char(s->out, ']');
    number(s, "skipped", s->parser->skipped);
    put_char(s->out, '}');
    return NULL;
}

/* ---------------------------------------------------------------------------------------- a port */

/* Receives for a number of milliseconds. */
static void listen_for(struct session *s, uint32_t milliseconds) {
    uint8_t data[4096];
    const size_t size = port_read(s->port, data, sizeof(data), milliseconds);
    tick(s);
    arrived(s, data, size);
    if (s->port->closed && !s->told) {
        s->told = true;
        begin(s, "closed");
        put_char(s->out, '}');
    }
}

static const char *answers(struct session *s) {
    while (s->client.waiting != NULL) {
        listen_for(s, 100);
    }
    return NULL;
}

static const char *listen_to(struct session *s, const struct json *step) {
    uint32_t milliseconds;
    if (get_whole(json_get(step, "milliseconds"), &milliseconds) != NULL) {
        return REQUEST;
    }
    const uint32_t start = port_milliseconds(s->port);
    for (uint32_t passed = 0; passed < milliseconds; passed = port_milliseconds(s->port) - start) {
        listen_for(s, milliseconds - passed < 100 ? milliseconds - passed : 100);
    }
    return NULL;
}

/* -------------------------------------------------------------------------------------- requests */

static const char *take_step(struct session *s, const struct json *step) {
    const struct json *kind = json_get(step, "step");
    const bool live = s->port != NULL;
    return json_equals(kind, "send")               ? send(s, step)
           : json_equals(kind, "end")              ? end(s, step)
           : live && json_equals(kind, "answers")  ? answers(s)
           : live && json_equals(kind, "listen")   ? listen_to(s, step)
           : !live && json_equals(kind, "receive") ? receive(s, step)
           : !live && json_equals(kind, "time")    ? wait(s, step)
                                                   : REQUEST;
}

static const char *play_steps(struct output *out, struct arena *arena, const struct json *steps, struct port *port) {
    struct session s = {arena, out, {NULL, 0, 0, 0}, NULL, 0, 0, true, port, false, NULL, NULL};
    mip_client_init(&s.client);
    s.parser = (struct mip_parser *)arena_take(arena, sizeof(struct mip_parser));
    mip_parser_init(s.parser);
    put(out, "{\"events\":[");
    for (const struct json *step = steps->first; step != NULL; step = step->next) {
        const char *wrong = take_step(&s, step);
        if (wrong != NULL) {
            return wrong;
        }
    }
    put(out, "]}");
    return NULL;
}

const char *play(struct output *out, struct arena *arena, const struct json *request) {
    const struct json *steps = json_get(request, "steps");
    return steps != NULL && steps->kind == JSON_LIST ? play_steps(out, arena, steps, NULL) : REQUEST;
}

const char *play_live(struct output *out, struct arena *arena, const struct json *request) {
    const struct json *steps = json_get(request, "steps");
    const struct json *name = json_get(request, "port");
    if (steps == NULL || steps->kind != JSON_LIST || name == NULL || name->kind != JSON_STRING) {
        return REQUEST;
    }
    char *text = (char *)arena_take(arena, name->size + 1);
    for (size_t i = 0; i < name->size; i++) {
        text[i] = (char)name->text[i];
    }
    struct port port;
    if (!port_open(&port, text)) {
        return "port";
    }
    const char *wrong = play_steps(out, arena, steps, &port);
    port_close(&port);
    return wrong;
}

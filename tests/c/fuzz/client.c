/*
 * The command client: whatever is sent and received, each request ends once, and no field of a packet is lost.
 *
 * Input: steps. A step is a byte for its kind and for the pieces in which bytes arrive, then what the step needs:
 *
 *     SEND slot set descriptor choice size data      a command with the values that the data hold
 *     ANSWER slot code choice size data              its acknowledge, and a response with these data
 *     PACKET set size payload                        any packet
 *     BYTES size bytes                               anything
 *     TIME high low, CANCEL slot, FLUSH
 */
#include "library.h"

#include "mip/client.h"

enum { SEND,
       ANSWER,
       PACKET,
       BYTES,
       TIME,
       CANCEL,
       FLUSH,
       KINDS };

enum { SLOTS = 4,
       LONGEST = 10000000 }; /* milliseconds after which every request is late */

struct slot {
    struct mip_request request;
    const struct mip_entry *entry; /* NULL until it is used */
    uint8_t set;
    void *response;
    size_t response_size;
    bool waiting;
    unsigned long age;
};

static struct slot slots[SLOTS];
static struct mip_client client;
static struct mip_parser parser;
static uint32_t now;
static unsigned long age;

static struct slot *slot_of(const struct mip_request *request) {
    for (size_t i = 0; i < SLOTS; i++) {
        if (request == &slots[i].request) {
            return &slots[i];
        }
    }
    fprintf(stderr, "the client gave a request that is none\n");
    abort();
}

/* The list holds exactly the requests that wait, oldest first. */
static void check_list(void) {
    unsigned long last = 0;
    size_t listed = 0;
    size_t waiting = 0;
    for (const struct mip_request *r = client.waiting; r != NULL; r = r->next) {
        const struct slot *s = slot_of(r);
        CHECK(s->waiting && s->age > last && ++listed <= SLOTS);
        last = s->age;
    }
    for (size_t i = 0; i < SLOTS; i++) {
        waiting += slots[i].waiting;
        CHECK(slots[i].entry == NULL || slots[i].waiting == (slots[i].request.state == MIP_REQUEST_WAITING));
    }
    CHECK(waiting == listed);
}

/* ------------------------------------------------------------------------------------------ sending */

static const struct mip_entry *command_of(uint8_t set, uint8_t descriptor) {
    const struct mip_entry *entry = mip_registry_next(set, descriptor, NULL);
    return entry != NULL && entry->role == MIP_COMMAND ? entry : NULL;
}

/* Adds the command and then names the place of its response; or both at once. */
static mip_error add(struct slot *s, struct mip_builder *b, const void *command, uint8_t choice) {
    const struct mip_entry *response = mip_registry_link(s->entry, choice % 128);
    mip_error error;
    if (response == NULL) {
        return mip_client_add(&client, &s->request, b, s->entry->command, command, now);
    }
    s->response_size = response->codec->size;
    s->response = exactly(s->response_size);
    memset(s->response, 0xAA, s->response_size);
    if (choice < 128) {
        error = mip_client_add(&client, &s->request, b, s->entry->command, command, now);
        if (error == MIP_OK) {
            const bool expected = mip_client_expect(&s->request, response->codec, s->response);
            CHECK(expected == (s->request.response != NULL));
        }
    } else {
        error = mip_client_send(&client, &s->request, b, s->entry->command, command, response->codec, s->response, now);
        CHECK(all_zero(s->response, s->response_size));
    }
    if (s->request.response == NULL) {
        free(s->response);
        s->response = NULL;
    }
    return error;
}

static void send(struct input *in) {
    struct slot *s = &slots[input_byte(in) % SLOTS];
    const uint8_t set = input_byte(in);
    const struct mip_entry *entry = command_of(set, input_byte(in));
    const uint8_t choice = input_byte(in);
    size_t size = input_byte(in) % (MIP_MAX_FIELD_DATA + 1);
    uint8_t *data = input_bytes(in, &size);
    if (entry != NULL) {
        const struct mip_field field = {data, (uint8_t)size, set, entry->descriptor};
        void *command = exactly(entry->codec->size);
        uint8_t buffer[MIP_MAX_PACKET];
        struct mip_builder b;
        (void)mip_decode(entry->codec, command, &field, NULL); /* zeros if the data cannot be decoded */
        CHECK(mip_builder_start(&b, buffer, sizeof(buffer), set) == MIP_OK);
        void *old = s->response; /* of a request that may still wait */
        s->response = NULL;
        s->entry = entry;
        s->set = set;
        s->age = ++age;
        const mip_error error = add(s, &b, command, choice);
        free(old);
        free(command); /* the client keeps neither */
        CHECK(error == MIP_OK ? b.length > MIP_HEADER_SIZE : b.length == MIP_HEADER_SIZE);
        const uint8_t state = s->request.state;
        CHECK(error == MIP_OK ? state == MIP_REQUEST_WAITING || state == MIP_REQUEST_SILENT
                              : state == MIP_REQUEST_CANCELLED);
        s->waiting = state == MIP_REQUEST_WAITING;
    }
    free(data);
}

/* ---------------------------------------------------------------------------------------- receiving */

/* Checks a request that has ended. True if `field` is the response after `acknowledge`, or that itself. */
static bool check_answer(struct slot *s, const struct mip_field *acknowledge, const struct mip_field *field) {
    const struct mip_request *r = &s->request;
    const struct mip_codec *command = s->entry->codec;
    const bool responds = r->asked != NULL &&
                          (r->state == MIP_REQUEST_ACKNOWLEDGED || r->state == MIP_REQUEST_UNDECODABLE);
    CHECK(s->waiting && acknowledge->descriptor == 0xF1 && acknowledge->size >= 2);
    CHECK(acknowledge->descriptor_set == s->set && acknowledge->data[0] == command->descriptor);
    CHECK(r->code == acknowledge->data[1] && (r->code != 0) == (r->state == MIP_REQUEST_REFUSED));
    CHECK(r->state == MIP_REQUEST_ACKNOWLEDGED || r->state == MIP_REQUEST_REFUSED ||
          r->state == MIP_REQUEST_MISSING_RESPONSE || r->state == MIP_REQUEST_UNDECODABLE);
    CHECK(r->responded == (responds && s->response != NULL && r->state == MIP_REQUEST_ACKNOWLEDGED));
    CHECK((r->error != MIP_OK) == (r->state == MIP_REQUEST_UNDECODABLE));
    if (r->responded) {
        void *value = exactly(s->response_size);
        CHECK(r->codec->size == s->response_size && r->codec->descriptor == field->descriptor);
        CHECK(mip_decode(r->codec, value, field, NULL) == MIP_OK);
        CHECK(memcmp(value, s->response, s->response_size) == 0);
        free(value);
    }
    if (r->state == MIP_REQUEST_UNDECODABLE) {
        CHECK(s->response != NULL && all_zero(s->response, s->response_size));
    }
    s->waiting = false;
    return responds;
}

/* Each field of the packet is returned once, or is the acknowledge in front of a response that is returned. */
static void take(const struct mip_packet *packet) {
    struct mip_walk plain = mip_walk_packet(packet);
    struct mip_walk walk = plain;
    struct mip_request *answered;
    struct mip_field field;
    struct mip_field wanted;
    while (mip_client_next(&client, &walk, &answered, &field)) {
        CHECK(mip_walk_next(&plain, &wanted));
        if (answered != NULL && check_answer(slot_of(answered), &wanted, &field)) {
            CHECK(mip_walk_next(&plain, &wanted));
        }
        CHECK(field.data == wanted.data && field.size == wanted.size && field.descriptor == wanted.descriptor);
        CHECK(field.descriptor_set == packet->descriptor_set);
        check_list();
    }
    CHECK(!mip_walk_next(&plain, &wanted) && walk.error == plain.error && walk.at == plain.at);
}

static bool is_late(const struct mip_request *request) {
    return (uint32_t)(now - request->deadline) < UINT32_C(0x80000000);
}

static void poll(size_t most) {
    struct mip_packet packet;
    const uint8_t *nothing = NULL;
    size_t none = 0;
    size_t found = 0;
    while (mip_parser_next(&parser, &nothing, &none, &packet) || mip_client_poll(&client, &parser, now, &packet)) {
        CHECK(++found <= most);
        take(&packet);
    }
    for (size_t i = 0; i < SLOTS; i++) {
        struct slot *s = &slots[i];
        if (s->waiting && is_late(&s->request)) {
            CHECK(s->request.state == MIP_REQUEST_TIMED_OUT && !s->request.responded);
            s->waiting = false;
        }
    }
    check_list();
}

static void arrive(const uint8_t *bytes, size_t size, size_t piece) {
    while (size > 0) {
        size_t count = piece > 0 && piece < size ? piece : size;
        struct input in = {bytes, count};
        uint8_t *own = input_bytes(&in, &count);
        const uint8_t *at = own;
        size_t left = count;
        struct mip_packet packet;
        while (mip_parser_next(&parser, &at, &left, &packet)) {
            take(&packet);
        }
        free(own);
        poll(MIP_MAX_PACKET);
        bytes += count;
        size -= count;
    }
}

static void arrive_packet(struct mip_builder *b, size_t piece) {
    const struct mip_packet packet = mip_builder_finish(b);
    arrive(packet.bytes, packet.size, piece);
}

static void answer(struct input *in, size_t piece) {
    const struct slot *s = &slots[input_byte(in) % SLOTS];
    const uint8_t code = input_byte(in);
    const uint8_t choice = input_byte(in);
    size_t size = input_byte(in) % 250;
    uint8_t *data = input_bytes(in, &size);
    if (s->entry != NULL) {
        const struct mip_entry *response = mip_registry_link(s->entry, choice);
        const uint8_t acknowledge[2] = {s->entry->descriptor, code};
        uint8_t buffer[MIP_MAX_PACKET];
        struct mip_builder b;
        CHECK(mip_builder_start(&b, buffer, sizeof(buffer), s->set) == MIP_OK);
        CHECK(mip_builder_add(&b, 0xF1, acknowledge, sizeof(acknowledge)) == MIP_OK);
        if (response != NULL) {
            const mip_error error = mip_builder_add(&b, response->descriptor, data, size);
            CHECK(error == b.error);
        }
        arrive_packet(&b, piece);
    }
    free(data);
}

static void any_packet(struct input *in, size_t piece) {
    const uint8_t set = input_byte(in);
    size_t size = input_byte(in);
    uint8_t *payload = input_bytes(in, &size);
    uint8_t buffer[MIP_MAX_PACKET];
    struct mip_builder b;
    if (mip_builder_start(&b, buffer, sizeof(buffer), set) == MIP_OK) {
        if (size > 0) {
            memcpy(buffer + MIP_HEADER_SIZE, payload, size);
        }
        buffer[3] = (uint8_t)size;
        b.length += size;
        arrive_packet(&b, piece);
    }
    free(payload);
}

/* -------------------------------------------------------------------------------------------- steps */

static void any_bytes(struct input *in, size_t piece) {
    size_t size = input_byte(in);
    uint8_t *bytes = input_bytes(in, &size);
    arrive(bytes, size, piece);
    free(bytes);
}

static void cancel(struct slot *s) {
    if (s->entry != NULL) {
        const uint8_t state = s->request.state;
        mip_client_cancel(&client, &s->request);
        CHECK(s->request.state == (s->waiting ? MIP_REQUEST_CANCELLED : state));
        s->waiting = false;
        check_list();
    }
}

static void flush(void) {
    struct mip_packet packet;
    size_t found = 0;
    while (mip_parser_flush(&parser, &packet)) {
        CHECK(++found <= MIP_MAX_PACKET);
        take(&packet);
    }
    poll(0);
}

static void begin(void) {
    memset(slots, 0, sizeof(slots));
    mip_client_init(&client);
    mip_parser_init(&parser);
    now = UINT32_MAX - 3000; /* it wraps around soon */
    age = 0;
}

static void end(void) {
    flush();
    now += LONGEST;
    poll(0);
    CHECK(client.waiting == NULL);
    for (size_t i = 0; i < SLOTS; i++) {
        free(slots[i].response);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct input in = {data, size};
    begin();
    while (in.left > 0) {
        const uint8_t kind = input_byte(&in);
        const size_t piece = kind / KINDS; /* 0: all at once */
        switch (kind % KINDS) {
        case SEND:
            send(&in);
            break;
        case ANSWER:
            answer(&in, piece);
            break;
        case PACKET:
            any_packet(&in, piece);
            break;
        case BYTES:
            any_bytes(&in, piece);
            break;
        case TIME:
            now += (uint32_t)input_byte(&in) << 8;
            now += input_byte(&in);
            poll(MIP_MAX_PACKET);
            break;
        case CANCEL:
            cancel(&slots[input_byte(&in) % SLOTS]);
            break;
        default:
            flush();
            break;
        }
        check_list();
    }
    end();
    return 0;
}

/* The innermost loops of reading a log as columns. If this file has been compiled, `native.py` calls the
 * functions by their names; otherwise, `scan.py` and `walk.py` do the same. Callers pass arrays that are large
 * enough.
 *
 * Plain C99, except for the few lines that make it a Python module, so that any Python build tool can compile it.
 */

#ifdef MIP_MODULE
#include <Python.h>
#endif

#include <stdint.h>
#include <string.h>

#if defined(_WIN32)
#define API __declspec(dllexport)
#else
#define API __attribute__((visibility("default")))
#endif

enum {
    HEAD = 4,
    OVERHEAD = 6,
    KINDS = 1024, /* maximum number of different fields: as in native.py */
    BITS = 12,
    SLOTS = 1 << BITS /* size of the table that finds them */
};

/* Returns the size of the packet that begins here, or 0 if there is none. The log has `left` more bytes. */
static int64_t packet_size(const uint8_t *data, int64_t left)
{
    uint16_t a = 0, b = 0;
    int size, i;

    if (left < OVERHEAD || data[1] != 0x65 || data[2] == 0)
        return 0;
    size = data[3] + OVERHEAD;
    if (size > left)
        return 0;
    for (i = 0; i < size - 2; i++) { /* b does not need a, so compilers vectorize this */
        a = (uint16_t)(a + data[i]);
        b = (uint16_t)(b + data[i] * (size - 2 - i));
    }
    return data[size - 2] == (uint8_t)a && data[size - 1] == (uint8_t)b ? size : 0;
}

/* Finds the packets that begin in `first` ... `limit`: stores where each begins and ends, and returns
 * their number. Packets never overlap; with `overlap`, finds everything that looks like a packet.
 */
API int64_t mip_packets(const uint8_t *data, int64_t first, int64_t limit, int64_t length,
                        int64_t overlap, int32_t *begin, int32_t *end)
{
    int64_t at = first, count = 0;

    if (limit > length)
        limit = length;
    while (at < limit) {
        int64_t size;

        if (data[at] != 0x75) {
            const uint8_t *next = memchr(data + at, 0x75, (size_t)(limit - at));
            if (next == NULL)
                break;
            at = next - data;
        }
        size = packet_size(data + at, length - at);
        if (size != 0) {
            begin[count] = (int32_t)at;
            end[count++] = (int32_t)(at + size);
        }
        at += size != 0 && !overlap ? size : 1;
    }
    return count;
}

/* Returns the index of a key in `keys`, which has `*count` elements; adds the key if it is new. */
static int32_t number_of(uint32_t key, uint32_t *keys, int64_t *count, uint16_t *slots)
{
    uint32_t slot = key * 2654435761u >> (32 - BITS);

    while (slots[slot] != 0) {
        if (keys[slots[slot] - 1] == key)
            return slots[slot] - 1;
        slot = (slot + 1) % SLOTS;
    }
    if (*count == KINDS)
        return -1;
    keys[*count] = key;
    slots[slot] = (uint16_t)++*count;
    return slots[slot] - 1;
}

/* Lists all fields of packets, in the order of the log: the packet of each, the offset of its data in
 * the payload, and the index of its key. A key is set << 16 | descriptor << 8 | length; `keys` has them
 * in order of first occurrence, and `counts` the number of fields of each. Returns the number of keys,
 * or -1 if there are more than KINDS, or more fields than `room`.
 */
API int64_t mip_fields(const uint8_t *data, const int32_t *begin, int64_t packets, int64_t room,
                       uint32_t *keys, int64_t *counts, uint16_t *number, int32_t *packet,
                       uint8_t *offset)
{
    uint16_t slots[SLOTS] = {0};
    int64_t kinds = 0, count = 0, p;

    for (p = 0; p < packets; p++) {
        const uint8_t *payload = data + begin[p] + HEAD;
        const uint8_t *stop = payload + payload[-1];
        const uint8_t *at = payload;
        uint32_t set = (uint32_t)payload[-2] << 16;

        while (at < stop) {
            int length = at[0]; /* read once: another program may change it */
            int64_t before = kinds;
            int32_t n;

            if (length < 2 || length > stop - at)
                break;
            n = number_of(set | (uint32_t)at[1] << 8 | (uint32_t)length, keys, &kinds, slots);
            if (n < 0 || count == room)
                return -1;
            counts[n] = n == before ? 1 : counts[n] + 1;
            number[count] = (uint16_t)n;
            packet[count] = (int32_t)p;
            offset[count++] = (uint8_t)(at + 2 - payload);
            at += length;
        }
    }
    return kinds;
}

/* Sorts the fields by key. `next` is the index at which the fields of each key begin. */
API void mip_sort(const uint16_t *number, const int32_t *packet, const uint8_t *offset,
                  int64_t fields, int64_t *next, int32_t *packets, uint8_t *offsets)
{
    int64_t i;

    for (i = 0; i < fields; i++) {
        int64_t place = next[number[i]]++;

        packets[place] = packet[i];
        offsets[place] = offset[i];
    }
}

/* Copies `size` bytes of each of these fields, one row per field, and reverses every `item` bytes. */
API void mip_gather(const uint8_t *data, const int32_t *begin, const int32_t *packet,
                    const uint8_t *offset, int64_t rows, int64_t size, int64_t item, uint8_t *out)
{
    int64_t row, i;

    for (row = 0; row < rows; row++, out += size) {
        const uint8_t *from = data + begin[packet[row]] + HEAD + offset[row];

        if (item == 4) {
            for (i = 0; i < size; i += 4) {
                out[i] = from[i + 3];
                out[i + 1] = from[i + 2];
                out[i + 2] = from[i + 1];
                out[i + 3] = from[i];
            }
        } else if (item == 8) {
            for (i = 0; i < size; i += 8) {
                out[i] = from[i + 7];
                out[i + 1] = from[i + 6];
                out[i + 2] = from[i + 5];
                out[i + 3] = from[i + 4];
                out[i + 4] = from[i + 3];
                out[i + 5] = from[i + 2];
                out[i + 6] = from[i + 1];
                out[i + 7] = from[i];
            }
        } else if (item == 2) {
            for (i = 0; i < size; i += 2) {
                out[i] = from[i + 1];
                out[i + 1] = from[i];
            }
        } else {
            memcpy(out, from, (size_t)size);
        }
    }
}

#ifdef MIP_MODULE
static struct PyModuleDef module = {PyModuleDef_HEAD_INIT, "_kernel", NULL, 0, NULL, NULL, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__kernel(void)
{
    return PyModule_Create(&module);
}
#endif

/* A UDP port of this machine: each read returns one datagram. */
#ifndef UDP_H
#define UDP_H
#define _DEFAULT_SOURCE
#include "mip/3dm_commands.h"

#include <arpa/inet.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

static int udp_open(const char *port) {
    struct sockaddr_in to;
    memset(&to, 0, sizeof(to));
    to.sin_family = AF_INET;
    to.sin_port = htons((uint16_t)atoi(port));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int made = socket(AF_INET, SOCK_DGRAM, 0);
    return connect(made, (const struct sockaddr *)&to, sizeof(to)) == 0 ? made : -1;
}

static bool udp_wait(int udp, int milliseconds) {
    struct pollfd wait = {udp, POLLIN, 0};
    return poll(&wait, 1, milliseconds) > 0;
}

static size_t udp_read(int udp, uint8_t *bytes, size_t size) {
    const ssize_t count = udp_wait(udp, 10) ? recv(udp, bytes, size, 0) : 0;
    return count > 0 ? (size_t)count : 0;
}

static bool udp_write(int udp, const uint8_t *bytes, size_t size) {
    return send(udp, bytes, size, 0) == (ssize_t)size;
}

static uint32_t udp_now(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint32_t)now.tv_sec * 1000u + (uint32_t)(now.tv_nsec / 1000000);
}

/* What came of the pairs; `shift` counts those in a row that were not right. */
struct count {
    unsigned right, stale, other, shift, longest, kept;
};

static void count_pair(struct count *count, bool acknowledged, bool right) {
    count->right += right;
    count->stale += acknowledged && !right;
    count->other += !acknowledged;
    count->shift = right ? 0 : count->shift + 1;
    count->longest = count->shift > count->longest ? count->shift : count->longest;
    usleep(20000);
}

static int print_count(const struct count *count) {
    return printf("{\"right\": %u, \"stale\": %u, \"other\": %u, \"longest\": %u, \"kept\": %u}\n", count->right,
                  count->stale, count->other, count->longest, count->kept) < 0;
}

#endif

/* Serial ports and TCP connections on Windows. Link with ws2_32. */
#ifdef _WIN32
#ifndef _WIN32_WINNT
#define _WIN32_WINNT 0x0601
#endif
#include <winsock2.h>

#include <ws2tcpip.h>

#include <windows.h>

#include "open.h"

#include <stdio.h>

/* ------------------------------------------------------------------------ reading and writing */

/** Notes why a line is lost; returns false. */
static bool lost(void *user, const char *why) {
    struct mip_line *line = (struct mip_line *)user;
    if (line->handle != -1) { /* otherwise, it is known why it could not be opened again */
        line->error = why;
    }
    return false;
}

static bool read_serial(void *user, uint8_t *bytes, size_t size, size_t *count) {
    DWORD got = 0;
    const HANDLE port = (HANDLE)((struct mip_line *)user)->handle;
    if (!ReadFile(port, bytes, (DWORD)size, &got, NULL)) { /* waits as configured by set_mode */
        return lost(user, "the port was disconnected");
    }
    *count = got;
    return true;
}

static bool write_serial(void *user, const uint8_t *bytes, size_t size) {
    const HANDLE port = (HANDLE)((struct mip_line *)user)->handle;
    while (size > 0) {
        DWORD count = 0;
        if (!WriteFile(port, bytes, (DWORD)size, &count, NULL) || count == 0) {
            return lost(user, "the port was disconnected, or accepts no bytes");
        }
        bytes += count;
        size -= count;
    }
    return true;
}

/** Waits until a socket can be read or written; returns a negative number if it is lost. */
static int wait_for(SOCKET socket, short event, int wait) {
    WSAPOLLFD one;
    if (socket == INVALID_SOCKET) { /* could not be opened again; WSAPoll() may ignore it */
        return -1;
    }
    one.fd = socket;
    one.events = event;
    one.revents = 0;
    return WSAPoll(&one, 1, wait);
}

static bool read_tcp(void *user, uint8_t *bytes, size_t size, size_t *count) {
    const SOCKET socket = (SOCKET)((struct mip_line *)user)->handle;
    const int ready = wait_for(socket, POLLRDNORM, MIP_LINE_WAIT);
    if (ready <= 0) { /* nothing for a while */
        return ready == 0 || lost(user, "the connection was lost");
    }
    const int got = recv(socket, (char *)bytes, (int)size, 0);
    if (got <= 0) {
        return lost(user, got == 0 ? "the connection was closed" : "the connection was lost");
    }
    *count = (size_t)got;
    return true;
}

static bool write_tcp(void *user, const uint8_t *bytes, size_t size) {
    const SOCKET socket = (SOCKET)((struct mip_line *)user)->handle;
    while (size > 0) {
        if (wait_for(socket, POLLWRNORM, MIP_LINE_PATIENCE) <= 0) {
            return lost(user, "the other end accepts no bytes");
        }
        const int count = send(socket, (const char *)bytes, (int)size, 0);
        if (count <= 0) {
            return lost(user, "the connection was lost");
        }
        bytes += count;
        size -= (size_t)count;
    }
    return true;
}

static uint32_t milliseconds(void *user) {
    (void)user;
    return (uint32_t)GetTickCount64();
}

uint32_t mip_line_pause(uint32_t wait) {
    if (wait > 0) {
        Sleep(wait);
    }
    return milliseconds(NULL);
}

/* ------------------------------------------------------------------------------- serial ports */

/** Sets 8N1 without flow control, at this rate. */
static bool set_mode(HANDLE port, uint32_t baud) {
    DCB mode;
    COMMTIMEOUTS times;
    memset(&mode, 0, sizeof(mode));
    mode.DCBlength = sizeof(mode);
    mode.BaudRate = baud;
    mode.fBinary = TRUE;
    mode.fDtrControl = DTR_CONTROL_ENABLE;
    mode.fRtsControl = RTS_CONTROL_ENABLE;
    mode.ByteSize = 8;
    mode.Parity = NOPARITY;
    mode.StopBits = ONESTOPBIT;
    /* A read returns available bytes at once, and waits only for the first one. */
    times.ReadIntervalTimeout = MAXDWORD;
    times.ReadTotalTimeoutMultiplier = MAXDWORD;
    times.ReadTotalTimeoutConstant = MIP_LINE_WAIT;
    times.WriteTotalTimeoutMultiplier = 0;
    times.WriteTotalTimeoutConstant = MIP_LINE_PATIENCE;
    return SetCommState(port, &mode) && SetCommTimeouts(port, &times) &&
           PurgeComm(port, PURGE_RXCLEAR | PURGE_TXCLEAR);
}

void mip_line_open_serial(struct mip_line *line, const char *name, uint32_t baud) {
    char path[64];
    const int length = snprintf(path, sizeof(path), "%s%s", name[0] == '\\' ? "" : "\\\\.\\", name);
    if (length < 0 || (size_t)length >= sizeof(path)) {
        line->error = "the name is too long";
        return;
    }
    const HANDLE port =
        CreateFileA(path, GENERIC_READ | GENERIC_WRITE, 0, NULL, OPEN_EXISTING, 0, NULL);
    if (port == INVALID_HANDLE_VALUE) {
        line->error = GetLastError() == ERROR_ACCESS_DENIED
                          ? "the port is in use by another program"
                          : "there is no such port";
        return;
    }
    if (!set_mode(port, baud)) {
        line->error = "the port does not support this baud rate";
        CloseHandle(port);
        return;
    }
    line->handle = (intptr_t)port;
    line->port.read = read_serial;
    line->port.write = write_serial;
    line->port.now = milliseconds;
}

bool mip_line_set_mode(const struct mip_line *line, uint32_t baud) {
    return set_mode((HANDLE)line->handle, baud);
}

/* --------------------------------------------------------------------------- TCP connections */

/** Connects to one address. */
static SOCKET connected(const struct addrinfo *to) {
    const BOOL one = TRUE;
    const SOCKET made = socket(to->ai_family, to->ai_socktype, to->ai_protocol);
    if (made == INVALID_SOCKET) {
        return INVALID_SOCKET;
    }
    if (connect(made, to->ai_addr, (int)to->ai_addrlen) != 0) {
        closesocket(made);
        return INVALID_SOCKET;
    }
    setsockopt(made, IPPROTO_TCP, TCP_NODELAY, (const char *)&one, sizeof(one));
    return made;
}

void mip_line_open_tcp(struct mip_line *line, const char *host, const char *number) {
    WSADATA about;
    struct addrinfo wanted;
    struct addrinfo *found = NULL;
    SOCKET made = INVALID_SOCKET;
    memset(&wanted, 0, sizeof(wanted));
    wanted.ai_socktype = SOCK_STREAM;
    if (WSAStartup(MAKEWORD(2, 2), &about) != 0) {
        line->error = "the network is not available";
        return;
    }
    if (getaddrinfo(host, number, &wanted, &found) != 0) {
        line->error = "there is no such host";
        WSACleanup();
        return;
    }
    for (const struct addrinfo *to = found; to != NULL && made == INVALID_SOCKET;
         to = to->ai_next) {
        made = connected(to);
    }
    freeaddrinfo(found);
    if (made == INVALID_SOCKET) {
        line->error = "no connection";
        WSACleanup();
        return;
    }
    line->handle = (intptr_t)made;
    line->port.read = read_tcp;
    line->port.write = write_tcp;
    line->port.now = milliseconds;
}

void mip_line_close(struct mip_line *line) {
    if (line->handle == -1) {
        return;
    }
    if (line->is_tcp) {
        closesocket((SOCKET)line->handle);
        WSACleanup();
    } else {
        CloseHandle((HANDLE)line->handle);
    }
    line->handle = -1;
}

#else
typedef int mip_not_windows; /* C does not allow an empty file */
#endif

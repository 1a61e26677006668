// A core that does nothing: sketches are compiled and linked with it, not run.
#include "Arduino.h"

SerialPort Serial, Serial1;

void SerialPort::begin(unsigned long) {
}
int SerialPort::available() {
    return 0;
}
int SerialPort::read() {
    return -1;
}
size_t SerialPort::write(const uint8_t *, size_t size) {
    return size;
}
void SerialPort::print(double) {
}
void SerialPort::print(const char *) {
}
void SerialPort::println(double) {
}
void SerialPort::println(const char *) {
}

uint32_t millis() {
    static uint32_t time;
    return time++;
}

int main() {
    setup();
    for (;;) {
        loop();
    }
}

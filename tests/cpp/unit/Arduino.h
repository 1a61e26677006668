// The functions that a sketch calls, and Arduino's macros with short names.
#ifndef ARDUINO_H
#define ARDUINO_H

#include <stddef.h>
#include <stdint.h>

#define HIGH 0x1
#define LOW 0x0
#define INPUT 0x0
#define OUTPUT 0x1
#define CHANGE 2
#define FALLING 3
#define RISING 4
#define DEFAULT 1
#define EXTERNAL 0
#define DEC 10
#define PI 3.1415926535897932384626433832795
#define sq(x) ((x) * (x))
#define radians(deg) ((deg) * PI / 180)
#define degrees(rad) ((rad) * 180 / PI)
#define constrain(x, low, high) ((x) < (low) ? (low) : ((x) > (high) ? (high) : (x)))
#define bit(b) (1UL << (b))
#define bitRead(value, bit) (((value) >> (bit)) & 0x01)
#define lowByte(w) ((uint8_t)((w) & 0xff))
#define highByte(w) ((uint8_t)((w) >> 8))
#define interrupts() __asm volatile("cpsie i")
#define noInterrupts() __asm volatile("cpsid i")
#define F(text) (text)

class SerialPort {
  public:
    void begin(unsigned long baud);
    int available();
    int read();
    size_t write(const uint8_t *bytes, size_t size);
    void print(double number);
    void print(const char *text);
    void println(double number);
    void println(const char *text);
};
extern SerialPort Serial, Serial1;

extern "C" uint32_t millis();
void setup();
void loop();

#endif

/* Lets a unit program run in an emulated AVR: its output and its exit status go to the serial port. */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <stdio.h>

int unit_main(void);
void unit_exit(int status);

static int put(char c, FILE *file) {
    (void)file;
    while ((UCSR0A & (1 << UDRE0)) == 0) {
    }
    UDR0 = (uint8_t)c;
    return 0;
}

static FILE serial = FDEV_SETUP_STREAM(put, NULL, _FDEV_SETUP_WRITE);

/* The emulator ends when the processor sleeps without interrupts. */
void unit_exit(int status) {
    printf("exit %d\n", status);
    for (;;) {
        cli();
        sleep_mode();
    }
}

int main(void) {
    UCSR0B = 1 << TXEN0;
    stdout = &serial;
    stderr = &serial;
    unit_exit(unit_main());
}

/* In front of each unit program for AVR: avr.c calls it. */
#include <stdlib.h>

void unit_exit(int status);
#define exit(status) unit_exit(status)
#define main unit_main

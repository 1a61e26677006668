/**
 * @file
 * For the Arduino IDE, which finds a library only by a header at the top of src: include this
 * before the headers in mip/.
 */
#ifndef MIP_ARDUINO_H
#define MIP_ARDUINO_H

#include "mip/core.h"

#endif

"""Where hosts connect to virtual devices: pseudo-terminals, TCP, UDP, serial ports."""

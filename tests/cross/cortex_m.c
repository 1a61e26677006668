/* The vector table of an emulated Cortex-M: the initial stack pointer, and newlib's entry. Its first RAM is at 0. */
void _start(void);

__attribute__((section(".vectors"), used)) static void *const vectors[16] = {(void *)0x20200000, (void *)_start};

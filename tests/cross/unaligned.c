/* Reads a number from an odd address, which a machine that insists on alignment traps. */
#include <stdint.h>
#include <string.h>

int main(int argc, char **argv) {
    static union {
        uint32_t numbers[4];
        uint8_t bytes[16];
    } memory;
    (void)argv;
    const volatile uint32_t *odd = (const volatile uint32_t *)(uintptr_t)(memory.bytes + argc);
    return (int)*odd;
}

#!/bin/sh
# Builds the conformance driver against a folder of generated C; the last line says how to run it.
#
#     build_driver.sh GENERATED_FOLDER BUILD_FOLDER
#
# MIP_SANITIZE=1 builds it with the address and undefined behavior sanitizers. CC chooses the compiler, CFLAGS adds options.
# MIP_LIBRARY names the library, if it has been built already.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
generated=$(cd "$1" && pwd)
mkdir -p "$2"
build=$(cd "$2" && pwd)
: "${CC:=cc}"
: "${CFLAGS:=}"

flags="-std=c99 -O1 -DMIP_WHOLE_ARRAYS -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror $CFLAGS"
program=$build/driver
if [ "${MIP_SANITIZE:-0}" = 1 ]; then
    flags="$flags -g -fsanitize=address,undefined -fno-sanitize-recover=all"
    program=$build/driver-sanitized
fi

# Identifies everything that the program is made of, so that nothing is built twice.
stamp=$(cat "$here/driver/driver.c" "$generated"/src/mip/*.h "$generated"/src/mip/*/* | cksum)
stamp="$CC $flags $generated $stamp"
if [ ! -x "$program" ] || [ "$(cat "$program.stamp" 2>/dev/null)" != "$stamp" ]; then
    # shellcheck disable=SC2086
    "$CC" $flags -I"$generated/src" "$here/driver/driver.c" ${MIP_LIBRARY:-"$generated"/src/mip/*/*.c} -o "$program"
    printf '%s\n' "$stamp" >"$program.stamp"
fi
echo "${PYTHON:-python3} $here/driver/driver.py $program"

#!/bin/sh
# Builds the conformance driver of C++ against a folder of generated C; the last line says how to run it.
#
#     build_driver.sh GENERATED_FOLDER BUILD_FOLDER
#
# It is the driver of C, except for what C++ does: see driver/layouts.cpp. The variables are those of
# tests/c/build_driver.sh, and CXX chooses the compiler of C++. With MIP_EVERY=N, the three ways to get a value are
# compared for every N-th layout only; MIP_SEED chooses which.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
generated=$(cd "$1" && pwd)
mkdir -p "$2"
build=$(cd "$2" && pwd)
: "${CC:=cc}"
: "${CXX:=c++}"
: "${CFLAGS:=}"
: "${MIP_EVERY:=1}"
: "${MIP_SEED:=1}"

warnings="-O1 -DMIP_WHOLE_ARRAYS -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror $CFLAGS"
program=$build/driver
if [ "${MIP_SANITIZE:-0}" = 1 ]; then
    warnings="$warnings -g1 -fsanitize=address,undefined -fno-sanitize-recover=all"
    program=$build/driver-sanitized
fi
names=
for name in decode encode packet_check parser_next parser_flush; do
    names="$names -Dmip_$name=cpp_$name"
done

# Identifies everything that the program is made of, so that nothing is built twice.
stamp=$(cat "$0" "$here"/driver/* "$here/../c/driver/driver.c" "$generated"/src/mip/*.h "$generated"/src/mip/*/* | cksum)
stamp="$CC $CXX $warnings $generated $MIP_EVERY $MIP_SEED $stamp"
if [ ! -x "$program" ] || [ "$(cat "$program.stamp" 2>/dev/null)" != "$stamp" ]; then
    sed -n 's/^MIP_LAYOUT(\([a-z0-9_]*\),.*/\1/p' "$generated"/src/mip/cpp/*.hpp |
        awk -v n="$MIP_EVERY" -v seed="$MIP_SEED" '{ print "LAYOUT(" $1 ", " ((NR + seed) % n == 0 ? "true" : "false") ")" }' \
            >"$build/layouts.inc"
    cd "$build"
    # shellcheck disable=SC2086
    "$CC" -std=c99 $warnings $names -I"$generated/src" -c "$here/../c/driver/driver.c"
    # shellcheck disable=SC2086
    "$CXX" -std=c++17 $warnings -fno-exceptions -fno-rtti -I"$generated/src" -I"$build" -c "$here/driver/layouts.cpp"
    if [ -z "${MIP_LIBRARY:-}" ]; then
        mkdir -p library
        # shellcheck disable=SC2086
        (cd library && "$CC" -std=c99 $warnings -I"$generated/src" -c "$generated"/src/mip/*/*.c)
        MIP_LIBRARY=$(echo library/*.o)
    fi
    # shellcheck disable=SC2086
    "$CXX" $warnings driver.o layouts.o $MIP_LIBRARY -o "$program"
    printf '%s\n' "$stamp" >"$program.stamp"
fi
echo "${PYTHON:-python3} $here/../c/driver/driver.py $program"

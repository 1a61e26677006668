#!/bin/sh
# tools.sh check|test|all: brings what can be brought, and names what is missing with its remedy, all of it at once.
set -u
missing=0

lacks() {
    echo "make: $1 is missing; $2" >&2
    missing=1
}

command_or() {
    command -v "$1" >/dev/null 2>&1 || lacks "$1" "$2"
}

# Of rustup, which has commands for components that are not installed.
component() {
    "$2" --version >/dev/null 2>&1 && return
    echo "installing $1"
    rustup --quiet component add "$1" >/dev/null 2>&1
    "$2" --version >/dev/null 2>&1 || lacks "$1" "rustup component add $1 (Debian without rustup: apt-get install $3)"
}

component rustfmt rustfmt rustfmt
[ "$1" = check ] && exit $missing

if command -v cargo >/dev/null 2>&1; then
    component clippy cargo-clippy rust-clippy
else
    lacks cargo "install Rust: https://rustup.rs"
fi
if command -v cc >/dev/null 2>&1; then
    printf '#include <stdio.h>\nint main(void) { return puts("") < 0; }\n' |
        cc -fsanitize=address,undefined -x c - -o /dev/null 2>/dev/null ||
        lacks "a part of the C compiler" "cc must link with -fsanitize=address,undefined (Debian: apt-get install gcc libc6-dev)"
else
    lacks "a C compiler, cc," "install one (Debian: apt-get install gcc libc6-dev)"
fi
[ "$1" = test ] && exit $missing

command_or tshark "install Wireshark 4.0 or later (Debian: apt-get install tshark)"
command_or text2pcap "it comes with Wireshark (Debian: apt-get install wireshark-common)"
command_or g++ "install it (Debian: apt-get install g++)"
command_or clang "install it (Debian: apt-get install clang)"
command_or clang++ "install it (Debian: apt-get install clang)"
command_or x86_64-w64-mingw32-gcc "install it (Debian: apt-get install gcc-mingw-w64-x86-64)"
command_or arduino-builder "install it (Debian: apt-get install arduino-builder)"
[ -d /usr/share/arduino/hardware/arduino/avr ] ||
    lacks "the core of Arduino's AVR boards" "install it (Debian: apt-get install arduino-core-avr)"
command_or doxygen "install it (Debian: apt-get install doxygen)"
command_or node "install it (Debian: apt-get install nodejs)"
command_or npm "install it (Debian: apt-get install npm)"
target=thumbv7m-none-eabi
if ! rustup target list --installed 2>/dev/null | grep -qx $target; then
    echo "installing $target"
    rustup --quiet target add $target >/dev/null 2>&1 || lacks "the Rust target $target" "rustup target add $target"
fi
for version in 3.10 3.11 3.12 3.13; do
    "python$version" -c pass 2>/dev/null || ls "${PYENV_ROOT:-$HOME/.pyenv}/versions/$version".*/bin/python >/dev/null 2>&1 ||
        lacks "Python $version" "install it (pyenv install $version)"
done
exit $missing

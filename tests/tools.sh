#!/bin/sh
# tools.sh check|test|packaging|release|all|cross|fuzz|miri|prove|semver|workflows: installs what it can, and names everything
# else that is missing, with its remedy. `make check` and `make test` leave out what needs Rust where it is missing.
set -u
goal=$1
missing=0

lacks() {
    echo "make: $1 is missing; $2" >&2
    missing=1
}

command_or() {
    command -v "$1" >/dev/null 2>&1 || lacks "$1" "$2"
}

# A component of rustup, which has commands even for components that are not installed.
component() {
    "$2" --version >/dev/null 2>&1 && return
    if command -v rustup >/dev/null 2>&1; then
        echo "installing $1"
        rustup --quiet component add "$1" >/dev/null 2>&1
    fi
    "$2" --version >/dev/null 2>&1 || [ "$goal" = check ] || lacks "$1" "rustup component add $1 (Debian without rustup: apt-get install $3)"
}

# A compiler for Linux on another machine, with its C library.
cross() {
    if ! command -v "$1-gcc" >/dev/null 2>&1; then
        lacks "$1-gcc" "install it (Debian: apt-get install gcc-$1 libc6-dev-$2-cross)"
    else
        printf '#include <stdio.h>\nint main(void) { return puts("") < 0; }\n' | "$1-gcc" -static -x c - -o /dev/null 2>/dev/null ||
            lacks "the C library of $1-gcc" "install it (Debian: apt-get install libc6-dev-$2-cross)"
    fi
}

if [ "$1" = cross ]; then
    cross i686-linux-gnu i386
    cross arm-linux-gnueabihf armhf
    cross aarch64-linux-gnu arm64
    cross powerpc-linux-gnu powerpc
    cross mips-linux-gnu mips
    cross sparc64-linux-gnu sparc64
    for machine in i386 arm aarch64 ppc mips sparc64; do
        command_or "qemu-$machine" "install it (Debian: apt-get install qemu-user)"
    done
    command_or arm-none-eabi-gcc "install it (Debian: apt-get install gcc-arm-none-eabi libnewlib-arm-none-eabi)"
    command_or qemu-system-arm "install it (Debian: apt-get install qemu-system-arm)"
    command_or avr-gcc "install it (Debian: apt-get install gcc-avr avr-libc)"
    command_or simavr "install it (Debian: apt-get install simavr)"
    exit $missing
fi

if [ "$1" = fuzz ]; then
    command_or clang "install it (Debian: apt-get install clang)"
    printf '#include <stddef.h>\nint LLVMFuzzerTestOneInput(const void *d, size_t n) { return d == NULL && n > 0; }\n' |
        clang -fsanitize=fuzzer,address,undefined -x c - -o /dev/null 2>/dev/null ||
        lacks libFuzzer "clang must link with -fsanitize=fuzzer,address,undefined (Debian: apt-get install libclang-rt-dev)"
    command_or cargo "install Rust: https://rustup.rs"
    exit $missing
fi

# Debian has CBMC since version 13, and Ubuntu since 24.04. On an older Debian, the packages of version 13 and the
# libraries that they need are unpacked in a folder of their own, and run with the loader that they contain. apt checks
# their signatures; it keeps what it knows of that version in this folder, so that nothing of the system changes.
prover() {
    command -v cbmc >/dev/null 2>&1 && return
    folder=$(pwd)/${TOOLS:-build/tools}/cbmc
    "$folder/cbmc" --version >/dev/null 2>&1 && return
    if command -v apt-get >/dev/null 2>&1 && [ -f /usr/share/keyrings/debian-archive-keyring.gpg ]; then
        echo "installing cbmc"
        rm -rf "$folder"
        mkdir -p "$folder/lists/partial" "$folder/archives/partial" "$folder/packages" "$folder/files"
        touch "$folder/status"
        echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian trixie main" >"$folder/sources.list"
        set -- -qq -o Dir::State="$folder" -o Dir::State::status="$folder/status" -o Dir::Cache="$folder" -o Dir::Etc::sourcelist="$folder/sources.list" \
            -o Dir::Etc::sourceparts=- -o Acquire::Languages=none -o APT::Sandbox::User=
        (
            apt-get "$@" update && cd "$folder/packages" && apt-get "$@" download cbmc minisat libc6 libgcc-s1 libstdc++6 zlib1g &&
                for package in *.deb; do dpkg-deb -x "$package" "$folder/files" || exit 1; done
        ) >/dev/null 2>"$folder/errors"
        rm -rf "$folder/lists" "$folder/archives" "$folder/packages"
        cat >"$folder/cbmc" <<'END'
#!/bin/sh
usr=$(cd "$(dirname "$0")" && pwd)/files/usr
libraries=$(echo "$usr"/lib/*-linux-gnu)
exec "$(echo "$libraries"/ld-linux*.so.*)" --library-path "$libraries:$usr/lib" "$usr/bin/cbmc" "$@"
END
        chmod +x "$folder/cbmc"
        "$folder/cbmc" --version >/dev/null 2>&1 && return
        sed 's/^/  /' "$folder/errors" >&2
    fi
    lacks cbmc "install version 6 or later (Debian 13, Ubuntu 24.04: apt-get install cbmc; macOS: brew install cbmc)"
}

actionlint() {
    version=1.7.12
    tools=$(pwd)/${TOOLS:-build/tools}
    "$tools/bin/actionlint" --version 2>/dev/null | grep -q "^v*$version$" && return
    if command -v go >/dev/null 2>&1; then
        echo "installing actionlint"
        GOBIN="$tools/bin" GOFLAGS=-mod=mod go install "github.com/rhysd/actionlint/cmd/actionlint@v$version" >/dev/null 2>&1
    fi
    "$tools/bin/actionlint" --version >/dev/null 2>&1 || lacks actionlint "it needs Go 1.24 or later: https://go.dev/dl"
}

if [ "$1" = workflows ]; then
    actionlint
    exit $missing
fi

if [ "$1" = prove ]; then
    command_or cc "install one (Debian: apt-get install gcc libc6-dev)"
    prover
    exit $missing
fi

# Compiled without optimization, which would take four times as long for a tool that has little to do.
semver_checks() {
    version=0.51.0 # for Rust 1.93 and some later versions: it reads the compiler's output, whose form changes
    tools=${TOOLS:-build/tools}
    [ "$("$tools/bin/cargo-semver-checks" --version 2>/dev/null)" = "cargo-semver-checks $version" ] && return
    echo "installing cargo-semver-checks, for some minutes"
    CARGO_PROFILE_RELEASE_OPT_LEVEL=0 CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16 \
        cargo install --quiet --locked cargo-semver-checks --version $version --root "$tools" --target-dir "$tools/target" &&
        rm -rf "$tools/target"
    "$tools/bin/cargo-semver-checks" --version >/dev/null 2>&1 ||
        lacks cargo-semver-checks "it could not be compiled (rustup update; cargo install cargo-semver-checks --version $version)"
}

# An interpreter of Rust, which sees undefined behaviour. It is part of the nightly toolchain, but not of each night's.
if [ "$1" = miri ]; then
    remedy="rustup toolchain install nightly --profile minimal --component miri,rust-src"
    if ! cargo +nightly miri --version >/dev/null 2>&1; then
        echo "installing Miri"
        $remedy >/dev/null 2>&1
    fi
    cargo +nightly miri setup >/dev/null 2>&1 || lacks "Miri, of Rust's nightly toolchain," "$remedy"
    exit $missing
fi

if [ "$1" = semver ]; then
    command_or cargo "install Rust: https://rustup.rs"
    [ $missing = 0 ] && semver_checks
    exit $missing
fi

# What the crate can depend on: packages are built and tried without the network. In a copy, which gets a Cargo.lock.
crates() {
    copy=${TOOLS:-build/tools}/crate
    rm -rf "$copy" && mkdir -p "$copy" && cp -R generated/rust/. "$copy"
    cargo fetch --quiet --offline --manifest-path "$copy/Cargo.toml" 2>/dev/null ||
        cargo fetch --quiet --manifest-path "$copy/Cargo.toml" ||
        lacks "what the Rust crate can depend on" "cargo must reach crates.io, once"
}

if [ "$1" = release ]; then
    command_or cargo "install Rust: https://rustup.rs"
    [ $missing = 0 ] && crates
    exit $missing
fi

[ "$1" = test ] || component rustfmt rustfmt rustfmt
[ "$1" = check ] && exit $missing

if [ "$1" != test ]; then
    command_or cargo "install Rust: https://rustup.rs"
    component clippy cargo-clippy rust-clippy
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
command_or g++ "install it (Debian: apt-get install g++)"
command_or x86_64-w64-mingw32-gcc "install it (Debian: apt-get install gcc-mingw-w64-x86-64)"
command_or arm-none-eabi-g++ "install it (Debian: apt-get install gcc-arm-none-eabi libstdc++-arm-none-eabi-newlib)"
command_or arduino-builder "install it (Debian: apt-get install arduino-builder)"
[ -d /usr/share/arduino/hardware/arduino/avr ] ||
    lacks "the core of Arduino's AVR boards" "install it (Debian: apt-get install arduino-core-avr)"
command_or node "install it (Debian: apt-get install nodejs)"
command_or npm "install it (Debian: apt-get install npm)"
for version in 3.10 3.11 3.12 3.13; do
    "python$version" -c pass 2>/dev/null || ls "${PYENV_ROOT:-$HOME/.pyenv}/versions/$version".*/bin/python >/dev/null 2>&1 ||
        lacks "Python $version" "install it (pyenv install $version)"
done
crates
[ "$1" = packaging ] && exit $missing

command_or xxd "install it (Debian: apt-get install xxd)"
command_or text2pcap "it comes with Wireshark (Debian: apt-get install wireshark-common)"
command_or clang "install it (Debian: apt-get install clang)"
command_or clang++ "install it (Debian: apt-get install clang)"
command_or x86_64-w64-mingw32-g++ "install it (Debian: apt-get install g++-mingw-w64-x86-64)"
command_or valgrind "install it (Debian: apt-get install valgrind)"
command_or doxygen "install it (Debian: apt-get install doxygen)"
command_or cppcheck "install it (Debian: apt-get install cppcheck)"
command_or chromium "install it (Debian: apt-get install chromium)"
target=thumbv7m-none-eabi
if ! rustup target list --installed 2>/dev/null | grep -qx $target; then
    echo "installing $target"
    rustup --quiet target add $target >/dev/null 2>&1 || lacks "the Rust target $target" "rustup target add $target"
fi
prover
exit $missing

#!/bin/sh
# build_driver.sh GENERATED_FOLDER BUILD_FOLDER
# Builds the conformance driver against a generated crate; the last line printed is the command.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
generated=$(cd "$1" && pwd)
mkdir -p "$2"
build=$(cd "$2" && pwd)

command -v cargo >/dev/null || { echo "build_driver.sh: cargo is missing; see https://rustup.rs" >&2; exit 1; }

# A string of TOML.
quoted() { printf '"%s"' "$(printf '%s' "$1" | sed 's/[\\"]/\\&/g')"; }

manifest="[package]
name = \"driver\"
version = \"0.0.0\"
edition = \"2021\"
publish = false

[[bin]]
name = \"driver\"
path = $(quoted "$here/driver/src/main.rs")

[dependencies]
mip-protocol = { path = $(quoted "$generated"), features = [\"dynamic\"] }

[profile.release]
debug-assertions = true
overflow-checks = true

[workspace]"
# Written only when it changes, so that nothing is rebuilt needlessly.
[ "$(cat "$build/Cargo.toml" 2>/dev/null)" = "$manifest" ] || printf '%s\n' "$manifest" >"$build/Cargo.toml"

cargo build --quiet --release --offline --manifest-path "$build/Cargo.toml" --target-dir "$build/target" >&2
echo "$build/target/release/driver"

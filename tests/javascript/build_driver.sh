#!/bin/sh
# usage: build_driver.sh GENERATED_FOLDER BUILD_FOLDER; prints the command that runs the driver.
set -eu
here=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd)
generated=$(CDPATH= cd -- "$1" && pwd)
command -v node >/dev/null || { echo "build_driver.sh: node is missing; install it (Debian: apt-get install nodejs)" >&2; exit 1; }
echo "node $here/driver.mjs $generated"

#!/bin/sh
# usage: build_driver.sh GENERATED_FOLDER BUILD_FOLDER; prints the command that runs the driver.
set -eu
here=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd)
generated=$(CDPATH= cd -- "$1" && pwd)
echo "${PYTHON:-python3} $here/interpreter.py $generated/mip.json"

#!/bin/sh
# build_driver.sh GENERATED_FOLDER BUILD_FOLDER
# Compiles mip.ksy to Python and prints the command that runs the driver; KAITAI_LANGUAGE=javascript only compiles.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
generated=$(cd "$1" && pwd)
mkdir -p "$2"
build=$(cd "$2" && pwd)
language=${KAITAI_LANGUAGE:-python}

for tool in node npm; do
    command -v $tool >/dev/null || { echo "build_driver.sh: $tool is missing; install it (Debian: apt-get install nodejs npm)" >&2; exit 1; }
done

# The compiler and the run-time library, in the versions of the lock; nothing is installed twice.
modules=$build/modules
if ! cmp -s "$here/package-lock.json" "$modules/installed.json"; then
    mkdir -p "$modules"
    cp "$here/package.json" "$here/package-lock.json" "$modules"
    (cd "$modules" && npm ci --loglevel=error --no-audit --no-fund --ignore-scripts >&2)
    cp "$here/package-lock.json" "$modules/installed.json"
fi
KAITAI_MODULES=$modules
export KAITAI_MODULES

stamp=$(cat "$generated/mip.ksy" "$here/compile.cjs" "$here/package-lock.json" | cksum)
if [ "$(cat "$build/$language.stamp" 2>/dev/null)" != "$stamp" ]; then
    node "$here/compile.cjs" "$generated/mip.ksy" "$language" "$build/$language" >&2
    printf '%s\n' "$stamp" >"$build/$language.stamp"
fi

[ "$language" != python ] || echo "env PYTHONPATH=$build/python ${PYTHON:-python3} $here/driver.py $build/python/mip.json"

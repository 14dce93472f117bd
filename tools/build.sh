#!/usr/bin/env bash
# Configures (if need be) and builds one preset: tools/build.sh release|debug|asan [target…]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [[ $# -lt 1 ]]; then
    echo "usage: tools/build.sh release|debug|asan [target…]" >&2
    exit 2
fi
preset="$1"
shift
targets=()
[[ $# -eq 0 ]] || targets=(--target "$@")

log="$(mktemp)"
trap 'rm -f "$log"' EXIT
# Configuring says the same each time; it is of interest only when it fails.
if ! cmake --preset "$preset" >"$log" 2>&1; then
    cat "$log" >&2
    exit 1
fi
sed -n 's/^-- Left out: /build: left out: /p' "$log"
cmake --build --preset "$preset" "${targets[@]}" -- --quiet

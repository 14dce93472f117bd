#!/usr/bin/env bash
# Builds the package of the Debian it runs on: tools/package.sh; prints the path of the .deb, build/package/mesher_VERSION_ARCHITECTURE.deb.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tools/setup.sh build workbench package
tools/build.sh release mesher mesher_bindings mesher_gui
log="$(mktemp)"
trap 'rm -f "$log"' EXIT
rm -f build/package/mesher_*.deb
if ! cpack --config build/release/CPackConfig.cmake -B build/package >"$log" 2>&1; then
    cat "$log" >&2
    exit 1
fi
rm -rf build/package/_CPack_Packages
realpath build/package/mesher_*.deb

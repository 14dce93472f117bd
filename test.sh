#!/usr/bin/env bash
# Builds and runs every test: ./test.sh [preset…]; without arguments debug, asan and release in turn.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

presets=("$@")
[[ ${#presets[@]} -gt 0 ]] || presets=(debug asan release)

export LSAN_OPTIONS="suppressions=$PWD/tools/lsan_suppressions.txt:print_suppressions=0${LSAN_OPTIONS:+:$LSAN_OPTIONS}"

tools/setup.sh build workbench package tests --optional solver peers checks
failed=()
for preset in "${presets[@]}"; do
    echo "=== $preset: build"
    if ! tools/build.sh "$preset"; then
        failed+=("$preset (build)")
        continue
    fi
    echo "=== $preset: tests"
    ctest --test-dir "build/$preset" --output-on-failure --no-tests=error --progress -j 2 || failed+=("$preset")
done

if [[ ${#failed[@]} -gt 0 ]]; then
    echo "test: FAILED in: ${failed[*]}"
    exit 1
fi
echo "test: all tests passed in: ${presets[*]}"

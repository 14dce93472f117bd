#!/usr/bin/env bash
# Runs clang-tidy 14 with .clang-tidy over the sources of MesherCore: tools/lint.sh [file.cpp…]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if ! command -v clang-tidy-14 >/dev/null; then
    echo "lint: clang-tidy-14 is not installed (apt-get install clang-tidy-14)" >&2
    exit 1
fi
[[ -f build/debug/compile_commands.json ]] || tools/build.sh debug
files=("$@")
[[ ${#files[@]} -gt 0 ]] || mapfile -d '' -t files < <(find MesherCore -name '*.cpp' -print0 | sort -z)
printf '%s\0' "${files[@]}" |
    xargs -0 -n 1 -P "$(nproc)" clang-tidy-14 -p build/debug --quiet --warnings-as-errors='*'
echo "lint: ${#files[@]} files are clean"

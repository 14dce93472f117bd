#!/usr/bin/env bash
# Formats all C++ files; with --check changes nothing and fails if a file would change.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mapfile -d '' -t files < <(find MesherCore Gui tests examples \( -name '*.h' -o -name '*.cpp' \) -print0 2>/dev/null | sort -z)
case "${1:-}" in
    "") clang-format-14 -i "${files[@]}" ;;
    --check)
        clang-format-14 --dry-run --Werror "${files[@]}"
        echo "format: ${#files[@]} files are formatted"
        ;;
    *)
        echo "usage: tools/format.sh [--check]" >&2
        exit 2
        ;;
esac

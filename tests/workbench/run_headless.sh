#!/usr/bin/env bash
# Runs a macro in a FreeCAD without a window: run_headless.sh MODULE_DIRECTORY MACRO [argument…]; ends with the macro's status.
set -uo pipefail

module_directory="$1"
macro="$2"
shift 2
profile="$(mktemp -d)"
trap 'rm -rf "$profile"' EXIT
PYTHONDONTWRITEBYTECODE=1 FREECAD_USER_HOME="$profile" PATH="/usr/bin:/bin:$PATH" freecadcmd "$macro" -M "$module_directory" -- "$@" </dev/null

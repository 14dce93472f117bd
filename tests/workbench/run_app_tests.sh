#!/usr/bin/env bash
# The workbench's tests without a window: run_app_tests.sh MODULE_DIRECTORY
set -euo pipefail

profile="$(mktemp -d)"
trap 'rm -rf "$profile"' EXIT
mkdir "$profile/Mod"
ln -s "$1" "$profile/Mod/Mesher"
PYTHONDONTWRITEBYTECODE=1 FREECAD_USER_HOME="$profile" PATH="/usr/bin:/bin:$PATH" freecadcmd -t TestMesherApp </dev/null

#!/usr/bin/env bash
# Runs a macro in a FreeCAD with a window on a display of its own: run_in_freecad.sh MODULE_DIRECTORY MACRO [NAME=value…]
# The macro finds the values in its environment: what stands on the command line FreeCAD would open. Ends with the macro's status.
set -uo pipefail

module_directory="$1"
macro="$2"
shift 2

profile="$(mktemp -d)"
display="$profile/display"
export FREECAD_USER_HOME="$profile" PYTHONDONTWRITEBYTECODE=1 PATH="/usr/bin:/bin:$PATH" QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 QT_X11_NO_MITSHM=1
Xvfb -displayfd 3 -screen 0 1440x1080x24 +extension GLX -nolisten tcp 3>"$display" 2>/dev/null &
server=$!
trap 'kill "$server" 2>/dev/null; wait "$server" 2>/dev/null; rm -rf "$profile"' EXIT
for _ in $(seq 200); do
    [[ -s "$display" ]] && break
    sleep 0.05
done

# The start page would open a browser, and the browser ends a FreeCAD that runs as root; that of 1.x asks for settings at first.
preferences="$profile/preferences.FCMacro"
cat >"$preferences" <<'PREFERENCES'
import FreeCAD
general = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/General")
general.SetString("AutoloadModule", "PartWorkbench")
general.SetBool("ShowSplasher", False)
start = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Start")
start.SetBool("ShowOnStartup", False)
start.SetBool("FirstStart2024", False)
FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Document").SetBool("RecoveryEnabled", False)
FreeCAD.saveParameter()
PREFERENCES
freecadcmd "$preferences" </dev/null >/dev/null 2>&1

DISPLAY=":$(cat "$display")" timeout -k 5 "${PATIENCE:-240}" env "$@" freecad "$macro" -M "$module_directory" </dev/null

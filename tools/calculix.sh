#!/usr/bin/env bash
# CalculiX for releases that have no package of it, as Debian 13: unpacks that of Debian 12 with the libraries that it needs, which
# cannot be installed beside FreeCAD there. tools/calculix.sh FOLDER makes FOLDER/bin/ccx and nothing elsewhere.
set -euo pipefail

if [[ $# -ne 1 ]]; then
    sed -n '2,3s/^# //p' "$0" >&2
    exit 2
fi
mkdir -p "$1"
folder=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Package lists of its own: the system's stay as they are.
mkdir -p "$work"/{etc/apt.conf.d,etc/preferences.d,state/lists/partial,cache/archives/partial,debs}
touch "$work/status"
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] ${MESHER_MIRROR:-http://deb.debian.org/debian} bookworm main" \
    >"$work/etc/sources.list"
cat >"$work/apt.conf" <<CONFIGURATION
Dir::Etc "$work/etc";
Dir::Etc::sourcelist "$work/etc/sources.list";
Dir::State "$work/state";
Dir::State::status "$work/status";
Dir::Cache "$work/cache";
APT::Sandbox::User "";
CONFIGURATION
export APT_CONFIG="$work/apt.conf"
apt-get --quiet=2 -o Acquire::Retries=3 update

(cd "$work/debs" && apt-get --quiet=2 -o Acquire::Retries=3 download calculix-ccx libspooles2.2 libarpack2)
for package in "$work"/debs/*.deb; do
    dpkg-deb --extract "$package" "$work/unpacked"
done

mkdir -p "$folder/bin" "$folder/lib"
cp "$work/unpacked/usr/bin/ccx" "$folder/lib/ccx"
find "$work/unpacked/usr/lib" -name '*.so*' -exec cp --no-dereference --force {} "$folder/lib" \;
missing=$(LD_LIBRARY_PATH=$folder/lib ldd "$folder/lib/ccx" | sed -n 's/ => not found//p' | sort -u)
if [[ -n $missing ]]; then
    echo "calculix: these libraries are missing:" $missing "(they come with FreeCAD, and with libgfortran5 liblapack3)" >&2
    exit 1
fi
cat >"$folder/bin/ccx" <<'WRAPPER'
#!/bin/sh
here=$(dirname "$(dirname "$(readlink -f "$0")")")
LD_LIBRARY_PATH="$here/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" exec "$here/lib/ccx" "$@"
WRAPPER
chmod +x "$folder/bin/ccx"
echo "CalculiX is in $folder/bin/ccx"

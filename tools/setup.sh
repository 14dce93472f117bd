#!/usr/bin/env bash
# Installs the packages of tools/packages.txt that are missing; does nothing when none is.
set -euo pipefail

here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
mapfile -t wanted < <(sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$here/packages.txt")

missing=()
for package in "${wanted[@]}"; do
    status="$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)"
    [[ "$status" == installed ]] || missing+=("$package")
done
if [[ ${#missing[@]} -eq 0 ]]; then
    exit 0
fi

as_root=()
if [[ "$(id -u)" -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
        echo "setup: these packages are missing and sudo is not there to install them: ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --quiet=2
    -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300)

echo "setup: installing ${missing[*]}"
updated=no
for attempt in 1 2 3; do
    # Package lists may be absent (a bare machine) or too old to download from.
    if [[ $attempt -gt 1 ]] || ! "${apt[@]}" install --simulate "${missing[@]}" >/dev/null 2>&1; then
        "${apt[@]}" update && updated=yes
    fi
    if "${apt[@]}" install --yes --no-install-recommends "${missing[@]}" >/dev/null; then
        exit 0
    fi
    echo "setup: attempt $attempt to install the packages failed (package lists updated: $updated)" >&2
    sleep 5
done
echo "setup: could not install: ${missing[*]}" >&2
exit 1

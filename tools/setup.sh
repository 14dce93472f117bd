#!/usr/bin/env bash
# Installs those packages of tools/packages.txt that are missing; does nothing when none is.
#   tools/setup.sh SECTION… [--optional SECTION…]
#   tools/setup.sh                all sections, with those optional that releases may be without
# Ends with 1 if something of the sections cannot be had. What is left out of the optional ones it tells.
set -euo pipefail

here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"

# The entries of one section, as they stand in the list.
entries_of() {
    awk -v wanted="[$1]" '{ sub(/#.*/, ""); gsub(/^[ \t]+|[ \t]+$/, "") }
        /^\[/ { is_wanted = ($0 == wanted); is_there = is_there || is_wanted; next }
        is_wanted && NF { print }
        END { exit !is_there }' "$here/packages.txt" || {
        echo "setup: tools/packages.txt has no section [$1]" >&2
        exit 2
    }
}

# Asking for each package by itself would take seconds. No pipe to grep -q: what it no longer reads ends the program before it.
read_installed() {
    installed=" $(dpkg-query --show --showformat='${Package} ${db:Status-Status}\n' | awk '$2 == "installed" { printf "%s ", $1 }')"
}

read_known() {
    known=" $(apt-cache policy "$@" 2>/dev/null | awk '/^[^ ]+:$/ { sub(/:$/, ""); name = $0 } /Candidate: [^(]/ { printf "%s ", name }')"
}

names_of() {
    sed -e 's/,.*//' -e 's/|/ /g' <<<"$1"
}

# Whether the condition behind "a, where b needs c" holds; without one it does.
is_wanted() {
    [[ "$1" =~ ,\ where\ ([^ ]+)\ needs\ ([^ ]+)$ ]] || return 0
    [[ "$(apt-cache depends "${BASH_REMATCH[1]}" 2>/dev/null)" == *"Depends: ${BASH_REMATCH[2]}"* ]]
}

# Fills `missing` with what is to be installed for these entries, and `unknown` with those that no package is there for.
look_for() {
    local entry name chosen absent=() names
    missing=() unknown=()
    read_installed
    for entry in "$@"; do
        for name in $(names_of "$entry"); do
            [[ "$installed" != *" $name "* ]] || continue 2
        done
        absent+=("$entry")
    done
    [[ ${#absent[@]} -gt 0 ]] || return 0
    mapfile -t names < <(printf '%s\n' "${absent[@]}" | sed -e 's/,.*//' -e 's/|/\n/g' | tr -d ' ')
    read_known "${names[@]}"
    for entry in "${absent[@]}"; do
        is_wanted "$entry" || continue
        chosen=
        for name in $(names_of "$entry"); do
            if [[ "$known" == *" $name "* ]]; then
                chosen=$name
                break
            fi
        done
        if [[ -n "$chosen" ]]; then missing+=("$chosen"); else unknown+=("${entry%%,*}"); fi
    done
}

update_lists() {
    [[ "$is_updated" == no ]] || return 0
    is_updated=yes
    "${apt[@]}" update || echo "setup: the lists of packages could not be updated" >&2
}

install_packages() {
    local attempt
    for attempt in 1 2 3; do
        # Package lists may be absent (a bare machine) or too old to download from.
        if [[ $attempt -gt 1 ]] || ! "${apt[@]}" install --simulate "$@" >/dev/null 2>&1; then
            update_lists
        fi
        "${apt[@]}" install --yes --no-remove --no-install-recommends "$@" >/dev/null && return 0
        echo "setup: attempt $attempt to install the packages failed" >&2
        [[ $attempt -eq 3 ]] || sleep "${MESHER_SETUP_PAUSE:-5}"
    done
    return 1
}

# All of the entries, or the end.
install_needed() {
    look_for "$@"
    if [[ ${#unknown[@]} -gt 0 ]]; then
        update_lists
        look_for "$@"
    fi
    if [[ ${#unknown[@]} -gt 0 ]]; then
        echo "setup: this release has no package ${unknown[*]}; without it nothing can be built here" >&2
        exit 1
    fi
    [[ ${#missing[@]} -gt 0 ]] || return 0
    echo "setup: installing ${missing[*]}"
    if ! install_packages "${missing[@]}"; then
        echo "setup: could not install: ${missing[*]}" >&2
        exit 1
    fi
    # Only now is it known what some of them need.
    look_for "$@"
    [[ ${#missing[@]} -eq 0 ]] || install_packages "${missing[@]}"
}

install_optional() {
    local name
    look_for "$@"
    if [[ ${#missing[@]} -gt 0 ]]; then
        echo "setup: installing ${missing[*]}"
        # One that is broken must not keep the others away.
        for name in "${missing[@]}"; do
            "${apt[@]}" install --yes --no-remove --no-install-recommends "$name" >/dev/null || unknown+=("$name")
        done
    fi
    [[ ${#unknown[@]} -eq 0 ]] || echo "setup: not to be had here, left out: ${unknown[*]}"
}

sections=() optional=()
while [[ $# -gt 0 && $1 != --optional ]]; do
    sections+=("$1")
    shift
done
[[ $# -eq 0 ]] || optional=("${@:2}")
if [[ ${#sections[@]} -eq 0 && ${#optional[@]} -eq 0 ]]; then
    sections=(build workbench package tests)
    optional=(solver peers checks)
fi
needed_entries="$(for section in "${sections[@]}"; do entries_of "$section"; done)"
optional_entries="$(for section in "${optional[@]}"; do entries_of "$section"; done)"
mapfile -t needed_entries < <(sed '/^$/d' <<<"$needed_entries")
mapfile -t optional_entries < <(sed '/^$/d' <<<"$optional_entries")

as_root=()
if [[ "$(id -u)" -ne 0 ]]; then
    as_root=(sudo)
    if ! command -v sudo >/dev/null; then
        look_for "${needed_entries[@]}"
        [[ $((${#missing[@]} + ${#unknown[@]})) -gt 0 ]] || exit 0
        echo "setup: these packages are missing and sudo is not there to install them: ${missing[*]} ${unknown[*]}" >&2
        exit 1
    fi
fi
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --quiet=2
    -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300)
is_updated=no

[[ ${#needed_entries[@]} -eq 0 ]] || install_needed "${needed_entries[@]}"
[[ ${#optional_entries[@]} -eq 0 ]] || install_optional "${optional_entries[@]}"

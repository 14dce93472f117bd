#!/usr/bin/env bash
# Tries the project in another release of Debian, from nothing: installs what tools/packages.txt names, builds with warnings as errors,
# runs run.sh, the tests of the Python package, the workbench and the package of Debian, and solves the example with CalculiX.
#   tools/try_release.sh bookworm|trixie|sid [command…]      with a command, runs that alone, in the checkout there
# The release is a system of its own in build/releases/RELEASE (or below MESHER_RELEASES), made with debootstrap at the first try and
# kept for the next. Needs root, debootstrap and 6 GB. What is tried is the work tree as it is, but for files that Git ignores.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [[ $# -lt 1 || ! $1 =~ ^(bookworm|trixie|sid)$ ]]; then
    sed -n '2,7s/^# //p' "tools/$(basename "$0")" >&2
    exit 2
fi
release=$1
shift
mirror=${MESHER_MIRROR:-http://deb.debian.org/debian}
root=$(realpath -m "${MESHER_RELEASES:-build/releases}/$release")

for need in debootstrap unshare git; do
    if ! PATH=$PATH:/usr/sbin command -v $need >/dev/null; then
        echo "try_release: $need is not installed (apt-get install debootstrap util-linux git)" >&2
        exit 1
    fi
done
if [[ $(id -u) -ne 0 ]]; then
    echo "try_release: root is needed to make the system of another release: sudo tools/try_release.sh $release" >&2
    exit 1
fi

# Runs a command in the release. What is mounted for it leaves with the last of its processes.
inside() {
    unshare --mount --pid --fork --kill-child --propagation private bash -c '
        root=$1; shift
        mount -t proc proc "$root/proc"
        mount --rbind /dev "$root/dev"
        mount --rbind /sys "$root/sys"
        exec chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 CCACHE_DIR=/var/cache/ccache \
            CMAKE_CXX_COMPILER_LAUNCHER=ccache CMAKE_BUILD_PARALLEL_LEVEL="$MESHER_JOBS" DEBIAN_FRONTEND=noninteractive "$@"' _ "$root" "$@"
}

# A system that is not complete must not look like one.
make_root() {
    local half=$root.half
    rm -rf "$half"
    mkdir -p "$half"
    debootstrap --variant=minbase "$release" "$half" "$mirror" >"$root.log" 2>&1 || {
        tail -n 5 "$root.log" >&2
        exit 1
    }
    # A mirror may be older than the lists of its moving release say they may be.
    echo 'Acquire::Check-Valid-Until "false";' >"$half/etc/apt/apt.conf.d/99mirror"
    if [[ $release == trixie ]]; then
        # It has no CalculiX; that of the release before it runs there.
        echo "deb $mirror bookworm main" >"$half/etc/apt/sources.list.d/bookworm.list"
        printf 'Package: *\nPin: release n=bookworm\nPin-Priority: 100\n' >"$half/etc/apt/preferences.d/bookworm"
    fi
    mv "$half" "$root"
}

# Files keep their times, so that only what is changed is built again.
copy_checkout() {
    mkdir -p "$root/mesher"
    find "$root/mesher" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
    git ls-files --cached --others --exclude-standard -z | while IFS= read -r -d '' file; do
        [[ ! -e $file && ! -L $file ]] || printf '%s\0' "$file"
    done | tar --null --files-from=- --create | tar --extract --no-same-owner --directory "$root/mesher"
}

# Two at a time would take each other's files away.
mkdir -p "$(dirname "$root")"
exec 9>"$root.lock"
if ! flock --nonblock 9; then
    echo "try_release: $release is being tried already" >&2
    exit 1
fi
export MESHER_JOBS=${MESHER_JOBS:-$(nproc)}
[[ -d $root ]] || make_root
cp /etc/resolv.conf "$root/etc/resolv.conf"
copy_checkout
if [[ $# -gt 0 ]]; then
    inside bash -c 'cd /mesher && exec "$@"' _ "$@"
else
    inside bash /mesher/tools/try_release_inside.sh
    echo "try_release: passed in $release; pictures of the window: $root/mesher/build/release/tests/workbench/pictures"
fi

#!/usr/bin/env bash
# Builds and tests the committed tree on a fresh Debian, in a separate folder that is removed afterwards; on trixie also
# tests with zink, OpenGL on Vulkan (lavapipe). Packages come from the given mirror, else from this system's own.
# As root: scripts/try_on.sh bookworm|trixie [MIRROR]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# The first mirror in apt's sources in a folder, except those of updates: from lines `deb [options] URI suite ...`
# and from paragraphs with Types, URIs and Suites.
mirror_of() {
    local file
    for file in "$1"/sources.list "$1"/sources.list.d/*.list "$1"/sources.list.d/*.sources; do
        [[ ! -f $file ]] || { cat "$file"; echo; }
    done | awk '
        function offer(uri, suite) {
            if (uri == "" || suite ~ /-(security|updates|backports|proposed)/ || found) return
            print uri
            found = 1
        }
        /^deb[ \t]/ { sub(/\[[^]]*\]/, ""); offer($2, $3) }
        /^Types:/ { deb = / deb( |$)/ }
        /^Enabled: *no/ { deb = 0 }
        /^URIs:/ { uri = $2 }
        /^Suites:/ { suite = $2 }
        /^[ \t]*$/ { if (deb) offer(uri, suite); deb = 0; uri = suite = "" }'
}

if [[ ${1:-} == --mirror-of ]]; then   # for its test
    mirror_of "$2"
    exit
fi
suite=${1:-}
mirror=${2:-$(mirror_of /etc/apt)}
if [[ $suite != bookworm && $suite != trixie ]]; then
    echo "usage: scripts/try_on.sh bookworm|trixie [MIRROR]" >&2
    exit 2
fi
if [[ -z $mirror ]]; then
    echo "apt has no source here that names a mirror of Debian; give one: scripts/try_on.sh $suite MIRROR" >&2
    exit 2
fi
if [[ $EUID -ne 0 ]] || ! command -v debootstrap >/dev/null; then
    echo "needs root and debootstrap (apt-get install debootstrap)" >&2
    exit 2
fi
# Mounts in a separate namespace end with it, so that nothing of this system is in the folder when it is removed.
if [[ -z ${KNUCKLE_TRY_ROOT:-} ]]; then
    root=$(mktemp -d)
    chmod 755 "$root"   # apt downloads as a user of its own
    trap 'rm -rf "$root"' EXIT
    KNUCKLE_TRY_ROOT=$root unshare --mount "$BASH" scripts/try_on.sh "$suite" "$mirror"
    exit
fi

root=$KNUCKLE_TRY_ROOT
debootstrap --variant=minbase --include=ca-certificates,git "$suite" "$root" "$mirror" >/dev/null
mount -t proc proc "$root/proc"
mount -t tmpfs tmpfs "$root/tmp"
mount --rbind /dev "$root/dev"
cp /etc/resolv.conf "$root/etc/resolv.conf"
git clone --quiet --no-local . "$root/root/knuckle"
inside() {
    env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 chroot "$root" bash -euo pipefail -c "$1"
}

inside 'cd /root/knuckle && bash test.sh'
if [[ $suite == trixie ]]; then
    inside 'export DEBIAN_FRONTEND=noninteractive
        apt-get install -y -qq --no-install-recommends mesa-vulkan-drivers >/dev/null'
    inside 'cd /root/knuckle && export LIBGL_ALWAYS_SOFTWARE=1 MESA_LOADER_DRIVER_OVERRIDE=zink &&
        build/release/bin/knuckle info && bash test.sh'
fi

#!/usr/bin/env bash
# Builds the Debian packages into build/packages, and asks lintian about them where it is installed. With --try it
# installs them on a fresh Debian in a folder that is removed afterwards, of this system's version and mirror, and runs
# program and Python module there: as root, with mmdebstrap or debootstrap.
# scripts/packages.sh [--try [MIRROR]]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/release
packages=build/packages
fail() {
    printf '%s\n' "$@" >&2
    exit 1
}

build_packages() {
    local log=$packages/log
    bash scripts/install.sh
    # Times in the packages are those of the commit.
    SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || date +%s)}
    export SOURCE_DATE_EPOCH
    cmake --preset release >/dev/null
    local targets=(knuckle knuckle_simulation)
    [[ $(ninja -C $build -t targets all) != *'knuckle_python: phony'* ]] || targets+=(knuckle_python)
    cmake --build $build --target "${targets[@]}" >&2
    mkdir -p $packages
    rm -f $packages/*.deb
    (cd $build && cpack -G DEB) >"$log" 2>&1 || { cat "$log" >&2; fail 'cpack failed'; }
    ls $packages/*.deb
}

# The suite that this system is of, into the folder.
make_debian() {
    local suite=$1 root=$2 mirror=$3
    if command -v mmdebstrap >/dev/null; then
        mmdebstrap --quiet --variant=apt --skip=cleanup/apt/lists "$suite" "$root" "$mirror"
    else
        debootstrap --variant=minbase "$suite" "$root" "$mirror" >/dev/null
    fi
}

try_packages() {
    local root=$1 mirror=$2 suite
    suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
    make_debian "$suite" "$root" "$mirror"
    mount -t proc proc "$root/proc"
    mount -t tmpfs tmpfs "$root/tmp"
    mount --rbind /dev "$root/dev"
    cp /etc/resolv.conf "$root/etc/resolv.conf"
    cp $packages/*.deb "$root/tmp"
    inside() {
        echo "\$ $1"
        env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
            chroot "$root" bash -euo pipefail -c "cd /root; $1"
    }
    # With what they recommend. The headers' package is unpacked only: what it depends on is large.
    local debs='./knuckle_*.deb' python=''
    if compgen -G "$packages/python3-knuckle_*.deb" >/dev/null; then
        python=yes
        debs+=' ./python3-knuckle_*.deb'
    fi
    inside "cd /tmp && apt-get install -y -qq $debs >log 2>&1 || { cat log; exit 1; }"
    inside 'knuckle --version'
    inside 'knuckle doctor'
    inside 'knuckle render assets/scenes/hello.json --device software --frames 1:3 -o hello && ls hello'
    inside 'knuckle render assets/scenes/hello.json --device software --frames 1:3 -o hello.mp4 && ls hello.mp4'
    inside 'knuckle golden add assets/scenes/hello.json --frames 1,3 && knuckle golden check --report report.html &&
        ls report.html'
    [[ -z $python ]] || inside 'python3 -c "import knuckle; print(knuckle.__version__, knuckle.__file__)"'
    inside 'dpkg-deb -x /tmp/libknuckle-dev_*.deb /tmp/dev && ls /tmp/dev/usr/lib/cmake/knuckle'
}

mirror=''
if [[ ${1:-} == --try ]]; then
    mirror=${2:-$(bash scripts/try_on.sh --mirror-of /etc/apt)}
    [[ -n $mirror ]] || fail 'apt has no source here that names a mirror of Debian; give one: scripts/packages.sh --try MIRROR'
    [[ $EUID -eq 0 ]] || fail '--try needs root'
    command -v mmdebstrap >/dev/null || command -v debootstrap >/dev/null ||
        fail '--try needs mmdebstrap or debootstrap (apt-get install mmdebstrap)'
elif [[ $# -gt 0 ]]; then
    echo 'usage: scripts/packages.sh [--try [MIRROR]]' >&2
    exit 2
fi

# Mounts in a separate namespace end with it, so that nothing of this system is in the folder when it is removed.
if [[ -n ${KNUCKLE_TRY_ROOT:-} ]]; then
    try_packages "$KNUCKLE_TRY_ROOT" "$mirror"
    exit
fi
build_packages
if command -v lintian >/dev/null; then
    # What it warns of fails; cmake/packages has the exceptions.
    said=$(lintian --allow-root --fail-on none $packages/*.deb 2>&1 | grep -E '^[EW]:' || true)
    [[ -z $said ]] || fail 'lintian says:' "$said"
fi
if [[ -n $mirror ]]; then
    root=$(mktemp -d)
    chmod 755 "$root"   # apt downloads as a user of its own
    trap 'rm -rf "$root"' EXIT
    KNUCKLE_TRY_ROOT=$root unshare --mount "$BASH" scripts/packages.sh --try "$mirror"
fi

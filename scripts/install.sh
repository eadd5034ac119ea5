#!/usr/bin/env bash
# Installs missing Debian packages for building Knuckle; with --checks also those for checking its source, with --browser
# the browser in which tests look at pages.
set -euo pipefail

packages=(build-essential cmake ninja-build pkgconf ccache libegl-dev libgl-dev libepoxy-dev libegl1
    libgl1-mesa-dri libeigen3-dev libassimp-dev zlib1g-dev libstb-dev libdeflate-dev nlohmann-json3-dev libcli11-dev
    libfmt-dev libcpp-httplib-dev libmeshoptimizer-dev libminizip-dev libwebp-dev libzstd-dev libpng-dev libjpeg-dev libopenexr-dev libgtest-dev
    pybind11-dev python3-dev python3-numpy
    libopengl0 fonts-dejavu-core ffmpeg git ca-certificates)
for switch in "$@"; do
    case $switch in
        --checks) packages+=(clang-format clang-tidy libmujoco-dev liburdfdom-tools) ;;
        --browser) packages+=(chromium) ;;
        *) echo "install.sh: $switch is unknown; give --checks, --browser, or nothing" >&2; exit 2 ;;
    esac
done

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    # On other systems the build itself reports what it does not find.
    echo "Without apt nothing is installed; the build needs what these Debian packages hold: ${packages[*]}" >&2
    exit 0
fi

missing=()
for package in "${packages[@]}"; do
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [[ $status == installed ]] || missing+=("$package")
done
[[ ${#missing[@]} -eq 0 ]] && exit 0

echo "Installing ${missing[*]}" >&2
root=()
if [[ $EUID -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
        echo "Run as root, or install these packages first: ${missing[*]}" >&2
        exit 1
    fi
    root=(sudo)
fi
"${root[@]}" apt-get update -qq
"${root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null

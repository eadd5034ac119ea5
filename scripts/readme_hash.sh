#!/usr/bin/env bash
# Tests whether hello.json gives README.md's hash on the driver named there. Other drivers round differently, and so
# does that one on a processor without AVX; there nothing is compared. scripts/readme_hash.sh [PROGRAM]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=${1:-build/release/bin/knuckle}

stated=$(sed -nE 's/^    state hash ([0-9a-f]{16})$/\1/p' README.md)
driver=$(tr '\n' ' ' <README.md | sed -nE 's/.*\(The hash is that of (llvmpipe \([^)]*\)) in (Mesa [0-9.]+);.*/\1|\2/p')
if [[ -z $stated || -z $driver ]]; then
    echo 'README.md states no hash, or not of which driver' >&2
    exit 1
fi
about=$("$program" --device software info 2>/dev/null)
if ! grep -qF "${driver%|*}" <<<"$about" || ! grep -qE "${driver#*|}( |$)" <<<"$about" ||
        ! grep -qw avx /proc/cpuinfo; then
    echo "another driver or processor than ${driver//|/, }: nothing to compare"
    exit
fi
frames=$(mktemp -d)
trap 'rm -rf "$frames"' EXIT
# The state does not depend on the picture's size.
found=$("$program" --device software render assets/scenes/hello.json --hash --size 64x36 -o "$frames" 2>/dev/null |
    sed -n 's/^state hash //p')
if [[ $found != "$stated" ]]; then
    echo "README.md: hello.json has the hash $found, not $stated" >&2
    exit 1
fi

#!/usr/bin/env bash
# Makes the README's moving picture, docs/dance.webp, from the dance: scripts/readme_picture.sh [PROGRAM]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=${1:-build/release/bin/knuckle}
picture=docs/dance.webp

frames=$(mktemp -d)
trap 'rm -rf "$frames"' EXIT
"$program" render assets/scenes/dance.json --size 480x270 --fps 60 --frames 90:450 -o "$frames"
# Every fourth frame.
ffmpeg -hide_banner -loglevel error -y -framerate 60 -start_number 90 -i "$frames/frame_%04d.png" -vf fps=15 \
    -c:v libwebp_anim -lossless 0 -quality 55 -compression_level 6 -loop 0 "$frames/dance.webp"
size=$(stat -c %s "$frames/dance.webp")
if (( size > 1500000 )); then
    echo "the picture has $size bytes, more than 1500000" >&2
    exit 1
fi
mv "$frames/dance.webp" "$picture"
chmod 644 "$picture"

#!/usr/bin/env bash
# Builds Knuckle and films a figure that dances and is let go: out/dance.mp4, its frames in out/dance.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

bash scripts/build.sh release knuckle
build/release/bin/knuckle render assets/scenes/dance.json -o out/dance -o out/dance.mp4

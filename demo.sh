#!/usr/bin/env bash
# Builds Knuckle and films a ragdoll that falls down the stairs: out/ragdoll.mp4, its frames in out/ragdoll.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

bash scripts/build.sh release knuckle
build/release/bin/knuckle render assets/scenes/ragdoll.json -o out/ragdoll -o out/ragdoll.mp4

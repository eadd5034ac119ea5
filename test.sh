#!/usr/bin/env bash
# Builds Knuckle and runs its tests. KNUCKLE_PRESET=ci treats warnings as errors. Arguments go to ctest: -R physics.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

preset=${KNUCKLE_PRESET:-release}    # ci and release share build/release
bash scripts/build.sh "$preset"
# One at a time: each test may use every core for its OpenGL driver.
ctest --test-dir build/release --output-on-failure -j1 "$@"

#!/usr/bin/env bash
# Builds Knuckle and runs its tests. KNUCKLE_PRESET=ci treats warnings as errors; debug and asan are the others.
# Arguments go to ctest: -R physics; -L quick leaves out what takes minutes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

preset=${KNUCKLE_PRESET:-release}
bash scripts/build.sh "$preset"
# The presets ci and release share a folder. As many suites at a time as there are cores: each keeps to one.
ctest --test-dir "build/${preset/#ci/release}" --output-on-failure -j"$(nproc)" "$@"

#!/usr/bin/env bash
# Builds the host's tests with address and undefined-behaviour sanitizers and runs them: those of the parts that read
# and convert what users give. What runs on the device would test the driver.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

suites=(world rig app tools)
bash scripts/install.sh
cmake --preset asan >/dev/null
cmake --build --preset asan --target "${suites[@]/#/test_}"
ctest --test-dir build/asan --output-on-failure -j"$(nproc)" -R "^($(IFS='|'; echo "${suites[*]}"))\$"

#!/usr/bin/env bash
# Installs missing packages and builds a preset, all or one target: scripts/build.sh [release|ci|debug|asan] [TARGET]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=${1:-release}
bash scripts/install.sh
cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset" ${2:+--target "$2"}

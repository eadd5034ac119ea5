#!/usr/bin/env bash
# Runs clang-tidy as .clang-tidy says over the sources of some folders, else of all but the tests', some ten seconds of
# a core for each file: scripts/tidy.sh [FOLDER...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

[[ $# -gt 0 ]] || set -- sim render app tools
cmake --preset release >/dev/null   # writes compile_commands.json
find "$@" -name '*.cpp' -print0 | sort -z |
    xargs -0 -n 4 -P "$(nproc)" clang-tidy -p build/release --quiet

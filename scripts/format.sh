#!/usr/bin/env bash
# Formats all C++ as .clang-format says; --check: only tells which files are not, and fails.
# clang-format 14, Debian 12's: others break some lines elsewhere. Shaders are not formatted, it takes them for C.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mode=(-i)
[[ ${1:-} == --check ]] && mode=(--dry-run -Werror)
git ls-files -z --cached --others --exclude-standard -- '*.cpp' '*.h' ':!shaders' |
    xargs -0 clang-format "${mode[@]}"

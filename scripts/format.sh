#!/usr/bin/env bash
# Formats all C++ by .clang-format; --check: only lists files that are not formatted, and fails.
# Needs clang-format 14, Debian 12's: others break some lines elsewhere. Shaders are skipped: it takes them for C.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mode=(-i)
[[ ${1:-} == --check ]] && mode=(--dry-run -Werror)
git ls-files -z --cached --others --exclude-standard -- '*.cpp' '*.h' ':!shaders' |
    xargs -0 clang-format "${mode[@]}"

#!/usr/bin/env bash
# Runs clang-tidy by .clang-tidy on all sources of sim, render, app and tools, or on those of the PARTs named (of tests by
# tests/.clang-tidy, too): scripts/tidy.sh [PART...]. Most of its time goes to the headers of libraries, so it checks
# sources as they are joined for building.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
parts=("$@")
[[ $# -gt 0 ]] || parts=(sim render app tools)
for part in "${parts[@]}"; do
    case $part in
        sim | render | app | tools | tests) ;;
        *) echo "tidy.sh: $part is no part of this project; name some of sim, render, app, tools, tests" >&2; exit 2 ;;
    esac
done

rm -rf build/tidy   # CMake leaves joined sources of before
cmake --preset tidy >/dev/null
cp tests/.clang-tidy build/tidy/tests
# Joined sources, and those that stand alone; not those that a build would make. Of those joined it would say that they
# include sources, and that what a library declares is defined in one of our namespaces.
sed -nE "s#^ *\"file\": \"$PWD/(.*)\",?\$#\1#p" build/tidy/compile_commands.json |
    grep -E "^(build/tidy/)?($(IFS='|'; echo "${parts[*]}"))/" | grep -E '^build/tidy/.*/unity_|^[^b]' |
    xargs -r -n 1 -P "$(nproc)" clang-tidy -p build/tidy --quiet \
        --checks=-bugprone-suspicious-include,-bugprone-forward-declaration-namespace

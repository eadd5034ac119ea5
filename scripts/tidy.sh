#!/usr/bin/env bash
# Runs clang-tidy by .clang-tidy on sources that have changed since the commit named in scripts/tidy_passed, and on
# those that include a changed header, directly or not. --all: on all sources, and writes the commit's name when they
# pass. FOLDER...: on the sources of these. --list: only lists the sources. Tests are left out, except with
# `scripts/tidy.sh tests` (checks: tests/.clang-tidy). Takes about seven seconds of a core for each source.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
parts=(sim render app tools)
record=scripts/tidy_passed

all='' list='' folders=()
for word in "$@"; do
    case $word in
        --all) all=1 ;;
        --list) list=1 ;;
        -*) echo "usage: scripts/tidy.sh [--list] [--all | FOLDER...]" >&2; exit 2 ;;
        *) folders+=("$word") ;;
    esac
done

every_source() { find "$@" -name '*.cpp' | LC_ALL=C sort; }

# Files that differ from a commit, including the working tree.
changed_since() {
    { git diff --no-renames --name-only "$1"; git ls-files --others --exclude-standard; } | LC_ALL=C sort -u
}

# The sources among the files on stdin, and all that include one of the headers.
with_includers() {
    local known next
    known=$(grep -E '\.(cpp|h)$' || true)
    while [[ -n $known ]]; do
        # Shaders' headers are included by their path below shaders.
        next=$(grep -E '\.h$' <<<"$known" | sed 's#^shaders/##; s#.*#\#include "&"#' |
               grep -rlFf - --include='*.cpp' --include='*.h' "${parts[@]}" shaders || true)
        next=$(printf '%s\n%s\n' "$known" "$next" | LC_ALL=C sort -u | grep .)
        [[ $next == "$known" ]] && break
        known=$next
    done
    local part
    for part in "${parts[@]}"; do grep "^$part/.*\.cpp$" <<<"$known" || true; done |
        while read -r source; do [[ ! -f $source ]] || echo "$source"; done
}

# A clone may lack the commit, and clang-tidy's checks may have changed: then runs on all.
since=$(cat "$record" 2>/dev/null || true)
if [[ ${#folders[@]} -gt 0 ]]; then
    sources=$(every_source "${folders[@]}")
elif [[ -n $all || -z $since ]] || ! git cat-file -e "$since^{commit}" 2>/dev/null ||
        ! git diff --quiet "$since" -- .clang-tidy; then
    sources=$(every_source "${parts[@]}")
else
    sources=$(changed_since "$since" | with_includers)
fi
if [[ -n $list ]]; then
    [[ -z $sources ]] || echo "$sources"
    exit
fi
[[ -n $sources ]] || exit 0

cmake --preset tidy >/dev/null   # writes compile_commands.json, in which each source stands alone
# Where OpenVDB is not there, nothing says how to compile what includes it.
grep -q /vdb_file.cpp build/tidy/compile_commands.json || sources=$(grep -v '/vdb_file\.cpp$' <<<"$sources" || true)
xargs -r -n 4 -P "$(nproc)" clang-tidy -p build/tidy --quiet <<<"$sources"

if [[ -n $all ]]; then
    if git diff --quiet HEAD -- "${parts[@]}" shaders .clang-tidy; then
        git rev-parse HEAD >"$record"
    else
        echo "$record stays as it is: not all is committed" >&2
    fi
fi

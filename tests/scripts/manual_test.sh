#!/usr/bin/env bash
# Pages of the manual, and completions as shells take them. Without man, zsh or fish less is looked at.
# tests/scripts/manual_test.sh KNUCKLE
set -euo pipefail
program=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
fail() {
    printf '%s\n' "$@" >&2
    failed=1
}

# Every command has a page, with all options that its help has; man has nothing to say against it.
commands=$("$program" man --list)
[[ $commands == *render* && $commands == *doctor* ]] || fail "commands: $commands"
for command in '' $commands; do
    page=$folder/knuckle${command:+-$command}.1
    "$program" man $command >"$page"
    for section in .TH '.SH NAME' '.SH SYNOPSIS' '.SH "OPTIONS"'; do
        grep -q "^$section" "$page" || fail "$page: no $section"
    done
    text=$(sed 's/\\-/-/g' "$page")
    while read -r option; do
        grep -qF -- "\\fB$option\\fR" <<<"$text" || fail "$page: no $option"
    done < <("$program" $command --help | grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE -- '--.*')
    if command -v man >/dev/null; then
        warnings=$(MANWIDTH=200 LC_ALL=C.UTF-8 man --warnings -E UTF-8 -l "$page" 2>&1 >/dev/null)
        [[ -z $warnings ]] || fail "$page:" "$warnings"
    fi
done
code=0
message=$("$program" man rendr 2>&1) || code=$?
[[ $code == 2 && $message == *'did you mean "render"'* ]] || fail "man rendr: $code $message"

# What bash offers for the last of these words.
"$program" completion bash >"$folder/bash"
offers() {
    bash -c 'source "$1"; COMP_WORDS=("${@:2}"); COMP_CWORD=$(($# - 2)); _knuckle; echo "${COMPREPLY[*]}"' - "$folder/bash" "$@"
}
expect() {
    local wanted=$1 found
    shift
    found=$(offers "$@")
    [[ $found == "$wanted" ]] || fail "$*: offers \"$found\", not \"$wanted\""
}
expect render knuckle ren
expect --quality knuckle render --qua
expect 'draft good final' knuckle render --quality ''
expect draft knuckle render --quality = dr
expect 'gpu' knuckle render --device g
expect 'check' knuckle golden ch
expect '--report --report-all --report-size' knuckle golden check --rep
expect 'beside replace' knuckle golden update --other-driver ''
expect --output knuckle --device software render a.json --ou
expect 'render' knuckle man ren
expect 'fish' knuckle completion f
expect 'status' knuckle sweep st
expect '--slurm' knuckle sweep --sl
# A value is no command, and what may be anything is a file.
expect voxelize knuckle --shaders render vox
expect '' knuckle render ''
expect '' knuckle render --from ''
[[ $(bash -c 'source "$1"; complete -p knuckle' - "$folder/bash") == *'-o default'* ]] || fail 'bash offers no files'

for shell in zsh fish; do
    "$program" completion "$shell" >"$folder/$shell"
    grep -q 'draft good final' "$folder/$shell" || fail "$shell: no words of --quality"
    ! command -v "$shell" >/dev/null || "$shell" -n "$folder/$shell" || fail "$shell cannot read its completion"
done
exit $failed

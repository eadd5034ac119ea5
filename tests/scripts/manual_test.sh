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

# What the shells themselves make of a line of which a Tab leaves one way to go on.
mkdir "$folder/zsh_functions" "$folder/here"
mv "$folder/zsh" "$folder/zsh_functions/_knuckle"
touch "$folder/here/plan.json"
cat >"$folder/tab.zsh" <<'END'
zmodload zsh/zpty
zpty tty zsh -f -i
{
    echo "fpath=($1/zsh_functions \$fpath); autoload -U compinit; compinit -u -D; cd $1/here"
    echo "tab() { zle complete-word; print -r -- \$BUFFER >$1/line; BUFFER=; }; zle -N tab; bindkey '^I' tab"
    echo "touch $1/ready"
} | while read -r line; do zpty -w tty "$line"; done
# wait_for FILE: true once it is there.
wait_for() { repeat 600 { [[ -s $1 || -e $1 && $1 == */ready ]] && return; zpty -rt tty said; sleep 0.05 }; return 1 }
wait_for "$1/ready" || exit
rm -f "$1/line"
zpty -wn tty "$2"$'\t'
wait_for "$1/line" && cat "$1/line"
END
tab() {
    rm -f "$folder/line" "$folder/ready"
    if [[ $1 == zsh ]]; then zsh -f "$folder/tab.zsh" "$folder" "$2"
    else (cd "$folder/here" && fish -c "source $folder/fish; complete -C '$2'" | sed "s/\t.*//; s/^/${2% *} /"); fi
}
while IFS='|' read -r line wanted; do
    for shell in zsh fish; do
        command -v "$shell" >/dev/null || continue
        found=$(tab "$shell" "$line")
        [[ ${found% } == "$wanted" ]] || fail "$shell: \"$line\" becomes \"$found\", not \"$wanted\""
    done
done <<'END'
knuckle rend|knuckle render
knuckle render --quality dra|knuckle render --quality draft
knuckle render --check|knuckle render --checkpoint
knuckle render pl|knuckle render plan.json
knuckle golden che|knuckle golden check
knuckle sweep stat|knuckle sweep status
knuckle sweep pl|knuckle sweep plan.json
knuckle sweep plan.json --sta|knuckle sweep plan.json --stale
knuckle sweep status pl|knuckle sweep status plan.json
knuckle man rend|knuckle man render
END
exit $failed

#!/usr/bin/env bash
# Writes the list of exports in docs/output.md, from the output of `knuckle render --help`. --check: fails if the list
# differs from it.
# usage: scripts/export_table.sh KNUCKLE [--check]
set -euo pipefail
[[ $# -ge 1 ]] || { echo "usage: scripts/export_table.sh KNUCKLE [--check]" >&2; exit 2; }
knuckle=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
document=docs/output.md

help=$("$knuckle" render --help)
table=$(mktemp)
trap 'rm -f "$table" "$table.new"' EXIT
{
    echo '| export | what it writes |'
    echo '| --- | --- |'
    sed -nE 's/^(--export [a-z]+=[^ ]+) +(.*)$/| `\1` | \2 |/p' <<<"$help"
} >"$table"
awk -v table="$table" '
    /<!-- exports -->/ { print; print ""; while ((getline line < table) > 0) print line; print ""; inside = 1; next }
    /<!-- \/exports -->/ { inside = 0 }
    !inside { print }' "$document" >"$table.new"
if [[ ${2:-} == --check ]]; then
    cmp -s "$table.new" "$document" && exit
    echo "$document: the list of exports is not what --help says; run scripts/export_table.sh KNUCKLE" >&2
    exit 1
fi
cat "$table.new" >"$document"

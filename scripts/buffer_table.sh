#!/usr/bin/env bash
# Writes the table of the solver's buffers in docs/buffers.md, from the declarations of the stages. --check: fails
# if the table differs from them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
document=docs/buffers.md

rows() {
    echo '| room | buffer | element | what it holds |'
    echo '| --- | --- | --- | --- |'
    local file
    for file in sim/solver/stages.h sim/solver/*/*_stage.h; do
        awk -v room="$(basename "$(dirname "$file")")" '
            function flush() {
                if (names == "") return
                gsub(/\|/, "\\|", text)
                printf "| %s | %s | `%s` | %s |\n", room == "solver" ? "shared by all" : "`" room "`", names, type, text
                names = ""
            }
            # A declaration may begin on the line before its comment, and names may have initializers.
            /^ *Buffer<[^>]*>/ {
                flush()
                line = $0
                while (line !~ /;/ && (getline more) > 0) line = line more
                type = line; sub(/^ *Buffer</, "", type); sub(/>.*/, "", type); sub(/^gpu::/, "", type)
                declared = line; sub(/^ *Buffer<[^>]*> */, "", declared); sub(/;.*/, "", declared)
                gsub(/\{[^}]*\}/, "", declared)
                count = split(declared, parts, / *, */)
                names = "`" parts[1] "`"
                for (k = 2; k <= count; ++k) names = names ", `" parts[k] "`"
                text = line
                if (text !~ /\/\/\/</) text = ""
                sub(/.*\/\/\/< */, "", text)
                next
            }
            /^ *\/\/\/</ && names != "" { more = $0; sub(/^ *\/\/\/< */, "", more); text = text " " more; next }
            { flush() }
            END { flush() }' "$file"
    done
}

table=$(mktemp)
trap 'rm -f "$table" "$table.new"' EXIT
rows >"$table"
awk -v table="$table" '
    /<!-- buffers -->/ { print; print ""; while ((getline line < table) > 0) print line; print ""; inside = 1; next }
    /<!-- \/buffers -->/ { inside = 0 }
    !inside { print }' "$document" >"$table.new"
if [[ ${1:-} == --check ]]; then
    cmp -s "$table.new" "$document" && exit
    echo "$document: the table of buffers is not what the stages declare; run scripts/buffer_table.sh" >&2
    exit 1
fi
cat "$table.new" >"$document"

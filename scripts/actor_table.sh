#!/usr/bin/env bash
# Prints, as a table in Markdown, the results of `knuckle voxelize` for models at its defaults: their sizes, particles,
# bodies and joints, and how well particles fill them along bones and on one grid.
# usage: scripts/actor_table.sh KNUCKLE MODEL...
set -euo pipefail
[[ $# -ge 2 ]] || { echo "usage: scripts/actor_table.sh KNUCKLE MODEL..." >&2; exit 2; }
knuckle=$1
shift

# "102 %, 0.24" from the line that begins with "fill:".
fill_of() { sed -nE "s/^fill: ([0-9]+) % .* is ([0-9.]+) diameters.*/\1 %, \2/p" <<<"$1"; }
# The number of joints of a kind in the table.
count_of() { awk -v kind="$2" '$4 == kind { ++count } END { print count + 0 }' <<<"$1"; }

echo "| model | height, m | particle, m | particles | bodies | balls | hinges | volume, surface | on one grid |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"
for model in "$@"; do
    told=$("$knuckle" voxelize "$model")
    grid=$("$knuckle" voxelize --grid "$model")
    line=$(grep -E '^[^:]+: [0-9]+ particles of ' <<<"$told")
    height=$(sed -nE 's/^size: .* wide, ([0-9.]+) high.*/\1/p' <<<"$told")
    particles=$(sed -nE 's/^[^:]+: ([0-9]+) particles.*/\1/p' <<<"$line")
    diameter=$(sed -nE 's/.*particles of ([0-9.]+) m.*/\1/p' <<<"$line")
    bodies=$(sed -nE 's/.* m, ([0-9]+) bod.*/\1/p' <<<"$line")
    printf '| %s | %s | %.4f | %s | %s | %s | %s | %s | %s |\n' "$(basename "$model" | tr _ " ")" "$height" "$diameter" \
        "$particles" "$bodies" "$(count_of "$told" ball)" "$(count_of "$told" hinge)" "$(fill_of "$told")" \
        "$(fill_of "$grid")"
done

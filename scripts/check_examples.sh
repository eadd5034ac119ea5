#!/usr/bin/env bash
# Whether the documents' examples of `knuckle voxelize` and of a mistake still say what the program says, line by line
# but for spaces and what is left out (...), and whether docs/actors.md has of the project's own models what
# scripts/actor_table.sh prints.
# usage: scripts/check_examples.sh KNUCKLE
set -euo pipefail
[[ $# -eq 1 ]] || { echo "usage: scripts/check_examples.sh KNUCKLE" >&2; exit 2; }
knuckle=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD failed=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
ln -s "$root/assets" "$work/assets"
mkdir "$work/out"

# A document's line that is not among what was said. single_spaces, so that columns may be as wide as they like.
single_spaces() { tr -s ' ' | sed 's/^ //; s/ $//'; }
expect() {
    grep -qxF -- "$3" <<<"$2" && return
    echo "$1 says what the program does not: $3" >&2
    failed=1
}

for document in README.md docs/actors.md; do
    said=
    while IFS= read -r line; do
        case $line in
            '    $ knuckle voxelize assets/'* | '    $ knuckle render '*'substepz'*)
                read -ra words <<<"${line#*knuckle }"
                said=$(cd "$work" && "$knuckle" "${words[@]}" 2>&1 | single_spaces) || true ;;
            '    ...') ;;
            '    '*) [[ -z $said ]] || expect "$document" "$said" "$(single_spaces <<<"$line")" ;;
            *) said= ;;
        esac
    done <"$document"
done

rows=$(bash scripts/actor_table.sh "$knuckle" assets/models/{humanoid,dog,spider}.glb)
while IFS= read -r row; do
    expect docs/actors.md "$rows" "$row"
done < <(grep -E '^\| (model \| height|humanoid\.glb|dog\.glb|spider\.glb) ' docs/actors.md)
exit $failed

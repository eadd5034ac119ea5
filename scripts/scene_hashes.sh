#!/usr/bin/env bash
# Prints the hash of each scene's state after some frames, for five of them also with the paper's solver. A change keeps
# all bits if the programs before and after it print the same. scripts/scene_hashes.sh [PROGRAM [SCENE...]]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

program=${1:-build/release/bin/knuckle}
[[ $# -gt 0 ]] && shift
scenes=("$@")
paper=()
if [[ $# -eq 0 ]]; then
    scenes=(assets/scenes/*.json)
    paper=(assets/scenes/{hello,joints,chain,ragdoll,tower}.json)
fi
frames=$(mktemp -d)
trap 'rm -rf "$frames"' EXIT

# Larger scenes run for fewer frames.
print() {
    local scene=$1 particles last
    shift
    particles=$("$program" check "$scene" | sed -E 's/.*: ([0-9]+) particles?,.*/\1/')
    last=$((particles < 7000 ? 120 : particles < 30000 ? 30 : 10))
    echo "$scene $last $* $("$program" render "$scene" "$@" --hash --frames $last:$last --size 64x36 -o "$frames" 2>/dev/null |
        sed -n 's/^state hash //p')"
}

for scene in "${scenes[@]}"; do print "$scene"; done
for scene in "${paper[@]}"; do print "$scene" --set solver=paper; done

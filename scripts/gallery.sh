#!/usr/bin/env bash
# Makes docs/gallery.md and its pictures in docs/gallery, a still and a small film of each scene: scripts/gallery.sh
# [NAME...], of all scenes or of these. Scenes that have not changed since their pictures were made are skipped;
# docs/gallery/made has the checksums. All of them take an hour on two busy cores, a small one ten seconds.
# --times [NAME...] makes their films as they are instead, and notes the processor time of each in docs/gallery/times.
# PROGRAM names another program than build/release/bin/knuckle.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=${PROGRAM:-build/release/bin/knuckle}
pictures=docs/gallery
made=$pictures/made
times=$pictures/times

# What the page begins with.
first=(ballpit wrecking jetty rapids dominoes torn waterfall dance)

# When the still is taken, as percent of the film, where that is not 40.
declare -A moment=([ballpit]=80 [catch]=18 [chain]=38 [drape]=25 [hit]=15 [ragdolls]=30 [stroll]=52 [struck]=21 [troupe]=54)

# The films have 12 frames a second; 120 frames at most, so those that last longer than 10 seconds run faster.
rate=12
most=120

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$pictures"
touch "$made" "$times"

# Refuses a picture that is too large for a page.
small() {
    local size
    size=$(stat -c %s "$1")
    if (( size > $2 )); then
        echo "$1 has $size bytes, more than $2" >&2
        return 1
    fi
}

# Pictures of a scene, from one run of it. Called in conditions, where set -e does not act.
make() {
    local name=$1 scene=assets/scenes/$1.json frames duration stride count
    read -r duration frames < <("$program" check "$scene" |
        sed -nE 's/.*, ([0-9.]+) s \(([0-9]+) frames\)$/\1 \2/p') || return
    stride=$(awk -v d="$duration" -v n="$frames" -v r=$rate -v m=$most 'BEGIN {
        s = int(n / d / r + 0.5); if (s < n / m) s = int(n / m + 0.999); print s < 1 ? 1 : s }') || return
    rm -rf "$work/frames"
    "$program" render "$scene" --size 640x360 --stride "$stride" -o "$work/frames" || return
    local drawn=("$work"/frames/*.png)
    count=${#drawn[@]}
    ffmpeg -hide_banner -loglevel error -y -i "${drawn[count * ${moment[$name]:-40} / 100]}" -q:v 4 "$work/still.jpg" &&
    ffmpeg -hide_banner -loglevel error -y -framerate $rate -pattern_type glob -i "$work/frames/*.png" \
        -vf scale=400:225:flags=lanczos -c:v libwebp_anim -quality 50 -compression_level 4 -loop 0 "$work/film.webp" &&
    small "$work/still.jpg" 60000 && small "$work/film.webp" 1000000 &&
    mv "$work/still.jpg" "$pictures/$name.jpg" && mv "$work/film.webp" "$pictures/$name.webp" &&
    chmod 644 "$pictures/$name".* || return
    sed -i "\\# $scene\$#d" "$made" && sha256sum "$scene" >>"$made" && LC_ALL=C sort -k 2 -o "$made" "$made"
}

# The processor time of a scene's film. Other work on the machine changes it less than the time on the clock.
measure() {
    local name=$1 seconds TIMEFORMAT='%U %S'
    seconds=$({ time "$program" render "assets/scenes/$name.json" --quiet -o "$work/film.mp4" 2>"$work/told"; } 2>&1) || {
        cat "$work/told" >&2
        return 1
    }
    sed -i "/^$name /d" "$times"
    awk -v name="$name" '{ printf "%s %.0f\n", name, $1 + $2 }' <<<"$seconds" >>"$times"
    LC_ALL=C sort -o "$times" "$times"
}

# " (95 s)"; nothing where it was not measured.
time_of() {
    sed -nE "s/^$1 ([0-9]+)$/ (\1 s)/p" "$times"
}

# The page, of all scenes that have pictures, two in a row.
page() {
    local names=() name column=0
    for name in "${first[@]}" $(printf '%s\n' assets/scenes/*.json | sed 's#.*/##; s#\.json$##'); do
        if [[ " ${names[*]} " != *" $name "* && -e $pictures/$name.webp ]]; then names+=("$name"); fi
    done
    cat <<'END'
# Gallery

<!-- Made by scripts/gallery.sh; do not edit. -->

Each picture opens a film. All were made on a CPU, by `knuckle render assets/scenes/NAME.json -o NAME.mp4`; a scene is a
[text](scene.md) of at most forty lines. In brackets: processor time of such a film, 1280 x 720, as one core of a small
server takes it; two need half of that at least.

| | |
| --- | --- |
END
    for name in "${names[@]}"; do
        printf '| [![%s](gallery/%s.jpg)](gallery/%s.webp)<br>[`%s`](../assets/scenes/%s.json): %s%s ' "$name" "$name" \
            "$name" "$name" "$name" "$(sed -nE '0,/"description"/s/^ *"description": "(.*)",?$/\1/p' "assets/scenes/$name.json")" "$(time_of "$name")"
        column=$((1 - column))
        if (( column == 0 )); then echo '|'; fi
    done
    if (( column )); then echo '| |'; fi
}

failed=()
task='make'
if [[ ${1:-} == --times ]]; then
    task=measure
    shift
fi
names=("$@")
if (( $# == 0 )); then
    for scene in assets/scenes/*.json; do names+=("$(basename "$scene" .json)"); done
fi
for name in "${names[@]}"; do
    if [[ $task == make && -e $pictures/$name.jpg && -e $pictures/$name.webp ]] &&
            grep -qxF "$(sha256sum "assets/scenes/$name.json")" "$made"; then continue; fi
    echo "$name"
    $task "$name" || failed+=("$name")
    page >"$work/page"
    cp "$work/page" docs/gallery.md
done
page >docs/gallery.md
if (( ${#failed[@]} )); then
    echo "failed: ${failed[*]}" >&2
    exit 1
fi

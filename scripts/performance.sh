#!/usr/bin/env bash
# Writes the tables of table 2 in README.md, docs/performance.md and docs/paper.md, from docs/bench.json, and the
# pictures in docs/performance, from scale.json there. --run [NOTE]: measures table 2 first, some ten minutes on two
# quiet cores; --scale [NOTE]: measures time and memory at growing sizes, as long. Both add a line to history.jsonl
# there; the note tells what else the machine did. --check: fails if a document or a picture has other figures.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
figures=docs/bench.json
folder=docs/performance

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# measure FILE NOTE BENCHMARK [OPTION...]
measure() {
    local file=$1 note=$2
    shift 2
    bash scripts/build.sh release knuckle
    build/release/bin/knuckle bench "$@" --json >"$work/figures"
    { echo '{'
      echo "  \"measured\": \"$(date +%F)\","
      echo "  \"note\": \"$(tr -d '"\\' <<<"${note:-on a quiet machine}")\","
      tail -n +2 "$work/figures"; } >"$work/whole"
    mkdir -p "$(dirname "$file")"
    cp "$work/whole" "$file"
    python3 scripts/performance_record.py append "$file" "$folder/history.jsonl"
}
case ${1:-} in
    --run) measure "$figures" "${2:-}" table2 --preset default,paper ;;
    --scale) measure "$folder/scale.json" "${2:-}" scale ;;
esac

# The JSON has one key per line, as the program writes it. Makes a line of values per run, in the order of the keys.
run_keys='preset objectCount particleCount stepsPerSecond settledStepsPerSecond drawnStepsPerSecond pileTop
    meanPenetration worstPenetration meanJointGap worstJointGap maxSpeed quadroP6000 gtx1080 unreal'
value() { sed -nE "s/^  \"$1\": \"?([^\"]*[^\",])\"?,?\$/\\1/p" "$figures"; }
runs() {
    awk -v keys="$(tr -s ' \n' ' ' <<<"$run_keys")" '
        BEGIN { count = split(keys, order, " ") }
        function flush(  k) {
            if (!("preset" in run)) return
            for (k = 1; k <= count; ++k) printf "%s%s", order[k] in run ? run[order[k]] : "-", k < count ? " " : "\n"
            delete run
        }
        /^ +"[A-Za-z0-9]+": / {
            key = $1; gsub(/[":]/, "", key)
            content = $2; gsub(/[",]/, "", content)
            if (key == "preset") flush()
            run[key] = content
        }
        END { flush() }' "$figures"
}

if [[ -z $(runs) ]]; then
    echo "$figures has no runs; scripts/performance.sh --run measures anew" >&2
    exit 1
fi

# The source of the figures, in one line.
source_line() {
    local threads
    threads=$(value driverThreads)
    case $threads in
        null) threads= ;;
        0) threads=', no driver threads' ;;
        *) threads=", $threads driver threads" ;;
    esac
    echo "$(value device)$threads, $(value steps) steps, measured $(value measured) $(value note)." |
        fold -s -w 120 | sed "s, *$,,"
}

# docs/performance.md: everything.
full_table() {
    source_line
    echo
    echo '| objects | preset | particles | steps/s, all | settled | drawn | paper, P6000 | GTX 1080 | UE4 | top | penetration, mean / worst | gap, mean / worst | fastest at the end |'
    echo '| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |'
    runs | awk '{
        printf "| %d | %s | %d | %.1f | %.1f | %.1f | %s | %s | %s | %.2f m | %.1f / %.1f %% | %.1f / %.1f %% | %.2f m/s |\n",
            $2, $1, $3, $4, $5, $6, $13, $14, $15, $7, 100 * $8, 100 * $9, 100 * $10, 100 * $11, $12 }'
}

# README.md: the program's output for 300 objects.
printed() {
    echo '    $ knuckle bench table2 --preset default,paper --objects 300'
    echo '    preset  objects  particles      all  settled    drawn  P6000   1080    UE4  top, m mean pen  worst mean gap  worst  speed'
    runs | awk '$2 == 300 {
        printf "    %-8s%7d%11d%9.1f%9.1f%9.1f%7s%7s%7s%8.2f%9.1f%7.1f%9.1f%7.1f%7.2f\n",
            $1, $2, $3, $4, $5, $6, $13, $14, $15, $7, 100 * $8, 100 * $9, 100 * $10, 100 * $11, $12 }'
}

# docs/paper.md: the paper's rows next to both presets.
beside_the_paper() {
    echo '| pairs | UE4 | paper, P6000 / GTX 1080 | default | penetration, mean / worst; gap | preset | penetration, mean / worst; gap |'
    echo '| --- | --- | --- | --- | --- | --- | --- |'
    runs | awk '
        { text = sprintf(" %.1f | %.1f / %.1f %%; %.1f %% |", $4, 100 * $8, 100 * $9, 100 * $11) }
        $1 == "default" { start[$2] = sprintf("| %d | %s | %s / %s |", $2, $15, $13, $14) text; order[++count] = $2 }
        $1 == "paper" { preset[$2] = text }
        END { for (k = 1; k <= count; ++k) print start[order[k]] preset[order[k]] }'
}

# Fills the part between the marks of a document.
failed=0
fill() {
    local document=$1 table=$2
    "$table" >"$work/table"
    awk -v table="$work/table" '
        /<!-- bench -->/ { print; print ""; while ((getline line < table) > 0) print line; print ""; inside = 1; next }
        /<!-- \/bench -->/ { inside = 0 }
        !inside { print }' "$document" >"$work/document"
    cmp -s "$work/document" "$document" && return
    if [[ $mode == --check ]]; then
        echo "$document: its table of speeds is not that of $figures; run scripts/performance.sh" >&2
        failed=1
    else
        cat "$work/document" >"$document"
    fi
}

mode=${1:-}
fill README.md printed
fill docs/performance.md full_table
fill docs/paper.md beside_the_paper
option=()
[[ $mode != --check ]] || option=(--check)
python3 scripts/performance_record.py plot "$folder/scale.json" "$folder" "${option[@]}" || failed=1
exit $failed

#!/usr/bin/env bash
# Tests of scripts/: each on a small tree, or a copy of this one, in a folder that is removed afterwards.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
root=$PWD
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0

# expect WHAT WANTED FOUND
expect() {
    [[ $2 == "$3" ]] && return
    printf '%s:\nwanted: %s\nfound:  %s\n' "$1" "$2" "$3" >&2
    failed=1
}
expect_line() {
    grep -qxF -- "$2" <<<"$3" && return
    printf '%s: no line "%s" in\n%s\n' "$1" "$2" "$3" >&2
    failed=1
}
write() { mkdir -p "$(dirname "$1")" && printf '%s\n' "${@:2}" >"$1"; }

test_mirror() {
    local apt=$folder/apt
    mkdir -p "$apt/sources.list.d"
    expect 'no source' '' "$(bash scripts/try_on.sh --mirror-of "$apt")"
    write "$apt/sources.list.d/a.sources" 'Types: deb' 'URIs: one://updates/security' 'Suites: trixie-security' '' \
        'Types: deb-src' 'URIs: one://sources' 'Suites: trixie' '' \
        'Types: deb deb-src' '# a comment' 'URIs: one://packages' 'Suites: trixie trixie-updates'
    expect 'paragraphs' one://packages "$(bash scripts/try_on.sh --mirror-of "$apt")"
    write "$apt/sources.list" '# deb no://comment trixie main' 'deb-src no://sources trixie main' \
        'deb no://updates trixie-security main' 'deb [arch=amd64 trusted=yes] two://packages trixie main'
    expect 'lines' two://packages "$(bash scripts/try_on.sh --mirror-of "$apt")"
}

# A tree with a chain of headers; commits as nobody in particular.
test_tidy() {
    local tree=$folder/tidy since
    commit() { git add -A && git -c user.name=test -c user.email=test@localhost commit -qm "$1"; }
    mkdir -p "$tree"/{sim,render,app,tools,shaders/shared,scripts}
    cp "$root/scripts/tidy.sh" "$tree/scripts"
    cd "$tree"
    write sim/deep.h '#pragma once'
    write sim/upper.h '#include "sim/deep.h"'
    write sim/a.cpp '#include "sim/upper.h"'
    write render/b.cpp '#include "shared/types.h"'
    write app/c.cpp 'int c;'
    write shaders/shared/types.h '#pragma once'
    write .clang-tidy 'Checks: none'
    git init -q
    commit one
    since=$(git rev-parse HEAD)
    local everything=$'app/c.cpp\nrender/b.cpp\nsim/a.cpp'
    expect 'nothing has passed' "$everything" "$(bash scripts/tidy.sh --list | sort)"
    echo "$since" >scripts/tidy_passed
    expect 'nothing has changed' '' "$(bash scripts/tidy.sh --list)"
    write app/c.cpp 'int d;'
    write tools/new.cpp 'int e;'
    expect 'sources' $'app/c.cpp\ntools/new.cpp' "$(bash scripts/tidy.sh --list)"
    write sim/deep.h '#pragma once' 'int f;'
    commit two
    expect 'a header behind another' $'app/c.cpp\nsim/a.cpp\ntools/new.cpp' "$(bash scripts/tidy.sh --list | sort)"
    write shaders/shared/types.h 'int g;'
    expect 'a header of shaders' $'app/c.cpp\nrender/b.cpp\nsim/a.cpp\ntools/new.cpp' \
        "$(bash scripts/tidy.sh --list | sort)"
    expect 'a folder' render/b.cpp "$(bash scripts/tidy.sh --list render)"
    rm app/c.cpp
    expect 'what is gone' '' "$(bash scripts/tidy.sh --list | grep app || true)"
    write .clang-tidy 'Checks: others'
    expect 'other checks' $'render/b.cpp\nsim/a.cpp\ntools/new.cpp' "$(bash scripts/tidy.sh --list | sort)"
    git checkout -q .clang-tidy app
    tr 0-9a-f 1-9a-f0 <<<"$since" >scripts/tidy_passed
    expect 'a commit that is missing' "$everything"$'\ntools/new.cpp' "$(bash scripts/tidy.sh --list | sort)"
    cd "$root"
}

# Every kind of mistake at once, in a copy of this tree.
test_structure() {
    local tree=$folder/structure found
    mkdir "$tree"
    cp -r ./*.md ./*.sh LICENSE CMakeLists.txt app assets cmake docs render scripts shaders sim tests tools "$tree"
    cd "$tree"
    expect 'as it is' '' "$(bash scripts/check_structure.sh 2>&1)"
    {
        echo 'Words of `no_kernel`, no_kernel_either, `grob_*`, `nothing.glsl`, `Joint.Nonsense…`, `Nowhere.*`,'
        echo '`Kinds/Gridd.*`, `NoSuchType`, `World::nonesuch`, `sim/no/file.h`, [a link](docs/nowhere.md).'
        echo '[A heading](#nowhere).'
        echo '    `example_kernel` stands in an example.'
    } >>README.md
    echo '| zonk | x | y |' >>docs/glossary.md
    printf '\n| what | test |\n| --- | --- |\n| a figure | |\n' >>docs/figures.md
    printf '// %0130d\n' 1 >>app/main/main.cpp
    write app/main/long.cpp "$(seq -f '// %g' 301)"
    write shaders/math/long.glsl "$(seq -f '// %g' 101)"
    sed -i '1i #include "app/run/progress.h"' sim/gpu/gpu.cpp
    sed -i '1i #include <nlohmann/json.hpp>' app/json/json.cpp
    sed -i 's/"note": "/"note": "not /' docs/bench.json
    found=$(bash scripts/check_structure.sh 2>&1) && expect 'a bad tree' fails passes
    local name line
    for name in no_kernel no_kernel_either 'grob_*' nothing.glsl 'the test Joint.Nonsense…' 'the test Nowhere.*' \
            'the test Kinds/Gridd.*' NoSuchType nonesuch sim/no/file.h; do
        expect_line 'names' "README.md names $name, which is not there" "$found"
    done
    local last row
    last=$(wc -l <app/main/main.cpp) row=$(wc -l <docs/figures.md)
    for line in 'README.md links to docs/nowhere.md, which is not there' \
            'README.md links to #nowhere, which is no heading there' \
            "docs/figures.md:$row: no test holds this row; name one, or move it to docs/decisions/28-measured-once.md" \
            'include "sim/base/json.h" instead' \
            'docs/glossary.md names the word zonk, which is not there' \
            "app/main/main.cpp:$last is wider than 120 columns" \
            'app/main/long.cpp is not listed in app/CMakeLists.txt' \
            'app/main/long.cpp has 301 lines, more than 300' \
            'shaders/math/long.glsl has 101 lines, more than 100' \
            'sim/gpu must not include sim/(solver, rig)/, render/, app/' \
            'docs/performance.md: its table of speeds is not that of docs/bench.json; run scripts/performance.sh'; do
        expect_line 'mistakes' "$line" "$found"
    done
    expect 'examples' '' "$(grep example_kernel <<<"$found" || true)"
    cd "$root"
}

# A history and pictures of made-up figures.
test_record() {
    local tree=$folder/record
    mkdir -p "$tree/pictures"
    cd "$tree"
    echo 1.2.3 >VERSION
    size() {
        printf '{ "world": "dam", "particleCount": %s, "problem": null, "milliseconds": %s, ' "$1" "$2"
        printf '"microsecondsPerParticle": %s, "bytesPerParticle": 500, "passes": [' "$3"
        printf '{ "name": "finish", "milliseconds": 10 }, { "name": "fluid_find", "milliseconds": %s }] },\n' "$4"
    }
    { echo '{ "measured": "2026-01-02", "note": "alone", "benchmark": "scale", "device": "none", "runs": ['
      size 16000 32 2 30
      size 64000 192 3 90
      echo '{ "world": "dam", "particleCount": 900000, "problem": "too large" } ] }'; } >scale.json
    record() { python3 "$root/scripts/performance_record.py" "$@" 2>&1; }
    record append scale.json history.jsonl
    record append scale.json history.jsonl
    expect 'lines of history' 2 "$(wc -l <history.jsonl)"
    cat >show.py <<'END'
import json
run = json.loads(open("history.jsonl").readline())
print(run["measured"], run["version"], run["runs"][1]["milliseconds"], run["runs"][2]["problem"])
END
    expect 'a run' '2026-01-02 1.2.3 192 too large' "$(python3 show.py)"
    local stale='pictures/passes_dam.svg does not show scale.json; run scripts/performance.sh'
    expect 'a picture that is missing' "$stale" "$(record plot scale.json pictures --check | grep passes || true)"
    record plot scale.json pictures
    expect 'pictures' 'passes_dam.svg scaling.svg' "$(ls pictures | paste -sd' ')"
    expect 'shares of the size next to 64,000' '90.0 % 10.0 %' \
        "$(grep -oE '[0-9.]+ %' pictures/passes_dam.svg | paste -sd' ')"
    expect 'pictures that are there' '' "$(record plot scale.json pictures --check)"
    sed -i 's/"milliseconds": 90/"milliseconds": 40/' scale.json
    expect 'other figures' "$stale" "$(record plot scale.json pictures --check || true)"
    expect 'no command' 2 "$(record draw >/dev/null && echo 0 || echo $?)"
    cd "$root"
}

test_mirror
test_record
test_tidy
test_structure
exit $failed

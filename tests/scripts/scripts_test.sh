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

# Sources are joined but for those that cannot be: two with something of one name, and one that sets a macro.
test_join() {
    local tree=$folder/join name
    write "$tree/CMakeLists.txt" 'cmake_minimum_required(VERSION 3.25)' 'project(joined LANGUAGES CXX)' \
        'set(KNUCKLE_JOINED 4)' "include($root/cmake/join.cmake)" \
        'add_library(joined STATIC a.cpp b.cpp c.cpp d.cpp e.cpp f.cpp)' 'knuckle_join(joined)'
    # own NAME DECLARATION LINE...: the declaration is the source's own.
    own() { write "$tree/$1.cpp" "${@:3}" '' 'namespace {' '' "$2" '' '}  // namespace' "int $1() { return 0; }"; }
    own a 'constexpr int LEAST = 1, MOST = 2;'
    own b 'struct Other {};'
    own c 'const int MOST(3);'
    own d 'struct Known final {};' '#define LEAST 5'
    own e 'class Known {};'
    own f 'enum class Known { Yes };'
    cmake -S "$tree" -B "$tree/build" -G Ninja >/dev/null
    together() { grep -rl --include='unity_*' "/$1.cpp" "$tree/build" | xargs -r grep -l "/$2.cpp" | wc -l; }
    expect 'sources that may stand together' 1 "$(together a b)"
    expect 'the second of a line of constants' 0 "$(together a c)"
    expect 'two types of one name' 0 "$(together e f)"
    for name in a b c e f; do
        expect "$name.cpp is joined once" 1 "$(grep -rh --include='unity_*' "/$name.cpp" "$tree/build" | wc -l)"
    done
    expect 'a macro' 0 "$(together d d)"
    cmake --build "$tree/build" >"$tree/told" || expect 'the build' fine "$(cat "$tree/told")"
}

# Which files clang-tidy gets: joined ones and those that stand alone, of the parts that are asked for.
test_tidy() {
    local tree=$folder/tidy file
    mkdir -p "$tree"/{scripts,bin,sim,tests,build/tidy}
    cp "$root/scripts/tidy.sh" "$tree/scripts"
    cd "$tree"
    write tests/.clang-tidy ''
    write bin/clang-tidy '#!/bin/sh' 'for file; do :; done; echo "$file"; test "$file" != sim/alone.cpp'
    write bin/cmake '#!/bin/sh' 'mkdir -p build/tidy/tests; cp files build/tidy/compile_commands.json'
    chmod +x bin/*
    for file in build/tidy/sim/x.dir/Unity/unity_0_cxx.cxx build/tidy/app/embedded.cpp app/main.cpp sim/alone.cpp \
        build/tidy/tests/t.dir/Unity/unity_0_cxx.cxx cmake/known.cpp; do
        printf '  "file": "%s"\n' "$tree/$file"
    done >files
    tidy() { PATH=$tree/bin:$PATH bash scripts/tidy.sh "$@" 2>&1 || echo "exit code $?"; }
    expect 'all' $'app/main.cpp\nbuild/tidy/sim/x.dir/Unity/unity_0_cxx.cxx\nexit code 123\nsim/alone.cpp' "$(tidy | sort)"
    expect 'a part' app/main.cpp "$(tidy app)"
    expect_line 'no part' 'exit code 2' "$(tidy nowhere)"
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
test_join
test_tidy
test_structure
exit $failed

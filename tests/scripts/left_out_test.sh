#!/usr/bin/env bash
# What a machine lacks of Python and OpenVDB is left out of the build, and said: not an error.
set -euo pipefail
cd "$(dirname "$0")/../.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# What configuring says with some of it hidden. configured SWITCH...
configured() {
    rm -rf "$folder/build"
    cmake -S . -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DKNUCKLE_TESTS=OFF "$@" >"$folder/said" 2>&1 ||
        { cat "$folder/said" >&2; exit 1; }
}

for package in Python3 pybind11; do
    configured -DCMAKE_DISABLE_FIND_PACKAGE_$package=ON
    grep -qF "Python's module is left out: it needs python3-dev and pybind11-dev" "$folder/said"
    if grep -qF knuckle_python "$folder/build/build.ninja"; then exit 1; fi
done
configured -DOPENVDB_INCLUDE=OFF
grep -qF -- '--export vdb is left out: it needs libopenvdb-dev and libboost-dev' "$folder/said"
grep -rqF --include='unity_*' vdb_missing.cpp "$folder/build"

#!/usr/bin/env bash
# The Python package: its tests, and the example of docs/python.md twice. python_test.sh BUILD PYTHON
set -euo pipefail
cd "$(dirname "$0")/../.."
export PYTHONPATH=$1/python KNUCKLE=$1/bin/knuckle
"$2" -W error tests/python/test_knuckle.py

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
for run in first second; do
    mkdir "$out/$run"
    ln -s "$PWD/assets" "$out/$run/assets"
    (cd "$out/$run" && "$2" "$OLDPWD/docs/example/throws.py" 2)
done
[[ $(wc -l <"$out/first/throws.csv") == 3 ]]
cmp "$out/first/throws.csv" "$out/second/throws.csv"

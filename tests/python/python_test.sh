#!/usr/bin/env bash
# The Python package: its tests, and the examples of docs/python.md, one of them twice. python_test.sh BUILD PYTHON
set -euo pipefail
cd "$(dirname "$0")/../.."
export PYTHONPATH=$1/python KNUCKLE=$1/bin/knuckle
"$2" -W error tests/python/test_knuckle.py
"$2" -W error tests/python/test_changes.py
"$2" -W error tests/python/test_actors.py

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
for run in first second; do
    mkdir "$out/$run"
    ln -s "$PWD/assets" "$out/$run/assets"
    (cd "$out/$run" && "$2" "$OLDPWD/docs/example/throws.py" 2)
done
[[ $(wc -l <"$out/first/throws.csv") == 3 ]]
cmp "$out/first/throws.csv" "$out/second/throws.csv"

"$2" docs/example/swing.py | grep -E '^up after [0-9.]+ s$'

# The notebook, in Jupyter where that is there, otherwise cell by cell.
if "$2" -c 'import nbconvert, ipykernel' 2>/dev/null; then
    (cd "$out/first" && "$2" -m nbconvert --to notebook --execute --output run.ipynb --output-dir . \
        "$OLDPWD/docs/example/film.ipynb")
else
    (cd "$out/first" && "$2" - "$OLDPWD/docs/example/film.ipynb" <<'CELLS'
import json, sys
names = {}
for cell in json.load(open(sys.argv[1]))["cells"]:
    if cell["cell_type"] == "code":
        exec("".join(cell["source"]), names)
CELLS
    )
fi
[[ -s $out/first/throw.mp4 ]]

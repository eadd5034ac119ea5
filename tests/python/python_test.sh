#!/usr/bin/env bash
# The Python package: its tests, and the examples of docs/python.md, one of them twice. python_test.sh BUILD PYTHON
set -euo pipefail
cd "$(dirname "$0")/../.."
export PYTHONPATH=$1/python KNUCKLE=$1/bin/knuckle
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
"$2" -W error tests/python/test_knuckle.py
"$2" -W error tests/python/test_changes.py
"$2" -W error tests/python/test_actors.py
"$2" -W error tests/python/test_inputs.py

# Another Python is told so.
mkdir -p "$out/without/knuckle"
cp "$1/python/knuckle/__init__.py" "$out/without/knuckle"
(PYTHONPATH=$out/without "$2" -c 'import knuckle' 2>&1 || true) | grep -q 'ImportError: this package has no module for Python 3'

# Assets are found from any folder, as long as they lie above the package.
(cd / && "$2" -c 'import knuckle; knuckle.Scene.load("assets/scenes/hello.json")
knuckle.Scene.load({"diameter": 0.06, "objects": [{"type": "actor", "file": "assets/models/humanoid.glb"}]})')

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
    # It runs where it lies.
    cp docs/example/film.ipynb "$out/first"
    (cd "$out/first" && "$2" -m nbconvert --to notebook --execute --output run.ipynb film.ipynb)
    grep -q 'video/mp4\|<video' "$out/first/run.ipynb"
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

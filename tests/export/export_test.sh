#!/usr/bin/env bash
# Files of `--export` as other programs read them. export_test.sh KNUCKLE [name...]: test_NAME.py alone
set -euo pipefail
KNUCKLE=$(realpath "$1")
cd "$(dirname "$0")"
export KNUCKLE LP_NUM_THREADS=0 PYTHONDONTWRITEBYTECODE=1
shift
python=/usr/bin/python3   # the system's, which has NumPy, whatever environment this runs in
[[ -x $python ]] || python=python3
tests=("$@")
if [[ ${#tests[@]} -eq 0 ]]; then
    for test in test_*.py; do tests+=("$(basename "${test#test_}" .py)"); done
fi
for test in "${tests[@]}"; do "$python" -W error "test_$test.py"; done

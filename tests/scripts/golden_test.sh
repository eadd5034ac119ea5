#!/usr/bin/env bash
# Checks the project's goldens: tests/scripts/golden_test.sh PROGRAM REPORT.html [whole]. Of long scenes it draws all
# stored states and simulates ten frames; with "whole" it simulates all of them, which takes some minutes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

program=$1
report=$2
failed=0
check() {
    "$program" golden check tests/golden "$@" --device software || failed=$?
}
if [[ ${3:-} == whole ]]; then
    check --report "$report"
else
    check quick modes --report "$report"
    check long --pictures --report "${report%.html}_long.html"
    check long --states --until 10
fi
exit $failed

#!/usr/bin/env bash
# A live scene over HTTP: what is answered, what is refused, and that nobody holds up the simulation.
# tests/scripts/serve_test.sh KNUCKLE
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
exec python3 tests/scripts/serve_test.py "$program"

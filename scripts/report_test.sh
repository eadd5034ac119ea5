#!/usr/bin/env bash
# Drives a report of compared images in headless Chromium and keeps screenshots to look at, on a desktop and a phone.
# Needs chromium (apt install chromium), or another named by KNUCKLE_BROWSER.
# Usage: report_test.sh [FOLDER [TEST_PROGRAM]]: by default out/report and build/release/bin/test_report
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

folder=${1:-out/report}
program=${2:-build/release/bin/test_report}
if ! command -v "${KNUCKLE_BROWSER:-chromium}" >/dev/null; then
    echo "skipped: ${KNUCKLE_BROWSER:-chromium}, which shows the page, is not here; apt install chromium"
    exit 0
fi
[[ -x $program ]] || { echo "$program is not here; build it first: cmake --build --preset release --target test_report" >&2; exit 2; }
mkdir -p "$folder"
KNUCKLE_SCREENSHOTS=$(realpath "$folder") "$program" --gtest_filter='*ReportInBrowser*'
echo "screenshots: $folder"

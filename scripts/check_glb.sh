#!/usr/bin/env bash
# Tests a file that `knuckle render --export gltf=` wrote with others' programs: Khronos's validator, and pictures by
# three.js in headless Chromium. Needs npm and chromium (apt install npm chromium); their packages go to a temporary
# folder.
# Usage: check_glb.sh FILE.glb [FOLDER [SECONDS...]]: pictures at these times, by default at 0.5, 1 and 1.5
set -euo pipefail

here="$(cd "$(dirname "$0")" && pwd)"
file="$(realpath "$1")"
out="$(mkdir -p "${2:-out/glb}" && realpath "${2:-out/glb}")"
times=("${@:3}")
[ ${#times[@]} -gt 0 ] || times=(0.5 1 1.5)
camera="${KNUCKLE_GLB_CAMERA:-from=-2.5,2.2,3.5&to=0,0.6,0}"
port=8123

work="$(mktemp -d)"
server=
trap '[ -z "$server" ] || kill "$server"; rm -rf "$work"' EXIT
cp "$here"/glb/* "$work"
cp "$file" "$work/file.glb"
cd "$work"
npm install --silent --no-fund --no-audit gltf-validator three > /dev/null
node validate.js file.glb
node serve.js "$work" "$port" &
server=$!
for time in "${times[@]}"; do
  chromium --headless=new --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --hide-scrollbars \
    --window-size=640,447 --virtual-time-budget=15000 --screenshot="$out/$time.png" \
    "http://localhost:$port/view.html?file=file.glb&time=$time&$camera" > chromium.log 2>&1
  [ -s "$out/$time.png" ] || { cat chromium.log; exit 1; }
done
echo "pictures: $out"

#!/usr/bin/env bash
# Finds includes against the direction of the data, and shaders that include from another room. docs/architecture.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
failed=0

# Files of the first folder that include anything that the pattern matches.
refuse() {
  local folder=$1 pattern=$2
  if grep -rnE --include='*.h' --include='*.cpp' --include='*.glsl' --include='*.comp' --include='*.vert' \
      --include='*.frag' "^#include \"($pattern)" "$folder"; then
    echo "$folder must not include ${pattern//|/, }" >&2
    failed=1
  fi
}

refuse sim/world 'sim/(gpu|solver|actor)/|render/|app/'
refuse sim/gpu 'sim/(solver|actor)/|render/|app/'
refuse sim/actor 'sim/(gpu|solver)/|render/|app/'
refuse sim/solver 'sim/actor/|render/|app/'
refuse render 'sim/actor/|app/'
refuse app/files 'app/commands/'
refuse app/scene 'app/commands/'
refuse app/schema 'app/(commands|scene)/'
refuse shaders/shared 'sim/|render/|math/'
refuse shaders/math 'sim/|render/'
refuse shaders/render 'sim/'
for part in sim render; do
  for room in shaders/"$part"/*/; do
    room=$(basename "$room")
    others=$(cd shaders/$part && ls -d */ | tr -d / | grep -vxE "$room|common|rotation" | paste -sd'|')
    refuse "shaders/$part/$room" "$part/($others)/"
  done
done
exit $failed

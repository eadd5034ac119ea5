#!/usr/bin/env bash
# Finds includes against the direction of the data, shaders that include from another room, sources that no
# CMakeLists.txt names, what stands at the top and should not, and files that a document names and that are not there.
# docs/architecture.md.
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
refuse sim/solver/layout 'sim/(gpu|solver/[a-km-z])'
refuse sim/solver/measure 'sim/(gpu|solver/[a-kn-z])'
refuse render 'sim/actor/|app/'
refuse render/picture 'render/(spheres|colliders|view|output)/'
refuse render/view 'render/(spheres|colliders|picture|output)/'
refuse render/output 'render/(spheres|colliders|view)/'
refuse app/run 'app/commands/'
refuse app/scene 'app/(commands|run)/'
refuse app/files 'app/(commands|run|scene)/'
refuse app/schema 'app/(commands|run|scene|files)/'
refuse app/json 'app/[a-ik-z]'
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

# A source is named in the CMakeLists.txt of its folder, or of the nearest one above.
while read -r source; do
  folder=$(dirname "$source")
  while [[ ! -f $folder/CMakeLists.txt ]]; do folder=$(dirname "$folder"); done
  if ! grep -qE "(^|[ (/])${source#"$folder"/}([ )]|\$)" "$folder/CMakeLists.txt"; then
    echo "$source is not listed in $folder/CMakeLists.txt" >&2
    failed=1
  fi
done < <(find sim render app tools tests -name '*.cpp' | sort)
bash scripts/buffer_table.sh --check || failed=1

# What may stand at the top of what is committed.
while read -r name; do
  echo "$name stands at the top of the tree; move it, or list it in scripts/check_structure.sh" >&2
  failed=1
done < <(git ls-files 2>/dev/null | cut -d/ -f1 | sort -u |
         grep -vxE -e '\.(ci|clang-format|clang-tidy|gitignore)|CMake(Lists\.txt|Presets\.json)|LICENSE|README\.md' \
             -e '(demo|test)\.sh|app|assets|cmake|docs|render|scripts|shaders|sim|tests|tools')

# Every file that a document names is there, but for those of examples.
while IFS=: read -r document name; do
  if [[ ! -e $name ]]; then
    echo "$document names $name, which is not there" >&2
    failed=1
  fi
done < <(grep -oHE '`(app|assets|docs|render|scripts|shaders|sim|tests|tools)/[A-Za-z0-9_/.]+\.[a-z]+`' README.md docs/*.md |
         tr -d '`' | grep -vE ':(sim/common/|assets/scenes/name|tests/FOLDER/|shaders/sim/room/)')
while IFS=: read -r document name; do
  if [[ ! -e $(dirname "$document")/$name ]]; then
    echo "$document links to $name, which is not there" >&2
    failed=1
  fi
done < <(grep -oHE '\]\([A-Za-z0-9_/.-]+' README.md docs/*.md | sed 's/\](//' | grep -v ':http')
exit $failed

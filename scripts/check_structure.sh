#!/usr/bin/env bash
# Finds includes against the direction of the data, shaders that include from another room, sources that no
# CMakeLists.txt names, lines and files that are too long, what stands at the top and should not, figures that no
# test holds, and files, kernels, tests, types and words that a document names and that are not there.
# docs/architecture.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
failed=0
documents=(README.md CONTRIBUTING.md CHANGELOG.md docs/*.md docs/decisions/*.md)

# Refuses files of the first folder that include anything that the pattern matches.
refuse() {
  local folder=$1 pattern=$2
  if grep -rnE --include='*.h' --include='*.cpp' --include='*.glsl' --include='*.comp' --include='*.vert' \
      --include='*.frag' "^#include \"($pattern)" "$folder"; then
    echo "$folder must not include ${pattern//|/, }" >&2
    failed=1
  fi
}

refuse sim/base 'sim/(world|gpu|solver|rig)/|render/|app/|shared/'
refuse sim/world 'sim/(gpu|solver|rig)/|render/|app/'
refuse sim/gpu 'sim/(solver|rig)/|render/|app/'
# Of what shaders share with the host, only numbers and vectors; structs are for the solver and the renderer.
refuse sim/gpu "shared/($(cd shaders/shared && ls | grep -vxE '(constants|vector_types)\.h' | paste -sd'|'))"
refuse sim/rig 'sim/(gpu|solver)/|render/|app/'
# In sim/rig each room uses only those before it.
rooms=(mesh anatomy gltf import limbs joints clips bodies)
for i in "${!rooms[@]}"; do
  later=$(printf '%s\n' "${rooms[@]:i+1}" skin | paste -sd'|')
  refuse "sim/rig/${rooms[i]}" "sim/rig/($later)/"
done
refuse sim/solver 'sim/rig/|render/|app/'
refuse sim/solver/layout 'sim/(gpu|solver/[a-km-z])'
refuse sim/solver/measure 'sim/(gpu|solver/[a-kn-z])'
refuse sim/api 'render/|app/|sim/rig/(anatomy|clips|gltf|joints|limbs|mesh|skin)/'
# The library's own header does not say what a document lacks.
if grep -rn --include='*.h' --include='*.cpp' '#include <nlohmann/' app render sim tests tools | grep -v '^sim/base/json\.h:'; then
  echo 'include "sim/base/json.h" instead' >&2
  failed=1
fi
for part in sim/base sim/world sim/gpu sim/solver sim/rig render app/commands app/film app/run app/scene app/states; do
  refuse $part '(sim|app)/api/'
done
refuse render 'sim/rig/|app/'
refuse render/picture 'render/(spheres|colliders|view|output)/'
refuse render/reader 'render/(colliders|compare|marks|output|picture|skins|spheres|view)/'
refuse render/compare 'render/(colliders|marks|output|skins|spheres|view)/'
refuse render/view 'render/(spheres|colliders|picture|output)/'
refuse render/shapes 'render/(colliders|skins|view|output)/'
refuse render/skins 'render/(spheres|colliders|view|output)/'
refuse render/output 'render/(spheres|colliders|view)/'
refuse app/run 'app/(commands|bench|film)/'
refuse app/film 'app/(commands|bench)/'
refuse app/states 'app/(branch|commands|bench|film|run)/'
refuse app/branch 'app/(commands|bench|checkpoint|film)/'
refuse app/bench 'app/commands/'
refuse app/export 'app/(commands|run)/'
refuse app/scene 'app/(commands|run|export)/'
refuse app/files 'app/(commands|run|scene|export)/'
refuse app/sweep 'app/(commands|bench|golden|serve)/'
refuse app/schema 'app/(commands|run|scene|files)/'
refuse app/json 'app/[a-ik-z]'
refuse app/report 'app/([a-qs-z]|run/)'
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

# Each source must be named in the CMakeLists.txt of its folder, or of the nearest one above.
while read -r source; do
  folder=$(dirname "$source")
  while [[ ! -f $folder/CMakeLists.txt ]]; do folder=$(dirname "$folder"); done
  if ! grep -qE "(^|[ (/])${source#"$folder"/}([ )]|\$)" "$folder/CMakeLists.txt"; then
    echo "$source is not listed in $folder/CMakeLists.txt" >&2
    failed=1
  fi
done < <(find sim render app tools tests -name '*.cpp' | sort)
bash scripts/buffer_table.sh --check || failed=1
bash scripts/performance.sh --check || failed=1

# Files that may be at the top of the tree. Some are there because others look for them: VERSION (CMake, packagers),
# CHANGELOG.md and CONTRIBUTING.md (readers, GitHub), .editorconfig (editors), .github (GitHub's own CI).
while read -r name; do
  echo "$name stands at the top of the tree; move it, or list it in scripts/check_structure.sh" >&2
  failed=1
done < <(git ls-files 2>/dev/null | cut -d/ -f1 | sort -u |
         grep -vxE -e '\.(ci|clang-format|clang-tidy|gitignore)|CMake(Lists\.txt|Presets\.json)|LICENSE|README\.md' \
             -e '(demo|test)\.sh|app|assets|cmake|docs|render|scripts|shaders|sim|tests|tools' \
             -e 'CHANGELOG\.md|CONTRIBUTING\.md|VERSION|\.editorconfig|\.github')

# Every file that a document names must exist, except those of examples.
while IFS=: read -r document name; do
  if [[ ! -e $name ]]; then
    echo "$document names $name, which is not there" >&2
    failed=1
  fi
done < <(grep -oHE '`(app|assets|cmake|docs|render|scripts|shaders|sim|tests|tools)/[A-Za-z0-9_/.]+\.[a-z]+`' "${documents[@]}" |
         tr -d '`' | grep -vE ':(sim/common/|assets/scenes/name|app/export/name|tests/FOLDER/|shaders/sim/room/)')
while IFS=: read -r document name; do
  if [[ ! -e $(dirname "$document")/$name ]]; then
    echo "$document links to $name, which is not there" >&2
    failed=1
  fi
done < <(grep -oHE '\]\([A-Za-z0-9_/.-]+' "${documents[@]}" | sed 's/\](//' | grep -v ':http')
while IFS=: read -r document link; do
  target=${link%%#*}
  target=${target:+$(dirname "$document")/$target}
  if ! grep -hE '^#+ ' "${target:-$document}" | sed 's/^#* //' | tr 'A-Z' 'a-z' | tr -cd 'a-z0-9 \n_-' | tr ' ' '-' |
      grep -qxF -- "${link#*#}"; then
    echo "$document links to $link, which is no heading there" >&2
    failed=1
  fi
done < <(grep -oHE '\]\([A-Za-z0-9_/.-]*#[^)]+' "${documents[@]}" | sed 's/\](//')

# Below: names that documents cite. Their examples, indented by four, are skipped.
folders=(app assets cmake render scripts shaders sim tests tools)
prose() { sed -E '/^    /d; s/\]\([^)]*\)/]/g; s#https?://[^ ]*##g' "$1"; }
absent() {
  echo "$1 names $2, which is not there" >&2
  failed=1
}
# The lines of the first file that are not in the second; both are sorted.
missing_from() { LC_ALL=C comm -23 "$1" "$2"; }
lists=$(mktemp -d)
trap 'rm -rf "$lists"' EXIT
export LC_ALL=C
find "${folders[@]}" -type f | sed 's#.*/##' | sort -u >"$lists/files"
# Stems of all files and targets of the build; Python's names; keys of exported JSON and arrays; and foreign words that look like kernels: of GLSL, C++, CMake, stb, and
# of Macklin and Müller 2013.
{ sed 's/\..*//' "$lists/files"; grep -rhoE '\b(knuckle|make)_[a-z_]+' --include=CMakeLists.txt "${folders[@]}"
  grep -ohE '[a-z]+(_[a-z]+)+' app/python/knuckle/__init__.pyi
  grep -rhoE '"[a-z]+(_[a-z0-9]+)+"' app/export | tr -d '"'
  grep -hoE '"[a-z]+(_[a-z]+)+' app/files/npz/actor_fields.cpp | tr -d '"'   # up to a capital, as below
  printf '%s\n' bodies_particles_starts joints_limits local_size_x uint32_t stb_image_write s_corr vdb_print find_package add_subdirectory; } | sort -u >"$lists/stems"
grep -rhoE '^TEST(_F|_P)?\([A-Za-z0-9]+, *[A-Za-z0-9]+' --include='*.cpp' tests |
    sed -E 's/^TEST(_F|_P)?\(//; s/, */./' | sort -u >"$lists/tests"
find app render shaders sim tests tools -name '*.cpp' -o -name '*.h' -o -name '*.glsl' -o -name '*.comp' \
    -o -name '*.vert' -o -name '*.frag' | sort >"$lists/sources"
xargs cat app/python/knuckle/__init__.pyi <"$lists/sources" | grep -oE '[A-Za-z0-9_]+' | sort -u >"$lists/identifiers"
# Words of all files except tests, with camelCase and snake_case split; of tests only the words of file names.
{ grep -v '^tests/' "$lists/sources" | xargs cat; cat "$lists/files"; } | sed -E 's/([a-z0-9])([A-Z])/\1 \2/g' |
    tr -cs 'A-Za-z0-9' '\n' | tr 'A-Z' 'a-z' | sort -u >"$lists/words"

for document in "${documents[@]}"; do
  # Kernels, by the form of their names: in backticks or not.
  prose "$document" | grep -oE '(^|[^A-Za-z0-9_./:"-])[a-z][a-z0-9]*(_[a-z0-9]+)*_([a-z0-9]+|\*)' | sed -E 's/^[^a-z]//' |
      sort -u >"$lists/cited" || true
  while read -r kernel; do
    [[ $kernel == *\* ]] && grep -q "^${kernel%\*}" "$lists/stems" || absent "$document" "$kernel"
  done < <(missing_from "$lists/cited" "$lists/stems")
  # Files without their folder, except those of examples.
  prose "$document" | grep -oE '`[A-Za-z0-9_]+\.(comp|glsl|vert|frag|cpp|h|sh)`' | tr -d '`' | grep -v '^name\.' |
      sort -u >"$lists/cited" || true
  while read -r file; do
    [[ -e $file ]] || absent "$document" "$file"
  done < <(missing_from "$lists/cited" "$lists/files")
  # Tests: Suite.Name, perhaps after an instance, with * or … for omitted parts.
  while read -r test; do
    pattern=$(sed -E 's#^[A-Za-z]+/##; s#…#*#; s#\.#\\.#; s#\*#.*#g' <<<"$test")
    grep -qE "^$pattern\$" "$lists/tests" || absent "$document" "the test $test"
  done < <(prose "$document" | grep -oE '`([A-Z][A-Za-z]*/)?[A-Z][A-Za-z0-9]+\.([A-Za-z0-9*]|…)+`' | tr -d '`' |
           grep -v '\.txt$' | sort -u)
  # Types, functions and suites that begin with a capital letter.
  prose "$document" | grep -oE '`[A-Z][A-Za-z0-9]*[a-z][A-Za-z0-9]*(::[A-Za-z]+)?(\(\))?`' | tr -d '`()' |
      sed 's/.*:://' | sort -u >"$lists/cited" || true
  while read -r name; do
    grep -rqw --include='*.json' -- "$name" assets || absent "$document" "$name"
  done < <(missing_from "$lists/cited" "$lists/identifiers")
done

# The glossary's words must occur in the code.
awk -F'|' '/^\|/ && $2 !~ /^ *(word|---) *$/ { print tolower($2) }' docs/glossary.md | grep -oE '[a-z]{3,}' |
    grep -vxE 'and|for|the' | sort -u >"$lists/cited"
while read -r word; do absent docs/glossary.md "the word $word"; done < <(missing_from "$lists/cited" "$lists/words")

# Every figure of docs/figures.md names the test that holds it: all tables there end in a column of tests, without gaps.
while IFS=: read -r line what; do
  echo "docs/figures.md:$line: $what" >&2
  failed=1
done < <(awk '
    /^\|/ {
      cells = split($0, cell, /[ \t]*\|[ \t]*/)
      last = cell[cells - 1]
      if (++row == 1) {
        if (last !~ /^test/) print FNR ":the last column of this table is not \"test\"; name the tests that hold it"
      } else if (row > 2 && last == "") {
        print FNR ":no test holds this row; name one, or move it to docs/decisions/28-measured-once.md"
      }
      next
    }
    { row = 0 }' docs/figures.md)

# Lines of 120 columns at most; shaders of 100 lines, sources and headers of the host of 300.
LC_ALL=C.UTF-8
while IFS=: read -r file line _; do
  echo "$file:$line is wider than 120 columns" >&2
  failed=1
done < <(xargs grep -nE '^.{121,}' /dev/null <"$lists/sources")
while read -r count file; do
  most=300
  [[ $file =~ \.(comp|glsl|vert|frag)$ ]] && most=100
  if (( count > most )); then
    echo "$file has $count lines, more than $most" >&2
    failed=1
  fi
done < <(xargs wc -l <"$lists/sources" | grep -v ' total$')

# The gallery shows all scenes; scripts/gallery.sh makes it.
for scene in assets/scenes/*.json; do
  name=$(basename "$scene" .json)
  if ! grep -qF "](gallery/$name.webp)" docs/gallery.md; then
    echo "docs/gallery.md lacks $scene: scripts/gallery.sh $name" >&2
    failed=1
  fi
done

# A room must be easy to survey: 24 files at most.
while read -r count folder; do
  if (( count > 24 )); then
    echo "$folder has $count files, more than 24: give some of them a room of their own" >&2
    failed=1
  fi
done < <(find app render shaders sim tests tools -type f ! -name CMakeLists.txt -printf '%h\n' | sort | uniq -c)
exit $failed

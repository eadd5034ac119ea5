#!/usr/bin/env bash
# Each installed file is in exactly one component, and so in exactly one package.
# tests/scripts/components_test.sh BUILD
set -euo pipefail
build=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export LC_ALL=C
failed=0

# install_to NAME argument...: the files that are installed, sorted, in $folder/NAME.
install_to() {
    local name=$1
    shift
    cmake --install "$build" --prefix "$folder/tree" "$@" >"$folder/log" 2>&1 || { cat "$folder/log" >&2; exit 1; }
    (cd "$folder/tree" && find . -type f | sort) >"$folder/$name"
    rm -r "$folder/tree"
}

mapfile -t components < <(sed -n 's/^set(CPACK_COMPONENTS_ALL "\(.*\)")$/\1/p' "$build/CPackConfig.cmake" | tr ';' '\n')
[[ " ${components[*]} " == *' program development '* ]] || { echo "components: ${components[*]}" >&2; exit 1; }
install_to all
for component in "${components[@]}"; do
    install_to "$component" --component "$component"
    [[ -s $folder/$component ]] || { echo "no file is in the component $component" >&2; failed=1; }
done
sort "${components[@]/#/$folder/}" >"$folder/parts"
if ! diff "$folder/all" "$folder/parts" >"$folder/different"; then
    echo 'in no component (<), or in more than one, or in a component only (>):' >&2
    cat "$folder/different" >&2
    failed=1
fi

# Where things must be.
expect() {
    grep -qxF "./$2" "$folder/$1" || { echo "$2 is not in the component $1" >&2; failed=1; }
}
for file in bin/knuckle share/man/man1/knuckle-render.1 share/bash-completion/completions/knuckle \
    share/knuckle/assets/scenes/hello.json share/doc/knuckle/README.md share/doc/knuckle/docs/scene.md; do
    expect program $file
done
for file in include/knuckle/simulation.h lib/cmake/knuckle/knuckle-config.cmake lib/libknuckle_solver.a; do
    expect development $file
done
exit $failed

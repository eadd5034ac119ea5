#!/usr/bin/env bash
# Installs what a build folder holds into a folder that is removed afterwards, and builds docs/example against it; then
# with this tree as a folder of the example's project, in BUILD/part, which stays: the second time little is built.
# tests/scripts/install_test.sh BUILD
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
root=$PWD
build=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
prefix=$folder/prefix
log=$folder/log
fail() {
    printf '%s\n' "$@" >&2
    exit 1
}
# Runs quietly; tells all where it fails.
quietly() { "$@" >"$log" 2>&1 || { cat "$log" >&2; fail "failed: $*"; }; }

# What is built may be a part of all: then the rest is left as it is.
cmake --build "$build" --target knuckle knuckle_simulation >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
quietly cmake --install "$build" --prefix "$prefix"

headers=$prefix/include
outside=$(find "$headers" -maxdepth 1 -mindepth 1 ! -name knuckle)
[[ -z $outside ]] || fail 'headers outside of include/knuckle:' "$outside"
foreign=$(grep -rnE '#include *[<"](epoxy|EGL|GL|GLES[0-9]*|assimp|nlohmann|stb|CLI|fmt)[/_.]' "$headers" || true)
[[ -z $foreign ]] || fail 'installed headers include what users should not need:' "$foreign"
loose=$(grep -rnE '#include "' "$headers" || true)
[[ -z $loose ]] || fail 'installed headers include by a path that depends on the project:' "$loose"
# Each header stands by itself.
for header in "$headers"/knuckle/*.h; do
    name=knuckle/$(basename "$header")
    quietly c++ -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I "$headers" -isystem /usr/include/eigen3 -include "$name" \
        -x c++ /dev/null
done

# The program finds its assets from any folder.
mkdir "$folder/elsewhere"
cd "$folder/elsewhere"
version=$("$prefix/bin/knuckle" --version)
[[ $version == "knuckle $(<"$root/VERSION")" ]] || fail "--version says $version"
quietly "$prefix/bin/knuckle" check assets/scenes/hello.json assets/scenes/dance.json
cd "$root"
for page in knuckle knuckle-render knuckle-doctor; do
    grep -q '^\.TH ' "$prefix/share/man/man1/$page.1" || fail "no page of the manual: $page.1"
done
for file in bash-completion/completions/knuckle zsh/site-functions/_knuckle fish/vendor_completions.d/knuckle.fish; do
    grep -q render "$prefix/share/$file" || fail "no completion: $file"
done

# Installed.
quietly cmake -S docs/example -B "$folder/installed" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix"
quietly cmake --build "$folder/installed"
export LP_NUM_THREADS=0
first=$("$folder/installed/example")
grep -qE '^1\.00 s: the box at 0\.(099|100|101) m' <<<"$first" || fail "the example's box does not lie on the ground:" "$first"

# Actors and scenes link, too.
mkdir "$folder/figure"
cat >"$folder/figure/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(figure LANGUAGES C CXX)
find_package(knuckle 0.1 REQUIRED)
add_executable(figure main.cpp)
target_link_libraries(figure PRIVATE knuckle::knuckle)
END
cat >"$folder/figure/main.cpp" <<'END'
#include <knuckle/actor.h>
#include <knuckle/scene.h>
#include <knuckle/simulation.h>
#include <cstdio>

int main(int, char** files)
{
    knuckle::ActorOptions options;
    options.voxels.diameter = 0.08f;
    const knuckle::Actor actor = makeActor(knuckle::importModel(files[1]), options);
    knuckle::SceneWorld scene = knuckle::loadSceneWorld(files[2]);
    knuckle::Simulation first(scene.world), second(std::move(scene.world));
    first.step(20);
    for (int k = 0; k < 20; ++k) second.step();
    std::printf("%zu bodies, %s\n", actor.bodies.size(), first.hash() == second.hash() ? "same" : "different");
}
END
quietly cmake -S "$folder/figure" -B "$folder/figure/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix"
quietly cmake --build "$folder/figure/build"
assets=$prefix/share/knuckle/assets
said=$("$folder/figure/build/figure" "$assets/models/humanoid.glb" "$assets/scenes/hello.json")
[[ $said =~ ^1[0-9]\ bodies,\ same$ ]] || fail "actor and scene: $said"

# As a folder of another project: the same bits.
part=$build/part
quietly cmake -S docs/example -B "$part" -G Ninja -DCMAKE_BUILD_TYPE=Release -DKNUCKLE_SOURCE="$root"
quietly cmake --build "$part" --target example
second=$("$part/example")
[[ $first == "$second" ]] || fail 'installed and as a part, the example says different things:' "$first" "$second"
[[ ! -e $part/knuckle/bin/test_world ]] || fail 'the tests are built with another project'

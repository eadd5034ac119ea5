#!/usr/bin/env bash
# Runs small inputs that once failed and compares the results with the README of their folder: clips of FBX, rigs, BVH
# and glTF files, outputs. Prints a line for each; exit 1 if any is wrong.
# usage: scripts/try_inputs.sh FOLDER [KNUCKLE]
set -uo pipefail
if [[ $# -lt 1 || $# -gt 2 || ! -d $1 ]]; then
    echo "usage: scripts/try_inputs.sh FOLDER [KNUCKLE]" >&2
    exit 2
fi
inputs=$(cd "$1" && pwd)
knuckle=$(realpath "${2:-$(dirname "${BASH_SOURCE[0]}")/../build/release/bin/knuckle}")
[[ -x $knuckle ]] || { echo "$knuckle is not there: build it, or name another" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
passed=0 failed=0 code=0 wrong=''

# Runs the program; its output goes to `log`, its exit code to $code.
run() {
    timeout 120 "$knuckle" "$@" >log 2>&1
    code=$?
    local broken
    broken=$(awk '/./ && /no hardware device/ && !/^(knuckle: )?(warning: |note: )?no hardware device/' log | head -1)
    [[ -z $broken ]] || complain "lines are mixed: $broken"
    (( code < 128 && code != 124 )) || complain "ended with $code: $(tail -1 log)"
}
complain() { wrong+="${wrong:+; }$1"; }
# expect WHAT COMMAND...: complains if the command fails.
expect() { "${@:2}" || complain "$1"; }
# Prints the line of an input, and resets the state for the next.
report() {
    if [[ -z $wrong ]]; then
        echo "ok     $1"
        passed=$((passed + 1))
    else
        echo "wrong  $1: $wrong"
        failed=$((failed + 1))
    fi
    wrong=''
    done_with+=("$1")
}
done_with=()

says() { grep -qE -- "$1" log; }
is_quiet() { ! grep -qE -- "$1" log; }
succeeds() { expect "exit $code: $(tail -1 log)" test "$code" -eq 0; }
# A field of a body's row in the table: 2 parent, 3 particles, 4 joint, 6 turns, 7 what it is taken for.
field() { awk -F'  +' -v name="$1" -v field="$2" '$1 == name { print $field; exit }' log; }
parent() { field "$1" 2; }
expect_parent() { expect "$1 hangs on '$(parent "$1")', not $2" test "$(parent "$1")" = "$2"; }
expect_alike() { expect "$1 has $(field "$1" 3) particles, $2 $(field "$2" 3)" test "$(field "$1" 3)" = "$(field "$2" 3)"; }
# A side of the figure: wide, high or deep.
side() { sed -nE "s/^size:.* ([0-9.e-]+)( m)? $1.*/\1/p" log; }
# between VALUE LEAST MOST
between() { awk -v v="$1" -v a="$2" -v b="$3" 'BEGIN { exit !(v != "" && v + 0 >= a && v + 0 <= b) }'; }
expect_high() { expect "$(side high) m high, not $1 to $2" between "$(side high)" "$1" "$2"; }
# The limbs of both sides on the same bodies, or on a left and a right one.
expect_sides() {
    local pairs
    pairs=$(awk -F'  +' '
        function other(name) {
            if (sub(/\.L$/, ".R", name) || sub(/_L$/, "_R", name)) return name
            if (sub(/^Left/, "Right", name) || sub(/^L\./, "R.", name) || sub(/_Left$/, "_Right", name)) return name
            return name
        }
        /^$/ { exit }
        { parent[$1] = $2 }
        END {
            for (b in parent)
                if (other(b) != b && other(b) in parent && other(parent[b]) != parent[other(b)])
                    print b " on " parent[b] ", " other(b) " on " parent[other(b)]
        }' log)
    expect "sides differ: ${pairs//$'\n'/, }" test -z "$pairs"
}
scene() { printf '{ "duration": 0.5, "objects": [{ "type": "actor", "file": "%s"%s }] }\n' "$1" "$2" >scene.json; }

# --- FBX

fbx_rest() {
    run voxelize "$inputs/$1"
    succeeds
    local side
    for side in Left Right; do
        expect "$(field ${side}UpLeg 6)" test "$(field ${side}UpLeg 6)" = 'cone 75, twist -45 to 45'
        expect_parent ${side}UpLeg Hips
        expect_parent ${side}Foot ${side}Leg
    done
    expect_sides
    expect_alike LeftUpLeg RightUpLeg
    expect_high 1.7 2
}
fbx_rest fbx_prerotation.fbx
report fbx_prerotation.fbx
fbx_rest fbx_no_prerotation.fbx
report fbx_no_prerotation.fbx
fbx_rest fbx_inherit_type2.fbx
report fbx_inherit_type2.fbx

run -q render "$inputs/fbx_prerotation.json" -o frames --size 64x36 --export bodies=bodies.csv --export gltf=motion.glb
succeeds
# feet_above BODIES.csv: the number of frames in which a foot is not below the hips.
feet_above() {
    awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        { y[$column["frame"], $column["name"]] = $column["y"]; frames[$column["frame"]] = 1 }
        END {
            for (f in frames) {
                ++count
                above += !(y[f, "LeftFoot"] < y[f, "Hips"] - 0.5 && y[f, "RightFoot"] < y[f, "Hips"] - 0.5)
            }
            print (count > 1 ? above + 0 : "all")
        }' "$1"
}
expect "feet are not below the hips in $(feet_above bodies.csv) frames" test "$(feet_above bodies.csv)" = 0
printf '{ "duration": 1, "objects": [{ "type": "actor", "file": "motion.glb", "animation": { "clip": "simulation" } }] }' \
    >again.json
run -q render again.json -o again --size 64x36 --export bodies=again.csv
succeeds
expect "of the exported clip feet are not below the hips in $(feet_above again.csv) frames" \
    test "$(feet_above again.csv)" = 0
report fbx_prerotation.json

# --- rigs

rig() { run voxelize "$inputs/rigs/$1"; succeeds; }

rig arms_droop_slightly.gltf
run voxelize "$inputs/rigs/arms_droop_slightly.gltf" --preview p.png -o droop.json
succeeds
expect 'no preview' test -s p.png
scene droop.json ''
run -q render scene.json -o droop --size 64x36 --frames 1:2
succeeds
report rigs/arms_droop_slightly.gltf

rig no_hips.gltf
expect_sides
expect_parent DEF-thigh.L DEF-spine.001
expect_parent DEF-thigh.R DEF-spine.001
expect "arms hang on $(parent DEF-upper_arm.L) and $(parent DEF-upper_arm.R)" \
    test "$(parent DEF-upper_arm.L)" = "$(parent DEF-upper_arm.R)"
report rigs/no_hips.gltf

for rig in feet_at_root feet_in_chain; do
    rig $rig.gltf
    for foot in Front Back; do for letter in L R; do
        expect_parent ${foot}Foot.$letter ${foot}LowLeg.$letter
    done; done
    expect_sides
    report rigs/$rig.gltf
done

rig leg_tips.gltf
expect 'there are no tips' says '_Leg_Tip_|_Tip_'
for tip in $(awk '$1 ~ /_Tip_/ { print $1 }' log); do
    expect "$tip is a $(field "$tip" 7)" grep -q '^toe' <<<"$(field "$tip" 7)"
done
expect_sides
report rigs/leg_tips.gltf

rig sides_swapped_no_clip.gltf
for letter in L R; do
    expect "$letter.LowerLeg turns $(field $letter.LowerLeg 6)" \
        grep -qE ' about (x|\(\+?(1\.00|0\.9))' <<<"$(field $letter.LowerLeg 6)"
    expect "$letter.LowerLeg turns $(field $letter.LowerLeg 6)" grep -qE '^-?[0-9]+ to 1[0-9][0-9] ' \
        <<<"$(field $letter.LowerLeg 6)"
done
report rigs/sides_swapped_no_clip.gltf

rig blocky.gltf
run voxelize "$inputs/rigs/blocky.gltf" -o blocky.json
# lowest ACTOR.json BODY: the lowest particle of a body.
lowest() {
    awk -v body="$2" '
        index($0, "{ \"name\": \"" body "\",") && /"particles": \[/ {
            list = $0; sub(/.*"particles": \[/, "", list); sub(/\].*/, "", list)
            for (count = split(list, own, /, */); count > 0; --count) is_own[own[count]] = 1
        }
        /^  "particles": \[/ { inside = 1; number = 0; next }
        inside && /^  \]/ { exit }
        inside {
            gsub(/[][,]/, " "); split($0, place, " ")
            if (number++ in is_own && (lowest == "" || place[2] + 0 < lowest)) lowest = place[2] + 0
        }
        END { print lowest }' "$1"
}
expect "Body reaches down to $(lowest blocky.json Body)" between "$(lowest blocky.json Body)" 0.55 9
expect_sides
expect_alike Leg_Left Leg_Right
report rigs/blocky.gltf

rig posed_nodes.gltf
for limb in Oberschenkel Unterschenkel Oberarm Unterarm; do expect_alike $limb.L $limb.R; done
expect 'nothing says that the nodes are posed' says '^note: .*another pose'
report rigs/posed_nodes.gltf

for rig in empty_trunk limbs_before_trunk limbs_before_trunk_posed rigify_def names_french names_german names_spanish \
    spider_empty_body spider_legs_first sides_swapped elbow_twist; do
    rig $rig.gltf
    expect_sides
    expect 'a limb hangs on one of the other side' \
        awk -F'  +' '/^$/ { exit } $1 ~ /[._]L$/ && $2 ~ /[._]R$/ { bad = 1 } END { exit bad }' log
    report rigs/$rig.gltf
done

# --- BVH

bvh() { run voxelize "$inputs/bvh/$1.bvh"; }
for file in zup zup_metres; do
    bvh $file
    succeeds
    expect_high 1.6 2
    expect 'it is deeper than it is high' between "$(side deep)" 0 0.6
    expect 'it does not say what was taken for up' says '^note: .*up'
    report bvh/$file.bvh
done
bvh decimetres
succeeds
expect_high 1.6 2
expect 'it does not say decimetres' says '^note: .*decimetres'
report bvh/decimetres.bvh
bvh two_roots
if (( code == 0 )); then expect 'nothing says that there are two' says 'skeletons'
else
    expect "exit $code" test "$code" -eq 2
    expect "it says: $(tail -1 log)" says 'it holds 2 skeletons: .*--skeleton'
    for root in Hips B_Hips; do
        run voxelize "$inputs/bvh/two_roots.bvh" --skeleton $root
        succeeds
        expect_high 1.6 2
    done
fi
report bvh/two_roots.bvh
for file in names_with_spaces lowercase_channels; do
    bvh $file
    succeeds
    expect_high 1.6 2
    expect_sides
    expect 'it has no clip' says '^clip: .*, 0\.9'
    report bvh/$file.bvh
done
for unit in metres millimetres inches feet cmu; do
    bvh $unit
    succeeds
    expect_high 1.6 2
    report bvh/$unit.bvh
done

# --- glTF

gltf() { run voxelize "$inputs/gltf/$1.gltf"; succeeds; expect_high 1.7 1.85; }
picture() {  # NAME: a frame of a scene with it is drawn into NAME.png
    scene "$inputs/gltf/$1.gltf" ', "skin": "mesh"'
    run render scene.json -o "$1" --size 320x180 --frames 1:1
    succeeds
    cp "$1"/*.png "$1.png"
}
for file in ktx2 webp; do
    gltf $file
    expect 'voxelize says nothing of its texture' test $file = webp -o -n "$(grep -i texture log)"
    picture $file
    if [[ $file == webp ]]; then   # both are alike but for the picture
        "$knuckle" compare ktx2.png webp.png >/dev/null 2>&1
        [[ $? -eq 4 ]] || expect 'its texture is neither drawn nor told' says '[Tt]exture'
    else
        expect 'render says nothing of its texture' says '[Tt]exture'
        run check scene.json
        succeeds
        expect 'check says nothing of its texture' says '[Tt]exture'
    fi
    report gltf/$file.gltf
done
for file in morph scale_anim; do
    gltf $file
    word=$([[ $file == morph ]] && echo 'morph weights' || echo 'scales')
    expect "voxelize says nothing of it ($word)" says "^note: .*$word"
    clip=$(sed -nE 's/^clip: (.*), [0-9.]+ s$/\1/p' log | head -1)
    scene "$inputs/gltf/$file.gltf" ", \"animation\": { \"clip\": \"$clip\" }"
    run check scene.json
    succeeds
    expect "check says nothing of it ($word)" says "note: .*$word"
    report gltf/$file.gltf
done
gltf same_name_clips
expect 'both clips have one name' test "$(grep -cx 'clip: mixamo.com, .*' log)" -eq 1
for clip in mixamo.com 'mixamo.com#2'; do
    scene "$inputs/gltf/same_name_clips.gltf" ", \"animation\": { \"clip\": \"$clip\" }"
    run check scene.json
    succeeds
done
report gltf/same_name_clips.gltf
run voxelize "$inputs/gltf/bone_parented.gltf"
succeeds
expect 'it is one rigid body without a word' says '^note: .*(bones|skeleton|node)|^thigh\.L '
if says '^thigh\.L '; then
    expect_parent thigh.L hips
    expect_parent shin.L thigh.L
    expect_sides
fi
report gltf/bone_parented.gltf
gltf unknown_required
expect 'nothing says which extension' says '^note: .*VENDOR_something'
report gltf/unknown_required.gltf
run voxelize "$inputs/gltf/meshopt.gltf"
if (( code == 0 )); then expect_high 1.7 1.85; else expect "exit $code: $(tail -1 log)" says meshopt; fi
report gltf/meshopt.gltf

# --- inputs without a row of their own: read, or refused in one line

one_line() { test "$code" -eq 2 && test "$(wc -l <log)" -eq 1 && says '^knuckle: '; }
for path in "$inputs"/rigs/*.gltf "$inputs"/bvh/*.bvh "$inputs"/gltf/*.gltf; do
    name=${path#"$inputs"/}
    [[ " ${done_with[*]} " == *" $name "* ]] && continue
    run voxelize "$path"
    if (( code == 0 )); then
        expect_high 1.5 2
        expect_sides
    else
        expect "exit $code: $(tail -1 log)" one_line
    fi
    report "$name"
done

# --- outputs

# Both streams in one file: no line of the table may contain another stream's text.
run voxelize "$inputs/gltf/plain.gltf" --preview preview.png
mv log both
timeout 120 "$knuckle" voxelize "$inputs/gltf/plain.gltf" --preview preview.png >apart 2>errors
expect 'lines differ from those of its streams apart' cmp -s <(sort both) <(sort apart errors)
report 'voxelize > log 2>&1'
if [[ -f $inputs/scenes/fall.json ]]; then
    run render "$inputs/scenes/fall.json" -o fall --size 64x36 --export bodies=fall.csv --stats fall.txt
    succeeds
    expect 'frames are missing' test "$(find fall -name '*.png' | wc -l)" -eq 60
    expect 'tables are missing' test -s fall.csv -a -s fall.txt
    report scenes/fall.json
fi
for path in "$inputs"/scenes/*.json; do
    [[ $path == */fall.json ]] || echo "skip   ${path#"$inputs"/}: what matter does is not tried here"
done
[[ ! -d $inputs/images ]] || echo 'skip   images/: how images are compared is not tried here'

echo "$passed passed, $failed failed"
(( failed == 0 ))

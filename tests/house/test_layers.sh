#!/usr/bin/env bash
# The layering rule: base <- model <- terrain <- solver <- world <- measure, scene, render; base <- camera
# <- world; calm is a part of the world in a folder of its own; experiments and session stand on measure
# and scene, the faces on all of them. A file includes only what stands
# left of it, and nothing goes round in a circle; the faces know public headers only, the experiments besides their own only those of
# base; the core needs nothing but the C library and threads. The web's modules go ui -> simulation ->
# src. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_layers.sh BUILD SOURCE}")
cd "${2:?usage: test_layers.sh BUILD SOURCE}"
calls=$(mktemp)
trap 'rm -f "$calls"' EXIT

# What each layer may include, itself first; skvalp.h is the core's headers in one.
declare -A may=(
    [base]="base"
    [model]="model base"
    [solver]="solver terrain model base"
    [terrain]="terrain model base"
    [camera]="camera base"
    [calm]="calm world solver terrain model base"
    [world]="world calm solver terrain model base"
    [measure]="measure world calm solver terrain model base"
    [skvalp]="base model camera terrain world measure"
    [scene]="scene world calm solver terrain model base"
    [render]="render camera world calm solver terrain model base"
    [experiments]="experiments measure scene world terrain model base"
    [session]="session measure scene camera world calm solver terrain model base"
    [link]="link base"
)
# What the core may take from the system: what a compiler brings along, and so much of <math.h> and
# <string.h> as src/base/wasm/include declares. The rest is behind src/base/platform.h.
core_system=' float limits math stdarg stdatomic stdbool stddef stdint string immintrin emmintrin
 arm_neon wasm_simd128 '
declare -A system=(
    [base]=$core_system
    [model]=$core_system
    [solver]=$core_system
    [terrain]=$core_system
    [camera]=$core_system
    [calm]=$core_system
    [world]=$core_system
    [measure]=$core_system
)

bad=0
complain() {
    printf '%s: %s\n' "$1" "$2"
    bad=$((bad + 1))
}

# What each file includes, as <x> or "x". All files are read at once: a process for each of them took
# most of this test's time.
declare -A included
while IFS=: read -r file include; do
    included[$file]+="$include "
done < <(grep -rE --include='*.[ch]' '^[[:space:]]*#[[:space:]]*include' src include app cli bench \
    examples 2>/dev/null |
    sed -nE 's/^([^:]*):[[:space:]]*#[[:space:]]*include[[:space:]]*([<"][^>"]*[>"]).*/\1:\2/p')

# layer_of FILE INCLUDE: sets `of` to the layer an include belongs to; to nothing for a system header.
layer_of() {
    local name=${2:1:-1}
    of=
    case $name in
    skvalp/fields.h) of=base ;;
    skvalp/fluid.h) of=model ;;
    skvalp/acting.h | skvalp/air.h | skvalp/area.h | skvalp/bodies.h | skvalp/frame.h | skvalp/parameters.h) of=world ;;
    skvalp/particles.h | skvalp/query.h | skvalp/snapshot.h) of=world ;;
    skvalp/mark.h) of=camera ;;
    skvalp/player.h | skvalp/stage.h) of=session ;;
    skvalp/controls.h | skvalp/fingers.h | skvalp/numbers.h | skvalp/stopwatch.h | skvalp/tilt.h) of=session ;;
    skvalp/study.h) of=experiments ;;
    skvalp/*.h)
        of=${name#skvalp/}
        of=${of%.h}
        ;;
    */*.h) [[ ! -e src/$name ]] || of=${name%%/*} ;;
    # A neighbour in the same folder, which is src/LAYER or one below it.
    *)
        [[ ! -e ${1%/*}/$name ]] || of=${1#*/}
        of=${of%%/*}
        ;;
    esac
}

check_library_file() {
    local file=$1 layer=$2 include of
    for include in ${included[$file]-}; do
        layer_of "$file" "$include"
        if [[ -n $of ]]; then
            [[ " ${may[$layer]} " == *" $of "* ]] ||
                complain "$file" "layer $layer must not include $include of layer $of"
            [[ $layer != experiments || " experiments base " == *" $of "* ||
                $include == ?skvalp/* ]] ||
                complain "$file" "an experiment must not include $include: it is not public"
        elif [[ $include == \"* ]]; then
            # Generated into the build folder; its name says so.
            [[ $include == *_generated.h* || $include == *.inc\" ]] ||
                complain "$file" "$include is found in no layer"
        elif [[ -n ${system[$layer]-} && $file != src/base/posix/* && $file != src/base/windows/* &&
            ${system[$layer]} != *[[:space:]]"${include:1:-3}"[[:space:]]* ]]; then
            complain "$file" "the core must not depend on $include"
        elif [[ $include =~ ^.(gtk|gdk|glib|adwaita|cairo|SDL) ]]; then
            complain "$file" "the library must not depend on a toolkit: $include"
        fi
    done
}

# The faces: public headers, headers of the same folder, and headers of the system or a toolkit. The
# command line also shows what bench measures.
check_face_file() {
    local file=$1 include name
    for include in ${included[$file]-}; do
        name=${include:1:-1}
        [[ $file == cli/* && $name == bench/bench.h ]] && continue
        if [[ $include == \"* && $name != skvalp/* && ! -e ${file%/*}/$name ]]; then
            complain "$file" "a face must not include $include: it is not public"
        elif [[ $include == '<'* && $name != skvalp/* && -e src/$name ]]; then
            complain "$file" "a face must not include $include: it is not public"
        fi
    done
}

# A scene's core, all of src/scene but read/, knows no files and no parsers: a host brings those.
check_scene_core() {
    local file=$1 include
    for include in ${included[$file]-}; do
        [[ $include != ?scene/read/* ]] || complain "$file" "the core must not include $include"
        [[ $include != '<'* || "$core_system stdlib " == *[[:space:]]"${include:1:-3}"[[:space:]]* ]] ||
            complain "$file" "the core must not depend on $include"
    done
}

files=0
for layer in "${!may[@]}"; do
    while IFS= read -r file; do
        check_library_file "$file" "$layer"
        files=$((files + 1))
    done < <(find "src/$layer" -name '*.[ch]' 2>/dev/null)
done
for file in include/skvalp/*.h; do
    layer_of "$file" "<${file#include/}>"
    layer=$of
    if [[ -z ${may[$layer]-} ]]; then
        complain "$file" "this public header belongs to no layer"
        continue
    fi
    check_library_file "$file" "$layer"
    files=$((files + 1))
done
while IFS= read -r file; do
    check_scene_core "$file"
done < <(find src/scene -maxdepth 1 -name '*.[ch]')
while IFS= read -r file; do
    check_face_file "$file"
    files=$((files + 1))
done < <(find app cli bench examples -name '*.[ch]' 2>/dev/null)
for folder in src/*/; do
    layer=$(basename "$folder")
    [[ -n ${may[$layer]-} ]] || complain "$folder" "this folder is no layer"
done
while IFS=: read -r file line _; do
    complain "$file:$line" "the solver must not know the world"
done < <(grep -rnE '\bskv_world' --include='*.[ch]' src/solver 2>/dev/null || true)

# No circles: neither headers that include each other, nor files that call each other. The calls are
# read from the objects of what was built; a table that holds others' functions calls nobody.
headers_included() {
    local header name place
    while IFS=: read -r header name; do
        for place in "${header%/*}/" src/ include/ ''; do
            if [[ -e $place$name ]]; then
                printf '%s %s\n' "$header" "$place$name"
                break
            fi
        done
    done < <(grep -rHE --include='*.h' '^[[:space:]]*#[[:space:]]*include' include src app cli bench |
        sed -nE 's/^([^:]*):[^<"]*[<"]([^>"]*)[>"].*/\1:\2/p')
}

files_called() {
    local source kind symbol
    while read -r source kind symbol; do
        [[ ! -e $source ]] || printf '%s %s %s\n' "$source" "$kind" "$symbol"
    done < <(sed -nE 's,.* -o ((src|app|cli|bench)/[^ ]*) -c .*,\1,p' "$build/compile_commands.json" |
        (cd "$build" && xargs nm -gA 2>/dev/null) |
        sed -nE "s,^(.*)CMakeFiles/[^/]*\.dir/([^:]*)\.o:[0-9a-f ]* ([A-Za-z]) (.*),\1\2 \3 \4,p") |
        awk '
            $2 == "U" { calls[$1 " " $3] }
            $2 == "T" { home[$3] = $1 }
            END {
                for (call in calls) {
                    split(call, part, " ")
                    if (part[2] in home && home[part[2]] != part[1])
                        print part[1], home[part[2]]
                }
            }'
}

# complain_of_circles WHAT: reads pairs of files; tsort names the members of every circle.
complain_of_circles() {
    local member
    while IFS= read -r member; do
        complain "$member" "$1 in a circle with the others named here"
    done < <(tsort 2>&1 >/dev/null | sed -n 's/^tsort: //p' | grep -v 'contains a loop')
}

complain_of_circles "includes" < <(headers_included)
files_called | sort >"$calls"
[[ -s $calls ]] || complain "$build" "no object was found to read calls from"
complain_of_circles "calls" <"$calls"

# The web's modules: imports, and workers that are started. Types are imported downwards, too, but may
# go round.
declare -A web_may=(
    [page]="page ui simulation src"
    [ui]="ui simulation src"
    [simulation]="simulation src"
    [src]="src"
    [tools]="tools src"
)

web_layer_of() {
    case $1 in
    web/page/ui/*) of=ui ;;
    web/page/simulation/*) of=simulation ;;
    web/page/*) of=page ;;
    web/src/*) of=src ;;
    web/tools/*) of=tools ;;
    *) of= ;;
    esac
}

# Of each import: the module, what it names (a neighbour's path as it stands there, or a package), and
# `type` where that is gone once it is built.
modules_named() {
    # shellcheck disable=SC2016  # awk's
    find web/page web/src web/tools -regextype posix-extended -regex '.*\.(ts|tsx|js)' -print0 |
        xargs -0 awk -v quote="['\"]" '
            /^[[:space:]]*\/\// { next }
            /^import/ || /^export/ { type = /^(im|ex)port type/ }
            match($0, "((^|[} ])from |^import |import\\(|new Worker\\(new URL\\()" quote "[^\"]*") {
                split(substr($0, RSTART, RLENGTH), part, quote)
                comment = /^[[:space:]]*\/?\*/ || /typeof import/
                print FILENAME, part[2], type || comment ? "type" : "value"
                type = 0
            }'
}

# Sets `target` to the file that a module names; to nothing if there is none. A process for each of them
# would take most of this test's time.
find_module() {
    local path=${1%/*}/$2 place='' part ending
    local IFS=/
    for part in $path; do
        case $part in
        .) ;;
        ..) place=${place%/*} ;;
        *) place+=/$part ;;
        esac
    done
    target=
    for ending in '' .ts .tsx; do
        [[ ! -f ${place#/}$ending ]] || target=${place#/}$ending
    done
}

imports=$(mktemp)
trap 'rm -f "$calls" "$imports"' EXIT
while read -r file name kind; do
    web_layer_of "$file"
    layer=$of
    if [[ $name != .* ]]; then
        [[ $layer != @(simulation|src|tools) || $name != @(preact|@preact)* ]] ||
            complain "$file" "layer $layer must not know what draws the page: $name"
        continue
    fi
    # Made by a build; a package's own file; a stylesheet.
    [[ $name != */interface.js && $name != */node_modules/* && $name != *.css ]] || continue
    find_module "$file" "$name"
    if [[ -z $target ]]; then
        complain "$file" "$name leads to no module"
        continue
    fi
    web_layer_of "$target"
    # A test may take its tools from everywhere.
    [[ $file == *.test.ts || $target != web/* || -z $of || " ${web_may[$layer]} " == *" $of "* ]] ||
        complain "$file" "layer $layer must not import $name of layer $of"
    [[ $kind == type ]] || printf '%s %s\n' "$file" "$target" >>"$imports"
    files=$((files + 1))
done < <(modules_named)
[[ -s $imports ]] || complain web "no module was found to read imports from"
complain_of_circles "imports" <"$imports"

((files > 0)) || complain . "no file was found to check"
if ((bad > 0)); then
    printf 'layers: %d faults\n' "$bad"
    exit 1
fi
printf 'layers: %d files and imports keep to them\n' "$files"

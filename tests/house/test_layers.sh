#!/usr/bin/env bash
# The layering rule: base <- terrain, camera <- solver <- world <- measure, scene, render; experiments
# and session stand on measure and scene, the faces on all of them. A file includes only what stands
# left of it; the faces know public headers only, the experiments besides their own only those of
# base; the core needs nothing but the C library and threads. Arguments: build folder, source folder.
set -euo pipefail
cd "${2:?usage: test_layers.sh BUILD SOURCE}"

# What each layer may include, itself first; skvalp.h is the core's headers in one.
declare -A may=(
    [base]="base"
    [solver]="solver terrain base"
    [terrain]="terrain base"
    [camera]="camera base"
    [world]="world solver terrain base"
    [measure]="measure world solver terrain base"
    [skvalp]="base camera terrain world measure"
    [scene]="scene world solver terrain base"
    [render]="render camera world solver terrain base"
    [experiments]="experiments measure scene world terrain base"
    [session]="session measure scene camera world solver terrain base"
)
# What the core may take from the system: what a compiler brings along, and so much of <math.h> and
# <string.h> as src/base/wasm/include declares. The rest is behind src/base/platform.h.
# Measuring may take what C has.
core_system=' float limits math stdarg stdatomic stdbool stddef stdint string immintrin emmintrin
 arm_neon wasm_simd128 '
declare -A system=(
    [base]=$core_system
    [solver]=$core_system
    [terrain]=$core_system
    [camera]=$core_system
    [world]=$core_system
    [measure]="$core_system assert ctype errno inttypes stdio stdlib "
)

bad=0
complain() {
    printf '%s: %s\n' "$1" "$2"
    bad=$((bad + 1))
}

# includes FILE: what it includes, one a line, as <x> or "x".
includes() {
    sed -nE 's/^[[:space:]]*#[[:space:]]*include[[:space:]]*([<"][^>"]*[>"]).*/\1/p' "$1"
}

# layer_of FILE INCLUDE: the layer an include belongs to; nothing for a system header.
layer_of() {
    local name=${2:1:-1}
    case $name in
    skvalp/fields.h) printf 'base' ;;
    skvalp/*.h) basename "$name" .h ;;
    */*.h) [[ -e src/$name ]] && printf '%s' "${name%%/*}" ;;
    # A neighbour in the same folder, which is src/LAYER or one below it.
    *) [[ -e $(dirname "$1")/$name ]] && cut -d / -f 2 <<<"$1" ;;
    esac || true
}

check_library_file() {
    local file=$1 layer=$2 include of
    while read -r include; do
        of=$(layer_of "$file" "$include")
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
    done < <(includes "$file")
}

# The faces: public headers, headers of the same folder, and headers of the system or a toolkit. The
# command line also shows what bench measures.
check_face_file() {
    local file=$1 include name
    while read -r include; do
        name=${include:1:-1}
        [[ $file == cli/* && $name == bench/bench.h ]] && continue
        if [[ $include == \"* && $name != skvalp/* && ! -e $(dirname "$file")/$name ]]; then
            complain "$file" "a face must not include $include: it is not public"
        elif [[ $include == '<'* && $name != skvalp/* && -e src/$name ]]; then
            complain "$file" "a face must not include $include: it is not public"
        fi
    done < <(includes "$file")
}

files=0
for layer in "${!may[@]}"; do
    while IFS= read -r file; do
        check_library_file "$file" "$layer"
        files=$((files + 1))
    done < <(find "src/$layer" -name '*.[ch]' 2>/dev/null)
done
for file in include/skvalp/*.h; do
    layer=$(layer_of "$file" "<skvalp/$(basename "$file")>")
    if [[ -z ${may[$layer]-} ]]; then
        complain "$file" "this public header belongs to no layer"
        continue
    fi
    check_library_file "$file" "$layer"
    files=$((files + 1))
done
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

((files > 0)) || complain . "no file was found to check"
((bad == 0)) || exit 1
printf 'layers: %d files keep to them\n' "$files"

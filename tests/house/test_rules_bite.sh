#!/usr/bin/env bash
# The house rules can fail: each is tried on a copy of the sources with sins in it, and must report
# them all. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_rules_bite.sh BUILD SOURCE}")
source=$(realpath "${2:?usage: test_rules_bite.sh BUILD SOURCE}")
rules=$source/tests/house
# shellcheck source=tests/support/sources.sh
source "$source/tests/support/sources.sh"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
bad=0

fresh_copy() {
    rm -rf "$work/copy"
    copy_sources "$source" "$work/copy"
}

# bites RULE BUILD SAID...: the rule must fail on the copy and say all of it; then the copy is new.
bites() {
    local rule=$1 said failed=0
    bash "$rules/$rule" "$2" "$work/copy" >"$work/said" 2>&1 || failed=1
    shift 2
    if ((!failed)); then
        printf '%s did not notice: %s\n' "$rule" "$*"
        bad=$((bad + 1))
    fi
    for said; do
        grep -qF -- "$said" "$work/said" && continue
        printf '%s did not say "%s" but:\n' "$rule" "$said"
        head -n 40 "$work/said"
        bad=$((bad + 1))
    done
    # Where a rule counts what it found, each line of it counts: one that does not would let the rule pass.
    said=$(sed -nE '$s/^[a-z]+: ([0-9]+) faults$/\1/p' "$work/said")
    [[ -z $said || $said == $(($(wc -l <"$work/said") - 1)) ]] || {
        printf '%s counts %s of its lines:\n' "$rule" "$said"
        cat "$work/said"
        bad=$((bad + 1))
    }
    fresh_copy
}

fresh_copy
copy=$work/copy
mkdir -p "$copy/src/solver/deeper"
: >"$copy/src/world/sin.h"
printf '#include "world/sin.h"\n#include <jansson.h>\n#include <stdio.h>\n' >>"$copy/src/base/memory.c"
printf '#include <stdio.h>\n' >>"$copy/src/scene/shape.c"
printf '#include <skvalp/render.h>\n' >>"$copy/include/skvalp/world.h"
printf '#include "solver/solver.h"\n' >"$copy/src/terrain/sin.c"
printf 'struct skv_world;\n' >"$copy/src/solver/deeper/sin.c"
printf '#include "calm/sleep.h"\n' >"$copy/src/experiments/sin.c"
printf '#include <skvalp/scene.h>\n' >"$copy/src/render/sin.c"
printf '#include "base/memory.h"\n' >"$copy/cli/sin.c"
printf '#include "base/sin.h"\n' >"$copy/src/base/other_sin.h"
printf '#include "base/other_sin.h"\n' >"$copy/src/base/sin.h"
printf "import { state } from '../ui/model';\nimport { signal } from '@preact/signals';\n" \
    >>"$copy/web/page/simulation/pacing.ts"
printf "import {\n    Row,\n} from '../page/ui/Row';\n" >>"$copy/web/src/memory.js"
printf "import { Properties } from './Properties';\n" >>"$copy/web/page/ui/Row.tsx"
# Of what was built the rule sees two files that call each other.
objects=$work/build/src/CMakeFiles/sin.dir/base
mkdir -p "$objects"
printf 'int other(void); int sin(void) { return other(); }\n' >"$copy/src/base/sin.c"
printf 'int sin(void); int other(void) { return sin(); }\n' >"$copy/src/base/other_sin.c"
for sin in sin other_sin; do
    printf '"command": "cc -o src/CMakeFiles/sin.dir/base/%s.c.o -c %s.c"\n' "$sin" "$sin" >>"$work/build/compile_commands.json"
    "${CC:-gcc}" -fno-builtin -c "$copy/src/base/$sin.c" -o "$objects/$sin.c.o"
done
bites test_layers.sh "$work/build" \
    'src/base/memory.c: layer base must not include "world/sin.h" of layer world' \
    "src/base/memory.c: the core must not depend on <jansson.h>" \
    "src/base/memory.c: the core must not depend on <stdio.h>" \
    "src/scene/shape.c: the core must not depend on <stdio.h>" \
    "include/skvalp/world.h: layer world must not include <skvalp/render.h>" \
    'src/terrain/sin.c: layer terrain must not include "solver/solver.h"' \
    "src/solver/deeper/sin.c:1: the solver must not know the world" \
    'src/experiments/sin.c: an experiment must not include "calm/sleep.h"' \
    "src/render/sin.c: layer render must not include <skvalp/scene.h>" \
    'cli/sin.c: a face must not include "base/memory.h"' \
    "src/base/other_sin.h: includes in a circle" "src/base/other_sin.c: calls in a circle" \
    "web/page/simulation/pacing.ts: layer simulation must not import ../ui/model of layer ui" \
    "web/page/simulation/pacing.ts: layer simulation must not know what draws the page: @preact/signals" \
    "web/src/memory.js: layer src must not import" "web/page/ui/Row.tsx: imports in a circle"

printf 'SKV_API int skv_sin_of_omission(void);\n' >>"$copy/include/skvalp/base.h"
bites test_api.sh "$build" "skv_sin_of_omission is declared in include/skvalp but not defined" \
    "skv_sin_of_omission is called by no test"

printf 'int sin = sizeof(skv_unknown);\n' >>"$copy/include/skvalp/terrain.h"
printf 'struct sin { int class; };\n' >>"$copy/include/skvalp/camera.h"
bites test_api.sh "$build" "terrain.h does not compile alone as C17" "camera.h does not compile alone as C++17"

sed -i 's/^int main(void)$/int sin = "no number"; &/' "$copy/README.md"
bites test_readme.sh "$build" "does not compile"

sed -i '1i build/release/skvalp run no-such-scene' "$copy/README.md"
bites test_readme.sh "$build" "no-such-scene' fails"

# shellcheck disable=SC2016  # the backquotes are the page's
# shellcheck disable=SC2016  # the backquotes are Markdown's
printf '%s\n' '[nowhere](docs/nowhere.md)' '`src/base/sin.c`' '`skv_world_sin`' '`skvalp lab sin`' \
    '`skvalp run sin`' '`skvalp run pool --sin`' '`sin.of=1`' >>"$copy/README.md"
sed -i 's/model.md#substeps/model.md#sin/' "$copy/docs/performance.md"
sed -i 's/^\(#define SPEED_OF_SOUND *\)0.78/\10.79/' "$copy/src/model/constants.c"
sed -i 's/,65\.2[0-9]*,/,65.9,/' "$copy/bench/results/amd-epyc.csv"
sed -i '/^| slosh | period /s/ 0\.99[0-9] / 0.979 /' "$copy/docs/lab.md"
sed -i '/lab.momentum.md/d' "$copy/docs/lab.md"
# shellcheck disable=SC2016
sed -i 's/`warm_lambda`/`warm_sin`/' "$copy/docs/model.md"
sed -i '/the-lattice.md/d' "$copy/docs/notebook/README.md"
printf '/* docs/model.md, "A sin" */\n' >>"$copy/src/base/memory.c"
bites test_pages.sh "$build" "the link to docs/nowhere.md leads nowhere" "there is no src/base/sin.c" \
    "the sources know no skv_world_sin" "there is no experiment sin" "there is no scene sin" \
    "skvalp has no --sin" "there is no parameter sin.of" "has no heading for #sin" \
    "SPEED_OF_SOUND is 0.79, not 0.78" "its table is not that of bench/results" \
    "its glossary has warm_sin" "the experiment momentum is not listed" "slosh, period: 0.979 is marked wrongly" "the-lattice.md is not in the table" 'cites "A sin" of docs/model.md'

printf 'int sin;\n' >"$copy/src/base/sin.c"
: >"$copy/src/base/empty_sin.c"
awk 'BEGIN { print "/* Long. */"; for (i = 0; i < 600; i++) print "" }' >"$copy/src/base/long_sin.c"
printf '/* %s: later. */\n' 'TO''DO' >"$copy/src/base/late_sin.c"
printf '/* See %s/notes. */\n' '/ho''me/me' >"$copy/src/base/home_sin.c"
: >"$copy/include/skvalp/sin.h"
bites test_style.sh "$build" "src/base/sin.c: a .c file opens with a comment" \
    "src/base/empty_sin.c: a .c file opens with a comment" "src/base/long_sin.c: 601 lines; at most 600" \
    "src/base/late_sin.c:1: unfinished business" "src/base/home_sin.c:1: names a folder" \
    "include/skvalp/sin.h: is found nowhere"

((bad == 0)) || exit 1
printf 'every house rule notices its sins\n'

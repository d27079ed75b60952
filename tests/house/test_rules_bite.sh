#!/usr/bin/env bash
# The house rules can fail: each is tried on a copy of the sources with one sin in it, and must
# report it. Arguments: build folder, source folder.
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

# bites RULE WHAT EXPECTED [BUILD]: the rule must fail on the copy and say EXPECTED; then the copy is new.
bites() {
    bites_once "$@"
    fresh_copy
}

# bites_once: the same, and the copy stays as it is.
bites_once() {
    local rule=$1 what=$2 expected=$3
    if bash "$rules/$rule" "${4:-$build}" "$work/copy" >"$work/said" 2>&1; then
        printf '%s did not notice: %s\n' "$rule" "$what"
        bad=$((bad + 1))
    elif ! grep -qF -- "$expected" "$work/said"; then
        printf '%s did not say why (%s) but:\n' "$rule" "$expected"
        head -n 5 "$work/said"
        bad=$((bad + 1))
    fi
}

fresh_copy
sin=src/base/memory.c
printf '#include "world/sin.h"\n' >>"$work/copy/$sin"
mkdir -p "$work/copy/src/world" && : >"$work/copy/src/world/sin.h"
bites test_layers.sh "base includes world" "layer base must not include"

printf '#include <jansson.h>\n' >>"$work/copy/$sin"
bites test_layers.sh "the core includes jansson" "the core must not depend on <jansson.h>"

printf '#include <stdio.h>\n' >>"$work/copy/$sin"
bites test_layers.sh "the core prints by itself" "the core must not depend on <stdio.h>"

printf '#include <stdio.h>\n' >>"$work/copy/src/scene/shape.c"
bites test_layers.sh "a scene's core reads files" "src/scene/shape.c: the core must not depend on"

printf '#include <skvalp/render.h>\n' >>"$work/copy/include/skvalp/world.h"
bites test_layers.sh "a public header includes one to its right" "layer world must not include"

mkdir -p "$work/copy/src/solver"
printf '#include "solver/solver.h"\n' >"$work/copy/src/terrain/sin.c"
bites test_layers.sh "the terrain includes the solver" "layer terrain must not include"

mkdir -p "$work/copy/src/solver/deeper"
printf 'struct skv_world;\n' >"$work/copy/src/solver/deeper/sin.c"
bites test_layers.sh "the solver names the world" "the solver must not know the world"

printf '#include "calm/sleep.h"\n' >"$work/copy/src/experiments/sin.c"
bites test_layers.sh "an experiment includes a private header" "an experiment must not include"

printf '#include <skvalp/scene.h>\n' >"$work/copy/src/render/sin.c"
bites test_layers.sh "the renderer includes scenes" "layer render must not include"

printf '#include "base/memory.h"\n' >"$work/copy/cli/sin.c"
bites test_layers.sh "a face includes a private header" "it is not public"

printf '#include "base/sin.h"\n' >"$work/copy/src/base/other_sin.h"
printf '#include "base/other_sin.h"\n' >"$work/copy/src/base/sin.h"
bites test_layers.sh "headers that include each other" "src/base/other_sin.h: includes in a circle"

objects=$work/build/src/CMakeFiles/sin.dir/base
mkdir -p "$objects"
printf 'int other(void); int sin(void) { return other(); }\n' >"$work/copy/src/base/sin.c"
printf 'int sin(void); int other(void) { return sin(); }\n' >"$work/copy/src/base/other_sin.c"
for sin in sin other_sin; do
    printf '"command": "cc -o src/CMakeFiles/sin.dir/base/%s.c.o -c %s.c"\n' "$sin" "$sin" >>"$work/build/compile_commands.json"
    "${CC:-gcc}" -fno-builtin -c "$work/copy/src/base/$sin.c" -o "$objects/$sin.c.o"
done
bites test_layers.sh "files that call each other" "src/base/other_sin.c: calls in a circle" "$work/build"

printf "import { state } from '../ui/model';\n" >>"$work/copy/web/page/simulation/pacing.ts"
bites test_layers.sh "the page's simulation imports its surface" \
    "web/page/simulation/pacing.ts: layer simulation must not import ../ui/model of layer ui"

printf "import {\n    Row,\n} from '../page/ui/Row';\n" >>"$work/copy/web/src/memory.js"
bites test_layers.sh "the package imports the page" "web/src/memory.js: layer src must not import"

printf "import { signal } from '@preact/signals';\n" >>"$work/copy/web/page/simulation/pacing.ts"
bites test_layers.sh "the page's simulation knows what draws it" "must not know what draws the page"

printf "import { Properties } from './Properties';\n" >>"$work/copy/web/page/ui/Row.tsx"
bites test_layers.sh "modules that import each other" "web/page/ui/Row.tsx: imports in a circle"

printf 'SKV_API int skv_sin_of_omission(void);\n' >>"$work/copy/include/skvalp/base.h"
bites test_api.sh "a declared function that does not exist" \
    "skv_sin_of_omission is declared in include/skvalp but not defined"

printf 'SKV_API int skv_sin_of_omission(void);\n' >>"$work/copy/include/skvalp/base.h"
bites test_api.sh "a public function without a test" "skv_sin_of_omission is called by no test"

printf 'int sin = sizeof(skv_unknown);\n' >>"$work/copy/include/skvalp/terrain.h"
bites test_api.sh "a header that does not compile" "terrain.h does not compile alone as C17"

printf 'struct sin { int class; };\n' >>"$work/copy/include/skvalp/terrain.h"
bites test_api.sh "a header that is no C++" "terrain.h does not compile alone as C++17"

sed -i 's/^int main(void)$/int sin = "no number"; &/' "$work/copy/README.md"
bites test_readme.sh "an example that does not compile" "does not compile"

sed -i '1i build/release/skvalp run no-such-scene' "$work/copy/README.md"
bites test_readme.sh "a command that fails" "no-such-scene' fails"

# shellcheck disable=SC2016  # the backquotes are the page's
# shellcheck disable=SC2016  # the backquotes are Markdown's
printf '%s\n' '[nowhere](docs/nowhere.md)' '`src/base/sin.c`' '`skv_world_sin`' '`skvalp lab sin`' \
    '`skvalp run sin`' '`skvalp run pool --sin`' '`sin.of=1`' >>"$work/copy/README.md"
sed -i 's/model.md#substeps/model.md#sin/' "$work/copy/docs/performance.md"
sed -i 's/^\(#define SPEED_OF_SOUND *\)0.78/\10.79/' "$work/copy/src/model/constants.c"
sed -i 's/,65\.2[0-9]*,/,65.9,/' "$work/copy/bench/results/amd-epyc.csv"
sed -i '/^| slosh | period /s/ 0\.99[0-9] / 0.979 /' "$work/copy/docs/lab.md"
sed -i '/lab.momentum.md/d' "$work/copy/docs/lab.md"
# shellcheck disable=SC2016
sed -i 's/`warm_lambda`/`warm_sin`/' "$work/copy/docs/model.md"
sed -i '/the-lattice.md/d' "$work/copy/docs/notebook/README.md"
printf '/* docs/model.md, "A sin" */\n' >>"$work/copy/src/base/memory.c"
for said in "the link to docs/nowhere.md leads nowhere" "there is no src/base/sin.c" \
    "the sources know no skv_world_sin" "there is no experiment sin" "there is no scene sin" \
    "skvalp has no --sin" "there is no parameter sin.of" "has no heading for #sin" \
    "SPEED_OF_SOUND is 0.79, not 0.78" "its table is not that of bench/results" \
    "its glossary has warm_sin" "the experiment momentum is not listed" "slosh, period: 0.979 is marked wrongly" "the-lattice.md is not in the table" 'cites "A sin" of docs/model.md'; do
    bites_once test_pages.sh "$said" "$said"
done
fresh_copy

printf 'int sin;\n' >"$work/copy/src/base/sin.c"
bites test_style.sh "a .c file without an opening comment" "opens with a comment"

awk 'BEGIN { print "/* Long. */"; for (i = 0; i < 600; i++) print "" }' >"$work/copy/src/base/sin.c"
bites test_style.sh "a file of 601 lines" "at most 600"

printf '/* %s: later. */\n' 'TO''DO' >"$work/copy/src/base/sin.c"
bites test_style.sh "unfinished business" "unfinished business"

printf '/* See %s/notes. */\n' '/ho''me/me' >"$work/copy/src/base/sin.c"
bites test_style.sh "a folder of one machine" "names a folder"

((bad == 0)) || exit 1
printf 'every house rule notices its sins\n'

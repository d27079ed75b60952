#!/usr/bin/env bash
# The house style that no compiler checks: every .c file opens with a comment and stays within 600
# lines, none is left unfinished, and nothing names a folder of the machine it was written on.
# Arguments: build folder, source folder.
set -euo pipefail
cd "${2:?usage: test_style.sh BUILD SOURCE}"

most=600
bad=0
complain() {
    printf '%s: %s\n' "$1" "$2"
    bad=$((bad + 1))
}

# The project's own text files, wherever it lies: what git would ship, or all of it without git.
list_files() {
    git ls-files --cached --others --exclude-standard 2>/dev/null ||
        find . -type f -not -path './build/*' -not -path './out/*' -not -path './.git/*' \
            -not -path '*/node_modules/*' -not -path './web/dist/*' -not -path './web/lib/*' |
        sed 's|^\./||'
}
mapfile -t files < <(list_files | grep -E '\.(c|h|md|sh|txt|json|glsl|vert|frag|cmake)$|^\.ci/run$' |
    while IFS= read -r file; do [[ -f $file ]] && printf '%s\n' "$file"; done)

# All files are read at once: a process for each of them would take most of this test's time.
mapfile -t sources < <(printf '%s\n' "${files[@]}" | grep -E '\.[ch]$')
((${#sources[@]} > 0)) || complain . "no source was found to check"
while read -r lines file; do
    ((lines <= most)) || complain "$file" "$lines lines; at most $most, split it"
done < <(wc -l "${sources[@]}" | grep -E '\.[ch]$')
while IFS= read -r file; do
    complain "$file" "a .c file opens with a comment: its one job and its main invariant"
done < <(comm -23 <(printf '%s\n' "${sources[@]}" | grep '\.c$' | sort) \
    <(awk 'FNR == 1 && /^\/\*/ { print FILENAME }' "${sources[@]}" | sort))

# What a newcomer includes names every public header that no other one includes.
said=$(cat include/skvalp/skvalp.h && grep -h '#include "' include/skvalp/*.h)
for header in include/skvalp/*.h; do
    name=skvalp/${header##*/}
    [[ $name == skvalp/skvalp.h || $said == *"$name"* ]] ||
        complain "$header" "is found nowhere: say in include/skvalp/skvalp.h what it is for"
done

# The patterns are written so that they do not find themselves.
while IFS=: read -r file line _; do
    complain "$file:$line" "unfinished business: do it or file an issue"
done < <(grep -nE '\b(TO[D]O|FIX[M]E|XX[X])\b' "${files[@]}" || true)
while IFS=: read -r file line _; do
    complain "$file:$line" "names a folder of one machine"
done < <(grep -nE '(^|[^A-Za-z0-9_.$}])/(hom[e]|wor[k]|roo[t]|User[s])/[A-Za-z0-9]' "${files[@]}" || true)

if ((bad > 0)); then
    printf 'style: %d faults\n' "$bad"
    exit 1
fi
printf 'style: %d sources keep the house style\n' "${#sources[@]}"

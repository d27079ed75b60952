#!/usr/bin/env bash
# The public interface: every function declared SKV_API is defined by the library and called by a
# test, every public header compiles alone as C17 and C++17 and all of them together, and the
# library neither prints nor exits. Reads the symbols of what was built, so that a mention in a comment does not count.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_api.sh BUILD SOURCE}")
cd "${2:?usage: test_api.sh BUILD SOURCE}"

bad=0
complain() {
    printf '%s\n' "$*"
    bad=$((bad + 1))
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# One declaration a line, then the name before its first parenthesis.
cat include/skvalp/*.h | tr '\n' ' ' | sed 's/SKV_API/\n&/g' |
    sed -nE 's/^SKV_API [^;(]*\b(skv_[a-z0-9_]+)\(.*/\1/p' | sort -u >"$work/declared"

mapfile -t libraries < <(find "$build/src" -name '*.a')
mapfile -t objects < <(find "$build/tests" -name '*.o')
((${#libraries[@]})) || complain "no library under $build/src"
((${#objects[@]})) || complain "no test was built under $build/tests"
nm --defined-only "${libraries[@]}" 2>/dev/null | awk '$2 == "T" { print $3 }' |
    sort -u >"$work/defined"
nm --undefined-only "${objects[@]}" 2>/dev/null | awk '$1 == "U" { print $2 }' |
    sort -u >"$work/called"

while read -r name; do
    complain "$name is declared in include/skvalp but not defined by the library"
done < <(comm -23 "$work/declared" "$work/defined")
while read -r name; do
    complain "$name is called by no test"
done < <(comm -23 "$work/declared" "$work/called")

# The library speaks through results only. abort() is the default assert handler.
nm -A --undefined-only "${libraries[@]}" 2>/dev/null |
    awk '$NF ~ /^(v?f?printf|puts|fputs|putchar|perror|exit|_exit|stdout|stderr|__v?f?printf_chk)$/' |
    sed 's/^.*lib/lib/' >"$work/speaks"
while read -r line; do
    complain "the library must not print or exit: $line"
done <"$work/speaks"

for header in include/skvalp/*.h; do
    printf '#include <skvalp/%s>\n' "$(basename "$header")" >"$work/alone.c"
    cp "$work/alone.c" "$work/alone.cc"
    "${CC:-gcc}" -std=c17 -Wall -Wextra -Wpedantic -Werror -Iinclude -fsyntax-only "$work/alone.c" ||
        complain "$header does not compile alone as C17"
    g++ -x c++ -std=c++17 -Wall -Wextra -Wpedantic -Werror -Iinclude -fsyntax-only \
        "$work/alone.cc" || complain "$header does not compile alone as C++17"
done
printf '#include <%s>\n' include/skvalp/*.h | sed 's,include/,,' >"$work/all.c"
"${CC:-gcc}" -std=c17 -Wall -Wextra -Wpedantic -Werror -Iinclude -fsyntax-only "$work/all.c" ||
    complain "the public headers do not compile together"

declared=$(wc -l <"$work/declared")
((declared > 0)) || complain "no public function was found"
((bad == 0)) || exit 1
printf 'api: %d public functions are defined and called by tests\n' "$declared"

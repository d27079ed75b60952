#!/usr/bin/env bash
# The core for Windows, cross-built by mingw-w64 as an archive and as a DLL, and as one file, gives
# the golden hashes in Wine on one thread and on several; the DLL exports what the headers declare.
# The scenes and the programs are not built there: Debian has no jansson and no libpng for mingw-w64.
# Only with SKV_LONG_TESTS=1. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_windows.sh BUILD SOURCE}")
cd "${2:?usage: test_windows.sh BUILD SOURCE}"
if [[ ${SKV_LONG_TESTS:-0} != 1 ]]; then
    printf 'install: Windows is left to SKV_LONG_TESTS=1\n'
    exit
fi
# shellcheck source=tests/install/lib.sh
source tests/install/lib.sh
# shellcheck source=tests/bits/lib.sh
source tests/bits/lib.sh
gcc=x86_64-w64-mingw32-gcc

# An empty Windows of this test's own.
export WINEPREFIX=$work/wine WINEDEBUG=-all
trap 'wineserver-stable -k || true; wineserver-stable -w; rm -rf "$work"' EXIT
windows() {
    wine "$@" 2>"$work/wine.log" | tr -d '\r'
}
windows wineboot --init >/dev/null

folder=$(core windows --toolchain cmake/mingw64.cmake -DSKVALP_SHARED=ON -DSKVALP_WERROR=ON)
ninja -C "$folder" >"$work/log" 2>&1 || complain "the DLL is not built: $(tail -n 3 "$work/log")"
set_is "Windows" sse2 windows "$folder/bits_hashes.exe" best
same_worlds "Windows, 1 thread" "$short_run" windows "$folder/bits_hashes.exe" best 1 "$short_run"
same_worlds "Windows, 3 threads" "$short_run" windows "$folder/bits_hashes.exe" best 3 "$short_run" fast

cp "$folder"/libskvalp-*.dll "$work/"
"$gcc" -DSKVALP_DLL -Iinclude -Itests/bits tests/bits/hashes.c tests/bits/worlds.c \
    "$folder/src/libskvalp.dll.a" -lm -o "$work/with_dll.exe"
same_worlds "Windows, DLL" "$short_run" windows "$work/with_dll.exe" best 2 "$short_run" fast
headers_declare include | sort >"$work/declared"
x86_64-w64-mingw32-objdump -p "$work"/libskvalp-*.dll |
    sed -nE 's/^\t\[ *[0-9]+\].* (skv_[a-z0-9_]+)$/\1/p' | sort -u >"$work/exported"
diff "$work/declared" "$work/exported" >"$work/log" ||
    complain "the DLL exports other functions than the headers declare: $(head -n 5 "$work/log")"

python3 scripts/amalgamate.py "$work/skvalp"
"$gcc" -O2 "-I$work" -Itests/bits tests/bits/hashes.c tests/bits/worlds.c "$work/skvalp/skvalp.c" \
    -lm -o "$work/one_file.exe"
same_worlds "Windows, one file" "$short_run" windows "$work/one_file.exe" best 2 "$short_run"
verdict

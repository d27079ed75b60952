#!/usr/bin/env bash
# The shared library's interface (functions, structures, sizes, enumerators) is the one committed in
# packaging/skvalp.abi. What only adds to it is written down with scripts/update-abi.sh; what breaks
# programs compiled before, too, with a line in CHANGELOG.md.
# Arguments: build folder, source folder; --print before them prints the interface instead.
set -euo pipefail
print=0
if [[ ${1-} == --print ]]; then
    print=1
    shift
fi
build=$(realpath "${1:?usage: test_abi.sh [--print] BUILD SOURCE}")
cd "${2:?usage: test_abi.sh [--print] BUILD SOURCE}"
# shellcheck source=tests/bits/lib.sh
source tests/bits/lib.sh

# The committed one was read on x86-64; sizes differ elsewhere.
if [[ $(uname -m) != x86_64 ]]; then
    printf 'abi: compared on x86-64 only\n'
    exit
fi
folder=$(core abi -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_C_FLAGS=-g -ffile-prefix-map=$PWD=." -DSKVALP_SHARED=ON)
ninja -C "$folder" skvalp_shared >"$folder.log" 2>&1 || {
    tail -n 5 "$folder.log"
    exit 1
}
library=$folder/src/libskvalp.so
# Types that no header defines are the library's own business.
abidw --headers-dir include/skvalp --drop-private-types --type-id-style hash --no-show-locs \
    --no-corpus-path --no-comp-dir-path "$library" >"$folder.abi"
if ((print)); then
    cat "$folder.abi"
    exit
fi
status=0
abidiff --no-show-locs packaging/skvalp.abi "$folder.abi" >"$folder.diff" || status=$?
if ((status & 8)); then
    printf 'abi: programs compiled before would break; if that is meant: %s\n' \
        "scripts/update-abi.sh, and a line in CHANGELOG.md"
elif ((status)); then
    printf 'abi: the interface has changed; write it down with scripts/update-abi.sh\n'
fi
head -n 30 "$folder.diff"
((status == 0)) || exit 1
printf 'abi: %d functions, as in packaging/skvalp.abi\n' \
    "$(grep -c '<elf-symbol .*func-type' packaging/skvalp.abi)"

# Shared by the tests of bit-equality: building the core in all its forms and comparing hashes with
# the golden ones. Sourced, never run; the caller stands in the source folder and has set `build`.
# shellcheck shell=bash disable=SC2034,SC2154

# Frames: hashes are taken after a second, and after a tenth where a machine is slow.
long_run=60
short_run=6

golden=tests/bits/golden.txt
golden_scenes=tests/bits/golden-scenes.txt
# shellcheck source=tests/support/comparing.sh
source tests/support/comparing.sh

# core NAME CMAKE-OPTION...: builds the core and bits_hashes in a folder of their own, which is
# printed. Ends the test if that fails. Configured afresh: a folder of before keeps old flags.
core() {
    local folder=$build/bits/$1 log=$build/bits/$1.log status=0
    shift
    mkdir -p "$build/bits"
    {
        cmake --fresh -S . -B "$folder" -G Ninja -DSKVALP_CORE_ONLY=ON "$@" &&
            ninja -C "$folder" bits_hashes
    } >"$log" 2>&1 || status=$?
    if ((status)); then
        tail -n 20 "$log" >&2
        printf 'building the core with %s failed with status %d\n' "$*" "$status" >&2
        return 1
    fi
    printf '%s' "$folder"
}

# same_worlds WHAT FRAMES COMMAND...: the command must print the golden hashes of so many frames; one that
# ends with "fast" those of the fast solver's worlds. The reference solver has one path for all instruction
# sets and takes half of the time, so one run of each build is enough for it.
same_worlds() {
    local what=$1 frames=$2
    shift 2
    same "$what" <(golden_worlds "$frames" "${@: -1}") "$@"
}

# golden_worlds FRAMES [fast]: their lines.
golden_worlds() {
    awk -v frames="$1" -v fast="${2-}" '$2 == frames && (fast != "fast" || !/reference/)' "$golden"
}

# set_is WHAT EXPECTED COMMAND...: the command must name the expected instruction set as the one in
# use; else the comparison would prove nothing about it.
set_is() {
    local what=$1 expected=$2 found
    shift 2
    found=$("$@" 2>&1) || true
    [[ $found == "$expected" ]] || complain "$what: the instruction set is $found, not $expected"
}

# fused ARCHIVE OBJDUMP: instructions that multiply and add in one.
fused() {
    "$2" -d --no-show-raw-insn "$1" 2>/dev/null |
        awk '$2 ~ /^(vfn?m(add|sub)|fn?m(add|sub)$|fml[as]$)/ { print $2 }' | sort | uniq -c
}

# fuses_nothing ARCHIVE OBJDUMP: there must be none.
fuses_nothing() {
    local line
    while read -r line; do
        complain "$1: rounds once instead of twice: $line"
    done < <(fused "$@")
}

# verdict: the last line of a test.
verdict() {
    if ((bad > 0)); then
        printf 'after a change of the physics on purpose: scripts/update-golden.sh\n'
        exit 1
    fi
    ((compared > 0)) || exit 1
    printf 'bits: %d runs gave the golden hashes\n' "$compared"
}

# Shared by tests that compare what a program prints with what it should: complaints are counted, and
# so are comparisons, for a test that compared nothing has not passed. Sourced, never run.
# shellcheck shell=bash disable=SC2034

compared=0
bad=0

complain() {
    printf '%s\n' "$*"
    bad=$((bad + 1))
}

# same WHAT EXPECTED COMMAND...: the command must print what the file EXPECTED holds.
same() {
    local what=$1 expected=$2 difference
    shift 2
    [[ -s $expected || -p $expected ]] || complain "$what: there is nothing to compare with"
    if difference=$(diff "$expected" <("$@" 2>&1)); then
        compared=$((compared + 1))
        return
    fi
    complain "$what: not as expected (< expected, > here):"
    printf '%s\n' "$difference" | grep '^[<>]' | sort -k2,2 -s | head -n 8
}

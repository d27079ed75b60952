# A copy of the sources, for tests that change or build it. Sourced, never run.
# shellcheck shell=bash

# copy_sources FROM TO: all of them, without what was built or installed. Files are named one by one,
# because other tests may put a file beside them meanwhile: tar takes a folder that changes for a fault.
copy_sources() {
    mkdir -p "$2"
    (cd "$1" && find . \( -path ./.git -o -path ./build -o -path ./out -o -name node_modules \) -prune \
        -o ! -type d -print0 | tar -c --null --files-from - | tar -x -C "$2")
}

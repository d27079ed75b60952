# Shared by the tests of what others install: a folder to work in, fresh projects in it, and what
# their programs must print. Sourced, never run; the caller has set `build` and stands in the source
# folder.
# shellcheck shell=bash disable=SC2034,SC2154

bad=0
checked=0
complain() {
    printf '%s\n' "$*"
    bad=$((bad + 1))
}

compiler=$(sed -n 's/^CMAKE_C_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
# Fresh projects are built as a stranger would, whatever the build was told.
unset CFLAGS LDFLAGS CMAKE_C_COMPILER_LAUNCHER LD_LIBRARY_PATH PKG_CONFIG_PATH
unset CMAKE_PREFIX_PATH CMAKE_BUILD_TYPE

source_folder=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# install_build: the build, installed into a folder of its own, and moved after that.
install_build() {
    cmake --install "$build" --prefix "$work/first" >"$work/log" 2>&1 || {
        tail -n 5 "$work/log"
        exit 1
    }
    mv "$work/first" "$work/prefix"
    prefix=$work/prefix
    export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
}

# expect_output: what hello.c prints with the library as it was built.
expect_output() {
    "$compiler" -Iinclude examples/hello.c "$build/src/libskvalp.a" -lm -pthread \
        -o "$work/hello"
    expected=$("$work/hello")
}

# prints WHAT COMMAND...: the command is hello.c and must print the same.
prints() {
    local what=$1 said
    shift
    checked=$((checked + 1))
    said=$("$@" 2>&1) || true
    [[ $said == "$expected" ]] || complain "$what: prints '$said' instead of '$expected'"
}

# quietly WHAT COMMAND...: the command must succeed; says what it said if it does not.
quietly() {
    local what=$1
    shift
    "$@" >"$work/log" 2>&1 && return
    complain "$what fails:"
    grep -iE -A 3 'error|undefined|not found' "$work/log" | head -n 12 || tail -n 5 "$work/log"
    return 1
}

# project NAME [CMAKE-LINE...] [-- CMAKE-LINE...]: a fresh project of examples/hello.c, with these lines
# before its program and after it.
project() {
    local folder=$work/$1
    shift
    mkdir "$folder"
    cp examples/hello.c "$folder/"
    {
        printf 'cmake_minimum_required(VERSION 3.25)\nproject(fresh C)\n'
        while (($#)) && [[ $1 != -- ]]; do
            printf '%s\n' "$1"
            shift
        done
        printf 'add_executable(hello hello.c)\n'
        printf 'target_link_libraries(hello PRIVATE skvalp::skvalp)\n'
        printf '%s\n' "${@:2}"
    } >"$folder/CMakeLists.txt"
}

# builds NAME CMAKE-OPTION...: configures and builds a project.
builds() {
    local name=$1
    shift
    quietly "$name: configuring" cmake -S "$work/$name" -B "$work/$name/build" -G Ninja \
        -DCMAKE_C_COMPILER="$compiler" "$@" &&
        quietly "$name: building" ninja -C "$work/$name/build"
}

# needs PROGRAM EXTENDED-REGEX: shared libraries that a program is linked with.
needs() {
    readelf -d "$1" | grep -qE "NEEDED.*\[($2)"
}

# headers_declare FOLDER: the functions of the core's headers, those that skvalp.h reaches in this
# include folder, sorted.
headers_declare() {
    local headers
    mapfile -t headers < <(cc -MM "-I$1" "$1/skvalp/skvalp.h" | grep -oE '[^ ]+\.h')
    cat "${headers[@]}" | tr '\n' ' ' | sed 's/SKV_API/\n&/g' |
        sed -nE 's/^SKV_API [^;(]*\b(skv_[a-z0-9_]+)\(.*/\1/p' | sort -u
}

# conclude WORDS: the last line of a test.
conclude() {
    ((bad == 0 && checked > 0)) || exit 1
    printf 'install: %s\n' "$*"
}

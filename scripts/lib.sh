# Shared by run.sh, test.sh and the other scripts: the package lists, installing what is missing,
# configuring and building. Sourced, never run; the caller sets `program` to its own name and has
# changed into the source folder.
#
# Every failure ends in one line on stderr: who, what, why, what to try. Long output goes to
# build/logs/, and to the terminal as well with SKVALP_VERBOSE=1.
# shellcheck shell=bash disable=SC2034,SC2154

# What all but the app is built with, and the app; what they need to run, and what the tests need
# besides. Everything else follows from Debian's own dependencies; recommends are not installed.
packages_library=(gcc libc6-dev cmake ninja-build pkg-config libjansson-dev libpng-dev zlib1g-dev
    libegl-dev libgles-dev)
packages_build=("${packages_library[@]}" libgtk-4-dev libadwaita-1-dev gettext)
# Mesa draws; GTK's icons are SVG files, which need the loader.
packages_run=(libegl1 libgles2 libgl1-mesa-dri adwaita-icon-theme librsvg2-common ffmpeg)
# For the tests of ./test.sh core, of the app, and of the page.
packages_core=(libcmocka-dev libegl1 libgles2 libgl1-mesa-dri ffmpeg imagemagick g++ python3
    libsdl2-dev libchipmunk-dev parallel)
packages_app=(xvfb xauth xdotool xclip imagemagick x11-utils openbox mutter pipewire dbus at-spi2-core
    desktop-file-utils appstream python3)
packages_browser=(chromium chromium-headless-shell ffmpeg)
# What the page is built with; npm brings the newer node that its build takes.
packages_web=(clang-19 lld-19 binaryen wasi-libc libclang-rt-19-dev-wasm32 cmake ninja-build libgles-dev
    nodejs librsvg2-bin)
# Besides, for the long forms: clang, arm64, Debian packages, and Windows.
packages_long=(clang-19 lld-19 gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user file
    lintian gcc-mingw-w64-x86-64 wine64 wine)
packages_fuzz=(clang-19 libclang-rt-19-dev zlib1g-dev)
packages_lint=(clang-19 clang-format-19 clang-tidy-19 shellcheck doxygen python3)

logs=build/logs
progress_seconds=30 # between two lines that say how far a long command has come

say() {
    printf '%s\n' "$*"
}

die() {
    printf '%s: %s\n' "$program" "$*" >&2
    exit 1
}

# elapsed: the time since the script started, as "1 min 5 s".
elapsed() {
    if ((SECONDS < 60)); then
        printf '%d s' "$SECONDS"
    else
        printf '%d min %d s' $((SECONDS / 60)) $((SECONDS % 60))
    fi
}

# require_writable FOLDER...: what somebody else has built here, root for example, can't be built on.
require_writable() {
    local folder
    for folder in "$@"; do
        [[ ! -e $folder || -w $folder ]] ||
            die "$PWD/$folder belongs to $(stat -c %U "$folder") and cannot be written; go on as" \
                "that user, or make it yours: sudo chown -R $(id -un) $PWD/${folder%%/*}"
    done
}

# logged NAME COMMAND...: runs the command with its output in build/logs/NAME.log.
logged() {
    local log=$logs/$1.log
    shift
    mkdir -p "$logs"
    if [[ ${SKVALP_VERBOSE:-0} == 1 ]]; then
        "$@" 2>&1 | tee "$log"
    else
        "$@" >"$log" 2>&1
    fi
}

# watched NAME COMMAND...: the same, and says from time to time how far ninja or ctest has come.
watched() {
    local log=$logs/$1.log worker next=$((SECONDS + progress_seconds)) far status=0
    logged "$@" &
    worker=$!
    while kill -0 "$worker" 2>/dev/null; do
        sleep 0.5
        ((SECONDS >= next)) || continue
        next=$((SECONDS + progress_seconds))
        far=$(grep -oE '^(\[[0-9]+/[0-9]+\]|[ 0-9]+/[0-9]+ )' "$log" | tail -n 1 | tr -d ' []' || true)
        [[ -z $far || ${SKVALP_VERBOSE:-0} == 1 ]] || say "  ${far/\// of } ($(elapsed))"
    done
    wait "$worker" || status=$?
    return "$status"
}

# reason NAME: the line of a log that says most about why the command failed.
reason() {
    local log=$logs/$1.log line
    line=$(grep -m1 -E '(^E: |: (fatal )?error: |CMake Error|undefined reference|No space left|failed, reason: )' \
        "$log" 2>/dev/null || tail -n 1 "$log" 2>/dev/null || true)
    # CMake puts its message on the lines that follow.
    if [[ $line == 'CMake Error'* ]]; then
        line+=$(grep -A4 -m1 'CMake Error' "$log" | tail -n +2 | tr -s ' \n' ' ')
    fi
    printf '%s' "${line:0:300}"
}

missing_packages() {
    local package
    for package in "$@"; do
        [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] ||
            printf '%s\n' "$package"
    done
}

# install_packages PACKAGE...: installs those that are missing; asks nothing of the network, nor for
# any right, when none is.
install_packages() {
    local missing=() as_root=()
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "$program: this is no Debian system; going on with what is installed (wanted: $*)"
        return
    fi
    mapfile -t missing < <(missing_packages "$@")
    ((${#missing[@]})) || return 0
    if ((EUID != 0)); then
        command -v sudo >/dev/null ||
            die "installing packages needs root or sudo; as root: apt-get install ${missing[*]}"
        as_root=(sudo)
    fi
    say "Installing ${#missing[@]} package(s) with what they depend on: ${missing[*]}"
    # Another installation may hold apt's lock for some minutes.
    as_root+=(env DEBIAN_FRONTEND=noninteractive apt-get -qy -o DPkg::Lock::Timeout=600)
    # Lists may be absent or stale; a failure here shows in the installation, if it matters.
    logged apt-update "${as_root[@]}" update || true
    logged apt-install "${as_root[@]}" install --no-install-recommends "${missing[@]}" ||
        die "installing packages failed: $(reason apt-install); try: apt-get update" \
            "(all of it in $logs/apt-install.log)"
}

# Where npm puts the newer node that the page's build takes, beside its other programs.
newer_node=$PWD/web/node/node_modules/.bin
page_programs=$newer_node:$PWD/web/node_modules/.bin

# install_npm_folder FOLDER: its npm packages, as its package-lock.json has them byte by byte, if they
# are not there yet.
install_npm_folder() {
    local stamp=$1/node_modules/.package-lock.json
    [[ ! -e $stamp || $stamp -ot $1/package-lock.json ]] || return 0
    say "Installing the npm packages of $1/"
    PATH=$newer_node:$PATH logged npm npm ci --prefix "$1" --ignore-scripts --no-audit --no-fund && return
    rm -f "$stamp"
    return 1
}

# install_npm: the npm packages of web/, after the node that they ask for, which is a package, too. Says
# what failed and returns 1 if they cannot be had.
install_npm() {
    # The npm of whoever has installed a newer node comes with it.
    command -v npm >/dev/null || install_packages npm
    install_npm_folder web/node && install_npm_folder web && return
    printf '%s: installing npm packages failed: %s (all of it in %s)\n' "$program" "$(reason npm)" \
        "$logs/npm.log" >&2
    return 1
}

# For a build folder that is made new. Warnings of compilers we do not know must not stop a user;
# .ci/run sets SKVALP_WERROR.
fresh_options=(-DSKVALP_WERROR=OFF)

# configure PRESET [CMAKE-OPTION...]: makes or refreshes build/PRESET. An existing folder keeps its
# settings, so that the same folder can serve run.sh, test.sh and a developer without rebuilding.
configure() {
    local preset=$1 log=configure-$1
    shift
    if [[ -n ${SKVALP_WERROR:-} ]]; then
        set -- "$@" "-DSKVALP_WERROR=$SKVALP_WERROR"
    fi
    if [[ -f build/$preset/build.ninja ]] &&
        logged "$log" cmake "$@" "build/$preset"; then
        return
    fi
    logged "$log" cmake --preset "$preset" --fresh "${fresh_options[@]}" "$@"
}

# build PRESET [TARGET...]: builds all, or the targets, in build/PRESET.
build() {
    local preset=$1 log=build-$1
    shift
    watched "$log" ninja -C "build/$preset" "$@"
}

# choose_build ["$@"]: for scripts that measure with a build. Sets `build` to the first argument, or
# to build/release, and `chosen` to how many arguments that took; --help ends with the caller's usage.
choose_build() {
    build=build/release
    chosen=0
    case ${1-} in
    -h | --help)
        usage
        exit
        ;;
    '' | --*) ;;
    *)
        build=$1
        chosen=1
        ;;
    esac
    [[ -x $build/skvalp ]] || die "$build/skvalp is not there; build it with: ./run.sh build"
}

# replace_in_page PAGE NAME FILE: puts the file in place of what stands between the page's marks
# "NAME: begin" and "NAME: end".
replace_in_page() {
    local page=$1 name=$2 file=$3
    local mark
    for mark in begin end; do
        grep -q "^<!-- $name: $mark -->\$" "$page" || die "$page has lost its mark <!-- $name: $mark -->"
    done
    awk -v file="$file" -v name="$name" '
        $0 == "<!-- " name ": end -->" { inside = 0 }
        !inside { print }
        $0 == "<!-- " name ": begin -->" {
            inside = 1
            print ""
            while ((getline line < file) > 0)
                print line
            print ""
        }' "$page" >"$page.new"
    mv "$page.new" "$page"
}

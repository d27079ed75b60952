#!/usr/bin/env bash
# The Debian packages have no errors that lintian finds, and a fresh project is built and run with
# what is in them; the core's package needs nothing but the C library. Only with SKV_LONG_TESTS=1.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_debs.sh BUILD SOURCE}")
cd "${2:?usage: test_debs.sh BUILD SOURCE}"
if [[ ${SKV_LONG_TESTS:-0} != 1 ]]; then
    printf 'install: the Debian packages are left to SKV_LONG_TESTS=1\n'
    exit
fi
# shellcheck source=tests/install/lib.sh
source tests/install/lib.sh
expect_output

quietly "scripts/package.sh" scripts/package.sh "$build/package" || exit 1
debs=("$build"/package/*.deb)
((${#debs[@]} == 4)) || complain "not four packages but: ${debs[*]}"
lintian --profile debian --fail-on error "${debs[@]}" >"$work/lintian" 2>&1 ||
    complain "lintian: $(grep "^E:" "$work/lintian" || cat "$work/lintian")"
for deb in "${debs[@]}"; do
    dpkg-deb --extract "$deb" "$work/root"
done
needed=$(dpkg-deb --field "$build"/package/libskvalp0_*.deb Depends)
[[ $needed =~ ^libc6\ [^,]*$ ]] || complain "libskvalp0 depends on more than libc6: $needed"

# Found as if / were there.
libraries=$(dirname "$(find "$work/root" -name libskvalp.so)")
project debian 'find_package(skvalp CONFIG REQUIRED COMPONENTS shared)'
if builds debian -DCMAKE_PREFIX_PATH="$work/root/usr" \
    -DCMAKE_LIBRARY_ARCHITECTURE="$(basename "$libraries")"; then
    prints "the packages' library" "$work/debian/build/hello"
fi
[[ $("$work/root/usr/bin/skvalp" --version) == *"$(cut -d " " -f 2 <<<"${expected%%:*}")"* ]] ||
    complain "the packages' skvalp names another version"
for file in applications/org.skvalp.Play.desktop metainfo/org.skvalp.Play.metainfo.xml \
    icons/hicolor/scalable/apps/org.skvalp.Play.svg man/man1/skvalp-play.1.gz man/man1/skvalp.1.gz; do
    [[ -f $work/root/usr/share/$file ]] || complain "no package holds $file"
done
conclude "four Debian packages without a lintian error"

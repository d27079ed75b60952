#!/usr/bin/env bash
# run.sh and test.sh explain themselves and say in one line what failed; installing asks the network
# for nothing that is there. apt-get and dpkg-query are stand-ins here. Arguments: build folder,
# source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_scripts.sh BUILD SOURCE}")
cd "${2:?usage: test_scripts.sh BUILD SOURCE}"

bad=0
complain() {
    printf '%s\n' "$*"
    bad=$((bad + 1))
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"
# Installed is what stands in the file `installed`; apt-get notes its calls and fails on demand.
cat >"$work/bin/dpkg-query" <<END
#!/bin/sh
for package; do :; done
grep -qx "\$package" "$work/installed" && printf installed
END
cat >"$work/bin/apt-get" <<END
#!/bin/sh
echo "\$*" >>"$work/calls"
echo "E: Unable to fetch some archives"
exit "\$(cat "$work/apt-status")"
END
# sudo without a right to ask for.
printf '#!/bin/sh\nexec "$@"\n' >"$work/bin/sudo"
chmod +x "$work/bin/"*

# install PACKAGE...: install_packages of lib.sh with the stand-ins, in a folder of its own.
install() {
    : >"$work/calls"
    (
        cd "$work"
        PATH=$work/bin:$PATH bash -c 'set -euo pipefail; program=try.sh; source "$0"
            install_packages "$@"' "$OLDPWD/scripts/lib.sh" "$@" >"$work/out" 2>"$work/err"
    )
}

# expect WHAT CONDITION...: a shell test.
expect() {
    local what=$1
    shift
    "$@" || complain "$what: $(head -n 2 "$work/out" "$work/err" 2>/dev/null | tr '\n' ' ')"
}

printf 'one\ntwo\n' >"$work/installed"
echo 0 >"$work/apt-status"
expect "installed packages install" install one two
expect "apt-get is not called when nothing is missing" test ! -s "$work/calls"
expect "one missing package installs" install one two three
expect "only what is missing is installed" grep -q 'install .* three$' "$work/calls"
expect "apt-get waits for a lock" grep -q -- '-o DPkg::Lock::Timeout=[1-9]' "$work/calls"
expect "the installed are left alone" test -z "$(grep 'install .*one' "$work/calls")"
expect "the user is told" grep -q 'Installing 1 package' "$work/out"

echo 100 >"$work/apt-status"
status=0
install three || status=$?
expect "a failing apt-get fails" test "$status" -eq 1
expect "one line says so" test "$(wc -l <"$work/err")" -eq 1
expect "the line says what, why and what to try" grep -q \
    '^try.sh: installing packages failed: E: Unable to fetch some archives; try: apt-get update' \
    "$work/err"

# npm's last line names a log of its own: what went wrong stands above.
cat >"$work/bin/npm" <<END
#!/bin/sh
echo "npm ERR! code ENOTFOUND"
echo "npm ERR! request to https://registry.example/pako failed, reason: getaddrinfo ENOTFOUND"
echo "npm ERR!     /root/.npm/_logs/debug-0.log"
exit 1
END
chmod +x "$work/bin/npm"
mkdir "$work/web"
status=0
(
    cd "$work"
    PATH=$work/bin:$PATH bash -c 'set -euo pipefail; program=try.sh; source "$0"; install_npm' \
        "$OLDPWD/scripts/lib.sh" >"$work/out" 2>"$work/err"
) || status=$?
expect "a failing npm fails" test "$status" -eq 1
expect "the line says what npm missed" grep -q \
    '^try.sh: installing npm packages failed: .* failed, reason: getaddrinfo ENOTFOUND (' "$work/err"

# A registry that fails: the page's tests are skipped, in one line and in the count. What builds and runs
# tests are stand-ins, too.
mkdir -p "$work/clone/scripts"
cp test.sh "$work/clone"
cp scripts/lib.sh "$work/clone/scripts"
for tool in cmake ninja; do
    printf '#!/bin/sh\n' >"$work/bin/$tool"
done
cat >"$work/bin/ctest" <<END
#!/bin/sh
case "\$*" in
*--show-only*) echo "Total Tests: 13" ;;
*) echo "\$*" >>"$work/tested"; echo "100% tests passed, 0 tests failed out of 20" ;;
esac
END
chmod +x "$work/bin/"*
printf '#!/bin/sh\nprintf installed\n' >"$work/bin/dpkg-query"
tested() {
    : >"$work/tested"
    (cd "$work/clone" && env -u SKV_LONG_TESTS PATH="$work/bin:$PATH" ./test.sh "$@") >"$work/out" 2>"$work/err"
}
expect "all but the page is tested without a registry" tested
expect "the skipped are counted" test "$(tail -n 1 "$work/out")" = "40 passed, 0 failed, 13 skipped"
expect "one line says what is skipped" test "$(grep -c skipped "$work/out")" -eq 2
expect "the page is not tried" grep -qF 'label-regex ^(solver|world|scene|session|render|cli|house|app|web)$ --exclude-regex ^web/' "$work/tested"
! tested web || complain "./test.sh web passes without a registry"
expect "a label's tests alone are run" tested scene cli
expect "ctest knows their labels" grep -qF 'label-regex ^(scene|cli)$' "$work/tested"
expect "the last line counts" test "$(tail -n 1 "$work/out")" = "20 passed, 0 failed"

for script in run.sh test.sh scripts/lint.sh scripts/try-in-chroot.sh; do
    "./$script" --help >"$work/out" 2>"$work/err" || complain "$script --help fails"
    expect "$script --help explains" grep -q "^Usage: " "$work/out"
    expect "$script --help has no errors" test ! -s "$work/err"
done
for script in run.sh test.sh scripts/lint.sh; do
    status=0
    "./$script" --no-such-thing >"$work/out" 2>"$work/err" || status=$?
    expect "$script refuses an unknown option" test "$status" -eq 1
    expect "$script says so in one line" test "$(wc -l <"$work/err")" -eq 1
    expect "$script points to --help" grep -q -- '--help' "$work/err"
done

# What another user has built: one line with the remedy.
mkdir -p "$work/theirs/build"
chmod 755 "$work"
chmod 555 "$work/theirs/build"
as_user=()
((EUID != 0)) || as_user=(setpriv --reuid 65534 --regid 65534 --clear-groups)
status=0
(cd "$work/theirs" && "${as_user[@]}" bash -c 'program=try.sh; source /dev/stdin
    require_writable . build build/*' <"$OLDPWD/scripts/lib.sh") >"$work/out" 2>"$work/err" ||
    status=$?
expect "a build of somebody else's ends the script" test "$status" -eq 1
expect "one line says so" test "$(wc -l <"$work/err")" -eq 1
expect "the line says whose it is and what to do" grep -qE \
    "^try.sh: .*/theirs(/\.|/build)? belongs to $(id -un) .*sudo chown -R .*/theirs" "$work/err"

# What takes long says how far it has come, and keeps its status.
status=0
(
    cd "$work"
    bash -c 'program=try.sh; source "$0"; progress_seconds=1
        watched slow sh -c "echo \"[7/9] a.c.o\"; sleep 2.5; exit 5"' "$OLDPWD/scripts/lib.sh"
) >"$work/out" 2>"$work/err" || status=$?
expect "a watched command keeps its status" test "$status" -eq 5
expect "it says how far it has come" grep -q '^  7 of 9 (' "$work/out"

# A display that does not answer: one line and a status of its own, by which run.sh falls back.
if [[ -x $build/skvalp-play ]]; then
    status=0
    env -u WAYLAND_DISPLAY DISPLAY=:54321 "$build/skvalp-play" pool >"$work/out" 2>"$work/err" ||
        status=$?
    expect "a dead display is told by the status" test "$status" -eq 3
    expect "one line says so" test "$(wc -l <"$work/err")" -eq 1
    expect "the line names it" grep -q '^skvalp-play: no answer from the display :54321; ' "$work/err"
fi

((bad == 0)) || exit 1
printf 'scripts: they explain themselves and install only what is missing\n'

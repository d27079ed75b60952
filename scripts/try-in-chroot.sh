#!/usr/bin/env bash
# Proves the two commands of the README on a bare Debian 12: makes one with debootstrap, clones what
# is committed into it, and runs ./run.sh build, ./run.sh (no display there) and ./test.sh inside;
# then once more without a network, because installed means installed.
set -euo pipefail

program=try-in-chroot.sh
usage() {
    cat <<END
Usage: scripts/try-in-chroot.sh [--keep] FOLDER [COMMAND...]
Makes a bare Debian 12 in FOLDER (about 2 GB with everything installed) and tries the committed
state of this repository in it. Needs root, debootstrap and git. Removes FOLDER when all went well,
unless --keep is given; an existing FOLDER made by an earlier try is used again. With a COMMAND,
only that is run, in the clone. DEBIAN_MIRROR: where packages come from.
END
}

die() {
    printf '%s: %s\n' "$program" "$*" >&2
    exit 1
}

keep=0
case ${1-} in
-h | --help | '')
    usage
    exit
    ;;
--keep)
    keep=1
    shift
    ;;
esac
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
root=$(realpath -m "${1:?a folder}")
shift
((EUID == 0)) || die "needs root"
command -v debootstrap >/dev/null || die "debootstrap is missing; try: apt-get install debootstrap"

# inside SHELL-COMMAND: runs it in the clone, in namespaces of its own, so that mounts and processes
# end with it. No display is passed on.
inside() {
    # shellcheck disable=SC2016
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root TERM=dumb LC_ALL=C.UTF-8 \
        unshare --mount --pid --fork ${network:+--net} bash -c '
            set -e
            mount -t proc proc "$0/proc"
            mount --rbind /dev "$0/dev"
            exec chroot "$0" bash -c "cd /skvalp && $1"' "$root" "$1" </dev/null
}

if [[ ! -x $root/bin/bash ]]; then
    debootstrap --variant=minbase bookworm "$root" "${DEBIAN_MIRROR:-http://deb.debian.org/debian}"
fi
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
# What every installed system knows and debootstrap leaves to whoever runs it.
[[ -e $root/etc/hosts ]] || printf '127.0.0.1 localhost\n' >"$root/etc/hosts"
rm -rf "$root/skvalp"
git clone -q --no-hardlinks "$source" "$root/skvalp"

network=
if (($#)); then
    inside "$*"
    exit
fi
inside './run.sh build'
inside './run.sh && ls -l out'
inside './test.sh'
network=none
say_offline='echo "Without a network:"'
inside "$say_offline && ./run.sh build && ./test.sh core"
((keep)) || rm -rf --one-file-system "$root"

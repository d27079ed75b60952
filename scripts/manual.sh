#!/usr/bin/env bash
# Makes the manual: the public headers and the pages of docs/, as HTML.
set -euo pipefail

program=manual.sh
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/lib.sh
source scripts/lib.sh

case ${1-} in
'') ;;
-h | --help)
    say "Usage: scripts/manual.sh    writes build/manual/html/index.html"
    exit
    ;;
*)
    die "unknown argument $1; try: scripts/manual.sh --help"
    ;;
esac

install_packages doxygen
mkdir -p build
logged manual doxygen docs/Doxyfile ||
    die "doxygen has something to say: $(grep -m 1 -E "warning|error" "$logs/manual.log")"
say "Written: build/manual/html/index.html"

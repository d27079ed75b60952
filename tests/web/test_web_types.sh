#!/usr/bin/env bash
# The host's side fits the interface that the headers have: TypeScript finds nothing wrong in web/src
# and web/page.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_web_types.sh BUILD SOURCE}")
cd "${2:?usage: test_web_types.sh BUILD SOURCE}"
# shellcheck source=tests/web/lib.sh
source tests/web/lib.sh
make_modules

cat >"$modules/tsconfig.json" <<END
{
    "extends": "$PWD/web/tsconfig.json",
    "compilerOptions": {
        "rootDirs": ["$PWD/web/src", "$modules"],
        "typeRoots": ["$PWD/web/node_modules/@types"]
    },
    "include": ["$PWD/web/src", "$PWD/web/page", "$PWD/web/vite.config.ts"]
}
END
web/node_modules/.bin/tsc -p "$modules/tsconfig.json"
printf 'web: the types fit\n'

#!/usr/bin/env bash
# What npm fetches is what a lock file holds: each package has its hash there, and none runs a script of its own
# that could fetch more, but the bundlers that tests try. Arguments: build folder, source folder.
set -euo pipefail
cd "${2:?usage: test_locks.sh BUILD SOURCE}"

python3 - <<'END'
import json, pathlib, sys
manifests = [path.with_name("package.json") for path in pathlib.Path(".").rglob("package-lock.json")
             if "node_modules" not in path.parts and "build" not in path.parts]
bad, held = [], 0
for manifest in manifests:
    lock = json.loads(manifest.with_name("package-lock.json").read_text())["packages"]
    packages = {name: one for name, one in lock.items() if name and not one.get("link")}
    held += len(packages)
    bad += [f"{manifest.parent}: {name} has no hash: npm install it anew" for name, one in packages.items()
            if not one.get("integrity", "").startswith("sha512-")]
    if manifest.parent != pathlib.Path("tests/web/bundlers"):
        bad += [f"{manifest.parent}: {name} runs a script as it is installed: take one that needs none"
                for name, one in packages.items() if one.get("hasInstallScript")]
    wanted = json.loads(manifest.read_text())
    bad += [f"{manifest}: {name} is {version}: pin it" for kind in ("dependencies", "devDependencies", "optionalDependencies")
            for name, version in wanted.get(kind, {}).items() if not version[0].isdigit() and not version.startswith("file:")]
if len(manifests) < 3:
    bad.append(f"only {len(manifests)} lock files")
if bad:
    sys.exit("\n".join(bad))
print(f"locks: {held} packages of {len(manifests)} lock files have their hashes")
END

#!/usr/bin/env bash
# The npm package: packed, installed into a fresh project, its README's example run there and its types
# checked. Views that are stale and what was destroyed throw. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_web_package.sh BUILD SOURCE}")
cd "${2:?usage: test_web_package.sh BUILD SOURCE}"
# shellcheck source=tests/web/lib.sh
source tests/web/lib.sh
make_modules

source=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unpack_package "$work"
cmp -s LICENSE "$work/project/node_modules/skvalp/LICENSE" || complain "the package has no licence"

cd "$work/project"
printf '{ "type": "module" }\n' >package.json
awk '/^```/ { inside = $0 == "```js"; next } inside' "$work/web/README.md" >example.js
hash=$("$build/skvalp" run dam-break --particles 1000 --law clavet --seconds 1 --json |
    sed -n 's/.*"hash": *"\([0-9a-f]*\)".*/\1/p')
node example.js >out
grep -q "hash $hash\$" out || complain "the README's example says '$(cat out)', natively the hash is $hash"

cat >stale.js <<'END'
import { open, SkvalpError } from 'skvalp';
import assert from 'node:assert';

const skvalp = await open({ threads: 2 });
assert(skvalp.scenes.includes('dam-break'));
assert.throws(() => skvalp.scene('no such scene'), SkvalpError);
assert.throws(() => skvalp.scene('pool', { particles: -1 }), { message: /^particles: / });
assert.throws(() => skvalp.scene('pool', { settings: { 'gravity.y': 'up' } }), { message: /^gravity\.y: / });
const world = skvalp.scene('pool', { particles: 200 }).world();
const particles = world.particles();
assert.equal(particles.x.length, particles.count);
world.step();
assert.throws(() => particles.x, /moved on/);
const later = world.particles();
world.destroy();
world.destroy();
assert.throws(() => later.vy, /destroyed/);
assert.throws(() => world.step(), /destroyed/);
// The fluid goes where gravity points to.
const tilted = skvalp.scene('dam-break', { particles: 200 }).world();
const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
const means = ({ x, y, vx, vy }) => [x, y, vx, vy].map(mean);
const before = means(tilted.particles());
tilted.setGravity(9.81, 0);
for (let i = 0; i < 6; i++) {
    tilted.step();
}
const [x, y, vx, vy] = means(tilted.particles()).map((now, i) => now - before[i]);
assert(vx > 0.5 && Math.abs(vy) < vx / 4, `it goes (${vx}, ${vy}) m/s`);
assert(x > 0.03 && Math.abs(y) < x / 4, `it has gone (${x}, ${y}) m`);
// What nobody destroyed is told of once it is collected; what was destroyed is not.
const warned = [];
console.warn = (text) => warned.push(text);
skvalp.scene('pool', { particles: 200 });
for (let i = 0; i < 1000 && warned.length === 0; i++) {
    globalThis.gc();
    await new Promise((resolve) => setTimeout(resolve, 10));
}
assert.match(warned.join(), /a scene was left without destroy/);
assert.doesNotMatch(warned.join(), /world/);
await skvalp.end();
END
node --expose-gc stale.js || complain "stale.js failed"
cat >typed.ts <<'END'
import { open, World } from 'skvalp';
const world: World = (await open()).scene('pool').world();
const x: Float32Array = world.particles().x;
// @ts-expect-error a number is wanted
world.step('fast');
export { x };
END
node "$work/web/node_modules/typescript/bin/tsc" --noEmit --strict --target es2022 --module nodenext \
    --moduleResolution nodenext --lib es2024,dom,dom.iterable typed.ts >types.log 2>&1 || complain "types: $(head -n 3 types.log)"
cd "$source"
in_chromium package.js "$work/project/node_modules/skvalp/lib" >"$work/shown"
grep -qx "$hash" "$work/shown" || complain "in a browser the hash is $(cat "$work/shown"), natively $hash"
((bad == 0)) || exit 1
printf 'web: the package works in a fresh project\n'

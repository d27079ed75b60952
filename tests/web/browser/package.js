// The npm package's lib/ in a browser, without a build step: prints the hash of a world as node has it.
// Arguments: the folder lib.
import { run } from './harness.js';

await run([process.argv[2]], async (browser) => {
    const page = await browser.open('/empty.html');
    console.log(await page.evaluate(async () => {
        const { open } = await import('/skvalp.js');
        const skvalp = await open();
        const world = skvalp.scene('dam-break', { particles: 1000, settings: { 'fluid.law': 'clavet' } }).world();
        for (let i = 0; i < 60; i++) {
            world.step();
        }
        return world.hash;
    }));
});

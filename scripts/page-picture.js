// Takes a picture of the page on a phone held across: see pictures.sh. Arguments: the folder of the built page, the
// picture, the link's text after the "#".
import { begin, until } from '../tests/web/browser/people.js';
import { run } from '../tests/web/browser/harness.js';

const [folder, picture, link] = process.argv.slice(2);

await run([folder], async (browser) => {
    const phone = { width: 760, height: 420, touch: true, isolated: true, ratio: 1.3 };
    const page = await begin(browser, phone, `#${link}`);
    await until(page, () => window.skvalp.state.value.moment > 240, 'the basins fill');
    await page.evaluate(() => window.skvalp.simulation.setPaused(true));
    await until(page, () => window.skvalp.state.value.paused, 'it stops');
    await page.screenshot({ path: picture });
});

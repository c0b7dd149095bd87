// SPDX-License-Identifier: MIT
// node hour.mjs CHROMIUM FOLDER: tests the page of an hour of soccer: its size, and that the user can go to each part of it. Prints how long the page
// takes to open, and how long frames take while the user drags; these times are not tested, as they depend on the load of the machine.
import { strict as assert } from 'node:assert';
import { statSync } from 'node:fs';
import { join } from 'node:path';
import { Situations } from './situations.mjs';

const [program, folder] = process.argv.slice(2);
const all = await Situations.open(program, folder);
const bytes = statSync(join(folder, 'hour.html')).size;
const frame = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const where = (page) => page.locator('.where').textContent();
const time = async (page) => parseFloat(await where(page));

await all.run('an hour of soccer is one page that is opened and scrubbed', 'hour', { viewport: { width: 1366, height: 768 } }, async (page) => {
  assert.ok(bytes < 20e6, `${bytes} bytes`);
  await page.waitForSelector('#scrub[aria-valuetext]');
  const opened = await page.evaluate(() => performance.now());
  await page.locator('#timeline').evaluate((section) => section.scrollIntoView());
  await page.locator('#scrub').focus();
  await page.keyboard.press('End');
  await frame(page);
  assert.match(await where(page), /^3600\.000 s, after event 1,\d\d\d,\d\d\d of 1,\d\d\d,\d\d\d: /);
  const { x, y, width } = await page.locator('#scrub').boundingBox();
  // Click at each tenth of the hour.
  for (let part = 1; part < 10; ++part) {
    await page.mouse.click(x + (width * part) / 10, y + 60);
    await frame(page);
    assert.ok(Math.abs((await time(page)) - 360 * part) < 20, `${await where(page)} at ${part} tenths`);
    assert.ok((await page.locator('#moment h4:text-is("Runs") + ul > li').count()) > 0);
  }
  // Drag from end to end.
  await page.evaluate(() => {
    const frames = (globalThis.frames = []);
    let last = performance.now();
    const next = (now) => {
      frames.push(now - last);
      last = now;
      requestAnimationFrame(next);
    };
    requestAnimationFrame(next);
  });
  await page.mouse.move(x + 1, y + 60);
  await page.mouse.down();
  const seen = [];
  for (let step = 1; step <= 100; ++step) {
    await page.mouse.move(x + (width * step) / 101, y + 60);
    if (step % 10 === 0) seen.push(await time(page));
  }
  await page.mouse.up();
  await frame(page);
  assert.deepEqual(seen, [...seen].sort((a, b) => a - b));
  assert.ok((await time(page)) > 3540);
  const frames = (await page.evaluate(() => globalThis.frames)).sort((a, b) => a - b);
  await all.shot(page, 'hour');
  const at = (part) => Math.round(frames[Math.floor((frames.length - 1) * part)]);
  console.log(`${(bytes / 1e6).toFixed(1)} MB, opened in ${Math.round(opened)} ms; dragged from end to end, half of ${frames.length} frames within ${at(0.5)} ms, 99 % within ${at(0.99)} ms, the longest ${at(1)} ms`);
});
await all.end();

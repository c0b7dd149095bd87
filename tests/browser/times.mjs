// SPDX-License-Identifier: MIT
// node times.mjs CHROMIUM PAGE: prints how many milliseconds it takes to paint the page, to answer a search and to zoom the picture; medians of five.
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const [program, file] = process.argv.slice(2);
const browser = await chromium.launch({ executablePath: program, args: ['--no-sandbox'] });
const frame = (act) => `new Promise((done) => { const from = performance.now(); ${act}; requestAnimationFrame(() => setTimeout(() => done(performance.now() - from))); })`;
const rows = [];
for (let i = 0; i < 5; ++i) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
  await page.goto(pathToFileURL(file).href, { waitUntil: 'load' });
  const painted = await page.evaluate(() => new Promise((done) => {
    new PerformanceObserver((list) => done(Math.max(performance.timing.loadEventEnd - performance.timing.navigationStart, ...list.getEntries().map((each) => each.startTime))))
      .observe({ type: 'largest-contentful-paint', buffered: true });
  }));
  const searched = await page.evaluate(frame("const input = document.getElementById('search'); input.value = 'walk'; input.dispatchEvent(new Event('input'))"));
  const zoomed = await page.evaluate(frame("document.querySelector('.tools button').click()"));
  rows.push([painted, searched, zoomed]);
  await page.close();
}
await browser.close();
const median = (column) => rows.map((row) => row[column]).sort((a, b) => a - b)[2];
console.log([0, 1, 2].map((column) => Math.round(median(column))).join(' | '));

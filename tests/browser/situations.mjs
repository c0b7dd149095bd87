// SPDX-License-Identifier: MIT
// Shared by the tests in a browser: each situation has its own page, which may log nothing and may request nothing but itself.
import { strict as assert } from 'node:assert';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** Set by `./test --long`: tests each page in both color schemes, and prints some as PDF. */
export const isLong = process.env.DIRECTOR_LONG !== undefined;

/** Saves a screenshot for people, `folder/name.png`, with `./test --long` or DIRECTOR_SCREENSHOTS=1. */
export async function screenshot(page, folder, name) {
  if (isLong || process.env.DIRECTOR_SCREENSHOTS) await page.screenshot({ path: join(folder, `${name}.png`) });
}

export class Situations {
  failed = 0;

  /** `folder`: of the pages; screenshots are saved there too, those of failed situations always. */
  static async open(program, folder) {
    const out = new Situations();
    out.folder = folder;
    out.browser = await chromium.launch({ executablePath: program, args: ['--no-sandbox'], timeout: 0 });
    return out;
  }

  /** Runs a situation with the page `name`. If `act` calls check(), `options` must have `bypassCSP`, to inject axe. */
  async run(title, name, options, act) {
    const context = await this.browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
    context.setDefaultTimeout(0); // no timeout, so that no test fails on a busy machine; ctest ends a test that waits forever
    const page = await context.newPage();
    const said = [];
    const late = setTimeout(() => console.log(`still in: ${title} (${name})`), 100000);
    const address = pathToFileURL(join(this.folder, `${name}.html`)).href;
    page.on('console', (message) => said.push(`console: ${message.text()}`));
    page.on('pageerror', (error) => said.push(`error: ${error.message}`));
    page.on('request', (request) => request.url().split('#')[0] === address || said.push(`request: ${request.url()}`));
    try {
      await page.goto(address);
      await act(page, said);
      assert.deepEqual(said, []);
      console.log(`ok ${title} (${name})`);
    } catch (error) {
      ++this.failed;
      console.log(`not ok ${title} (${name}): ${error.message}`);
      await page.screenshot({ path: join(this.folder, `failed_${this.failed}.png`) });
    }
    await context.close();
    clearTimeout(late);
  }

  shot(page, name) {
    return screenshot(page, this.folder, name);
  }

  async end() {
    await this.browser.close();
    process.exit(this.failed === 0 ? 0 : 1);
  }
}

/** Waits until the position of an element is stable: sections above it get a layout only when they enter the viewport, which moves the element. */
export async function comeToRest(locator) {
  await locator.evaluate(async (element) => {
    let last = NaN;
    for (let frames = 0; frames < 3; ) {
      await new Promise((done) => requestAnimationFrame(done));
      const { top } = element.getBoundingClientRect();
      frames = top === last ? frames + 1 : 0;
      last = top;
    }
  });
}

/** Clicks an element when its position is stable. */
export async function click(locator) {
  await locator.scrollIntoViewIfNeeded();
  await comeToRest(locator);
  await locator.click();
}

export async function check(page) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }));
  assert.deepEqual(violations.map((each) => `${each.id}: ${each.nodes.slice(0, 3).map((node) => node.html.slice(0, 160)).join(' | ')}`), []);
}

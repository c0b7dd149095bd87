// SPDX-License-Identifier: MIT
// node live.mjs CHROMIUM LIVE_PROGRAM SOCCER FOLDER: tests what users do with the page of a running program. Saves screenshots in FOLDER (situations.mjs).
import { strict as assert } from 'node:assert';
import { spawn } from 'node:child_process';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { chromium } from 'playwright-core';
import { check, screenshot } from './situations.mjs';

const [program, live, soccer, folder] = process.argv.slice(2);
const browser = await chromium.launch({ executablePath: program, args: ['--no-sandbox'] });
let failed = 0;

/** Starts a program; returns its process, and the address in the first line that it prints. */
async function start(command, ...options) {
  const child = spawn(command, options, { stdio: ['pipe', 'pipe', 'inherit'] });
  const lines = createInterface({ input: child.stdout });
  const [url] = /http:\S+/.exec(await new Promise((resolve) => lines.once('line', resolve)));
  lines.resume();
  return { child, url };
}

/** Runs a situation with its own program and page. The page may log nothing, and may request only addresses below its own, which has the token. */
async function situation(title, command, options, act) {
  const { child, url } = await start(...command);
  const context = await browser.newContext({ viewport: { width: 1400, height: 950 }, ...options });
  const page = await context.newPage();
  const said = [];
  page.on('console', (message) => said.push(`console: ${message.text()}`));
  page.on('pageerror', (error) => said.push(`error: ${error.message}`));
  page.on('request', (request) => request.url().startsWith(url) || said.push(`request: ${request.url()}`));
  try {
    await page.goto(url);
    await sees(page, '.live-state', /^Connected/);
    await page.waitForSelector('#moment');
    await act({ page, said, url, child });
    assert.deepEqual(said, []);
    console.log(`ok ${title}`);
  } catch (error) {
    ++failed;
    console.log(`not ok ${title}: ${error.message}`);
    await page.screenshot({ path: join(folder, `failed_${failed}.png`) });
  }
  await context.close();
  child.kill('SIGKILL');
}

const text = (page, where) => page.locator(where).first().innerText();

/** Waits until `is` is true in the page; the page's Content-Security-Policy forbids Playwright's own way to wait for that. */
async function until(page, is, argument, what = is) {
  for (const end = Date.now() + 30_000; !(await page.evaluate(is, argument)); await page.waitForTimeout(50)) assert.ok(Date.now() < end, `never: ${what}`);
}

async function sees(page, where, expected) {
  await until(page, ([at, pattern, flags]) => new RegExp(pattern, flags).test(document.querySelector(at)?.innerText ?? ''), [where, expected.source, expected.flags], `${where} shows ${expected}`);
}

const shot = (page, name) => screenshot(page, folder, name);
const time = async (page) => Number.parseFloat(await text(page, '.where'));
const node = (page, group) => page.locator(`.holder:not([hidden]) g.node:has(> title:text-is("${group}"))`).first();
const tracks = (page) => page.locator('.labels a:not(.state)').allTextContents();
const game = [soccer, '--live', '0', '--speed', '4'];

await situation('a game is followed: the picture, the tracks and the words show what runs now', game, {}, async ({ page }) => {
  await sees(page, '#moment', /Runs\n.*FallRecovery/s);
  await until(page, () => Math.abs(document.getElementById('live').getBoundingClientRect().top) < 1); // so that everything below it is visible
  const first = await time(page);
  await until(page, (from) => Number.parseFloat(document.querySelector('.where').innerText) > from + 3, first);
  assert.match(await node(page, 'FallRecovery').getAttribute('class'), /is-running/);
  assert.equal(await page.locator('#follow').isChecked(), true);
  await page.waitForTimeout(1500);
  await shot(page, 'soccer');
});

await situation('who looks back stays there, while more happens, until the end is followed again', game, {}, async ({ page }) => {
  const first = await time(page);
  await until(page, (from) => Number.parseFloat(document.querySelector('.where').innerText) > from + 2, first);
  await page.locator('#scrub').focus();
  await page.keyboard.press('Home');
  await until(page, (from) => !document.querySelector('#follow').checked && Number.parseFloat(document.querySelector('.where').innerText) <= from, first);
  const there = await time(page);
  await page.waitForTimeout(700);
  assert.equal(await time(page), there);
  await sees(page, '.live-state', /^Connected: what is shown is the past; “Follow the end” leads back to the present$/);
  await page.check('#follow');
  await sees(page, '.live-state', /^Connected: this is what happens now$/);
  await until(page, (from) => Number.parseFloat(document.querySelector('.where').innerText) > from + 2, there);
});

await situation('who chooses an event or a place in the overview, or plays, leaves the end too', game, {}, async ({ page }) => {
  const first = await time(page);
  await until(page, (from) => Number.parseFloat(document.querySelector('.where').innerText) > from + 2, first);
  // At once: the list is made anew all the time, and has no event at times.
  const clickEvent = () => until(page, () => {
    const event = document.querySelector('#events button');
    event?.click();
    return event !== null;
  });
  for (const choose of [clickEvent, () => page.locator('.overview').click({ position: { x: 5, y: 5 } })]) {
    await page.check('#follow');
    await choose();
    await until(page, () => !document.querySelector('#follow').checked);
    await page.waitForTimeout(300); // until that time is shown
    const there = await time(page);
    await page.waitForTimeout(700);
    assert.equal(await time(page), there);
  }
  await page.check('#follow');
  await page.getByRole('button', { name: 'Play' }).click();
  await page.waitForTimeout(500);
  assert.equal(await page.locator('#follow').isChecked(), false);
  assert.equal(await page.getByRole('button', { name: 'Pause' }).count(), 1);
});

await situation('the boxes of the filter follow what happens, and a click on one removes the track of that group alone', game, {}, async ({ page }) => {
  await page.locator('.filter summary').click();
  const ticked = () => page.locator('.filter fieldset:nth-of-type(2) label:has(input:checked)').allInnerTexts();
  const first = await time(page);
  await until(page, (from) => Number.parseFloat(document.querySelector('.where').innerText) > from + 4, first); // most groups have begun to run by then
  const [gone, ...others] = (await ticked()).map((name) => name.trim());
  await page.locator('.filter').getByLabel(gone, { exact: true }).uncheck();
  await until(page, ([group, stay]) => {
    const shown = [...document.querySelectorAll('.labels a:not(.state)')].map((track) => track.textContent);
    return !shown.includes(group) && stay.every((each) => shown.includes(each));
  }, [gone, others]);
});
await situation('what waits says for which state, what that is worth, and who could cause it', [live], {}, async ({ page }) => {
  await sees(page, '#moment', /Waits\n(.*\n)*Open waits \(Deliver>Open\): until Door == open/);
  await sees(page, '#moment', /Door is shut\nOpen\.unlocking could cause it, and is disabled/);
  await shot(page, 'waits');
});

await situation('a click on a box says why, also where it is a link, and so does a choice by keyboard, which goes on to the answer', [live], {}, async ({ page }) => {
  await node(page, 'Open').click();
  await sees(page, '#why-answer', /^Open waits \(Deliver>Open\): until Door == open, .*\(asked at .*\)\n+Door is shut\nOpen\.unlocking could cause it, and is disabled$/s);
  await page.locator('#why-group').focus();
  await page.keyboard.type('Sing');
  await sees(page, '#why-answer', /^Sing runs \(Rest>Sing\) \(asked/);
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await sees(page, '#why-answer', /^Sing runs/);
  await page.keyboard.press('Tab'); // a long answer is scrolled by keyboard
  assert.equal(await page.evaluate(() => document.activeElement.id), 'why-answer');
});

for (const [screen, viewport] of Object.entries({ 'a laptop': { width: 1366, height: 768 }, 'a phone': { width: 390, height: 844 } })) {
  await situation(`how the connection is, and the answer to a click, are in sight beside the picture, on ${screen}`, [live], { viewport }, async ({ page }) => {
    await page.locator('.bench').evaluate((bench) => bench.scrollIntoView());
    await node(page, 'Open').click();
    await sees(page, '#why-answer', /^Open waits/);
    const seen = await page.evaluate(() => ['.live-state', '#why-answer p', '.bench .picture'].map((each) => {
      const element = document.querySelector(each);
      const { left, top } = element.getBoundingClientRect();
      return element.contains(document.elementFromPoint(left + 10, top + 10));
    }));
    assert.deepEqual(seen, [true, true, true]);
    await shot(page, `waits_${viewport.width}`);
  });
}

await situation('only what runs or waits now has a track, and the rest of the picture is hardly there', [live], {}, async ({ page, url }) => {
  await page.check('#only-now');
  await until(page, () => document.querySelectorAll('.labels a:not(.state)').length === 5);
  assert.equal((await fetch(`${url}cancel?task=Rest`, { method: 'POST' })).status, 202);
  await until(page, () => document.querySelectorAll('.labels a:not(.state)').length < 5);
  assert.equal((await tracks(page)).includes('Sing'), false);
  assert.ok(Number(await node(page, 'Sing').evaluate((each) => getComputedStyle(each).opacity)) < 0.5);
});

await situation('where the keyboard is, it stays, while more comes', game, {}, async ({ page }) => {
  const link = page.locator('#moment a', { hasText: /^FallRecovery$/ }).first();
  await link.focus();
  await page.waitForTimeout(1000);
  assert.equal(await page.evaluate(() => document.activeElement?.textContent), 'FallRecovery');
});

await situation('a program that stands still is called silent, and then connected again', [live], {}, async ({ page, child }) => {
  child.kill('SIGSTOP');
  await sees(page, '.live-state', /^Silent since \d\d:\d\d:\d\d: the connection is there, and nothing comes; the program may be stopped$/);
  await shot(page, 'silent');
  child.kill('SIGCONT');
  await sees(page, '.live-state', /^Connected: this is what happens now$/);
});

await situation('of a program that takes no steps, the page says so, although the connection is there', [live, 'hang'], {}, async ({ page }) => {
  await sees(page, '.live-state', /^Connected: this is what happens now$/);
  await sees(page, '.live-state', /^Connected, but at \d\d:\d\d:\d\d the program had taken no step for some seconds: what is shown is from its last one$/);
});

await situation('a program that has ended is called lost, and what was seen stays', [live], {}, async ({ page, said, child }) => {
  child.kill('SIGKILL');
  await sees(page, '.live-state', /^Lost since \d\d:\d\d:\d\d: the program has ended, or cannot be reached; it is tried again$/);
  await node(page, 'Walk').click();
  await sees(page, '#why-answer', /^Not answered: the program cannot be reached$/);
  assert.match(await text(page, '#moment'), /Rest/);
  await shot(page, 'lost');
  for (const each of said.splice(0)) assert.match(each, /^console: Failed to load resource: net::ERR_(CONNECTION_REFUSED|INCOMPLETE_CHUNKED_ENCODING|CONTENT_LENGTH_MISMATCH|EMPTY_RESPONSE|CONNECTION_RESET)/);
});

await situation('a page of another version of the behaviour says so, and the own one does not', [live], {}, async ({ page, url }) => {
  const warning = /This page is of another version of the behaviour than the one that runs/;
  assert.doesNotMatch(await text(page, '#live'), warning);
  await page.route(url, async (route) => {
    const answer = await route.fetch();
    const body = (await answer.text()).replace(/data-fingerprint="\w{16}"/, 'data-fingerprint="0123456789abcdef"').replaceAll('Walk', 'Gait');
    await route.fulfill({ response: answer, body });
  });
  await page.reload();
  await sees(page, '#live', warning);
  await sees(page, '#moment', /Rest/); // although the program has no group of the name that one has in this page
});

await situation('events that are missing are counted, and then it is the present again', [live, 'flood'], {}, async ({ page }) => {
  await sees(page, '.live-state', /^Behind: [\d,]+ events came faster than they could be shown, and are missing; from here on it is the present again$/);
  await sees(page, '#moment', /Rest/);
  await sees(page, '.live-state', /^(Connected|Behind)/);
});

await situation('a moment that is not kept any more is not shown as another one, and what runs all the time keeps its track', [live], {}, async ({ page, url, said }) => {
  const reader = (await fetch(`${url}events`)).body.getReader();
  let begin = '';
  while (!begin.includes('\n')) begin += new TextDecoder().decode((await reader.read()).value);
  await reader.cancel();
  const line = (time, number, rest) => `data: ${JSON.stringify({ t: time, n: number, ...rest })}\n`;
  const bells = (from, to) => Array.from({ length: to - from }, (_, i) => line((from + i) * 1000, from + i, { event: 'input', input: 'trigger', trigger: 'Bell' })).join('');
  const requests = [{ event: 'input', input: 'request', edge: 'root>Rest' }, { event: 'grant', edge: 'root>Rest', provider: 'default' }].map((rest) => line(0, 1, rest)).join('');
  const bodies = [`${begin.split('\n')[0]}\n${line(0, 0, { event: 'begin' })}${requests}${bells(2, 40)}id: 1\n\n`, `${bells(40, 420_000)}id: 2\n\n`];
  let more;
  const wanted = new Promise((resolve) => (more = resolve));
  await page.route('**/events', async (route) => {
    const body = bodies.shift();
    if (body === undefined) return; // no answer
    if (bodies.length === 0) await wanted;
    await route.fulfill({ headers: { 'content-type': 'text/event-stream' }, body });
  });
  await page.reload();
  await page.waitForSelector('#moment');
  await page.locator('#at').fill('0.01');
  await page.keyboard.press('Enter');
  await sees(page, '.where', /^0\.010 s/);
  assert.deepEqual(await tracks(page), ['Rest']);
  more();
  await sees(page, '.where', /; the moment before, which was shown, is not kept any more$/);
  assert.ok((await time(page)) > 100);
  assert.deepEqual(await tracks(page), ['Rest']);
  const there = await text(page, '.where');
  await page.locator('.filter').evaluate((filter) => (filter.open = true));
  await page.getByLabel('other inputs', { exact: true }).check();
  await page.locator('#scrub').focus();
  await page.keyboard.press('ArrowRight');
  await until(page, (before) => document.querySelector('.where').innerText !== before && !/not kept/.test(document.querySelector('.where').innerText), there);
  said.length = 0; // the connection that was never answered
});

await situation('of a program that shows no moment, what is not kept any more is not known', [live, 'unshown'], {}, async ({ page }) => {
  await sees(page, '#moment', /Not known, as events are missing\n/);
  const shown = await text(page, '#moment');
  assert.match(shown, /Door is not known/);
  assert.doesNotMatch(shown, /Not requested/);
});

for (const colorScheme of ['light', 'dark']) {
  await situation(`axe finds nothing, ${colorScheme}`, [live], { colorScheme, bypassCSP: true }, async ({ page }) => {
    await sees(page, '#moment', /Door is shut/);
    await node(page, 'Open').click();
    await sees(page, '#why-answer', /^Open waits/);
    await page.locator('#follow').uncheck();
    await check(page);
    await shot(page, `live_${colorScheme}`);
  });
}

await situation('at 200 % nothing is cut off at the side', [live], { viewport: { width: 640, height: 450 }, deviceScaleFactor: 2 }, async ({ page }) => {
  await sees(page, '#moment', /Door is shut/);
  const [inner, whole] = await page.evaluate(() => [document.documentElement.clientWidth, document.documentElement.scrollWidth]);
  assert.ok(whole <= inner, `${whole} points in ${inner}`);
  await shot(page, 'live_200');
});

await situation('the policy lets the page ask its own server, and nobody else', [live], {}, async ({ page, said }) => {
  const blocked = page.evaluate(() => new Promise((resolve) => document.addEventListener('securitypolicyviolation', (event) => resolve(event.effectiveDirective), { once: true })));
  await page.evaluate(() => fetch('http://127.0.0.1:9/').catch(() => undefined));
  assert.equal(await blocked, 'connect-src');
  assert.match(said.splice(0).join(), /violates the following Content Security Policy directive: "connect-src 'self'"/);
});

await situation('a page of another address can neither read nor show it', [live], {}, async ({ page, said, url }) => {
  const other = await page.context().newPage();
  await other.goto('data:text/html,<p>other</p>');
  const read = await other.evaluate((address) => fetch(`${address}why`).then(() => 'read', () => 'refused'), url);
  assert.equal(read, 'refused');
  // The browser sends it, and the server refuses it because of its header Origin.
  await other.evaluate((address) => fetch(`${address}cancel_all`, { method: 'POST', mode: 'no-cors' }).catch(() => undefined), url);
  await page.waitForTimeout(500);
  await sees(page, '#moment', /Rest/);
  assert.deepEqual(said, []);
});

await browser.close();
process.exit(failed === 0 ? 0 : 1);

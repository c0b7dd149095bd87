// SPDX-License-Identifier: MIT
// node pages.mjs CHROMIUM FOLDER: tests what users do with the pages in FOLDER. Saves screenshots there (situations.mjs).
import { strict as assert } from 'node:assert';
import { statSync } from 'node:fs';
import { join } from 'node:path';
import { check, click, comeToRest, isLong, Situations } from './situations.mjs';

const [program, folder] = process.argv.slice(2);
const all = await Situations.open(program, folder);
const situation = (...words) => all.run(...words);
const shot = (page, name) => all.shot(page, name);
const near = (page) => page.locator('.holder:not([hidden]) g.node.near title').allTextContents();
const focused = (page) => page.evaluate(() => document.activeElement?.id || document.activeElement?.textContent);

/** The groups of the picture that are not completely within its frame. */
const beyond = (page) => page.evaluate(() => {
  const picture = document.querySelector('.holder:not([hidden]) .picture');
  const paper = picture.getBoundingClientRect();
  const isOut = ({ left, right, top, bottom }) => left < paper.left - 1 || right > paper.right + 1 || top < paper.top - 1 || bottom > paper.bottom + 1;
  return [...picture.querySelectorAll('g.node')].filter((node) => isOut(node.getBoundingClientRect())).map((node) => node.querySelector('title').textContent);
});

for (const colorScheme of ['light', 'dark']) {
  for (const name of colorScheme === 'light' || isLong ? ['soccer', 'photo'] : ['photo']) {
    await situation(`axe finds nothing, ${colorScheme}`, name, { colorScheme, bypassCSP: true }, async (page) => {
      await shot(page, `${name}_${colorScheme}`);
      await check(page);
      await click(page.locator('.matrix td a').nth(1));
      await page.fill('#search', 'e');
      await check(page);
      await page.locator('#transitions').evaluate((section) => section.scrollIntoView());
      await shot(page, `${name}_${colorScheme}_matrix`);
    });
  }
}

await situation('who requests a group stands above its providers, as it is said of all of them', 'soccer', {}, async (page) => {
  assert.deepEqual(await page.locator('#group-Walk').locator('.others dt, h4').evaluateAll((all) => all.map((each) => each.firstChild.textContent.trim())), ['requested by', 'may be pushed by', 'Walk.walking', 'Walk.halting']);
});

await situation('a search finds by name, then by what is said; Enter goes there', 'soccer', {}, async (page) => {
  await page.keyboard.press('/');
  assert.equal(await focused(page), 'search');
  await page.keyboard.type('kick');
  assert.deepEqual((await page.locator('#found button').allTextContents()).slice(0, 3), ['Kick', 'KickTo', 'KickToGoal']);
  assert.deepEqual(await page.locator('.holder:not([hidden]) g.node.found title').evaluateAll((all) => all.map((each) => each.textContent).sort()), ['Kick', 'KickTo', 'KickToGoal']);
  await page.keyboard.press('Enter');
  assert.equal(await focused(page), 'group-Kick');
  await page.fill('#search', 'inertial sensor');
  assert.deepEqual(await page.locator('#found button').allTextContents(), ['state Stability']);
  await page.fill('#search', 'no such thing');
  assert.equal(await page.locator('#status').textContent(), '0 found');
});

await situation('the whole name is found first, so that Enter goes to it', 'exact', {}, async (page) => {
  for (const [typed, group] of [['Kick', 'Kick'], ['kick', 'Kick'], ['KICKS', 'kicks'], ['kickt', 'KickTo']]) {
    await page.fill('#search', typed);
    await page.locator('#search').press('Enter');
    assert.equal(await focused(page), `group-${group}`);
  }
});

await situation('in the search field the first Escape clears it, and the second ends the focus, which is named until then', 'soccer', {}, async (page) => {
  const words = () => page.locator('#focused').textContent();
  await page.fill('#search', 'kick');
  await page.locator('#search').press('Enter');
  assert.match(await words(), /^Focus on Kick: /);
  await page.locator('#search').press('Escape');
  assert.equal(await page.locator('#search').inputValue(), '');
  assert.match(await words(), /^Focus on Kick: /);
  assert.notDeepEqual(await near(page), []);
  await page.locator('#search').press('Escape');
  assert.equal(await words(), '');
  assert.deepEqual(await near(page), []);
});

await situation('after a way back to the page the chosen picture is the one that is shown', 'soccer', {}, async (page, said) => {
  await page.getByLabel('By module', { exact: true }).check();
  const address = page.url();
  await page.goto('about:blank');
  await page.goBack();
  assert.equal(page.url(), address);
  const shown = await page.locator('.picture:visible').evaluateAll((all) => all.map((each) => each.dataset.picture));
  assert.deepEqual(shown, await page.locator('.views input:checked + label').allTextContents());
  said.length = 0; // leaving and returning are requests
});

await situation('a focus greys out what has nothing to do with the group, Escape ends it', 'soccer', {}, async (page) => {
  await click(page.locator('#group-KickTo button.focus'));
  assert.deepEqual((await near(page)).sort(), ['Kick', 'KickTo', 'KickToGoal', 'LookAt', 'Striker', 'Walk']);
  await shot(page, 'soccer_focus');
  const grey = await page.locator('.holder:not([hidden]) g.node:not(.near)').first().evaluate((node) => getComputedStyle(node).opacity);
  assert.ok(Number(grey) < 0.5);
  await page.locator('h1').click();
  await page.keyboard.press('Escape');
  assert.deepEqual(await near(page), []);
});

await situation('a focus while modules are shown goes to the picture that has the group, and leaves the others as they are', 'soccer', {}, async (page) => {
  const place = () => page.locator('.holder:not([hidden]) svg > g').getAttribute('transform');
  await page.getByLabel('By module', { exact: true }).check();
  const modules = await place();
  await click(page.locator('#group-KickTo button.focus'));
  assert.deepEqual(await page.locator('.picture:visible').evaluateAll((all) => all.map((each) => each.dataset.picture)), ['All groups']);
  assert.equal(await page.getByLabel('All groups', { exact: true }).isChecked(), true);
  assert.deepEqual((await near(page)).sort(), ['Kick', 'KickTo', 'KickToGoal', 'LookAt', 'Striker', 'Walk']);
  assert.doesNotMatch(await place(), /NaN/);
  await page.getByLabel('By module', { exact: true }).check();
  assert.equal(await place(), modules);
  assert.equal(await page.locator('.holder:not([hidden]) svg.focused').count(), 0);
});

await situation('a focus on a group that shares its box with others is on that box', 'soccer', {}, async (page) => {
  await click(page.locator('#group-LeftArm button.focus'));
  assert.deepEqual((await near(page)).sort(), ['Brace', 'FallRecovery', 'GetUp', 'KickTo', 'KickToGoal', 'LeftArm, RightArm', 'Striker', 'Walk', 'WalkTo', 'WalkToBall', 'WalkToReady']);
  await page.fill('#search', 'leftarm');
  assert.deepEqual(await page.locator('.holder:not([hidden]) g.node.found title').allTextContents(), ['LeftArm, RightArm']);
});

await situation('a focus has who leads to the group, what it holds, who may take that, and whom it may push', 'soccer', {}, async (page) => {
  await click(page.locator('#group-Kick button.focus'));
  assert.deepEqual((await near(page)).sort(), ['Brace', 'GetUp', 'Kick', 'KickTo', 'KickToGoal', 'LeftLeg', 'RightLeg', 'Striker', 'Walk']);
  const arrows = await page.locator('.holder:not([hidden]) g.edge.near > title').allTextContents();
  for (const arrow of ['Striker.playing → KickToGoal', 'KickToGoal → KickTo', 'KickTo.kick → Kick', 'GetUp → LeftLeg', 'Kick → Walk.halting']) assert.ok(arrows.includes(arrow), arrow);
  await shot(page, 'soccer_focus_kick');
});

await situation('a focus on a telephone has in sight what it is, how it ends, and what is beside the group, or names that', 'soccer', { viewport: { width: 390, height: 844 } }, async (page) => {
  for (const group of ['Kick', 'KickTo', 'Walk']) {
    await page.fill('#search', group);
    await page.locator('#search').press('Enter');
    await comeToRest(page.locator(`#group-${group}`)); // until then the page scrolls to it
    await page.locator('#picture').evaluate((picture) => picture.scrollIntoView());
    const all = await near(page), out = await beyond(page);
    const [words, outside] = (await page.locator('#focused').textContent()).split(' Outside of the frame: ');
    assert.match(words, new RegExp(`^Focus on ${group}: `));
    assert.deepEqual(outside?.replace(/\.$/, '').split(/, (?!Right)/) ?? [], all.filter((name) => out.includes(name)));
    assert.ok(all.length > out.filter((name) => all.includes(name)).length + 2);
    for (const shown of ['#focused', '.tools button:text("Show everything")']) {
      const { y, height } = await page.locator(shown).boundingBox();
      assert.ok(y >= 0 && y + height <= 844, `${y} ${height}`);
    }
    await shot(page, `soccer_focus_390_${group}`);
  }
  await page.getByRole('button', { name: 'Show everything' }).click();
  assert.deepEqual(await near(page), []);
});

await situation('the keys for searching and for ending a focus act where a radio button has the keyboard', 'soccer', {}, async (page) => {
  await click(page.locator('#group-KickTo button.focus'));
  await page.getByLabel('All groups', { exact: true }).focus();
  await page.keyboard.press('Escape');
  assert.deepEqual(await near(page), []);
  await page.keyboard.press('/');
  assert.equal(await focused(page), 'search');
});

await situation('who goes first is said of the group that is named, where another name differs only in case', 'alike', {}, async (page) => {
  const ask = async (first, second) => {
    await page.getByLabel('Who goes first,').fill(first);
    await page.getByLabel('or', { exact: true }).fill(second);
    return page.locator('#pair-answer li').allTextContents();
  };
  assert.deepEqual(await ask('Walkto', 'Sit'), ['Sit goes first. At the program: Sit (priority 20) before Walkto (priority 10).']);
  assert.deepEqual(await ask('WalkTo', 'Sit'), ['WalkTo goes first. At the program: WalkTo (priority 30) before Sit (priority 20).']);
});

await situation('a focused group is in the frame, also where the picture is flat', 'flat', {}, async (page) => {
  for (const group of ['Play', 'Leaf1', 'Leaf20', 'Leaf36']) {
    await click(page.locator(`#group-${group} button.focus`));
    const [box, frame] = await page.locator(`.holder:not([hidden]) g.node:has(> title:text-is("${group}"))`).evaluate((node) => [node, node.closest('.picture')].map((each) => each.getBoundingClientRect().toJSON()));
    assert.ok(box.left >= frame.left && box.right <= frame.right && box.top >= frame.top && box.bottom <= frame.bottom, `${group}: ${JSON.stringify([box, frame])}`);
    assert.ok(Math.abs((box.top + box.bottom - frame.top - frame.bottom) / 2) < frame.height / 3);
    assert.doesNotMatch(await page.locator('#focused').textContent(), new RegExp(`Outside of the frame: .*\\b${group}\\b`));
  }
});

await situation('a focus has all that is near the group in the frame, at a size that can be read', 'soccer', {}, async (page) => {
  for (const group of ['Kick', 'Walk', 'Striker']) {
    await click(page.locator(`#group-${group} button.focus`));
    const all = await near(page), out = await beyond(page);
    assert.deepEqual(all.filter((name) => out.includes(name)), []);
    const letter = await page.locator('.holder:not([hidden]) g.node.near text').first().evaluate((text) => text.getBoundingClientRect().height);
    assert.ok(letter >= 8, `${letter}`);
  }
});

await situation('the picture is moved and zoomed by keys, wheel and buttons', 'soccer', {}, async (page) => {
  const place = () => page.locator('.holder:not([hidden]) svg > g').getAttribute('transform');
  await page.locator('.holder:not([hidden]) .picture').focus();
  const before = await place();
  await page.keyboard.press('ArrowRight');
  const moved = await place();
  assert.notEqual(moved, before);
  await page.keyboard.press('+');
  const larger = await place();
  assert.notEqual(larger, moved);
  await page.keyboard.press('0');
  assert.equal(await place(), 'translate(0,0) scale(1)');
  await page.getByRole('button', { name: 'Larger' }).first().click();
  assert.equal(await page.locator('.holder:not([hidden]) svg > g').getAttribute('transform').then((text) => /scale\(1\.3\)/.test(text)), true);
});

await situation('the keyboard goes to each box once, which is in sight then; a link goes past all of them', 'robocup', { viewport: { width: 1400, height: 900 } }, async (page) => {
  const frame = page.locator('.holder:not([hidden]) .picture');
  await frame.focus();
  const titles = [];
  for (;;) {
    await page.keyboard.press('Tab');
    const seen = await page.evaluate(() => {
      const link = document.activeElement;
      const [box, frame] = [link, document.querySelector('.holder:not([hidden]) .picture')].map((each) => each.getBoundingClientRect());
      const isSeen = box.left >= frame.left && box.right <= frame.right && box.top >= Math.max(0, frame.top) && box.bottom <= Math.min(innerHeight, frame.bottom) + 1;
      return { title: link.closest('svg') && (link.closest('g')?.querySelector('title').textContent ?? ''), isSeen };
    });
    if (seen.title === null) break;
    assert.ok(seen.isSeen, seen.title);
    titles.push(seen.title);
  }
  assert.equal(new Set(titles).size, titles.length);
  assert.ok(titles.length > 40, `${titles.length}`);
  await frame.focus();
  await page.keyboard.press('Shift+Tab');
  assert.equal(await focused(page), 'To what comes after the picture');
  await shot(page, 'robocup_skip');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.closest('#groups') !== null), true);
});

await situation('collapsed to modules and to layers, one picture is shown', 'soccer', {}, async (page) => {
  for (const view of ['By module', 'By layer', 'All groups']) {
    await page.getByLabel(view, { exact: true }).check();
    assert.deepEqual(await page.locator('.picture:visible').evaluateAll((all) => all.map((each) => each.dataset.picture)), [view]);
  }
});

await situation('a cell explains itself, with a scenario; arrow keys go to its neighbours', 'soccer', {}, async (page) => {
  await click(page.getByRole('link', { name: 'soft: from WalkTo to Kick' }));
  assert.match(await page.locator('#cell').textContent(), /From WalkTo to Kick: soft.*Walk is pushed to halting for Stability == standing, within 2 s/s);
  assert.match(await page.locator('#cell pre').textContent(), /^scenario: from WalkTo to Kick\nbehaviour: soccer\.yaml\nscript:\n/);
  await shot(page, 'soccer_cell');
  await page.getByRole('button', { name: 'Close' }).click();
  assert.equal(await page.evaluate(() => document.activeElement?.getAttribute('aria-label')), 'soft: from WalkTo to Kick');
  await page.keyboard.press('ArrowRight');
  assert.match(await page.evaluate(() => document.activeElement?.getAttribute('aria-label')), /from WalkTo to LookAt$/);
  assert.equal(await page.locator('.matrix a[tabindex="0"]').count(), 1);
});

await situation('while a cell is explained, the names of the columns, the cell and the explanation are in sight', 'robocup', {}, async (page) => {
  for (const row of [1, 12, 30]) {
    await click(page.locator(`.matrix tbody tr:nth-child(${row}) td:nth-of-type(3) a`));
    const seen = await page.evaluate(() => {
      const [head, cell, panel] = ['.matrix thead th', '.matrix td[aria-current]', '#cell p'].map((each) => document.querySelector(each).getBoundingClientRect());
      return { head: head.top, below: cell.top - head.bottom, panel: innerHeight - panel.bottom };
    });
    assert.ok(seen.head >= 0 && seen.below >= -1 && seen.panel >= 0, `${row}: ${JSON.stringify(seen)}`);
    await shot(page, `robocup_cell_${row}`);
  }
});

await situation('what a small matrix is of is said in few lines', 'alike', {}, async (page) => {
  const { height } = await page.locator('.matrix caption').boundingBox();
  assert.ok(height <= 50, `${height}`);
});

await situation('of any two groups the page says who goes first, and what decides, in either order', 'soccer', {}, async (page) => {
  const ask = async (first, second) => {
    await page.getByLabel('Who goes first,').fill(first);
    await page.getByLabel('or', { exact: true }).fill(second);
    return page.locator('#pair-answer li').allTextContents();
  };
  const told = ['GetUp goes first. At the program: FallRecovery (priority 90) before Striker (priority 10).'];
  assert.deepEqual(await ask('GetUp', 'Kick'), told);
  assert.deepEqual(await ask('kick', 'getup'), told);
  assert.deepEqual(await ask('Head', 'LookAt'), ['LookAt leads to Head: it goes first of what it leads to.']);
  assert.deepEqual(await ask('Striker', 'Striker'), ['Nowhere do two chains of requesters lead to Striker.']);
  assert.deepEqual(await ask('Kick', ''), []);
  assert.deepEqual(await ask('Kick', 'Nobody'), ['There is no group Nobody.']);
  assert.deepEqual(await ask('Kick', 'Wal'), []);
  await page.getByLabel('or', { exact: true }).press('Enter');
  assert.deepEqual(await page.locator('#pair-answer li').allTextContents(), ['There is no group Wal.']);
  await page.locator('#pair').scrollIntoViewIfNeeded();
  await ask('Kick', 'Walk');
  await shot(page, 'soccer_pair');
});

for (const way of ['by a link', 'by its address']) {
  await situation(`who goes to the findings of seventy groups ${way} sees them`, 'robocup', { viewport: { width: 1400, height: 900 } }, async (page, said) => {
    if (way === 'by a link') {
      await page.getByRole('link', { name: /^Findings/ }).click();
    } else {
      const address = page.url();
      await page.goto('about:blank');
      await page.goto(`${address}#findings`);
      said.length = 0; // leaving and returning are requests
    }
    await page.waitForTimeout(1000);
    const top = await page.locator('#findings-title').evaluate((title) => title.getBoundingClientRect().top);
    assert.ok(top >= 0 && top < 900, `${top}`);
  });
}

await situation('the rows of boxes are drawn, also where they are links', 'soccer', {}, async (page) => {
  assert.deepEqual(await page.locator('.picture:visible g.node text').evaluateAll((all) => all.filter((text) => text.getClientRects().length === 0).map((text) => text.textContent)), []);
});

await situation('what the letters of the matrix mean is said of those that stand in it', 'soccer', {}, async (page) => {
  const signs = (where) => page.locator(where).evaluateAll((all) => [...new Set(all.map((each) => each.textContent))].sort());
  assert.deepEqual(await signs('.legend .sign'), await signs('.matrix td a'));
});

await situation('where the matrix is scrolled, its corner hides the names that go below it', 'robocup', {}, async (page) => {
  await page.locator('.matrix').evaluate((matrix) => { matrix.scrollIntoView(); matrix.scrollTop = 400; matrix.scrollLeft = 100; });
  const seen = await page.locator('.matrix').evaluate((matrix) => {
    const { left, top } = matrix.getBoundingClientRect();
    return [20, 60, 100].map((down) => document.elementFromPoint(left + 20, top + down).closest('tr').parentElement.localName);
  });
  assert.deepEqual(seen, ['thead', 'thead', 'thead']);
  await shot(page, 'robocup_matrix');
});

await situation('what a cell says comes in sight, as far as the names of the columns stay there', 'robocup', {}, async (page) => {
  const link = page.getByRole('link', { name: 'hard: from WalkTo to GetUp', exact: true });
  await page.locator('.matrix').evaluate((matrix) => matrix.scrollIntoView({ block: 'end' }));
  await click(link);
  const [bottom, top, height] = await page.evaluate(() => [...['#cell', '.matrix thead td'].map((each) => document.querySelector(each).getBoundingClientRect()), innerHeight].map((each, i) => [each.bottom, each.top, each][i]));
  assert.ok(bottom <= height + 1 || top < 100, `the words end at ${bottom} of ${height}, the names are at ${top}`);
  assert.ok(top >= 0);
});

await situation('on a narrow screen the names of rows stand on one line', 'soccer', { viewport: { width: 420, height: 900 } }, async (page) => {
  const heights = await page.locator('.matrix tbody tr').evaluateAll((all) => all.map((row) => row.getBoundingClientRect().height));
  assert.ok(Math.max(...heights) <= 40, `${heights}`);
});

await situation('what is said of groups and cells begins at one place below each other, however long the names are', 'soccer', {}, async (page) => {
  for (const where of ['#from-Walk dd', '#group-LeftLeg dl:last-child dd']) {
    const lefts = await page.locator(where).evaluateAll((all) => all.map((each) => Math.round(each.getBoundingClientRect().left)));
    assert.ok(lefts.length >= 3);
    assert.equal(new Set(lefts).size, 1, `${where}: ${lefts}`);
  }
});

await situation('one finger scrolls the page, also on the picture; two move the picture', 'soccer', { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true }, async (page) => {
  const session = await page.context().newCDPSession(page);
  const { x, y, width } = await page.locator('.holder:not([hidden]) .picture').boundingBox();
  const touch = (type, ...points) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([px, py], id) => ({ x: px, y: py, id })) });
  const place = () => page.locator('.holder:not([hidden]) svg > g').getAttribute('transform');
  const before = await place();
  await touch('touchStart', [x + width / 2, y + 200]);
  for (let moved = 10; moved <= 150; moved += 10) await touch('touchMove', [x + width / 2, y + 200 - moved]);
  await touch('touchEnd');
  for (let last = -1, now = 0; now !== last; [last, now] = [now, await page.evaluate(() => scrollY)]) await page.waitForTimeout(300); // until scrolling ends
  assert.ok((await page.evaluate(() => scrollY)) >= 100);
  assert.equal(await place(), before);
  const at = (await page.locator('.holder:not([hidden]) .picture').boundingBox()).y + 100;
  const [left, right] = [x + width / 3, x + width / 2];
  await touch('touchStart', [left, at], [right, at]);
  for (let moved = 10; moved <= 60; moved += 10) await touch('touchMove', [left, at + moved], [right, at + moved]);
  await touch('touchEnd');
  // The page follows the fingers in its next frames.
  await page.waitForFunction((was) => document.querySelector('.holder:not([hidden]) svg > g').getAttribute('transform') !== was, before);
});

await situation('without JavaScript all of the text is there, and each cell leads to its words and its scenario', 'soccer', { javaScriptEnabled: false }, async (page) => {
  assert.equal(await page.locator('#finder').isVisible(), false);
  assert.equal(await page.locator('.picture').first().isVisible(), true);
  const link = page.locator('.matrix td[data-kind="soft"] a').first();
  const target = page.locator((await link.getAttribute('href')));
  assert.equal(await page.locator('#pair').isVisible(), false);
  assert.equal(await page.locator('.rivals td').first().isVisible(), false);
  // By keyboard: a click waits for two frames in which a script of the page runs, and without JavaScript these may never come.
  await page.locator('.rivals summary').press('Enter');
  assert.deepEqual(await page.locator('.rivals tbody tr').first().locator('td').allTextContents(), ['Walk', 'WalkTo and KickTo', 'Striker: KickToGoal (priority 20) before WalkToBall (priority 10), together or not at allStriker: KickToGoal (priority 20) before WalkToReady (priority 0), never both at once']);
  assert.match(await target.textContent(), /waits\. .* is pushed to /);
  assert.equal(await target.locator('pre').isVisible(), false);
  await target.locator('summary').press('Enter');
  assert.equal(await target.locator('pre').isVisible(), true);
  assert.match(await target.locator('pre').textContent(), /^scenario: from \w+ to \w+\nbehaviour: soccer\.yaml\nscript:\n/);
  await shot(page, 'soccer_plain');
});

await situation('at 200 % nothing is cut off at the side', 'soccer', { viewport: { width: 640, height: 450 }, deviceScaleFactor: 2 }, async (page) => {
  const [inner, whole] = await page.evaluate(() => [document.documentElement.clientWidth, document.documentElement.scrollWidth]);
  assert.ok(whole <= inner, `${whole} points in ${inner}`);
  await shot(page, 'soccer_200');
});

await situation('on paper there are no buttons, and it fits', 'soccer', {}, async (page) => {
  await page.emulateMedia({ media: 'print' });
  assert.equal(await page.locator('button:visible').count(), 0);
  const size = (where) => page.locator(where).first().evaluate((each) => parseFloat(getComputedStyle(each).fontSize));
  assert.ok((await size('#group-Kick .place')) < (await size('#group-Kick dd')));
  assert.deepEqual(await beyond(page), []);
  assert.equal(await page.locator('.rivals td').first().isVisible(), true);
  assert.equal(await page.locator('.rows summary').first().isVisible(), false);
  assert.deepEqual(await page.locator('h2, h3, h4').evaluateAll((all) => [...new Set(all.map((each) => getComputedStyle(each).breakAfter))]), ['avoid']);
  if (isLong) await page.pdf({ path: join(folder, 'soccer.pdf'), format: 'A4' });
});

await situation('on paper that is wider than high the picture is on one page', 'soccer', { viewport: { width: 1047, height: 718 } }, async (page) => {
  await page.emulateMedia({ media: 'print' });
  const height = await page.locator('.holder:not([hidden]) .picture svg').evaluate((svg) => svg.getBoundingClientRect().height);
  assert.ok(height > 300 && height < 0.9 * 718, `${height}`);
});

await situation('on paper a focus, and a cell that was chosen, change nothing but that the cell is explained, without its scenario', 'soccer', {}, async (page) => {
  await click(page.locator('#group-Kick button.focus'));
  await click(page.getByRole('link', { name: 'soft: from Walk to Kick', exact: true }));
  await page.emulateMedia({ media: 'print' });
  const looks = (where, key) => page.locator(where).evaluateAll((all, name) => [...new Set(all.map((each) => getComputedStyle(each)[name]))], key);
  assert.deepEqual(await looks('.holder:not([hidden]) g:is(.node, .edge, .label)', 'opacity'), ['1']);
  assert.deepEqual(await looks('.holder:not([hidden]) .chosen path', 'strokeWidth'), ['1px']);
  assert.deepEqual(await looks('.matrix td[aria-current] a', 'outlineStyle'), ['none']);
  assert.equal(await page.locator('#cell p').first().isVisible(), true);
  assert.equal(await page.locator('#cell pre').isVisible(), false);
});

await situation('on paper nothing of seventy groups is cut off at the side', 'robocup', { viewport: { width: 718, height: 1047 } }, async (page) => {
  await page.emulateMedia({ media: 'print' });
  const [inner, whole] = await page.evaluate(() => [document.documentElement.clientWidth, document.documentElement.scrollWidth]);
  assert.ok(whole <= inner, `${whole} points in ${inner}`);
  assert.deepEqual(await beyond(page), []);
  await page.locator('.matrix').evaluate((matrix) => matrix.scrollIntoView());
  await shot(page, 'robocup_paper');
});

await situation('on paper a table with long names is no wider than the page', 'long_takes', { viewport: { width: 718, height: 1047 } }, async (page) => {
  await page.emulateMedia({ media: 'print' });
  assert.equal(await page.locator('.wide table').count(), 2);
  for (const right of await page.locator('.wide table').evaluateAll((all) => all.map((each) => each.getBoundingClientRect().right))) assert.ok(right <= 718, `${right} points in 718`);
});

await situation('on paper a matrix of sixty columns stands in bands, each with the names of its rows, and none is cut off', 'wide', { viewport: { width: 718, height: 1047 } }, async (page) => {
  assert.equal(await page.locator('.bands').isVisible(), false);
  await page.emulateMedia({ media: 'print' });
  assert.equal(await page.locator('.matrix').isVisible(), false);
  const bands = await page.locator('.bands table').evaluateAll((all) =>
    all.map((table) => ({ caption: table.caption.textContent, rows: table.tBodies[0].rows.length, width: Math.ceil(table.getBoundingClientRect().right), cut: [...table.querySelectorAll('th, td, span')].filter((each) => each.scrollWidth > each.clientWidth + 1 && each.clientWidth > 0).length })));
  const caption = 'From the group of the row to that of the column; columns ';
  assert.deepEqual(bands.map(({ caption, rows, cut }) => ({ caption, rows, cut })), [{ caption: `${caption}1 to 30 of 60`, rows: 60, cut: 0 }, { caption: `${caption}31 to 60 of 60`, rows: 60, cut: 0 }]);
  for (const { width } of bands) assert.ok(width <= 718, `${width} points in 718`);
  await page.locator('.bands').evaluate((bands) => bands.scrollIntoView());
  await shot(page, 'wide_paper');
  if (isLong) await page.pdf({ path: join(folder, 'wide.pdf'), format: 'A4' });
});

for (const colorScheme of ['light', 'dark']) {
  await situation(`all that is written in a picture can be read, ${colorScheme}, and on paper it is light`, 'soccer', { colorScheme }, async (page) => {
    const look = () => page.evaluate(() => {
      const light = (color) => {
        const [r, g, b] = color.match(/[\d.]+/g).slice(0, 3).map((each) => (each / 255 <= 0.03928 ? each / 255 / 12.92 : ((each / 255 + 0.055) / 1.055) ** 2.4));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      const contrast = (a, b) => (Math.max(light(a), light(b)) + 0.05) / (Math.min(light(a), light(b)) + 0.05);
      const picture = document.querySelector('.picture');
      const paper = getComputedStyle(picture).backgroundColor;
      const band = getComputedStyle(picture.querySelector('.band')).fill;
      const least = (elements, key) => Math.min(...[...elements].flatMap((each) => [paper, band].map((below) => contrast(getComputedStyle(each)[key], below))));
      const halo = getComputedStyle(picture.querySelector('.halo')).fill;
      const label = Math.min(...[...picture.querySelectorAll('.label text:not(.halo)')].map((each) => contrast(getComputedStyle(each).fill, halo)));
      return { paper, label, text: least(picture.querySelectorAll('text:not(.halo)'), 'fill'), line: least(picture.querySelectorAll('.edge path, .node path[fill="none"]'), 'stroke') };
    });
    const seen = await look();
    assert.equal(seen.paper, colorScheme === 'dark' ? 'rgb(22, 25, 29)' : 'rgb(255, 255, 255)');
    assert.ok(seen.text >= 4.5, `${seen.text}`);
    assert.ok(seen.label >= 4.5, `${seen.label}`);
    assert.ok(seen.line >= 3, `${seen.line}`);
    await page.emulateMedia({ media: 'print', colorScheme });
    assert.equal((await look()).paper, 'rgb(255, 255, 255)');
  });
}

await situation('a picture of sixty groups side by side begins in its middle, with names that can be read, and grows as large as any', 'wide', {}, async (page) => {
  const seen = () => page.evaluate(() => {
    const frame = document.querySelector('.picture').getBoundingClientRect();
    const names = [...document.querySelectorAll('.picture g.node text')].map((text) => text.getBoundingClientRect());
    return { height: Math.max(...names.map(({ height }) => height)), inside: names.filter(({ left, right }) => left >= frame.left && right <= frame.right).length };
  });
  const first = await seen();
  assert.ok(first.height >= 9 && first.inside > 3, JSON.stringify(first));
  await shot(page, 'wide');
  for (let i = 0; i < 12; ++i) await page.getByRole('button', { name: 'Larger' }).click();
  const largest = await seen();
  assert.ok(largest.height >= 30, JSON.stringify(largest));
  await page.getByRole('button', { name: 'Whole' }).click();
  assert.deepEqual(await beyond(page), []);
});

for (const [name, tasks] of [['aside', 'what the program requests'], ['far', 'one of the tasks of the program, if they are too far apart']]) {
  await situation(`a picture that is wider than its frame begins at ${tasks}`, name, {}, async (page) => {
    const within = await page.evaluate(() => {
      const frame = document.querySelector('.picture').getBoundingClientRect();
      const roots = [...document.querySelectorAll('.picture g.node')].filter((node) => node.textContent.includes('▼'));
      return roots.map((node) => node.getBoundingClientRect()).filter(({ left, right }) => left >= frame.left && right <= frame.right).length;
    });
    assert.equal(within, 1);
    await shot(page, name);
  });
}

await situation('a search marks the boxes of modules and of layers in which the groups are', 'soccer', {}, async (page) => {
  await page.fill('#search', 'kick');
  const marked = async (view) => {
    await page.getByLabel(view, { exact: true }).check();
    return (await page.locator('.holder:not([hidden]) g.node.found title').allTextContents()).sort();
  };
  assert.deepEqual(await marked('All groups'), ['Kick', 'KickTo', 'KickToGoal']);
  assert.deepEqual(await marked('By module'), ['module kicking', 'module planning', 'module strategy']);
  assert.deepEqual(await marked('By layer'), ['layer planning', 'layer skill', 'layer strategy']);
});

for (const width of [390, 1280]) {
  await situation(`what the signs of a picture mean is below its frame, and can be read, also where the picture is wider than that (${width})`, 'aside', { viewport: { width, height: 844 } }, async (page) => {
    const rows = await page.locator('.signs .legend > div').evaluateAll((all) => all.map((row) => {
      const [sign, words] = [...row.children].map((each) => each.getBoundingClientRect());
      return { text: row.textContent, sample: row.querySelectorAll('svg :is(polyline, text)').length, beside: sign.right <= words.left && Math.abs(sign.top - words.top) < 2, right: words.right, size: parseFloat(getComputedStyle(row).fontSize) };
    }));
    assert.deepEqual(rows.map(({ text, sample }) => `${sample} ${text}`), ['2 ▶requests', '2 ●needs: holds it while it runs', '0 thick framethe program itself requests it', '0 outer framethe focus, or found by the search']);
    for (const { beside, right, size } of rows) assert.ok(beside && right <= width && size >= 12, `${beside} ${right} ${size}`);
    assert.equal(await page.locator('.picture svg g.graph > text').count(), 0);
    await shot(page, `aside_${width}`);
  });
}

await situation('a picture without signs has no title either, as nothing is below it', 'no_roots', {}, async (page) => {
  assert.deepEqual(await page.locator('.picture svg text').allTextContents(), ['Only']);
  assert.equal(await page.locator('.signs').count(), 0);
});

await situation('the focus and what is found have an outer frame, and no thick one, which is of what the program requests', 'soccer', {}, async (page) => {
  const look = (name) => page.locator(`.holder:not([hidden]) g.node:has(> title:text-is("${name}"))`).evaluate((node) => [getComputedStyle(node).outlineStyle, getComputedStyle(node.querySelector('path')).strokeWidth]);
  const [, usual] = await look('Kick');
  await click(page.locator('#group-Kick button.focus'));
  assert.deepEqual([await look('Kick'), await look('KickTo')], [['solid', usual], ['none', usual]]);
  await page.fill('#search', 'kickto');
  assert.deepEqual(await look('KickTo'), ['solid', usual]);
});

for (const [name, parts] of [['alone', 0], ['flat', 4]]) {
  await situation(`a picture that would be too small on paper is printed in parts too, all of which have something of the next (${parts})`, name, {}, async (page) => {
    await page.emulateMedia({ media: 'print' });
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    const views = await page.locator('.pieces svg').evaluateAll((all) => all.map((each) => each.viewBox.baseVal).map(({ x, width }) => [x, x + width]));
    assert.equal(views.length, parts);
    if (parts === 0) return;
    const whole = await page.locator('.picture svg').evaluate((svg) => svg.viewBox.baseVal.width);
    const ends = views.map(([, end]) => end);
    assert.deepEqual([views[0][0], Math.round(ends.at(-1))], [0, Math.round(whole)]);
    for (const [i, [x, end]] of views.entries()) assert.ok(end - x <= 961 && (i === 0 || x <= ends[i - 1] - 100), `${x} ${end}`);
    for (const name of ['Play', 'Leaf1', 'Leaf36']) assert.equal(await page.locator(`.pieces g.node > title:text-is("${name}")`).count(), parts);
    await shot(page, `${name}_print`);
    await page.evaluate(() => dispatchEvent(new Event('afterprint')));
    assert.equal(await page.locator('.pieces svg').count(), 0);
  });
}

await situation('a flat picture that has room in height begins at a size that can be read, though half of that would show all of it', 'flat', {}, async (page) => {
  const heights = await page.locator('.picture g.node text').evaluateAll((all) => all.map((text) => text.getBoundingClientRect().height));
  assert.ok(Math.max(...heights) >= 10, `${Math.max(...heights)}`);
});

await situation('a picture of one group is as large as on paper, in a frame that is no higher than it needs', 'alone', {}, async (page) => {
  const { text, frame } = await page.evaluate(() => ({
    text: Math.max(...[...document.querySelectorAll('.picture g.node text')].map((each) => each.getBoundingClientRect().height)),
    frame: document.querySelector('.picture').getBoundingClientRect().height,
  }));
  assert.ok(text >= 10 && text <= 25, `${text}`);
  assert.ok(frame <= 260, `${frame}`);
  await shot(page, 'alone');
});

for (const width of [390, 1280]) {
  await situation(`names that are longer than a line are broken, none is cut off (${width})`, 'long_names', { viewport: { width, height: 844 } }, async (page) => {
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
    const cut = await page.locator('h1, h3, h4, p, li, dt, dd').evaluateAll((all) => all.filter((each) => each.scrollWidth > each.clientWidth + 1).map((each) => each.textContent));
    assert.deepEqual(cut, []);
    const [head, first] = await page.locator('.matrix tbody tr:first-child > *').evaluateAll((all) => all.map((each) => each.getBoundingClientRect().right));
    assert.ok(head < width / 2 && first < width, `${head} ${first}`);
    await shot(page, `long_names_${width}`);
  });
}

await situation('what signs mean stands in one column', 'soccer', {}, async (page) => {
  const lefts = await page.locator('#transitions .legend > div').evaluateAll((all) => all.map((each) => Math.round(each.lastElementChild.getBoundingClientRect().left - each.getBoundingClientRect().left)));
  assert.equal(new Set(lefts).size, 1, `${lefts}`);
});

await situation('seventy groups are one page of at most 1.6 MB', 'robocup', {}, async (page) => {
  assert.ok(statSync(join(folder, 'robocup.html')).size <= 1.6e6);
  await page.fill('#search', 'walk');
  await page.keyboard.press('Enter');
  await shot(page, 'robocup_focus');
});

await situation('the policy refuses a script that is not its own', 'photo', {}, async (page, said) => {
  const told = page.waitForEvent('console');
  const blocked = page.evaluate(() => new Promise((resolve) => document.addEventListener('securitypolicyviolation', (event) => resolve(event.effectiveDirective), { once: true })));
  await page.evaluate(() => {
    const script = document.createElement('script');
    script.textContent = 'globalThis.ran = true';
    document.body.append(script);
  });
  assert.equal(await blocked, 'script-src-elem');
  assert.equal(await page.evaluate(() => globalThis.ran), undefined);
  await told;
  assert.match(said.splice(0).join(), /violates the following Content Security Policy/);
});

await all.end();

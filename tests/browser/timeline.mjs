// SPDX-License-Identifier: MIT
// node timeline.mjs CHROMIUM FOLDER: tests what users do with the pages in FOLDER that have a recording. Saves screenshots there (situations.mjs).
import { strict as assert } from 'node:assert';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { check, isLong, Situations } from './situations.mjs';

const [program, folder] = process.argv.slice(2);
const all = await Situations.open(program, folder);
const laptop = { viewport: { width: 1366, height: 768 } };

/** Runs a situation; it begins when the recording is decoded. */
const situation = (title, name, options, act) =>
  all.run(title, name, { ...laptop, ...options }, async (page, said) => {
    await page.waitForSelector('#scrub[aria-valuetext]');
    await page.locator('#timeline').evaluate((section) => section.scrollIntoView());
    await act(page, said);
  });

/** Waits until the next frame is drawn, with all changes that are due in it. */
const frame = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const press = async (page, ...keys) => {
  await page.locator('#scrub').focus();
  for (const key of keys) await page.keyboard.press(key);
  await frame(page);
};
const where = (page) => page.locator('.where').textContent();
const marked = (page, mark) => page.locator(`.holder:not([hidden]) g.node.is-${mark} > title`).allTextContents().then((names) => names.sort());
const lines = (page, part) => page.locator(`#moment h4:text-is("${part}") + ul > li`).allTextContents();
const box = (page) => page.locator('#scrub').boundingBox();

/** Waits until `holds` returns true; the page's Content-Security-Policy forbids Playwright's own way to wait for that. */
async function until(page, holds) {
  for (let i = 0; i < 300 && !(await holds()); ++i) await page.waitForTimeout(50);
  assert.ok(await holds());
}

/** Clicks at this part of the tracks: of the whole recording, unless they are zoomed. */
async function scrubTo(page, part) {
  const { x, y, width } = await box(page);
  await page.mouse.move(x + width * part, y + 60);
  await page.mouse.down();
  await page.mouse.up();
  await frame(page);
}

/** The texts in boxes of the picture that come close to the right side of the box's frame, or go beyond it. */
const beyondFrames = (page) => page.evaluate(() => [...document.querySelectorAll('.holder:not([hidden]) g.node')].flatMap((node) => {
  const frame = node.querySelector('path')?.getBBox();
  return frame ? [...node.querySelectorAll('text')].filter((text) => text.getBBox().x + text.getBBox().width > frame.x + frame.width - 2).map((text) => text.textContent) : [];
}));

for (const colorScheme of ['light', 'dark']) {
  for (const name of colorScheme === 'light' || isLong ? ['minute', 'gap', 'rover'] : ['rover']) {
    await situation(`axe finds nothing, ${colorScheme}`, name, { colorScheme, bypassCSP: true }, async (page) => {
      await press(page, 'PageUp', 'PageUp', 'ArrowRight', 'ArrowRight', 'ArrowRight');
      assert.deepEqual(await beyondFrames(page), []);
      await all.shot(page, `${name}_${colorScheme}`);
      await page.locator('.filter summary').click();
      await check(page);
      await all.shot(page, `${name}_${colorScheme}_filter`);
    });
  }
}

await situation('steps go from decision to decision, and picture, words and list show each', 'rover', {}, async (page) => {
  assert.match(await where(page), /^0\.000 s, after event \d+ of 42: run Wheels new_task$/);
  await press(page, 'Home');
  for (let i = 0; i < 3; ++i) await page.getByRole('button', { name: 'Previous event' }).click();
  await frame(page);
  const texts = [];
  for (let i = 0; i < 12; ++i) {
    texts.push((await where(page)).split(': ').slice(1).join(': ').replace(/, and what was decided with it, up to event \d+$/, ''));
    await page.getByRole('button', { name: 'Next event' }).click();
    await frame(page);
  }
  assert.deepEqual(texts.slice(0, 6), ['> request Photograph', 'push Drive.braking for root>Photograph', 'queue root>Photograph: waiting for Motion == still', 'set Motion still', 'queue Explore>Drive: blocked', 'hand over Wheels from Drive>Wheels to Photograph>Wheels'].slice(0, 6));
});

await situation('a push is shown: who waits and why, who is pushed for it, in words and in the picture', 'rover', {}, async (page) => {
  assert.deepEqual(await lines(page, 'Waits'), [
    'Photograph waits (root>Photograph): until Motion == still, which Drive.braking could cause' +
      'Motion is rolling (tests/docs/rover/rover.yaml:21)' + 'Drive.braking is to cause it: pushed for root>Photograph (tests/docs/rover/rover.yaml:36)',
  ]);
  assert.deepEqual(await page.locator('#moment .notes a').evaluateAll((all) => all.map((each) => each.href)), [21, 36].map((line) => `https://git.example.org/tests/docs/rover/rover.yaml#L${line}`));
  assert.deepEqual(await lines(page, 'Pushed'), ['Drive: pushed to braking for Photograph, to cause Motion == still']);
  assert.deepEqual(await lines(page, 'States'), ['Motion == rolling']);
  assert.deepEqual([await marked(page, 'running'), await marked(page, 'pushed'), await marked(page, 'queued'), await marked(page, 'inactive')], [['Explore', 'Wheels'], ['Drive'], ['Photograph'], ['Camera']]);
  assert.deepEqual(await page.locator('.holder:not([hidden]) g.edge.is-pushed > title').allTextContents(), ['Photograph → Drive.braking']);
  assert.deepEqual((await page.locator('.holder:not([hidden]) .note').allTextContents()).sort(), ['pushed to braking for Photograph', 'queued: until Motion == still']);
  assert.deepEqual(await page.locator('.holder:not([hidden]) .note').evaluateAll((all) => all.map((note) => {
    const [paper, frame] = [note.querySelector('rect'), note.closest('.picture')].map((each) => each.getBoundingClientRect());
    const isWithin = (inner, outer) => inner.left >= outer.left - 1 && inner.right <= outer.right + 1;
    return isWithin(paper, frame) && [...note.querySelectorAll('text')].every((line) => isWithin(line.getBoundingClientRect(), paper));
  })), [true, true]);
  assert.equal(await page.locator('.holder:not([hidden]) text', { hasText: '▶ braking' }).count(), 1);
  assert.deepEqual(await beyondFrames(page), []);
  await all.shot(page, 'rover_push');
  const roots = () => page.locator('.holder:not([hidden]) .signs .legend > div', { hasText: 'the program itself requests it' }).textContent();
  assert.equal(await roots(), '▼ programthe program itself requests it, with that priority');
  await page.getByLabel('Moment in the picture').uncheck();
  await frame(page);
  assert.equal(await roots(), 'thick framethe program itself requests it, with that priority');
  assert.deepEqual([await marked(page, 'running'), await page.locator('.note').count(), await page.locator('svg.moment').count()], [[], 0, 0]);
});

await situation('between the events of a micro-step the situation at its end is shown, so that words, states and picture agree', 'rover', {}, async (page) => {
  for (let i = 0; i < 9 && !/: set Motion still/.test(await where(page)); ++i) await press(page, 'ArrowRight');
  assert.match(await where(page), /^1\.000 s, after event (\d+) of 42: set Motion still, and what was decided with it, up to event \d+$/);
  const atFirst = await page.locator('#moment').innerText();
  assert.deepEqual([await lines(page, 'States'), (await lines(page, 'Waits')).map((line) => line.slice(0, 29)), await lines(page, 'Runs')], [['Motion == still'], ['Drive waits (Explore>Drive): '], ['Explore: for the program', 'Photograph: for the program', 'Wheels: for Photograph']]);
  assert.deepEqual([await marked(page, 'queued'), await marked(page, 'running')], [['Drive'], ['Explore', 'Photograph', 'Wheels']]);
  await press(page, 'ArrowRight');
  assert.match(await where(page), /: queue Explore>Drive: blocked, and what was decided with it, up to event \d+$/);
  assert.equal(await page.locator('#moment').innerText(), atFirst);
});

await situation('a focused group is in the frame, also where words above that make it lower', 'warehouse', {}, async (page) => {
  for (const name of await page.locator('article.group').evaluateAll((all) => all.map((each) => each.dataset.group))) {
    await page.locator(`#group-${name} button.focus`).evaluate((button) => button.click());
    await frame(page);
    const seen = await page.locator('.holder:not([hidden]) g.node.chosen').evaluate((node) => {
      const [box, paper] = [node, node.closest('.picture')].map((each) => each.getBoundingClientRect());
      const others = [...node.ownerSVGElement.querySelectorAll('g.node.near')].filter((each) => each !== node).filter((each) => {
        const { left, right, top, bottom } = each.getBoundingClientRect();
        return left < paper.left || right > paper.right || top < paper.top || bottom > paper.bottom;
      });
      const isIn = box.height > paper.height || (box.top >= paper.top && box.bottom <= paper.bottom);
      return { isIn, outside: others.map((each) => each.querySelector('title').textContent) };
    });
    assert.ok(seen.isIn, name);
    const [, outside] = (await page.locator('#focused').textContent()).split(' Outside of the frame: ');
    assert.deepEqual(outside?.replace(/\.$/, '').split(', ') ?? [], seen.outside, name);
  }
});

await situation('a click on a name with the sign focuses that group', 'letters', {}, async (page) => {
  await press(page, 'End');
  // Without --link, boxes are no links.
  await page.locator('.holder:not([hidden]) svg a').evaluateAll((all) => all.forEach((link) => link.removeAttributeNS('http://www.w3.org/1999/xlink', 'href')));
  const sign = page.locator('.holder:not([hidden]) g.node text', { hasText: '▶ D' }).locator('tspan');
  await sign.dispatchEvent('click');
  assert.match(await page.locator('#focused').textContent(), /^Focus on D: /);
});

for (const name of ['letters', 'minute']) {
  await situation('beside the sign of what runs, names are not crushed, and those in the middle of their frame stay there', name, {}, async (page) => {
    await scrubTo(page, 0.5);
    await all.shot(page, `${name}_signs`);
    const names = await page.locator('.holder:not([hidden]) g.node text').evaluateAll((all) => all.filter((text) => text.textContent.startsWith('▶ ')).map((text) => {
      const path = text.closest('g.node > a > g, g.node > g')?.querySelector('path');
      const written = text.getBBox();
      const frame = path?.getBBox();
      const off = frame ? written.x - frame.x - (frame.x + frame.width - written.x - written.width) : 0;
      const length = text.getAttribute('textLength');
      text.removeAttribute('textLength');
      return { name: text.textContent, share: length ? length / text.getBBox().width : 1, inGroup: frame !== undefined, off };
    }));
    assert.ok(names.length > 3, `${names.length}`);
    assert.ok(names.some(({ inGroup }) => inGroup));
    assert.deepEqual(names.filter(({ share, off }) => share < 0.75 || Math.abs(off) > 2), []);
  });
}

await situation('a note hides nothing that is written in boxes or beside arrows, where there is a place for it', 'warehouse', {}, async (page) => {
  const hidden = () => page.evaluate(() => [...document.querySelectorAll('.holder:not([hidden]) .note')].flatMap((note) => {
    const paper = note.getBoundingClientRect();
    return [...note.closest('svg').querySelectorAll('g.node text, g.label text')].filter((text) => {
      const { left, right, top, bottom } = text.getBoundingClientRect();
      return Math.min(right, paper.right) - Math.max(left, paper.left) > 1 && Math.min(bottom, paper.bottom) - Math.max(top, paper.top) > 1;
    }).map((text) => `${note.textContent} hides ${text.textContent}`);
  }));
  await press(page, 'Home');
  let notes = 0;
  for (let i = 0; i < 25; ++i) {
    assert.deepEqual(await hidden(), []);
    notes += await page.locator('.holder:not([hidden]) .note').count();
    await press(page, 'ArrowRight');
  }
  assert.ok(notes > 20, `${notes}`);
});

await situation('an arrow of what is queued has a bar, so that it is no matter of colour', 'warehouse', {}, async (page) => {
  const barred = () => page.locator('.holder:not([hidden]) g.edge:has(.bar) > title').allTextContents();
  await press(page, 'Home');
  assert.deepEqual(await barred(), ['Orders.going_out → Travel']);
  assert.deepEqual(await page.locator('.holder:not([hidden]) g.edge.is-queued > title').allTextContents(), await barred());
  await press(page, 'ArrowRight');
  assert.deepEqual(await barred(), ['Orders.going_out → MoveArm']);
  await all.shot(page, 'warehouse_queued');
  await page.getByLabel('Moment in the picture').uncheck();
  await frame(page);
  assert.deepEqual(await barred(), []);
});

await situation('of several packs only the lines of the one that is requested are marked, unless others request alike', 'packs', {}, async (page) => {
  const edges = (mark) => page.locator(`.holder:not([hidden]) g.edge.is-${mark} > title`).allTextContents().then((all) => all.filter((title) => title.startsWith('Plan')).sort());
  await scrubTo(page, 0.25);
  assert.deepEqual([await edges('running'), await edges('queued')], [['Plan.alike → Walk', 'Plan.stroll → Walk'], []]);
  await press(page, 'End');
  assert.deepEqual([await edges('running'), await edges('queued')], [[], ['Plan.alike → Walk', 'Plan.stroll → Walk']]);
  assert.deepEqual(await edges('inactive'), ['Plan.alike → Look', 'Plan.go → Look', 'Plan.go → Walk']);
  await all.shot(page, 'packs');
});

await situation('a note is whole on the paper of its picture, also where it is wider than that in one line', 'wide', {}, async (page) => {
  await press(page, 'End');
  const notes = await page.locator('.holder:not([hidden]) .note').evaluateAll((all) => all.map((note) => {
    const paper = note.closest('svg').getBoundingClientRect();
    const parts = [note, ...note.querySelectorAll('text')].map((part) => part.getBoundingClientRect());
    const isWhole = parts.every(({ left, right, top, bottom }) => left >= paper.left && right <= paper.right && top >= paper.top && bottom <= paper.bottom);
    return [note.textContent, isWhole];
  }));
  await all.shot(page, 'wide');
  assert.deepEqual(notes, [['queued: blocked, as SharedThingWithAnEvenLongerNameThanTheOthers is held by TheOtherTaskThatHoldsAllOfTheSharedThing', true]]);
});

await situation('the event of the moment is in sight among those around it', 'minute', {}, async (page) => {
  for (const part of [0, 0.2, 0.5, 0.9, 1]) {
    await scrubTo(page, Math.min(part, 0.999));
    if (part === 1) await press(page, 'End');
    const [list, row] = await page.evaluate(() => [document.getElementById('events'), document.querySelector('#events [aria-current]')].map((each) => {
      const { top, bottom } = each.getBoundingClientRect();
      return { top, bottom };
    }));
    assert.ok(row.top >= list.top && row.bottom <= list.bottom, `${row.top} to ${row.bottom} in ${list.top} to ${list.bottom}`);
  }
});

await situation('the mouse scrubs, and drags', 'minute', {}, async (page) => {
  await scrubTo(page, 0.5);
  assert.match(await where(page), /^30\.[12]\d+ s, after event [\d,]+ of [\d,]+: /);
  const { x, y, width } = await box(page);
  await page.mouse.move(x + width / 2, y + 60);
  await page.mouse.down();
  await page.mouse.move(x + width / 4, y + 60, { steps: 5 });
  await page.mouse.up();
  await frame(page);
  assert.match(await where(page), /^1[45]\.\d+ s, /);
  const value = Number(await page.locator('#scrub').getAttribute('aria-valuenow'));
  assert.ok(value > 14 && value < 16);
});

await situation('the keyboard goes to events, further, to both ends, and zooms around the moment', 'minute', {}, async (page) => {
  await press(page, 'End');
  assert.match(await where(page), /^60\.000 s, /);
  await press(page, 'Home');
  assert.match(await where(page), /^0\.010 s, /);
  await press(page, 'PageUp');
  assert.match(await where(page), /^6\.049 s, /);
  const from = await where(page);
  await press(page, 'ArrowRight', 'ArrowLeft');
  const before = await where(page);
  assert.ok(parseFloat(before) <= parseFloat(from), `${before}, ${from}`);
  const place = () => page.locator('.overview .window').evaluate((window) => window.style.width);
  const whole = await place();
  await press(page, '+', '+');
  assert.ok(parseFloat(await place()) < parseFloat(whole) / 3);
  await press(page, '0');
  assert.equal(await place(), whole);
  const { x, y } = await box(page);
  await page.mouse.move(x + 100, y + 100);
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, -400);
  await page.keyboard.up('Control');
  await frame(page);
  assert.ok(parseFloat(await place()) < parseFloat(whole));
});

await situation('playing moves the moment, at the speed that is chosen, until it is paused or at the end', 'minute', {}, async (page) => {
  const time = async () => parseFloat(await where(page));
  await page.getByLabel('Speed').selectOption('10');
  await page.getByRole('button', { name: 'Play' }).click();
  await until(page, async () => (await time()) > 2);
  await page.getByRole('button', { name: 'Pause' }).click();
  await frame(page);
  const paused = await time();
  await page.waitForTimeout(100);
  assert.equal(await time(), paused);
  await press(page, 'End', ' ');
  await until(page, async () => (await time()) < 30); // it plays from the beginning again
  await press(page, ' ');
  assert.equal(await page.getByRole('button', { name: 'Play' }).count(), 1);
});

await situation('the filter says which events are stepped to and listed, and which groups have a track', 'minute', {}, async (page) => {
  await page.locator('.filter summary').click();
  for (const box of await page.locator('.filter fieldset:first-of-type input').all()) await box.uncheck();
  assert.deepEqual(await page.locator('#events li').allTextContents(), ['None that the filter lets through.']);
  await page.getByLabel('pushes', { exact: true }).check();
  await page.locator('.filter summary').click();
  await press(page, 'ArrowRight');
  assert.match(await where(page), /: push Walk\.halting for KickTo>Kick, and what was decided with it, up to event [\d,]+$/);
  const listed = await page.locator('#events li button').evaluateAll((all) => all.map((each) => each.lastChild.textContent));
  assert.deepEqual([...new Set(listed)].sort(), ['push Walk.halting for KickTo>Kick', 'release Walk']);
  const before = await page.locator('.labels a').count();
  await page.locator('.filter summary').click();
  await page.getByRole('button', { name: 'No group' }).click();
  await page.getByLabel('Kick', { exact: true }).check();
  await frame(page);
  assert.deepEqual(await page.locator('.labels a').allTextContents(), ['Kick', 'Phase', 'Stability', 'Ball', 'RisingStep']);
  await page.getByRole('button', { name: 'Those to which something happens' }).click();
  await frame(page);
  assert.equal(await page.locator('.labels a').count(), before);
});

await situation('above the list of events it is said which kinds the filter hides', 'minute', {}, async (page) => {
  const hidden = () => page.locator('#events > p').textContent();
  assert.equal(await hidden(), 'Hidden by the filter: other inputs, runs, what bodies request, granted, lost and withdrawn, done and failed.');
  await page.locator('.filter summary').click();
  await page.getByLabel('runs', { exact: true }).check();
  await page.getByLabel('pushes', { exact: true }).uncheck();
  await frame(page);
  assert.equal(await hidden(), 'Hidden by the filter: other inputs, what bodies request, granted, lost and withdrawn, pushes, done and failed.');
  for (const box of await page.locator('.filter fieldset:first-of-type input').all()) await box.check();
  await frame(page);
  assert.equal(await hidden(), '');
});

/** Goes to the first push. */
async function goToPush(page) {
  await page.locator('.filter summary').click();
  for (const box of await page.locator('.filter fieldset:first-of-type input').all()) await box.uncheck();
  await page.getByLabel('pushes', { exact: true }).check();
  await page.locator('.filter summary').click();
  await press(page, 'ArrowRight');
  assert.match(await where(page), /: push Walk\.halting for KickTo>Kick/);
}

await situation('by module and by layer too the picture shows which groups run, which push is in force, and who is pushed', 'minute', {}, async (page) => {
  await goToPush(page);
  const names = (all) => all.map((line) => line.split(':')[0]);
  const running = [...names(await lines(page, 'Runs')), ...names(await lines(page, 'Pushed'))].sort();
  assert.ok(running.length > 4 && running.includes('Walk') && !running.includes('Kick'), `${running}`);
  // Where the box has several groups the note names its group; both of these are in one layer.
  for (const [view, pushes, notes] of [
    ['By module', ['module kicking → module locomotion'], ['pushed to halting for Kick', 'queued: until Stability == standing']],
    ['By layer', [], ['Walk: pushed to halting for Kick Kick: queued: until Stability == standing']],
  ]) {
    await page.getByLabel(view, { exact: true }).check();
    await frame(page);
    const signs = await page.locator('.holder:not([hidden]) g.node text').evaluateAll((all) => all.map((text) => text.textContent).filter((text) => text.startsWith('▶ ')).map((text) => text.slice(2)).sort());
    assert.deepEqual(signs, running);
    assert.deepEqual(await page.locator('.holder:not([hidden]) g.edge.is-pushed > title').allTextContents(), pushes);
    assert.deepEqual((await page.locator('.holder:not([hidden]) .note').allTextContents()).sort(), notes);
    await all.shot(page, `minute_push_${view}`);
  }
});

await situation('a box of several groups is of what runs, as `graph --step` draws it, and has each of them that waits in red', 'fold', {}, async (page) => {
  await press(page, 'End');
  await page.getByLabel('By module', { exact: true }).check();
  await frame(page);
  assert.deepEqual([await marked(page, 'running'), await marked(page, 'queued')], [['module fold'], []]);
  const lines = page.locator('.holder:not([hidden]) .note text');
  assert.equal((await lines.allTextContents()).join(''), 'Wait: queued: until S == b Other: queued: until S == b');
  const colours = (all) => all.evaluateAll((texts) => [...new Set(texts.map((text) => getComputedStyle(text).fill))]);
  assert.deepEqual(await colours(lines), ['rgb(163, 23, 26)']);
  const named = (name) => page.locator('.holder:not([hidden]) g.node text').filter({ hasText: name });
  assert.deepEqual([await colours(named(/^Wait$/)), await colours(named(/^▶ Run$/)), await colours(named(/^Late$/))], [['rgb(163, 23, 26)'], ['rgb(0, 98, 155)'], ['rgb(90, 97, 107)']]);
  await all.shot(page, 'fold_module');
});

await situation('what is not requested has a pale frame, a root task too', 'fold', {}, async (page) => {
  await press(page, 'End');
  const frames = await page.locator('.holder:not([hidden]) g.node.is-inactive path[fill="none"]').evaluateAll((all) => all.map((frame) => getComputedStyle(frame).stroke));
  assert.deepEqual([...new Set(frames)], ['rgb(138, 145, 155)']);
  assert.ok(frames.length > 1);
  await all.shot(page, 'fold');
});

await situation('with a focus the note of the group is in the frame too', 'minute', {}, async (page) => {
  await goToPush(page);
  for (const group of ['Kick', 'Walk']) {
    await page.locator(`#group-${group} button.focus`).evaluate((button) => button.click());
    await frame(page);
    const beyond = await page.locator('.holder:not([hidden]) .note').evaluateAll((all) => all.filter((note) => {
      const [paper, frame] = [note, note.closest('.picture')].map((each) => each.getBoundingClientRect());
      return paper.left < frame.left || paper.right > frame.right || paper.top < frame.top || paper.bottom > frame.bottom;
    }).map((note) => note.textContent));
    assert.deepEqual(beyond, []);
    await all.shot(page, `minute_focus_${group}`);
  }
});

await situation('the filter is whole on the screen, where it is narrow too', 'minute', {}, async (page) => {
  await page.locator('.filter summary').click();
  for (const width of [1040, 1280, 1400]) {
    await page.setViewportSize({ width, height: 900 });
    const { left, right } = await page.locator('.filter > div').evaluate((box) => box.getBoundingClientRect().toJSON());
    assert.ok(left >= 0 && right <= width, `${left} to ${right} of ${width}`);
  }
});

await situation('a time that is entered is gone to, and who is not requested then is told, with who may request it', 'minute', {}, async (page) => {
  await page.getByLabel('Go to').fill('3.2');
  await page.keyboard.press('Enter');
  await frame(page);
  assert.match(await where(page), /^3\.200 s, after event /);
  assert.deepEqual((await lines(page, 'Not requested')).filter((line) => line.startsWith('Kick:')), ['Kick: KickTo may request it']);
  await page.getByLabel('Go to').fill('100');
  await page.keyboard.press('Enter');
  await frame(page);
  assert.match(await where(page), /^60\.000 s, /);
});

await situation('what is inactive can be read in the picture, its labels too', 'minute', {}, async (page) => {
  await scrubTo(page, 0.2);
  const pale = await page.locator('.holder:not([hidden]) text').evaluateAll((all) =>
    all.filter((text) => {
      for (let up = text; up instanceof SVGElement; up = up.parentElement) if (Number(getComputedStyle(up).opacity) < 1) return true;
      return false;
    }).map((text) => text.textContent));
  assert.deepEqual(pale, []);
});

await situation('where the tracks are scrolled, the ruler stays above them; a name that is cut off can be read', 'minute', {}, async (page) => {
  const top = await page.locator('.lanes').evaluate((lanes) => {
    lanes.scrollTop = 100;
    const { left, right, top: edge } = lanes.getBoundingClientRect();
    const canvas = lanes.querySelector('.ruler').getBoundingClientRect();
    return { scrolled: lanes.scrollTop, ruler: canvas.top - edge, label: document.elementFromPoint(left + 20, edge + 15).className, right: right > canvas.left };
  });
  assert.deepEqual(top, { scrolled: 100, ruler: 1, label: 'labels', right: true });
  const isDrawn = await page.locator('.ruler').evaluate((ruler) => new Set(ruler.getContext('2d').getImageData(0, 0, ruler.width, ruler.height).data).size > 10);
  assert.ok(isDrawn);
  assert.equal(await page.locator('.labels a[href="#group-FallRecovery"]').getAttribute('title'), 'FallRecovery');
  await all.shot(page, 'minute_scrolled');
});

for (const colorScheme of ['light', 'dark']) {
  await situation(`what is written on a pushed slice can be read over its stripes, ${colorScheme}`, 'rover', { colorScheme }, async (page) => {
    const contrasts = await page.locator('canvas.slices').evaluate((canvas) => {
      const scale = canvas.height / canvas.getBoundingClientRect().height;
      const { data } = canvas.getContext('2d').getImageData(canvas.width * 0.7, (34 + 2 * 20 + 4) * scale, 60, 10 * scale); // behind the text of Drive
      const light = (colour) => colour.reduce((sum, each, i) => sum + [0.2126, 0.7152, 0.0722][i] * (each / 255 <= 0.04045 ? each / 255 / 12.92 : ((each / 255 + 0.055) / 1.055) ** 2.4), 0);
      return Array.from({ length: data.length / 4 }, (_, i) => 1.05 / (light([...data.subarray(4 * i, 4 * i + 3)]) + 0.05));
    });
    assert.ok(Math.min(...contrasts) >= 4.5, `${Math.min(...contrasts)} to ${Math.max(...contrasts)}`);
    assert.ok(Math.max(...contrasts) > 1.5 * Math.min(...contrasts)); // the stripes can be seen
  });
}

await situation('the list marks the event that the caption names, also where the filter leaves it out', 'rover', {}, async (page) => {
  const current = () => page.locator('#events [aria-current]').evaluateAll((all) => all.map((each) => each.lastChild.textContent));
  assert.match(await where(page), /: run Wheels new_task$/);
  assert.deepEqual(await current(), ['run Wheels new_task']);
  await press(page, 'ArrowRight');
  assert.deepEqual(await current(), ['set Motion still']);
  assert.equal(await page.locator('#events button', { hasText: 'run Wheels' }).count(), 0);
});

await situation('a slice says under the pointer what it is', 'rover', {}, async (page) => {
  const { x, y, width } = await box(page);
  await page.mouse.move(x + width / 2, y + 34 + 2 * 20 + 10);
  assert.equal(await page.locator('.tip').textContent(), 'Drive: pushed to braking for Photograph\n0.000 s to 1.000 s');
  await page.mouse.move(x + width / 2, y + 34 + 5 * 20 + 10);
  assert.equal(await page.locator('.tip').textContent(), 'Motion: rolling\n0.000 s to 1.000 s');
  await page.mouse.move(x + width - 3, y + 34 + 5 * 20 + 10); // what the last events change has a width
  assert.equal(await page.locator('.tip').textContent(), 'Motion: rolling\nfrom 1.000 s on');
  await page.mouse.move(x + width / 2, y + 10);
  assert.equal(await page.locator('.tip').isVisible(), false);
});

await situation('a slice of who is blocked says by whom', 'blocked', {}, async (page) => {
  const { x, y, width } = await box(page);
  const tips = [];
  for (const row of [0, 1, 2]) {
    await page.mouse.move(x + width / 2, y + 34 + row * 20 + 10);
    tips.push((await page.locator('.tip').textContent()).split('\n')[0]);
  }
  assert.deepEqual(tips, ['GetUp: running, for the program', 'Walk: queued: blocked, as Legs is held by GetUp', 'Legs: queued: blocked, as Legs is held by GetUp']);
  assert.deepEqual((await page.locator('.holder:not([hidden]) .note').allTextContents()).sort(), ['queued: blocked, as Legs is held by GetUp', 'queued: blocked, as Legs is held by GetUp']);
  await all.shot(page, 'blocked');
  // All events have the same time; what runs then must be drawn nevertheless.
  const drawn = await page.locator('canvas.slices').evaluate((canvas) => [...canvas.getContext('2d').getImageData(canvas.width / 2, (34 + 4) * devicePixelRatio, 1, 1).data]);
  assert.deepEqual(drawn, [0, 98, 155, 255]);
});

await situation('a broken promise is marked above the tracks, on its track and in the overview', 'broken', {}, async (page) => {
  // Whether the row of points at that height has the colour of faults around each of two parts of the width.
  const red = (where, y) => page.locator(where).evaluate((canvas, y) => {
    const scale = canvas.height / canvas.getBoundingClientRect().height;
    const { data } = canvas.getContext('2d').getImageData(0, y * scale, canvas.width, 1);
    const around = (x) => data.subarray(4 * Math.floor(canvas.width * (x - 0.02)), 4 * Math.floor(canvas.width * (x + 0.02))).join();
    return [0.4, 0.49].map((x) => around(x).includes('163,23,26,255'));
  }, y);
  assert.match(await page.locator('.looks').textContent(), /✖ fault or loss/);
  for (const [where, y] of [['.ruler', 24], ['canvas.slices', 34 + 10], ['.overview canvas', 12]]) assert.deepEqual(await red(where, y), [false, true], where); // at 1 s
});

await situation('names that begin alike are cut before their ends', 'broken', { viewport: { width: 360, height: 640 } }, async (page) => {
  const ends = await page.locator('.labels a').evaluateAll((all) => all.slice(0, 2).map((name) => {
    const end = name.querySelector('.end');
    return { text: name.textContent, end: end.textContent, whole: end.scrollWidth <= end.clientWidth && end.getBoundingClientRect().right <= name.getBoundingClientRect().right, cut: name.firstChild.scrollWidth > name.firstChild.clientWidth };
  }));
  assert.deepEqual(ends, [
    { text: 'ControlHydraulicValveBlockOfLeftArm', end: 'kOfLeftArm', whole: true, cut: true },
    { text: 'ControlHydraulicValveBlockOfRightArm', end: 'OfRightArm', whole: true, cut: true },
  ]);
});

await situation('behind a gap nothing is known until it is told, and why not', 'gap', {}, async (page) => {
  await page.locator('.filter summary').click();
  for (const box of await page.locator('.filter fieldset:first-of-type input').all()) await box.uncheck();
  await page.getByLabel('faults and losses', { exact: true }).check();
  await page.locator('.filter summary').click();
  await press(page, 'ArrowRight');
  assert.match(await where(page), /: 2000 events are missing$/);
  assert.equal((await lines(page, 'Not known, as events are missing')).length, 24);
  assert.deepEqual(await lines(page, 'Runs'), []);
  assert.deepEqual(await lines(page, 'States'), ['Phase is not known', 'Stability is not known', 'Ball is not known', 'RisingStep is not known']);
  await page.locator('.filter summary').click();
  await page.getByLabel('queued', { exact: true }).check();
  await page.getByLabel('faults and losses', { exact: true }).uncheck();
  await page.locator('.filter summary').click();
  for (let i = 0; i < 40 && !/: queue KickTo>Kick/.test(await where(page)); ++i) await press(page, 'ArrowRight');
  assert.deepEqual((await lines(page, 'Waits')).filter((line) => line.startsWith('Kick')), ['Kick queued: until Stability == standingNot more is known: 2000 events are missing before: why something waits is not known from there on.']);
});

await situation('in a recording that begins in the middle nothing is known until it is told', 'late', {}, async (page) => {
  await press(page, 'Home');
  assert.match(await page.locator('#timeline .about').textContent(), /The trace begins in the middle/);
  assert.ok((await lines(page, 'Not known, as events are missing')).includes('FallRecovery'));
  assert.deepEqual(await lines(page, 'Not requested'), []);
  assert.ok((await lines(page, 'States')).includes('Phase is not known'));
  await press(page, 'End');
  assert.ok((await lines(page, 'Runs')).length > 2);
});

await situation('a request for a task that runs for another is in the words too, not what blocks it: that may be something else', 'eyes', {}, async (page) => {
  await press(page, 'End');
  assert.deepEqual([await lines(page, 'Waits'), await lines(page, 'Runs')], [[], ['Boss: for the program', 'Guard: for the program', 'Look: for Guard; queued for Boss: blocked']]);
});

await situation('one picture of modules or layers shows the moment too', 'minute', {}, async (page) => {
  await scrubTo(page, 0.5);
  await page.getByLabel('By layer', { exact: true }).check();
  await frame(page);
  assert.deepEqual(await marked(page, 'running'), ['layer actuation', 'layer planning', 'layer purpose', 'layer skill', 'layer strategy']);
});

await situation('at 200 % nothing is cut off at the side', 'minute', { viewport: { width: 683, height: 384 }, deviceScaleFactor: 2 }, async (page) => {
  const [inner, whole] = await page.evaluate(() => [document.documentElement.clientWidth, document.documentElement.scrollWidth]);
  assert.ok(whole <= inner, `${whole} points in ${inner}`);
  await all.shot(page, 'minute_200');
});

await situation('on paper each name stands beside its track, in blocks of which none is higher than a page, and a dark browser prints in light colours', 'tall', { colorScheme: 'dark' }, async (page) => {
  await page.evaluate(() => addEventListener('beforeprint', () => (globalThis.blocks = document.querySelectorAll('.printed .lanes').length)));
  await page.pdf();
  assert.deepEqual(await page.evaluate(() => [globalThis.blocks, document.querySelectorAll('.printed .lanes').length]), [2, 0]);
  await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  const blocks = await page.locator('.printed .lanes').evaluateAll((all) => all.map((block) => {
    const canvas = block.querySelector('canvas');
    const { top } = canvas.getBoundingClientRect();
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const pixels = (y, height) => [...data.subarray(y * 3 * 4 * canvas.width, (y + height) * 3 * 4 * canvas.width)];
    const labels = [...block.querySelectorAll('.labels a')];
    return {
      height: block.getBoundingClientRect().height,
      kept: getComputedStyle(block).breakInside,
      names: labels.map((each) => each.textContent),
      rows: labels.map((each) => (each.getBoundingClientRect().top - top - 34) / 20),
      running: labels.map((_, i) => pixels(34 + 20 * i + 4, 1).slice(4 * 3, 4 * 3 + 3).join()),
      times: Math.min(...pixels(4, 8).filter((value, i) => i % 4 === 0)), // the least red of its letters
    };
  }));
  assert.deepEqual(blocks.flatMap(({ names }) => names), ['Play', ...Array.from({ length: 44 }, (_, i) => `Leaf${i + 1}`)].sort((a, b) => (a === 'Play') - (b === 'Play')));
  for (const { height, kept, rows, running, times } of blocks) {
    assert.ok(height <= 700, `${height}`);
    assert.equal(kept, 'avoid');
    assert.deepEqual(rows, rows.map((_, i) => i));
    assert.deepEqual([...new Set(running)], ['0,98,155']);
    assert.ok(times < 60, `${times}`);
  }
  assert.equal(await page.locator('.printed + .looks i').first().evaluate((sign) => getComputedStyle(sign).printColorAdjust), 'exact');
  assert.equal(await page.locator('#scrub').isVisible(), false);
  await all.shot(page, 'tall_paper');
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  assert.equal(await page.locator('#scrub').isVisible(), true);
});

await all.run('without JavaScript the beginning is a table', 'minute', { javaScriptEnabled: false }, async (page) => {
  assert.match(await page.locator('#no-timeline').textContent(), /The timeline itself needs JavaScript\. These are the first events:/);
  assert.equal(await page.locator('#no-timeline tbody tr').count(), 40);
  assert.equal(await page.locator('#no-timeline td').nth(1).textContent(), '> request FallRecovery');
});

const whole = readFileSync(join(folder, 'minute.html'), 'utf8');
writeFileSync(join(folder, 'damaged.html'), whole.replace(/(id="recording">.{2000}).{40}/, `$1${'A'.repeat(40)}`));
await all.run('a recording that is damaged is told, and the rest of the page is there', 'damaged', {}, async (page) => {
  await until(page, async () => (await page.locator('#no-timeline').textContent()).startsWith('The timeline cannot be shown: '));
  assert.equal(await page.locator('#no-timeline tbody tr').count(), 40);
  assert.equal(await page.locator('#finder').isVisible(), true);
});

await all.end();

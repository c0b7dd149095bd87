// SPDX-License-Identifier: MIT
// node answers.mjs: which answer of a running program the page shows for which moment (answers.ts).
import { strict as assert } from 'node:assert';
import { build } from 'esbuild';

await build({ stdin: { contents: "export * from './recording'; export * from './answers';", resolveDir: '.' }, bundle: true, format: 'esm', outfile: 'both.mjs' });
const { Answers, Recording } = await import('./both.mjs');

const groups = ['Brace', 'GetUp', 'Walk', 'Leg'].map((name) => ({ name, providers: ['default'] }));
const edges = ['root>Brace', 'root>GetUp', 'root>Walk', 'Brace>Leg', 'GetUp>Leg', 'Walk>Leg'].map((name) => ({ name, target: name.split('>')[1], levels: [''] }));
const states = ['Motion', 'Ball'].map((name) => ({ name, values: ['on', 'off'] }));
const names = ['Brace', 'GetUp', 'Walk', 'Leg'];
const walk = names.indexOf('Walk');

/** Walk waits since 100; Brace holds Leg until 300, then GetUp does. Motion changes at 500, Ball at 600. */
function recorded(until = Infinity) {
  const recording = new Recording({ director_trace: 1, behaviour: 'b', fingerprint: '', groups, edges, states, triggers: [], conditions: [] });
  const lines = [
    { t: 0, n: 1, event: 'input', input: 'request', edge: 'root>Brace' }, { t: 0, n: 1, event: 'grant', edge: 'root>Brace', provider: 'default' }, { t: 0, n: 1, event: 'grant', edge: 'Brace>Leg' },
    { t: 0, n: 2, event: 'set', state: 'Motion', value: 'on' }, { t: 0, n: 2, event: 'set', state: 'Ball', value: 'on' },
    { t: 100, n: 3, event: 'input', input: 'request', edge: 'root>Walk' }, { t: 100, n: 3, event: 'queue', edge: 'root>Walk', why: 'blocked' },
    { t: 300, n: 4, event: 'input', input: 'request', edge: 'root>GetUp' }, { t: 300, n: 4, event: 'lose', group: 'Brace', from: 'root>Brace' },
    { t: 300, n: 4, event: 'grant', edge: 'root>GetUp', provider: 'default' }, { t: 300, n: 4, event: 'grant', edge: 'GetUp>Leg', from: 'Brace>Leg' },
    { t: 500, n: 5, event: 'input', input: 'set', state: 'Motion', value: 'off' }, { t: 600, n: 6, event: 'input', input: 'set', state: 'Ball', value: 'off' },
  ];
  recording.append(lines.filter(({ t }) => t <= until).map((line) => JSON.stringify(line)).join('\n'));
  return recording;
}

const by = (edge) => ({ text: `Walk waits: Leg is held by ${edge}`, held: { group: 'Leg', by: edge } });
const shown = (recording, answers, time) => answers.at(walk, recording.eventAt(time))?.text;

{ // For the past: the answer that was given then, not a later one about who held Leg only afterwards.
  const recording = recorded();
  const answers = new Answers(recording);
  answers.add(walk, 200, by('Brace>Leg'));
  answers.add(walk, 300, by('GetUp>Leg'));
  answers.add(walk, 400, by('GetUp>Leg'));
  assert.deepEqual([50, 100, 250, 299, 300, 450, 600].map((time) => shown(recording, answers, time)), [
    undefined, ...Array(3).fill('Walk waits: Leg is held by Brace>Leg'), ...Array(3).fill('Walk waits: Leg is held by GetUp>Leg'),
  ]);
}
{ // An answer that came before its events waits for them; one whose events have come since is out of date.
  const early = recorded(299);
  const answers = new Answers(early);
  answers.add(walk, 300, by('GetUp>Leg'));
  assert.equal(shown(early, answers, 299), undefined);
  const recording = recorded();
  const late = new Answers(recording);
  late.add(walk, 200, by('Brace>Leg'));
  assert.deepEqual([250, 300].map((time) => shown(recording, late, time)), ['Walk waits: Leg is held by Brace>Leg', undefined]);
}
{ // An answer that names a state is of the value that the state had; others do not matter.
  const recording = recorded();
  const answers = new Answers(recording);
  answers.add(walk, 450, { text: 'Walk waits: until Motion == off\nMotion is on' });
  assert.deepEqual([100, 450, 499, 500].map((time) => shown(recording, answers, time) !== undefined), [true, true, true, false]);
  answers.add(walk, 550, { text: 'Walk waits: until Motions' });
  assert.deepEqual([499, 500, 600].map((time) => shown(recording, answers, time)), ['Walk waits: until Motion == off\nMotion is on', 'Walk waits: until Motions', 'Walk waits: until Motions']);
}
{ // An answer that names a group is of what that group did then, and of which of its providers were enabled.
  const recording = recorded();
  const answers = new Answers(recording);
  answers.add(walk, 200, { text: 'Walk waits: GetUp could cause it, but nothing requests GetUp' });
  assert.deepEqual([100, 250, 300, 450].map((time) => shown(recording, answers, time) !== undefined), [true, true, false, false]);
  recording.append(JSON.stringify({ t: 700, n: 7, event: 'input', input: 'disable', group: 'GetUp', provider: 'default' }));
  answers.add(walk, 650, { text: 'Walk waits: GetUp.default could cause it, and runs' });
  assert.deepEqual([650, 699, 700].map((time) => shown(recording, answers, time)?.endsWith('runs')), [true, true, undefined]);
}
console.log('ok');

// SPDX-License-Identifier: MIT
// node moments.mjs MOMENTS FIRST COUNT [NUMBER...]: compares the moments that the page's script derives with the engine's own (moments/moments.cpp),
// for random behaviours: from a trace, from what a viewer of the live view was sent, and from what a viewer that connects at this moment is sent. They
// must be equal only where time advances: before that, the engine reports some changes one event later, and a program shows no moment.
import { build } from 'esbuild';
import { spawn } from 'node:child_process';
import { createInterface } from 'node:readline';

await build({ entryPoints: ['recording.ts'], bundle: true, format: 'esm', outfile: 'recording.mjs' });
const { lineOf, Recording } = await import('./recording.mjs');

const [program, ...numbers] = process.argv.slice(2);
const child = spawn(program, numbers, { stdio: ['ignore', 'pipe', 'inherit'] });
let recording, live, about, moment, last;
let compared = 0;
const wrong = { trace: 0, live: 0, late: 0 };

/** Reads server-sent events, as live.ts does. `known`: the viewer's recording so far; undefined: a new viewer. */
function hear(text, known) {
  let into = known;
  for (const message of text.split('\n\n').filter((each) => each !== '')) {
    const data = message.split('\n').filter((line) => line.startsWith('data: ')).map((line) => line.slice(6));
    if (message.startsWith('event: standing\n')) data.splice(0, Infinity, lineOf(data.join('\n')));
    if (!into) into = new Recording(JSON.parse(data.shift()), new Map(Object.entries(about.initial)));
    into.append(data.join('\n'));
  }
  return into;
}

/** Only of edges that are granted or queued: others are not shown. A viewer who comes later does not know the level until the edge is requested anew. */
function found(recording) {
  const { header, targets } = recording.names;
  const at = recording.end - 1;
  const standings = header.groups.map((_, group) => recording.standingAt(group, at));
  const edge = (_, i) => {
    const target = standings[targets[i]];
    if (target.waits.some((wait) => wait.edge === i)) return 'queued';
    return target.holder !== i ? 'inactive' : target.mark === 'running' || target.mark === 'pushed' ? 'running' : 'held';
  };
  const level = (_, i) => {
    if (recording.names.requesters[i] < 0 || !['queued', 'running'].includes(edge(_, i))) return null;
    const known = recording.levelAt(i, at);
    return known === undefined ? moment.levels[i] : known;
  };
  const pushes = standings.flatMap(({ mark, push }, i) => (mark === 'pushed' && push ? [[header.groups[targets[push.edge]].name, header.groups[i].name, header.groups[i].providers[push.provider]]] : []));
  const value = (state, i) => (recording.valueAt(i, at) === null ? `${state.name} is unset` : `${state.name} == ${recording.valueAt(i, at)}`);
  const groups = standings.map((standing, i) => [standing.mark, header.groups[i].providers[standing.provider] ?? null]);
  return { groups, edges: header.edges.map(edge), levels: header.edges.map(level), pushes, values: header.states.map(value) };
}

function compareOne(of, recording, line) {
  const mine = JSON.stringify(found(recording));
  if (mine !== JSON.stringify(moment) && ++wrong[of] <= 3) console.log(`${of}: seed ${about.seed} of ${about.of}, before ${JSON.stringify(line)}\n  found: ${mine}\n  engine: ${JSON.stringify(moment)}`);
}

function compare(line) {
  if (moment && (line === undefined || line.t > last)) {
    ++compared;
    compareOne('trace', recording, line);
  }
  moment = undefined;
  last = line?.t ?? last;
}

for await (const text of createInterface({ input: child.stdout })) {
  const line = JSON.parse(text);
  if (line.seed !== undefined) {
    if (recording) compare(undefined);
    about = line;
    live = moment = undefined;
  } else if (line.director_trace !== undefined) {
    recording = new Recording(line, new Map(Object.entries(about.initial)));
    last = -Infinity;
  } else if (line.moment) {
    moment = line.moment;
  } else if (line.live !== undefined) {
    live = hear(line.live, live);
    if (moment) compareOne('live', live, line);
  } else if (line.late !== undefined) {
    if (moment) compareOne('late', hear(line.late), line);
  } else {
    if (!['held', 'stays', 'without_effect', 'in_force'].includes(line.event)) compare(line);
    recording.append(text);
  }
}
compare(undefined);
const status = await new Promise((done) => (child.exitCode === null ? child.on('exit', done) : done(child.exitCode)));
console.log(`${compared} moments; not as the engine has them: ${JSON.stringify(wrong)}`);
process.exit(status === 0 && compared > 1000 && Object.values(wrong).every((count) => count === 0) ? 0 : 1);

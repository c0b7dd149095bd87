// SPDX-License-Identifier: MIT
// An event without its time. A recording has millions of events but only a few hundred shapes, so kind, effect and text are found once per shape.

import { limbo, type Names, nobody } from './names';

/** A line of a trace, without `t`, `until`, `n` and `due`. `begins`: whether it begins a micro-step; absent: runs and inputs do, others do not. */
export interface EventLine {
  event: string;
  input?: string;
  group?: string;
  edge?: string;
  from?: string;
  provider?: string;
  reasons?: string[];
  why?: string;
  condition?: string;
  state?: string;
  value?: string | number | null;
  trigger?: string;
  level?: string | number;
  count?: number;
  begins?: boolean;
  asks?: string[];
}

/** The kinds of events that can be chosen in the filter. */
export const sorts = ['request', 'input', 'run', 'ask', 'hand-over', 'control', 'push', 'queue', 'state', 'handler', 'result', 'fault'] as const;
export type Sort = (typeof sorts)[number];

/** False for events that the page does not need, as other events report their effect: answers and settings of bodies, and due timers. */
export function isTold(line: EventLine): boolean {
  if (['answer', 'wait', 'assign'].includes(line.event)) return false;
  return line.event !== 'input' || !['wait', 'within', 'every', 'expire'].includes(line.input ?? '');
}

/** Whether an event of this kind begins a micro-step, as long as nothing else is known. */
export const isUsualBeginning = (line: EventLine): boolean => line.event === 'run' || line.event === 'input';

function sortOf(line: EventLine): Sort {
  switch (line.event) {
    case 'input': return line.input === 'set' || line.input === 'trigger' ? 'input' : 'request';
    case 'given': case 'begin': return 'input';
    case 'run': return 'run';
    case 'ask': case 'keep': return 'ask';
    case 'grant': return line.from === undefined || line.from === 'limbo' || line.edge === 'limbo' ? 'control' : 'hand-over';
    case 'lose': case 'withdraw': case 'held': case 'stays': case 'runs': return 'control';
    case 'push': case 'release': case 'without_effect': case 'in_force': return 'push';
    case 'queue': case 'waits': case 'dequeue': return 'queue';
    case 'set': return 'state';
    case 'start': case 'stop': return 'handler';
    case 'done': case 'failed': return 'result';
    default: return 'fault';
  }
}

export class Shape {
  readonly group: number;
  readonly provider: number;
  readonly edge: number;
  readonly from: number;
  readonly state: number;
  readonly sort: Sort;
  readonly text: string;
  readonly value: string | null; // of a state; null: unset
  readonly level: string | null; // of a request; null: it is withdrawn
  /** Whether it may change the standing of a group. */
  readonly decides: boolean;
  readonly setsState: boolean;
  readonly setsLevel: boolean;
  readonly isGap: boolean;
  readonly begins: boolean; // a micro-step
  readonly isFlow: boolean;
  /** The groups that it concerns: its own, and the requesters of its edges. */
  readonly groups: number[];

  constructor(readonly line: EventLine, names: Names) {
    this.edge = names.edge(line.edge);
    this.from = names.edge(line.from);
    this.group = line.group === undefined ? (names.targets[this.edge] ?? nobody) : names.group(line.group);
    this.provider = names.provider(this.group, line.provider);
    this.state = names.state(line.state);
    this.sort = sortOf(line);
    this.value = line.value === null || line.value === undefined ? null : String(line.value);
    this.level = line.event === 'withdraw' ? null : String(names.level(this.edge, line.level));
    this.isGap = line.event === 'dropped';
    this.begins = line.begins ?? isUsualBeginning(line);
    this.setsState = line.event === 'set' || line.event === 'given' || line.input === 'set';
    this.setsLevel = ['ask', 'keep', 'withdraw'].includes(line.event) && this.edge >= 0;
    this.isFlow = line.event === 'push' || this.sort === 'hand-over';
    this.decides = ['run', 'stop', 'held', 'stays', 'runs', 'waits', 'dequeue', 'ask', 'keep', 'grant', 'lose', 'queue', 'withdraw', 'push', 'release', 'without_effect', 'in_force', 'dropped'].includes(line.event) || line.event === 'input';
    this.text = textOf(this, names);
    this.groups = [this.group, names.requesters[this.edge] ?? nobody, names.requesters[this.from] ?? nobody].filter((group) => group !== nobody);
  }
}

/** As `directorc replay` has it. */
const levelText = ({ level }: EventLine): string => (level === undefined ? '' : typeof level === 'number' ? `, level ${level + 1} of its list` : `, level ${level}`);

const valueText = (line: EventLine): string => String(line.value ?? 'no value');

/** The text that `directorc trace` prints; events that it leaves out have similar texts. */
function textOf(shape: Shape, names: Names): string {
  const { line, group } = shape;
  const groupName = names.header.groups[group]?.name ?? '';
  const full = line.provider === undefined ? groupName : `${groupName}.${line.provider}`;
  switch (line.event) {
    case 'input': return inputText(shape, names, groupName, full);
    case 'run': return `run ${names.providerText(group, shape.provider)} ${(line.reasons ?? []).join('+')}`.trimEnd();
    case 'queue': case 'waits': return `${line.event} ${line.edge}: ${line.why}${line.why === 'waiting' && line.condition ? ` for ${line.condition}` : ''}`;
    case 'push': return `push ${full} for ${line.edge}`;
    case 'without_effect': return `push of ${groupName} without effect`;
    case 'in_force': return `push of ${groupName} in force`;
    case 'set': return line.value === null ? `unset ${line.state}` : `set ${line.state} ${valueText(line)}`;
    case 'refused': return `refused ${line.state} ${valueText(line)}`;
    case 'given': return `given ${line.state} ${valueText(line)}`;
    case 'broken': return `broken ${names.providerText(group, shape.provider)}`;
    case 'fault': return `fault ${full}`;
    case 'exhausted': return 'budget_exhausted';
    case 'lost': return `lost ${line.count} ${line.count === 1 ? 'input' : 'inputs'}`;
    case 'dropped': return `${line.count} ${line.count === 1 ? 'event is' : 'events are'} missing`;
    case 'grant':
      if (shape.edge === limbo) return `hold ${groupName} for what comes after it`;
      return shape.from === nobody || shape.from === limbo ? `grant ${line.edge}` : `hand over ${groupName} from ${line.from} to ${line.edge}`;
    case 'lose': return `lose ${groupName}`;
    case 'withdraw': case 'ask': case 'keep': return `${line.event} ${line.edge}${levelText(line)}`;
    case 'dequeue': return `dequeue ${line.edge}`;
    case 'begin': return 'begin';
    default: return `${line.event} ${groupName}`;
  }
}

function inputText(shape: Shape, names: Names, groupName: string, full: string): string {
  const { line } = shape;
  switch (line.input) {
    case 'request': {
      const level = typeof line.level === 'number' ? (names.header.edges[shape.edge]?.levels[line.level] ?? '') : (line.level ?? '');
      return `> request ${level === '' ? groupName : `{${groupName}: {level: ${level}}}`}`;
    }
    case 'cancel': return `> cancel ${groupName === '' ? 'all' : groupName}`;
    case 'set': return `> set {${line.state}: ${valueText(line)}}`;
    case 'trigger': return `> trigger ${line.trigger}`;
    default: return `> ${line.input} ${full}`;
  }
}

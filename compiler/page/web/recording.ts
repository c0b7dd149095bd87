// SPDX-License-Identifier: MIT
// A recording in the browser: all events in order, and, derived from them, the standing of each group (standing.ts) and the value of each state after
// any event. The timeline and the pictures read it, whatever its source is.
//
// A source fills the recording, and answers why a group waits:
// - embedded.ts decodes the recording that `directorc trace --to=html` wrote into the page; it is complete at once;
// - a live source calls `new Recording(header, initial)` with the first line of a trace, `append(text)` with each further block of complete lines, and
//   `pass(time)` if time passed without an event. `limit` is the number of events above which the oldest are removed. A source that begins in the
//   middle first sends the current state as events, such as `given`, `grant`, `queue` and `push` (runtime/live/moment_lines.hpp). `why(group, event)`
//   may answer later, by a promise. `new Timeline(source, pictures, data)` shows it; if it `grows`, the end is followed until the user goes elsewhere.
//
// Events are numbered from 0 and keep their numbers. Events before `first` are removed; the standings and values that they led to are kept.

import { type Column, counts, times } from './columns';
import { type Header, Names } from './names';
import { type EventLine, isTold, isUsualBeginning, Shape } from './shape';
import { type Standing, Standings } from './standing';

/** The reason why a group waits. */
export interface Because {
  text: string; // one or several lines
  held?: Held;
}
/** The group that blocks, and the edge by which it is held. */
export interface Held {
  group: string;
  by: string;
}

export interface Source {
  readonly recording: Recording;
  /** Whether more events may come: then the timeline follows the end. */
  readonly grows: boolean;
  /** Why a group waits after this event; undefined: not known. */
  why(group: number, event: number): Because | undefined | Promise<Because | undefined>;
  /** Why `why` has no answers for this event; undefined: it has. */
  whyUnknown(event: number): string | undefined;
}

/** The history of a group or state: `value[i]` is valid from `event[i]` on, the first value from Recording.first on. */
export interface Track {
  event: Column<Uint32Array>;
  value: Column<Uint32Array>; // index in Recording.standings or Recording.values
}

export type Value = string | null | undefined; // null: unset; undefined: not known

const newTrack = (): Track => ({ event: counts(), value: counts() });

/** Makes a line for append() from a list of standings that no event reports, a JSON array (append_standing in runtime/live/moment_lines.hpp). */
export const lineOf = (standing: string): string => `{"event":"standing","told":${standing}}`;

export class Recording {
  readonly names: Names;
  readonly shapes: Shape[] = [];
  readonly time: Column<Float64Array> = times(); // of each event from `first` on, in microseconds, in ascending order
  readonly shape: Column<Uint32Array> = counts(); // of each event from `first` on, index in `shapes`
  readonly groups: Track[];
  readonly states: Track[];
  private readonly levels: Track[]; // of each edge: at which level its requester requests it
  readonly flows: Column<Uint32Array> = counts(); // events that are pushes or hand-overs
  readonly switches: Column<Uint32Array> = counts(); // events that enable or disable a provider
  readonly gaps: Column<Uint32Array> = counts(); // events `dropped`: other events are missing before them
  readonly faults: Column<Uint32Array> = counts(); // other events that tell of a fault: a broken promise, an exception, inputs that are lost
  readonly standings: Standing[] = [];
  readonly values: Value[] = [undefined, null];
  first = 0;

  private readonly shapeOf = new Map<string, number>();
  private readonly standingOf = new Map<string, number>();
  private readonly valueOf = new Map<Value, number>([[undefined, 0], [null, 1]]);
  private readonly now: Standings;
  private readonly listeners: (() => void)[] = [];
  private passed = 0;
  private microStep: number | undefined; // of the last line

  /**
   * `initial`: the values of the states before the first event; undefined: the recording begins in the middle, so nothing is known before an event
   * tells it. `limit`: if more events are kept, the oldest are removed.
   */
  constructor(header: Header, initial?: Map<string, Value>, private readonly limit = Infinity) {
    this.names = new Names(header);
    this.now = new Standings(this.names, initial !== undefined);
    this.groups = header.groups.map(newTrack);
    this.states = header.states.map(newTrack);
    this.levels = header.edges.map(newTrack);
    this.groups.forEach((track, group) => this.put(track, 0, this.standing(group)));
    this.states.forEach((track, i) => this.put(track, 0, this.value(initial?.get(header.states[i].name))));
    for (const track of this.levels) this.put(track, 0, this.value(initial && null));
  }

  /** The number of the last event, plus 1. */
  get end(): number {
    return this.first + this.time.length;
  }

  /** The times of its beginning and its end, in microseconds. */
  get begins(): number {
    return this.time.length === 0 ? 0 : this.time.at[0];
  }
  get ends(): number {
    return Math.max(this.passed, this.time.length === 0 ? 0 : this.time.last);
  }

  timeOf(event: number): number {
    return this.time.at[event - this.first];
  }

  shapeAt(event: number): Shape {
    return this.shapes[this.shape.at[event - this.first]];
  }

  /** The last event up to this time; `first` - 1: there is none. */
  eventAt(time: number): number {
    return this.first + this.time.upTo(time) - 1;
  }

  /** After this event. */
  standingAt(group: number, event: number): Standing {
    return this.standings[this.at(this.groups[group], event)];
  }
  valueAt(state: number, event: number): Value {
    return this.values[this.at(this.states[state], event)];
  }

  /** The level at which an edge is requested after this event, its place in the edge's `levels`; null: it is not; undefined: not known. */
  levelAt(edge: number, event: number): number | null | undefined {
    const level = this.values[this.at(this.levels[edge], event)];
    return typeof level === 'string' ? Number(level) : level;
  }

  /** The last event of the micro-step of this event: between them, what the events say does not fit together yet. */
  endOfStep(event: number): number {
    if (event < this.first || event >= this.end || this.shapeAt(event).isGap) return event;
    let out = event;
    while (out + 1 < this.end && !this.shapeAt(out + 1).begins && !this.shapeAt(out + 1).isGap) ++out;
    return out;
  }

  /** The event since which the group has the standing that it has after this event. */
  sinceOf(group: number, event: number): number {
    const { event: begins } = this.groups[group];
    return begins.at[Math.max(0, begins.upTo(event) - 1)];
  }

  /** Appends complete lines of a trace, without its header. Throws at a line that cannot be read; the lines before it are appended. */
  append(text: string): void {
    try {
      for (const each of text.split('\n')) if (each !== '') this.takeLine(JSON.parse(each) as EventLine & { t?: number });
    } finally {
      this.forgetOldest();
      this.tell();
    }
  }

  /** Time has passed without an event. */
  pass(time: number): void {
    this.passed = Math.max(this.passed, time);
    this.tell();
  }

  /** `listener` is called whenever events were appended, or time has passed. */
  onGrowth(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** Adds the shape of a line, if it is new; returns its index in `shapes`. */
  addShape(line: EventLine): number {
    const key = JSON.stringify(line);
    const known = this.shapeOf.get(key);
    if (known !== undefined) return known;
    this.shapeOf.set(key, this.shapes.length);
    return this.shapes.push(new Shape(line, this.names)) - 1;
  }

  /** Adds an event; `number`: the index of its shape. */
  add(time: number, number: number): void {
    const event = this.end;
    const shape = this.shapes[number];
    this.time.push(this.time.length > 0 && time < this.time.last ? this.time.last : time);
    this.shape.push(number);
    if (shape.decides) for (const group of this.now.apply(shape)) this.put(this.groups[group], event, this.standing(group));
    if (shape.setsState) this.put(this.states[shape.state], event, this.value(shape.value));
    if (shape.setsLevel) this.put(this.levels[shape.edge], event, this.value(shape.level));
    if (shape.isGap) for (const track of [...this.states, ...this.levels]) this.put(track, event, 0);
    if (shape.isFlow) this.flows.push(event);
    if (shape.isGap) this.gaps.push(event);
    else if (shape.sort === 'fault') this.faults.push(event);
    if (shape.line.input === 'enable' || shape.line.input === 'disable') this.switches.push(event);
  }

  private takeLine(line: EventLine & { t?: number; n?: number; told?: EventLine[] }): void {
    if (line.told) return this.settle(line.told);
    if (!isTold(line)) return;
    const { t, n, ...rest } = line;
    for (const key of ['until', 'due']) delete (rest as Record<string, unknown>)[key];
    if (n !== undefined && this.microStep !== undefined && (n !== this.microStep) !== isUsualBeginning(rest)) rest.begins = n !== this.microStep;
    this.microStep = n ?? (line.event === 'dropped' ? undefined : this.microStep);
    this.add(t ?? this.ends, this.addShape(rest));
  }

  /**
   * Adds events where a complete list of standings differs. Held groups that are not in it run; requests that are not in it are not queued; pushes
   * that are not in it are in force.
   */
  private settle(told: EventLine[]): void {
    const look = (line: EventLine) => {
      const shape = this.addShape(line);
      if (!this.now.knows(this.shapes[shape])) this.add(this.ends, shape);
    };
    told.forEach(look);
    const isOfPush = (line: EventLine) => line.event === 'without_effect';
    const groups = new Set(told.filter((line) => !isOfPush(line)).map((line) => line.group)), edges = new Set(told.map((line) => line.edge));
    const pushed = new Set(told.filter(isOfPush).map((line) => line.group));
    for (const { name: group } of this.names.header.groups) {
      if (!groups.has(group)) look({ event: 'runs', group });
      if (!pushed.has(group)) look({ event: 'in_force', group });
    }
    for (const { name: edge } of this.names.header.edges) if (!edges.has(edge)) look({ event: 'dequeue', edge });
  }

  private at(track: Track, event: number): number {
    return track.value.at[Math.max(0, track.event.upTo(event) - 1)];
  }

  private put(track: Track | undefined, event: number, value: number): void {
    if (!track || (track.value.length > 0 && track.value.last === value)) return;
    track.event.push(event);
    track.value.push(value);
  }

  private standing(group: number): number {
    const standing = this.now.of(group);
    const plain = standing.push === undefined && standing.waits.length === 0;
    const key = plain ? `${standing.mark} ${standing.provider} ${standing.holder}` : JSON.stringify(standing);
    const known = this.standingOf.get(key);
    if (known !== undefined) return known;
    this.standingOf.set(key, this.standings.length);
    return this.standings.push(standing) - 1;
  }

  private value(value: Value): number {
    const known = this.valueOf.get(value);
    if (known !== undefined) return known;
    this.valueOf.set(value, this.values.length);
    return this.values.push(value) - 1;
  }

  /** Removes the oldest events down to half of the limit, so that this is rarely necessary. */
  private forgetOldest(): void {
    if (this.time.length <= this.limit) return;
    const count = this.time.length - Math.floor(this.limit / 2);
    this.first += count;
    this.time.drop(count);
    this.shape.drop(count);
    for (const track of [...this.groups, ...this.states, ...this.levels]) {
      const gone = Math.max(0, track.event.upTo(this.first) - 1);
      track.event.drop(gone);
      track.value.drop(gone);
    }
    for (const column of [this.flows, this.switches, this.gaps, this.faults]) column.drop(column.upTo(this.first - 1));
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}

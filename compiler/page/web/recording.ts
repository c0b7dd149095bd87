// SPDX-License-Identifier: MIT
// A recording in the browser: all events in order, and from them where each group stood and what each state was worth at any of them. The timeline
// and the picture read it, and know nothing of where it comes from.
//
// A source is who fills it, and who knows why something waits:
// - embedded.ts decodes the one that `directorc trace --to=html` wrote into the page; it is whole at once;
// - a live source makes `new Recording(header)` from the first line of a trace, calls `append(text)` with each further bundle of whole lines, and
//   `pass(time)` where nothing happened but time passed. `limit` bounds how many events are kept. One that begins in the middle sends first what
//   holds as events: a `given` for each state, and `grant`, `queue` and `push`. `why(group, event)` may answer later, by a promise. A page shows it by
//   `new Timeline(source, pictures, data)`, as page.ts does; with `grows` it follows the end until the person goes elsewhere.
//
// Events are numbered from 0 and keep their numbers; of those before `first` nothing is kept but what holds there.

import { type Column, counts, times } from './columns';
import { type Header, Names } from './names';
import { type EventLine, isTold, Shape } from './shape';
import { type Standing, Standings } from './standing';

/** Why something waits. */
export interface Because {
  text: string; // one line or several
  held?: Held;
}
/** What is in the way, and the edge by which it is held. */
export interface Held {
  group: string;
  by: string;
}

export interface Source {
  readonly recording: Recording;
  /** More may come: the timeline follows the end. */
  readonly grows: boolean;
  /** Why a group waits after this event; undefined: that is not known. */
  why(group: number, event: number): Because | undefined | Promise<Because | undefined>;
  /** Why `why` knows nothing of this event; undefined: it does. */
  whyUnknown(event: number): string | undefined;
}

/** From which event on something is what; the first one holds from `first` on. */
export interface Track {
  event: Column<Uint32Array>;
  value: Column<Uint32Array>; // place among Recording.standings or Recording.values
}

export type Value = string | null | undefined; // null: it has none; undefined: not known

const newTrack = (): Track => ({ event: counts(), value: counts() });

/** A message of what holds and no event tells, a JSON array (runtime/live/moment_lines.hpp), as a line to append. */
export const lineOf = (standing: string): string => `{"event":"standing","told":${standing}}`;

export class Recording {
  readonly names: Names;
  readonly shapes: Shape[] = [];
  readonly time: Column<Float64Array> = times(); // of each event from `first` on, in microseconds; never earlier than the one before
  readonly shape: Column<Uint32Array> = counts(); // place among `shapes`
  readonly groups: Track[];
  readonly states: Track[];
  readonly flows: Column<Uint32Array> = counts(); // events that are a push or a take-over
  readonly gaps: Column<Uint32Array> = counts(); // events before which some are missing
  readonly standings: Standing[] = [];
  readonly values: Value[] = [undefined, null];
  first = 0;

  private readonly shapeOf = new Map<string, number>();
  private readonly standingOf = new Map<string, number>();
  private readonly valueOf = new Map<Value, number>([[undefined, 0], [null, 1]]);
  private readonly now: Standings;
  private readonly listeners: (() => void)[] = [];
  private passed = 0;

  /** `initial`: what states are worth before anything is told; `limit`: events. */
  constructor(header: Header, initial: Map<string, Value> = new Map(), private readonly limit = Infinity) {
    this.names = new Names(header);
    this.now = new Standings(this.names);
    this.groups = header.groups.map(newTrack);
    this.states = header.states.map(newTrack);
    this.groups.forEach((track, group) => this.put(track, 0, this.standing(group)));
    this.states.forEach((track, i) => this.put(track, 0, this.value(initial.get(header.states[i].name))));
  }

  /** One more than the last event's number. */
  get end(): number {
    return this.first + this.time.length;
  }

  /** When it begins and ends, in microseconds. */
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

  /** The last event that is no later; before the first one, one less than `first`. */
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

  /** The event since which the group stands as it does after this one. */
  sinceOf(group: number, event: number): number {
    const { event: begins } = this.groups[group];
    return begins.at[Math.max(0, begins.upTo(event) - 1)];
  }

  /** Whole lines of a trace, behind its header. Throws at what is none; what stands before it is taken. */
  append(text: string): void {
    try {
      for (const each of text.split('\n')) if (each !== '') this.takeLine(JSON.parse(each) as EventLine & { t?: number });
    } finally {
      this.forgetOldest();
      this.tell();
    }
  }

  /** Time went on, and nothing happened. */
  pass(time: number): void {
    this.passed = Math.max(this.passed, time);
    this.tell();
  }

  /** Called whenever there is more. */
  onGrowth(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** A shape by its line, known from then on by the number that comes back. */
  addShape(line: EventLine): number {
    const key = JSON.stringify(line);
    const known = this.shapeOf.get(key);
    if (known !== undefined) return known;
    this.shapeOf.set(key, this.shapes.length);
    return this.shapes.push(new Shape(line, this.names)) - 1;
  }

  /** An event of a shape that was added. */
  add(time: number, number: number): void {
    const event = this.end;
    const shape = this.shapes[number];
    this.time.push(this.time.length > 0 && time < this.time.last ? this.time.last : time);
    this.shape.push(number);
    if (shape.decides) for (const group of this.now.apply(shape)) this.put(this.groups[group], event, this.standing(group));
    if (shape.setsState) this.put(this.states[shape.state], event, this.value(shape.value));
    if (shape.isGap) for (const track of this.states) this.put(track, event, 0);
    if (shape.isFlow) this.flows.push(event);
    if (shape.isGap) this.gaps.push(event);
  }

  private takeLine(line: EventLine & { t?: number; told?: EventLine[] }): void {
    if (line.told) return this.settle(line.told);
    if (!isTold(line)) return;
    const { t, ...rest } = line;
    for (const key of ['until', 'n', 'due']) delete (rest as Record<string, unknown>)[key];
    this.add(t ?? this.ends, this.addShape(rest));
  }

  /** What is known already is no event. What is held and not among these runs, and no other request waits. */
  private settle(told: EventLine[]): void {
    const look = (line: EventLine) => {
      const shape = this.addShape(line);
      if (!this.now.knows(this.shapes[shape])) this.add(this.ends, shape);
    };
    told.forEach(look);
    const groups = new Set(told.map((line) => line.group)), edges = new Set(told.map((line) => line.edge));
    for (const { name: group } of this.names.header.groups) if (!groups.has(group)) look({ event: 'runs', group });
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

  /** Half of what is kept, so that it is done seldom. */
  private forgetOldest(): void {
    if (this.time.length <= this.limit) return;
    const count = this.time.length - Math.floor(this.limit / 2);
    this.first += count;
    this.time.drop(count);
    this.shape.drop(count);
    for (const track of [...this.groups, ...this.states]) {
      const gone = Math.max(0, track.event.upTo(this.first) - 1);
      track.event.drop(gone);
      track.value.drop(gone);
    }
    for (const column of [this.flows, this.gaps]) column.drop(column.upTo(this.first - 1));
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}

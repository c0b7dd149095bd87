// SPDX-License-Identifier: MIT
// The standing of each group: its mark, provider, holder and queued requests. It is derived from events, and at rest equals what the engine's view says
// (compiler/play/why/moment.cpp). Three changes have no event of the engine: a group that is no longer requested, and was kept for a possible requester,
// stops and is only held as a need; a group whose request was queued or withdrawn continues as a need, with its own requests; a group runs in the
// provider of its push, but not because of it. Sources report them:
// - a recording has additional events where that happened: {"event":"held","group":…}, {"event":"stays","group":…}, {"event":"without_effect",
//   "group":…}, and {"event":"in_force","group":…} where it runs because of its push again (compiler/trace/waits.hpp);
// - a running program sends complete lists of standings (runtime/live/feed.hpp); recording.ts adds {"event":"runs","group":…} for a held group that
//   is not in the list, {"event":"in_force","group":…} for one whose push is not without effect in the list, and {"event":"dequeue","edge":…} for a
//   request that is not in it.
// Without these events, the standing is wrong until the next event of the group.

import { type Names, nobody } from './names';
import type { Shape } from './shape';

/** As `directorc graph --step` marks groups. `unknown`: events are missing, and none has reported the group's standing since. */
export const marks = ['inactive', 'running', 'pushed', 'queued', 'held', 'unknown'] as const;
export type Mark = (typeof marks)[number];

export interface Wait {
  edge: number;
  why: string;
  condition?: string;
}

export interface Push {
  edge: number;
  provider: number;
  condition?: string;
}

export interface Standing {
  mark: Mark;
  /** The active provider, if the group is granted; otherwise `nobody`. */
  provider: number;
  /** The edge that holds it, `nobody` or `limbo`. */
  holder: number;
  push?: Push;
  /** The queued requests for it, by its holder or by others. */
  waits: Wait[];
}

interface Group {
  known: boolean;
  holder: number;
  provider: number;
  granted: boolean;
  /** It is not granted any more but continues: its own requests remain. */
  stays: boolean;
  push?: Push;
  /** When it ran last in the provider of its push, it was not because of it. */
  isWithoutEffect: boolean;
}

export class Standings {
  private readonly groups: Group[];
  private readonly waits: (Wait | undefined)[]; // by edge
  private readonly told: (Wait | undefined)[]; // by edge: the last reported reason, until it is granted; the engine reports only changes
  private readonly asked: boolean[]; // by edge: whether it is requested
  private readonly touched = new Set<number>();
  private readonly lapsing = new Map<number, boolean>(); // groups whose request ended, if this micro-step may hand them over; value: were they granted

  /** `known`: nothing runs at first; otherwise it is not known what does. */
  constructor(private readonly names: Names, known: boolean) {
    this.groups = names.header.groups.map(() => ({ known, holder: nobody, provider: nobody, granted: false, stays: false, isWithoutEffect: false }));
    this.waits = names.header.edges.map(() => undefined);
    this.told = names.header.edges.map(() => undefined);
    this.asked = names.header.edges.map(() => false);
  }

  /** Applies an event; returns the groups whose standing may have changed. */
  apply(shape: Shape): Set<number> {
    const { line, group, edge } = shape;
    const at = this.groups[group];
    this.touched.clear();
    if (this.lapsing.size > 0 && (line.event === 'run' || line.event === 'input')) this.lapse(); // the next micro-step
    switch (line.event) {
      case 'run': return at ? this.run(at, shape) : this.touched;
      case 'ask': case 'keep': return this.ask(edge);
      case 'grant': return at ? this.grant(at, shape) : this.touched;
      case 'lose': return at ? this.lose(at, group, shape.from) : this.touched;
      case 'stop': case 'held': if (at && (this.isAlive(group) || this.lapsing.delete(group))) this.end(group); break;
      case 'stays': if (at) this.goesOn(group, line.asks ?? []); break;
      case 'queue': return this.queue(shape);
      case 'waits': this.waitsFor(shape); break;
      case 'runs': if (at) this.runsAgain(at, group); break;
      case 'dequeue': this.waits[edge] = undefined; this.asked[edge] = false; break;
      case 'withdraw': return this.forget(edge);
      case 'input':
        if (line.input === 'request') this.asked[edge] = true;
        return line.input === 'cancel' ? this.forget(edge) : this.touched;
      case 'push': if (at) at.push = { edge, provider: shape.provider, condition: line.condition }; break;
      case 'release': if (at) Object.assign(at, { push: undefined, isWithoutEffect: false }); break;
      case 'without_effect': case 'in_force': if (at) at.isWithoutEffect = line.event === 'without_effect'; break;
      case 'dropped': return this.lostTrack();
      default: return this.touched;
    }
    return this.touched.add(group);
  }

  /** Whether a line `held`, `stays`, `runs`, `without_effect`, `in_force`, `waits` or `dequeue` says only what is known already. */
  knows({ line, group, edge }: Shape): boolean {
    if (line.event === 'waits') return this.waits[edge] !== undefined;
    if (line.event === 'dequeue') return !this.isWaiting(edge);
    const at = this.groups[group];
    if (line.event === 'runs') return at.granted || at.holder === nobody;
    if (line.event === 'without_effect') return at.isWithoutEffect;
    if (line.event === 'in_force') return !at.isWithoutEffect || at.push?.provider !== at.provider;
    if (!at || this.lapsing.has(group)) return false;
    if (line.event === 'held') return !this.isAlive(group);
    return !at.granted && at.stays && (line.asks ?? []).every((edge) => this.asked[this.names.edge(edge)]);
  }

  of(group: number): Standing {
    const at = this.groups[group];
    const waits = this.names.edgesTo[group].filter((edge) => this.isWaiting(edge)).map((edge) => this.waits[edge] as Wait);
    const pushed = at.push !== undefined && at.push.provider === at.provider && !at.isWithoutEffect;
    const mark = at.granted ? (pushed ? 'pushed' : 'running') : waits.length > 0 ? 'queued' : !at.known ? 'unknown' : at.holder !== nobody ? 'held' : 'inactive';
    return { mark, provider: at.granted ? at.provider : nobody, holder: at.holder, push: at.push, waits };
  }

  /** A request does not count while its requester does not run. */
  private isWaiting(edge: number): boolean {
    return this.waits[edge] !== undefined && this.isAlive(this.names.requesters[edge]);
  }

  /** Whether a requester runs; the program (`nobody`) always does. */
  private isAlive(group: number): boolean {
    return group === nobody || this.groups[group].granted || this.groups[group].stays;
  }

  private touchAsked(group: number): void {
    for (const edge of this.names.requests[group]) if (this.waits[edge]) this.touched.add(this.names.targets[edge]);
  }

  /** A group that this one holds without having requested it stops, unless this run requests it; it may still be held as a need. */
  private run(at: Group, shape: Shape): Set<number> {
    for (const edge of this.names.requests[shape.group]) {
      const target = this.names.targets[edge];
      if (this.asked[edge] || this.groups[target].holder !== edge) continue;
      this.stopUnlessHandedOn(target);
      this.touched.add(target);
    }
    if (at.holder >= 0 && shape.line.reasons?.includes('new_task')) this.asked[at.holder] = true;
    if (at.granted && at.provider === shape.provider && at.known) return this.touched;
    at.granted = at.known = true;
    at.provider = shape.provider;
    this.runsFor(at.holder);
    this.touchAsked(shape.group);
    return this.touched.add(shape.group);
  }

  /** A group that the same micro-step was about to stop continues; a request that is not granted waits for the last reported reason. */
  private ask(edge: number): Set<number> {
    this.asked[edge] = true;
    const group = this.names.targets[edge];
    const at = this.groups[group];
    if (!at) return this.touched;
    if (at.holder === edge && this.lapsing.has(group)) {
      at.granted = this.lapsing.get(group) ?? false;
      this.stay(group);
    }
    if (at.holder !== edge || !at.granted) this.waits[edge] ??= this.told[edge];
    return this.touched.add(group);
  }

  private runsFor(edge: number): void {
    if (edge >= 0) this.waits[edge] = this.told[edge] = undefined;
  }

  private grant(at: Group, shape: Shape): Set<number> {
    if (at.granted && shape.provider === nobody) this.end(shape.group);
    at.known = true;
    at.holder = shape.edge;
    at.provider = shape.provider;
    at.granted = shape.provider !== nobody;
    this.touchAsked(shape.group);
    if (at.granted) this.runsFor(shape.edge);
    return this.touched.add(shape.group);
  }

  /** If the request through which the group was held is neither queued nor withdrawn, it ended because its requester stopped. */
  private lose(at: Group, group: number, from: number): Set<number> {
    const asker = this.names.requesters[from] ?? nobody;
    if (asker !== nobody && this.asked[from] && !this.waits[from]) {
      this.stopUnlessHandedOn(asker);
      this.touched.add(asker);
    }
    this.end(group);
    at.known = true;
    at.holder = at.provider = nobody;
    return this.touched.add(group);
  }

  private waitsFor({ edge, line }: Shape): void {
    if (edge < 0) return;
    this.asked[edge] = true;
    this.waits[edge] = this.told[edge] = { edge, why: line.why ?? '', condition: line.condition };
  }

  private queue(shape: Shape): Set<number> {
    const { edge, group } = shape;
    if (edge < 0) return this.touched;
    this.waitsFor(shape);
    if (this.groups[group].holder === edge) this.stopUnlessHandedOn(group);
    const asker = this.names.requesters[edge];
    if (this.lapsing.has(asker)) this.stay(asker); // only a group that continues has requests
    return this.touched.add(group);
  }

  /** `asks`: the edges that it requests. A list of standings may come late, when these requests were removed already. */
  private goesOn(group: number, asks: string[]): void {
    this.groups[group].granted = false;
    this.stay(group);
    for (const edge of asks) this.ask(this.names.edge(edge));
  }

  /** For a group that was wrongly taken to have stopped. */
  private runsAgain(at: Group, group: number): void {
    at.granted = at.known = true;
    at.stays = false;
    this.lapsing.delete(group);
    if (at.holder >= 0) this.asked[at.holder] = true;
    this.runsFor(at.holder);
    this.touchAsked(group);
  }

  private stay(group: number): void {
    this.lapsing.delete(group);
    this.groups[group].stays = !this.groups[group].granted;
    this.touchAsked(group);
  }

  private stopUnlessHandedOn(group: number): void {
    if (!this.isAlive(group)) return;
    this.lapsing.set(group, this.groups[group].granted);
    this.groups[group].granted = this.groups[group].stays = false;
    this.touchAsked(group);
  }

  private lapse(): void {
    for (const group of this.lapsing.keys()) {
      if (this.isAlive(group)) continue;
      this.end(group);
      this.touched.add(group);
    }
    this.lapsing.clear();
  }

  /** The edge is not requested any more. */
  private forget(edge: number): Set<number> {
    const group = this.names.targets[edge];
    if (group === undefined) return this.touched;
    const was = this.waits[edge];
    this.waits[edge] = undefined;
    this.asked[edge] = false;
    const { holder } = this.groups[group];
    const wasKeptForIt = was?.why === 'outdated' && holder >= 0 && !this.asked[holder];
    if (holder === edge || wasKeptForIt) this.stopUnlessHandedOn(group);
    return this.touched.add(group);
  }

  private end(group: number): void {
    this.groups[group].granted = this.groups[group].stays = false;
    for (const edge of this.names.requests[group]) {
      this.asked[edge] = false;
      if (this.waits[edge] === undefined) continue;
      this.waits[edge] = undefined;
      this.touched.add(this.names.targets[edge]);
    }
  }

  private lostTrack(): Set<number> {
    this.groups.forEach((at, group) => {
      Object.assign(at, { known: false, granted: false, stays: false, holder: nobody, provider: nobody, push: undefined, isWithoutEffect: false });
      this.touched.add(group);
    });
    this.waits.fill(undefined);
    this.told.fill(undefined);
    this.asked.fill(false);
    return this.touched;
  }
}

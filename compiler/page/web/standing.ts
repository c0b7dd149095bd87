// SPDX-License-Identifier: MIT
// Where each group stands, kept up event by event: what the engine's own view says at rest (compiler/play/moment.cpp), found from what it told.

import { type Names, nobody } from './names';
import type { Shape } from './shape';

/** As `directorc graph --step` marks groups; unknown: events are missing, and nothing was told of it since. */
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
  /** Who is in charge; `nobody`. */
  provider: number;
  /** The edge that holds it; `nobody`, `limbo`. */
  holder: number;
  push?: Push;
  /** Requests of it that wait, its own or those of others beside the one that has it. */
  waits: Wait[];
}

interface Group {
  known: boolean;
  holder: number;
  provider: number;
  granted: boolean;
  push?: Push;
}

export class Standings {
  private readonly groups: Group[];
  private readonly waits: (Wait | undefined)[]; // by edge
  private readonly touched = new Set<number>();

  constructor(private readonly names: Names) {
    this.groups = names.header.groups.map(() => ({ known: true, holder: nobody, provider: nobody, granted: false }));
    this.waits = names.header.edges.map(() => undefined);
  }

  /** The groups that may stand elsewhere than before. */
  apply(shape: Shape): Set<number> {
    const { line, group, edge } = shape;
    const at = this.groups[group];
    this.touched.clear();
    switch (line.event) {
      case 'run': return at && (!at.granted || at.provider !== shape.provider || !at.known) ? this.run(at, shape) : this.touched;
      case 'grant': return at ? this.grant(at, shape) : this.touched;
      case 'lose': return at ? this.lose(at, group) : this.touched;
      case 'queue': return this.queue(shape);
      case 'withdraw': return this.forget(edge);
      case 'input': return line.input === 'cancel' ? this.forget(edge) : this.touched;
      case 'push': if (at) at.push = { edge, provider: shape.provider, condition: line.condition }; break;
      case 'release': if (at) at.push = undefined; break;
      case 'dropped': return this.lostTrack();
      default: return this.touched;
    }
    return this.touched.add(group);
  }

  of(group: number): Standing {
    const at = this.groups[group];
    const waits = this.names.askers[group].map((edge) => this.waits[edge]).filter((wait): wait is Wait => wait !== undefined);
    const pushed = at.push !== undefined && at.push.provider === at.provider;
    const mark = at.granted ? (pushed ? 'pushed' : 'running') : waits.length > 0 ? 'queued' : !at.known ? 'unknown' : at.holder !== nobody ? 'held' : 'inactive';
    return { mark, provider: at.provider, holder: at.holder, push: at.push, waits };
  }

  private run(at: Group, shape: Shape): Set<number> {
    at.granted = at.known = true;
    at.provider = shape.provider;
    if (at.holder >= 0) this.waits[at.holder] = undefined;
    return this.touched.add(shape.group);
  }

  private grant(at: Group, shape: Shape): Set<number> {
    if (at.granted && shape.provider === nobody) this.end(shape.group);
    at.known = true;
    at.holder = shape.edge;
    at.provider = shape.provider;
    at.granted = shape.provider !== nobody;
    if (at.granted && shape.edge >= 0) this.waits[shape.edge] = undefined;
    return this.touched.add(shape.group);
  }

  private lose(at: Group, group: number): Set<number> {
    this.end(group);
    at.known = true;
    at.holder = at.provider = nobody;
    at.push = undefined;
    return this.touched.add(group);
  }

  private queue(shape: Shape): Set<number> {
    const { edge, line, group } = shape;
    if (edge < 0) return this.touched;
    this.waits[edge] = { edge, why: line.why ?? '', condition: line.condition };
    if (this.groups[group].holder === edge) this.end(group);
    return this.touched.add(group);
  }

  /** Nobody asks by this edge any more. */
  private forget(edge: number): Set<number> {
    const group = this.names.targets[edge];
    if (group === undefined) return this.touched;
    this.waits[edge] = undefined;
    if (this.groups[group].holder === edge) this.end(group);
    return this.touched.add(group);
  }

  /** What does not run asks for nothing. */
  private end(group: number): void {
    this.groups[group].granted = false;
    this.groups[group].provider = nobody;
    for (const edge of this.names.requests[group]) {
      if (this.waits[edge] === undefined) continue;
      this.waits[edge] = undefined;
      this.touched.add(this.names.targets[edge]);
    }
  }

  private lostTrack(): Set<number> {
    this.groups.forEach((at, group) => {
      Object.assign(at, { known: false, granted: false, holder: nobody, provider: nobody, push: undefined });
      this.touched.add(group);
    });
    this.waits.fill(undefined);
    return this.touched;
  }
}

// SPDX-License-Identifier: MIT
// The names in the header of a trace, its first line (schemas/trace.schema.json), and the number of each: its index there.

export interface Header {
  director_trace: number;
  behaviour: string;
  fingerprint: string;
  groups: { name: string; providers: string[] }[];
  edges: { name: string; target: string; levels: string[] }[];
  states: { name: string; values?: string[] }[];
  triggers: string[];
  conditions: string[];
  level_uses?: LevelUse[]; // absent in traces of earlier programs
}

/** A task of a pack: at this level, its place in the edge's `levels`. */
export interface LevelUse {
  edge: string;
  provider?: string;
  pack_name?: string;
  level: number;
}

/** Instead of an index. `nobody`: none, or as a requester the program; `limbo`: as the holder of a group that limbo keeps. */
export const nobody = -1;
export const limbo = -2;

const places = (names: string[]): Map<string, number> => new Map(names.map((name, i) => [name, i]));

export class Names {
  private readonly groups: Map<string, number>;
  private readonly edges: Map<string, number>;
  private readonly states: Map<string, number>;
  readonly targets: number[]; // of each edge
  readonly requesters: number[]; // of each edge; `nobody`: the program
  readonly requests: number[][]; // of each group, the edges of which it is the requester
  readonly edgesTo: number[][]; // of each group, the edges that lead to it, from its requesters

  constructor(readonly header: Header) {
    this.groups = places(header.groups.map((group) => group.name));
    this.edges = places(header.edges.map((edge) => edge.name));
    this.states = places(header.states.map((state) => state.name));
    this.targets = header.edges.map((edge) => this.group(edge.target));
    this.requesters = header.edges.map((edge) => this.group(edge.name.split('>')[0]));
    const of = (ends: number[]) => header.groups.map((_, group) => header.edges.map((__, edge) => edge).filter((edge) => ends[edge] === group));
    this.requests = of(this.requesters);
    this.edgesTo = of(this.targets);
  }

  group(name: string | undefined): number {
    return this.groups.get(name ?? '') ?? nobody;
  }

  edge(name: string | undefined): number {
    return name === 'limbo' ? limbo : (this.edges.get(name ?? '') ?? nobody);
  }

  /** The level of a request, from its line in a trace: its place in the edge's `levels`. */
  level(edge: number, level: string | number | undefined): number {
    return typeof level === 'string' ? (this.header.edges[edge]?.levels.indexOf(level) ?? nobody) : (level ?? 0);
  }

  state(name: string | undefined): number {
    return this.states.get(name ?? '') ?? nobody;
  }

  provider(group: number, name: string | undefined): number {
    return this.header.groups[group]?.providers.indexOf(name ?? '') ?? nobody;
  }

  /** `Walk.halting`; only `Walk` if the group has no named providers. */
  providerText(group: number, provider: number): string {
    const { name, providers } = this.header.groups[group];
    const own = providers[provider];
    return own === undefined || own === 'default' ? name : `${name}.${own}`;
  }

  /** The requester of this edge: a group, or the program. */
  requesterText(edge: number): string {
    const group = this.requesters[edge] ?? nobody;
    return group === nobody ? 'the program' : this.header.groups[group].name;
  }
}

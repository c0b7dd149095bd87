// SPDX-License-Identifier: MIT
// The part of the page's JSON that the script reads. Schema: schemas/graph.schema.json.

export interface Cell {
  kind: string;
  words: string;
  scenario?: number[];
}

export interface Row {
  group: string;
  reached: boolean;
  words: string;
  cells: Cell[];
}

/** The rule that decides between two tasks of one requester. */
export interface Decision {
  goes_first: string;
  words: string;
}

/** The order of two groups. `decisions`: twice the index in Data.ranks.decisions, plus 1 if the first group is on the side of the second task. */
export interface Answer {
  leads?: string;
  decisions: number[];
  more?: number; // the number of decisions that the page does not have
}

export interface Data {
  behaviour: string;
  layers?: string[];
  groups: { name: string; doc?: string; layer?: string; module?: string }[];
  states: { name: string; doc?: string; initial?: string }[];
  ranks?: { decisions: Decision[]; answers: Answer[]; pairs: number[][] };
  transitions?: { rows: Row[]; pieces: string[] };
}

export function readData(): Data {
  const text = document.getElementById('data')?.textContent ?? '{}';
  return JSON.parse(text) as Data;
}

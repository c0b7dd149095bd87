// SPDX-License-Identifier: MIT
// What the script reads of the page's JSON. Schema: schemas/graph.schema.json.

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

/** What decides between two tasks of one requester. */
export interface Decision {
  goes_first: string;
  words: string;
}

/** Codes of decisions: twice the place, and one more where the first group is on the side of the second task. */
export interface Answer {
  leads?: string;
  decisions: number[];
  more?: number; // that the page does not have
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

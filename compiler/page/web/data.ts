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

export interface Data {
  behaviour: string;
  groups: { name: string; doc?: string }[];
  states: { name: string; doc?: string }[];
  transitions?: { rows: Row[]; pieces: string[] };
}

export function readData(): Data {
  const text = document.getElementById('data')?.textContent ?? '{}';
  return JSON.parse(text) as Data;
}

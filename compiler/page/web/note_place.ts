// SPDX-License-Identifier: MIT
// Where a note stands beside its box, and how its words are divided into lines: so that it hides no other box, if there is such a place, and as few
// labels of arrows as possible.

export interface Rect {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** A line of a note, and which of the texts in the note it belongs to. */
export interface Line {
  text: string;
  of: number;
}

export interface Place extends Rect {
  lines: Line[];
  size: number; // of its letters
}

export interface Surroundings {
  paper: Rect; // of the picture
  boxes: Rect[]; // and notes that have a place already
  labels: Rect[];
}

const smallest = 9; // of letters
const gap = 1; // between the box and its note, and between that and the edge of the paper
const border = 4; // beside the lines
const spare = 1.03; // lines may be drawn wider than they are measured, by this factor
const narrow = 14; // letters in a line of a narrow note ...
const usual = 26; // ... and of a usual one

// What is better costs less. The unit is a square point of a label that is hidden.
const costOfBox = 1000; // a square point of a box that is hidden, or of the note beyond the paper
const costOfSize = 10; // a point by which letters are smaller
const costOfPlace = 1; // each further place that is tried

export const heightOf = (lines: number, size: number): number => lines * size * 1.2 + 5;

function overlap(a: Rect, b: Rect): number {
  const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0;
}

const clamp = (value: number, from: number, to: number): number => Math.max(from, Math.min(to, value));

/** Lines of at most this width, unless a word is longer. `measure`: the width of a text at size 1. */
function wrapped(texts: string[], width: number, measure: (text: string) => number): Line[] {
  return texts.flatMap((text, of) => {
    const lines: Line[] = [];
    for (const word of text.split(' ')) {
      const last = lines[lines.length - 1];
      const longer = `${last?.text ?? ''} ${word}`;
      if (last && measure(longer) <= width) last.text = longer;
      else lines.push({ text: word, of });
    }
    return lines;
  });
}

/** Below, above and beside the frame, the usual place first. */
function corners(frame: Rect, width: number, height: number): [number, number][] {
  const [right, bottom] = [frame.x + frame.width, frame.y + frame.height];
  const xs = [frame.x + frame.width / 2 - width / 2, frame.x, right - width];
  const ys = [frame.y, frame.y + frame.height / 2 - height / 2, bottom - height];
  return [
    ...xs.map((x): [number, number] => [x, bottom + gap]), ...xs.map((x): [number, number] => [x, frame.y - gap - height]),
    ...ys.map((y): [number, number] => [right + gap, y]), ...ys.map((y): [number, number] => [frame.x - gap - width, y]),
  ];
}

/** `texts`: each begins a line. `size`: the letters that are wanted. `frame`: of its box, which is one of the boxes. The place is beyond the paper only where one of its words is wider. */
export function placeOf(texts: string[], size: number, frame: Rect, around: Surroundings, measure: (text: string) => number): Place {
  const paper = { x: around.paper.x + gap, y: around.paper.y + gap, width: around.paper.width - 2 * gap, height: around.paper.height - 2 * gap };
  const all = texts.join(' ');
  const letter = measure(all) / Math.max(1, all.length);
  const widest = paper.width / spare - 2 * border;
  let best: { place: Place; cost: number } | undefined;
  for (const each of [...new Set([size, (size + smallest) / 2, Math.min(size, smallest)])]) {
    const shapes = new Map<number, Line[]>();
    for (const width of [Math.max(frame.width, letter * each * usual) - 2 * border, widest, frame.width - 2 * border, letter * each * narrow]) {
      const lines = wrapped(texts, Math.min(width, widest) / each, measure);
      if (!shapes.has(lines.length)) shapes.set(lines.length, lines);
    }
    let tried = 0;
    for (const lines of shapes.values()) {
      const width = Math.max(...lines.map(({ text }) => measure(text))) * each * spare + 2 * border, height = heightOf(lines.length, each);
      const reach = { x: frame.x - width - gap, y: frame.y - height - gap, width: frame.width + 2 * (width + gap), height: frame.height + 2 * (height + gap) };
      const isNear = (rect: Rect): boolean => overlap(rect, reach) > 0;
      const boxes = around.boxes.filter(isNear), labels = around.labels.filter(isNear);
      for (const [x, y] of corners(frame, width, height)) {
        const place = { x: clamp(x, paper.x, paper.x + paper.width - width), y: clamp(y, paper.y, paper.y + paper.height - height), width, height, lines, size: each };
        const cut = width * height - overlap(place, paper);
        let cost = costOfPlace * tried++ + costOfSize * (size - each) + costOfBox * cut;
        for (const box of boxes) cost += costOfBox * overlap(place, box);
        for (const label of labels) cost += overlap(place, label);
        if (!best || cost < best.cost) best = { place, cost };
      }
    }
  }
  return best?.place ?? { ...frame, lines: texts.map((text, of) => ({ text, of })), size };
}

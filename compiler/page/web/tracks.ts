// SPDX-License-Identifier: MIT
// The tracks: one for each group, with a slice for each standing, then one for each state, and at the top a ruler with pushes and hand-overs. If more
// slices of a group are in the viewport than pixels, each pixel shows the shares of the marks in its time: the cost depends on the number of pixels.

import { drawSlice, drawText, hatch, type Look } from './look';
import type { Because, Recording, Track } from './recording';
import { Shares, summed } from './shares';
import { words } from './standing_words';
import type { View } from './view';

export const rowHeight = 20;
export const rulerHeight = 34;
const inset = 2;
const mostArrows = 250;

export interface Row {
  group?: number;
  state?: number;
}

/** The slice under the pointer. */
export interface Hit {
  row: Row;
  from: number;
  to: number;
  event: number;
}

export class Tracks {
  rows: Row[] = [];
  private readonly shares: Shares[];

  /** `why`: why a group waits after an event; undefined: not known. */
  constructor(private readonly recording: Recording, private readonly view: View, private readonly why: (group: number, event: number) => Because | undefined) {
    this.shares = recording.groups.map((track) => new Shares(recording, track));
  }

  get height(): number {
    return rulerHeight + this.rows.length * rowHeight + 2;
  }

  draw(to: CanvasRenderingContext2D, width: number, look: Look): void {
    to.clearRect(0, 0, width, this.height);
    to.font = '11px system-ui, sans-serif';
    to.textBaseline = 'middle';
    const events = this.eventsAtPoints(width);
    this.drawRuler(to, width, look);
    this.rows.forEach((row, i) => {
      const y = rulerHeight + i * rowHeight + inset;
      if (row.group !== undefined) this.drawGroup(to, width, look, row.group, y, events);
      else if (row.state !== undefined) this.drawState(to, width, look, row.state, y, events);
    });
    this.drawGaps(to, width, look);
    this.drawFlows(to, width, look, events);
    this.drawFaults(to, width, look, events);
  }

  hit(x: number, y: number, width: number): Hit | undefined {
    const row = this.rows[Math.floor((y - rulerHeight) / rowHeight)];
    if (!row || y < rulerHeight) return undefined;
    const track = row.group === undefined ? this.recording.states[row.state ?? 0] : this.recording.groups[row.group];
    const event = Math.max(this.recording.first, this.recording.eventAt(this.view.timeAt(x, width)));
    const place = Math.max(0, track.event.upTo(event) - 1);
    return { row, from: this.begin(track, place), to: Math.min(this.recording.ends, this.begin(track, place + 1)), event };
  }

  private eventsAtPoints(width: number): number[] {
    return Array.from({ length: width + 1 }, (_, x) => this.recording.eventAt(this.view.timeAt(x, width)));
  }

  private begin(track: Track, place: number): number {
    if (place >= track.event.length) return this.view.last; // so the last slice has a width even if all events have one time
    const event = track.event.at[place];
    return place === 0 || event < this.recording.first ? this.recording.begins : this.recording.timeOf(event);
  }

  private drawGroup(to: CanvasRenderingContext2D, width: number, look: Look, group: number, y: number, events: number[]): void {
    const track = this.recording.groups[group];
    const height = rowHeight - 2 * inset;
    if (this.count(track, events, width) > width) return this.drawShares(to, width, look, group, y, height, events);
    drawSlice(to, look, 'inactive', 0, y, width, height);
    this.eachSlice(track, width, events, (value, x, length) => {
      const standing = this.recording.standings[value];
      if (standing.mark === 'inactive') return;
      drawSlice(to, look, standing.mark, x, y, length, height);
      const solid = standing.mark === 'running' || standing.mark === 'pushed';
      const why = standing.mark === 'queued' ? this.why(group, events[Math.min(events.length - 1, Math.max(0, Math.ceil(x)))]) : undefined;
      drawText(to, words(this.recording.names, group, standing, why), solid ? look.onFill : look.ink, x, y + height / 2 + 1, length);
    });
  }

  private drawShares(to: CanvasRenderingContext2D, width: number, look: Look, group: number, y: number, height: number, events: number[]): void {
    const colours = [look.running, look.pushed, look.queued, look.grey, look.line]; // in the order of `summed`
    const shares = this.shares[group];
    shares.prepare();
    let [before, after]: number[][] = [[], []];
    shares.until(events[0], this.view.timeAt(0, width), before);
    for (let x = 0; x < width; ++x) {
      const [begin, end] = [this.view.timeAt(x, width), this.view.timeAt(x + 1, width)];
      shares.until(events[x + 1], end, after);
      let bottom = y + height;
      summed.forEach((mark, i) => {
        const part = (after[i] - before[i]) / Math.max(1, end - begin);
        if (part < 1e-6) return;
        const tall = Math.max(1, Math.round(part * height));
        to.fillStyle = colours[i];
        if (mark !== 'queued' || x % 3 !== 2) to.fillRect(x, Math.max(y, bottom - tall), 1, tall);
        bottom -= tall;
      });
      [before, after] = [after, before];
    }
  }

  private drawState(to: CanvasRenderingContext2D, width: number, look: Look, state: number, y: number, events: number[]): void {
    const track = this.recording.states[state];
    const height = rowHeight - 2 * inset;
    to.strokeStyle = look.line;
    to.lineWidth = 1;
    if (this.count(track, events, width) > width) {
      hatch(to, look.grey, 0, y, width, height, 0.5);
      return drawText(to, 'changes too often to be shown at this zoom', look.ink, 0, y + height / 2 + 1, width);
    }
    this.eachSlice(track, width, events, (value, x, length) => {
      to.fillStyle = look.paper;
      to.fillRect(x, y, length, height);
      to.strokeRect(x + 0.5, y + 0.5, Math.max(length - 1, 0), height - 1);
      const text = this.recording.values[value];
      drawText(to, text === undefined ? 'not known' : (text ?? 'unset'), look.ink, x, y + height / 2 + 1, length);
    });
  }

  private count(track: Track, events: number[], width: number): number {
    return track.event.upTo(events[width]) - track.event.upTo(events[0]);
  }

  /** Calls `draw` for each slice in the viewport, without those that last no time. */
  private eachSlice(track: Track, width: number, events: number[], draw: (value: number, x: number, length: number) => void): void {
    const first = Math.max(0, track.event.upTo(events[0]) - 1);
    const last = Math.max(first + 1, track.event.upTo(events[width]));
    for (let place = first; place < last; ++place) {
      const [begin, end] = [this.begin(track, place), this.begin(track, place + 1)];
      if (begin === end && place + 1 < track.event.length) continue;
      const from = Math.max(0, this.view.xOf(begin, width));
      draw(track.value.at[place], from, Math.max(1, Math.min(width, this.view.xOf(end, width)) - from));
    }
  }

  private drawRuler(to: CanvasRenderingContext2D, width: number, look: Look): void {
    const wish = (this.view.length / width) * 90;
    const power = 10 ** Math.floor(Math.log10(wish));
    const step = [1, 2, 5, 10].map((each) => each * power).find((each) => each >= wish) ?? wish;
    const digits = Math.max(0, Math.min(6, 6 - Math.floor(Math.log10(step) + 1e-9)));
    to.fillStyle = look.ink;
    for (let time = Math.ceil(this.view.from / step) * step; time <= this.view.to; time += step) {
      const x = Math.round(this.view.xOf(time, width));
      to.fillStyle = look.line;
      to.fillRect(x, 14, 1, this.height);
      to.fillStyle = look.ink;
      const text = `${(time / 1e6).toFixed(digits)} s`;
      if (x + to.measureText(text).width < width) to.fillText(text, x + 2, 8);
    }
  }

  private drawGaps(to: CanvasRenderingContext2D, width: number, look: Look): void {
    for (let i = 0; i < this.recording.gaps.length; ++i) {
      const event = this.recording.gaps.at[i];
      const x = this.view.xOf(this.recording.timeOf(event), width);
      if (x < 0 || x > width) continue;
      to.fillStyle = look.queued;
      to.fillRect(x - 1, 0, 3, this.height);
      drawText(to, this.recording.shapeAt(event).text, look.queued, x + 3, 24, width - x);
    }
  }

  /** Crosses above the tracks, and on the track of the group if it is a fault of one; if there are many, short lines. */
  private drawFaults(to: CanvasRenderingContext2D, width: number, look: Look, events: number[]): void {
    const { faults } = this.recording;
    const [first, last] = [faults.upTo(this.before()), faults.upTo(events[width])];
    const rowOf = new Map(this.rows.map((row, i) => [row.group, i]));
    const drawn = new Set<string>();
    for (let i = first; i < last; ++i) {
      const event = faults.at[i];
      const x = Math.round(this.view.xOf(this.recording.timeOf(event), width));
      const row = rowOf.get(this.recording.shapeAt(event).group);
      for (const y of row === undefined ? [24] : [24, rulerHeight + row * rowHeight + rowHeight / 2]) {
        if (drawn.has(`${x} ${y}`)) continue;
        drawn.add(`${x} ${y}`);
        if (last - first <= mostArrows) {
          drawCross(to, look, x, y);
        } else {
          to.fillStyle = look.queued;
          to.fillRect(x, y - 4, 1, 8);
        }
      }
    }
  }

  /** The last event before the viewport: those at its first moment are in it. */
  private before(): number {
    return this.view.from <= this.recording.begins ? this.recording.first - 1 : this.recording.eventAt(this.view.from - 1);
  }

  /** Pushes are triangles, hand-overs diamonds, with an arrow from the group that waits or loses to the other one; if there are many, short lines. */
  private drawFlows(to: CanvasRenderingContext2D, width: number, look: Look, events: number[]): void {
    const { flows } = this.recording;
    const [first, last] = [flows.upTo(this.before()), flows.upTo(events[width])];
    const drawn = new Set<string>();
    for (let i = first; i < last; ++i) {
      const event = flows.at[i];
      const shape = this.recording.shapeAt(event);
      const x = Math.round(this.view.xOf(this.recording.timeOf(event), width));
      const pushes = shape.line.event === 'push';
      const colour = pushes ? look.pushed : look.take;
      const isCrowd = last - first > mostArrows;
      if (!drawn.has(`${x} ${pushes}`)) isCrowd ? drawTick(to, colour, pushes, x) : drawSign(to, colour, pushes, x, 24);
      drawn.add(`${x} ${pushes}`);
      if (isCrowd) continue;
      const { names } = this.recording;
      const from = pushes ? names.targets[shape.edge] : names.requesters[shape.from];
      const until = pushes ? shape.group : names.requesters[shape.edge];
      this.drawArrow(to, colour, x, from, until, drawn);
    }
  }

  private drawArrow(to: CanvasRenderingContext2D, colour: string, x: number, from: number, until: number, drawn: Set<string>): void {
    const [a, b] = [from, until].map((group) => this.rows.findIndex((row) => row.group !== undefined && row.group === group));
    const key = `${x} ${a} ${b}`;
    if (a < 0 || b < 0 || a === b || drawn.has(key)) return;
    drawn.add(key);
    const [y, end] = [a, b].map((row) => rulerHeight + row * rowHeight + rowHeight / 2);
    const down = end > y ? 1 : -1;
    to.strokeStyle = to.fillStyle = colour;
    to.lineWidth = 1.5;
    to.beginPath();
    to.arc(x, y, 2.5, 0, 7);
    to.fill();
    to.beginPath();
    to.moveTo(x, y);
    to.lineTo(x, end - down * 5);
    to.stroke();
    to.beginPath();
    to.moveTo(x, end);
    to.lineTo(x - 3.5, end - down * 7);
    to.lineTo(x + 3.5, end - down * 7);
    to.fill();
  }
}

function drawTick(to: CanvasRenderingContext2D, colour: string, isPush: boolean, x: number): void {
  to.fillStyle = colour;
  to.fillRect(x, isPush ? 17 : 25, 1, 7);
}

/** On a border of the colour of paper, to be seen on any track. */
function drawCross(to: CanvasRenderingContext2D, look: Look, x: number, y: number): void {
  for (const [colour, width] of [[look.paper, 5], [look.queued, 2.5]] as const) {
    to.strokeStyle = colour;
    to.lineWidth = width;
    to.beginPath();
    to.moveTo(x - 4, y - 4);
    to.lineTo(x + 4, y + 4);
    to.moveTo(x + 4, y - 4);
    to.lineTo(x - 4, y + 4);
    to.stroke();
  }
}

function drawSign(to: CanvasRenderingContext2D, colour: string, isPush: boolean, x: number, y: number): void {
  to.fillStyle = colour;
  to.beginPath();
  to.moveTo(x, y - 5);
  to.lineTo(x + 5, isPush ? y + 5 : y);
  to.lineTo(isPush ? x - 5 : x, y + 5);
  if (!isPush) to.lineTo(x - 5, y);
  to.fill();
}

// SPDX-License-Identifier: MIT
// A strip of the whole recording: it shows where pushes, hand-overs, faults and gaps are, and which part of the time the tracks show.

import type { Cursor } from './cursor';
import { make } from './elements';
import type { Look } from './look';
import type { Recording } from './recording';
import type { View } from './view';

const height = 24;

/** `chosen`: called before a click goes to a time; `changed`: after it. */
export class Overview {
  readonly element = make('div', { class: 'overview', 'aria-hidden': 'true' });
  private readonly canvas = make('canvas');
  private readonly window = make('div', { class: 'window' });
  private readonly line = make('div', { class: 'cursor' });
  private width = 0;

  constructor(private readonly recording: Recording, private readonly view: View, private readonly cursor: Cursor, private readonly chosen: () => void, private readonly changed: () => void) {
    this.element.append(this.canvas, this.window, this.line);
    this.element.addEventListener('pointerdown', (event) => {
      this.element.setPointerCapture(event.pointerId);
      this.go(event);
    });
    this.element.addEventListener('pointermove', (event) => event.buttons & 1 && this.go(event));
  }

  draw(look: Look): void {
    const width = (this.width = this.element.clientWidth);
    this.canvas.width = width * devicePixelRatio;
    this.canvas.height = height * devicePixelRatio;
    const to = this.canvas.getContext('2d');
    if (!to || width === 0) return;
    to.scale(devicePixelRatio, devicePixelRatio);
    const { flows, gaps, faults } = this.recording;
    for (let i = 0; i < flows.length; ++i) this.mark(to, flows.at[i], width, this.recording.shapeAt(flows.at[i]).line.event === 'push' ? look.pushed : look.take);
    for (const column of [gaps, faults]) for (let i = 0; i < column.length; ++i) this.mark(to, column.at[i], width, look.queued);
    const [from, until] = [this.xOf(this.view.from, width), this.xOf(this.view.to, width)];
    this.window.style.transform = `translateX(${from}px)`;
    this.window.style.width = `${Math.max(4, until - from)}px`;
    this.showCursor();
  }

  showCursor(): void {
    this.line.style.transform = `translateX(${this.xOf(this.cursor.time, this.width)}px)`;
  }

  /** Pushes are in the upper half, hand-overs in the lower half, faults and gaps in both. */
  private mark(to: CanvasRenderingContext2D, event: number, width: number, colour: string): void {
    const shape = this.recording.shapeAt(event);
    const isPush = shape.line.event === 'push', isFault = shape.sort === 'fault';
    to.fillStyle = colour;
    to.fillRect(Math.floor(this.xOf(this.recording.timeOf(event), width)), isPush || isFault ? 3 : height / 2, 1, isFault ? height - 6 : height / 2 - 3);
  }

  private xOf(time: number, width: number): number {
    const length = this.view.last - this.recording.begins;
    return ((time - this.recording.begins) / length) * width;
  }

  private go(event: PointerEvent): void {
    this.chosen();
    const box = this.element.getBoundingClientRect();
    const time = this.recording.begins + ((event.clientX - box.left) / box.width) * (this.view.last - this.recording.begins);
    this.view.pan((time - (this.view.from + this.view.to) / 2) / this.view.length);
    this.cursor.goToTime(Math.round(time));
    this.changed();
  }
}

// SPDX-License-Identifier: MIT
// Plays the recording: moves the cursor at a chosen speed.

import type { Cursor } from './cursor';
import { button, make } from './elements';
import type { Recording } from './recording';

const speeds = [0.1, 0.25, 1, 2, 5, 10, 60];

export class Player {
  readonly element: HTMLElement;
  private readonly toggle = button('Play', () => this.flip(), { class: 'play' });
  private readonly speed = make('select', { id: 'speed' }, ...speeds.map((each) => make('option', { value: String(each) }, `${each} ×`)));
  private last: number | undefined; // the time of the last frame; undefined: not playing

  constructor(private readonly recording: Recording, private readonly cursor: Cursor, private readonly started: () => void) {
    this.speed.value = '1';
    this.element = make('span', { class: 'row' }, this.toggle, make('label', { for: 'speed' }, 'Speed'), this.speed);
  }

  get plays(): boolean {
    return this.last !== undefined;
  }

  flip(): void {
    if (this.plays) return this.stop();
    this.started();
    if (this.cursor.time >= this.recording.ends) this.cursor.goToTime(this.recording.begins);
    this.last = performance.now();
    this.say();
    requestAnimationFrame((now) => this.frame(now));
  }

  stop(): void {
    this.last = undefined;
    this.say();
  }

  private frame(now: number): void {
    if (this.last === undefined) return;
    const passed = Math.max(0, now - this.last) * 1000 * Number(this.speed.value);
    this.last = now;
    this.cursor.goToTime(this.cursor.time + passed);
    if (this.cursor.time >= this.recording.ends) return this.stop();
    requestAnimationFrame((next) => this.frame(next));
  }

  private say(): void {
    this.toggle.textContent = this.plays ? 'Pause' : 'Play';
  }
}

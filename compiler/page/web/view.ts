// SPDX-License-Identifier: MIT
// The part of the time that the tracks show.

import type { Recording } from './recording';

const shortest = 200; // microseconds
const usual = 20e6; // of what grows, so much of the end

export class View {
  from: number;
  to: number;
  private wanted = usual; // how much is seen while the end is followed

  constructor(private readonly recording: Recording) {
    this.from = recording.begins;
    this.to = this.last;
  }

  get length(): number {
    return this.to - this.from;
  }

  xOf(time: number, width: number): number {
    return ((time - this.from) / this.length) * width;
  }

  timeAt(x: number, width: number): number {
    return Math.round(this.from + (x / width) * this.length);
  }

  /** `factor` below 1: closer, with this time where it is. */
  zoom(factor: number, around: number): void {
    const whole = this.last - this.recording.begins;
    const length = Math.min(Math.max(this.length * factor, Math.min(shortest, whole)), whole);
    this.wanted = length;
    this.put(around - ((around - this.from) / this.length) * length, length);
  }

  /** By a part of what is shown. */
  pan(part: number): void {
    this.put(this.from + part * this.length, this.length);
  }

  /** To the end, as wide as it was made last. */
  toEnd(): void {
    this.put(this.last, Math.min(this.wanted, this.last - this.recording.begins));
  }

  whole(): void {
    this.wanted = Infinity;
    this.put(this.recording.begins, this.last - this.recording.begins);
  }

  /** So that the time is in it. */
  reveal(time: number): boolean {
    if (time >= this.from && time <= this.to) return false;
    this.put(time - this.length / 10, this.length);
    return true;
  }

  private put(from: number, length: number): void {
    this.from = Math.max(this.recording.begins, Math.min(from, this.last - length));
    this.to = this.from + length;
  }

  /** Where it ends what can be seen: of a recording that has no length a little later. */
  get last(): number {
    return Math.max(this.recording.ends, this.recording.begins + 1000);
  }
}

// SPDX-License-Identifier: MIT
// The part of the time that the tracks show.

import type { Recording } from './recording';

const shortest = 200; // microseconds

export class View {
  from: number;
  to: number;

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
    this.put(around - ((around - this.from) / this.length) * length, length);
  }

  /** By a part of what is shown. */
  pan(part: number): void {
    this.put(this.from + part * this.length, this.length);
  }

  whole(): void {
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

  /** Never none at all. */
  private get last(): number {
    return Math.max(this.recording.ends, this.recording.begins + 1000);
  }
}

// SPDX-License-Identifier: MIT
// The viewport of the tracks: the part of the recording's time that they show.

import type { Recording } from './recording';

const shortest = 200; // microseconds
const room = 0.02; // of the length
const mostRoom = 400e3; // microseconds
const usual = 20e6; // microseconds: how much of a growing recording is shown at first

export class View {
  from: number;
  to: number;
  private wanted = usual; // microseconds: how much is shown while the end is followed

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

  /** `factor` below 1: zooms in. The time `around` keeps its position. */
  zoom(factor: number, around: number): void {
    const whole = this.last - this.recording.begins;
    const length = Math.min(Math.max(this.length * factor, Math.min(shortest, whole)), whole);
    this.wanted = length;
    this.put(around - ((around - this.from) / this.length) * length, length);
  }

  /** `part`: of the length that is shown. */
  pan(part: number): void {
    this.put(this.from + part * this.length, this.length);
  }

  /** Moves to the end, with the length of the last zoom. */
  toEnd(): void {
    this.put(this.last, Math.min(this.wanted, this.last - this.recording.begins));
  }

  whole(): void {
    this.wanted = Infinity;
    this.put(this.recording.begins, this.last - this.recording.begins);
  }

  /** Moves so that this time is shown; false: it was already. */
  reveal(time: number): boolean {
    if (time >= this.from && time <= this.to) return false;
    this.put(time - this.length / 10, this.length);
    return true;
  }

  private put(from: number, length: number): void {
    this.from = Math.max(this.recording.begins, Math.min(from, this.last - length));
    this.to = this.from + length;
  }

  /**
   * The end of the time that can be shown: after that of the recording, since what begins there must have a width, and at least 1 ms after the
   * beginning, as the length must not be 0.
   */
  get last(): number {
    const { begins, ends } = this.recording;
    return ends + Math.max(1000, Math.min(mostRoom, (ends - begins) * room));
  }
}

// SPDX-License-Identifier: MIT
// The moment that is shown: a time, and the last event that has happened by then, or one that was chosen. Everything that shows the moment is notified when it changes.

import type { Recording } from './recording';

export class Cursor {
  time: number;
  event: number;
  private readonly listeners: (() => void)[] = [];

  constructor(private readonly recording: Recording) {
    this.time = recording.begins;
    this.event = recording.eventAt(this.time); // the last of all events at this time
  }

  /** What is shown is the situation after this event: between the events of a micro-step, states, requests and answers do not fit together yet. */
  get settled(): number {
    return this.recording.endOfStep(this.event);
  }

  onMove(listener: () => void): void {
    this.listeners.push(listener);
  }

  goToTime(time: number): void {
    this.time = Math.min(Math.max(time, this.recording.begins), this.recording.ends);
    this.event = this.recording.eventAt(this.time);
    this.tell();
  }

  goToEvent(event: number): void {
    this.event = Math.min(Math.max(event, this.recording.first), this.recording.end - 1);
    this.time = this.recording.end > this.recording.first ? this.recording.timeOf(this.event) : 0;
    this.tell();
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}

/** `12.600 s`; with microseconds if they are not 0. */
export function seconds(time: number): string {
  return `${(time / 1e6).toFixed(time % 1000 === 0 ? 3 : 6)} s`;
}

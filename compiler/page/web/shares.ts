// SPDX-License-Identifier: MIT
// How long a group was what, between any two times: sums from the beginning on, so that an hour in a thousand points costs as much as a second.

import { type Column, times } from './columns';
import type { Recording, Track } from './recording';
import type { Mark } from './standing';

export const summed = ['running', 'pushed', 'queued', 'held', 'unknown'] as const satisfies readonly Mark[];
export type Summed = (typeof summed)[number];

export class Shares {
  private sums = new Map<Summed, Column<Float64Array>>(); // up to the beginning of each stretch
  private of = -1; // Recording.first for which they are

  constructor(private readonly recording: Recording, private readonly track: Track) {}

  /** Of the time between the moments after two events. `end` and `begin`: those moments. */
  between(mark: Summed, fromEvent: number, begin: number, toEvent: number, end: number): number {
    if (end <= begin) return 0;
    this.extend();
    return (this.until(mark, toEvent, end) - this.until(mark, fromEvent, begin)) / (end - begin);
  }

  private until(mark: Summed, event: number, time: number): number {
    const place = Math.max(0, this.track.event.upTo(event) - 1);
    const sum = this.sums.get(mark)?.at[place] ?? 0;
    return sum + (this.markAt(place) === mark ? time - this.begin(place) : 0);
  }

  private markAt(place: number): Mark {
    return this.recording.standings[this.track.value.at[place]].mark;
  }

  private begin(place: number): number {
    const event = this.track.event.at[place];
    return event < this.recording.first || place === 0 ? this.recording.begins : this.recording.timeOf(event);
  }

  private extend(): void {
    if (this.of !== this.recording.first) this.sums = new Map(summed.map((mark) => [mark, times()]));
    this.of = this.recording.first;
    const done = this.sums.get('running')?.length ?? 0;
    for (let place = done; place < this.track.event.length; ++place) {
      const mark = place === 0 ? undefined : this.markAt(place - 1);
      const length = place === 0 ? 0 : this.begin(place) - this.begin(place - 1);
      for (const [each, column] of this.sums) column.push((place === 0 ? 0 : column.last) + (each === mark ? length : 0));
    }
  }
}

// SPDX-License-Identifier: MIT
// How long a group had each mark up to any time: as prefix sums, so that to draw an hour in a thousand pixels costs as much as to draw a second.

import { type Column, times } from './columns';
import type { Recording, Track } from './recording';
import type { Mark } from './standing';

export const summed = ['running', 'pushed', 'queued', 'held', 'unknown'] as const satisfies readonly Mark[];

export class Shares {
  private sums: Column<Float64Array>[] = []; // for each mark, its time up to the beginning of each slice
  private of = -1; // the Recording.first of the sums

  constructor(private readonly recording: Recording, private readonly track: Track) {}

  /** Brings the sums up to date; to be called before calls of until(). */
  prepare(): void {
    if (this.of !== this.recording.first) this.sums = summed.map(times);
    this.of = this.recording.first;
    for (let place = this.sums[0].length; place < this.track.event.length; ++place) {
      const mark = place === 0 ? undefined : this.markAt(place - 1);
      const length = place === 0 ? 0 : this.begin(place) - this.begin(place - 1);
      this.sums.forEach((column, i) => column.push((place === 0 ? 0 : column.last) + (summed[i] === mark ? length : 0)));
    }
  }

  /** Writes the time of each mark up to `time` into `out`; `event`: the last event up to that time. */
  until(event: number, time: number, out: number[]): void {
    const place = Math.max(0, this.track.event.upTo(event) - 1);
    const mark = this.markAt(place);
    for (let i = 0; i < summed.length; ++i) out[i] = this.sums[i].at[place] + (summed[i] === mark ? time - this.begin(place) : 0);
  }

  private markAt(place: number): Mark {
    return this.recording.standings[this.track.value.at[place]].mark;
  }

  private begin(place: number): number {
    const event = this.track.event.at[place];
    return event < this.recording.first || place === 0 ? this.recording.begins : this.recording.timeOf(event);
  }
}

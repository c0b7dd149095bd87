// SPDX-License-Identifier: MIT
// The answers of a running program to why groups wait. Each is of the time at which it was given, and is shown for another moment only if everything
// that it mentions was the same then: since when the group waits, the holder of the group that blocks it, the values of the states, the standings of
// the groups, and which of their providers are enabled.

import { type Column, times } from './columns';
import { limbo, nobody } from './names';
import type { Because, Recording } from './recording';

/** Of a group. Recordings forget events too, so more are never needed. */
const most = 2000;

interface Given {
  time: Column<Float64Array>; // in ascending order
  because: Because[];
}

export class Answers {
  private readonly given: Given[];

  constructor(private readonly recording: Recording) {
    this.given = recording.names.header.groups.map(() => ({ time: times(), because: [] }));
  }

  /** `time`: up to which the answer is true; the events up to it may not have come yet. */
  add(group: number, time: number, because: Because): void {
    const given = this.given[group];
    const last = given.because[given.because.length - 1];
    const isSame = last !== undefined && last.text === because.text && JSON.stringify(last.held) === JSON.stringify(because.held);
    if (given.time.length > 0 && time <= given.time.last) { // an earlier one was given before the last events of that time
      given.because[given.because.length - 1] = because;
      return;
    }
    given.time.push(time);
    given.because.push(isSame ? last : because); // so that equal texts are kept once
    if (given.because.length <= most) return;
    given.time.drop(most / 2);
    given.because.splice(0, most / 2);
  }

  /** The last answer that was given up to this moment, or the first one behind it; undefined: neither is true then. */
  at(group: number, event: number): Because | undefined {
    const { recording } = this;
    const given = this.given[group];
    const next = event + 1 < recording.end ? recording.timeOf(event + 1) : Infinity;
    const behind = given.time.upTo(next === Infinity ? next : next - 1); // whole microseconds
    for (const place of [behind - 1, behind]) {
      const because = given.because[place];
      if (because && this.fits(because, group, recording.eventAt(given.time.at[place]), event)) return because;
    }
    return undefined;
  }

  /** Whether what was answered after the event `then` is true after `event`. */
  private fits(because: Because, group: number, then: number, event: number): boolean {
    const { recording } = this;
    if (then < recording.first || recording.sinceOf(group, then) !== recording.sinceOf(group, event)) return false;
    if (because.held !== undefined && !this.isHeld(recording.names.group(because.held.group), recording.names.edge(because.held.by), event)) return false;
    const { groups, states } = recording.names.header;
    const isNamedGroup = (i: number): boolean => isNamed(groups[i].name, because.text);
    if (groups.some((_, i) => recording.standingAt(i, then) !== recording.standingAt(i, event) && isNamedGroup(i))) return false;
    const [from, to] = [Math.min(then, event), Math.max(then, event)];
    for (let i = recording.switches.upTo(from); i < recording.switches.upTo(to); ++i) if (isNamedGroup(recording.shapeAt(recording.switches.at[i]).group)) return false;
    return states.every(({ name }, i) => recording.valueAt(i, then) === recording.valueAt(i, event) || !isNamed(name, because.text));
  }

  private isHeld(group: number, by: number, event: number): boolean {
    return group === nobody || by === nobody || by === limbo || this.recording.standingAt(group, event).holder === by;
  }
}

/** Whether the text has this name, and not only as a part of another word. */
function isNamed(name: string, text: string): boolean {
  for (let at = text.indexOf(name); at >= 0; at = text.indexOf(name, at + 1)) {
    if (![text[at - 1], text[at + name.length]].some((beside) => beside !== undefined && /[\p{L}\p{N}_]/u.test(beside))) return true;
  }
  return false;
}

// SPDX-License-Identifier: MIT
// The list of events around the moment: its own one, and those that the filter does not hide. A click on an event goes to its moment.

import { type Cursor, seconds } from './cursor';
import { button, make } from './elements';
import type { Filter } from './filter';
import type { Recording } from './recording';

const before = 6;
const rows = 14;

/** `chosen`: called before a click goes to an event. */
export class EventList {
  readonly element = make('div', { id: 'events', tabindex: '0', role: 'region', 'aria-label': 'Events' });
  private readonly list = make('ol');
  private readonly hidden = make('p', { class: 'hint' });

  constructor(private readonly recording: Recording, private readonly cursor: Cursor, private readonly filter: Filter, private readonly chosen: () => void) {
    this.element.append(make('h3', {}, 'Events'), this.hidden, this.list);
  }

  show(): void {
    const { event } = this.cursor;
    const all = this.filter.events();
    const first = Math.max(0, Math.min(all.upTo(event) - before, all.length - rows), all.upTo(this.recording.first - 1));
    const events = [...all.at.subarray(first, Math.min(all.length, first + rows))];
    const past = events.filter((each) => each <= event).length;
    if (events.length > 0 && event >= this.recording.first && events[past - 1] !== event) events.splice(past, 0, event);
    const shown = events.indexOf(event);
    this.hidden.textContent = this.filter.hidden.length === 0 ? '' : `Hidden by the filter: ${this.filter.hidden.join(', ')}.`;
    this.list.replaceChildren(...events.map((each, i) => this.row(each, i === shown, each > event)));
    const current = this.list.children[shown] as HTMLElement | undefined;
    if (current) this.element.scrollTop += current.getBoundingClientRect().top - this.element.getBoundingClientRect().top - this.element.clientHeight / 2;
    if (events.length === 0) this.list.append(make('li', {}, 'None that the filter lets through.'));
  }

  private go(event: number): void {
    this.chosen();
    this.cursor.goToEvent(event);
  }

  private row(event: number, isLast: boolean, isLater: boolean): HTMLElement {
    const go = button(this.recording.shapeAt(event).text, () => this.go(event), isLast ? { 'aria-current': 'true' } : {});
    go.prepend(make('span', { class: 'time' }, seconds(this.recording.timeOf(event))));
    return make('li', { class: isLater ? 'later' : '' }, go);
  }
}

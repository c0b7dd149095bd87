// SPDX-License-Identifier: MIT
// The filter: which groups have a track, and which events are stepped to and listed.

import { type Column, counts } from './columns';
import { button, make } from './elements';
import type { Recording } from './recording';
import { type Sort, sorts } from './shape';

const words: Record<Sort, string> = {
  request: 'requests of the program', input: 'other inputs', run: 'runs', ask: 'what bodies request', 'hand-over': 'hand-overs', control: 'granted, lost and withdrawn', push: 'pushes', queue: 'queued',
  state: 'states set', handler: 'start and stop', result: 'done and failed', fault: 'faults and losses',
};
/** The kinds of events that are chosen at first; very frequent ones are not among them. */
const usual: Sort[] = ['request', 'hand-over', 'push', 'queue', 'state', 'handler', 'fault'];

export class Filter {
  readonly element = make('details', { class: 'filter' }, make('summary', {}, 'Filter'));
  private readonly chosenSorts = new Set<Sort>(usual);
  private readonly chosenGroups = new Map<number, boolean>(); // by the user; others are shown if something happens to them
  private shown = counts();
  private looked = 0; // the first event that has not been filtered into `shown` yet
  private let: boolean[] = []; // by the index of a shape: whether its events are shown; a cache
  private readonly boxes: HTMLInputElement[] = [];
  private readonly note = make('p', { class: 'hint', role: 'status' });

  /** `order`: the groups, in the order of their tracks. */
  constructor(private readonly recording: Recording, private readonly order: number[], private readonly changed: () => void) {
    const events = make('fieldset', {}, make('legend', {}, 'Events to step to and to list'));
    for (const sort of sorts) events.append(this.box(words[sort], this.chosenSorts.has(sort), (on) => (on ? this.chosenSorts.add(sort) : this.chosenSorts.delete(sort))).label);
    const groups = make('fieldset', {}, make('legend', {}, 'Groups'));
    for (const group of order) {
      const { label, input } = this.box(recording.names.header.groups[group].name, this.shows(group), (on) => this.choose(group, on));
      this.boxes.push(input);
      groups.append(label);
    }
    const all = (on?: boolean) => (): void => {
      this.chosenGroups.clear();
      if (on !== undefined) for (const group of order) this.chosenGroups.set(group, on);
      this.tell();
      this.anew();
    };
    groups.append(make('span', { class: 'row' }, button('All groups', all(true)), button('No group', all(false)), button('Those to which something happens', all())));
    this.element.append(make('div', {}, events, groups, this.note));
    this.element.addEventListener('toggle', () => this.tell());
    this.tell();
  }

  /** The groups that have a track, in order. `event`: instead those that are neither inactive nor unknown after this event. */
  groups(event?: number): number[] {
    if (this.element.open) this.tell(); // a recording that grows may have something of further groups
    return this.order.filter((group) => (event === undefined ? this.shows(group) : !['inactive', 'unknown'].includes(this.recording.standingAt(group, event).mark)));
  }

  /** The kinds of events that are not shown. */
  get hidden(): string[] {
    return sorts.filter((sort) => !this.chosenSorts.has(sort)).map((sort) => words[sort]);
  }

  /** The events that are shown, in order. */
  events(): Column<Uint32Array> {
    const { recording } = this;
    const gone = this.shown.upTo(recording.first - 1);
    if (gone > 0) this.shown.drop(gone);
    for (; this.looked < recording.end; ++this.looked) if (this.looked >= recording.first && this.lets(recording.shape.at[this.looked - recording.first])) this.shown.push(this.looked);
    return this.shown;
  }

  /** The next or previous event that is shown; undefined: there is none. */
  from(event: number, step: 1 | -1): number | undefined {
    const shown = this.events();
    const place = step === 1 ? shown.upTo(event) : shown.upTo(event - 1) - 1;
    return place >= 0 && place < shown.length ? shown.at[place] : undefined;
  }

  /** Whether events of this shape are shown. */
  private lets(place: number): boolean {
    let known = this.let[place];
    if (known === undefined) {
      const shape = this.recording.shapes[place];
      known = this.chosenSorts.has(shape.sort) && (shape.groups.length === 0 || shape.groups.some((group) => this.chosenGroups.get(group) ?? true));
      this.let[place] = known;
    }
    return known;
  }

  private anew(): void {
    this.shown = counts();
    this.looked = 0;
    this.let = [];
    this.changed();
  }

  private shows(group: number): boolean {
    return this.chosenGroups.get(group) ?? this.happens(group);
  }

  /** What has run or waited all the time that is kept counts too. */
  private happens(group: number): boolean {
    const { recording } = this;
    return recording.groups[group].event.length > 1 || !['inactive', 'unknown'].includes(recording.standingAt(group, recording.end - 1).mark);
  }

  private choose(group: number, on: boolean): void {
    this.chosenGroups.set(group, on);
    this.tell();
  }

  /** Brings the boxes and the note up to date. */
  private tell(): void {
    this.boxes.forEach((box, i) => (box.checked = this.shows(this.order[i])));
    const hidden = this.order.filter((group) => !this.shows(group)).length;
    this.note.textContent = hidden === 0 ? '' : `${hidden} ${hidden === 1 ? 'group has' : 'groups have'} no track.`;
  }

  private box(text: string, checked: boolean, act: (on: boolean) => void): { label: HTMLLabelElement; input: HTMLInputElement } {
    const input = make('input', { type: 'checkbox' });
    input.checked = checked;
    input.addEventListener('change', () => {
      act(input.checked);
      this.anew();
    });
    return { label: make('label', {}, input, ` ${text}`), input };
  }
}

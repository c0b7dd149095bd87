// SPDX-License-Identifier: MIT
// The moment in words: which groups wait and why, which are pushed, which run and for which requester, and the values of the states.

import { type Cursor, seconds } from './cursor';
import { make, withPlace } from './elements';
import type { Because, Source } from './recording';
import type { Standing } from './standing';
import { waitWords, words } from './standing_words';

const link = (kind: string, name: string): HTMLElement => make('a', { href: `#${kind}-${name}` }, name);

export class Moment {
  readonly element = make('div', { id: 'moment', tabindex: '0', role: 'region', 'aria-label': 'The moment' });
  private asked = 0; // counts calls of show(): an answer that comes after the next call is not shown

  constructor(private readonly source: Source, private readonly cursor: Cursor, private readonly order: number[]) {}

  show(): void {
    ++this.asked;
    const { recording } = this.source;
    const event = this.cursor.settled;
    const standings = this.order.map((group) => ({ group, standing: recording.standingAt(group, event) }));
    const of = (mark: Standing['mark']) => standings.filter((each) => each.standing.mark === mark);
    const parts: Node[] = [make('h3', {}, `At ${seconds(this.cursor.time)}`)];
    const add = (title: string, items: Node[]): void => {
      if (items.length > 0) parts.push(make('h4', {}, title), make('ul', {}, ...items));
    };
    add('Waits', of('queued').map((each) => this.wait(each.group, each.standing, event)));
    add('Pushed', of('pushed').map((each) => this.line(each.group, each.standing, 'pushed')));
    add('Runs', of('running').map((each) => this.line(each.group, each.standing, 'running')));
    add('Held', of('held').map((each) => this.line(each.group, each.standing, 'held')));
    add('Not known, as events are missing', of('unknown').map((each) => make('li', {}, link('group', this.name(each.group)))));
    if (parts.length === 1) parts.push(make('p', {}, 'Nothing runs.'));
    add('States', recording.names.header.states.map((state, i) => make('li', {}, link('state', state.name), ` ${this.value(i, event)}`)));
    add('Not requested', of('inactive').map((each) => this.idle(each.group)));
    this.put(parts);
  }

  /** Replaces only the parts that changed, and keeps the keyboard focus: for a running program this is called many times a second. */
  private put(parts: Node[]): void {
    const old = [...this.element.children];
    const focus = this.element.contains(document.activeElement) ? document.activeElement?.getAttribute('href') : undefined;
    for (const part of parts) {
      const same = old.shift();
      if (same === undefined) this.element.append(part);
      else if (!same.isEqualNode(part)) same.replaceWith(part);
    }
    for (const each of old) each.remove();
    if (focus && !this.element.contains(document.activeElement)) this.element.querySelector<HTMLElement>(`a[href="${focus}"]`)?.focus({ preventScroll: true });
  }

  private name(group: number): string {
    return this.source.recording.names.header.groups[group].name;
  }

  private value(state: number, event: number): string {
    const value = this.source.recording.valueAt(state, event);
    return value === undefined ? 'is not known' : value === null ? 'is unset' : `== ${value}`;
  }

  private line(group: number, standing: Standing, mark: string): HTMLElement {
    const { condition } = standing.push ?? {};
    const { names } = this.source.recording;
    const text = words(names, group, standing);
    const others = standing.waits.map((wait) => `; queued for ${names.requesterText(wait.edge)}: ${waitWords(wait, names)}`);
    return make('li', { class: mark }, link('group', this.name(group)), text === '' ? '' : `: ${text}`, mark === 'pushed' && condition ? `, to cause ${condition}` : '', ...others);
  }

  private idle(group: number): HTMLElement {
    const { names } = this.source.recording;
    const by = names.edgesTo[group].filter((edge) => names.header.edges[edge].levels.length > 0).map((edge) => names.requesterText(edge));
    return make('li', {}, link('group', this.name(group)), by.length === 0 ? '' : `: ${by.join(', ')} may request it`);
  }

  private wait(group: number, standing: Standing, event: number): HTMLElement {
    const out = make('li', { class: 'queued' }, link('group', this.name(group)));
    const asked = this.asked;
    const known = this.source.why(group, event);
    if (known instanceof Promise) {
      out.append(` ${words(this.source.recording.names, group, standing)}`);
      void known.then((because) => asked === this.asked && out.replaceChildren(link('group', this.name(group)), ...this.answer(group, standing, event, because)));
    } else {
      out.append(...this.answer(group, standing, event, known));
    }
    return out;
  }

  /** The text of `directorc why`: the answer, and a line for each of its notes; a shorter text if there is no answer. */
  private answer(group: number, standing: Standing, event: number, because: Because | undefined): Node[] {
    const { names } = this.source.recording;
    if (because === undefined) {
      const reason = this.source.whyUnknown(event);
      return [make('span', {}, ` ${words(names, group, standing)}`), ...(reason === undefined ? [] : [make('p', { class: 'hint' }, `Not more is known: ${reason}.`)])];
    }
    const [first, ...notes] = because.text.split('\n').filter((line) => line !== '');
    const short = first.startsWith(`${this.name(group)} `) ? first.slice(this.name(group).length) : ` ${first}`;
    return [make('span', {}, short), make('ul', { class: 'notes' }, ...notes.map((note) => make('li', {}, ...withPlace(note.trim()))))];
  }
}

// SPDX-License-Identifier: MIT
// The bar above the picture of a running behaviour: it shows whether the page shows the present, and with one click why a group runs or does not.

import type { Data } from './data';
import { button, byId, make } from './elements';

interface Reason {
  text: string;
  notes: string[];
}

type State = 'connecting' | 'connected' | 'behind' | 'silent' | 'lost' | 'over';

const words: Record<State, string> = {
  connecting: 'Connecting',
  connected: 'Connected',
  behind: 'Behind',
  silent: 'Silent',
  lost: 'Lost',
  over: 'Over',
};
const behindFor = 4000; // milliseconds for which the bar mentions missing events

const clock = (): string => new Date().toLocaleTimeString('en-GB');

export class LiveBar {
  private readonly sign = make('strong', {}, words.connecting);
  private readonly about = make('span', {}, ' to the program');
  private readonly status = make('p', { class: 'live-state', role: 'status', 'data-state': 'connecting' }, this.sign, this.about);
  private readonly warning = make('p', { hidden: '' });
  private readonly choice = make('select', { id: 'why-group' });
  private readonly answer = make('div', { id: 'why-answer', role: 'status', tabindex: '0', 'aria-label': 'Answer' }, make('p', { class: 'hint' }, 'Click a box in the picture, or choose a group here: the program says why it runs, or what it waits for.'));
  private state: State = 'connecting';
  private behindUntil = 0;
  private isIdle = false; // the program takes no steps
  private isPast = false; // the page shows an earlier moment
  private asked = 0;

  constructor(data: Data, private readonly reasonOf: (group: string) => Promise<Reason>) {
    for (const { name } of data.groups) this.choice.append(make('option', { value: name }, name));
    this.choice.addEventListener('change', () => void this.why(this.choice.value));
    const box = make(
      'section', { id: 'live', 'aria-label': 'The running program' }, this.status, this.warning,
      make('p', { class: 'live-why' }, make('label', { for: 'why-group' }, 'Why does it run, or not: '), this.choice, ' ', button('Ask', () => void this.why(this.choice.value))),
      this.answer,
    );
    byId('picture')?.before(box);
  }

  connected(): void {
    this.isIdle = false;
    this.show('connected', this.isPast ? ': what is shown is the past; “Follow the end” leads back to the present' : ': this is what happens now');
  }

  /** Says whether the page shows an earlier moment. */
  looksBack(isPast: boolean): void {
    if (this.isPast === isPast) return;
    this.isPast = isPast;
    if (this.state === 'connected' && !this.isIdle) this.connected();
  }

  /** Messages are coming: ends the state `silent`, and `behind` after its time. `steps`: the program has also taken steps lately. */
  heard(steps: boolean): void {
    if (this.state === 'silent' || (this.state === 'behind' && performance.now() > this.behindUntil)) this.connected();
    if (this.state !== 'connected' || this.isIdle === !steps) return;
    this.connected();
    this.isIdle = !steps;
    if (this.isIdle) this.show('connected', `, but at ${clock()} the program had taken no step for some seconds: what is shown is from its last one`);
  }

  silent(): void {
    if (this.state === 'connected' || this.state === 'behind') this.show('silent', ` since ${clock()}: the connection is there, and nothing comes; the program may be stopped`);
  }

  missed(count: number): void {
    this.behindUntil = performance.now() + behindFor;
    this.show('behind', `: ${count.toLocaleString('en')} events came faster than they could be shown, and are missing; from here on it is the present again`);
  }

  lost(forGood: boolean): void {
    if (forGood) this.show('over', ` since ${clock()}: the program has ended, or has begun anew at another address; what is shown is its past`);
    else if (this.state !== 'lost') this.show('lost', ` since ${clock()}: the program has ended, or cannot be reached; it is tried again`);
  }

  warn(text: string): void {
    this.warning.textContent = text;
    this.warning.hidden = false;
  }

  /** Asks the program why the group runs or does not, and shows the answer. */
  async why(group: string): Promise<void> {
    const mine = ++this.asked;
    this.choice.value = group;
    let parts: Node[];
    try {
      const { text, notes } = await this.reasonOf(group);
      parts = [make('p', {}, make('strong', {}, text), make('span', { class: 'hint' }, ` (asked at ${clock()})`)), make('ul', {}, ...notes.map((note) => make('li', {}, note)))];
      if (notes.length === 0) parts.pop();
    } catch (error) {
      const why = error instanceof TypeError ? 'the program cannot be reached' : error instanceof Error ? error.message.trim() : String(error); // of fetch, in words of the browser
      parts = [make('p', {}, `Not answered: ${why}`)];
    }
    if (mine !== this.asked) return;
    this.answer.replaceChildren(...parts);
    this.answer.scrollIntoView({ block: 'nearest' }); // it may be outside the viewport of a user who clicked a box
  }

  private show(state: State, about: string): void {
    this.state = state;
    this.status.dataset.state = state;
    this.sign.textContent = words[state];
    this.about.textContent = about;
  }
}

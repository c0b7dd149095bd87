// SPDX-License-Identifier: MIT
// Searches groups and states by name and documentation, and focuses one group in the pictures.

import type { Data } from './data';
import { button, byId, goTo, make } from './elements';
import { namesIn, type Picture } from './picture';

const most = 12;

/** Types of inputs into which no text is typed. */
const textless = ['radio', 'checkbox', 'range', 'button'];

export class Finder {
  private readonly input = make('input', { type: 'search', id: 'search', autocomplete: 'off', spellcheck: 'false', 'aria-controls': 'found' });
  private readonly list = make('ul', { id: 'found', 'aria-label': 'Found' });
  private readonly status = make('p', { id: 'status', role: 'status' });
  private readonly focused = make('span', { id: 'focused', role: 'status' }); // the words of the current focus; empty: there is none
  private readonly clear = button('Show everything', () => this.focus(undefined), { hidden: '' });

  /** `chosen`: called for a click on a group in a picture; undefined: the click focuses the group. */
  constructor(private readonly data: Data, private readonly pictures: Picture[], chosen?: (group: string) => void) {
    const box = byId('finder');
    if (!box) return;
    box.append(make('label', { for: 'search' }, 'Search groups and states'), this.input, this.status, this.list);
    box.hidden = false;
    this.input.addEventListener('input', () => this.search());
    this.input.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') this.list.querySelector('button')?.click();
      if (event.key === 'Escape' && this.input.value === '') this.focus(undefined);
      else if (event.key === 'Escape') this.reset();
    });
    document.addEventListener('keydown', (event) => {
      const typing = event.target instanceof HTMLTextAreaElement || (event.target instanceof HTMLInputElement && !textless.includes(event.target.type));
      if (event.key === '/' && !typing && !event.ctrlKey && !event.metaKey) {
        event.preventDefault();
        this.input.focus();
      }
      if (event.key === 'Escape' && !typing) this.focus(undefined);
    });
    for (const article of document.querySelectorAll<HTMLElement>('article.group')) {
      const group = article.dataset.group ?? '';
      article.querySelector('h3')?.after(button('Focus in the picture', () => this.focus(group), { class: 'focus', 'aria-label': `Focus on ${group} in the picture` }));
    }
    for (const picture of pictures) {
      for (const [title, node] of picture.nodes) {
        const names = namesIn(title).filter((name) => this.isGroup(name));
        if (names.length === 0) continue;
        node.classList.add('choosable');
        node.addEventListener('click', (event) => {
          const isLink = event.target instanceof Element && event.target.closest('a[*|href]') !== null;
          if (isLink && (!chosen || event.ctrlKey || event.metaKey || event.shiftKey)) return;
          if (isLink) event.preventDefault();
          const text = event.target instanceof Element ? (event.target.closest('text') ?? event.target).textContent?.trim() : undefined;
          const name = names.find((each) => text === each || text?.endsWith(` ${each}`)) ?? names[0]; // `▶ LeftArm`
          if (chosen) chosen(name);
          else this.focus(name);
        });
      }
    }
  }

  focus(group: string | undefined): void {
    if (group !== undefined && !this.pictures.some((picture) => picture.has(group) && !picture.hidden)) {
      this.pictures.find((picture) => picture.has(group))?.reveal();
    }
    const shown = this.pictures.find((picture) => !picture.hidden);
    shown?.tools.append(this.clear, this.focused); // beside the picture, to which the page is scrolled
    this.clear.hidden = group === undefined;
    for (const { tools } of this.pictures) tools.style.minHeight = '';
    const words = group === undefined ? '' : `Focus on ${group}: what leads to it, what it requests, needs and pushes, what pushes it, and what needs the same.`;
    this.focused.textContent = words;
    for (const picture of this.pictures) picture.focus(group);
    if (group === undefined) return;
    for (let i = 0; shown && i < 4; ++i) { // more words above the frame may make it lower: then it is centred again, and others may be outside
      const all = shown.outside.length > 0 ? `${words} Outside of the frame: ${shown.outside.join(', ')}.` : words;
      if (this.focused.textContent === all) break;
      this.focused.textContent = all;
      shown.tools.style.minHeight = `${shown.tools.getBoundingClientRect().height}px`; // fewer words do not make it higher again: this would not end
      shown.focus(group);
    }
    byId('picture')?.scrollIntoView({ block: 'start' });
  }

  private isGroup(name: string): boolean {
    return this.data.groups.some((group) => group.name === name);
  }

  private reset(): void {
    this.input.value = '';
    this.search();
  }

  private search(): void {
    const wanted = this.input.value.trim().toLowerCase();
    const hits = wanted === '' ? [] : this.find(wanted, this.input.value.trim());
    this.list.replaceChildren(...hits.slice(0, most).map((hit) => make('li', {}, button(hit.label, () => this.open(hit)))));
    this.status.textContent = wanted === '' ? '' : `${hits.length} found${hits.length > most ? `, the first ${most} of them` : ''}`;
    const names = new Set(hits.map((hit) => hit.group).filter((name): name is string => name !== undefined));
    for (const picture of this.pictures) picture.mark(names);
  }

  /** `typed`: the same in the letters that were typed. The whole name comes first, then the same in other letters. */
  private find(wanted: string, typed: string): { label: string; id: string; group?: string }[] {
    const rank = (name: string): number => {
      const small = name.toLowerCase();
      return name === typed ? -2 : small === wanted ? -1 : small.startsWith(wanted) ? 0 : small.includes(wanted) ? 1 : 2;
    };
    const all = [
      ...this.data.groups.map((each) => ({ each, label: each.name, id: `group-${each.name}`, group: each.name as string | undefined })),
      ...this.data.states.map((each) => ({ each, label: `state ${each.name}`, id: `state-${each.name}`, group: undefined })),
    ];
    return all
      .filter(({ each }) => rank(each.name) < 2 || (each.doc ?? '').toLowerCase().includes(wanted))
      .sort((a, b) => rank(a.each.name) - rank(b.each.name));
  }

  private open(hit: { id: string; group?: string }): void {
    if (hit.group !== undefined) this.focus(hit.group);
    goTo(hit.id);
  }
}

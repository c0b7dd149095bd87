// SPDX-License-Identifier: MIT
// The transition matrix: arrow keys move the focus from cell to cell, and a click shows the explanation of a cell, with its scenario.

import type { Data } from './data';
import { button, byId, make } from './elements';

export class Matrix {
  private readonly panel = byId('cell');
  private readonly links: HTMLAnchorElement[][] = [];
  private readonly places = new Map<Element, [number, number]>();

  constructor(private readonly data: Data) {
    const table = document.querySelector('.matrix table');
    if (!table || !this.panel || !data.transitions) return;
    table.querySelectorAll('tbody tr').forEach((row) => this.links.push([...row.querySelectorAll<HTMLAnchorElement>('td a')]));
    this.links.forEach((row, i) =>
      row.forEach((link, j) => {
        link.tabIndex = i === 0 && j === 0 ? 0 : -1;
        this.places.set(link, [i, j]);
      }),
    );
    setTimeout(() => this.name());
    this.panel.setAttribute('role', 'status');
    table.addEventListener('click', (event) => this.click(event));
    table.addEventListener('keydown', (event) => this.key(event as KeyboardEvent));
  }

  private get rows() {
    return this.data.transitions?.rows ?? [];
  }

  /** Labels the cells for screen readers; done after the page is painted. */
  private name(): void {
    for (const [link, [i, j]] of this.places) {
      link.setAttribute('aria-label', `${this.rows[i].cells[j].kind}: from ${this.rows[i].group} to ${this.rows[j].group}`);
    }
  }

  private placeOf(element: Element): [number, number] | undefined {
    const link = element.closest('a');
    return link === null ? undefined : this.places.get(link);
  }

  private click(event: Event): void {
    const place = this.placeOf(event.target as Element);
    if (!place) return;
    event.preventDefault();
    this.go(...place);
    this.explain(...place);
  }

  private key(event: KeyboardEvent): void {
    const place = this.placeOf(event.target as Element);
    if (!place) return;
    const moves: Record<string, [number, number]> = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] };
    const move = moves[event.key];
    if (!move) return;
    event.preventDefault();
    const last = this.links.length - 1;
    const within = (value: number): number => Math.min(last, Math.max(0, value));
    this.go(within(place[0] + move[0]), within(place[1] + move[1]));
  }

  private go(i: number, j: number): void {
    for (const row of this.links) for (const link of row) link.tabIndex = -1;
    const link = this.links[i][j];
    const [frame, corner] = [link.closest<HTMLElement>('.matrix'), link.closest('table')?.tHead?.rows[0].cells[0]];
    if (frame && corner) frame.style.scrollPadding = `${corner.offsetHeight}px 0 0 ${corner.offsetWidth}px`; // else names would hide the cell
    link.tabIndex = 0;
    link.focus();
  }

  private explain(i: number, j: number): void {
    const panel = this.panel;
    if (!panel || !this.data.transitions) return;
    for (const cell of document.querySelectorAll('.matrix td[aria-current]')) cell.removeAttribute('aria-current');
    this.links[i][j].parentElement?.setAttribute('aria-current', 'true');
    const [row, column, cell] = [this.rows[i], this.rows[j], this.rows[i].cells[j]];
    const parts: Node[] = [make('h3', {}, `From ${row.group} to ${column.group}: ${cell.kind}`), make('p', {}, cell.words)];
    if (cell.kind === 'unreachable') {
      for (const one of [row, column]) if (!one.reached) parts.push(make('p', {}, `${one.group}: ${one.words}`));
    } else {
      parts.push(make('p', {}, `${row.group}: ${row.words}`));
    }
    if (cell.scenario) {
      const text = cell.scenario.map((piece) => this.data.transitions?.pieces[piece] ?? '').join('');
      const pre = make('pre', { tabindex: '0', 'aria-label': 'Scenario' }, text);
      const copy = button('Copy the scenario', () => void this.copy(text, pre, copy));
      parts.push(pre, copy, make('p', { class: 'hint' }, 'Saved beside the behaviour, `directorc simulate --decisions FILE` plays it; `directorc test --update FILE` keeps it as a test.'));
    }
    parts.push(button('Close', () => { panel.hidden = true; this.go(i, j); }));
    panel.replaceChildren(...parts);
    panel.hidden = false;
    this.reveal(this.links[i][j], panel);
  }

  /** Scrolls the explanation, which is below the matrix, into the viewport as far as the names of the columns remain visible. */
  private reveal(link: HTMLElement, panel: HTMLElement): void {
    link.scrollIntoView({ block: 'nearest', inline: 'nearest' }); // the matrix is lower while there is an explanation
    const missing = panel.getBoundingClientRect().bottom - innerHeight;
    const head = link.closest('table')?.tHead?.rows[0].cells[0] ?? link; // it stays at the top of the matrix
    const covered = parseFloat(getComputedStyle(document.documentElement).scrollPaddingTop);
    scrollBy(0, Math.min(Math.max(0, missing), head.getBoundingClientRect().top - covered));
  }

  /** Copies the text; without permission to use the clipboard, the text is selected. */
  private async copy(text: string, shown: HTMLElement, copied: HTMLButtonElement): Promise<void> {
    try {
      await navigator.clipboard.writeText(text);
      copied.textContent = 'Copied';
    } catch {
      const range = document.createRange();
      range.selectNodeContents(shown);
      const selection = getSelection();
      selection?.removeAllRanges();
      selection?.addRange(range);
      copied.textContent = 'Selected: copy it with the keyboard';
    }
  }
}

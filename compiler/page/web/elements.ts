// SPDX-License-Identifier: MIT
// Functions that make and find elements of the page.

type Attributes = Record<string, string>;

export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const out = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) out.setAttribute(name, value);
  out.append(...children);
  return out;
}

export function button(label: string, act: () => void, attributes: Attributes = {}): HTMLButtonElement {
  const out = make('button', { type: 'button', ...attributes }, label);
  out.addEventListener('click', act);
  return out;
}

/** With what has a meaning of its own in addresses as `%20`, like the compiler. */
function inAddress(path: string): string {
  return encodeURIComponent(path).replace(/[!'()*]/g, (letter) => `%${letter.charCodeAt(0).toString(16).toUpperCase()}`).split('%2F').join('/');
}

/** Makes a place at the end of a text, `(robot.yaml:12)`, a link, if the page has links to places. */
export function withPlace(text: string): (Node | string)[] {
  const pattern = document.body.dataset.link;
  const found = /^(.* \()([^()]+):(\d+)\)$/.exec(text);
  if (!pattern || !found) return [text];
  const [, before, file, line] = found;
  const href = pattern.split('{line}').join(line).split('{file}').join(inAddress(file));
  return [before, make('a', { href }, `${file}:${line}`), ')'];
}

export function byId(id: string): HTMLElement | null {
  return document.getElementById(id);
}

/** Scrolls to an element, in each frame until it stays there: sections above it have their real height only when they were near the viewport. */
export function scrollToElement(target: Element): void {
  let [frames, calm, last] = [0, 0, NaN];
  const look = (): void => {
    const { top } = target.getBoundingClientRect();
    calm = top === last ? calm + 1 : 0;
    if (calm > 1 || ++frames > 60) return;
    target.scrollIntoView();
    last = target.getBoundingClientRect().top;
    requestAnimationFrame(look);
  };
  look();
}

/** Makes links within the page, and an address with a fragment, end where they lead to. */
export function settleLinks(): void {
  const settle = (): void => void requestAnimationFrame(() => {
    const target = document.querySelector(':target');
    if (target) scrollToElement(target);
  });
  document.addEventListener('click', (event) => {
    if (!event.defaultPrevented && event.target instanceof Element && event.target.closest('a[href^="#"]')) settle();
  });
  const [way] = performance.getEntriesByType('navigation') as PerformanceNavigationTiming[];
  if (way?.type === 'navigate') addEventListener('load', settle); // otherwise the browser scrolls to where the user was
}

/** Opens the details around an element, scrolls to it and moves the keyboard focus there; false: there is none with this id. */
export function goTo(id: string): boolean {
  const target = byId(id);
  if (!target) return false;
  for (let up = target.parentElement; up; up = up.parentElement) if (up instanceof HTMLDetailsElement) up.open = true;
  scrollToElement(target);
  target.focus({ preventScroll: true });
  return true;
}

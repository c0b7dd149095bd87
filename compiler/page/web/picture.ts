// SPDX-License-Identifier: MIT
// A picture that can be moved and zoomed, and that can grey out everything not related to one group. Its layout is that of Graphviz.

import { select } from 'd3-selection';
import { zoom, zoomIdentity } from 'd3-zoom';
import { button, make } from './elements';
import { takeLegend } from './legend';
import { addPieces } from './pieces';

const inFront = 'near';

/** Pixels per point: at this scale its text has the size that was given to Graphviz. */
const onPaper = 4 / 3;

/** The smallest scale at which names can be recognized. A picture too wide for it first shows its roots; a flat one is larger, to fill its frame. */
const least = 0.4;
const flat = { scale: 0.8, height: 256 }; // its largest scale; pixels, the least height of a frame in page.css (16rem)

/** The smallest scale at which names can be read well. */
const readable = 0.6;

/** The two ends in the title of an arrow, `Walk.halting → Wheels`: each is a box, or a row of a box after a dot. */
function endsOf(title: string): [string, string] | undefined {
  const ends = title.split(' → ');
  return ends.length === 2 ? [ends[0], ends[1]] : undefined;
}

/** The groups of a box, from its title. */
export const namesIn = (title: string): string[] => title.split(', ');

const groupOf = (end: string): string => end.split('.')[0];

const isWithin = (inner: DOMRect, outer: DOMRect): boolean => inner.left >= outer.left && inner.right <= outer.right && inner.top >= outer.top && inner.bottom <= outer.bottom;

export class Picture {
  readonly nodes = new Map<string, SVGGElement>();
  readonly svg: SVGSVGElement;
  readonly tools: HTMLElement;
  readonly legend: HTMLElement | undefined; // below the frame
  readonly arrows: { from: string; to: string; element: SVGGElement }[] = []; // and their labels; the ends are as in endsOf()
  private readonly boxes = new Map<string, SVGGElement>(); // by group; several groups may share a box, `LeftArm, RightArm`
  private readonly motion = zoom<SVGSVGElement, unknown>();
  readonly notes = new Map<Element, Element>(); // by box: what stands beside it (picture_marks.ts)
  private pending?: () => void; // centres what was focused while this picture was hidden
  reveal: () => void = () => undefined; // shows this picture instead of the others

  constructor(readonly frame: HTMLElement) {
    this.svg = frame.querySelector('svg') as SVGSVGElement;
    const layer = this.svg.querySelector('g.graph') as SVGGElement;
    for (const node of layer.querySelectorAll<SVGGElement>('g.node')) {
      const title = node.querySelector('title')?.textContent ?? '';
      this.nodes.set(title, node);
      for (const name of [title, ...namesIn(title)]) this.boxes.set(name, node);
    }
    for (const element of layer.querySelectorAll<SVGGElement>('g.edge, g.label')) {
      const ends = endsOf(element.querySelector('title')?.textContent ?? '');
      if (ends) this.arrows.push({ from: ends[0], to: ends[1], element });
    }
    this.legend = takeLegend(this.svg, layer);
    if (this.legend) frame.after(this.legend);
    addPieces(this.svg, layer, frame);
    this.makeMovable(layer);
    this.tools = this.makeTools();
    frame.before(this.tools);
  }

  get name(): string {
    return this.frame.dataset.picture ?? '';
  }

  get hidden(): boolean {
    return this.frame.clientWidth === 0;
  }

  has(group: string): boolean {
    return this.boxes.has(group);
  }

  /**
   * Greys out everything but the group, those that lead to it, what it requests, needs, pushes or is pushed by, and those that need the same; nothing if
   * it is undefined or not in the picture.
   */
  focus(group?: string): void {
    const own = group === undefined ? undefined : this.boxes.get(group);
    const lines = this.arrows.map(({ from, to, element }) => ({ element, from: this.boxes.get(groupOf(from)), to: this.boxes.get(groupOf(to)), isPush: this.isPush(element), isNeed: this.isNeed(element) }));
    const beside = new Set<SVGGElement>(); // what an arrow connects with it
    const near = new Set<SVGGElement>();
    const add = (all: Set<SVGGElement>, wanted: (line: (typeof lines)[number]) => boolean, end: 'from' | 'to'): void => {
      for (const line of lines) if (line[end] && wanted(line)) all.add(line[end]);
    };
    if (own) {
      beside.add(own);
      add(beside, ({ from }) => from === own, 'to');
      add(beside, ({ to }) => to === own, 'from');
      for (const each of beside) near.add(each);
      const above = new Set([own]), held = new Set([own]);
      for (const each of above) add(above, ({ to, isPush }) => to === each && !isPush, 'from'); // a set grows while it is gone through
      for (const each of held) add(held, ({ from, isNeed }) => from === each && isNeed, 'to');
      for (const each of [...above, ...held]) near.add(each);
      held.delete(own);
      add(near, ({ to, isNeed }) => to !== undefined && held.has(to) && isNeed, 'from');
    }
    for (const { element, from, to } of lines) element.classList.toggle(inFront, from !== undefined && to !== undefined && near.has(from) && near.has(to));
    for (const node of this.nodes.values()) {
      node.classList.toggle(inFront, near.has(node));
      node.classList.toggle('chosen', node === own);
    }
    this.svg.classList.toggle('focused', own !== undefined);
    this.pending = own && (() => this.centre([...near], [...beside], own, group ?? ''));
    this.settle();
  }

  /** The boxes in front that are not completely in the frame, without the focused one. */
  get outside(): string[] {
    const frame = this.frame.getBoundingClientRect();
    return this.hidden ? [] : [...this.nodes].filter(([, node]) => node.classList.contains(inFront) && !node.classList.contains('chosen') && !isWithin(node.getBoundingClientRect(), frame)).map(([title]) => title);
  }

  /** Pushes have a colour of their own: palette::push in compiler/emit/graph. */
  isPush(arrow: Element): boolean {
    return arrow.querySelector('[stroke="#00704f"], text[fill="#00704f"]') !== null;
  }

  /** Needs are blue, also beside a request: palette::need in compiler/emit/graph. */
  private isNeed(arrow: Element): boolean {
    return arrow.querySelector('[stroke="#00629b"]') !== null;
  }

  /** Called when it becomes visible: a hidden picture has no size by which something could be centred. */
  settle(): void {
    if (this.hidden) return;
    this.pending?.();
    this.pending = undefined;
  }

  mark(names: Set<string>): void {
    const rowsAreGroups = this.name !== 'All groups'; // of a module, or of a layer
    for (const [title, node] of this.nodes) {
      const rows = rowsAreGroups ? [...node.querySelectorAll('text')].map((text) => text.textContent ?? '') : [];
      node.classList.toggle('found', [...namesIn(title), ...rows].some((name) => names.has(name)));
    }
  }

  private makeMovable(layer: SVGGElement): void {
    const at = layer.getAttribute('transform') ?? '';
    const moved = document.createElementNS('http://www.w3.org/2000/svg', 'g');
    layer.before(moved);
    moved.append(layer);
    layer.setAttribute('transform', at);
    this.svg.setAttribute('preserveAspectRatio', 'xMidYMin meet');
    this.motion
      .scaleExtent([0.2, 12])
      .filter((event: Event) => (event instanceof WheelEvent ? event.ctrlKey || event.metaKey : !('touches' in event) || (event.touches as TouchList).length > 1))
      .on('zoom', (event: { transform: { toString(): string } }) => moved.setAttribute('transform', event.transform.toString()));
    select(this.svg).call(this.motion).on('dblclick.zoom', null);
    // Otherwise two fingers would also scroll the page.
    this.svg.addEventListener('touchstart', (event) => event.touches.length > 1 && event.cancelable && event.preventDefault(), { passive: false });
    this.frame.classList.add('moves');
    this.frame.addEventListener('keydown', (event) => this.key(event));
    // Boxes have one link each; the text below has the links of rows and arrows too.
    for (const link of this.svg.querySelectorAll('a a, .edge a, .label a')) link.setAttribute('tabindex', '-1');
    this.frame.addEventListener('focusin', (event) => event.target instanceof SVGElement && event.target.matches(':focus-visible') && this.bringIn(event.target));
  }

  private key(event: KeyboardEvent): void {
    const step = 60;
    const moves: Record<string, [number, number]> = {
      ArrowLeft: [step, 0], ArrowRight: [-step, 0], ArrowUp: [0, step], ArrowDown: [0, -step],
    };
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (moves[event.key]) select(this.svg).call(this.motion.translateBy, ...moves[event.key]);
    else if (event.key === '+' || event.key === '=') this.scale(1.3);
    else if (event.key === '-') this.scale(1 / 1.3);
    else if (event.key === '0') this.whole();
    else return;
    event.preventDefault();
  }

  private scale(by: number): void {
    select(this.svg).call(this.motion.scaleBy, by);
  }

  /** Shows all of the picture. */
  whole(): void {
    select(this.svg).call(this.motion.transform, zoomIdentity);
  }

  /** Sets the first scale: as on paper if that fits, otherwise the frame's width if readable; from the top, in a frame no higher than needed. */
  show(): void {
    const view = this.svg.viewBox.baseVal;
    const fits = this.frame.clientWidth / view.width;
    const wanted = fits < readable ? Math.max(fits, least, Math.min(flat.scale, flat.height / view.height)) : Math.min(onPaper, fits);
    this.frame.style.setProperty('--needed', `${Math.ceil(wanted * view.height) + 2}px`);
    const unit = this.svg.getScreenCTM()?.a ?? 0;
    if (unit === 0) return;
    const scale = unit > onPaper ? onPaper / unit : Math.max(1, wanted / unit);
    this.motion.scaleExtent([0.2, Math.max(12, (3 * onPaper) / unit)]);
    const [seen, drawn] = [this.frame.clientWidth / unit, scale * view.width];
    const most = Math.max(0, (drawn - seen) / 2); // the largest shift from the middle
    const aside = Math.max(-most, Math.min(most, scale * (view.width / 2 - this.roots(view.width / 2, seen / scale))));
    select(this.svg).call(this.motion.transform, zoomIdentity.translate((view.width - drawn) / 2 + aside, 0).scale(scale));
  }

  /**
   * The middle of the groups that the program requests, which have the sign ▼: of all, or if they are further apart than `room`, of most that fit;
   * `otherwise`: if there are none.
   */
  private roots(otherwise: number, room: number): number {
    const all = [...this.nodes.values()].filter((node) => node.querySelector('text')?.textContent?.startsWith('▼')).map((node) => node.getBBox());
    const fitting = all.map(({ x: left }) => all.filter(({ x, width }) => x >= left && x + width <= left + room));
    const most = fitting.reduce((best, each) => (each.length > best.length ? each : best), []);
    if (most.length === 0) return all.length === 0 ? otherwise : all[0].x + all[0].width / 2;
    return (Math.min(...most.map(({ x }) => x)) + Math.max(...most.map(({ x, width }) => x + width))) / 2;
  }

  /** Moves an element to the middle of the frame if a part of it is outside, and the frame into the viewport. */
  private bringIn(element: Element): void {
    const [box, frame] = [element, this.frame].map((each) => each.getBoundingClientRect());
    const scale = this.svg.querySelector('g')?.getScreenCTM()?.a;
    const middle = (rect: DOMRect): [number, number] => [rect.left + rect.width / 2, rect.top + rect.height / 2];
    if (scale && !isWithin(box, frame)) {
      const [[x, y], [toX, toY]] = [middle(box), middle(frame)];
      select(this.svg).call(this.motion.translateBy, (toX - x) / scale, (toY - y) / scale);
    }
    element.scrollIntoView({ block: 'nearest' });
  }

  /**
   * Centres all that is near if that is readable, otherwise what is beside the group if names can be recognized, otherwise the group alone, or if its box
   * is larger than the frame, its name.
   */
  private centre(near: Element[], beside: Element[], own: Element, group: string): void {
    this.whole();
    const matrix = this.svg.getScreenCTM();
    if (!matrix || matrix.a === 0) return;
    const around = (nodes: Element[]): DOMRect => {
      const boxes = nodes.flatMap((each) => [each, this.notes.get(each) ?? []].flat()).map((each) => each.getBoundingClientRect());
      const [left, top] = [Math.min(...boxes.map((box) => box.left)), Math.min(...boxes.map((box) => box.top))];
      return new DOMRect(left, top, Math.max(...boxes.map((box) => box.right)) - left, Math.max(...boxes.map((box) => box.bottom)) - top);
    };
    const scaleFor = (box: DOMRect): number => 0.95 * matrix.a * Math.min(this.frame.clientWidth / box.width, this.frame.clientHeight / box.height);
    let box = around(near);
    let scale = scaleFor(box);
    if (scale < readable) scale = scaleFor((box = around(beside)));
    if (scale < least) scale = Math.max(readable, scaleFor((box = around([own]))));
    const larger = Math.max(1, Math.min(onPaper, scale) / matrix.a);
    const name = [...own.querySelectorAll('text')].find((text) => text.textContent === group) ?? own;
    const frame = this.frame.getBoundingClientRect();
    const drawn = { width: larger * box.width, height: larger * box.height };
    if (drawn.width > frame.width || drawn.height > frame.height) {
      const only = around([name]);
      box = new DOMRect(drawn.width > frame.width ? only.left : box.left, drawn.height > frame.height ? only.top : box.top, drawn.width > frame.width ? only.width : box.width, drawn.height > frame.height ? only.height : box.height);
    }
    const middle = (rect: DOMRect): DOMPoint => new DOMPoint(rect.left + rect.width / 2, rect.top + rect.height / 2).matrixTransform(matrix.inverse());
    const [at, to] = [middle(box), middle(frame)]; // the picture stands at the top of its frame, so the middle of its viewBox is elsewhere
    this.scale(larger);
    select(this.svg).call(this.motion.translateTo, at.x, at.y, [to.x, to.y]);
  }

  private makeTools(): HTMLElement {
    const after = this.frame.closest('section')?.nextElementSibling;
    return make(
      'div',
      { class: 'tools', role: 'group', 'aria-label': `Zoom of ${this.name}` },
      button('Larger', () => this.scale(1.3)),
      button('Smaller', () => this.scale(1 / 1.3)),
      button('Whole', () => this.whole()),
      make('span', { class: 'hint' }, 'Drag to move; Ctrl and the wheel, or + and −, to zoom; arrow keys move; on a touch screen two fingers'),
      ...(after && this.svg.querySelector('a') ? [make('a', { class: 'skip', href: `#${after.id}` }, 'To what comes after the picture')] : []),
    );
  }
}

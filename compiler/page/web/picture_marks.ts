// SPDX-License-Identifier: MIT
// Marks the moment in the pictures: frames as `directorc graph --step` draws them, a sign before the active provider, a bar at the head of an arrow that
// waits, and beside a box a note why its group waits, or for which task it is pushed. The frame of a box of several groups is that of the one whose
// mark is last in `order`, and its note has a line for each that waits or is pushed.

import type { Data } from './data';
import { type Names, nobody } from './names';
import { type Place, placeOf, type Rect, type Surroundings } from './note_place';
import type { Picture } from './picture';
import type { Because, Recording } from './recording';
import type { Mark, Standing } from './standing';
import { words } from './standing_words';

const order: Mark[] = ['inactive', 'unknown', 'held', 'queued', 'running', 'pushed']; // as rank() in compiler/emit/graph/picture/picture.cpp: what runs, in a box with something that waits
const space = 'http://www.w3.org/2000/svg';
const sign = '▶ ';
const roots = 'thick frame'; // compiler/emit/graph/legend.cpp
const [usual, small] = [12, 7]; // sizes of the sign
const beside = 3; // least distance between a name and its frame
const mostTold = 5; // groups in a note
const readable = 10; // pixels: the font size that notes should have on the screen

/** How a text is changed so that it fits its frame. */
interface Fit {
  smallSign: boolean;
  left: string; // by how much it begins further left; empty: not at all
  length: string; // its `textLength`; empty: its own
}

/** About one group of a box. */
interface Said {
  mark: Mark;
  words: string;
}

interface Box {
  node: SVGGElement;
  groups: number[];
  heads: Map<number, SVGTextElement>; // the texts with the names of groups, in a box without rows
  rows: Map<string, SVGTextElement>;
  fits: Map<string, Fit>; // by mark and text: a cache of fitOf()
  isFolded: boolean; // of a module or a layer: its names have the colours of what their groups do
  mark: Mark | '';
  said: Said[]; // in its note; empty: it has none
  note: SVGGElement | undefined;
  shown: string;
}

/** The new content of a box. */
interface Change {
  box: Box;
  mark: Mark | '';
  texts: [SVGTextElement, string][];
  heads: [SVGTextElement, Mark | ''][];
  said: Said[];
}

interface Arrow {
  element: SVGGElement;
  from: number[];
  provider: string | undefined; // the active provider that requests or needs by this arrow; undefined: any
  levels: Map<number, Set<number>> | undefined; // by edge: those at which the pack requests from which this arrow leaves; undefined: it is of any pack
  to: number[];
  isPush: boolean; // else it is a request or need
  pushedTo: string | undefined; // a push to this provider; undefined: to any
  bar: SVGElement | undefined;
  shown: string;
}

export class PictureMarks {
  private readonly boxes: Box[] = [];
  private readonly arrows: Arrow[] = [];
  private readonly frames: Element | undefined; // the words in the legend for the frames of what the program requests
  private readonly names: Names;
  private readonly pen = document.createElement('canvas').getContext('2d');
  private layout: Surroundings | undefined; // without notes: a cache, as nothing in the picture moves

  /** `why`: why a group waits after an event; undefined: not known. */
  constructor(private readonly picture: Picture, private readonly recording: Recording, data: Data, private readonly why: (group: number, event: number) => Because | undefined) {
    this.names = recording.names;
    this.frames = [...(picture.legend?.querySelectorAll('dt') ?? [])].find((sign) => sign.textContent === roots);
    const parts = new Map<string, number[]>(); // groups of modules and layers, by title of the box; bands have such titles too, but no frame
    for (const { name, module, layer } of data.groups) {
      const group = this.names.group(name);
      if (group === nobody) continue; // the page is of another version of the behaviour
      for (const part of [`module ${module}`, `layer ${layer}`]) parts.set(part, [...(parts.get(part) ?? []), group]);
    }
    const groupsOf = (title: string): number[] => {
      const groups = title.split(', ').map((name) => this.names.group(name));
      return groups.every((group) => group !== nobody) ? groups : (parts.get(title) ?? []);
    };
    for (const [title, node] of picture.nodes) {
      const groups = groupsOf(title);
      if (groups.length > 0 && node.querySelector('path')) this.boxes.push(this.box(node, groups, parts.has(title)));
    }
    for (const { from, to, element } of picture.arrows) {
      const [asker, row, part] = from.split('.');
      const [asked, pushedTo] = to.split('.');
      const groups = groupsOf(asker);
      const provider = groups.length === 1 && this.names.provider(groups[0], row) !== nobody ? row : undefined;
      const pack = provider === undefined ? row : part;
      const levels = groups.length === 1 && pack !== undefined ? this.levelsOf(groups[0], provider, pack) : undefined;
      this.arrows.push({ element, from: groups, provider, levels, to: groupsOf(asked), isPush: picture.isPush(element), pushedTo, bar: undefined, shown: '' });
    }
  }

  /** Whether the picture has a layout: without one its boxes have no size. */
  get isVisible(): boolean {
    return this.picture.svg.getClientRects().length > 0;
  }

  /** `event`: undefined: removes all marks. `onlyNow`: inactive parts are almost transparent. */
  show(event: number | undefined, onlyNow = false): void {
    this.picture.svg.classList.toggle('moment', event !== undefined);
    this.picture.svg.classList.toggle('only-now', onlyNow);
    if (this.frames) this.frames.textContent = event === undefined ? roots : '▼ program'; // thick frames are of what runs
    this.apply(this.boxes.flatMap((box) => this.changeOf(box, event) ?? []));
    for (const arrow of this.arrows) this.showArrow(arrow, event);
  }

  private box(node: SVGGElement, groups: number[], isFolded: boolean): Box {
    const all = [...node.querySelectorAll('text')];
    const texts = all.filter((text) => text.getAttribute('font-size') === '12.00');
    const rows = new Map<string, SVGTextElement>();
    const { providers } = this.names.header.groups[groups[0]];
    if (groups.length === 1) for (const text of texts) if (providers.includes(text.textContent ?? '')) rows.set(text.textContent ?? '', text);
    const heads = new Map<number, SVGTextElement>();
    for (const group of rows.size > 0 ? [] : groups) {
      const text = all.find((each) => each.textContent === this.names.header.groups[group].name); // smaller in boxes of modules and layers
      if (text) heads.set(group, text);
    }
    return { node, groups, heads, rows, fits: new Map(), isFolded, mark: '', said: [], note: undefined, shown: '' };
  }

  /** Undefined: not known, as the trace is of an earlier program. A provider without a row is the only one of its group. */
  private levelsOf(group: number, provider: string | undefined, pack: string): Arrow['levels'] {
    const out = new Map<number, Set<number>>();
    for (const use of this.names.header.level_uses ?? []) {
      const edge = this.names.edge(use.edge);
      if (this.names.requesters[edge] !== group || use.pack_name !== pack || (provider !== undefined && use.provider !== provider)) continue;
      out.set(edge, (out.get(edge) ?? new Set()).add(use.level));
    }
    return out.size > 0 ? out : undefined;
  }

  private changeOf(box: Box, event: number | undefined): Change | undefined {
    const standings = event === undefined ? [] : box.groups.map((group) => ({ group, standing: this.recording.standingAt(group, event) }));
    const most = standings.reduce<{ group: number; standing: Standing } | undefined>((a, b) => (a && order.indexOf(a.standing.mark) >= order.indexOf(b.standing.mark) ? a : b), undefined);
    const mark = most?.standing.mark ?? '';
    const said = standings.flatMap(({ group, standing }): Said[] => {
      if (standing.mark !== 'queued' && standing.mark !== 'pushed') return [];
      const because = standing.mark === 'queued' && event !== undefined ? this.why(group, event) : undefined;
      const about = box.groups.length > 1 ? `${this.names.header.groups[group].name}: ` : '';
      return [{ mark: standing.mark, words: about + words(this.names, group, standing, because) }];
    });
    const told = said.length > mostTold ? [...said.slice(0, mostTold - 1), { mark: said[mostTold - 1].mark, words: `and ${said.length - mostTold + 1} more` }] : said;
    const provider = most && most.standing.provider !== nobody ? this.names.header.groups[most.group].providers[most.standing.provider] : '';
    const running = new Set(standings.filter(({ standing }) => standing.mark === 'running' || standing.mark === 'pushed').map(({ group }) => group));
    const shown = `${mark} ${provider} ${said.map((each) => each.words).join()} ${standings.map(({ standing }) => standing.mark).join()}`;
    if (box.shown === shown) return undefined;
    box.shown = shown;
    const rows = [...box.rows].map(([name, text]): [SVGTextElement, string] => [text, (name === provider ? sign : '') + name]);
    const heads = [...box.heads].map(([group, text]): [SVGTextElement, string] => [text, (running.has(group) ? sign : '') + this.names.header.groups[group].name]);
    const marked = [...(box.isFolded ? box.heads : [])].map(([group, text]): [SVGTextElement, Mark | ''] => [text, standings.find((each) => each.group === group)?.standing.mark ?? '']);
    return { box, mark, texts: [...rows, ...heads], heads: marked, said: told };
  }

  /** Writes all texts, then measures all, then fits all: if these alternated, each measurement would cause a new layout of the whole picture. */
  private apply(changes: Change[]): void {
    for (const { box, mark, texts, heads } of changes) {
      const put = (element: Element, its: Mark | ''): void => order.forEach((each) => element.classList.toggle(`is-${each}`, each === its));
      put(box.node, mark);
      for (const [text, its] of heads) put(text, its);
      for (const [text, words] of texts) {
        text.textContent = words;
        text.removeAttribute('textLength');
        text.removeAttribute('dx');
      }
    }
    const fitted = changes.flatMap(({ box, mark, texts }) => texts.map(([text, words]): [SVGTextElement, Fit] => [text, this.fitOf(box, text, words, mark)]));
    for (const [text, { smallSign, left, length }] of fitted) {
      if (smallSign) writeSmallSign(text);
      if (left !== '') text.setAttribute('dx', `-${left}`);
      if (length === '') continue;
      text.setAttribute('textLength', length);
      text.setAttribute('lengthAdjust', 'spacingAndGlyphs');
    }
    for (const { box, mark, said } of changes) Object.assign(box, { mark, said });
    if (changes.length > 0) this.putNotes();
  }

  /** Frames have no place for the sign and bold letters: a text goes to the left; if that is not enough its sign, and then all of it, becomes narrower. */
  private fitOf(box: Box, text: SVGTextElement, words: string, mark: Mark | ''): Fit {
    const asDrawn = { smallSign: false, left: '', length: '' };
    if (mark === '') return asDrawn; // by Graphviz
    const key = `${mark} ${words}`;
    const known = box.fits.get(key);
    if (known) return known;
    const own = text.closest('g.node > a > g, g.node > g')?.querySelector('path'); // of one group of several in the box, in whose middle its name is
    const frame = (own ?? box.node.querySelector('path'))?.getBBox();
    const written = text.getBBox();
    if (!frame || frame.width === 0) return asDrawn; // it has no layout
    const [first, end] = [frame.x + beside, frame.x + frame.width - beside];
    const smallSign = words.startsWith(sign) && written.width > end - first;
    const width = written.width - (smallSign ? text.getSubStringLength(0, sign.length) * (1 - small / usual) : 0);
    const x = Math.max(first, own ? frame.x + (frame.width - width) / 2 : Math.min(written.x, end - width));
    const out = { smallSign, left: written.x - x > 0.1 ? (written.x - x).toFixed(1) : '', length: width > end - x ? (end - x).toFixed(1) : '' };
    box.fits.set(key, out);
    return out;
  }

  /** Places all notes anew: where one can stand depends on the others. Their letters are larger if the scale is small. */
  private putNotes(): void {
    for (const box of this.boxes) box.note?.remove();
    this.picture.notes.clear();
    const noted = this.boxes.filter(({ said }) => said.length > 0);
    if (noted.length === 0) return;
    const { paper, boxes, labels } = this.surroundings();
    const taken = [...boxes];
    const size = Math.min(16, Math.max(9, readable / (this.picture.svg.getScreenCTM()?.a ?? 1)));
    const places = noted.map(({ node, said }) => {
      const place = placeOf(said.map((each) => each.words), size, rectOf(node), { paper, boxes: taken, labels }, (text) => this.measure(text));
      taken.push(place);
      return place;
    });
    noted.forEach((box, i) => {
      box.note = drawNote(box, places[i]);
      this.picture.notes.set(box.node, box.note);
    });
  }

  private surroundings(): Surroundings {
    if (this.layout) return this.layout;
    const whole = this.picture.svg.querySelector<SVGGraphicsElement>('g.graph > polygon')?.getBBox();
    const { width, height } = this.picture.svg.viewBox.baseVal; // without the legend, unlike the polygon
    const labels = this.arrows.filter(({ element }) => element.matches('.label')).map(({ element }) => rectOf(element));
    const out = { paper: { x: whole?.x ?? 0, y: whole?.y ?? 0, width: whole?.width ?? width, height }, boxes: [...this.picture.nodes.values()].map(rectOf), labels };
    if (this.isVisible) this.layout = out;
    return out;
  }

  /** The width of a text in a note whose letters have size 1. */
  private measure(text: string): number {
    const size = 20;
    if (!this.pen) return 0.6 * text.length;
    this.pen.font = `bold ${size}px system-ui, sans-serif`; // as in page.css
    return this.pen.measureText(text).width / size;
  }

  private showArrow(arrow: Arrow, event: number | undefined): void {
    const mark = event === undefined ? '' : arrow.isPush ? this.pushMark(arrow, event) : this.markOf(arrow, event);
    if (arrow.shown === mark) return;
    arrow.shown = mark;
    for (const each of order) arrow.element.classList.toggle(`is-${each}`, each === mark);
    arrow.bar?.remove();
    arrow.bar = mark === 'queued' ? drawBar(arrow.element) : undefined;
  }

  private markOf(arrow: Arrow, event: number): Mark {
    let out: Mark = 'inactive';
    const put = (mark: Mark): void => {
      if (order.indexOf(mark) > order.indexOf(out)) out = mark;
    };
    for (const from of arrow.from) {
      const asks = this.recording.standingAt(from, event);
      const isOnlyHeld = asks.provider === nobody; // for one of its providers, which does not run
      if (arrow.provider !== undefined && !isOnlyHeld && this.names.header.groups[from].providers[asks.provider] !== arrow.provider) continue;
      for (const to of arrow.to) {
        const asked = this.recording.standingAt(to, event);
        const isTheirs = (edge: number): boolean => this.names.requesters[edge] === from && (isOnlyHeld || this.isOfPack(arrow, edge, event));
        if (isTheirs(asked.holder)) put(asked.mark === 'running' || asked.mark === 'pushed' ? 'running' : asked.waits.some((wait) => wait.edge === asked.holder) ? 'queued' : 'held');
        else if (asked.waits.some((wait) => isTheirs(wait.edge))) put('queued');
      }
    }
    return out;
  }

  /** Of two packs that request at the same level, both may be the one that requests. */
  private isOfPack({ levels }: Arrow, edge: number, event: number): boolean {
    const level = levels && this.recording.levelAt(edge, event);
    return level === undefined || (level !== null && (levels?.get(edge)?.has(level) ?? false));
  }

  private pushMark(arrow: Arrow, event: number): Mark {
    for (const to of arrow.to) {
      const { mark, push } = this.recording.standingAt(to, event);
      const isTo = (provider: number): boolean => arrow.pushedTo === undefined || this.names.header.groups[to].providers[provider] === arrow.pushedTo;
      if (mark === 'pushed' && push && arrow.from.includes(this.names.targets[push.edge]) && isTo(push.provider)) return 'pushed';
    }
    return 'inactive';
  }
}

function rectOf(element: SVGGraphicsElement): Rect {
  const { x, y, width, height } = element.getBBox();
  return { x, y, width, height };
}

function add(to: Element, name: string, attributes: Record<string, string | number>, text = ''): SVGElement {
  const out = document.createElementNS(space, name);
  for (const [key, value] of Object.entries(attributes)) out.setAttribute(key, String(value));
  out.textContent = text;
  to.append(out);
  return out;
}

/** Makes the sign before a name smaller. */
function writeSmallSign(text: SVGTextElement): void {
  const name = (text.textContent ?? '').slice(sign.length);
  text.textContent = '';
  add(text, 'tspan', { 'font-size': small }, sign);
  text.append(name);
}

function drawNote({ node, said }: Box, { x, y, width, height, lines, size }: Place): SVGGElement {
  const out = document.createElementNS(space, 'g');
  out.setAttribute('class', `note is-${said.some(({ mark }) => mark === 'queued') ? 'queued' : 'pushed'}`);
  add(out, 'rect', { x, y, width, height, rx: 3 });
  lines.forEach(({ text, of }, i) => add(out, 'text', { class: `is-${said[of].mark}`, x: x + 4, y: y + size + 1 + i * size * 1.2, 'font-size': size }, i + 1 < lines.length ? `${text} ` : text));
  node.parentNode?.append(out);
  return out;
}

/** Draws a bar across an arrow before its head, as Graphviz does where a request is queued (compiler/emit/graph/dot.cpp). A label has none. */
function drawBar(arrow: SVGGElement): SVGElement | undefined {
  const path = arrow.querySelector<SVGPathElement>('path[fill="none"]');
  const head = arrow.querySelector<SVGGraphicsElement>('polygon, ellipse')?.getBBox();
  const length = path?.getTotalLength() ?? 0;
  if (!path || !head || length === 0) return undefined;
  const middle = { x: head.x + head.width / 2, y: head.y + head.height / 2 };
  const distance = (point: DOMPoint): number => Math.hypot(point.x - middle.x, point.y - middle.y);
  const isForward = distance(path.getPointAtLength(length)) <= distance(path.getPointAtLength(0));
  const at = (fromHead: number): DOMPoint => path.getPointAtLength(isForward ? Math.max(0, length - fromHead) : Math.min(length, fromHead));
  const [place, before] = [at(3), at(5)];
  const step = Math.hypot(place.x - before.x, place.y - before.y) || 1;
  const half = 5;
  const across = { x: (-half * (place.y - before.y)) / step, y: (half * (place.x - before.x)) / step };
  return add(arrow, 'line', { class: 'bar', x1: place.x - across.x, y1: place.y - across.y, x2: place.x + across.x, y2: place.y + across.y });
}

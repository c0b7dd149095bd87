// SPDX-License-Identifier: MIT
// The timeline below the picture, for a recording that is complete or that grows: the user scrubs, steps, plays and filters. The picture, and the text
// beside it, show the moment.

import { Cursor, seconds } from './cursor';
import type { Data } from './data';
import { button, byId, make } from './elements';
import { EventList } from './event_list';
import { Filter } from './filter';
import { type Look, lookOf } from './look';
import { Moment } from './moment';
import { Overview } from './overview';
import type { Picture } from './picture';
import { PictureMarks } from './picture_marks';
import { Player } from './player';
import type { Because, Source } from './recording';
import { words } from './standing_words';
import { rulerHeight, Tracks } from './tracks';
import { View } from './view';

/** The groups by layer, the first layer first, and within a layer as declared; those in no layer are last. */
function orderOf(source: Source, data: Data): number[] {
  const layers = data.layers ?? [];
  const place = new Map(data.groups.map((group, i) => [group.name, (group.layer === undefined ? layers.length : layers.indexOf(group.layer)) * data.groups.length + i]));
  const { groups } = source.recording.names.header;
  return groups.map((_, i) => i).sort((a, b) => (place.get(groups[a].name) ?? 0) - (place.get(groups[b].name) ?? 0));
}

/** What fits on A4 and Letter, in both directions. */
const rowsOnPaper = 30;
const widthOnPaper = 600; // pixels
const scaleOnPaper = 3;

const highestCanvas = 32_767; // pixels: some browsers show nothing of a higher one

export class Timeline {
  private readonly cursor: Cursor;
  private readonly view: View;
  private readonly tracks: Tracks;
  private readonly filter: Filter;
  private readonly player: Player;
  private readonly moment: Moment;
  private readonly list: EventList;
  private readonly overview: Overview;
  private readonly marks: PictureMarks[];
  private readonly canvas = make('canvas', { class: 'slices', 'aria-hidden': 'true' });
  private readonly ruler = make('canvas', { class: 'ruler', 'aria-hidden': 'true' }); // remains visible when the tracks are scrolled
  private readonly line = make('div', { class: 'cursor' });
  private readonly tip = make('div', { class: 'tip', hidden: '' });
  private readonly labels = make('div', { class: 'labels' });
  private readonly area = make('div', { class: 'area', id: 'scrub', tabindex: '0', role: 'slider', 'aria-label': 'Time' }, this.ruler, this.canvas, this.line, this.tip);
  private readonly printed = make('div', { class: 'printed', 'aria-hidden': 'true' });
  private readonly where = make('output', { class: 'where' });
  private readonly inPicture = make('input', { type: 'checkbox', id: 'in-picture', checked: '' });
  private readonly onlyNow = make('input', { type: 'checkbox', id: 'only-now' });
  private readonly at = make('input', { type: 'number', id: 'at', step: 'any' });
  private readonly follow = make('input', { type: 'checkbox', id: 'follow', checked: '' });
  private look: Look;
  private width = 0;
  private isGone = false; // the moment that the user looked at is not kept any more, and the oldest one is shown instead
  private drawn = false; // whether the tracks are drawn since the last change
  private waiting = false; // whether a frame is requested

  constructor(private readonly source: Source, pictures: Picture[], data: Data) {
    const { recording } = source;
    const order = orderOf(source, data);
    this.cursor = new Cursor(recording);
    this.view = new View(recording);
    this.tracks = new Tracks(recording, this.view, (group, event) => this.why(group, event));
    this.filter = new Filter(recording, order, () => this.change());
    this.player = new Player(recording, this.cursor, () => (this.follow.checked = this.isGone = false));
    this.moment = new Moment(source, this.cursor, order);
    this.list = new EventList(recording, this.cursor, this.filter, () => this.leaveEnd());
    this.overview = new Overview(recording, this.view, this.cursor, () => this.leaveEnd(), () => this.change());
    this.marks = pictures.map((picture) => new PictureMarks(picture, recording, data, (group, event) => this.why(group, event)));
    this.put();
    this.look = lookOf(this.area);
    this.cursor.onMove(() => this.moved());
    recording.onGrowth(() => this.grown());
    for (const picture of pictures) {
      picture.legend?.removeAttribute('open'); // here the frame needs its space
      picture.whole();
    }
    this.listen();
    this.change();
  }

  private put(): void {
    const section = byId('timeline');
    const picture = byId('picture');
    if (!section || !picture) return;
    const bench = make('div', { class: 'bench' });
    picture.before(bench);
    bench.append(picture, section);
    const zoom = make(
      'span', { class: 'row', role: 'group', 'aria-label': 'Zoom of the timeline' },
      button('Closer', () => this.zoom(0.5)), button('Wider', () => this.zoom(2)), button('All of it', () => this.whole()),
    );
    const bar = make(
      'div', { class: 'bar' },
      button('Previous event', () => this.step(-1)), button('Next event', () => this.step(1)), this.player.element, make('label', {}, 'Go to ', this.at, ' s'), zoom,
      make('label', {}, this.inPicture, ' Moment in the picture'), make('label', {}, this.onlyNow, ' Only what runs or waits then'),
    );
    if (this.source.grows) bar.append(make('label', {}, this.follow, ' Follow the end'));
    const legend = make('p', { class: 'looks' }, ...['running', 'pushed', 'queued', 'held', 'inactive'].map((mark) => make('span', {}, make('i', { class: mark }), ` ${mark}`)), make('span', { class: 'push-sign' }, '▲ push'), make('span', { class: 'hand-over-sign' }, '◆ hand-over'), make('span', { class: 'fault-sign' }, '✖ fault or loss'), 'Lines of the picture: thick blue: has it; dashed red, with a bar: waits for it; pale: not requested.');
    const hint = make('p', { class: 'hint' }, 'Click or drag to a moment. With the keyboard: ← and → to the events beside it, Page keys further, Home, End, space plays, + and − zoom, as does Ctrl with the wheel.');
    const lanes = make('div', { class: 'lanes' }, this.labels, this.area);
    section.append(bar, this.where, this.overview.element, lanes, this.printed, legend, make('div', { class: 'beside' }, this.moment.element, this.list.element), hint);
    bar.append(this.filter.element);
    byId('no-timeline')?.remove();
  }

  private listen(): void {
    this.inPicture.addEventListener('change', () => this.moved());
    this.onlyNow.addEventListener('change', () => this.change());
    byId('picture')?.addEventListener('change', () => this.moved()); // another picture was chosen
    this.at.addEventListener('change', () => this.goTo(this.at.value));
    this.follow.addEventListener('change', () => this.grown());
    this.area.addEventListener('keydown', (event) => this.key(event));
    this.area.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    this.area.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      this.area.setPointerCapture(event.pointerId);
      this.scrub(event);
    });
    this.area.addEventListener('pointermove', (event) => (event.buttons & 1 ? this.scrub(event) : this.hover(event)));
    this.area.addEventListener('pointerleave', () => (this.tip.hidden = true));
    new ResizeObserver(() => this.change()).observe(this.area);
    addEventListener('beforeprint', () => this.toPaper());
    addEventListener('afterprint', () => this.toScreen());
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
      this.look = lookOf(this.area);
      this.change();
    });
  }

  // Input of the user.

  private step(by: 1 | -1): void {
    this.leaveEnd();
    const next = this.filter.from(this.cursor.event, by);
    if (next !== undefined) this.cursor.goToEvent(next);
  }

  private scrub(event: PointerEvent): void {
    this.leaveEnd();
    this.tip.hidden = true;
    this.cursor.goToTime(this.view.timeAt(event.clientX - this.area.getBoundingClientRect().left, this.width));
  }

  /** Goes to this time, in seconds; a text that is no number is ignored. */
  private goTo(text: string): void {
    if (text === '' || !Number.isFinite(Number(text))) return;
    this.leaveEnd();
    this.cursor.goToTime(Math.round(Number(text) * 1e6));
  }

  private leaveEnd(): void {
    this.follow.checked = this.isGone = false;
    this.player.stop();
  }

  private zoom(factor: number, around = this.cursor.time): void {
    this.view.zoom(factor, around);
    this.change();
  }

  private whole(): void {
    this.view.whole();
    this.change();
  }

  private wheel(event: WheelEvent): void {
    const sideways = event.shiftKey ? event.deltaY : event.deltaX;
    if (event.ctrlKey || event.metaKey) this.zoom(1.0015 ** event.deltaY, this.view.timeAt(event.clientX - this.area.getBoundingClientRect().left, this.width));
    else if (sideways !== 0) this.view.pan(sideways / this.width);
    else return;
    event.preventDefault();
    this.change();
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const far = this.view.length / 10;
    const { recording } = this.source;
    const go = (time: number) => (): void => {
      this.leaveEnd();
      this.cursor.goToTime(time);
    };
    const acts: Record<string, () => void> = {
      ArrowLeft: () => this.step(-1), ArrowDown: () => this.step(-1), ArrowRight: () => this.step(1), ArrowUp: () => this.step(1),
      PageUp: go(this.cursor.time + far), PageDown: go(this.cursor.time - far), Home: go(recording.begins), End: go(recording.ends),
      '+': () => this.zoom(0.5), '=': () => this.zoom(0.5), '-': () => this.zoom(2), '0': () => this.whole(), ' ': () => this.player.flip(),
    };
    if (!acts[event.key]) return;
    event.preventDefault();
    acts[event.key]();
  }

  /** Why the group waits; undefined: not known, or the source answers later. */
  private why(group: number, event: number): Because | undefined {
    const known = this.source.why(group, event);
    return known instanceof Promise ? undefined : known;
  }

  private hover(event: PointerEvent): void {
    const box = this.area.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const hit = this.tracks.hit(x, y, this.width);
    this.tip.hidden = hit === undefined;
    if (!hit) return;
    const { recording } = this.source;
    const time = hit.from < hit.to ? `${seconds(hit.from)} to ${seconds(hit.to)}` : `from ${seconds(hit.from)} on`;
    if (hit.row.group !== undefined) {
      const standing = recording.standingAt(hit.row.group, hit.event);
      const text = words(recording.names, hit.row.group, standing, standing.mark === 'queued' ? this.why(hit.row.group, hit.event) : undefined);
      this.tip.textContent = `${recording.names.header.groups[hit.row.group].name}: ${text === '' ? standing.mark : text.startsWith(standing.mark) ? text : `${standing.mark}, ${text}`}\n${time}`;
    } else if (hit.row.state !== undefined) {
      const value = recording.valueAt(hit.row.state, hit.event);
      this.tip.textContent = `${recording.names.header.states[hit.row.state].name}: ${value === undefined ? 'not known' : (value ?? 'unset')}\n${time}`;
    }
    this.tip.style.left = `${Math.min(x + 12, this.width - 240)}px`;
    this.tip.style.top = `${y + 14}px`;
  }

  // Display.

  /** Whether the moment is the end of a recording that grows. */
  get follows(): boolean {
    return this.follow.checked;
  }

  private grown(): void {
    if (this.follow.checked && this.source.grows) {
      this.cursor.goToTime(this.source.recording.ends);
      this.view.toEnd();
      this.isGone = false;
    } else if (this.cursor.event < this.source.recording.first && this.source.recording.first > 0) {
      this.cursor.goToTime(this.source.recording.begins);
      this.isGone = true;
    }
    this.change();
  }

  private moved(): void {
    if (this.view.reveal(this.cursor.time) || this.onlyNow.checked) this.drawn = false;
    this.plan();
  }

  private change(): void {
    this.drawn = false;
    this.plan();
  }

  /** Shows all changes together in the next frame. */
  private plan(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.show();
    });
  }

  private show(): void {
    if (!this.drawn) this.draw();
    this.drawn = true;
    const { recording } = this.source;
    const { time, event, settled } = this.cursor;
    this.line.style.transform = `translateX(${this.view.xOf(time, this.width)}px)`;
    const text = event < recording.first ? 'nothing has happened' : recording.shapeAt(event).text;
    const number = (each: number): string => (each + 1).toLocaleString('en');
    this.where.textContent = `${seconds(time)}, after event ${number(event)} of ${recording.end.toLocaleString('en')}: ${text}${settled > event ? `, and what was decided with it, up to event ${number(settled)}` : ''}${this.isGone ? '; the moment before, which was shown, is not kept any more' : ''}`;
    for (const [name, value] of Object.entries({ valuemin: recording.begins / 1e6, valuemax: recording.ends / 1e6, valuenow: time / 1e6, valuetext: `${seconds(time)}, ${text}` })) {
      this.area.setAttribute(`aria-${name}`, String(value));
    }
    this.moment.show();
    this.list.show();
    this.overview.showCursor();
    for (const marks of this.marks) if (marks.isVisible) marks.show(this.inPicture.checked ? settled : undefined, this.onlyNow.checked);
  }

  private draw(): void {
    const { names } = this.source.recording;
    this.tracks.rows = [...this.filter.groups(this.onlyNow.checked ? this.cursor.settled : undefined).map((group) => ({ group })), ...names.header.states.map((_, state) => ({ state }))];
    // Without room a name is shortened before its end: names that begin alike differ there.
    const label = (kind: string, name: string): HTMLElement => {
      const end = name.length - Math.min(10, Math.floor(name.length / 2));
      return make('a', { class: kind, href: `#${kind}-${name}`, title: name }, make('span', {}, name.slice(0, end)), make('span', { class: 'end' }, name.slice(end)));
    };
    this.labels.replaceChildren(
      ...this.tracks.rows.map((row) => (row.group !== undefined ? label('group', names.header.groups[row.group].name) : label('state', names.header.states[row.state ?? 0].name))),
    );
    this.width = Math.max(1, Math.floor(this.area.clientWidth));
    const scale = Math.min(devicePixelRatio, highestCanvas / this.tracks.height);
    this.canvas.width = this.width * scale;
    this.canvas.height = this.tracks.height * scale;
    this.canvas.style.height = this.line.style.height = `${this.tracks.height}px`;
    const context = this.canvas.getContext('2d');
    if (!context) return;
    context.scale(scale, scale);
    this.tracks.draw(context, this.width, this.look);
    this.copyRuler(scale);
    this.overview.draw(this.look);
  }

  /** For print: the tracks in blocks, each no higher than a page, with their names beside them, in the light colours. */
  private toPaper(): void {
    this.toScreen();
    if (!this.drawn) this.draw();
    document.documentElement.classList.add('paper');
    const look = lookOf(this.area);
    const { rows } = this.tracks;
    const names = [...this.labels.children];
    for (let from = 0; from < rows.length; from += rowsOnPaper) {
      this.tracks.rows = rows.slice(from, from + rowsOnPaper);
      const canvas = make('canvas', { class: 'slices' });
      canvas.width = widthOnPaper * scaleOnPaper;
      canvas.height = this.tracks.height * scaleOnPaper;
      const context = canvas.getContext('2d');
      context?.scale(scaleOnPaper, scaleOnPaper);
      if (context) this.tracks.draw(context, widthOnPaper, look);
      const labels = make('div', { class: 'labels' }, ...names.slice(from, from + rowsOnPaper).map((name) => name.cloneNode(true)));
      this.printed.append(make('div', { class: 'lanes' }, labels, make('div', { class: 'area' }, canvas)));
      canvas.style.height = `${this.tracks.height}px`;
    }
    this.tracks.rows = rows;
  }

  private toScreen(): void {
    document.documentElement.classList.remove('paper');
    this.printed.replaceChildren();
  }

  private copyRuler(scale: number): void {
    this.ruler.width = this.canvas.width;
    this.ruler.height = rulerHeight * scale;
    const context = this.ruler.getContext('2d');
    if (!context) return;
    context.fillStyle = this.look.paper;
    context.fillRect(0, 0, this.ruler.width, this.ruler.height);
    context.drawImage(this.canvas, 0, 0);
  }
}

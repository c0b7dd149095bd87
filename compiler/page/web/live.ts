// SPDX-License-Identifier: MIT
// The page of a running behaviour (runtime/live). It receives server-sent events whose data are lines of a trace, and fills a recording with them,
// which the timeline follows. It asks the program why groups wait; the program knows that only for the present. Only a page that a program sent does
// this: the program adds a tag with the address of the events (runtime/live/page.cpp).

import { Answers } from './answers';
import type { Data } from './data';
import { byId, make } from './elements';
import { LiveBar } from './live_bar';
import type { Header } from './names';
import type { Picture } from './picture';
import { type Because, type Held, lineOf, Recording, type Source } from './recording';
import { Timeline } from './timeline';

const most = 400_000; // the number of events above which the oldest are removed
const pause = 100; // milliseconds between two updates of the page, so that the user can read it
const askAgain = 1000; // milliseconds after which the reasons for waiting are requested again, although nothing has changed
const silence = 5000; // milliseconds without a message; an `alive` message comes each second

interface Reason {
  group: string;
  text: string;
  held?: Held;
  notes: string[];
}

export class Live implements Source {
  readonly grows = true;
  private record: Recording | undefined;
  private timeline: Timeline | undefined;
  private fingerprint = '';
  private readonly waiting: string[] = []; // data of messages that are not processed yet
  private time: number | undefined;
  private shown: number | undefined; // the engine's time in the last `alive` message
  private held = false; // a pointer is pressed: until it is released, the page does not change
  private heard = performance.now();
  private stepped = performance.now(); // a thread of its own sends `alive`, also while the thread that steps waits or hangs
  private answers: Answers | undefined; // of the recording
  private asking = false;
  private asked = 0;
  readonly bar: LiveBar;

  /** `address`: of the events, relative to the page. */
  constructor(address: string, private readonly data: Data, private readonly pictures: Picture[]) {
    this.bar = new LiveBar(data, (group) => this.reasonOf(group));
    const events = new EventSource(address);
    events.addEventListener('open', () => this.bar.connected());
    events.addEventListener('error', () => this.bar.lost(events.readyState === EventSource.CLOSED));
    events.addEventListener('message', (message: MessageEvent<string>) => {
      this.heard = this.stepped = performance.now();
      this.waiting.push(message.data);
    });
    events.addEventListener('standing', (message: MessageEvent<string>) => this.waiting.push(lineOf(message.data)));
    events.addEventListener('alive', (message: MessageEvent<string>) => {
      this.heard = performance.now();
      const time = Number(message.data);
      if (time === 0 || time !== this.shown) this.stepped = this.heard; // 0: the program shows no moment
      this.time = this.shown = time;
    });
    for (const kind of ['pointerdown', 'pointerup', 'pointercancel']) addEventListener(kind, () => (this.held = kind === 'pointerdown'), true);
    setInterval(() => this.look(), pause);
  }

  get recording(): Recording {
    if (!this.record) throw new Error('nothing has come yet');
    return this.record;
  }

  private look(): void {
    if (performance.now() - this.heard > silence) this.bar.silent();
    else this.bar.heard(performance.now() - this.stepped <= silence);
    this.bar.looksBack(this.timeline?.follows === false);
    if (this.held || (this.waiting.length === 0 && this.time === undefined)) return;
    const lines = this.waiting.splice(0).map((data) => this.withoutHeader(data)).join('\n');
    const { record, time } = this;
    this.time = undefined;
    if (!record) return;
    if (lines !== '') record.append(lines);
    if (time !== undefined) record.pass(time);
  }

  /** Removes the header of a trace. The first header creates the recording; a later one only says that the stream begins again. */
  private withoutHeader(data: string): string {
    const lines = data.split('\n');
    if (lines[0].startsWith('{"director_trace":')) this.takeHeader(lines);
    else this.noticeGap(lines[0]);
    return lines.join('\n');
  }

  private takeHeader(lines: string[]): void {
    const header = JSON.parse(lines.shift() ?? '') as Header;
    if (this.record) {
      if (header.fingerprint !== this.fingerprint) location.reload(); // another program at this address
      else this.noticeGap(lines[0]);
      return;
    }
    this.fingerprint = header.fingerprint;
    if ((document.body.dataset.fingerprint ?? header.fingerprint) !== header.fingerprint) {
      this.bar.warn('This page is of another version of the behaviour than the one that runs: its pictures and texts may be wrong. `directorc docs` writes the page of the other one.');
    }
    const initial = new Map(this.data.states.map((state) => [state.name, state.initial ?? null]));
    this.record = new Recording(header, initial, most);
    this.answers = new Answers(this.record);
    // Events before the connection are not missing if the current state follows: the recording begins with it. A program that shows none has none.
    if (lines[0]?.startsWith('{"event":"dropped"') && lines.length > 1) lines.shift();
    if (lines.length > 0) this.record.append(lines.splice(0).join('\n'));
    this.makeTimeline();
  }

  private noticeGap(line: string | undefined): void {
    if (line?.startsWith('{"event":"dropped"')) this.bar.missed((JSON.parse(line) as { count: number }).count);
  }

  private makeTimeline(): void {
    const section = make('section', { id: 'timeline', 'aria-labelledby': 'timeline-title' }, make('h2', { id: 'timeline-title' }, 'Now, and what led to it'));
    byId('picture')?.after(section);
    this.timeline = new Timeline(this, this.pictures, this.data);
    if (scrollY === 0 && location.hash === '') scrollTo({ top: byId('live')?.getBoundingClientRect().top }); // scrollIntoView would add the padding meant for this box
  }

  // Reasons for waiting.

  /** For the present the program is asked, again and again while the group waits; for the past there are only the answers that were given then. */
  why(group: number, event: number): Because | undefined {
    const known = this.answers?.at(group, event);
    const isNow = event === this.recording.end - 1;
    if (isNow && (!known || performance.now() - this.asked > askAgain)) void this.askAll();
    return known;
  }

  whyUnknown(event: number): string | undefined {
    return event === this.recording.end - 1 ? undefined : 'the program says why of the present only, and was not asked then';
  }

  private async askAll(): Promise<void> {
    if (this.asking || performance.now() - this.asked < 2 * pause) return;
    this.asking = true;
    this.asked = performance.now();
    const { recording } = this;
    try {
      const { t, groups } = await this.ask('why');
      for (const { group, text, notes, held } of groups) this.answers?.add(recording.names.group(group), t, { text: [text, ...notes].join('\n'), held });
      recording.pass(recording.ends);
    } catch {
      // The bar shows that the connection is lost.
    } finally {
      this.asking = false;
    }
  }

  private async ask(address: string): Promise<{ t: number; groups: Reason[] }> {
    const answer = await fetch(address);
    if (!answer.ok) throw new Error(await answer.text());
    return (await answer.json()) as { t: number; groups: Reason[] };
  }

  private async reasonOf(group: string): Promise<Reason> {
    return (await this.ask(`why?group=${encodeURIComponent(group)}`)).groups[0];
  }
}

/** The address of the events; undefined: the page is a file, and makes no requests. */
export function liveAddress(): string | undefined {
  return document.querySelector<HTMLMetaElement>('meta[name="director-live"]')?.content;
}

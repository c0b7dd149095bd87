// SPDX-License-Identifier: MIT
// Decodes the recording that `directorc trace --to=html` writes into a page. The encoder and the format: compiler/trace/recording.hpp.

import { counts, type Column } from './columns';
import type { Header } from './names';
import { type Because, type Held, Recording, type Source, type Value } from './recording';
import type { EventLine } from './shape';

interface Head {
  header: Header;
  shapes: EventLine[];
  texts: string[];
  held: (Held | null)[]; // of each text
  begins: number; // microseconds
  events: number;
  changes: number;
  why_until: number;
  why_ends?: string;
}

/** Reads numbers that have seven bits a byte, the lowest first, each byte but the last with its highest bit set. */
class Bytes {
  constructor(private readonly bytes: Uint8Array, private place: number) {}

  next(): number {
    let out = 0;
    for (let factor = 1; ; factor *= 128) {
      if (this.place >= this.bytes.length) throw new Error('the recording in this page ends too early');
      const byte = this.bytes[this.place++];
      out += (byte & 127) * factor;
      if (byte < 128) return out;
    }
  }
}

async function inflate(base64: string): Promise<Uint8Array> {
  const letters = atob(base64);
  const packed = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) packed[i] = letters.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

class Embedded implements Source {
  readonly grows = false;
  private readonly events: Column<Uint32Array>[]; // by group: from which events on its answer to why changes
  private readonly answers: Column<Uint32Array>[]; // ... and the answer: an index in the texts, plus 1; 0: it does not wait

  constructor(readonly recording: Recording, private readonly head: Head) {
    this.events = head.header.groups.map(counts);
    this.answers = head.header.groups.map(counts);
  }

  addChange(event: number, group: number, answer: number): void {
    this.events[group].push(event);
    this.answers[group].push(answer);
  }

  why(group: number, event: number): Because | undefined {
    const place = this.events[group].upTo(event) - 1;
    const answer = place < 0 || this.whyUnknown(event) !== undefined ? 0 : this.answers[group].at[place];
    return answer === 0 ? undefined : { text: this.head.texts[answer - 1], held: this.head.held[answer - 1] ?? undefined };
  }

  whyUnknown(event: number): string | undefined {
    return event < this.head.why_until ? undefined : this.head.why_ends;
  }
}

/** `initial`: the values of the states before the first event, if the trace has it. */
export async function decodeRecording(base64: string, initial: Map<string, Value>): Promise<Source> {
  const raw = await inflate(base64);
  const length = new DataView(raw.buffer, raw.byteOffset).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(raw.subarray(4, 4 + length))) as Head;
  const isWhole = head.events === 0 || head.shapes[0].event === 'begin'; // shapes are in the order in which they come first
  const recording = new Recording(head.header, isWhole ? initial : undefined);
  const shapes = head.shapes.map((line) => recording.addShape(line));
  const bytes = new Bytes(raw, 4 + length);
  const column = (count: number): number[] | Uint32Array => Uint32Array.from({ length: count }, () => bytes.next());
  recording.time.reserve(head.events);
  recording.shape.reserve(head.events);
  const steps = new Float64Array(head.events);
  for (let i = 0; i < head.events; ++i) steps[i] = bytes.next();
  const source = new Embedded(recording, head);
  let time = head.begins;
  for (let i = 0; i < head.events; ++i) recording.add((time += steps[i]), shapes[bytes.next()]);
  const [at, groups, answers] = [column(head.changes), column(head.changes), column(head.changes)];
  let event = 0;
  for (let i = 0; i < head.changes; ++i) source.addChange((event += at[i]), groups[i], answers[i]);
  return source;
}

// SPDX-License-Identifier: MIT
// What a page of `directorc docs` does beyond its text. Without it, all of the text is there.

import { choosePicture } from './collapse';
import { readData } from './data';
import { byId } from './elements';
import { decodeRecording } from './embedded';
import { Finder } from './finder';
import { Matrix } from './matrix';
import { Pair } from './pair';
import { Timeline } from './timeline';

const data = readData();
const section = byId('picture');
const pictures = section ? choosePicture(section) : [];
new Finder(data, pictures);
new Pair(data);
new Matrix(data);

const embedded = byId('recording');
if (embedded) {
  const initial = new Map(data.states.map((state) => [state.name, state.initial ?? null]));
  decodeRecording(embedded.textContent ?? '', initial).then(
    (source) => new Timeline(source, pictures, data),
    (error: unknown) => byId('no-timeline')?.prepend(`The timeline cannot be shown: ${error instanceof Error ? error.message : String(error)}. `),
  );
}

// SPDX-License-Identifier: MIT
// The entry point of the script of a page (`directorc docs`, `directorc trace --to=html`). Without scripts, the page still has its whole text.

import { choosePicture } from './collapse';
import { readData } from './data';
import { byId, settleLinks } from './elements';
import { decodeRecording } from './embedded';
import { Finder } from './finder';
import { Live, liveAddress } from './live';
import { Matrix } from './matrix';
import { Pair } from './pair';
import { Timeline } from './timeline';

const data = readData();
const section = byId('picture');
const pictures = section ? choosePicture(section) : [];
const address = liveAddress();
const live = address === undefined ? undefined : new Live(address, data, pictures);
new Finder(data, pictures, live && ((group) => void live.bar.why(group)));
new Pair(data);
new Matrix(data);
settleLinks();

const embedded = byId('recording');
if (embedded) {
  const initial = new Map(data.states.map((state) => [state.name, state.initial ?? null]));
  decodeRecording(embedded.textContent ?? '', initial).then(
    (source) => new Timeline(source, pictures, data),
    (error: unknown) => byId('no-timeline')?.prepend(`The timeline cannot be shown: ${error instanceof Error ? error.message : String(error)}. `),
  );
}

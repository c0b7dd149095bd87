// SPDX-License-Identifier: MIT
// For print: a picture that is too wide to be read on paper is printed once more in parts, one below the other, from left to right.

import { make } from './elements';

const space = 'http://www.w3.org/2000/svg';
const widest = 1340; // points: at the width of paper its names are then still larger than 4 points
const piece = 960; // points: likewise larger than 6
const shared = 120; // points that a part has in common with the one before, so that most boxes are whole in one of them

/** Below the frame of the picture it has the parts while the page is printed; none if it is not too wide. */
export function addPieces(svg: SVGSVGElement, layer: SVGGElement, frame: HTMLElement): void {
  const { width, height } = svg.viewBox.baseVal;
  if (width <= widest) return;
  const count = Math.ceil((width - shared) / (piece - shared));
  const each = (width - shared) / count + shared;
  const out = make('div', { class: 'pieces' });
  const part = (i: number): HTMLElement => {
    const drawn = document.createElementNS(space, 'svg');
    drawn.setAttribute('class', svg.getAttribute('class') ?? ''); // says whether a moment is shown
    drawn.setAttribute('viewBox', `${i * (each - shared)} 0 ${each} ${height}`);
    drawn.append(layer.cloneNode(true));
    return make('figure', {}, make('figcaption', {}, `Part ${i + 1} of ${count}, from left to right`), drawn);
  };
  frame.after(out);
  addEventListener('beforeprint', () => out.replaceChildren(...(frame.clientWidth > 0 ? Array.from({ length: count }, (_, i) => part(i)) : [])));
  addEventListener('afterprint', () => out.replaceChildren());
}

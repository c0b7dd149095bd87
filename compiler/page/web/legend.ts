// SPDX-License-Identifier: MIT
// The legend of a picture. Graphviz writes it below the picture, where it is too small to read, or out of sight, if the picture is large.

import { make } from './elements';

const space = 'http://www.w3.org/2000/svg';

/** Removes the legend and its space from the picture, and returns it as text with samples of the lines; undefined: there is none. */
export function takeLegend(svg: SVGSVGElement, layer: SVGGElement): HTMLElement | undefined {
  const yOf = (element: Element | undefined): number => Number(element?.getAttribute('y') ?? NaN);
  const parts = [...layer.children].filter((each) => each.matches('text, polyline'));
  const texts = parts.filter((each) => each.matches('text'));
  const top = yOf(texts[0]) + 12; // notes below the last boxes (picture_marks.ts) have space
  if (texts.length === 0) return undefined;
  const list = make('dl', { class: 'legend' });
  let sample: Element[] = []; // what stands before the words: lines, and a sign
  for (const part of parts) {
    part.remove();
    const next = texts[texts.indexOf(part) + 1];
    if (part.matches('polyline') || yOf(next) === yOf(part)) {
      sample.push(part);
    } else if (part !== texts[0]) { // which is the title
      list.append(make('div', {}, make('dt', {}, drawn(sample, yOf(part))), make('dd', {}, part.textContent ?? '')));
      sample = [];
    }
  }
  const { width, height } = svg.viewBox.baseVal;
  const left = Math.ceil(height - 4 + top); // the coordinates of the layer begin 4 points above the bottom
  svg.setAttribute('viewBox', `0 0 ${width} ${left}`);
  svg.setAttribute('height', `${left}pt`);
  if (list.childElementCount === 0) return undefined;
  list.append(make('div', { class: 'on-screen' }, make('dt', {}, 'outer frame'), make('dd', {}, 'the focus, or found by the search')));
  return make('details', { class: 'signs', open: '' }, make('summary', {}, 'What the signs mean'), list);
}

function drawn(sample: Element[], y: number): Node | string {
  if (sample.length === 1) return sample[0].textContent?.trim() ?? '';
  const out = document.createElementNS(space, 'svg');
  for (const [name, value] of Object.entries({ viewBox: `14 ${y - 10} 60 14`, width: '80', height: '19', 'aria-hidden': 'true' })) out.setAttribute(name, value);
  out.append(...sample);
  return out;
}

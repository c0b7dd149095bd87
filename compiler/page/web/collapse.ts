// SPDX-License-Identifier: MIT
// Shows one picture at a time, with a choice between them: all groups, or collapsed to modules or layers.

import { make } from './elements';
import { Picture } from './picture';

export function choosePicture(section: HTMLElement): Picture[] {
  const frames = [...section.querySelectorAll<HTMLElement>('.picture')];
  const boxes = frames.map((frame) => frame.closest<HTMLElement>('details.more') ?? frame);
  const holders = frames.map((frame, i) => {
    const holder = make('div', { class: 'holder' });
    boxes[i].before(holder);
    holder.append(frame);
    if (boxes[i] !== frame) boxes[i].remove();
    return holder;
  });
  const pictures = frames.map((frame) => new Picture(frame));
  const shown = new Set<number>();
  const show = (chosen: number): void => {
    holders.forEach((holder, i) => (holder.hidden = i !== chosen));
    if (!shown.has(chosen)) pictures[chosen].show();
    shown.add(chosen);
    pictures[chosen].settle();
  };
  if (pictures.length > 1) {
    const choice = make('fieldset', { class: 'views' }, make('legend', {}, 'Collapse'));
    pictures.forEach((picture, i) => {
      const radio = make('input', { type: 'radio', name: 'view', id: `view-${i}`, autocomplete: 'off' });
      radio.checked = i === 0;
      radio.addEventListener('change', () => show(i));
      picture.reveal = () => {
        radio.checked = true;
        show(i);
      };
      choice.append(make('span', {}, radio, make('label', { for: `view-${i}` }, picture.name)));
    });
    holders[0].before(choice);
  }
  if (pictures.length > 0) show(0);
  return pictures;
}

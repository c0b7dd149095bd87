// SPDX-License-Identifier: MIT
// How the tracks are drawn: the colours are those of the page's style, and the marks can be distinguished without colour too.

import type { Mark } from './standing';

export interface Look {
  ink: string;
  grey: string;
  line: string;
  paper: string;
  running: string;
  pushed: string;
  queued: string;
  take: string;
  onFill: string;
}

export function lookOf(element: Element): Look {
  const style = getComputedStyle(element);
  const of = (name: string): string => style.getPropertyValue(`--${name}`).trim();
  return {
    ink: of('ink'), grey: of('grey'), line: of('line'), paper: of('paper'), running: of('running'), pushed: of('pushed'), queued: of('queued'), take: of('take'), onFill: of('on-fill'),
  };
}

/** Dark, as what is written over them is white. */
const stripes = { colour: '#000000', strength: 0.4, width: 2 };

/** Running is solid, pushed solid with stripes, queued empty with a dashed border, held with a dotted one, unknown hatched; inactive is a line. */
export function drawSlice(to: CanvasRenderingContext2D, look: Look, mark: Mark, x: number, y: number, width: number, height: number): void {
  const solid = mark === 'running' || mark === 'pushed';
  to.lineWidth = 1;
  if (mark === 'inactive') {
    to.fillStyle = look.line;
    to.fillRect(x, y + height / 2, width, 1);
  } else if (solid) {
    to.fillStyle = mark === 'running' ? look.running : look.pushed;
    to.fillRect(x, y, width, height);
    if (mark === 'pushed') hatch(to, stripes.colour, x, y, width, height, stripes.strength, stripes.width);
  } else {
    to.fillStyle = look.paper;
    to.fillRect(x, y, width, height);
    to.strokeStyle = mark === 'queued' ? look.queued : look.grey;
    to.setLineDash(mark === 'queued' ? [5, 3] : [1, 2]);
    if (width < 3) {
      to.beginPath();
      to.moveTo(x + 0.5, y);
      to.lineTo(x + 0.5, y + height);
      to.stroke();
    } else {
      to.lineWidth = mark === 'queued' ? 1.5 : 1;
      to.strokeRect(x + 0.75, y + 0.75, width - 1.5, height - 1.5);
    }
    to.setLineDash([]);
    if (mark === 'unknown') hatch(to, look.grey, x, y, width, height, 0.6);
  }
}

export function hatch(to: CanvasRenderingContext2D, colour: string, x: number, y: number, width: number, height: number, strength: number, lineWidth = 1): void {
  to.save();
  to.beginPath();
  to.rect(x, y, width, height);
  to.clip();
  to.globalAlpha = strength;
  to.strokeStyle = colour;
  to.lineWidth = lineWidth;
  to.beginPath();
  const first = Math.floor(x / 6) * 6 - height;
  for (let at = first; at < x + width + height; at += 6) {
    to.moveTo(at, y + height);
    to.lineTo(at + height, y);
  }
  to.stroke();
  to.restore();
}

/** A text that is wider than `width` is cut off. */
export function drawText(to: CanvasRenderingContext2D, text: string, colour: string, x: number, y: number, width: number): void {
  if (width < 14 || text === '') return;
  to.save();
  to.beginPath();
  to.rect(x, y - 20, width - 2, 40);
  to.clip();
  to.fillStyle = colour;
  to.fillText(text, x + 3, y);
  to.restore();
}

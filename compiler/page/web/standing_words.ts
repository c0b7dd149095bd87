// SPDX-License-Identifier: MIT
// Where a group stands, in a few words: in a slice of its track, and below its box.

import { limbo, type Names, nobody } from './names';
import type { Standing, Wait } from './standing';

/** `Stability == standing` is waited for, or in one word what keeps the request. */
export function waitWords(wait: Wait, names: Names, why?: string): string {
  if (wait.why === 'waiting' && wait.condition !== undefined) return `until ${wait.condition}`;
  if (wait.why === 'blocked') return blockedWords(names, why);
  return wait.why;
}

/** `blocked, as Legs is held by Walk`, where the answer to `why` says so (runtime/core/inspect/why_text.cpp). */
function blockedWords(names: Names, why: string | undefined): string {
  const held = /(?:^|[ :])([^\s:,]+)(?:, which it needs,)? is held by ([^\s,]+)/.exec(why ?? '');
  if (!held) return 'blocked';
  const [, what, edge] = held;
  return `blocked, as ${what} is held by ${names.askerText(names.edge(edge))}`;
}

/** `walking, for WalkTo`. `why`: what is known of why it waits, as `directorc why` prints it. */
export function words(names: Names, group: number, standing: Standing, why?: string): string {
  const own = names.header.groups[group].providers[standing.provider];
  const provider = own === undefined || own === 'default' ? '' : own;
  switch (standing.mark) {
    case 'running': {
      if (standing.holder === limbo) return `${provider} for nobody`.trim();
      const asker = standing.holder === nobody ? '' : `for ${names.askerText(standing.holder)}`;
      return [provider, asker].filter((text) => text !== '').join(', ');
    }
    case 'pushed': return `pushed to ${own} for ${names.header.groups[names.targets[standing.push?.edge ?? nobody]]?.name ?? ''}`;
    case 'queued': return `queued: ${waitWords(standing.waits[0], names, why)}`;
    case 'held': return 'held for who needs it';
    case 'unknown': return 'not known';
    case 'inactive': return '';
  }
}

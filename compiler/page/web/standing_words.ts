// SPDX-License-Identifier: MIT
// Where a group stands, in a few words: in a slice of its track, and below its box.

import { limbo, type Names, nobody } from './names';
import type { Standing, Wait } from './standing';

/** `Stability == standing` is waited for, or in one word what keeps the request. */
export function waitWords(wait: Wait): string {
  if (wait.why === 'waiting' && wait.condition !== undefined) return `until ${wait.condition}`;
  return wait.why;
}

/** `walking, for WalkTo`. */
export function words(names: Names, group: number, standing: Standing): string {
  const own = names.header.groups[group].providers[standing.provider];
  const provider = own === undefined || own === 'default' ? '' : own;
  switch (standing.mark) {
    case 'running': {
      if (standing.holder === limbo) return `${provider} for nobody`.trim();
      const asker = standing.holder === nobody ? '' : `for ${names.askerText(standing.holder)}`;
      return [provider, asker].filter((text) => text !== '').join(', ');
    }
    case 'pushed': return `pushed to ${own} for ${names.header.groups[names.targets[standing.push?.edge ?? nobody]]?.name ?? ''}`;
    case 'queued': return `queued: ${waitWords(standing.waits[0])}`;
    case 'held': return 'held for who needs it';
    case 'unknown': return 'not known';
    case 'inactive': return '';
  }
}

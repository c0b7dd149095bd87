// SPDX-License-Identifier: MIT
// Where a group stands, in a few words: in a slice of its track, and below its box.

import { limbo, type Names, nobody } from './names';
import type { Because } from './recording';
import type { Standing, Wait } from './standing';

/** `Stability == standing` is waited for, or in one word what keeps the request; of one that is blocked by whom, where the answer to `why` says so. */
export function waitWords(wait: Wait, names: Names, why?: Because): string {
  if (wait.why === 'waiting' && wait.condition !== undefined) return `until ${wait.condition}`;
  if (wait.why === 'blocked' && why?.held !== undefined) return `blocked, as ${why.held.group} is held by ${names.askerText(names.edge(why.held.by))}`;
  return wait.why;
}

/** `walking, for WalkTo`. `why`: what is known of why it waits. */
export function words(names: Names, group: number, standing: Standing, why?: Because): string {
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
    case 'held': return 'held for what needs it';
    case 'unknown': return 'not known';
    case 'inactive': return '';
  }
}

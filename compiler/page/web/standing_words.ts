// SPDX-License-Identifier: MIT
// The standing of a group in a few words, for a slice of its track and for the note below its box.

import { limbo, type Names, nobody } from './names';
import type { Because } from './recording';
import type { Standing, Wait } from './standing';

/** `until Stability == standing`, or the reason in one word; for a blocked request also what blocks it, if the answer to `why` says so. */
export function waitWords(wait: Wait, names: Names, why?: Because): string {
  if (wait.why === 'waiting' && wait.condition !== undefined) return `until ${wait.condition}`;
  if (wait.why === 'blocked' && why?.held !== undefined) return `blocked, as ${why.held.group} is held by ${names.requesterText(names.edge(why.held.by))}`;
  return wait.why;
}

/** `walking, for WalkTo`. `why`: the reason why it waits; undefined: not known. */
export function words(names: Names, group: number, standing: Standing, why?: Because): string {
  const own = names.header.groups[group].providers[standing.provider];
  const provider = own === undefined || own === 'default' ? '' : own;
  switch (standing.mark) {
    case 'running': {
      if (standing.holder === limbo) return `${provider} kept in limbo`.trim();
      const requester = standing.holder === nobody ? '' : `for ${names.requesterText(standing.holder)}`;
      return [provider, requester].filter((text) => text !== '').join(', ');
    }
    case 'pushed': return `pushed to ${own} for ${names.header.groups[names.targets[standing.push?.edge ?? nobody]]?.name ?? ''}`;
    case 'queued': return `queued: ${waitWords(standing.waits[0], names, why)}`;
    case 'held': return 'held for what needs it';
    case 'unknown': return 'not known';
    case 'inactive': return '';
  }
}

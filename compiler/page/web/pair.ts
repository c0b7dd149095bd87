// SPDX-License-Identifier: MIT
// Shows for any two groups which of them goes first, and what decides that.

import type { Data, Decision } from './data';
import { byId, make } from './elements';

/** `first`, `second` or `equal`, of the two chosen groups. `turned`: the decision has them in the other order. */
function sideThatWins(decision: Decision, turned: boolean): string {
  if (decision.goes_first === 'equal' || !turned) return decision.goes_first;
  return decision.goes_first === 'first' ? 'second' : 'first';
}

export class Pair {
  private readonly inputs = ['first', 'second'].map((id) =>
    make('input', { type: 'search', id: `pair-${id}`, list: 'pair-names', autocomplete: 'off', spellcheck: 'false' }),
  );
  private readonly answer = make('div', { id: 'pair-answer', role: 'status' });
  private readonly places: Map<string, number>; // by name, and by name in small letters, which several groups may share

  constructor(private readonly data: Data) {
    const places = data.groups.map((group, i): [string, number] => [group.name, i]);
    this.places = new Map([...places.map(([name, i]): [string, number] => [name.toLowerCase(), i]), ...places]);
    const box = byId('pair');
    if (!box || !data.ranks || data.ranks.pairs.length === 0) return;
    const names = make('datalist', { id: 'pair-names' }, ...data.groups.map((group) => make('option', { value: group.name })));
    const [first, second] = this.inputs;
    box.append(make('label', { for: first.id }, 'Who goes first,'), first, make('label', { for: second.id }, 'or'), second, names, this.answer);
    for (const input of this.inputs) {
      input.addEventListener('input', () => this.show(false));
      input.addEventListener('change', () => this.show(true));
    }
    box.hidden = false;
  }

  /** `entered`: otherwise a name may be the beginning of one that is being typed. */
  private show(entered: boolean): void {
    const typed = this.inputs.map(({ value }) => value.trim()).filter((name) => name !== '');
    const placeOf = (name: string): number | undefined => this.places.get(name) ?? this.places.get(name.toLowerCase());
    const begins = (name: string): boolean => [...this.places.keys()].some((each) => each.startsWith(name.toLowerCase()));
    const unknown = typed.filter((name) => placeOf(name) === undefined && (entered || !begins(name)));
    const [a, b] = typed.map(placeOf);
    this.answer.replaceChildren(
      ...(unknown.length > 0 ? [make('ul', {}, ...unknown.map((name) => make('li', {}, `There is no group ${name}.`)))] : a === undefined || b === undefined ? [] : this.tell(a, b)),
    );
  }

  private tell(a: number, b: number): Node[] {
    const ranks = this.data.ranks;
    if (!ranks) return [];
    const swapped = a < b; // the row of a group has only the groups up to it
    const answer = ranks.answers[swapped ? ranks.pairs[b][a] : ranks.pairs[a][b]];
    const [first, second] = [this.data.groups[a].name, this.data.groups[b].name];
    const lines: string[] = [];
    if (answer.leads) {
      const [above, below] = (answer.leads === 'first') === !swapped ? [first, second] : [second, first];
      lines.push(`${above} leads to ${below}: it goes first of what it leads to.`);
    }
    for (const code of answer.decisions) {
      const decision = ranks.decisions[Math.floor(code / 2)];
      const wins = sideThatWins(decision, (code % 2 === 1) !== swapped);
      const head = wins === 'equal' || a === b ? '' : `${wins === 'first' ? first : second} goes first. `;
      lines.push(`${head}At ${decision.words}.`);
    }
    if (lines.length === 0) {
      lines.push(a === b ? `Nowhere do two chains of requesters lead to ${first}.` : `They never meet: no requester leads to both beside each other.`);
    } else if (answer.decisions.some((code) => ranks.decisions[Math.floor(code / 2)].goes_first === 'equal')) {
      lines.push('Of equals, the holder keeps it; of two that request it, the older request goes first.');
    }
    if (answer.more) lines.push(`And ${answer.more} more, which are too many for a page: directorc graph --format=json --page has them all, and a deployment with fewer roots has fewer.`);
    return [make('ul', {}, ...lines.map((line) => make('li', {}, line)))];
  }
}

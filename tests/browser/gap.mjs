// SPDX-License-Identifier: MIT
// node gap.mjs TRACE TO: writes the same trace to TO, with its events 3001 to 5000 missing.
import { readFileSync, writeFileSync } from 'node:fs';

const [from, to] = process.argv.slice(2);
const lines = readFileSync(from, 'utf8').trimEnd().split('\n');
lines.splice(3001, 2000, JSON.stringify({ event: 'dropped', count: 2000 }));
writeFileSync(to, `${lines.join('\n')}\n`);

// SPDX-License-Identifier: MIT
// node gap.mjs TRACE TO LATE: writes the same trace to TO, with its events 3001 to 5000 missing, and to LATE without those before the 5001st.
import { readFileSync, writeFileSync } from 'node:fs';

const [from, to, late] = process.argv.slice(2);
const lines = readFileSync(from, 'utf8').trimEnd().split('\n');
writeFileSync(late, `${[lines[0], ...lines.slice(5001)].join('\n')}\n`);
lines.splice(3001, 2000, JSON.stringify({ event: 'dropped', count: 2000 }));
writeFileSync(to, `${lines.join('\n')}\n`);

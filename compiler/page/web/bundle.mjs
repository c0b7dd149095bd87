// SPDX-License-Identifier: MIT
// node bundle.mjs [FOLDER]: checks the types, then writes page.js and page.css into FOLDER, without one into compiler/page/bundle. The licences of what
// page.js has of others ask to stand in each copy, and each page is one: they are a comment in it.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { build } from 'esbuild';

const to = process.argv[2] ?? '../bundle';
execFileSync(process.execPath, ['node_modules/typescript/bin/tsc', '--project', 'tsconfig.json'], { stdio: 'inherit' });
const common = { bundle: true, minify: true, legalComments: 'none', charset: 'utf8', logLevel: 'warning' };
const script = { ...common, entryPoints: ['page.ts'], outfile: join(to, 'page.js'), format: 'iife', target: 'es2020' };
const { metafile } = await build({ ...script, write: false, metafile: true });

const packages = new Set();
for (const input of Object.keys(metafile.inputs)) {
  const found = /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(input);
  if (found) packages.add(found[1]);
}
const texts = new Map();
for (const name of [...packages].sort()) {
  const folder = join('node_modules', name);
  const about = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const text = readFileSync(join(folder, 'LICENSE'), 'utf8').trim();
  texts.set(text, [...(texts.get(text) ?? []), `${name} ${about.version}`]);
}
let licences = 'With parts of:\n';
for (const [text, names] of texts) licences += `\n${names.join(', ')}\n\n${text}\n`;
await build({ ...script, banner: { js: `/*! SPDX-License-Identifier: MIT\n${licences}*/` } });
await build({ ...common, entryPoints: ['page.css'], outfile: join(to, 'page.css'), target: 'chrome100' });

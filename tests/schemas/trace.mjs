// SPDX-License-Identifier: MIT
// node trace.mjs SCHEMA FILE...: tests that the schema accepts each line of each file.
import { readFileSync } from 'node:fs';
import Ajv from 'ajv';

const [path, ...files] = process.argv.slice(2);
const validate = new Ajv({ strict: false }).compile(JSON.parse(readFileSync(path, 'utf8')));
let wrong = 0;
for (const file of files) {
  const lines = readFileSync(file, 'utf8').trimEnd().split('\n');
  lines.forEach((line, i) => {
    if (validate(JSON.parse(line))) return;
    ++wrong;
    console.log(`${file}:${i + 1}: ${validate.errors.map((e) => `${e.instancePath} ${e.message}`).join('; ')}`);
  });
}
process.exit(wrong === 0 ? 0 : 1);

// SPDX-License-Identifier: MIT
// node graph.mjs SCHEMA FILE...: tests that the schema accepts each file, and that the name of each property of the schema is a key in one of them.
import { readFileSync } from 'node:fs';
import Ajv from 'ajv';

const [path, ...files] = process.argv.slice(2);
const schema = JSON.parse(readFileSync(path, 'utf8'));
const validate = new Ajv({ strict: false }).compile(schema);

const keys = new Set();
const collect = (value) => {
  if (Array.isArray(value)) return value.forEach(collect);
  if (value === null || typeof value !== 'object') return;
  for (const [key, inner] of Object.entries(value)) {
    keys.add(key);
    collect(inner);
  }
};
let wrong = 0;
for (const file of files) {
  const graph = JSON.parse(readFileSync(file, 'utf8'));
  collect(graph);
  if (validate(graph)) continue;
  ++wrong;
  console.log(`${file}: ${validate.errors.map((e) => `${e.instancePath} ${e.message}`).join('; ')}`);
}
const declared = new Set();
const declare = (value) => {
  if (Array.isArray(value)) return value.forEach(declare);
  if (value === null || typeof value !== 'object') return;
  for (const key of Object.keys(value.properties ?? {})) declared.add(key);
  Object.values(value).forEach(declare);
};
declare(schema);
for (const key of declared) if (!keys.has(key)) ++wrong, console.log(`none has the key ${key}`);
console.log(`${path.split("/").pop()}: ${files.length}, keys: ${declared.size}`);
process.exit(wrong === 0 && files.length > 0 ? 0 : 1);

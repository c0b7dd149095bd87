// SPDX-License-Identifier: MIT
// node compare.mjs VERDICTS SCHEMAS: tests that each schema accepts everything that the reader accepts, and refuses everything that the reader refuses
// for a reason that a schema can express. VERDICTS: the output of the program `verdicts`; SCHEMAS: the folder of the schemas.
import { readFileSync } from 'node:fs';
import Ajv from 'ajv';
import { parseDocument } from 'yaml';

const seen = ['unknown_key', 'wrong_node_kind', 'missing_key', 'exclusive_keys', 'bad_condition', 'bad_type', 'bad_header'];

// Faults that no schema can find: how a number or boolean is spelled is lost when YAML is parsed, and a schema cannot compare two numbers.
const beyond = [
  { why: 'a number that is not in decimal, or a boolean with capitals', text: /\b(0[0-9]+|0x[0-9a-f]+|0o[0-7]+|[0-9]+\.0|[0-9]+e[0-9]+|True|TRUE|False|FALSE)\b/ },
  { why: 'a range whose lowest number is the higher one', text: /"?range"?: *\[(100, 0|0, -1)\]/ },
];

const [verdicts, schemas] = process.argv.slice(2);
const texts = ['behaviour', 'scenario'].map((kind) => JSON.parse(readFileSync(`${schemas}/${kind}.schema.json`, 'utf8')));
const validators = texts.map((text) =>
  new Ajv({ strict: true, allowUnionTypes: true, strictRequired: false, strictTypes: false }).compile(text));

// Each key must have a description: editors show it when the pointer rests on the key.
const undescribed = [];
const visit = (node, path) => {
  for (const [key, value] of Object.entries(node ?? {})) {
    if (typeof value !== 'object' || key === 'not') continue;
    if (path.endsWith('/properties') && typeof value.description !== 'string') undescribed.push(`${path}/${key}`);
    visit(value, `${path}/${key}`);
  }
};
texts.forEach((text, i) => visit(text, i === 0 ? 'behaviour' : 'scenario'));
if (undescribed.length > 0) console.log(`no description: ${undescribed.join(', ')}`);

const count = { files: 0, accepted: 0, refused: 0, 'not for a schema': 0, 'no YAML': 0, 'beyond a schema': 0 };
const reasons = Object.fromEntries(seen.map((id) => [id, 0]));
let wrong = 0;
for (const line of readFileSync(verdicts, 'utf8').split('\n')) {
  if (line === '') continue;
  const { name, scenario, text, errors } = JSON.parse(line);
  ++count.files;
  const document = parseDocument(text, { version: '1.2', schema: 'core', logLevel: 'silent' });
  if (document.errors.length > 0 || errors.includes('yaml_syntax') || errors.includes('duplicate_key')) {
    ++count['no YAML'];
    continue;
  }
  const visible = errors.filter((id) => seen.includes(id));
  if (visible.length === 0 && errors.length > 0) {
    ++count['not for a schema'];
    continue;
  }
  const validate = validators[scenario ? 1 : 0];
  const valid = validate(document.toJS());
  const expected = errors.length === 0;
  if (valid !== expected) {
    if (valid && beyond.some((each) => each.text.test(text))) {
      ++count['beyond a schema'];
      continue;
    }
    if (++wrong <= 20) {
      console.log(`${name}: the reader ${expected ? 'accepts' : `refuses (${visible.join(', ')})`}, the schema ${valid ? 'accepts' : 'refuses'}`);
      if (!valid) console.log(`  ${validate.errors.map((e) => `${e.instancePath} ${e.message}`).join('; ')}`);
      console.log(text.replace(/^/gm, '    '));
    }
    continue;
  }
  ++count[expected ? 'accepted' : 'refused'];
  if (visible.length === 1) ++reasons[visible[0]];
}
console.log(Object.entries(count).map(([what, n]) => `${what}: ${n}`).join(', '));
console.log(`refused for one reason alone: ${seen.map((id) => `${id}: ${reasons[id]}`).join(', ')}`);
if (wrong > 0) console.log(`${wrong} disagree`);
const untried = seen.filter((id) => reasons[id] === 0);
if (untried.length > 0) console.log(`no file is refused for ${untried.join(', ')} alone`);
process.exit(undescribed.length === 0 && wrong === 0 && untried.length === 0 && count.accepted > 0 ? 0 : 1);

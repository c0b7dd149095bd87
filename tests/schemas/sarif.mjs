// SPDX-License-Identifier: MIT
// node sarif.mjs FILE...: tests that each file is SARIF 2.1.0. The schema is from an npm package. Ajv does not support its old draft of JSON Schema,
// but the keywords that it uses have the same meaning in the newer one.
import { readFileSync } from 'node:fs';
import Ajv from 'ajv';

const schema = JSON.parse(readFileSync('node_modules/@microsoft/jest-sarif/lib/schemas/sarif-2.1.0-rtm.5.json', 'utf8'));
delete schema.$schema;
delete schema.id;
const validate = new Ajv({ strict: false, validateFormats: false, unicodeRegExp: false }).compile(schema);

let wrong = 0;
const seen = { error: 0, warning: 0, note: 0, codeFlows: 0, relatedLocations: 0 };
for (const file of process.argv.slice(2)) {
  const log = JSON.parse(readFileSync(file, 'utf8'));
  if (!validate(log)) {
    ++wrong;
    console.log(`${file}: ${validate.errors.map((e) => `${e.instancePath} ${e.message}`).join('; ')}`);
    continue;
  }
  const prints = new Set();
  for (const result of log.runs[0].results) {
    ++seen[result.level];
    for (const key of ['codeFlows', 'relatedLocations']) if (result[key]) ++seen[key];
    prints.add(result.partialFingerprints['director/v1']);
    const rule = log.runs[0].tool.driver.rules[result.ruleIndex];
    if (rule?.id !== result.ruleId) ++wrong, console.log(`${file}: ${result.ruleId} is not rule ${result.ruleIndex}`);
  }
  if (prints.size !== log.runs[0].results.length) ++wrong, console.log(`${file}: two results have one fingerprint`);
}
console.log(`SARIF: ${Object.entries(seen).map(([what, n]) => `${what}: ${n}`).join(', ')}`);
process.exit(wrong === 0 && seen.error > 0 && seen.warning > 0 ? 0 : 1);

// node validate_glb.mjs FILE.glb - asks the Khronos validator (npm: gltf-validator) about a file. Exits with 0 when it
// finds neither error nor warning, 1 when it does, 2 without a file, 77 when the validator is not installed. The
// environment's TOILE_GLTF_VALIDATOR names the node_modules folder it lies in, if node does not find it by itself.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';

const [, , file] = process.argv;
if (!file) {
  console.error('usage: node validate_glb.mjs FILE.glb');
  process.exit(2);
}

const folder = process.env.TOILE_GLTF_VALIDATOR;
let validator;
try {
  validator = createRequire(folder ? join(resolve(folder), 'any.js') : import.meta.url)('gltf-validator');
} catch {
  console.error('gltf-validator is not installed');
  process.exit(77);
}

const { issues, info } = await validator.validateBytes(new Uint8Array(readFileSync(file)));
const severities = ['error', 'warning', 'information', 'hint'];
for (const { severity, code, message, pointer } of issues.messages) {
  console.error(`${severities[severity]}: ${code}: ${message} ${pointer ?? ''}`);
}
console.error(`${file}: ${info.totalVertexCount} vertices, ${info.totalTriangleCount} triangles, ` +
  `${issues.numErrors} errors, ${issues.numWarnings} warnings, ${issues.numInfos + issues.numHints} remarks`);
process.exit(issues.numErrors + issues.numWarnings === 0 ? 0 : 1);

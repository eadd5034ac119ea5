// Khronos's validator: node validate.js FILE.glb; fails on any error or warning.
const fs = require("fs"), validator = require("gltf-validator");
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[2]))).then((report) => {
  for (const message of report.issues.messages) console.log(`${message.code} ${message.pointer}: ${message.message}`);
  console.log(`${report.issues.numErrors} errors, ${report.issues.numWarnings} warnings`);
  process.exit(report.issues.numErrors + report.issues.numWarnings > 0 ? 1 : 0);
});

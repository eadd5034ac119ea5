// Serves a folder on localhost: node serve.js FOLDER PORT
const fs = require("fs"), http = require("http"), path = require("path");
const [folder, port] = process.argv.slice(2);
const types = { ".html": "text/html", ".js": "text/javascript", ".glb": "model/gltf-binary" };
http.createServer((request, response) => {
  const name = path.join(folder, decodeURIComponent(request.url.split("?")[0]));
  fs.readFile(name, (error, bytes) => {
    response.writeHead(error ? 404 : 200, { "content-type": types[path.extname(name)] || "application/octet-stream" });
    response.end(error ? "" : bytes);
  });
}).listen(Number(port), "127.0.0.1");

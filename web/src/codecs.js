// What an instance needs libraries for that are large and seldom wanted: see Instance.bringCodecs.
export { deflate, inflate } from './deflate.js';
export { parseJson } from './json.js';
export { decodePng } from './png.js';

// jsonc-parser for the built page: what web/src/json.js takes of it, so that the rest is left out.
import { ParseErrorCode, visit } from '../node_modules/jsonc-parser/lib/esm/main.js';

export { ParseErrorCode, visit };
export default { ParseErrorCode, visit };

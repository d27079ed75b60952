// The script of a browser's worker of the pool: what it is sent brings it in.
import { serve } from './pool.js';

onmessage = ({ data }) => serve(data);

// Pacing: when the next frame is asked for, and how sharp pictures may be.
//
// Invariant: no frame is asked for while nothing moves and nothing has changed.

/** What the world passes at the first frame after a rest. */
const period = 1 / 60;

export class Frames {
    #nextFrame;
    #pass;
    #asked = false;
    #hidden = false;
    #last: number | null = null;

    /**
     * @param nextFrame requestAnimationFrame, or what stands for it
     * @param pass lets so many seconds pass; whether time goes on
     */
    constructor(nextFrame: (callback: (ms: number) => void) => void, pass: (seconds: number) => boolean) {
        this.#nextFrame = nextFrame;
        this.#pass = pass;
    }

    /** Something has changed, or moves. */
    ask() {
        if (!this.#asked && !this.#hidden) {
            this.#asked = true;
            this.#nextFrame((ms) => this.#frame(ms));
        }
    }

    setHidden(hidden: boolean) {
        this.#hidden = hidden;
        this.#last = null;
        this.ask();
    }

    #frame(ms: number) {
        this.#asked = false;
        if (this.#hidden) {
            return;
        }
        const now = ms / 1000;
        const goesOn = this.#pass(this.#last === null ? period : now - this.#last);
        this.#last = goesOn ? now : null;
        if (goesOn) {
            this.ask();
        }
    }
}

const ratios = [2, 1.5, 1];
/** What is judged by: so many frames, or those of a second. */
const mostFrames = 45, leastFrames = 6, longest = 1;
const slowFrame = 1 / 45, slowDrawing = 0.008, verySlowDrawing = 0.03; // s
const lightWork = 0.6, gain = 0.85;

/**
 * How many device pixels a CSS pixel may have at most: less where drawing is slow. That is where it
 * takes long to ask for it, or where pictures come late although neither stepping nor asking takes
 * long. Where less pixels gain nothing it is something else, and they come back for good.
 */
export class Sharpness {
    #level = 0;
    #fixed = false;
    /** What a frame took before the last change, and the level then. */
    #before: number | null = null;
    #from = 0;
    #frames = 0;
    #sum = 0;
    #work = 0;
    #drawing = 0;

    get limit() {
        return ratios[this.#level];
    }

    /** A frame of so many seconds, in which so many were worked and drawn; whether the limit changes. */
    tell(seconds: number, stepping: number, drawing: number) {
        this.#frames++;
        this.#sum += seconds;
        this.#work += stepping + drawing;
        this.#drawing += drawing;
        const seen = this.#frames >= mostFrames || (this.#frames >= leastFrames && this.#sum >= longest);
        if (!seen || this.#fixed) {
            return false;
        }
        const frame = this.#sum / this.#frames, draw = this.#drawing / this.#frames;
        const work = this.#work / this.#sum;
        this.#frames = this.#sum = this.#work = this.#drawing = 0;
        if (this.#before !== null && frame > gain * this.#before && draw <= slowDrawing) {
            this.#fixed = true;
            this.#level = this.#from;
            return true;
        }
        const slow = draw > slowDrawing || (frame > slowFrame && work < lightWork);
        if (!slow || this.#level === ratios.length - 1) {
            this.#before = null;
            return false;
        }
        this.#before = frame;
        this.#from = this.#level;
        this.#level = draw > verySlowDrawing ? ratios.length - 1 : this.#level + 1;
        return true;
    }
}

// Chooses which pixels of a large picture are shown.

/** Largest width and height that the page shows, in pixels. Browsers refuse canvases that are much larger. */
const MAX_SHOWN = 4096;

/** Returns the step between the rows and columns that are shown. It is 1 if all pixels are shown. */
export function stepOf(width: number, height: number): number {
    return Math.ceil(Math.max(width, height, 1) / MAX_SHOWN);
}

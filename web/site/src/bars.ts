// The bars between the editors and between the columns. The user drags them or presses arrow keys, and they are kept.
import * as store from './store';

/** The least and the largest part of the room that is before a bar, and the part by which a key moves it. */
const [LEAST, MOST, STEP] = [0.15, 0.85, 0.02];

/**
 * Lets the user move a bar. The property `--ID` of the page is the part of the room that is before the bar with this
 * id. The room begins at the first element of `data-between`, and ends at the second one.
 */
export function movable(bar: HTMLElement): void {
    const [first, last] = (bar.dataset.between ?? '').split(' ').map((id) => document.getElementById(id));
    const isVertical = bar.ariaOrientation === 'vertical';
    let part = 0;
    const move = (wanted: number) => {
        part = Math.min(Math.max(wanted, LEAST), MOST);
        document.documentElement.style.setProperty(`--${bar.id}`, String(part));
        bar.ariaValueNow = String(Math.round(100 * part));
    };
    const keep = () => store.keepSetting(bar.id, String(part));
    move(Number(store.setting(bar.id)) || Number(bar.dataset.part));
    bar.addEventListener('pointerdown', (event) => bar.setPointerCapture(event.pointerId));
    bar.addEventListener('pointermove', (event) => {
        if (first && last && bar.hasPointerCapture(event.pointerId)) {
            const [start, end] = [first.getBoundingClientRect(), last.getBoundingClientRect()];
            move(isVertical
                ? (event.clientX - start.left) / (end.right - start.left)
                : (event.clientY - start.top) / (end.bottom - start.top));
        }
    });
    bar.addEventListener('pointerup', keep);
    bar.addEventListener('keydown', ({ key }) => {
        const [less, more] = isVertical ? ['ArrowLeft', 'ArrowRight'] : ['ArrowUp', 'ArrowDown'];
        if (key === less || key === more) {
            move(part + (key === less ? -STEP : STEP));
            keep();
        }
    });
}

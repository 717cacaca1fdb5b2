// The tabs of the page's views. The arrow keys move between them, as in every list of tabs.

/** Shows one view at a time. Calls `left` before a change, and `shown` with the id of its element after it. */
export class Tabs {
    readonly #tabs = Array.from(document.querySelectorAll<HTMLButtonElement>('[role=tab]'));

    constructor(private readonly shown: (name: string) => void, private readonly left: () => void) {
        this.#tabs.forEach((tab, index) => {
            tab.addEventListener('click', () => this.show(tab.getAttribute('aria-controls') ?? ''));
            tab.addEventListener('keydown', (event) => {
                const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
                if (step !== 0) {
                    const next = this.#tabs[(index + step + this.#tabs.length) % this.#tabs.length];
                    next?.focus();
                    next?.click();
                }
            });
        });
    }

    /** The id of the view that is shown. */
    get current(): string {
        return this.#tabs.find((tab) => tab.ariaSelected === 'true')?.getAttribute('aria-controls') ?? '';
    }

    /** Shows the view whose element has the id `name`. Another name changes nothing. A view of an entry is not left. */
    show(name: string, isEntry = false): void {
        if (!this.#tabs.some((tab) => tab.getAttribute('aria-controls') === name)) {
            return;
        }
        if (name !== this.current && !isEntry) {
            this.left();
        }
        for (const tab of this.#tabs) {
            const controls = tab.getAttribute('aria-controls') ?? '';
            const isShown = controls === name;
            tab.ariaSelected = String(isShown);
            tab.tabIndex = isShown ? 0 : -1;
            (document.getElementById(controls) as HTMLElement).hidden = !isShown;
        }
        this.shown(name);
    }
}

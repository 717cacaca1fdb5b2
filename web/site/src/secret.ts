// The secret of `render-lab view`, which every request for its files and changes must have.
//
// The program prints an address with the secret. The page keeps the secret in its local storage, which a browser
// separates by port, and loads itself again without it. So the secret is neither in the address bar nor in a link.

const KEY = 'render.secret';

let secret = '';
try {
    secret = localStorage.getItem(KEY) ?? '';
} catch {
    // Without storage, the secret of the address counts until the page is left.
}

/** Takes the secret from the address. Returns whether the page is being loaded again, so that nothing else is to do. */
export function takeSecret(): boolean {
    const given = new URLSearchParams(location.search).get('secret');
    if (given === null) {
        return false;
    }
    secret = given;
    const address = location.pathname + location.hash;
    try {
        localStorage.setItem(KEY, secret);
    } catch {
        history.replaceState(null, '', address);
        return false;
    }
    location.replace(address);
    return true;
}

/** Requests a path of `render-lab view`. */
export const ask = (path: string, options: RequestInit = {}): Promise<Response> =>
    fetch(path, { ...options, headers: { Authorization: `Bearer ${secret}` } });

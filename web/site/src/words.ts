// The words of the page in English and Spanish. Messages of the renderer are in English, as its specification says;
// the hints below them are in both languages.

const ENGLISH = {
    title: 'An exact renderer of spheres and cylinders',
    lead: 'The picture has the bytes that the program render-aos writes, computed in this page.',
    config: 'Configuration',
    scene: 'Scene',
    picture: 'Picture',
    examples: 'Examples',
    choose: 'choose…',
    earlier: 'My earlier texts',
    objects: '{0} {0|object|objects}{1}',
    language: 'Language',
    render: 'Render',
    cancel: 'Cancel',
    live: 'Render after every change',
    savePpm: 'Save PPM',
    savePng: 'Save PNG',
    share: 'Make a link',
    link: 'Link with both texts, changed shaders and the view',
    help: 'Ctrl+Enter renders. Ctrl+Space shows the lines that are possible. Escape, then Tab, leaves an editor.',
    helpTouch: '"Render" makes the exact picture. While you type, the lines that are possible are shown.',
    barEditors: 'Boundary between the editors',
    barColumns: 'Boundary between the texts and the picture',
    loading: 'Loading the renderer…',
    preparing: 'Preparing the scene…',
    rendering: 'Rendering…',
    cancelled: 'Cancelled.',
    same: 'the bytes of render-aos',
    rows: 'rows',
    seconds: 's',
    shownPart: 'one pixel in {0} is shown each way, and all are saved',
    faultIn: 'There is an error in: {0}.',
    oldPicture: 'The texts have changed since this picture. "Render" makes the new one.',
    oldViews: 'What is shown belongs to earlier texts.',
    line: 'Line {0}',
    firstFaults: 'Only the first {0} errors are shown.',
    failed: 'The renderer stopped: {0}',
    noModule: 'The renderer could not be loaded: {0}',
    noExample: 'The example could not be loaded: {0}',
    badLink: 'The link could not be read, so your own texts stay.',
    copied: 'The link is copied.',
    made: 'The link is below.',
    tooLong: 'The link has {0} characters; some programs cut such links.',
    notKept: 'This browser does not keep what you type: {0}',
    fileChanged: 'the file has changed meanwhile. Choose which text stays.',
    fileMissing: 'The file does not exist yet: "Save" creates it.',
    offer: 'A file has changed, and its text here is not saved.',
    offerTake: 'Take the file',
    offerKeep: 'Keep my text',
    save: 'Save',
    download: 'Download',
    unsaved: '● not saved',
    saved: '{0} is saved.',
    notSaved: 'Not saved: {0}',
    reloaded: 'A file has changed and was loaded again.',
    unreachable: 'render-lab view does not answer. What you type is kept here.',
    views: 'Views',
    liveView: 'Live view',
    gpuOpening: 'Opening WebGPU…',
    gpuMissing: 'This browser has no WebGPU.',
    gpuInsecure: 'A browser offers WebGPU only to pages from this machine or by HTTPS.',
    gpuNoAdapter: 'This browser has WebGPU, but no graphics device for it.',
    gpuSilent: 'WebGPU has not answered within {0} s.',
    gpuLost: 'The graphics device was lost: {0}',
    gpuFailed: 'WebGPU failed: {0}',
    gpuInstead: 'The exact renderer (WebAssembly) draws a small picture in the live view instead.',
    gpuAgain: 'Try WebGPU again',
    liveTake: 'Put this view into the configuration',
    liveSave: 'Save the camera to the file',
    liveReset: 'Back to the camera of the text',
    liveFixed: 'Deterministic light, for comparing: one ray through the middle of each pixel',
    lightFixed: 'deterministic light',
    busy: 'Calculating…',
    liveHelp: 'Drag to turn, with Shift or the right button to move, wheel or two fingers to come closer. Click a '
        + 'pixel to follow its path. The keys move the camera: arrows, Shift+arrows, + and -, Home.',
    liveHelpTouch: 'Drag with one finger to turn, with two fingers to move or to come closer. '
        + 'Tap a pixel to follow its path.',
    liveSamples: '{0} {0|sample|samples}',
    liveRate: '{0} frames/s',
    liveDuration: 'the last frame took {0} s',
    liveInside: 'The camera is inside an object ({0}).',
    liveRefused: 'A shader has an error, so the last good picture stays.',
    liveRefusedFirst: 'A shader has an error, so there is no picture yet. The editor of the shaders shows the line.',
    directive: 'A module can have no directive, because other modules stand before it in one text. Leave it out.',
    liveFault: 'The texts have an error, so the last good picture stays: {0}',
    liveFaultFirst: 'The texts have an error, so there is no picture yet: {0}',
    liveStopped: 'The live view stopped: {0}',
    liveTaken: 'The view is in the configuration. "Render" makes its exact picture.',
    liveSaved: 'The camera is saved in the configuration file.',
    compare: 'Compare',
    compareSlider: 'Boundary between the pictures',
    compareWith: 'Compare the shaders with',
    compareView: 'Show',
    exactF64: 'the exact renderer (f64; most pixels round otherwise)',
    rustF32: 'the same steps in Rust (f32)',
    viewBoth: 'both pictures',
    viewLinear: 'difference, linear',
    viewUlps: 'difference, units in the last place',
    blink: 'Blink',
    comparing: 'Comparing…',
    ulps: '{0} {0|unit|units} in the last place',
    compareFigures: '{0} of {1} pixels {0|differs|differ}, RMSE {2}, at most {3}, '
        + '{4} {4|unit|units} in the last place.',
    compareMostAt: 'Largest difference: column {0}, row {1}',
    compareBlind: 'This light has no random vectors, so a changed formula for them shows only in the live view with '
        + 'samples.',
    compareHelp: 'Left of the line: by Rust. Right of it: by the shaders. '
        + 'Deterministic light: one ray through the middle of each pixel. Click or tap a pixel to follow its path.',
    noCompare: 'Without WebGPU there are no shaders to compare.',
    fit: 'Fit',
    pixelAt: 'column {0}, row {1}: {2}',
    compareFiles: 'Compare files…',
    compareClose: 'Back to the shaders',
    filesHelp: 'Two files (PPM, PNG), or one with the picture of the first tab.',
    viewHelp: 'Files can also be dropped on the page. Drag the line; the wheel zooms, and a drag with Shift or the '
        + 'right button moves the pictures.',
    viewHelpTouch: 'Drag the line. Two fingers zoom and move the pictures.',
    filesNames: 'Left: {0}. Right: {1}.',
    filesAccepted: 'The course accepts this difference: RMSE {2} (below 10), at most {3} (below 150), of 255; a pixel '
        + 'counts as the mean of its channels. {0} of {1} pixels {0|differs|differ}.',
    filesRefused: 'The course does not accept this difference: RMSE {2} (below 10 is needed), at most {3} (below 150 '
        + 'is needed), of 255; a pixel counts as the mean of its channels. {0} of {1} pixels '
        + '{0|differs|differ}.',
    noPicture: 'this is neither PPM (P3 or P6) nor PNG with 8 bits a channel',
    brokenPicture: 'the file ends early, is too large, or has something else where a number belongs',
    sizesDiffer: '{0} has {1} × {2} pixels, and {3} has {4} × {5}. Only pictures of one size can be compared.',
    oneFile: 'One file is compared with the picture of the first tab, which is not finished. '
        + 'Wait, or choose two files.',
    planAbove: 'from above: x to the right, z downwards',
    planFront: 'against z: x to the right, y upwards',
    planPaths: 'path by Rust (line) and by WGSL (dashes)',
    planRust: 'path by Rust',
    planSame: 'path by Rust and by WGSL',
    pixel: 'Pixel',
    pixelHelp: 'Click or tap a pixel here, in the live view or in the comparison, or type its place.',
    column: 'Column',
    row: 'Row',
    side: 'side',
    top: 'top cap',
    bottom: 'bottom cap',
    outside: 'from outside',
    inside: 'from inside',
    range: '{0} (0 to {1})',
    stepAlone: 'step {0}',
    stepSame: 'step {0}: no bit differs',
    stepDiffers: 'step {0}: {1} {1|number differs|numbers differ}',
    scaleLinear: '(linear scale)',
    scaleLogarithmic: '(logarithmic scale)',
    firstDifference: 'First difference: step {0}, {1}',
    noDifference: 'No bit differs.',
    liveProbe: 'Show what the shaders give to probe(value)',
    probeRange: 'probe from {0} to {1} (linear scale)',
    shaders: 'Shaders (WGSL)',
    shadersChanged: 'changed: {0}',
    module: 'Module',
    shaderReset: 'Back to the original text',
    shaderHelp: 'The live view compiles the modules after each pause. A comment makes a slider or a colour picker: '
        + 'override gain: f32 = 0.5; // slider 0..1 step .01 — const tint = vec3<real>(1.0, 0.5, 0.2); // color',
    noShaders: 'Without WebGPU the modules are kept but not compiled.',
    default: 'default',
    material: 'material',
};

/** A key of the words. */
export type Key = keyof typeof ENGLISH;

const SPANISH: Record<Key, string> = {
    title: 'Un renderizador exacto de esferas y cilindros',
    lead: 'La imagen tiene los bytes que escribe el programa render-aos, calculados en esta página.',
    config: 'Configuración',
    scene: 'Escena',
    picture: 'Imagen',
    examples: 'Ejemplos',
    choose: 'elegir…',
    earlier: 'Mis textos anteriores',
    objects: '{0} {0|objeto|objetos}{1}',
    language: 'Idioma',
    render: 'Renderizar',
    cancel: 'Cancelar',
    live: 'Renderizar tras cada cambio',
    savePpm: 'Guardar PPM',
    savePng: 'Guardar PNG',
    share: 'Crear un enlace',
    link: 'Enlace con los dos textos, los sombreadores cambiados y la vista',
    help: 'Ctrl+Intro renderiza. Ctrl+Espacio muestra las líneas posibles. Escape y después Tab sale de un editor.',
    helpTouch: '«Renderizar» calcula la imagen exacta. Mientras escribe, se muestran las líneas posibles.',
    barEditors: 'Límite entre los editores',
    barColumns: 'Límite entre los textos y la imagen',
    loading: 'Cargando el renderizador…',
    preparing: 'Preparando la escena…',
    rendering: 'Renderizando…',
    cancelled: 'Cancelado.',
    same: 'los bytes de render-aos',
    rows: 'filas',
    seconds: 's',
    shownPart: 'se muestra uno de cada {0} píxeles en cada dirección; se guardan todos',
    faultIn: 'Hay un error en: {0}.',
    oldPicture: 'Los textos han cambiado desde esta imagen. «Renderizar» calcula la nueva.',
    oldViews: 'Lo que se muestra es de textos anteriores.',
    line: 'Línea {0}',
    firstFaults: 'Solo se muestran los {0} primeros errores.',
    failed: 'El renderizador se ha detenido: {0}',
    noModule: 'No se ha podido cargar el renderizador: {0}',
    noExample: 'No se ha podido cargar el ejemplo: {0}',
    badLink: 'No se ha podido leer el enlace; se conservan sus textos.',
    copied: 'El enlace está copiado.',
    made: 'El enlace está abajo.',
    tooLong: 'El enlace tiene {0} caracteres; algunos programas cortan enlaces así.',
    notKept: 'Este navegador no guarda lo que escribe: {0}',
    fileChanged: 'el archivo ha cambiado entretanto. Elija qué texto queda.',
    fileMissing: 'El archivo aún no existe: «Guardar» lo crea.',
    offer: 'Un archivo ha cambiado, y su texto aquí no está guardado.',
    offerTake: 'Tomar el archivo',
    offerKeep: 'Conservar mi texto',
    save: 'Guardar',
    download: 'Descargar',
    unsaved: '● sin guardar',
    saved: '{0} está guardado.',
    notSaved: 'No se ha guardado: {0}',
    reloaded: 'Un archivo ha cambiado y se ha vuelto a cargar.',
    unreachable: 'render-lab view no responde. Lo que escribe se guarda aquí.',
    views: 'Vistas',
    liveView: 'Vista en vivo',
    gpuOpening: 'Abriendo WebGPU…',
    gpuMissing: 'Este navegador no tiene WebGPU.',
    gpuInsecure: 'Un navegador ofrece WebGPU solo a páginas de esta máquina o por HTTPS.',
    gpuNoAdapter: 'Este navegador tiene WebGPU, pero ningún dispositivo gráfico para él.',
    gpuSilent: 'WebGPU no ha respondido en {0} s.',
    gpuLost: 'Se ha perdido el dispositivo gráfico: {0}',
    gpuFailed: 'WebGPU ha fallado: {0}',
    gpuInstead: 'En su lugar, el renderizador exacto (WebAssembly) dibuja una imagen pequeña en la vista en vivo.',
    gpuAgain: 'Probar WebGPU de nuevo',
    liveTake: 'Poner esta vista en la configuración',
    liveSave: 'Guardar la cámara en el archivo',
    liveReset: 'Volver a la cámara del texto',
    liveFixed: 'Luz determinista, para comparar: un rayo por el centro de cada píxel',
    lightFixed: 'luz determinista',
    busy: 'Calculando…',
    liveHelp: 'Arrastrar gira; con Mayús o el botón derecho desplaza; rueda o dos dedos acercan. Un clic en un '
        + 'píxel sigue su camino. Las teclas mueven la cámara: flechas, Mayús+flechas, + y -, Inicio.',
    liveHelpTouch: 'Arrastrar con un dedo gira; con dos, desplaza o acerca. Pulse un píxel para seguir su camino.',
    liveSamples: '{0} {0|muestra|muestras}',
    liveRate: '{0} imágenes/s',
    liveDuration: 'la última imagen tardó {0} s',
    liveInside: 'La cámara está dentro de un objeto ({0}).',
    liveRefused: 'Un sombreador tiene un error; queda la última imagen buena.',
    liveRefusedFirst: 'Un sombreador tiene un error; aún no hay imagen. El editor de sombreadores muestra la línea.',
    directive: 'Un módulo no puede tener directivas, porque otros módulos van antes en un mismo texto. Quítela.',
    liveFault: 'Los textos tienen un error; queda la última imagen buena: {0}',
    liveFaultFirst: 'Los textos tienen un error; aún no hay imagen: {0}',
    liveStopped: 'La vista en vivo se ha detenido: {0}',
    liveTaken: 'La vista está en la configuración. «Renderizar» calcula su imagen exacta.',
    liveSaved: 'La cámara está guardada en el archivo de configuración.',
    compare: 'Comparar',
    compareSlider: 'Límite entre las imágenes',
    compareWith: 'Comparar los sombreadores con',
    compareView: 'Mostrar',
    exactF64: 'el renderizador exacto (f64; casi todo píxel se redondea de otra forma)',
    rustF32: 'Rust, mismos pasos (f32)',
    viewBoth: 'las dos imágenes',
    viewLinear: 'diferencia, lineal',
    viewUlps: 'diferencia, unidades en el último lugar',
    blink: 'Parpadear',
    comparing: 'Comparando…',
    ulps: '{0} {0|unidad|unidades} en el último lugar',
    compareFigures: '{0|Difiere|Difieren} {0} de {1} píxeles, RMSE {2}, como máximo {3}, '
        + '{4} {4|unidad|unidades} en el último lugar.',
    compareMostAt: 'Mayor diferencia: columna {0}, fila {1}',
    compareBlind: 'Esta luz no tiene vectores aleatorios: una fórmula cambiada para ellos solo se ve en la vista en '
        + 'vivo con muestras.',
    compareHelp: 'A la izquierda de la línea: Rust. A la derecha: los sombreadores. '
        + 'Luz determinista: un rayo por el centro de cada píxel. Pulse un píxel para seguir su camino.',
    noCompare: 'Sin WebGPU no hay sombreadores que comparar.',
    fit: 'Ajustar',
    pixelAt: 'columna {0}, fila {1}: {2}',
    compareFiles: 'Comparar archivos…',
    compareClose: 'Volver a los sombreadores',
    filesHelp: 'Dos archivos (PPM, PNG), o uno con la imagen de la primera pestaña.',
    viewHelp: 'También puede soltar archivos en la página. Arrastre la línea; la rueda amplía, y arrastrar con Mayús '
        + 'o el botón derecho desplaza las imágenes.',
    viewHelpTouch: 'Arrastre la línea. Dos dedos amplían y desplazan las imágenes.',
    filesNames: 'A la izquierda: {0}. A la derecha: {1}.',
    filesAccepted: 'El curso acepta esta diferencia: RMSE {2} (menor que 10), como máximo {3} (menor que 150), de 255; '
        + 'un píxel cuenta como la media de sus canales. {0|Difiere|Difieren} {0} de {1} píxeles.',
    filesRefused: 'El curso no acepta esta diferencia: RMSE {2} (debe ser menor que 10), como máximo {3} (debe ser '
        + 'menor que 150), de 255; un píxel cuenta como la media de sus canales. {0|Difiere|Difieren} {0} de '
        + '{1} píxeles.',
    noPicture: 'no es PPM (P3 o P6) ni PNG de 8 bits por canal',
    brokenPicture: 'el archivo termina antes de tiempo, es demasiado grande o tiene otra cosa donde va un número',
    sizesDiffer: '{0} tiene {1} × {2} píxeles, y {3} tiene {4} × {5}. Solo se comparan imágenes de un tamaño.',
    oneFile: 'Un archivo se compara con la imagen de la primera pestaña, que no ha terminado. '
        + 'Espere, o elija dos archivos.',
    planAbove: 'desde arriba: x a la derecha, z hacia abajo',
    planFront: 'en sentido contrario a z: x a la derecha, y hacia arriba',
    planPaths: 'camino según Rust (línea) y según WGSL (trazos)',
    planRust: 'camino según Rust',
    planSame: 'camino según Rust y según WGSL',
    pixel: 'Píxel',
    pixelHelp: 'Pulse un píxel aquí, en la vista en vivo o en la comparación, o escriba su lugar.',
    column: 'Columna',
    row: 'Fila',
    side: 'lado',
    top: 'tapa superior',
    bottom: 'tapa inferior',
    outside: 'desde fuera',
    inside: 'desde dentro',
    range: '{0} (0 a {1})',
    stepAlone: 'paso {0}',
    stepSame: 'paso {0}: no difiere ningún bit',
    stepDiffers: 'paso {0}: {1|difiere|difieren} {1} {1|número|números}',
    scaleLinear: '(escala lineal)',
    scaleLogarithmic: '(escala logarítmica)',
    firstDifference: 'Primera diferencia: paso {0}, {1}',
    noDifference: 'No difiere ningún bit.',
    liveProbe: 'Mostrar lo que los sombreadores dan a probe(valor)',
    probeRange: 'probe de {0} a {1} (escala lineal)',
    shaders: 'Sombreadores (WGSL)',
    shadersChanged: 'cambiados: {0}',
    module: 'Módulo',
    shaderReset: 'Volver al texto original',
    shaderHelp: 'La vista en vivo compila los módulos tras cada pausa. Un comentario crea un control o un selector de color: '
        + 'override gain: f32 = 0.5; // slider 0..1 step .01 — const tint = vec3<real>(1.0, 0.5, 0.2); // color',
    noShaders: 'Sin WebGPU los módulos se guardan, pero no se compilan.',
    default: 'por defecto',
    material: 'material',
};

/** The meanings of the lines of both files in Spanish. The English ones are in the renderer's table. */
const SPANISH_MEANINGS: Record<string, string> = {
    'aspect_ratio:': 'anchura y altura de la imagen, como proporción',
    'image_width:': 'anchura en píxeles; de ella sigue la altura',
    'gamma:': 'corrección gamma: un canal es su media ^ (1 / gamma)',
    'camera_position:': 'lugar de la cámara, en unidades de la escena',
    'camera_target:': 'punto en el centro de la imagen, en unidades de la escena',
    'camera_north:': 'dirección que está arriba en la imagen; de cualquier longitud',
    'field_of_view:': 'apertura vertical de la vista, en grados',
    'samples_per_pixel:': 'rayos por píxel; el ruido baja con su raíz cuadrada',
    'max_depth:': 'rayos que puede enviar una muestra; si el último toca algo, negro',
    'material_rng_seed:': 'semilla de los vectores de dispersión',
    'ray_rng_seed:': 'semilla de los lugares de los rayos en los píxeles',
    'background_dark_color:': 'fondo en vertical hacia arriba (+y)',
    'background_light_color:': 'fondo en vertical hacia abajo (-y)',
    'matte:': 'material que dispersa; reflectancia en [0, 1]',
    'metal:': 'material que refleja; con difusión 0 es un espejo perfecto',
    'refractive:': 'vidrio; índice > 0, el de una ventana es 1.5',
    'sphere:': 'centro, radio > 0, un material definido más arriba',
    'cylinder:': 'centro, radio > 0, eje: tan largo como alto es el cilindro',
};

export type Language = 'en' | 'es';

/** Returns the words of an exception. Those of the browser are in its language. */
export const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

let words: Record<Key, string> = ENGLISH;

/** Returns a number as text. Whole numbers of five digits or more have their digits in groups of three. */
function grouped(value: string | number): string {
    const text = String(value);
    const isLong = typeof value === 'number' && /^\d{5,}$/.test(text);
    return isLong ? text.replace(/\B(?=(\d{3})+$)/g, ofLanguage([',', '\u202f'])) : text;
}

/** Returns the words for `key`, with `values` in the places {0}, {1} and so on. {0|one|many} is one of two words. */
export function say(key: Key, ...values: (string | number)[]): string {
    return words[key].replace(/\{(\d)(?:\|(.*?)\|(.*?))?\}/g, (_, place, one?: string, many?: string) => {
        const value = values[Number(place)] ?? '';
        return one === undefined ? grouped(value) : (value === 1 ? one : many) ?? '';
    });
}

/** The functions that return the texts of elements in the page's language. */
const written = new Map<HTMLElement, () => string>();

/** Writes what `text` returns into an element, and again when the language changes. */
export function write(element: HTMLElement, text: () => string): void {
    written.set(element, text);
    element.textContent = text();
}

/** Returns the one of two texts that is in the page's language. */
export function ofLanguage(texts: readonly [english: string, spanish: string]): string {
    return texts[words === SPANISH ? 1 : 0];
}

/** Returns the meaning of a line in the page's language. */
export function meaningOf(tag: string, english: string): string {
    return words === SPANISH ? SPANISH_MEANINGS[tag] ?? english : english;
}

/** The words of the editors' own parts in Spanish: finding, folding, and for readers of the screen. */
const SPANISH_EDITOR: Record<string, string> = {
    'Find': 'Buscar', 'Replace': 'Reemplazar', 'next': 'siguiente', 'previous': 'anterior', 'all': 'todo',
    'match case': 'mayúsculas', 'regexp': 'expresión regular', 'by word': 'palabra entera', 'replace': 'reemplazar',
    'replace all': 'reemplazar todo', 'close': 'cerrar', 'current match': 'coincidencia actual',
    'on line': 'en la línea',
    'replaced match on line $': 'reemplazado en la línea $', 'replaced $ matches': '$ reemplazos',
    'Go to line': 'Ir a la línea', 'go': 'ir', 'Selection deleted': 'Selección borrada', 'to': 'a',
    'Folded lines': 'Líneas plegadas', 'Unfolded lines': 'Líneas desplegadas', 'folded code': 'líneas plegadas',
    'unfold': 'desplegar', 'Fold line': 'Plegar la línea', 'Unfold line': 'Desplegar la línea',
    'Completions': 'Propuestas',
    'Diagnostics': 'Errores', 'No diagnostics': 'Sin errores', 'Control character': 'Carácter de control',
};

/** Returns the words of the editors' own parts. English ones are those of the editor. */
export const editorWords = (): Record<string, string> => (words === SPANISH ? SPANISH_EDITOR : {});

/**
 * Sets the page's language, and replaces the words of all elements that have `data-words`, and those that {@link write}
 * has written. Then the event `spoken` tells the editors.
 */
export function speak(language: Language): void {
    words = language === 'es' ? SPANISH : ENGLISH;
    document.documentElement.lang = language;
    document.title = words.title;
    for (const element of document.querySelectorAll<HTMLElement>('[data-words]')) {
        element.textContent = words[element.dataset.words as Key];
    }
    for (const [element, text] of written) {
        if (element.isConnected) {
            element.textContent = text();
        } else {
            written.delete(element);
        }
    }
    for (const element of document.querySelectorAll<HTMLElement | SVGElement>('[data-label]')) {
        element.ariaLabel = words[element.dataset.label as Key];
    }
    document.dispatchEvent(new Event('spoken'));
}

// The words of the page in English and Spanish. Messages of the renderer are in English, as its specification says;
// the hints below them are in both languages.

const WORDS = {
    title: ['An exact renderer of spheres and cylinders', 'Un renderizador exacto de esferas y cilindros'],
    lead: ['The picture has the bytes that the program render-aos writes, computed in this page.',
        'La imagen tiene los bytes que escribe el programa render-aos, calculados en esta página.'],
    config: ['Configuration', 'Configuración'],
    scene: ['Scene', 'Escena'],
    picture: ['Picture', 'Imagen'],
    examples: ['Examples', 'Ejemplos'],
    choose: ['choose…', 'elegir…'],
    earlier: ['My earlier texts', 'Mis textos anteriores'],
    objects: ['{0} {0|object|objects}{1}', '{0} {0|objeto|objetos}{1}'],
    language: ['Language', 'Idioma'],
    render: ['Render', 'Renderizar'],
    cancel: ['Cancel', 'Cancelar'],
    live: ['Render after every change', 'Renderizar tras cada cambio'],
    savePpm: ['Save PPM', 'Guardar PPM'],
    savePng: ['Save PNG', 'Guardar PNG'],
    share: ['Make a link', 'Crear un enlace'],
    link: ['Link with both texts, changed shaders and the view',
        'Enlace con los dos textos, los sombreadores cambiados y la vista'],
    help: [
        'Ctrl+Enter renders. Ctrl+Space shows the lines that are possible. Alt and dragging, or Alt and an arrow key, '
        + 'changes a number. Escape, then Tab, leaves an editor.',
        'Ctrl+Intro renderiza. Ctrl+Espacio muestra las líneas posibles. Alt y arrastrar, o Alt y una flecha, cambia un '
        + 'número. Escape y después Tab sale de un editor.'],
    helpTouch: [
        '"Render" makes the exact picture. While you type, the lines that are possible are shown. Tap a number, and drag '
        + 'the handle above it to change it.',
        '«Renderizar» calcula la imagen exacta. Mientras escribe, se muestran las líneas posibles. Toque un número y '
        + 'arrastre el control que aparece encima para cambiarlo.'],
    barEditors: ['Boundary between the editors', 'Límite entre los editores'],
    barColumns: ['Boundary between the texts and the picture', 'Límite entre los textos y la imagen'],
    loading: ['Loading the renderer…', 'Cargando el renderizador…'],
    preparing: ['Preparing the scene…', 'Preparando la escena…'],
    rendering: ['Rendering…', 'Renderizando…'],
    cancelled: ['Cancelled.', 'Cancelado.'],
    same: ['the bytes of render-aos', 'los bytes de render-aos'],
    rows: ['rows', 'filas'],
    timeLeft: ['{0} s left', 'faltan {0} s'],
    seconds: ['s', 's'],
    shownPart: ['one pixel in {0} is shown each way, and all are saved',
        'se muestra uno de cada {0} píxeles en cada dirección; se guardan todos'],
    faultIn: ['There is an error in: {0}.', 'Hay un error en: {0}.'],
    oldPicture: ['The texts have changed since this picture. "Render" makes the new one.',
        'Los textos han cambiado desde esta imagen. «Renderizar» calcula la nueva.'],
    oldViews: ['What is shown belongs to earlier texts.', 'Lo que se muestra es de textos anteriores.'],
    line: ['Line {0}', 'Línea {0}'],
    firstFaults: ['Only the first {0} errors are shown.', 'Solo se muestran los {0} primeros errores.'],
    failed: ['The renderer stopped: {0}', 'El renderizador se ha detenido: {0}'],
    noModule: ['The renderer could not be loaded: {0}', 'No se ha podido cargar el renderizador: {0}'],
    noExample: ['The example could not be loaded: {0}', 'No se ha podido cargar el ejemplo: {0}'],
    badLink: ['The link could not be read, so your own texts stay.',
        'No se ha podido leer el enlace; se conservan sus textos.'],
    copied: ['The link is copied.', 'El enlace está copiado.'],
    made: ['The link is below.', 'El enlace está abajo.'],
    tooLong: ['The link has {0} characters; some programs cut such links.',
        'El enlace tiene {0} caracteres; algunos programas cortan enlaces así.'],
    notKept: ['This browser does not keep what you type: {0}', 'Este navegador no guarda lo que escribe: {0}'],
    fileChanged: ['the file has changed meanwhile. Choose which text stays.',
        'el archivo ha cambiado entretanto. Elija qué texto queda.'],
    fileMissing: ['The file does not exist yet: "Save" creates it.', 'El archivo aún no existe: «Guardar» lo crea.'],
    offer: ['A file has changed, and its text here is not saved.',
        'Un archivo ha cambiado, y su texto aquí no está guardado.'],
    offerTake: ['Take the file', 'Tomar el archivo'],
    offerKeep: ['Keep my text', 'Conservar mi texto'],
    openFiles: ['Open…', 'Abrir…'],
    textTooLarge: ['{0} has more than 16 MiB, so it is not opened.', '{0} tiene más de 16 MiB y no se abre.'],
    unsavedBack: ['Your text is not saved, so Back stays in the page.',
        'Su texto no está guardado, así que Atrás no sale de la página.'],
    depth: ['Depth', 'Distancia'],
    depthUnit: ['distance from the camera, in units of the scene (logarithmic scale)',
        'distancia desde la cámara, en unidades de la escena (escala logarítmica)'],
    normal: ['Normals', 'Normales'],
    normalUnit: ['red: x, green: y, blue: z, from -1 (dark) to 1', 'rojo: x, verde: y, azul: z, de -1 (oscuro) a 1'],
    object: ['Objects', 'Objetos'],
    objectUnit: ['A click goes to the line of the object.', 'Un clic lleva a la línea del objeto.'],
    cost: ['Rays', 'Rayos'],
    costUnit: ['rays of the path through the middle, without scattering',
        'rayos del camino por el centro, sin dispersión'],
    exposure: ['Exposure', 'Exposición'],
    low: ['Smallest value', 'Valor menor'],
    high: ['Largest value', 'Valor mayor'],
    background: ['background', 'fondo'],
    axes: ['In the picture: +x {0}, +y {1}, +z {2}.', 'En la imagen: +x {0}, +y {1}, +z {2}.'],
    axis_r: ['to the right', 'a la derecha'],
    axis_l: ['to the left', 'a la izquierda'],
    axis_u: ['up', 'arriba'],
    axis_d: ['down', 'abajo'],
    axis_n: ['towards you', 'hacia usted'],
    axis_a: ['away from you', 'alejándose'],
    units: ['Lengths have one unit of your choice, and angles are in degrees.',
        'Las longitudes tienen una unidad a su elección; los ángulos van en grados.'],
    filesLink: ['All lines of both files', 'Todas las líneas de los dos archivos'],
    fullScreen: ['Full screen', 'Pantalla completa'],
    save: ['Save', 'Guardar'],
    download: ['Download', 'Descargar'],
    unsaved: ['● not saved', '● sin guardar'],
    saved: ['{0} is saved.', '{0} está guardado.'],
    notSaved: ['Not saved: {0}', 'No se ha guardado: {0}'],
    reloaded: ['A file has changed and was loaded again.', 'Un archivo ha cambiado y se ha vuelto a cargar.'],
    unreachable: ['render-lab view does not answer. What you type is kept here.',
        'render-lab view no responde. Lo que escribe se guarda aquí.'],
    views: ['Views', 'Vistas'],
    liveView: ['Live view', 'En vivo'],
    gpuOpening: ['Opening WebGPU…', 'Abriendo WebGPU…'],
    gpuMissing: ['This browser has no WebGPU.', 'Este navegador no tiene WebGPU.'],
    gpuInsecure: ['A browser offers WebGPU only to pages from this machine or by HTTPS.',
        'Un navegador ofrece WebGPU solo a páginas de esta máquina o por HTTPS.'],
    gpuNoAdapter: ['This browser has WebGPU, but no graphics device for it.',
        'Este navegador tiene WebGPU, pero ningún dispositivo gráfico para él.'],
    gpuSilent: ['WebGPU has not answered within {0} s.', 'WebGPU no ha respondido en {0} s.'],
    gpuLost: ['The graphics device was lost: {0}', 'Se ha perdido el dispositivo gráfico: {0}'],
    gpuFailed: ['WebGPU failed: {0}', 'WebGPU ha fallado: {0}'],
    gpuInstead: ['The exact renderer (WebAssembly) draws a small picture in the live view instead.',
        'En su lugar, el renderizador exacto (WebAssembly) dibuja una imagen pequeña en la vista en vivo.'],
    gpuAgain: ['Try WebGPU again', 'Probar WebGPU de nuevo'],
    liveTake: ['Put this view into the configuration', 'Poner esta vista en la configuración'],
    liveSave: ['Save the camera to the file', 'Guardar la cámara en el archivo'],
    liveReset: ['Back to the camera of the text', 'Volver a la cámara del texto'],
    liveFixed: ['Deterministic light, for comparing: one ray through the middle of each pixel',
        'Luz determinista, para comparar: un rayo por el centro de cada píxel'],
    lightFixed: ['deterministic light', 'luz determinista'],
    busy: ['Calculating…', 'Calculando…'],
    liveHelp: [
        'Drag to turn, with Shift or the right button to move, wheel or two fingers to come closer. Click a pixel '
        + 'to follow its path. The keys move the camera: arrows, Shift+arrows, + and -, Home. '
        + 'Enter follows the pixel in the middle.',
        'Arrastrar gira; con Mayús o el botón derecho desplaza; rueda o dos dedos acercan. Un clic en un píxel '
        + 'sigue su camino. Las teclas mueven la cámara: flechas, Mayús+flechas, + y -, Inicio. '
        + 'Intro sigue el píxel del centro.'],
    liveHelpTouch: [
        'Drag with one finger to turn, with two fingers to move or to come closer. Tap a pixel to follow its path.',
        'Arrastrar con un dedo gira; con dos, desplaza o acerca. Pulse un píxel para seguir su camino.'],
    liveSamples: ['{0} {0|sample|samples}', '{0} {0|muestra|muestras}'],
    liveRate: ['{0} frames/s', '{0} imágenes/s'],
    liveDuration: ['the last frame took {0} s', 'la última imagen tardó {0} s'],
    liveInside: ['The camera is inside an object ({0}).', 'La cámara está dentro de un objeto ({0}).'],
    liveRefused: ['A shader has an error, so the last good picture stays.',
        'Un sombreador tiene un error; queda la última imagen buena.'],
    liveRefusedFirst: ['A shader has an error, so there is no picture yet. The editor of the shaders shows the line.',
        'Un sombreador tiene un error; aún no hay imagen. El editor de sombreadores muestra la línea.'],
    endlessLoop: ['This loop of {0} did not end after 16,777,216 rounds, so it was stopped. Make it end.',
        'Este bucle de {0} no terminó tras 16 777 216 vueltas y se ha detenido. Haga que termine.'],
    directive: ['A module can have no directive, because other modules stand before it in one text. Leave it out.',
        'Un módulo no puede tener directivas, porque otros módulos van antes en un mismo texto. Quítela.'],
    liveFault: ['The texts have an error, so the last good picture stays: {0}',
        'Los textos tienen un error; queda la última imagen buena: {0}'],
    liveFaultFirst: ['The texts have an error, so there is no picture yet: {0}',
        'Los textos tienen un error; aún no hay imagen: {0}'],
    liveStopped: ['The live view stopped: {0}', 'La vista en vivo se ha detenido: {0}'],
    liveTaken: ['The view is in the configuration. "Render" makes its exact picture.',
        'La vista está en la configuración. «Renderizar» calcula su imagen exacta.'],
    liveSaved: ['The camera is saved in the configuration file.',
        'La cámara está guardada en el archivo de configuración.'],
    compare: ['Compare', 'Comparar'],
    compareSlider: ['Boundary between the pictures', 'Límite entre las imágenes'],
    compareWith: ['Compare the shaders with', 'Comparar los sombreadores con'],
    compareView: ['Show', 'Mostrar'],
    exactF64: ['the exact renderer (f64; most pixels round otherwise)',
        'el renderizador exacto (f64; casi todo píxel se redondea de otra forma)'],
    rustF32: ['Rust, same steps (f32)', 'Rust, mismos pasos (f32)'],
    viewBoth: ['both pictures', 'las dos imágenes'],
    viewLinear: ['difference, linear', 'diferencia, lineal'],
    viewUlps: ['difference, last places', 'diferencia, últimos lugares'],
    blink: ['Blink', 'Parpadear'],
    comparing: ['Comparing…', 'Comparando…'],
    ulps: ['{0} {0|unit|units} in the last place', '{0} {0|unidad|unidades} en el último lugar'],
    compareFigures: [
        '{0} of {1} pixels {0|differs|differ}, RMSE {2}, at most {3}, {4} {4|unit|units} in the last place.',
        '{0|Difiere|Difieren} {0} de {1} píxeles, RMSE {2}, como máximo {3}, {4} {4|unidad|unidades} en el último '
        + 'lugar.'],
    compareMostAt: ['Largest difference: column {0}, row {1}', 'Mayor diferencia: columna {0}, fila {1}'],
    compareBlind: [
        'This light has no random vectors, so a changed formula for them shows only in the live view with samples.',
        'Esta luz no tiene vectores aleatorios: una fórmula cambiada para ellos solo se ve en la vista en vivo con '
        + 'muestras.'],
    compareHelp: [
        'Left of the line: by Rust. Right of it: by the shaders. Deterministic light: one ray through the middle '
        + 'of each pixel. Click or tap a pixel to follow its path.',
        'A la izquierda de la línea: Rust. A la derecha: los sombreadores. Luz determinista: un rayo por el centro '
        + 'de cada píxel. Pulse un píxel para seguir su camino.'],
    noCompare: ['Without WebGPU there are no shaders to compare.', 'Sin WebGPU no hay sombreadores que comparar.'],
    fit: ['Fit', 'Ajustar'],
    pixelAt: ['column {0}, row {1}: {2}', 'columna {0}, fila {1}: {2}'],
    compareFiles: ['Compare files…', 'Archivos…'],
    compareClose: ['Back to the shaders', 'Volver a los sombreadores'],
    filesHelp: [
        'Two files (PPM, PNG), or one with the picture of the first tab. "Explain" then tells the pixel that you click.',
        'Dos archivos (PPM, PNG), o uno con la imagen de la primera pestaña. «Explicar» cuenta entonces el píxel en el '
        + 'que pulse.',
    ],
    viewHelp: [
        'Files can also be dropped on the page. Drag the line; the wheel zooms, and a drag with Shift or the right '
        + 'button moves the pictures.',
        'También puede soltar archivos en la página. Arrastre la línea; la rueda amplía, y arrastrar con Mayús o '
        + 'el botón derecho desplaza las imágenes.'],
    viewHelpTouch: ['Drag the line. Two fingers zoom and move the pictures.',
        'Arrastre la línea. Dos dedos amplían y desplazan las imágenes.'],
    filesNames: ['Left: {0}. Right: {1}.', 'A la izquierda: {0}. A la derecha: {1}.'],
    filesAccepted: [
        'The course accepts this difference: RMSE {2} (below 10), at most {3} (below 150), of 255; a pixel counts '
        + 'as the mean of its channels. {0} of {1} pixels {0|differs|differ}.',
        'El curso acepta esta diferencia: RMSE {2} (menor que 10), como máximo {3} (menor que 150), de 255; un '
        + 'píxel cuenta como la media de sus canales. {0|Difiere|Difieren} {0} de {1} píxeles.'],
    filesRefused: [
        'The course does not accept this difference: RMSE {2} (below 10 is needed), at most {3} (below 150 is '
        + 'needed), of 255; a pixel counts as the mean of its channels. {0} of {1} pixels {0|differs|differ}.',
        'El curso no acepta esta diferencia: RMSE {2} (debe ser menor que 10), como máximo {3} (debe ser menor que '
        + '150), de 255; un píxel cuenta como la media de sus canales. {0|Difiere|Difieren} {0} de {1} píxeles.'],
    noPicture: ['this is neither PPM (P3 or P6) nor PNG with 8 bits a channel',
        'no es PPM (P3 o P6) ni PNG de 8 bits por canal'],
    brokenPicture: ['the file ends early, is too large, or has something else where a number belongs',
        'el archivo termina antes de tiempo, es demasiado grande o tiene otra cosa donde va un número'],
    sizesDiffer: ['{0} has {1} × {2} pixels, and {3} has {4} × {5}. Only pictures of one size can be compared.',
        '{0} tiene {1} × {2} píxeles, y {3} tiene {4} × {5}. Solo se comparan imágenes de un tamaño.'],
    oneFile: [
        'One file is compared with the picture of the first tab, which is not finished. Wait, or choose two files.',
        'Un archivo se compara con la imagen de la primera pestaña, que no ha terminado. Espere, o elija dos '
        + 'archivos.'],
    planAbove: ['from above: x to the right, z downwards', 'desde arriba: x a la derecha, z hacia abajo'],
    planFront: ['against z: x to the right, y upwards', 'en sentido contrario a z: x a la derecha, y hacia arriba'],
    planPaths: ['path by Rust (line) and by WGSL (dashes)', 'camino según Rust (línea) y según WGSL (trazos)'],
    planRust: ['path by Rust', 'camino según Rust'],
    planSame: ['path by Rust and by WGSL', 'camino según Rust y según WGSL'],
    pixel: ['Pixel', 'Píxel'],
    pixelHelp: ['Click or tap a pixel here, in the picture, in the live view or in the comparison, or type its place.',
        'Pulse un píxel aquí, en la imagen, en la vista en vivo o en la comparación, o escriba su lugar.'],
    explain: ['Explain', 'Explicar'],
    explainHelp: [
        'How the exact picture computes a pixel, by the steps of the statement. Click the pixel in the picture, or type '
        + 'its place. Of the lambdas in range the smallest is taken. A lambda is in lengths of the direction, which is not '
        + 'made a unit: it is no distance, and the limit 1e-3 is on it. A sphere that the ray\'s line misses is left out.',
        'Cómo calcula la imagen exacta un píxel, según los pasos del enunciado. Pulse el píxel en la imagen o escriba '
        + 'su lugar. De las lambdas en el rango se toma la menor. Una lambda está en longitudes de la dirección, que no '
        + 'se hace unitaria: no es una distancia, y a ella se aplica el límite 1e-3. Falta una esfera que la recta no toca.'],
    sample: ['Sample', 'Muestra'],
    color: ['Colour', 'Color'],
    column: ['Column', 'Columna'],
    row: ['Row', 'Fila'],
    sphere: ['sphere', 'esfera'],
    cylinder: ['cylinder', 'cilindro'],
    side: ['side', 'lado'],
    top: ['top cap', 'tapa superior'],
    bottom: ['bottom cap', 'tapa inferior'],
    outside: ['from outside', 'desde fuera'],
    inside: ['from inside', 'desde dentro'],
    range: ['{0} (0 to {1})', '{0} (0 a {1})'],
    stepAlone: ['step {0}', 'paso {0}'],
    stepSame: ['step {0}: no bit differs', 'paso {0}: no difiere ningún bit'],
    stepDiffers: ['step {0}: {1} {1|number differs|numbers differ}',
        'paso {0}: {1|difiere|difieren} {1} {1|número|números}'],
    scaleLinear: ['(linear scale)', '(escala lineal)'],
    scaleLogarithmic: ['(logarithmic scale)', '(escala logarítmica)'],
    firstDifference: ['First difference: step {0}, {1}', 'Primera diferencia: paso {0}, {1}'],
    noDifference: ['No bit differs.', 'No difiere ningún bit.'],
    liveProbe: ['Show what the shaders give to probe(value)', 'Mostrar lo que los sombreadores dan a probe(valor)'],
    probeRange: ['probe from {0} to {1} (linear scale)', 'probe de {0} a {1} (escala lineal)'],
    shaders: ['Shaders (WGSL)', 'Sombreadores (WGSL)'],
    shadersChanged: ['changed: {0}', 'cambiados: {0}'],
    module: ['Module', 'Módulo'],
    shaderReset: ['Back to the original text', 'Volver al texto original'],
    shaderHelp: [
        'The live view compiles the modules after each pause. A comment makes a slider or a colour picker: '
        + 'override gain: f32 = 0.5; // slider 0..1 step .01 — const tint = vec3<real>(1.0, 0.5, 0.2); // color',
        'La vista en vivo compila los módulos tras cada pausa. Un comentario crea un control o un selector de '
        + 'color: override gain: f32 = 0.5; // slider 0..1 step .01 — const tint = vec3<real>(1.0, 0.5, 0.2); // '
        + 'color'],
    noShaders: ['Without WebGPU the modules are kept but not compiled.',
        'Sin WebGPU los módulos se guardan, pero no se compilan.'],
    default: ['default', 'por defecto'],
    material: ['material', 'material'],
} satisfies Record<string, [english: string, spanish: string]>;

/** A key of the words. */
export type Key = keyof typeof WORDS;

/** The meanings of the lines of both files in Spanish. The English ones are in the renderer's table. */
const SPANISH_MEANINGS: Record<string, string> = {
    'aspect_ratio:': 'anchura y altura de la imagen, como proporción',
    'image_width:': 'anchura en píxeles; de ella sigue la altura',
    'gamma:': 'corrección gamma: un canal es su media ^ (1 / gamma)',
    'camera_position:': 'lugar de la cámara, en unidades de la escena',
    'camera_target:': 'punto en el centro de la imagen, en unidades de la escena',
    'camera_north:': 'dirección que está arriba en la imagen; de cualquier longitud salvo 0',
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

/** The place of the page's language in the pairs of texts: 0 for English, 1 for Spanish. */
let place: 0 | 1 = 0;

/** Returns a number as text. Whole numbers of five digits or more have their digits in groups of three. */
function grouped(value: string | number): string {
    const text = String(value);
    const isLong = typeof value === 'number' && /^\d{5,}$/.test(text);
    return isLong ? text.replace(/\B(?=(\d{3})+$)/g, ofLanguage([',', '\u202f'])) : text;
}

/** Returns the words for `key`, with `values` in the places {0}, {1} and so on. {0|one|many} is one of two words. */
export const say = (key: Key, ...values: (string | number)[]): string => filled(WORDS[key], ...values);

/** Returns the one of two texts that is in the page's language, with `values` as {@link say} has them. */
export function filled(texts: readonly [english: string, spanish: string], ...values: (string | number)[]): string {
    return texts[place].replace(/\{(\d)(?:\|(.*?)\|(.*?))?\}/g, (_, number, one?: string, many?: string) => {
        const value = values[Number(number)] ?? '';
        return one === undefined ? grouped(value) : (value === 1 ? one : many) ?? '';
    });
}

/** Returns a date and a time in the page's language, in the way of the browser's country if both languages are one. */
export function dated(milliseconds: number): string {
    const language = ofLanguage(['en', 'es']);
    return new Date(milliseconds).toLocaleString(navigator.languages.find((one) => one.startsWith(language)) ?? language);
}

/** The functions that return the texts of elements in the page's language. */
const written = new Map<HTMLElement, () => string>();

/** Returns the element of the page with this id. */
export const element = <E extends HTMLElement>(id: string): E => document.getElementById(id) as E;

/** Writes what `text` returns into an element, and again when the language changes. */
export function write(element: HTMLElement, text: () => string): void {
    written.set(element, text);
    element.textContent = text();
}

/** Returns the one of two texts that is in the page's language. */
export function ofLanguage(texts: readonly [english: string, spanish: string]): string {
    return texts[place];
}

/** Returns the meaning of a line in the page's language. */
export function meaningOf(tag: string, english: string): string {
    return place === 1 ? SPANISH_MEANINGS[tag] ?? english : english;
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
export const editorWords = (): Record<string, string> => (place === 1 ? SPANISH_EDITOR : {});

/**
 * Sets the page's language, and replaces the words of all elements that have `data-words`, and those that {@link write}
 * has written. Then the event `spoken` tells the editors.
 */
export function speak(language: Language): void {
    place = language === 'es' ? 1 : 0;
    document.documentElement.lang = language;
    document.title = say('title');
    for (const element of document.querySelectorAll<HTMLElement>('[data-words]')) {
        element.textContent = say(element.dataset.words as Key);
    }
    for (const [element, text] of written) {
        if (element.isConnected) {
            element.textContent = text();
        } else {
            written.delete(element);
        }
    }
    for (const element of document.querySelectorAll<HTMLElement | SVGElement>('[data-label]')) {
        element.ariaLabel = say(element.dataset.label as Key);
    }
    document.dispatchEvent(new Event('spoken'));
}

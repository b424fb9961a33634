<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>Bench</name>
    <message>
        <source>stopped before all was measured</source>
        <translation>detenido antes de haberlo medido todo</translation>
    </message>
    <message>
        <source>no temporary folder can be made: %1. Set TMPDIR to a folder that can be written.</source>
        <translation>no se puede crear una carpeta temporal: %1. Asigne a TMPDIR una carpeta en la que se pueda escribir.</translation>
    </message>
    <message>
        <source>there is no stroke to drag in this painting</source>
        <translation>en esta obra no hay ningún trazo que arrastrar</translation>
    </message>
    <message>
        <source>measuring %1</source>
        <translation>midiendo %1</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nombre</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>comparado</translation>
    </message>
    <message>
        <source>painting</source>
        <translation>obra</translation>
    </message>
    <message>
        <source>size</source>
        <translation>tamaño</translation>
    </message>
    <message>
        <source>backend</source>
        <translation>motor</translation>
    </message>
    <message>
        <source>device</source>
        <translation>dispositivo</translation>
    </message>
    <message>
        <source>median ms</source>
        <translation>mediana ms</translation>
    </message>
    <message>
        <source>min ms</source>
        <translation>mín. ms</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>pasadas</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>proporción</translation>
    </message>
</context>
<context>
    <name>Brushes</name>
    <message>
        <source>Ink wash</source>
        <translation>Aguada de tinta</translation>
    </message>
    <message>
        <source>Watercolour edge</source>
        <translation>Acuarela con borde</translation>
    </message>
    <message>
        <source>Soft airbrush</source>
        <translation>Aerógrafo suave</translation>
    </message>
    <message>
        <source>Flat marker</source>
        <translation>Rotulador plano</translation>
    </message>
    <message>
        <source>Dry chalk</source>
        <translation>Tiza seca</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Lápiz</translation>
    </message>
    <message>
        <source>Brush pen</source>
        <translation>Rotulador pincel</translation>
    </message>
    <message>
        <source>Dry brush</source>
        <translation>Pincel seco</translation>
    </message>
    <message>
        <source>Ink splash</source>
        <translation>Salpicadura de tinta</translation>
    </message>
    <message>
        <source>Broad nib</source>
        <translation>Plumilla ancha</translation>
    </message>
    <message>
        <source>Flat wash</source>
        <translation>Aguada plana</translation>
    </message>
    <message>
        <source>Granulating wash</source>
        <translation>Aguada granulante</translation>
    </message>
    <message>
        <source>Wet in wet</source>
        <translation>Húmedo sobre húmedo</translation>
    </message>
    <message>
        <source>Glaze</source>
        <translation>Veladura</translation>
    </message>
    <message>
        <source>Two tones</source>
        <translation>Dos tonos</translation>
    </message>
    <message>
        <source>Charcoal</source>
        <translation>Carboncillo</translation>
    </message>
    <message>
        <source>Pastel</source>
        <translation>Pastel</translation>
    </message>
    <message>
        <source>Gouache</source>
        <translation>Gouache</translation>
    </message>
    <message>
        <source>Glow</source>
        <translation>Resplandor</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tinta</translation>
    </message>
    <message>
        <source>Watercolour</source>
        <translation>Acuarela</translation>
    </message>
    <message>
        <source>Dry</source>
        <translation>Secos</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Planos</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Aerógrafo</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Otros</translation>
    </message>
    <message>
        <source>Round wash</source>
        <translation>Aguada redonda</translation>
    </message>
</context>
<context>
    <name>Buttons</name>
    <message>
        <source>&amp;OK</source>
        <translation>&amp;Aceptar</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Descartar</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Ce&amp;rrar</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>A&amp;brir</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Sí</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;No</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>A&amp;plicar</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Res&amp;tablecer</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>&amp;Retry</source>
        <translation>R&amp;eintentar</translation>
    </message>
    <message>
        <source>Restore &amp;Defaults</source>
        <translation>&amp;Valores predeterminados</translation>
    </message>
    <message>
        <source>&amp;Show Details...</source>
        <translation>&amp;Mostrar detalles...</translation>
    </message>
    <message>
        <source>&amp;Hide Details...</source>
        <translation>&amp;Ocultar detalles...</translation>
    </message>
</context>
<context>
    <name>ChoosePicture</name>
    <message>
        <source>Pictures</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Pictures and diffusion curves</source>
        <translation>Imágenes y curvas de difusión</translation>
    </message>
</context>
<context>
    <name>Cli</name>
    <message>
        <source>%1: cannot be read (%2). Check the name and its permissions.</source>
        <translation>%1: no se puede leer (%2). Compruebe el nombre y los permisos.</translation>
    </message>
    <message>
        <source>%1: has more than 2 GB; that is more than can be opened</source>
        <translation>%1: ocupa más de 2 GB; es más de lo que se puede abrir</translation>
    </message>
    <message>
        <source>  bytes     %1</source>
        <translation>  bytes     %1</translation>
    </message>
    <message>
        <source>  canvas    %1 × %2</source>
        <translation>  lienzo    %1 × %2</translation>
    </message>
    <message>
        <source>  on paper  %1 × %2 mm, %3 units an inch</source>
        <translation>  en papel  %1 × %2 mm, %3 unidades por pulgada</translation>
    </message>
    <message>
        <source>  strokes   %1</source>
        <translation>  trazos    %1</translation>
    </message>
    <message>
        <source>  segments  %1</source>
        <translation>  segmentos %1</translation>
    </message>
    <message>
        <source>  bounds    none: nothing is painted</source>
        <translation>  límites   ninguno: no hay nada pintado</translation>
    </message>
    <message>
        <source>  bounds    x %1, y %2, %3 × %4</source>
        <translation>  límites   x %1, y %2, %3 × %4</translation>
    </message>
    <message>
        <source>  duration  %1 s</source>
        <translation>  duración  %1 s</translation>
    </message>
    <message>
        <source>  chunk     %1, %2 bytes</source>
        <translation>  bloque    %1, %2 bytes</translation>
    </message>
    <message>
        <source>%1not available: %2</source>
        <translation>%1no disponible: %2</translation>
    </message>
    <message>
        <source>Tells what a painting or a recording holds.</source>
        <translation>Dice qué contiene una obra o una grabación.</translation>
    </message>
    <message>
        <source>Prints JSON (docs/cli.md).</source>
        <translation>Muestra JSON (docs/cli.md).</translation>
    </message>
    <message>
        <source>The backends and devices there are, and why one is missing.</source>
        <translation>Los motores y dispositivos que hay, y por qué falta alguno.</translation>
    </message>
    <message>
        <source>give a file, or --backends</source>
        <translation>indique un archivo, o --backends</translation>
    </message>
    <message>
        <source>draw a painting into an image file</source>
        <translation>dibujar una obra en un archivo de imagen</translation>
    </message>
    <message>
        <source>what a file holds; the backends there are</source>
        <translation>qué contiene un archivo; qué motores hay</translation>
    </message>
    <message>
        <source>between documents, the text form and recordings</source>
        <translation>entre documentos, la forma de texto y grabaciones</translation>
    </message>
    <message>
        <source>what lies at a point of the canvas</source>
        <translation>qué hay en un punto del lienzo</translation>
    </message>
    <message>
        <source>compare the backends with the reference</source>
        <translation>comparar los motores con la referencia</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli COMMAND [options] …</source>
        <translation>Uso: suffuse-cli ORDEN [opciones] …</translation>
    </message>
    <message>
        <source>%1: there is no such command. See suffuse-cli --help.</source>
        <translation>%1: no existe esa orden. Véase suffuse-cli --help.</translation>
    </message>
    <message>
        <source>Shows this help.</source>
        <translation>Muestra esta ayuda.</translation>
    </message>
    <message>
        <source>too few arguments</source>
        <translation>faltan argumentos</translation>
    </message>
    <message>
        <source>one argument too many: %1</source>
        <translation>sobra un argumento: %1</translation>
    </message>
    <message>
        <source>%1: %2. See suffuse-cli %1 --help.</source>
        <translation>%1: %2. Véase suffuse-cli %1 --help.</translation>
    </message>
    <message>
        <source>standard output cannot be written: %1</source>
        <translation>no se puede escribir en la salida estándar: %1</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>dibujando</translation>
    </message>
    <message>
        <source>stopped; nothing was written</source>
        <translation>detenido; no se ha escrito nada</translation>
    </message>
    <message>
        <source>there is not enough memory for %1 × %2 pixels. Choose a smaller size.</source>
        <translation>no hay memoria suficiente para %1 × %2 píxeles. Elija un tamaño menor.</translation>
    </message>
    <message>
        <source>--area %1: give X,Y,W,H in canvas units, W and H above 0</source>
        <translation>--area %1: indique X,Y,W,H en unidades del lienzo, con W y H mayores que 0</translation>
    </message>
    <message>
        <source>--size %1: give WxH or W in pixels, e.g. 1024x768</source>
        <translation>--size %1: indique WxH o W en píxeles, p. ej. 1024x768</translation>
    </message>
    <message>
        <source>--scale %1: give pixels a unit, above 0, e.g. 2</source>
        <translation>--scale %1: indique píxeles por unidad, más de 0, p. ej. 2</translation>
    </message>
    <message>
        <source>a picture of %1 × %2 pixels is too large: at most %3 million pixels. Choose a smaller --size, --scale or --area</source>
        <translation>una imagen de %1 × %2 píxeles es demasiado grande: como máximo, %3 millones de píxeles. Elija un valor menor de --size, --scale o --area</translation>
    </message>
    <message>
        <source>%1 pixels a unit are out of range: 0.001 to 1e9. Choose another --size, --scale or --area</source>
        <translation>%1 píxeles por unidad está fuera del intervalo: de 0.001 a 1e9. Elija otro valor de --size, --scale o --area</translation>
    </message>
    <message>
        <source>give --size or --scale, not both</source>
        <translation>indique --size o --scale, no ambos</translation>
    </message>
    <message>
        <source>--size %1: the picture is scaled uniformly, so a width of %2 has the height %3: use --size %2x%3</source>
        <translation>--size %1: la imagen se escala uniformemente, así que a una anchura de %2 le corresponde la altura %3: use --size %2x%3</translation>
    </message>
    <message>
        <source>--time %1: give a moment in seconds, e.g. 1.5</source>
        <translation>--time %1: indique un momento en segundos, p. ej. 1.5</translation>
    </message>
    <message>
        <source>--backend %1: give auto, cpu, cuda or reference</source>
        <translation>--backend %1: indique auto, cpu, cuda o reference</translation>
    </message>
    <message>
        <source>--threads %1: give a number from 1 to 1024</source>
        <translation>--threads %1: indique un número de 1 a 1024</translation>
    </message>
    <message>
        <source>stroke %1</source>
        <translation>trazo %1</translation>
    </message>
    <message>
        <source>stroke %1, %2</source>
        <translation>trazo %1, %2</translation>
    </message>
    <message>
        <source>
  φ %1   ω̄ %2   φ′ %3   F %4   w %5
  C̄ %6 (red, yellow, blue, opacity)
  after it: RYB %7, RGB %8
</source>
        <translation>
  φ %1   ω̄ %2   φ′ %3   F %4   w %5
  C̄ %6 (rojo, amarillo, azul, opacidad)
  después: RYB %7, RGB %8
</translation>
    </message>
    <message>
        <source>  fill: φ %1, share %2
</source>
        <translation>  relleno: φ %1, parte %2
</translation>
    </message>
    <message>
        <source>  segment %1: φ %2, share %3
</source>
        <translation>  segmento %1: φ %2, parte %3
</translation>
    </message>
    <message>
        <source>at %1, %2, %3 s: paper η %4, background RYB %5, RGB %6
</source>
        <translation>en %1, %2, %3 s: papel η %4, fondo RYB %5, RGB %6
</translation>
    </message>
    <message>
        <source>no stroke reaches this point
</source>
        <translation>ningún trazo llega a este punto
</translation>
    </message>
    <message>
        <source>Tells what lies at a point of the canvas, stroke by stroke from bottom to top. X and Y are in canvas units.</source>
        <translation>Dice qué hay en un punto del lienzo, trazo por trazo de abajo arriba. X e Y van en unidades del lienzo.</translation>
    </message>
    <message>
        <source>The moment, in seconds (default: the end).</source>
        <translation>El momento, en segundos (predeterminado: el final).</translation>
    </message>
    <message>
        <source>%1 %2: give X and Y as numbers, in canvas units</source>
        <translation>%1 %2: indique X e Y como números, en unidades del lienzo</translation>
    </message>
    <message>
        <source>Pixels: WxH, or W alone; scales uniformly.</source>
        <translation>Píxeles: WxH, o solo W; escala uniformemente.</translation>
    </message>
    <message>
        <source>Pixels a canvas unit (default 1).</source>
        <translation>Píxeles por unidad del lienzo (predeterminado: 1).</translation>
    </message>
    <message>
        <source>Part of the canvas, in canvas units (default: all of it).</source>
        <translation>Parte del lienzo, en unidades del lienzo (predeterminado: todo).</translation>
    </message>
    <message>
        <source>The moment that is drawn, in seconds (default: the end).</source>
        <translation>El momento que se dibuja, en segundos (predeterminado: el final).</translation>
    </message>
    <message>
        <source>No background: alpha holds the coverage.</source>
        <translation>Sin fondo: el canal alfa guarda la cobertura.</translation>
    </message>
    <message>
        <source>8, 16, half or float (default: the format&apos;s usual one).</source>
        <translation>8, 16, half o float (predeterminado: lo habitual del formato).</translation>
    </message>
    <message>
        <source>auto, cpu, cuda or reference.</source>
        <translation>auto, cpu, cuda o reference.</translation>
    </message>
    <message>
        <source>Number of threads (default: one a core).</source>
        <translation>Número de hilos (predeterminado: uno por núcleo).</translation>
    </message>
    <message>
        <source>Prints times and counts as JSON.</source>
        <translation>Muestra tiempos y recuentos como JSON.</translation>
    </message>
    <message>
        <source>--depth %1: give 8, 16, half or float</source>
        <translation>--depth %1: indique 8, 16, half o float</translation>
    </message>
    <message>
        <source>Draws a painting or a recording into an image file.</source>
        <translation>Dibuja una obra o una grabación en un archivo de imagen.</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the picture to write</source>
        <translation>falta -o OUT: indique la imagen que se va a escribir</translation>
    </message>
    <message>
        <source>%1 and %2: largest difference R %3, G %4, B %5</source>
        <translation>%1 y %2: mayor diferencia R %3, G %4, B %5</translation>
    </message>
    <message>
        <source>  at pixel %1, %2: RGB %3 and %4</source>
        <translation>  en el píxel %1, %2: RGB %3 y %4</translation>
    </message>
    <message>
        <source>  %1 of %2 pixels over 1/512</source>
        <translation>  %1 de %2 píxeles por encima de 1/512</translation>
    </message>
    <message>
        <source>  %1 pixels that are no numbers</source>
        <translation>  %1 píxeles no son números</translation>
    </message>
    <message>
        <source>%1 and %2: largest difference in 8 bits %3, at pixel %4, %5</source>
        <translation>%1 y %2: mayor diferencia en 8 bits %3, en el píxel %4, %5</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, at %4 s</source>
        <translation>%1, %2 × %3 píxeles, a los %4 s</translation>
    </message>
    <message>
        <source>within the contract</source>
        <translation>dentro de lo acordado</translation>
    </message>
    <message>
        <source>OVER the contract: 1/512 to the reference, 1 level of 8 bits between backends</source>
        <translation>FUERA de lo acordado: 1/512 respecto a la referencia, 1 nivel de 8 bits entre motores</translation>
    </message>
    <message>
        <source>Draws a painting on every backend there is and on the reference, and compares the pictures.</source>
        <translation>Dibuja una obra con cada motor que hay y con la referencia, y compara las imágenes.</translation>
    </message>
    <message>
        <source>Prints the rows as a JSON array.</source>
        <translation>Muestra las filas como una matriz JSON.</translation>
    </message>
    <message>
        <source>Measures on this document instead of a generated painting of figure 11f&apos;s size.</source>
        <translation>Mide con este documento en lugar de una obra generada del tamaño de la figura 11f.</translation>
    </message>
    <message>
        <source>all: every backend that can run here, one after the other.</source>
        <translation>all: cada motor que puede funcionar aquí, uno tras otro.</translation>
    </message>
    <message>
        <source>Numbers of threads; several: full renders with each (default: 1, and one a core).</source>
        <translation>Números de hilos; si son varios, imágenes completas con cada uno (predeterminado: 1, y uno por núcleo).</translation>
    </message>
    <message>
        <source>Pixels: WxH, or W alone (default: 1 px a unit, and full renders at 2.8125 px too).</source>
        <translation>Píxeles: WxH, o solo W (predeterminado: 1 px por unidad, y también imágenes completas a 2.8125 px).</translation>
    </message>
    <message>
        <source>Names of rows, with commas between: takes these only.</source>
        <translation>Nombres de filas separados por comas: solo se usan estas.</translation>
    </message>
    <message>
        <source>Runs a row (default: 9).</source>
        <translation>Pasadas por fila (predeterminado: 9).</translation>
    </message>
    <message>
        <source>Full renders of all thirteen sizes of the paper&apos;s Table 2 too.</source>
        <translation>También imágenes completas en los trece tamaños de la Tabla 2 del artículo.</translation>
    </message>
    <message>
        <source>Range of the generated strokes&apos; spread, in units (default: 6 20).</source>
        <translation>Intervalo de la expansión de los trazos generados, en unidades (predeterminado: 6 20).</translation>
    </message>
    <message>
        <source>Segments of the growth rows (default: 1000,10000,100000).</source>
        <translation>Segmentos de las filas de crecimiento (predeterminado: 1000,10000,100000).</translation>
    </message>
    <message>
        <source>A growth row of 1000000 segments too.</source>
        <translation>También una fila de crecimiento de 1000000 segmentos.</translation>
    </message>
    <message>
        <source>Width of the generated painting&apos;s canvas (default: 1024).</source>
        <translation>Anchura del lienzo de la obra generada (predeterminado: 1024).</translation>
    </message>
    <message>
        <source>Height of the generated painting&apos;s canvas (default: 768).</source>
        <translation>Altura del lienzo de la obra generada (predeterminado: 768).</translation>
    </message>
    <message>
        <source>Scale of the generated strokes (default: width / 1024).</source>
        <translation>Escala de los trazos generados (predeterminado: anchura / 1024).</translation>
    </message>
    <message>
        <source>--%1 %2: give whole numbers from %3 to %4</source>
        <translation>--%1 %2: indique números enteros de %3 a %4</translation>
    </message>
    <message>
        <source>--%1 %2: give a number above 0, at most %3</source>
        <translation>--%1 %2: indique un número mayor que 0, como máximo %3</translation>
    </message>
    <message>
        <source>--spread %1: give two numbers, e.g. --spread 6 20</source>
        <translation>--spread %1: indique dos números, p. ej. --spread 6 20</translation>
    </message>
    <message>
        <source>--devices %1: give all, or leave it out</source>
        <translation>--devices %1: indique all, o no lo ponga</translation>
    </message>
    <message>
        <source>--only %1: the rows are %2</source>
        <translation>--only %1: las filas son %2</translation>
    </message>
    <message>
        <source>Measures how fast this machine draws: the figures of docs/performance.md.</source>
        <translation>Mide lo rápido que dibuja este equipo: las cifras de docs/performance.md.</translation>
    </message>
    <message>
        <source>measure how fast this machine draws</source>
        <translation>medir lo rápido que dibuja este equipo</translation>
    </message>
    <message>
        <source>--devices %1: give all, or a number of GPUs, at least 1</source>
        <translation>--devices %1: indique all, o un número de GPU, al menos 1</translation>
    </message>
    <message>
        <source>--devices is for CUDA: use it with --backend cuda</source>
        <translation>--devices es para CUDA: úselo con --backend cuda</translation>
    </message>
    <message>
        <source>With CUDA: GPUs that share the picture, all or a number (default 1).</source>
        <translation>Con CUDA: las GPU que se reparten la imagen, all o un número (predeterminado: 1).</translation>
    </message>
    <message>
        <source>draw a painting while it is painted, as frames</source>
        <translation>dibujar cómo se pinta una obra, en fotogramas</translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>queda %n s</numerusform>
            <numerusform>quedan %n s</numerusform>
        </translation>
    </message>
    <message>
        <source>Frames a second (default 25).</source>
        <translation>Fotogramas por segundo (predeterminado: 25).</translation>
    </message>
    <message>
        <source>Length in seconds (default 10).</source>
        <translation>Duración en segundos (predeterminado: 10).</translation>
    </message>
    <message>
        <source>Seconds that are kept of a pause in the painting (default 0.5).</source>
        <translation>Segundos que se conservan de una pausa al pintar (predeterminado: 0.5).</translation>
    </message>
    <message>
        <source>With CUDA: GPUs that share the frames, all or a number (default 1).</source>
        <translation>Con CUDA: las GPU que se reparten los fotogramas, all o un número (predeterminado: 1).</translation>
    </message>
    <message>
        <source>--%1 %2: give a number from %3 to 1000000</source>
        <translation>--%1 %2: indique un número de %3 a 1000000</translation>
    </message>
    <message>
        <source>%1 frames are too many: at most %2. Choose a smaller --fps or --duration</source>
        <translation>%1 fotogramas son demasiados: como máximo, %2. Elija un valor menor de --fps o --duration</translation>
    </message>
    <message>
        <source>Draws a painting while it is painted, frame by frame.</source>
        <translation>Dibuja cómo se pinta una obra, fotograma a fotograma.</translation>
    </message>
    <message>
        <source>--brush %1: there is no such brush nor file; choose a file or one of %2</source>
        <translation>--brush %1: no existe ese pincel ni ese archivo; elija un archivo o uno de %2</translation>
    </message>
    <message>
        <source>Frames with their number, film/%05d.png; or film.webp, .webm or .mp4.</source>
        <translation>Fotogramas con su número, film/%05d.png; o film.webp, .webm o .mp4.</translation>
    </message>
    <message>
        <source>WebP: plays once instead of again and again.</source>
        <translation>WebP: se reproduce una vez en lugar de una y otra vez.</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the frames or the film to write</source>
        <translation>falta -o OUT: indique los fotogramas o la película que se van a escribir</translation>
    </message>
    <message>
        <source>Leaves out what lies beside the picture: preview, view, undo history.</source>
        <translation>Omite lo que acompaña a la imagen: vista previa, vista, historial de deshacer.</translation>
    </message>
    <message>
        <source>Of a damaged document takes what is whole, and says what is missing.</source>
        <translation>De un documento dañado toma lo que está intacto y dice qué falta.</translation>
    </message>
    <message>
        <source>%1: is damaged; --salvage writes what is whole of it</source>
        <translation>%1: está dañado; --salvage escribe lo que está intacto</translation>
    </message>
    <message>
        <source>segments added: %1</source>
        <translation>segmentos añadidos: %1</translation>
    </message>
    <message>
        <source>segments removed: %1</source>
        <translation>segmentos quitados: %1</translation>
    </message>
    <message>
        <source>%1 and %2 hold the same painting</source>
        <translation>%1 y %2 contienen la misma obra</translation>
    </message>
    <message>
        <source>%1, segments: %2</source>
        <translation>%1, segmentos: %2</translation>
    </message>
    <message>
        <source>%1: from place %2 to %3</source>
        <translation>%1: del lugar %2 al %3</translation>
    </message>
    <message>
        <source>Compares two paintings and tells what was added, removed and changed from A to B.</source>
        <translation>Compara dos obras y dice qué se ha añadido, quitado y cambiado de A a B.</translation>
    </message>
    <message>
        <source>only one of the two can be standard input</source>
        <translation>solo una de las dos puede ser la entrada estándar</translation>
    </message>
    <message>
        <source>A picture that shows where: B pale, added strokes green, removed ones orange, changed and moved ones blue.</source>
        <translation>Una imagen que muestra dónde: B pálido, trazos añadidos en verde, quitados en naranja, cambiados y movidos en azul.</translation>
    </message>
    <message>
        <source>--%1 is for the picture; give -o OUT too</source>
        <translation>--%1 es para la imagen; indique también -o OUT</translation>
    </message>
    <message>
        <source>preview</source>
        <translation>vista previa</translation>
    </message>
    <message>
        <source>how it was last looked at</source>
        <translation>cómo se vio por última vez</translation>
    </message>
    <message>
        <source>undo history</source>
        <translation>historial de deshacer</translation>
    </message>
    <message>
        <source>colour profile</source>
        <translation>perfil de color</translation>
    </message>
    <message>
        <source>size on paper</source>
        <translation>tamaño en papel</translation>
    </message>
    <message>
        <source>unknown to this version, kept</source>
        <translation>desconocido para esta versión, se conserva</translation>
    </message>
    <message>
        <source>  chunk     %1 at byte %2 is damaged: %3</source>
        <translation>  bloque    %1 en el byte %2 está dañado: %3</translation>
    </message>
    <message>
        <source>  paper     %1</source>
        <translation>  papel     %1</translation>
    </message>
    <message>
        <source>what differs between two paintings, and where</source>
        <translation>en qué se diferencian dos obras, y dónde</translation>
    </message>
    <message>
        <source>what was not saved when the editor ended</source>
        <translation>lo que no estaba guardado cuando terminó el programa</translation>
    </message>
    <message>
        <source>in use by a running Suffuse</source>
        <translation>lo usa un Suffuse en ejecución</translation>
    </message>
    <message>
        <source>There is nothing to recover.
</source>
        <translation>No hay nada que recuperar.
</translation>
    </message>
    <message>
        <source>Lists what was painted and not saved when Suffuse ended unexpectedly, or writes one of it to a file.</source>
        <translation>Enumera lo que se pintó y no se había guardado cuando Suffuse terminó de forma inesperada, o escribe una de esas obras en un archivo.</translation>
    </message>
    <message>
        <source>Lists what there is; the same as no ID.</source>
        <translation>Enumera lo que hay; lo mismo que sin ID.</translation>
    </message>
    <message>
        <source>The file to write: .suffuse or .json.</source>
        <translation>El archivo que se va a escribir: .suffuse o .json.</translation>
    </message>
    <message>
        <source>give an ID and -o OUT, or neither</source>
        <translation>indique un ID y -o OUT, o ninguno de los dos</translation>
    </message>
    <message>
        <source>%1: there is no such journal to recover. See suffuse-cli recover --list.</source>
        <translation>%1: no existe ese diario que recuperar. Véase suffuse-cli recover --list.</translation>
    </message>
    <message>
        <source>The brush that recordings and drawings are painted with: a name, or a brush file.</source>
        <translation>El pincel con que se pintan las grabaciones y los dibujos: un nombre o un archivo de pincel.</translation>
    </message>
    <message>
        <source>%1: is IN itself, which would be lost; give OUT another name</source>
        <translation>%1: es el propio IN, que se perdería; dé a OUT otro nombre</translation>
    </message>
    <message>
        <source>The painting, recording or drawing to read; -: standard input.</source>
        <translation>La obra, grabación o dibujo que se lee; -: entrada estándar.</translation>
    </message>
    <message>
        <source>The painting before; -: standard input.</source>
        <translation>La obra de antes; -: entrada estándar.</translation>
    </message>
    <message>
        <source>The painting after; -: standard input.</source>
        <translation>La obra de después; -: entrada estándar.</translation>
    </message>
    <message>
        <source>How far right of the canvas&apos; left edge, in canvas units.</source>
        <translation>A qué distancia a la derecha del borde izquierdo del lienzo, en unidades del lienzo.</translation>
    </message>
    <message>
        <source>How far below the canvas&apos; upper edge, in canvas units.</source>
        <translation>A qué distancia por debajo del borde superior del lienzo, en unidades del lienzo.</translation>
    </message>
    <message>
        <source>Which one, as the list names it.</source>
        <translation>Cuál, tal como la nombra la lista.</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli %1 [options]</source>
        <translation>Uso: suffuse-cli %1 [opciones]</translation>
    </message>
    <message>
        <source>%1 is given twice; give it once</source>
        <translation>%1 se ha indicado dos veces; indíquelo una sola</translation>
    </message>
    <message>
        <source>--time %1: nothing is painted before %2 s</source>
        <translation>--time %1: no hay nada pintado antes de %2 s</translation>
    </message>
    <message>
        <source>--format is for an OUT of -; the ending of %1 chooses the format</source>
        <translation>--format es para un OUT de -; la terminación de %1 elige el formato</translation>
    </message>
    <message>
        <source>--brush is ignored: the strokes of %1 have their looks already</source>
        <translation>--brush no tiene efecto: los trazos de %1 ya tienen su aspecto</translation>
    </message>
    <message numerus="yes">
        <source>%1: none of its %n stroke(s) is whole; open a backup of it</source>
        <translation>
            <numerusform>%1: su único trazo no está intacto; abra una copia de seguridad</numerusform>
            <numerusform>%1: ninguno de sus %n trazos está intacto; abra una copia de seguridad</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 → %2: %3, %4 removed, %5 changed, %6 moved</source>
        <translation>%1 → %2: %3, %4 quitados, %5 cambiados, %6 movidos</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) added</source>
        <translation>
            <numerusform>%n trazo añadido</numerusform>
            <numerusform>%n trazos añadidos</numerusform>
        </translation>
    </message>
    <message>
        <source>suffuse-cli COMMAND --help lists the options of a command, and so does suffuse-cli help COMMAND. An input of - is standard input.
Exit codes: 0 done, 1 the work failed, 2 wrong usage.</source>
        <translation>suffuse-cli ORDEN --help enumera las opciones de una orden, igual que suffuse-cli help ORDEN. Una entrada de - es la entrada estándar.
Códigos de salida: 0 hecho, 1 el trabajo ha fallado, 2 uso incorrecto.</translation>
    </message>
    <message>
        <source>The file to write: .suffuse or .json; -: standard output.</source>
        <translation>El archivo que se va a escribir: .suffuse o .json; -: salida estándar.</translation>
    </message>
    <message numerus="yes">
        <source>  %n segment(s) with a share below %1 left out (--all)
</source>
        <translation>
            <numerusform>  %n segmento con una parte inferior a %1 omitido (--all)
</numerusform>
            <numerusform>  %n segmentos con una parte inferior a %1 omitidos (--all)
</numerusform>
        </translation>
    </message>
    <message>
        <source>Lists segments with shares below a millionth, too.</source>
        <translation>Enumera también los segmentos con partes inferiores a una millonésima.</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s)</source>
        <translation>
            <numerusform>%n trazo</numerusform>
            <numerusform>%n trazos</numerusform>
        </translation>
    </message>
    <message>
        <source>-o %1: what is recovered is a painting: give a name that ends in .suffuse or .json. suffuse-cli render draws it then</source>
        <translation>-o %1: lo que se recupera es una obra: indique un nombre que termine en .suffuse o .json. Después, suffuse-cli render la dibuja</translation>
    </message>
    <message>
        <source>The picture: .png, .tiff, .exr, .jpg, .webp or .pfm; .ora or .psd: its layers; -: standard output.</source>
        <translation>La imagen: .png, .tiff, .exr, .jpg, .webp o .pfm; .ora o .psd: sus capas; -: salida estándar.</translation>
    </message>
    <message>
        <source>With -o -: png, tiff, exr, jpg, webp or pfm (default: png).</source>
        <translation>Con -o -: png, tiff, exr, jpg, webp o pfm (predeterminado: png).</translation>
    </message>
    <message>
        <source>Of JPEG and WebP, 1 to 100 (default 92); WebP loses nothing at 100.</source>
        <translation>De JPEG y WebP, de 1 a 100 (predeterminado: 92); con 100, WebP no pierde nada.</translation>
    </message>
    <message>
        <source>Pixels an inch, as the file says it (default: what makes the picture as large on paper as IN says that it is; else it says nothing).</source>
        <translation>Píxeles por pulgada que indica el archivo (predeterminado: los que dan a la imagen el tamaño en papel que dice IN; si no lo dice, ninguno).</translation>
    </message>
    <message>
        <source>--format is for -o -; the ending of %1 chooses the format</source>
        <translation>--format es para -o -; la terminación de %1 elige el formato</translation>
    </message>
    <message>
        <source>--stats and -o - both write to standard output; give one</source>
        <translation>--stats y -o - escriben ambos en la salida estándar; indique solo uno</translation>
    </message>
    <message>
        <source>standard output is a terminal, which shows no pictures; lead it into a file or a program</source>
        <translation>la salida estándar es un terminal, que no muestra imágenes; diríjala a un archivo o a un programa</translation>
    </message>
    <message>
        <source>--format %1: give one of %2</source>
        <translation>--format %1: indique uno de %2</translation>
    </message>
    <message>
        <source>--quality %1: give a whole number from 1 to 100</source>
        <translation>--quality %1: indique un número entero de 1 a 100</translation>
    </message>
    <message>
        <source>--quality is ignored: %1 loses nothing</source>
        <translation>--quality no tiene efecto: %1 no pierde nada</translation>
    </message>
    <message>
        <source>--dpi %1: give a number from 1 to 10000, e.g. 300</source>
        <translation>--dpi %1: indique un número de 1 a 10000, p. ej. 300</translation>
    </message>
    <message>
        <source>--dpi is ignored: %1 files hold no resolution</source>
        <translation>--dpi no tiene efecto: los archivos %1 no guardan la resolución</translation>
    </message>
    <message>
        <source>  segment %1 fades: φ %2, which leaves %3
</source>
        <translation>  el segmento %1 atenúa: φ %2, queda %3
</translation>
    </message>
    <message>
        <source>  segment %1 lifts: φ %2, share %3
</source>
        <translation>  el segmento %1 levanta: φ %2, parte %3
</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>sin título</translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, is missing or of another version, so texts are left out; install Suffuse again, with what suffuse-cli recommends</source>
        <translation>una parte de Suffuse, %1, falta o es de otra versión, así que se omiten los textos; vuelva a instalar Suffuse, con lo que recomienda suffuse-cli</translation>
    </message>
    <message>
        <source>  groups    %1</source>
        <translation>  grupos    %1</translation>
    </message>
    <message>
        <source>%1 of them blending</source>
        <translation>%1 de ellos con fusión</translation>
    </message>
    <message>
        <source>%1 clipped</source>
        <translation>%1 recortados</translation>
    </message>
    <message>
        <source>%1 masking</source>
        <translation>%1 como máscara</translation>
    </message>
    <message>
        <source>%1 a wash</source>
        <translation>%1 como aguada</translation>
    </message>
    <message>
        <source>--transparent: the background is a layer of its own, which other programs can hide</source>
        <translation>--transparent: el fondo es una capa propia, que otros programas pueden ocultar</translation>
    </message>
    <message>
        <source>--depth %1: layers have 8 or 16 bits</source>
        <translation>--depth %1: las capas tienen 8 o 16 bits</translation>
    </message>
    <message>
        <source>--%1 is ignored: it is not for layered files</source>
        <translation>--%1 no tiene efecto: no es para archivos con capas</translation>
    </message>
    <message>
        <source>drawing layers</source>
        <translation>dibujando capas</translation>
    </message>
    <message>
        <source>there is not enough memory for layers of %1 × %2 pixels. Choose a smaller size.</source>
        <translation>no hay memoria suficiente para capas de %1 × %2 píxeles. Elija un tamaño menor.</translation>
    </message>
    <message numerus="yes">
        <source>%n group(s) would look otherwise in other programs; their layers show what they make of the picture instead</source>
        <translation>
            <numerusform>%n grupo se vería distinto en otros programas; en su lugar, su capa muestra lo que el grupo hace de la imagen</numerusform>
            <numerusform>%n grupos se verían distintos en otros programas; en su lugar, sus capas muestran lo que los grupos hacen de la imagen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 shown alone</source>
        <translation>%1 en solitario</translation>
    </message>
    <message>
        <source>%1 a draft</source>
        <translation>%1 como borrador</translation>
    </message>
    <message>
        <source>  pictures  %1</source>
        <translation>  imágenes  %1</translation>
    </message>
    <message>
        <source>Draws groups that are drafts, too.</source>
        <translation>Dibuja también los grupos que son borradores.</translation>
    </message>
    <message>
        <source>%1: unknown ending; use .suffuse, .json, .svg, .svgz or .pdf</source>
        <translation>%1: terminación desconocida; use .suffuse, .json, .svg, .svgz o .pdf</translation>
    </message>
    <message>
        <source>Converts between documents (.suffuse) and the text form (.json), and from pen recordings and drawings, and to drawings (.svg, .svgz, .pdf). What IN is, is found from its content; what OUT is, from its ending.</source>
        <translation>Convierte entre documentos (.suffuse) y la forma de texto (.json), desde grabaciones de lápiz y dibujos, y a dibujos (.svg, .svgz, .pdf). Qué es IN se deduce de su contenido; qué es OUT, de su terminación.</translation>
    </message>
    <message>
        <source>--format %1: give suffuse, json, svg or pdf</source>
        <translation>--format %1: indique suffuse, json, svg o pdf</translation>
    </message>
    <message>
        <source>Where OUT is -: suffuse, json, svg or pdf (default: json).</source>
        <translation>Si OUT es -: suffuse, json, svg o pdf (predeterminado: json).</translation>
    </message>
    <message>
        <source>--%1 is for drawings; give OUT the ending .svg or .pdf</source>
        <translation>--%1 es para dibujos; dé a OUT la terminación .svg o .pdf</translation>
    </message>
    <message>
        <source>--as %1: give outlines, bands or hybrid</source>
        <translation>--as %1: indique outlines, bands o hybrid</translation>
    </message>
    <message>
        <source>--bands %1: give a whole number from 1 to %2</source>
        <translation>--bands %1: indique un número entero de 1 a %2</translation>
    </message>
    <message>
        <source>--bands is for --as bands; leave one of them out</source>
        <translation>--bands es para --as bands; quite uno de los dos</translation>
    </message>
    <message>
        <source>Where OUT is a drawing (.svg, .svgz, .pdf): outlines (a path a stroke), bands (contours within each other, as opaque as the paint; the default) or hybrid (the exact picture under unpainted outlines).</source>
        <translation>Si OUT es un dibujo (.svg, .svgz, .pdf): outlines (un trayecto por trazo), bands (contornos unos dentro de otros, tan opacos como la pintura; el predeterminado) o hybrid (la imagen exacta bajo contornos sin pintar).</translation>
    </message>
    <message>
        <source>How many bands full opacity has, 1 to 256 (default: 16).</source>
        <translation>Cuántas bandas tiene la opacidad total, de 1 a 256 (predeterminado: 16).</translation>
    </message>
    <message>
        <source>The moment that is drawn, in seconds (default: all dried).</source>
        <translation>El momento que se dibuja, en segundos (predeterminado: todo seco).</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Dibujo</translation>
    </message>
    <message>
        <source>ICC profile of RGB colours that the file has (default: sRGB).</source>
        <translation>Perfil ICC de colores RGB que tiene el archivo (predeterminado: sRGB).</translation>
    </message>
    <message>
        <source>--profile %1: %2; give an ICC profile of RGB colours</source>
        <translation>--profile %1: %2; indique un perfil ICC de colores RGB</translation>
    </message>
    <message>
        <source>Where OUT is a PDF: A3, A4, A5, Letter, or a size such as 200x150mm or 8x6in, into which the sheet fits (default: the sheet as large as it is on paper; where that is not said, 96 units are an inch).</source>
        <translation>Si OUT es un PDF: A3, A4, A5, Letter o un tamaño como 200x150mm u 8x6in, en el que cabe la hoja (predeterminado: la hoja, tan grande como es en papel; si no se dice, 96 unidades son una pulgada).</translation>
    </message>
    <message>
        <source>--page is for PDF; give OUT the ending .pdf</source>
        <translation>--page es para PDF; dé a OUT la terminación .pdf</translation>
    </message>
    <message>
        <source>--page %1: give A3, A4, A5, Letter, or a size such as 200x150mm or 8x6in</source>
        <translation>--page %1: indique A3, A4, A5, Letter o un tamaño como 200x150mm u 8x6in</translation>
    </message>
    <message>
        <source>several INs become the pages of a PDF; give OUT the ending .pdf</source>
        <translation>varios IN se convierten en las páginas de un PDF; dé a OUT la terminación .pdf</translation>
    </message>
    <message>
        <source>%1 is a picture: suffuse-cli render IN -o OUT writes pictures</source>
        <translation>%1 es una imagen: las imágenes las escribe suffuse-cli render IN -o OUT</translation>
    </message>
    <message>
        <source>The painting to write: .suffuse or .json.</source>
        <translation>La obra que se va a escribir: .suffuse o .json.</translation>
    </message>
    <message>
        <source>At most so many strokes (default 512).</source>
        <translation>Como máximo, tantos trazos (predeterminado: 512).</translation>
    </message>
    <message>
        <source>At most so many numbers, 27 for each stroke.</source>
        <translation>Como máximo, tantos números, 27 por trazo.</translation>
    </message>
    <message>
        <source>As many strokes as this root mean square error needs, in 255ths.</source>
        <translation>Tantos trazos como requiera esta media cuadrática del error, sobre 255.</translation>
    </message>
    <message>
        <source>So many paints, which become linked swatches.</source>
        <translation>Tantas pinturas, que pasan a ser muestras vinculadas.</translation>
    </message>
    <message>
        <source>feathering (default), uniform or edge.</source>
        <translation>feathering (predeterminado), uniform o edge.</translation>
    </message>
    <message>
        <source>No stroke is narrower, pixels of PICTURE.</source>
        <translation>Ningún trazo es más estrecho, en píxeles de PICTURE.</translation>
    </message>
    <message>
        <source>No stroke is wider, pixels of PICTURE.</source>
        <translation>Ningún trazo es más ancho, en píxeles de PICTURE.</translation>
    </message>
    <message>
        <source>Another picture, white where PICTURE counts and black where not.</source>
        <translation>Otra imagen, blanca donde PICTURE cuenta y negra donde no.</translation>
    </message>
    <message>
        <source>The share of the error as people see it, 0 (default) to 1.</source>
        <translation>La parte del error tal como lo ven las personas, de 0 (predeterminado) a 1.</translation>
    </message>
    <message>
        <source>Goes on with a painting that was fitted before.</source>
        <translation>Continúa con una obra que ya se ajustó antes.</translation>
    </message>
    <message>
        <source>How many steps (default 1200).</source>
        <translation>Cuántos pasos (predeterminado: 1200).</translation>
    </message>
    <message>
        <source>PICTURE is averaged down to so many pixels (default 600000).</source>
        <translation>PICTURE se promedia hasta tantos píxeles (predeterminado: 600000).</translation>
    </message>
    <message>
        <source>Other numbers give other strokes (default 1).</source>
        <translation>Otros números dan otros trazos (predeterminado: 1).</translation>
    </message>
    <message>
        <source>Prints how near the painting comes, as JSON (docs/cli.md).</source>
        <translation>Muestra cuánto se acerca la obra, como JSON (docs/cli.md).</translation>
    </message>
    <message>
        <source>--%1 %2: give a whole number from %3 to %4</source>
        <translation>--%1 %2: indique un número entero de %3 a %4</translation>
    </message>
    <message>
        <source>--%1 %2: give a number from %3 to %4</source>
        <translation>--%1 %2: indique un número de %3 a %4</translation>
    </message>
    <message>
        <source>--style %1: give feathering, uniform or edge</source>
        <translation>--style %1: indique feathering, uniform o edge</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the painting to write</source>
        <translation>falta -o OUT: indique la obra que se va a escribir</translation>
    </message>
    <message>
        <source>%1: unknown ending; use .suffuse or .json</source>
        <translation>%1: terminación desconocida; use .suffuse o .json</translation>
    </message>
    <message>
        <source>--strokes and --numbers say the same; give one of them</source>
        <translation>--strokes y --numbers dicen lo mismo; indique solo uno</translation>
    </message>
    <message>
        <source>--style goes without --from, whose strokes have a style already</source>
        <translation>--style va sin --from, cuyos trazos ya tienen un estilo</translation>
    </message>
    <message>
        <source>--greatest-width %1 is below --least-width %2</source>
        <translation>--greatest-width %1 es menor que --least-width %2</translation>
    </message>
    <message>
        <source>%1: is a painting already; draw it with suffuse-cli render first</source>
        <translation>%1: ya es una obra; dibújela antes con suffuse-cli render</translation>
    </message>
    <message>
        <source>%1: there is no folder %2</source>
        <translation>%1: no existe la carpeta %2</translation>
    </message>
    <message>
        <source>%1: cannot be written</source>
        <translation>%1: no se puede escribir</translation>
    </message>
    <message>
        <source>fitting</source>
        <translation>ajustando</translation>
    </message>
    <message>
        <source>stopped; %1 has the strokes so far, and --from %1 goes on</source>
        <translation>detenido; %1 tiene los trazos hechos hasta ahora, y --from %1 continúa</translation>
    </message>
    <message>
        <source>Makes strokes that look like a picture, from the back to the front and large before small.</source>
        <translation>Hace trazos que se parecen a una imagen, de atrás hacia delante y los grandes antes que los pequeños.</translation>
    </message>
    <message>
        <source>there is not enough memory to fit %1. Choose fewer --pixels.</source>
        <translation>no hay memoria suficiente para ajustar %1. Elija menos --pixels.</translation>
    </message>
    <message>
        <source>make a painting of a picture</source>
        <translation>hacer una obra a partir de una imagen</translation>
    </message>
    <message>
        <source>--strokes goes with --fit, which makes strokes of a picture</source>
        <translation>--strokes va con --fit, que hace trazos a partir de una imagen</translation>
    </message>
    <message>
        <source>--%1 says nothing of a picture that is fitted; leave it out</source>
        <translation>--%1 no dice nada de una imagen que se ajusta; quítelo</translation>
    </message>
    <message>
        <source>--fit takes one IN at a time</source>
        <translation>--fit admite un solo IN a la vez</translation>
    </message>
    <message>
        <source>Solves the diffusion curves of IN, or reads its picture, and makes strokes that look like it, as suffuse-cli fit does.</source>
        <translation>Resuelve las curvas de difusión de IN, o lee su imagen, y hace trazos que se le parecen, como hace suffuse-cli fit.</translation>
    </message>
    <message>
        <source>With --fit: at most so many strokes (default 512).</source>
        <translation>Con --fit: como máximo, tantos trazos (predeterminado: 512).</translation>
    </message>
    <message>
        <source>Also writes the picture that is fitted, as it was read, averaged or solved.</source>
        <translation>Escribe también la imagen que se ajusta, tal como se leyó, promedió o resolvió.</translation>
    </message>
    <message>
        <source>--target %1: unknown ending; use one of %2</source>
        <translation>--target %1: terminación desconocida; use una de %2</translation>
    </message>
    <message>
        <source>The picture to read: PNG, JPEG, TIFF, EXR, WebP or diffusion curves (XML); -: standard input.</source>
        <translation>La imagen que se lee: PNG, JPEG, TIFF, EXR, WebP o curvas de difusión (XML); -: entrada estándar.</translation>
    </message>
    <message>
        <source>make fewer strokes that look like those of a painting</source>
        <translation>hacer menos trazos que se parezcan a los de una obra</translation>
    </message>
    <message>
        <source>The strokes to make anew, by their ids, such as 3,7,20-180 (default: all).</source>
        <translation>Los trazos que se rehacen, por sus identificadores, como 3,7,20-180 (predeterminado: todos).</translation>
    </message>
    <message>
        <source>All strokes of the group of that name, in place of --select.</source>
        <translation>Todos los trazos del grupo de ese nombre, en lugar de --select.</translation>
    </message>
    <message>
        <source>A picture, or another painting, that the whole is to look like (default: as it does).</source>
        <translation>Una imagen, u otra obra, a la que debe parecerse el conjunto (predeterminado: como está).</translation>
    </message>
    <message>
        <source>At most so many strokes (default: a quarter of those before).</source>
        <translation>Como máximo, tantos trazos (predeterminado: un cuarto de los de antes).</translation>
    </message>
    <message>
        <source>What the strokes reach is fitted at so many pixels (default 600000).</source>
        <translation>Lo que alcanzan los trazos se ajusta con tantos píxeles (predeterminado: 600000).</translation>
    </message>
    <message>
        <source>Says how near the painting comes as JSON (docs/cli.md).</source>
        <translation>Dice cuánto se acerca la obra como JSON (docs/cli.md).</translation>
    </message>
    <message>
        <source>--select and --layer both say which strokes; give one of them</source>
        <translation>--select y --layer dicen ambos qué trazos; indique solo uno</translation>
    </message>
    <message>
        <source>--select %1: give ids of strokes, such as 3,7,20-180</source>
        <translation>--select %1: indique identificadores de trazos, como 3,7,20-180</translation>
    </message>
    <message>
        <source>--select %1: there is no stroke %2; suffuse-cli convert IN OUT.json shows the ids</source>
        <translation>--select %1: no existe el trazo %2; suffuse-cli convert IN OUT.json muestra los identificadores</translation>
    </message>
    <message>
        <source>--layer %1: several groups have that name; rename one of them</source>
        <translation>--layer %1: varios grupos tienen ese nombre; cambie el nombre de alguno</translation>
    </message>
    <message>
        <source>--layer %1: there is no group of that name</source>
        <translation>--layer %1: no existe ningún grupo con ese nombre</translation>
    </message>
    <message>
        <source>%1: is empty</source>
        <translation>%1: está vacío</translation>
    </message>
    <message>
        <source>%1 strokes in place of %2. Where they are seen, the picture is %3 of 255 from what it should be (root mean square), %4 at most.</source>
        <translation>%1 trazos en lugar de %2. Donde se ven, la imagen se aparta %3 de 255 de lo que debería ser (media cuadrática), %4 como máximo.</translation>
    </message>
    <message>
        <source>Before it was %1, %2 at most.</source>
        <translation>Antes era %1, %2 como máximo.</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) that lay between them lie below now.</source>
        <translation>
            <numerusform>%n trazo que estaba entre ellos está ahora debajo.</numerusform>
            <numerusform>%n trazos que estaban entre ellos están ahora debajo.</numerusform>
        </translation>
    </message>
    <message>
        <source>Makes fewer strokes that look like those of a painting, or makes them look like a picture, and says how near they come.</source>
        <translation>Hace menos trazos que se parecen a los de una obra, o hace que se parezcan a una imagen, y dice cuánto se acercan.</translation>
    </message>
    <message>
        <source>a small picture of a painting, for file managers</source>
        <translation>una imagen pequeña de una obra, para gestores de archivos</translation>
    </message>
    <message>
        <source>The painting, recording or drawing to read.</source>
        <translation>La obra, grabación o dibujo que se lee.</translation>
    </message>
    <message>
        <source>The PNG file to write; -: standard output.</source>
        <translation>El archivo PNG que se va a escribir; -: salida estándar.</translation>
    </message>
    <message>
        <source>So many pixels a side at most, 1 to 1024.</source>
        <translation>Como máximo, tantos píxeles por lado, de 1 a 1024.</translation>
    </message>
    <message>
        <source>Writes a small picture of a painting as a PNG file: the preview in the file, if it has one. File managers call this.</source>
        <translation>Escribe una imagen pequeña de una obra como archivo PNG: la vista previa del archivo, si la tiene. Los gestores de archivos llaman a esta orden.</translation>
    </message>
    <message>
        <source>%1: give SIDE as a whole number of pixels from 1 to %2</source>
        <translation>%1: indique SIDE como un número entero de píxeles de 1 a %2</translation>
    </message>
    <message>
        <source>%1 of %2 pieces are there</source>
        <translation>%1 de %2 piezas están listas</translation>
    </message>
    <message>
        <source>%1: frames %2 are missing</source>
        <translation>%1: faltan los fotogramas %2</translation>
    </message>
    <message>
        <source>%1: sheets %2 are missing</source>
        <translation>%1: faltan los pliegos %2</translation>
    </message>
    <message>
        <source>%1: two workers made different bits of piece %2. One of the machines is faulty: find it by the names in %3, remove its journal there, and run the tasks again.</source>
        <translation>%1: dos procesos han producido bits distintos de la pieza %2. Uno de los equipos falla: búsquelo por los nombres en %3, quite allí su diario y vuelva a ejecutar las tareas.</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>leyendo</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>detenido</translation>
    </message>
    <message>
        <source>joining</source>
        <translation>uniendo</translation>
    </message>
    <message>
        <source>%1: sheet %2 cannot be read any more. Run the tasks again.</source>
        <translation>%1: el pliego %2 ya no se puede leer. Vuelva a ejecutar las tareas.</translation>
    </message>
    <message>
        <source>Says what is missing, by what workers wrote down.</source>
        <translation>Dice qué falta, según lo que anotaron los procesos.</translation>
    </message>
    <message>
        <source>Says what is missing or damaged, by reading all of it.</source>
        <translation>Dice qué falta o está dañado, leyéndolo todo.</translation>
    </message>
    <message>
        <source>Puts the pictures together, once all is there and whole.</source>
        <translation>Une las imágenes, una vez que todo está y está intacto.</translation>
    </message>
    <message>
        <source>Nothing was joined. Run the tasks again: they draw what is missing.</source>
        <translation>No se ha unido nada. Vuelva a ejecutar las tareas: dibujan lo que falta.</translation>
    </message>
    <message>
        <source>say what is to be drawn, in a shared folder</source>
        <translation>decir qué hay que dibujar, en una carpeta compartida</translation>
    </message>
    <message>
        <source>draw a part of it, on any machine</source>
        <translation>dibujar una parte, en cualquier equipo</translation>
    </message>
    <message>
        <source>what is missing</source>
        <translation>qué falta</translation>
    </message>
    <message>
        <source>read all that is there, and compare the hashes</source>
        <translation>leer todo lo que hay y comparar los hashes</translation>
    </message>
    <message>
        <source>put the pictures together</source>
        <translation>unir las imágenes</translation>
    </message>
    <message>
        <source>submit the work as a job array of Slurm</source>
        <translation>enviar el trabajo como matriz de trabajos de Slurm</translation>
    </message>
    <message>
        <source>print the work as an Open Job Description</source>
        <translation>mostrar el trabajo como Open Job Description</translation>
    </message>
    <message>
        <source>print the work as a job type of Flamenco</source>
        <translation>mostrar el trabajo como tipo de trabajo de Flamenco</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli farm COMMAND [options] …</source>
        <translation>Uso: suffuse-cli farm ORDEN [opciones] …</translation>
    </message>
    <message>
        <source>farm %1: there is no such command. See suffuse-cli farm --help.</source>
        <translation>farm %1: no existe esa orden. Véase suffuse-cli farm --help.</translation>
    </message>
    <message>
        <source>Into how many tasks the work is divided (default: one for 64 pieces).</source>
        <translation>En cuántas tareas se divide el trabajo (predeterminado: una por cada 64 piezas).</translation>
    </message>
    <message>
        <source>--tasks %1: give a whole number, at least 1</source>
        <translation>--tasks %1: indique un número entero, al menos 1</translation>
    </message>
    <message>
        <source>sbatch cannot be started: install Slurm (slurm-client), or use --write-only</source>
        <translation>no se puede iniciar sbatch: instale Slurm (slurm-client) o use --write-only</translation>
    </message>
    <message>
        <source>Submits the tasks as a job array, and the joining after it.</source>
        <translation>Envía las tareas como matriz de trabajos y, tras ella, la unión.</translation>
    </message>
    <message>
        <source>Cores of each task (default 2).</source>
        <translation>Núcleos de cada tarea (predeterminado: 2).</translation>
    </message>
    <message>
        <source>Writes the scripts, and submits nothing.</source>
        <translation>Escribe los scripts y no envía nada.</translation>
    </message>
    <message>
        <source>--cpus %1: give a whole number, at least 1</source>
        <translation>--cpus %1: indique un número entero, al menos 1</translation>
    </message>
    <message>
        <source>job %1: %2 tasks; job %3 joins what they draw</source>
        <translation>trabajo %1: %2 tareas; el trabajo %3 une lo que dibujan</translation>
    </message>
    <message>
        <source>Prints a job template of the Open Job Description.</source>
        <translation>Muestra una plantilla de trabajo de Open Job Description.</translation>
    </message>
    <message>
        <source>Prints a job type of Flamenco 3 for its folder of scripts.</source>
        <translation>Muestra un tipo de trabajo de Flamenco 3 para su carpeta de scripts.</translation>
    </message>
    <message>
        <source>%1: the plan is damaged, or of another version; make it anew</source>
        <translation>%1: el plan está dañado o es de otra versión; hágalo de nuevo</translation>
    </message>
    <message>
        <source>the plan is damaged; make it anew</source>
        <translation>el plan está dañado; hágalo de nuevo</translation>
    </message>
    <message>
        <source>%1: there is another plan already. Remove the folder, or choose another one.</source>
        <translation>%1: ya hay otro plan. Quite la carpeta o elija otra.</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made. Choose another one, or change its permissions.</source>
        <translation>%1: no se puede crear la carpeta. Elija otra o cambie sus permisos.</translation>
    </message>
    <message>
        <source>%1: there is something else already. Remove it, or choose another name.</source>
        <translation>%1: ya hay otra cosa. Quítela o elija otro nombre.</translation>
    </message>
    <message>
        <source>%1: there is no plan (%2). Is the shared folder there? farm plan makes one.</source>
        <translation>%1: no hay ningún plan (%2). ¿Está ahí la carpeta compartida? farm plan crea uno.</translation>
    </message>
    <message>
        <source>%1: the folder is gone. Is the shared folder there?</source>
        <translation>%1: la carpeta ha desaparecido. ¿Está ahí la carpeta compartida?</translation>
    </message>
    <message>
        <source>The folder of the farm, which all machines share.</source>
        <translation>La carpeta de la granja, que comparten todos los equipos.</translation>
    </message>
    <message>
        <source>Frames of the paintings being painted: name%05d.png; of several, %s is the painting&apos;s name.</source>
        <translation>Fotogramas de cómo se pintan las obras: name%05d.png; si son varias, %s es el nombre de la obra.</translation>
    </message>
    <message>
        <source>Tiles of a Deep Zoom: jpg or png.</source>
        <translation>Teselas de un Deep Zoom: jpg o png.</translation>
    </message>
    <message>
        <source>8 or 16 bits (default 8).</source>
        <translation>8 o 16 bits (predeterminado: 8).</translation>
    </message>
    <message>
        <source>Of JPEG and WebP, 1 to 100.</source>
        <translation>De JPEG y WebP, de 1 a 100.</translation>
    </message>
    <message>
        <source>a farm draws numbered frames, name%05d.png</source>
        <translation>una granja dibuja fotogramas numerados, name%05d.png</translation>
    </message>
    <message>
        <source>Plans the drawing of paintings by many machines.</source>
        <translation>Planifica el dibujo de obras entre muchos equipos.</translation>
    </message>
    <message>
        <source>-o FOLDER is missing: name the folder that all machines share</source>
        <translation>falta -o FOLDER: indique la carpeta que comparten todos los equipos</translation>
    </message>
    <message>
        <source>give --tiles or --frames</source>
        <translation>indique --tiles o --frames</translation>
    </message>
    <message>
        <source>several paintings need several names: put %s where the painting&apos;s name is to stand, as in out/%s.dzi</source>
        <translation>varias obras necesitan varios nombres: ponga %s donde deba ir el nombre de la obra, como en out/%s.dzi</translation>
    </message>
    <message>
        <source>%1: two paintings would become the same file. Rename one.</source>
        <translation>%1: dos obras darían el mismo archivo. Cambie el nombre de una.</translation>
    </message>
    <message>
        <source>--task %1: give i/n, e.g. 3/8, from 1/8 to 8/8</source>
        <translation>--task %1: indique i/n, p. ej. 3/8, de 1/8 a 8/8</translation>
    </message>
    <message>
        <source>the plan is for %1 &quot;%2&quot;, and this machine has &quot;%3&quot;, which makes other bits. Use the same program on all machines, or make a new plan</source>
        <translation>el plan es para %1 «%2» y este equipo tiene «%3», que produce otros bits. Use el mismo programa en todos los equipos o haga un plan nuevo</translation>
    </message>
    <message>
        <source>%1: the painting has changed since it was planned. Bring it back, or make a new plan.</source>
        <translation>%1: la obra ha cambiado desde que se planificó. Recupérela o haga un plan nuevo.</translation>
    </message>
    <message>
        <source>%1 What another backend draws has other bits, and is not mixed in. Start the task again.</source>
        <translation>%1 Lo que dibuja otro motor tiene otros bits y no se mezcla. Inicie la tarea otra vez.</translation>
    </message>
    <message>
        <source>Draws what is missing of a task; as often as is liked.</source>
        <translation>Dibuja lo que falta de una tarea; tantas veces como se quiera.</translation>
    </message>
    <message>
        <source>Which part: i/n, from 1/n to n/n (default 1/1).</source>
        <translation>Qué parte: i/n, de 1/n a n/n (predeterminado: 1/1).</translation>
    </message>
    <message>
        <source>stopped; what is finished is kept, and the same command goes on</source>
        <translation>detenido; lo terminado se conserva, y la misma orden continúa</translation>
    </message>
    <message>
        <source>task %1: %2 drawn, %3 there already</source>
        <translation>tarea %1: %2 dibujadas, %3 ya estaban</translation>
    </message>
    <message>
        <source>let many machines draw pictures in tiles, and films</source>
        <translation>repartir entre muchos equipos el dibujo de imágenes en teselas y de películas</translation>
    </message>
    <message>
        <source>a picture of %1 × %2 pixels is too large: at most %3 a side. Choose a smaller --size, --scale or --area</source>
        <translation>una imagen de %1 × %2 píxeles es demasiado grande: como máximo, %3 por lado. Elija un valor menor de --size, --scale o --area</translation>
    </message>
    <message>
        <source>%1: is a folder. Give a file name.</source>
        <translation>%1: es una carpeta. Indique un nombre de archivo.</translation>
    </message>
    <message>
        <source>A picture of any size in tiles: OUT.dzi (Deep Zoom), OUT.tif (BigTIFF) or a folder; --format jpg or png.</source>
        <translation>Una imagen de cualquier tamaño en teselas: OUT.dzi (Deep Zoom), OUT.tif (BigTIFF) o una carpeta; --format jpg o png.</translation>
    </message>
    <message>
        <source>With --tiles: pixels a side (default 254; TIFF 512).</source>
        <translation>Con --tiles: píxeles por lado (predeterminado: 254; TIFF: 512).</translation>
    </message>
    <message>
        <source>With --tiles: pixels that tiles show of their neighbours (default 1; TIFF 0).</source>
        <translation>Con --tiles: píxeles que las teselas muestran de sus vecinas (predeterminado: 1; TIFF: 0).</translation>
    </message>
    <message>
        <source>With --tiles: pixels a side of what is drawn at once (default 2048; CUDA 8192).</source>
        <translation>Con --tiles: píxeles por lado de lo que se dibuja de una vez (predeterminado: 2048; CUDA: 8192).</translation>
    </message>
    <message>
        <source>--%1 is not for --tiles</source>
        <translation>--%1 no es para --tiles</translation>
    </message>
    <message>
        <source>--tiles %1: the name is missing: give wall.dzi, wall.tif or a folder</source>
        <translation>--tiles %1: falta el nombre: indique wall.dzi, wall.tif o una carpeta</translation>
    </message>
    <message>
        <source>--tiles %1: give a name that ends in .dzi or .tif, or a folder</source>
        <translation>--tiles %1: indique un nombre que termine en .dzi o .tif, o una carpeta</translation>
    </message>
    <message>
        <source>--format is for Deep Zoom: the tiles of a TIFF are packed in it</source>
        <translation>--format es para Deep Zoom: las teselas de un TIFF van dentro de él</translation>
    </message>
    <message>
        <source>--format %1: tiles of a Deep Zoom are jpg or png</source>
        <translation>--format %1: las teselas de un Deep Zoom son jpg o png</translation>
    </message>
    <message>
        <source>--depth %1: tiles have 8 or 16 bits</source>
        <translation>--depth %1: las teselas tienen 8 o 16 bits</translation>
    </message>
    <message>
        <source>tiles of JPEG hold 8 bits and no transparency: use --format png, or .tif</source>
        <translation>las teselas JPEG tienen 8 bits y no admiten transparencia: use --format png, o .tif</translation>
    </message>
    <message>
        <source>tiles of a TIFF do not overlap, and have sides of a multiple of 16</source>
        <translation>las teselas de un TIFF no se solapan, y sus lados son múltiplos de 16</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 pieces of %n painting(s)</source>
        <translation>
            <numerusform>%1: %2 piezas de %n obra</numerusform>
            <numerusform>%1: %2 piezas de %n obras</numerusform>
        </translation>
    </message>
    <message>
        <source>these are more than %1 pieces. Choose a greater --sheet, a smaller picture, or several plans.</source>
        <translation>son más de %1 piezas. Elija un --sheet mayor, una imagen más pequeña o varios planes.</translation>
    </message>
    <message>
        <source>other machines cannot read this standard input: give files</source>
        <translation>otros equipos no pueden leer esta entrada estándar: indique archivos</translation>
    </message>
    <message>
        <source>auto (default: a GPU where there is one), cpu or cuda.</source>
        <translation>auto (predeterminado: una GPU donde la haya), cpu o cuda.</translation>
    </message>
    <message>
        <source>--backend %1: give auto, cpu or cuda</source>
        <translation>--backend %1: indique auto, cpu o cuda</translation>
    </message>
    <message>
        <source>the GPU failed (%1); the CPU went on</source>
        <translation>la GPU ha fallado (%1); la CPU ha continuado</translation>
    </message>
    <message>
        <source>stopped before it came nearer than %1; nothing was written</source>
        <translation>detenido antes de acercarse más que %1; no se ha escrito nada</translation>
    </message>
    <message>
        <source>--error %1 was not reached: it is %2. Give more --strokes or --iterations.</source>
        <translation>no se alcanzó --error %1: es %2. Indique más --strokes o --iterations.</translation>
    </message>
    <message>
        <source>%1: is damaged</source>
        <translation>%1: está dañado</translation>
    </message>
    <message>
        <source>%1: is missing</source>
        <translation>%1: falta</translation>
    </message>
    <message numerus="yes">
        <source>%n more file(s) are missing or damaged; farm verify --json names all.</source>
        <translation>
            <numerusform>falta o está dañado %n archivo más; farm verify --json los nombra todos.</numerusform>
            <numerusform>faltan o están dañados %n archivos más; farm verify --json los nombra todos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n line(s) of this journal are damaged, so nobody knows what was finished. Run the tasks again: they draw what is missing.</source>
        <translation>
            <numerusform>%1: %n línea de este diario está dañada, así que no se sabe qué estaba terminado. Vuelva a ejecutar las tareas: dibujan lo que falta.</numerusform>
            <numerusform>%1: %n líneas de este diario están dañadas, así que no se sabe qué estaba terminado. Vuelva a ejecutar las tareas: dibujan lo que falta.</numerusform>
        </translation>
    </message>
    <message>
        <source>the new strokes are farther from %1 than those before: %2 of 255, and before it was %3. Give more --strokes or --iterations.</source>
        <translation>los trazos nuevos están más lejos de %1 que los de antes: %2 de 255, y antes era %3. Indique más --strokes o --iterations.</translation>
    </message>
    <message>
        <source>%1 cannot be used</source>
        <translation>%1 no se puede usar</translation>
    </message>
    <message>
        <source>Lists the extensions that there are.</source>
        <translation>Enumera las extensiones que hay.</translation>
    </message>
    <message>
        <source>%1: cannot be read</source>
        <translation>%1: no se puede leer</translation>
    </message>
    <message>
        <source>%1: there is no such extension. See suffuse-cli extension list.</source>
        <translation>%1: no existe esa extensión. Véase suffuse-cli extension list.</translation>
    </message>
    <message>
        <source>--set %1: give FIELD=VALUE with one of the fields %2</source>
        <translation>--set %1: indique FIELD=VALUE con uno de los campos %2</translation>
    </message>
    <message>
        <source>%1; give it by --set</source>
        <translation>%1; indíquelo con --set</translation>
    </message>
    <message>
        <source>Runs an extension on a painting, and writes what it makes of it.</source>
        <translation>Ejecuta una extensión sobre una obra y escribe lo que hace de ella.</translation>
    </message>
    <message>
        <source>A field&apos;s value; may be given several times.</source>
        <translation>El valor de un campo; se puede indicar varias veces.</translation>
    </message>
    <message>
        <source>The strokes that are selected, by their ids, such as 3,7,20-180.</source>
        <translation>Los trazos seleccionados, por sus identificadores, como 3,7,20-180.</translation>
    </message>
    <message>
        <source>The group that is painted on, by its name.</source>
        <translation>El grupo en el que se pinta, por su nombre.</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the file to write</source>
        <translation>falta -o OUT: indique el archivo que se va a escribir</translation>
    </message>
    <message>
        <source>%1 makes no painting; leave -o away</source>
        <translation>%1 no hace ninguna obra; quite -o</translation>
    </message>
    <message>
        <source>%1: end the name with .suffuse or .json</source>
        <translation>%1: termine el nombre en .suffuse o .json</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli extension COMMAND [options] …</source>
        <translation>Uso: suffuse-cli extension ORDEN [opciones] …</translation>
    </message>
    <message>
        <source>the extensions that there are, with their fields</source>
        <translation>las extensiones que hay, con sus campos</translation>
    </message>
    <message>
        <source>run one on a painting, and write what it makes of it</source>
        <translation>ejecutar una sobre una obra y escribir lo que hace de ella</translation>
    </message>
    <message>
        <source>extension %1: there is no such command. See suffuse-cli extension --help.</source>
        <translation>extension %1: no existe esa orden. Véase suffuse-cli extension --help.</translation>
    </message>
    <message>
        <source>run programs of others on a painting</source>
        <translation>ejecutar programas de terceros sobre una obra</translation>
    </message>
    <message>
        <source>Its id, as extension list names it, or the path of its folder.</source>
        <translation>Su identificador, tal como lo nombra extension list, o la ruta de su carpeta.</translation>
    </message>
    <message>
        <source>%1: it belongs to the farm in %2, and two farms would overwrite each other&apos;s pieces. Choose another name, or, if that farm is not wanted any more, remove its folder.</source>
        <translation>%1: pertenece a la granja de %2, y dos granjas se sobrescribirían las piezas. Elija otro nombre o, si esa granja ya no hace falta, quite su carpeta.</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Is another farm being planned?</source>
        <translation>%1: no se puede escribir (%2). ¿Se está planificando otra granja?</translation>
    </message>
</context>
<context>
    <name>Clipboard</name>
    <message>
        <source>Paste</source>
        <translation>Pegar</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Clipboard</source>
        <translation>Portapapeles</translation>
    </message>
    <message>
        <source>There are no paths in the SVG of the clipboard.</source>
        <translation>No hay trayectos en el SVG del portapapeles.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) cannot lie there, too far out, and were left out.</source>
        <translation>
            <numerusform>%Ln trazo quedaría demasiado lejos y se ha omitido.</numerusform>
            <numerusform>%Ln trazos quedarían demasiado lejos y se han omitido.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>As SVG, for other programs, what was erased softly is left out: %n erasure(s).</source>
        <translation>
            <numerusform>Como SVG, para otros programas, se omite lo borrado suavemente: %n borrado.</numerusform>
            <numerusform>Como SVG, para otros programas, se omite lo borrado suavemente: %n borrados.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>SVG has no groups that mask, erase or clip what lies below: %n group(s) became plain.</source>
        <translation>
            <numerusform>SVG no tiene grupos que enmascaren, borren o recorten lo que hay debajo: %n grupo ha pasado a ser normal.</numerusform>
            <numerusform>SVG no tiene grupos que enmascaren, borren o recorten lo que hay debajo: %n grupos han pasado a ser normales.</numerusform>
        </translation>
    </message>
    <message>
        <source>An erasure is not copied without the paint that it takes away. Duplicate doubles it within its stroke, Delete removes it.</source>
        <translation>Un borrado no se copia sin la pintura que quita. «Duplicar» lo duplica dentro de su trazo; «Eliminar» lo quita.</translation>
    </message>
    <message>
        <source>What was pasted lies outside of what is seen of the canvas. View ▸ Zoom to Selection goes there.</source>
        <translation>Lo pegado está fuera de lo que se ve del lienzo. Ver ▸ Zoom a la selección lleva hasta allí.</translation>
    </message>
    <message>
        <source>There it would not be seen: what was pasted lies in the middle of what is seen of the canvas.</source>
        <translation>Allí no se vería: lo pegado está en el centro de lo que se ve del lienzo.</translation>
    </message>
    <message numerus="yes">
        <source>SVG has no washes: the strokes of %n group(s) lie over each other there.</source>
        <translation>
            <numerusform>SVG no tiene aguadas: allí los trazos de %n grupo quedan unos sobre otros.</numerusform>
            <numerusform>SVG no tiene aguadas: allí los trazos de %n grupos quedan unos sobre otros.</numerusform>
        </translation>
    </message>
    <message>
        <source>The clipboard holds no strokes, no SVG paths, no picture and no colour.</source>
        <translation>El portapapeles no contiene trazos, trayectos SVG, imágenes ni colores.</translation>
    </message>
    <message numerus="yes">
        <source>As SVG, for other programs, pictures are left out: %n of them.</source>
        <translation>
            <numerusform>Como SVG, para otros programas, se omite %n imagen.</numerusform>
            <numerusform>Como SVG, para otros programas, se omiten %n imágenes.</numerusform>
        </translation>
    </message>
    <message>
        <source>What came was painted after the moment that you look at. It was brought back to this moment, so that you see it.</source>
        <translation>Lo que ha llegado se pintó después del momento que está viendo. Se ha traído a este momento para que lo vea.</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Delete segments</source>
        <translation>Eliminar segmentos</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s) deleted; Undo brings back.</source>
        <translation>
            <numerusform>%Ln segmento eliminado; Deshacer lo recupera.</numerusform>
            <numerusform>%Ln segmentos eliminados; Deshacer los recupera.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln stroke(s); Undo takes it back.</source>
        <translation>
            <numerusform>%1: %Ln trazo; Deshacer lo revierte.</numerusform>
            <numerusform>%1: %Ln trazos; Deshacer lo revierte.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) deleted; Undo brings back.</source>
        <translation>
            <numerusform>%Ln trazo eliminado; Deshacer lo recupera.</numerusform>
            <numerusform>%Ln trazos eliminados; Deshacer los recupera.</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete strokes</source>
        <translation>Eliminar trazos</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>The erasure is there twice now, and takes twice: drag the copy, or move it with the arrow keys.</source>
        <translation>El borrado está ahora dos veces y quita dos veces: arrastre la copia o muévala con las teclas de flecha.</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>Elevar</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Bajar</translation>
    </message>
    <message>
        <source>Raise to top</source>
        <translation>Traer al frente</translation>
    </message>
    <message>
        <source>Lower to bottom</source>
        <translation>Enviar al fondo</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Flip horizontally</source>
        <translation>Voltear horizontalmente</translation>
    </message>
    <message>
        <source>Flip vertically</source>
        <translation>Voltear verticalmente</translation>
    </message>
    <message>
        <source>Rotate by 90°</source>
        <translation>Girar 90°</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Alinear</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Distribuir</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Agrupar</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Desagrupar</translation>
    </message>
    <message>
        <source>Lock strokes</source>
        <translation>Bloquear trazos</translation>
    </message>
    <message>
        <source>Hide strokes</source>
        <translation>Ocultar trazos</translation>
    </message>
    <message>
        <source>Unlock all</source>
        <translation>Desbloquear todo</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Mostrar todo</translation>
    </message>
    <message>
        <source>Rename strokes</source>
        <translation>Cambiar nombre de trazos</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>Cambiar nombre del grupo</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>Simplificar</translation>
    </message>
    <message>
        <source>Smooth strokes</source>
        <translation>Suavizar trazos</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Enderezar</translation>
    </message>
    <message>
        <source>Grow or shrink paint</source>
        <translation>Ensanchar o estrechar pintura</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Desplazar</translation>
    </message>
    <message>
        <source>What is selected is locked or hidden.</source>
        <translation>Lo seleccionado está bloqueado u oculto.</translation>
    </message>
    <message>
        <source>Nothing changes.</source>
        <translation>No cambia nada.</translation>
    </message>
    <message>
        <source>Apply brush</source>
        <translation>Aplicar pincel</translation>
    </message>
    <message>
        <source>Apply form of the brush</source>
        <translation>Aplicar forma del pincel</translation>
    </message>
    <message>
        <source>Apply colour of the brush</source>
        <translation>Aplicar color del pincel</translation>
    </message>
    <message>
        <source>Apply texture of the brush</source>
        <translation>Aplicar textura del pincel</translation>
    </message>
    <message>
        <source>No appearance was copied.</source>
        <translation>No se ha copiado ningún aspecto.</translation>
    </message>
    <message>
        <source>Paste appearance</source>
        <translation>Pegar aspecto</translation>
    </message>
    <message>
        <source>Combine strokes</source>
        <translation>Combinar trazos</translation>
    </message>
    <message>
        <source>Break apart</source>
        <translation>Descombinar</translation>
    </message>
    <message>
        <source>Remove erasures</source>
        <translation>Quitar borrados</translation>
    </message>
    <message>
        <source>Recolour artwork</source>
        <translation>Recolorear obra</translation>
    </message>
    <message>
        <source>The painting has no swatches yet.</source>
        <translation>La obra aún no tiene muestras.</translation>
    </message>
    <message>
        <source>Map colours to swatches</source>
        <translation>Asignar colores a muestras</translation>
    </message>
    <message>
        <source>Not combined: one stroke has one fill, and these differ, overlap, or are missing in some strokes.</source>
        <translation>No se ha combinado: un trazo tiene un solo relleno, y estos difieren, se solapan o faltan en algunos trazos.</translation>
    </message>
    <message>
        <source>Aligning takes two strokes or groups that are not locked. A group counts as one; it can be aligned relative to the canvas.</source>
        <translation>Para alinear hacen falta dos trazos o grupos sin bloquear. Un grupo cuenta como uno; se puede alinear respecto al lienzo.</translation>
    </message>
    <message>
        <source>Distributing takes three strokes or groups that are not locked. A group counts as one.</source>
        <translation>Para distribuir hacen falta tres trazos o grupos sin bloquear. Un grupo cuenta como uno.</translation>
    </message>
    <message>
        <source>Clip group to what lies below</source>
        <translation>Recortar grupo a lo de abajo</translation>
    </message>
    <message>
        <source>Clip group no more</source>
        <translation>Dejar de recortar grupo</translation>
    </message>
    <message>
        <source>Use group as mask</source>
        <translation>Usar grupo como máscara</translation>
    </message>
    <message>
        <source>Use group as mask no more</source>
        <translation>Dejar de usar grupo como máscara</translation>
    </message>
    <message>
        <source>Make group a wash</source>
        <translation>Convertir grupo en aguada</translation>
    </message>
    <message>
        <source>Make wash a plain group</source>
        <translation>Convertir aguada en grupo normal</translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation>Eliminar capa</translation>
    </message>
    <message>
        <source>Make group a draft</source>
        <translation>Convertir grupo en borrador</translation>
    </message>
    <message>
        <source>Export draft again</source>
        <translation>Volver a exportar borrador</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) now. Where their paint meets it mixes, and no longer adds up.</source>
        <translation>
            <numerusform>Ahora %Ln trazo. Donde su pintura se toca, se mezcla y ya no se suma.</numerusform>
            <numerusform>Ahora %Ln trazos. Donde su pintura se toca, se mezcla y ya no se suma.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) selected. Delete once more deletes.</source>
        <translation>
            <numerusform>%Ln trazo seleccionado. Pulsar Supr otra vez lo elimina.</numerusform>
            <numerusform>%Ln trazos seleccionados. Pulsar Supr otra vez los elimina.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s) selected. Delete once more deletes.</source>
        <translation>
            <numerusform>%Ln segmento seleccionado. Pulsar Supr otra vez lo elimina.</numerusform>
            <numerusform>%Ln segmentos seleccionados. Pulsar Supr otra vez los elimina.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>The selected strokes were exported last, and nothing is selected. Select strokes, or choose Export…</source>
        <translation>Lo último que se exportó fueron los trazos seleccionados, y no hay nada seleccionado. Seleccione trazos o elija Exportar…</translation>
    </message>
    <message>
        <source>There is nothing to export. Choose Export…</source>
        <translation>No hay nada que exportar. Elija Exportar…</translation>
    </message>
</context>
<context>
    <name>FigureWarnings</name>
    <message>
        <source>Widest at %1 s; from then on it grows narrower while it spreads.</source>
        <translation>Máxima anchura a los %1 s; desde entonces se estrecha mientras se expande.</translation>
    </message>
    <message>
        <source>ξ2 too large for ξ1: the stroke has no clear edge and tints as far as its paint reaches. Up to %1 is clear.</source>
        <translation>ξ2 demasiado grande para ξ1: el trazo no tiene un borde nítido y tiñe hasta donde llega su pintura. Con %1 como máximo, lo tiene.</translation>
    </message>
    <message>
        <source>ξ2 too large for ξ1: the paint inside the dark rim vanishes.</source>
        <translation>ξ2 demasiado grande para ξ1: desaparece la pintura dentro del borde oscuro.</translation>
    </message>
    <message>
        <source>Density 0: there is no paint.</source>
        <translation>Densidad 0: no hay pintura.</translation>
    </message>
    <message>
        <source>Opacity 0 %: nothing of it is seen.</source>
        <translation>Opacidad 0 %: no se ve nada.</translation>
    </message>
    <message>
        <source>Fades away at %1 s: nothing of it is seen after that. More φ, or less D or drying time, keeps it.</source>
        <extracomment>%1: seconds after it was painted</extracomment>
        <translation>Se desvanece a los %1 s: después no se ve nada. Más φ, o menos D o tiempo de secado, lo conserva.</translation>
    </message>
    <message>
        <source>Parts fade away, the first at %1 s. More φ, or less D or drying time, keeps them.</source>
        <translation>Hay partes que se desvanecen, la primera a los %1 s. Más φ, o menos D o tiempo de secado, las conserva.</translation>
    </message>
    <message>
        <source>Strength 0: nothing is taken away.</source>
        <translation>Intensidad 0: no se quita nada.</translation>
    </message>
</context>
<context>
    <name>FileReplacement</name>
    <message>
        <source>%1: cannot be written (%2). Choose another folder, or change its permissions.</source>
        <translation>%1: no se puede escribir (%2). Elija otra carpeta o cambie sus permisos.</translation>
    </message>
    <message>
        <source>%1: the disk is full (%2). Free some space, or choose another disk.</source>
        <translation>%1: el disco está lleno (%2). Libere espacio o elija otro disco.</translation>
    </message>
    <message>
        <source>%1: writing failed (%2). Choose another place.</source>
        <translation>%1: la escritura ha fallado (%2). Elija otro lugar.</translation>
    </message>
    <message>
        <source>%1: is a folder. Give a file name.</source>
        <translation>%1: es una carpeta. Indique un nombre de archivo.</translation>
    </message>
    <message>
        <source>%1: is not a plain file. Choose another name.</source>
        <translation>%1: no es un archivo normal. Elija otro nombre.</translation>
    </message>
    <message>
        <source>%1: the folder %2 does not exist. Create it, or choose another.</source>
        <translation>%1: la carpeta %2 no existe. Créela o elija otra.</translation>
    </message>
</context>
<context>
    <name>Film</name>
    <message>
        <source>a film has %1 to %2 frames a second</source>
        <translation>una película tiene de %1 a %2 fotogramas por segundo</translation>
    </message>
    <message>
        <source>MP4 cannot hold transparency. Use WebM, WebP or frames.</source>
        <translation>MP4 no admite transparencia. Use WebM, WebP o fotogramas.</translation>
    </message>
    <message>
        <source>a video has at most %1 pixels a side</source>
        <translation>un vídeo tiene como máximo %1 píxeles por lado</translation>
    </message>
    <message>
        <source>%1: cannot write into this folder. Choose another one.</source>
        <translation>%1: no se puede escribir en esta carpeta. Elija otra.</translation>
    </message>
    <message>
        <source>frames are numbered files: give a name such as film/%05d.png, or one that ends in .webp, .webm or .mp4</source>
        <translation>los fotogramas son archivos numerados: indique un nombre como film/%05d.png, o uno que termine en .webp, .webm o .mp4</translation>
    </message>
    <message>
        <source>%1: ffmpeg, which makes videos, is not installed. Install it, or choose WebP or frames.</source>
        <translation>%1: ffmpeg, que crea los vídeos, no está instalado. Instálelo o elija WebP o fotogramas.</translation>
    </message>
    <message>
        <source>%1: ffmpeg could not make the video (%2). Choose another format or size.</source>
        <translation>%1: ffmpeg no ha podido crear el vídeo (%2). Elija otro formato o tamaño.</translation>
    </message>
    <message>
        <source>%1: the film could not be written (%2).</source>
        <translation>%1: no se ha podido escribir la película (%2).</translation>
    </message>
    <message>
        <source>%1: the film is too large for WebP. Choose another format, a smaller size or fewer frames.</source>
        <translation>%1: la película es demasiado grande para WebP. Elija otro formato, un tamaño menor o menos fotogramas.</translation>
    </message>
</context>
<context>
    <name>ImageFormat</name>
    <message>
        <source>This is no image format that can be written. Use one of these endings: %1.</source>
        <translation>No es un formato de imagen que se pueda escribir. Use una de estas terminaciones: %1.</translation>
    </message>
    <message>
        <source>%1 cannot hold depth %2. Choose %3, or another format.</source>
        <translation>%1 no admite la profundidad %2. Elija %3 u otro formato.</translation>
    </message>
    <message>
        <source>%1 cannot hold transparency. Use PNG, TIFF, EXR or WebP, or export with the background.</source>
        <translation>%1 no admite transparencia. Use PNG, TIFF, EXR o WebP, o exporte con el fondo.</translation>
    </message>
    <message>
        <source>%1 holds 1 to %2 pixels a side, not %3 × %4. Choose another size or format.</source>
        <translation>%1 admite de 1 a %2 píxeles por lado, no %3 × %4. Elija otro tamaño o formato.</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels is too large: at most %3 million pixels can be drawn. Choose a smaller size.</source>
        <translation>Una imagen de %1 × %2 píxeles es demasiado grande: se pueden dibujar como máximo %3 millones de píxeles. Elija un tamaño menor.</translation>
    </message>
    <message>
        <source>%1 cannot hold a colour profile. Use PNG, TIFF, JPEG or WebP, or export in sRGB.</source>
        <translation>%1 no admite un perfil de color. Use PNG, TIFF, JPEG o WebP, o exporte en sRGB.</translation>
    </message>
</context>
<context>
    <name>ImageModule</name>
    <message>
        <source>is missing</source>
        <translation>falta</translation>
    </message>
    <message>
        <source>cannot be loaded (%1)</source>
        <translation>no se puede cargar (%1)</translation>
    </message>
    <message>
        <source>is of another version of Suffuse</source>
        <translation>es de otra versión de Suffuse</translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, %2; install Suffuse again, with what suffuse-cli recommends. Pictures ending in .pfm work without it</source>
        <translation>una parte de Suffuse, %1, %2; vuelva a instalar Suffuse, con lo que recomienda suffuse-cli. Las imágenes que terminan en .pfm funcionan sin ella</translation>
    </message>
</context>
<context>
    <name>ImageReader</name>
    <message>
        <source>%1: the image declares more than %2 × %2 or %3 million pixels. Scale it down first.</source>
        <translation>%1: la imagen declara más de %2 × %2 o %3 millones de píxeles. Redúzcala antes.</translation>
    </message>
    <message>
        <source>%1: is not a PNG, JPEG, TIFF, EXR or WebP image. Convert it to one of them.</source>
        <translation>%1: no es una imagen PNG, JPEG, TIFF, EXR ni WebP. Conviértala a uno de estos formatos.</translation>
    </message>
    <message>
        <source>%1: cannot read %2: %3.</source>
        <translation>%1: no se puede leer %2: %3.</translation>
    </message>
    <message>
        <source>%1: the %2 image cannot be read (%3). It may be damaged, or too large (at most %4 pixels a side, %5 million in all).</source>
        <translation>%1: no se puede leer la imagen %2 (%3). Puede estar dañada o ser demasiado grande (como máximo, %4 píxeles por lado y %5 millones en total).</translation>
    </message>
</context>
<context>
    <name>ImageWriter</name>
    <message>
        <source>%1: cannot write %2: %3.</source>
        <translation>%1: no se puede escribir %2: %3.</translation>
    </message>
    <message>
        <source>%1: writing was cancelled; nothing was changed.</source>
        <translation>%1: se ha cancelado la escritura; no ha cambiado nada.</translation>
    </message>
    <message>
        <source>%1: %2 could not be written (%3). Choose another format or depth.</source>
        <translation>%1: no se ha podido escribir %2 (%3). Elija otro formato o profundidad.</translation>
    </message>
    <message>
        <source>%1: the colour profile cannot be used: %2. Choose another one.</source>
        <translation>%1: no se puede usar el perfil de color: %2. Elija otro.</translation>
    </message>
</context>
<context>
    <name>Import</name>
    <message>
        <source>there are no strokes in it</source>
        <translation>no contiene trazos</translation>
    </message>
    <message>
        <source>Import strokes</source>
        <translation>Importar trazos</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Return</source>
        <extracomment>the key, as it is called on keyboards</extracomment>
        <translation>Intro</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>Save the changes to “%1” before closing?</source>
        <translation>¿Guardar los cambios de «%1» antes de cerrar?</translation>
    </message>
    <message>
        <source>Suffuse did not come up the last times, so it has started with the usual settings. Yours are kept in %1.</source>
        <translation>Suffuse no ha podido arrancar las últimas veces, así que ha empezado con los ajustes predeterminados. Los suyos se conservan en %1.</translation>
    </message>
    <message>
        <source>Leave out the quotation marks: file dialogs take them for the borders between several names.</source>
        <translation>Omita las comillas: los diálogos de archivos las toman por separadores entre varios nombres.</translation>
    </message>
    <message>
        <source>“%1” is only an ending. Give a name before it.</source>
        <translation>«%1» es solo una terminación. Ponga un nombre delante.</translation>
    </message>
    <message>
        <source>Nothing is lost: the painting stays open as it is.</source>
        <translation>No se ha perdido nada: la obra sigue abierta tal como está.</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Guardar c&amp;omo…</translation>
    </message>
    <message>
        <source>Another program has changed “%1”.</source>
        <translation>Otro programa ha cambiado «%1».</translation>
    </message>
    <message>
        <source>The file stays as it is until you save.</source>
        <translation>El archivo se queda como está hasta que guarde.</translation>
    </message>
    <message>
        <source>Overwriting gives up what the other program wrote.</source>
        <translation>Al sobrescribir se pierde lo que escribió el otro programa.</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>&amp;Sobrescribir</translation>
    </message>
    <message>
        <source>&amp;Keep Mine</source>
        <translation>&amp;Conservar el mío</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Recargar</translation>
    </message>
    <message>
        <source>Reloading takes away what was painted since the last save; Undo brings it back.</source>
        <translation>Recargar quita lo pintado desde el último guardado; Deshacer lo recupera.</translation>
    </message>
    <message>
        <source>“%1” exists. Replace it?</source>
        <translation>«%1» ya existe. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Reemplazar</translation>
    </message>
    <message>
        <source>Without saving, what has not been saved yet is lost.</source>
        <translation>Si no se guarda, se pierde lo que aún no se ha guardado.</translation>
    </message>
</context>
<context>
    <name>NodeDrag</name>
    <message>
        <source>Move nodes</source>
        <translation>Mover nodos</translation>
    </message>
    <message>
        <source>Move node</source>
        <translation>Mover nodo</translation>
    </message>
    <message>
        <source>Move handle</source>
        <translation>Mover tirador</translation>
    </message>
    <message>
        <source>Bend curve</source>
        <translation>Doblar curva</translation>
    </message>
    <message>
        <source>Move erasure</source>
        <translation>Mover borrado</translation>
    </message>
</context>
<context>
    <name>Paper</name>
    <message>
        <source>paper image</source>
        <translation>imagen del papel</translation>
    </message>
    <message>
        <source>paper image: there is none. Choose an image, or another kind of paper.</source>
        <translation>imagen del papel: no hay ninguna. Elija una imagen u otro tipo de papel.</translation>
    </message>
</context>
<context>
    <name>Papers</name>
    <message>
        <source>Smooth</source>
        <translation>Liso</translation>
    </message>
    <message>
        <source>Cold press</source>
        <translation>Grano fino</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Rugoso</translation>
    </message>
    <message>
        <source>Rice</source>
        <translation>De arroz</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Lienzo</translation>
    </message>
</context>
<context>
    <name>PictureFile</name>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 no se puede leer: %2.</translation>
    </message>
    <message>
        <source>%1 is larger than 64 MB: choose a smaller picture.</source>
        <translation>%1 ocupa más de 64 MB: elija una imagen más pequeña.</translation>
    </message>
</context>
<context>
    <name>ReferenceRenderer</name>
    <message>
        <source>%1 threads · double</source>
        <translation>%1 hilos · doble</translation>
    </message>
</context>
<context>
    <name>Renderer</name>
    <message numerus="yes">
        <source>%n threads</source>
        <translation>
            <numerusform>%n hilo</numerusform>
            <numerusform>%n hilos</numerusform>
        </translation>
    </message>
    <message>
        <source>The CUDA backend cannot run: %1. Use the CPU backend.</source>
        <translation>El motor CUDA no puede funcionar: %1. Use el motor de CPU.</translation>
    </message>
    <message>
        <source>%1 stopped: %2. The CPU draws now.</source>
        <translation>%1 se ha detenido: %2. Ahora dibuja la CPU.</translation>
    </message>
    <message>
        <source>the picture is too large</source>
        <translation>la imagen es demasiado grande</translation>
    </message>
    <message>
        <source>this program was built without the CUDA renderer</source>
        <translation>este programa se compiló sin el motor CUDA</translation>
    </message>
    <message>
        <source>no NVIDIA driver, or one that is too old for this program</source>
        <translation>no hay controlador de NVIDIA, o es demasiado antiguo para este programa</translation>
    </message>
    <message>
        <source>there is no NVIDIA GPU</source>
        <translation>no hay ninguna GPU de NVIDIA</translation>
    </message>
    <message>
        <source>the NVIDIA driver does not work</source>
        <translation>el controlador de NVIDIA no funciona</translation>
    </message>
    <message>
        <source>there is not enough memory for %1 × %2 pixels. Choose a smaller size.</source>
        <translation>no hay memoria suficiente para %1 × %2 píxeles. Elija un tamaño menor.</translation>
    </message>
    <message>
        <source>The reference finds no gradients. Use the CPU backend.</source>
        <translation>La referencia no calcula gradientes. Use el motor de CPU.</translation>
    </message>
</context>
<context>
    <name>Retiming</name>
    <message>
        <source>Ease in time</source>
        <translation>Suavizar en el tiempo</translation>
    </message>
    <message>
        <source>Move in time</source>
        <translation>Mover en el tiempo</translation>
    </message>
    <message>
        <source>Stretch in time</source>
        <translation>Estirar en el tiempo</translation>
    </message>
    <message>
        <source>%1, with its erasures</source>
        <translation>%1, con sus borrados</translation>
    </message>
    <message>
        <source>%1; erasures keep their time</source>
        <translation>%1; los borrados conservan su tiempo</translation>
    </message>
    <message>
        <source>Later by %1 s</source>
        <translation>%1 s más tarde</translation>
    </message>
    <message>
        <source>Drawn in %1 s</source>
        <translation>Dibujado en %1 s</translation>
    </message>
    <message>
        <source>Begins at %1 % of its pace</source>
        <translation>Empieza al %1 % de su ritmo</translation>
    </message>
    <message>
        <source>Ends at %1 % of its pace</source>
        <translation>Termina al %1 % de su ritmo</translation>
    </message>
</context>
<context>
    <name>SelectHints</name>
    <message>
        <source>Drag: scale. Ctrl: keep the proportions. Shift: about the centre.</source>
        <translation>Arrastrar: escalar. Ctrl: mantener las proporciones. Mayús: desde el centro.</translation>
    </message>
    <message>
        <source>Drag: rotate. Ctrl: in steps of 15°. Shift: about the opposite corner.</source>
        <translation>Arrastrar: girar. Ctrl: en pasos de 15°. Mayús: en torno a la esquina opuesta.</translation>
    </message>
    <message>
        <source>Drag: skew. Ctrl: in steps of 15°. Shift: about the opposite side.</source>
        <translation>Arrastrar: inclinar. Ctrl: en pasos de 15°. Mayús: respecto al lado opuesto.</translation>
    </message>
    <message>
        <source>Drag: move the centre of rotation. Shift+click: back into the middle.</source>
        <translation>Arrastrar: mover el centro de giro. Mayús+clic: volver al centro.</translation>
    </message>
    <message>
        <source>Shift+Alt+click: add the next stroke below, with Ctrl within its group. Shift+Alt+drag: add what the path touches.</source>
        <translation>Mayús+Alt+clic: añadir el siguiente trazo de debajo; con Ctrl, dentro de su grupo. Mayús+Alt+arrastrar: añadir lo que toca el trayecto.</translation>
    </message>
    <message>
        <source>Alt+click: select the next stroke below, with Ctrl within its group. Alt+drag: select what the path touches.</source>
        <translation>Alt+clic: seleccionar el siguiente trazo de debajo; con Ctrl, dentro de su grupo. Alt+arrastrar: seleccionar lo que toca el trayecto.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+click: one stroke of a group, in or out. Ctrl+Shift+drag: take away.</source>
        <translation>Ctrl+Mayús+clic: añadir o quitar un trazo de un grupo. Ctrl+Mayús+arrastrar: quitar.</translation>
    </message>
    <message>
        <source>Ctrl+click: one stroke of a group. Ctrl+drag: move along an axis.</source>
        <translation>Ctrl+clic: un trazo de un grupo. Ctrl+arrastrar: mover a lo largo de un eje.</translation>
    </message>
    <message>
        <source>Shift+click: add or take away. Shift+drag: add what the band encloses; while moving: do not snap.</source>
        <translation>Mayús+clic: añadir o quitar. Mayús+arrastrar: añadir lo que encierra el marco; al mover: no ajustar.</translation>
    </message>
    <message>
        <source>Click paint to select its stroke. Drag for a band, over paint with Shift. Alt+click: the stroke below.</source>
        <translation>Clic en la pintura: seleccionar su trazo. Arrastrar: marco; sobre pintura, con Mayús. Alt+clic: el trazo de debajo.</translation>
    </message>
    <message>
        <source>Move by %1, %2</source>
        <translation>Mover %1; %2</translation>
    </message>
    <message>
        <source>Scale to %1 % × %2 %</source>
        <translation>Escalar al %1 % × %2 %</translation>
    </message>
    <message>
        <source>Rotate by %1</source>
        <translation>Girar %1</translation>
    </message>
    <message>
        <source>Skew by %1°</source>
        <translation>Inclinar %1°</translation>
    </message>
    <message>
        <source>Drag: move. Click again: turn and skew. Double click: values. Shift+click: add. Alt+click: the one below.</source>
        <translation>Arrastrar: mover. Otro clic: girar e inclinar. Doble clic: valores. Mayús+clic: añadir. Alt+clic: el de debajo.</translation>
    </message>
</context>
<context>
    <name>SvgPaths</name>
    <message>
        <source>SVG, line %1: %2</source>
        <translation>SVG, línea %1: %2</translation>
    </message>
</context>
<context>
    <name>TimelinePicture</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Each stroke is a bar here: from when it is painted until it is dry.</source>
        <translation>Aquí cada trazo es una barra: desde que se pinta hasta que está seco.</translation>
    </message>
</context>
<context>
    <name>Underlay</name>
    <message>
        <source>%1: there is not enough memory for it.</source>
        <translation>%1: no hay memoria suficiente.</translation>
    </message>
</context>
<context>
    <name>UnderlayCommands</name>
    <message>
        <source>Import underlay</source>
        <translation>Importar calco</translation>
    </message>
    <message>
        <source>Replace underlay</source>
        <translation>Reemplazar calco</translation>
    </message>
    <message>
        <source>Show underlay</source>
        <translation>Mostrar calco</translation>
    </message>
    <message>
        <source>Hide underlay</source>
        <translation>Ocultar calco</translation>
    </message>
    <message>
        <source>Change underlay opacity</source>
        <translation>Cambiar opacidad del calco</translation>
    </message>
    <message>
        <source>Move underlay</source>
        <translation>Mover calco</translation>
    </message>
    <message>
        <source>Resize underlay</source>
        <translation>Cambiar tamaño del calco</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>Calco</translation>
    </message>
    <message>
        <source>Fit underlay to the canvas</source>
        <translation>Encajar calco en el lienzo</translation>
    </message>
    <message>
        <source>Remove underlay</source>
        <translation>Quitar calco</translation>
    </message>
</context>
<context>
    <name>Validate</name>
    <message>
        <source>it is earlier than the one before it; put them in order of time</source>
        <translation>es anterior al que lo precede; póngalos en orden de tiempo</translation>
    </message>
    <message>
        <source>another group has the same id</source>
        <translation>otro grupo tiene el mismo identificador</translation>
    </message>
    <message>
        <source>there is no group with this id</source>
        <translation>no existe ningún grupo con este identificador</translation>
    </message>
    <message>
        <source>the group would lie within itself</source>
        <translation>el grupo estaría dentro de sí mismo</translation>
    </message>
    <message>
        <source>the group&apos;s members do not stand together in the order</source>
        <translation>los miembros del grupo no están juntos en el orden</translation>
    </message>
    <message>
        <source>there is no such style</source>
        <translation>no existe ese estilo</translation>
    </message>
    <message>
        <source>only edge darkening has a third value</source>
        <translation>solo los bordes oscuros tienen un tercer valor</translation>
    </message>
    <message>
        <source>there is no such mixing mode</source>
        <translation>no existe ese modo de mezcla</translation>
    </message>
    <message>
        <source>only beta mixing has a beta</source>
        <translation>solo la mezcla beta tiene una beta</translation>
    </message>
    <message>
        <source>there is no such kind of node</source>
        <translation>no existe ese tipo de nodo</translation>
    </message>
    <message>
        <source>a stroke needs at least one</source>
        <translation>un trazo necesita al menos uno</translation>
    </message>
    <message>
        <source>a segment that lifts cannot fade as well</source>
        <translation>un segmento que levanta no puede también atenuar</translation>
    </message>
    <message>
        <source>the segment does not start where the one before it ends</source>
        <translation>el segmento no empieza donde termina el anterior</translation>
    </message>
    <message>
        <source>there is no such kind of paper</source>
        <translation>no existe ese tipo de papel</translation>
    </message>
    <message>
        <source>the paper&apos;s image is missing</source>
        <translation>falta la imagen del papel</translation>
    </message>
    <message>
        <source>the stroke is missing</source>
        <translation>falta el trazo</translation>
    </message>
    <message>
        <source>another stroke has the same id</source>
        <translation>otro trazo tiene el mismo identificador</translation>
    </message>
    <message>
        <source>%1: %2 is not in %3</source>
        <translation>%1: %2 no está en %3</translation>
    </message>
    <message>
        <source>there is no such kind</source>
        <translation>no existe ese tipo</translation>
    </message>
    <message>
        <source>another curve is of the same quantity and input</source>
        <translation>otra curva es de la misma magnitud y entrada</translation>
    </message>
    <message>
        <source>it needs 2 to 16 points [x, y] in [0, 1], from left to right</source>
        <translation>necesita de 2 a 16 puntos [x, y] en [0, 1], de izquierda a derecha</translation>
    </message>
    <message>
        <source>there is no such rule</source>
        <translation>no existe esa regla</translation>
    </message>
    <message>
        <source>it is the same point as from; a gradient needs two</source>
        <translation>es el mismo punto que from; un degradado necesita dos</translation>
    </message>
    <message>
        <source>there is no such grain of paper</source>
        <translation>no existe ese grano de papel</translation>
    </message>
    <message>
        <source>style.xi[1]: %1 is more than 2^(1/3) times xi[0], which is %2</source>
        <translation>style.xi[1]: %1 es más de 2^(1/3) veces xi[0], que es %2</translation>
    </message>
    <message>
        <source>there is no such alignment</source>
        <translation>no existe esa alineación</translation>
    </message>
    <message>
        <source>it is no valid Unicode</source>
        <translation>no es Unicode válido</translation>
    </message>
    <message>
        <source>%1: %2 characters are more than %3</source>
        <translation>%1: %2 caracteres son más de %3</translation>
    </message>
    <message>
        <source>%1: %2 curves are more than %3</source>
        <translation>%1: %2 curvas son más de %3</translation>
    </message>
    <message>
        <source>there is no such blend mode</source>
        <translation>no existe ese modo de fusión</translation>
    </message>
    <message>
        <source>there is no such colour to mark groups</source>
        <translation>no existe ese color para marcar grupos</translation>
    </message>
    <message>
        <source>it needs an image, or a link with the SHA-256 of its file</source>
        <translation>necesita una imagen, o un enlace con el SHA-256 de su archivo</translation>
    </message>
    <message>
        <source>it is no path of a file</source>
        <translation>no es la ruta de un archivo</translation>
    </message>
    <message>
        <source>it has more than 67 million pixels</source>
        <translation>tiene más de 67 millones de píxeles</translation>
    </message>
    <message>
        <source>its corners lie on one line; a picture needs an area</source>
        <translation>sus esquinas están en una línea; una imagen necesita un área</translation>
    </message>
</context>
<context>
    <name>WidthHandle</name>
    <message>
        <source>Drag to set the width by the density, Shift: by the diffusion.</source>
        <translation>Arrastrar para cambiar la anchura por la densidad; Mayús: por la difusión.</translation>
    </message>
    <message>
        <source>Change width</source>
        <translation>Cambiar anchura</translation>
    </message>
</context>
<context>
    <name>compare</name>
    <message>
        <source>The pictures differ in size (%1 × %2 and %3 × %4): render both at one size.</source>
        <translation>Las imágenes difieren en tamaño (%1 × %2 y %3 × %4): dibuje ambas con el mismo tamaño.</translation>
    </message>
</context>
<context>
    <name>suffuse::AboutDialog</name>
    <message>
        <source>About Suffuse</source>
        <translation>Acerca de Suffuse</translation>
    </message>
    <message>
        <source>Icon of Suffuse</source>
        <translation>Icono de Suffuse</translation>
    </message>
    <message>
        <source>Suffuse %1</source>
        <translation>Suffuse %1</translation>
    </message>
    <message>
        <source>Paints with strokes that really diffuse, and stay editable.</source>
        <translation>Pinta con trazos que se difunden de verdad y siguen siendo editables.</translation>
    </message>
    <message>
        <source>Free software under the Apache License 2.0.</source>
        <translation>Software libre bajo la licencia Apache 2.0.</translation>
    </message>
</context>
<context>
    <name>suffuse::AgePlot</name>
    <message>
        <source>No paint here</source>
        <translation>Aquí no hay pintura</translation>
    </message>
    <message>
        <source>density φ, up to %1</source>
        <translation>densidad φ, hasta %1</translation>
    </message>
    <message>
        <source>0 s</source>
        <translation>0 s</translation>
    </message>
    <message>
        <source>age %1 s</source>
        <translation>edad %1 s</translation>
    </message>
</context>
<context>
    <name>suffuse::AlongDialog</name>
    <message>
        <source>Along the Stroke</source>
        <translation>A lo largo del trazo</translation>
    </message>
    <message>
        <source>Curve along the stroke</source>
        <translation>Curva a lo largo del trazo</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Magnitud</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Constante</translation>
    </message>
    <message>
        <source>The same value all along</source>
        <translation>El mismo valor en todo el trazo</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampa</translation>
    </message>
    <message>
        <source>Evenly from one value to another</source>
        <translation>De un valor a otro de forma uniforme</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Dibujada</translation>
    </message>
    <message>
        <source>A curve drawn with the pointer</source>
        <translation>Una curva dibujada con el puntero</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Change along the stroke</source>
        <translation>Cambiar a lo largo del trazo</translation>
    </message>
    <message>
        <source>Drag the line, its ends or its points; a press beside them makes a point, Del removes one. A drawn curve is drawn with the pointer. The dots are the values of the segments.</source>
        <translation>Arrastre la línea, sus extremos o sus puntos; pulsar al lado crea un punto, Supr quita uno. Una curva dibujada se dibuja con el puntero. Los puntos pequeños son los valores de los segmentos.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>The values that there are, as a curve of points that can be moved</source>
        <translation>Los valores que hay, como una curva de puntos que se pueden mover</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escalar</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Sumar</translation>
    </message>
    <message>
        <source>Multiplies all of it; what varies along the stroke stays</source>
        <translation>Lo multiplica todo; lo que varía a lo largo del trazo se mantiene</translation>
    </message>
    <message>
        <source>Is added to all of it; what varies along the stroke stays</source>
        <translation>Se suma a todo; lo que varía a lo largo del trazo se mantiene</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>Trazo %1</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s)</source>
        <translation>
            <numerusform>%n trazo</numerusform>
            <numerusform>%n trazos</numerusform>
        </translation>
    </message>
    <message>
        <source>Along the Stroke – %1</source>
        <translation>A lo largo del trazo – %1</translation>
    </message>
    <message>
        <source>Nothing is selected that can be changed. Click a stroke, and its values are shown here.</source>
        <translation>No hay nada seleccionado que se pueda cambiar. Haga clic en un trazo y aquí se mostrarán sus valores.</translation>
    </message>
</context>
<context>
    <name>suffuse::AreaRow</name>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Which part of the canvas is drawn</source>
        <translation>Qué parte del lienzo se dibuja</translation>
    </message>
    <message>
        <source>Whole canvas</source>
        <translation>Lienzo entero</translation>
    </message>
    <message>
        <source>What is painted</source>
        <translation>Lo pintado</translation>
    </message>
    <message>
        <source>Selected strokes</source>
        <translation>Trazos seleccionados</translation>
    </message>
    <message>
        <source>What the window shows</source>
        <translation>Lo que muestra la ventana</translation>
    </message>
    <message>
        <source>By numbers</source>
        <translation>Con números</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>Borde izquierdo</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge</source>
        <translation>Borde superior</translation>
    </message>
    <message>
        <source>W</source>
        <translation>An</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>H</source>
        <translation>Al</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
</context>
<context>
    <name>suffuse::AssistantRow</name>
    <message>
        <source>Parallel Lines</source>
        <translation>Líneas paralelas</translation>
    </message>
    <message>
        <source>Vanishing Point</source>
        <translation>Punto de fuga</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspectiva</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Elipse</translation>
    </message>
    <message>
        <source>Concentric Ellipses</source>
        <translation>Elipses concéntricas</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Regla</translation>
    </message>
    <message>
        <source>What is made next</source>
        <translation>Qué se crea a continuación</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Horizontal place of the chosen point, canvas units</source>
        <translation>Posición horizontal del punto elegido, unidades del lienzo</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Vertical place of the chosen point, canvas units</source>
        <translation>Posición vertical del punto elegido, unidades del lienzo</translation>
    </message>
    <message>
        <source>∠</source>
        <translation>∠</translation>
    </message>
    <message>
        <source>Angle of the line or of the first half axis, clockwise</source>
        <translation>Ángulo de la línea o del primer semieje, en sentido horario</translation>
    </message>
    <message>
        <source>a</source>
        <translation>a</translation>
    </message>
    <message>
        <source>First half axis of the ellipse, canvas units</source>
        <translation>Primer semieje de la elipse, unidades del lienzo</translation>
    </message>
    <message>
        <source>b</source>
        <translation>b</translation>
    </message>
    <message>
        <source>Second half axis of the ellipse, canvas units</source>
        <translation>Segundo semieje de la elipse, unidades del lienzo</translation>
    </message>
    <message>
        <source>A new one in the middle of the view</source>
        <translation>Uno nuevo en el centro de la vista</translation>
    </message>
    <message>
        <source>New assistant</source>
        <translation>Nuevo asistente</translation>
    </message>
</context>
<context>
    <name>suffuse::AssistantTool</name>
    <message>
        <source>Drag for a new assistant; drag its points or lines to change it. Shift: in steps. Tab: next point. Return: a new one.</source>
        <translation>Arrastrar: nuevo asistente; arrastrar sus puntos o líneas lo cambia. Mayús: por pasos. Tab: punto siguiente. Intro: uno nuevo.</translation>
    </message>
    <message>
        <source>%1, point %2 of %3: x %4, y %5</source>
        <extracomment>%1: an assistant, as &quot;Vanishing Point&quot;</extracomment>
        <translation>%1, punto %2 de %3: x %4, y %5</translation>
    </message>
</context>
<context>
    <name>suffuse::AttributeBrushTool</name>
    <message>
        <source>How fast it is laid down</source>
        <translation>Con qué rapidez se aplica</translation>
    </message>
    <message>
        <source>Drag over strokes to paint the chosen value onto their segments. [ and ] change the size.</source>
        <translation>Arrastrar sobre trazos para pintar el valor elegido en sus segmentos. [ y ] cambian el tamaño.</translation>
    </message>
    <message>
        <source>Drag over the selection to paint the chosen value onto its segments. [ and ] change the size.</source>
        <translation>Arrastrar sobre la selección para pintar el valor elegido en sus segmentos. [ y ] cambian el tamaño.</translation>
    </message>
    <message>
        <source>Paint diffusion</source>
        <translation>Pintar difusión</translation>
    </message>
    <message>
        <source>Paint density</source>
        <translation>Pintar densidad</translation>
    </message>
    <message>
        <source>Paint granulation</source>
        <translation>Pintar granulación</translation>
    </message>
    <message>
        <source>Paint colour</source>
        <translation>Pintar color</translation>
    </message>
    <message>
        <source>Paint opacity</source>
        <translation>Pintar opacidad</translation>
    </message>
    <message>
        <source>Paint drying time</source>
        <translation>Pintar tiempo de secado</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensidad</translation>
    </message>
    <message>
        <source>A fill has a density of its own, ρ, which the inspector shows. It can be painted relative to what it is.</source>
        <translation>Un relleno tiene una densidad propia, ρ, que muestra el inspector. Se puede pintar en relación con lo que es.</translation>
    </message>
</context>
<context>
    <name>suffuse::BackupsDialog</name>
    <message>
        <source>Restore Backup</source>
        <translation>Restaurar copia de seguridad</translation>
    </message>
    <message>
        <source>There is no backup of “%1” yet. When it is saved again, the version before is kept; Settings says how many are.</source>
        <translation>Aún no hay ninguna copia de seguridad de «%1». La próxima vez que se guarde, se conservará la versión anterior; los Ajustes dicen cuántas se guardan.</translation>
    </message>
    <message>
        <source>An earlier version of “%1” takes the place of the painting as it is now. Undo brings that back, and no file changes until you save.</source>
        <translation>Una versión anterior de «%1» ocupa el lugar de la obra tal como está ahora. Deshacer la recupera, y ningún archivo cambia hasta que guarde.</translation>
    </message>
    <message>
        <source>Backups, the newest first</source>
        <translation>Copias de seguridad, la más reciente primero</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Guardada</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Trazos</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Restaurar</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>no se puede leer</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushColourPage</name>
    <message>
        <source>Second colour</source>
        <translation>Segundo color</translation>
    </message>
    <message>
        <source>&amp;Take the Current Colour</source>
        <translation>&amp;Tomar el color actual</translation>
    </message>
    <message>
        <source>Makes the current colour the second one</source>
        <translation>Convierte el color actual en el segundo</translation>
    </message>
    <message>
        <source>The row Second colour of the curves says when it comes through.</source>
        <translation>La fila Segundo color de las curvas dice cuándo aparece.</translation>
    </message>
    <message>
        <source>Strays from the colour by</source>
        <translation>Se aparta del color en</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rojo</translation>
    </message>
    <message>
        <source>At most so much redder or less red</source>
        <translation>Cuánto más o menos rojo, como máximo</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Amarillo</translation>
    </message>
    <message>
        <source>At most so much more or less yellow</source>
        <translation>Cuánto más o menos amarillo, como máximo</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Azul</translation>
    </message>
    <message>
        <source>At most so much bluer or less blue</source>
        <translation>Cuánto más o menos azul, como máximo</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>Claridad</translation>
    </message>
    <message>
        <source>At most so much lighter or darker</source>
        <translation>Cuánto más claro o más oscuro, como máximo</translation>
    </message>
    <message>
        <source>Drifts along the stroke</source>
        <translation>Deriva a lo largo del trazo</translation>
    </message>
    <message>
        <source>Else each stroke has one colour</source>
        <translation>Si no, cada trazo tiene un solo color</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushCombo</name>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search brushes</source>
        <translation>Buscar pinceles</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushCurvesPage</name>
    <message>
        <source>Second colour</source>
        <translation>Segundo color</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Presión</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Inclinación</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>By stroke</source>
        <translation>Por trazo</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Deriva</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Curvas</translation>
    </message>
    <message>
        <source>What changes with what: a tick switches a curve on, a click shows it below</source>
        <translation>Qué cambia con qué: una marca activa una curva; un clic la muestra debajo</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>Drag points; click for another one, drag it out to take it away</source>
        <translation>Arrastre los puntos; haga clic para añadir otro; arrastre uno fuera para quitarlo</translation>
    </message>
    <message>
        <source>Full speed</source>
        <translation>Velocidad máxima</translation>
    </message>
    <message>
        <source>Speed at the right end of its curves, in sizes a second</source>
        <translation>Velocidad en el extremo derecho de sus curvas, en tamaños por segundo</translation>
    </message>
    <message>
        <source> sizes/s</source>
        <translation> tam./s</translation>
    </message>
    <message>
        <source>Full distance</source>
        <translation>Distancia máxima</translation>
    </message>
    <message>
        <source>Distance at the right end of its curves, in sizes</source>
        <translation>Distancia en el extremo derecho de sus curvas, en tamaños</translation>
    </message>
    <message>
        <source> sizes</source>
        <translation> tam.</translation>
    </message>
    <message>
        <source>Way on which what drifts becomes another, in sizes</source>
        <translation>Recorrido en el que lo que deriva cambia por completo, en tamaños</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushDialog</name>
    <message>
        <source>A stroke of the brush</source>
        <translation>Un trazo del pincel</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Pintura</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Curvas</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Shape and hand</source>
        <translation>Forma y mano</translation>
    </message>
    <message>
        <source>Settings of the brush</source>
        <translation>Ajustes del pincel</translation>
    </message>
    <message>
        <source>Keeps the changes in the brush of this name; built-in brushes stay as they are</source>
        <translation>Guarda los cambios en el pincel de este nombre; los pinceles incluidos se quedan como están</translation>
    </message>
    <message>
        <source>Keeps the brush under another name</source>
        <translation>Guarda el pincel con otro nombre</translation>
    </message>
    <message>
        <source>Closes this window; the brush stays in hand as it is</source>
        <translation>Cierra esta ventana; el pincel en uso se queda como está</translation>
    </message>
    <message>
        <source>Brush: %1</source>
        <translation>Pincel: %1</translation>
    </message>
    <message>
        <source>&amp;Save Changes</source>
        <translation>&amp;Guardar cambios</translation>
    </message>
    <message>
        <source>Save as &amp;New…</source>
        <translation>Guardar como &amp;nuevo…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Ce&amp;rrar</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushGrid</name>
    <message>
        <source>Brushes</source>
        <translation>Pinceles</translation>
    </message>
    <message>
        <source>%1: size %2, dry after %3</source>
        <translation>%1: tamaño %2, seco tras %3</translation>
    </message>
    <message>
        <source>Changed since the program was started; Reload in its menu undoes that</source>
        <translation>Cambiado desde que se inició el programa; Recargar, en su menú, lo deshace</translation>
    </message>
    <message>
        <source>There is no such brush.</source>
        <translation>No existe ese pincel.</translation>
    </message>
    <message>
        <source>Choose a brush to paint with it.</source>
        <translation>Elija un pincel para pintar con él.</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushHandPage</name>
    <message>
        <source>Tip</source>
        <translation>Punta</translation>
    </message>
    <message>
        <source>Of the tip, against the path or the canvas</source>
        <translation>De la punta, respecto al recorrido o al lienzo</translation>
    </message>
    <message>
        <source>Turns with the path</source>
        <translation>Gira con el recorrido</translation>
    </message>
    <message>
        <source>Else it keeps its angle on the canvas, as a broad nib does</source>
        <translation>Si no, mantiene su ángulo en el lienzo, como una plumilla ancha</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Extremos</translation>
    </message>
    <message>
        <source> sizes</source>
        <translation> tam.</translation>
    </message>
    <message>
        <source>Taper in</source>
        <translation>Afinado inicial</translation>
    </message>
    <message>
        <source>Length on which the stroke grows from its tip</source>
        <translation>Longitud en la que el trazo crece desde su punta</translation>
    </message>
    <message>
        <source>Taper out</source>
        <translation>Afinado final</translation>
    </message>
    <message>
        <source>Length on which it runs out when the pen lifts</source>
        <translation>Longitud en la que se desvanece al levantar el lápiz</translation>
    </message>
    <message>
        <source>Tip size</source>
        <translation>Tamaño de la punta</translation>
    </message>
    <message>
        <source>Size at the very end</source>
        <translation>Tamaño en el extremo mismo</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Mano</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Suavizado</translation>
    </message>
    <message>
        <source>Steadies the hand: the stroke follows the pen softly, or is pulled on a string</source>
        <translation>Da firmeza a la mano: el trazo sigue suavemente al lápiz, o se arrastra con una cuerda</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Muestreo</translation>
    </message>
    <message>
        <source>Time between the points that the curve is fitted through</source>
        <translation>Tiempo entre los puntos por los que se ajusta la curva</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushLibrary</name>
    <message>
        <source>Brush</source>
        <translation>Pincel</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: the folder could not be made; check its permissions</source>
        <translation>%1: no se ha podido crear la carpeta; compruebe sus permisos</translation>
    </message>
    <message>
        <source>%1 is a built-in brush; save it under a name of its own</source>
        <translation>%1 es un pincel incluido; guárdelo con otro nombre</translation>
    </message>
    <message>
        <source>A brush needs a name</source>
        <translation>Un pincel necesita un nombre</translation>
    </message>
    <message>
        <source>There is a brush “%1” already</source>
        <translation>Ya existe un pincel «%1»</translation>
    </message>
    <message>
        <source>%1 is a built-in brush; it stays</source>
        <translation>%1 es un pincel incluido; no se puede quitar</translation>
    </message>
    <message>
        <source>%1 could not be removed; check its permissions</source>
        <translation>No se ha podido quitar %1; compruebe sus permisos</translation>
    </message>
    <message>
        <source>There is no brush “%1”</source>
        <translation>No existe ningún pincel «%1»</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushMenu</name>
    <message>
        <source>&amp;Edit Brush…</source>
        <translation>&amp;Editar pincel…</translation>
    </message>
    <message>
        <source>&amp;Favourite</source>
        <translation>&amp;Favorito</translation>
    </message>
    <message>
        <source>&amp;Save Changes</source>
        <translation>&amp;Guardar cambios</translation>
    </message>
    <message>
        <source>Save as &amp;New…</source>
        <translation>Guardar como &amp;nuevo…</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplicar</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>Cambiar no&amp;mbre…</translation>
    </message>
    <message>
        <source>De&amp;lete…</source>
        <translation>E&amp;liminar…</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importar…</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportar…</translation>
    </message>
    <message>
        <source>Save Brush</source>
        <translation>Guardar pincel</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Rename Brush</source>
        <translation>Cambiar nombre del pincel</translation>
    </message>
    <message>
        <source>Delete the brush “%1”?</source>
        <translation>¿Eliminar el pincel «%1»?</translation>
    </message>
    <message>
        <source>Strokes painted with it stay.</source>
        <translation>Los trazos pintados con él se conservan.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Import Brushes</source>
        <translation>Importar pinceles</translation>
    </message>
    <message>
        <source>Brushes (*.suffuse-brush *.myb);;All files (*)</source>
        <translation>Pinceles (*.suffuse-brush *.myb);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>%1: these settings have no counterpart here: %2</source>
        <translation>%1: estos ajustes no tienen equivalente aquí: %2</translation>
    </message>
    <message>
        <source>Export Brush</source>
        <translation>Exportar pincel</translation>
    </message>
    <message>
        <source>Suffuse brush</source>
        <translation>Pincel de Suffuse</translation>
    </message>
    <message>
        <source>Rel&amp;oad</source>
        <translation>&amp;Recargar</translation>
    </message>
    <message>
        <source>&amp;Apply to Selection</source>
        <translation>&amp;Aplicar a la selección</translation>
    </message>
    <message>
        <source>&amp;Whole Brush</source>
        <translation>&amp;Pincel entero</translation>
    </message>
    <message>
        <source>&amp;Form Only</source>
        <translation>Solo &amp;forma</translation>
    </message>
    <message>
        <source>&amp;Colour Only</source>
        <translation>Solo &amp;color</translation>
    </message>
    <message>
        <source>&amp;Texture Only</source>
        <translation>Solo &amp;textura</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPaintPage</name>
    <message>
        <source>Style</source>
        <translation>Estilo</translation>
    </message>
    <message>
        <source>How density becomes coverage.</source>
        <translation>Cómo la densidad se convierte en cobertura.</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>Mezcla</translation>
    </message>
    <message>
        <source>How the paint mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>Cómo se mezcla la pintura con lo que hay debajo: cubre, o los pigmentos se suman.</translation>
    </message>
    <message>
        <source>How long the paint spreads; the size stays</source>
        <translation>Cuánto tiempo se expande la pintura; el tamaño se mantiene</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPalette</name>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>How large the painting is shown</source>
        <translation>A qué tamaño se muestra la obra</translation>
    </message>
    <message>
        <source>Brush palette</source>
        <translation>Paleta de pinceles</translation>
    </message>
    <message>
        <source>Choose what to paint with. The colour stays.</source>
        <translation>Elija con qué pintar. El color se mantiene.</translation>
    </message>
    <message>
        <source>Current colour</source>
        <translation>Color actual</translation>
    </message>
    <message>
        <source>Near colours</source>
        <translation>Colores próximos</translation>
    </message>
    <message>
        <source>Lighter and darker, the neighbouring hues, and from grey to full</source>
        <translation>Más claros y más oscuros, los tonos vecinos, y del gris al color pleno</translation>
    </message>
    <message>
        <source>Painted with last</source>
        <translation>Último usado al pintar</translation>
    </message>
    <message>
        <source>Recent colours</source>
        <translation>Colores recientes</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPanel</name>
    <message>
        <source>Choose what to paint with. The colour stays.</source>
        <translation>Elija con qué pintar. El color se mantiene.</translation>
    </message>
    <message>
        <source>Reset brush</source>
        <translation>Restablecer pincel</translation>
    </message>
    <message>
        <source>Back to the brush as it came</source>
        <translation>Volver al pincel original</translation>
    </message>
    <message>
        <source>%1 (changed)</source>
        <translation>%1 (cambiado)</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search brushes</source>
        <translation>Buscar pinceles</translation>
    </message>
    <message>
        <source>Shows brushes and groups with this in their name</source>
        <translation>Muestra los pinceles y grupos con este texto en el nombre</translation>
    </message>
    <message>
        <source>Favourites only</source>
        <translation>Solo favoritos</translation>
    </message>
    <message>
        <source>Show favourites only; the first nine have the keys 1 to 9</source>
        <translation>Mostrar solo los favoritos; los nueve primeros tienen las teclas 1 a 9</translation>
    </message>
    <message>
        <source>Brush menu</source>
        <translation>Menú del pincel</translation>
    </message>
    <message>
        <source>Edit, save, import and export brushes</source>
        <translation>Editar, guardar, importar y exportar pinceles</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushTool</name>
    <message>
        <source>Brush stroke</source>
        <translation>Trazo de pincel</translation>
    </message>
    <message>
        <source>Shift+drag to go on with the selected stroke from its end.</source>
        <translation>Mayús+arrastrar para continuar el trazo seleccionado desde su final.</translation>
    </message>
    <message>
        <source>Extend stroke</source>
        <translation>Prolongar trazo</translation>
    </message>
    <message>
        <source>This stroke lies beyond the canvas: View ▸ Show Paint beyond the Canvas shows it.</source>
        <translation>Este trazo está fuera del lienzo: Ver ▸ Mostrar pintura fuera del lienzo lo muestra.</translation>
    </message>
    <message>
        <source>All that you paint stays editable: press V and click paint to move, scale or recolour it.</source>
        <translation>Todo lo que pinte sigue siendo editable: pulse V y haga clic en la pintura para moverla, escalarla o recolorearla.</translation>
    </message>
    <message>
        <source>Drag to paint, tap for a dot. Right button: palette. Shift+drag: size, opacity. Ctrl+click: the picture&apos;s colour, with Shift the stroke&apos;s own.</source>
        <translation>Arrastrar: pintar; toque: punto. Botón derecho: paleta. Mayús+arrastrar: tamaño, opacidad. Ctrl+clic: color de la imagen; con Mayús, del trazo.</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushToolOptions</name>
    <message>
        <source>Width of a dry line at full pressure, in units ([ and ] change it)</source>
        <translation>Anchura de una línea seca a plena presión, en unidades ([ y ] la cambian)</translation>
    </message>
    <message>
        <source>How much the paint covers ({ and } change it)</source>
        <translation>Cuánto cubre la pintura ({ y } lo cambian)</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pincel</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Suavizado</translation>
    </message>
    <message>
        <source>Steadies the hand: the stroke follows the pen softly, or is pulled on a string</source>
        <translation>Da firmeza a la mano: el trazo sigue suavemente al lápiz, o se arrastra con una cuerda</translation>
    </message>
    <message>
        <source>Amount of smoothing</source>
        <translation>Cantidad de suavizado</translation>
    </message>
    <message>
        <source>How strongly it lags behind, or how long the string is</source>
        <translation>Cuánto se retrasa, o lo larga que es la cuerda</translation>
    </message>
    <message>
        <source>Own brush</source>
        <translation>Pincel propio</translation>
    </message>
    <message>
        <source>What to paint with. Click: all brushes, with pictures.</source>
        <translation>Con qué pintar. Clic: todos los pinceles, con imágenes.</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasDrops</name>
    <message>
        <source>Drop colour</source>
        <translation>Soltar color</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasMenu</name>
    <message>
        <source>Under the Pointer</source>
        <translation>Bajo el puntero</translation>
    </message>
    <message>
        <source>Further Below</source>
        <translation>Más abajo</translation>
    </message>
    <message>
        <source>A&amp;rrange</source>
        <translation>O&amp;rganizar</translation>
    </message>
    <message>
        <source>R&amp;eshape</source>
        <translation>R&amp;eformar</translation>
    </message>
    <message>
        <source>Dr&amp;ying</source>
        <translation>&amp;Secado</translation>
    </message>
    <message>
        <source>Brush and C&amp;olours</source>
        <translation>Pincel y c&amp;olores</translation>
    </message>
    <message>
        <source>Apply &amp;Brush</source>
        <translation>Aplicar &amp;pincel</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Aspecto</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>&amp;Nodos</translation>
    </message>
    <message>
        <source>Trans&amp;form</source>
        <translation>Trans&amp;formar</translation>
    </message>
    <message>
        <source>Com&amp;bine and Break</source>
        <translation>Com&amp;binar y romper</translation>
    </message>
    <message>
        <source>Select S&amp;ame</source>
        <translation>Seleccionar con el &amp;mismo</translation>
    </message>
    <message>
        <source>Under&amp;lay</source>
        <translation>Ca&amp;lco</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Colores</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasSection</name>
    <message>
        <source>Canvas</source>
        <translation>Lienzo</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Background colour. Click: white.</source>
        <translation>Color de fondo. Clic: blanco.</translation>
    </message>
    <message>
        <source>Change background</source>
        <translation>Cambiar fondo</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>Resize canvas</source>
        <translation>Cambiar tamaño del lienzo</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>Width of the canvas in units; a unit is a pixel at 100 %.</source>
        <translation>Anchura del lienzo en unidades; una unidad es un píxel al 100 %.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Height of the canvas in units; a unit is a pixel at 100 %.</source>
        <translation>Altura del lienzo en unidades; una unidad es un píxel al 100 %.</translation>
    </message>
    <message>
        <source>%1 × %2 mm at %3 dpi</source>
        <translation>%1 × %2 mm a %3 ppp</translation>
    </message>
    <message>
        <source>%1 × %2 in at %3 dpi</source>
        <translation>%1 × %2 in a %3 ppp</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textura</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Image…</source>
        <translation>Imagen…</translation>
    </message>
    <message>
        <source>The paper&apos;s grain, which granulating strokes show.</source>
        <translation>El grano del papel, que muestran los trazos con granulación.</translation>
    </message>
    <message>
        <source>Take the grain from another picture file.</source>
        <translation>Tomar el grano de otro archivo de imagen.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Another number gives another grain.</source>
        <translation>Otro número da otro grano.</translation>
    </message>
    <message>
        <source>Change paper</source>
        <translation>Cambiar papel</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Paper image</source>
        <translation>Imagen del papel</translation>
    </message>
    <message>
        <source>%1 cannot be used as paper: %2</source>
        <translation>%1 no se puede usar como papel: %2</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personalizado</translation>
    </message>
    <message>
        <source>Size of the coarsest grain or of a thread in units, or units per pixel of the image.</source>
        <translation>Tamaño del grano más grueso o de un hilo en unidades, o unidades por píxel de la imagen.</translation>
    </message>
    <message>
        <source>Choose &amp;Image…</source>
        <translation>Elegir &amp;imagen…</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasWidget</name>
    <message>
        <source>Canvas</source>
        <translation>Lienzo</translation>
    </message>
    <message>
        <source>The picture goes to the screen by way of memory: %1</source>
        <translation>La imagen llega a la pantalla pasando por la memoria: %1</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourChips</name>
    <message>
        <source>%1, opacity %2 %</source>
        <translation>%1, opacidad %2 %</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourHeader</name>
    <message>
        <source>Shows and changes the colour that is painted with</source>
        <translation>Muestra y cambia el color con el que se pinta</translation>
    </message>
    <message>
        <source>Colour of what is selected</source>
        <translation>Color de lo seleccionado</translation>
    </message>
    <message>
        <source>Shows and changes the colour of what is selected; it keeps its opacity</source>
        <translation>Muestra y cambia el color de lo seleccionado, que conserva su opacidad</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Variar</translation>
    </message>
    <message>
        <source>Several colours</source>
        <translation>Varios colores</translation>
    </message>
    <message>
        <source>Set: all colours become the same.
Shift: all change as the shown one does, and keep their differences.</source>
        <translation>Fijar: todos los colores pasan a ser el mismo.
Variar: todos cambian como el que se muestra y conservan sus diferencias.</translation>
    </message>
    <message>
        <source>Apply to selection</source>
        <translation>Aplicar a la selección</translation>
    </message>
    <message>
        <source>Apply to selection: gives the selected segments the brush&apos;s colour. They keep their opacity.</source>
        <translation>Aplicar a la selección: da a los segmentos seleccionados el color del pincel. Conservan su opacidad.</translation>
    </message>
    <message>
        <source>Apply colour</source>
        <translation>Aplicar color</translation>
    </message>
    <message>
        <source>Colour of the brush</source>
        <translation>Color del pincel</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourPanel</name>
    <message>
        <source>Current colour</source>
        <translation>Color actual</translation>
    </message>
    <message>
        <source>The colour that is painted with</source>
        <translation>El color con el que se pinta</translation>
    </message>
    <message>
        <source>Previous colour</source>
        <translation>Color anterior</translation>
    </message>
    <message>
        <source>The colour painted with last. Click: back to it.</source>
        <translation>El color con el que se pintó por última vez. Clic: volver a él.</translation>
    </message>
    <message>
        <source>Hex</source>
        <translation>Hex</translation>
    </message>
    <message>
        <source>sRGB colour as #rrggbb, #rgb or CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal</source>
        <translation>Color sRGB como #rrggbb, #rgb o CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal</translation>
    </message>
    <message>
        <source>“%1” is not a colour. Write it as #rrggbb, for example #2f6690.</source>
        <translation>«%1» no es un color. Escríbalo como #rrggbb, por ejemplo #2f6690.</translation>
    </message>
    <message>
        <source>Recent colours</source>
        <translation>Colores recientes</translation>
    </message>
    <message>
        <source>Colours painted with before. Click: take it.</source>
        <translation>Colores con los que se ha pintado antes. Clic: tomarlo.</translation>
    </message>
    <message>
        <source>Colours painted with come here.</source>
        <translation>Aquí aparecen los colores con los que se pinta.</translation>
    </message>
    <message>
        <source>RYB</source>
        <extracomment>red, yellow, blue; hue, saturation, value; red, green, blue</extracomment>
        <translation>RYB</translation>
    </message>
    <message>
        <source>HSV</source>
        <translation>HSV</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>Sliders</source>
        <translation>Deslizadores</translation>
    </message>
    <message>
        <source>The numbers that the sliders show: paint as red, yellow and blue, or the screen&apos;s hue, saturation and value, or its red, green and blue</source>
        <translation>Los números que muestran los deslizadores: la pintura como rojo, amarillo y azul, o el tono, la saturación y el valor de la pantalla, o su rojo, verde y azul</translation>
    </message>
    <message>
        <source>Colour of the brush</source>
        <translation>Color del pincel</translation>
    </message>
    <message>
        <source>The colour of the brush. Click: take it.</source>
        <translation>El color del pincel. Clic: tomarlo.</translation>
    </message>
    <message>
        <source>several</source>
        <translation>varios</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourTarget</name>
    <message>
        <source>Colour of the brush</source>
        <translation>Color del pincel</translation>
    </message>
    <message>
        <source>Colour of a swatch</source>
        <translation>Color de una muestra</translation>
    </message>
    <message>
        <source>Colour of the swatch “%1”</source>
        <translation>Color de la muestra «%1»</translation>
    </message>
    <message numerus="yes">
        <source>Colours of %Ln segment(s)</source>
        <translation>
            <numerusform>Colores de %Ln segmento</numerusform>
            <numerusform>Colores de %Ln segmentos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour of %Ln segment(s)</source>
        <translation>
            <numerusform>Color de %Ln segmento</numerusform>
            <numerusform>Color de %Ln segmentos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colours of %Ln stroke(s)</source>
        <translation>
            <numerusform>Colores de %Ln trazo</numerusform>
            <numerusform>Colores de %Ln trazos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour of %Ln stroke(s)</source>
        <translation>
            <numerusform>Color de %Ln trazo</numerusform>
            <numerusform>Color de %Ln trazos</numerusform>
        </translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Cambiar color</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Cambiar opacidad</translation>
    </message>
    <message>
        <source>Change swatch</source>
        <translation>Cambiar muestra</translation>
    </message>
    <message>
        <source>Colour of the fill</source>
        <translation>Color del relleno</translation>
    </message>
    <message>
        <source>Colours of the fill</source>
        <translation>Colores del relleno</translation>
    </message>
    <message>
        <source>Colour of the gradient&apos;s end</source>
        <translation>Color del final del degradado</translation>
    </message>
    <message>
        <source>Colour of the gradient&apos;s start</source>
        <translation>Color del inicio del degradado</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourWheel</name>
    <message>
        <source>Colour wheel</source>
        <translation>Rueda de color</translation>
    </message>
    <message>
        <source>Ring: hue in the order of pigments. Triangle: pure, white and black.
Arrow keys work too.</source>
        <translation>Anillo: tono en el orden de los pigmentos. Triángulo: puro, blanco y negro.
Las teclas de flecha también funcionan.</translation>
    </message>
</context>
<context>
    <name>suffuse::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Buscar una orden</translation>
    </message>
    <message>
        <source>Commands, brushes, docks, recent files</source>
        <translation>Órdenes, pinceles, paneles, archivos recientes</translation>
    </message>
    <message>
        <source>Parts of names in any order; Enter runs the chosen one, Escape goes back.</source>
        <translation>Partes de nombres en cualquier orden; Intro ejecuta lo elegido, Esc vuelve atrás.</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Encontrado</translation>
    </message>
    <message>
        <source>Click one to run it.</source>
        <translation>Haga clic en una orden para ejecutarla.</translation>
    </message>
    <message>
        <source>Nothing is called so.</source>
        <translation>Nada se llama así.</translation>
    </message>
    <message>
        <source>It cannot be used now.</source>
        <translation>No se puede usar ahora.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pincel</translation>
    </message>
    <message>
        <source>Open Recent</source>
        <translation>Abrir reciente</translation>
    </message>
    <message>
        <source>“%1” cannot be used now.</source>
        <translation>«%1» no se puede usar ahora.</translation>
    </message>
</context>
<context>
    <name>suffuse::Commands</name>
    <message>
        <source>&amp;New…</source>
        <translation>N&amp;ueva…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Guardar &amp;como…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xportar…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>&amp;Close Window</source>
        <translation>Cerrar ve&amp;ntana</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>Ctrl+Q</source>
        <translation>Ctrl+Q</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>Des&amp;hacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>E&amp;liminar</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>&amp;Duplicar</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>Seleccion&amp;ar todo</translation>
    </message>
    <message>
        <source>D&amp;eselect</source>
        <translation>An&amp;ular selección</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>Settin&amp;gs…</source>
        <translation>A&amp;justes…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pincel</translation>
    </message>
    <message>
        <source>Paint strokes</source>
        <translation>Pintar trazos</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Seleccionar</translation>
    </message>
    <message>
        <source>Select and move strokes</source>
        <translation>Seleccionar y mover trazos</translation>
    </message>
    <message>
        <source>Se&amp;gments</source>
        <translation>Se&amp;gmentos</translation>
    </message>
    <message>
        <source>&amp;Hand</source>
        <translation>&amp;Mano</translation>
    </message>
    <message>
        <source>Move the canvas</source>
        <translation>Mover el lienzo</translation>
    </message>
    <message>
        <source>&amp;Raise</source>
        <translation>&amp;Elevar</translation>
    </message>
    <message>
        <source>&amp;Lower</source>
        <translation>Ba&amp;jar</translation>
    </message>
    <message>
        <source>Raise to &amp;Top</source>
        <translation>&amp;Traer al frente</translation>
    </message>
    <message>
        <source>Lower to &amp;Bottom</source>
        <translation>Enviar al f&amp;ondo</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>&amp;Acercar</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>Ale&amp;jar</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>&amp;100 %</translation>
    </message>
    <message>
        <source>&amp;Fit the Canvas</source>
        <translation>&amp;Encajar el lienzo</translation>
    </message>
    <message>
        <source>Turn &amp;Left</source>
        <translation>Girar a la iz&amp;quierda</translation>
    </message>
    <message>
        <source>Turn &amp;Right</source>
        <translation>Gi&amp;rar a la derecha</translation>
    </message>
    <message>
        <source>&amp;Upright</source>
        <translation>Sin &amp;giro</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>Re&amp;flejar</translation>
    </message>
    <message>
        <source>&amp;Hide the Docks</source>
        <translation>Oc&amp;ultar los paneles</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>Resta&amp;blecer la disposición</translation>
    </message>
    <message>
        <source>Docks and tool bars go back to where they stand at the first start</source>
        <translation>Los paneles y las barras de herramientas vuelven adonde están en el primer inicio</translation>
    </message>
    <message>
        <source>Full S&amp;creen</source>
        <translation>Pantalla co&amp;mpleta</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts…</source>
        <translation>&amp;Atajos de teclado…</translation>
    </message>
    <message>
        <source>&amp;About Suffuse…</source>
        <translation>A&amp;cerca de Suffuse…</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>A&amp;brir reciente</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Docks</source>
        <translation>Panele&amp;s</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Herramientas</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Ay&amp;uda</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cor&amp;tar</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Pegar</translation>
    </message>
    <message>
        <source>Paste &amp;in Place</source>
        <translation>Pegar &amp;en su sitio</translation>
    </message>
    <message>
        <source>Ctrl+Alt+V</source>
        <translation>Ctrl+Alt+V</translation>
    </message>
    <message>
        <source>Paste strokes where they were</source>
        <translation>Pegar los trazos donde estaban</translation>
    </message>
    <message>
        <source>Edit segments, nodes and handles of strokes</source>
        <translation>Editar segmentos, nodos y tiradores de trazos</translation>
    </message>
    <message>
        <source>&amp;Knife</source>
        <translation>Cuc&amp;hilla</translation>
    </message>
    <message>
        <source>Cut strokes along a line</source>
        <translation>Cortar trazos a lo largo de una línea</translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation>G&amp;oma de borrar</translation>
    </message>
    <message>
        <source>&amp;Attribute Brush</source>
        <translation>Pi&amp;ncel de atributos</translation>
    </message>
    <message>
        <source>Paint values onto segments</source>
        <translation>Pintar valores en los segmentos</translation>
    </message>
    <message>
        <source>Eye&amp;dropper</source>
        <translation>Cuent&amp;agotas</translation>
    </message>
    <message>
        <source>Pick a colour</source>
        <translation>Tomar un color</translation>
    </message>
    <message>
        <source>&amp;Insert Nodes</source>
        <translation>&amp;Insertar nodos</translation>
    </message>
    <message>
        <source>Insert a node into each selected segment</source>
        <translation>Insertar un nodo en cada segmento seleccionado</translation>
    </message>
    <message>
        <source>&amp;Corner</source>
        <translation>&amp;Esquina</translation>
    </message>
    <message>
        <source>Shift+C</source>
        <translation>Shift+C</translation>
    </message>
    <message>
        <source>Make the selected nodes corners</source>
        <translation>Convertir los nodos seleccionados en esquinas</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>&amp;Suavizar</translation>
    </message>
    <message>
        <source>Shift+S</source>
        <translation>Shift+S</translation>
    </message>
    <message>
        <source>Make the selected nodes smooth</source>
        <translation>Hacer suaves los nodos seleccionados</translation>
    </message>
    <message>
        <source>S&amp;ymmetric</source>
        <translation>Si&amp;métrico</translation>
    </message>
    <message>
        <source>Shift+Y</source>
        <translation>Shift+Y</translation>
    </message>
    <message>
        <source>Make the selected nodes symmetric</source>
        <translation>Hacer simétricos los nodos seleccionados</translation>
    </message>
    <message>
        <source>&amp;Break Strokes</source>
        <translation>&amp;Romper trazos</translation>
    </message>
    <message>
        <source>Shift+B</source>
        <translation>Shift+B</translation>
    </message>
    <message>
        <source>Break strokes at the selected nodes</source>
        <translation>Romper los trazos en los nodos seleccionados</translation>
    </message>
    <message>
        <source>&amp;Join Nodes</source>
        <translation>&amp;Unir nodos</translation>
    </message>
    <message>
        <source>Shift+J</source>
        <translation>Shift+J</translation>
    </message>
    <message>
        <source>Join two selected end nodes</source>
        <translation>Unir dos nodos extremos seleccionados</translation>
    </message>
    <message>
        <source>&amp;Delete Segments</source>
        <translation>E&amp;liminar segmentos</translation>
    </message>
    <message>
        <source>Ctrl+Del</source>
        <translation>Ctrl+Del</translation>
    </message>
    <message>
        <source>Brid&amp;ge Segments</source>
        <translation>&amp;Puentear segmentos</translation>
    </message>
    <message>
        <source>Alt+Del</source>
        <translation>Alt+Del</translation>
    </message>
    <message>
        <source>Replace selected segments by one that goes on smoothly</source>
        <translation>Sustituir los segmentos seleccionados por uno que continúe suavemente</translation>
    </message>
    <message>
        <source>&amp;Reverse</source>
        <translation>In&amp;vertir sentido</translation>
    </message>
    <message>
        <source>Shift+R</source>
        <translation>Shift+R</translation>
    </message>
    <message>
        <source>Let the selected strokes run from end to start</source>
        <translation>Hacer que los trazos seleccionados vayan del final al inicio</translation>
    </message>
    <message>
        <source>&amp;Object</source>
        <translation>&amp;Objeto</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>&amp;Nodos</translation>
    </message>
    <message>
        <source>In&amp;vert Selection</source>
        <translation>In&amp;vertir selección</translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation>Ctrl+Shift+I</translation>
    </message>
    <message>
        <source>!</source>
        <translation>!</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Color</translation>
    </message>
    <message>
        <source>Select all strokes of the same colour</source>
        <translation>Seleccionar todos los trazos del mismo color</translation>
    </message>
    <message>
        <source>&amp;Style</source>
        <translation>&amp;Estilo</translation>
    </message>
    <message>
        <source>Select all strokes of the same style</source>
        <translation>Seleccionar todos los trazos del mismo estilo</translation>
    </message>
    <message>
        <source>Select all strokes of the same brush</source>
        <translation>Seleccionar todos los trazos del mismo pincel</translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation>&amp;Lazo</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Select what is drawn around; with Shift from paint, too</source>
        <translation>Seleccionar lo que se rodea; con Mayús, también al empezar sobre pintura</translation>
    </message>
    <message>
        <source>&amp;Touch</source>
        <translation>&amp;Tocar</translation>
    </message>
    <message>
        <source>Select what a path touches</source>
        <translation>Seleccionar lo que toca un trayecto</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>A&amp;grupar</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>De&amp;sagrupar</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Loc&amp;k</source>
        <translation>Blo&amp;quear</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Ctrl+2</translation>
    </message>
    <message>
        <source>U&amp;nlock All</source>
        <translation>&amp;Desbloquear todo</translation>
    </message>
    <message>
        <source>Ctrl+Alt+2</source>
        <translation>Ctrl+Alt+2</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Oc&amp;ultar</translation>
    </message>
    <message>
        <source>Ctrl+3</source>
        <translation>Ctrl+3</translation>
    </message>
    <message>
        <source>Sho&amp;w All</source>
        <translation>&amp;Mostrar todo</translation>
    </message>
    <message>
        <source>Ctrl+Alt+3</source>
        <translation>Ctrl+Alt+3</translation>
    </message>
    <message>
        <source>Rena&amp;me…</source>
        <translation>Cambiar &amp;nombre…</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Flip Hori&amp;zontally</source>
        <translation>Voltear &amp;horizontalmente</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>Flip &amp;Vertically</source>
        <translation>&amp;Voltear verticalmente</translation>
    </message>
    <message>
        <source>Shift+V</source>
        <translation>Shift+V</translation>
    </message>
    <message>
        <source>Rotate by &amp;90° Left</source>
        <translation>Girar &amp;90° a la izquierda</translation>
    </message>
    <message>
        <source>Ctrl+[</source>
        <translation>Ctrl+[</translation>
    </message>
    <message>
        <source>Rotate by 90° R&amp;ight</source>
        <translation>G&amp;irar 90° a la derecha</translation>
    </message>
    <message>
        <source>Ctrl+]</source>
        <translation>Ctrl+]</translation>
    </message>
    <message>
        <source>&amp;Scale Spread with the Shape</source>
        <translation>Escalar la e&amp;xpansión con la forma</translation>
    </message>
    <message>
        <source>Spread and density follow the shape when it is scaled</source>
        <translation>La expansión y la densidad siguen a la forma cuando se escala</translation>
    </message>
    <message>
        <source>&amp;Left Edges</source>
        <translation>Bordes &amp;izquierdos</translation>
    </message>
    <message>
        <source>&amp;Centres, Horizontally</source>
        <translation>&amp;Centros, en horizontal</translation>
    </message>
    <message>
        <source>&amp;Right Edges</source>
        <translation>Bordes &amp;derechos</translation>
    </message>
    <message>
        <source>&amp;Top Edges</source>
        <translation>Bordes &amp;superiores</translation>
    </message>
    <message>
        <source>&amp;Middles, Vertically</source>
        <translation>Puntos &amp;medios, en vertical</translation>
    </message>
    <message>
        <source>&amp;Bottom Edges</source>
        <translation>Bordes in&amp;feriores</translation>
    </message>
    <message>
        <source>Relative to the &amp;Selection</source>
        <translation>Respecto a la selecció&amp;n</translation>
    </message>
    <message>
        <source>Relative to the C&amp;anvas</source>
        <translation>Respecto al lien&amp;zo</translation>
    </message>
    <message>
        <source>Even Gaps, &amp;Horizontally</source>
        <translation>Espacios iguales, en &amp;horizontal</translation>
    </message>
    <message>
        <source>Even Gaps, &amp;Vertically</source>
        <translation>Espacios iguales, en &amp;vertical</translation>
    </message>
    <message>
        <source>Even &amp;Centres, Horizontally</source>
        <translation>&amp;Centros equidistantes, en horizontal</translation>
    </message>
    <message>
        <source>Even C&amp;entres, Vertically</source>
        <translation>C&amp;entros equidistantes, en vertical</translation>
    </message>
    <message>
        <source>Snap to &amp;Nodes</source>
        <translation>Ajustar a &amp;nodos</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Snap to &amp;Grid</source>
        <translation>Ajustar a la &amp;cuadrícula</translation>
    </message>
    <message>
        <source>&amp;Show the Grid</source>
        <translation>Mostrar la cua&amp;drícula</translation>
    </message>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Grid St&amp;ep…</source>
        <translation>&amp;Paso de la cuadrícula…</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>&amp;Alinear</translation>
    </message>
    <message>
        <source>&amp;Distribute</source>
        <translation>Distri&amp;buir</translation>
    </message>
    <message>
        <source>Select Sa&amp;me</source>
        <translation>Seleccionar con el &amp;mismo</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>Ctrl+4</source>
        <translation>Ctrl+4</translation>
    </message>
    <message>
        <source>Ctrl+6</source>
        <translation>Ctrl+6</translation>
    </message>
    <message>
        <source>Ctrl+5</source>
        <translation>Ctrl+5</translation>
    </message>
    <message>
        <source>Ti&amp;me</source>
        <translation>&amp;Tiempo</translation>
    </message>
    <message>
        <source>&amp;Favourite Brushes</source>
        <translation>Pinceles fa&amp;voritos</translation>
    </message>
    <message>
        <source>Favourite Brush %1</source>
        <translation>Pincel favorito %1</translation>
    </message>
    <message>
        <source>Relative to the &amp;First Selected</source>
        <translation>Respecto al &amp;primero seleccionado</translation>
    </message>
    <message>
        <source>Relative to the Bi&amp;ggest</source>
        <translation>Respecto al más &amp;grande</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Reproducir</translation>
    </message>
    <message>
        <source>Play the painting being painted, or pause</source>
        <translation>Reproducir cómo se pinta la obra, o pausar</translation>
    </message>
    <message>
        <source>To the &amp;Start</source>
        <translation>Al &amp;inicio</translation>
    </message>
    <message>
        <source>Shift+,</source>
        <translation>Shift+,</translation>
    </message>
    <message>
        <source>Go to where the painting begins</source>
        <translation>Ir a donde empieza la obra</translation>
    </message>
    <message>
        <source>P&amp;revious Stroke</source>
        <translation>Trazo &amp;anterior</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>Go back to where a stroke begins</source>
        <translation>Volver a donde empieza un trazo</translation>
    </message>
    <message>
        <source>&amp;Next Stroke</source>
        <translation>Trazo &amp;siguiente</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>Go on to where a stroke begins</source>
        <translation>Avanzar a donde empieza un trazo</translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation>Al &amp;final</translation>
    </message>
    <message>
        <source>Shift+.</source>
        <translation>Shift+.</translation>
    </message>
    <message>
        <source>Go to the end, where all has dried: the present</source>
        <translation>Ir al final, donde todo se ha secado: el presente</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>&amp;Bucle</translation>
    </message>
    <message>
        <source>Play again and again</source>
        <translation>Reproducir una y otra vez</translation>
    </message>
    <message>
        <source>S&amp;kip Pauses</source>
        <translation>&amp;Omitir pausas</translation>
    </message>
    <message>
        <source>Cut pauses in which nothing is painted or spreads to half a second</source>
        <translation>Reducir a medio segundo las pausas en las que nada se pinta ni se expande</translation>
    </message>
    <message>
        <source>Preview When &amp;Dry</source>
        <translation>&amp;Vista previa en seco</translation>
    </message>
    <message>
        <source>Shift+D</source>
        <translation>Shift+D</translation>
    </message>
    <message>
        <source>Show wet paint as it will look when it has dried, while you paint too</source>
        <translation>Mostrar la pintura húmeda como se verá cuando se haya secado, también mientras se pinta</translation>
    </message>
    <message>
        <source>Let It Dr&amp;y</source>
        <translation>&amp;Dejar secar</translation>
    </message>
    <message>
        <source>Go to the moment at which all has dried</source>
        <translation>Ir al momento en que todo se ha secado</translation>
    </message>
    <message>
        <source>&amp;Freeze Wet Paint</source>
        <translation>&amp;Congelar la pintura húmeda</translation>
    </message>
    <message>
        <source>Ctrl+Alt+F</source>
        <translation>Ctrl+Alt+F</translation>
    </message>
    <message>
        <source>All that is wet stops spreading at this moment</source>
        <translation>Todo lo húmedo deja de expandirse en este momento</translation>
    </message>
    <message>
        <source>Re-&amp;wet…</source>
        <translation>Re&amp;humedecer…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+W</source>
        <translation>Ctrl+Alt+W</translation>
    </message>
    <message>
        <source>Let the selected paint spread on for a while from this moment</source>
        <translation>Dejar que la pintura seleccionada se siga expandiendo un rato desde este momento</translation>
    </message>
    <message>
        <source>Remove Re-we&amp;tting</source>
        <translation>&amp;Quitar rehumedecido</translation>
    </message>
    <message>
        <source>The selected paint dries once and for all</source>
        <translation>La pintura seleccionada se seca de una vez por todas</translation>
    </message>
    <message>
        <source>&amp;Even</source>
        <translation>&amp;Uniforme</translation>
    </message>
    <message>
        <source>Selected strokes are drawn at an even pace</source>
        <translation>Los trazos seleccionados se dibujan a un ritmo uniforme</translation>
    </message>
    <message>
        <source>Ease &amp;In</source>
        <translation>&amp;Inicio suave</translation>
    </message>
    <message>
        <source>Selected strokes begin slowly</source>
        <translation>Los trazos seleccionados empiezan despacio</translation>
    </message>
    <message>
        <source>Ease &amp;Out</source>
        <translation>&amp;Final suave</translation>
    </message>
    <message>
        <source>Selected strokes end slowly</source>
        <translation>Los trazos seleccionados terminan despacio</translation>
    </message>
    <message>
        <source>Ease In and O&amp;ut</source>
        <translation>Inicio y final &amp;suaves</translation>
    </message>
    <message>
        <source>Selected strokes begin and end slowly</source>
        <translation>Los trazos seleccionados empiezan y terminan despacio</translation>
    </message>
    <message>
        <source>Export Ti&amp;melapse…</source>
        <translation>Exportar cá&amp;mara rápida…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+E</source>
        <translation>Ctrl+Alt+E</translation>
    </message>
    <message>
        <source>Make a film of the painting being painted</source>
        <translation>Hacer una película de cómo se pinta la obra</translation>
    </message>
    <message>
        <source>Drawing Pa&amp;ce</source>
        <translation>Ri&amp;tmo de dibujo</translation>
    </message>
    <message>
        <source>Relative to the Last Select&amp;ed</source>
        <translation>Respecto al ú&amp;ltimo seleccionado</translation>
    </message>
    <message>
        <source>Keep Undo &amp;History in the File</source>
        <translation>Conservar el &amp;historial de deshacer en el archivo</translation>
    </message>
    <message>
        <source>Whoever opens the file can go on undoing. Take it out before you give a file away</source>
        <translation>Quien abra el archivo puede seguir deshaciendo. Quítelo antes de entregar un archivo</translation>
    </message>
    <message>
        <source>Import &amp;Underlay…</source>
        <translation>Importar ca&amp;lco…</translation>
    </message>
    <message>
        <source>A picture to paint over, which shows on the canvas only</source>
        <translation>Una imagen sobre la que pintar, que solo se muestra en el lienzo</translation>
    </message>
    <message>
        <source>Show the Underl&amp;ay</source>
        <translation>Mostrar el calc&amp;o</translation>
    </message>
    <message>
        <source>Shift+U</source>
        <translation>Shift+U</translation>
    </message>
    <message>
        <source>&amp;Import Strokes…</source>
        <translation>Importar &amp;trazos…</translation>
    </message>
    <message>
        <source>Drawings, recordings and the strokes of other paintings, into this one</source>
        <translation>Dibujos, grabaciones y los trazos de otras obras, en esta</translation>
    </message>
    <message>
        <source>S&amp;maller Tool Size</source>
        <translation>Herramienta más pe&amp;queña</translation>
    </message>
    <message>
        <source>La&amp;rger Tool Size</source>
        <translation>Herramienta ma&amp;yor</translation>
    </message>
    <message>
        <source>&amp;Less Opacity</source>
        <translation>Menos opaci&amp;dad</translation>
    </message>
    <message>
        <source>More &amp;Opacity</source>
        <translation>Más opac&amp;idad</translation>
    </message>
    <message>
        <source>Move the Canvas While Held</source>
        <translation>Mover el lienzo mientras se mantiene</translation>
    </message>
    <message>
        <source>Turn the Canvas While Held</source>
        <translation>Girar el lienzo mientras se mantiene</translation>
    </message>
    <message>
        <source>Move the Selection</source>
        <translation>Mover la selección</translation>
    </message>
    <message>
        <source>Move the Selection Ten Times as Far</source>
        <translation>Mover la selección diez veces más lejos</translation>
    </message>
    <message>
        <source>Move the Selection by One Unit</source>
        <translation>Mover la selección una unidad</translation>
    </message>
    <message>
        <source>Move the Selection by Ten Units</source>
        <translation>Mover la selección diez unidades</translation>
    </message>
    <message>
        <source>Move Rows in the Strokes Dock</source>
        <translation>Mover filas en el panel Trazos</translation>
    </message>
    <message>
        <source>Previous Stroke or Node</source>
        <translation>Trazo o nodo anterior</translation>
    </message>
    <message>
        <source>Give Up, or Deselect</source>
        <translation>Cancelar o anular la selección</translation>
    </message>
    <message>
        <source>Save a Cop&amp;y…</source>
        <translation>Guardar una cop&amp;ia…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Shift+S</source>
        <translation>Ctrl+Alt+Shift+S</translation>
    </message>
    <message>
        <source>Into another file; you go on painting in this one</source>
        <translation>En otro archivo; se sigue pintando en este</translation>
    </message>
    <message>
        <source>Re&amp;vert…</source>
        <translation>Re&amp;vertir…</translation>
    </message>
    <message>
        <source>Back to what the file holds; Undo takes it back</source>
        <translation>Volver a lo que contiene el archivo; Deshacer lo revierte</translation>
    </message>
    <message>
        <source>Restore &amp;Backup…</source>
        <translation>Restaurar copia de seguri&amp;dad…</translation>
    </message>
    <message>
        <source>Back to an earlier version of the file</source>
        <translation>Volver a una versión anterior del archivo</translation>
    </message>
    <message>
        <source>Export A&amp;gain</source>
        <translation>Exportar de nuev&amp;o</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>To the same file, with the same settings</source>
        <translation>En el mismo archivo, con los mismos ajustes</translation>
    </message>
    <message>
        <source>Hide Outlines and Handles While Held</source>
        <translation>Ocultar contornos y tiradores mientras se mantiene</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <source>Select all strokes of the same name</source>
        <translation>Seleccionar todos los trazos del mismo nombre</translation>
    </message>
    <message>
        <source>Select &amp;Found</source>
        <translation>Seleccionar lo e&amp;ncontrado</translation>
    </message>
    <message>
        <source>Select what the search in the Strokes dock has found</source>
        <translation>Seleccionar lo que ha encontrado la búsqueda en el panel Trazos</translation>
    </message>
    <message>
        <source>Find Strokes</source>
        <translation>Buscar trazos</translation>
    </message>
    <message>
        <source>Look for strokes and groups by their names, in the Strokes dock</source>
        <translation>Buscar trazos y grupos por su nombre, en el panel Trazos</translation>
    </message>
    <message>
        <source>Show Ou&amp;tlines</source>
        <translation>Mostrar con&amp;tornos</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>Lines along the selected strokes; the Brush shows none</source>
        <translation>Líneas a lo largo de los trazos seleccionados; el pincel no muestra ninguna</translation>
    </message>
    <message>
        <source>Show Paint &amp;beyond the Canvas</source>
        <translation>Mostrar pintura fuera del &amp;lienzo</translation>
    </message>
    <message>
        <source>Under a veil, what was painted beside the canvas; it is in no picture that is exported</source>
        <translation>Bajo un velo, lo que se pintó junto al lienzo; no aparece en ninguna imagen exportada</translation>
    </message>
    <message>
        <source>Ne&amp;xt Panel</source>
        <translation>Pró&amp;ximo panel</translation>
    </message>
    <message>
        <source>The keyboard goes from the canvas to the docks and tool bars in turn</source>
        <translation>El teclado pasa del lienzo a los paneles y barras de herramientas, por turno</translation>
    </message>
    <message>
        <source>&amp;Previous Panel</source>
        <translation>Panel anter&amp;ior</translation>
    </message>
    <message>
        <source>The keyboard goes back from panel to panel</source>
        <translation>El teclado vuelve de panel en panel</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>Des&amp;hacer: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rehacer: %1</translation>
    </message>
    <message>
        <source>&amp;Find a Command…</source>
        <translation>B&amp;uscar una orden…</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Commands, brushes, docks and recent files by their names</source>
        <translation>Órdenes, pinceles, paneles y archivos recientes por su nombre</translation>
    </message>
    <message>
        <source>Drawing pace</source>
        <translation>Ritmo de dibujo</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pausar</translation>
    </message>
    <message>
        <source>Remove re-wetting</source>
        <translation>Quitar rehumedecido</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Cuadrícula</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Keep Undo &amp;History in the File (%1)</source>
        <translation>Conservar el &amp;historial de deshacer en el archivo (%1)</translation>
    </message>
    <message>
        <source>Canvas, while held</source>
        <translation>Lienzo, mientras se mantiene</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>En todas partes</translation>
    </message>
    <message>
        <source>Canvas, Strokes dock</source>
        <translation>Lienzo, panel Trazos</translation>
    </message>
    <message>
        <source>Canvas, Timeline dock</source>
        <translation>Lienzo, panel Línea de tiempo</translation>
    </message>
    <message>
        <source>Canvas, Segments tool</source>
        <translation>Lienzo, herramienta Segmentos</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Lienzo</translation>
    </message>
    <message>
        <source>Nothing is wet at this moment.</source>
        <translation>No hay nada húmedo en este momento.</translation>
    </message>
    <message>
        <source>Freeze wet paint</source>
        <translation>Congelar la pintura húmeda</translation>
    </message>
    <message>
        <source>Nothing that is selected is painted yet at this moment.</source>
        <translation>Nada de lo seleccionado está pintado aún en este momento.</translation>
    </message>
    <message>
        <source>Name of the group</source>
        <translation>Nombre del grupo</translation>
    </message>
    <message numerus="yes">
        <source>Name of %Ln stroke(s)</source>
        <translation>
            <numerusform>Nombre de %Ln trazo</numerusform>
            <numerusform>Nombre de %Ln trazos</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Cambiar nombre</translation>
    </message>
    <message>
        <source>Re-wet</source>
        <translation>Rehumedecer</translation>
    </message>
    <message>
        <source>Seconds that the paint spreads on</source>
        <translation>Segundos que la pintura se sigue expandiendo</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>Smooth the curves of the selected strokes; each time more</source>
        <translation>Suavizar las curvas de los trazos seleccionados; más cada vez que se repite</translation>
    </message>
    <message>
        <source>S&amp;traighten</source>
        <translation>&amp;Enderezar</translation>
    </message>
    <message>
        <source>Ctrl+Alt+L</source>
        <translation>Ctrl+Alt+L</translation>
    </message>
    <message>
        <source>Move the selected strokes towards straight lines; each time more</source>
        <translation>Acercar los trazos seleccionados a líneas rectas; más cada vez que se repite</translation>
    </message>
    <message>
        <source>&amp;Grow Paint</source>
        <translation>Ens&amp;anchar pintura</translation>
    </message>
    <message>
        <source>Ctrl+)</source>
        <translation>Ctrl+)</translation>
    </message>
    <message>
        <source>Make the paint of the selected strokes wider</source>
        <translation>Hacer más ancha la pintura de los trazos seleccionados</translation>
    </message>
    <message>
        <source>S&amp;hrink Paint</source>
        <translation>Es&amp;trechar pintura</translation>
    </message>
    <message>
        <source>Ctrl+(</source>
        <translation>Ctrl+(</translation>
    </message>
    <message>
        <source>Make the paint of the selected strokes narrower</source>
        <translation>Hacer más estrecha la pintura de los trazos seleccionados</translation>
    </message>
    <message>
        <source>What is selected is locked or hidden.</source>
        <translation>Lo seleccionado está bloqueado u oculto.</translation>
    </message>
    <message>
        <source>Simp&amp;lify…</source>
        <translation>Simp&amp;lificar…</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>Make fewer segments of the selected strokes</source>
        <translation>Hacer menos segmentos de los trazos seleccionados</translation>
    </message>
    <message>
        <source>&amp;Offset and More…</source>
        <translation>&amp;Desplazar y más…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+O</source>
        <translation>Ctrl+Alt+O</translation>
    </message>
    <message>
        <source>Offset, smooth, straighten, grow or shrink the selected strokes by numbers</source>
        <translation>Desplazar, suavizar, enderezar, ensanchar o estrechar los trazos seleccionados por números</translation>
    </message>
    <message>
        <source>Resha&amp;pe</source>
        <translation>Re&amp;formar</translation>
    </message>
    <message>
        <source>&amp;Fill</source>
        <translation>&amp;Rellenar</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Wet what the selected strokes enclose; the inspector has its values</source>
        <translation>Mojar lo que encierran los trazos seleccionados; el inspector tiene sus valores</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Rellenar</translation>
    </message>
    <message>
        <source>Remove Fill</source>
        <translation>Quitar relleno</translation>
    </message>
    <message>
        <source>Remove fill</source>
        <translation>Quitar relleno</translation>
    </message>
    <message>
        <source>Leave of the selected strokes their outlines</source>
        <translation>Dejar solo los contornos de los trazos seleccionados</translation>
    </message>
    <message>
        <source>Geome&amp;tric Shapes</source>
        <translation>&amp;Formas geométricas</translation>
    </message>
    <message>
        <source>Paint rectangles, ellipses, polygons and stars</source>
        <translation>Pintar rectángulos, elipses, polígonos y estrellas</translation>
    </message>
    <message>
        <source>Redra&amp;w</source>
        <translation>Redibu&amp;jar</translation>
    </message>
    <message>
        <source>Draw over a part of a stroke, which follows the new line</source>
        <translation>Dibujar sobre una parte de un trazo, que sigue la línea nueva</translation>
    </message>
    <message>
        <source>&amp;Push</source>
        <translation>&amp;Empujar</translation>
    </message>
    <message>
        <source>Push, comb, pinch or roughen strokes</source>
        <translation>Empujar, peinar, juntar o encrespar trazos</translation>
    </message>
    <message>
        <source>What lies under the pointer, and what can be done with it</source>
        <translation>Lo que hay bajo el puntero y lo que se puede hacer con ello</translation>
    </message>
    <message>
        <source>Br&amp;ush Palette at the Pointer</source>
        <translation>Paleta de pinceles en el punte&amp;ro</translation>
    </message>
    <message>
        <source>Brushes, colours, size and zoom where the pointer is</source>
        <translation>Pinceles, colores, tamaño y zoom donde está el puntero</translation>
    </message>
    <message>
        <source>Edit Value&amp;s Here…</source>
        <translation>Editar valores a&amp;quí…</translation>
    </message>
    <message>
        <source>Width, diffusion, density, colour and opacity of what is selected, at the pointer</source>
        <translation>Anchura, difusión, densidad, color y opacidad de lo seleccionado, en el puntero</translation>
    </message>
    <message>
        <source>&amp;Whole Brush</source>
        <translation>&amp;Pincel entero</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>Put the brush in hand on the selected strokes; they remember the pen&apos;s pressure</source>
        <translation>Aplicar el pincel en uso a los trazos seleccionados; recuerdan la presión del lápiz</translation>
    </message>
    <message>
        <source>&amp;Form Only</source>
        <translation>Solo &amp;forma</translation>
    </message>
    <message>
        <source>Width, density, tapering and tip of the brush in hand</source>
        <translation>Anchura, densidad, afinado y punta del pincel en uso</translation>
    </message>
    <message>
        <source>&amp;Colour Only</source>
        <translation>Solo &amp;color</translation>
    </message>
    <message>
        <source>Colour and opacity of the brush in hand</source>
        <translation>Color y opacidad del pincel en uso</translation>
    </message>
    <message>
        <source>&amp;Texture Only</source>
        <translation>Solo &amp;textura</translation>
    </message>
    <message>
        <source>Style, mixing, grain and drying time of the brush in hand</source>
        <translation>Estilo, mezcla, grano y tiempo de secado del pincel en uso</translation>
    </message>
    <message>
        <source>C&amp;opy Appearance</source>
        <translation>C&amp;opiar aspecto</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Copy style, mixing, values and colour of the stroke that was selected last</source>
        <translation>Copiar estilo, mezcla, valores y color del último trazo seleccionado</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>Put it on the selected strokes; what varies along them goes on varying</source>
        <translation>Aplicarlo a los trazos seleccionados; lo que varía a lo largo de ellos sigue variando</translation>
    </message>
    <message>
        <source>Paste Appearance Evenl&amp;y</source>
        <translation>Pegar aspecto uni&amp;forme</translation>
    </message>
    <message>
        <source>Put it on the selected strokes, with the same values all along</source>
        <translation>Aplicarlo a los trazos seleccionados, con los mismos valores en todo el trazo</translation>
    </message>
    <message>
        <source>Along th&amp;e Stroke…</source>
        <translation>A lo largo del tra&amp;zo…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+R</source>
        <translation>Ctrl+Alt+R</translation>
    </message>
    <message>
        <source>Set a value along the stroke: constant, as a ramp, or drawn as a curve</source>
        <translation>Fijar un valor a lo largo del trazo: constante, en rampa o dibujado como curva</translation>
    </message>
    <message>
        <source>Vary at Rand&amp;om…</source>
        <translation>Variar a&amp;l azar…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Y</source>
        <translation>Ctrl+Alt+Y</translation>
    </message>
    <message>
        <source>Let values and colours of the selected strokes stray at random</source>
        <translation>Hacer que los valores y colores de los trazos seleccionados se desvíen al azar</translation>
    </message>
    <message>
        <source>Appl&amp;y Brush</source>
        <translation>Aplicar &amp;pincel</translation>
    </message>
    <message>
        <source>Show Erasures</source>
        <translation>Mostrar borrados</translation>
    </message>
    <message>
        <source>Shift+E</source>
        <translation>Shift+E</translation>
    </message>
    <message>
        <source>Dashed lines along what was erased softly from all strokes; what is not selected is paler</source>
        <translation>Líneas discontinuas a lo largo de lo que se borró con suavidad de todos los trazos; lo no seleccionado es más pálido</translation>
    </message>
    <message>
        <source>&amp;Combine</source>
        <translation>&amp;Combinar</translation>
    </message>
    <message>
        <source>Ctrl+Alt+K</source>
        <translation>Ctrl+Alt+K</translation>
    </message>
    <message>
        <source>Make one stroke of the selected ones, whose paint adds up</source>
        <translation>Hacer un solo trazo de los seleccionados, cuya pintura se suma</translation>
    </message>
    <message>
        <source>Break Apart</source>
        <translation>Descombinar</translation>
    </message>
    <message>
        <source>Ctrl+Shift+K</source>
        <translation>Ctrl+Shift+K</translation>
    </message>
    <message>
        <source>Make strokes of the parts of the selected ones</source>
        <translation>Hacer trazos de las partes de los seleccionados</translation>
    </message>
    <message>
        <source>Remove Erasures</source>
        <translation>Quitar borrados</translation>
    </message>
    <message>
        <source>Bring back what was erased softly from the selected strokes, or by the selected segments</source>
        <translation>Recuperar lo que se borró suavemente de los trazos seleccionados, o con los segmentos seleccionados</translation>
    </message>
    <message>
        <source>Delete the selected segments, which leaves gaps in strokes</source>
        <translation>Eliminar los segmentos seleccionados, lo que deja huecos en los trazos</translation>
    </message>
    <message>
        <source>Take paint away softly, or cut out parts of strokes</source>
        <translation>Quitar pintura suavemente, o recortar partes de trazos</translation>
    </message>
    <message>
        <source>Map Colours to S&amp;watches</source>
        <translation>As&amp;ignar colores a muestras</translation>
    </message>
    <message>
        <source>Give what is selected, or else all of the painting, the swatches that look nearest</source>
        <translation>Dar a lo seleccionado, o si no a toda la obra, las muestras que más se parecen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+C</source>
        <translation>Ctrl+Alt+C</translation>
    </message>
    <message>
        <source>Give each colour of the painting, or of what is selected, another one everywhere</source>
        <translation>Dar a cada color de la obra, o de lo seleccionado, otro en todas partes</translation>
    </message>
    <message>
        <source>Paste Appeara&amp;nce</source>
        <translation>Pegar a&amp;specto</translation>
    </message>
    <message>
        <source>Menu at t&amp;he Pointer</source>
        <translation>Menú conte&amp;xtual en el puntero</translation>
    </message>
    <message>
        <source>Recolour Artwor&amp;k…</source>
        <translation>Recolorear o&amp;bra…</translation>
    </message>
    <message>
        <source>Match &amp;by Eyedropper</source>
        <translation>I&amp;gualar con cuentagotas</translation>
    </message>
    <message>
        <source>Click a stroke: the selected ones get its style, mixing, values and colour</source>
        <translation>Hacer clic en un trazo: los seleccionados toman su estilo, mezcla, valores y color</translation>
    </message>
    <message>
        <source>A fill cannot be wetted again. It spreads as long as it takes to dry.</source>
        <translation>Un relleno no se puede rehumedecer. Se expande mientras tarda en secarse.</translation>
    </message>
    <message>
        <source>Not done: nothing would be left.</source>
        <translation>No se ha hecho: no quedaría nada.</translation>
    </message>
    <message>
        <source>Not done: the outlines meet so often that it would take minutes.</source>
        <translation>No se ha hecho: los contornos se cruzan tantas veces que llevaría minutos.</translation>
    </message>
    <message>
        <source>Not done: the outlines lie on each other so closely that the result is uncertain.</source>
        <translation>No se ha hecho: los contornos están tan juntos que el resultado es incierto.</translation>
    </message>
    <message>
        <source>Select two or more filled strokes.</source>
        <translation>Seleccione dos o más trazos rellenos.</translation>
    </message>
    <message>
        <source>&amp;Union</source>
        <translation>&amp;Unión</translation>
    </message>
    <message>
        <source>Ctrl+Alt++</source>
        <translation>Ctrl+Alt++</translation>
    </message>
    <message>
        <source>One fill of what the selected ones cover, with the values of the lowest</source>
        <translation>Un solo relleno de lo que cubren los seleccionados, con los valores del más bajo</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>&amp;Diferencia</translation>
    </message>
    <message>
        <source>Ctrl+Alt+-</source>
        <translation>Ctrl+Alt+-</translation>
    </message>
    <message>
        <source>Leave of the lowest selected fill what the others do not cover</source>
        <translation>Dejar del relleno seleccionado más bajo lo que los otros no cubren</translation>
    </message>
    <message>
        <source>&amp;Intersection</source>
        <translation>&amp;Intersección</translation>
    </message>
    <message>
        <source>Ctrl+*</source>
        <translation>Ctrl+*</translation>
    </message>
    <message>
        <source>Leave of the lowest selected fill what all others cover</source>
        <translation>Dejar del relleno seleccionado más bajo lo que cubren todos los demás</translation>
    </message>
    <message>
        <source>E&amp;xclusion</source>
        <translation>E&amp;xclusión</translation>
    </message>
    <message>
        <source>Ctrl+^</source>
        <translation>Ctrl+^</translation>
    </message>
    <message>
        <source>One fill of what one of the selected ones covers, and not two</source>
        <translation>Un relleno de lo que cubre uno de los seleccionados, y no dos</translation>
    </message>
    <message>
        <source>Di&amp;vision</source>
        <translation>Di&amp;visión</translation>
    </message>
    <message>
        <source>Ctrl+/</source>
        <translation>Ctrl+/</translation>
    </message>
    <message>
        <source>Cut the lowest selected fill along the outlines of the others</source>
        <translation>Cortar el relleno seleccionado más bajo por los contornos de los otros</translation>
    </message>
    <message>
        <source>Select a filled stroke.</source>
        <translation>Seleccione un trazo relleno.</translation>
    </message>
    <message>
        <source>I&amp;nset</source>
        <translation>&amp;Reducir</translation>
    </message>
    <message>
        <source>Ctrl+Alt+(</source>
        <translation>Ctrl+Alt+(</translation>
    </message>
    <message>
        <source>Move the outlines of fills inwards, by the distance of Offset and More</source>
        <translation>Mover los contornos de los rellenos hacia dentro, según la distancia de Desplazar y más</translation>
    </message>
    <message>
        <source>&amp;Outset</source>
        <translation>&amp;Ampliar</translation>
    </message>
    <message>
        <source>Ctrl+Alt+)</source>
        <translation>Ctrl+Alt+)</translation>
    </message>
    <message>
        <source>Move the outlines of fills outwards, by the distance of Offset and More</source>
        <translation>Mover los contornos de los rellenos hacia fuera, según la distancia de Desplazar y más</translation>
    </message>
    <message>
        <source>&amp;Stroke to Outline</source>
        <translation>&amp;Trazo a contorno</translation>
    </message>
    <message>
        <source>Ctrl+Alt+T</source>
        <translation>Ctrl+Alt+T</translation>
    </message>
    <message>
        <source>Make fills of what is seen of the lines of the selected strokes</source>
        <translation>Hacer rellenos de lo que se ve de las líneas de los trazos seleccionados</translation>
    </message>
    <message>
        <source>Stroke to outline</source>
        <translation>Trazo a contorno</translation>
    </message>
    <message>
        <source>Select a stroke of which a line is seen.</source>
        <translation>Seleccione un trazo del que se vea una línea.</translation>
    </message>
    <message>
        <source>Areas</source>
        <translation>Áreas</translation>
    </message>
    <message>
        <source>Outline Pe&amp;n</source>
        <translation>Pl&amp;uma de contornos</translation>
    </message>
    <message>
        <source>Draw an outline node by node, filled or not</source>
        <translation>Dibujar un contorno nodo a nodo, relleno o no</translation>
    </message>
    <message>
        <source>Lasso F&amp;ill</source>
        <translation>Relleno con &amp;lazo</translation>
    </message>
    <message>
        <source>Fill what is drawn around</source>
        <translation>Rellenar lo que se rodea</translation>
    </message>
    <message>
        <source>Bu&amp;cket</source>
        <translation>Cu&amp;bo de pintura</translation>
    </message>
    <message>
        <source>Fill what the paint around a place bounds</source>
        <translation>Rellenar lo que delimita la pintura en torno a un punto</translation>
    </message>
    <message>
        <source>Text to Strokes</source>
        <translation>Texto a trazos</translation>
    </message>
    <message>
        <source>Make plain strokes of the letters of the selected texts; they cannot be typed in any more</source>
        <translation>Convertir las letras de los textos seleccionados en trazos normales; ya no se podrá escribir en ellas</translation>
    </message>
    <message>
        <source>Text to strokes</source>
        <translation>Texto a trazos</translation>
    </message>
    <message>
        <source>Release Text from Stroke</source>
        <translation>Soltar el texto del trazo</translation>
    </message>
    <message>
        <source>Let the selected texts keep their curves, whatever becomes of the strokes that they follow</source>
        <translation>Los textos seleccionados conservan sus curvas, pase lo que pase con los trazos que siguen</translation>
    </message>
    <message>
        <source>Select a text that follows a stroke.</source>
        <translation>Seleccione un texto que siga un trazo.</translation>
    </message>
    <message>
        <source>Release text from stroke</source>
        <translation>Soltar el texto del trazo</translation>
    </message>
    <message>
        <source>Te&amp;xt</source>
        <translation>&amp;Texto</translation>
    </message>
    <message>
        <source>Type texts, whose letters are strokes</source>
        <translation>Escribir textos, cuyas letras son trazos</translation>
    </message>
    <message>
        <source>&amp;Zoom to Selection</source>
        <translation>&amp;Zoom a la selección</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Show what is selected as large as possible: strokes, segments or nodes</source>
        <translation>Mostrar lo seleccionado lo más grande posible: trazos, segmentos o nodos</translation>
    </message>
    <message>
        <source>Add Gradient</source>
        <translation>Añadir degradado</translation>
    </message>
    <message>
        <source>The colour of the selected fills fades from left to right; needs a fill of one colour</source>
        <translation>El color de los rellenos seleccionados se degrada de izquierda a derecha; requiere un relleno de un solo color</translation>
    </message>
    <message>
        <source>Add gradient</source>
        <translation>Añadir degradado</translation>
    </message>
    <message>
        <source>Remove Gradient</source>
        <translation>Quitar degradado</translation>
    </message>
    <message>
        <source>The selected fills have their first colour everywhere; needs a fill with a gradient</source>
        <translation>Los rellenos seleccionados tienen su primer color en todas partes; requiere un relleno con degradado</translation>
    </message>
    <message>
        <source>Remove gradient</source>
        <translation>Quitar degradado</translation>
    </message>
    <message>
        <source>Clip to Below</source>
        <translation>Recortar a lo de abajo</translation>
    </message>
    <message>
        <source>Ctrl+Alt+G</source>
        <translation>Ctrl+Alt+G</translation>
    </message>
    <message>
        <source>The selected groups are seen only where the next thing below them in the same group is; needs something below</source>
        <translation>Los grupos seleccionados solo se ven donde está lo siguiente por debajo en el mismo grupo; requiere algo debajo</translation>
    </message>
    <message>
        <source>Use as Mask</source>
        <translation>Usar como máscara</translation>
    </message>
    <message>
        <source>What is beside the selected groups is seen only where they have paint; needs something beside</source>
        <translation>Lo que acompaña a los grupos seleccionados solo se ve donde estos tienen pintura; requiere algo al lado</translation>
    </message>
    <message>
        <source>Wash</source>
        <translation>Aguada</translation>
    </message>
    <message>
        <source>The strokes of the selected groups are one, laid wet into wet</source>
        <translation>Los trazos de los grupos seleccionados son uno solo, aplicado húmedo sobre húmedo</translation>
    </message>
    <message>
        <source>What the group did as a whole (opacity, mode, isolation, clip, mask, wash) is gone with it.</source>
        <translation>Con él desaparece lo que el grupo hacía como conjunto (opacidad, modo, aislamiento, recorte, máscara, aguada).</translation>
    </message>
    <message>
        <source>Group as a Whole</source>
        <translation>Grupo como conjunto</translation>
    </message>
    <message>
        <source>Not merged: nothing lies below the layer in its group.</source>
        <translation>No se ha fusionado: no hay nada debajo de la capa en su grupo.</translation>
    </message>
    <message>
        <source>Not merged: what lies just below the layer is no layer.</source>
        <translation>No se ha fusionado: lo que hay justo debajo de la capa no es una capa.</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is hidden.</source>
        <translation>No se ha fusionado: una de las dos capas está oculta.</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is locked.</source>
        <translation>No se ha fusionado: una de las dos capas está bloqueada.</translation>
    </message>
    <message>
        <source>Merge layer down</source>
        <translation>Fusionar capa hacia abajo</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>Duplicar capa</translation>
    </message>
    <message>
        <source>Raise layer</source>
        <translation>Elevar capa</translation>
    </message>
    <message>
        <source>Lower layer</source>
        <translation>Bajar capa</translation>
    </message>
    <message>
        <source>&amp;New Layer</source>
        <translation>&amp;Nueva capa</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Paint on a new layer above this one; it comes with its first stroke</source>
        <translation>Pintar en una capa nueva encima de esta; aparece con su primer trazo</translation>
    </message>
    <message>
        <source>New &amp;Clipped Layer</source>
        <translation>Nueva capa &amp;recortada</translation>
    </message>
    <message>
        <source>Ctrl+Alt+N</source>
        <translation>Ctrl+Alt+N</translation>
    </message>
    <message>
        <source>Paint on a new layer that shows only where the layer below has paint: a clipping mask</source>
        <translation>Pintar en una capa nueva que solo se ve donde la capa de abajo tiene pintura: una máscara de recorte</translation>
    </message>
    <message>
        <source>&amp;Duplicate Layer</source>
        <translation>&amp;Duplicar capa</translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation>Ctrl+J</translation>
    </message>
    <message>
        <source>&amp;Merge Down</source>
        <translation>&amp;Fusionar hacia abajo</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>&amp;Raise Layer</source>
        <translation>&amp;Elevar capa</translation>
    </message>
    <message>
        <source>&amp;Lower Layer</source>
        <translation>&amp;Bajar capa</translation>
    </message>
    <message>
        <source>Layer &amp;Above</source>
        <translation>Capa &amp;superior</translation>
    </message>
    <message>
        <source>Paint on the next layer above; above all of them there is none</source>
        <translation>Pintar en la siguiente capa por encima; por encima de todas no hay ninguna</translation>
    </message>
    <message>
        <source>Layer &amp;Below</source>
        <translation>Capa &amp;inferior</translation>
    </message>
    <message>
        <source>Paint on the next layer below</source>
        <translation>Pintar en la siguiente capa por debajo</translation>
    </message>
    <message>
        <source>N&amp;o Layer</source>
        <translation>Nin&amp;guna capa</translation>
    </message>
    <message>
        <source>Paint on top of all again</source>
        <translation>Volver a pintar encima de todo</translation>
    </message>
    <message>
        <source>&amp;Hide Others</source>
        <translation>&amp;Ocultar las demás</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>Show only this layer, or all again</source>
        <translation>Mostrar solo esta capa, o todas de nuevo</translation>
    </message>
    <message>
        <source>Show other layers</source>
        <translation>Mostrar las demás capas</translation>
    </message>
    <message>
        <source>Hide other layers</source>
        <translation>Ocultar las demás capas</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>&amp;Capa</translation>
    </message>
    <message>
        <source>Nothing changes.</source>
        <translation>No cambia nada.</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is a mask, and the picture would change.</source>
        <translation>No se ha fusionado: una de las dos capas es una máscara, y la imagen cambiaría.</translation>
    </message>
    <message>
        <source>Not merged: the layer below is clipped, and the picture would change.</source>
        <translation>No se ha fusionado: la capa de abajo está recortada, y la imagen cambiaría.</translation>
    </message>
    <message>
        <source>Not merged: what lies above is clipped to this layer, and the picture would change.</source>
        <translation>No se ha fusionado: lo que hay encima está recortado a esta capa, y la imagen cambiaría.</translation>
    </message>
    <message>
        <source>So that the picture stays, %1 is a group of its own within %2.</source>
        <translation>Para que la imagen no cambie, %1 es un grupo propio dentro de %2.</translation>
    </message>
    <message>
        <source>Put the layer onto the one just below it; the picture stays</source>
        <translation>Fusionar la capa con la que está justo debajo; la imagen no cambia</translation>
    </message>
    <message>
        <source>La&amp;yer</source>
        <translation>&amp;Capa</translation>
    </message>
    <message>
        <source>&amp;This Layer Only</source>
        <translation>Solo es&amp;ta capa</translation>
    </message>
    <message>
        <source>Tools reach only what is on the layer, where there is one</source>
        <translation>Las herramientas solo alcanzan lo que está en la capa, si hay una</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Borrador</translation>
    </message>
    <message>
        <source>The selected groups are seen here, and left out of what is exported</source>
        <translation>Los grupos seleccionados se ven aquí y se omiten en lo que se exporta</translation>
    </message>
    <message>
        <source>Underlay to Layer</source>
        <translation>Calco a capa</translation>
    </message>
    <message>
        <source>Make an image layer below all of the underlay, where it lies; it is exported then</source>
        <translation>Hacer con el calco, donde está, una capa de imagen debajo de todo; entonces se exporta</translation>
    </message>
    <message>
        <source>Picture to Stro&amp;kes…</source>
        <translation>Imagen a tra&amp;zos…</translation>
    </message>
    <message>
        <source>Strokes that look like a picture, of a file or the underlay, as a layer</source>
        <translation>Trazos que se parecen a una imagen, de un archivo o del calco, como capa</translation>
    </message>
    <message>
        <source>Import &amp;Picture as Layer…</source>
        <translation>Importar imagen como ca&amp;pa…</translation>
    </message>
    <message>
        <source>A picture as a layer among the others: with opacity and mode, and in what is exported</source>
        <translation>Una imagen como capa entre las demás: con opacidad y modo, y en lo que se exporta</translation>
    </message>
    <message>
        <source>Paste strokes, SVG paths or a picture at the pointer; a colour becomes the current one</source>
        <translation>Pegar trazos, trayectos SVG o una imagen en el puntero; un color pasa a ser el actual</translation>
    </message>
    <message>
        <source>Export &amp;Drawing…</source>
        <translation>Exportar dibu&amp;jo…</translation>
    </message>
    <message>
        <source>Prin&amp;t…</source>
        <translation>Imp&amp;rimir…</translation>
    </message>
    <message>
        <source>On paper, or as a page of a PDF file</source>
        <translation>En papel, o como página de un archivo PDF</translation>
    </message>
    <message>
        <source>Print Previe&amp;w…</source>
        <translation>Vista pr&amp;evia de impresión…</translation>
    </message>
    <message>
        <source>See the page in large before it is printed</source>
        <translation>Ver la página en grande antes de imprimirla</translation>
    </message>
    <message>
        <source>Exact outlines and bands of paint for Inkscape, plotters and browsers (SVG)</source>
        <translation>Contornos exactos y bandas de pintura para Inkscape, trazadores y navegadores (SVG)</translation>
    </message>
    <message>
        <source>Soft Proof</source>
        <translation>Prueba de color</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Y</source>
        <translation>Ctrl+Shift+Y</translation>
    </message>
    <message>
        <source>Shows the colours that are left on another device, as a press, by its profile</source>
        <translation>Mostrar, según su perfil, los colores que quedan en otro dispositivo, como una imprenta</translation>
    </message>
    <message>
        <source>Gamut &amp;Warning</source>
        <translation>A&amp;viso de gama</translation>
    </message>
    <message>
        <source>Marks the colours that the device of the soft proof does not have</source>
        <translation>Marcar los colores que no tiene el dispositivo de la prueba de color</translation>
    </message>
    <message>
        <source>Soft Proof with Profile…</source>
        <translation>Prueba de color con perfil…</translation>
    </message>
    <message>
        <source>Chooses the profile of the device whose colours are shown</source>
        <translation>Elegir el perfil del dispositivo cuyos colores se muestran</translation>
    </message>
    <message>
        <source>It is clipped to a layer that is hidden now, so nothing of it is seen.</source>
        <translation>Está recortada a una capa que ahora está oculta, así que no se ve nada de ella.</translation>
    </message>
    <message>
        <source>&amp;Fewer Strokes…</source>
        <translation>&amp;Menos trazos…</translation>
    </message>
    <message>
        <source>Make fewer strokes that look like the selected ones</source>
        <translation>Hacer menos trazos que se parezcan a los seleccionados</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manual</translation>
    </message>
    <message>
        <source>What Suffuse does and how; the key opens the page about what you are working with</source>
        <translation>Qué hace Suffuse y cómo; la tecla abre la página sobre aquello con lo que se trabaja</translation>
    </message>
    <message>
        <source>Ctrl+F1</source>
        <translation>Ctrl+F1</translation>
    </message>
    <message>
        <source>&amp;Welcome…</source>
        <translation>&amp;Bienvenida…</translation>
    </message>
    <message>
        <source>New paintings, recent ones, samples, and short lessons</source>
        <translation>Obras nuevas, recientes, ejemplos y lecciones breves</translation>
    </message>
    <message>
        <source>Nothing is selected: click paint with Select first.</source>
        <translation>No hay nada seleccionado: haga clic antes en la pintura con Seleccionar.</translation>
    </message>
    <message>
        <source>Nothing is painted yet.</source>
        <translation>Aún no hay nada pintado.</translation>
    </message>
    <message>
        <source>Nothing is locked.</source>
        <translation>No hay nada bloqueado.</translation>
    </message>
    <message>
        <source>Nothing is hidden.</source>
        <translation>No hay nada oculto.</translation>
    </message>
    <message>
        <source>Select two strokes or more; to the canvas one can be aligned, too.</source>
        <translation>Seleccione dos trazos o más; respecto al lienzo también se puede alinear uno solo.</translation>
    </message>
    <message>
        <source>No layer is chosen: click one in the Strokes dock, or begin one with New Layer.</source>
        <translation>No se ha elegido ninguna capa: haga clic en una del panel Trazos o empiece una con Nueva capa.</translation>
    </message>
    <message>
        <source>The painting has no layers yet: New Layer begins one.</source>
        <translation>La obra aún no tiene capas: Nueva capa empieza una.</translation>
    </message>
    <message>
        <source>Select a group that this can be.</source>
        <translation>Seleccione un grupo al que se pueda aplicar.</translation>
    </message>
    <message>
        <source>Select strokes of a group.</source>
        <translation>Seleccione trazos de un grupo.</translation>
    </message>
    <message>
        <source>Select a text.</source>
        <translation>Seleccione un texto.</translation>
    </message>
    <message>
        <source>Select strokes without a fill.</source>
        <translation>Seleccione trazos sin relleno.</translation>
    </message>
    <message>
        <source>Select a fill of one colour.</source>
        <translation>Seleccione un relleno de un solo color.</translation>
    </message>
    <message>
        <source>Select a fill with a gradient.</source>
        <translation>Seleccione un relleno con degradado.</translation>
    </message>
    <message>
        <source>Select two strokes or more.</source>
        <translation>Seleccione dos trazos o más.</translation>
    </message>
    <message>
        <source>Select a stroke that was combined or cut into parts.</source>
        <translation>Seleccione un trazo que se haya combinado o cortado en partes.</translation>
    </message>
    <message>
        <source>Select a stroke from which something was erased softly.</source>
        <translation>Seleccione un trazo del que se haya borrado algo suavemente.</translation>
    </message>
    <message>
        <source>The painting has no underlay.</source>
        <translation>La obra no tiene calco.</translation>
    </message>
    <message>
        <source>Select paint that was wetted again.</source>
        <translation>Seleccione pintura que se haya rehumedecido.</translation>
    </message>
    <message>
        <source>Copy an appearance first.</source>
        <translation>Copie antes un aspecto.</translation>
    </message>
    <message>
        <source>The painting has no swatches.</source>
        <translation>La obra no tiene muestras.</translation>
    </message>
    <message>
        <source>The painting has no file yet: save it first.</source>
        <translation>La obra aún no tiene archivo: guárdela antes.</translation>
    </message>
    <message>
        <source>The clipboard has nothing that can be painted.</source>
        <translation>El portapapeles no contiene nada que se pueda pintar.</translation>
    </message>
    <message>
        <source>An export is still under way.</source>
        <translation>Aún hay una exportación en curso.</translation>
    </message>
    <message>
        <source>Search in the Strokes dock first.</source>
        <translation>Busque antes en el panel Trazos.</translation>
    </message>
    <message>
        <source>Switch the soft proof on first.</source>
        <translation>Active antes la prueba de color.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>No hay nada que deshacer.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>No hay nada que rehacer.</translation>
    </message>
    <message>
        <source>Select nodes with Segments first.</source>
        <translation>Seleccione antes nodos con Segmentos.</translation>
    </message>
    <message>
        <source>Select segments, or the nodes at their ends, with Segments first.</source>
        <translation>Seleccione antes segmentos, o los nodos de sus extremos, con Segmentos.</translation>
    </message>
    <message>
        <source>Select two end nodes with Segments first.</source>
        <translation>Seleccione antes dos nodos extremos con Segmentos.</translation>
    </message>
    <message>
        <source>&amp;Show the Axes of the Symmetry</source>
        <translation>M&amp;ostrar los ejes de simetría</translation>
    </message>
    <message>
        <source>Also the square that moves them and the disc that turns them</source>
        <translation>También el cuadrado que los mueve y el disco que los gira</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guía</translation>
    </message>
    <message>
        <source>Horizontal place</source>
        <translation>Posición horizontal</translation>
    </message>
    <message>
        <source>Vertical place</source>
        <translation>Posición vertical</translation>
    </message>
    <message>
        <source>Show the &amp;Rulers</source>
        <translation>Mostrar las &amp;reglas</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Along the upper and the left edge; guides are dragged out of them, and back into them</source>
        <translation>En los bordes superior e izquierdo; las guías se arrastran desde ellas, y de vuelta a ellas</translation>
    </message>
    <message>
        <source>Show the &amp;Guides</source>
        <translation>Mostrar las &amp;guías</translation>
    </message>
    <message>
        <source>&amp;Snap to Guides</source>
        <translation>&amp;Ajustar a las guías</translation>
    </message>
    <message>
        <source>Nodes, shapes and what is moved; paint goes where the hand goes</source>
        <translation>Nodos, formas y lo que se mueve; la pintura va donde va la mano</translation>
    </message>
    <message>
        <source>&amp;Lock the Guides</source>
        <translation>&amp;Bloquear las guías</translation>
    </message>
    <message>
        <source>They cannot be dragged, and new ones still can be made</source>
        <translation>No se pueden arrastrar, pero aún se pueden crear otras</translation>
    </message>
    <message>
        <source>Add a Le&amp;vel Guide…</source>
        <translation>Añadir guía &amp;horizontal…</translation>
    </message>
    <message>
        <source>Add an &amp;Upright Guide…</source>
        <translation>Añadir guía &amp;vertical…</translation>
    </message>
    <message>
        <source>Remove &amp;All Guides</source>
        <translation>Quitar &amp;todas las guías</translation>
    </message>
    <message>
        <source>S&amp;how the Assistants</source>
        <translation>&amp;Mostrar los asistentes</translation>
    </message>
    <message>
        <source>Nothing is led by those that are not seen</source>
        <translation>Los que no se ven no guían ningún trazo</translation>
    </message>
    <message>
        <source>&amp;Snap to Assistants</source>
        <translation>&amp;Ajustar a los asistentes</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>A stroke of the Brush follows the assistant whose direction it begins with</source>
        <translation>Un trazo del pincel sigue al asistente en cuya dirección empieza</translation>
    </message>
    <message>
        <source>Remove &amp;All Assistants</source>
        <translation>Quitar &amp;todos los asistentes</translation>
    </message>
    <message>
        <source>There are no assistants.</source>
        <translation>No hay asistentes.</translation>
    </message>
    <message>
        <source>Assistants</source>
        <translation>Asistentes</translation>
    </message>
    <message>
        <source>Lines, vanishing points and ellipses that lead strokes</source>
        <translation>Líneas, puntos de fuga y elipses que guían los trazos</translation>
    </message>
    <message>
        <source>Mirrored &amp;Left and Right</source>
        <translation>Reflejo &amp;izquierda y derecha</translation>
    </message>
    <message>
        <source>What is painted on one side of an upright axis comes on the other, too</source>
        <translation>Lo que se pinta a un lado de un eje vertical aparece también al otro</translation>
    </message>
    <message>
        <source>Mirrored &amp;Top and Bottom</source>
        <translation>Reflejo &amp;arriba y abajo</translation>
    </message>
    <message>
        <source>What is painted above a level axis comes below it, too</source>
        <translation>Lo que se pinta encima de un eje horizontal aparece también debajo</translation>
    </message>
    <message>
        <source>Mirrored &amp;Both Ways</source>
        <translation>Reflejo en a&amp;mbos sentidos</translation>
    </message>
    <message>
        <source>What is painted comes in all four corners of a cross</source>
        <translation>Lo que se pinta aparece en las cuatro esquinas de una cruz</translation>
    </message>
    <message>
        <source>&amp;Rotated around the Centre</source>
        <translation>&amp;Girado en torno al centro</translation>
    </message>
    <message>
        <source>What is painted comes once in each arm around the centre</source>
        <translation>Lo que se pinta aparece una vez en cada brazo en torno al centro</translation>
    </message>
    <message>
        <source>&amp;Kaleidoscope</source>
        <translation>&amp;Caleidoscopio</translation>
    </message>
    <message>
        <source>What is painted comes in each arm around the centre, and mirrored beside it</source>
        <translation>Lo que se pinta aparece en cada brazo en torno al centro, y reflejado a su lado</translation>
    </message>
    <message>
        <source>&amp;Paint in Symmetry</source>
        <translation>Pintar con &amp;simetría</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>Strokes, shapes and outlines come several times, mirrored or rotated, as one undo step</source>
        <translation>Trazos, formas y contornos aparecen varias veces, reflejados o girados, como un solo paso de deshacer</translation>
    </message>
    <message>
        <source>Number of &amp;Arms…</source>
        <translation>Número de &amp;brazos…</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Simetría</translation>
    </message>
    <message>
        <source>Arms around the centre</source>
        <translation>Brazos en torno al centro</translation>
    </message>
    <message>
        <source>An&amp;gle of the Axes…</source>
        <translation>Áng&amp;ulo de los ejes…</translation>
    </message>
    <message>
        <source>Degrees clockwise</source>
        <translation>Grados en sentido horario</translation>
    </message>
    <message>
        <source>Axes to the &amp;Middle of the Canvas</source>
        <translation>&amp;Ejes al centro del lienzo</translation>
    </message>
    <message>
        <source>The centre of the symmetry lies in the middle again, and the axes are upright and level</source>
        <translation>El centro de simetría vuelve al centro del lienzo, y los ejes quedan vertical y horizontal</translation>
    </message>
    <message>
        <source>Rulers and Guides</source>
        <translation>Reglas y guías</translation>
    </message>
    <message>
        <source>Workspace to &amp;Paint</source>
        <translation>Espacio de trabajo para &amp;pintar</translation>
    </message>
    <message>
        <source>Colour, brushes and strokes beside a wide canvas</source>
        <translation>Color, pinceles y trazos junto a un lienzo ancho</translation>
    </message>
    <message>
        <source>Workspace to &amp;Refine</source>
        <translation>Espacio de trabajo para re&amp;finar</translation>
    </message>
    <message>
        <source>Inspector, strokes, history and colour</source>
        <translation>Inspector, trazos, historial y color</translation>
    </message>
    <message>
        <source>Workspace for &amp;Time</source>
        <translation>Espacio de trabajo para el &amp;tiempo</translation>
    </message>
    <message>
        <source>A high timeline, with inspector and strokes</source>
        <translation>Una línea de tiempo alta, con inspector y trazos</translation>
    </message>
    <message>
        <source>&amp;Save Workspace…</source>
        <translation>&amp;Guardar espacio de trabajo…</translation>
    </message>
    <message>
        <source>Keep where docks and tool bars stand now, under a name</source>
        <translation>Conservar con un nombre dónde están ahora los paneles y las barras de herramientas</translation>
    </message>
    <message>
        <source>Workspaces</source>
        <translation>Espacios de trabajo</translation>
    </message>
    <message>
        <source>Rulers in &amp;Canvas Units</source>
        <translation>Reglas en unidades del &amp;lienzo</translation>
    </message>
    <message>
        <source>Rulers in &amp;Millimetres</source>
        <translation>Reglas en &amp;milímetros</translation>
    </message>
    <message>
        <source>Rulers in &amp;Inches</source>
        <translation>Reglas en &amp;pulgadas</translation>
    </message>
    <message>
        <source>New View</source>
        <translation>Nueva vista</translation>
    </message>
    <message>
        <source>A window that shows the painting from elsewhere while you paint; each edit shows in both</source>
        <translation>Una ventana que muestra la obra desde otro lugar mientras se pinta; cada cambio se ve en ambas</translation>
    </message>
    <message>
        <source>&amp;Repeat Last Extension</source>
        <translation>&amp;Repetir la última extensión</translation>
    </message>
    <message>
        <source>Ctrl+Alt+X</source>
        <translation>Ctrl+Alt+X</translation>
    </message>
    <message>
        <source>Once more, with the same values</source>
        <translation>Una vez más, con los mismos valores</translation>
    </message>
    <message>
        <source>&amp;Manage Extensions…</source>
        <translation>&amp;Gestionar extensiones…</translation>
    </message>
    <message>
        <source>Which extensions there are, which are in the menu, and what went wrong</source>
        <translation>Qué extensiones hay, cuáles están en el menú y qué ha ido mal</translation>
    </message>
    <message>
        <source>Nothing that is visible and unlocked is selected.</source>
        <translation>No hay nada seleccionado que sea visible y no esté bloqueado.</translation>
    </message>
    <message>
        <source>E&amp;xtensions</source>
        <translation>E&amp;xtensiones</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>Paint with Ke&amp;ys</source>
        <translation>Pintar con te&amp;clas</translation>
    </message>
    <message>
        <source>Ctrl+Alt+P</source>
        <translation>Ctrl+Alt+P</translation>
    </message>
    <message>
        <source>Arrow keys move a crosshair over the canvas, Space presses the tool in use down and lifts it</source>
        <translation>Las teclas de flecha mueven una cruz por el lienzo; Espacio baja y levanta la herramienta en uso</translation>
    </message>
    <message>
        <source>There are no guides.</source>
        <translation>No hay guías.</translation>
    </message>
    <message>
        <source>Choose a symmetry that turns, or the kaleidoscope, first.</source>
        <translation>Elija antes una simetría que gire, o el caleidoscopio.</translation>
    </message>
    <message>
        <source>No extension has run yet.</source>
        <translation>Aún no se ha ejecutado ninguna extensión.</translation>
    </message>
</context>
<context>
    <name>suffuse::CompareButton</name>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Shows the picture as it was before the last changes to the selection: while held, or click to switch back and forth.</source>
        <translation>Muestra la imagen como era antes de los últimos cambios en la selección: mientras se mantiene pulsado, o un clic para alternar.</translation>
    </message>
</context>
<context>
    <name>suffuse::CrossSectionPlot</name>
    <message>
        <source>Not painted yet</source>
        <translation>Aún sin pintar</translation>
    </message>
    <message>
        <source>cross-section</source>
        <translation>sección transversal</translation>
    </message>
    <message>
        <source>Covers up to %1</source>
        <translation>Cubre hasta %1</translation>
    </message>
</context>
<context>
    <name>suffuse::CurrentLayer</name>
    <message>
        <source>Layer: %1</source>
        <translation>Capa: %1</translation>
    </message>
    <message>
        <source>No layer: paint goes on top of all</source>
        <translation>Ninguna capa: la pintura va encima de todo</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Capa %1</translation>
    </message>
    <message>
        <source>New layer: %1. Paint on it.</source>
        <translation>Capa nueva: %1. Pinte en ella.</translation>
    </message>
    <message>
        <source>New clipped layer: %1. Paint on it, where the layer below has paint.</source>
        <translation>Capa recortada nueva: %1. Pinte en ella donde la capa de abajo tenga pintura.</translation>
    </message>
    <message>
        <source>All is shown again, since this would be hidden</source>
        <translation>Se muestra todo de nuevo, ya que esto quedaría oculto</translation>
    </message>
    <message>
        <source>%1 is locked: nothing is painted there</source>
        <translation>Capa bloqueada (%1): ahí no se pinta nada</translation>
    </message>
    <message>
        <source>%1 is hidden: nothing is painted there</source>
        <translation>Capa oculta (%1): ahí no se pinta nada</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 copia</translation>
    </message>
    <message>
        <source>%1 copy %2</source>
        <translation>%1 copia %2</translation>
    </message>
    <message>
        <source>Only what is on %1 is reached. Layer ▸ This Layer Only reaches all again.</source>
        <translation>Solo se alcanza lo que está en %1. Capa ▸ Solo esta capa vuelve a alcanzarlo todo.</translation>
    </message>
</context>
<context>
    <name>suffuse::CurveEditor</name>
    <message>
        <source>along the stroke →</source>
        <translation>a lo largo del trazo →</translation>
    </message>
</context>
<context>
    <name>suffuse::DensityPlot</name>
    <message>
        <source>Coverage at the peak density %1: %2 %</source>
        <translation>Cobertura en la densidad máxima %1: %2 %</translation>
    </message>
    <message>
        <source>density φ — first of several styles</source>
        <translation>densidad φ — primero de varios estilos</translation>
    </message>
    <message>
        <source>density φ</source>
        <translation>densidad φ</translation>
    </message>
    <message>
        <source>F(φ), peak %1</source>
        <translation>F(φ), máximo %1</translation>
    </message>
</context>
<context>
    <name>suffuse::Docks</name>
    <message>
        <source>&amp;Arrange</source>
        <translation>&amp;Organizar</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonda</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>Pinceles</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspector</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Trazos</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referencia</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingTool</name>
    <message>
        <source>Outline</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>What was drawn encloses no area: nothing was added.</source>
        <translation>Lo dibujado no encierra ninguna área: no se ha añadido nada.</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Relleno</translation>
    </message>
    <message>
        <source>Outline and fill</source>
        <translation>Contorno y relleno</translation>
    </message>
    <message>
        <source>What of the shape is painted</source>
        <translation>Qué se pinta de la forma</translation>
    </message>
</context>
<context>
    <name>suffuse::Editor</name>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
    <message>
        <source>%1 (recovered)</source>
        <extracomment>name of a document that was brought back after a crash</extracomment>
        <translation>%1 (recuperado)</translation>
    </message>
    <message>
        <source>is damaged, so the painting stays as it is; save it, or open the file to see what is whole of it</source>
        <translation>está dañado, así que la obra se queda como está; guárdela, o abra el archivo para ver qué está intacto</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Revertir</translation>
    </message>
</context>
<context>
    <name>suffuse::EraserFields</name>
    <message>
        <source>Fade</source>
        <translation>Atenuar</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Levantar</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Fade makes paint paler, wherever it is seen; Lift takes its density away, so that edges draw in; Cut cuts curves out</source>
        <translation>Atenuar vuelve la pintura más pálida, dondequiera que se vea; Levantar quita su densidad, de modo que los bordes se retraen; Cortar recorta las curvas</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensidad</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Suavidad</translation>
    </message>
    <message>
        <source>How far what is taken away spreads, as a share of the radius</source>
        <translation>Hasta dónde se expande lo que se quita, como parte del radio</translation>
    </message>
    <message>
        <source>Selected Strokes</source>
        <extracomment>scope of the eraser, while no stroke is selected</extracomment>
        <translation>Trazos seleccionados</translation>
    </message>
    <message>
        <source>Current Group</source>
        <translation>Grupo actual</translation>
    </message>
    <message>
        <source>All Strokes</source>
        <translation>Todos los trazos</translation>
    </message>
    <message>
        <source>From which strokes; without a selection, the first choice means all</source>
        <translation>De qué trazos; sin selección, la primera opción significa todos</translation>
    </message>
    <message>
        <source>All (None Selected)</source>
        <translation>Todos (nada seleccionado)</translation>
    </message>
    <message>
        <source>Fade: the share of the paint that is taken. Lift: how much density, so that feathered paint gets paler and paint with a sharp edge narrower. A pen&apos;s pressure takes from it</source>
        <translation>Atenuar: la parte de la pintura que se quita. Levantar: cuánta densidad; la pintura difuminada se vuelve más pálida, y la de borde nítido, más estrecha. La presión del lápiz la reduce</translation>
    </message>
    <message>
        <source>Sharp edges draw in.</source>
        <translation>Los bordes nítidos se retraen.</translation>
    </message>
</context>
<context>
    <name>suffuse::ErasureRows</name>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Fade makes paint paler; Lift takes its density away, so that edges draw in.</source>
        <translation>Atenuar vuelve la pintura más pálida; Levantar quita su densidad, de modo que los bordes se retraen.</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>Atenuar</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Levantar</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>The diameter of the eraser, if its softness was the usual one.</source>
        <translation>El diámetro de la goma, si su suavidad era la habitual.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensidad</translation>
    </message>
    <message>
        <source>The share of the paint that it takes in its middle.</source>
        <translation>La parte de la pintura que quita en su centro.</translation>
    </message>
    <message>
        <source>Density taken</source>
        <translation>Densidad quitada</translation>
    </message>
    <message>
        <source>Change size</source>
        <translation>Cambiar tamaño</translation>
    </message>
    <message>
        <source>The density that it takes away in its middle: paint that is thinner is gone there.</source>
        <translation>La densidad que quita en su centro: la pintura más delgada desaparece allí.</translation>
    </message>
    <message>
        <source>Change strength</source>
        <translation>Cambiar intensidad</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>No es posible para todo lo seleccionado: un valor quedaría fuera del intervalo.</translation>
    </message>
    <message>
        <source>Change kind of erasure</source>
        <translation>Cambiar tipo de borrado</translation>
    </message>
</context>
<context>
    <name>suffuse::EraserTool</name>
    <message>
        <source>Erase</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Fade: drag to make the selected strokes paler, by the strength. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Atenuar: arrastrar para volver más pálidos los trazos seleccionados, según la intensidad. Mayús: cortar. [ y ]: tamaño; { y }: intensidad.</translation>
    </message>
    <message>
        <source>Fade: drag to make the strokes of the group paler, by the strength. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Atenuar: arrastrar para volver más pálidos los trazos del grupo, según la intensidad. Mayús: cortar. [ y ]: tamaño; { y }: intensidad.</translation>
    </message>
    <message>
        <source>Fade: drag to make paint paler, by the strength, wherever it is seen. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Atenuar: arrastrar para volver más pálida la pintura que se vea, según la intensidad. Mayús: cortar. [ y ]: tamaño; { y }: intensidad.</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly from the selected strokes. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Levantar: arrastrar para quitar pintura suavemente de los trazos seleccionados. Mayús: cortar. [ y ]: tamaño; { y }: intensidad.</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly from the strokes of the group. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Levantar: arrastrar para quitar pintura suavemente de los trazos del grupo. Mayús: cortar. [ y ]: tamaño; { y }: intensidad.</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly, wherever it is seen. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Levantar: arrastrar para quitar pintura suavemente, dondequiera que se vea. Mayús: cortar. [ y ]: tamaño; { y }: intensidad.</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the selected curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>Cortar: arrastrar para recortar lo que hay bajo el círculo de las curvas seleccionadas. Mayús: borrar suavemente. [ y ]: tamaño.</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the group&apos;s curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>Cortar: arrastrar para recortar lo que hay bajo el círculo de las curvas del grupo. Mayús: borrar suavemente. [ y ]: tamaño.</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>Cortar: arrastrar para recortar lo que hay de las curvas bajo el círculo. Mayús: borrar suavemente. [ y ]: tamaño.</translation>
    </message>
    <message>
        <source>Nothing is erased: no paint is seen under the circle.</source>
        <translation>No se borra nada: no se ve pintura bajo el círculo.</translation>
    </message>
    <message>
        <source>Nothing is cut: no curve lies under the circle. Fade takes paint away wherever it is seen.</source>
        <translation>No se corta nada: no hay ninguna curva bajo el círculo. Atenuar quita pintura dondequiera que se vea.</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is not selected.</source>
        <translation>No se borra nada: lo que hay bajo el círculo no está seleccionado.</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is in another group.</source>
        <translation>No se borra nada: lo que hay bajo el círculo está en otro grupo.</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is locked.</source>
        <translation>No se borra nada: lo que hay bajo el círculo está bloqueado.</translation>
    </message>
    <message>
        <source>It was cut, but hardly a gap is seen: its edges are softer than the cut is wide. Fade takes its paint away.</source>
        <translation>Se ha cortado, pero apenas se ve un hueco: sus bordes son más suaves que el ancho del corte. Atenuar quita su pintura.</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is not on the layer, and only that is reached.</source>
        <translation>No se borra nada: lo que hay bajo el círculo no está en la capa, y solo se alcanza esta.</translation>
    </message>
</context>
<context>
    <name>suffuse::ExportDialog</name>
    <message>
        <source>8 bit</source>
        <translation>8 bits</translation>
    </message>
    <message>
        <source>16 bit</source>
        <translation>16 bits</translation>
    </message>
    <message>
        <source>16 bit floating point</source>
        <translation>16 bits, coma flotante</translation>
    </message>
    <message>
        <source>32 bit floating point</source>
        <translation>32 bits, coma flotante</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>The ending chooses the format: png, tiff, exr, jpg, webp or pfm, or ora or psd with layers.</source>
        <translation>La terminación elige el formato: png, tiff, exr, jpg, webp o pfm, u ora o psd con capas.</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>Elegir una carpeta y un nombre</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>Precision of each colour channel</source>
        <translation>Precisión de cada canal de color</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Calidad</translation>
    </message>
    <message>
        <source>Of JPEG and WebP; 100 is the best. WebP loses nothing then.</source>
        <translation>De JPEG y WebP; 100 es la mejor. Entonces WebP no pierde nada.</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Fondo transparente</translation>
    </message>
    <message>
        <source>Leaves the background out and stores how much the paint covers.</source>
        <translation>Omite el fondo y guarda cuánto cubre la pintura.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>Anchura en píxeles</translation>
    </message>
    <message>
        <source>Width in pixels; the height follows.</source>
        <translation>Anchura en píxeles; la altura la sigue.</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>Altura en píxeles</translation>
    </message>
    <message>
        <source>Height in pixels; the width follows.</source>
        <translation>Altura en píxeles; la anchura la sigue.</translation>
    </message>
    <message>
        <source>painting</source>
        <translation>obra</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>“%1” has no ending of a picture format. Choose one of: %2.</source>
        <translation>«%1» no tiene la terminación de un formato de imagen. Elija una de: %2.</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 ya existe. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportar</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>Ex&amp;aminar…</translation>
    </message>
    <message>
        <source>What it holds now is lost.</source>
        <translation>Lo que contiene ahora se perderá.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Reemplazar</translation>
    </message>
    <message>
        <source>At most %1 × %2 px</source>
        <translation>Como máximo, %1 × %2 px</translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation>Exportar imagen</translation>
    </message>
    <message>
        <source>No picture format</source>
        <translation>No es un formato de imagen</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>What is written. The ending of the file&apos;s name says the same.</source>
        <translation>Lo que se escribe. La terminación del nombre del archivo dice lo mismo.</translation>
    </message>
    <message>
        <source>Pictures are written here. File ▸ Export Drawing writes SVG.</source>
        <translation>Aquí se escriben imágenes. Archivo ▸ Exportar dibujo escribe SVG.</translation>
    </message>
    <message>
        <source>Photoshop (layers)</source>
        <translation>Photoshop (capas)</translation>
    </message>
    <message>
        <source>OpenRaster (layers)</source>
        <translation>OpenRaster (capas)</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>The colour profile that the file has. The painting keeps the one that was chosen from a file.</source>
        <translation>El perfil de color que tiene el archivo. La obra conserva el que se eligió de un archivo.</translation>
    </message>
</context>
<context>
    <name>suffuse::ExportJob</name>
    <message>
        <source>A picture of %1 × %2 pixels does not fit into memory. Choose a smaller size.</source>
        <translation>Una imagen de %1 × %2 píxeles no cabe en la memoria. Elija un tamaño menor.</translation>
    </message>
</context>
<context>
    <name>suffuse::Exporting</name>
    <message>
        <source>Exported to %1</source>
        <translation>Exportado a %1</translation>
    </message>
    <message>
        <source>Printed to %1</source>
        <translation>Impreso en %1</translation>
    </message>
    <message>
        <source>Given to the printer %1</source>
        <translation>Enviado a la impresora %1</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>Exportando %1…</translation>
    </message>
</context>
<context>
    <name>suffuse::EyedropperTool</name>
    <message>
        <source>Click to take the picture&apos;s colour as the current one. Shift: the stroke&apos;s own colour.</source>
        <translation>Clic: tomar el color de la imagen como color actual. Mayús: el color propio del trazo.</translation>
    </message>
    <message>
        <source>A click takes</source>
        <translation>Un clic toma</translation>
    </message>
    <message>
        <source>The colour, to paint with</source>
        <translation>El color, para pintar</translation>
    </message>
    <message>
        <source>The appearance, for the selection</source>
        <translation>El aspecto, para la selección</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Igualar</translation>
    </message>
    <message>
        <source>Select strokes first: they get the appearance of the stroke you click.</source>
        <translation>Seleccione antes trazos: toman el aspecto del trazo en el que haga clic.</translation>
    </message>
    <message>
        <source>Click a stroke: the selected ones get its appearance, and what varies along them stays. Shift: the same values all along.</source>
        <translation>Clic en un trazo: los seleccionados toman su aspecto; lo que varía a lo largo se mantiene. Mayús: los mismos valores en todo el trazo.</translation>
    </message>
    <message>
        <source>Click to give what is selected the picture&apos;s colour. Shift: the stroke&apos;s own colour. Ctrl: its whole appearance.</source>
        <translation>Clic: dar a lo seleccionado el color de la imagen. Mayús: el color propio del trazo. Ctrl: todo su aspecto.</translation>
    </message>
    <message>
        <source>Click to give the swatch the picture&apos;s colour. Shift: the stroke&apos;s own colour.</source>
        <translation>Clic: dar a la muestra el color de la imagen. Mayús: el color propio del trazo.</translation>
    </message>
    <message>
        <source>A colour, or style, values and colour of a stroke for the selected ones. The colour is for what the Colour dock shows: the brush, the selection or a swatch.</source>
        <translation>Un color, o el estilo, los valores y el color de un trazo para los seleccionados. El color es para lo que muestra el panel Color: el pincel, la selección o una muestra.</translation>
    </message>
    <message>
        <source>The colour, for the selection</source>
        <translation>El color, para la selección</translation>
    </message>
    <message>
        <source>The colour, for the swatch</source>
        <translation>El color, para la muestra</translation>
    </message>
</context>
<context>
    <name>suffuse::FiguresSection</name>
    <message>
        <source>The outline lays no paint: its density φ is 0. What is seen is the fill.</source>
        <translation>El contorno no aplica pintura: su densidad φ es 0. Lo que se ve es el relleno.</translation>
    </message>
    <message>
        <source>Density function</source>
        <translation>Función de densidad</translation>
    </message>
    <message>
        <source>How density becomes coverage. The mark is the peak density of the selected segments.</source>
        <translation>Cómo la densidad se convierte en cobertura. La marca es la densidad máxima de los segmentos seleccionados.</translation>
    </message>
    <message>
        <source>Cross-section</source>
        <translation>Sección transversal</translation>
    </message>
    <message>
        <source>The cut through the stroke at the first selected segment, at the moment shown: coverage, on the colour that it has on the background.</source>
        <translation>El corte del trazo en el primer segmento seleccionado, en el momento mostrado: la cobertura, con el color que tiene sobre el fondo.</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>Spread s</source>
        <translation>Expansión s</translation>
    </message>
    <message>
        <source>Peak density</source>
        <translation>Densidad máxima</translation>
    </message>
    <message>
        <source>Half-width</source>
        <translation>Media anchura</translation>
    </message>
    <message>
        <source>Fades away</source>
        <translation>Se desvanece</translation>
    </message>
    <message>
        <source>Density in the middle of a long straight stroke, dry.</source>
        <translation>Densidad en el centro de un trazo largo y recto, seco.</translation>
    </message>
    <message>
        <source>From the middle to the visible edge of a long straight stroke, dry.</source>
        <translation>Del centro al borde visible de un trazo largo y recto, seco.</translation>
    </message>
    <message>
        <source>When the paint has spread so thin that nothing of it is visible any more.</source>
        <translation>Cuándo se ha expandido tanto la pintura que ya no se ve nada de ella.</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nunca</translation>
    </message>
    <message>
        <source>partly, from %1</source>
        <translation>en parte, desde %1</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>tras %1</translation>
    </message>
    <message>
        <source>Spread along</source>
        <translation>Expansión a lo largo</translation>
    </message>
    <message>
        <source>How far the paint has spread across the curve once it is dry: √(4·D·t_max).</source>
        <translation>Hasta dónde se ha expandido la pintura a través de la curva una vez seca: √(4·D·t_max).</translation>
    </message>
    <message>
        <source>How far it has spread along the curve.</source>
        <translation>Hasta dónde se ha expandido a lo largo de la curva.</translation>
    </message>
    <message>
        <source>Spread across</source>
        <translation>Expansión a través</translation>
    </message>
    <message>
        <source>Takes away</source>
        <translation>Quita</translation>
    </message>
    <message>
        <source>How softly the erasure ends: how far it has spread beside its curve, √(4·D·t_max).</source>
        <translation>Con qué suavidad termina el borrado: hasta dónde se ha expandido junto a su curva, √(4·D·t_max).</translation>
    </message>
    <message>
        <source>What one segment of the erasure takes away in its middle: the share of the paint if it fades; density if it lifts, and paint that is thinner is gone there.</source>
        <translation>Lo que un segmento del borrado quita en su centro: una parte de la pintura si atenúa; densidad si levanta, y la pintura menos densa desaparece ahí.</translation>
    </message>
</context>
<context>
    <name>suffuse::FileOpening</name>
    <message>
        <source>Pictures with layers (*.ora *.psd)</source>
        <translation>Imágenes con capas (*.ora *.psd)</translation>
    </message>
    <message>
        <source>All that can be opened (*.suffuse *.json *.ora *.psd *.csv *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote *.svg *.svgz *.pdf *.xml)</source>
        <translation>Todo lo que se puede abrir (*.suffuse *.json *.ora *.psd *.csv *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote *.svg *.svgz *.pdf *.xml)</translation>
    </message>
    <message>
        <source>Suffuse paintings (*.suffuse *.json)</source>
        <translation>Obras de Suffuse (*.suffuse *.json)</translation>
    </message>
    <message>
        <source>Backups of paintings (*.suffuse~* *.json~*)</source>
        <translation>Copias de seguridad de obras (*.suffuse~* *.json~*)</translation>
    </message>
    <message>
        <source>Pen recordings (*.csv *.json *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote)</source>
        <translation>Grabaciones de lápiz (*.csv *.json *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote)</translation>
    </message>
    <message>
        <source>Drawings (*.svg *.svgz *.pdf)</source>
        <translation>Dibujos (*.svg *.svgz *.pdf)</translation>
    </message>
    <message>
        <source>Diffusion curves (*.xml)</source>
        <translation>Curvas de difusión (*.xml)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>“%1” is open already.</source>
        <translation>«%1» ya está abierto.</translation>
    </message>
    <message>
        <source>“%1” is damaged. What is whole of it was opened; the file itself is left as it is.</source>
        <translation>«%1» está dañado. Se ha abierto lo que está intacto; el archivo en sí se queda como está.</translation>
    </message>
    <message>
        <source>&amp;Clear the List</source>
        <translation>&amp;Vaciar la lista</translation>
    </message>
</context>
<context>
    <name>suffuse::FileRestoring</name>
    <message>
        <source>Revert “%1” to what the file holds?</source>
        <translation>¿Revertir «%1» a lo que contiene el archivo?</translation>
    </message>
    <message>
        <source>What was painted since the last save goes; Undo brings it back.</source>
        <translation>Lo pintado desde el último guardado desaparece; Deshacer lo recupera.</translation>
    </message>
    <message>
        <source>&amp;Revert</source>
        <translation>&amp;Revertir</translation>
    </message>
    <message>
        <source>Restore backup of %1</source>
        <translation>Restaurar la copia de seguridad del %1</translation>
    </message>
    <message>
        <source>The backup of %1 is back. Undo takes it away again; no file changes until you save.</source>
        <translation>Se ha restaurado la copia de seguridad del %1. Deshacer la vuelve a quitar; ningún archivo cambia hasta que guarde.</translation>
    </message>
    <message>
        <source>The backup of %1 is what you see: nothing has changed.</source>
        <translation>La copia de seguridad del %1 es lo que está viendo: no ha cambiado nada.</translation>
    </message>
    <message>
        <source>The backup is damaged. What is whole of it was restored.</source>
        <translation>La copia de seguridad está dañada. Se ha restaurado lo que está intacto.</translation>
    </message>
</context>
<context>
    <name>suffuse::FileSaving</name>
    <message>
        <source>What you paint now would not survive a crash: %1. Painting goes on; save from time to time.</source>
        <translation>Lo que pinte ahora no sobreviviría a un fallo: %1. Se puede seguir pintando; guarde de vez en cuando.</translation>
    </message>
    <message>
        <source>“%1” is gone from its folder. Save to put it back.</source>
        <translation>«%1» ha desaparecido de su carpeta. Guarde para volver a ponerlo.</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Guardar como</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <extracomment>name of the file that a copy is saved to, beside that of the painting</extracomment>
        <translation>%1 copia</translation>
    </message>
    <message>
        <source>Save a Copy</source>
        <translation>Guardar una copia</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>Guardando «%1»…</translation>
    </message>
    <message>
        <source>A copy is saved as “%1”.</source>
        <translation>Se ha guardado una copia como «%1».</translation>
    </message>
    <message>
        <source>“%1” is saved already.</source>
        <translation>«%1» ya está guardado.</translation>
    </message>
    <message>
        <source>%1 (without what is still being drawn)</source>
        <translation>%1 (sin lo que aún se está dibujando)</translation>
    </message>
    <message>
        <source>Saved “%1”, %2</source>
        <translation>Guardado «%1», %2</translation>
    </message>
    <message>
        <source>Saved “%1”, but %2</source>
        <translation>Guardado «%1», pero %2</translation>
    </message>
    <message>
        <source>“%1” is not saved.</source>
        <translation>«%1» no está guardado.</translation>
    </message>
    <message>
        <source>Suffuse painting</source>
        <translation>Obra de Suffuse</translation>
    </message>
    <message>
        <source>Text form</source>
        <translation>Forma de texto</translation>
    </message>
    <message>
        <source>“%1” is open in another window. Choose another name, or close that window first.</source>
        <translation>«%1» está abierto en otra ventana. Elija otro nombre o cierre antes esa ventana.</translation>
    </message>
    <message>
        <source>“%1” has plain lines and areas, for other programs. Export Drawing keeps soft and dark edges.</source>
        <translation>«%1» tiene líneas y áreas simples, para otros programas. Exportar dibujo conserva los bordes suaves y oscuros.</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>Dibujo SVG</translation>
    </message>
</context>
<context>
    <name>suffuse::FileTypes</name>
    <message>
        <source>Suffuse painting</source>
        <translation>Obra de Suffuse</translation>
    </message>
    <message>
        <source>Suffuse brush</source>
        <translation>Pincel de Suffuse</translation>
    </message>
    <message>
        <source>Backup of a painting</source>
        <translation>Copia de seguridad de una obra</translation>
    </message>
</context>
<context>
    <name>suffuse::Files</name>
    <message numerus="yes">
        <source>%n adjustment or fill layer(s)</source>
        <translation>
            <numerusform>%n capa de ajuste o de relleno</numerusform>
            <numerusform>%n capas de ajuste o de relleno</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the effects of %n layer(s)</source>
        <translation>
            <numerusform>los efectos de %n capa</numerusform>
            <numerusform>los efectos de %n capas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the mask(s) of %n group(s)</source>
        <translation>
            <numerusform>la máscara de %n grupo</numerusform>
            <numerusform>las máscaras de %n grupos</numerusform>
        </translation>
    </message>
    <message>
        <source>This Photoshop file is damaged.</source>
        <translation>Este archivo de Photoshop está dañado.</translation>
    </message>
    <message>
        <source>Photoshop picture</source>
        <translation>Imagen de Photoshop</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Photoshop files over 30,000 pixels a side (PSB) are not read. Save it as PSD.</source>
        <translation>Los archivos de Photoshop de más de 30 000 píxeles por lado (PSB) no se leen. Guárdelo como PSD.</translation>
    </message>
    <message>
        <source>Only Photoshop files in RGB or grey of 8 or 16 bits are read. Convert it to RGB.</source>
        <translation>Solo se leen archivos de Photoshop en RGB o gris de 8 o 16 bits. Conviértalo a RGB.</translation>
    </message>
    <message numerus="yes">
        <source>%n layer(s) whose picture is missing, damaged or too large</source>
        <translation>
            <numerusform>%n capa cuya imagen falta, está dañada o es demasiado grande</numerusform>
            <numerusform>%n capas cuya imagen falta, está dañada o es demasiado grande</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the mode(s) of %n layer(s)</source>
        <translation>
            <numerusform>el modo de %n capa</numerusform>
            <numerusform>los modos de %n capas</numerusform>
        </translation>
    </message>
    <message>
        <source>This OpenRaster file is damaged: %1.</source>
        <translation>Este archivo OpenRaster está dañado: %1.</translation>
    </message>
    <message>
        <source>it has no list of its layers</source>
        <translation>no tiene la lista de sus capas</translation>
    </message>
    <message>
        <source>its list of layers cannot be read</source>
        <translation>su lista de capas no se puede leer</translation>
    </message>
    <message>
        <source>is a folder; give a file name inside it</source>
        <translation>es una carpeta; indique un nombre de archivo dentro de ella</translation>
    </message>
    <message>
        <source>is a device or a pipe, not a file; save to a file</source>
        <translation>es un dispositivo o una tubería, no un archivo; guarde en un archivo</translation>
    </message>
    <message>
        <source>the folder %1 does not exist; create it or choose another one</source>
        <translation>la carpeta %1 no existe; créela o elija otra</translation>
    </message>
    <message>
        <source>%1 is not a folder; choose another place</source>
        <translation>%1 no es una carpeta; elija otro lugar</translation>
    </message>
    <message>
        <source>the folder %1 is read-only; choose another one or change its permissions</source>
        <translation>la carpeta %1 es de solo lectura; elija otra o cambie sus permisos</translation>
    </message>
    <message>
        <source>The file has no name; choose one</source>
        <translation>El archivo no tiene nombre; elija uno</translation>
    </message>
    <message>
        <source>would have more than 2 GB; nothing was written</source>
        <translation>ocuparía más de 2 GB; no se ha escrito nada</translation>
    </message>
    <message>
        <source>cannot be written (%1); choose another place</source>
        <translation>no se puede escribir (%1); elija otro lugar</translation>
    </message>
    <message>
        <source>%1 (%2); the old file, if there was one, is as before. Free some space or choose another place</source>
        <translation>%1 (%2); el archivo antiguo, si lo había, está como antes. Libere espacio o elija otro lugar</translation>
    </message>
    <message>
        <source>could not be written in full</source>
        <translation>no se ha podido escribir entero</translation>
    </message>
    <message>
        <source>could not be put in place</source>
        <translation>no se ha podido poner en su sitio</translation>
    </message>
    <message>
        <source>was written, but the folder could not be brought to the disk (%1); save once more before you switch off</source>
        <translation>se ha escrito, pero la carpeta no se ha podido llevar al disco (%1); guarde una vez más antes de apagar</translation>
    </message>
    <message>
        <source>the image has %1 MB; at most 64 MB are possible, make it smaller</source>
        <translation>la imagen ocupa %1 MB; se admiten 64 MB como máximo, redúzcala</translation>
    </message>
    <message>
        <source>is not a PNG, JPEG, TIFF, WebP or EXR image; convert it to one of them</source>
        <translation>no es una imagen PNG, JPEG, TIFF, WebP ni EXR; conviértala a uno de estos formatos</translation>
    </message>
    <message>
        <source>is empty; give a data: URL or the path of an image file</source>
        <translation>está vacío; indique una URL data: o la ruta de un archivo de imagen</translation>
    </message>
    <message>
        <source>the image file %1 is missing; put it there or correct the path</source>
        <translation>falta el archivo de imagen %1; póngalo ahí o corrija la ruta</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 no es un archivo</translation>
    </message>
    <message>
        <source>the image file %1 has %2 MB; at most 64 MB are possible</source>
        <translation>el archivo de imagen %1 ocupa %2 MB; se admiten 64 MB como máximo</translation>
    </message>
    <message>
        <source>the image file %1 cannot be read: %2</source>
        <translation>no se puede leer el archivo de imagen %1: %2</translation>
    </message>
    <message>
        <source>is not a data:…;base64,… URL</source>
        <translation>no es una URL data:…;base64,…</translation>
    </message>
    <message>
        <source>the image is too large; at most 64 MB are possible</source>
        <translation>la imagen es demasiado grande; se admiten 64 MB como máximo</translation>
    </message>
    <message>
        <source>the base64 data of the image are damaged</source>
        <translation>los datos base64 de la imagen están dañados</translation>
    </message>
    <message>
        <source>has more than 2 GB; that is more than can be opened</source>
        <translation>ocupa más de 2 GB; es más de lo que se puede abrir</translation>
    </message>
    <message>
        <source>could not be read: %1</source>
        <translation>no se ha podido leer: %1</translation>
    </message>
    <message>
        <source>Suffuse painting</source>
        <translation>Obra de Suffuse</translation>
    </message>
    <message>
        <source>Suffuse text form</source>
        <translation>Forma de texto de Suffuse</translation>
    </message>
    <message>
        <source>Ink recording (CSV)</source>
        <translation>Grabación de tinta (CSV)</translation>
    </message>
    <message>
        <source>Universal Ink</source>
        <translation>Universal Ink</translation>
    </message>
    <message>
        <source>Excalidraw drawing</source>
        <translation>Dibujo de Excalidraw</translation>
    </message>
    <message>
        <source>MyPaint events</source>
        <translation>Eventos de MyPaint</translation>
    </message>
    <message>
        <source>Unknown format</source>
        <translation>Formato desconocido</translation>
    </message>
    <message>
        <source>there is no such file: %1</source>
        <translation>no existe ese archivo: %1</translation>
    </message>
    <message>
        <source>is a folder; give a file inside it</source>
        <translation>es una carpeta; indique un archivo dentro de ella</translation>
    </message>
    <message>
        <source>could not be opened: %1; check its permissions</source>
        <translation>no se ha podido abrir: %1; compruebe sus permisos</translation>
    </message>
    <message>
        <source>the ending is neither .suffuse nor .json; choose one of them</source>
        <translation>la terminación no es .suffuse ni .json; elija una de ellas</translation>
    </message>
    <message>
        <source>%1: has less than 2 numbers</source>
        <translation>%1: tiene menos de 2 números</translation>
    </message>
    <message>
        <source>holds no freedraw elements; only those become strokes</source>
        <translation>no contiene elementos freedraw; solo estos se convierten en trazos</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>no es un objeto JSON</translation>
    </message>
    <message>
        <source>: is not a list of numbers</source>
        <translation>: no es una lista de números</translation>
    </message>
    <message>
        <source>%1[%2]: is not a number within ±1e15</source>
        <translation>%1[%2]: no es un número dentro de ±1e15</translation>
    </message>
    <message>
        <source>line %1, column %2: “%3” is not a number within ±1e15</source>
        <translation>línea %1, columna %2: «%3» no es un número dentro de ±1e15</translation>
    </message>
    <message>
        <source>is empty; there is nothing to paint</source>
        <translation>está vacío; no hay nada que pintar</translation>
    </message>
    <message>
        <source>line %1: no columns x and y; name the columns x, y, time and pressure</source>
        <translation>línea %1: no hay columnas x e y; llame a las columnas x, y, time y pressure</translation>
    </message>
    <message>
        <source>%1: splineX has %2 numbers, splineY %3</source>
        <translation>%1: splineX tiene %2 números, splineY %3</translation>
    </message>
    <message>
        <source>an object {…}</source>
        <translation>un objeto {…}</translation>
    </message>
    <message>
        <source>a list […]</source>
        <translation>una lista […]</translation>
    </message>
    <message>
        <source>the file ends here, “%1” is missing; it is probably cut off</source>
        <translation>el archivo termina aquí, falta «%1»; probablemente está cortado</translation>
    </message>
    <message>
        <source>expected “,” or “%1” before “%2”</source>
        <translation>se esperaba «,» o «%1» antes de «%2»</translation>
    </message>
    <message>
        <source>expected a member&apos;s name in quotes before “%1”</source>
        <translation>se esperaba el nombre de un miembro entre comillas antes de «%1»</translation>
    </message>
    <message>
        <source>expected “:” after “%1”</source>
        <translation>se esperaba «:» después de «%1»</translation>
    </message>
    <message>
        <source>is given twice; keep one of them</source>
        <translation>aparece dos veces; deje solo uno</translation>
    </message>
    <message>
        <source>is not a member of this format; correct or remove it</source>
        <translation>no es un miembro de este formato; corríjalo o quítelo</translation>
    </message>
    <message>
        <source>a string has a wrong escape “\%1”</source>
        <translation>una cadena tiene una secuencia de escape incorrecta «\%1»</translation>
    </message>
    <message>
        <source>the file ends inside a string; it is probably cut off</source>
        <translation>el archivo termina dentro de una cadena; probablemente está cortado</translation>
    </message>
    <message>
        <source>a string has a control character; write it as an escape such as \n</source>
        <translation>una cadena tiene un carácter de control; escríbalo como secuencia de escape, como \n</translation>
    </message>
    <message>
        <source>the file ends here; it is probably cut off</source>
        <translation>el archivo termina aquí; probablemente está cortado</translation>
    </message>
    <message>
        <source>expected %1 before “%2”</source>
        <translation>se esperaba %1 antes de «%2»</translation>
    </message>
    <message>
        <source>%1 is not %2</source>
        <translation>%1 no es %2</translation>
    </message>
    <message>
        <source>has %1 numbers instead of %2</source>
        <translation>tiene %1 números en lugar de %2</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>%1 is too large; the largest number is %2</source>
        <translation>%1 es demasiado grande; el número mayor es %2</translation>
    </message>
    <message>
        <source>%1 is not a whole number from 0 to 2^64 − 1</source>
        <translation>%1 no es un número entero de 0 a 2^64 − 1</translation>
    </message>
    <message>
        <source>%1 s is not in [-1e12, 1e12]</source>
        <translation>%1 s no está en [-1e12, 1e12]</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true o false</translation>
    </message>
    <message>
        <source>a string in quotes</source>
        <translation>una cadena entre comillas</translation>
    </message>
    <message>
        <source>is not UTF-8; save the file in that encoding</source>
        <translation>no es UTF-8; guarde el archivo con esa codificación</translation>
    </message>
    <message>
        <source>“%1” follows after the end of the painting; remove it</source>
        <translation>«%1» aparece después del final de la obra; quítelo</translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>línea %1, columna %2: %3</translation>
    </message>
    <message>
        <source>standard input</source>
        <translation>entrada estándar</translation>
    </message>
    <message>
        <source>holds no pen strokes; there is nothing to paint</source>
        <translation>no contiene trazos de lápiz; no hay nada que pintar</translation>
    </message>
    <message>
        <source>the strokes span %1 × %2 units; at most 1e6 are possible, scale them down</source>
        <translation>los trazos abarcan %1 × %2 unidades; se admiten 1e6 como máximo, redúzcalos</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>línea %1, columna %2</translation>
    </message>
    <message>
        <source>a value has the wrong type</source>
        <translation>un valor tiene un tipo incorrecto</translation>
    </message>
    <message>
        <source>the first chunk must be HEAD</source>
        <translation>el primer bloque debe ser HEAD</translation>
    </message>
    <message>
        <source>there is more than one HEAD</source>
        <translation>hay más de un HEAD</translation>
    </message>
    <message>
        <source>there is more than one</source>
        <translation>hay más de uno</translation>
    </message>
    <message>
        <source>chunk %1 at byte %2 is unknown, and the painting needs it; update Suffuse</source>
        <translation>el bloque %1 en el byte %2 es desconocido, y la obra lo necesita; actualice Suffuse</translation>
    </message>
    <message>
        <source>is not a CBOR map</source>
        <translation>no es un mapa CBOR</translation>
    </message>
    <message>
        <source>lacks the version or the counts</source>
        <translation>no tiene la versión o los recuentos</translation>
    </message>
    <message>
        <source>was written by a newer program (%1): it needs a reader of version %2, this one is %3; update Suffuse</source>
        <translation>lo escribió un programa más nuevo (%1): necesita un lector de la versión %2, y este es el %3; actualice Suffuse</translation>
    </message>
    <message>
        <source>the chunk DOCU is missing; the file is damaged, take a backup copy</source>
        <translation>falta el bloque DOCU; el archivo está dañado, use una copia de seguridad</translation>
    </message>
    <message>
        <source>should hold %1 strokes and %2 segments, but holds %3 and %4; the file is damaged, take a backup copy</source>
        <translation>debería contener %1 trazos y %2 segmentos, pero contiene %3 y %4; el archivo está dañado, use una copia de seguridad</translation>
    </message>
    <message>
        <source>the file is damaged, take a backup copy</source>
        <translation>el archivo está dañado, use una copia de seguridad</translation>
    </message>
    <message>
        <source>is not a .suffuse file</source>
        <translation>no es un archivo .suffuse</translation>
    </message>
    <message>
        <source>the hash of the whole differs</source>
        <translation>el hash del conjunto no coincide</translation>
    </message>
    <message>
        <source>%1 bytes follow after the end</source>
        <translation>siguen %1 bytes después del final</translation>
    </message>
    <message>
        <source>has %1 bytes, but the file only %2 more</source>
        <translation>tiene %1 bytes, pero al archivo solo le quedan %2</translation>
    </message>
    <message>
        <source>checksum differs</source>
        <translation>la suma de comprobación no coincide</translation>
    </message>
    <message>
        <source>%1 strokes and %2 segments are more than the file can hold</source>
        <translation>%1 trazos y %2 segmentos son más de los que puede contener el archivo</translation>
    </message>
    <message>
        <source>its columns are not what the format allows</source>
        <translation>sus columnas no son las que permite el formato</translation>
    </message>
    <message>
        <source>stroke %1 of it is not what the format allows</source>
        <translation>el trazo %1 no es como permite el formato</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>falta</translation>
    </message>
    <message>
        <source>“%1” is none of: %2</source>
        <translation>«%1» no es ninguno de: %2</translation>
    </message>
    <message>
        <source>has %1 numbers; the kind %2 has %3</source>
        <translation>tiene %1 números; el tipo %2 tiene %3</translation>
    </message>
    <message>
        <source>belongs to the mode beta; remove it or change the mode</source>
        <translation>pertenece al modo beta; quítelo o cambie el modo</translation>
    </message>
    <message>
        <source>has %1 points instead of 4</source>
        <translation>tiene %1 puntos en lugar de 4</translation>
    </message>
    <message>
        <source>has %1 numbers instead of 2</source>
        <translation>tiene %1 números en lugar de 2</translation>
    </message>
    <message>
        <source>0 is not an id; count from 1 or leave it out</source>
        <translation>0 no es un identificador; cuente desde 1 u omítalo</translation>
    </message>
    <message>
        <source>%1 is not in [0, 4294967295]</source>
        <translation>%1 no está en [0, 4294967295]</translation>
    </message>
    <message>
        <source>width and height must not be negative</source>
        <translation>la anchura y la altura no deben ser negativas</translation>
    </message>
    <message>
        <source>%1 is not in [0, 1]</source>
        <translation>%1 no está en [0, 1]</translation>
    </message>
    <message>
        <source>“%1” is not “suffuse-text”</source>
        <translation>«%1» no es «suffuse-text»</translation>
    </message>
    <message>
        <source>0 is not a version; write 1</source>
        <translation>0 no es una versión; escriba 1</translation>
    </message>
    <message>
        <source>%1 is not a version that this program reads; it reads 1</source>
        <translation>%1 no es una versión que lea este programa; lee la 1</translation>
    </message>
    <message>
        <source>another curve is of the same quantity and input; keep one of them</source>
        <translation>otra curva es de la misma magnitud y entrada; deje solo una</translation>
    </message>
    <message>
        <source>needs 2 to 16 points [x, y] in [0, 1], from left to right</source>
        <translation>necesita de 2 a 16 puntos [x, y] en [0, 1], de izquierda a derecha</translation>
    </message>
    <message>
        <source>could not be opened: %1</source>
        <translation>no se ha podido abrir: %1</translation>
    </message>
    <message>
        <source>has more than 1 MB; it is not a brush</source>
        <translation>ocupa más de 1 MB; no es un pincel</translation>
    </message>
    <message>
        <source>a colour has three numbers: red, green, blue</source>
        <translation>un color tiene tres números: rojo, verde, azul</translation>
    </message>
    <message>
        <source>“%1” is not a number from 0 to 255</source>
        <translation>«%1» no es un número de 0 a 255</translation>
    </message>
    <message>
        <source>is larger than 1 MiB; a palette is not</source>
        <translation>ocupa más de 1 MiB; una paleta no</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>línea %1: %2</translation>
    </message>
    <message>
        <source>“GIMP Palette” is missing: this is no GIMP palette</source>
        <translation>falta «GIMP Palette»: no es una paleta de GIMP</translation>
    </message>
    <message>
        <source>there are more than %1 colours</source>
        <translation>hay más de %1 colores</translation>
    </message>
    <message>
        <source>has no settings; it is not a brush</source>
        <translation>no tiene ajustes; no es un pincel</translation>
    </message>
    <message>
        <source>is write-protected; save under another name or change its permissions</source>
        <translation>está protegido contra escritura; guarde con otro nombre o cambie sus permisos</translation>
    </message>
    <message>
        <source>belongs to %1, and would not any more; save under another name</source>
        <translation>pertenece a %1 y dejaría de hacerlo; guarde con otro nombre</translation>
    </message>
    <message>
        <source>could not be brought to the disk</source>
        <translation>no se ha podido llevar al disco</translation>
    </message>
    <message>
        <source>the backup could not be made; check the folder</source>
        <translation>no se ha podido crear la copia de seguridad; compruebe la carpeta</translation>
    </message>
    <message>
        <source>the first element is not curve_set</source>
        <translation>el primer elemento no es curve_set</translation>
    </message>
    <message>
        <source>%1 of %2 is &quot;%3&quot;, not a number up to 1e6</source>
        <translation>%1 de %2 es «%3», que no es un número hasta 1e6</translation>
    </message>
    <message>
        <source>a curve has %1 control points; 3n + 1 make cubics</source>
        <translation>una curva tiene %1 puntos de control; las cúbicas necesitan 3n + 1</translation>
    </message>
    <message>
        <source>a curve has no colours on one of its sides</source>
        <translation>una curva no tiene colores en uno de sus lados</translation>
    </message>
    <message>
        <source>has more than 64 MB of XML; that is more than is read</source>
        <translation>ocupa más de 64 MB de XML; es más de lo que se lee</translation>
    </message>
    <message>
        <source>holds no curves; there is nothing to paint</source>
        <translation>no contiene curvas; no hay nada que pintar</translation>
    </message>
    <message>
        <source>Diffusion curves (XML)</source>
        <translation>Curvas de difusión (XML)</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>está dañado</translation>
    </message>
    <message>
        <source>it belongs to another painting</source>
        <translation>pertenece a otra obra</translation>
    </message>
    <message>
        <source>it has too many steps</source>
        <translation>tiene demasiados pasos</translation>
    </message>
    <message>
        <source>step %1 is damaged</source>
        <translation>el paso %1 está dañado</translation>
    </message>
    <message>
        <source>step %1 does not fit the painting</source>
        <translation>el paso %1 no corresponde a la obra</translation>
    </message>
    <message>
        <source>the undo history was left out: %1</source>
        <translation>se ha omitido el historial de deshacer: %1</translation>
    </message>
    <message>
        <source>chunk %1 at byte %2: %3</source>
        <translation>bloque %1 en el byte %2: %3</translation>
    </message>
    <message>
        <source>is cut off after %1 bytes</source>
        <translation>está cortado tras %1 bytes</translation>
    </message>
    <message>
        <source>byte %1: %2</source>
        <translation>byte %1: %2</translation>
    </message>
    <message>
        <source>is damaged, and nothing in it is whole (%1); take a backup copy</source>
        <translation>está dañado, y nada en él está intacto (%1); use una copia de seguridad</translation>
    </message>
    <message>
        <source>the canvas, paper, groups, swatches and underlay are missing; the canvas is a usual one</source>
        <translation>faltan el lienzo, el papel, los grupos, las muestras y el calco; se usa un lienzo predeterminado</translation>
    </message>
    <message>
        <source>the image of the paper is missing; there is no paper now</source>
        <translation>falta la imagen del papel; ahora no hay papel</translation>
    </message>
    <message>
        <source>the underlay is missing</source>
        <translation>falta el calco</translation>
    </message>
    <message>
        <source>%1 strokes with %2 segments are here; how many there were is not known</source>
        <translation>hay %1 trazos con %2 segmentos; no se sabe cuántos eran</translation>
    </message>
    <message>
        <source>%1 of %2 strokes are missing, with %3 of %4 segments</source>
        <translation>faltan %1 de %2 trazos, con %3 de %4 segmentos</translation>
    </message>
    <message>
        <source>all %1 strokes are here</source>
        <translation>están todos los %1 trazos</translation>
    </message>
    <message>
        <source>%1 strokes are in no group any more</source>
        <translation>%1 trazos ya no están en ningún grupo</translation>
    </message>
    <message>
        <source>the end of the file is missing</source>
        <translation>falta el final del archivo</translation>
    </message>
    <message>
        <source>the journal cannot be written (%1)</source>
        <translation>no se puede escribir el diario (%1)</translation>
    </message>
    <message>
        <source>is not a journal of Suffuse</source>
        <translation>no es un diario de Suffuse</translation>
    </message>
    <message>
        <source>ends before its first painting was written</source>
        <translation>termina antes de que se escribiera su primera obra</translation>
    </message>
    <message>
        <source>was written by a newer program (%1); update Suffuse</source>
        <translation>lo escribió un programa más nuevo (%1); actualice Suffuse</translation>
    </message>
    <message>
        <source>Suffuse reads .suffuse, its text form (.json), ink as CSV, Universal Ink, InkML, Excalidraw, MyPaint events, Xournal++, Rnote, SVG and diffusion curves (XML)</source>
        <translation>Suffuse lee .suffuse, su forma de texto (.json), tinta como CSV, Universal Ink, InkML, Excalidraw, eventos de MyPaint, Xournal++, Rnote, SVG y curvas de difusión (XML)</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>Dibujo SVG</translation>
    </message>
    <message>
        <source>the drawing is %1 × %2 units large; at most 1e6 are possible, scale it down</source>
        <translation>el dibujo mide %1 × %2 unidades; se admiten 1e6 como máximo, redúzcalo</translation>
    </message>
    <message>
        <source>holds no paths that can be painted; in the program that drew it, turn text and images into paths first</source>
        <translation>no contiene trayectos que se puedan pintar; en el programa que lo dibujó, convierta antes el texto y las imágenes en trayectos</translation>
    </message>
    <message>
        <source>the preview</source>
        <translation>la vista previa</translation>
    </message>
    <message>
        <source>how it was last looked at</source>
        <translation>cómo se vio por última vez</translation>
    </message>
    <message>
        <source>the undo history</source>
        <translation>el historial de deshacer</translation>
    </message>
    <message>
        <source>the end of the file is damaged</source>
        <translation>el final del archivo está dañado</translation>
    </message>
    <message>
        <source>the file is damaged or cut off at byte %1</source>
        <translation>el archivo está dañado o cortado en el byte %1</translation>
    </message>
    <message>
        <source>Damaged and left out: %1. All %2 strokes are here.</source>
        <translation>Dañado y omitido: %1. Están todos los %2 trazos.</translation>
    </message>
    <message>
        <source>damaged and left out: %1</source>
        <translation>dañado y omitido: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n element(s) not drawn freehand</source>
        <translation>
            <numerusform>%n elemento no dibujado a mano alzada</numerusform>
            <numerusform>%n elementos no dibujados a mano alzada</numerusform>
        </translation>
    </message>
    <message>
        <source>column “%1”</source>
        <translation>columna «%1»</translation>
    </message>
    <message numerus="yes">
        <source>%n brush shape(s)</source>
        <translation>
            <numerusform>%n forma de pincel</numerusform>
            <numerusform>%n formas de pincel</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turned or stretched brush tip(s)</source>
        <translation>
            <numerusform>%n punta de pincel girada o estirada</numerusform>
            <numerusform>%n puntas de pincel giradas o estiradas</numerusform>
        </translation>
    </message>
    <message>
        <source>the pen&apos;s azimuths</source>
        <translation>los acimutes del lápiz</translation>
    </message>
    <message numerus="yes">
        <source>%n view(s) of recognised text</source>
        <translation>
            <numerusform>%n vista de texto reconocido</numerusform>
            <numerusform>%n vistas de texto reconocido</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 were left out.</source>
        <extracomment>%1: a list such as &quot;3 fills, 2 gradients&quot;; the number is that of all things in it.</extracomment>
        <translation>
            <numerusform>Se ha omitido: %1.</numerusform>
            <numerusform>Se han omitido: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <comment>list</comment>
        <translation>, </translation>
    </message>
    <message numerus="yes">
        <source>%n gradient(s)</source>
        <translation>
            <numerusform>%n degradado</numerusform>
            <numerusform>%n degradados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pattern(s)</source>
        <translation>
            <numerusform>%n patrón</numerusform>
            <numerusform>%n patrones</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n clip path(s)</source>
        <translation>
            <numerusform>%n trayecto de recorte</numerusform>
            <numerusform>%n trayectos de recorte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mask(s)</source>
        <translation>
            <numerusform>%n máscara</numerusform>
            <numerusform>%n máscaras</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n filter(s)</source>
        <translation>
            <numerusform>%n filtro</numerusform>
            <numerusform>%n filtros</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n blend mode(s)</source>
        <translation>
            <numerusform>%n modo de fusión</numerusform>
            <numerusform>%n modos de fusión</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marker(s)</source>
        <translation>
            <numerusform>%n marcador</numerusform>
            <numerusform>%n marcadores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n intricate outline(s)</source>
        <translation>
            <numerusform>%n contorno intrincado</numerusform>
            <numerusform>%n contornos intrincados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s)</source>
        <translation>
            <numerusform>%n texto</numerusform>
            <numerusform>%n textos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n image(s)</source>
        <translation>
            <numerusform>%n imagen</numerusform>
            <numerusform>%n imágenes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n style rule(s)</source>
        <translation>
            <numerusform>%n regla de estilo</numerusform>
            <numerusform>%n reglas de estilo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n &lt;use&gt; of itself</source>
        <translation>
            <numerusform>%n &lt;use&gt; de sí mismo</numerusform>
            <numerusform>%n &lt;use&gt; de sí mismos</numerusform>
        </translation>
    </message>
    <message>
        <source>There is more in the drawing than is read; the rest was left out.</source>
        <translation>El dibujo contiene más de lo que se lee; el resto se ha omitido.</translation>
    </message>
    <message>
        <source>ends after %1 bytes</source>
        <translation>termina tras %1 bytes</translation>
    </message>
    <message>
        <source>its line endings were changed on the way, transfer it as a binary file</source>
        <translation>sus finales de línea cambiaron por el camino; transfiéralo como archivo binario</translation>
    </message>
    <message>
        <source>its first bytes are damaged</source>
        <translation>sus primeros bytes están dañados</translation>
    </message>
    <message>
        <source>the first bytes of the file</source>
        <translation>los primeros bytes del archivo</translation>
    </message>
    <message>
        <source>version: %1 does not know all that strokes have here; write %2</source>
        <translation>version: %1 no conoce todo lo que tienen aquí los trazos; escriba %2</translation>
    </message>
    <message>
        <source>%1 is newer than this program, which reads up to version %2; update Suffuse</source>
        <translation>%1 es más nueva que este programa, que lee hasta la versión %2; actualice Suffuse</translation>
    </message>
    <message>
        <source>This file is empty: nothing was saved in it.</source>
        <translation>Este archivo está vacío: no se guardó nada en él.</translation>
    </message>
    <message>
        <source>This is UTF-16 text. Save it as UTF-8.</source>
        <translation>Es texto UTF-16. Guárdelo como UTF-8.</translation>
    </message>
    <message>
        <source>This is a picture, not a painting. %1.</source>
        <translation>Es una imagen, no una obra. %1.</translation>
    </message>
    <message>
        <source>This is neither a painting nor a recording that can be read. %1. Other programs can export SVG.</source>
        <translation>No es una obra ni una grabación que se pueda leer. %1. Otros programas pueden exportar SVG.</translation>
    </message>
    <message numerus="yes">
        <source>%n fill(s)</source>
        <translation>
            <numerusform>%n relleno</numerusform>
            <numerusform>%n rellenos</numerusform>
        </translation>
    </message>
    <message>
        <source>Other fonts stand in for those that are not installed: %1.</source>
        <translation>Otras fuentes sustituyen a las que no están instaladas: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) came in as letters: they cannot be typed in again.</source>
        <translation>
            <numerusform>%n texto ha llegado como letras: no se puede volver a escribir en él.</numerusform>
            <numerusform>%n textos han llegado como letras: no se puede volver a escribir en ellos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the images of %n image layer(s) are missing</source>
        <translation>
            <numerusform>falta la imagen de %n capa de imagen</numerusform>
            <numerusform>faltan las imágenes de %n capas de imagen</numerusform>
        </translation>
    </message>
    <message>
        <source>This OpenRaster file is damaged: it has no list of its parts.</source>
        <translation>Este archivo OpenRaster está dañado: no tiene la lista de sus partes.</translation>
    </message>
    <message>
        <source>OpenRaster picture</source>
        <translation>Imagen OpenRaster</translation>
    </message>
    <message>
        <source>Another program changed this picture. What was opened is the painting as Suffuse exported it.</source>
        <translation>Otro programa ha cambiado esta imagen. Se ha abierto la obra tal como la exportó Suffuse.</translation>
    </message>
    <message>
        <source>The linked picture %1 is missing, and is not seen: put its file back, or link another one in the Inspector.</source>
        <translation>La imagen vinculada %1 falta, y no se ve: vuelva a poner su archivo o vincule otra en el Inspector.</translation>
    </message>
    <message>
        <source>The linked picture %1 has more than 64 MB, and is not seen.</source>
        <translation>La imagen vinculada %1 ocupa más de 64 MB, y no se ve.</translation>
    </message>
    <message>
        <source>The linked picture %1 has changed since it was linked, and is not seen: link it anew in the Inspector.</source>
        <translation>La imagen vinculada %1 ha cambiado desde que se vinculó, y no se ve: vuelva a vincularla en el Inspector.</translation>
    </message>
    <message numerus="yes">
        <source>So it is with %n other picture(s).</source>
        <translation>
            <numerusform>Lo mismo ocurre con %n imagen más.</numerusform>
            <numerusform>Lo mismo ocurre con %n imágenes más.</numerusform>
        </translation>
    </message>
    <message>
        <source>This file is compressed with gzip, and what is in it is neither an SVG nor a notebook of Xournal++ or Rnote. Unpack it first. %1.</source>
        <translation>Este archivo está comprimido con gzip, y lo que contiene no es ni un SVG ni un cuaderno de Xournal++ o de Rnote. Descomprímalo antes. %1.</translation>
    </message>
    <message>
        <source>Another program has changed the drawing since Suffuse wrote it. It is opened as it is drawn now, not as the painting that is in it.</source>
        <translation>Otro programa ha cambiado el dibujo desde que lo escribió Suffuse. Se abre como está dibujado ahora, no como la obra que contiene.</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>no hay memoria suficiente</translation>
    </message>
    <message>
        <source>is too large once it is unpacked</source>
        <translation>es demasiado grande una vez descomprimido</translation>
    </message>
    <message>
        <source>is damaged: it cannot be unpacked</source>
        <translation>está dañado: no se puede descomprimir</translation>
    </message>
    <message>
        <source>the colour profile</source>
        <translation>el perfil de color</translation>
    </message>
    <message>
        <source>the size on paper</source>
        <translation>el tamaño en papel</translation>
    </message>
    <message>
        <source>the first element is not xournal</source>
        <translation>el primer elemento no es xournal</translation>
    </message>
    <message>
        <source>holds no pages</source>
        <translation>no contiene páginas</translation>
    </message>
    <message>
        <source>%1 is no number within ±1e7</source>
        <translation>%1 no es un número dentro de ±1e7</translation>
    </message>
    <message>
        <source>has more than %1 layers</source>
        <translation>tiene más de %1 capas</translation>
    </message>
    <message>
        <source>the page has no size</source>
        <translation>la página no tiene tamaño</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Página %1</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Capa %1</translation>
    </message>
    <message>
        <source>the stroke has an x without y</source>
        <translation>el trazo tiene una x sin y</translation>
    </message>
    <message>
        <source>has more than %1 points</source>
        <translation>tiene más de %1 puntos</translation>
    </message>
    <message>
        <source>the stroke has no width</source>
        <translation>el trazo no tiene anchura</translation>
    </message>
    <message>
        <source>%1: %2 is no number within ±1e7</source>
        <translation>%1: %2 no es un número dentro de ±1e7</translation>
    </message>
    <message>
        <source>Xournal++ notebook</source>
        <translation>Cuaderno de Xournal++</translation>
    </message>
    <message>
        <source>InkML recording</source>
        <translation>Grabación InkML</translation>
    </message>
    <message>
        <source>Rnote notebook</source>
        <translation>Cuaderno de Rnote</translation>
    </message>
    <message>
        <source>the first element is not ink</source>
        <translation>el primer elemento no es ink</translation>
    </message>
    <message>
        <source>its groups are too deep</source>
        <translation>sus grupos están anidados a demasiada profundidad</translation>
    </message>
    <message>
        <source>a point has more than %1 values</source>
        <translation>un punto tiene más de %1 valores</translation>
    </message>
    <message>
        <source>the trace is not a list of points with %1 numbers each, or there are more than %2 points</source>
        <translation>la traza no es una lista de puntos con %1 números cada uno, o hay más de %2 puntos</translation>
    </message>
    <message>
        <source>the trace has no X and Y</source>
        <translation>la traza no tiene X e Y</translation>
    </message>
    <message>
        <source>a point is farther than 1e7 units away</source>
        <translation>un punto está a más de 1e7 unidades</translation>
    </message>
    <message>
        <source>holds no notebook that can be read; save it with Rnote 0.5 or later</source>
        <translation>no contiene ningún cuaderno que se pueda leer; guárdelo con Rnote 0.5 o posterior</translation>
    </message>
    <message>
        <source>a point is not two numbers within ±1e7</source>
        <translation>un punto no consta de dos números dentro de ±1e7</translation>
    </message>
    <message>
        <source>has more than %1 numbers</source>
        <translation>tiene más de %1 números</translation>
    </message>
    <message>
        <source>is Universal Ink %1.%2; 3.0 and 3.1 can be read</source>
        <translation>es Universal Ink %1.%2; se pueden leer 3.0 y 3.1</translation>
    </message>
    <message>
        <source>is damaged: a part of it is not whole</source>
        <translation>está dañado: una de sus partes no está intacta</translation>
    </message>
    <message>
        <source>its part %1 is packed in a way that cannot be read</source>
        <translation>su parte %1 está comprimida de un modo que no se puede leer</translation>
    </message>
    <message numerus="yes">
        <source>%n line style(s)</source>
        <translation>
            <numerusform>%n estilo de línea</numerusform>
            <numerusform>%n estilos de línea</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n shape(s)</source>
        <translation>
            <numerusform>%n forma</numerusform>
            <numerusform>%n formas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n way(s) of the pen over the paper</source>
        <translation>
            <numerusform>%n trayecto del lápiz por encima del papel</numerusform>
            <numerusform>%n trayectos del lápiz por encima del papel</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mapping(s) of channels</source>
        <translation>
            <numerusform>%n conversión de canales</numerusform>
            <numerusform>%n conversiones de canales</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) of sound</source>
        <translation>
            <numerusform>%n grabación de sonido</numerusform>
            <numerusform>%n grabaciones de sonido</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n ruled or printed paper(s)</source>
        <translation>
            <numerusform>%n papel pautado o impreso</numerusform>
            <numerusform>%n papeles pautados o impresos</numerusform>
        </translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, %2; install Suffuse again. It is for PDF files alone</source>
        <translation>una parte de Suffuse, %1, %2; vuelva a instalar Suffuse. Solo es para archivos PDF</translation>
    </message>
    <message>
        <source>cannot be loaded (%1)</source>
        <translation>no se puede cargar (%1)</translation>
    </message>
    <message>
        <source>is of another version of Suffuse</source>
        <translation>es de otra versión de Suffuse</translation>
    </message>
    <message>
        <source>would have more than 2 GB</source>
        <translation>ocuparía más de 2 GB</translation>
    </message>
    <message>
        <source>could not be written: %1</source>
        <translation>no se ha podido escribir: %1</translation>
    </message>
    <message numerus="yes">
        <source>Of %n painting(s) in this PDF file the first one was opened.</source>
        <translation>
            <numerusform>De %n obra que hay en este archivo PDF se ha abierto la primera.</numerusform>
            <numerusform>De %n obras que hay en este archivo PDF se ha abierto la primera.</numerusform>
        </translation>
    </message>
    <message>
        <source>PDF file</source>
        <translation>Archivo PDF</translation>
    </message>
    <message>
        <source>This is a PDF file, and %1.</source>
        <translation>Es un archivo PDF, y %1.</translation>
    </message>
    <message>
        <source>This PDF file is damaged: %1.</source>
        <translation>Este archivo PDF está dañado: %1.</translation>
    </message>
    <message>
        <source>This PDF file holds no painting. Suffuse opens those that it wrote; open a picture of its pages as a layer instead.</source>
        <translation>Este archivo PDF no contiene ninguna obra. Suffuse abre los que él mismo escribió; abra en su lugar una imagen de sus páginas como capa.</translation>
    </message>
    <message>
        <source>Another program changed this PDF file. What was opened is the painting as Suffuse exported it.</source>
        <translation>Otro programa ha cambiado este archivo PDF. Se ha abierto la obra tal como la exportó Suffuse.</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupCells</name>
    <message>
        <source>Clipped to what lies below it in its group</source>
        <translation>Recortado a lo que hay debajo en su grupo</translation>
    </message>
    <message>
        <source>A mask for the others in its group</source>
        <translation>Una máscara para los demás de su grupo</translation>
    </message>
    <message>
        <source>A wash: its strokes are one</source>
        <translation>Una aguada: sus trazos son uno solo</translation>
    </message>
    <message>
        <source>Shown alone</source>
        <translation>Mostrado en solitario</translation>
    </message>
    <message>
        <source>A draft: left out of what is exported</source>
        <translation>Un borrador: se omite en lo que se exporta</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupHand</name>
    <message>
        <source>The group is locked: nothing changes.</source>
        <translation>El grupo está bloqueado: no cambia nada.</translation>
    </message>
    <message>
        <source>Change group opacity</source>
        <translation>Cambiar opacidad del grupo</translation>
    </message>
    <message>
        <source>Change group mode</source>
        <translation>Cambiar modo del grupo</translation>
    </message>
    <message>
        <source>Opacity of the group</source>
        <translation>Opacidad del grupo</translation>
    </message>
</context>
<context>
    <name>suffuse::HintLabel</name>
    <message>
        <source>Hint</source>
        <translation>Sugerencia</translation>
    </message>
</context>
<context>
    <name>suffuse::HistoryPanel</name>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Every change since the painting was opened. Click one to go back or forward to it.</source>
        <translation>Todos los cambios desde que se abrió la obra. Haga clic en uno para retroceder o avanzar hasta él.</translation>
    </message>
    <message>
        <source>This stroke</source>
        <translation>Este trazo</translation>
    </message>
</context>
<context>
    <name>suffuse::Importing</name>
    <message>
        <source>Picture to Strokes</source>
        <translation>Imagen a trazos</translation>
    </message>
    <message>
        <source>Import underlay</source>
        <translation>Importar calco</translation>
    </message>
    <message>
        <source>Import Strokes</source>
        <translation>Importar trazos</translation>
    </message>
    <message>
        <source>“%1” is damaged. What is whole of it was imported.</source>
        <translation>«%1» está dañado. Se ha importado lo que está intacto.</translation>
    </message>
    <message>
        <source>Import picture as layer</source>
        <translation>Importar imagen como capa</translation>
    </message>
    <message>
        <source>Add as &amp;Layer</source>
        <translation>Añadir como &amp;capa</translation>
    </message>
    <message>
        <source>Use as &amp;Underlay</source>
        <translation>Usar como ca&amp;lco</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>suffuse::InspectorPanel</name>
    <message>
        <source>Nothing is selected. Click a stroke to see and change its values.</source>
        <translation>No hay nada seleccionado. Haga clic en un trazo para ver y cambiar sus valores.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln trazo</numerusform>
            <numerusform>%Ln trazos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln segmento</numerusform>
            <numerusform>%Ln segmentos</numerusform>
        </translation>
    </message>
    <message>
        <source>Along the Stroke…</source>
        <translation>A lo largo del trazo…</translation>
    </message>
    <message>
        <source>Sets a value along the stroke: constant, as a ramp, or drawn as a curve.</source>
        <translation>Fija un valor a lo largo del trazo: constante, en rampa o dibujado como curva.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %Ln segment(s)</source>
        <translation>
            <numerusform>%1 de %Ln segmento</numerusform>
            <numerusform>%1 de %Ln segmentos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln erasing segment(s)</source>
        <translation>
            <numerusform>%Ln segmento que borra</numerusform>
            <numerusform>%Ln segmentos que borran</numerusform>
        </translation>
    </message>
    <message>
        <source>They make paint paler.</source>
        <translation>Vuelven la pintura más pálida.</translation>
    </message>
    <message>
        <source>They take paint away: the more density, the more.</source>
        <translation>Quitan pintura: cuanta más densidad, más.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln of them take(s) paint away.</source>
        <translation>
            <numerusform>%Ln de ellos quita pintura.</numerusform>
            <numerusform>%Ln de ellos quitan pintura.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::KeyboardFocus</name>
    <message>
        <source>The %1 dock has the keyboard; Esc gives it back to the canvas.</source>
        <translation>El panel %1 tiene el teclado; Esc lo devuelve al lienzo.</translation>
    </message>
    <message>
        <source>The canvas has the keyboard.</source>
        <translation>El lienzo tiene el teclado.</translation>
    </message>
    <message>
        <source>The tool bar “%1” has the keyboard; Esc gives it back to the canvas.</source>
        <translation>La barra de herramientas «%1» tiene el teclado; Esc lo devuelve al lienzo.</translation>
    </message>
</context>
<context>
    <name>suffuse::KnifeTool</name>
    <message>
        <source>Drag a line to insert nodes where it crosses strokes. Shift: cut the strokes apart. Ctrl: steps of 15°.</source>
        <translation>Arrastrar una línea para insertar nodos donde cruza trazos. Mayús: cortar los trazos. Ctrl: pasos de 15°.</translation>
    </message>
    <message>
        <source>Cut strokes</source>
        <translation>Cortar trazos</translation>
    </message>
    <message>
        <source>Insert nodes</source>
        <translation>Insertar nodos</translation>
    </message>
    <message>
        <source>%1 cut into %2</source>
        <extracomment>what the knife did; %1: &quot;2 strokes&quot;, %2: &quot;5 parts&quot;</extracomment>
        <translation>Cortado: %1 en %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln trazo</numerusform>
            <numerusform>%Ln trazos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln part(s)</source>
        <translation>
            <numerusform>%Ln parte</numerusform>
            <numerusform>%Ln partes</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 inserted in %2</source>
        <extracomment>what the knife did; %1: &quot;3 nodes&quot;, %2: &quot;2 strokes&quot;</extracomment>
        <translation>Insertado: %1 en %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln node(s)</source>
        <translation>
            <numerusform>%Ln nodo</numerusform>
            <numerusform>%Ln nodos</numerusform>
        </translation>
    </message>
    <message>
        <source>There are nodes already where the line crosses strokes.</source>
        <translation>Ya hay nodos donde la línea cruza trazos.</translation>
    </message>
    <message>
        <source>The line crosses no stroke.</source>
        <translation>La línea no cruza ningún trazo.</translation>
    </message>
    <message>
        <source>The line crosses no selected stroke.</source>
        <translation>La línea no cruza ningún trazo seleccionado.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <comment>in</comment>
        <translation>
            <numerusform>%Ln trazo</numerusform>
            <numerusform>%Ln trazos</numerusform>
        </translation>
    </message>
    <message>
        <source>A fill is cut only where the line goes all the way through it.</source>
        <translation>Un relleno solo se corta donde la línea lo atraviesa por completo.</translation>
    </message>
    <message>
        <source>Inserts nodes where a line crosses strokes; with Shift it cuts them apart there.</source>
        <translation>Inserta nodos donde una línea cruza trazos; con Mayús, los corta ahí.</translation>
    </message>
</context>
<context>
    <name>suffuse::MainWindow</name>
    <message>
        <source>Tool Options</source>
        <translation>Opciones de herramienta</translation>
    </message>
</context>
<context>
    <name>suffuse::MixingSection</name>
    <message>
        <source>Mixing</source>
        <translation>Mezclas</translation>
    </message>
    <message>
        <source>Paint colours over each other here. Shift+drag rubs, Ctrl+click picks.</source>
        <translation>Pinte aquí colores unos sobre otros. Mayús+arrastrar: frotar; Ctrl+clic: tomar.</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Pintar</translation>
    </message>
    <message>
        <source>Paints with the current colour.</source>
        <translation>Pinta con el color actual.</translation>
    </message>
    <message>
        <source>Rub</source>
        <translation>Frotar</translation>
    </message>
    <message>
        <source>Carries the paint under the pointer along.</source>
        <translation>Arrastra la pintura bajo el puntero.</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Tomar</translation>
    </message>
    <message>
        <source>Makes the colour under the pointer the current one.</source>
        <translation>Convierte el color bajo el puntero en el actual.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vaciar</translation>
    </message>
    <message>
        <source>Takes a clean sheet.</source>
        <translation>Pone una hoja limpia.</translation>
    </message>
</context>
<context>
    <name>suffuse::MomentRow</name>
    <message>
        <source>Moment</source>
        <translation>Momento</translation>
    </message>
    <message>
        <source>All dried</source>
        <translation>Todo seco</translation>
    </message>
    <message>
        <source>As it looks now</source>
        <translation>Como se ve ahora</translation>
    </message>
    <message>
        <source>At the time</source>
        <translation>En el instante</translation>
    </message>
    <message>
        <source>The finished painting, the moment that the canvas shows, or any other.</source>
        <translation>La obra terminada, el momento que muestra el lienzo, o cualquier otro.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Minutes and seconds, as the timeline shows them: 1:02.345</source>
        <translation>Minutos y segundos, como los muestra la línea de tiempo: 1:02.345</translation>
    </message>
</context>
<context>
    <name>suffuse::NewDialog</name>
    <message>
        <source>Custom</source>
        <translation>Personalizado</translation>
    </message>
    <message>
        <source>Swap width and height</source>
        <translation>Intercambiar anchura y altura</translation>
    </message>
    <message>
        <source>C&amp;reate</source>
        <translation>C&amp;rear</translation>
    </message>
    <message>
        <source>New Painting</source>
        <translation>Nueva obra</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Hoja</translation>
    </message>
    <message>
        <source>Usual sizes, and sheets with a ground of their own</source>
        <translation>Tamaños habituales, y hojas con un fondo propio</translation>
    </message>
    <message>
        <source>Sides in</source>
        <translation>Lados en</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Píxeles</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Milímetros</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pulgadas</translation>
    </message>
    <message>
        <source>What width and height are given in. A pixel is a unit of the canvas.</source>
        <translation>En qué se dan la anchura y la altura. Un píxel es una unidad del lienzo.</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolución</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> ppp</translation>
    </message>
    <message>
        <source>Pixels for each inch of paper. The sheet stays as large on paper.</source>
        <translation>Píxeles por cada pulgada de papel. La hoja conserva su tamaño en papel.</translation>
    </message>
</context>
<context>
    <name>suffuse::NextNodeFields</name>
    <message>
        <source>X</source>
        <extracomment>of the next node of an outline</extracomment>
        <translation>X</translation>
    </message>
    <message>
        <source>Where the next node is set, from the left. Return sets it, and so does a click</source>
        <translation>Dónde se pone el siguiente nodo, desde la izquierda. Intro lo pone, y también un clic</translation>
    </message>
    <message>
        <source>Y</source>
        <extracomment>of the next node of an outline</extracomment>
        <translation>Y</translation>
    </message>
    <message>
        <source>Where the next node is set, from the top. Return sets it, and so does a click</source>
        <translation>Dónde se pone el siguiente nodo, desde arriba. Intro lo pone, y también un clic</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>From the last node to the next one. Return sets it, and so does a click</source>
        <translation>Del último nodo al siguiente. Intro lo pone, y también un clic</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Direction from the last node to the next one, clockwise from the right. Return sets it, and so does a click</source>
        <translation>Dirección del último nodo al siguiente, en sentido horario desde la derecha. Intro lo pone, y también un clic</translation>
    </message>
    <message>
        <source>Close</source>
        <extracomment>closes an outline</extracomment>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Closes the outline at its first node (Shift+Return)</source>
        <translation>Cierra el contorno en su primer nodo (Mayús+Intro)</translation>
    </message>
</context>
<context>
    <name>suffuse::NodeCommands</name>
    <message>
        <source>The joined stroke has the upper one&apos;s fill. Undo brings the other back.</source>
        <translation>El trazo unido tiene el relleno del superior. Deshacer recupera el otro.</translation>
    </message>
    <message>
        <source>The joined stroke has no fill, as the upper one had none. Undo brings the lower one&apos;s back.</source>
        <translation>El trazo unido no tiene relleno, ya que el superior no lo tenía. Deshacer recupera el del inferior.</translation>
    </message>
    <message>
        <source>Smooth nodes</source>
        <translation>Suavizar nodos</translation>
    </message>
    <message>
        <source>Symmetric nodes</source>
        <translation>Nodos simétricos</translation>
    </message>
    <message>
        <source>Corner nodes</source>
        <translation>Nodos de esquina</translation>
    </message>
    <message>
        <source>Insert nodes</source>
        <translation>Insertar nodos</translation>
    </message>
    <message>
        <source>Break stroke</source>
        <translation>Romper trazo</translation>
    </message>
    <message>
        <source>Join nodes</source>
        <translation>Unir nodos</translation>
    </message>
    <message>
        <source>Reverse strokes</source>
        <translation>Invertir trazos</translation>
    </message>
    <message>
        <source>Delete nodes</source>
        <translation>Eliminar nodos</translation>
    </message>
    <message>
        <source>Delete segments</source>
        <translation>Eliminar segmentos</translation>
    </message>
    <message>
        <source>Bridge segments</source>
        <translation>Puentear segmentos</translation>
    </message>
    <message>
        <source>A node alone has no paint: select the nodes at both ends of a segment, or take the whole stroke with the Select tool.</source>
        <translation>Un nodo solo no tiene pintura: seleccione los nodos de ambos extremos de un segmento, o el trazo entero con la herramienta Seleccionar.</translation>
    </message>
    <message>
        <source>The closed outline begins and ends at this node, so it has nothing more to break. Delete Segments (Ctrl+Del) opens it.</source>
        <translation>El contorno cerrado empieza y termina en este nodo, así que no hay nada más que romper. Eliminar segmentos (Ctrl+Supr) lo abre.</translation>
    </message>
    <message>
        <source>Join needs two ends of strokes: select one, and Shift+click the other or drag around both.</source>
        <translation>Unir necesita dos extremos de trazos: seleccione uno y haga Mayús+clic en el otro, o arrastre alrededor de ambos.</translation>
    </message>
    <message>
        <source>These two ends cannot be joined.</source>
        <translation>Estos dos extremos no se pueden unir.</translation>
    </message>
</context>
<context>
    <name>suffuse::NodeTool</name>
    <message>
        <source>Drag the handle to bend the curve. Shift: make the node a corner. Ctrl: steps of 15°.</source>
        <translation>Arrastrar el tirador para doblar la curva. Mayús: hacer esquina el nodo. Ctrl: pasos de 15°.</translation>
    </message>
    <message>
        <source>Insert node</source>
        <translation>Insertar nodo</translation>
    </message>
    <message>
        <source>Move nodes</source>
        <translation>Mover nodos</translation>
    </message>
    <message>
        <source>Move node</source>
        <translation>Mover nodo</translation>
    </message>
    <message>
        <source>Click a segment to select it, Shift+click for a run or another stroke&apos;s, Ctrl+click to add or remove one. Drag around nodes.</source>
        <translation>Clic: seleccionar un segmento; Mayús+clic: una serie o los de otro trazo; Ctrl+clic: añadir o quitar uno. Arrastrar alrededor de nodos.</translation>
    </message>
    <message>
        <source>Drag to move nodes, softly within the reach (wheel, Alt+drag). Ctrl: along an axis, Ctrl+Alt: the handle. Shift+click for more.</source>
        <translation>Arrastrar: mover nodos, suavemente dentro del alcance (rueda, Alt+arrastrar). Ctrl: por un eje; Ctrl+Alt: por el tirador. Mayús+clic: más.</translation>
    </message>
    <message>
        <source>Drag to bend the curve within the reach (wheel, Alt+drag). Double click to insert a node. Click to select the segment.</source>
        <translation>Arrastrar: doblar la curva dentro del alcance (rueda, Alt+arrastrar). Doble clic: insertar un nodo. Clic: seleccionar el segmento.</translation>
    </message>
    <message>
        <source>Move erasure</source>
        <translation>Mover borrado</translation>
    </message>
    <message>
        <source>Move the erasure: it takes away where it lies. Ctrl: along an axis. Esc gives it up.</source>
        <translation>Mover el borrado: quita pintura donde está. Ctrl: por un eje. Esc lo cancela.</translation>
    </message>
    <message>
        <source>Drag to move the erasure. Click to select it in all strokes, again for its part in this one, again for a segment. Delete removes it.</source>
        <translation>Arrastrar: mover el borrado. Clic: seleccionarlo en todos los trazos; otro: su parte en este; otro más: un segmento. Supr lo quita.</translation>
    </message>
    <message>
        <source>Move segments</source>
        <translation>Mover segmentos</translation>
    </message>
    <message>
        <source>An end of a gradient is not deleted alone. Remove, beside Gradient in the Inspector, takes the gradient away; Esc first, and Delete means the stroke.</source>
        <translation>Un extremo de un degradado no se elimina solo. Quitar, junto a Degradado en el Inspector, quita el degradado; tras pulsar Esc, Supr se refiere al trazo.</translation>
    </message>
    <message>
        <source>What was selected is deleted; its strokes are merely shown. Click what else is to go, or take whole strokes with the Select tool.</source>
        <translation>Lo seleccionado se ha eliminado; sus trazos solo se muestran. Haga clic en lo que también sobre, o tome trazos enteros con Seleccionar.</translation>
    </message>
</context>
<context>
    <name>suffuse::NumberField</name>
    <message>
        <source>“%1” is not a number. Sums such as 12*1.5 or +2 work too.</source>
        <translation>«%1» no es un número. También valen operaciones como 12*1.5 o +2.</translation>
    </message>
    <message>
        <source>%1 is out of range: %2 to %3 is possible.</source>
        <translation>%1 está fuera del intervalo: se admite de %2 a %3.</translation>
    </message>
    <message>
        <source>“%1” is not possible here: this number has no unit.</source>
        <translation>«%1» no es posible aquí: este número no tiene unidad.</translation>
    </message>
    <message>
        <source>“%1” is not possible here: the unit is %2.</source>
        <translation>«%1» no es posible aquí: la unidad es %2.</translation>
    </message>
    <message>
        <source> u</source>
        <translation> u</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> in</source>
        <translation> in</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> u²/s</source>
        <translation> u²/s</translation>
    </message>
    <message>
        <source>%1 is out of range: more than 0 and up to %2 is possible.</source>
        <translation>%1 está fuera del intervalo: se admite más de 0 y hasta %2.</translation>
    </message>
    <message>
        <source>%1 is the most that is possible.</source>
        <translation>%1 es el máximo posible.</translation>
    </message>
    <message>
        <source>%1 is the least that is possible.</source>
        <translation>%1 es el mínimo posible.</translation>
    </message>
</context>
<context>
    <name>suffuse::PanTool</name>
    <message>
        <source>Drag to move the canvas. The wheel zooms; R and drag turns.</source>
        <translation>Arrastrar para mover el lienzo. La rueda hace zoom; R y arrastrar lo gira.</translation>
    </message>
</context>
<context>
    <name>suffuse::PenPad</name>
    <message>
        <source>Try your pen here.</source>
        <translation>Pruebe aquí el lápiz.</translation>
    </message>
</context>
<context>
    <name>suffuse::PenPage</name>
    <message>
        <source>Pressure</source>
        <translation>Presión</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Suave</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Uniforme</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>Firme</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personalizada</translation>
    </message>
    <message>
        <source>How hard the pen must be pressed, for all brushes.</source>
        <translation>Con cuánta fuerza hay que apretar el lápiz, para todos los pinceles.</translation>
    </message>
    <message>
        <source>Takes a clean sheet.</source>
        <translation>Pone una hoja limpia.</translation>
    </message>
    <message>
        <source>pressure of the pen →</source>
        <translation>presión del lápiz →</translation>
    </message>
    <message>
        <source>↑ paints with</source>
        <translation>↑ pinta con</translation>
    </message>
    <message>
        <source>Pressure curve</source>
        <translation>Curva de presión</translation>
    </message>
    <message>
        <source>Drag the points; click for another; drag one out to take it away.</source>
        <translation>Arrastre los puntos; haga clic para añadir otro; arrastre uno fuera para quitarlo.</translation>
    </message>
    <message>
        <source>Paint here with the brush in use; the dot on the curve is the pen&apos;s pressure.</source>
        <translation>Pinte aquí con el pincel en uso; el punto en la curva es la presión del lápiz.</translation>
    </message>
    <message>
        <source>Only the pen and the mouse paint; fingers move the view</source>
        <translation>Solo pintan el lápiz y el ratón; los dedos mueven la vista</translation>
    </message>
    <message>
        <source>One finger moves the canvas, two zoom and turn it. Otherwise one finger paints.</source>
        <translation>Un dedo mueve el lienzo; dos hacen zoom y lo giran. Si no, un dedo pinta.</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>&amp;Vaciar</translation>
    </message>
</context>
<context>
    <name>suffuse::PresetRow</name>
    <message>
        <source>Preset</source>
        <translation>Preajuste</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Format, depth, quality, resolution, size, area and moment under a name</source>
        <translation>Formato, profundidad, calidad, resolución, tamaño, área y momento con un nombre</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Guardar…</translation>
    </message>
    <message>
        <source>Keep what is set here as a preset</source>
        <translation>Conservar como preajuste lo que está fijado aquí</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Quitar</translation>
    </message>
    <message>
        <source>Forget the chosen preset</source>
        <translation>Olvidar el preajuste elegido</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>There is a preset “%1”. Replace it?</source>
        <translation>Ya existe un preajuste «%1». ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>Save Preset</source>
        <translation>Guardar preajuste</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintDialog</name>
    <message>
        <source>Print</source>
        <translation>Imprimir</translation>
    </message>
    <message>
        <source>&amp;Print</source>
        <translation>&amp;Imprimir</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Prints the canvas's colour; without it the paint lies on the paper as it is.</source>
        <translation>Imprime el color del lienzo; sin él, la pintura queda sobre el papel tal como es.</translation>
    </message>
    <message>
        <source>Print to File (PDF)</source>
        <translation>Imprimir en archivo (PDF)</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Impresora</translation>
    </message>
    <message>
        <source>Where the page comes out</source>
        <translation>Por dónde sale la página</translation>
    </message>
    <message>
        <source>No printer is set up on this computer. A file can be printed elsewhere.</source>
        <translation>No hay ninguna impresora configurada en este equipo. Un archivo se puede imprimir en otro lugar.</translation>
    </message>
    <message>
        <source>The PDF file that is written: one page as large as the paper.</source>
        <translation>El archivo PDF que se escribe: una página tan grande como el papel.</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Copias</translation>
    </message>
    <message>
        <source>How often the page is printed</source>
        <translation>Cuántas veces se imprime la página</translation>
    </message>
    <message>
        <source>%1 – %2 × %3 mm</source>
        <translation>%1 – %2 × %3 mm</translation>
    </message>
    <message>
        <source>As large as the sheet</source>
        <translation>Tan grande como la hoja</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>Vertical</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Horizontal</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientación</translation>
    </message>
    <message>
        <source>How the paper lies</source>
        <translation>En qué sentido está el papel</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>The size of the paper</source>
        <translation>El tamaño del papel</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierdo</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Superior</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecho</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Inferior</translation>
    </message>
    <message>
        <source>Left margin</source>
        <translation>Margen izquierdo</translation>
    </message>
    <message>
        <source>Top margin</source>
        <translation>Margen superior</translation>
    </message>
    <message>
        <source>Right margin</source>
        <translation>Margen derecho</translation>
    </message>
    <message>
        <source>Bottom margin</source>
        <translation>Margen inferior</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>What stays empty at this edge of the paper</source>
        <translation>Lo que queda vacío en este borde del papel</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Márgenes</translation>
    </message>
    <message>
        <source>Fit to the page</source>
        <translation>Ajustar a la página</translation>
    </message>
    <message>
        <source>Actual size</source>
        <translation>Tamaño real</translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation>Escalado</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Of the actual size</source>
        <translation>Respecto al tamaño real</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>How large the picture lies on the paper</source>
        <translation>Qué tamaño tiene la imagen en el papel</translation>
    </message>
    <message>
        <source>%1 dpi</source>
        <translation>%1 ppp</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolución</translation>
    </message>
    <message>
        <source>How many dots an inch the picture is drawn with</source>
        <translation>Con cuántos puntos por pulgada se dibuja la imagen</translation>
    </message>
    <message>
        <source>Usual: %1 dpi</source>
        <translation>Habitual: %1 ppp</translation>
    </message>
    <message>
        <source>The printer's: %1 dpi</source>
        <translation>La de la impresora: %1 ppp</translation>
    </message>
    <message>
        <source>The margins leave no room on the paper.</source>
        <translation>Los márgenes no dejan espacio en el papel.</translation>
    </message>
    <message>
        <source>The picture is %1 × %2 mm on the paper.</source>
        <translation>La imagen mide %1 × %2 mm en el papel.</translation>
    </message>
    <message>
        <source>What does not fit is cut off.</source>
        <translation>Lo que no cabe se corta.</translation>
    </message>
    <message>
        <source>PDF files</source>
        <translation>Archivos PDF</translation>
    </message>
    <message>
        <source>“%1” is not there any more. Choose another printer.</source>
        <translation>«%1» ya no está. Elija otra impresora.</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintJob</name>
    <message>
        <source>The page does not fit into memory.</source>
        <translation>La página no cabe en la memoria.</translation>
    </message>
    <message>
        <source>There is no room for the page on the disk: %1</source>
        <translation>No hay espacio para la página en el disco: %1</translation>
    </message>
    <message>
        <source>The printer does not take the page. See whether it is there, or print to a file.</source>
        <translation>La impresora no acepta la página. Compruebe que esté disponible, o imprima en un archivo.</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintRows</name>
    <message>
        <source>Print size</source>
        <translation>Tamaño de impresión</translation>
    </message>
    <message>
        <source>Width on paper</source>
        <translation>Anchura en papel</translation>
    </message>
    <message>
        <source>Width on paper; the height and the pixels follow.</source>
        <translation>Anchura en papel; la altura y los píxeles la siguen.</translation>
    </message>
    <message>
        <source>Height on paper</source>
        <translation>Altura en papel</translation>
    </message>
    <message>
        <source>Height on paper; the width and the pixels follow.</source>
        <translation>Altura en papel; la anchura y los píxeles la siguen.</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Millimetres or inches</source>
        <translation>Milímetros o pulgadas</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolución</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> ppp</translation>
    </message>
    <message>
        <source>Pixels an inch. PNG, TIFF, JPEG and EXR files say it.</source>
        <translation>Píxeles por pulgada. Los archivos PNG, TIFF, JPEG y EXR la indican.</translation>
    </message>
</context>
<context>
    <name>suffuse::ProbePanel</name>
    <message>
        <source>Rest the pointer on the painting: what it is made of there is listed here, and stays when you come here to click it.</source>
        <translation>Deje quieto el puntero sobre la obra: aquí se enumera de qué está hecha en ese punto, y se mantiene cuando venga a hacer clic.</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Trazo</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>Density φ</source>
        <translation>Densidad φ</translation>
    </message>
    <message>
        <source>Of strokes: share of the colour. Of segments: share of the stroke&apos;s density.</source>
        <translation>De los trazos: parte del color. De los segmentos: parte de la densidad del trazo.</translation>
    </message>
    <message>
        <source>Strokes under the pointer</source>
        <translation>Trazos bajo el puntero</translation>
    </message>
    <message>
        <source>Density over the age</source>
        <translation>Densidad según la edad</translation>
    </message>
    <message>
        <source>The density of the chosen stroke at this place from when it was painted until it is dry. Dashed: the density from which it is seen.</source>
        <translation>La densidad del trazo elegido en este punto, desde que se pintó hasta que está seco. Línea discontinua: la densidad desde la que se ve.</translation>
    </message>
    <message>
        <source>%1, %2 · paper η %3</source>
        <translation>%1; %2 · papel η %3</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Lienzo</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>Trazo %1</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>Segmento %1</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Relleno</translation>
    </message>
    <message>
        <source>The topmost stroke comes first, with its share of the colour.</source>
        <translation>El trazo superior aparece primero, con su parte del color.</translation>
    </message>
</context>
<context>
    <name>suffuse::PushTool</name>
    <message>
        <source>Drag to push strokes along. [ and ] change the size.</source>
        <translation>Arrastrar para empujar trazos. [ y ] cambian el tamaño.</translation>
    </message>
    <message>
        <source>Drag to push the selected strokes along. [ and ] change the size.</source>
        <translation>Arrastrar para empujar los trazos seleccionados. [ y ] cambian el tamaño.</translation>
    </message>
    <message>
        <source>Drag to turn strokes into the direction of the drag.</source>
        <translation>Arrastrar para orientar los trazos en la dirección del arrastre.</translation>
    </message>
    <message>
        <source>Drag to turn the selected strokes into the direction of the drag.</source>
        <translation>Arrastrar para orientar los trazos seleccionados en la dirección del arrastre.</translation>
    </message>
    <message>
        <source>Hold to pull strokes together. Shift: apart.</source>
        <translation>Mantener para juntar trazos. Mayús: separarlos.</translation>
    </message>
    <message>
        <source>Hold to pull the selected strokes together. Shift: apart.</source>
        <translation>Mantener para juntar los trazos seleccionados. Mayús: separarlos.</translation>
    </message>
    <message>
        <source>Drag to roughen strokes.</source>
        <translation>Arrastrar para encrespar trazos.</translation>
    </message>
    <message>
        <source>Drag to roughen the selected strokes.</source>
        <translation>Arrastrar para encrespar los trazos seleccionados.</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Empujar</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>Peinar</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Juntar</translation>
    </message>
    <message>
        <source>Roughen</source>
        <translation>Encrespar</translation>
    </message>
    <message>
        <source>What the circle does to strokes</source>
        <translation>Qué hace el círculo con los trazos</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensidad</translation>
    </message>
    <message>
        <source>How much of it one touch does; a pen&apos;s pressure takes from it</source>
        <translation>Cuánto efecto tiene un toque; la presión del lápiz lo reduce</translation>
    </message>
    <message>
        <source>Push strokes</source>
        <translation>Empujar trazos</translation>
    </message>
    <message>
        <source>Comb strokes</source>
        <translation>Peinar trazos</translation>
    </message>
    <message>
        <source>Pinch strokes</source>
        <translation>Juntar trazos</translation>
    </message>
    <message>
        <source>Roughen strokes</source>
        <translation>Encrespar trazos</translation>
    </message>
    <message>
        <source>Letters are left alone while nothing is selected. Select the text to change its letters.</source>
        <translation>Las letras no se tocan mientras no haya nada seleccionado. Seleccione el texto para cambiar sus letras.</translation>
    </message>
</context>
<context>
    <name>suffuse::RecolourDialog</name>
    <message>
        <source>Recolour Artwork</source>
        <translation>Recolorear obra</translation>
    </message>
    <message>
        <source>Colours of what is selected</source>
        <translation>Colores de lo seleccionado</translation>
    </message>
    <message>
        <source>Colours of the painting</source>
        <translation>Colores de la obra</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>The colours with the most paint come first. Choose one, or several, and give it another colour: it changes everywhere.</source>
        <translation>Los colores con más pintura aparecen primero. Elija uno o varios y deles otro color: cambia en todas partes.</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Después</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Pintura</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Trazos</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmentos</translation>
    </message>
    <message numerus="yes">
        <source>%n colours that look alike</source>
        <translation>
            <numerusform>%n color parecido</numerusform>
            <numerusform>%n colores parecidos</numerusform>
        </translation>
    </message>
    <message>
        <source>Hex</source>
        <translation>Hex</translation>
    </message>
    <message>
        <source>sRGB colour as #rrggbb, #rgb or CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal</source>
        <translation>Color sRGB como #rrggbb, #rgb o CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal</translation>
    </message>
    <message>
        <source>Swatches</source>
        <translation>Muestras</translation>
    </message>
    <message>
        <source>The swatches of the painting. Click: the chosen colour becomes this one.</source>
        <translation>Las muestras de la obra. Clic: el color elegido pasa a ser este.</translation>
    </message>
    <message>
        <source>Keep differences</source>
        <translation>Conservar diferencias</translation>
    </message>
    <message>
        <source>Colours that are one line in the list change together and stay different. Else they become the same.</source>
        <translation>Los colores que forman una línea de la lista cambian juntos y siguen siendo distintos. Si no, pasan a ser el mismo.</translation>
    </message>
    <message>
        <source>Reset the Colour</source>
        <translation>Restablecer el color</translation>
    </message>
    <message>
        <source>Gives the chosen colours back what they were</source>
        <translation>Devuelve los colores elegidos a lo que eran</translation>
    </message>
    <message>
        <source>All colours</source>
        <translation>Todos los colores</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Tono</translation>
    </message>
    <message>
        <source>Turns all hues around the colour wheel</source>
        <translation>Gira todos los tonos por la rueda de color</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturación</translation>
    </message>
    <message>
        <source>100 %: as it is; 0 %: grey; more: more colourful</source>
        <translation>100 %: como está; 0 %: gris; más: más colorido</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>Claridad</translation>
    </message>
    <message>
        <source>Above 0 % nearer to white, below nearer to black</source>
        <translation>Por encima de 0 %, más cerca del blanco; por debajo, más cerca del negro</translation>
    </message>
    <message>
        <source>Map to the nearest swatches</source>
        <translation>Asignar a las muestras más próximas</translation>
    </message>
    <message>
        <source>Each colour becomes the swatch of the painting that looks nearest</source>
        <translation>Cada color pasa a ser la muestra de la obra que más se parece</translation>
    </message>
    <message>
        <source>“%1” is not a colour. Write it as #rrggbb, for example #2f6690.</source>
        <translation>«%1» no es un color. Escríbalo como #rrggbb, por ejemplo #2f6690.</translation>
    </message>
</context>
<context>
    <name>suffuse::RecoveryDialog</name>
    <message>
        <source>Recover Paintings</source>
        <translation>Recuperar obras</translation>
    </message>
    <message>
        <source>Suffuse ended before these paintings were saved. They open as they were at the last stroke; files on the disk are left as they are.</source>
        <translation>Suffuse terminó antes de que se guardaran estas obras. Se abren como estaban en el último trazo; los archivos del disco se quedan como están.</translation>
    </message>
    <message>
        <source>Paintings that can be recovered</source>
        <translation>Obras que se pueden recuperar</translation>
    </message>
    <message>
        <source>Painting</source>
        <translation>Obra</translation>
    </message>
    <message>
        <source>Last Change</source>
        <translation>Último cambio</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Trazos</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Recuperar</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Más tarde</translation>
    </message>
    <message>
        <source>&amp;Discard…</source>
        <translation>&amp;Descartar…</translation>
    </message>
    <message>
        <source>Opens the selected paintings, without a file of their own</source>
        <translation>Abre las obras seleccionadas, sin archivo propio</translation>
    </message>
    <message>
        <source>Asks again when Suffuse starts the next time</source>
        <translation>Vuelve a preguntar la próxima vez que se inicie Suffuse</translation>
    </message>
    <message>
        <source>Removes the selected paintings for good</source>
        <translation>Quita definitivamente las obras seleccionadas</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>aún sin guardar</translation>
    </message>
    <message>
        <source>Discard “%1”?</source>
        <translation>¿Descartar «%1»?</translation>
    </message>
    <message numerus="yes">
        <source>Discard %n paintings?</source>
        <translation>
            <numerusform>¿Descartar %n obra?</numerusform>
            <numerusform>¿Descartar %n obras?</numerusform>
        </translation>
    </message>
    <message>
        <source>What was painted since the last save is then lost for good.</source>
        <translation>Lo pintado desde el último guardado se perderá definitivamente.</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Descartar</translation>
    </message>
</context>
<context>
    <name>suffuse::RedrawTool</name>
    <message>
        <source>Draw from a stroke and back to it: the part between follows the line.</source>
        <translation>Dibujar desde un trazo y de vuelta a él: la parte intermedia sigue la línea.</translation>
    </message>
    <message>
        <source>Draw from a selected stroke and back to it: the part between follows.</source>
        <translation>Dibujar desde un trazo seleccionado y de vuelta a él: la parte intermedia la sigue.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>As they were</source>
        <translation>Como estaban</translation>
    </message>
    <message>
        <source>Of the brush in hand</source>
        <translation>Del pincel en uso</translation>
    </message>
    <message>
        <source>What the new part is painted with, and when</source>
        <translation>Con qué se pinta la parte nueva, y cuándo</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>Redibujar</translation>
    </message>
    <message>
        <source>The line begins and ends at no stroke that can be changed.</source>
        <translation>La línea no empieza ni termina en ningún trazo que se pueda cambiar.</translation>
    </message>
    <message>
        <source>The line begins and ends at no selected stroke that can be changed.</source>
        <translation>La línea no empieza ni termina en ningún trazo seleccionado que se pueda cambiar.</translation>
    </message>
</context>
<context>
    <name>suffuse::ReshapeDialog</name>
    <message>
        <source>Reshape</source>
        <translation>Reformar</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>Simplificar</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Suavizar</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Enderezar</translation>
    </message>
    <message>
        <source>Grow or shrink</source>
        <translation>Ensanchar o estrechar</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Desplazar</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>How far curves may move</source>
        <translation>Cuánto se pueden mover las curvas</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>How far spreads, densities, colours and times may differ that become one</source>
        <translation>Cuánto pueden diferir expansiones, densidades, colores y tiempos que se juntan en uno</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Wiggles of this length and shorter ones go</source>
        <translation>Las ondulaciones de esta longitud y más cortas desaparecen</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Cantidad</translation>
    </message>
    <message>
        <source>0 %: as it is; 100 %: a straight line</source>
        <translation>0 %: como está; 100 %: una línea recta</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>Of the paint; below 100 % it shrinks</source>
        <translation>De la pintura; por debajo de 100 % se estrecha</translation>
    </message>
    <message>
        <source>To the right of the stroke&apos;s direction; below 0 to the left</source>
        <translation>A la derecha del sentido del trazo; por debajo de 0, a la izquierda</translation>
    </message>
    <message>
        <source>%1 → %2 segments</source>
        <extracomment>%1, %2: numbers of segments before and after</extracomment>
        <translation>%1 → %2 segmentos</translation>
    </message>
    <message>
        <source>%1, picture differs by %2</source>
        <extracomment>%1: &quot;12 → 3 segments&quot;; %2: &quot;0.4 %&quot;, the mean difference of the pictures</extracomment>
        <translation>%1, la imagen difiere en %2</translation>
    </message>
</context>
<context>
    <name>suffuse::RewetRows</name>
    <message>
        <source>Wetted again</source>
        <translation>Rehumedecido</translation>
    </message>
    <message>
        <source>… and more</source>
        <translation>… y más</translation>
    </message>
    <message>
        <source>at %1 for %2 s</source>
        <translation>en %1 durante %2 s</translation>
    </message>
    <message>
        <source>at %1 for %2 s, some segments</source>
        <translation>en %1 durante %2 s, algunos segmentos</translation>
    </message>
    <message>
        <source>The selected paint is not wetted then</source>
        <translation>La pintura seleccionada no se moja en ese momento</translation>
    </message>
    <message>
        <source>Remove re-wetting</source>
        <translation>Quitar rehumedecido</translation>
    </message>
</context>
<context>
    <name>suffuse::ScreenColourRows</name>
    <message>
        <source>Hue</source>
        <translation>Tono</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturación</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Hue on the circle of the screen&apos;s colours: 0° red, 120° green, 240° blue</source>
        <translation>Tono en el círculo de los colores de la pantalla: 0° rojo, 120° verde, 240° azul</translation>
    </message>
    <message>
        <source>0 %: grey; 100 %: as colourful as a screen can be</source>
        <translation>0 %: gris; 100 %: tan colorido como puede ser una pantalla</translation>
    </message>
    <message>
        <source>0 %: black; 100 %: as bright as the colour can be</source>
        <translation>0 %: negro; 100 %: tan brillante como puede ser el color</translation>
    </message>
    <message>
        <source>Red light of the screen, 0 to 255</source>
        <translation>Luz roja de la pantalla, de 0 a 255</translation>
    </message>
    <message>
        <source>Green light of the screen, 0 to 255</source>
        <translation>Luz verde de la pantalla, de 0 a 255</translation>
    </message>
    <message>
        <source>Blue light of the screen, 0 to 255</source>
        <translation>Luz azul de la pantalla, de 0 a 255</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
</context>
<context>
    <name>suffuse::SegmentSection</name>
    <message>
        <source>Diffusion D</source>
        <translation>Difusión D</translation>
    </message>
    <message>
        <source>How fast the paint spreads: the spread grows with the root of D times time.</source>
        <translation>Con qué rapidez se expande la pintura: la expansión crece con la raíz de D por el tiempo.</translation>
    </message>
    <message>
        <source>Density φ</source>
        <translation>Densidad φ</translation>
    </message>
    <message>
        <source>How much paint the segment gives off along its length.</source>
        <translation>Cuánta pintura suelta el segmento a lo largo de su longitud.</translation>
    </message>
    <message>
        <source>Drying time</source>
        <translation>Tiempo de secado</translation>
    </message>
    <message>
        <source>t_max: how long the paint spreads after it was laid down.</source>
        <translation>t_max: cuánto tiempo se expande la pintura después de aplicarse.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmentos</translation>
    </message>
    <message>
        <source>Change diffusion</source>
        <translation>Cambiar difusión</translation>
    </message>
    <message>
        <source>Change density</source>
        <translation>Cambiar densidad</translation>
    </message>
    <message>
        <source>Change granulation</source>
        <translation>Cambiar granulación</translation>
    </message>
    <message>
        <source>Change drying time</source>
        <translation>Cambiar tiempo de secado</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Colour of the selection</source>
        <translation>Color de la selección</translation>
    </message>
    <message>
        <source>Colour of the selection. Click: paint with it.</source>
        <translation>Color de la selección. Clic: pintar con él.</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Cambiar opacidad</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Cambiar color</translation>
    </message>
    <message>
        <source>Anisotropy</source>
        <translation>Anisotropía</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Direction of the anisotropy, clockwise from the horizontal.</source>
        <translation>Dirección de la anisotropía, en sentido horario desde la horizontal.</translation>
    </message>
    <message>
        <source>Change anisotropy</source>
        <translation>Cambiar anisotropía</translation>
    </message>
    <message>
        <source>Change angle</source>
        <translation>Cambiar ángulo</translation>
    </message>
    <message>
        <source>How many times D along the angle is D across it; 1 spreads evenly.</source>
        <translation>Cuántas veces mayor es D a lo largo del ángulo que a través de él; con 1 se expande por igual.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>How much the paint covers at full density</source>
        <translation>Cuánto cubre la pintura a plena densidad</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rojo</translation>
    </message>
    <message>
        <source>Share of red pigment</source>
        <translation>Parte de pigmento rojo</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Amarillo</translation>
    </message>
    <message>
        <source>Share of yellow pigment</source>
        <translation>Parte de pigmento amarillo</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Azul</translation>
    </message>
    <message>
        <source>Share of blue pigment</source>
        <translation>Parte de pigmento azul</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>No es posible para todo lo seleccionado: un valor quedaría fuera del intervalo.</translation>
    </message>
    <message>
        <source>Born</source>
        <translation>Nacimiento</translation>
    </message>
    <message>
        <source>When the stroke, or what is selected of it, begins. All of that moves in time as one.</source>
        <translation>Cuándo empieza el trazo, o lo seleccionado de él. Todo ello se mueve en el tiempo como un todo.</translation>
    </message>
    <message>
        <source>Change birth</source>
        <translation>Cambiar nacimiento</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Cambiar %1</translation>
    </message>
    <message>
        <source>Granulation</source>
        <translation>Granulación</translation>
    </message>
    <message>
        <source>How much of the paper&apos;s grain shows: 0 % is smooth, 100 % shows all of it. Files and scripts hold ω, which is 1 where this is 0 %.</source>
        <translation>Cuánto se ve del grano del papel: 0 % es liso, 100 % lo muestra todo. Los archivos y scripts contienen ω, que es 1 donde esto es 0 %.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Width of a dry line at full pressure, in units; sets the diffusion.</source>
        <translation>Anchura de una línea seca a plena presión, en unidades; fija la difusión.</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Flujo</translation>
    </message>
    <message>
        <source>Density in the middle of the stroke at full pressure.</source>
        <translation>Densidad en el centro del trazo a plena presión.</translation>
    </message>
    <message>
        <source>String</source>
        <translation>Cuerda</translation>
    </message>
    <message>
        <source>Its length on the screen</source>
        <translation>Su longitud en la pantalla</translation>
    </message>
    <message>
        <source>Pigment β</source>
        <translation>Pigmento β</translation>
    </message>
    <message>
        <source>Share of the colour below that stays: 0 % covers, 100 % adds.</source>
        <translation>Parte del color de debajo que permanece: 0 % cubre, 100 % suma.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensidad</translation>
    </message>
    <message>
        <source>How deep the grain goes.</source>
        <translation>Qué profundidad tiene el grano.</translation>
    </message>
    <message>
        <source>How far the stroke lags behind</source>
        <translation>Cuánto se retrasa el trazo</translation>
    </message>
    <message>
        <source>Parameter of the style</source>
        <translation>Parámetro del estilo</translation>
    </message>
    <message>
        <source>Threshold ξ1</source>
        <translation>Umbral ξ1</translation>
    </message>
    <message>
        <source>Softness ξ2</source>
        <translation>Suavidad ξ2</translation>
    </message>
    <message>
        <source>Full at ξ1</source>
        <translation>Pleno en ξ1</translation>
    </message>
    <message>
        <source>Steepness ξ2</source>
        <translation>Pendiente ξ2</translation>
    </message>
    <message>
        <source>Edge ξ1</source>
        <translation>Borde ξ1</translation>
    </message>
    <message>
        <source>Lightening ξ2</source>
        <translation>Aclarado ξ2</translation>
    </message>
    <message>
        <source>Strength ξ3</source>
        <translation>Intensidad ξ3</translation>
    </message>
    <message>
        <source>Density at which the stroke covers by half.</source>
        <translation>Densidad en la que el trazo cubre a medias.</translation>
    </message>
    <message>
        <source>How gently the edge fades.</source>
        <translation>Con qué suavidad se desvanece el borde.</translation>
    </message>
    <message>
        <source>Density from which the stroke covers fully.</source>
        <translation>Densidad desde la que el trazo cubre por completo.</translation>
    </message>
    <message>
        <source>How steeply coverage grows with density.</source>
        <translation>Con qué pendiente crece la cobertura con la densidad.</translation>
    </message>
    <message>
        <source>Density at which the dark rim stands.</source>
        <translation>Densidad en la que está el borde oscuro.</translation>
    </message>
    <message>
        <source>How much the inside is lighter than the rim; at most 1.26·ξ1.</source>
        <translation>Cuánto más claro es el interior que el borde; como máximo 1,26·ξ1.</translation>
    </message>
    <message>
        <source>Coverage far inside the stroke.</source>
        <translation>Cobertura muy dentro del trazo.</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Uniforme</translation>
    </message>
    <message>
        <source>Feathering</source>
        <translation>Difuminado</translation>
    </message>
    <message>
        <source>Dark edges</source>
        <translation>Bordes oscuros</translation>
    </message>
    <message>
        <source>Covering (alpha)</source>
        <translation>Cubriente (alfa)</translation>
    </message>
    <message>
        <source>Pigment (β)</source>
        <translation>Pigmento (β)</translation>
    </message>
    <message>
        <source>Erasure</source>
        <translation>Borrado</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Desactivado</translation>
    </message>
    <message>
        <source>Weighted</source>
        <translation>Ponderado</translation>
    </message>
    <message>
        <source>Pulled string</source>
        <translation>Cuerda tensada</translation>
    </message>
</context>
<context>
    <name>suffuse::SelectTool</name>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Stroke %1 of %2 under the pointer, from the top. Alt+click again: the next below.</source>
        <translation>Trazo %1 de %2 bajo el puntero, desde arriba. Alt+clic otra vez: el siguiente de debajo.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escalar</translation>
    </message>
    <message>
        <source>Skew</source>
        <translation>Inclinar</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %2 de %3</translation>
    </message>
    <message>
        <source>%1: moved by %2, %3</source>
        <translation>%1: movido %2; %3</translation>
    </message>
</context>
<context>
    <name>suffuse::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>System</source>
        <translation>Sistema</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Colours of the windows</source>
        <translation>Colores de las ventanas</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Lienzo</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Raster</source>
        <translation>Ráster</translation>
    </message>
    <message>
        <source>All cores</source>
        <translation>Todos los núcleos</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Hilos</translation>
    </message>
    <message>
        <source>Renderer</source>
        <translation>Motor de dibujo</translation>
    </message>
    <message>
        <source>General</source>
        <translation>General</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Lápiz</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Copias de seguridad</translation>
    </message>
    <message>
        <source>How many earlier versions are kept when a painting is saved: “name.suffuse~” beside it is the last one, “~2” the one before. File ▸ Restore Backup brings one back.</source>
        <translation>Cuántas versiones anteriores se conservan al guardar una obra: «nombre.suffuse~», a su lado, es la última; «~2», la anterior. Archivo ▸ Restaurar copia de seguridad recupera una.</translation>
    </message>
    <message>
        <source>Language of the program</source>
        <translation>Idioma del programa</translation>
    </message>
    <message>
        <source>How the picture comes to the screen</source>
        <translation>Cómo llega la imagen a la pantalla</translation>
    </message>
    <message>
        <source>What computes the picture</source>
        <translation>Qué calcula la imagen</translation>
    </message>
    <message>
        <source>Processor threads for drawing</source>
        <translation>Hilos del procesador para dibujar</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Whether docks glide to their places and carets blink</source>
        <translation>Si los paneles se deslizan a su sitio y los cursores parpadean</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Reducido</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Completo</translation>
    </message>
</context>
<context>
    <name>suffuse::SheetView</name>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
</context>
<context>
    <name>suffuse::ShortcutsDialog</name>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search shortcuts</source>
        <translation>Buscar atajos</translation>
    </message>
    <message>
        <source>Shows only commands whose name or shortcut holds this text.</source>
        <translation>Muestra solo las órdenes cuyo nombre o atajo contiene este texto.</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Atajo</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Órdenes</translation>
    </message>
    <message>
        <source>Choose a command, then press its new shortcut below.</source>
        <translation>Elija una orden y pulse abajo su nuevo atajo.</translation>
    </message>
    <message>
        <source>Press the keys</source>
        <translation>Pulse las teclas</translation>
    </message>
    <message>
        <source>No shortcut for this command</source>
        <translation>Ningún atajo para esta orden</translation>
    </message>
    <message>
        <source>This command&apos;s own shortcut</source>
        <translation>El atajo propio de esta orden</translation>
    </message>
    <message>
        <source>%1 belongs to “%2” and “%3”. Give one of them another shortcut.</source>
        <translation>%1 pertenece a «%2» y a «%3». Dé otro atajo a una de ellas.</translation>
    </message>
    <message>
        <source>Takes the shortcut away from the other command</source>
        <translation>Quita el atajo a la otra orden</translation>
    </message>
    <message>
        <source>Fixed: no command can have these keys.</source>
        <translation>Fijas: ninguna orden puede tener estas teclas.</translation>
    </message>
    <message>
        <source>%1 is fixed: “%2”. Give “%3” another shortcut.</source>
        <translation>%1 es fijo: «%2». Dé otro atajo a «%3».</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Ninguno</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Res&amp;tablecer</translation>
    </message>
    <message>
        <source>&amp;Take Over</source>
        <translation>T&amp;omarlo</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>Atajos de teclado</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Dónde</translation>
    </message>
    <message>
        <source>Where the shortcut works. What is typed in a dock, without Ctrl or Alt, stays there.</source>
        <translation>Dónde funciona el atajo. Lo que se escribe en un panel, sin Ctrl ni Alt, se queda ahí.</translation>
    </message>
</context>
<context>
    <name>suffuse::SizedTool</name>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Diameter of the circle ([ and ] change it)</source>
        <translation>Diámetro del círculo ([ y ] lo cambian)</translation>
    </message>
</context>
<context>
    <name>suffuse::SliderField</name>
    <message>
        <source>Double-click: back to the default.</source>
        <translation>Doble clic: volver al valor predeterminado.</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1, deslizador</translation>
    </message>
    <message>
        <source>The values differ. The slider multiplies each of them; with Ctrl it makes them one.</source>
        <translation>Los valores difieren. El deslizador multiplica cada uno; con Ctrl los hace iguales.</translation>
    </message>
    <message>
        <source>The values differ. The slider adds to each of them; with Ctrl it makes them one.</source>
        <translation>Los valores difieren. El deslizador suma a cada uno; con Ctrl los hace iguales.</translation>
    </message>
    <message>
        <source>The values differ. A number makes them one; *1.2 or +2 changes each of them.</source>
        <translation>Los valores difieren. Un número los hace iguales; *1,2 o +2 cambia cada uno.</translation>
    </message>
</context>
<context>
    <name>suffuse::SoftReach</name>
    <message>
        <source>Reach</source>
        <translation>Alcance</translation>
    </message>
    <message>
        <source>How far along the stroke a dragged node or curve takes along what lies near; 0: nothing (wheel or [ and ] during the drag, or Alt+drag, change it)</source>
        <translation>Hasta dónde, a lo largo del trazo, un nodo o curva que se arrastra lleva consigo lo cercano; 0: nada (la rueda o [ y ] al arrastrar, o Alt+arrastrar, lo cambian)</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Let the reach follow the view: soft where nodes would crowd, else the node alone</source>
        <translation>Hacer que el alcance siga a la vista: suave donde los nodos se amontonarían; si no, el nodo solo</translation>
    </message>
    <message>
        <source>Let the reach follow the view</source>
        <translation>Hacer que el alcance siga a la vista</translation>
    </message>
</context>
<context>
    <name>suffuse::StatusLine</name>
    <message>
        <source>Position of the pointer, in what the rulers count</source>
        <translation>Posición del puntero, en la unidad de las reglas</translation>
    </message>
    <message>
        <source>Zoom, and the angle by which the canvas is turned</source>
        <translation>Zoom, y ángulo en que está girado el lienzo</translation>
    </message>
    <message>
        <source>What renders the picture</source>
        <translation>Qué dibuja la imagen</translation>
    </message>
    <message>
        <source>Time that the last frame took</source>
        <translation>Tiempo que tardó el último fotograma</translation>
    </message>
    <message>
        <source>You paint in the past: what came later covers it.</source>
        <extracomment>instead of what the brush does, while the timeline shows a moment of the past</extracomment>
        <translation>Está pintando en el pasado: lo que vino después lo cubre.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>a position: x, y</extracomment>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 ms, coarse</source>
        <translation>%1 ms, tosco</translation>
    </message>
    <message>
        <source>Arrow keys move the pen, with Shift far and with Alt finely; Space presses it down and lifts it; + and - change its pressure; Esc puts it away.</source>
        <translation>Las teclas de flecha mueven el lápiz, con Mayús más lejos y con Alt más fino; Espacio lo baja y lo levanta; + y - cambian su presión; Esc lo retira.</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokeHistoryList</name>
    <message>
        <source>History of the selected stroke</source>
        <translation>Historial del trazo seleccionado</translation>
    </message>
    <message>
        <source>What was done to the selected stroke. Click a state to put this stroke back to it; everything else stays as it is.</source>
        <translation>Qué se ha hecho con el trazo seleccionado. Haga clic en un estado para devolver este trazo a él; todo lo demás se queda como está.</translation>
    </message>
    <message>
        <source>As it was at first</source>
        <translation>Como era al principio</translation>
    </message>
    <message>
        <source>Put stroke back</source>
        <translation>Devolver trazo</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokeSection</name>
    <message>
        <source>Strokes</source>
        <translation>Trazos</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Name of the selected strokes, as the list of strokes shows it.</source>
        <translation>Nombre de los trazos seleccionados, como lo muestra la lista de trazos.</translation>
    </message>
    <message>
        <source>Rename stroke</source>
        <translation>Cambiar nombre del trazo</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>Mezcla</translation>
    </message>
    <message>
        <source>How the paint mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>Cómo se mezcla la pintura con lo que hay debajo: cubre, o los pigmentos se suman.</translation>
    </message>
    <message>
        <source>Change pigment mixing</source>
        <translation>Cambiar mezcla de pigmento</translation>
    </message>
    <message>
        <source>Change mixing</source>
        <translation>Cambiar mezcla</translation>
    </message>
    <message>
        <source>unnamed</source>
        <translation>sin nombre</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>No es posible para todo lo seleccionado: un valor quedaría fuera del intervalo.</translation>
    </message>
    <message>
        <source>The mixing of the wash is seen in place of this one.</source>
        <translation>En lugar de esta mezcla se ve la de la aguada.</translation>
    </message>
</context>
<context>
    <name>suffuse::WashRows</name>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>How the density of all strokes of the wash becomes coverage.</source>
        <translation>Cómo la densidad de todos los trazos de la aguada se convierte en cobertura.</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>Mezcla</translation>
    </message>
    <message>
        <source>How the wash mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>Cómo se mezcla la aguada con lo que hay debajo: cubre, o los pigmentos se suman.</translation>
    </message>
    <message>
        <source>Change wash</source>
        <translation>Cambiar aguada</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: %1</source>
        <translation>No es posible para todo lo seleccionado: %1</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesModel</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Visible</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Bloqueado</translation>
    </message>
    <message>
        <source>Visible. Click: hide.</source>
        <translation>Visible. Clic: ocultar.</translation>
    </message>
    <message>
        <source>Hidden. Click: show.</source>
        <translation>Oculto. Clic: mostrar.</translation>
    </message>
    <message>
        <source>Locked. Click: unlock.</source>
        <translation>Bloqueado. Clic: desbloquear.</translation>
    </message>
    <message>
        <source>Not locked. Click: lock.</source>
        <translation>Sin bloquear. Clic: bloquear.</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>Trazo %1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln segmento</numerusform>
            <numerusform>%Ln segmentos</numerusform>
        </translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Grupo %1</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>Cambiar nombre del grupo</translation>
    </message>
    <message>
        <source>Rename stroke</source>
        <translation>Cambiar nombre del trazo</translation>
    </message>
    <message>
        <source>Hide group</source>
        <translation>Ocultar grupo</translation>
    </message>
    <message>
        <source>Show group</source>
        <translation>Mostrar grupo</translation>
    </message>
    <message>
        <source>Unlock group</source>
        <translation>Desbloquear grupo</translation>
    </message>
    <message>
        <source>Lock group</source>
        <translation>Bloquear grupo</translation>
    </message>
    <message>
        <source>Hide stroke</source>
        <translation>Ocultar trazo</translation>
    </message>
    <message>
        <source>Show stroke</source>
        <translation>Mostrar trazo</translation>
    </message>
    <message>
        <source>Unlock stroke</source>
        <translation>Desbloquear trazo</translation>
    </message>
    <message>
        <source>Lock stroke</source>
        <translation>Bloquear trazo</translation>
    </message>
    <message>
        <source>Reorder strokes</source>
        <translation>Reordenar trazos</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>Segmento %1</translation>
    </message>
    <message>
        <source>All in it is hidden. Click: show it.</source>
        <translation>Todo lo que contiene está oculto. Clic: mostrarlo.</translation>
    </message>
    <message>
        <source>Some of it is hidden. Click: hide the group.</source>
        <translation>Una parte está oculta. Clic: ocultar el grupo.</translation>
    </message>
    <message>
        <source>All in it is locked. Click: unlock it.</source>
        <translation>Todo lo que contiene está bloqueado. Clic: desbloquearlo.</translation>
    </message>
    <message>
        <source>Some of it is locked. Click: lock the group.</source>
        <translation>Una parte está bloqueada. Clic: bloquear el grupo.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln piece(s)</source>
        <translation>
            <numerusform>%Ln pieza</numerusform>
            <numerusform>%Ln piezas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln erasure(s)</source>
        <translation>
            <numerusform>%Ln borrado</numerusform>
            <numerusform>%Ln borrados</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <extracomment>between &quot;3 pieces&quot; and &quot;12 erasures&quot;</extracomment>
        <translation>, </translation>
    </message>
    <message>
        <source>mixes by itself</source>
        <translation>se mezcla por separado</translation>
    </message>
    <message>
        <source>%1, painted on</source>
        <translation>%1, se pinta aquí</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesPanel</name>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search strokes</source>
        <translation>Buscar trazos</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Trazos</translation>
    </message>
    <message>
        <source>The topmost stroke comes first. Drag to reorder, double-click to rename; a right click offers more.</source>
        <translation>El trazo superior aparece primero. Arrastre para reordenar, haga doble clic para cambiar el nombre; el clic derecho ofrece más.</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Cambiar nombre</translation>
    </message>
    <message>
        <source>Mo&amp;ve Up</source>
        <translation>Mover a&amp;rriba</translation>
    </message>
    <message>
        <source>Move Do&amp;wn</source>
        <translation>Mover a&amp;bajo</translation>
    </message>
    <message>
        <source>Select rows to move them.</source>
        <translation>Seleccione filas para moverlas.</translation>
    </message>
    <message>
        <source>Nothing changes: this is on top already.</source>
        <translation>No cambia nada: esto ya está arriba del todo.</translation>
    </message>
    <message>
        <source>Nothing changes: this is at the bottom already.</source>
        <translation>No cambia nada: esto ya está abajo del todo.</translation>
    </message>
    <message>
        <source>Nothing changes: locked strokes stay in place.</source>
        <translation>No cambia nada: los trazos bloqueados se quedan en su sitio.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Select &amp;Same</source>
        <translation>Seleccionar con el mi&amp;smo</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Color</translation>
    </message>
    <message>
        <source>&amp;Style</source>
        <translation>&amp;Estilo</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pincel</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>&amp;Ocultar</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>Mos&amp;trar</translation>
    </message>
    <message>
        <source>Un&amp;lock</source>
        <translation>&amp;Desbloquear</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>B&amp;loquear</translation>
    </message>
    <message>
        <source>Hide strokes</source>
        <translation>Ocultar trazos</translation>
    </message>
    <message>
        <source>Show strokes</source>
        <translation>Mostrar trazos</translation>
    </message>
    <message>
        <source>Unlock strokes</source>
        <translation>Desbloquear trazos</translation>
    </message>
    <message>
        <source>Lock strokes</source>
        <translation>Bloquear trazos</translation>
    </message>
    <message>
        <source>Shows only strokes and groups whose name holds this text. Return selects them.</source>
        <translation>Muestra solo los trazos y grupos cuyo nombre contiene este texto. Intro los selecciona.</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <source>No stroke is called “%1”.</source>
        <translation>Ningún trazo se llama «%1».</translation>
    </message>
    <message>
        <source>While the list is searched, rows are not dragged: between those that show there may be others. Clear the search first.</source>
        <translation>Mientras se busca en la lista, las filas no se arrastran: entre las que se ven puede haber otras. Vacíe antes la búsqueda.</translation>
    </message>
    <message>
        <source>Mi&amp;x by Itself</source>
        <translation>Me&amp;zclar por separado</translation>
    </message>
    <message>
        <source>Mix group by itself</source>
        <translation>Mezclar grupo por separado</translation>
    </message>
    <message>
        <source>Mix group with what lies below</source>
        <translation>Mezclar grupo con lo que hay debajo</translation>
    </message>
    <message>
        <source>New layer: %1</source>
        <translation>Capa nueva: %1</translation>
    </message>
    <message>
        <source>Painting on: %1</source>
        <translation>Se pinta en: %1</translation>
    </message>
    <message>
        <source>The layer comes into the list with the first stroke that is painted.</source>
        <translation>La capa aparece en la lista con el primer trazo que se pinta.</translation>
    </message>
    <message>
        <source>What is painted goes into this group. A click beside all rows: on top of all again.</source>
        <translation>Lo que se pinta va a este grupo. Un clic fuera de todas las filas: de nuevo encima de todo.</translation>
    </message>
    <message>
        <source>Painting on top of all</source>
        <translation>Se pinta encima de todo</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>&amp;Modo</translation>
    </message>
    <message>
        <source>O&amp;pacity…</source>
        <translation>O&amp;pacidad…</translation>
    </message>
    <message>
        <source>New clipped layer: %1</source>
        <translation>Capa recortada nueva: %1</translation>
    </message>
</context>
<context>
    <name>suffuse::StyleSection</name>
    <message>
        <source>Style</source>
        <translation>Estilo</translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation>Pertenece</translation>
    </message>
    <message>
        <source>Whether the segments follow their stroke&apos;s style or have their own.</source>
        <translation>Si los segmentos siguen el estilo de su trazo o tienen uno propio.</translation>
    </message>
    <message>
        <source>The stroke</source>
        <translation>Al trazo</translation>
    </message>
    <message>
        <source>These segments</source>
        <translation>A estos segmentos</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>How density becomes coverage.</source>
        <translation>Cómo la densidad se convierte en cobertura.</translation>
    </message>
    <message>
        <source>Change style</source>
        <translation>Cambiar estilo</translation>
    </message>
    <message>
        <source>Give segments their own style</source>
        <translation>Dar a los segmentos un estilo propio</translation>
    </message>
    <message>
        <source>Follow the stroke&apos;s style</source>
        <translation>Seguir el estilo del trazo</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: %1</source>
        <translation>No es posible para todo lo seleccionado: %1</translation>
    </message>
    <message>
        <source>The style of the wash is seen in place of this one.</source>
        <translation>En lugar de este estilo se ve el de la aguada.</translation>
    </message>
</context>
<context>
    <name>suffuse::SwatchGrid</name>
    <message>
        <source>Add swatch</source>
        <translation>Añadir muestra</translation>
    </message>
    <message>
        <source>Move swatch</source>
        <translation>Mover muestra</translation>
    </message>
    <message>
        <source>Rename swatch</source>
        <translation>Cambiar nombre de muestra</translation>
    </message>
    <message>
        <source>Remove swatch</source>
        <translation>Quitar muestra</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Cambiar nombre…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Link swatch</source>
        <translation>Vincular muestra</translation>
    </message>
    <message>
        <source>Unlink swatch</source>
        <translation>Desvincular muestra</translation>
    </message>
    <message>
        <source>linked</source>
        <translation>vinculada</translation>
    </message>
    <message>
        <source>Change the Colour</source>
        <translation>Cambiar el color</translation>
    </message>
    <message>
        <source>Linked to What Is Painted with It</source>
        <translation>Vinculada a lo que se pinta con ella</translation>
    </message>
    <message>
        <source>Select What Has This Colour</source>
        <translation>Seleccionar lo que tiene este color</translation>
    </message>
</context>
<context>
    <name>suffuse::SwatchesSection</name>
    <message>
        <source>Swatches</source>
        <translation>Muestras</translation>
    </message>
    <message>
        <source>Add swatch</source>
        <translation>Añadir muestra</translation>
    </message>
    <message>
        <source>Keeps the current colour with the painting.</source>
        <translation>Conserva el color actual con la obra.</translation>
    </message>
    <message>
        <source>Palettes</source>
        <translation>Paletas</translation>
    </message>
    <message>
        <source>GIMP palettes in and out</source>
        <translation>Importar y exportar paletas de GIMP</translation>
    </message>
    <message>
        <source>Colours kept with the painting. Click: take it. Drag to move; Delete removes.</source>
        <translation>Colores conservados con la obra. Clic: tomarlo. Arrastrar: moverlo; Supr: quitarlo.</translation>
    </message>
    <message>
        <source>None yet: + keeps the current colour.</source>
        <translation>Aún no hay: + conserva el color actual.</translation>
    </message>
    <message>
        <source>GIMP palettes</source>
        <translation>Paletas de GIMP</translation>
    </message>
    <message>
        <source>Import palette</source>
        <translation>Importar paleta</translation>
    </message>
    <message>
        <source>Export palette</source>
        <translation>Exportar paleta</translation>
    </message>
    <message>
        <source>Remove all swatches</source>
        <translation>Quitar todas las muestras</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 no se puede leer: %2.</translation>
    </message>
    <message>
        <source>Map Colours to Swatches</source>
        <translation>Asignar colores a muestras</translation>
    </message>
    <message>
        <source>Gives what is selected, or else all of the painting, the swatch that looks nearest</source>
        <translation>Da a lo seleccionado, o si no a toda la obra, la muestra que más se parece</translation>
    </message>
    <message>
        <source>Import Palette…</source>
        <translation>Importar paleta…</translation>
    </message>
    <message>
        <source>Export Palette…</source>
        <translation>Exportar paleta…</translation>
    </message>
    <message>
        <source>Remove All</source>
        <translation>Quitar todas</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelapseDialog</name>
    <message>
        <source>The ending chooses the format: webm or mp4 is a video, webp an animation, and png, tiff, exr, jpg or pfm numbered pictures, such as frame%04d.png.</source>
        <translation>La terminación elige el formato: webm o mp4 es un vídeo, webp una animación, y png, tiff, exr, jpg o pfm imágenes numeradas, como frame%04d.png.</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Fotogramas por segundo</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> fotogramas/s</translation>
    </message>
    <message>
        <source>How many pictures a second the film has</source>
        <translation>Cuántas imágenes por segundo tiene la película</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>How long the film is; the painting&apos;s time is stretched over it.</source>
        <translation>Cuánto dura la película; el tiempo de la obra se estira a lo largo de ella.</translation>
    </message>
    <message>
        <source>Animated WebP: begins anew at its end. Players decide it for videos.</source>
        <translation>WebP animado: vuelve a empezar al final. En los vídeos lo decide el reproductor.</translation>
    </message>
    <message>
        <source>Films</source>
        <translation>Películas</translation>
    </message>
    <message>
        <source>Numbered pictures</source>
        <translation>Imágenes numeradas</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 fotogramas</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>A film of %1 frames is too long. Choose a lower rate or a shorter length.</source>
        <translation>Una película de %1 fotogramas es demasiado larga. Elija menos fotogramas por segundo o una duración menor.</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Fotograma %1 de %2</translation>
    </message>
    <message>
        <source>Writing the film…</source>
        <translation>Escribiendo la película…</translation>
    </message>
    <message numerus="yes">
        <source>%1; %n second(s) left</source>
        <translation>
            <numerusform>%1; queda %n segundo</numerusform>
            <numerusform>%1; quedan %n segundos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n minute(s) left</source>
        <translation>
            <numerusform>%1; queda %n minuto</numerusform>
            <numerusform>%1; quedan %n minutos</numerusform>
        </translation>
    </message>
    <message>
        <source>Longest pause</source>
        <translation>Pausa más larga</translation>
    </message>
    <message>
        <source>Pauses in which nothing is painted or spreads are cut to this, in the painting&apos;s time.</source>
        <translation>Las pausas en las que nada se pinta ni se expande se reducen a esto, en el tiempo de la obra.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Bucle</translation>
    </message>
    <message>
        <source>Export Timelapse</source>
        <translation>Exportar cámara rápida</translation>
    </message>
    <message>
        <source>“%1” has no ending of a film or a picture. Choose one of: %2.</source>
        <translation>«%1» no tiene la terminación de una película ni de una imagen. Elija una de: %2.</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelinePanel</name>
    <message>
        <source>%1 is out of range: 0.1 to 1000 times is possible.</source>
        <translation>%1 está fuera del intervalo: se admite de 0,1 a 1000 veces.</translation>
    </message>
    <message>
        <source>The moment that is shown, and the end, when all has dried</source>
        <translation>El momento que se muestra, y el final, cuando todo se ha secado</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>How fast the painting is played: 0.1 to 1000 times as fast as it was painted</source>
        <translation>Con qué rapidez se reproduce la obra: de 0,1 a 1000 veces tan rápido como se pintó</translation>
    </message>
    <message>
        <source>Show all of the time (0). Ctrl+wheel zooms.</source>
        <translation>Mostrar todo el tiempo (0). Ctrl+rueda hace zoom.</translation>
    </message>
    <message>
        <source>Show all of the time</source>
        <translation>Mostrar todo el tiempo</translation>
    </message>
    <message>
        <source>Go to Its &amp;Start</source>
        <translation>Ir a su &amp;inicio</translation>
    </message>
    <message>
        <source>Go to When It Is Dr&amp;y</source>
        <translation>Ir a cuando esté &amp;seco</translation>
    </message>
    <message>
        <source>Drawing Pa&amp;ce</source>
        <translation>Ri&amp;tmo de dibujo</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelinePointer</name>
    <message>
        <source>Stroke %1</source>
        <translation>Trazo %1</translation>
    </message>
    <message>
        <source>Drawn from %1 to %2</source>
        <translation>Dibujado de %1 a %2</translation>
    </message>
    <message>
        <source>Dry at %1</source>
        <translation>Seco en %1</translation>
    </message>
    <message>
        <source>Erased in part from %1 on</source>
        <translation>Borrado en parte desde %1</translation>
    </message>
    <message>
        <source>Wetted again, dry at %1</source>
        <translation>Rehumedecido, seco en %1</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Bloqueado</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelineView</name>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>A bar for each stroke, from when it was painted until it is dry.</source>
        <translation>Una barra para cada trazo, desde que se pintó hasta que está seco.</translation>
    </message>
</context>
<context>
    <name>suffuse::TransformBar</name>
    <message>
        <source>X</source>
        <extracomment>left edge of the selection</extracomment>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge of the selected strokes&apos; curves</source>
        <translation>Borde izquierdo de las curvas de los trazos seleccionados</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge of the selected strokes&apos; curves</source>
        <translation>Borde superior de las curvas de los trazos seleccionados</translation>
    </message>
    <message>
        <source>W</source>
        <extracomment>width</extracomment>
        <translation>An</translation>
    </message>
    <message>
        <source>Width of the selected strokes&apos; curves</source>
        <translation>Anchura de las curvas de los trazos seleccionados</translation>
    </message>
    <message>
        <source>Keep the proportions of width and height</source>
        <translation>Mantener las proporciones de anchura y altura</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>Mantener las proporciones</translation>
    </message>
    <message>
        <source>H</source>
        <extracomment>height</extracomment>
        <translation>Al</translation>
    </message>
    <message>
        <source>Height of the selected strokes&apos; curves</source>
        <translation>Altura de las curvas de los trazos seleccionados</translation>
    </message>
    <message>
        <source>∠</source>
        <translation>∠</translation>
    </message>
    <message>
        <source>Rotate the selected strokes by this angle</source>
        <translation>Girar este ángulo los trazos seleccionados</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escalar</translation>
    </message>
    <message>
        <source>Some of these strokes would become too small, too large or too far away to be painted.</source>
        <translation>Algunos de estos trazos quedarían demasiado pequeños, demasiado grandes o demasiado lejos para pintarse.</translation>
    </message>
</context>
<context>
    <name>suffuse::UnderlayLoader</name>
    <message>
        <source>Underlay</source>
        <translation>Calco</translation>
    </message>
</context>
<context>
    <name>suffuse::UnderlaySection</name>
    <message>
        <source>Add…</source>
        <translation>Añadir…</translation>
    </message>
    <message>
        <source>A picture to paint over. It shows on the canvas only, never in what is exported.</source>
        <translation>Una imagen sobre la que pintar. Solo se muestra en el lienzo, nunca en lo que se exporta.</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>Calco</translation>
    </message>
    <message>
        <source>Show the underlay</source>
        <translation>Mostrar el calco</translation>
    </message>
    <message>
        <source>Take the underlay out of the painting</source>
        <translation>Quitar el calco de la obra</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>How strongly the underlay shows.</source>
        <translation>Con qué intensidad se muestra el calco.</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge of the underlay</source>
        <translation>Borde izquierdo del calco</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge of the underlay</source>
        <translation>Borde superior del calco</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>Width of the underlay</source>
        <translation>Anchura del calco</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Height of the underlay</source>
        <translation>Altura del calco</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Keep the proportions of width and height</source>
        <translation>Mantener las proporciones de anchura y altura</translation>
    </message>
    <message>
        <source>Fit to Canvas</source>
        <translation>Encajar en el lienzo</translation>
    </message>
    <message>
        <source>In the middle of the canvas, as large as it goes</source>
        <translation>En el centro del lienzo, lo más grande posible</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>Reemplazar…</translation>
    </message>
    <message>
        <source>Another picture in its place</source>
        <translation>Otra imagen en su lugar</translation>
    </message>
    <message>
        <source>Import underlay</source>
        <translation>Importar calco</translation>
    </message>
</context>
<context>
    <name>suffuse::ValueCard</name>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>From one visible edge of the paint to the other, at its widest, as it is now</source>
        <translation>De un borde visible de la pintura al otro, donde es más ancha, tal como está ahora</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Todo</translation>
    </message>
    <message>
        <source>All that is selected</source>
        <translation>Todo lo seleccionado</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segmento</translation>
    </message>
    <message>
        <source>The segment under the pointer alone</source>
        <translation>Solo el segmento bajo el puntero</translation>
    </message>
    <message>
        <source>Change width</source>
        <translation>Cambiar anchura</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln trazo</numerusform>
            <numerusform>%Ln trazos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, segment %2</source>
        <translation>%1, segmento %2</translation>
    </message>
</context>
<context>
    <name>suffuse::ShapeTool</name>
    <message>
        <source>Drag from the middle to a corner. Shift: steps of 15°. Return: as the last one.</source>
        <translation>Arrastrar del centro a una esquina. Mayús: pasos de 15°. Intro: como la última.</translation>
    </message>
    <message>
        <source>Drag from corner to corner. Shift: even sides. Ctrl: from the middle. Return: as the last one.</source>
        <translation>Arrastrar de esquina a esquina. Mayús: lados iguales. Ctrl: desde el centro. Intro: como la última.</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectángulo</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Elipse</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polígono</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Estrella</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>Qué se dibuja</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Radio de las esquinas</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Esquinas</translation>
    </message>
    <message>
        <source>Radius of the corners; half of the shorter side is the most</source>
        <translation>Radio de las esquinas; la mitad del lado más corto es el máximo</translation>
    </message>
    <message>
        <source>How many corners a polygon, or tips a star has</source>
        <translation>Cuántas esquinas tiene un polígono, o puntas una estrella</translation>
    </message>
    <message>
        <source>Inner</source>
        <translation>Interior</translation>
    </message>
    <message>
        <source>Radius of the inner corners, as a share of that of the tips</source>
        <translation>Radio de las esquinas interiores, como parte del de las puntas</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Redondeo</translation>
    </message>
    <message>
        <source>How much of each side is round</source>
        <translation>Cuánto de cada lado es redondo</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>Where the arc begins, clockwise from the right</source>
        <translation>Dónde empieza el arco, en sentido horario desde la derecha</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Arco</translation>
    </message>
    <message>
        <source>How far the arc goes round; 360° is the whole ellipse</source>
        <translation>Hasta dónde llega el arco; 360° es la elipse entera</translation>
    </message>
    <message>
        <source>Pie</source>
        <translation>Sector</translation>
    </message>
    <message>
        <source>An arc is closed through the middle; else by a straight line</source>
        <translation>Un arco se cierra por el centro; si no, con una línea recta</translation>
    </message>
</context>
<context>
    <name>suffuse::FillSection</name>
    <message>
        <source>How fast the fill spreads: the spread grows with the root of D times time. 0 keeps its edge crisp at any zoom.</source>
        <translation>Con qué rapidez se expande el relleno: la expansión crece con la raíz de D por el tiempo. 0 mantiene su borde nítido con cualquier zoom.</translation>
    </message>
    <message>
        <source>Density ρ</source>
        <translation>Densidad ρ</translation>
    </message>
    <message>
        <source>Density ρ deep within the fill. On its outline it is half of that, so that with 1 and a threshold of ½ the paint ends there.</source>
        <translation>Densidad ρ muy dentro del relleno. En su contorno es la mitad, de modo que con 1 y un umbral de ½ la pintura termina ahí.</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Relleno</translation>
    </message>
    <message>
        <source>What the stroke encloses was wetted at once, and spreads like its paint</source>
        <translation>Lo que encierra el trazo se mojó de una vez, y se expande como su pintura</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Interior</translation>
    </message>
    <message>
        <source>All that is enclosed</source>
        <translation>Todo lo encerrado</translation>
    </message>
    <message>
        <source>Every other area</source>
        <translation>Un área sí y otra no</translation>
    </message>
    <message>
        <source>What is inside where the outline overlaps itself (nonzero and even-odd in SVG)</source>
        <translation>Qué es interior donde el contorno se solapa consigo mismo (nonzero y even-odd en SVG)</translation>
    </message>
    <message>
        <source>Change fill</source>
        <translation>Cambiar relleno</translation>
    </message>
    <message>
        <source>Remove fill</source>
        <translation>Quitar relleno</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>No es posible para todo lo seleccionado: un valor quedaría fuera del intervalo.</translation>
    </message>
</context>
<context>
    <name>suffuse::VaryDialog</name>
    <message>
        <source>Vary at Random</source>
        <translation>Variar al azar</translation>
    </message>
    <message>
        <source>Vary</source>
        <translation>Variar</translation>
    </message>
    <message>
        <source>D becomes greater by up to this, or smaller by the same factor</source>
        <translation>D aumenta hasta este factor, o disminuye por el mismo</translation>
    </message>
    <message>
        <source>φ becomes greater by up to this, or smaller by the same factor</source>
        <translation>φ aumenta hasta este factor, o disminuye por el mismo</translation>
    </message>
    <message>
        <source>t_max becomes greater by up to this, or smaller by the same factor</source>
        <translation>t_max aumenta hasta este factor, o disminuye por el mismo</translation>
    </message>
    <message>
        <source>So much more grain, or less</source>
        <translation>Cuánto más grano, o menos</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Tono</translation>
    </message>
    <message>
        <source>Colours turn by up to this angle, either way</source>
        <translation>Los colores giran hasta este ángulo, en uno u otro sentido</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>Claridad</translation>
    </message>
    <message>
        <source>Colours get lighter or darker by up to this</source>
        <translation>Los colores se aclaran u oscurecen, como máximo, en esta medida</translation>
    </message>
    <message>
        <source>So much more opaque, or less</source>
        <translation>Cuánto más opaco, o menos</translation>
    </message>
    <message>
        <source>Roll Again</source>
        <translation>Volver a sortear</translation>
    </message>
    <message>
        <source>Other random values by the same amounts</source>
        <translation>Otros valores al azar, en la misma medida</translation>
    </message>
    <message>
        <source>Each stroke</source>
        <translation>Cada trazo</translation>
    </message>
    <message>
        <source>Each segment</source>
        <translation>Cada segmento</translation>
    </message>
    <message>
        <source>Along each stroke</source>
        <translation>A lo largo de cada trazo</translation>
    </message>
    <message>
        <source>What gets a random value of its own; along a stroke values drift smoothly</source>
        <translation>Qué recibe un valor al azar propio; a lo largo de un trazo, los valores derivan suavemente</translation>
    </message>
    <message>
        <source>Of its own</source>
        <translation>Por separado</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Over this length along a stroke values become others</source>
        <translation>En esta longitud a lo largo de un trazo, los valores pasan a ser otros</translation>
    </message>
</context>
<context>
    <name>suffuse::WishFields</name>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>What is painted onto the segments</source>
        <translation>Qué se pinta en los segmentos</translation>
    </message>
    <message>
        <source>Towards a value, or from the value that each segment has</source>
        <translation>Hacia un valor, o a partir del valor que tiene cada segmento</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>What a segment has when it got all of it</source>
        <translation>Lo que tiene un segmento cuando lo ha recibido todo</translation>
    </message>
    <message>
        <source>set to</source>
        <translation>fijar en</translation>
    </message>
    <message>
        <source>multiply by</source>
        <translation>multiplicar por</translation>
    </message>
    <message>
        <source>add</source>
        <translation>sumar</translation>
    </message>
    <message>
        <source>the current colour</source>
        <translation>el color actual</translation>
    </message>
</context>
<context>
    <name>suffuse::GradientRows</name>
    <message>
        <source>Gradient</source>
        <translation>Degradado</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>The fill&apos;s colour fades from left to right. The Segments tool drags the ends.</source>
        <translation>El color del relleno se degrada de izquierda a derecha. La herramienta Segmentos arrastra los extremos.</translation>
    </message>
    <message>
        <source>Add gradient</source>
        <translation>Añadir degradado</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>Invertir</translation>
    </message>
    <message>
        <source>The two colours change places</source>
        <translation>Los dos colores cambian de sitio</translation>
    </message>
    <message>
        <source>Swap colours of gradient</source>
        <translation>Intercambiar colores del degradado</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>The fill has its first colour everywhere</source>
        <translation>El relleno tiene su primer color en todas partes</translation>
    </message>
    <message>
        <source>Remove gradient</source>
        <translation>Quitar degradado</translation>
    </message>
    <message>
        <source>The second colour of the gradient</source>
        <translation>El segundo color del degradado</translation>
    </message>
    <message>
        <source>Change gradient</source>
        <translation>Cambiar degradado</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>No es posible para todo lo seleccionado: un valor quedaría fuera del intervalo.</translation>
    </message>
</context>
<context>
    <name>ColourPicker</name>
    <message>
        <source>Beside the canvas there is no paint to take a colour from, unless paint beyond the canvas is shown.</source>
        <translation>Fuera del lienzo no hay pintura de la que tomar un color, a menos que se muestre la pintura fuera del lienzo.</translation>
    </message>
</context>
<context>
    <name>GradientHandles</name>
    <message>
        <source>Drag an end of the gradient. Ctrl: steps of 15°. Click it, and colours are for it.</source>
        <translation>Arrastrar un extremo del degradado. Ctrl: pasos de 15°. Con un clic en él, los colores son para él.</translation>
    </message>
    <message>
        <source>Move gradient</source>
        <translation>Mover degradado</translation>
    </message>
</context>
<context>
    <name>suffuse::PenTool</name>
    <message>
        <source>Click: corner. Drag: curve, Alt: one handle alone. First node: close. Return: end. Backspace: one back.</source>
        <translation>Clic: esquina. Arrastrar: curva; Alt: un solo tirador. Primer nodo: cerrar. Intro: terminar. Retroceso: uno atrás.</translation>
    </message>
    <message>
        <source>Click or drag to go on with the selected stroke from its end.</source>
        <translation>Clic o arrastrar para continuar el trazo seleccionado desde su final.</translation>
    </message>
    <message>
        <source>Click for corners, drag for curves. Shift: steps of 15°. An end of a selected stroke: go on with it.</source>
        <translation>Clic: esquinas; arrastrar: curvas. Mayús: pasos de 15°. Un extremo de un trazo seleccionado: continuarlo.</translation>
    </message>
    <message>
        <source>Extend outline</source>
        <translation>Prolongar contorno</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contorno</translation>
    </message>
</context>
<context>
    <name>suffuse::LassoFillTool</name>
    <message>
        <source>Click: straight line. First point, double click or Return: close. Shift: steps of 15°.</source>
        <translation>Clic: línea recta. Primer punto, doble clic o Intro: cerrar. Mayús: pasos de 15°.</translation>
    </message>
    <message>
        <source>Draw around what is to be filled. Alt at the end, or clicks: straight lines.</source>
        <translation>Rodear lo que se quiere rellenar. Alt al final, o clics: líneas rectas.</translation>
    </message>
    <message>
        <source>Lasso fill</source>
        <translation>Relleno con lazo</translation>
    </message>
</context>
<context>
    <name>suffuse::BucketTool</name>
    <message>
        <source>Click: fill what the paint around that place bounds, with the brush in hand.</source>
        <translation>Clic: rellenar lo que delimita la pintura en torno a ese punto, con el pincel en uso.</translation>
    </message>
    <message>
        <source>Over all strokes</source>
        <translation>Sobre todos los trazos</translation>
    </message>
    <message>
        <source>Under all strokes</source>
        <translation>Bajo todos los trazos</translation>
    </message>
    <message>
        <source>Where the fill lies</source>
        <translation>Dónde queda el relleno</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>By how much colours may differ from that under the pointer</source>
        <translation>Cuánto pueden diferir los colores del que hay bajo el puntero</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Hueco</translation>
    </message>
    <message>
        <source>Openings of the bounds that are narrower are closed</source>
        <translation>Se cierran las aberturas de los límites más estrechas que esto</translation>
    </message>
    <message>
        <source>Grow by</source>
        <translation>Crecer</translation>
    </message>
    <message>
        <source>How far the fill reaches under its bounds</source>
        <translation>Hasta dónde llega el relleno bajo sus límites</translation>
    </message>
    <message>
        <source>Only what lies on the canvas is filled.</source>
        <translation>Solo se rellena lo que está en el lienzo.</translation>
    </message>
    <message>
        <source>There is nothing to fill here.</source>
        <translation>Aquí no hay nada que rellenar.</translation>
    </message>
    <message>
        <source>Bucket fill</source>
        <translation>Relleno con cubo</translation>
    </message>
    <message>
        <source>Looking for what the paint bounds there. Esc gives it up.</source>
        <translation>Buscando lo que delimita ahí la pintura. Esc lo cancela.</translation>
    </message>
    <message>
        <source>The painting has changed meanwhile: nothing was filled.</source>
        <translation>Entretanto la obra ha cambiado: no se ha rellenado nada.</translation>
    </message>
</context>
<context>
    <name>suffuse::TextEntry</name>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
</context>
<context>
    <name>suffuse::TextTool</name>
    <message>
        <source>Something in this text is locked: unlock it to change the text.</source>
        <translation>Algo en este texto está bloqueado: desbloquéelo para cambiar el texto.</translation>
    </message>
    <message>
        <source>The font “%1” is not installed here, so these letters stay as they are. Choose another one above, or type on: new letters are those of a font like it.</source>
        <translation>La fuente «%1» no está instalada aquí, así que estas letras se quedan como están. Elija otra arriba o siga escribiendo: las letras nuevas son de una fuente parecida.</translation>
    </message>
    <message>
        <source>Type. Return: a new line. Esc or a click elsewhere: done.</source>
        <translation>Escribir. Intro: línea nueva. Esc o un clic en otra parte: terminar.</translation>
    </message>
    <message>
        <source>Click or Return: type a text, or in the text that is there.</source>
        <translation>Clic o Intro: escribir un texto, o en el texto que ya está.</translation>
    </message>
</context>
<context>
    <name>suffuse::TextRow</name>
    <message>
        <source>Font</source>
        <translation>Fuente</translation>
    </message>
    <message>
        <source>Font: it is not installed here, and another one stands in</source>
        <translation>Fuente: no está instalada aquí, y otra la sustituye</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Fina</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Ligera</translation>
    </message>
    <message>
        <source>Regular</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Semibold</source>
        <translation>Seminegrita</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>Negrita</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Negra</translation>
    </message>
    <message>
        <source>How strong the letters are</source>
        <translation>Qué grosor tienen las letras</translation>
    </message>
    <message>
        <source>Italic</source>
        <translation>Cursiva</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>The em of the font</source>
        <translation>El cuadratín de la fuente</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espaciado</translation>
    </message>
    <message>
        <source>Room that is added between letters, of the size</source>
        <translation>Espacio que se añade entre letras, respecto al tamaño</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Líneas</translation>
    </message>
    <message>
        <source>From one line to the next, of the size</source>
        <translation>De una línea a la siguiente, respecto al tamaño</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centro</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Where lines lie: they begin at the text&apos;s place, are centred on it, or end there</source>
        <translation>Dónde quedan las líneas: empiezan en el lugar del texto, se centran en él o terminan ahí</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Vertical</translation>
    </message>
    <message>
        <source>Lines run from top to bottom, and follow each other from right to left</source>
        <translation>Las líneas van de arriba abajo y se suceden de derecha a izquierda</translation>
    </message>
    <message>
        <source>On Selected Stroke</source>
        <translation>En el trazo seleccionado</translation>
    </message>
    <message>
        <source>Set the text along the selected stroke, which it follows from then on</source>
        <translation>Poner el texto a lo largo del trazo seleccionado, al que seguirá desde entonces</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>Recto</translation>
    </message>
    <message>
        <source>Take the text off its curve</source>
        <translation>Quitar el texto de su curva</translation>
    </message>
</context>
<context>
    <name>suffuse::TextValues</name>
    <message>
        <source>Change text</source>
        <translation>Cambiar texto</translation>
    </message>
</context>
<context>
    <name>suffuse::BlendMode</name>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Multiplicar</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Pantalla</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Superponer</translation>
    </message>
    <message>
        <source>Darken</source>
        <translation>Oscurecer</translation>
    </message>
    <message>
        <source>Lighten</source>
        <translation>Aclarar</translation>
    </message>
    <message>
        <source>Colour Dodge</source>
        <translation>Sobreexponer color</translation>
    </message>
    <message>
        <source>Colour Burn</source>
        <translation>Subexponer color</translation>
    </message>
    <message>
        <source>Hard Light</source>
        <translation>Luz dura</translation>
    </message>
    <message>
        <source>Soft Light</source>
        <translation>Luz suave</translation>
    </message>
    <message>
        <source>Difference</source>
        <comment>blend mode</comment>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>Exclusion</source>
        <comment>blend mode</comment>
        <translation>Exclusión</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Tono</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturación</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Luminosity</source>
        <translation>Luminosidad</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Suma</translation>
    </message>
    <message>
        <source>Mask Below</source>
        <translation>Enmascarar lo de abajo</translation>
    </message>
    <message>
        <source>Erase Below</source>
        <translation>Borrar lo de abajo</translation>
    </message>
    <message>
        <source>Clip to Below</source>
        <translation>Recortar a lo de abajo</translation>
    </message>
    <message>
        <source>The group covers what lies below.</source>
        <translation>El grupo cubre lo que hay debajo.</translation>
    </message>
    <message>
        <source>Darkens, as glazes and shadows do; white changes nothing.</source>
        <translation>Oscurece, como las veladuras y las sombras; el blanco no cambia nada.</translation>
    </message>
    <message>
        <source>Lightens, as lights do that fall on one place; black changes nothing.</source>
        <translation>Aclara, como luces que caen en un mismo lugar; el negro no cambia nada.</translation>
    </message>
    <message>
        <source>Multiplies where it is dark below, and screens where it is light there.</source>
        <translation>Multiplica donde lo de abajo es oscuro, y aplica Pantalla donde es claro.</translation>
    </message>
    <message>
        <source>Of each channel the darker value stays.</source>
        <translation>De cada canal queda el valor más oscuro.</translation>
    </message>
    <message>
        <source>Of each channel the lighter value stays.</source>
        <translation>De cada canal queda el valor más claro.</translation>
    </message>
    <message>
        <source>Brightens what lies below, strongly where the group is light.</source>
        <translation>Aviva lo que hay debajo, con fuerza donde el grupo es claro.</translation>
    </message>
    <message>
        <source>Deepens what lies below, strongly where the group is dark.</source>
        <translation>Intensifica lo que hay debajo, con fuerza donde el grupo es oscuro.</translation>
    </message>
    <message>
        <source>Multiplies where the group is dark, and screens where it is light.</source>
        <translation>Multiplica donde el grupo es oscuro, y aplica Pantalla donde es claro.</translation>
    </message>
    <message>
        <source>Darkens or lightens gently, as a diffuse light does.</source>
        <translation>Oscurece o aclara con suavidad, como una luz difusa.</translation>
    </message>
    <message>
        <source>How far both are apart; white inverts what lies below.</source>
        <translation>Cuánto distan ambos; el blanco invierte lo que hay debajo.</translation>
    </message>
    <message>
        <source>As Difference, with less contrast.</source>
        <translation>Como Diferencia, con menos contraste.</translation>
    </message>
    <message>
        <source>The hue of the group, with saturation and luminosity of what lies below.</source>
        <translation>El tono del grupo, con la saturación y la luminosidad de lo que hay debajo.</translation>
    </message>
    <message>
        <source>The saturation of the group, with hue and luminosity of what lies below.</source>
        <translation>La saturación del grupo, con el tono y la luminosidad de lo que hay debajo.</translation>
    </message>
    <message>
        <source>Hue and saturation of the group, with the luminosity of what lies below: for tinting.</source>
        <translation>Tono y saturación del grupo, con la luminosidad de lo que hay debajo: para teñir.</translation>
    </message>
    <message>
        <source>The luminosity of the group, with hue and saturation of what lies below.</source>
        <translation>La luminosidad del grupo, con el tono y la saturación de lo que hay debajo.</translation>
    </message>
    <message>
        <source>The sum of both, for glows (plus, linear dodge).</source>
        <translation>La suma de ambos, para resplandores (plus, sobreexposición lineal).</translation>
    </message>
    <message>
        <source>The group is not seen itself: what lies below stays where the group covers, and goes elsewhere (destination-in).</source>
        <translation>El grupo en sí no se ve: lo que hay debajo permanece donde el grupo cubre y desaparece en lo demás (destination-in).</translation>
    </message>
    <message>
        <source>The group is not seen itself: it takes away what lies below where it covers (destination-out).</source>
        <translation>El grupo en sí no se ve: quita lo que hay debajo donde cubre (destination-out).</translation>
    </message>
    <message>
        <source>The group is seen only where paint lies below it: for shading a shape without leaving it (source-atop).</source>
        <translation>El grupo solo se ve donde hay pintura debajo: para sombrear una forma sin salirse de ella (source-atop).</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupSection</name>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupos</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>How strongly the group shows. Below 100 % it fades as a whole: strokes that overlap in it do not show through each other.</source>
        <translation>Con qué intensidad se muestra el grupo. Por debajo de 100 % se atenúa como conjunto: los trazos que se solapan en él no se transparentan unos a otros.</translation>
    </message>
    <message>
        <source>Change group opacity</source>
        <translation>Cambiar opacidad del grupo</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>No es posible para todo lo seleccionado: un valor quedaría fuera del intervalo.</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>Change group mode</source>
        <translation>Cambiar modo del grupo</translation>
    </message>
    <message>
        <source>Mix by itself</source>
        <translation>Mezclar por separado</translation>
    </message>
    <message>
        <source>Mix group by itself</source>
        <translation>Mezclar grupo por separado</translation>
    </message>
    <message>
        <source>Mix group with what lies below</source>
        <translation>Mezclar grupo con lo que hay debajo</translation>
    </message>
    <message>
        <source>How the group&apos;s picture is put on what lies below. Any mode but Normal has its strokes mix by themselves first.</source>
        <translation>Cómo se pone la imagen del grupo sobre lo que hay debajo. Con cualquier modo salvo Normal, sus trazos se mezclan antes por separado.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>the mode that is chosen, and what it does</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The group&apos;s strokes mix among themselves, and their picture is put on what lies below. Otherwise they mix with what lies below as if there were no group.</source>
        <translation>Los trazos del grupo se mezclan entre sí, y su imagen se pone sobre lo que hay debajo. Si no, se mezclan con lo que hay debajo como si no hubiera grupo.</translation>
    </message>
    <message>
        <source>Clip to below</source>
        <translation>Recortar a lo de abajo</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Máscara</translation>
    </message>
    <message>
        <source>Wash</source>
        <translation>Aguada</translation>
    </message>
    <message>
        <source>The group is seen only where the next thing below it in the same group is: for shading a shape without leaving it.</source>
        <translation>El grupo solo se ve donde está lo siguiente por debajo en el mismo grupo: para sombrear una forma sin salirse de ella.</translation>
    </message>
    <message>
        <source>The group is not seen itself; what else is in the same group is seen only where it has paint.</source>
        <translation>El grupo en sí no se ve; lo demás del mismo grupo solo se ve donde este tiene pintura.</translation>
    </message>
    <message>
        <source>All strokes of the group are one, laid wet into wet: their densities add up, with one style and one mixing. Filled strokes, hidden ones and those of a mask within it stay by themselves.</source>
        <translation>Todos los trazos del grupo son uno solo, aplicado húmedo sobre húmedo: sus densidades se suman, con un solo estilo y una sola mezcla. Los trazos rellenos, los ocultos y los de una máscara que contenga quedan aparte.</translation>
    </message>
    <message>
        <source>There is nothing below it to clip to.</source>
        <translation>No hay nada debajo a lo que recortarlo.</translation>
    </message>
    <message>
        <source>There is nothing beside it to mask.</source>
        <translation>No hay nada al lado que enmascarar.</translation>
    </message>
    <message>
        <source>It is in a wash already.</source>
        <translation>Ya está en una aguada.</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Marca</translation>
    </message>
    <message>
        <source>A colour that marks the group for you, in lists. It is not seen in the picture.</source>
        <translation>Un color que marca el grupo para usted, en las listas. No se ve en la imagen.</translation>
    </message>
    <message>
        <source>Mark group</source>
        <translation>Marcar grupo</translation>
    </message>
    <message>
        <source>The group mixes by itself in any case: by its opacity or its mode, or since it is clipped or a mask.</source>
        <translation>El grupo se mezcla por separado en cualquier caso: por su opacidad o su modo, o porque está recortado o es una máscara.</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Borrador</translation>
    </message>
    <message>
        <source>The group is seen here, and left out of pictures and films that are exported: for sketches and pictures to paint over.</source>
        <translation>El grupo se ve aquí y se omite en las imágenes y películas que se exportan: para bocetos e imágenes sobre las que pintar.</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupTag</name>
    <message>
        <source>None</source>
        <comment>mark of a group</comment>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Red</source>
        <comment>mark of a group</comment>
        <translation>Rojo</translation>
    </message>
    <message>
        <source>Orange</source>
        <comment>mark of a group</comment>
        <translation>Naranja</translation>
    </message>
    <message>
        <source>Yellow</source>
        <comment>mark of a group</comment>
        <translation>Amarillo</translation>
    </message>
    <message>
        <source>Green</source>
        <comment>mark of a group</comment>
        <translation>Verde</translation>
    </message>
    <message>
        <source>Blue</source>
        <comment>mark of a group</comment>
        <translation>Azul</translation>
    </message>
    <message>
        <source>Violet</source>
        <comment>mark of a group</comment>
        <translation>Violeta</translation>
    </message>
    <message>
        <source>Brown</source>
        <comment>mark of a group</comment>
        <translation>Marrón</translation>
    </message>
    <message>
        <source>Grey</source>
        <comment>mark of a group</comment>
        <translation>Gris</translation>
    </message>
</context>
<context>
    <name>ScenePicture</name>
    <message>
        <source>%1: the linked picture is missing or has changed. Put it back, or link it anew in the Inspector.</source>
        <translation>%1: la imagen vinculada falta o ha cambiado. Vuelva a ponerla en su sitio o vincúlela de nuevo en el Inspector.</translation>
    </message>
    <message>
        <source>the image of a picture is missing</source>
        <translation>falta la imagen</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>imagen</translation>
    </message>
</context>
<context>
    <name>LayeredFile</name>
    <message>
        <source>%1: Photoshop files have at most 2 GB. Choose a smaller size, or OpenRaster.</source>
        <translation>%1: los archivos de Photoshop ocupan como máximo 2 GB. Elija un tamaño menor, u OpenRaster.</translation>
    </message>
    <message>
        <source>%1: Photoshop files have at most %2 pixels a side. Choose a smaller size, or OpenRaster.</source>
        <translation>%1: los archivos de Photoshop tienen como máximo %2 píxeles por lado. Elija un tamaño menor, u OpenRaster.</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Trazos</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Grupo %1</translation>
    </message>
    <message>
        <source>stopped; nothing was written</source>
        <translation>detenido; no se ha escrito nada</translation>
    </message>
    <message>
        <source>The file could not be packed.</source>
        <translation>No se ha podido comprimir el archivo.</translation>
    </message>
</context>
<context>
    <name>ImageLayer</name>
    <message>
        <source>%1: the pictures of a painting may have %2 million pixels together, and this one would be too many. Scale it down, or remove another one.</source>
        <translation>%1: las imágenes de una obra pueden tener %2 millones de píxeles en total, y con esta serían demasiados. Redúzcala o quite otra.</translation>
    </message>
    <message>
        <source>Import picture</source>
        <translation>Importar imagen</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>The picture of the clipboard cannot be read.</source>
        <translation>No se puede leer la imagen del portapapeles.</translation>
    </message>
    <message>
        <source>Paste picture</source>
        <translation>Pegar imagen</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>Calco</translation>
    </message>
    <message>
        <source>Underlay to layer</source>
        <translation>Calco a capa</translation>
    </message>
    <message>
        <source>Link picture</source>
        <translation>Vincular imagen</translation>
    </message>
    <message>
        <source>Embed picture</source>
        <translation>Incrustar imagen</translation>
    </message>
    <message>
        <source>Reset proportions</source>
        <translation>Restablecer proporciones</translation>
    </message>
</context>
<context>
    <name>suffuse::PictureSection</name>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Linked to a file</source>
        <translation>Vinculada a un archivo</translation>
    </message>
    <message>
        <source>The painting names the picture&apos;s file, and does not hold the picture itself. Otherwise the picture is in the painting, whatever becomes of the file.</source>
        <translation>La obra nombra el archivo de la imagen, y no contiene la imagen en sí. Si no, la imagen está en la obra, pase lo que pase con el archivo.</translation>
    </message>
    <message>
        <source>Relink…</source>
        <translation>Volver a vincular…</translation>
    </message>
    <message>
        <source>Another file, or the same one where it lies now, in the picture&apos;s place</source>
        <translation>Otro archivo, o el mismo donde está ahora, en lugar de la imagen</translation>
    </message>
    <message>
        <source>Reset Proportions</source>
        <translation>Restablecer proporciones</translation>
    </message>
    <message>
        <source>As high and wide as its pixels ask for: its top left corner, its direction and its width stay.</source>
        <translation>Tan alta y ancha como piden sus píxeles: se mantienen su esquina superior izquierda, su dirección y su anchura.</translation>
    </message>
    <message>
        <source>Link picture</source>
        <translation>Vincular imagen</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 píxeles</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s)</source>
        <translation>
            <numerusform>%n imagen</numerusform>
            <numerusform>%n imágenes</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is missing or has changed, and is not seen.</source>
        <translation>%1 falta o ha cambiado, y no se ve.</translation>
    </message>
    <message>
        <source>A picture is missing, and is not seen.</source>
        <translation>Falta una imagen, y no se ve.</translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message>
        <source>interrupted</source>
        <translation>interrumpido</translation>
    </message>
    <message>
        <source>interrupted; nothing was written</source>
        <translation>interrumpido; no se ha escrito nada</translation>
    </message>
    <message>
        <source>the sheet is too large for a picture with a pixel a unit</source>
        <translation>la hoja es demasiado grande para una imagen con un píxel por unidad</translation>
    </message>
    <message numerus="yes">
        <source>SVG has no groups that erase what lies below: %n group(s) became plain.</source>
        <translation>
            <numerusform>SVG no tiene grupos que borren lo que hay debajo: %n grupo ha pasado a ser normal.</numerusform>
            <numerusform>SVG no tiene grupos que borren lo que hay debajo: %n grupos han pasado a ser normales.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) are left out, since nothing of them is covered enough to have a path.</source>
        <translation>
            <numerusform>Se omite %n trazo, porque nada de él cubre lo bastante para tener un trayecto.</numerusform>
            <numerusform>Se omiten %n trazos, porque nada de ellos cubre lo bastante para tener un trayecto.</numerusform>
        </translation>
    </message>
    <message>
        <source>The drawing differs from the picture by at most %1 of 255, by %2 on average.</source>
        <translation>El dibujo difiere de la imagen como máximo %1 de 255, y %2 de media.</translation>
    </message>
    <message>
        <source>%1: would have %2 MB once it is unpacked, and could not be opened again. Choose fewer bands, or the ending .svg.</source>
        <translation>%1: ocuparía %2 MB una vez descomprimido, y no se podría volver a abrir. Elija menos bandas, o la terminación .svg.</translation>
    </message>
    <message numerus="yes">
        <source>PDF has no groups that erase what lies below, or add to it: %n group(s) became plain.</source>
        <translation>
            <numerusform>PDF no tiene grupos que borren lo que hay debajo, o se sumen a ello: %n grupo ha pasado a ser normal.</numerusform>
            <numerusform>PDF no tiene grupos que borren lo que hay debajo, o se sumen a ello: %n grupos han pasado a ser normales.</numerusform>
        </translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Contornos</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingDialog</name>
    <message>
        <source>One path for each stroke, where it is covered by half: for plotters, cutters, logos.</source>
        <translation>Un trayecto por trazo, donde cubre a medias: para trazadores, cortadoras y logotipos.</translation>
    </message>
    <message>
        <source>Contours within each other, as opaque as the paint. They look like the painting at any zoom.</source>
        <translation>Contornos unos dentro de otros, tan opacos como la pintura. Se ven como la obra con cualquier zoom.</translation>
    </message>
    <message>
        <source>The exact picture, a pixel a unit, and over it the outlines without paint, to select and name strokes by.</source>
        <translation>La imagen exacta, un píxel por unidad, y sobre ella los contornos sin pintar, con los que seleccionar y nombrar trazos.</translation>
    </message>
    <message>
        <source>Export Drawing</source>
        <translation>Exportar dibujo</translation>
    </message>
    <message>
        <source>The ending chooses the format: svg, svgz, which is packed, or pdf.</source>
        <translation>La terminación elige el formato: svg, svgz, que va comprimido, o pdf.</translation>
    </message>
    <message>
        <source>Bands</source>
        <translation>Bandas</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Contornos</translation>
    </message>
    <message>
        <source>Picture and outlines</source>
        <translation>Imagen y contornos</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>What of the painting becomes paths</source>
        <translation>Qué parte de la obra se convierte en trayectos</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pasos</translation>
    </message>
    <message>
        <source>How many bands full opacity is drawn in. More of them are smoother, and make a larger file.</source>
        <translation>En cuántas bandas se dibuja la opacidad total. Más bandas son más suaves, y el archivo es mayor.</translation>
    </message>
    <message>
        <source>Of red, green and blue, over the sheet, with a pixel a unit</source>
        <translation>De rojo, verde y azul, en toda la hoja, con un píxel por unidad</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>Comparing with the picture…</source>
        <translation>Comparando con la imagen…</translation>
    </message>
    <message>
        <source>It is exported as soon as it is compared with the picture.</source>
        <translation>Se exporta en cuanto se haya comparado con la imagen.</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Desconocido</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>Dibujos</translation>
    </message>
    <message>
        <source>“%1” has no ending of a drawing. Choose one of: %2.</source>
        <translation>«%1» no tiene la terminación de un dibujo. Elija una de: %2.</translation>
    </message>
    <message>
        <source>As large as the sheet</source>
        <translation>Tan grande como la hoja</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>Of a PDF: the sheet fits into the page, in its middle. By itself it is as large as on paper or, where that is not said, has 96 units an inch.</source>
        <translation>De un PDF: la hoja cabe en la página, en su centro. Por sí sola es tan grande como en papel o, si no se dice, tiene 96 unidades por pulgada.</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingJob</name>
    <message>
        <source>The drawing does not fit into memory.</source>
        <translation>El dibujo no cabe en la memoria.</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesView</name>
    <message numerus="yes">
        <source>%Ln row(s)</source>
        <translation>
            <numerusform>%Ln fila</numerusform>
            <numerusform>%Ln filas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ColourProfile</name>
    <message>
        <source>it is no ICC profile of RGB, grey or CMYK</source>
        <translation>no es un perfil ICC de RGB, gris o CMYK</translation>
    </message>
    <message>
        <source>%1: cannot be read, or is too large</source>
        <translation>%1: no se puede leer, o es demasiado grande</translation>
    </message>
</context>
<context>
    <name>suffuse::Proofing</name>
    <message>
        <source>Profile of the Soft Proof</source>
        <translation>Perfil de la prueba de color</translation>
    </message>
    <message>
        <source>Colours not converted</source>
        <translation>Colores sin convertir</translation>
    </message>
    <message>
        <source>Proof: %1</source>
        <translation>Prueba: %1</translation>
    </message>
</context>
<context>
    <name>ChooseProfile</name>
    <message>
        <source>Colour profiles</source>
        <translation>Perfiles de color</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourPage</name>
    <message>
        <source>That of the system</source>
        <translation>El del sistema</translation>
    </message>
    <message>
        <source>None (sRGB)</source>
        <translation>Ninguno (sRGB)</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>De un archivo</translation>
    </message>
    <message>
        <source>Screen profile</source>
        <translation>Perfil de la pantalla</translation>
    </message>
    <message>
        <source>What the screen makes of its numbers. The canvas is converted to it, so that colours look as they were meant.</source>
        <translation>Lo que hace la pantalla con sus números. El lienzo se convierte a él, para que los colores se vean como se pensaron.</translation>
    </message>
    <message>
        <source>Screen profile file</source>
        <translation>Archivo del perfil de la pantalla</translation>
    </message>
    <message>
        <source>Chooses the ICC profile that was measured for this screen</source>
        <translation>Elige el perfil ICC que se midió para esta pantalla</translation>
    </message>
    <message>
        <source>Soft proof</source>
        <translation>Prueba de color</translation>
    </message>
    <message>
        <source>Chooses the ICC profile of a press or a printer. View ▸ Soft Proof shows the colours that are left there.</source>
        <translation>Elige el perfil ICC de una imprenta o una impresora. Ver ▸ Prueba de color muestra los colores que quedan en ella.</translation>
    </message>
    <message>
        <source>Perceptual</source>
        <translation>Perceptual</translation>
    </message>
    <message>
        <source>Relative colorimetric</source>
        <translation>Colorimétrico relativo</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturación</translation>
    </message>
    <message>
        <source>Absolute colorimetric</source>
        <translation>Colorimétrico absoluto</translation>
    </message>
    <message>
        <source>Rendering intent</source>
        <translation>Propósito de conversión</translation>
    </message>
    <message>
        <source>What becomes of colours that the device of the soft proof does not have</source>
        <translation>Qué pasa con los colores que no tiene el dispositivo de la prueba de color</translation>
    </message>
    <message>
        <source>Black point compensation</source>
        <translation>Compensación de punto negro</translation>
    </message>
    <message>
        <source>The darkest colour becomes the darkest one that the device has</source>
        <translation>El color más oscuro pasa a ser el más oscuro que tiene el dispositivo</translation>
    </message>
    <message>
        <source>Profile of the Screen</source>
        <translation>Perfil de la pantalla</translation>
    </message>
    <message>
        <source>Profile of the Soft Proof</source>
        <translation>Perfil de la prueba de color</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
</context>
<context>
    <name>suffuse::ProfileBox</name>
    <message>
        <source>The painting&apos;s profile</source>
        <translation>El perfil de la obra</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>De un archivo…</translation>
    </message>
    <message>
        <source>%1: the profile is too large to be kept in a painting. Choose a smaller one.</source>
        <translation>%1: el perfil es demasiado grande para conservarlo en una obra. Elija uno más pequeño.</translation>
    </message>
    <message>
        <source>%1: %2. Choose a profile of RGB colours.</source>
        <translation>%1: %2. Elija un perfil de colores RGB.</translation>
    </message>
    <message>
        <source>Profile of the Colours</source>
        <translation>Perfil de los colores</translation>
    </message>
</context>
<context>
    <name>suffuse::FitJob</name>
    <message>
        <source>%1: there is not enough memory to fit it.</source>
        <translation>%1: no hay memoria suficiente para ajustarla.</translation>
    </message>
</context>
<context>
    <name>FitLayer</name>
    <message>
        <source>Ground</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Trazos</translation>
    </message>
    <message>
        <source>Picture to strokes</source>
        <translation>Imagen a trazos</translation>
    </message>
    <message>
        <source>The picture was painted quickly, just before the moment that you look at. All that you painted stays as it is.</source>
        <translation>La imagen se pintó deprisa, justo antes del momento que está viendo. Todo lo que usted pintó se queda como está.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) came in, and a ground below them.</source>
        <translation>
            <numerusform>Ha llegado %Ln trazo, y un fondo debajo.</numerusform>
            <numerusform>Han llegado %Ln trazos, y un fondo debajo.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::FitView</name>
    <message>
        <source>Picture made of strokes</source>
        <translation>Imagen hecha de trazos</translation>
    </message>
    <message>
        <source>What the strokes look like. While a mouse button is held on it, the original is seen.</source>
        <translation>Cómo se ven los trazos. Mientras se mantiene pulsado sobre ella un botón del ratón, se ve el original.</translation>
    </message>
    <message>
        <source>Here the picture grows, stroke by stroke.</source>
        <translation>Aquí crece la imagen, trazo a trazo.</translation>
    </message>
</context>
<context>
    <name>suffuse::FitRows</name>
    <message>
        <source>Strokes</source>
        <translation>Trazos</translation>
    </message>
    <message>
        <source>At most so many. More of them go on with those that are there; fewer begin anew.</source>
        <translation>Como máximo, tantos. Con más se continúa a partir de los que hay; con menos se empieza de nuevo.</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Detalle</translation>
    </message>
    <message>
        <source>How much is done for each stroke. Better goes on with what is there.</source>
        <translation>Cuánto se hace por cada trazo. Con más calidad se continúa a partir de lo que hay.</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Rápido</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Bueno</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Óptimo</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Estilo</translation>
    </message>
    <message>
        <source>Of all strokes. Another one begins anew.</source>
        <translation>De todos los trazos. Con otro se empieza de nuevo.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>Each stroke its own, or a few paints, which become linked swatches</source>
        <translation>Cada trazo el suyo, o unas pocas pinturas, que pasan a ser muestras vinculadas</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todos</translation>
    </message>
    <message>
        <source>Few paints</source>
        <translation>Pocas pinturas</translation>
    </message>
    <message>
        <source>Paints</source>
        <translation>Pinturas</translation>
    </message>
    <message>
        <source>So many colours in all</source>
        <translation>Tantos colores en total</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Más</translation>
    </message>
    <message>
        <source>Widths of strokes, and the roll of the dice</source>
        <translation>Anchuras de los trazos, y la tirada de dados</translation>
    </message>
    <message>
        <source>Least width</source>
        <translation>Anchura mínima</translation>
    </message>
    <message>
        <source>No stroke is narrower; 0: as narrow as it likes</source>
        <translation>Ningún trazo es más estrecho; 0: tan estrecho como se quiera</translation>
    </message>
    <message>
        <source>Greatest width</source>
        <translation>Anchura máxima</translation>
    </message>
    <message>
        <source>No stroke is wider; 0: as wide as it likes</source>
        <translation>Ningún trazo es más ancho; 0: tan ancho como se quiera</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Another number gives other strokes, equally good ones</source>
        <translation>Otro número da otros trazos, igual de buenos</translation>
    </message>
    <message>
        <source>The greatest width is below the least one.</source>
        <translation>La anchura máxima es menor que la mínima.</translation>
    </message>
</context>
<context>
    <name>suffuse::FitDialog</name>
    <message>
        <source>far: %1 dB</source>
        <translation>lejos: %1 dB</translation>
    </message>
    <message>
        <source>roughly: %1 dB</source>
        <translation>aproximado: %1 dB</translation>
    </message>
    <message>
        <source>near: %1 dB</source>
        <translation>cerca: %1 dB</translation>
    </message>
    <message>
        <source>very near: %1 dB</source>
        <translation>muy cerca: %1 dB</translation>
    </message>
    <message>
        <source>Picture to Strokes</source>
        <translation>Imagen a trazos</translation>
    </message>
    <message>
        <source>How far it is</source>
        <translation>Cuánto se ha avanzado</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Shows the picture itself: while held, or click to switch back and forth.</source>
        <translation>Muestra la imagen en sí: mientras se mantiene pulsado, o un clic para alternar.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Which picture becomes strokes</source>
        <translation>Qué imagen se convierte en trazos</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Ninguna aún</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>Calco</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Archivo…</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>&amp;Insertar</translation>
    </message>
    <message>
        <source>Puts the strokes so far into the painting, as a layer</source>
        <translation>Pone en la obra los trazos hechos hasta ahora, como capa</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Stops the work, or goes on with it</source>
        <translation>Detiene el trabajo, o lo continúa</translation>
    </message>
    <message>
        <source>Reading the picture…</source>
        <translation>Leyendo la imagen…</translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln trazo</numerusform>
            <numerusform>%Ln trazos</numerusform>
        </translation>
    </message>
    <message>
        <source>off by %1 of 255</source>
        <translation>se aparta %1 de 255</translation>
    </message>
    <message>
        <source>Fewer Strokes</source>
        <translation>Menos trazos</translation>
    </message>
    <message>
        <source>What the strokes are to look like: as those that are there do, or as a picture of the whole sheet</source>
        <translation>Cómo se deben ver los trazos: como los que hay, o como una imagen de toda la hoja</translation>
    </message>
    <message>
        <source>As they look</source>
        <translation>Como se ven</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Reemplazar</translation>
    </message>
    <message>
        <source>Puts the strokes so far in place of the selected ones</source>
        <translation>Pone los trazos hechos hasta ahora en lugar de los seleccionados</translation>
    </message>
    <message>
        <source>Give up the strokes so far?</source>
        <translation>¿Abandonar los trazos hechos hasta ahora?</translation>
    </message>
    <message>
        <source>Replace puts them in place of the selected ones.</source>
        <translation>Reemplazar los pone en lugar de los seleccionados.</translation>
    </message>
    <message>
        <source>Insert puts them into the painting.</source>
        <translation>Insertar los pone en la obra.</translation>
    </message>
    <message>
        <source>&amp;Give Up</source>
        <translation>A&amp;bandonar</translation>
    </message>
</context>
<context>
    <name>fitting</name>
    <message>
        <source>stopped</source>
        <translation>detenido</translation>
    </message>
    <message>
        <source>%1: is black all over, so nothing counts; paint white what is to be fitted</source>
        <translation>%1: es negra por completo, así que nada cuenta; pinte de blanco lo que se deba ajustar</translation>
    </message>
    <message>
        <source>its canvas has %1 × %2 units, and the picture %3 × %4 pixels; go on with a painting that was fitted to this picture</source>
        <translation>su lienzo tiene %1 × %2 unidades, y la imagen %3 × %4 píxeles; continúe con una obra que se haya ajustado a esta imagen</translation>
    </message>
    <message>
        <source>stroke %1: %2; a fit goes on with what a fit made</source>
        <translation>trazo %1: %2; un ajuste continúa con lo que hizo un ajuste</translation>
    </message>
</context>
<context>
    <name>curves</name>
    <message>
        <source>its picture has %1 × %2 pixels; image_width and image_height must be 1 at least</source>
        <translation>su imagen tiene %1 × %2 píxeles; image_width e image_height deben ser al menos 1</translation>
    </message>
    <message>
        <source>holds no curves; there is nothing to solve</source>
        <translation>no contiene curvas; no hay nada que resolver</translation>
    </message>
</context>
<context>
    <name>refit</name>
    <message>
        <source>none of the strokes is visible and unlocked; choose others</source>
        <translation>ninguno de los trazos es visible y está sin bloquear; elija otros</translation>
    </message>
    <message>
        <source>the strokes lie beside the sheet, where nothing is seen of them</source>
        <translation>los trazos están fuera de la hoja, donde no se ve nada de ellos</translation>
    </message>
    <message>
        <source>the strokes of group “%1” mix in their own way; choose all of them that are visible, or none of them</source>
        <translation>los trazos del grupo «%1» se mezclan a su manera; elija todos los que son visibles, o ninguno</translation>
    </message>
    <message>
        <source>group “%1” is a wash, whose strokes are one; make it a group like others first</source>
        <translation>el grupo «%1» es una aguada, cuyos trazos son uno solo; conviértalo antes en un grupo como los demás</translation>
    </message>
    <message>
        <source>%1: has the shape %2 × %3, and the sheet %4 × %5; crop it to the shape of the sheet</source>
        <translation>%1: tiene la forma %2 × %3, y la hoja %4 × %5; recórtela a la forma de la hoja</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>detenido</translation>
    </message>
    <message>
        <source>the strokes are in a group that is put on the others as one picture, so no picture of the whole says how they should look; make it a group like others first</source>
        <translation>los trazos están en un grupo que se pone sobre los demás como una sola imagen, así que ninguna imagen del conjunto dice cómo se deberían ver; conviértalo antes en un grupo como los demás</translation>
    </message>
    <message>
        <source>other strokes hide the chosen ones wholly; choose others, or hide what lies above</source>
        <translation>otros trazos ocultan por completo los elegidos; elija otros, u oculte lo que hay encima</translation>
    </message>
</context>
<context>
    <name>RefitTask</name>
    <message>
        <source>There the picture is off by %1 of 255 (root mean square), %2 at most.</source>
        <translation>Ahí la imagen se aparta %1 de 255 (media cuadrática), %2 como máximo.</translation>
    </message>
    <message>
        <source>Fewer strokes</source>
        <translation>Menos trazos</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln trazo</numerusform>
            <numerusform>%Ln trazos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in place of %Ln.</source>
        <translation>
            <numerusform>en lugar de %Ln.</numerusform>
            <numerusform>en lugar de %Ln.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) that lay between them lie below now.</source>
        <translation>
            <numerusform>%Ln trazo que estaba entre ellos está ahora debajo.</numerusform>
            <numerusform>%Ln trazos que estaban entre ellos están ahora debajo.</numerusform>
        </translation>
    </message>
    <message>
        <source>That is farther than before, when it was off by %1; Undo brings the former strokes back.</source>
        <translation>Está más lejos que antes, cuando se apartaba %1; Deshacer recupera los trazos anteriores.</translation>
    </message>
</context>
<context>
    <name>Tiles</name>
    <message>
        <source>%1 What another backend draws has other bits, and is not mixed in. Start again to go on.</source>
        <translation>%1 Lo que dibuja otro motor tiene otros bits y no se mezcla. Inicie de nuevo para continuar.</translation>
    </message>
    <message>
        <source>there is not enough memory for the sheets that are drawn at once</source>
        <translation>no hay memoria suficiente para los pliegos que se dibujan de una vez</translation>
    </message>
    <message>
        <source>a tile cannot be encoded: %1</source>
        <translation>no se puede codificar una tesela: %1</translation>
    </message>
    <message>
        <source>%1: cannot be read (%2)</source>
        <translation>%1: no se puede leer (%2)</translation>
    </message>
    <message>
        <source>%1: what is there is of another picture, or of another build or backend. Remove it, or choose another name.</source>
        <translation>%1: lo que hay es de otra imagen, o de otra compilación u otro motor. Quítelo o elija otro nombre.</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Choose another folder, or change its permissions.</source>
        <translation>%1: no se puede escribir (%2). Elija otra carpeta o cambie sus permisos.</translation>
    </message>
    <message>
        <source>%1: another program is drawing the same picture. Wait until it has finished, or choose another name.</source>
        <translation>%1: otro programa está dibujando la misma imagen. Espere a que termine o elija otro nombre.</translation>
    </message>
</context>
<context>
    <name>suffuse::ManualWindow</name>
    <message>
        <source>Suffuse Manual</source>
        <translation>Manual de Suffuse</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Buscar en el manual</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Contenido</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Adelante</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>No se ha encontrado nada</translation>
    </message>
</context>
<context>
    <name>suffuse::Lesson</name>
    <message>
        <source>Paint, and change your mind</source>
        <translation>Pintar y cambiar de idea</translation>
    </message>
    <message>
        <source>Let paint spread</source>
        <translation>Dejar que la pintura se expanda</translation>
    </message>
    <message>
        <source>Work with layers</source>
        <translation>Trabajar con capas</translation>
    </message>
    <message>
        <source>Done. All of this can be changed at any time.</source>
        <translation>Hecho. Todo esto se puede cambiar en cualquier momento.</translation>
    </message>
    <message>
        <source>Press B and draw a stroke on the sheet, however you like.</source>
        <translation>Pulse B y dibuje un trazo en la hoja, como quiera.</translation>
    </message>
    <message>
        <source>Press V for the Select tool, and click the paint of your stroke.</source>
        <translation>Pulse V para la herramienta Seleccionar y haga clic en la pintura de su trazo.</translation>
    </message>
    <message>
        <source>Choose another colour in the Colour dock. It is now about what is selected.</source>
        <translation>Elija otro color en el panel Color. Ahora se refiere a lo seleccionado.</translation>
    </message>
    <message>
        <source>Take it back with Ctrl+Z.</source>
        <translation>Deshágalo con Ctrl+Z.</translation>
    </message>
    <message>
        <source>Press B and draw a stroke. Watch it spread after you let go.</source>
        <translation>Pulse B y dibuje un trazo. Observe cómo se expande después de soltar.</translation>
    </message>
    <message>
        <source>Press D: this goes to the moment when everything is dry.</source>
        <translation>Pulse D: va al momento en que todo está seco.</translation>
    </message>
    <message>
        <source>In the Inspector dock, drag the slider of Diffusion D. The dry paint spreads further, or less far.</source>
        <translation>En el panel Inspector, arrastre el deslizador de Difusión D. La pintura seca se expande más, o menos.</translation>
    </message>
    <message>
        <source>Choose Layer ▸ New Layer, or press Ctrl+Shift+N. What you paint next comes into it.</source>
        <translation>Elija Capa ▸ Nueva capa, o pulse Ctrl+Mayús+N. Lo próximo que pinte va a ella.</translation>
    </message>
    <message>
        <source>Press B and draw a stroke. The layer comes into the list with it.</source>
        <translation>Pulse B y dibuje un trazo. Con él aparece la capa en la lista.</translation>
    </message>
    <message>
        <source>In the row of the layer, drag its opacity to the left, or click its mode and choose another one.</source>
        <translation>En la fila de la capa, arrastre su opacidad a la izquierda, o haga clic en su modo y elija otro.</translation>
    </message>
</context>
<context>
    <name>suffuse::LessonCard</name>
    <message>
        <source>%1 – step %2 of %3</source>
        <translation>%1 – paso %2 de %3</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Leave the lesson</source>
        <translation>Salir de la lección</translation>
    </message>
</context>
<context>
    <name>suffuse::Sheets</name>
    <message>
        <source>Screen</source>
        <translation>Pantalla</translation>
    </message>
    <message>
        <source>%1 × %2 px</source>
        <translation>%1 × %2 px</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>%1 × %2 in</source>
        <translation>%1 × %2 in</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>Plantillas</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>Boceto</translation>
    </message>
    <message>
        <source>Full HD</source>
        <translation>Full HD</translation>
    </message>
    <message>
        <source>4K</source>
        <translation>4K</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Cuadrado</translation>
    </message>
    <message>
        <source>A5</source>
        <translation>A5</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>A3</source>
        <translation>A3</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Carta</translation>
    </message>
    <message>
        <source>Legal</source>
        <translation>Legal (EE. UU.)</translation>
    </message>
    <message>
        <source>Tabloid</source>
        <translation>Tabloide</translation>
    </message>
    <message>
        <source>Postcard</source>
        <translation>Postal</translation>
    </message>
    <message>
        <source>Watercolour sheet</source>
        <translation>Hoja de acuarela</translation>
    </message>
    <message>
        <source>Rice paper</source>
        <translation>Papel de arroz</translation>
    </message>
    <message>
        <source>Toned paper</source>
        <translation>Papel tintado</translation>
    </message>
    <message>
        <source>Night</source>
        <translation>Noche</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Lienzo</translation>
    </message>
</context>
<context>
    <name>suffuse::WelcomeDialog</name>
    <message>
        <source>Welcome to Suffuse</source>
        <translation>Le damos la bienvenida a Suffuse</translation>
    </message>
    <message>
        <source>New painting</source>
        <translation>Nueva obra</translation>
    </message>
    <message>
        <source>Other Size…</source>
        <translation>Otro tamaño…</translation>
    </message>
    <message>
        <source>Open a painting</source>
        <translation>Abrir una obra</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recientes</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Ejemplos</translation>
    </message>
    <message>
        <source>Open File…</source>
        <translation>Abrir archivo…</translation>
    </message>
    <message>
        <source>Three short lessons</source>
        <translation>Tres lecciones breves</translation>
    </message>
    <message>
        <source>Show this at the start</source>
        <translation>Mostrar esto al inicio</translation>
    </message>
    <message>
        <source>Sheets by their size. Return begins a painting on one.</source>
        <translation>Hojas por su tamaño. Intro empieza una obra en una de ellas.</translation>
    </message>
    <message>
        <source>Recent paintings and samples. Return opens one.</source>
        <translation>Obras recientes y ejemplos. Intro abre una.</translation>
    </message>
</context>
<context>
    <name>suffuse::Workspaces</name>
    <message>
        <source>Save Workspace</source>
        <translation>Guardar espacio de trabajo</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>There is a workspace “%1” already.</source>
        <translation>Ya existe un espacio de trabajo «%1».</translation>
    </message>
    <message>
        <source>It would be replaced by how the window is arranged now.</source>
        <translation>Se reemplazaría por la disposición que tiene ahora la ventana.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>The workspace “%1” was saved: View ▸ Workspaces.</source>
        <translation>Se ha guardado el espacio de trabajo «%1»: Ver ▸ Espacios de trabajo.</translation>
    </message>
    <message>
        <source>The workspace “%1” is damaged. Save it anew.</source>
        <translation>El espacio de trabajo «%1» está dañado. Guárdelo de nuevo.</translation>
    </message>
    <message>
        <source>&amp;Delete Workspace</source>
        <translation>&amp;Eliminar espacio de trabajo</translation>
    </message>
    <message>
        <source>Delete the workspace “%1”?</source>
        <translation>¿Eliminar el espacio de trabajo «%1»?</translation>
    </message>
    <message>
        <source>The window stays arranged as it is.</source>
        <translation>La ventana conserva su disposición.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
</context>
<context>
    <name>suffuse::ReferencePanel</name>
    <message>
        <source>Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>Choose a picture to look at while painting</source>
        <translation>Elegir una imagen que mirar mientras se pinta</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Encajar</translation>
    </message>
    <message>
        <source>Show all of the picture</source>
        <translation>Mostrar toda la imagen</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>A pixel of the picture is one of the screen</source>
        <translation>Un píxel de la imagen es uno de la pantalla</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Show no picture here; its file stays</source>
        <translation>No mostrar aquí ninguna imagen; su archivo se conserva</translation>
    </message>
    <message>
        <source>Open Reference Picture</source>
        <translation>Abrir imagen de referencia</translation>
    </message>
    <message>
        <source>Actual pixels</source>
        <translation>Píxeles reales</translation>
    </message>
</context>
<context>
    <name>suffuse::ReferenceView</name>
    <message>
        <source>Reference picture</source>
        <translation>Imagen de referencia</translation>
    </message>
    <message>
        <source>Arrow keys move a cross, and Return picks the colour there.</source>
        <translation>Las teclas de flecha mueven una cruz, e Intro toma el color en ella.</translation>
    </message>
    <message>
        <source>Drop a picture here to look at it while you paint, and to take colours from it.</source>
        <translation>Suelte aquí una imagen para mirarla mientras pinta y para tomar colores de ella.</translation>
    </message>
</context>
<context>
    <name>suffuse::ViewWindow</name>
    <message>
        <source>View of the painting</source>
        <translation>Vista de la obra</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>%1 · view at %2 %</source>
        <translation>%1 · vista al %2 %</translation>
    </message>
</context>
<context>
    <name>suffuse::Extensions</name>
    <message>
        <source>Programs are limited in time, memory and what they write, but not confined: install bubblewrap, and they have no network and can write nowhere else.</source>
        <translation>Los programas tienen limitados el tiempo, la memoria y lo que escriben, pero no están aislados: instale bubblewrap, y no tendrán red ni podrán escribir en otro lugar.</translation>
    </message>
    <message>
        <source>Programs are confined by bubblewrap: they have no network, unless they say that they need it, and can write in a temporary folder only.</source>
        <translation>Los programas están aislados por bubblewrap: no tienen red, a menos que digan que la necesitan, y solo pueden escribir en una carpeta temporal.</translation>
    </message>
    <message>
        <source>Programs are limited in time, memory and what they write, but not confined: bubblewrap is installed, and does not work here (%1).</source>
        <translation>Los programas tienen limitados el tiempo, la memoria y lo que escriben, pero no están aislados: bubblewrap está instalado, y no funciona aquí (%1).</translation>
    </message>
    <message>
        <source>it wrote no result</source>
        <translation>no ha escrito ningún resultado</translation>
    </message>
    <message>
        <source>its result cannot be read</source>
        <translation>su resultado no se puede leer</translation>
    </message>
    <message>
        <source>its result is no file</source>
        <translation>su resultado no es un archivo</translation>
    </message>
    <message>
        <source>its result is too large</source>
        <translation>su resultado es demasiado grande</translation>
    </message>
    <message>
        <source>its result is empty</source>
        <translation>su resultado está vacío</translation>
    </message>
    <message>
        <source>Nothing that is visible and unlocked is selected. Select strokes first.</source>
        <translation>No hay nada seleccionado que sea visible y no esté bloqueado. Seleccione antes trazos.</translation>
    </message>
    <message>
        <source>Nothing in the layer is visible and unlocked.</source>
        <translation>En la capa no hay nada que sea visible y no esté bloqueado.</translation>
    </message>
    <message>
        <source>No temporary folder can be made: %1. Set TMPDIR to a folder that can be written.</source>
        <translation>No se puede crear una carpeta temporal: %1. Asigne a TMPDIR una carpeta en la que se pueda escribir.</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Is the disk full?</source>
        <translation>%1: no se puede escribir (%2). ¿Está lleno el disco?</translation>
    </message>
    <message>
        <source>The program %1 cannot be started: %2.</source>
        <translation>No se puede iniciar el programa %1: %2.</translation>
    </message>
    <message numerus="yes">
        <source>It was ended after %n second(s), which is as long as it may take.</source>
        <translation>
            <numerusform>Se ha terminado tras %n segundo, que es lo máximo que puede tardar.</numerusform>
            <numerusform>Se ha terminado tras %n segundos, que es lo máximo que puede tardar.</numerusform>
        </translation>
    </message>
    <message>
        <source>It was ended, since it took more than %1 MB of memory.</source>
        <translation>Se ha terminado porque ocupaba más de %1 MB de memoria.</translation>
    </message>
    <message>
        <source>It was ended, since it wrote more than %1 MB.</source>
        <translation>Se ha terminado porque escribió más de %1 MB.</translation>
    </message>
    <message>
        <source>The program was killed or crashed. The painting is as it was.</source>
        <translation>El programa se ha interrumpido o ha fallado. La obra está como estaba.</translation>
    </message>
    <message>
        <source>The program failed (exit code %1). The painting is as it was.</source>
        <translation>El programa ha fallado (código de salida %1). La obra está como estaba.</translation>
    </message>
    <message>
        <source>It wrote: %1</source>
        <translation>Ha escrito: %1</translation>
    </message>
    <message>
        <source>Its result is not used, and the painting is as it was: %1.</source>
        <translation>Su resultado no se usa, y la obra está como estaba: %1.</translation>
    </message>
    <message>
        <source>%1 was not written: %2.</source>
        <translation>%1 no se ha escrito: %2.</translation>
    </message>
    <message>
        <source>a colour is red, yellow, blue and opacity, each from 0 to 1</source>
        <translation>un color es rojo, amarillo, azul y opacidad, cada uno de 0 a 1</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>indique un número</translation>
    </message>
    <message>
        <source>%1 is not in [%2, %3]</source>
        <translation>%1 no está en [%2, %3]</translation>
    </message>
    <message>
        <source>%1 is no whole number</source>
        <translation>%1 no es un número entero</translation>
    </message>
    <message>
        <source>“%1” is none of %2</source>
        <translation>«%1» no es ninguno de %2</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>indique true o false</translation>
    </message>
    <message>
        <source>give a text of at most %1 characters</source>
        <translation>indique un texto de %1 caracteres como máximo</translation>
    </message>
    <message>
        <source>choose a file</source>
        <translation>elija un archivo</translation>
    </message>
    <message>
        <source>%1: the name must end with .%2</source>
        <translation>%1: el nombre debe terminar en .%2</translation>
    </message>
    <message>
        <source>%1: there is no such file</source>
        <translation>%1: no existe ese archivo</translation>
    </message>
    <message>
        <source>%1: there is no such folder</source>
        <translation>%1: no existe esa carpeta</translation>
    </message>
    <message>
        <source>“%1” is no number</source>
        <translation>«%1» no es un número</translation>
    </message>
    <message>
        <source>“%1” is neither true nor false</source>
        <translation>«%1» no es true ni false</translation>
    </message>
    <message>
        <source>%1: cannot be read, or is larger than 1 MB</source>
        <translation>%1: no se puede leer, u ocupa más de 1 MB</translation>
    </message>
    <message>
        <source>%1: %2 has the id “%3”, too; give it another one</source>
        <translation>%1: también %2 tiene el identificador «%3»; dele otro</translation>
    </message>
    <message>
        <source>Python 3 is missing. Install python3.</source>
        <translation>Falta Python 3. Instale python3.</translation>
    </message>
    <message>
        <source>The program %1 is missing, or cannot be started. Install it.</source>
        <translation>El programa %1 falta, o no se puede iniciar. Instálelo.</translation>
    </message>
    <message>
        <source>%1 does not find the Python modules %2. Install them by packages such as python3-suffuse and python3-numpy, or by pip as docs/python.md says.</source>
        <translation>%1 no encuentra los módulos de Python %2. Instálelos con paquetes como python3-suffuse y python3-numpy, o con pip como dice docs/python.md.</translation>
    </message>
    <message>
        <source>name the program, and what it is started with</source>
        <translation>indique el programa y con qué se inicia</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>falta</translation>
    </message>
    <message>
        <source>“%1” is not “%2”</source>
        <translation>«%1» no es «%2»</translation>
    </message>
    <message>
        <source>version %1 is not known; this program reads version %2</source>
        <translation>no se conoce la versión %1; este programa lee la versión %2</translation>
    </message>
    <message>
        <source>“%1” does not look like %2</source>
        <translation>«%1» no tiene la forma de %2</translation>
    </message>
    <message>
        <source>a text has 1 to 2000 characters</source>
        <translation>un texto tiene de 1 a 2000 caracteres</translation>
    </message>
    <message>
        <source>give a text, or one for each language</source>
        <translation>indique un texto, o uno para cada idioma</translation>
    </message>
    <message>
        <source>give at most %1 texts of 1 to 4096 characters</source>
        <translation>indique como máximo %1 textos de 1 a 4096 caracteres</translation>
    </message>
    <message>
        <source>there are at most 3 submenus within each other</source>
        <translation>hay como máximo 3 submenús unos dentro de otros</translation>
    </message>
    <message>
        <source>there are at most %1 fields</source>
        <translation>hay como máximo %1 campos</translation>
    </message>
    <message>
        <source>two fields are called %1</source>
        <translation>dos campos se llaman %1</translation>
    </message>
    <message>
        <source>the field&apos;s type must stand before its default</source>
        <translation>el tipo del campo (type) debe ir antes de su valor predeterminado (default)</translation>
    </message>
    <message>
        <source>there are at most %1 choices</source>
        <translation>hay como máximo %1 opciones</translation>
    </message>
    <message>
        <source>is not above least</source>
        <translation>no es mayor que least</translation>
    </message>
    <message>
        <source>whole numbers are from -1000000000 to 1000000000</source>
        <translation>los números enteros van de -1000000000 a 1000000000</translation>
    </message>
    <message>
        <source>“%1” is no ending; give it without its dot</source>
        <translation>«%1» no es una terminación; indíquela sin el punto</translation>
    </message>
    <message>
        <source>a part of the painting was passed, so canvas, palette and underlay must stay as they are</source>
        <translation>se pasó una parte de la obra, así que el lienzo, la paleta y el calco deben quedarse como están</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>Se ha detenido.</translation>
    </message>
    <message>
        <source>It went well.</source>
        <translation>Ha ido bien.</translation>
    </message>
    <message>
        <source>The result does not fit into memory.</source>
        <translation>El resultado no cabe en la memoria.</translation>
    </message>
</context>
<context>
    <name>suffuse::ExtensionDialog</name>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Ejecutar</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 ya existe. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>What it holds now is lost.</source>
        <translation>Lo que contiene ahora se perderá.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Reemplazar</translation>
    </message>
    <message>
        <source>It was stopped. The painting is as it was.</source>
        <translation>Se ha detenido. La obra está como estaba.</translation>
    </message>
    <message>
        <source>The painting has changed meanwhile, so the result is not used. Run it again.</source>
        <translation>Entretanto la obra ha cambiado, así que el resultado no se usa. Ejecútela de nuevo.</translation>
    </message>
</context>
<context>
    <name>suffuse::ExtensionFields</name>
    <message>
        <source>&amp;Browse…</source>
        <translation>Ex&amp;aminar…</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>Elegir una carpeta y un nombre</translation>
    </message>
</context>
<context>
    <name>suffuse::ManageExtensionsDialog</name>
    <message>
        <source>Manage Extensions</source>
        <translation>Gestionar extensiones</translation>
    </message>
    <message>
        <source>Extensions</source>
        <translation>Extensiones</translation>
    </message>
    <message>
        <source>Extension</source>
        <translation>Extensión</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Origen</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>About the extension</source>
        <translation>Acerca de la extensión</translation>
    </message>
    <message>
        <source>&amp;Open Folder</source>
        <translation>&amp;Abrir carpeta</translation>
    </message>
    <message>
        <source>Your own extensions lie there, each in a folder with a manifest</source>
        <translation>Sus propias extensiones están ahí, cada una en una carpeta con un manifiesto</translation>
    </message>
    <message>
        <source>Read &amp;Again</source>
        <translation>&amp;Leer de nuevo</translation>
    </message>
    <message>
        <source>Looks for extensions anew, after files were changed</source>
        <translation>Vuelve a buscar extensiones, tras cambiar archivos</translation>
    </message>
    <message>
        <source>You</source>
        <translation>Propio</translation>
    </message>
    <message>
        <source>Suffuse</source>
        <translation>Suffuse</translation>
    </message>
    <message>
        <source>Cannot be used</source>
        <translation>No se puede usar</translation>
    </message>
    <message>
        <source>There are no extensions yet. Put a folder with a manifest into yours.</source>
        <translation>Aún no hay extensiones. Ponga una carpeta con un manifiesto en la suya.</translation>
    </message>
    <message>
        <source>It uses the network.</source>
        <translation>Usa la red.</translation>
    </message>
    <message>
        <source>The last run: %1</source>
        <translation>La última ejecución: %1</translation>
    </message>
    <message>
        <source>Your extensions lie in %1.</source>
        <translation>Sus extensiones están en %1.</translation>
    </message>
    <message>
        <source>What the chosen extension does, what is wrong with it, and what it wrote when it last ran</source>
        <translation>Qué hace la extensión elegida, qué problema tiene y qué escribió la última vez que se ejecutó</translation>
    </message>
    <message>
        <source>Those that are checked stand in the menu</source>
        <translation>Las marcadas están en el menú</translation>
    </message>
</context>
<context>
    <name>ColourWords</name>
    <message>
        <source>dark red</source>
        <translation>rojo oscuro</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rojo</translation>
    </message>
    <message>
        <source>light red</source>
        <translation>rojo claro</translation>
    </message>
    <message>
        <source>brown</source>
        <translation>marrón</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>naranja</translation>
    </message>
    <message>
        <source>light orange</source>
        <translation>naranja claro</translation>
    </message>
    <message>
        <source>olive</source>
        <translation>oliva</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>amarillo</translation>
    </message>
    <message>
        <source>light yellow</source>
        <translation>amarillo claro</translation>
    </message>
    <message>
        <source>dark yellow-green</source>
        <translation>verde amarillento oscuro</translation>
    </message>
    <message>
        <source>yellow-green</source>
        <translation>verde amarillento</translation>
    </message>
    <message>
        <source>light yellow-green</source>
        <translation>verde amarillento claro</translation>
    </message>
    <message>
        <source>dark green</source>
        <translation>verde oscuro</translation>
    </message>
    <message>
        <source>green</source>
        <translation>verde</translation>
    </message>
    <message>
        <source>light green</source>
        <translation>verde claro</translation>
    </message>
    <message>
        <source>dark turquoise</source>
        <translation>turquesa oscuro</translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation>turquesa</translation>
    </message>
    <message>
        <source>light turquoise</source>
        <translation>turquesa claro</translation>
    </message>
    <message>
        <source>dark blue</source>
        <translation>azul oscuro</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>azul</translation>
    </message>
    <message>
        <source>light blue</source>
        <translation>azul claro</translation>
    </message>
    <message>
        <source>dark violet</source>
        <translation>violeta oscuro</translation>
    </message>
    <message>
        <source>violet</source>
        <translation>violeta</translation>
    </message>
    <message>
        <source>light violet</source>
        <translation>violeta claro</translation>
    </message>
    <message>
        <source>dark magenta</source>
        <translation>magenta oscuro</translation>
    </message>
    <message>
        <source>magenta</source>
        <translation>magenta</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>rosa</translation>
    </message>
    <message>
        <source>black</source>
        <translation>negro</translation>
    </message>
    <message>
        <source>dark grey</source>
        <translation>gris oscuro</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>gris</translation>
    </message>
    <message>
        <source>light grey</source>
        <translation>gris claro</translation>
    </message>
    <message>
        <source>white</source>
        <translation>blanco</translation>
    </message>
</context>
<context>
    <name>SpokenNames</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>More buttons</source>
        <translation>Más botones</translation>
    </message>
</context>
<context>
    <name>StrokeWords</name>
    <message>
        <source>stroke %1</source>
        <translation>trazo %1</translation>
    </message>
    <message>
        <source>even</source>
        <translation>uniforme</translation>
    </message>
    <message>
        <source>feathered</source>
        <translation>difuminado</translation>
    </message>
    <message>
        <source>dark edge</source>
        <translation>borde oscuro</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>imagen</translation>
    </message>
    <message>
        <source>%1 and other colours</source>
        <translation>%1 y otros colores</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>relleno</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln segmento</numerusform>
            <numerusform>%Ln segmentos</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>oculto</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueado</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln trazo</numerusform>
            <numerusform>%Ln trazos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasReading</name>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln trazo</numerusform>
            <numerusform>%Ln trazos</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message numerus="yes">
        <source>%Ln selected</source>
        <translation>
            <numerusform>%Ln seleccionado</numerusform>
            <numerusform>%Ln seleccionados</numerusform>
        </translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Seleccionar</translation>
    </message>
    <message>
        <source>Selects this and nothing else</source>
        <translation>Selecciona esto y nada más</translation>
    </message>
    <message>
        <source>Adds this to the selection, or takes it away</source>
        <translation>Añade esto a la selección, o lo quita</translation>
    </message>
</context>
<context>
    <name>suffuse::PenSpeech</name>
    <message>
        <source>Arrow keys move the pen, Space presses it down and lifts it. Esc puts it away.</source>
        <translation>Las teclas de flecha mueven el lápiz; Espacio lo baja y lo levanta. Esc lo retira.</translation>
    </message>
    <message>
        <source>The pen is put away.</source>
        <translation>El lápiz se ha retirado.</translation>
    </message>
    <message>
        <source>Pen down at %1.</source>
        <translation>Lápiz bajado en %1.</translation>
    </message>
    <message>
        <source>Pen up at %1.</source>
        <translation>Lápiz levantado en %1.</translation>
    </message>
    <message>
        <source>Pen up at %1: %2.</source>
        <translation>Lápiz levantado en %1: %2.</translation>
    </message>
    <message>
        <source>Given up.</source>
        <translation>Cancelado.</translation>
    </message>
    <message>
        <source>Pressure %1 %</source>
        <translation>Presión %1 %</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>suffuse::Samples</name>
    <message>
        <source>Harbour</source>
        <translation>El puerto</translation>
    </message>
    <message>
        <source>Ink Landscape</source>
        <translation>Paisaje a tinta</translation>
    </message>
    <message>
        <source>Lanterns</source>
        <translation>Farolillos</translation>
    </message>
    <message>
        <source>Moonrise</source>
        <translation>Salida de la luna</translation>
    </message>
    <message>
        <source>Sheet of Strokes</source>
        <translation>Hoja de trazos</translation>
    </message>
    <message>
        <source>Still Life</source>
        <translation>Bodegón</translation>
    </message>
</context>
</TS>
